//! Faults at random times of a motion: the last command is a stop, soon, and the ending names the fault.

use crate::fake::{Event, FakeRobot, STATE_AGE_MS, execute_round};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use wisch::run::{Ending, StopCause, StopKind};

/// Allowance for a stop after its cause is known [s].
const STOP_S: f64 = 0.1;
/// Allowance for a computer that other programs load [s].
const LOAD_S: f64 = 0.15;

fn repetitions() -> u64 {
    let text = std::env::var("WISCH_ROS2_FAULTS").ok();
    text.and_then(|text| text.parse().ok()).unwrap_or(1)
}

/// Waits for a random moment of a motion: some time after the start of one of its first goals. `before`: number of events
/// before the motion.
fn wait_for_random_moment(fake: &FakeRobot, before: usize, seed: u64) {
    let mixed = (seed + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
    let mut skipped = before;
    for _ in 0..=mixed % 4 {
        fake.wait_for("goal with", skipped);
        let events = fake.events();
        let begun = events
            .iter()
            .skip(skipped)
            .position(|event| event.text.starts_with("goal with"));
        skipped += begun.unwrap() + 1;
    }
    std::thread::sleep(Duration::from_millis(10 + (mixed >> 8) % 400));
}

/// What a fault is expected to lead to.
pub struct Expected {
    pub kind: StopKind,
    /// Part of the reason.
    pub reason: &'static str,
    /// Time after which the executor knows of the fault [s].
    pub known_after: f64,
}

/// Injects a fault on standard input of the fake robot, and checks ending and commands.
fn check(command: &str, expected: &Expected) {
    let mut fake = FakeRobot::commissioned(|file| file);
    for seed in 0..repetitions() {
        if seed > 0 {
            fake = fake.restart();
        }
        let mut executor = fake.executor().unwrap();
        let before = fake.events().len();
        let ending = std::thread::scope(|scope| {
            let fake = &mut fake;
            let injected = scope.spawn(move || {
                wait_for_random_moment(fake, before, seed + command.len() as u64);
                fake.command(command);
            });
            let ending = execute_round(&mut executor);
            injected.join().unwrap();
            ending
        });
        check_ending(&ending.unwrap(), expected);
        check_commands(&fake, expected);
    }
}

pub fn check_ending(ending: &Ending, expected: &Expected) {
    let Ending::ProtectiveStop {
        cause: StopCause::Reported { kind, reason },
        ..
    } = ending
    else {
        panic!("{ending:?}");
    };
    assert_eq!(*kind, expected.kind, "{reason}");
    assert!(reason.contains(expected.reason), "{reason}");
}

/// Checks that the robot holds soon after the fault: no goal is left, force mode is off, and nothing begins anew.
pub fn check_commands(fake: &FakeRobot, expected: &Expected) {
    std::thread::sleep(Duration::from_millis(500));
    let events = fake.events();
    let is_command = |event: &Event| event.text.starts_with("command");
    let fault = events.iter().rfind(|event| is_command(event)).unwrap().time;
    check_hold(&events, fault + expected.known_after);
}

/// Checks that the robot holds soon after a time [s].
fn check_hold(events: &[Event], known: f64) {
    let limit = known + STOP_S + LOAD_S;
    for (begin, end) in [
        ("goal with", "goal ended"),
        ("force mode on", "force mode off"),
    ] {
        let Some(last) = (events.iter()).rposition(|event| event.text.starts_with(begin)) else {
            continue;
        };
        assert!(events[last].time <= limit, "{begin}: {events:#?}");
        // A stop is repeated until it is confirmed; the first one counts.
        let mut later = events[last..].iter();
        let ended = later.find(|event| event.text.starts_with(end));
        let ended = ended.map_or(f64::INFINITY, |event| event.time);
        assert!(ended <= limit, "{end}: {events:#?}");
    }
}

const SILENCE_S: f64 = STATE_AGE_MS / 1000.0;

#[test]
fn silence_of_the_joint_states_stops_the_robot() {
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "/joint_states has been silent",
        known_after: SILENCE_S,
    };
    check("silence joints", &expected);
}

#[test]
fn silence_of_the_wrench_stops_the_robot() {
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "/ft_data has been silent",
        known_after: SILENCE_S,
    };
    check("silence wrench", &expected);
}

#[test]
fn a_pause_cancels_the_goal() {
    let expected = Expected {
        kind: StopKind::Operator,
        reason: "the speed scaling is 0",
        known_after: 0.01,
    };
    check("scaling 0", &expected);
}

