//! Limits of the robot file, and a robot that refuses: the ending names each of them.

use crate::fake::{FakeRobot, PROGRAM, execute_round, start_executor};
use crate::faults::{Expected, check_commands, check_ending};
use std::process::{Command, Stdio};
use std::time::Duration;
use wisch::run::{Ending, StopKind};

/// Gives a command to the fake robot in its first goal, and checks ending and commands.
fn check_in_first_goal(command: &str, expected: &Expected) {
    let mut fake = FakeRobot::commissioned(|file| file);
    // A slow robot rests soon, also on a loaded computer.
    let mut executor = start_executor(&fake.robot_file, &["--speed", "0.3"]).unwrap();
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &mut fake;
        scope.spawn(move || {
            fake.wait_for("goal with", before);
            std::thread::sleep(Duration::from_millis(300));
            fake.command(command);
        });
        execute_round(&mut executor)
    });
    check_ending(&ending.unwrap(), expected);
    check_commands(&fake, expected);
}

#[test]
fn an_arm_that_is_pushed_off_its_trajectory_is_stopped() {
    // It is pushed at 0.5 rad/s.
    let expected = Expected {
        kind: StopKind::Tolerance,
        reason: "from its setpoint, more than limits.lag_m = 0.08 m",
        known_after: 0.5,
    };
    check_in_first_goal("move 1 0.25", &expected);
}

#[test]
fn a_motion_without_progress_is_stopped() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    fake.command("scaling 0.00001");
    let ending = execute_round(&mut executor);
    let expected = Expected {
        kind: StopKind::Tolerance,
        reason: "the motion has made no progress for 5.",
        known_after: 0.0,
    };
    check_ending(&ending.unwrap(), &expected);
    let begun = fake.wait_for("goal with", 0);
    let ended = fake.wait_for("goal ended as Canceled", 0);
    assert!(ended.time - begun.time < 6.0);
}

#[test]
fn a_pressing_tool_that_leaves_the_believed_surface_is_stopped() {
    // The sponge yields by more than a millimetre.
    let change = |file: String| file.replace("lag_m =", "depth_m = 0.001\nlag_m =");
    let fake = FakeRobot::commissioned(change);
    let ending = execute_round(&mut fake.executor().unwrap());
    let expected = Expected {
        kind: StopKind::Tolerance,
        reason: "more than limits.depth_m = 0.001 m from it",
        known_after: 0.0,
    };
    check_ending(&ending.unwrap(), &expected);
    fake.wait_for("force mode off", 0);
}

#[test]
fn after_a_stop_nothing_moves_unless_an_operator_permits_it() {
    let mut fake = FakeRobot::commissioned(|file| file);
    for options in [&[][..], &["--operated"]] {
        let mut executor = start_executor(&fake.robot_file, options).unwrap();
        fake.command("reject true");
        let ending = execute_round(&mut executor);
        let expected = Expected {
            kind: StopKind::ProtectiveStop,
            reason: "the controller rejects the goal",
            known_after: 0.0,
        };
        check_ending(&ending.unwrap(), &expected);
        assert!(
            !fake
                .events()
                .iter()
                .any(|event| event.text.starts_with("goal with"))
        );
        fake.command("reject false");
        std::thread::sleep(Duration::from_millis(200));
        let next = execute_round(&mut executor);
        if options.is_empty() {
            let error = next.unwrap_err();
            assert!(error.contains("nothing moves after a stop"), "{error}");
        } else {
            assert_eq!(next, Ok(Ending::Complete));
        }
    }
}

#[test]
fn a_robot_without_force_needs_no_push_test_and_gets_no_force_mode() {
    let fake = FakeRobot::start(|file| {
        let file = file.replace("\"ur_force_mode\"", "\"none\"");
        let lines = file.lines().filter(|line| !line.starts_with("topic"));
        let kept: Vec<&str> = lines.filter(|line| !line.starts_with("tare")).collect();
        kept.join("\n")
    });
    let ending = execute_round(&mut fake.executor().unwrap());
    assert_eq!(ending, Ok(Ending::Complete));
    let events = fake.events();
    let is_force = |text: &str| text.starts_with("force") || text.starts_with("tare");
    assert!(
        !events.iter().any(|event| is_force(&event.text)),
        "{events:#?}"
    );
}

/// Runs a program for 3 s, gives the fake robot a command, and returns what the program says.
fn output_with(fake: &mut FakeRobot, words: &[&str], command: &str) -> String {
    let program = Command::new(PROGRAM)
        .arg(words[0])
        .arg(&fake.robot_file)
        .args(&words[1..])
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(3));
    fake.command(command);
    let output = program.wait_with_output().unwrap();
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// On a loaded computer, the limit may be exceeded before the silence: the text is the same.
#[test]
fn the_default_limits_of_age_are_20_ms_for_the_wrench_and_50_ms_for_states() {
    for (topic, command, limit) in [
        ("/ft_data", "silence wrench", "the limit is 20 ms"),
        ("/joint_states", "silence joints", "the limit is 50 ms"),
    ] {
        let mut fake = FakeRobot::start(|file| {
            let line = if topic == "/ft_data" {
                "state_age_ms = 500"
            } else {
                "wrench_age_ms = 500"
            };
            let lines = file.lines().filter(|line| !line.contains("_age_ms"));
            let kept: Vec<&str> = lines.collect();
            kept.join("\n")
                .replace("[limits]", &format!("[limits]\n{line}"))
        });
        let text = output_with(&mut fake, &["push-test", "--yes"], command);
        assert!(text.contains(topic) && text.contains(limit), "{text}");
    }
}
