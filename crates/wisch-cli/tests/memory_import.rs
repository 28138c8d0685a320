//! `wisch memory import`, and the pages of logs, in a real temporary directory.

use crate::interpret::{believed, folder};
use crate::program::wisch;
use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use wisch::geometry::Pose;
use wisch_memory::{EpisodeRecord, Individual, Memory, Value};
use wisch_telemetry::{LogOptions, read};

fn import(folder: &Path, more: &[&str]) -> (i32, String, String) {
    let args = [
        "memory",
        "import",
        "log.mcap",
        "--task",
        "task.toml",
        "--start-s",
        "1795309772",
    ];
    wisch(folder, &[&args[..], more].concat())
}

fn individual<'a>(record: &'a EpisodeRecord, class: &str) -> &'a Individual {
    let mut those = record.individuals.iter().filter(|one| one.class == class);
    those.next().expect(class)
}

#[test]
fn a_log_that_is_imported_twice_is_one_episode() {
    let folder = folder(believed());
    let folder = folder.path();
    let (code, first, _) = import(folder, &["--json"]);
    assert_eq!(code, 0, "{first}");
    // Another name of the same file.
    fs::rename(folder.join("log.mcap"), folder.join("other.mcap")).unwrap();
    fs::copy(folder.join("other.mcap"), folder.join("log.mcap")).unwrap();
    let (code, again, err) = import(folder, &["--json"]);
    assert_eq!((code, err.as_str()), (0, ""), "{again}");
    assert_eq!(first, again, "it is the same episode");
    let (code, out, _) = import(folder, &[]);
    assert!(code == 0 && out.contains("nothing was added"), "{out}");
    let memory = Memory::open(&folder.join("episodes")).unwrap();
    assert_eq!(memory.episodes().unwrap().len(), 1);
    // Read otherwise, it would be another episode of the same wiping.
    let (code, _, err) = import(folder, &["--wrench-sign", "by-tool"]);
    let id = &memory.episodes().unwrap()[0];
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains(id.as_str()) && err.contains("memory forget"),
        "{err}"
    );
    // Another log is another episode.
    let mut other = fs::read_to_string(folder.join("task.toml")).unwrap();
    other.push_str("\n# Another task file.\n");
    let table = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n0,0.6,0.1,0.9,0,0,0,1,0,0,0\n1,0.6,0.1,0.9,0,0,0,1,0,0,0\n2,0.6,0.1,0.9,0,0,0,1,0,0,0\n";
    fs::write(folder.join("air.csv"), table).unwrap();
    let args = [
        "memory",
        "import",
        "air.csv",
        "--task",
        "task.toml",
        "--start-s",
        "1795309772",
        "--max-gap-s",
        "2",
    ];
    let (code, out, err) = wisch(folder, &args);
    assert_eq!(code, 0, "{out}{err}");
    assert_eq!(memory.episodes().unwrap().len(), 2);
}

/// Writes the first samples of the log as a table, of which a share is taken, with positions in a unit \[m\] and this number of
/// decimals.
fn write_table(folder: &Path, name: &str, share: f64, (unit, decimals): (&str, usize)) {
    let log = read(&folder.join("log.mcap"), &LogOptions::default()).unwrap();
    let factor = if unit == "mm" { 1e3 } else { 1.0 };
    let mut text =
        format!("t [s],x [{unit}],y [{unit}],z [{unit}],qx,qy,qz,qw,fx [N],fy [N],fz [N]\n");
    let count = (share * log.samples.len() as f64) as usize;
    for sample in &log.samples[..count] {
        let place = factor * sample.world_from_tool.translation.vector;
        let turn = sample.world_from_tool.rotation.coords;
        let numbers = place.iter().chain(&turn).chain(&sample.force);
        let numbers: Vec<String> = numbers
            .map(|number| format!("{number:.decimals$}"))
            .collect();
        text += &format!("{:.6},{}\n", sample.time, numbers.join(","));
    }
    fs::write(folder.join(name), text).unwrap();
}

#[test]
fn the_beginning_of_a_table_and_the_whole_are_one_log_in_any_unit() {
    let folder = folder(believed());
    let folder = folder.path();
    write_table(folder, "whole.csv", 1.0, ("m", 6));
    write_table(folder, "begun.csv", 0.6, ("m", 6));
    write_table(folder, "other.csv", 1.0, ("mm", 3));
    let import = |log: &str, memory: &str| {
        let args = [
            "memory",
            "import",
            log,
            "--task",
            "task.toml",
            "--memory",
            memory,
        ];
        let more = ["--wrench-frame", "world"];
        wisch(folder, &[&args[..], &more].concat())
    };
    let count = |memory: &str| {
        let memory = Memory::open(&folder.join(memory)).unwrap();
        memory.episodes().unwrap().len()
    };
    // The logger was still writing when the table was copied.
    let (code, out, err) = import("begun.csv", "first");
    assert_eq!(code, 0, "{out}{err}");
    let (code, _, err) = import("whole.csv", "first");
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains("the memory has the first ") && err.contains("wisch memory forget"),
        "{err}"
    );
    assert_eq!(count("first"), 1);
    for log in ["whole.csv", "begun.csv", "other.csv"] {
        let (code, out, err) = import(log, "second");
        assert_eq!(code, 0, "{log}: {out}{err}");
        assert_eq!(
            out.contains("nothing was added"),
            log != "whole.csv",
            "{out}"
        );
        assert_eq!(count("second"), 1, "{log}");
    }
}

