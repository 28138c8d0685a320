//! Logs of a sensor that measures the inertia of the tool behind it.

use super::log::{DEPTH, PRESS, STEEP, task};
use super::{events, interpreted_with};
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::interpret::{Doubt, EventKind, InterpretConfig, Interpretation, TouchSample};

/// Samples per second.
const RATE: f64 = 200.0;
const LIFT: f64 = 0.05;
const FRICTION: f64 = 0.3;
/// Gravity in the world [m/s²].
const GRAVITY: f64 = -9.80665;

/// Durations of a stroke, of a motion down or up, and of a motion to the next stroke [s].
type Durations = [f64; 3];

/// Motions of least jerk over the board: from, to and duration. The tool hangs still before and after them.
fn motions([stroke, down, across]: Durations) -> Vec<(Point3, Point3, f64)> {
    let mut legs = Vec::new();
    let mut at = Point3::new(-0.125, -0.08, LIFT);
    legs.push((at, at, 1.0));
    for row in 0..5 {
        let y = 0.04 * f64::from(row) - 0.08;
        let x = if row % 2 == 0 { 0.125 } else { -0.125 };
        let [begin, end] = [-x, x].map(|x| Point3::new(x, y, 0.0));
        let up = Vector3::z() * LIFT;
        legs.push((at, begin + up, across));
        legs.push((begin + up, begin, down));
        legs.push((begin, end, stroke));
        legs.push((end, end + up, down));
        at = end + up;
    }
    legs.push((at, at, 1.0));
    legs
}

/// The log of a sensor with a mass behind it [kg] whose weight is not compensated. `push` returns the force of a hand at a time [s],
/// in the axes of the surface [N].
fn samples(durations: Durations, mass: f64, push: impl Fn(f64) -> Vector3) -> Vec<TouchSample> {
    let surface = task(0, STEEP).surface.world_from_surface;
    let weight = surface.rotation.inverse() * Vector3::new(0.0, 0.0, GRAVITY * mass);
    let mut samples: Vec<TouchSample> = Vec::new();
    for (from, to, duration) in motions(durations) {
        for i in 0..(duration * RATE) as usize {
            let time = samples.len() as f64 / RATE;
            let s = i as f64 / (duration * RATE);
            let share = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
            let bend = 60.0 * s - 180.0 * s * s + 120.0 * s.powi(3);
            let place = from + (to - from) * share;
            let acceleration = (to - from) * (bend / (duration * duration));
            let normal = PRESS * (1.0 - place.z / DEPTH).clamp(0.0, 1.0);
            let along = (to - from).xy();
            let moving = if along.norm() > 0.0 {
                along.normalize()
            } else {
                along
            };
            let contact = Vector3::new(-FRICTION * moving.x, -FRICTION * moving.y, 1.0) * normal;
            let force = contact + weight + push(time) - acceleration * mass;
            samples.push(TouchSample {
                time,
                world_from_tool: surface * Pose::from(place),
                force: surface.rotation * force,
            });
        }
    }
    samples
}

fn read(samples: &[TouchSample], moved_mass_kg: f64) -> Interpretation {
    let task = task(80, STEEP);
    let config = InterpretConfig {
        moved_mass_kg,
        ..InterpretConfig::from_task(&task)
    };
    interpreted_with(samples, &task, &config)
}

fn mass(found: &Interpretation) -> Option<f64> {
    found.doubts.iter().find_map(|doubt| match doubt {
        Doubt::Inertia { mass } => Some(*mass),
        _ => None,
    })
}

const FAST: Durations = [1.2, 0.4, 0.3];
const SLOW: Durations = [2.0, 0.8, 0.5];

#[test]
fn inertia_is_no_push() {
    let nobody = |_| Vector3::zeros();
    for durations in [FAST, SLOW] {
        let truth = read(&samples(durations, 0.0, nobody), 0.0);
        assert_eq!(truth.doubts, []);
        for behind in [0.5, 1.0, 2.0, 5.0] {
            let log = samples(durations, behind, nobody);
            for stated in [0.0, behind] {
                let found = read(&log, stated);
                let what = format!("{durations:?} s, {behind} kg, stated {stated} kg");
                for kind in [EventKind::Push, EventKind::Vibration, EventKind::Landing] {
                    assert_eq!(events(&found, kind), [], "{what}");
                }
                assert_eq!(events(&found, EventKind::Contact).len(), 5, "{what}");
                let difference = found.performance.mean - truth.performance.mean;
                assert!(difference.abs() < 0.02, "{what}: {difference}");
                assert!(found.is_conclusive(), "{what}: {:?}", found.doubts);
                let read = mass(&found);
                assert!(
                    read.is_none_or(|mass| (mass / behind - 1.0).abs() < 0.1),
                    "{what}: {read:?}"
                );
                assert!(read.is_some() || behind <= 1.0 && stated == 0.0, "{what}");
            }
        }
    }
    // A sensor of the other sign.
    let reversed: Vec<TouchSample> = (samples(FAST, 2.0, nobody).into_iter())
        .map(|sample| TouchSample {
            force: -sample.force,
            ..sample
        })
        .collect();
    let found = read(&reversed, 0.0);
    assert!(found.doubts.contains(&Doubt::WrenchSignInverted));
    assert_eq!(events(&found, EventKind::Push), []);
    assert!(mass(&found).is_some_and(|mass| (mass - 2.0).abs() < 0.2));
}

#[test]
fn a_push_is_found_beside_inertia() {
    for behind in [0.0, 2.0] {
        for (start, end) in [(0.2, 0.7), (3.05, 3.45), (7.65, 8.1)] {
            for force in [[8.0, 0.0, 0.0], [0.0, -8.0, 0.0], [-5.0, 5.0, 5.0]] {
                let hand = |time: f64| {
                    let rise = ((time - start).min(end - time) / 0.05).clamp(0.0, 1.0);
                    Vector3::from(force) * rise
                };
                let found = read(&samples(FAST, behind, hand), 0.0);
                let pushes = events(&found, EventKind::Push);
                let what = format!("{behind} kg, {start} s, {force:?}: {pushes:?}");
                let is_near =
                    (pushes.iter()).any(|push| push.start < end - 0.1 && push.end > start + 0.1);
                assert!(pushes.len() == 1 && is_near, "{what}");
            }
        }
    }
}