#[test]
fn a_protective_stop_and_an_emergency_stop_have_their_kinds() {
    let protective = Expected {
        kind: StopKind::ProtectiveStop,
        reason: "PROTECTIVE_STOP",
        known_after: 0.0,
    };
    check("safety 3", &protective);
    let emergency = Expected {
        kind: StopKind::EmergencyStop,
        reason: "ROBOT_EMERGENCY_STOP",
        known_after: 0.0,
    };
    check("safety 7", &emergency);
}

#[test]
fn a_program_that_ends_stops_the_motion() {
    let expected = Expected {
        kind: StopKind::Operator,
        reason: "the program on the robot does not run",
        known_after: 0.0,
    };
    check("program false", &expected);
}

#[test]
fn a_second_publisher_of_joint_states_stops_the_motion() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    let mut second = fake.start_second();
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let (fake, second) = (&mut fake, &mut second);
        scope.spawn(move || {
            fake.wait_for("goal with", before);
            fake.command("speak");
            second.command("speak");
        });
        execute_round(&mut executor)
    });
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "2 publishers send joint states",
        known_after: 0.05,
    };
    check_ending(&ending.unwrap(), &expected);
    check_commands(&fake, &expected);
}

#[test]
fn a_robot_that_is_moved_by_hand_between_two_motions_is_refused() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    assert_eq!(execute_round(&mut executor), Ok(Ending::Complete));
    let before = fake.events().len();
    fake.command("move 2 0.03");
    std::thread::sleep(Duration::from_millis(800));
    let error = execute_round(&mut executor).unwrap_err();
    assert!(error.contains("limits.start_rad = 0.02"), "{error}");
    let events = fake.events();
    let mut later = events[before..].iter();
    assert!(!later.any(|event| event.text.starts_with("goal")));
}

#[test]
fn stamps_that_jump_stop_the_motion() {
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "clock",
        known_after: 0.0,
    };
    check("clock 10", &expected);
}

#[test]
fn a_push_beyond_the_force_limit_is_an_overload() {
    // After the first tare; before it, the sensor's zero is not known.
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &mut fake;
        scope.spawn(move || {
            fake.wait_for("tare", before);
            fake.wait_for("force mode on", before);
            fake.command("push 60 0 0 1");
        });
        execute_round(&mut executor)
    });
    let expected = Expected {
        kind: StopKind::Overload,
        reason: "more than limits.force_n = 30 N",
        known_after: 0.01,
    };
    check_ending(&ending.unwrap(), &expected);
    check_commands(&fake, &expected);
}

/// A cancel that overtakes its goal finds none, and the goal begins after it.
#[test]
fn a_goal_that_arrives_after_its_cancel_is_canceled() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    // The answer to a goal is awaited for 2 s.
    fake.command("delay 2.5");
    let ending = execute_round(&mut executor);
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "the answer to a goal has not arrived",
        known_after: 3.5,
    };
    check_ending(&ending.unwrap(), &expected);
    let begun = fake.wait_for("goal with", 0);
    let ended = fake.wait_for("goal ended as Canceled", 0);
    assert!(ended.time - begun.time < STOP_S + LOAD_S);
}

/// A robot that goes on pressing is not taken for one that was pushed and rests.
#[test]
fn force_mode_that_does_not_end_is_a_lost_link() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    let before = fake.events().len();
    fake.command("refuse true");
    let ending = std::thread::scope(|scope| {
        let fake = &mut fake;
        scope.spawn(move || {
            fake.wait_for("force mode on", before);
            fake.command("push 60 0 0 1");
        });
        execute_round(&mut executor)
    });
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "the robot has not confirmed that it rests",
        known_after: 1.0,
    };
    check_ending(&ending.unwrap(), &expected);
    // The guard goes on where the executor ends.
    fake.command("refuse false");
    let released = fake.events().len();
    drop(executor);
    fake.wait_for("force mode off", released);
}

#[test]
fn an_executor_that_is_killed_leaves_no_goal_behind() {
    let mut fake = FakeRobot::commissioned(|file| file);
    for seed in 0..repetitions() {
        if seed > 0 {
            fake = fake.restart();
        }
        let mut executor = fake.executor().unwrap();
        let before = fake.events().len();
        let killed = std::thread::scope(|scope| {
            let fake = &fake;
            let killed = scope.spawn(move || {
                wait_for_random_moment(fake, before, seed);
                signal_executor(fake, "-KILL")
            });
            let _ = execute_round(&mut executor);
            killed.join().unwrap()
        });
        check_guard(&fake, killed, 0.0);
    }
}

