//! How the project speaks: phrases that stop a reader, names of functions, and subjects of commits.

use super::documents::root;
use super::rust_files;
use std::collections::BTreeSet;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Phrases that say no noun, or that name a thing by a private metaphor, with what to say instead.
const PATTERNS: [(&str, &str); 53] = [
    ("what is so", "say the ground truth"),
    ("what there is", "say the noun"),
    ("truth's door", "say GroundTruth"),
    ("told", "reported or detected"),
    ("felt", "measured by touch"),
    ("looked", "observed"),
    ("look on", "observe or show"),
    ("looks on", "observes or shows"),
    ("others look", "say who observes"),
    ("look away", "ignore"),
    ("looks away", "ignores"),
    ("nothing to see", "say what is off, and why"),
    ("at hand", "current"),
    ("has come to", "has completed"),
    ("that are none", "say what is wrong with them"),
    ("that is none", "say what is wrong with it"),
    ("are no numbers", "are not finite"),
    ("is no number", "is not finite"),
    ("to be expected of", "the predicted result of"),
    ("what is to be done", "say the action"),
    ("of ours", "say which"),
    ("by trying", "found by search"),
    ("give up", "abandon or stop"),
    ("gives up", "abandons or stops"),
    ("gave up", "abandoned or stopped"),
    ("given up", "abandoned or stopped"),
    ("nodes up", "nodes abandoned"),
    ("executor up", "stop waiting for the executor"),
    ("hands on nothing", "sends no sample"),
    ("gone on with", "resumed"),
    ("whatever it", "say the condition"),
    ("whichever", "say the condition"),
    ("whoever", "say the actor"),
    ("worth", "score"),
    ("gainful", "with a predicted gain"),
    ("surer", "say what narrows the interval"),
    ("how sure", "say the confidence interval"),
    ("no more than this", "say the number"),
    ("so many", "say the number"),
    ("for so long", "say the time"),
    ("the former", "repeat the noun"),
    ("are others therefore", "have changed"),
    ("as it was believed to be", "say the estimate"),
    ("judge", "decide, by the termination policy"),
    ("judged", "decided, by the termination policy"),
    ("judges", "decides, or assesses"),
    ("amid", "during"),
    ("unknowable", "undecided, or unknown"),
    ("taut", "of the least joint travel"),
    ("eased", "shortened, or with less joint travel"),
    ("blows", "pushes"),
    ("house", "module, interface or boundary"),
    ("a program of its own", "a companion program"),
];

/// Passages in which a phrase of [`PATTERNS`] is right, with the reason.
const EXCEPTIONS: [(&str, &str); 4] = [
    ("cannot be told", "a verdict in files of version 0.2.0"),
    ("unknowable by touch", "a verdict in files of version 0.2.0"),
    ("tests house", "the folder of these checks"),
    ("worth knowing", "an idiom about a note, not about a plan"),
];

/// Words that the glossary avoids in one sense and that are right in another, so that no check finds them.
const UNCHECKED: [(&str, &str); 15] = [
    ("others", "right where the noun is in the same sentence"),
    ("such", "\"such as\" gives an example"),
    ("one", "a number"),
    ("seen", "\"seen from above\" is a direction of view"),
    ("sight", "the name of a sense in task files"),
    ("place", "a position on the surface"),
    ("stay", "a verb"),
    ("open", "a verb"),
    ("waiting", "a verb"),
    ("considered", "a verb"),
    ("heading", "a direction of travel, and a key of task files"),
    ("transfer", "the name of a phase in files"),
    ("elsewhere", "away from the goal area"),
    ("emit", "the name of an action in files of earlier versions"),
    ("floor", "what a robot stands on"),
];

/// Words of a sentence at most.
const MAX_WORDS: usize = 40;

/// Lines of the README at most.
const MAX_README_LINES: usize = 200;

/// Characters of a commit's subject at most.
const MAX_SUBJECT: usize = 72;

/// Commits whose subjects are checked.
const COMMITS: usize = 50;

/// Words of a message at least; shorter literals are names and units.
const MIN_MESSAGE_WORDS: usize = 3;

/// Words with which no name of a public function begins: they say where or when, but not what it does.
const NO_VERBS: [&str; 15] = [
    "about", "after", "at", "before", "beside", "beyond", "by", "certain", "during", "each", "of",
    "over", "through", "towards", "within",
];

