//! The mesh of a surface after a run: what keeps a copy of it, and what is refused on another mesh.

use crate::program::{command, root, wisch};
use crate::rounds::after_one_round;
use crate::surfaces::write_grid;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Writes a dish of 0.3 × 0.18 m with this curvature along x \[1/m\].
fn write_dish(folder: &Path, curvature: f64) {
    let dish = |x: f64, y: f64| {
        let (x, y) = (0.3 * x, 0.3 * y);
        [x, y, -0.5 * (curvature * x * x + y * y)]
    };
    write_grid(&folder.join("dish.ply"), dish, 0);
}

/// A folder with the board of `arm-board`, whose surface is a dish.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(root().join("scenarios/arm-board.toml")).unwrap();
    // The planner goes around no objects on curved surfaces.
    let (text, _) = text.split_once("[[scene]]").unwrap();
    let mesh = "friction = 0.45\nmesh = { file = \"dish.ply\" }";
    let text = (text.lines())
        .filter(|line| !line.starts_with("carried_by") && !line.starts_with("skim_edges"))
        .map(|line| line.replace("size_m = [0.32, 0.24]", mesh))
        .collect::<Vec<_>>()
        .join("\n");
    fs::write(folder.path().join("task.toml"), text).unwrap();
    write_dish(folder.path(), 1.0);
    folder
}

const RUN: [&str; 8] = [
    "run",
    "task.toml",
    "--greedy",
    "--rounds",
    "2",
    "--set",
    "target_performance=1.0",
    "--out",
];

/// Runs two short rounds.
fn run(folder: &Path, out: &str) {
    let (code, _, err) = wisch(folder, &[&RUN[..], &[out]].concat());
    assert_eq!(code, 1, "{err}");
}

/// The folder of the only episode.
fn episode(folder: &Path) -> PathBuf {
    let entries = fs::read_dir(folder.join("episodes")).unwrap();
    let mut paths = entries.map(|entry| entry.unwrap().path());
    paths
        .find(|path| path.join("episode.json").is_file())
        .unwrap()
}

#[test]
fn an_episode_keeps_the_mesh_and_teaches_without_it() {
    let folder = folder();
    let place = folder.path();
    run(place, "out");
    let kept = episode(place);
    let mesh = fs::read(place.join("dish.ply")).unwrap();
    assert!(fs::read(kept.join("task-files/1.ply")).unwrap() == mesh);
    let learn = |more: &[&str]| {
        let args = ["learn", "--memory", "episodes", "--out", "learned.toml"];
        wisch(place, &[&args[..], more].concat())
    };
    let (code, known, err) = learn(&["--task", "task.toml"]);
    assert_eq!(code, 0, "{err}");
    // The file is another one: its digest and that of the episode are named.
    write_dish(place, 1.2);
    let (code, _, err) = learn(&["--task", "task.toml"]);
    assert_eq!(code, 2, "{err}");
    for part in [
        "the episode was recorded with another file \"dish.ply\": its digest was fnv1a-64:",
        "and that of the file of --task is fnv1a-64:",
    ] {
        assert!(err.contains(part), "{err}");
    }
    // The episode's own task is read without the file, too.
    fs::remove_file(place.join("dish.ply")).unwrap();
    let (code, out, err) = learn(&[]);
    assert_eq!((code, out.as_str()), (0, known.as_str()), "{err}");
    // A damaged copy is no copy.
    fs::write(kept.join("task-files/1.ply"), "ply").unwrap();
    let (code, _, err) = learn(&[]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the copy of \"dish.ply\" has the digest"),
        "{err}"
    );
}

#[test]
fn a_plan_and_a_bag_of_another_mesh_are_refused() {
    let folder = folder();
    let place = folder.path();
    run(place, "out");
    let interpret = [
        "interpret",
        "out/telemetry/round-1.mcap",
        "--task",
        "task.toml",
    ];
    let predict = [
        "predict",
        "task.toml",
        "--plan",
        "out/plan.json",
        "--out",
        "again",
    ];
    let (code, _, err) = wisch(place, &predict);
    assert!(code < 2, "{err}");
    let (code, _, err) = wisch(place, &interpret);
    assert!(code < 2, "{err}");
    // A plan of an earlier version states no digest.
    let text = fs::read_to_string(place.join("out/plan.json")).unwrap();
    let digest = text
        .lines()
        .find(|line| line.contains("\"digest\""))
        .unwrap();
    let stretch = text
        .lines()
        .find(|line| line.contains("\"stretch\""))
        .unwrap();
    let older = text.replace(
        &format!("{stretch}\n{digest}"),
        stretch.trim_end_matches(','),
    );
    fs::write(place.join("older.json"), older).unwrap();
    let (code, _, err) = wisch(place, &["predict", "task.toml", "--plan", "older.json"]);
    assert!(code < 2, "{err}");

    // The same shape, moved within the file by a millimetre.
    let mesh = |x: f64, y: f64| {
        let (x, y) = (0.3 * x + 0.001, 0.3 * y);
        [x, y, -0.5 * ((x - 0.001).powi(2) + y * y)]
    };
    write_grid(&place.join("dish.ply"), mesh, 0);
    let (code, _, err) = wisch(place, &predict);
    assert_eq!(code, 2);
    assert!(
        err.contains("out/plan.json: the plan's surface shape is")
            && err.matches(", digest ").count() == 2,
        "{err}"
    );
    let (code, _, err) = wisch(place, &interpret);
    assert_eq!(code, 2);
    assert!(
        err.contains("round-1.mcap: the log was recorded on a mesh with the digest")
            && err.contains("but the surface of task \"arm-board\" has the digest"),
        "{err}"
    );
}

#[test]
fn a_killed_run_goes_on_with_the_mesh_with_which_it_began() {
    let folder = folder();
    let place = folder.path();
    run(place, "whole");
    let mut cut = std::process::Command::new(crate::program::path());
    cut.current_dir(place).args(RUN).arg("cut");
    let (mut process, _) = after_one_round(place, cut);
    process.kill().unwrap();
    process.wait().unwrap();
    write_dish(place, 1.2);
    let output = command(place).args(RUN).args(["cut", "--resume"]).output();
    let err = String::from_utf8(output.unwrap().stderr).unwrap();
    for part in [
        "dish.ply: the file has changed since the killed run began: its digest is fnv1a-64:",
        "the run continues with the earlier file",
        "resuming after 1 round of the killed run",
    ] {
        assert!(err.contains(part), "{err}");
    }
    for name in ["plan.json", "rounds.json", "telemetry/round-2.mcap"] {
        let [whole, cut] =
            ["whole", "cut"].map(|run| fs::read(place.join(run).join(name)).unwrap());
        assert!(whole == cut, "{name} differs");
    }
}
