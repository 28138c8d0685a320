//! `wisch memory export`: what is in the memory comes out as a NEEM, and back.

use crate::program::wisch;
use std::collections::BTreeMap;
use std::fs;
use tempfile::TempDir;
use wisch::follow::Phase;
use wisch_memory::neem::import;
use wisch_memory::{
    EPISODE_SCHEMA, EpisodeRecord, Individual, Mark, Memory, Origin, TelemetryHead,
};

fn record(id: &str) -> EpisodeRecord {
    let interval = [1_767_225_600.0, 1_767_225_601.0];
    let individual = |class: &str, parent, relations: &[(&str, &str)]| Individual {
        class: class.to_owned(),
        interval: Some(interval),
        parent,
        relations: relations
            .iter()
            .map(|(property, object)| ((*property).to_owned(), vec![(*object).to_owned()]))
            .collect(),
        values: BTreeMap::new(),
    };
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: id.to_owned(),
        task: "board".to_owned(),
        interval,
        origin: Origin::Imported("lab.mcap".to_owned()),
        program: "wisch".to_owned(),
        seed: 7,
        rounds: vec![interval[0]],
        individuals: vec![
            individual("semco:WipingEpisode", None, &[]),
            individual(
                "semco:WipingAction",
                Some(0),
                &[
                    ("semco:usesTool", "semco:sponge"),
                    ("semco:actsOnSurface", "semco:chopping_board"),
                ],
            ),
        ],
    }
}

/// A folder with a memory of two episodes, each with one second of the tool's pose and force at 100 Hz.
fn memory() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let memory = Memory::create(&folder.path().join("episodes")).expect("a memory");
    let pose = ["x", "y", "z", "qx", "qy", "qz", "qw"].map(|part| format!("measured/{part}"));
    let force = ["fx", "fy", "fz"].map(|part| format!("external/{part}"));
    let columns = [pose.as_slice(), &force].concat();
    let mark = Mark {
        motion: 0,
        phase: Phase::Wipe(0),
    };
    for id in ["first", "second"] {
        let writer = memory.begin(id).expect("an episode");
        let head = TelemetryHead::default();
        let mut log = writer
            .telemetry_with_columns(1, head, &columns)
            .expect("telemetry");
        for step in 0..100 {
            let row = [0.1, 0.2, 0.8, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -9.0];
            log.push(0.01 * f64::from(step), mark, row).expect("a row");
        }
        log.finish().expect("telemetry");
        writer.commit(&record(id)).expect("an episode");
    }
    folder
}

#[test]
fn all_episodes_come_out_and_back() {
    let folder = memory();
    let (code, out, err) = wisch(
        folder.path(),
        &["memory", "export", "--neem", "neem", "--json"],
    );
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let report: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(
        (&report["episodes"], &report["poses"]),
        (&2.into(), &20.into())
    );
    assert_eq!(report["wrenches"], 200);
    let neem = folder.path().join("neem");
    assert_eq!(
        import(&neem).expect("a NEEM"),
        ["first", "second"].map(record)
    );
    let collections = [
        "triples",
        "annotations",
        "inferred",
        "tf",
        "wrench",
        "observation",
    ];
    for collection in collections {
        let dump = neem.join(collection).join("roslog");
        for file in [".bson", ".metadata.json"] {
            assert!(dump.join(format!("{collection}{file}")).is_file());
        }
    }
    let meta = fs::read_to_string(neem.join("meta.json")).expect("meta.json");
    let meta: serde_json::Value = serde_json::from_str(&meta).expect("JSON");
    assert_eq!(meta["description"], "2 episodes of robotic wiping: board");
    assert_eq!(meta["environment"], "chopping board");
}

#[test]
fn named_episodes_come_out_at_the_rate_that_is_asked_for() {
    let folder = memory();
    let asked = [
        "memory",
        "export",
        "--neem",
        "neem",
        "second",
        "--tf-rate-hz",
        "50",
    ];
    let (code, out, err) = wisch(folder.path(), &asked);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.starts_with("neem: 1 episode, "), "{out}");
    assert!(
        out.contains("50 poses, 100 wrenches, 0 observations\n"),
        "{out}"
    );
    let neem = folder.path().join("neem");
    assert_eq!(import(&neem).expect("a NEEM"), [record("second")]);
}

#[test]
fn a_damaged_episode_is_left_out_unless_it_is_named() {
    let folder = memory();
    fs::write(folder.path().join("episodes/first/episode.json"), "").expect("written");
    let (code, out, err) = wisch(
        folder.path(),
        &["memory", "export", "--neem", "neem", "--json"],
    );
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    let report: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(report["episodes"], 1);
    assert_eq!(report["left_out"].as_array().map(Vec::len), Some(1));
    let named = ["memory", "export", "--neem", "other", "first"];
    assert_eq!(wisch(folder.path(), &named).0, 2);
}

#[test]
fn wrong_input_leaves_no_folder() {
    let folder = memory();
    for (asked, said) in [
        (["--neem", "neem", "secnd"].as_slice(), "second"),
        (
            &["--neem", "neem", "--tf-rate-hz", "-1"],
            "-1 is not above 0",
        ),
        (&["--neem", "neem", "first", "first"], "twice"),
        (&["--neem", "episodes"], "there is something already"),
        (&["--neem", "neem", "--memory", "nowhere"], "nowhere"),
    ] {
        let args = [&["memory", "export"], asked].concat();
        let (code, out, err) = wisch(folder.path(), &args);
        assert_eq!((code, out.as_str()), (2, ""), "{asked:?}");
        assert!(err.contains(said), "{asked:?}: {err}");
        let left = fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(left, 1, "{asked:?} leaves only the memory");
    }
}

#[test]
fn an_episode_that_is_left_out_is_named_with_the_reason() {
    let folder = memory();
    let changed = folder.path().join("episodes/first/task.toml");
    let memory = Memory::create(&folder.path().join("episodes")).expect("a memory");
    memory.forget("first").expect("an episode");
    let writer = memory.begin("first").expect("an episode");
    writer.attach("task.toml", "seed = 1").expect("a file");
    writer.commit(&record("first")).expect("an episode");
    fs::write(&changed, "seed = 2").expect("a file");
    let export = |more: &[&str]| {
        let args = [&["memory", "export", "--neem", "neem"], more].concat();
        let ended = wisch(folder.path(), &args);
        fs::remove_dir_all(folder.path().join("neem")).expect("a NEEM");
        ended
    };
    let (code, out, err) = export(&[]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    assert!(
        out.contains("left out: episodes/first/task.toml: "),
        "{out}"
    );
    let (code, out, _) = export(&["--json"]);
    let report: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!((code, &report["episodes"]), (1, &1.into()));
    assert_eq!(report["left_out"].as_array().map(Vec::len), Some(1));
}

#[test]
fn notes_of_people_are_left_out_and_counted() {
    let folder = memory();
    let note = "[\"semco:WipingEpisode_first-0\",\"rdfs:comment\",\"a visitor watched\"]\n";
    fs::write(folder.path().join("episodes/told.jsonl"), note).unwrap();
    let (code, out, err) = wisch(folder.path(), &["memory", "export", "--neem", "neem"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let said = "left out: 1 statement that people have added by tell";
    assert!(out.contains(said), "{out}");
}
