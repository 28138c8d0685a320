//! `wisch learn` in a real temporary directory.

use crate::program::{folder_with, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch::follow::Phase;
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector3};
use wisch::represent::Observation;
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_memory::{Memory, neem};
use wisch_telemetry::{BagHead, BagWriter, LogOptions, ObservationTime, read};

/// A board that is wiped with a sponge by a robot that looks.
pub const TASK: &str = r#"
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

/// The nearest number of single precision, in which episodes keep poses and forces.
fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

/// Runs and bags whose motions differ by 0.1 mm, as no robot moves twice alike.
const RUNS: [&str; 6] = ["first", "second", "blind", "other", "few", "third"];

/// A round in which the sponge strokes once along the middle of the board with 10 N, and takes every crumb up but those that
/// stay.
pub fn write_bag(path: &Path, task: &str, looks: [Option<&Observation>; 2]) {
    write_bag_of_force(path, task, looks, Some("10"));
}

/// The same, with another nominal press force in its notes, or none.
pub fn write_bag_of_force(
    path: &Path,
    task: &str,
    looks: [Option<&Observation>; 2],
    press_force_n: Option<&str>,
) {
    let world_from_surface = Pose::translation(BOARD[0], BOARD[1], BOARD[2]);
    let file = path.to_str().unwrap();
    let run = RUNS.iter().position(|run| file.contains(run));
    let beside = 1e-4 * run.map_or(0.0, |run| run as f64);
    let head = BagHead {
        notes: [("task", task), ("round", "1")]
            .into_iter()
            .chain(press_force_n.map(|force| ("press_force_n", force)))
            .map(|(key, value)| (key.to_owned(), value.to_owned()))
            .collect(),
        ..BagHead::from_surface_pose(world_from_surface)
    };
    let mut bag = BagWriter::create(path, head).unwrap();
    if let Some(before) = looks[0] {
        bag.write_observation(ObservationTime::Before, before)
            .unwrap();
    }
    for index in 0..700 {
        let time = f64::from(index) * 0.01;
        // Down, along, up.
        let (x, z) = match time {
            t if t < 1.0 => (-0.2, 0.05 * (1.0 - t)),
            t if t < 5.0 => (-0.2 + 0.1 * (t - 1.0), 0.0),
            t => (0.2, 0.025 * (t - 5.0)),
        };
        let force = single(10.0 * (1.0 - z / 0.005_f64).clamp(0.0, 1.0));
        let [x, y, z] = [BOARD[0] + x, BOARD[1] + beside, BOARD[2] + z].map(single);
        let there = Pose::translation(x, y, z);
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
            status: SampleStatus::default(),
        })
        .unwrap();
    }
    if let Some(after) = looks[1] {
        bag.write_observation(ObservationTime::After, after)
            .unwrap();
    }
    bag.finish().unwrap();
}

/// Crumbs in a row under the sponge's way, of which every `nth` stays.
pub fn looks(nth: usize) -> [Observation; 2] {
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
    // Notes on what was left out may stand before it.
    assert!(err.lines().any(|line| line.starts_with("error: ")), "{err}");
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
        learn_once_more(folder.path(), number("mean"));
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
        code == 2 && err.contains("mine.toml: the file exists and was not written"),
        "{err}"
    );
}

