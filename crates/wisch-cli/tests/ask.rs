//! `wisch ask`: where its Prolog engine comes from, and the page that it draws.

#[cfg(unix)]
mod engine;
#[cfg(target_os = "linux")]
mod interactive;
#[cfg(target_os = "linux")]
mod killed;
mod view;

use crate::program::{ended, path as program};
use assert_cmd::Command;
use std::path::Path;
use std::sync::{Mutex, Once, PoisonError};
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

/// The engine beside the program. Cargo builds it for the tests of its own package, so it is there when the whole
/// workspace is tested; who tests this package alone has it built here, once.
fn build_engine() {
    static BUILT: Once = Once::new();
    BUILT.call_once(|| {
        let program = program();
        if program.with_file_name("wisch-prolog").is_file() {
            return;
        }
        let folder = program.parent().unwrap();
        let mut cargo = std::process::Command::new(env!("CARGO"));
        cargo.args(["build", "--locked", "--package", "wisch-prolog"]);
        cargo.arg("--target-dir").arg(folder.parent().unwrap());
        if folder.ends_with("release") {
            cargo.arg("--release");
        }
        assert!(cargo.status().unwrap().success(), "the engine is built");
    });
}

/// Exit code, standard output and standard error of the program with its engine.
pub fn ask(folder: &Path, args: &[&str]) -> (i32, String, String) {
    build_engine();
    run(Command::new(program())
        .current_dir(folder)
        .arg("ask")
        .args(args))
}

#[test]
fn a_table_of_answers_that_is_cut_says_so() {
    let folder = memory();
    let query = "member(N, [1, 2, 3])";
    let (code, out, err) = ask(folder.path(), &[query, "--csv", "--limit", "2"]);
    assert_eq!((code, out.as_str()), (0, "N\n1\n2\n"), "{err}");
    assert!(
        err.contains("the answers are cut: the first 2 answers; raise the limit with --limit"),
        "{err}"
    );
    let (_, _, err) = ask(folder.path(), &[query, "--csv"]);
    assert_eq!(err, "");
}

/// One at a time: a process that is just beginning holds open, for a moment, the scripts that another test writes.
fn run(command: &mut Command) -> (i32, String, String) {
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    ended(command)
}
