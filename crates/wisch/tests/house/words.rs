//! How the project speaks: patterns that stop a reader, and names of functions.

use super::documents::root;
use super::rust_files;
use std::fs;
use std::path::{Path, PathBuf};

/// Phrases that say no noun, with what to say instead.
const PATTERNS: [(&str, &str); 23] = [
    ("what is so", "say the ground truth"),
    ("what there is", "say the noun"),
    ("was told", "reported or detected"),
    ("were told", "reported or detected"),
    ("are told", "reported or detected"),
    ("is told", "reported or detected"),
    ("looks on", "observes or shows"),
    ("look on", "observe or show"),
    ("round at hand", "the current round"),
    ("that are none", "say what is wrong with them"),
    ("that is none", "say what is wrong with it"),
    ("of ours", "say which"),
    ("by trying", "found by search"),
    ("gives up", "abandons or stops"),
    ("given up", "abandoned or stopped"),
    ("gone on with", "resumed"),
    ("whatever it", "say the condition"),
    ("whichever", "say the condition"),
    ("whoever", "say the actor"),
    ("worth most", "has the highest score"),
    ("no more than this", "say the number"),
    ("so many ", "say the number"),
    ("as it was believed to be", "say the estimate"),
];

/// Words of a sentence at most.
const MAX_WORDS: usize = 40;

/// Lines of the README at most.
const MAX_README_LINES: usize = 200;

/// Names of public functions that end like a participle and are none, or that the field uses.
const NOT_PARTICIPLES: [(&str, &str); 4] = [
    ("seed", "a noun"),
    ("speed", "a noun"),
    ("need", "a verb"),
    ("shed", "a verb"),
];

/// Folders whose functions no user can reach: their modules are private.
const PRIVATE: [&str; 7] = [
    "wisch-cli/src",
    "wisch-py/src",
    "wisch-fleet/src",
    "wisch-studio/src",
    "wisch-eval/src",
    "wisch-testkit/src",
    "wisch-memory/src",
];

/// The documents that people read, without the changes and the paper's map.
fn documents() -> Vec<PathBuf> {
    let names = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"];
    let mut found: Vec<PathBuf> = names.iter().map(|name| root().join(name)).collect();
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let path = entry.unwrap().path();
        found.extend(path.extension().is_some_and(|e| e == "md").then_some(path));
    }
    found.sort();
    found
}

/// The sources of all crates, without their tests.
fn sources() -> Vec<PathBuf> {
    let crates = fs::read_dir(root().join("crates")).unwrap();
    let folders = crates.map(|entry| entry.unwrap().path().join("src"));
    let files = folders
        .filter(|folder| folder.is_dir())
        .flat_map(|folder| rust_files(&folder));
    files
        .filter(|file| !file.ends_with("tests.rs") && !is_in_tests(file))
        .collect()
}

fn is_in_tests(file: &Path) -> bool {
    file.iter().any(|part| part == "tests")
}

/// The prose of a document: without code, tables, headings and comments.
fn prose(text: &str) -> String {
    let mut is_code = false;
    let mut prose = String::new();
    for line in text.lines() {
        let start = line.trim_start();
        if start.starts_with("```") {
            is_code = !is_code;
        }
        let is_other = ["```", "|", "#", "<", "!["]
            .iter()
            .any(|begin| start.starts_with(begin));
        if is_code || is_other || start.is_empty() {
            prose.push_str("\n\n");
        } else {
            let is_item = ["- ", "* ", "1. "]
                .iter()
                .any(|begin| start.starts_with(begin))
                || start
                    .split_once(". ")
                    .is_some_and(|(n, _)| n.parse::<u32>().is_ok());
            if is_item {
                prose.push_str("\n\n");
            }
            prose.push_str(start);
            prose.push(' ');
        }
    }
    prose
}

