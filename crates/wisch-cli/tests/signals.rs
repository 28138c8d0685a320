//! Ctrl-C, SIGTERM and a closed pipe of events while another program executes: wisch asks it to stop first, and what it
//! did is kept.
//!
//! ```sh
//! WISCH_SIGNALS=200 cargo test --workspace --test main signals::
//! ```

use crate::kills::{MARK, alive};
use crate::program::{folder_with, path as program};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use wisch_memory::Memory;

/// How many signals, if `WISCH_SIGNALS` does not say so.
const SIGNALS: usize = 3;
/// What a test waits for at most: longer than any run on a busy machine.
const LONGEST: Duration = Duration::from_secs(300);

/// Follows its motion at five times its speed and writes down what it hears, word by word.
const ROBOT: &str = r#"
import json, os, select, sys, time
heard = b""
def hear(wait=None):
    global heard
    while b"\n" not in heard:
        if not select.select([0], [], [], wait)[0]:
            return None
        more = os.read(0, 1 << 16)
        if not more:
            note("end")
            sys.exit()
        heard += more
    line, heard = heard.split(b"\n", 1)
    return json.loads(line)
def note(word):
    with open("heard", "a") as file:
        file.write(word + "\n")
def say(**message):
    print(json.dumps(message), flush=True)
def execute(motion):
    note("execute")
    points = [hear()["point"] for _ in range(motion["points"])]
    begin = time.time()
    for point in points:
        time.sleep(max(0, begin + point["time_s"] / 5 - time.time()))
        say(sample={"time_s": point["time_s"], "world_from_tool": point["world_from_tool"], "force_n": [0, 0, 0],
                    "positions": point["positions"]})
        if hear(0) == "stop":
            note("stop")
            say(done={"duration_s": point["time_s"], "ending": "stopped", "positions": point["positions"]})
            return
    note("done")
    say(done={"duration_s": motion["duration_s"], "ending": "complete", "positions": points[-1]["positions"]})
while True:
    message = hear()
    if message == "stop":
        note("stop")
    elif "hello" in message:
        say(ready={"version": 1})
    elif "execute" in message:
        execute(message["execute"])
    elif "observe" in message:
        say(observation=None)
"#;

fn begin(folder: &Path, mark: &str, more: &[&str]) -> Child {
    let mut command = Command::new(program());
    command.current_dir(folder).env(MARK, mark);
    command.args(["run", "task.toml", "--touch-only", "--rounds", "1"]);
    command.args(["--executor", "python3 robot.py", "--out", "out"]);
    command
        .args(more)
        .stdin(Stdio::null())
        .stderr(Stdio::piped());
    command.spawn().expect("it begins")
}

/// The words that the robot noted down.
fn heard(folder: &Path) -> Vec<String> {
    let text = fs::read_to_string(folder.join("heard")).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

/// Waits for the end of a run, and for that of all that it started; gives exit code and standard error.
fn ended(run: Child, mark: &str) -> (Option<i32>, String) {
    let output = run.wait_with_output().expect("it ends");
    let since = Instant::now();
    while !alive(mark).is_empty() {
        assert!(
            since.elapsed() < Duration::from_secs(10),
            "{:?}",
            alive(mark)
        );
        std::thread::sleep(Duration::from_millis(20));
    }
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code(), err)
}

