//! Compaction, retention, and files of older and newer versions.

use crate::memories::{SAMPLES, contents, memory, place, session, some};
use datafusion::arrow::util::display::array_value_to_string;
use datafusion::arrow::util::pretty::pretty_format_batches;
use std::fs;
use std::path::Path;
use wisch_fleet::ask::SqlSession;
use wisch_fleet::moves::{Filter, PushOptions, compact, forget, pull, purge, push, retain, verify};
use wisch_fleet::store::{Snapshot, StorePlace, read_clock};
use wisch_memory::Memory;

fn quiet() -> impl FnMut(usize, usize) {
    |_, _| {}
}

async fn all_rows(session: &SqlSession) -> String {
    let mut text = String::new();
    for table in [
        "episodes",
        "rounds",
        "strokes",
        "motions",
        "events",
        "participants",
    ] {
        let mut sort = "robot, day, episode".to_owned();
        if table != "episodes" {
            sort += ", place";
        }
        if table == "participants" {
            sort += ", role, participant";
        }
        let rows = session
            .rows(&format!("SELECT * FROM {table} ORDER BY {sort}"))
            .await
            .unwrap();
        text += &pretty_format_batches(&rows).unwrap().to_string();
    }
    text
}

#[tokio::test]
async fn compaction_changes_no_answer_and_no_open_session() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(&folder.path().join("here"), &some(200));
    let fleet = place(&folder.path().join("fleet"));
    push(&memory, &fleet, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    let reader = session(&fleet).await;
    let before = all_rows(&reader).await;
    let done = compact(&fleet).await.unwrap();
    assert!(done.before > done.after && done.after > 0, "{done:?}");
    assert_eq!(all_rows(&session(&fleet).await).await, before);
    assert_eq!(
        all_rows(&reader).await,
        before,
        "a session opened before the compaction"
    );
    assert_eq!(
        purge(&fleet, read_clock() - 3600.0).await.unwrap(),
        0,
        "nothing is old enough"
    );
    assert_eq!(
        purge(&fleet, read_clock() + 1.0).await.unwrap(),
        done.before
    );
    assert_eq!(all_rows(&session(&fleet).await).await, before);
    assert!(Snapshot::read(&fleet).await.unwrap().removed.is_empty());
    assert_eq!(verify(&fleet, &mut quiet()).await.unwrap().faults, [""; 0]);
    let again = push(&memory, &fleet, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!((again.episodes, again.there), (0, 200));
}

async fn samples(fleet: &StorePlace) -> String {
    let rows = session(fleet)
        .await
        .rows("SELECT count(*) AS n FROM telemetry")
        .await
        .unwrap();
    array_value_to_string(rows[0].column(0), 0).unwrap()
}

#[tokio::test]
async fn retention_removes_only_old_telemetry() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(&folder.path().join("here"), &some(5));
    let fleet = place(&folder.path().join("fleet"));
    push(&memory, &fleet, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!(samples(&fleet).await, SAMPLES.to_string());
    let retained = retain(&fleet, read_clock()).await.unwrap();
    assert_eq!(retained.files, 1);
    assert_eq!(samples(&fleet).await, "0");
    assert_eq!(
        purge(&fleet, read_clock() + 1.0).await.unwrap(),
        2,
        "one episode has telemetry: its rows and its archive"
    );
    assert_eq!(verify(&fleet, &mut quiet()).await.unwrap().faults, [""; 0]);
    let there = Memory::create(&folder.path().join("there")).unwrap();
    let pulled = pull(&fleet, &there, &Filter::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!((pulled.episodes, pulled.thinned), (5, 1));
    // Synthetic episodes lack telemetry of most rounds, which is no fault of a copy.
    for id in there.episodes().unwrap() {
        assert!(there.episode(&id).unwrap().faults().is_empty(), "{id}");
    }
    let (here, there) = (contents(&memory), contents(&there));
    let lacking: Vec<&String> = here
        .keys()
        .filter(|name| !there.contains_key(*name))
        .collect();
    assert_eq!(lacking.len(), 1);
    assert!(lacking[0].ends_with("round-1.parquet"));
}

/// Replaces a text in every commit of the log.
fn rewrite(fleet: &Path, from: &str, to: &str) {
    for entry in fs::read_dir(fleet.join("log")).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{text}");
        fs::write(&path, text.replace(from, to)).unwrap();
    }
}

#[tokio::test]
async fn files_of_a_newer_version_are_refused() {
    for (from, to) in [
        ("\"version\":[1,1]", "\"version\":[2,0]"),
        ("\"schema\":[1,1]", "\"schema\":[2,0]"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let memory = memory(&folder.path().join("here"), &some(1));
        let fleet = place(&folder.path().join("fleet"));
        push(&memory, &fleet, &PushOptions::default(), &mut quiet())
            .await
            .unwrap();
        rewrite(&folder.path().join("fleet"), from, to);
        let source = wisch_fleet::ask::SqlSource::open(fleet).await;
        let error = match source {
            Ok(source) => SqlSession::new(&[source]).await.err().unwrap(),
            Err(error) => error,
        };
        assert!(
            error.to_string().contains("version 2.0 is not supported"),
            "{error}"
        );
    }
}

#[tokio::test]
async fn every_earlier_version_is_read() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    // A version before `plane_tilt_rad` would have written the files in "lacking".
    for (name, tilts) in [
        ("version-1.0", "| 3      |"),
        ("version-1.0-lacking", "| 0      |"),
    ] {
        let fleet = StorePlace::open(fixtures.join(name).to_str().unwrap()).unwrap();
        let session = session(&fleet).await;
        let rows = session
            .rows("SELECT count(plane_tilt_rad) AS tilted FROM rounds")
            .await
            .unwrap();
        let found = pretty_format_batches(&rows).unwrap().to_string();
        assert!(found.contains(tilts), "{name}: {found}");
        let rows = session
            .rows("SELECT count(performance) AS n FROM rounds")
            .await
            .unwrap();
        assert!(
            pretty_format_batches(&rows)
                .unwrap()
                .to_string()
                .contains("| 3 |"),
            "{name}"
        );
        assert_eq!(
            verify(&fleet, &mut quiet()).await.unwrap().faults,
            [""; 0],
            "{name}"
        );
    }
}

#[tokio::test]
async fn a_forgotten_episode_leaves_no_rows_and_no_archive() {
    let folder = tempfile::tempdir().unwrap();
    let all = some(12);
    let here = memory(&folder.path().join("here"), &all);
    let (gone, others) = all.split_at(2);
    let others = memory(&folder.path().join("others"), others);
    let expected = place(&folder.path().join("expected"));
    push(&others, &expected, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    let expected = all_rows(&session(&expected).await).await;
    for is_compacted in [false, true] {
        let name = format!("fleet-{is_compacted}");
        let fleet = place(&folder.path().join(&name));
        let push_all = async || {
            push(&here, &fleet, &PushOptions::default(), &mut quiet())
                .await
                .unwrap()
                .episodes
        };
        assert_eq!(push_all().await, 12);
        if is_compacted {
            compact(&fleet).await.unwrap();
        }
        let before = all_rows(&session(&fleet).await).await;
        let unknown = [gone[0].id.clone(), "20200101-000000-0000".to_owned()];
        let error = forget(&fleet, &unknown).await.unwrap_err().to_string();
        let what = "has no episode \"20200101-000000-0000\", so nothing was removed";
        assert!(error.contains(what), "{error}");
        assert_eq!(all_rows(&session(&fleet).await).await, before);
        let ids = [&gone[0].id, &gone[1].id].map(String::clone);
        assert_eq!(forget(&fleet, &ids).await.unwrap().episodes, 2);
        assert_eq!(all_rows(&session(&fleet).await).await, expected);
        // The first one has telemetry.
        assert_eq!(samples(&fleet).await, "0");
        for id in &ids {
            let archive = folder.path().join(format!("{name}/episodes/{id}.tar.zst"));
            assert!(!archive.exists(), "{}", archive.display());
        }
        assert_eq!(verify(&fleet, &mut quiet()).await.unwrap().faults, [""; 0]);
        // A memory that still has them may push them again.
        assert_eq!(push_all().await, 2);
        purge(&fleet, read_clock() + 1.0).await.unwrap();
        let verified = verify(&fleet, &mut quiet()).await.unwrap();
        assert_eq!((verified.episodes, verified.faults.len()), (12, 0));
        assert_eq!(all_rows(&session(&fleet).await).await, before);
    }
}
