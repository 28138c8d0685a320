//! `wisch eval`.

use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn wisch(folder: &Path, args: &[&str]) -> Output {
    eval(folder, "calibration", args)
}

fn eval(folder: &Path, what: &str, args: &[&str]) -> Output {
    command(folder, what, args).output().expect("it runs")
}

fn command(folder: &Path, what: &str, args: &[&str]) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("wisch"));
    command.current_dir(folder).args(["eval", what]).args(args);
    command
}

/// A world on the chopping board, undisturbed, with a tool of another size.
const ONE: [&str; 4] = ["--first-seed", "17", "--worlds", "1"];

#[test]
fn a_world_is_evaluated_once_and_its_figures_stand() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = wisch(
        folder.path(),
        &[&ONE[..], &["--json", "--out", "out"]].concat(),
    );
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*err), (Some(0), ""));
    let record: Value = serde_json::from_slice(&output.stdout).expect("one object");
    assert_eq!(record["worlds"], 1);
    assert_eq!(record["seed_use"], "demonstration");
    let names: Vec<&Value> = (record["methods"].as_array().expect("methods").iter())
        .map(|method| &method["name"])
        .collect();
    assert_eq!(
        names,
        [
            "wisch",
            "prediction",
            "force-blind replay",
            "the paper's rule"
        ]
    );
    let text = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).expect(name);
    let lines = text("worlds-1-of-1.jsonl");
    let world: Value = serde_json::from_str(lines.trim()).expect("a line");
    assert_eq!(world["case"]["mismatch"], "footprint");
    let round = &world["rounds"][0];
    let outcome = round["outcome"].as_f64().expect("what was so");
    assert!(
        outcome > 0.5 && round["belief"]["crps"].as_f64() < Some(0.5),
        "{round}"
    );
    assert!(text("calibration.md").contains("| footprint ± 10 % | 1 |"));
    assert!(text("reliability.svg").starts_with("<svg"));

    // Once more, it is refused; to go on adds nothing.
    let again = wisch(folder.path(), &[&ONE[..], &["--out", "out"]].concat());
    let err = String::from_utf8_lossy(&again.stderr);
    assert_eq!(again.status.code(), Some(2), "{err}");
    assert!(err.contains("already holds 1 world"), "{err}");
    let before = text("calibration.json");
    // What a killed evaluation left of a line is passed over.
    fs::write(
        folder.path().join("out/worlds-1-of-1.jsonl"),
        lines + "{\"case\"",
    )
    .expect("written");
    let resumed = wisch(
        folder.path(),
        &[&ONE[..], &["--out", "out", "--resume"]].concat(),
    );
    assert_eq!(resumed.status.code(), Some(0));
    assert_eq!(text("calibration.json"), before);
    let other = [
        "--first-seed",
        "20",
        "--worlds",
        "2",
        "--out",
        "out",
        "--resume",
    ];
    let other = wisch(folder.path(), &other);
    let err = String::from_utf8_lossy(&other.stderr);
    assert_eq!(other.status.code(), Some(2), "{err}");
    assert!(
        err.contains("holds another evaluation, for example of seed 17"),
        "{err}"
    );
    let set = ["--set", "execution.grains_resist=false"];
    let other = wisch(
        folder.path(),
        &[&ONE[..], &["--out", "out", "--resume"], &set[..]].concat(),
    );
    let err = String::from_utf8_lossy(&other.stderr);
    assert_eq!(other.status.code(), Some(2), "{err}");
    assert!(err.contains("holds another evaluation"), "{err}");
}

#[test]
fn seeds_of_several_uses_are_remarked_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let seeds = ["--first-seed", "999", "--worlds", "2"];
    let mut mixed = command(folder.path(), "calibration", &seeds);
    let mut run = mixed.stderr(Stdio::piped()).spawn().expect("it begins");
    let mut lines = BufReader::new(run.stderr.take().expect("a pipe")).lines();
    let remark = lines.next().expect("a line").expect("text");
    run.kill().expect("it runs");
    run.wait().expect("it ends");
    assert!(
        remark.contains("these seeds mix several ranges"),
        "{remark}"
    );
    let refused = wisch(folder.path(), &["--worlds", "2", "--shard", "3/2"]);
    let err = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2), "{err}");
    assert!(err.contains("expected I/N with 1 <= I <= N"), "{err}");
}

#[test]
fn a_scenario_is_wiped_over_seeds_and_summed_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = [
        "arm-board",
        "--rounds",
        "1",
        "--worlds",
        "2",
        "--out",
        "out",
    ];
    let output = eval(
        folder.path(),
        "scenarios",
        &[&args[..], &["--json"]].concat(),
    );
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*err), (Some(0), ""));
    let record: Value = serde_json::from_slice(&output.stdout).expect("one object");
    let runs = record["runs"].as_array().expect("runs");
    let after = |run: &Value| run["rounds"][0]["outcome"].as_f64().expect("what was so");
    let (first, second) = (after(&runs[0]), after(&runs[1]));
    let scores = &record["scenarios"][0];
    assert_eq!((&scores["runs"], &scores["rounds"]), (&2.into(), &2.into()));
    let median = scores["first"][2].as_f64().expect("a median");
    assert!((median - (first + second) / 2.0).abs() < 1e-12, "{scores}");
    assert!(first > runs[0]["before"].as_f64().expect("what was so before"));
    let table = fs::read_to_string(folder.path().join("out/scenarios.md")).expect("a table");
    assert!(table.contains("| arm-board | 2 | 2 |"), "{table}");

    let again = eval(folder.path(), "scenarios", &args);
    let err = String::from_utf8_lossy(&again.stderr);
    assert_eq!(again.status.code(), Some(2), "{err}");
    assert!(err.contains("the file exists already"), "{err}");
    let none = eval(
        folder.path(),
        "scenarios",
        &["arm-board", "no-such-task", "--out", "none"],
    );
    let err = String::from_utf8_lossy(&none.stderr);
    assert_eq!(none.status.code(), Some(2), "{err}");
    assert!(err.contains("no-such-task"), "{err}");
    assert!(!folder.path().join("none").exists());
}