/// The sentences of prose that have too many words.
fn long_sentences(prose: &str) -> Vec<String> {
    let paragraphs = prose.split("\n\n");
    let sentences = paragraphs.flat_map(|paragraph| {
        paragraph.split_inclusive(['.', '!', '?', ':', ';']).fold(
            Vec::<String>::new(),
            |mut all, part| {
                // A full stop within a word, such as a file name, ends no sentence.
                match all.last_mut() {
                    Some(last) if !part.starts_with(char::is_whitespace) => last.push_str(part),
                    _ => all.push(part.to_owned()),
                }
                all
            },
        )
    });
    let is_long = |sentence: &String| sentence.split_whitespace().count() > MAX_WORDS;
    sentences.filter(is_long).collect()
}

/// Phrases of a text that stop a reader, with what to say instead.
fn stopping(text: &str) -> Vec<(&'static str, &'static str)> {
    let text = text.to_lowercase();
    PATTERNS
        .into_iter()
        .filter(|(phrase, _)| text.contains(phrase))
        .collect()
}

/// The doc comments of a source.
fn doc_comments(text: &str) -> String {
    let lines = text.lines().map(str::trim_start);
    let docs = lines.filter(|line| line.starts_with("///") || line.starts_with("//!"));
    docs.map(|line| &line[3..]).collect::<Vec<_>>().join("\n")
}

/// Public functions that are named by the state of their result.
fn participles(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for begin in ["pub fn ", "pub const fn "] {
        for (at, _) in text.match_indices(begin) {
            let name = &text[at + begin.len()..];
            let name = &name[..name.find(['(', '<']).unwrap_or(name.len())];
            let is_allowed = NOT_PARTICIPLES.iter().any(|(allowed, _)| *allowed == name);
            if name.ends_with("ed") && !name.contains('_') && !is_allowed {
                found.push(name);
            }
        }
    }
    found
}

#[test]
fn documents_say_the_noun_in_short_sentences() {
    let mut faults = Vec::new();
    for path in documents() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let prose = prose(&text);
        faults.extend(
            stopping(&prose)
                .iter()
                .map(|(phrase, instead)| format!("{name}: \"{phrase}\": {instead}")),
        );
        faults.extend(
            long_sentences(&prose)
                .iter()
                .map(|sentence| format!("{name}: over {MAX_WORDS} words: {sentence}")),
        );
    }
    assert_eq!(faults, [""; 0], "{}", faults.join("\n"));
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let lines = readme.lines().count();
    assert!(
        lines <= MAX_README_LINES,
        "README.md has {lines} lines, at most {MAX_README_LINES}"
    );
}

#[test]
fn doc_comments_say_the_noun_and_functions_begin_with_a_verb() {
    let mut faults = Vec::new();
    for file in sources() {
        let text = fs::read_to_string(&file).unwrap();
        let name = file.display();
        let phrases = stopping(&doc_comments(&text));
        faults.extend(
            phrases
                .iter()
                .map(|(phrase, instead)| format!("{name}: \"{phrase}\": {instead}")),
        );
        if !PRIVATE
            .iter()
            .any(|folder| file.to_string_lossy().contains(folder))
        {
            faults.extend(
                participles(&text)
                    .iter()
                    .map(|found| format!("{name}: fn {found}: begin with a verb")),
            );
        }
    }
    assert_eq!(faults, [""; 0], "{}", faults.join("\n"));
}

#[test]
fn planted_faults_are_noticed() {
    assert_eq!(stopping("What is so, whoever it is.").len(), 2);
    assert_eq!(stopping("The ground truth of the current round."), []);
    assert_eq!(doc_comments("/// A\nfn f() {} // b\n//! C"), " A\n C");
    assert_eq!(
        participles("pub fn eased(&self) {}\npub fn speed() {}\npub fn plan_strokes() {}"),
        ["eased"]
    );
    let long = format!("Short one. {}.", ["word"; MAX_WORDS + 1].join(" "));
    assert_eq!(long_sentences(&prose(&long)).len(), 1);
    assert_eq!(
        long_sentences(&prose("See a.md, b.rs and so on. ")),
        [""; 0]
    );
    let code = format!(
        "```\n{}\n```\n| {} |\n",
        ["x"; 50].join(" "),
        ["x"; 50].join(" ")
    );
    assert_eq!(long_sentences(&prose(&code)), [""; 0]);
}