/// Learns from the runs `first` and `second` with a knowledge base that was learned from them, whose μ is given.
fn learn_once_more(folder: &Path, mu: f64) {
    let args = |runs: &[&'static str]| {
        let more = ["--task", "task.toml", "--knowledge", "knowledge", "--json"];
        [&["learn"], runs, &more].concat()
    };
    let (code, _, err) = wisch(folder, &args(&["first", "second"]));
    assert_eq!(code, 2, "{err}");
    let said = "the knowledge base has been learned from all of the 2 given rounds already";
    assert!(err.contains(said), "{err}");
    // A new run counts, and those before do not count again.
    let [before, after] = looks(4);
    let telemetry = folder.join("third").join("telemetry");
    fs::create_dir_all(&telemetry).unwrap();
    let bag = telemetry.join("round-1.mcap");
    write_bag(&bag, "board", [Some(&before), Some(&after)]);
    let (code, out, err) = wisch(folder, &args(&["first", "second", "third"]));
    assert!(
        code == 0 && err.contains("left out: 2 rounds from which"),
        "{err}"
    );
    let again: Value = serde_json::from_str(&out).unwrap();
    let law = &again["laws"][0];
    assert_eq!(
        (&law["rounds"], &law["runs"]),
        (&1.into(), &1.into()),
        "{again}"
    );
    let known = law["mu"]["before"].as_f64().unwrap();
    assert!((known - mu).abs() < 1e-3, "{again}");
    let written = fs::read_to_string(folder.join("learned.toml")).unwrap();
    let lines = written
        .lines()
        .filter_map(|line| line.strip_prefix("# learned: rounds "));
    let rounds: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
    assert_eq!(rounds.len(), 3, "{written}");
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
        err.contains("other.mcap: the bag has the task \"table-9\", but --task names [\"board\"]"),
        "{err}"
    );
    let err = refused(place, &["other.mcap"]);
    assert!(err.contains("not a shipped scenario"), "{err}");
    // The same name, another place.
    let elsewhere = TASK
        .replace("NAME", "board")
        .replace("[0.6, 0.1, 0.75]", "[0.9, 0.1, 0.75]");
    fs::write(place.join("elsewhere.toml"), elsewhere).unwrap();
    let err = refused(place, &["first", "--task", "elsewhere.toml"]);
    assert!(
        err.contains("the log's surface is 0.300 m away from the surface of task"),
        "{err}"
    );
    let harder = TASK.replace("NAME", "board") + "\n[interaction]\npress_force_n = 12.0\n";
    fs::write(place.join("harder.toml"), harder).unwrap();
    let err = refused(place, &["first", "--task", "harder.toml"]);
    assert!(
        err.contains("interaction.press_force_n = 12, but the knowledge base has 10"),
        "{err}"
    );
    let few = Observation {
        detections: before.detections[..6].to_vec(),
        ..Observation::default()
    };
    write_bag(&place.join("few.mcap"), "board", [Some(&few), Some(&few)]);
    let err = refused(place, &["few.mcap", "--task", "task.toml"]);
    assert!(
        err.contains("particles were touched and observed in 1 rounds; at least 10 are needed"),
        "{err}"
    );
    fs::create_dir(place.join("empty")).unwrap();
    let err = refused(place, &["empty", "--task", "task.toml"]);
    assert!(err.contains("empty: the folder contains no bag"), "{err}");
    let err = refused(place, &["nowhere.mcap", "--task", "task.toml"]);
    assert!(err.contains("nowhere.mcap"), "{err}");
}

