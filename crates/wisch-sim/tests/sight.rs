//! Observations by a camera: detections of the true dirt, and errors that a robot cannot know.

use crate::execute::Wiping;
use wisch::geometry::{Point2, Polygon, Pose, Region};
use wisch::represent::{Action, Fate, Observation, SensorModel, Task};
use wisch::run::Executor;
use wisch_sim::{
    Camera, Dirt, Grain, GrainCount, GroundTruth, SimulationSettings, Spread, TrueDirt,
    WorkSurface, World,
};
use wisch_testkit::board;

/// A camera that detects all dirt at its exact position.
const PERFECT: SensorModel = SensorModel {
    detection: 1.0,
    half_size_m: 0.0,
    false_alarms_per_m2: 0.0,
    position_error_m: 0.0,
};

fn task() -> Task {
    board(Action::Absorb, [0.5, 0.0, 0.2])
}

fn settings(sensor: SensorModel) -> SimulationSettings {
    SimulationSettings {
        camera: Some(Camera {
            sensor,
            arm_hides: false,
        }),
        count: GrainCount::Exactly(200),
        dirt: TrueDirt::Uniform,
        ..super::execute::as_believed()
    }
}

fn world(settings: SimulationSettings) -> World {
    World::new(&WorkSurface::from_task(&task()), settings, 1).unwrap()
}

fn seen(world: &mut World) -> Observation {
    world.observe(&task()).unwrap().expect("there is a camera")
}

fn places(dirt: &Dirt) -> Vec<Point2> {
    dirt.grains().iter().map(|grain| grain.position).collect()
}

#[test]
fn without_a_camera_nothing_is_seen() {
    let mut blind = world(SimulationSettings {
        camera: None,
        ..settings(PERFECT)
    });
    assert_eq!(blind.observe(&task()), Ok(None));
}

#[test]
fn where_dirt_is_too_much_to_be_simulated_nothing_is_seen() {
    let mut bare = world(SimulationSettings {
        max_bodies: 199,
        ..settings(PERFECT)
    });
    assert_eq!(bare.observe(&task()), Ok(None));
}

#[test]
fn a_perfect_camera_sees_every_grain_where_it_is() {
    let mut world = world(settings(PERFECT));
    let real = places(world.dirt());
    assert_eq!(real.len(), 200);
    for (seen, real) in seen(&mut world).detections.iter().zip(&real) {
        assert!((seen - real).norm() < 1e-12);
    }
    assert_eq!(seen(&mut world).detections.len(), 200);
}

#[test]
fn misses_false_alarms_and_errors_are_as_frequent_as_set() {
    let half = SensorModel {
        detection: 0.5,
        ..PERFECT
    };
    let looks = |sensor| {
        let mut world = world(settings(sensor));
        let dirt = places(world.dirt());
        let looks = (0..100).map(|_| seen(&mut world).detections);
        (dirt, looks.collect::<Vec<_>>())
    };
    let (_, found) = looks(half);
    let count = found.iter().map(Vec::len).sum::<usize>() as f64 / 20_000.0;
    // Four standard errors of 20,000 draws.
    assert!((count - 0.5).abs() < 0.015, "{count}");
    assert_ne!(
        found[0], found[1],
        "each look has random numbers of its own"
    );

    // Grains of 2 to 3 mm, of which those of 2.5 mm are half seen.
    let small = SensorModel {
        half_size_m: 2.5e-3,
        ..PERFECT
    };
    let (_, found) = looks(small);
    let count = found.iter().map(Vec::len).sum::<usize>() as f64 / 20_000.0;
    assert!((count - 0.5).abs() < 0.08, "{count}");

    let alarmed = SensorModel {
        detection: 0.0,
        false_alarms_per_m2: 1000.0,
        ..PERFECT
    };
    let (_, found) = looks(alarmed);
    let area = task().surface.outline.area();
    let density = found.iter().map(Vec::len).sum::<usize>() as f64 / 100.0 / area;
    assert!((density - 1000.0).abs() < 70.0, "{density} per m²");
    let left = found.iter().flatten().filter(|place| place.x < 0.0).count() as f64;
    let all = found.iter().flatten().count() as f64;
    assert!((left / all - 0.5).abs() < 0.05);

    let blurred = SensorModel {
        position_error_m: 0.003,
        ..PERFECT
    };
    let (dirt, found) = looks(blurred);
    let errors = found
        .iter()
        .flat_map(|look| look.iter().zip(&dirt).map(|(seen, real)| seen - real));
    let squares: f64 = errors.map(|error| error.norm_squared()).sum();
    let deviation = (squares / 20_000.0 / 2.0).sqrt();
    assert!((deviation - 0.003).abs() < 1e-4, "{deviation} m");
}

