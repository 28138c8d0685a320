//! Pushes, things in the way, a surface that is not where it is believed.

use super::wiping::{FORCE, Wiping, controller_faults};
use nalgebra::UnitQuaternion;
use wisch::geometry::Vector3;
use wisch::represent::{Action, ScenePart};
use wisch::run::{Ending, StopCause};
use wisch_sim::{FrictionChange, Moment, Push};
use wisch_testkit::block;

/// What a person who pushes with 40 N may meet at most [N].
const RESISTANCE: f64 = 13.0;

/// Whoever pushes against more than he should.
fn pushed(force: Vector3, hand_speed: f64) -> Wiping {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.settings.pushes = vec![Push {
        round: 1,
        start: Moment::Seconds(wiping.midst()),
        duration: 0.6,
        force,
        hand_speed,
    }];
    wiping
}

#[test]
fn a_push_leads_the_arm_away_and_meets_no_more_than_the_task_needs() {
    let calm = Wiping::of_one_stroke(Action::Absorb).execute();
    for direction in [Vector3::x(), -Vector3::y(), Vector3::z()] {
        let wiping = pushed(40.0 * direction, 0.2);
        let log = wiping.execute();
        log.assert_finite();
        assert_eq!(controller_faults(&log), [] as [String; 0]);
        assert!(log.truth.max_controller_force < RESISTANCE);
        // At 10 N against it the hand still moves at 3/4 of its speed.
        let yielded = (log.rows.iter().zip(&calm.rows)).map(|(pushed, calm)| {
            let places = [pushed, calm].map(|row| row.world_from_tool.translation.vector);
            (places[0] - places[1]).dot(&direction)
        });
        let yielded = yielded.fold(0.0, f64::max);
        assert!(yielded > 0.02, "{yielded} m along {direction}");
        if !log.is_stopped() {
            let last = log.rows.last().unwrap();
            let told = last.world_from_commanded.translation.vector;
            let apart = (told - last.world_from_tool.translation.vector).norm();
            assert!(apart < 0.03, "{apart} m after a push along {direction}");
        }
    }
}

#[test]
fn an_arm_that_resists_is_noticed() {
    let mut wiping = pushed(Vector3::new(0.0, 0.0, 40.0), 0.2);
    wiping.task.interaction.press_force_n = 3.0 * FORCE;
    let log = wiping.execute();
    assert!(!controller_faults(&log).is_empty());
    assert!(log.truth.max_controller_force > RESISTANCE);
}

#[test]
fn a_hand_that_takes_weight_off_the_tool_is_measured_together_with_the_surface() {
    // Lifted with less than the controller presses with, the tool stays on the surface: hand and surface
    // together stand against the controller's force, and that is all that the joints can tell.
    let log = pushed(Vector3::new(0.0, 0.0, 8.0), 1e3).execute();
    let felt = |from: f64, to: f64| {
        let rows: Vec<_> = (log.rows.iter())
            .filter(|row| (from..to).contains(&row.time))
            .collect();
        rows.iter().map(|row| row.external.z).sum::<f64>() / rows.len() as f64
    };
    let start = Wiping::of_one_stroke(Action::Absorb).midst();
    assert!((felt(start + 0.3, start + 0.6) - FORCE).abs() < 1.0);
}

#[test]
fn an_absurd_push_ends_in_a_protective_stop() {
    for direction in [Vector3::x(), Vector3::y(), Vector3::z(), -Vector3::z()] {
        let log = pushed(5000.0 * direction, 50.0).execute();
        log.assert_finite();
        assert!(
            log.is_stopped(),
            "{:?} along {direction}",
            log.executed.ending
        );
    }
}

#[test]
fn a_thing_in_the_way_that_nobody_knows_of_holds_the_tool_but_breaks_nothing() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let motion = wiping
        .followed
        .motions
        .iter()
        .find(|m| m.phase.is_contact());
    let end = motion.unwrap().tool_line.last().unwrap().surface_from_tool;
    let at = wiping.task.surface.world_from_surface
        * wisch::geometry::Point3::new(end.position.x, end.position.y, 0.05);
    let thing = block("thing", [0.04, 0.04, 0.1], [at.x, at.y, at.z]);
    assert_eq!(thing.part, ScenePart::Obstacle);
    wiping.task.scene.push(thing);
    let log = wiping.execute();
    log.assert_finite();
    assert_eq!(controller_faults(&log), [] as [String; 0]);
    assert!(log.is_stopped() || log.furthest() > 0.01, "it went through");
}

#[test]
fn the_stops_say_why() {
    let log = pushed(Vector3::new(0.0, 0.0, 5000.0), 50.0).execute();
    let Ending::ProtectiveStop { time, cause } = &log.executed.ending else {
        panic!("it went on");
    };
    assert!(*time >= log.rows.last().unwrap().time);
    match cause {
        StopCause::Astray { distance, limit } => assert!(distance > limit),
        StopCause::Overspeed {
            velocity, limit, ..
        } => assert!(velocity.abs() > *limit),
        StopCause::Overshoot {
            position, limits, ..
        } => assert!(!(limits.lower..=limits.upper).contains(position)),
        StopCause::Reported { reason, .. } => panic!("the simulated robot says nothing: {reason}"),
    }
    assert!(!cause.to_string().is_empty());
}

#[test]
fn a_tilted_surface_is_wiped_as_far_as_the_spring_reaches() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let tilt = Vector3::new(2_f64.to_radians(), 0.0, 0.0);
    wiping.settings.believed_from_real.rotation = UnitQuaternion::from_scaled_axis(tilt);
    let truth = wiping.execute().truth;
    assert_eq!(truth.lost_share, 0.0);
    assert!((truth.contact_force.mean() - FORCE).abs() < 2.5);
}

#[test]
fn friction_changes_when_reality_says_so() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    wiping.settings.friction = 0.1;
    let (change, round) = (wiping.midst(), 1);
    wiping.settings.friction_changes = vec![FrictionChange {
        round,
        start: Moment::Seconds(change),
        friction: 0.8,
    }];
    let log = wiping.execute();
    let mean = |is_after: bool| {
        let rows = log
            .sliding()
            .filter(|row| (row.time > change + 0.1) == is_after);
        let forces: Vec<f64> = rows.map(|row| row.external.xy().norm()).collect();
        forces.iter().sum::<f64>() / forces.len() as f64
    };
    assert!(mean(false) < 0.4 * mean(true));
    // In another round nothing changes.
    wiping.settings.friction_changes[0].round = round + 1;
    let calm = wiping.execute();
    wiping.settings.friction_changes.clear();
    assert_eq!(calm.bytes(), wiping.execute().bytes());
}
