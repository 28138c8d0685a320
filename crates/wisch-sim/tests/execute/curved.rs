//! A soft pad on a curved surface.

use super::wiping::{Log, Wiping, as_believed, faults};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;
use wisch::geometry::{Point2, Point3, Polygon, SheetConfig, Vector3};
use wisch::represent::{Action, Cone, Fate, MeshShape, Mount, SensorModel, SurfaceShape, Task};
use wisch::run::Executor;
use wisch_sim::{Camera, Dirt, SimulationSettings, WorkSurface, World};
use wisch_testkit::{board, curved_meshes::mesh_over};

/// Radius, and angle of the axis from the chart's x: bulges and hollows, across the stroke, along it and askew.
const BENDS: [(f64, f64); 6] = [
    (0.5, FRAC_PI_2),
    (0.5, 0.0),
    (0.3, 0.7),
    (2.0, FRAC_PI_2),
    (-0.5, FRAC_PI_2),
    (-0.5, 0.3),
];

/// Radius, half angle, and direction in which the cone widens.
const CONES: [(f64, f64, f64); 2] = [(0.5, 0.4, FRAC_PI_2), (-0.5, 0.3, 0.3)];

/// Cylinders and cones.
fn bends() -> impl Iterator<Item = SurfaceShape> {
    let cones = CONES.map(|(radius, half_angle, axis)| {
        SurfaceShape::Cone(Cone {
            radius,
            half_angle,
            axis,
        })
    });
    BENDS.map(cylinder).into_iter().chain(cones)
}

/// The first stroke with a pad of 10 mm over a board of this shape.
fn rolled(action: Action, shape: SurfaceShape) -> Wiping {
    let mut task = board(action, [0.5, 0.0, 0.2]);
    task.tool.mount = Some(Mount::Hand { lean: 0.8 });
    task.scene.clear();
    task.interaction.compression_depth_m = 0.01;
    task.surface.shape = shape;
    Wiping::of_first_stroke(task)
}

const fn cylinder((radius, axis): (f64, f64)) -> SurfaceShape {
    SurfaceShape::Cylinder { radius, axis }
}

/// Angle between the tool's axis and the normal under it at most [rad], while the tool slides.
fn greatest_lean(log: &Log, wiping: &Wiping) -> f64 {
    let surface = &wiping.task.surface;
    let lean = log.sliding().map(|row| {
        let under = surface.chart(Point3::from(row.world_from_tool.translation.vector));
        let axis = row.world_from_tool.rotation * Vector3::z();
        axis.angle(&surface.normal(under.place))
    });
    lean.fold(0.0, f64::max)
}

/// The bounds are those of a wipe over a plane.
#[test]
fn a_wipe_over_a_cylinder_or_a_cone_presses_as_over_a_plane() {
    for bend in bends() {
        let wiping = rolled(Action::Absorb, bend.clone());
        let log = wiping.execute();
        let found: Vec<String> = faults(&log)
            .into_iter()
            // A pad of 10 mm lets the tool sink in further than the boards' pad does.
            .filter(|fault| !fault.contains("from the plane"))
            .collect();
        assert_eq!(found, [] as [String; 0], "{bend:?}");
        assert!(log.truth.contact_force.count() > 200);
        let lean = greatest_lean(&log, &wiping).to_degrees();
        assert!(lean < 2.0, "{bend:?}: {lean}°");
    }
}

/// A dish that bulges in both directions, whose chart has a curved border.
#[test]
fn a_wipe_over_a_mesh_presses_as_over_a_plane() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    task.tool.mount = Some(Mount::Hand { lean: 0.8 });
    task.scene.clear();
    task.interaction.compression_depth_m = 0.01;
    let dish = mesh_over([40, 40], [0.24, 0.18], |p| {
        Point3::new(p.x, p.y, -1.2 * p.x * p.x - 0.8 * p.y * p.y)
    });
    let config = SheetConfig {
        tool_radius: task.tool.collision_radius(),
        ..SheetConfig::default()
    };
    let (shape, mesh_from_surface) = MeshShape::from_mesh(&dish, &config).unwrap();
    task.surface.outline = shape.outline();
    task.surface.world_from_surface *= mesh_from_surface;
    task.surface.shape = SurfaceShape::Mesh(Arc::new(shape));
    let wiping = Wiping::of_first_stroke(task);
    let log = wiping.execute();
    let found: Vec<String> = faults(&log)
        .into_iter()
        .filter(|fault| !fault.contains("from the plane"))
        .collect();
    assert_eq!(found, [] as [String; 0]);
    assert!(log.truth.contact_force.count() > 200);
    let lean = greatest_lean(&log, &wiping).to_degrees();
    assert!(lean < 2.0, "{lean}°");
}

