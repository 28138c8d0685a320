//! Logs of a soft pad that leans on the board.

use super::log::{DEPTH, PRESS, STEEP, Script, task};
use super::{events, interpreted_with};
use wisch::geometry::{Pose, Vector2, Vector3};
use wisch::interpret::{Diagnosis, EventKind, InterpretConfig, Interpretation, TouchSample};

/// Springs along each side of the pad.
const SPRINGS: i32 = 60;

/// Returns by how much a leaning pad is higher than a flat one under a force over the nominal one [m]. The pad is a grid of springs;
/// `slope` is that of the board against its underside [1].
fn raise(force: f64, slope: Vector2, pad: Vector2) -> f64 {
    let places: Vec<f64> = (0..SPRINGS * SPRINGS)
        .map(|i| {
            let along = |k: i32| (f64::from(k) + 0.5) / f64::from(SPRINGS) - 0.5;
            let place = Vector2::new(along(i % SPRINGS), along(i / SPRINGS));
            slope.dot(&place.component_mul(&pad))
        })
        .collect();
    let mean = |middle: f64| {
        let compressed = places.iter().map(|rise| (middle + rise).max(0.0));
        compressed.sum::<f64>() / places.len() as f64
    };
    let highest = places.iter().copied().fold(0.0, f64::max);
    let (mut low, mut high) = (-highest, force * DEPTH);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if mean(middle) < force * DEPTH {
            low = middle;
        } else {
            high = middle;
        }
    }
    force * DEPTH - high
}

/// Interprets three strokes of a pad that leans by an angle [rad] about an axis of its own.
fn read(axis: Vector3, lean: f64, surface_height: f64) -> Interpretation {
    let task = task(80, STEEP);
    let surface = task.surface.world_from_surface;
    let slope = Vector2::new(-axis.y, axis.x) * lean.tan();
    let size = task.tool.footprint.bounds().unwrap().size();
    let levels: Vec<f64> = (0..=20)
        .map(|i| raise(0.05 * f64::from(i), slope, size))
        .collect();
    let script = Script {
        rate: 200.0,
        force_noise: 0.1,
        position_noise: 2e-5,
        ..Script::default()
    };
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
        .map(|sample| {
            let force = surface.rotation.inverse() * sample.force / PRESS;
            let at = 20.0 * force.z.clamp(0.0, 0.999);
            let [below, above] = [0, 1].map(|next| levels[at as usize + next]);
            let up = below + (above - below) * at.fract() + surface_height;
            let flat = surface.inverse() * sample.world_from_tool;
            let place = flat.translation.vector + Vector3::z() * up;
            TouchSample {
                world_from_tool: surface * Pose::new(place, axis * lean),
                ..sample
            }
        })
        .collect();
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

#[test]
fn a_leaning_pad_does_not_move_the_surface() {
    for axis in [Vector3::x(), Vector3::y(), Vector3::new(0.6, -0.8, 0.0)] {
        for degrees in [-30.0_f64, 8.0, 15.0, 20.0, 30.0] {
            let found = read(axis, degrees.to_radians(), 0.0);
            let what = format!("{degrees}° about {axis:?}");
            let plane = found.plane.unwrap();
            assert!(plane.offset.abs() < 4e-4, "{what}: {plane:?}");
            assert!(plane.tilt < 0.003, "{what}: {plane:?}");
            assert_eq!(found.diagnosis, Diagnosis::Localized, "{what}");
            assert_eq!(events(&found, EventKind::Push), [], "{what}");
            assert_eq!(events(&found, EventKind::Contact).len(), 3, "{what}");
        }
        // A surface that is lower is found, too.
        let lower = read(axis, 0.4, -0.008).plane.unwrap();
        assert!((lower.offset + 0.008).abs() < 4e-4, "{axis:?}: {lower:?}");
    }
}
