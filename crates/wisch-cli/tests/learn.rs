//! `wisch learn` in a real temporary directory.

use crate::program::{folder_with, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch::follow::Phase;
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector3};
use wisch::represent::Observation;
use wisch::run::{TelemetrySample, Wrench};
use wisch_telemetry::{BagHead, BagWriter, LogOptions, LookTime, read};

/// A board that is wiped with a sponge by a robot that looks.
const TASK: &str = r#"
schema = 1
name = "NAME"
seed = 1
action = "absorb"

[tool]
name = "sponge"
start_m = [0.0, -0.3]

[medium]
name = "breadcrumbs"

[surface]
name = "chopping_board"
size_m = [0.4, 0.28]
position_m = [0.6, 0.1, 0.75]

[particles]
source = "uniform"
count = 20

[perception]
senses = ["touch", "sight"]
"#;

const BOARD: [f64; 3] = [0.6, 0.1, 0.75];

/// A round in which the sponge strokes once along the middle of the board with 10 N, and takes every crumb up but those that
/// stay.
fn write_bag(path: &Path, task: &str, looks: [Option<&Observation>; 2]) {
    let world_from_surface = Pose::translation(BOARD[0], BOARD[1], BOARD[2]);
    let head = BagHead {
        notes: [("task", task), ("round", "1")]
            .map(|(key, value)| (key.to_owned(), value.to_owned()))
            .into(),
        ..BagHead::at(world_from_surface)
    };
    let mut bag = BagWriter::create(path, head).unwrap();
    if let Some(before) = looks[0] {
        bag.write_observation(LookTime::Before, before).unwrap();
    }
    for index in 0..700 {
        let time = f64::from(index) * 0.01;
        // Down, along, up.
        let (x, z) = match time {
            t if t < 1.0 => (-0.2, 0.05 * (1.0 - t)),
            t if t < 5.0 => (-0.2 + 0.1 * (t - 1.0), 0.0),
            t => (0.2, 0.025 * (t - 5.0)),
        };
        let force = 10.0 * (1.0 - z / 0.005_f64).clamp(0.0, 1.0);
        let there = world_from_surface * Pose::translation(x, 0.0, z);
        bag.write(&TelemetrySample {
            time,
            positions: &[],
            velocities: &[],
            efforts: &[],
            world_from_commanded: there,
            world_from_tool: there,
            controller: Wrench::default(),
            external: Wrench {
                force: Vector3::new(0.0, 0.0, force),
                moment: Vector3::zeros(),
            },
            motion: 0,
            phase: Phase::Wipe(0),
        })
        .unwrap();
    }
    if let Some(after) = looks[1] {
        bag.write_observation(LookTime::After, after).unwrap();
    }
    bag.finish().unwrap();
}

/// Crumbs in a row under the sponge's way, of which every `nth` stays.
fn looks(nth: usize) -> [Observation; 2] {
    let before: Vec<Point2> = (0..16)
        .map(|i| Point2::new(0.02 * f64::from(i) - 0.15, 0.0))
        .collect();
    let after = before.iter().copied().step_by(nth).collect();
    [before, after].map(|detections| Observation {
        detections,
        hidden: Region::new(vec![Polygon::rectangle([0.01, 0.01].into())]),
    })
}

/// A folder with a task and the runs `first` and `second`, after which every fourth crumb is left.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("task.toml"),
        TASK.replace("NAME", "board"),
    )
    .unwrap();
    let [before, after] = looks(4);
    for run in ["first", "second"] {
        let telemetry = folder.path().join(run).join("telemetry");
        fs::create_dir_all(&telemetry).unwrap();
        write_bag(
            &telemetry.join("round-1.mcap"),
            "board",
            [Some(&before), Some(&after)],
        );
    }
    folder
}

