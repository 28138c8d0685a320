//! The items, paths and commands that the documents name exist.

use super::{STAGES, code, rust_files, source};
use std::fs;
use std::path::{Path, PathBuf};

pub(super) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The folders of the crates, by their names.
fn crates() -> impl Iterator<Item = PathBuf> {
    let entries = fs::read_dir(root().join("crates")).unwrap();
    entries.map(|entry| entry.unwrap().path())
}

/// The source of a stage, or of a crate under the name by which code calls it.
fn source_of(room: &str) -> Option<PathBuf> {
    if STAGES.contains(&room) {
        return Some(source().join(room));
    }
    match room {
        "robot" => return Some(root().join("crates/wisch-robot/src")),
        "geometry" => return Some(root().join("crates/wisch-robot/src/geometry")),
        _ => {}
    }
    let is_called_so = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.replace('-', "_") == room
    };
    Some(crates().find(is_called_so)?.join("src"))
}

/// Items named in a text as `stage::…::Name` or `crate::…::Name`.
fn items(text: &str) -> Vec<&str> {
    text.split('`')
        .skip(1)
        .step_by(2)
        .filter(|word| (word.split_once("::")).is_some_and(|(room, _)| source_of(room).is_some()))
        .collect()
}

fn exists(item: &str) -> bool {
    let mut parts = item.split("::");
    let folder = parts.next().and_then(source_of).expect("is named by items");
    let names: Vec<&str> = parts.collect();
    let text: String = rust_files(&folder)
        .iter()
        .map(|file| code(&fs::read_to_string(file).unwrap()))
        .collect();
    !names.is_empty()
        && names.iter().all(|name| {
            let declared = |keyword: &str| {
                text.match_indices(&format!("{keyword} {name}"))
                    .any(|(at, found)| {
                        !text[at + found.len()..]
                            .starts_with(|c: char| c.is_alphanumeric() || c == '_')
                    })
            };
            ["fn", "struct", "enum", "const", "type", "trait", "mod"]
                .into_iter()
                .any(declared)
                || text.contains(&format!("    {name},"))
                || text.contains(&format!("    {name} {{"))
        })
}

#[test]
fn what_paper_md_names_exists() {
    let text = fs::read_to_string(root().join("PAPER.md")).unwrap();
    let items = items(&text);
    assert!(
        items.len() > 20,
        "PAPER.md names only {} items",
        items.len()
    );
    let missing: Vec<&str> = items.into_iter().filter(|item| !exists(item)).collect();
    assert!(
        missing.is_empty(),
        "PAPER.md names what is not there: {missing:?}"
    );
}

#[test]
fn an_item_that_is_not_there_is_noticed() {
    assert!(exists("represent::EffectModel::apply"));
    assert!(!exists("represent::EffectModel::undo_everything"));
    assert!(exists("wisch_sim::World::truth"));
    assert!(!exists("wisch_sim::World::lie"));
    assert_eq!(
        items("see `plan::grid`, `cargo doc` and `wisch_io::load_task`, not `std::fs::read`"),
        ["plan::grid", "wisch_io::load_task"]
    );
}

/// The documents for readers.
const DOCUMENTS: [&str; 8] = [
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "PAPER.md",
    "PERFORMANCE.md",
    "STYLE.md",
    "docs/executor-protocol.md",
    "docs/worlds.md",
];

/// What paths in the documents begin with.
const FOLDERS: [&str; 10] = [
    "crates",
    "docs",
    "fuzz",
    "knowledge",
    "ontology",
    "peers",
    "robots",
    "scenarios",
    "worlds",
    ".ci",
];

/// Folders below a folder of results, which are not of this repository.
const RESULTS: [&str; 4] = ["figures/", "telemetry/", "trajectories/", "particles/"];

