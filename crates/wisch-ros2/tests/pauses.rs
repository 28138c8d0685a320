//! Pauses on request: the goal ends, nothing begins until the motion continues, and then the rest is executed.

use crate::fake::{FakeRobot, Recorded, execute_round, start_executor};
use crate::faults::{Expected, check_ending};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;
use wisch::follow::Phase;
use wisch::run::{Ending, StopKind};
use wisch_io::PauseSwitch;

/// Starts a slow executor, so that the goals last.
fn slow_executor(fake: &FakeRobot) -> Recorded {
    start_executor(&fake.robot_file, &["--speed", "0.5"]).unwrap()
}

/// Number of the first event after `after` that begins with a text; waits for it.
fn place_of(fake: &FakeRobot, text: &str, after: usize) -> usize {
    fake.wait_for(text, after);
    let events = fake.events();
    let mut later = events.iter().enumerate().skip(after);
    let found = later.find(|(_, event)| event.text.starts_with(text));
    found.unwrap().0
}

/// Asks for a pause during a goal, and returns the number of events when the goal has ended.
fn begin_pause(fake: &FakeRobot, switch: &PauseSwitch) -> usize {
    std::thread::sleep(Duration::from_millis(400));
    let before = fake.events().len();
    assert!(switch.toggle());
    place_of(fake, "goal ended as Canceled", before) + 1
}

/// Pauses for a moment, in which nothing begins or ends, and lets the motion continue.
fn pause_briefly(fake: &FakeRobot, switch: &PauseSwitch) {
    let paused = begin_pause(fake, switch);
    std::thread::sleep(Duration::from_millis(1500));
    let events = fake.events();
    assert!(events[paused..].is_empty(), "{events:#?}");
    assert!(!switch.toggle());
    fake.wait_for("goal with", paused);
}

#[test]
fn a_motion_that_pauses_continues_with_its_rest_also_in_a_stroke() {
    let fake = FakeRobot::commissioned(|file| file);
    let mut executor = slow_executor(&fake);
    let switch = Arc::clone(&executor.pause);
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &fake;
        let pauses = scope.spawn(move || {
            fake.wait_for("goal with", before);
            pause_briefly(fake, &switch);
            let pressed = place_of(fake, "force mode on", before);
            fake.wait_for("goal with", pressed);
            pause_briefly(fake, &switch);
        });
        let ending = execute_round(&mut executor);
        pauses.join().unwrap();
        ending
    });
    assert_eq!(ending, Ok(Ending::Complete));
    let phases: Vec<Phase> = executor.pauses.iter().map(|pause| pause.phase).collect();
    assert_eq!(phases.len(), 2, "{phases:?}");
    let in_stroke = [0, 1].map(|i| matches!(phases[i], Phase::Wipe(_)));
    assert_eq!(in_stroke, [false, true], "{phases:?}");
    for pause in &executor.pauses {
        let duration = pause.end.unwrap() - pause.start;
        assert!((0.8..4.0).contains(&duration), "{duration}");
        assert_eq!(pause.reason, "the operator");
    }
    // The tool pressed during the second pause: force mode went on and off once for each stroke.
    let events = fake.events();
    let is_force = |text: &str| events.iter().filter(|e| e.text.starts_with(text)).count();
    assert_eq!(is_force("force mode on"), is_force("force mode off"));
}

#[test]
fn a_robot_that_is_moved_during_a_pause_does_not_continue() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = slow_executor(&fake);
    let switch = Arc::clone(&executor.pause);
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &mut fake;
        scope.spawn(move || {
            fake.wait_for("goal with", before);
            begin_pause(fake, &switch);
            std::thread::sleep(Duration::from_millis(1500));
            fake.command("move 2 0.05");
            std::thread::sleep(Duration::from_secs(3));
            switch.toggle();
        });
        execute_round(&mut executor)
    });
    let expected = Expected {
        kind: StopKind::Operator,
        reason: "of the paused robot has moved by",
        known_after: 0.0,
    };
    check_ending(&ending.unwrap(), &expected);
}

#[test]
fn a_pause_in_a_stroke_can_be_stopped_and_then_force_mode_ends() {
    let fake = FakeRobot::commissioned(|file| file);
    let mut executor = slow_executor(&fake);
    let (switch, stop) = (Arc::clone(&executor.pause), Arc::clone(&executor.stop));
    let before = fake.events().len();
    let ending = std::thread::scope(|scope| {
        let fake = &fake;
        scope.spawn(move || {
            let pressed = place_of(fake, "force mode on", before);
            fake.wait_for("goal with", pressed);
            let paused = begin_pause(fake, &switch);
            std::thread::sleep(Duration::from_millis(1000));
            stop.store(true, Ordering::SeqCst);
            fake.wait_for("force mode off", paused);
        });
        execute_round(&mut executor)
    });
    assert_eq!(ending, Ok(Ending::Stopped));
    let events = fake.events();
    let last = events.iter().rposition(|e| e.text.starts_with("goal with"));
    let ended = events
        .iter()
        .rposition(|e| e.text.starts_with("goal ended"));
    assert!(last < ended, "{events:#?}");
}
