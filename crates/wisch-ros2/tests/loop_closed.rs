//! The fake robot closes the loop: its runs come to the results of the built-in simulation.

use crate::fake::{CHOPPING_BOARD, FakeRobot, Scenario, execute_round, task};
use wisch::run::{Ending, Executor, Session};
use wisch_sim::{WorkSurface, World};

/// Verdict and estimated performance of a run.
fn result(session: &Session<'_>) -> (String, f64) {
    let last = session.rounds().last().unwrap();
    let estimate = last.interpretation.performance.mean;
    (last.verdict.as_str().to_owned(), estimate)
}

fn run(scenario: &Scenario, executor: &mut dyn Executor) -> (String, f64) {
    let loaded = task(scenario);
    let robot = loaded.robot().unwrap().unwrap();
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let ran = session.run(executor, &mut |_| std::ops::ControlFlow::Continue(()));
    ran.unwrap();
    result(&session)
}

#[test]
fn a_run_on_the_fake_robot_has_the_verdict_and_estimate_of_the_built_in_run() {
    let loaded = task(&CHOPPING_BOARD);
    let settings = loaded.simulation.clone();
    let surface = WorkSurface::from_task(&loaded.task);
    let mut world = World::new(&surface, settings, loaded.task.seed).unwrap();
    let (verdict, estimate) = run(&CHOPPING_BOARD, &mut world);

    let fake = FakeRobot::commissioned_for(&CHOPPING_BOARD, |file| file);
    let (live_verdict, live_estimate) = run(&CHOPPING_BOARD, &mut fake.executor().unwrap());
    assert_eq!(live_verdict, verdict);
    let difference = (live_estimate - estimate).abs();
    assert!(difference < 0.01, "{live_estimate} and {estimate}");
    // Force is on in strokes only, and off at the end.
    let forces: Vec<bool> = (fake.events().iter())
        .filter(|event| event.text.starts_with("force mode"))
        .map(|event| event.text.contains(" on"))
        .collect();
    assert!(
        forces.len() >= 4 && forces.len().is_multiple_of(2),
        "{forces:?}"
    );
    assert!(
        forces.iter().enumerate().all(|(i, on)| *on == (i % 2 == 0)),
        "{forces:?}"
    );
}

#[test]
fn shuffled_joints_and_a_slow_controller_change_nothing_but_the_time() {
    let mut fake = FakeRobot::commissioned(|file| file);
    fake.command("shuffle");
    fake.command("scaling 0.3");
    let mut executor = fake.executor().unwrap();
    assert_eq!(execute_round(&mut executor), Ok(Ending::Complete));
}

#[test]
fn in_the_air_there_is_no_force_mode_and_no_tare() {
    let fake = FakeRobot::commissioned(|file| file);
    let before = fake.events().len();
    let options = ["--air", "--speed", "0.9"];
    let mut executor = crate::fake::start_executor(&fake.robot_file, &options).unwrap();
    assert_eq!(execute_round(&mut executor), Ok(Ending::Complete));
    let events = fake.events();
    let texts: Vec<&str> = events[before..]
        .iter()
        .map(|event| event.text.as_str())
        .collect();
    assert!(
        texts.iter().any(|text| text.starts_with("goal with")),
        "{texts:?}"
    );
    let forbidden = |text: &&&str| text.starts_with("force") || text.starts_with("tare");
    assert_eq!(texts.iter().find(forbidden), None);
}
