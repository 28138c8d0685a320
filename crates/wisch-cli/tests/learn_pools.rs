//! Which rounds `wisch learn` pools: surfaces that only a task defines, episodes that teach nothing, and press forces.

use crate::learn::{TASK, looks, write_bag};
use crate::program::wisch;
use std::fs;
use std::path::Path;

/// Imports a bag as an episode of the memory, with a task.
fn import(folder: &Path, bag: &str, task: &str) {
    let (code, out, err) = wisch(folder, &["memory", "import", bag, "--task", task]);
    assert_eq!(code, 0, "{out}{err}");
}

#[test]
fn a_surface_that_only_the_task_defines_teaches_the_law_of_any_surface() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let own = TASK
        .replace("NAME", "mine")
        .replace("\"chopping_board\"\n", "\"my_board\"\nfriction = 0.3\n");
    fs::write(folder.join("mine.toml"), &own).unwrap();
    // An interaction that only the task defines belongs to no law of the knowledge base.
    let alone = own.replace("\"mine\"", "\"alone\"")
        + "\n[interaction]\nmu = -1.0\nsigma = 0.3\npress_force_n = 12.0\n";
    fs::write(folder.join("alone.toml"), alone).unwrap();
    let [before, after] = looks(4);
    for (bag, task) in [("first.mcap", "mine"), ("second.mcap", "alone")] {
        write_bag(&folder.join(bag), task, [Some(&before), Some(&after)]);
        import(folder, bag, &format!("{task}.toml"));
    }
    let (code, out, err) = wisch(folder, &["learn", "--memory", "episodes", "--json"]);
    assert_eq!(code, 0, "{err}");
    let left_out: Vec<&str> = err
        .lines()
        .filter(|line| line.contains("left out"))
        .collect();
    assert!(
        left_out.len() == 1 && left_out[0].contains("unknown surface \"my_board\""),
        "{err}"
    );
    let record: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    let law = &record["laws"][0];
    assert_eq!(
        (&law["surface"], &law["rounds"]),
        (&"any".into(), &1.into())
    );
    assert_eq!(law["press_force_n"], 10.0);
}

#[test]
fn a_round_of_an_episode_that_is_left_out_counts_in_another_one() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let board = TASK.replace("NAME", "board");
    fs::write(folder.join("board.toml"), &board).unwrap();
    let alone = board.replace("\"board\"", "\"alone\"")
        + "\n[interaction]\nmu = -1.0\nsigma = 0.3\npress_force_n = 12.0\n";
    fs::write(folder.join("alone.toml"), alone).unwrap();
    let [before, after] = looks(4);
    for (bag, task, start) in [
        ("first-alone.mcap", "alone", "1795309772"),
        ("first.mcap", "board", "1795309872"),
    ] {
        crate::learn::write_bag_of_force(
            &folder.join(bag),
            task,
            [Some(&before), Some(&after)],
            None,
        );
        let task = format!("{task}.toml");
        let import = ["memory", "import", bag, "--task", &task, "--start-s", start];
        let (code, out, err) = wisch(folder, &import);
        assert_eq!(code, 0, "{out}{err}");
    }
    let (code, out, err) = wisch(folder, &["learn", "--memory", "episodes", "--json"]);
    assert_eq!(code, 0, "{err}");
    assert!(
        err.matches("left out").count() == 1 && !err.contains("counted once"),
        "{err}"
    );
    let record: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(record["laws"][0]["rounds"], 1, "{out}");
}

#[test]
fn rounds_of_another_press_force_are_not_pooled() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("task.toml"), TASK.replace("NAME", "board")).unwrap();
    let [before, after] = looks(4);
    let bag = folder.join("first.mcap");
    write_bag(&bag, "board", [Some(&before), Some(&after)]);
    crate::learn::write_bag_of_force(
        &folder.join("second.mcap"),
        "board",
        [Some(&before), Some(&after)],
        Some("6"),
    );
    let learn = |bags: &[&str]| {
        let args = [&["learn", "--task", "task.toml"], bags].concat();
        wisch(folder, &args)
    };
    let (code, _, err) = learn(&["first.mcap", "second.mcap"]);
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains(
            "second.mcap: the round was recorded with a press force of 6 N, but task \"board\" has"
        ) && err.contains("= 10 N"),
        "{err}"
    );
    // An older bag does not state it.
    crate::learn::write_bag_of_force(
        &folder.join("third.mcap"),
        "board",
        [Some(&before), Some(&after)],
        None,
    );
    let (code, out, err) = learn(&["first.mcap", "third.mcap"]);
    assert_eq!(code, 0, "{err}");
    assert!(
        err.contains("the task, 10 N, is assumed") && err.contains("do not state it: third.mcap"),
        "{err}"
    );
    assert!(out.contains("10 N, assumed for 1 of 2 rounds"), "{out}");
}
