//! A task that presses with another force than the one for which an effect is known.

use crate::program::{command, root};
use serde_json::Value;

/// Runs `wisch predict` of a scenario with a press force [N]. Returns the exit code, standard output and standard error.
fn predict(force: &str, words: &[&str]) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let done = command(folder.path())
        .arg("predict")
        .arg(root().join("scenarios/arm-board.toml"))
        .args(["--set", &format!("interaction.press_force_n={force}")])
        .args(words)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

#[test]
fn a_force_too_weak_for_the_dirt_leaves_the_goal_unknown() {
    let (code, summary, remarks) = predict("3", &[]);
    assert_eq!(code, Some(1), "{summary}");
    assert!(summary.contains("unknown, see reaction"), "{summary}");
    let reaction = "by the law of the interaction, 26.9 % of the particles react";
    assert!(summary.contains(reaction), "{summary}");
    assert!(
        remarks.contains("press_force_n is 3 N, and the knowledge base has 10 N"),
        "{remarks}"
    );
    let (_, record, _) = predict("3", &["--json"]);
    let record: Value = serde_json::from_str(&record).unwrap();
    assert_eq!(record["goal"], "unknown");
    assert_eq!(record["goal_met"], false);
}

#[test]
fn a_force_that_moves_the_dirt_needs_no_remark_on_the_reaction() {
    for force in ["10", "40"] {
        let (code, summary, remarks) = predict(force, &[]);
        assert_eq!(code, Some(0), "{summary}");
        assert!(!summary.contains("reaction"), "{summary}");
        assert_eq!(
            remarks.contains("press_force_n"),
            force != "10",
            "{remarks}"
        );
    }
}