/// Names of public functions that look like a fault and are none, with the reason.
const ALLOWED_NAMES: [(&str, &str); 5] = [
    ("seed", "a noun"),
    ("speed", "a noun"),
    ("need", "a verb"),
    ("shed", "a verb"),
    ("after_stop", "a key of task files"),
];

/// Folders whose functions no user can reach: their modules are private.
const PRIVATE: [&str; 5] = [
    "wisch-cli/src",
    "wisch-py/src",
    "wisch-fleet/src",
    "wisch-studio/src",
    "wisch-testkit/src",
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

/// The words of a text in lower case, each between spaces. Backticks belong to their words, as they mark names.
fn words(text: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || "_'`-".contains(c);
    let text = text.to_lowercase().replace('’', "'");
    let words = text.split(|c| !is_word(c)).filter(|word| !word.is_empty());
    words.fold(" ".to_owned(), |words, word| words + word + " ")
}

/// Phrases of a text that stop a reader, with what to say instead.
fn stopping(text: &str) -> Vec<(&'static str, &'static str)> {
    let mut words = words(text);
    for (passage, _) in EXCEPTIONS {
        words = words.replace(&format!(" {passage} "), " … ");
    }
    PATTERNS
        .into_iter()
        .filter(|(phrase, _)| words.contains(&format!(" {phrase} ")))
        .collect()
}

/// The length of the comment or literal with which a source continues, and whether it is a text. `before`: what
/// stands before it.
fn token(before: &str, rest: &str) -> Option<(usize, bool)> {
    let closed = |from: usize, close: &str| {
        let end = rest[from..].find(close).map(|end| from + end + close.len());
        end.unwrap_or(rest.len())
    };
    let is_in_name = before.ends_with(|c: char| c.is_alphanumeric() || c == '_');
    let raw = rest.strip_prefix('b').unwrap_or(rest).strip_prefix('r');
    if rest.starts_with("//") {
        Some((rest.find('\n').unwrap_or(rest.len()), false))
    } else if rest.starts_with("/*") {
        Some((closed(2, "*/"), false))
    } else if let Some(raw) = raw.filter(|_| !is_in_name)
        && let Some(hashes) = raw.find('"')
        && raw[..hashes].chars().all(|c| c == '#')
    {
        let begin = rest.len() - raw.len() + hashes + 1;
        let close = format!("\"{}", "#".repeat(hashes));
        Some((closed(begin, &close), true))
    } else if let Some(text) = rest.strip_prefix('"') {
        let mut is_escaped = false;
        let end = text.find(|c| {
            let ends = c == '"' && !is_escaped;
            is_escaped = c == '\\' && !is_escaped;
            ends
        });
        Some((end.map_or(rest.len(), |end| end + 2), true))
    } else if rest.starts_with("'\\") {
        Some((closed(3, "'"), false))
    } else {
        let character = rest.strip_prefix('\'')?.chars().next()?.len_utf8();
        let is_character = rest[1 + character..].starts_with('\'');
        is_character.then_some((character + 2, false))
    }
}

/// The texts that a source shows to people: literals of some words, without placeholders, names of tests and what is
/// compiled for tests only.
fn messages(text: &str) -> Vec<String> {
    let mut code = String::new();
    let mut literals: Vec<Range<usize>> = Vec::new();
    while let Some(next) = text[code.len()..].chars().next() {
        let begin = code.len();
        match token(&text[..begin], &text[begin..]) {
            Some((length, is_text)) => {
                code.push_str(&" ".repeat(length));
                literals.extend(is_text.then_some(begin..begin + length));
            }
            None => code.push(next),
        }
    }
    let tests = code.match_indices("#[cfg(test)]").map(|(begin, _)| {
        // One item: it ends with a semicolon, or with the brace that closes it.
        let mut depth = 0;
        let end = code[begin..].find(|c| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            depth == 0 && (c == ';' || c == '}')
        });
        begin..end.map_or(code.len(), |end| begin + end)
    });
    let tests: Vec<Range<usize>> = tests.collect();
    let shown = literals
        .into_iter()
        .filter(|literal| !tests.iter().any(|test| test.contains(&literal.start)));
    shown
        .map(|literal| without_placeholders(&text[literal]))
        .filter(|message| words(message).split_whitespace().count() >= MIN_MESSAGE_WORDS)
        .collect()
}

