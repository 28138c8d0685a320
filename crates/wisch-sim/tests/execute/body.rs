//! The world's own body: tool, grasp, joints, sensors and surface that are not what the robot believes. Each test fails
//! when its key has no effect.

use super::wiping::{FORCE, Log, Wiping};
use super::{median, touched};
use wisch::follow::Phase;
use wisch::geometry::{Vector2, Vector3};
use wisch::represent::{Action, Fate};
use wisch_sim::{Dirt, Moment, Push, Waviness};
use wisch_testkit::block;

fn dirty(action: Action) -> Wiping {
    let mut wiping = Wiping::of_one_stroke(action);
    wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
    wiping
}

/// Which grains the tool took up.
fn absorbed(log: &Log) -> Vec<bool> {
    let grains = log.truth.dirt.grains().iter();
    grains.map(|grain| grain.fate == Fate::Absorbed).collect()
}

/// Height of the measured tool centre point over the plane while it slides [m].
fn height(log: &Log, wiping: &Wiping) -> f64 {
    let surface_from_world = wiping.task.surface.world_from_surface.inverse();
    let heights = log
        .sliding()
        .map(|row| (surface_from_world * row.world_from_tool).translation.z);
    median(heights.collect())
}

#[test]
fn a_softer_tool_gives_way_further_and_presses_as_hard() {
    let mut wiping = dirty(Action::Absorb);
    let believed = wiping.execute();
    let depth = wiping.task.interaction.compression_depth_m;
    wiping.settings.tool.stiffness = 0.5;
    let soft = wiping.execute();
    let sunk = height(&believed, &wiping) - height(&soft, &wiping);
    assert!((sunk - depth).abs() < 1e-3, "{sunk} m");
    assert!((soft.truth.contact_force.mean() - FORCE).abs() < 1.0);
    // The same force over the same area is the same pressure.
    assert_eq!(absorbed(&soft), absorbed(&believed));
}

#[test]
fn a_larger_footprint_wipes_more_and_presses_less_on_each_grain() {
    let mut wiping = dirty(Action::Absorb);
    let mut count = |footprint: f64, threshold: f64| {
        wiping.settings.tool.footprint = footprint;
        wiping.settings.likelihood.mu = threshold.ln();
        wiping.settings.likelihood.sigma = 1e-3;
        wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
        let taken = absorbed(&wiping.execute());
        taken.into_iter().filter(|is| *is).count()
    };
    let [small, middle, believed] = [0.6, 0.8, 1.0].map(|size| count(size, 0.05));
    assert!(
        small < middle && middle < believed,
        "{small} {middle} {believed}"
    );
    // At 1.4 times the length and width the pressure is half of the nominal one.
    assert!(count(1.0, 0.7) > 2);
    assert_eq!(count(1.4, 0.7), 0);
}

#[test]
fn a_tool_that_slipped_in_the_hand_wipes_elsewhere_and_the_joints_do_not_tell() {
    let mut wiping = dirty(Action::Absorb);
    // One that does not reach every grain.
    wiping.settings.tool.footprint = 0.6;
    let centred = wiping.execute();
    wiping.settings.tool.grasp_offset = Vector2::new(0.0, 0.02);
    let slipped = wiping.execute();
    assert_ne!(absorbed(&slipped), absorbed(&centred));
    assert!((slipped.truth.max_lateral_error - 0.02).abs() < 0.008);
    let rows = slipped.rows.iter().zip(&centred.rows);
    let apart = rows.map(|(a, b)| {
        (a.world_from_tool.translation.vector - b.world_from_tool.translation.vector).norm()
    });
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < 0.008, "{apart} m");
}

#[test]
fn a_tool_that_is_turned_in_the_hand_wipes_elsewhere() {
    let mut wiping = dirty(Action::Skim);
    let places = |log: &Log| -> Vec<_> {
        let grains = log.truth.dirt.grains().iter();
        grains.map(|grain| grain.position).collect()
    };
    let believed = places(&wiping.execute());
    wiping.settings.tool.grasp_turn = 0.4;
    let turned = places(&wiping.execute());
    let apart = believed.iter().zip(&turned).map(|(a, b)| (a - b).norm());
    assert!(apart.fold(0.0, f64::max) > 0.01);
}

#[test]
fn encoders_are_as_noisy_as_set() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.settings.sensing.encoder_noise = 1e-3;
    let log = wiping.execute();
    let joint = wiping.cell.ik().chain().variables()[0];
    let positions: Vec<f64> = log.rows.iter().map(|row| row.positions[joint]).collect();
    // Of second differences, to which motion adds next to nothing, the variance is six times that of the noise.
    let jitter = positions.windows(3).map(|q| q[2] - 2.0 * q[1] + q[0]);
    let variance = jitter.map(|d| d * d).sum::<f64>() / (positions.len() - 2) as f64;
    let noise = (variance / 6.0).sqrt();
    assert!((noise - 1e-3).abs() < 1e-4, "{noise} rad");
    // What is measured of the tool is what these joints say.
    let heights: Vec<f64> = (log.rows.iter())
        .map(|row| row.world_from_tool.translation.z)
        .collect();
    let jitter = heights.windows(3).map(|z| (z[2] - 2.0 * z[1] + z[0]).abs());
    assert!(median(jitter.collect()) > 1e-4);
}

#[test]
fn play_in_the_joints_leads_the_tool_astray() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let exact = wiping.execute().truth.max_lateral_error;
    wiping.settings.sensing.backlash = 0.02;
    let loose = wiping.execute().truth.max_lateral_error;
    // Half of the play on a lever of a tenth of a metre.
    assert!(loose > exact + 1e-3, "{exact} m, {loose} m");
}

