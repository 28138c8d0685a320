//! Every command that plans makes the same plan, whatever it does with it.

use crate::program::{command, root};
use std::fs;
use std::path::{Path, PathBuf};

fn scenarios() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(root().join("scenarios"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    found.sort();
    assert!(found.len() >= 10, "{found:?}");
    found
}

/// The plan that a command writes.
fn plan(words: &[&str], scenario: &Path, out: &Path) -> String {
    let mut command = command(out.parent().unwrap());
    command.arg(words[0]).arg(scenario).args(&words[1..]);
    let done = command
        .arg("--quiet")
        .arg("--out")
        .arg(out)
        .output()
        .unwrap();
    let code = done.status.code();
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(
        matches!(code, Some(0 | 1)),
        "{words:?} {scenario:?}: {errors}"
    );
    fs::read_to_string(out.join("plan.json")).unwrap()
}

#[test]
fn all_commands_make_the_same_plan_of_every_scenario() {
    let folder = tempfile::tempdir().unwrap();
    for scenario in scenarios() {
        let name = scenario.file_stem().unwrap().to_string_lossy().into_owned();
        let out = |command: &str| folder.path().join(format!("{name}-{command}"));
        let planned = plan(&["plan"], &scenario, &out("plan"));
        assert_eq!(
            plan(&["predict"], &scenario, &out("predict")),
            planned,
            "{name}"
        );
        let blind = ["run", "--robot", "none"];
        assert_eq!(plan(&blind, &scenario, &out("run")), planned, "{name}");
    }
}

#[test]
fn following_and_running_make_the_same_plan_too() {
    let folder = tempfile::tempdir().unwrap();
    // With one candidate, and with several of which the predicted effect chooses.
    for name in ["arm-board", "failure-human-push"] {
        let scenario = root().join(format!("scenarios/{name}.toml"));
        let out = |command: &str| folder.path().join(format!("{name}-{command}"));
        let planned = plan(&["plan"], &scenario, &out("plan"));
        assert_eq!(
            plan(&["follow"], &scenario, &out("follow")),
            planned,
            "{name}"
        );
        // A run that looks first plans for what it sees.
        let once = ["run", "--rounds", "1", "--no-memory", "--touch-only"];
        assert_eq!(plan(&once, &scenario, &out("run")), planned, "{name}");
    }
}

#[test]
fn a_search_tries_as_many_plans_as_its_budget_says() {
    let folder = tempfile::tempdir().unwrap();
    let board = Path::new("chopping-board");
    let planned = |words: &[&str], to: &str| {
        let words = [&["plan", "--strategy", "adaptive"], words].concat();
        plan(&words, board, &folder.path().join(to))
    };
    let few = planned(&["--budget", "3000"], "few");
    assert_eq!(planned(&["--set", "plan.evaluations=3000"], "set"), few);
    assert_ne!(planned(&["--budget", "9000"], "more"), few);

    // In a time so many are tried as it says, with the same plan again for that number.
    let mut timed = command(folder.path());
    timed.args(["plan", "chopping-board", "--strategy", "adaptive"]);
    let timed = timed
        .args(["--budget", "400ms", "--out", "timed"])
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&timed.stderr);
    assert_eq!(timed.status.code(), Some(0), "{said}");
    let number = said
        .split("--budget ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    let again = planned(&["--budget", number.expect("a number of plans")], "again");
    let timed = fs::read_to_string(folder.path().join("timed/plan.json")).unwrap();
    assert_eq!(again, timed, "{said}");

    for (strategy, budget) in [("kde", "3000"), ("adaptive", "2h"), ("adaptive", "0")] {
        let mut refused = command(folder.path());
        refused.args(["plan", "chopping-board", "--strategy", strategy]);
        let refused = refused.args(["--budget", budget]).output().unwrap();
        let said = String::from_utf8_lossy(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(
            said.contains("budget") || said.contains("evaluations"),
            "{said}"
        );
    }
}