/// A literal without the values that a format inserts, and without escapes.
fn without_placeholders(literal: &str) -> String {
    let mut plain = String::new();
    let mut depth = 0;
    let mut characters = literal.chars();
    while let Some(c) = characters.next() {
        match c {
            '\\' => {
                characters.next();
                plain.push(' ');
            }
            '{' => depth += 1,
            '}' => depth -= 1,
            c if depth <= 0 => plain.push(c),
            _ => {}
        }
    }
    plain
}

/// The subjects of the last commits; none without a repository, as in a package or an archive of the sources.
fn subjects() -> Vec<String> {
    let git = |arguments: &[&str]| {
        let output = Command::new("git")
            .arg("-C")
            .arg(root())
            .args(arguments)
            .output();
        let output = output.ok().filter(|output| output.status.success())?;
        String::from_utf8(output.stdout).ok()
    };
    // An archive may lie within another repository.
    let is_own = git(&["rev-parse", "--show-toplevel"]).is_some_and(|top| {
        let [top, root] =
            [PathBuf::from(top.trim_end()), root()].map(|path| path.canonicalize().ok());
        top.is_some() && top == root
    });
    let log = is_own.then(|| git(&["log", &format!("-{COMMITS}"), "--format=%s"]));
    let log = log.flatten().unwrap_or_default();
    log.lines().map(str::to_owned).collect()
}

/// Subjects that are too long.
fn long_subjects(subjects: &[String]) -> Vec<&String> {
    let is_long = |subject: &&String| subject.chars().count() > MAX_SUBJECT;
    subjects.iter().filter(is_long).collect()
}

/// The doc comments of a source.
fn doc_comments(text: &str) -> String {
    let lines = text.lines().map(str::trim_start);
    let docs = lines.filter(|line| line.starts_with("///") || line.starts_with("//!"));
    docs.map(|line| &line[3..]).collect::<Vec<_>>().join("\n")
}

/// Public functions that are named by the state of their result, or by a word that says no action.
fn badly_named(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for begin in ["pub fn ", "pub const fn "] {
        for (at, _) in text.match_indices(begin) {
            let name = &text[at + begin.len()..];
            let name = &name[..name.find(['(', '<']).unwrap_or(name.len())];
            let is_allowed = ALLOWED_NAMES.iter().any(|(allowed, _)| *allowed == name);
            let is_participle = name.ends_with("ed") && !name.contains('_');
            let first = name.split('_').next().unwrap_or(name);
            if (is_participle || NO_VERBS.contains(&first)) && !is_allowed {
                found.push(name);
            }
        }
    }
    found
}

/// The phrases of a text that stop a reader, as faults of `name`.
fn faults(name: impl std::fmt::Display, text: &str) -> impl Iterator<Item = String> {
    let found = stopping(text).into_iter();
    found.map(move |(phrase, instead)| format!("{name}: \"{phrase}\": {instead}"))
}

#[test]
fn documents_say_the_noun_in_short_sentences() {
    let mut found = Vec::new();
    for path in documents() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let prose = prose(&text);
        found.extend(faults(&name, &prose));
        found.extend(
            long_sentences(&prose)
                .iter()
                .map(|sentence| format!("{name}: over {MAX_WORDS} words: {sentence}")),
        );
    }
    assert_eq!(found, [""; 0], "{}", found.join("\n"));
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let lines = readme.lines().count();
    assert!(
        lines <= MAX_README_LINES,
        "README.md has {lines} lines, at most {MAX_README_LINES}"
    );
}

#[test]
fn doc_comments_say_the_noun_and_functions_begin_with_a_verb() {
    let mut found = Vec::new();
    for file in sources() {
        let text = fs::read_to_string(&file).unwrap();
        let name = file.display();
        found.extend(faults(&name, &doc_comments(&text)));
        let path = file.to_string_lossy();
        if !PRIVATE.iter().any(|folder| path.contains(folder)) {
            let named = badly_named(&text).into_iter();
            found.extend(named.map(|fault| format!("{name}: fn {fault}: begin with a verb")));
        }
    }
    assert_eq!(found, [""; 0], "{}", found.join("\n"));
}

#[test]
fn messages_say_the_noun() {
    let mut found = Vec::new();
    for file in sources() {
        let text = fs::read_to_string(&file).unwrap();
        for message in messages(&text) {
            let name = format!("{}: {message}", file.display());
            found.extend(faults(name, &message));
        }
    }
    assert_eq!(found, [""; 0], "{}", found.join("\n"));
}

