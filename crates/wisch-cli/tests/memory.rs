//! `wisch run` keeps episodes, and `wisch memory` looks at them, in a real temporary directory.

use crate::program::{folder_with, wisch};
use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch_memory::{EpisodeRecord, Frames, Memory, Origin, PoseAt, Sampling, Value};
use wisch_telemetry::{LogOptions, read};

/// Joints are stored in single precision; over a robot's length that is this far at the tool [m].
const POSE_TOLERANCE: f64 = 2e-6;
/// A force of single precision, of some hundred newtons at most [N].
const FORCE_TOLERANCE: f64 = 1e-4;

/// Standard output of what works.
fn said(folder: &Path, args: &[&str]) -> String {
    let (code, out, err) = wisch(folder, args);
    assert_eq!((code, err.as_str()), (0, ""), "{args:?}: {out}");
    out
}

/// A memory with one episode of one round, beside its results in `result`.
fn one_run() -> (TempDir, Memory, String) {
    let folder = folder_with("arm-board.toml");
    // By touch alone, as the bag will be interpreted.
    let args = [
        "run",
        "task.toml",
        "--rounds",
        "1",
        "--touch-only",
        "--out",
        "result",
    ];
    let (code, out, err) = wisch(folder.path(), &args);
    assert!(code <= 1 && err.is_empty(), "{code}: {err}");
    let memory = Memory::open(&folder.path().join("episodes")).expect("the usual memory");
    let ids = memory.episodes().expect("a list");
    assert_eq!(ids.len(), 1);
    assert!(out.contains(&format!("episodes/{}", ids[0])), "{out}");
    (folder, memory, ids[0].clone())
}

fn number(record: &EpisodeRecord, class: &str, property: &str) -> f64 {
    let mut those = record.individuals.iter().filter(|one| one.class == class);
    match those.next().and_then(|one| one.values.get(property)) {
        Some(Value::Number(number)) => *number,
        other => panic!("{class} {property}: {other:?}"),
    }
}