/// The engine lets a face carry with four corners at most; the surface under the tool is divided.
#[test]
fn an_outline_of_many_corners_carries_the_tool_everywhere() {
    // Around the board, so that the stroke stays within it.
    let corner = |i: usize| {
        let (sine, cosine) = (i as f64 * PI / 12.0).sin_cos();
        Point2::new(0.3 * cosine, 0.3 * sine)
    };
    let round = Polygon::new((0..24).map(corner).collect(), vec![]);
    for shape in [SurfaceShape::Plane, cylinder((0.5, FRAC_PI_2))] {
        let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
        task.tool.mount = Some(Mount::Hand { lean: 0.8 });
        task.scene.clear();
        task.interaction.compression_depth_m = 0.01;
        task.surface.shape = shape;
        let mut wiping = Wiping::of_first_stroke(task);
        wiping.task.surface.outline = round.clone();
        let log = wiping.execute();
        let found: Vec<String> = faults(&log)
            .into_iter()
            .filter(|fault| !fault.contains("from the plane"))
            .collect();
        assert_eq!(found, [] as [String; 0]);
    }
}

/// Dirt beside the pad lies still, whatever the surface leans; what the middle of the pad goes over is taken up.
#[test]
fn grains_lie_on_the_bend_until_the_pad_takes_them() {
    for bend in bends() {
        let mut wiping = rolled(Action::Absorb, bend.clone());
        wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
        let log = wiping.execute();
        let path: Vec<Point2> = (log.rows.iter())
            .filter(|row| row.phase.is_contact())
            .map(|row| {
                let tool = Point3::from(row.world_from_tool.translation.vector);
                wiping.task.surface.chart(tool).place
            })
            .collect();
        let mut taken = 0;
        let grains = wiping.dirt.grains().iter();
        for (before, after) in grains.zip(log.truth.dirt.grains()) {
            let away = path.iter().map(|at| (at - before.position).norm());
            let away = away.fold(f64::INFINITY, f64::min);
            if away < 0.02 && before.threshold < 0.8 {
                assert_eq!(
                    after.fate,
                    Fate::Absorbed,
                    "{bend:?}: {away} m beside the path"
                );
                taken += 1;
            } else if away > 0.09 {
                let moved = (after.position - before.position).norm();
                assert_eq!(after.fate, Fate::OnSurface, "{bend:?}");
                assert!(moved < 1e-3, "{bend:?}: crept by {moved} m");
            }
        }
        assert!(taken > 1, "{bend:?}");
    }
}

/// A camera sees dirt where it lies in the chart, and nothing of sides that lean away.
#[test]
fn a_camera_shows_the_chart_of_a_bend() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    // 60 degrees of 5 cm.
    let on_top = 0.05 * 60_f64.to_radians();
    task.surface.shape = cylinder((0.05, FRAC_PI_2));
    check_camera(&task, |place| Some(place.x.abs() < on_top));
    let half_angle: f64 = 0.2;
    let funnel = Cone {
        radius: 0.05,
        half_angle,
        axis: FRAC_PI_2,
    };
    task.surface.shape = SurfaceShape::Cone(funnel);
    let (sine, cosine) = half_angle.sin_cos();
    let shape = task.surface.shape.clone();
    // The vertical part of a normal is cos² α cos φ + sin² α. Cells of what is hidden are 2 cm wide, or 23° of the cone.
    check_camera(&task, |place| {
        let upright = cosine * cosine * shape.roll(place).cos() + sine * sine;
        let (lean, margin) = (upright.acos().to_degrees(), 25.0);
        ((lean - 60.0).abs() > margin).then_some(lean < 60.0)
    });
}

/// Checks that a camera shows the dirt at places that it sees, and reports others as hidden. `sees`: whether it sees a
/// place, unless that is uncertain.
fn check_camera(task: &Task, sees: impl Fn(Point2) -> Option<bool>) {
    let sensor = SensorModel {
        detection: 1.0,
        half_size_m: 0.0,
        false_alarms_per_m2: 0.0,
        position_error_m: 0.0,
    };
    let settings = SimulationSettings {
        camera: Some(Camera {
            sensor,
            arm_hides: false,
        }),
        ..as_believed()
    };
    let mut world = World::new(&WorkSurface::from_task(task), settings, 1).unwrap();
    let seen = world.observe(task).unwrap().unwrap();
    let (mut shown, mut hidden) = (0, 0);
    for grain in world.dirt().grains() {
        let place = grain.position;
        let is_shown = seen.detections.iter().any(|at| (at - place).norm() < 1e-9);
        if let Some(is_seen) = sees(place) {
            assert_eq!(
                (is_shown, seen.is_hidden(place)),
                (is_seen, !is_seen),
                "{place}"
            );
        }
        shown += usize::from(is_shown);
        hidden += usize::from(!is_shown);
    }
    assert!(shown > 5 && hidden > 5, "{shown} {hidden}");
}
