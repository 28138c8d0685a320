//! What version 2 of the executor protocol offers to the drivers of real robots.

use crate::process::{CHILD, has_python, loaded, motion};
use std::ops::ControlFlow;
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, PlannedRound, ignore_events};
use wisch_io::{DriverRobotRecord, ProcessExecutor, ProcessOptions};

/// Executes any number of motions, each twice as fast as planned, and writes down what it hears, word by word.
/// `spoil(word)` is called before the answer to each word.
const DRIVER: &str = r#"
import json, sys
def hear():
    line = sys.stdin.readline()
    return json.loads(line) if line else None
def write(message):
    print(json.dumps(message), flush=True)
def say(**message):
    write(message)
def done(motion, ending):
    say(done={"duration_s": motion["duration_s"], "ending": ending, "positions": points[-1]["positions"]})
while (message := hear()) is not None:
    word = message if isinstance(message, str) else next(iter(message))
    with open(HEARD, "a") as file:
        file.write(word + "\n")
    spoil(word)
    if word == "hello":
        robot = message["hello"].get("robot")
        say(ready={"version": 2, **READY})
    elif word == "prepare":
        write("prepared")
    elif word == "finish":
        write("finished")
    elif word == "execute":
        motion = message["execute"]
        points = [hear()["point"] for _ in range(motion["points"])]
        for point in points:
            say(sample={"time_s": point["time_s"], "force_n": [0, 0, 0], "positions": point["positions"]})
        done(motion, "complete")
"#;

/// Starts a driver. `ready`: what its greeting adds. `spoil`: lines of Python that it executes before each answer.
fn driver(heard: &tempfile::NamedTempFile, ready: &str, spoil: &str) -> ProcessExecutor {
    let spoil = spoil.replace('\n', "\n    ");
    let script = format!(
        "HEARD = {:?}\nREADY = {{{ready}}}\ndef spoil(word):\n    {spoil}\n{DRIVER}",
        heard.path().display().to_string()
    );
    let options = ProcessOptions {
        robot: Some(described()),
        ..ProcessOptions::default()
    };
    ProcessExecutor::start_with("python3", &["-c".to_owned(), script], options).expect("it greets")
}

fn described() -> DriverRobotRecord {
    let planned = motion();
    let (_, robot) = loaded();
    DriverRobotRecord::new(&robot, &planned.cell, &planned.task.tool.name)
}

fn words(heard: &tempfile::NamedTempFile) -> Vec<String> {
    let text = std::fs::read_to_string(heard.path()).expect("its words");
    text.lines().map(str::to_owned).collect()
}

fn file() -> tempfile::NamedTempFile {
    tempfile::NamedTempFile::new().expect("a file")
}

fn execute(
    child: &mut ProcessExecutor,
    planned: &PlannedRound,
) -> Result<Execution, ExecutorError> {
    let order = MotionOrder {
        round: 1,
        seed: 1,
        task: &planned.task,
        cell: &planned.cell,
        followed: &planned.followed,
    };
    child.execute(&order, &mut |_| ControlFlow::Continue(()))
}

#[test]
fn a_driver_learns_which_robot_it_drives() {
    if !has_python() {
        return;
    }
    let heard = file();
    let lines = r#"
global check
if word == "execute":
    check = lambda motion: [
        key for key, same in [
            ("joints", robot["joints"] == motion["joints"]),
            ("tip", robot["tip"] == motion["tip"]),
            ("tip_from_tool", robot["tip_from_tool"] == motion["tip_from_tool"]),
            ("name", robot["name"] == motion["robot"] == "arm7"),
            ("tool", robot["tool"] == motion["tool"]),
            ("urdf", "<robot" in robot["urdf"] and all(f'"{j}"' in robot["urdf"] for j in robot["joints"])),
            ("srdf", "<group" in robot["srdf"]),
            ("arm_joints", set(robot["arm_joints"]) <= set(robot["joints"]) and robot["arm_joints"]),
        ] if not same
    ]
    wrong = check(message["execute"])
    if wrong:
        say(error=f"these differ: {wrong}")
"#;
    let planned = motion();
    execute(&mut driver(&heard, "", lines), &planned).expect("it is the same robot");
}