#[test]
fn a_run_is_kept_as_it_was_and_can_be_asked() {
    let (folder, memory, id) = one_run();
    let episode = memory.episode(&id).expect("the episode");
    let record = episode.record().expect("its record");
    let text = fs::read_to_string(folder.path().join("result/rounds.json")).expect("rounds");
    let rounds: Json = serde_json::from_str(&text).expect("JSON");
    for (property, key) in [
        ("semco:performance", "estimated"),
        ("semco:predictedPerformance", "predicted"),
        ("semco:simulatedPerformance", "true_performance"),
    ] {
        let kept = number(&record, "semco:WipingRound", property);
        assert_eq!(rounds[0][key].as_f64(), Some(kept), "{property}");
        assert_eq!(number(&record, "semco:WipingAction", property), kept);
    }
    parts_lie_within_the_whole(&record);
    let strokes = record.individuals.iter();
    let strokes = strokes.filter(|one| one.class == "semco:Stroke").count();
    assert_eq!(
        strokes as f64,
        number(&record, "semco:WipingRound", "semco:strokes")
    );
    assert_eq!(record.origin, Origin::Simulated);

    // Against the bag, which another program part wrote.
    let bag = read(
        &folder.path().join("result/telemetry/round-1.mcap"),
        &LogOptions::default(),
    );
    let bag = bag.expect("a bag");
    let telemetry = episode.telemetry(1).expect("telemetry");
    assert_eq!(telemetry.rows(), bag.samples.len());
    let robot = episode.robot().expect("the robot");
    let frames = Frames::new(&robot, &telemetry).expect("frames");
    let [first, last] = telemetry.interval().expect("samples");
    let force = telemetry.values("external/fz", 0..telemetry.rows());
    for (sample, force) in bag.samples.iter().zip(force.expect("forces")) {
        assert!((sample.force.z - force).abs() < FORCE_TOLERANCE);
    }
    let apart = |a: &PoseAt, sample: &wisch::interpret::TouchSample| {
        let tool_from_tool = a.world_from_frame.inv_mul(&sample.world_from_tool);
        tool_from_tool.translation.vector.norm() + tool_from_tool.rotation.angle()
    };
    let trajectory = frames.trajectory("sponge", [first, last], Sampling::Count(50));
    for pose in trajectory.expect("poses") {
        let row = bag
            .samples
            .partition_point(|sample| sample.time < pose.time - 1e-9);
        let distance = apart(&pose, &bag.samples[row]);
        assert!(distance < POSE_TOLERANCE, "{distance} at {} s", pose.time);
    }
    let half = frames.trajectory("tcp", [first, first + 1.5], Sampling::Every(0.5));
    assert_eq!(half.expect("poses").len(), 4);
    let wrong = frames
        .pose("spong", first)
        .expect_err("no such frame")
        .to_string();
    assert_eq!(
        wrong,
        "there is no frame \"spong\"; the nearest is \"sponge\""
    );
    let late = frames
        .pose("tcp", last + 1.0)
        .expect_err("too late")
        .to_string();
    assert!(late.starts_with("time: "), "{late}");

    let listed: Json = serde_json::from_str(&said(folder.path(), &["memory", "list", "--json"]))
        .expect("one object");
    assert_eq!(listed["id"], id.as_str());
    assert_eq!(listed["performance"], rounds[0]["estimated"]);
    let table = said(folder.path(), &["memory", "list"]);
    assert!(
        table.contains(&id) && table.ends_with("1 episode\n"),
        "{table}"
    );
    let shown = said(folder.path(), &["memory", "show", &id]);
    assert!(
        shown.contains("Stroke") && shown.contains("round-1.parquet"),
        "{shown}"
    );

    // The memory has the round of this bag already.
    let bag = [
        "memory",
        "import",
        "result/telemetry/round-1.mcap",
        "--task",
        "task.toml",
    ];
    let known = said(folder.path(), &bag);
    assert!(known.contains("nothing was added"), "{known}");

    assert_eq!(
        said(folder.path(), &["memory", "verify"]),
        "1 episode: no faults\n"
    );
    let scratched = memory.folder().join(&id).join("round-1.parquet");
    let mut bytes = fs::read(&scratched).expect("a file");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&scratched, bytes).expect("a scratch");
    let (code, out, _) = wisch(folder.path(), &["memory", "verify"]);
    assert_eq!(code, 1);
    assert!(
        out.contains("round-1.parquet") && out.ends_with("1 fault\n"),
        "{out}"
    );
    let told = memory.folder().join("told.jsonl");
    fs::write(&told, "[\"semco:x\",\n").expect("a cut statement");
    let (_, out, _) = wisch(folder.path(), &["memory", "verify"]);
    assert!(out.contains("told.jsonl: line 1 is no statement"), "{out}");
    fs::remove_file(told).expect("its end");
    let forgot = said(folder.path(), &["memory", "forget", &id]);
    assert_eq!(forgot, format!("forgot {id}\n"));

    // Without that episode, the bag says the same as the bag of another robot.
    let import = [&bag[..], &["--start-s", "1795309772", "--json"]].concat();
    let imported: EpisodeRecord =
        serde_json::from_str(&said(folder.path(), &import)).expect("a record");
    assert!(
        imported.id.starts_with("20261122-010932-"),
        "{}",
        imported.id
    );
    assert_eq!(imported.origin, Origin::Imported("round-1.mcap".to_owned()));
    let again = number(&imported, "semco:WipingRound", "semco:performance");
    // But for rounding of what was logged.
    let estimated = rounds[0]["estimated"].as_f64().expect("a number");
    assert!((estimated - again).abs() < 1e-4, "{estimated}, {again}");
    parts_lie_within_the_whole(&imported);
    let other = memory.episode(&imported.id).expect("the import");
    let rows = other.telemetry(1).expect("telemetry").rows();
    assert_eq!(rows, telemetry.rows());
    assert_eq!(
        said(folder.path(), &["memory", "verify"]),
        "1 episode: no faults\n"
    );
}

/// Times of parts within those of what they are part of.
fn parts_lie_within_the_whole(record: &EpisodeRecord) {
    for one in &record.individuals {
        let (Some([start, end]), Some(parent)) = (one.interval, one.parent) else {
            continue;
        };
        let [from, to] = record.individuals[parent]
            .interval
            .expect("the whole has a time");
        assert!(from <= start && end <= record.interval[1], "{one:?}");
        // An event begins during its motion, and may outlast it.
        let is_event = record.individuals[parent].class != "semco:WipingRound";
        assert!(end <= to || is_event, "{one:?} in {from} to {to}");
    }
}

