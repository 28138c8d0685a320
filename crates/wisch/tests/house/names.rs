//! Names and lengths in what is shipped, over all crates.

use super::{production, rust_files};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The crates that users depend on.
const LIBRARIES: [&str; 11] = [
    "wisch",
    "wisch-eval",
    "wisch-io",
    "wisch-memory",
    "wisch-record",
    "wisch-report",
    "wisch-robot",
    "wisch-sim",
    "wisch-telemetry",
    "wisch-testkit",
    "wisch-web",
];

/// Most lines that a function has.
const MOST_LINES: usize = 100;

/// Fewest words of the doc of a public item of a library.
const LEAST_WORDS: usize = 6;

/// The shipped sources of all crates: where, and the code without comments and tests.
fn shipped() -> Vec<(String, String)> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = fs::read_dir(crates).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path().join("src"));
    let files = folders
        .filter(|folder| folder.is_dir())
        .flat_map(|folder| rust_files(&folder));
    let is_test = |file: &Path| {
        let name = file.file_stem().unwrap().to_string_lossy();
        name.ends_with("tests") || file.iter().any(|part| part == "tests")
    };
    files
        .filter(|file| !is_test(file))
        .map(|file| {
            let text = production(&fs::read_to_string(&file).unwrap());
            (file.display().to_string(), text)
        })
        .collect()
}

/// The public types that a text declares.
fn public_types(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let item = line.trim_start().strip_prefix("pub ")?;
        let (kind, rest) = item.split_once(' ')?;
        let is_type = ["struct", "enum", "trait", "type", "union"].contains(&kind);
        let name = rest.split(|c: char| !c.is_alphanumeric()).next()?;
        is_type.then_some(name)
    })
}

/// The public items at the top level of a text whose doc has fewer than [`LEAST_WORDS`] words.
fn scarcely_documented(text: &str) -> Vec<&str> {
    const KINDS: [&str; 7] = ["struct", "enum", "trait", "type", "union", "fn", "const"];
    let mut found = Vec::new();
    let (mut words, mut in_attribute) = (0, false);
    for line in text.lines() {
        if let Some(doc) = line.strip_prefix("///") {
            words += doc.split_whitespace().count();
        } else if in_attribute || line.starts_with("#[") {
            in_attribute = !line.ends_with(']');
        } else {
            let item = line.strip_prefix("pub ").unwrap_or_default();
            if words < LEAST_WORDS && item.split(' ').any(|word| KINDS.contains(&word)) {
                found.push(line);
            }
            words = 0;
        }
    }
    found
}

/// The functions that are longer than [`MOST_LINES`]: name and lines.
fn long_functions(text: &str) -> Vec<(&str, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let indent = |line: &str| line.len() - line.trim_start().len();
    let mut found = Vec::new();
    for (begin, line) in lines.iter().enumerate() {
        let Some((before, after)) = line.split_once("fn ") else {
            continue;
        };
        let is_item = before
            .split(|c: char| !c.is_alphanumeric())
            .all(|word| ["", "pub", "crate", "super", "in", "const", "async"].contains(&word));
        let name = after
            .split(|c: char| !(c.is_alphanumeric() || c == '_'))
            .next();
        let closes = |line: &&str| indent(line) == indent(lines[begin]) && line.trim() == "}";
        let length = lines[begin..].iter().position(closes).map(|end| end + 1);
        if let (true, Some(name), Some(length)) = (is_item, name, length)
            && length > MOST_LINES
        {
            found.push((name, length));
        }
    }
    found
}

#[test]
fn a_public_type_has_a_name_of_its_own() {
    let shipped = shipped();
    let mut places: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (file, text) in &shipped {
        for name in public_types(text) {
            places.entry(name).or_default().push(file);
        }
    }
    places.retain(|_, files| files.len() > 1);
    assert!(places.is_empty(), "{places:#?}");
}

#[test]
fn public_items_of_libraries_are_documented_in_a_sentence() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for name in LIBRARIES {
        for file in rust_files(&crates.join(name).join("src")) {
            let text = fs::read_to_string(&file).unwrap();
            let items = scarcely_documented(&text).into_iter();
            found.extend(items.map(|item| format!("{}: {item}", file.display())));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn an_item_with_a_doc_of_five_words_is_noticed() {
    let text = |doc: &str| {
        format!("/// {doc}\n#[derive(Debug)]\n#[error(\n    \"of two lines\"\n)]\npub struct A;\n")
    };
    let [five, six] = [
        text("The robot of an episode."),
        text("The robot of an old episode."),
    ];
    assert_eq!(scarcely_documented(&five), ["pub struct A;"]);
    assert_eq!(scarcely_documented(&six), Vec::<&str>::new());
    assert_eq!(
        scarcely_documented("pub const fn b() {}"),
        ["pub const fn b() {}"]
    );
}

#[test]
fn no_function_is_longer_than_a_page_or_two() {
    let shipped = shipped();
    let long: Vec<_> = (shipped.iter())
        .flat_map(|(file, text)| long_functions(text).into_iter().map(move |f| (file, f)))
        .collect();
    assert!(long.is_empty(), "{long:#?}");
}

#[test]
fn a_long_function_and_a_public_type_are_noticed() {
    let long = format!(
        "impl A {{\n    pub fn b() {{\n{}    }}\n}}\n",
        "        c();\n".repeat(99)
    );
    assert_eq!(long_functions(&long), [("b", 101)]);
    assert_eq!(long_functions(&long.replacen("        c();\n", "", 1)), []);
    let types = "pub struct A {\n}\npub(crate) enum B {}\n    pub type C = u8;";
    assert_eq!(public_types(types).collect::<Vec<_>>(), ["A", "C"]);
}