#[test]
fn a_description_that_is_too_long_leaves_texts_out() {
    let (_, mut robot) = loaded();
    let planned = motion();
    let mut describe = |urdf: usize, srdf: usize| {
        robot.files.urdf = "u".repeat(urdf);
        robot.files.srdf = Some("s".repeat(srdf));
        let record = DriverRobotRecord::new(&robot, &planned.cell, "sponge");
        (record.urdf.is_some(), record.srdf.is_some())
    };
    assert_eq!(describe(400_000, 600_000), (true, true));
    assert_eq!(describe(400_000, 700_000), (true, false));
    assert_eq!(describe(1_100_000, 10), (false, false));
}

#[test]
fn a_driver_prepares_before_its_first_motion_and_finishes_after_its_last() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let heard = file();
    let mut child = driver(&heard, "\"prepares\": True", "pass");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let run = session.run(&mut child, &mut ignore_events);
    assert_eq!((run, session.finish_failure()), (Ok(()), None));
    drop(child);
    let mut words = words(&heard);
    words.retain(|word| word != "observe");
    words.dedup();
    assert_eq!(words, ["hello", "prepare", "execute", "finish"]);

    // A driver that does not say so hears neither.
    let heard = file();
    let mut child = driver(&heard, "", "pass");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    assert_eq!(session.run(&mut child, &mut ignore_events), Ok(()));
    let words = self::words(&heard);
    assert!(
        !words
            .iter()
            .any(|word| word == "prepare" || word == "finish"),
        "{words:?}"
    );
}

#[test]
fn a_driver_that_cannot_prepare_moves_nothing_and_one_that_cannot_finish_is_named() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let run = |spoil: &str| {
        let heard = file();
        let mut child = driver(&heard, "\"prepares\": True", spoil);
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let run = session.run(&mut child, &mut ignore_events);
        let failure = session.finish_failure().map(ToString::to_string);
        drop(child);
        (
            run.map_err(|error| error.to_string()),
            failure,
            words(&heard),
        )
    };
    let (result, failure, words) =
        run("if word == \"prepare\": say(error=\"the brakes are closed\")");
    let reason = "executor \"python3\": the brakes are closed";
    assert_eq!((result, failure), (Err(reason.to_owned()), None));
    let moved = words
        .iter()
        .any(|word| word == "execute" || word == "finish");
    assert!(!moved, "{words:?}");

    let (result, failure, _) = run("if word == \"finish\": say(error=\"the pendant is locked\")");
    let reason = "executor \"python3\": the pendant is locked";
    assert_eq!((result, failure.as_deref()), (Ok(()), Some(reason)));

    // After a fault the robot is stopped first.
    let (result, failure, words) = run("if word == \"execute\": say(nonsense=1)");
    let error = result.expect_err("it is no message");
    assert!(
        error.contains("is not a message of the protocol"),
        "{error}"
    );
    assert_eq!(failure, None);
    assert_eq!(words[words.len() - 2..], ["stop", "finish"]);
}

#[test]
fn a_driver_whose_run_is_abandoned_finishes_too() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let heard = file();
    let mut child = driver(&heard, "\"prepares\": True", "pass");
    child.prepare(&planned.cell).expect("it prepares");
    drop(child);
    assert_eq!(words(&heard), ["hello", "prepare", "finish"]);
    let greeting = "say(ready={\"version\": 1, \"prepares\": True})";
    let script = CHILD.replace("say(ready={\"version\": 1})", greeting);
    let started = ProcessExecutor::start("python3", &["-c".to_owned(), script]);
    let error = started.expect_err("it is refused").to_string();
    assert!(error.contains("ready: prepares needs version 2"), "{error}");
}