#[test]
fn subjects_of_commits_are_short() {
    assert_eq!(long_subjects(&subjects()), [] as [&String; 0]);
}

#[test]
fn patterns_have_advice_and_exceptions_a_reason_and_a_use() {
    let phrases: BTreeSet<&str> = PATTERNS.iter().map(|(phrase, _)| *phrase).collect();
    assert_eq!(phrases.len(), PATTERNS.len(), "a phrase stands twice");
    let all = PATTERNS.iter().chain(&EXCEPTIONS).chain(&UNCHECKED);
    for (phrase, why) in all.chain(&ALLOWED_NAMES) {
        assert!(!why.is_empty(), "{phrase}");
        // A phrase in another form would never match.
        assert!(words(phrase).trim() == *phrase, "{phrase}");
    }
    for (word, _) in UNCHECKED {
        assert!(!phrases.contains(word), "{word} is checked");
    }
    let documents = documents()
        .into_iter()
        .map(|path| fs::read_to_string(path).unwrap());
    let sources = sources()
        .into_iter()
        .map(|path| fs::read_to_string(path).unwrap());
    let texts: Vec<String> = documents.chain(sources).map(|text| words(&text)).collect();
    for (passage, _) in EXCEPTIONS {
        let has_phrase = phrases
            .iter()
            .any(|phrase| words(passage).contains(&words(phrase)));
        assert!(has_phrase, "{passage} contains no phrase");
        let is_used = texts.iter().any(|text| text.contains(&words(passage)));
        assert!(is_used, "{passage} stands nowhere");
    }
}

#[test]
fn each_planted_phrase_is_noticed() {
    for (phrase, instead) in PATTERNS {
        let planted = format!("Here {phrase}, in a sentence.");
        assert!(stopping(&planted).contains(&(phrase, instead)), "{phrase}");
        let broken = phrase.replace(' ', "\n");
        assert!(stopping(&broken).contains(&(phrase, instead)), "{phrase}");
        assert_eq!(stopping(&format!("un{phrase}s")), [], "{phrase}");
    }
    for (passage, _) in EXCEPTIONS {
        assert_eq!(stopping(&format!("Here {passage}.")), [], "{passage}");
    }
    assert_eq!(stopping("It cannot be told what was told.").len(), 1);
    assert_eq!(stopping("The ground truth of the current round."), []);
    assert_eq!(stopping("The stage `judged` of a session."), []);
}

#[test]
fn messages_of_a_source_are_found() {
    let source = r##"
        /// "in a comment, not a message"
        fn f<'a>(c: char) -> &'a str {
            let quote = c == '"' || c == '\''; // "in a comment too, really"
            let url = "https://a.b/c is what is so";
            let short = "no message";
            let broken = format!("an \"escaped {felt:?} quote\" that \
                whoever reads");
            r#"a raw "text" of ours"#
        }
        #[cfg(test)]
        mod tests {
            fn g() { panic!("that is not for {people} at all"); }
        }
        const LAST: &str = "one more after the tests";
    "##;
    let found = messages(source);
    let words: Vec<String> = found.iter().map(|message| words(message)).collect();
    let expected = [
        " https a b c is what is so ",
        " an escaped quote that whoever reads ",
        " r a raw text of ours ",
        " one more after the tests ",
    ];
    assert_eq!(words, expected);
    let stopped = found.iter().map(|message| stopping(message).len());
    assert_eq!(stopped.collect::<Vec<_>>(), [1, 1, 1, 0]);
}

#[test]
fn planted_faults_are_noticed() {
    assert_eq!(doc_comments("/// A\nfn f() {} // b\n//! C"), " A\n C");
    assert_eq!(
        badly_named(
            "pub fn eased(&self) {}\npub fn speed() {}\npub fn plan_strokes() {}\npub const fn of<T>() {}\n\
            pub fn after_stop() {}\npub fn offset() {}\npub fn by_action() {}"
        ),
        ["eased", "by_action", "of"]
    );
    let subject = |length: usize| format!("docs: {}", "é".repeat(length - 6));
    let subjects = [subject(MAX_SUBJECT), subject(MAX_SUBJECT + 1)];
    assert_eq!(long_subjects(&subjects), [&subjects[1]]);
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
