//! Files of version 0.1.0 are still read: a task, a knowledge base, a plan, a bag and an episode.
//!
//! They were written at commit 1d55ce1c, before the recording of a page existed. `wisch run task.toml` wrote plan and
//! episode, and the example `demo_bag` of `wisch-telemetry` wrote the bag, with three lanes at 100 Hz.

use crate::program::{contents, root, wisch};
use serde_json::Value as Json;
use std::fs;
use tempfile::TempDir;

const EPISODE: &str = "20261126-061041-349e";

/// A copy of the files, with the meshes of the shipped tools, which have not changed.
fn copied() -> TempDir {
    let files = root().join("crates/wisch-cli/tests/data/version-0.1.0");
    let meshes = contents(&root().join("knowledge/meshes"));
    let meshes = meshes
        .into_iter()
        .map(|(name, bytes)| (format!("knowledge/meshes/{name}"), bytes));
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, bytes) in contents(&files).into_iter().chain(meshes) {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a copy");
    }
    folder
}

/// What a command prints as JSON.
fn read_json(folder: &TempDir, args: &[&str], expected: i32) -> Json {
    let (code, out, err) = wisch(folder.path(), &[args, &["--json"]].concat());
    assert_eq!(code, expected, "{out}{err}");
    serde_json::from_str(&out).expect("one object")
}

#[test]
fn a_task_and_a_knowledge_base_are_read() {
    let folder = copied();
    let args = ["check", "task.toml", "--knowledge", "knowledge"];
    let (code, out, err) = wisch(folder.path(), &args);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    for line in [
        "small-board: the task is valid",
        "dirt       4 particles of breadcrumbs",
        "reach      the robot follows the whole plan",
    ] {
        assert!(out.contains(line), "{line}: {out}");
    }
}

#[test]
fn a_plan_is_read_and_predicted() {
    let folder = copied();
    let args = ["predict", "task.toml", "--plan", "plan.json"];
    let summary = read_json(&folder, &args, 0);
    assert_eq!(
        (&summary["nodes"], &summary["strokes"]),
        (&2.into(), &1.into())
    );
    assert_eq!(summary["predicted_performance"], 1.0);
}

#[test]
fn a_bag_is_read_and_interpreted() {
    let folder = copied();
    let task = "chopping-board";
    let args = [
        "interpret",
        "demo.mcap",
        "--task",
        task,
        "--action",
        "absorb",
    ];
    let read = read_json(&folder, &args, 1);
    assert_eq!(read["is_conclusive"], true, "{read}");
    assert_eq!(read["verdict"], "unknown", "{read}");
    assert!(read["contact_share"].as_f64() > Some(0.5), "{read}");
}

#[test]
fn an_episode_is_listed_verified_and_exported() {
    let folder = copied();
    let listed = read_json(&folder, &["memory", "list"], 0);
    assert_eq!(
        (&listed["id"], &listed["goal"]),
        (&EPISODE.into(), &"met".into())
    );
    assert_eq!(listed["performance"], 0.99609375);
    for args in [
        &["verify"][..],
        &["show", EPISODE],
        &["export", "--neem", "neem"],
    ] {
        let (code, out, err) = wisch(folder.path(), &[&["memory"], args].concat());
        assert_eq!((code, err.as_str()), (0, ""), "{args:?}: {out}");
    }
    assert!(folder.path().join("neem/triples").is_dir());
}
