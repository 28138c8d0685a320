//! `wisch run --executor` and `--events`.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use wisch_memory::Memory;

/// One round on a small board.
fn wisch(folder: &Path, more: &[&str]) -> Output {
    let task = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/arm-board.toml");
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("wisch"));
    command.current_dir(folder).arg("run").arg(task);
    command.args(["--rounds", "1", "--no-memory", "--out", "out"]);
    command.args(more).output().expect("it runs")
}

/// The kinds of events, without those that repeat the one before; every line is an object that has one.
fn kinds(lines: &str) -> Vec<String> {
    let mut kinds: Vec<String> = Vec::new();
    for line in lines.lines() {
        let event: Value = serde_json::from_str(line).expect(line);
        let kind = event["event"].as_str().expect(line).to_owned();
        if kinds.last() != Some(&kind) {
            kinds.push(kind);
        }
    }
    kinds
}

const ROUND: [&str; 9] = [
    "planning",
    "planned",
    "following",
    "audited",
    "executing",
    "sample",
    "interpreting",
    "decided",
    "ended",
];

/// Whether there is Python; where CI runs there has to be.
pub fn has_python() -> bool {
    let is_there = Command::new("python3").arg("--version").output().is_ok();
    let is_ci = std::env::var("CI").is_ok_and(|ci| ci == "true");
    assert!(is_there || !is_ci, "there is no python3");
    if !is_there {
        eprintln!("SKIPPED: there is no python3 to run executors with");
    }
    is_there
}

/// As at half speed of the pendant: phases follow the time on the trajectory, not the clock.
#[test]
fn an_episode_of_a_slow_robot_has_the_phases_that_it_executed() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/echo_robot.py");
    let robot = fs::read_to_string(robot).expect("the robot");
    let slow = robot.replace(
        "\"time_s\": time,",
        "\"time_s\": 2 * time, \"trajectory_time_s\": time,",
    );
    let slow = slow.replace("\"duration_s\": motion", "\"duration_s\": 2 * motion");
    fs::write(folder.path().join("robot.py"), &robot).expect("a file");
    fs::write(folder.path().join("slow.py"), slow).expect("a file");
    let motions = |robot: &str| {
        let memory = format!("{robot}-memory");
        let executor = format!("python3 {robot}.py");
        let task = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/arm-board.toml");
        let output = Command::new(assert_cmd::cargo::cargo_bin!("wisch"))
            .current_dir(folder.path())
            .arg("run")
            .arg(task)
            .args(["--rounds", "1", "--executor", &executor])
            .args(["--memory", &memory, "--out", robot])
            .output()
            .expect("it runs");
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() < Some(2), "{err}");
        let memory = Memory::open(&folder.path().join(memory)).expect("a memory");
        let id = memory.episodes().expect("episodes")[0].clone();
        let telemetry = memory.episode(&id).expect("the episode").telemetry(1);
        let telemetry = telemetry.expect("telemetry");
        let rows = 0..telemetry.rows();
        ["motion", "phase"].map(|column| telemetry.values(column, rows.clone()).expect(column))
    };
    assert_eq!(motions("slow"), motions("robot"));
}

#[test]
fn a_run_by_another_program_writes_its_events_and_knows_no_truth() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/echo_robot.py");
    fs::copy(robot, folder.path().join("echo robot.py")).expect("a copy");
    // It only feels, and a single round leaves much open.
    let executor = [
        "--executor",
        "python3 'echo robot.py'",
        "--json",
        "--set",
        "target_performance=0.2",
        // The target is chosen for the motion with this mount.
        "--set",
        "tool.mount={on=\"hand\"}",
    ];
    let output = wisch(
        folder.path(),
        &[&executor[..], &["--events", "events.jsonl"]].concat(),
    );
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*err), (Some(0), ""));
    let summary: Value = serde_json::from_slice(&output.stdout).expect("one object");
    let round = &summary["rounds"][0];
    assert_eq!(round["verdict"], "goal met", "{round}");
    assert_eq!(round["true_performance"], Value::Null);
    assert!(folder.path().join("out/report.html").is_file());

    let events = fs::read_to_string(folder.path().join("events.jsonl")).expect("events");
    assert_eq!(kinds(&events), ROUND);
    let felt = events.lines().any(|line| {
        let event: Value = serde_json::from_str(line).expect(line);
        event["phase"] == "wipe" && event["force_n"][2].as_f64() > Some(5.0)
    });
    assert!(felt, "no sample shows the force of the robot");
    let last: Value = serde_json::from_str(events.lines().last().expect("a line")).expect("JSON");
    assert_eq!(last["verdict"], "goal met");
}