#[test]
fn a_run_with_sight_can_be_learned_from() {
    let folder = folder_with("arm-board.toml");
    let run = [
        "run",
        "task.toml",
        // A stroke each.
        "--greedy",
        "--rounds",
        "3",
        "--set",
        "target_performance=1.0",
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

    // Its episode tells the same.
    let memory = Memory::open(&folder.path().join("memory")).unwrap();
    let [id] = &memory.episodes().unwrap()[..] else {
        panic!("one episode");
    };
    let episode = memory.episode(id).unwrap();
    for round in 1..=3 {
        let bag = format!("result/telemetry/round-{round}.mcap");
        let log = read(&folder.path().join(bag), &LogOptions::default()).unwrap();
        let kept = episode.observations(round).unwrap().expect("looks");
        assert_eq!(kept.round, log.round);
        let apart = log.world_from_surface.unwrap().inverse() * kept.world_from_surface;
        assert!(apart.translation.vector.norm() + apart.rotation.angle() < 1e-9);
        for (kept, logged) in kept.observations.iter().zip(&log.observations) {
            let (kept, logged) = (kept.as_ref().unwrap(), logged.as_ref().unwrap());
            assert_eq!(kept.detections.len(), logged.detections.len());
            let pairs = kept.detections.iter().zip(&logged.detections);
            // A bag keeps single precision.
            assert!(pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).norm())) < 1e-7);
        }
    }
    let args = ["--episode", id, "--memory", "memory"];
    assert_alike(&learned(folder.path(), &args), &record);

    // Its bags hold the same rounds.
    let both = ["learn", "result", "--task", "task.toml", "--json"];
    let (code, out, err) = wisch(folder.path(), &[&both[..], &args].concat());
    assert_eq!(code, 0, "{err}");
    assert_eq!(err.matches("note: counted once: ").count(), 3, "{err}");
    assert_alike(&serde_json::from_str(&out).unwrap(), &record);
    let bag = "result/telemetry/round-2.mcap";
    let import = [
        "memory",
        "import",
        bag,
        "--task",
        "task.toml",
        "--memory",
        "memory",
    ];
    for options in [&[][..], &["--force-scale", "2"]] {
        let (code, out, err) = wisch(folder.path(), &[&import, options].concat());
        let known =
            format!("has this round already, as round 2 of the run {id}; nothing was added");
        assert!(code == 0 && out.contains(&known), "{out}{err}");
    }
    assert_eq!(memory.episodes().unwrap().len(), 1);
}

#[test]
fn a_round_is_counted_once_however_it_is_given() {
    let folder = folder();
    let place = folder.path();
    let by_bags = learned(place, &["first", "second"]);
    let [id] = &imported(place, &["first/telemetry/round-1.mcap"])[..] else {
        panic!("one episode");
    };
    // Other bytes after the end of a bag, as those of another compression, are another file.
    let mut bytes = fs::read(place.join("first/telemetry/round-1.mcap")).unwrap();
    bytes.push(0);
    fs::write(place.join("copy.mcap"), &bytes).unwrap();
    let all = [
        "learn",
        "first",
        "second",
        "copy.mcap",
        "--episode",
        id,
        "--task",
        "task.toml",
    ];
    let (code, out, err) = wisch(place, &[&all[..], &["--json"]].concat());
    assert_eq!(code, 0, "{err}");
    assert_eq!(err.matches("note: counted once: ").count(), 2, "{err}");
    assert_alike(&serde_json::from_str(&out).unwrap(), &by_bags);
    // A cut copy is a part of the same round, and a longer log has more than a cut copy.
    let import = [
        "memory",
        "import",
        "--task",
        "task.toml",
        "--start-s",
        "1795309772",
    ];
    fs::write(place.join("cut.mcap.active"), &bytes[..bytes.len() * 2 / 3]).unwrap();
    for log in ["copy.mcap", "cut.mcap.active"] {
        let (code, out, err) = wisch(place, &[&import[..], &[log]].concat());
        assert!(
            code == 0 && out.contains("nothing was added"),
            "{log}: {out}{err}"
        );
    }
    let other = ["--memory", "other", "copy.mcap"];
    let (code, _, err) = wisch(
        place,
        &[&import[..], &["--memory", "other", "cut.mcap.active"]].concat(),
    );
    assert_eq!(code, 0, "{err}");
    let (code, _, err) = wisch(place, &[&import[..], &other].concat());
    assert!(
        code == 2 && err.contains("has the first") && err.contains("memory forget"),
        "{err}"
    );
    // A table holds nothing to learn from.
    fs::write(place.join("log.csv"), "t,x,y,z\n0,0,0,0\n").unwrap();
    fs::remove_file(place.join("learned.toml")).unwrap();
    let err = refused(place, &["log.csv", "--task", "task.toml"]);
    assert!(
        err.contains("log.csv: this is no bag") && err.contains("--memory DIR"),
        "{err}"
    );
}