/// Checks that the guard cancels soon after a time [s], and that no goal begins after its cancel. `known_after`: time after
/// which the guard knows [s].
fn check_guard(fake: &FakeRobot, time: f64, known_after: f64) {
    std::thread::sleep(Duration::from_millis(600));
    let events = fake.events();
    // The guard repeats its cancel; the first one counts.
    let mut later = events.iter().filter(|event| event.time > time);
    let cancel = later.find(|event| event.text == "cancel").unwrap();
    let last_goal = events
        .iter()
        .rposition(|event| event.text.starts_with("goal with"));
    let delay = cancel.time - time;
    assert!(delay < known_after + STOP_S + LOAD_S, "{delay}");
    assert!(
        events[last_goal.unwrap()..]
            .iter()
            .any(|event| event.text == "cancel")
    );
}

#[test]
fn a_stop_on_request_ends_the_goal_at_once() {
    let mut fake = FakeRobot::commissioned(|file| file);
    for seed in 0..repetitions() {
        if seed > 0 {
            fake = fake.restart();
        }
        let mut executor = fake.executor().unwrap();
        let (before, stop) = (fake.events().len(), Arc::clone(&executor.stop));
        let ending = std::thread::scope(|scope| {
            let fake = &fake;
            let stopped = scope.spawn(move || {
                wait_for_random_moment(fake, before, seed + 3);
                stop.store(true, Ordering::SeqCst);
                now_seconds()
            });
            let ending = execute_round(&mut executor);
            std::thread::sleep(Duration::from_millis(500));
            check_hold(&fake.events(), stopped.join().unwrap());
            ending
        });
        // On a loaded computer, the simulated robot may need more than a second to rest.
        let is_late = matches!(&ending, Ok(Ending::ProtectiveStop { cause, .. })
            if cause.to_string().contains("stopped on request; the robot has not confirmed"));
        assert!(is_late || ending == Ok(Ending::Stopped), "{ending:?}");
    }
}

fn now_seconds() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap().as_secs_f64()
}

/// An executor that is suspended, or hangs, supervises nothing: the guard stops the robot, and the executor does not go on.
/// The library for DDS does not survive a suspension, so the robot cannot confirm the stop to the executor.
#[test]
fn an_executor_that_is_suspended_leaves_no_goal_behind() {
    let mut fake = FakeRobot::commissioned(|file| file);
    for seed in 0..repetitions() {
        if seed > 0 {
            fake = fake.restart();
        }
        let mut executor = fake.executor().unwrap();
        let before = fake.events().len();
        let ending = std::thread::scope(|scope| {
            let fake = &fake;
            let suspended = scope.spawn(move || {
                wait_for_random_moment(fake, before, seed + 7);
                let suspended = signal_executor(fake, "-STOP");
                std::thread::sleep(Duration::from_millis(700));
                signal_executor(fake, "-CONT");
                suspended
            });
            let ending = execute_round(&mut executor);
            check_guard(fake, suspended.join().unwrap(), 0.5);
            ending
        });
        // On a loaded computer, wisch ends the executor before the executor has stated the ending.
        match ending {
            Ok(Ending::ProtectiveStop { cause, .. }) => {
                assert_eq!(cause.kind(), StopKind::LinkLost, "{cause}");
                assert!(cause.to_string().contains("did not run for"), "{cause}");
            }
            Err(error) => assert!(error.contains("no message for 2 s"), "{error}"),
            Ok(ending) => panic!("{ending:?}"),
        }
        let goals = |fake: &FakeRobot| {
            let events = fake.events();
            let goals = events.iter();
            goals
                .filter(|event| event.text.starts_with("goal with"))
                .count()
        };
        let begun = goals(&fake);
        assert!(execute_round(&mut executor).is_err());
        assert_eq!(goals(&fake), begun);
    }
}

/// Sends a signal to the executor's process; returns the time [s].
fn signal_executor(fake: &FakeRobot, signal: &str) -> f64 {
    let file = fake.robot_file.display().to_string();
    let is_executor = |pid: &String| {
        let line = std::fs::read(format!("/proc/{pid}/cmdline")).unwrap_or_default();
        let words: Vec<&[u8]> = line.split(|byte| *byte == 0).collect();
        words.get(1) == Some(&&b"execute"[..]) && words.contains(&file.as_bytes())
    };
    let entries = std::fs::read_dir("/proc").unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    let pid = names.into_iter().find(is_executor).unwrap();
    let status = std::process::Command::new("kill")
        .args([signal, &pid])
        .status();
    assert!(status.unwrap().success());
    now_seconds()
}

#[test]
fn a_robot_that_dies_is_a_lost_link() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &mut fake;
        scope.spawn(move || {
            fake.wait_for("goal with", before);
            std::thread::sleep(Duration::from_millis(700));
            fake.kill();
        });
        execute_round(&mut executor)
    });
    let expected = Expected {
        kind: StopKind::LinkLost,
        reason: "has not confirmed that it rests",
        known_after: SILENCE_S,
    };
    check_ending(&ending.unwrap(), &expected);
}