#[test]
fn events_on_standard_output_stand_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = wisch(folder.path(), &["--greedy", "--events", "-"]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*err), (Some(1), ""));
    let out = String::from_utf8(output.stdout).expect("text");
    let mut expected = ROUND.to_vec();
    expected.insert(1, "observed");
    expected.insert(8, "observed");
    assert_eq!(kinds(&out), expected);
    let first: Value = serde_json::from_str(out.lines().next().expect("a line")).expect("JSON");
    assert_eq!(first["schema"], 2);
}

#[test]
fn an_executor_that_cannot_be_used_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for (executor, expected) in [
        ("no-such-robot --fast", "executor \"no-such-robot\""),
        ("  ", "not a command"),
        ("'open", "not a command"),
    ] {
        let output = wisch(folder.path(), &["--executor", executor]);
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{err}");
        assert!(err.contains(expected), "{err}");
        assert!(!folder.path().join("out").exists());
    }
    let output = wisch(folder.path(), &["--events", "nowhere/events.jsonl"]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{err}");
    assert!(err.contains("events.jsonl: cannot write there"), "{err}");
}

#[test]
fn a_silent_executor_is_abandoned_and_the_episode_is_kept() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/echo_robot.py");
    let robot = fs::read_to_string(robot).expect("a robot");
    let spoiled = robot.replace(
        "    for point in points:\n",
        "    for point in points:\n        if point[\"time_s\"] > 2.0:\n            import time; time.sleep(600)\n",
    );
    assert_ne!(spoiled, robot);
    fs::write(folder.path().join("robot.py"), spoiled).expect("a copy");
    let task = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/arm-board.toml");
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("wisch"));
    command.current_dir(folder.path()).arg("run").arg(task);
    command.args([
        "--executor",
        "python3 robot.py",
        "--timeout",
        "2",
        "--memory",
        "memory",
    ]);
    let output = command.output().expect("it runs");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{err}");
    assert!(err.contains("no message for 2 s"), "{err}");
    assert!(err.contains("the episode was kept in"), "{err}");
    let kept = fs::read_dir(folder.path().join("memory")).expect("a memory");
    assert!(kept.count() > 0);
    let refused = wisch(folder.path(), &["--executor", "true", "--timeout", "0"]);
    let err = String::from_utf8_lossy(&refused.stderr);
    assert!(err.contains("0 s is outside 0.001 to 86400 s"), "{err}");
}

#[test]
fn a_robot_that_cannot_be_prepared_does_not_move_and_one_that_is_not_handed_back_is_named() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/echo_robot.py");
    let robot = fs::read_to_string(robot).expect("a robot");
    let with = |prepare: &str, finish: &str| {
        let answers = format!(
            "        if message == \"prepare\":\n            {prepare}\n        elif message == \"finish\":\n            {finish}\n        elif \"hello\" in message:"
        );
        let spoiled = robot
            .replace("        if \"hello\" in message:", &answers)
            .replace("{\"version\": 1}", "{\"version\": 2, \"prepares\": True}");
        assert_ne!(spoiled, robot);
        fs::write(folder.path().join("robot.py"), spoiled).expect("a copy");
        let output = wisch(folder.path(), &["--executor", "python3 robot.py"]);
        let err = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), err)
    };
    let [prepared, finished] =
        ["prepared", "finished"].map(|word| format!("print('\"{word}\"', flush=True)"));
    assert_eq!(with(&prepared, &finished), (Some(1), String::new()));

    let (code, err) = with(&prepared, "say(error=\"the pendant is locked\")");
    assert_eq!(code, Some(1), "{err}");
    let warned = "the robot is not handed back, because finish failed: executor \"python3\": the pendant is locked";
    assert!(err.contains(warned), "{err}");

    let (code, err) = with("say(error=\"the brakes are closed\")", &finished);
    assert_eq!(code, Some(2), "{err}");
    assert!(err.contains("the brakes are closed"), "{err}");
}

