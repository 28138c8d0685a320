//! `wisch memory health` warns of what changes over the episodes of a memory.

use crate::program::wisch;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::path::Path;
use tempfile::TempDir;
use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin, Value};

/// A memory of one run a day, with the offset of the surface in each \[m\].
fn memory_of(offsets: impl IntoIterator<Item = f64>) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = Memory::create(&folder.path().join("episodes")).expect("a memory");
    for (day, offset) in offsets.into_iter().enumerate() {
        let begin = 1.79e9 + 86_400.0 * day as f64;
        let individual = |class: &str, parent| Individual {
            class: format!("semco:{class}"),
            interval: Some([begin, begin + 30.0]),
            parent,
            relations: BTreeMap::new(),
            values: BTreeMap::new(),
        };
        let mut round = individual("WipingRound", Some(1));
        for (property, number) in [
            ("round", 1.0),
            ("pressForce", 10.0),
            ("meanNormalForce", -10.0),
            ("planeOffset", offset),
        ] {
            let property = format!("semco:{property}");
            round.values.insert(property, Value::Number(number));
        }
        for (relation, thing) in [
            ("soma:isPerformedBy", "semco:arm"),
            ("semco:usesTool", "semco:sponge"),
            ("semco:actsOnSurface", "semco:table"),
            ("semco:removesMedium", "semco:crumbs"),
        ] {
            round
                .relations
                .insert(relation.to_owned(), vec![thing.to_owned()]);
        }
        let id = format!("day{day:02}");
        let writer = memory.begin(&id).expect("an episode");
        let record = EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id,
            task: "board".to_owned(),
            interval: [begin, begin + 30.0],
            origin: Origin::Executor("by hand".to_owned()),
            program: "by hand".to_owned(),
            seed: 1,
            rounds: vec![begin],
            individuals: vec![
                individual("WipingEpisode", None),
                individual("WipingAction", Some(0)),
                round,
            ],
        };
        writer.commit(&record).expect("an episode");
    }
    folder
}

/// Exit code and standard output of `wisch memory health`, which says nothing on standard error.
fn health(folder: &Path, args: &[&str]) -> (i32, String) {
    let (code, out, err) = wisch(folder, &[&["memory", "health"], args].concat());
    assert_eq!(err, "", "{args:?}: {out}");
    (code, out)
}

#[test]
fn a_surface_that_creeps_needs_attention() {
    // A scatter of up to 0.2 mm.
    let folder = memory_of((0..14).map(|day: i32| {
        let scatter = f64::from(day * 7 % 5 - 2) * 1e-4;
        -4e-4 * f64::from(day) + scatter
    }));
    let (code, out) = health(folder.path(), &[]);
    assert_eq!(code, 1, "{out}");
    for part in [
        "arm · sponge · table · crumbs · 10.0 N · executed",
        "14 runs, ",
        "relocalise the surface",
        "tool stiffness      0  not recorded",
        "1 group: 1 needs attention",
        "Tracking errors are not assessed",
    ] {
        assert!(out.contains(part), "{part:?} is not in:\n{out}");
    }
    assert!(out.lines().all(|line| line.chars().count() <= 100), "{out}");
    assert!(!out.contains('\u{1b}') && !out.contains("healthy"), "{out}");
    let (code, out) = health(folder.path(), &["--json", "--tool", "sponge"]);
    let report: Json = serde_json::from_str(&out).expect("one object");
    assert_eq!((code, &report["needs_attention"]), (1, &true.into()));
    let channels = report["groups"][0]["channels"]
        .as_array()
        .expect("channels");
    let of = |name: &str| channels.iter().find(|channel| channel["channel"] == name);
    let offset = of("offset").expect("the offset");
    assert_eq!(offset["findings"][0]["kind"], "drift", "{offset}");
    assert_eq!(offset["findings"][0]["cause"], "unknown", "{offset}");
    assert_eq!(of("tilt").expect("the tilt")["state"], "not_recorded");
}

#[test]
fn a_quiet_memory_needs_no_attention_and_a_short_one_cannot_tell() {
    let folder = memory_of((0..14).map(|day: i32| f64::from(day * 7 % 5 - 2) * 1e-4));
    let (code, out) = health(folder.path(), &[]);
    assert_eq!(code, 0, "{out}");
    assert!(
        out.contains("1 group: nothing is found that needs attention"),
        "{out}"
    );
    let folder = memory_of([0.0, 0.01, 0.02]);
    let (code, out) = health(folder.path(), &[]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("too few episodes (3 of 7)"), "{out}");
    let folder = memory_of([]);
    let (code, out) = health(folder.path(), &[]);
    assert_eq!(
        (code, out.as_str()),
        (0, "the memory has no rounds; wisch run adds an episode\n")
    );
}

#[test]
fn an_unknown_name_or_memory_is_an_error() {
    let folder = memory_of([0.0]);
    for (args, part) in [
        (["--tool", "spong"], "the episodes name: sponge"),
        (["--robot", "justin"], "the episodes name: arm"),
        (["--memory", "nowhere"], "choose another folder"),
    ] {
        let (code, out, err) = wisch(folder.path(), &[&["memory", "health"], &args[..]].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{err}");
        assert!(err.contains(part), "{err}");
    }
}
