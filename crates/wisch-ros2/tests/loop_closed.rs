//! The fake robot closes the loop: its runs come to the results of the built-in simulation.

use crate::fake::{ARM_BOARD, CHOPPING_BOARD, FIVE, FakeRobot, Scenario, execute_round, task};
use std::sync::Arc;
use std::time::{Duration, Instant};
use wisch::interpret::WrenchQuality;
use wisch::run::{Ending, Executor, RunEvent, Stage};
use wisch_sim::{WorkSurface, World};

/// What a run comes to.
struct RunResult {
    rounds: usize,
    verdict: String,
    /// Estimated performance [1].
    estimate: f64,
}

fn run(scenario: &Scenario, executor: &mut dyn Executor) -> Result<RunResult, String> {
    let loaded = task(scenario);
    let robot = loaded.robot().unwrap().unwrap();
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let ran = session.run(executor, &mut |_| std::ops::ControlFlow::Continue(()));
    ran.map_err(|error| error.to_string())?;
    let last = session.rounds().last().unwrap();
    Ok(RunResult {
        rounds: session.rounds().len(),
        verdict: last.verdict.as_str().to_owned(),
        estimate: last.interpretation.performance.mean,
    })
}

/// Runs a scenario in the built-in simulation and on the fake robot.
fn run_both(scenario: &Scenario) -> ([RunResult; 2], FakeRobot) {
    let loaded = task(scenario);
    let settings = loaded.simulation.clone();
    let surface = WorkSurface::from_task(&loaded.task);
    let mut world = World::new(&surface, settings, loaded.task.seed).unwrap();
    let built_in = run(scenario, &mut world).unwrap();
    let fake = FakeRobot::commissioned_for(scenario, |file| file);
    let mut executor = fake.executor().unwrap();
    let live = run(scenario, &mut executor).unwrap_or_else(|error| RunResult {
        rounds: executor.endings.len(),
        verdict: executor.error.clone().unwrap_or(error),
        estimate: f64::NAN,
    });
    ([built_in, live], fake)
}

/// Prints a table of both. It takes a quarter of an hour.
#[test]
#[ignore = "takes a quarter of an hour; an evaluation"]
fn five_scenarios_have_the_verdicts_and_estimates_of_the_built_in_runs() {
    println!("| scenario | built-in simulation | `robot fake` | difference |");
    println!("|---|---|---|---|");
    let mut deviations = Vec::new();
    for scenario in &FIVE {
        let ([built_in, live], _fake) = run_both(scenario);
        let cell = |result: &RunResult| {
            let RunResult {
                rounds,
                verdict,
                estimate,
            } = result;
            format!("{rounds} rounds, {verdict}, {:.1} %", 100.0 * estimate)
        };
        let points = 100.0 * (live.estimate - built_in.estimate);
        let (name, cells) = (scenario.name, [cell(&built_in), cell(&live)]);
        println!("| {name} | {} | {} | {points:.1} |", cells[0], cells[1]);
        if built_in.verdict != live.verdict || points.is_nan() || points.abs() >= 1.0 {
            deviations.push(name);
        }
    }
    assert_eq!(deviations, [""; 0]);
}

#[test]
fn a_run_on_the_fake_robot_has_the_verdict_and_estimate_of_the_built_in_run() {
    let ([built_in, live], fake) = run_both(&CHOPPING_BOARD);
    let shown = |result: &RunResult| {
        let RunResult {
            rounds,
            verdict,
            estimate,
        } = result;
        format!("{rounds} rounds, {verdict}, {estimate}")
    };
    let results = [&live, &built_in].map(shown);
    assert_eq!(live.verdict, built_in.verdict, "{results:?}");
    let difference = (live.estimate - built_in.estimate).abs();
    assert!(
        difference < 0.01,
        "{} and {}",
        live.estimate,
        built_in.estimate
    );
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
    let untared = |quality: &WrenchQuality| *quality == WrenchQuality::Untared;
    assert!(executor.qualities.len() > 100 && executor.qualities.iter().all(untared));
}

#[test]
fn the_force_is_stated_as_untared_until_the_tare_of_each_motion() {
    let fake = FakeRobot::commissioned(|file| file);
    let mut executor = fake.executor().unwrap();
    for round in 1..=2 {
        assert_eq!(execute_round(&mut executor), Ok(Ending::Complete));
        let mut kinds = std::mem::take(&mut executor.qualities);
        // On a loaded computer, a wrench may come late.
        kinds.retain(|quality| *quality != WrenchQuality::Stale);
        kinds.dedup();
        let expected = [WrenchQuality::Untared, WrenchQuality::Ok];
        assert_eq!(kinds, expected, "round {round}");
    }
}

#[test]
fn controllers_that_a_run_activates_are_inactive_after_it() {
    let fake = FakeRobot::commissioned(|file| file);
    let before = fake.events().len();
    let options = ["--air", "--speed", "0.9"];
    let mut executor = crate::fake::start_executor(&fake.robot_file, &options).unwrap();
    assert_eq!(execute_round(&mut executor), Ok(Ending::Complete));
    executor.finish().unwrap();
    let events = fake.events();
    let place = |text: &str| {
        let found = events[before..].iter();
        let places = found
            .enumerate()
            .filter(|(_, event)| event.text.starts_with(text));
        places.map(|(place, _)| place).collect::<Vec<usize>>()
    };
    let controllers = "jtc force_mode_controller";
    let activated = place(&format!("activate {controllers}"));
    let deactivated = place(&format!("deactivate {controllers}"));
    let goals = [place("goal with"), place("goal ended")];
    assert_eq!([activated.len(), deactivated.len()], [1, 1], "{events:#?}");
    assert!(activated[0] < goals[0][0] && goals[1].last() < deactivated.last());
}

#[test]
fn controllers_that_cannot_be_handed_back_are_an_error() {
    let mut fake = FakeRobot::commissioned(|file| file);
    let mut executor = crate::fake::start_executor(&fake.robot_file, &["--air"]).unwrap();
    let loaded = task(&ARM_BOARD);
    let robot = loaded.robot().unwrap().unwrap();
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let observer = &mut |_: &RunEvent<'_>| std::ops::ControlFlow::Continue(());
    session
        .run_until(Stage::Audited, &mut executor, observer)
        .unwrap();
    let cell = Arc::clone(&session.planned_round().unwrap().cell);
    executor.prepare(&cell).unwrap();
    fake.kill();
    let begin = Instant::now();
    let error = executor.finish().unwrap_err().to_string();
    assert!(error.contains("/controller_manager"), "{error}");
    let names = "stay active: jtc, force_mode_controller.";
    assert!(error.contains(names), "{error}");
    // After an error, wisch waits for 2 s.
    let elapsed = begin.elapsed();
    assert!(elapsed < Duration::from_secs(2), "{elapsed:?}");
}