/// Writes `robot.py`, whose sensor hangs in the second half of the motion, which the driver says.
fn write_hanging_robot(folder: &Path) {
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/echo_robot.py");
    let robot = fs::read_to_string(robot).expect("a robot");
    let hanging = robot
        .replace("{\"version\": 1}", "{\"version\": 2, \"stamp_clock\": \"epoch\"}")
        .replace(
            "                \"time_s\": time,\n",
            "                \"time_s\": time,\n                \"stamp_ns\": 1764150000000000000 + int(1e9 * time),\n                \"wrench_quality\": \"stale\" if hangs else \"ok\",\n",
        )
        .replace(
            "        force = motion",
            "        hangs = time > motion[\"duration_s\"] / 2\n        presses |= hangs\n        force = motion",
        );
    assert_ne!(hanging, robot);
    fs::write(folder.join("robot.py"), hanging).expect("a copy");
}

#[test]
fn the_episode_of_a_run_keeps_qualities_of_wrenches_and_stamps() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    write_hanging_robot(folder.path());
    let task = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/arm-board.toml");
    let run = |arguments: &[&str]| {
        let output = Command::new(assert_cmd::cargo::cargo_bin!("wisch"))
            .current_dir(folder.path())
            .args(arguments)
            .output()
            .expect("it runs");
        let err = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() < Some(2), "{err}");
        String::from_utf8(output.stdout).expect("text")
    };
    let task = task.display().to_string();
    let robot = ["--executor", "python3 robot.py", "--touch-only"];
    let more = ["--rounds", "1", "--memory", "episodes", "--out", "out"];
    run(&[&["run", &task][..], &robot, &more].concat());
    let memory = Memory::open(&folder.path().join("episodes")).expect("a memory");
    let id = memory.episodes().expect("episodes")[0].clone();
    let telemetry = memory.episode(&id).expect("the episode").telemetry(1);
    let telemetry = telemetry.expect("telemetry");
    let (usable, unusable) = telemetry.touch_samples().expect("samples");
    assert!(unusable.stale > 100 && unusable.count() == unusable.stale);
    assert_eq!(usable.len() + unusable.count(), telemetry.rows());
    let half = 0.5 * telemetry.interval().expect("samples")[1];
    assert!(usable.iter().all(|sample| sample.time <= half + 0.02));
    let stamps = telemetry.stamps().expect("stamps");
    let first = stamps[0].expect("a stamp");
    assert_eq!(first.nanoseconds, 1_764_150_000_000_000_000);
    assert_eq!(first.clock, wisch::run::StampClock::Epoch);
    assert!(stamps.iter().all(Option::is_some));
    let shown = run(&["memory", "show", &id, "--memory", "episodes"]);
    let count = telemetry.rows();
    let expected = format!("stamps of round 1: {count} samples from 1764150000.000 s to");
    assert!(shown.contains(&expected), "{shown}");
    assert!(shown.contains("is not used as touch"), "{shown}");
}

#[test]
fn the_bag_of_a_run_with_unusable_wrenches_has_the_same_interpretation() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    write_hanging_robot(folder.path());
    let output = wisch(
        folder.path(),
        &["--executor", "python3 robot.py", "--touch-only", "--json"],
    );
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{err}");
    let summary: Value = serde_json::from_slice(&output.stdout).expect("one object");
    let round = &summary["rounds"][0];
    let task = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/arm-board.toml");
    let output = Command::new(assert_cmd::cargo::cargo_bin!("wisch"))
        .current_dir(folder.path())
        .args(["interpret", "out/telemetry/round-1.mcap", "--out", "again"])
        .args(["--json", "--task"])
        .arg(task)
        .output()
        .expect("it runs");
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() < Some(2), "{err}");
    let again: Value = serde_json::from_slice(&output.stdout).expect("one object");
    for key in [
        "estimated",
        "estimated_low",
        "estimated_high",
        "contact_share",
    ] {
        let (run, bag) = (round[key].as_f64(), again[key].as_f64());
        assert!(
            (run.expect(key) - bag.expect(key)).abs() < 1e-3,
            "{key}: {run:?} in the run, {bag:?} in its bag"
        );
    }
    let doubts = again["doubts"].to_string();
    assert!(doubts.contains("is not used as touch"), "{doubts}");
    assert!(doubts.contains(" stale)"), "{doubts}");
}
