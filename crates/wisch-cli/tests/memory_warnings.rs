//! `wisch run` warns while wiping of what differs from the episodes of its memory.

use crate::executor::has_python;
use crate::program::{command, ended, root};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch_memory::Memory;

/// A folder with a robot that executes exactly, and one whose tool is 5 mm too high in the second half of each motion.
fn robots() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let robot = fs::read_to_string(root().join("docs/echo_robot.py")).expect("the robot");
    let high = robot.replace(
        "        time = point[\"time_s\"]\n",
        "        time = point[\"time_s\"]\n        if time > motion[\"duration_s\"] / 2:\n            point[\"world_from_tool\"][2] += 0.005\n",
    );
    assert_ne!(robot, high);
    fs::write(folder.path().join("exact.py"), robot).expect("a file");
    // The same program name, because episodes of another executor are not comparable.
    fs::create_dir(folder.path().join("high")).expect("a folder");
    fs::write(folder.path().join("high/exact.py"), high).expect("a file");
    folder
}

/// Runs one round with the settings; returns the exit code, standard output and standard error.
fn run(folder: &Path, robot: &str, settings: &[&str]) -> (i32, String, String) {
    let mut command = command(folder);
    command
        .arg("run")
        .arg(root().join("scenarios/arm-board.toml"));
    let executor = format!("python3 {robot}");
    command.args(["--rounds", "2", "--executor", &executor, "--json"]);
    command.args(["--events", "events.jsonl", "--memory", "m", "--out", "out"]);
    command.args(["--set", "target_performance=0.2"]);
    for setting in ["execution.false_warning_rate=0.2"].iter().chain(settings) {
        command.args(["--set", setting]);
    }
    ended(&mut command)
}

/// The warnings among the events of the last run.
fn warned(folder: &Path) -> Vec<Value> {
    let text = fs::read_to_string(folder.join("events.jsonl")).expect("events");
    let events = text
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).expect(line));
    events.filter(|event| event["event"] == "warned").collect()
}

#[test]
fn a_run_that_differs_from_its_memory_is_warned_of_and_stopped_if_the_task_says_so() {
    if !has_python() {
        return;
    }
    let folder = robots();
    let folder = folder.path();
    for earlier in 0..4 {
        let (_, _, err) = run(folder, "exact.py", &[]);
        let episodes = format!("{earlier} comparable episode");
        // An empty memory is stated only where the task asks for a reaction.
        let is_stated = err.contains("note: no warnings while wiping: ");
        assert_eq!(is_stated, earlier > 0, "{err}");
        assert!(
            earlier == 0 || err.contains(&episodes) && err.contains("4 are needed"),
            "{err}"
        );
    }
    let (_, out, err) = run(folder, "exact.py", &[]);
    assert!(!err.contains("warning"), "{err}");
    assert!(warned(folder).is_empty() && !out.contains("\"warnings\""));

    let (_, out, err) = run(folder, "high/exact.py", &[]);
    assert!(err.contains("note: warning: round 1, stroke "), "{err}");
    assert!(err.contains(" mm, outside "), "{err}");
    let events = warned(folder);
    assert_eq!(events[0]["channel"], "height", "{events:?}");
    assert_eq!(events[0]["alike"].as_array().map(Vec::len), Some(3));
    assert!(events[0]["p_value"].as_f64().is_some_and(|p| p <= 0.2));
    let summary: Value = serde_json::from_str(&out).expect("one object");
    let round = &summary["rounds"][0];
    assert_eq!(round["warnings"][0]["channel"], "height", "{round}");
    assert_eq!(round["ending"], "complete");
    let memory = Memory::open(&folder.join("m")).expect("a memory");
    let newest = memory.episodes().expect("episodes").pop().expect("one");
    let record = memory.episode(&newest).and_then(|episode| episode.record());
    let record = record.expect("a record");
    let warning = (record.individuals.iter())
        .find(|individual| individual.class == "semco:MemoryWarning")
        .expect("the episode keeps it");
    let during = warning.parent.map(|parent| &record.individuals[parent]);
    assert_eq!(during.map(|part| part.class.as_str()), Some("semco:Stroke"));

    let (_, out, _) = run(
        folder,
        "high/exact.py",
        &["execution.on_warning=end_stroke"],
    );
    let summary: Value = serde_json::from_str(&out).expect("one object");
    let ending = summary["rounds"][0]["ending"].as_str().expect("an ending");
    assert!(
        ending.contains("a warning ended it: the height"),
        "{ending}"
    );

    let (code, out, err) = run(folder, "high/exact.py", &["execution.on_warning=stop"]);
    let summary: Value = serde_json::from_str(&out).expect("one object");
    assert_eq!(summary["rounds"].as_array().map(Vec::len), Some(1));
    assert_eq!(summary["rounds"][0]["ending"], "stopped");
    assert!(err.contains("a warning stopped the run"), "{code}: {err}");

    let (_, _, err) = run(folder, "high/exact.py", &["execution.on_warning=ignore"]);
    assert!(
        !err.contains("warning") && warned(folder).is_empty(),
        "{err}"
    );
    let (code, _, err) = run(folder, "exact.py", &["execution.on_warning=panic"]);
    assert!(code == 2 && err.contains("on_warning"), "{err}");
}
