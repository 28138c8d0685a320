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
