//! `wisch eval … --evidence`, and `.ci/evidence`, which writes the figures into pages.

use crate::executor::has_python;
use crate::program::{root, wisch};
use serde_json::Value;
use std::fs::{self, File};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, SystemTime};
use tempfile::TempDir;

const PAGE: &str = "# Page\n\n<!-- evidence small: predicted performance -->\n<!-- end -->\n\nIt plans <!-- evidence small: distance / absorb board / grid --><!-- end -->.\n";

const MEASURE: [&str; 13] = [
    "eval",
    "table1",
    "--cells",
    "board/absorb",
    "--strategies",
    "grid",
    "--seeds",
    "1",
    "--evidence",
    "evidence/small.json",
    "--out",
    "out/small",
    "-q",
];

fn git(folder: &Path, words: &[&str]) {
    let mut command = Command::new("git");
    command.args(["-c", "user.name=a", "-c", "user.email=a@example.org"]);
    let output = command
        .args(words)
        .current_dir(folder)
        .output()
        .expect("it runs");
    assert!(output.status.success(), "git {words:?}: {output:?}");
}

/// Writes a file that is older than the program.
fn write_old(path: &Path, text: &[u8]) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(path, text).expect("written");
    let old = SystemTime::UNIX_EPOCH + Duration::from_hours(24);
    let file = File::options().append(true).open(path).expect("the file");
    file.set_modified(old).expect("a time");
}

/// A repository with the paths of this one, and a page with figures.
fn repository() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for path in [
        "Cargo.lock",
        "crates/wisch/src/lib.rs",
        "crates/wisch-robot/src/lib.rs",
        "crates/wisch-io/src/lib.rs",
        "crates/wisch-eval/src/lib.rs",
        "knowledge/tools.toml",
        "robots/arm.urdf",
        "scenarios/board.toml",
    ] {
        write_old(&folder.path().join(path), b"");
    }
    let script = fs::read(root().join(".ci/evidence")).expect("the script");
    write_old(&folder.path().join(".ci/evidence"), &script);
    write_old(&folder.path().join("docs/page.md"), PAGE.as_bytes());
    fs::create_dir(folder.path().join("evidence")).expect("a folder");
    git(folder.path(), &["init", "--quiet"]);
    git(folder.path(), &["add", "."]);
    git(folder.path(), &["commit", "--quiet", "-m", "a"]);
    folder
}

/// Runs `.ci/evidence` and returns whether it succeeded, with what it printed.
fn script(folder: &Path, word: &str) -> (bool, String) {
    let mut command = Command::new("python3");
    let command = command.args([".ci/evidence", word]).current_dir(folder);
    let output = command.output().expect("it runs");
    let printed = [output.stdout, output.stderr].concat();
    (
        output.status.success(),
        String::from_utf8(printed).expect("text"),
    )
}

#[test]
fn figures_are_published_and_become_stale() {
    if !has_python() {
        return;
    }
    let repository = repository();
    let folder = repository.path();
    assert_eq!(wisch(folder, &MEASURE), (0, String::new(), String::new()));
    let text = fs::read_to_string(folder.join("evidence/small.json")).expect("evidence");
    let evidence: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(evidence["format"], "wisch evidence");
    assert_eq!(evidence["name"], "small");
    let repeated = [&["wisch"], &MEASURE[..8]].concat();
    assert_eq!(evidence["command"], serde_json::json!(repeated));
    assert_eq!(evidence["cases"], serde_json::json!([1, 0]));
    assert_eq!(evidence["code"]["is_committed"], true);
    let figures = evidence["figures"].as_array().expect("figures");
    let predicted = |figure: &&Value| figure["table"] == "predicted performance";
    let predicted = figures.iter().find(predicted).expect("the figure");
    assert_eq!(predicted["target"]["at_least"], 84.25);
    assert_eq!(predicted["count"][0], 1);

    // The page has the figures; a figure that is changed by hand is noticed.
    assert!(!script(folder, "--check").0);
    assert!(script(folder, "--write").0);
    assert_eq!(script(folder, "--check"), (true, String::new()));
    assert!(script(folder, "stale").0);
    let page = folder.join("docs/page.md");
    let written = fs::read_to_string(&page).expect("the page");
    assert!(
        written.contains("| absorb board |") && written.contains("≥ 84.25"),
        "{written}"
    );
    fs::write(&page, written.replace("84.25", "84.26")).expect("written");
    let (is_right, said) = script(folder, "--check");
    assert!(
        !is_right && said.contains("docs/page.md is not that of the evidence"),
        "{said}"
    );

    // Code that changes makes the figures stale, which the page must state.
    write_old(&folder.join("crates/wisch/src/lib.rs"), b"// changed\n");
    git(folder, &["commit", "--quiet", "-am", "b"]);
    let (is_fresh, said) = script(folder, "stale");
    assert!(
        !is_fresh && said.contains("small: crates/wisch/src changed"),
        "{said}"
    );
    assert!(script(folder, "--write").0);
    let written = fs::read_to_string(&page).expect("the page");
    assert!(
        written.contains("| **stale** |") && written.contains("(stale)"),
        "{written}"
    );
    fs::write(folder.join("evidence/stale.txt"), "small: a reason\n").expect("written");
    assert!(script(folder, "stale").0);

    // Results of other code are not taken up, and an old program is no evidence of new code.
    let resumed = wisch(folder, &[&MEASURE[..], &["--resume"]].concat());
    assert_eq!(resumed.0, 2);
    assert!(resumed.2.contains("results of other code"), "{}", resumed.2);
    fs::write(folder.join("crates/wisch/src/lib.rs"), "// newer\n").expect("written");
    let (code, _, said) = wisch(folder, &MEASURE);
    assert_eq!(code, 2);
    assert!(
        said.contains("the program is older than crates/wisch/src/lib.rs"),
        "{said}"
    );
}

#[test]
fn evidence_needs_a_checkout() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, _, said) = wisch(folder.path(), &MEASURE);
    assert_eq!(code, 2);
    assert!(said.contains("not the root of a checkout"), "{said}");
}
