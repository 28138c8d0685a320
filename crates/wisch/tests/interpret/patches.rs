//! Logs that wipe more of a divided mesh than the patch of the task.

use super::interpreted_with;
use super::log::{DEPTH, PRESS, STEEP, task};
use std::sync::Arc;
use wisch::geometry::{Atlas, MAX_CHARTS, Point2, Point3, Pose, SheetConfig, Vector3};
use wisch::interpret::{Diagnosis, InterpretConfig, TouchSample};
use wisch::represent::{MeshShape, ParticleDistribution, SurfaceShape, Task};
use wisch_testkit::{Relief, ReliefWipe, curved_meshes};

/// Radius of the dome, which has several patches [m].
const RADIUS: f64 = 0.3;
/// Distance between two particles [m].
const APART: f64 = 0.012;

/// Seven strokes over the dome, up to this x [m].
fn log(world_from_mesh: &Pose, most: f64) -> Vec<TouchSample> {
    let strokes = (0..7).map(|row| {
        let y = 0.05 * (f64::from(row) - 3.0);
        let ends = [Point2::new(-0.15, y), Point2::new(most, y)];
        if row % 2 == 0 {
            ends
        } else {
            [ends[1], ends[0]]
        }
    });
    let wipe = ReliefWipe {
        relief: Relief::Sphere {
            curvature: 1.0 / RADIUS,
        },
        strokes: strokes.collect(),
        leans: true,
        press: [PRESS, DEPTH],
        friction: 0.3,
        noise: [0.1, 1e-5],
        rate: 100.0,
        believed_from_real: Pose::identity(),
        seed: 1,
    };
    wipe.samples(world_from_mesh)
}

/// Share of a task's particles over which the tool's underside presses.
fn wiped(task: &Task, samples: &[TouchSample]) -> f64 {
    let pressing = |sample: &&TouchSample| sample.force.norm() >= 0.8 * PRESS;
    let tools: Vec<Pose> = (samples.iter().filter(pressing))
        .map(|sample| sample.world_from_tool.inverse())
        .collect();
    let is_wiped = |place: Point2| {
        let at = task.surface.world_from_place(place, 0.0).translation.vector;
        tools.iter().any(|tool| {
            let at = tool * Point3::from(at);
            at.x.abs() <= 0.035 && at.y.abs() <= 0.055 && at.z.abs() <= 0.01
        })
    };
    let places: Vec<Point2> = task.particles.iter().map(|(place, _)| place).collect();
    let count = places.iter().filter(|place| is_wiped(**place)).count();
    count as f64 / places.len() as f64
}

#[test]
fn a_log_of_a_whole_dome_is_read_for_each_patch() {
    let mesh = curved_meshes::dome(RADIUS);
    let config = SheetConfig {
        tool_radius: 0.0652,
        ..SheetConfig::default()
    };
    let atlas = Arc::new(Atlas::from_mesh(&mesh, &config, MAX_CHARTS).unwrap());
    let world_from_mesh = Pose::new(Vector3::new(0.5, 0.1, 0.3), Vector3::new(0.2, -0.1, 0.7));
    let whole = log(&world_from_mesh, 0.15);
    let half = log(&world_from_mesh, -0.05);
    assert!(atlas.charts().len() > 2);
    for index in 0..atlas.charts().len() {
        let (shape, mesh_from_surface) = MeshShape::from_patch(&mesh, &atlas, index);
        let mut task = task(1, STEEP);
        task.surface.outline = shape.outline();
        task.surface.world_from_surface = world_from_mesh * mesh_from_surface;
        task.surface.shape = SurfaceShape::Mesh(Arc::new(shape));
        let steps = (-40..=40).map(|step| APART * f64::from(step));
        let grid = steps
            .clone()
            .flat_map(|y| steps.clone().map(move |x| Point2::new(x, y)));
        let places: Vec<Point2> = grid
            .filter(|place| task.surface.outline.contains(*place))
            .collect();
        task.particles = ParticleDistribution::new(&places).unwrap();
        for (log, samples) in [("whole", &whole), ("half", &half)] {
            let what = format!("{log}, patch {index}");
            let truth = wiped(&task, samples);
            if truth == 0.0 {
                continue;
            }
            let found = interpreted_with(samples, &task, &InterpretConfig::from_task(&task));
            if log == "whole" {
                assert_eq!(found.doubts.len(), 1, "{what}: {:?}", found.doubts);
            }
            assert_eq!(found.diagnosis, Diagnosis::Localized, "{what}");
            assert!(found.is_conclusive(), "{what}");
            let by_hand = found.events.iter().filter(|event| event.kind.is_by_hand());
            assert_eq!(by_hand.count(), 0, "{what}");
            let off = found.performance.mean - truth;
            assert!(off.abs() < 0.06, "{what}: {:?} {truth}", found.performance);
        }
    }
}
