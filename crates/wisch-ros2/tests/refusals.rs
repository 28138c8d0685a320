//! What is refused before anything moves, with its number.

use crate::fake::{FakeRobot, execute_round};
use std::process::Command;
use std::time::Duration;

/// Starts the executor of a fake robot, and returns its error.
fn refused(fake: &FakeRobot) -> String {
    match fake.executor() {
        Err(error) => error.to_string(),
        Ok(mut executor) => execute_round(&mut executor).unwrap_err(),
    }
}

fn assert_contains(text: &str, part: &str) {
    assert!(text.contains(part), "{text}");
}

#[test]
fn a_robot_that_is_not_commissioned_or_changed_since_is_refused() {
    let mut fake = FakeRobot::start(|file| file);
    assert_contains(&refused(&fake), "push-test");
    let (is_done, text) = fake.push_test([0.0, 0.0, -20.0]);
    assert!(is_done, "{text}");
    let text = std::fs::read_to_string(&fake.robot_file).unwrap();
    std::fs::write(&fake.robot_file, format!("{text}# changed\n")).unwrap();
    assert_contains(&refused(&fake), "belongs to configuration");
    // Nothing has moved.
    assert!(
        !fake
            .events()
            .iter()
            .any(|event| event.text.starts_with("goal"))
    );
}

#[test]
fn a_push_in_another_direction_is_refused_and_a_negative_sensor_is_found() {
    let mut fake = FakeRobot::start(|file| file);
    let (is_done, text) = fake.push_test([20.0, 0.0, -20.0]);
    assert!(!is_done, "{text}");
    assert_contains(&text, "degrees off the push; the limit is 25 degrees");
    drop(fake);
    let mut fake = FakeRobot::start(|file| file);
    fake.command("sign -1");
    let (is_done, text) = fake.push_test([0.0, 0.0, -20.0]);
    assert!(is_done, "{text}");
    let written = fake.robot_file.with_extension("commissioned.toml");
    assert_contains(&std::fs::read_to_string(written).unwrap(), "sign = -1.0");
}

#[test]
fn limits_of_force_speed_and_size_are_refused_with_value_and_limit() {
    for (key, replaced, part) in [
        (
            "tool_speed_m_s = 1.5",
            "force_n = 5\ntool_speed_m_s = 1.5",
            "more than limits.force_n = 5 N",
        ),
        (
            "tool_speed_m_s = 1.5",
            "tool_speed_m_s = 0.1",
            "faster than limits.tool_speed_m_s = 0.1 m/s",
        ),
        (
            "scaling =",
            "most_bytes = 1500\nscaling =",
            "more than motion.most_bytes = 1500",
        ),
    ] {
        let fake = FakeRobot::commissioned(|file| file.replace(key, replaced));
        assert_contains(&refused(&fake), part);
        assert!(
            !fake
                .events()
                .iter()
                .any(|event| event.text.starts_with("goal"))
        );
    }
}

#[test]
fn a_robot_that_may_not_move_or_stands_elsewhere_is_refused() {
    let mut fake = FakeRobot::commissioned(|file| file);
    for (command, undo, part) in [
        ("scaling 0", "scaling 1", "the speed scaling is 0"),
        ("safety 3", "safety 1", "PROTECTIVE_STOP"),
        ("program false", "program true", "does not run"),
        ("silence joints", "speak", "/joint_states has"),
    ] {
        fake.command(command);
        std::thread::sleep(Duration::from_millis(500));
        assert_contains(&refused(&fake), part);
        fake.command(undo);
        std::thread::sleep(Duration::from_millis(200));
    }
    fake.command("move 2 0.03");
    std::thread::sleep(Duration::from_millis(800));
    let error = refused(&fake);
    assert!(
        error.contains("\"joint_3\" is 0.030 rad") && error.contains("limits.start_rad = 0.02"),
        "{error}"
    );
    assert!(
        !fake
            .events()
            .iter()
            .any(|event| event.text.starts_with("goal"))
    );
}

#[test]
fn a_second_robot_in_the_domain_is_refused() {
    let fake = FakeRobot::commissioned(|file| file);
    let mut second = Command::new(crate::fake::PROGRAM)
        .args(["fake", "arm-board", "--as"])
        .arg(&fake.robot_file)
        .stdout(std::process::Stdio::null())
        .stdin(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(4));
    let error = refused(&fake);
    let _ = second.kill();
    let _ = second.wait();
    assert_contains(&error, "2 publishers send states of these joints");
}

#[test]
fn the_doctor_names_what_would_be_refused_and_commands_nothing() {
    let fake = FakeRobot::start(|file| file);
    let doctor = |file: &std::path::Path| {
        let output = Command::new(crate::fake::PROGRAM)
            .arg("doctor")
            .arg(file)
            .output();
        let output = output.unwrap();
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        (output.status.code(), text)
    };
    let (code, text) = doctor(&fake.robot_file);
    assert_eq!(code, Some(1), "{text}");
    assert_contains(&text, "sensor_msgs/msg/JointState of RustDDS");
    assert_contains(&text, "not commissioned");
    assert_eq!(fake.events().len(), 1, "{:?}", fake.events());
}

#[test]
fn a_robot_that_is_not_there_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("robot.toml");
    let text = crate::fake::robot_file(231).replace("[motion]", "discovery_s = 1\n[motion]");
    std::fs::write(&file, text).unwrap();
    let output = Command::new(crate::fake::PROGRAM)
        .arg("doctor")
        .arg(&file)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_contains(
        &text,
        "no service /jtc/follow_joint_trajectory/_action/send_goal is found (domain 231",
    );
}
