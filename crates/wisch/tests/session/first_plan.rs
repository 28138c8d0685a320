//! The plan of a first round that another session has computed: it is used for equal inputs only, and not computed again.

use super::{loaded, robot};
use std::ops::ControlFlow;
use std::sync::Arc;
use wisch::geometry::Point2;
use wisch::interpret::Belief;
use wisch::plan::{CoverageStrategy, Strategy};
use wisch::represent::ParticleDistribution;
use wisch::run::{NoExecutor, Pace, RunConfig, Session, Stage, ignore_events};
use wisch_io::{LoadedTask, Robot};

fn config_of(loaded: &LoadedTask, strategy: Strategy) -> RunConfig {
    let mut config = loaded.run.clone();
    config.plan.strategy = strategy;
    config.plan.search.evaluations = 50;
    config
}

fn session<'a>(loaded: &LoadedTask, robot: &'a Robot, config: RunConfig) -> Session<'a> {
    let session = Session::new(&loaded.task, config).with_belief(loaded.belief());
    session.with_robot(robot.robot_setup())
}

/// Runs the first round up to its audit, and returns its events.
fn audit_first(session: &mut Session<'_>) -> Vec<String> {
    let mut events = Vec::new();
    let done = session.run_until(Stage::Audited, &mut NoExecutor, &mut |event| {
        events.push(format!("{event:?}"));
        ControlFlow::Continue(())
    });
    done.expect("a motion");
    events
}

#[test]
fn a_kept_plan_is_not_computed_again_and_reports_the_same_events() {
    let loaded = loaded();
    let robot = robot(&loaded);
    for strategy in [
        Strategy::Coverage(CoverageStrategy::ALL[0]),
        Strategy::Adaptive,
        Strategy::Best,
    ] {
        let config = config_of(&loaded, strategy);
        let mut planning = session(&loaded, &robot, config.clone());
        let first = planning.plan_first(&mut NoExecutor, &mut ignore_events);
        let first = first.expect("a motion");
        let kept_cell = &planning.planned_round().expect("a motion").cell;

        let mut plain = session(&loaded, &robot, config.clone());
        let plain_events = audit_first(&mut plain);
        assert!(!plain.has_used_first_plan());

        let mut using = session(&loaded, &robot, config).with_first_plan(first);
        let events = audit_first(&mut using);
        assert!(using.has_used_first_plan(), "{strategy}");
        assert_eq!(events, plain_events, "{strategy}");
        // Each computation of a motion builds a cell of its own, unless it finds that of its session.
        let cell = |session: &Session<'_>| Arc::clone(&session.planned_round().expect("one").cell);
        assert!(Arc::ptr_eq(&cell(&using), kept_cell), "{strategy}");
        assert!(!Arc::ptr_eq(&cell(&plain), kept_cell), "{strategy}");
    }
}

#[test]
fn a_kept_plan_is_not_used_for_other_inputs() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let config = config_of(&loaded, Strategy::Coverage(CoverageStrategy::ALL[0]));
    let mut planning = session(&loaded, &robot, config.clone());
    let first = planning.plan_first(&mut NoExecutor, &mut ignore_events);
    let first = first.expect("a motion");
    let is_used = |session: Session<'_>| {
        let mut session = session.with_first_plan(first.clone());
        let planned = session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events);
        planned.expect("a plan");
        session.has_used_first_plan()
    };
    assert!(is_used(session(&loaded, &robot, config.clone())));
    // What only later stages use is no input of the first plan.
    let later = RunConfig {
        max_rounds: 1,
        ..config.clone()
    };
    assert!(is_used(session(&loaded, &robot, later)));

    let mut seeded = loaded.task.clone();
    seeded.seed += 1;
    let seeded = Session::new(&seeded, config.clone()).with_belief(loaded.belief());
    assert!(!is_used(seeded.with_robot(robot.robot_setup())), "seed");
    let crumb = ParticleDistribution::new(&[Point2::new(0.01, 0.0)]).expect("a place");
    let other = session(&loaded, &robot, config.clone());
    let other = other.with_belief(Belief::from_particles(crumb));
    assert!(!is_used(other), "belief");
    let blind = Session::new(&loaded.task, config.clone()).with_belief(loaded.belief());
    assert!(!is_used(blind), "robot");
    let mut moved = config.clone();
    moved.workcell.limit_margin += 0.001;
    assert!(!is_used(session(&loaded, &robot, moved)), "workcell");
    let greedy = RunConfig {
        pace: Pace::Greedy,
        ..config.clone()
    };
    assert!(!is_used(session(&loaded, &robot, greedy)), "pace");
    let given = planning.plan().cloned();
    let given = session(&loaded, &robot, config).with_plan(given);
    assert!(!is_used(given), "a plan that the user gives");
}
