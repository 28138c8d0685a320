//! Commands that a signal ends leave nothing, and a run that a signal ends between two rounds keeps the rounds before.

use crate::program::{folder_with, path as program, wisch};
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use wisch_memory::Memory;

/// What a test waits for at most: longer than any command on a busy machine.
const LONGEST: Duration = Duration::from_secs(300);

/// The names of a folder's hidden entries.
fn hidden(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned());
    names.filter(|name| name.starts_with('.')).collect()
}

/// Runs a command, and sends a signal as soon as a condition holds.
fn interrupt(folder: &Path, args: &[&str], signal: Signal, is_due: &dyn Fn() -> bool) -> Output {
    let mut command = Command::new(program());
    command.args(args);
    interrupt_command(command.current_dir(folder), &[signal], is_due)
}

/// Runs a command, and sends signals one after the other as soon as a condition holds.
fn interrupt_command(
    command: &mut Command,
    signals: &[Signal],
    is_due: &dyn Fn() -> bool,
) -> Output {
    let run = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it begins");
    let since = Instant::now();
    while !is_due() {
        assert!(
            since.elapsed() < LONGEST,
            "{command:?}: it does not come so far"
        );
        std::thread::sleep(Duration::from_millis(5));
    }
    for (number, signal) in signals.iter().enumerate() {
        if number > 0 {
            // Meanwhile, the program handles the signal before.
            std::thread::sleep(Duration::from_millis(300));
        }
        kill_process(Pid::from_child(&run), *signal).expect("it runs");
    }
    run.wait_with_output().expect("it ends")
}

/// A map that takes minutes to build.
const MAP: [&str; 7] = [
    "robot",
    "map",
    "arm7",
    "--samples",
    "100000000",
    "--out",
    "arm7.reach",
];

#[test]
fn a_command_that_a_signal_ends_removes_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let plan = ["plan", "chopping-board", "--out", "deep/out"];
    for (args, place) in [(&MAP[..], folder.to_owned()), (&plan, folder.join("deep"))] {
        for (signal, code) in [(Signal::INT, 130), (Signal::TERM, 143)] {
            let output = interrupt(folder, args, signal, &|| !hidden(&place).is_empty());
            let err = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(code), "{args:?}: {err}");
            assert_eq!(err, "error: interrupted\n", "{args:?}");
            let left = fs::read_dir(folder).expect("a folder").count();
            assert_eq!(left, 0, "{args:?}: {signal:?}");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_command_goes_on_at_a_signal_that_is_ignored_from_its_begin() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mut command = Command::new("sh");
    // As `nohup` does it.
    command.args(["-c", "trap '' HUP; exec \"$0\" \"$@\""]);
    command.arg(program()).args(MAP).current_dir(folder);
    let is_due = || !hidden(folder).is_empty();
    let output = interrupt_command(&mut command, &[Signal::HUP, Signal::TERM], &is_due);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(143), "{err}");
    assert_eq!(hidden(folder), [""; 0]);
}

#[test]
fn the_next_file_in_a_folder_removes_that_of_a_killed_command() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let output = interrupt(folder, &MAP, Signal::KILL, &|| !hidden(folder).is_empty());
    assert_eq!(output.status.code(), None);
    assert_eq!(hidden(folder).len(), 1);
    fs::write(folder.join(".notes.txt.part"), "mine").expect("a file");
    let (code, out, err) = wisch(folder, &["new", "board.toml"]);
    assert_eq!(code, 0, "{out}{err}");
    assert_eq!(hidden(folder), [".notes.txt.part"]);
}

#[test]
fn files_for_people_have_the_permissions_of_the_process() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("plain"), "").expect("a file");
    let mode = |name: &str| {
        let file = fs::metadata(folder.join(name)).expect(name);
        file.permissions().mode()
    };
    for args in [
        &["new", "board.toml"][..],
        &["footprint", "sponge", "--svg", "sponge.svg"],
        &[
            "predict",
            "chopping-board",
            "--strategy",
            "grid",
            "--out",
            "out",
        ],
        &["report", "out", "--out", "page.html"],
    ] {
        let (code, out, err) = wisch(folder, args);
        assert!(code < 2, "{args:?}: {out}{err}");
    }
    for name in ["board.toml", "sponge.svg", "page.html", "out/plan.json"] {
        assert_eq!(mode(name), mode("plain"), "{name}");
    }
}