#[test]
fn a_log_that_several_programs_import_at_once_is_one_episode() {
    let folder = folder(believed());
    let folder = folder.path();
    let outcomes: Vec<(i32, String, String)> = std::thread::scope(|scope| {
        let imports: Vec<_> = (0..4)
            .map(|_| scope.spawn(|| import(folder, &[])))
            .collect();
        imports.into_iter().map(|one| one.join().unwrap()).collect()
    });
    let memory = Memory::open(&folder.join("episodes")).unwrap();
    assert_eq!(memory.episodes().unwrap().len(), 1, "{outcomes:?}");
    assert!(outcomes.iter().all(|(code, ..)| *code == 0), "{outcomes:?}");
}

#[test]
fn the_doubts_of_a_log_are_kept_and_an_unknown_performance_is_no_failure() {
    // The tool wiped a hand's breadth above where the task has the surface.
    let folder = folder(Pose::translation(0.6, 0.1, 0.85));
    let folder = folder.path();
    let (_, out, _) = wisch(
        folder,
        &["interpret", "log.mcap", "--task", "task.toml", "--json"],
    );
    let told: Json = serde_json::from_str(&out).expect("one object");
    let doubts = told["doubts"].as_array().expect("doubts");
    assert!(!doubts.is_empty(), "{told}");
    let (code, out, _) = import(folder, &["--json"]);
    assert_eq!(code, 0, "{out}");
    let record: EpisodeRecord = serde_json::from_str(&out).expect("a record");
    let round = individual(&record, "semco:WipingRound");
    let kept = match round.values.get("semco:doubt") {
        Some(Value::Text(text)) => text.as_str(),
        other => panic!("{other:?}"),
    };
    for doubt in doubts {
        assert!(kept.contains(doubt.as_str().unwrap()), "{kept}: {doubt}");
    }
    assert!(
        !round.values.contains_key("semco:contactShare"),
        "{round:?}"
    );
    let action = individual(&record, "semco:WipingAction");
    for one in [round, action] {
        assert!(
            !one.relations.contains_key("soma:hasExecutionState"),
            "{one:?}"
        );
        assert!(!one.values.contains_key("semco:performance"), "{one:?}");
    }
    let memory = Memory::open(&folder.join("episodes")).unwrap();
    let episode = memory.episode(&record.id).unwrap();
    let interpretation = episode.attachment("round-1/interpretation.json").unwrap();
    let interpretation: Json = serde_json::from_slice(&interpretation).expect("JSON");
    assert_eq!(interpretation["doubts"], told["doubts"]);
    assert_eq!(interpretation["log"]["remarks"], told["log"]["remarks"]);
    let (_, listed, _) = wisch(folder, &["memory", "list"]);
    assert!(
        listed.contains("unknown") && !listed.contains(" 0.0 %"),
        "{listed}"
    );
    let (_, _, err) = wisch(folder, &["memory", "forget", &record.id]);
    assert_eq!(err, "");
    let (_, _, err) = import(folder, &[]);
    assert!(err.contains("note: "), "what is doubted is said: {err}");
}

#[test]
fn a_log_whose_times_begin_at_0_has_no_date() {
    let folder = folder(believed());
    let folder = folder.path();
    let args = ["memory", "import", "log.mcap", "--task", "task.toml"];
    let (code, _, err) = wisch(folder, &args);
    assert_eq!(code, 0, "{err}");
    let remark = "log.mcap: its times begin at 0 s, which is no date";
    assert!(err.contains(remark) && err.contains("--start-s"), "{err}");
    let (_, listed, _) = wisch(folder, &["memory", "list"]);
    assert!(listed.contains("date unknown"), "{listed}");
    assert!(!listed.contains("1970-01-01 "), "{listed}");
    let (_, listed, _) = wisch(folder, &["memory", "list", "--json"]);
    let listed: Json = serde_json::from_str(&listed).unwrap();
    assert!(listed["start_s"].is_null(), "{listed}");
}

#[test]
fn a_log_its_interpretation_and_its_episode_have_a_page() {
    let folder = folder(believed());
    let folder = folder.path();
    let (code, out, err) = wisch(
        folder,
        &[
            "interpret",
            "log.mcap",
            "--task",
            "task.toml",
            "--out",
            "told",
        ],
    );
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let (_, out, _) = import(folder, &["--json"]);
    let record: EpisodeRecord = serde_json::from_str(&out).expect("a record");
    for what in ["told", "log.mcap", &record.id] {
        let task: &[&str] = if what == "log.mcap" {
            &["--task", "task.toml"]
        } else {
            &[]
        };
        let args = [&["report", what, "--out", "page.html"], task].concat();
        let (code, out, err) = wisch(folder, &args);
        assert_eq!((code, err.as_str()), (0, ""), "{what}: {out}");
        let page = fs::read_to_string(folder.join("page.html")).unwrap();
        for part in [
            "<!DOCTYPE html>",
            "path over the surface",
            "Normal force",
            "fitted plane",
            "still to be wiped",
            "performance",
        ] {
            assert!(page.contains(part), "{what}: no {part:?}");
        }
        assert!(!page.contains("NaN"), "{what}");
        fs::remove_file(folder.join("page.html")).unwrap();
    }
    let (code, _, err) = wisch(folder, &["report", "log.mcap"]);
    assert!(code == 2 && err.contains("--task"), "{err}");
    let (code, _, err) = wisch(folder, &["report", "nothing"]);
    assert!(code == 2 && err.contains("there is no episode"), "{err}");
}