/// What must hold however a run ended: nothing half-written, the robot asked to stop before its end, and what it executed
/// kept.
fn check(folder: &Path, what: &str) {
    let entries = fs::read_dir(folder).expect("a folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let hidden: Vec<_> = names
        .filter(|name| name.to_string_lossy().starts_with('.'))
        .collect();
    assert!(hidden.is_empty(), "{what}: {hidden:?}");
    let words = heard(folder);
    let begun = words.iter().any(|word| word == "execute");
    let over = words.iter().any(|word| word == "stop" || word == "done");
    assert!(!begun || over, "{what}: {words:?}");
    let memory = Memory::open(&folder.join("episodes"));
    let episodes = memory
        .as_ref()
        .map_or(0, |memory| memory.episodes().unwrap().len());
    if let Ok(memory) = memory {
        let faults = memory.verify().unwrap();
        assert!(faults.is_empty(), "{what}: {faults:?}");
    }
    let out = folder.join("out");
    if out.exists() {
        for file in ["report.html", "rounds.json", "telemetry/round-1.mcap"] {
            assert!(out.join(file).is_file(), "{what}: {file}");
        }
    }
    assert_eq!(episodes > 0, out.exists(), "{what}: {words:?}");
}

#[test]
fn a_signal_at_any_moment_stops_the_robot_first_and_loses_nothing() {
    if !crate::executor::has_python() {
        return;
    }
    let count = std::env::var("WISCH_SIGNALS").ok();
    let count: usize = count.map_or(SIGNALS, |count| count.parse().expect("a number of signals"));
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let fresh = || {
        let folder = folder_with("arm-board.toml");
        fs::write(folder.path().join("robot.py"), ROBOT).expect("a robot");
        folder
    };
    let folder = fresh();
    let since = Instant::now();
    let (code, err) = ended(begin(folder.path(), "signals-none", &[]), "signals-none");
    assert!(code.is_some_and(|code| code < 2), "{code:?}: {err}");
    let longest = since.elapsed().as_secs_f64();
    let mut kept = 0;
    for signal in 0..count {
        let folder = fresh();
        let folder = folder.path();
        let mark = format!("signals-{}-{signal}", std::process::id());
        let run = begin(folder, &mark, &[]);
        // The first comes amid the motion, whatever the machine is busy with.
        if signal == 0 {
            while !heard(folder).contains(&"execute".to_owned()) {
                assert!(since.elapsed() < LONGEST, "no motion began");
                std::thread::sleep(Duration::from_millis(5));
            }
            std::thread::sleep(Duration::from_millis(300));
        } else {
            std::thread::sleep(Duration::from_secs_f64(random.random::<f64>() * longest));
        }
        let which = *[Signal::INT, Signal::TERM].choose(&mut random).unwrap();
        let _ = kill_process(Pid::from_child(&run), which);
        let (code, err) = ended(run, &mark);
        let what = format!(
            "signal {signal}, {which:?}: {code:?}: {err}: {:?}",
            heard(folder)
        );
        assert!(!err.contains("internal error"), "{what}");
        check(folder, &what);
        if signal == 0 {
            assert_eq!(heard(folder)[..2], ["execute", "stop"], "{what}");
            assert!(err.contains("interrupted: 1 round kept"), "{what}");
            let rounds = fs::read_to_string(folder.join("out/rounds.json")).expect("rounds");
            let rounds: serde_json::Value = serde_json::from_str(&rounds).expect("JSON");
            assert_eq!(rounds[0]["ending"], "stopped", "{what}");
            kept += 1;
        }
    }
    assert!(kept <= count);
}

#[test]
fn ctrl_c_in_the_first_round_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let names = || {
        let entries = fs::read_dir(folder.path()).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        names.collect::<Vec<_>>()
    };
    let mut command = Command::new(program());
    command.current_dir(folder.path()).stderr(Stdio::piped());
    command.args(["run", "chopping-board", "--out", "out", "--no-memory"]);
    // The file of events begins when Ctrl-C is heard; the first motion is planned for seconds then.
    let run = command.args(["--events", "events"]);
    let run = run.spawn().expect("it begins");
    let since = Instant::now();
    while !folder.path().join("events").exists() {
        assert!(since.elapsed() < LONGEST, "nothing is planned");
        std::thread::sleep(Duration::from_millis(20));
    }
    kill_process(Pid::from_child(&run), Signal::INT).expect("it runs");
    let output = run.wait_with_output().expect("it ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(
        err.contains("interrupted during the first round; nothing is kept"),
        "{err}"
    );
    assert_eq!(output.status.code(), Some(130), "{err}");
    assert_eq!(names(), ["events"], "{err}");
}

