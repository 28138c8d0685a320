//! Shipped scenarios that treat a surface or hover over it, executed: estimates against the ground
//! truth.

use std::ops::ControlFlow;
use wisch::interpret::Doubt;
use wisch::recover::Verdict;
use wisch::represent::Treatment;
use wisch::run::{Round, RunConfig, Session};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{GroundTruth, WorkSurface, World};
use wisch_testkit::{humanoid, run_config, scenario};

/// The first round of a scenario, its ground truth, and the true performance [1].
fn first_round(name: &str, settings: &[(&str, &str)]) -> (LoadedTask, Round, GroundTruth, f64) {
    let given = settings.iter();
    let options = LoadOptions {
        seed: Some(1),
        settings: given
            .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
            .collect(),
        ..LoadOptions::default()
    };
    let loaded = load_task(&scenario(name), &options).unwrap();
    let settings = loaded.simulation.clone();
    let mut world = World::new(&WorkSurface::from_task(&loaded.task), settings, 1).unwrap();
    let robot = humanoid();
    let config = RunConfig {
        max_rounds: 1,
        ..run_config(&loaded)
    };
    let mut session = (Session::new(&loaded.task, config))
        .with_belief(loaded.belief())
        .with_robot(robot.robot_setup());
    session
        .run(&mut world, &mut |_| ControlFlow::Continue(()))
        .unwrap();
    let round = session.into_rounds().remove(0);
    assert!(round.audit.is_sound());
    let truth = world.truth()[0].clone();
    let goal = &round.motion.plan.graph.goal;
    let performance = truth.performance(goal, &round.motion.task.surface);
    let performance = performance.unwrap().unwrap();
    (loaded, round, truth, performance)
}

#[test]
fn a_plate_is_polished_and_touch_knows_it() {
    let (loaded, round, truth, performance) = first_round("polish-plate", &[]);
    assert!(performance >= 0.99, "{performance}");
    assert_eq!(round.verdict, Verdict::GoalMet);
    let task = &loaded.task;
    let shortest = 0.50 * 0.31 / task.tool.area_of_effect.y * 2.0;
    let way = round.motion.plan.contact_distance() / shortest;
    assert!(way <= 1.3, "{way}");
    // By Preston's law with the press force of the task.
    let per_pass = task.depth_per_pass();
    let [mean, _] = Treatment::spread(&truth.dirt.particles().unwrap());
    let expected = mean * per_pass.unwrap();
    let wear = truth.dirt.mean_wear();
    assert!(
        (wear / expected - 1.0).abs() < 0.15,
        "{wear} m, {expected} m"
    );
}

#[test]
fn a_pad_that_is_hardly_pressed_polishes_little() {
    // Most points need a higher pressure than the pad exerts.
    let hard = [("execution.mu", "0.5"), ("execution.sigma", "0.2")];
    let (_, _, _, performance) = first_round("polish-plate", &hard);
    assert!(performance < 0.5, "{performance}");
}

#[test]
fn a_pad_on_a_plate_that_lies_deeper_is_known_to_be_pressed_less() {
    let lower = [("execution.surface_shift_m", "[0.0, 0.0, -0.015]")];
    let (_, round, _, performance) = first_round("polish-plate", &lower);
    let interpretation = &round.interpretation;
    let pressed = interpretation.pressed_force.unwrap();
    assert!((4.0..6.0).contains(&pressed), "{pressed}");
    assert!(
        matches!(interpretation.doubts[..], [Doubt::PressForceDiffers { .. }]),
        "{:?}",
        interpretation.doubts
    );
    let estimate = interpretation.performance;
    assert!(
        (estimate.low..=estimate.high).contains(&performance),
        "{performance} of {estimate:?}"
    );
}

#[test]
fn a_panel_is_painted_evenly_and_touch_knows_it() {
    let (_, round, truth, performance) = first_round("paint-panel", &[]);
    assert!(performance >= 0.95, "{performance}");
    assert_eq!(round.verdict, Verdict::GoalMet);
    let [mean, deviation] = Treatment::spread(&truth.dirt.particles().unwrap());
    assert!(
        (mean - 1.0).abs() < 0.05 && deviation < 0.15,
        "{mean} {deviation}"
    );
    assert_eq!(truth.dirt.mean_wear(), 0.0);
}

#[test]
fn a_nozzle_that_hovers_takes_sand_up_without_a_touch() {
    let (_, round, truth, performance) = first_round("vacuum-panel", &[]);
    assert!(performance >= 0.8, "{performance}");
    // The weight of the nozzle's plate on its springs is no contact force.
    assert!(truth.contact_force.mean() < 0.01);
    assert!(round.interpretation.plane.is_none());
    let estimate = round.interpretation.performance;
    assert!((estimate.low..=estimate.high).contains(&performance));
    // At three times the believed gap, it takes up less, and the force does not show that.
    let lower = [("execution.surface_shift_m", "[0.0, 0.0, -0.006]")];
    let (_, round, _, less) = first_round("vacuum-panel", &lower);
    assert!(less < performance - 0.2, "{less}");
    assert_ne!(round.verdict, Verdict::GoalMet);
}
