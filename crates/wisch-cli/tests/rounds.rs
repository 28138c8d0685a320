//! The closed loop of `wisch run`: what a killed run leaves behind, and how it is gone on with.

use crate::program::{path, root};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// Files that say how a run went, all of them the same every time.
const FILES: [&str; 9] = [
    "report.html",
    "recording.jsonl.gz",
    "rounds.json",
    "plan.json",
    "particles/particles-before.csv",
    "particles/particles-true.csv",
    "particles/particles-estimated.csv",
    "telemetry/round-1.mcap",
    "telemetry/round-2.mcap",
];

/// A run of two short rounds.
pub fn wisch(folder: &Path, out: &str, more: &[&str]) -> Command {
    let task = root().join("scenarios/chopping-board.toml");
    let mut command = Command::new(path());
    command.current_dir(folder).arg("run").arg(task);
    command.args([
        "--greedy",
        "--strategy",
        "kde",
        "--rounds",
        "2",
        "--out",
        out,
    ]);
    command.args(["--set", "target_performance=1.0"]).args(more);
    command
}

/// Exit code and standard error.
fn ended(mut command: Command) -> (Option<i32>, String) {
    let output = command.output().expect("it runs");
    let err = String::from_utf8(output.stderr).expect("text");
    (output.status.code(), err)
}

/// The hidden folders beside results.
fn hidden(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_hidden = |path: &PathBuf| {
        let name = path.file_name().expect("a name");
        name.to_string_lossy().starts_with('.')
    };
    paths.filter(is_hidden).collect()
}

/// Starts a run and waits until its first round is over; gives the run and its hidden folder.
pub fn after_one_round(folder: &Path, mut command: Command) -> (Child, PathBuf) {
    let mut run = command.stdout(Stdio::null()).spawn().expect("it runs");
    let has_one = || {
        hidden(folder)
            .into_iter()
            .find(|p| p.join("state/round-1.json").is_file())
    };
    let left = loop {
        if let Some(left) = has_one() {
            break left;
        }
        assert_eq!(
            run.try_wait().expect("a process"),
            None,
            "it ended too early"
        );
        std::thread::sleep(Duration::from_millis(2));
    };
    (run, left)
}

/// Starts a run, kills it (SIGKILL where there are signals) after its first round, and gives what it left.
fn killed_after_one_round(folder: &Path, out: &str) -> PathBuf {
    let (mut run, left) = after_one_round(folder, wisch(folder, out, &[]));
    run.kill().expect("it is killed");
    run.wait().expect("it is dead");
    assert!(!folder.join(out).exists() && left.exists());
    left
}

#[test]
fn a_killed_run_is_gone_on_with_and_gives_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, err) = ended(wisch(folder.path(), "whole", &[]));
    assert_eq!((code, err.as_str()), (Some(1), ""));

    killed_after_one_round(folder.path(), "cut");
    let (code, err) = ended(wisch(folder.path(), "cut", &["--resume"]));
    assert_eq!(code, Some(1), "{err}");
    assert!(
        err.contains("resuming after 1 round of the killed run"),
        "{err}"
    );
    let of = |run: &str, name: &str| fs::read(folder.path().join(run).join(name)).expect(name);
    for name in FILES {
        assert!(of("cut", name) == of("whole", name), "{name} differs");
    }
    // The same of the episode's telemetry and looks, those of the round which was taken over too.
    let episodes = fs::read_dir(folder.path().join("episodes")).expect("a memory");
    let episodes = episodes.map(|entry| entry.expect("an entry").path());
    let mut episodes: Vec<PathBuf> = episodes
        .filter(|path| path.join("episode.json").is_file())
        .collect();
    episodes.sort();
    let [whole, cut] = &episodes[..] else {
        panic!("two episodes: {episodes:?}");
    };
    let kept = [
        "round-1.parquet",
        "round-2.parquet",
        "round-1/observations.json",
        "round-2/observations.json",
    ];
    for name in kept {
        let of = |episode: &Path| fs::read(episode.join(name)).expect(name);
        assert!(of(cut) == of(whole), "{name} differs");
    }
    assert_eq!(hidden(folder.path()), Vec::<PathBuf>::new());
}

#[cfg(unix)]
#[test]
fn ctrl_c_says_how_to_go_on() {
    use rustix::process::{Pid, Signal, kill_process};
    use std::io::Read;
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = wisch(folder.path(), "cut", &["--realtime"]);
    command.stderr(Stdio::piped());
    let (mut run, left) = after_one_round(folder.path(), command);
    kill_process(Pid::from_child(&run), Signal::INT).expect("it runs");
    assert_eq!(run.wait().expect("it ends").code(), Some(130));
    let mut err = String::new();
    let read = run
        .stderr
        .take()
        .map(|mut pipe| pipe.read_to_string(&mut err));
    read.expect("a pipe").expect("text");
    let said = "error: interrupted after round 1\n  help: add --resume to the same command to continue from there\n";
    assert_eq!(err, said);
    assert!(left.exists());
    let (code, err) = ended(wisch(folder.path(), "cut", &["--resume"]));
    assert_eq!(code, Some(1), "{err}");
    assert!(
        err.contains("resuming after 1 round of the killed run"),
        "{err}"
    );
}

#[test]
fn what_a_killed_run_left_is_not_taken_for_another_and_is_cleaned_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let left = killed_after_one_round(folder.path(), "cut");
    // Of another place: not touched.
    let (code, err) = ended(wisch(folder.path(), "other", &["--robot", "none"]));
    assert_eq!((code, err.as_str()), (Some(1), ""));
    assert!(left.exists());
    // Without --resume: removed.
    let (code, err) = ended(wisch(folder.path(), "cut", &["--robot", "none"]));
    assert_eq!(code, Some(1), "{err}");
    assert!(
        err.contains("note: removed") && err.contains("killed run"),
        "{err}"
    );
    assert!(!left.exists());

    // Of another seed: an error, and its round is still there for the right command.
    killed_after_one_round(folder.path(), "again");
    let (code, err) = ended(wisch(folder.path(), "again", &["--resume", "--seed", "7"]));
    assert_eq!(code, Some(2), "{err}");
    assert!(
        err.contains("again: the killed run, which completed 1 round, had another task, seed"),
        "{err}"
    );
    let (_, err) = ended(wisch(folder.path(), "again", &["--resume"]));
    assert!(
        err.contains("resuming after 1 round of the killed run"),
        "{err}"
    );
}