#[test]
fn without_a_memory_or_a_robot_nothing_is_kept() {
    let folder = folder_with("arm-board.toml");
    let alone = ["run", "task.toml", "--robot", "none"];
    wisch(folder.path(), &alone);
    assert!(!folder.path().join("episodes").exists());
    for (args, expected) in [
        (
            &["memory", "list"][..],
            "episodes: there is no memory of episodes",
        ),
        (
            &["memory", "show", "x", "--memory", "."],
            "there is no episode \"x\"",
        ),
        (
            &["run", "task.toml", "--memory", "task.toml"],
            "task.toml: ",
        ),
        (
            &["run", "task.toml", "--memory", "m", "--no-memory"],
            "--no-memory",
        ),
        (
            &["memory", "import", "none.mcap", "--task", "task.toml"],
            "none.mcap",
        ),
        (
            &[
                "memory",
                "import",
                "x",
                "--task",
                "task.toml",
                "--start-s=-1",
            ],
            "-1 s is outside 0 to 10000000000 s",
        ),
    ] {
        let (code, out, err) = wisch(folder.path(), args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(
            err.starts_with("error: ") && err.contains(expected),
            "{err}"
        );
    }
    assert!(!folder.path().join("episodes").exists());
}

/// A full disk, where this system lets anybody mount a small one for a command.
#[cfg(target_os = "linux")]
#[test]
fn on_a_full_disk_the_results_are_kept_and_of_the_episode_what_can_be() {
    use std::process::Command;
    let can_mount = Command::new("unshare")
        .args(["-rm", "mount", "-t", "tmpfs", "tmpfs", "/mnt"])
        .output()
        .is_ok_and(|output| output.status.success());
    if !can_mount {
        eprintln!("SKIPPED: no small disk can be mounted");
        return;
    }
    let folder = folder_with("arm-board.toml");
    fs::create_dir(folder.path().join("disk")).unwrap();
    // The telemetry of a round takes some megabytes, the rest of the episode far less than one.
    for (size, is_kept) in [("1m", true), ("16k", false)] {
        let script = format!(
            "mount -t tmpfs -o size={size} tmpfs disk
             $0 run task.toml --rounds 1 --set \"strategy='kde'\" --memory disk/episodes --out {size}; echo code $?
             $0 memory verify --memory disk/episodes
             $0 memory list --memory disk/episodes --json"
        );
        let output = Command::new("unshare")
            .current_dir(folder.path())
            .args(["-rm", "sh", "-c", &script])
            .arg(crate::program::path())
            .output()
            .unwrap();
        let [out, err] = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b));
        assert!(
            err.contains("No space left on device"),
            "{size}: {out}{err}"
        );
        for file in [
            "report.html",
            "plan.json",
            "rounds.json",
            "telemetry/round-1.mcap",
        ] {
            assert!(
                folder.path().join(size).join(file).is_file(),
                "{size}: {file}\n{err}"
            );
        }
        let episodes = if is_kept {
            "1 episode: 1 fault"
        } else {
            "0 episodes: no faults"
        };
        assert!(out.contains(episodes), "{size}: {out}{err}");
        assert_eq!(out.contains("\"task\""), is_kept, "{out}");
        assert!(
            out.contains("code 2") && err.contains("error: "),
            "{out}{err}"
        );
        if is_kept {
            let says = "the episode was kept without the telemetry of round 1";
            assert!(err.contains(says), "{err}");
            assert!(out.contains("round 1 has no telemetry: "), "{out}");
        }
    }
    // The other way round: the episode does not depend on where the results go, whether the bag is cut off at its beginning
    // or after some seconds.
    for size in ["256k", "4m"] {
        let script = format!(
            "mount -t tmpfs -o size={size} tmpfs disk
             $0 run task.toml --rounds 1 --set \"strategy='kde'\" --out disk/out --memory kept-{size}; echo code $?
             $0 memory verify --memory kept-{size}"
        );
        let output = Command::new("unshare")
            .current_dir(folder.path())
            .args(["-rm", "sh", "-c", &script])
            .arg(crate::program::path())
            .output()
            .unwrap();
        let [out, err] = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b));
        assert!(out.contains("code 2\n1 episode: no faults"), "{out}{err}");
        let says = format!("note: the episode was kept in kept-{size}/");
        assert!(err.contains(&says) && err.contains("round-1.mcap"), "{err}");
        let memory = Memory::open(&folder.path().join(format!("kept-{size}"))).unwrap();
        let id = &memory.episodes().unwrap()[0];
        let telemetry = memory.episode(id).unwrap().telemetry(1).unwrap();
        let [first, last] = telemetry.interval().unwrap();
        assert!(first == 0.0 && last > 15.0, "{first} to {last} s");
        let periods = (last * 1000.0).round() as usize;
        assert_eq!(telemetry.rows(), periods + 1, "a sample every millisecond");
    }
}
