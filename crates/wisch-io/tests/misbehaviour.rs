//! Programs of others that misbehave during a run: each ends it with an error that names the fault, or raises a doubt.

use crate::process::{has_python, loaded};
use std::time::{Duration, Instant};
use wisch::interpret::Doubt;
use wisch::run::{RunConfig, Session, ignore_events};
use wisch_io::{ProcessExecutor, ProcessOptions};

/// A driver that follows motions exactly and presses as required; tests replace its comments by
/// faults.
const DRIVER: &str = r#"
import json, os, sys, time
def hear():
    line = sys.stdin.readline()
    return json.loads(line) if line else None
def write(text):
    sys.stdout.write(text)
    sys.stdout.flush()
def say(**message):
    write(json.dumps(message) + "\n")
def done(ending="complete"):
    say(done={"duration_s": motion["duration_s"], "ending": ending, "positions": points[-1]["positions"], **MORE})
MORE, stands = {}, []
while (message := hear()) is not None:
    word = message if isinstance(message, str) else next(iter(message))
    if word == "hello":
        say(ready={"version": 2, "reports_state": True})
        #READY
    elif word == "state":
        say(state={"positions": stands})
    elif word == "observe":
        say(observation=None)
    elif word == "execute":
        motion = message["execute"]
        points = [hear()["point"] for _ in range(motion["points"])]
        x, y, z, w = motion["world_from_surface"][3:]
        normal = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
        wipes = [p for p in motion["phases"] if p["phase"] == "wipe"]
        for k, point in enumerate(points):
            presses = any(p["start_s"] <= point["time_s"] <= p["end_s"] for p in wipes)
            force = [motion["press_force_n"] * presses * n for n in normal]
            pose, positions, now = point["world_from_tool"], point["positions"], point["time_s"]
            #SAMPLE
            say(sample={"time_s": now, "world_from_tool": pose, "positions": positions, "force_n": force, **MORE})
        stands = positions
        #END
        done()
        #AFTER
"#;

/// How a run with a driver ended.
struct Ended {
    error: String,
    /// Error of the end of the session.
    finish: String,
    doubts: Vec<Doubt>,
}

/// Lets a driver execute up to two rounds. `place`: the comment that `lines` replace. `silence`: limit of silence.
fn run(place: &str, lines: &str, silence: Duration) -> Ended {
    let (loaded, robot) = loaded();
    let found = DRIVER.find(place).expect("a comment");
    let indent = found - DRIVER[..found].rfind('\n').expect("a line") - 1;
    let lines = lines.replace('\n', &format!("\n{:indent$}", ""));
    let options = ProcessOptions {
        silence,
        ..ProcessOptions::default()
    };
    let arguments = ["-c".to_owned(), DRIVER.replace(place, &lines)];
    let mut child = ProcessExecutor::start_with("python3", &arguments, options).expect("it greets");
    let config = RunConfig {
        max_rounds: 2,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config)
        .with_belief(loaded.belief())
        .with_robot(robot.robot_setup());
    let run = session.run(&mut child, &mut ignore_events);
    let finish = session.finish_failure().map(ToString::to_string);
    drop(child);
    let rounds = session.into_rounds().into_iter();
    Ended {
        error: run.err().map(|error| error.to_string()).unwrap_or_default(),
        finish: finish.unwrap_or_default(),
        doubts: rounds
            .flat_map(|round| round.interpretation.doubts)
            .collect(),
    }
}

/// A limit that a busy machine does not reach.
const PATIENT: Duration = Duration::from_secs(20);

#[test]
fn a_driver_without_a_fault_raises_no_doubt() {
    if !has_python() {
        return;
    }
    let ended = run("#SAMPLE", "MORE = {'round': motion['round']}", PATIENT);
    assert_eq!((ended.error.as_str(), ended.finish.as_str()), ("", ""));
    assert_eq!(ended.doubts, []);
}

#[test]
fn samples_and_ends_of_another_motion_or_in_other_units_are_named() {
    if !has_python() {
        return;
    }
    for (place, lines, expected) in [
        (
            "#SAMPLE",
            "MORE = {'round': 7}",
            "the sample at 0 s is of round 7; expected round 1",
        ),
        (
            "#END",
            "MORE = {'round': 7}",
            "\"done\" is of round 7; expected round 1",
        ),
        (
            "#SAMPLE",
            "now -= 0.5 * (k == 100)",
            "the sample at 0.5 s follows the sample at 0.99 s; times must rise",
        ),
        (
            "#SAMPLE",
            "pose = [1000 * x for x in pose[:3]] + pose[3:]",
            "m from the motion, beyond the limit of 10 m; expected metres",
        ),
        (
            "#SAMPLE",
            "positions = [57.3 * x for x in positions]",
            "from the start of the motion, more than the limit of 0.3 rad, so the motion is stopped",
        ),
        (
            "#SAMPLE",
            "positions = positions[::-1]",
            "in the order of the robot's variables",
        ),
        ("#SAMPLE", "force = [float('nan')] * 3", "NaN"),
        (
            "#SAMPLE",
            "force = [1e300] * 3",
            "at 0 s force_n[0] is 1e300, beyond the limit of 1e6",
        ),
        (
            "#SAMPLE",
            "positions = [1e300 for _ in positions]",
            "at 0 s positions[0] is 1e300, beyond the limit of 1e6",
        ),
        (
            "#SAMPLE",
            "MORE = {'trajectory_time_s': 1e300 - k}\nMORE['trajectory_time_s'] *= 1 - k / 2",
            "earlier than the last reported time",
        ),
    ] {
        let ended = run(place, lines, PATIENT);
        assert!(ended.error.contains(expected), "{lines}: {}", ended.error);
    }
}