#[test]
fn a_signal_in_a_later_step_of_a_goal_names_the_step_and_keeps_the_earlier_ones() {
    let folder = tempfile::tempdir().unwrap();
    crate::goals::write_board(folder.path());
    let mut command = Command::new(program());
    command.current_dir(folder.path()).stderr(Stdio::piped());
    let run = command.args(["run", "board.toml", "--out", "out", "--no-memory"]);
    let run = run.stdout(Stdio::null()).spawn().expect("it begins");
    let since = Instant::now();
    while !folder.path().join("out/step-1/report.html").exists() {
        assert!(since.elapsed() < LONGEST, "no step is finished");
        std::thread::sleep(Duration::from_millis(5));
    }
    kill_process(Pid::from_child(&run), Signal::TERM).expect("it runs");
    let output = run.wait_with_output().expect("it ends");
    let err = String::from_utf8_lossy(&output.stderr);
    // The signal may arrive before the second step begins.
    let names = ["during step 2; its results are not kept", "after step 1"];
    let help = "help: the results of what is finished are in out; they cannot be resumed\n";
    let said = names.map(|name| format!("error: interrupted {name}\n  {help}"));
    assert!(said.iter().any(|said| err.contains(said)), "{err}");
    assert_eq!(output.status.code(), Some(143), "{err}");
    assert!(folder.path().join("out/step-1").exists());
    assert!(!folder.path().join("out/step-2").exists());
}

#[test]
fn where_nobody_reads_the_events_any_more_the_robot_is_stopped_and_the_round_kept() {
    if !crate::executor::has_python() {
        return;
    }
    let folder = folder_with("arm-board.toml");
    let folder = folder.path();
    fs::write(folder.join("robot.py"), ROBOT).expect("a robot");
    let mark = format!("events-{}", std::process::id());
    let mut command = Command::new(program());
    command.current_dir(folder).env(MARK, &mark);
    command.args([
        "run",
        "task.toml",
        "--touch-only",
        "--rounds",
        "1",
        "--events",
        "-",
    ]);
    command.args(["--executor", "python3 robot.py", "--out", "out"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut run = command.spawn().expect("it begins");
    let mut lines = BufReader::new(run.stdout.take().expect("a pipe")).lines();
    let sample = lines.find(|line| line.as_ref().is_ok_and(|line| line.contains("\"sample\"")));
    assert!(sample.is_some(), "there are samples");
    drop(lines);
    let (code, err) = ended(run, &mark);
    assert_eq!(code, Some(2), "{err}");
    assert!(err.contains("cannot write events"), "{err}");
    assert!(err.contains("1 round kept"), "{err}");
    assert_eq!(heard(folder)[..2], ["execute", "stop"], "{err}");
    check(folder, &err);
}

/// Waits until the robot has noted a word.
fn wait_for(folder: &Path, word: &str) {
    let since = Instant::now();
    while !heard(folder).iter().any(|heard| heard == word) {
        assert!(since.elapsed() < LONGEST, "no {word}: {:?}", heard(folder));
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_signal_pauses_the_robot_and_another_lets_it_continue() {
    if !crate::executor::has_python() {
        return;
    }
    let folder = folder_with("arm-board.toml");
    let folder = folder.path();
    let pausing = ROBOT
        .replace("{\"version\": 1}", "{\"version\": 2, \"pauses\": True}")
        .replace(
            "        if hear(0) == \"stop\":",
            r#"        word = hear(0)
        if word == "pause":
            note(word)
            say(paused={"time_s": point["time_s"], "reason": "on request"})
            word = hear()
            note(word)
            say(resumed={"time_s": point["time_s"]})
        if word == "stop":"#,
        );
    fs::write(folder.join("robot.py"), pausing).expect("a robot");
    let mark = format!("pauses-{}", std::process::id());
    let run = begin(folder, &mark, &[]);
    wait_for(folder, "execute");
    std::thread::sleep(Duration::from_millis(300));
    let signal = || kill_process(Pid::from_child(&run), Signal::USR1).expect("it runs");
    signal();
    wait_for(folder, "pause");
    signal();
    wait_for(folder, "resume");
    let (code, err) = ended(run, &mark);
    assert!(code.is_some_and(|code| code < 2), "{code:?}: {err}");
    assert!(err.contains("pausing the robot"), "{err}");
    assert!(err.contains("the robot continues"), "{err}");
    assert_eq!(heard(folder)[..4], ["execute", "pause", "resume", "done"]);
    let rounds = fs::read_to_string(folder.join("out/rounds.json")).expect("rounds");
    let rounds: serde_json::Value = serde_json::from_str(&rounds).expect("JSON");
    assert_eq!(rounds[0]["pauses"][0]["reason"], "on request", "{rounds}");
}