fn learned(folder: &Path, more: &[&str]) -> Value {
    let args = [&["learn", "--task", "task.toml", "--json"], more].concat();
    let (code, out, err) = wisch(folder, &args);
    assert_eq!((code, err.as_str()), (0, ""), "{args:?}");
    serde_json::from_str(&out).expect("exactly one JSON object")
}

fn refused(folder: &Path, args: &[&str]) -> String {
    let (code, out, err) = wisch(folder, &[&["learn"], args].concat());
    assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {err}");
    assert!(err.starts_with("error: "), "{err}");
    assert!(
        !folder.join("learned.toml").exists(),
        "nothing is left behind"
    );
    err
}

#[test]
fn bags_hold_what_was_seen() {
    let folder = folder();
    let [before, after] = looks(4);
    let log = read(
        &folder.path().join("first/telemetry/round-1.mcap"),
        &LogOptions::default(),
    )
    .unwrap();
    assert_eq!(log.round, Some(1));
    for (found, written) in log.observations.iter().zip([before, after]) {
        let found = found.as_ref().expect("a look");
        assert_eq!(found.detections.len(), written.detections.len());
        for (found, written) in found.detections.iter().zip(&written.detections) {
            assert!((found - written).norm() < 1e-7);
        }
        assert!(
            found.is_hidden(Point2::new(0.004, 0.004)) && !found.is_hidden(Point2::new(0.006, 0.0))
        );
    }
}

#[test]
fn crumbs_that_stay_make_a_law_harder() {
    let folder = folder();
    let record = learned(
        folder.path(),
        &["first", "second/telemetry/round-1.mcap", "first"],
    );
    let [law] = &record["laws"].as_array().unwrap()[..] else {
        panic!("{record}");
    };
    assert_eq!(
        (&law["surface"], &law["rounds"], &law["runs"]),
        (&"chopping_board".into(), &2.into(), &2.into())
    );
    // Two of 16 lie beside the way or are hidden.
    assert!(
        (24..=32).contains(&law["particles"].as_u64().unwrap()),
        "{record}"
    );
    let number = |key: &str| law["mu"][key].as_f64().unwrap();
    // A quarter stays at full force, of which the knowledge base has it that nearly none does.
    assert_eq!(number("before"), -1.05);
    assert!(number("low") > -1.05 && number("mean") > -0.7, "{record}");
    let written = fs::read_to_string(folder.path().join("learned.toml")).unwrap();
    for part in [
        "schema = 1\n",
        "tool = \"sponge\"",
        "# learned: from 2 rounds of 2 runs",
        "mu_spread = ",
        "redraw_length_m = ",
    ] {
        assert!(written.contains(part), "{part} in {written}");
    }
    toml_entries(&written);

    // As a diff, which other programs apply; nothing is written over what is not ours.
    let knowledge = folder.path().join("knowledge");
    copy(&crate::program::root().join("knowledge"), &knowledge);
    let args = [
        "learn",
        "first",
        "second",
        "--task",
        "task.toml",
        "--knowledge",
        "knowledge",
        "--diff",
    ];
    let (code, diff, err) = wisch(folder.path(), &args);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        diff.starts_with("--- a/interactions.toml\n+++ b/interactions.toml\n@@ -"),
        "{diff}"
    );
    fs::write(folder.path().join("learned.diff"), &diff).unwrap();
    let patched = std::process::Command::new("patch")
        .args(["-p1", "-d", "knowledge", "-i", "../learned.diff"])
        .current_dir(folder.path())
        .status();
    if patched.is_ok_and(|status| status.success()) {
        // What was learned is what is known now.
        let again = [
            "learn",
            "first",
            "second",
            "--task",
            "task.toml",
            "--knowledge",
            "knowledge",
            "--json",
        ];
        let (code, out, err) = wisch(folder.path(), &again);
        assert_eq!((code, err.as_str()), (0, ""));
        let again: Value = serde_json::from_str(&out).unwrap();
        let before = again["laws"][0]["mu"]["before"].as_f64().unwrap();
        assert!((before - number("mean")).abs() < 1e-3, "{again}");
    }
    fs::write(folder.path().join("mine.toml"), "mu = 1\n").unwrap();
    let args = [
        "learn",
        "first",
        "--task",
        "task.toml",
        "--out",
        "mine.toml",
    ];
    let (code, _, err) = wisch(folder.path(), &args);
    assert!(
        code == 2 && err.contains("mine.toml: this file is there already"),
        "{err}"
    );
}