/// Files and folders of this repository that a document names and that are not there. A file of ours that is named
/// by a part of its path counts from `crates/wisch/src`, or lies where one does that the same line names before.
fn missing_paths(text: &str) -> Vec<String> {
    let ends = [".rs", ".pl", ".owl", ".pddl", "/"];
    let is_path = |word: &&str| {
        let is_plain = (word.chars()).all(|c| c.is_ascii_alphanumeric() || "._-/".contains(c));
        let begins = word.split('/').next().unwrap_or_default();
        let is_ours = word.contains('/') && FOLDERS.contains(&begins);
        // A name in capitals stands for any.
        !RESULTS.contains(word)
            && !word.contains("NAME")
            && is_plain
            && (is_ours || (!word.starts_with('/') && ends.iter().any(|e| word.ends_with(e))))
    };
    let mut missing = Vec::new();
    for line in text.lines() {
        let mut folders = vec![root(), source()];
        let words = line.split(|c: char| c.is_whitespace() || "`*()[]\",;:|".contains(c));
        for word in words.map(|word| word.trim_end_matches('.')).filter(is_path) {
            let found = folders
                .iter()
                .map(|folder| folder.join(word))
                .find(|path| path.exists());
            match found {
                Some(path) if path.is_dir() => folders.push(path),
                Some(path) => folders.extend(path.parent().map(Path::to_path_buf)),
                None => missing.push(word.to_owned()),
            }
        }
    }
    missing
}

/// Examples, benches and tests, as `--example NAME`, that a document names and that are not there; programs of
/// `target/release` with them.
fn missing_targets(text: &str) -> Vec<String> {
    let exists = |kind: &str, name: &str| {
        crates().any(|folder| {
            let named = folder.join(kind).join(name);
            // Beside a main.rs, the other files of a folder of tests are parts of it.
            let is_part = kind == "tests" && name != "main";
            (!is_part && named.with_extension("rs").is_file()) || named.join("main.rs").is_file()
        })
    };
    let mut missing = Vec::new();
    for (mark, kind) in [
        ("--example ", "examples"),
        ("target/release/examples/", "examples"),
        ("--bench ", "benches"),
        ("--test ", "tests"),
    ] {
        for (at, _) in text.match_indices(mark) {
            let rest = &text[at + mark.len()..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '-');
            let name = &rest[..end.unwrap_or(rest.len())];
            if !exists(kind, name) {
                missing.push(format!("{mark}{name}"));
            }
        }
    }
    let fuzzed = text
        .match_indices("fuzz run ")
        .map(|(at, mark)| &text[at + mark.len()..]);
    for name in fuzzed.filter_map(|rest| rest.split(|c: char| !c.is_alphanumeric()).next()) {
        if !name.is_empty()
            && !root()
                .join(format!("fuzz/fuzz_targets/{name}.rs"))
                .is_file()
        {
            missing.push(format!("fuzz run {name}"));
        }
    }
    missing
}

#[test]
fn what_the_documents_name_exists() {
    for document in DOCUMENTS {
        let text = fs::read_to_string(root().join(document)).unwrap();
        assert_eq!(missing_paths(&text), [""; 0], "{document}");
        assert_eq!(missing_targets(&text), [""; 0], "{document}");
    }
    let recipes = fs::read_to_string(root().join("justfile")).unwrap();
    assert_eq!(missing_targets(&recipes), [""; 0]);
}

#[test]
fn a_path_or_a_command_that_leads_nowhere_is_noticed() {
    let sound = "`represent/effect.rs`, beside it `heap.rs` ([paper](docs/executor-protocol.md)), `knowledge/`, `out/plan.json`";
    assert_eq!(missing_paths(sound), [""; 0]);
    assert_eq!(
        missing_paths("| `execute/session.rs`, then `heap.rs` | see docs/nowhere.md."),
        ["execute/session.rs", "heap.rs", "docs/nowhere.md"]
    );
    let commands = "`cargo bench --bench effect`, `target/release/examples/random_problems 3`, `cargo test --test main house::`";
    assert_eq!(missing_targets(commands), [""; 0]);
    assert_eq!(
        missing_targets(
            "`--bench effects`, `cargo run --example hose -- x`, `--test house`, `fuzz run mush`"
        ),
        [
            "--example hose",
            "--bench effects",
            "--test house",
            "fuzz run mush"
        ]
    );
}
