//! `wisch ask --view`: a page, or none at all.

use assert_cmd::Command;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin};

const ID: &str = "20261122-010000-abcd";

/// A memory of one episode with a push, without telemetry.
fn memory() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    let individual = |class: &str, parent, interval| Individual {
        class: format!("semco:{class}"),
        interval: Some(interval),
        parent,
        relations: [].into(),
        values: [].into(),
    };
    let all = [1000.0, 1010.0];
    let record = EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: ID.to_owned(),
        task: "board".to_owned(),
        interval: all,
        origin: Origin::Simulated,
        program: "test".to_owned(),
        seed: 1,
        rounds: vec![1000.0],
        individuals: vec![
            individual("WipingEpisode", None, all),
            individual("WipingAction", Some(0), all),
            individual("WipingRound", Some(1), all),
            individual("HumanCollision", Some(2), [1003.0, 1004.5]),
        ],
    };
    memory.begin(ID).unwrap().commit(&record).unwrap();
    folder
}

/// Exit code, standard output and standard error.
fn ask(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("wisch").unwrap();
    let output = command.current_dir(folder).arg("ask").args(args).output();
    let output = output.unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code().unwrap(),
        text(output.stdout),
        text(output.stderr),
    )
}

const COLLISIONS: &str = "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), D is E - S, \
    data_vis(barchart(lasted), [data: [[C], [D]], title: 'How long', ylabel: 'time [s]'])";

#[test]
fn what_a_query_shows_is_drawn_into_one_page() {
    let folder = memory();
    let (code, out, err) = ask(folder.path(), &[COLLISIONS, "--view", "seen.html"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(
        out.contains("HumanCollision"),
        "answers are printed all the same: {out}"
    );
    let page = fs::read_to_string(folder.path().join("seen.html")).unwrap();
    assert!(page.contains("<h3>How long</h3>") && page.contains(">1.5</text>"));
    assert!(page.contains(ID), "its episode is shown over time");
    assert!(page.contains("class=\"event-collision\""));
    assert!(!page.contains("http"), "nothing is asked of the network");
}

#[test]
fn without_a_page_it_is_said_how_to_get_one() {
    let folder = memory();
    let (code, _, err) = ask(folder.path(), &[COLLISIONS]);
    assert_eq!(code, 0);
    assert!(err.contains("--view FILE"), "{err}");
    let (_, _, err) = ask(folder.path(), &["owl_individual_of(C, semco:'Collision')"]);
    assert_eq!(err, "", "where nothing is shown, nothing is said");
}

#[test]
fn what_cannot_be_drawn_leaves_no_page() {
    let folder = memory();
    for (query, says) in [
        (
            "data_vis(piechart(p), [data: [[a, b], [1]]])",
            "piechart: data has 2 Xs, but 1 Ys",
        ),
        ("show(sponge, 5)", "nothing was recorded between 5 and 5 s"),
        ("show(sponge, 1003)", "round-1.parquet"),
    ] {
        let (code, _, err) = ask(folder.path(), &[query, "--view", "seen.html"]);
        assert_eq!(code, 2, "{query}");
        assert!(err.contains(says), "{query}: {err}");
    }
    let (code, _, err) = ask(folder.path(), &["true", "--view", "episodes"]);
    assert_eq!(code, 2);
    assert!(err.contains("--view"), "{err}");
    let files = fs::read_dir(folder.path()).unwrap();
    assert_eq!(files.count(), 1, "only the memory");
}

#[test]
fn a_page_takes_a_query() {
    let folder = memory();
    let (code, _, err) = ask(folder.path(), &["--view", "seen.html"]);
    assert_eq!(code, 2);
    assert!(err.contains("QUERY"), "{err}");
}