#[test]
fn detections_are_in_the_frame_of_the_believed_surface() {
    let mut moved = settings(PERFECT);
    moved.believed_from_real = Pose::translation(0.01, -0.02, 0.0);
    let mut world = world(moved);
    let real = places(world.dirt());
    let expected = real[0] + nalgebra::Vector2::new(0.01, -0.02);
    assert!((seen(&mut world).detections[0] - expected).norm() < 1e-12);
    // If the robot has measured the surface, detections are in the measured frame.
    let mut task = task();
    task.surface.world_from_surface *= Pose::translation(0.01, -0.02, 0.0);
    let told = world.observe(&task).unwrap().unwrap();
    assert!((told.detections[0] - real[0]).norm() < 1e-12);
}

#[test]
fn the_arm_and_the_tool_hide_what_lies_under_them() {
    let mut wiping = Wiping::of_one_stroke(Action::Absorb);
    let mut hidden = |arm_hides| {
        let sensor = PERFECT;
        wiping.settings.camera = Some(Camera { sensor, arm_hides });
        let log = wiping.execute_until(wiping.midst());
        let last = log.rows.last().unwrap().world_from_tool;
        let surface = &wiping.task.surface.world_from_surface;
        let tool = (surface.inverse() * last).translation.vector.xy();
        let hulls = log.truth.hidden.into_iter();
        let hulls = hulls.map(|hull| Polygon::new(hull, Vec::new()));
        (Region::new(hulls.collect()), Point2::from(tool))
    };
    let (hulls, tool) = hidden(true);
    assert!(hulls.contains(tool));
    // The robot's base is far from the board, and a point beyond the board is not hidden.
    assert!(!hulls.contains(Point2::new(1.0, 1.0)));
    let (hulls, _) = hidden(false);
    assert_eq!(hulls.polygons(), []);
}

#[test]
fn what_is_gone_or_hidden_is_not_seen() {
    let fates = [
        (0.0, Fate::OnSurface),
        (0.02, Fate::Absorbed),
        (0.04, Fate::OffSurface { edge: 1 }),
        (0.06, Fate::OnSurface),
    ];
    let grain = |(x, fate)| Grain {
        position: Point2::new(x, 0.0),
        fate,
        radius: 1e-3,
        threshold: 0.3,
        wear: 0.0,
    };
    let corners = [(0.05, -0.01), (0.07, -0.01), (0.07, 0.01), (0.05, 0.01)];
    let truth = GroundTruth {
        dirt: Dirt::from_grains(fates.map(grain).to_vec()),
        contact_force: Spread::default(),
        max_plane_distance: 0.0,
        max_controller_force: 0.0,
        lost_share: 0.0,
        max_lateral_error: 0.0,
        pushes: vec![],
        obstructions: vec![],
        hidden: vec![corners.map(|(x, y)| Point2::new(x, y)).to_vec()],
    };
    let mut world = world(settings(PERFECT)).with_history(vec![truth]);
    let seen = seen(&mut world);
    assert_eq!(seen.detections, [Point2::origin()]);
    assert!(seen.is_hidden(Point2::new(0.06, 0.0)) && !seen.is_hidden(Point2::origin()));
}