#[test]
fn a_late_sensor_feels_the_surface_late() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let begins = |log: &Log| touched(log, 0.5 * FORCE).expect("it is touched");
    let prompt = begins(&wiping.execute());
    wiping.settings.sensing.force_delay = 0.1;
    let late = begins(&wiping.execute());
    assert!((late - prompt - 0.1).abs() < 2e-3, "{prompt} s, {late} s");
}

#[test]
fn a_sensor_drifts_as_set() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let still = wiping.execute();
    wiping.settings.sensing.force_drift = Vector3::new(0.0, 0.1, -0.2);
    let drifting = wiping.execute();
    for (a, b) in drifting.rows.iter().zip(&still.rows) {
        let drift = wiping.settings.sensing.force_drift * a.time;
        assert!((a.external - b.external - drift).norm() < 1e-9);
    }
}

#[test]
fn friction_in_the_joints_is_measured_as_a_force() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let felt = |log: &Log| {
        let free = log.rows.iter().filter(|row| row.phase == Phase::FreeMotion);
        median(free.map(|row| row.external.norm()).collect())
    };
    let without = felt(&wiping.execute());
    wiping.settings.joint_friction = 1.0;
    let log = wiping.execute();
    log.assert_finite();
    let with = felt(&log);
    assert!(without < 0.1 && with > 0.5, "{without} N, {with} N");
}

#[test]
fn no_drive_gives_more_than_its_limit() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.task.interaction.press_force_n = 200.0;
    wiping.settings.pushes = vec![Push {
        round: 1,
        start: Moment::Seconds(wiping.midst()),
        duration: 0.5,
        force: Vector3::new(0.0, 900.0, 300.0),
        hand_speed: 5.0,
    }];
    let log = wiping.execute();
    log.assert_finite();
    let robot = wiping.cell.robot();
    let mut reached = 0;
    for &variable in wiping.cell.ik().chain().variables() {
        let most = robot.variable(variable).limits.effort.unwrap();
        let given = log.rows.iter().map(|row| row.efforts[variable].abs());
        let given = given.fold(0.0, f64::max);
        assert!(given <= most, "{given} Nm of {most} Nm");
        reached += usize::from(given == most);
    }
    assert!(reached > 0);
}

#[test]
fn waves_in_the_surface_are_measured() {
    let mut wiping = dirty(Action::Absorb);
    let flat = wiping.execute();
    wiping.settings.waviness = Waviness {
        height: 0.004,
        length: 0.1,
    };
    let wavy = wiping.execute();
    wavy.assert_finite();
    let heights = |log: &Log| {
        let z: Vec<f64> = (log.sliding())
            .map(|row| row.world_from_tool.translation.z)
            .collect();
        let span = |pick: fn(f64, f64) -> f64| z.iter().copied().reduce(pick).unwrap();
        span(f64::max) - span(f64::min)
    };
    let (flat, wavy) = (heights(&flat), heights(&wavy));
    assert!(flat < 1e-3 && wavy > 1.5e-3, "{flat} m, {wavy} m");
    assert!(wavy < 5e-3, "{wavy} m");
}

#[test]
fn pressure_is_less_in_the_valleys_of_a_surface() {
    let mut wiping = dirty(Action::Absorb);
    let count = |log: &Log| absorbed(log).iter().filter(|is| **is).count();
    wiping.settings.likelihood.mu = 0.6_f64.ln();
    wiping.settings.likelihood.sigma = 1e-3;
    wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
    let flat = count(&wiping.execute());
    // Waves that are shorter than the tool: it bridges them.
    wiping.settings.waviness = Waviness {
        height: 0.005,
        length: 0.03,
    };
    let wavy = count(&wiping.execute());
    assert!(wavy < flat, "{wavy} of {flat}");
}

#[test]
fn a_heap_resists_the_tool_that_pushes_it() {
    let mut wiping = dirty(Action::Skim);
    // The tool itself slides without friction.
    wiping.settings.friction = 0.0;
    let along = |log: &Log| {
        let felt = log.sliding().map(|row| row.external.xy().norm());
        felt.fold(0.0, f64::max)
    };
    let light = wiping.execute();
    wiping.settings.grain_mass = Some(0.05);
    let heavy = wiping.execute();
    let pushed = (heavy.truth.dirt.grains().iter().zip(wiping.dirt.grains()))
        .filter(|(after, before)| (after.position - before.position).norm() > 0.02)
        .count();
    assert!(pushed > 0);
    // Each grain stands for 0.05 kg of dirt with a friction of 0.8: 0.4 N.
    let (light, heavy) = (along(&light), along(&heavy));
    assert!(heavy > light + 0.3, "{light} N, {heavy} N, {pushed} pushed");
    let weight = 0.8 * 0.05 * 9.81 * wiping.dirt.grains().len() as f64;
    assert!(heavy < light + weight, "{light} N, {heavy} N");
    wiping.settings.grains_resist = false;
    let unfelt = along(&wiping.execute());
    assert!(unfelt < light + 0.05, "{unfelt} N, {light} N");
}

#[test]
fn what_robot_and_tool_strike_is_known() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let free = wiping.execute();
    assert_eq!(free.truth.obstructions, [] as [[f64; 2]; 0]);
    let midst = wiping.midst();
    let row = free.rows.iter().find(|row| row.time >= midst).unwrap();
    let at = row.world_from_tool.translation;
    // Put there after the motion was planned.
    let cup = block("cup", [0.02, 0.02, 0.08], [at.x, at.y, at.z + 0.06]);
    wiping.task.scene.push(cup);
    let struck = wiping.execute().truth.obstructions;
    let first = struck.first().expect("it is struck");
    assert!(
        first[0] < midst && first[0] > 0.5 * midst,
        "{struck:?}, {midst} s"
    );
}