/// Follows its motions, and presses with less force than planned. It has no camera, and takes a second to state where it stands.
const ROBOT: &str = r#"
import json, sys, time
at = []
def hear():
    line = sys.stdin.readline()
    return json.loads(line) if line else sys.exit()
def say(**message):
    print(json.dumps(message), flush=True)
while True:
    message = hear()
    if "hello" in message:
        say(ready={"version": 1, "reports_state": True})
    elif message == "state":
        time.sleep(1)
        say(state={"positions": at})
    elif "execute" in message:
        motion = message["execute"]
        points = [hear()["point"] for _ in range(motion["points"])]
        wipes = [p for p in motion["phases"] if p["phase"] == "wipe"]
        for point in points:
            time_s = point["time_s"]
            presses = any(p["start_s"] <= time_s <= p["end_s"] for p in wipes)
            say(sample={"time_s": time_s, "world_from_tool": point["world_from_tool"],
                        "force_n": [0, 0, 0.6 * motion["press_force_n"] * presses], "positions": point["positions"]})
        at = points[-1]["positions"]
        say(done={"duration_s": motion["duration_s"], "ending": "complete", "positions": points[-1]["positions"]})
    elif "observe" in message:
        say(observation=None)
"#;

#[test]
fn a_run_that_is_interrupted_before_its_next_round_keeps_the_rounds_before() {
    if !crate::executor::has_python() {
        return;
    }
    let folder = folder_with("arm-board.toml");
    let folder = folder.path();
    fs::write(folder.join("robot.py"), ROBOT).expect("a robot");
    let events = || fs::read_to_string(folder.join("events")).unwrap_or_default();
    let args = [
        "run",
        "task.toml",
        "--touch-only",
        "--executor",
        "python3 robot.py",
        "--strategy",
        "grid",
        "--out",
        "out",
        "--events",
        "events",
        "--memory",
        "episodes",
        "--json",
    ];
    let decided = || events().contains("\"decided\"");
    let output = interrupt(folder, &args, Signal::INT, &decided);
    let (out, err) = [output.stdout, output.stderr]
        .map(|text| String::from_utf8(text).expect("text"))
        .into();
    if events().matches("\"decided\"").count() != 1 {
        // The machine was too slow to interrupt before the second round.
        return;
    }
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert!(err.contains("interrupted: 1 round kept\n"), "{err}");
    let summary: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(summary["rounds"][0]["verdict"], "wipe again", "{out}");
    let memory = Memory::open(&folder.join("episodes")).expect("a memory");
    let [id] = &memory.episodes().expect("episodes")[..] else {
        panic!("one episode");
    };
    let episode = memory.episode(id).expect("an episode");
    assert_eq!(episode.record().expect("a record").rounds.len(), 1);
    let packed = episode
        .attachment("recording.jsonl.gz")
        .expect("a recording");
    let mut text = String::new();
    flate2::read::GzDecoder::new(&packed[..])
        .read_to_string(&mut text)
        .expect("text");
    let ended: serde_json::Value =
        serde_json::from_str(text.lines().last().expect("lines")).expect("JSON");
    assert_eq!(ended["badge"], "interrupted");
    let story = ended["story"]["happened"].as_str().expect("a story");
    assert!(
        story.contains("The operator interrupted the run"),
        "{story}"
    );
    // The suggested command has the options of the run.
    let next = &ended["story"]["next"]["command"];
    let next = next.as_str().expect("a command");
    assert!(
        next.starts_with("wisch run task.toml --set ")
            && next.contains(" --strategy grid --executor 'python3 robot.py'")
            && next.contains(" --memory episodes"),
        "{next}"
    );
}