#[test]
fn the_camera_of_a_bag_is_used_on_request() {
    let folder = folder();
    let place = folder.path();
    let log = "first/telemetry/round-1.mcap";
    let interpret = ["interpret", log, "--task", "task.toml", "--json"];
    let remarks = |more: &[&str]| {
        let (code, out, err) = wisch(place, &[&interpret[..], more].concat());
        assert!(code < 2, "{err}");
        let record: Value = serde_json::from_str(&out).unwrap();
        (
            record["detections"].as_u64(),
            record["log"]["remarks"].to_string(),
        )
    };
    let (detections, said) = remarks(&["--out", "touch"]);
    let unused = format!(
        "the log holds camera observations of the dirt before and after it, which this estimate does not use: wisch interpret uses them with --observation {log}"
    );
    assert!(detections.is_none() && said.contains(&unused), "{said}");
    let (detections, said) = remarks(&["--out", "sight", "--observation", log]);
    assert!(
        detections == Some(4)
            && said.contains("before the log: 16 detections of dirt; after the log: 4 detections of dirt in first/")
            && !said.contains("does not use"),
        "{said}"
    );
    let [before, _] = looks(4);
    write_bag(&place.join("blind.mcap"), "board", [Some(&before), None]);
    let args = [&interpret[..], &["--observation", "blind.mcap", "--force"]].concat();
    let (code, _, err) = wisch(place, &args);
    assert!(
        code == 2 && err.contains("topic /wisch/dirt_after is missing"),
        "{err}"
    );
}

/// How far numbers of single precision move what is learned, as a share: a bag keeps looks in it, an episode poses and forces. This
/// run's law moves by 4e-9. A touch on the very edge of a draw would move it by more: μ by 0.03 of itself in a made-up log of
/// round numbers.
const MOVED: f64 = 1e-6;

/// The same law, but for the precision of what it was learned from.
fn assert_alike(a: &Value, b: &Value) {
    let (laws, others) = (a["laws"].as_array().unwrap(), b["laws"].as_array().unwrap());
    assert_eq!(laws.len(), others.len());
    for (law, other) in laws.iter().zip(others) {
        for key in ["tool", "medium", "surface", "rounds", "runs", "particles"] {
            assert_eq!(law[key], other[key], "{key}");
        }
        for parameter in ["mu", "sigma", "redraw_length_m"] {
            for key in ["before", "mean", "spread", "low", "high"] {
                let [a, b] = [law, other].map(|law| law[parameter][key].as_f64().unwrap());
                let apart = (a - b).abs();
                assert!(
                    apart <= MOVED * a.abs().max(0.01),
                    "{parameter} {key}: {a}, {b}"
                );
            }
        }
    }
}

/// The bags of [`folder`] as episodes of the memory `episodes`, in their order.
fn imported(folder: &Path, bags: &[&str]) -> Vec<String> {
    let starts = (0..).map(|number| (1_795_309_772 + 100 * number).to_string());
    let ids = bags.iter().zip(starts).map(|(bag, start)| {
        let import = ["memory", "import", bag, "--task", "task.toml", "--start-s"];
        let args = [&import[..], &[&start, "--json"]].concat();
        let (code, out, err) = wisch(folder, &args);
        let note = "note: the log holds camera observations of the dirt before";
        assert!(
            code == 0 && err.lines().count() == 1 && err.starts_with(note),
            "{bag}: {err}"
        );
        let record: Value = serde_json::from_str(&out).unwrap();
        record["id"].as_str().unwrap().to_owned()
    });
    ids.collect()
}

