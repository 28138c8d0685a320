//! The recording of a run, the live page, and the report that is made of it.

use crate::program::{path, wisch};
use flate2::read::GzDecoder;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A run of at most two short rounds.
fn run(folder: &Path, more: &[&str]) -> Child {
    let mut command = crate::rounds::wisch(folder, "out", more);
    command.arg("--quiet").stdout(Stdio::null());
    command.spawn().expect("it runs")
}

fn recording(folder: &Path) -> String {
    let file = File::open(folder.join("recording.jsonl.gz")).expect("there is a recording");
    let mut text = String::new();
    GzDecoder::new(file)
        .read_to_string(&mut text)
        .expect("it is packed text");
    text
}

fn pieces(text: &str) -> Vec<Value> {
    let lines = text.lines();
    lines
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect()
}

/// The episodes of a memory.
fn episodes(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.join("episodes")).expect("a memory");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .filter(|path| path.join("episode.json").is_file())
        .collect()
}

#[test]
fn a_run_is_kept_as_it_is_shown_and_becomes_a_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let code = run(folder.path(), &[]).wait().expect("it ends").code();
    assert_eq!(code, Some(1), "the goal cannot be met");
    let text = recording(&folder.path().join("out"));
    let pieces = pieces(&text);
    let kinds: Vec<&str> = pieces
        .iter()
        .filter_map(|piece| piece["piece"].as_str())
        .collect();
    assert_eq!((kinds[0], kinds[kinds.len() - 1]), ("head", "ended"));
    let kinds: BTreeSet<&str> = kinds.into_iter().collect();
    for kind in [
        "stage",
        "round",
        "samples",
        "observed",
        "interpreted",
        "truth",
    ] {
        assert!(kinds.contains(kind), "{kind} in {kinds:?}");
    }
    for round in [1, 2] {
        let samples = (pieces.iter()).filter(|p| p["piece"] == "samples" && p["round"] == round);
        let times: Vec<f64> = samples
            .flat_map(|piece| piece["t"].as_array().expect("times"))
            .map(|time| time.as_f64().expect("a number"))
            .collect();
        assert!(
            times.len() > 50 && times.is_sorted_by(|a, b| a < b),
            "round {round}"
        );
        let interpreted =
            (pieces.iter()).find(|p| p["piece"] == "interpreted" && p["round"] == round);
        let contacts = interpreted.expect("it is interpreted")["contacts"].as_array();
        assert!(!contacts.expect("spans").is_empty(), "round {round}");
    }
    let ended = pieces.last().expect("pieces");
    assert_eq!(ended["badge"], "not met: no rounds left");
    let next = ended["story"]["next"]["command"].as_str();
    assert!(
        next.is_some_and(|next| next.contains("--rounds 4")),
        "{next:?}"
    );
    let [episode] = &episodes(folder.path())[..] else {
        panic!("one episode");
    };
    assert_eq!(recording(episode), text, "the episode keeps the same");

    let name = episode.file_name().expect("a name").to_str().expect("text");
    let report = fs::read_to_string(folder.path().join("out/report.html")).expect("a report");
    for (what, page) in [
        ("out", "out.html".to_owned()),
        (name, format!("{name}.html")),
    ] {
        let (code, out, err) = wisch(folder.path(), &["report", what]);
        assert_eq!((code, out, err), (0, format!("{page}\n"), String::new()));
        let page = fs::read_to_string(folder.path().join(page)).expect("a page");
        assert!(page == report, "{what}: the page is that of the run");
    }
    assert!(report.len() < 3_000_000, "{} bytes", report.len());
}

#[test]
fn what_has_no_recording_is_no_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |path: &str| folder.path().join(path);
    fs::create_dir_all(at("old")).expect("a folder");
    fs::write(at("old/plan.json"), "{}").expect("written");
    fs::create_dir_all(at("broken")).expect("a folder");
    fs::write(at("broken/recording.jsonl.gz"), "no gzip").expect("written");
    fs::create_dir_all(at("episodes")).expect("a folder");
    for (what, says) in [
        (
            "old",
            "the folder has neither recording.jsonl.gz nor report.html",
        ),
        (
            "broken",
            "broken/recording.jsonl.gz: cannot read the recording",
        ),
        ("nowhere", "nowhere"),
        ("../episodes", "../episodes"),
    ] {
        let (code, _, err) = wisch(folder.path(), &["report", what, "--out", "page.html"]);
        assert!(code == 2 && err.contains(says), "{what}: {code}: {err}");
        assert!(!at("page.html").exists(), "{what}");
    }
}