/// The file is TOML that people and programs read.
fn toml_entries(text: &str) {
    let entries = text.matches("[[interaction]]").count();
    assert_eq!(entries, 1, "{text}");
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

#[test]
fn bags_that_teach_nothing_are_refused_by_name() {
    let folder = folder();
    let place = folder.path();
    let [before, after] = looks(4);
    write_bag(&place.join("blind.mcap"), "board", [Some(&before), None]);
    let err = refused(place, &["blind.mcap", "--task", "task.toml"]);
    assert!(
        err.contains("blind.mcap: topic /wisch/dirt_after is missing"),
        "{err}"
    );
    write_bag(
        &place.join("other.mcap"),
        "table-9",
        [Some(&before), Some(&after)],
    );
    let err = refused(place, &["other.mcap", "--task", "task.toml"]);
    assert!(
        err.contains(
            "other.mcap: the bag is of the task \"table-9\", and --task names [\"board\"]"
        ),
        "{err}"
    );
    let err = refused(place, &["other.mcap"]);
    assert!(err.contains("none of the shipped scenarios"), "{err}");
    // The same name, another place.
    let elsewhere = TASK
        .replace("NAME", "board")
        .replace("[0.6, 0.1, 0.75]", "[0.9, 0.1, 0.75]");
    fs::write(place.join("elsewhere.toml"), elsewhere).unwrap();
    let err = refused(place, &["first", "--task", "elsewhere.toml"]);
    assert!(
        err.contains("its surface is 0.300 m from that of the task"),
        "{err}"
    );
    let harder = TASK.replace("NAME", "board") + "\n[interaction]\npress_force_n = 12.0\n";
    fs::write(place.join("harder.toml"), harder).unwrap();
    let err = refused(place, &["first", "--task", "harder.toml"]);
    assert!(
        err.contains("interaction.press_force_n = 12, and the knowledge base 10"),
        "{err}"
    );
    let few = Observation {
        detections: before.detections[..6].to_vec(),
        ..Observation::default()
    };
    write_bag(&place.join("few.mcap"), "board", [Some(&few), Some(&few)]);
    let err = refused(place, &["few.mcap", "--task", "task.toml"]);
    assert!(
        err.contains(
            "particles were touched and looked for in 1 rounds, and at least 10 are needed"
        ),
        "{err}"
    );
    fs::create_dir(place.join("empty")).unwrap();
    let err = refused(place, &["empty", "--task", "task.toml"]);
    assert!(
        err.contains("empty: there is no bag in this folder"),
        "{err}"
    );
    let err = refused(place, &["nowhere.mcap", "--task", "task.toml"]);
    assert!(err.contains("nowhere.mcap"), "{err}");
}

#[test]
fn a_run_with_sight_can_be_learned_from() {
    let folder = folder_with("arm-board.toml");
    let run = [
        "run",
        "task.toml",
        "--rounds",
        "2",
        "--out",
        "result",
        "--memory",
        "memory",
        "--quiet",
    ];
    let (code, _, err) = wisch(folder.path(), &run);
    assert!(code < 2, "{err}");
    let (code, out, err) = wisch(
        folder.path(),
        &["learn", "result", "--task", "task.toml", "--json"],
    );
    assert_eq!((code, err.as_str()), (0, ""));
    let record: Value = serde_json::from_str(&out).unwrap();
    assert!(
        record["laws"][0]["particles"].as_u64().unwrap() > 20,
        "{record}"
    );
}
