//! Execution in the simulated world: undisturbed, under disturbances, and with true dirt.

mod body;
mod curved;
mod disturbances;
mod grains;
mod humanoid;
mod two_hands;
mod wiping;

use wiping::{FORCE, faults};
pub use wiping::{Wiping, as_believed};
use wisch::control::ControlConfig;
use wisch::follow::Phase;
use wisch::geometry::Vector3;
use wisch::interpret::{Belief, Diagnosis, InterpretConfig, TouchSample, interpret};
use wisch::represent::{Action, GoalState};
use wisch::run::Ending;

#[test]
fn an_undisturbed_wipe_presses_as_required_and_stays_in_its_plane() {
    let wiping = Wiping::of_one_stroke(Action::Absorb);
    let log = wiping.execute();
    assert_eq!(faults(&log), [] as [String; 0]);
    assert_eq!(log.executed.ending, Ending::Complete);
    assert!((log.executed.duration - wiping.followed.duration()).abs() < 2e-3);
    // There are enough samples for a mean.
    assert!(log.truth.contact_force.count() > 200);
}

#[test]
fn each_fault_of_a_wipe_is_noticed() {
    let sound = Wiping::of_one_stroke(Action::Absorb);
    let found = |wiping: &Wiping, fault: &str| {
        let faults = faults(&wiping.execute());
        assert!(faults.iter().any(|f| f.contains(fault)), "{faults:?}");
    };
    let mut soft = sound.clone();
    soft.config.press_margin = 0.5;
    found(&soft, "mean contact force");

    let mut hard = sound.clone();
    hard.task.interaction.press_force_n = 1.5 * FORCE;
    found(&hard, "controller");

    let mut deep = sound.clone();
    deep.settings.believed_from_real.translation.z = -0.05;
    found(&deep, "contact is lost");

    let mut tall = sound.clone();
    tall.settings.believed_from_real.translation.z = 0.004;
    tall.task.interaction.compression_depth_m = 0.02;
    found(&tall, "from the plane");
}

#[test]
fn what_is_measured_is_where_the_joints_put_the_tool_once_per_period() {
    let wiping = Wiping::of_one_stroke(Action::Absorb);
    let log = wiping.execute();
    let robot = wiping.cell.robot();
    for (k, row) in log.rows.iter().enumerate() {
        assert!((row.time - k as f64 * wiping.config.period).abs() < 1e-9);
        if k % 100 != 0 {
            continue;
        }
        let kinematics = robot.forward_kinematics(&row.positions).unwrap();
        let root_from_tip = kinematics.world_from_link(wiping.cell.tip());
        let world_from_tool =
            wiping.cell.world_from_root() * root_from_tip * wiping.cell.tip_from_tool();
        let apart = world_from_tool.inverse() * row.world_from_tool;
        assert!(apart.translation.vector.norm() < 1e-9 && apart.rotation.angle() < 1e-7);
    }
}

#[test]
fn the_measured_force_is_that_of_pressing_and_of_friction() {
    // Coulomb friction acts against the motion along the surface. The controller limits the norm of
    // its whole force to F, so that the force against friction is missing along the normal:
    // N² + (μ N)² = F².
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    for friction in [0.2, 0.6] {
        wiping.settings.friction = friction;
        let log = wiping.execute();
        let normal: Vec<f64> = log.sliding().map(|row| row.external.z).collect();
        let along = log.sliding().map(|row| row.external.xy().norm()).collect();
        // Where the line turns back the tool sticks for a moment: most of the time it slides.
        let (normal, along) = (median(normal), median(along));
        let expected = FORCE / 1_f64.hypot(friction);
        assert!((normal - expected).abs() < 0.5, "{normal} N");
        assert!(
            (along - friction * expected).abs() < 0.5,
            "{along} N at {friction}"
        );
    }
}

#[test]
fn no_force_is_measured_without_contact() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.settings.force_bias = Vector3::zeros();
    let log = wiping.execute();
    let free = log.rows.iter().filter(|row| row.phase == Phase::FreeMotion);
    for axis in 0..3 {
        let felt = median(free.clone().map(|row| row.external[axis]).collect());
        assert!(felt.abs() < 0.02, "axis {axis}: {felt} N");
    }
}