#[test]
fn messages_that_nobody_asked_for_are_named() {
    if !has_python() {
        return;
    }
    for (place, lines, expected) in [
        ("#READY", "say(ready={'version': 2})", "\"ready\""),
        ("#AFTER", "done()", "\"done\""),
        (
            "#AFTER",
            "say(sample={'time_s': now + 1, 'positions': positions, 'force_n': [0, 0, 0]})",
            "\"sample\"",
        ),
        ("#AFTER", "say(error='too late')", "too late"),
    ] {
        let ended = run(place, lines, PATIENT);
        let text = ended.error + &ended.finish;
        assert!(text.contains(expected), "{lines}: {text}");
    }
}

#[test]
fn a_state_that_jumps_between_rounds_moves_nothing() {
    if !has_python() {
        return;
    }
    let ended = run("#READY", "stands = [1.0] * 7", PATIENT);
    let expected = "from the start of the motion, more than the limit of 0.05 rad";
    assert!(ended.error.contains(expected), "{}", ended.error);
}

#[test]
fn an_end_that_the_samples_contradict_moves_nothing() {
    if !has_python() {
        return;
    }
    // From half of the motion on, every sample measures the same state, and "done" states the planned end.
    let blocked = "half = points[len(points) // 2]\nif k > len(points) // 2:\n    pose, positions = half['world_from_tool'], half['positions']";
    let ended = run("#SAMPLE", blocked, PATIENT);
    for part in [
        "after the motion of round 1, joint",
        "by the last sample, but at",
        "start_rad",
    ] {
        assert!(ended.error.contains(part), "{}", ended.error);
    }
    let stood = |doubt: &Doubt| matches!(doubt, Doubt::RobotStoodStill { .. });
    assert!(ended.doubts.iter().any(stood), "{:?}", ended.doubts);
}

#[test]
fn a_wrench_with_another_sign_or_unit_is_doubted() {
    if !has_python() {
        return;
    }
    let ended = run("#SAMPLE", "force = [-x for x in force]", PATIENT);
    assert!(
        ended.doubts.contains(&Doubt::WrenchSignInverted),
        "{} {:?}",
        ended.error,
        ended.doubts
    );
    let ended = run("#SAMPLE", "force = [1000 * x for x in force]", PATIENT);
    let is_doubted = |doubt: &Doubt| matches!(doubt, Doubt::PressForceDiffers { .. });
    assert!(
        ended.doubts.iter().any(is_doubted),
        "{} {:?}",
        ended.error,
        ended.doubts
    );
}

#[test]
fn a_pose_that_contradicts_the_joint_positions_is_doubted() {
    if !has_python() {
        return;
    }
    let lines = "pose = [pose[0] + 0.05] + pose[1:]";
    let ended = run("#SAMPLE", lines, PATIENT);
    let contradicts = ended.doubts.iter().find_map(|doubt| match doubt {
        Doubt::PositionsContradictPose { distance, angle } => Some((*distance, *angle)),
        _ => None,
    });
    let (distance, angle) = contradicts.unwrap_or_else(|| panic!("{:?}", ended.doubts));
    assert!(
        (distance - 0.05).abs() < 1e-6 && angle < 1e-6,
        "{distance} m, {angle} rad"
    );
}

#[test]
fn a_driver_that_says_no_more_or_too_much_ends_in_bounded_time() {
    if !has_python() {
        return;
    }
    let silence = Duration::from_secs(2);
    for (lines, expected) in [
        (
            "write('{\"sample\": ')\ntime.sleep(600)",
            "no message for 2 s",
        ),
        (
            "os.close(1)\ntime.sleep(600)",
            "it closed its standard output",
        ),
        (
            "write('x' * 100_000_000)\ntime.sleep(600)",
            "it sent a line above the limit of 1048576 bytes",
        ),
        (
            "while k == 100:\n    write(' ')\n    time.sleep(0.01)",
            "no message for 2 s",
        ),
    ] {
        let begin = Instant::now();
        let ended = run("#SAMPLE", lines, silence);
        assert!(ended.error.contains(expected), "{lines}: {}", ended.error);
        assert!(begin.elapsed() < Duration::from_secs(60), "{lines}");
    }
}