#[cfg(unix)]
#[test]
fn a_live_run_is_shown_and_can_be_stopped_in_order() {
    use rustix::process::{Pid, Signal, kill_process};
    let folder = tempfile::tempdir().expect("a folder");
    let mut running = run(folder.path(), &["--live", "--realtime"]);
    let live = folder.path().join("episodes/.live");
    let lines = || {
        let entries = fs::read_dir(&live).into_iter().flatten().flatten();
        entries
            .map(|entry| entry.path())
            .find(|path| path.extension().is_some_and(|ending| ending == "jsonl"))
    };
    let wait_for = |running: &mut Child, what: &dyn Fn() -> bool| {
        while !what() {
            assert_eq!(
                running.try_wait().expect("a process"),
                None,
                "it ended too early"
            );
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    let has_samples = || {
        let text = lines().and_then(|path| fs::read_to_string(path).ok());
        text.is_some_and(|text| text.contains("\"samples\""))
    };
    wait_for(&mut running, &has_samples);
    let path = lines().expect("it is there");
    let who = fs::read_to_string(path.with_extension("json")).expect("who it is");
    let who: Value = serde_json::from_str(&who).expect("JSON");
    assert_eq!(
        (&who["pid"], &who["task"]),
        (&running.id().into(), &"chopping-board".into())
    );
    assert!(episodes(folder.path()).is_empty());
    // Who holds it sees the end of it, though its name is gone by then.
    let mut held = File::open(&path).expect("it can be read");

    kill_process(Pid::from_child(&running), Signal::TERM).expect("it can be told");
    assert_eq!(running.wait().expect("it ends").code(), Some(1));
    let [episode] = &episodes(folder.path())[..] else {
        panic!("what was wiped is kept");
    };
    assert_eq!(
        fs::read_dir(&live).expect("a folder").count(),
        0,
        "the live file is removed"
    );
    let mut text = String::new();
    held.read_to_string(&mut text).expect("text");
    let pieces = pieces(&text);
    let last = pieces.last().expect("pieces");
    let name = episode.file_name().expect("a name").to_str().expect("text");
    assert_eq!(
        (&last["piece"], &last["episode"]),
        (&"ended".into(), &name.into())
    );
    let happened = last["story"]["happened"].as_str().expect("a story");
    assert!(happened.ends_with("The run was stopped."), "{happened}");
    assert_eq!(last["badge"], "stopped");
    let interpreted = pieces.iter().find(|piece| piece["piece"] == "interpreted");
    let interpreted = interpreted.expect("it is interpreted");
    assert_eq!(interpreted["ending"], "stopped");
    let incidents = interpreted["incidents"].as_array().expect("incidents");
    let titles = incidents.iter().filter_map(|one| one["title"].as_str());
    let titles: Vec<&str> = titles.collect();
    assert!(
        (titles.last()).is_some_and(|title| title.starts_with("Stopped on request")),
        "{titles:?}"
    );
    // A run that was stopped is not blamed for what it had not wiped yet.
    assert!(
        !titles.iter().any(|title| title.contains("predicted")),
        "{titles:?}"
    );
}

#[test]
fn a_recording_states_what_did_not_go_as_planned() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = [
        "run",
        "failure-human-push",
        "--rounds",
        "1",
        "--seed",
        "0",
        "--no-memory",
    ];
    let (code, _, err) = wisch(folder.path(), &args);
    assert_eq!(code, 1, "{err}");
    let text = recording(&folder.path().join("out/failure-human-push"));
    let pieces = pieces(&text);
    let interpreted = pieces.iter().find(|piece| piece["piece"] == "interpreted");
    let interpreted = interpreted.expect("it is interpreted");
    let incidents = interpreted["incidents"].as_array().expect("incidents");
    let texts = |key: &str| -> Vec<&str> {
        incidents
            .iter()
            .filter_map(|one| one[key].as_str())
            .collect()
    };
    assert_eq!(
        texts("title"),
        [
            "2 collisions: in stroke 3 and in stroke 5",
            "Less was wiped than predicted"
        ]
    );
    let evidence = texts("evidence")[0];
    assert!(
        evidence.starts_with("At 24.0 s, 38.1 s: ") && evidence.contains(" N at most, tool up to "),
        "{evidence}"
    );
    // The lane of contacts has as many intervals as the summary states.
    let contacts = interpreted["contacts"].as_array().expect("spans").len();
    let words = interpreted["words"].to_string();
    assert!(
        words.contains(&format!(" {contacts} contacts")),
        "{contacts}: {words}"
    );
}

#[cfg(unix)]
#[test]
fn ended_before_a_round_is_over_nothing_is_kept() {
    use rustix::process::{Pid, Signal, kill_process};
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::new(path());
    command.current_dir(folder.path()).stderr(Stdio::piped());
    // To look for the best plan takes its time.
    command.args(["run", "chopping-board", "--live", "--quiet"]);
    let running = command.spawn().expect("it runs");
    let live = folder.path().join("episodes/.live");
    while fs::read_dir(&live).map_or(0, Iterator::count) < 2 {
        std::thread::sleep(Duration::from_millis(2));
    }
    // From then on it listens.
    std::thread::sleep(Duration::from_millis(100));
    kill_process(Pid::from_child(&running), Signal::TERM).expect("it can be told");
    let ended = running.wait_with_output().expect("it ends");
    let said = String::from_utf8(ended.stderr).expect("text");
    assert_eq!(ended.status.code(), Some(2), "{said}");
    assert!(
        said.contains("interrupted before the first motion"),
        "{said}"
    );
    assert!(episodes(folder.path()).is_empty());
    assert_eq!(fs::read_dir(&live).expect("a folder").count(), 0);
}

#[test]
fn a_live_run_needs_a_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, _, err) = wisch(
        folder.path(),
        &["run", "arm-board", "--live", "--no-memory"],
    );
    assert!(code == 2 && err.contains("--no-memory"), "{err}");
}