#[test]
fn the_bias_that_is_set_is_the_one_that_is_found() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    for bias in [0.0, -1.5, 2.0] {
        wiping.settings.force_bias = Vector3::new(0.3, 0.0, bias);
        let log = wiping.execute();
        let samples: Vec<TouchSample> = (log.rows.iter())
            .map(|row| TouchSample::new(row.time, row.world_from_tool, row.external))
            .collect();
        let believed = Belief::from_particles(wiping.task.particles.clone());
        let config = InterpretConfig::from_task(&wiping.task);
        let goal = GoalState::Absorbed;
        let found = interpret(&samples, &wiping.task, &believed, &goal, &config);
        // The surface lies level: its normal is the world's z.
        let found = found.unwrap().force_bias.expect("it moves freely, too");
        assert!((found - bias).abs() < 0.05, "{found} N of {bias} N");
    }
}

#[test]
fn a_rigid_tool_wipes_and_is_understood() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.task.interaction.compression_depth_m = 0.0;
    let log = wiping.execute();
    assert_eq!(faults(&log), [] as [String; 0]);
    let samples: Vec<TouchSample> = (log.rows.iter())
        .map(|row| TouchSample::new(row.time, row.world_from_tool, row.external))
        .collect();
    let believed = Belief::from_particles(wiping.task.particles.clone());
    let config = InterpretConfig::from_task(&wiping.task);
    let goal = GoalState::Absorbed;
    let found = interpret(&samples, &wiping.task, &believed, &goal, &config).unwrap();
    assert_eq!(found.diagnosis, Diagnosis::Localized);
    assert!(found.contact_share > Some(0.8), "{:?}", found.contact_share);
}

/// Returns the time at which the force of the surface first exceeds `force` \[N\], in seconds.
fn touched(log: &wiping::Log, force: f64) -> Option<f64> {
    let first = log.rows.iter().find(|row| row.external.z > force);
    first.map(|row| row.time)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
fn the_same_seed_gives_the_same_bytes_and_another_one_other_noise() {
    let mut wiping = Wiping::of_one_stroke(Action::Skim);
    wiping.settings.force_noise = 0.3;
    let first = wiping.execute();
    assert_eq!(first.bytes(), wiping.execute().bytes());
    wiping.seed += 1;
    let other = wiping.execute();
    assert_ne!(first.bytes(), other.bytes());
    // Noise is added to the measurements, not to the world.
    assert_eq!(first.executed, other.executed);
    assert_eq!(first.truth, other.truth);
}

#[test]
fn bias_and_noise_of_the_force_are_those_of_reality() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let clean = wiping.execute();
    wiping.settings.force_bias = Vector3::new(0.5, -1.0, 2.0);
    wiping.settings.force_noise = 0.4;
    let log = wiping.execute();
    let count = log.rows.len() as f64;
    let errors = || (log.rows.iter().zip(&clean.rows)).map(|(a, b)| a.external - b.external);
    let mean = errors().sum::<Vector3>() / count;
    // Five standard errors of a mean.
    let bound = 5.0 * wiping.settings.force_noise / count.sqrt();
    for axis in 0..3 {
        let bias = wiping.settings.force_bias[axis];
        assert!((mean[axis] - bias).abs() < bound);
        let squares: f64 = errors().map(|e| (e[axis] - mean[axis]).powi(2)).sum();
        let deviation = (squares / count).sqrt();
        assert!((deviation / wiping.settings.force_noise - 1.0).abs() < 0.1);
    }
}

#[test]
fn who_takes_the_samples_may_stop_it() {
    let wiping = Wiping::of_one_stroke(Action::Absorb);
    let log = wiping.execute_until(0.5);
    assert_eq!(log.executed.ending, Ending::Stopped);
    assert!((log.executed.duration - 0.5).abs() < 2.0 * ControlConfig::default().period);
}