#[test]
fn episodes_teach_what_their_bags_do() {
    let folder = folder();
    let place = folder.path();
    let by_bags = learned(place, &["first", "second"]);
    let bags = [
        "first/telemetry/round-1.mcap",
        "second/telemetry/round-1.mcap",
    ];
    let ids = imported(place, &bags);
    // Of numbers that an episode keeps to the last bit, the very same.
    assert_eq!(
        learned(place, &["--memory", "episodes"])["laws"],
        by_bags["laws"]
    );
    let named = [
        "--episode",
        &ids[1],
        "--episode",
        &ids[0],
        "--episode",
        &ids[0],
    ];
    assert_alike(&learned(place, &named), &by_bags);
    assert_alike(&learned(place, &["first", "--episode", &ids[1]]), &by_bags);

    // What was seen goes to others, and comes back.
    let export = ["memory", "export", "--neem", "neem", "--json"];
    let (code, out, err) = wisch(place, &export);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("\"observations\":4"), "{out}");
    let exported = neem::observations(&place.join("neem")).unwrap();
    let memory = Memory::open(&place.join("episodes")).unwrap();
    for id in &ids {
        let kept = memory.episode(id).unwrap().observations(1).unwrap();
        assert_eq!(exported[id].get(&1), kept.as_ref());
        assert!(kept.is_some());
    }

    // Episodes without an observation after their round, and episodes of another task, are left out; if they are named, they are errors.
    let [before, after] = looks(4);
    write_bag(&place.join("blind.mcap"), "board", [Some(&before), None]);
    let [blind] = &imported(place, &["blind.mcap"])[..] else {
        panic!("one episode");
    };
    fs::write(place.join("task.toml"), TASK.replace("NAME", "shelf")).unwrap();
    write_bag(
        &place.join("other.mcap"),
        "shelf",
        [Some(&before), Some(&after)],
    );
    let [other] = &imported(place, &["other.mcap"])[..] else {
        panic!("one episode");
    };
    fs::write(place.join("task.toml"), TASK.replace("NAME", "board")).unwrap();
    let all = [
        "learn",
        "--memory",
        "episodes",
        "--task",
        "task.toml",
        "--json",
    ];
    let (code, out, err) = wisch(place, &all);
    assert_eq!(code, 0, "{err}");
    assert_alike(&serde_json::from_str(&out).unwrap(), &by_bags);
    let unseen = format!(
        "episodes/{blind}/round-1: there is no camera observation of the dirt after this round"
    );
    let unknown = format!(
        "episodes/{other}: the episode has the task \"shelf\", but --task names [\"board\"]"
    );
    for said in [&unseen, &unknown] {
        assert!(err.contains(&format!("note: left out: {said}")), "{err}");
    }
    fs::remove_file(place.join("learned.toml")).unwrap();
    for (id, said) in [(blind, &unseen), (other, &unknown)] {
        let err = refused(place, &["--episode", id, "--task", "task.toml"]);
        assert!(err.contains(said.as_str()), "{err}");
    }
    // Without --task, each episode teaches by the task that it keeps.
    let (code, out, err) = wisch(place, &["learn", "--memory", "episodes", "--json"]);
    assert_eq!(code, 0, "{err}");
    assert!(err.contains(&unseen) && !err.contains(&unknown), "{err}");
    let found: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(found["laws"][0]["rounds"], 3, "{out}");
    fs::remove_file(place.join("learned.toml")).unwrap();
    fs::write(place.join("bench.toml"), TASK.replace("NAME", "bench")).unwrap();
    let bench = ["--memory", "episodes", "--task", "bench.toml", "--quiet"];
    let err = refused(place, &bench);
    assert!(
        err.contains("episodes: none of 4 episodes can be learned from"),
        "{err}"
    );
    let err = refused(place, &["--episode", "20260101-000000-0000"]);
    assert!(err.contains("there is no episode"), "{err}");
    assert!(refused(place, &["--memory", "nowhere"]).contains("no memory of episodes"));

    // A scratch is named, by who looks for it and by who learns.
    let name = format!("episodes/{}/round-1/observations.json", ids[0]);
    let mut bytes = fs::read(place.join(&name)).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(place.join(&name), bytes).unwrap();
    let (code, out, _) = wisch(place, &["memory", "verify"]);
    assert!(code == 1 && out.contains(&name), "{out}");
    let err = refused(place, &["--memory", "episodes", "--task", "task.toml"]);
    assert!(err.contains(&name) && err.contains("check sum"), "{err}");
}
