//! Plans over meshes, compared with a sweep in space: the poses of the tool against points of the mesh as given. The sweep shares no
//! code with charts, contact and prediction.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::sync::Arc;
use wisch::follow::{ToolPose, Workcell};
use wisch::geometry::{
    Atlas, Bounds2, MAX_CHARTS, Mesh, PlanarPose, Point2, Point3, Pose, SheetConfig, Vector3,
};
use wisch::plan::{Plan, PlanConfig, Strategy, plan, predict};
use wisch::represent::{
    Action, Fate, MeshShape, ParticleDistribution, SurfaceShape, Task, Tool, Treatment,
};
use wisch_testkit::{board, curved_meshes};

/// Sides of the pad along and across its motion, and its compression [m].
const PAD: [f64; 2] = [0.06, 0.10];
const COMPRESSION: f64 = 0.01;
/// Number of places on each mesh.
const PLACES: usize = 20_000;
/// Distance between poses of the sweep [m].
const STEP: f64 = 1e-3;
/// Largest share of places at which contact differs from the prediction [1].
const OTHERWISE: f64 = 0.015;
/// Least share of places that are touched [1].
const TOUCHED: f64 = 0.999;

/// The same for a mesh in patches [1].
const TOUCHED_BY_PATCHES: f64 = 0.995;

/// A point of a mesh with the normal of its triangle, in the frame of the mesh.
struct Place {
    point: Point3,
    normal: Vector3,
}

/// Sums of the areas of the triangles up to each [m²].
fn sum_areas(mesh: &Mesh) -> Vec<f64> {
    let areas = mesh.triangles().iter().map(|triangle| {
        let [a, b, c] = triangle.map(|i| mesh.vertices()[i as usize]);
        0.5 * (b - a).cross(&(c - a)).norm()
    });
    let sums = areas.scan(0.0, |sum, area| {
        *sum += area;
        Some(*sum)
    });
    sums.collect()
}

/// Draws places that are uniform over the area of a mesh.
fn draw_places(mesh: &Mesh, count: usize) -> Vec<Place> {
    let corners = |t: &[u32; 3]| t.map(|i| mesh.vertices()[i as usize]);
    let sums = sum_areas(mesh);
    let area = sums.last().copied().unwrap_or_default();
    let mut random = ChaCha8Rng::seed_from_u64(1000);
    let places = (0..count).map(|_| {
        let drawn = area * random.random::<f64>();
        let triangle = sums.partition_point(|&sum| sum < drawn);
        let [a, b, c] = corners(&mesh.triangles()[triangle.min(sums.len() - 1)]);
        let [mut u, mut v] = [random.random::<f64>(), random.random::<f64>()];
        if u + v > 1.0 {
            [u, v] = [1.0 - u, 1.0 - v];
        }
        Place {
            point: a + (b - a) * u + (c - a) * v,
            normal: (b - a).cross(&(c - a)).normalize(),
        }
    });
    places.collect()
}

/// A polish of a mesh, one pass, and the pose of the mesh in the world.
fn polish(mesh: &Mesh) -> (Task, Pose) {
    let task = polish_with_pad();
    let (shape, pose) = MeshShape::from_mesh(mesh, &config(&task)).unwrap();
    roll(task, shape, pose)
}

/// The settings with which a mesh is unrolled for the tool of a task.
fn config(task: &Task) -> SheetConfig {
    SheetConfig {
        tool_radius: task.tool.collision_radius(),
        ..SheetConfig::default()
    }
}

/// A polish of a board with the pad, one pass.
fn polish_with_pad() -> Task {
    let mut task = board(Action::Polish, [0.5, 0.0, 0.2]);
    task.scene.clear();
    task.tool = Tool::pad("pad", Vector3::new(PAD[0], PAD[1], 0.04)).unwrap();
    task.interaction.compression_depth_m = COMPRESSION;
    task.treatment = Some(Treatment::Polish {
        passes: 1,
        max_passes: 20,
        preston: None,
    });
    task
}

/// Rolls the surface of a task onto a shape; also returns the pose of the mesh in the world.
fn roll(mut task: Task, shape: MeshShape, mesh_from_surface: Pose) -> (Task, Pose) {
    let world_from_mesh = task.surface.world_from_surface;
    task.surface.outline = shape.outline();
    task.surface.world_from_surface *= mesh_from_surface;
    task.surface.shape = SurfaceShape::Mesh(Arc::new(shape));
    (task, world_from_mesh)
}

/// Returns the poses of the tool in contact, at most a step apart, in the frame of the mesh.
fn sweep(task: &Task, plan: &Plan, world_from_mesh: &Pose) -> Vec<Pose> {
    let pairs = (plan.strokes.iter()).flat_map(|stroke| stroke.poses.windows(2));
    let poses = pairs.flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        let way = to.position - from.position;
        let turn = to.heading - from.heading;
        let parts = (way.norm() / STEP).max(turn.abs() / 0.01).ceil().max(1.0) as usize;
        (0..=parts).map(move |i| {
            let share = i as f64 / parts as f64;
            PlanarPose::new(from.position + way * share, from.heading + turn * share)
        })
    });
    let lifted = poses.map(|surface_from_tool| {
        let pose = ToolPose {
            surface_from_tool,
            height: 0.0,
            tilt: 0.0,
        };
        world_from_mesh.inverse() * Workcell::world_from_tool(task, &pose)
    });
    lifted.collect()
}

/// What a sweep found.
struct Sweep {
    /// Whether each place was touched.
    touched: Vec<bool>,
    /// Largest angle between the axis of the tool and the mean normal under it, where the whole tool lies on the mesh [rad].
    lean: f64,
}

/// Presses the pad at each pose: it touches the places under its rectangle that are no farther from its plane than its
/// compression.
fn press(places: &[Place], poses: &[Pose], density: f64) -> Sweep {
    let reach = 0.5 * PAD[0].hypot(PAD[1]) + COMPRESSION;
    let expected = density * PAD[0] * PAD[1];
    let mut found = Sweep {
        touched: vec![false; places.len()],
        lean: 0.0,
    };
    for pose in poses {
        let rotation = pose.rotation.to_rotation_matrix();
        let [x, y, z] = [0, 1, 2].map(|axis| rotation.matrix().column(axis).into_owned());
        let mut mean = Vector3::zeros();
        let mut under = 0;
        for (place, touched) in places.iter().zip(&mut found.touched) {
            let offset = place.point.coords - pose.translation.vector;
            if offset.norm_squared() > reach * reach {
                continue;
            }
            let is_under =
                2.0 * offset.dot(&x).abs() <= PAD[0] && 2.0 * offset.dot(&y).abs() <= PAD[1];
            if is_under && offset.dot(&z).abs() <= COMPRESSION {
                *touched = true;
                under += 1;
                mean += place.normal;
            }
        }
        if f64::from(under) > 0.9 * expected {
            let lean = mean.cross(&z).norm().atan2(mean.dot(&z));
            found.lean = found.lean.max(lean);
        }
    }
    found
}

/// Result of the comparison: share of places at which contact differs from the prediction [1],
/// share of touched places [1], and lean [rad].
#[derive(Debug)]
struct Comparison {
    otherwise: f64,
    touched: f64,
    lean: f64,
}

/// Plans, predicts and sweeps. `fault` is planted: the pose of the tool as it is in the frame of the tool as it should be.
fn compare_with_sweep(name: &str, mesh: &Mesh, fault: &Pose) -> Comparison {
    let (mut task, world_from_mesh) = polish(mesh);
    // Simplifying the border of the chart takes at most 0.2 mm of it.
    let chart = |place: &Place| task.surface.chart(world_from_mesh * place.point).place;
    let (charted, places): (Vec<Point2>, Vec<Place>) = (draw_places(mesh, PLACES).into_iter())
        .map(|place| (chart(&place), place))
        .filter(|(at, _)| task.surface.outline.contains(*at))
        .unzip();
    assert!(places.len() as f64 > 0.995 * PLACES as f64, "{name}");
    // The plan knows cells of 1 cm, not the places of the sweep.
    task.particles = ParticleDistribution::new(&lattice(&task)).unwrap();
    let whole = plan(&task, &lanes()).unwrap();
    // Every second lane leaves borders between what it touches and what not.
    let half = Plan {
        strokes: whole.strokes.iter().step_by(2).cloned().collect(),
        ..whole.clone()
    };
    task.particles = ParticleDistribution::new(&charted).unwrap();
    let count = places.len() as f64;
    let area = sum_areas(mesh).last().copied().unwrap();
    let [whole_swept, half_swept] = [&whole, &half].map(|plan| {
        let poses: Vec<Pose> = (sweep(&task, plan, &world_from_mesh).iter())
            .map(|pose| pose * fault)
            .collect();
        press(&places, &poses, count / area)
    });
    let predicted = predict(&task, &half, |_| ()).particles;
    let is_predicted = |i| matches!(predicted.fate(i), Fate::Treated { passes } if passes > 0.5);
    let otherwise = (0..places.len()).filter(|&i| is_predicted(i) != half_swept.touched[i]);
    let touched = whole_swept.touched.iter().filter(|&&touched| touched);
    let found = Comparison {
        otherwise: otherwise.count() as f64 / count,
        touched: touched.count() as f64 / count,
        lean: whole_swept.lean,
    };
    println!(
        "{name}: {:.3} % touched otherwise than predicted, {:.3} % touched, lean {:.2}°, {} strokes of {:.2} m",
        100.0 * found.otherwise,
        100.0 * found.touched,
        found.lean.to_degrees(),
        whole.strokes.len(),
        whole.contact_distance()
    );
    found
}

/// Settings of a planner of lanes.
fn lanes() -> PlanConfig {
    PlanConfig {
        strategy: Strategy::Lanes,
        ..PlanConfig::default()
    }
}

/// Centres of square cells of 1 cm in the chart.
fn lattice(task: &Task) -> Vec<Point2> {
    let bounds = Bounds2::from_points(task.surface.outline.outer().iter().copied()).unwrap();
    let cells = (bounds.size() / 0.01).map(|count| count as usize);
    let centres = (0..cells.x).flat_map(|i| (0..cells.y).map(move |j| [i, j]));
    centres
        .map(|[i, j]| bounds.min + nalgebra::Vector2::new(i as f64 + 0.5, j as f64 + 0.5) * 0.01)
        .filter(|at| task.surface.outline.contains(*at))
        .collect()
}

#[test]
fn a_plan_over_a_mesh_touches_in_space_what_it_predicts() {
    // A smooth mesh may be off by 1°, the door by 3° at its crease.
    for (name, mesh, lean) in [
        ("cylinder", curved_meshes::pipe(0.5), 1.0_f64),
        ("saddle", curved_meshes::saddle(), 1.0),
        ("door", curved_meshes::door(), 3.0),
    ] {
        let found = compare_with_sweep(name, &mesh, &Pose::identity());
        assert!(found.otherwise <= OTHERWISE, "{name}: {found:?}");
        assert!(found.touched >= TOUCHED, "{name}: {found:?}");
        assert!(found.lean <= lean.to_radians(), "{name}: {found:?}");
    }
    // The sweep sees a tool that is 1 cm beside its place, 1.5 cm over it, or leans by 5°.
    let seen = |fault: Pose| compare_with_sweep("planted fault", &curved_meshes::saddle(), &fault);
    let beside = seen(Pose::translation(0.0, 0.01, 0.0));
    assert!(beside.otherwise > OTHERWISE, "{beside:?}");
    let above = seen(Pose::translation(0.0, 0.0, 0.015));
    assert!(above.touched < TOUCHED, "{above:?}");
    let leaning = seen(Pose::new(
        Vector3::zeros(),
        Vector3::x() * 5.0_f64.to_radians(),
    ));
    assert!(leaning.lean > 3.0_f64.to_radians(), "{leaning:?}");
}

#[test]
fn plans_over_all_patches_of_a_mesh_touch_what_one_chart_does_not() {
    for (name, mesh, most_patches) in [
        ("wok", curved_meshes::bowl(0.25), 8),
        ("dome", curved_meshes::dome(0.30), 8),
        ("bathtub", curved_meshes::bathtub(), 12),
    ] {
        let task = polish_with_pad();
        let atlas = Arc::new(Atlas::from_mesh(&mesh, &config(&task), MAX_CHARTS).unwrap());
        let count = atlas.charts().len();
        assert!((2..=most_patches).contains(&count), "{name}: {count}");
        let places = draw_places(&mesh, PLACES);
        let density = places.len() as f64 / sum_areas(&mesh).last().unwrap();
        let mut touched = vec![false; places.len()];
        let (mut strokes, mut way, mut lean) = (0, 0.0, 0.0_f64);
        for index in 0..count {
            let (shape, pose) = MeshShape::from_patch(&mesh, &atlas, index);
            let (mut task, world_from_mesh) = roll(task.clone(), shape, pose);
            task.particles = ParticleDistribution::new(&lattice(&task)).unwrap();
            let plan = plan(&task, &lanes()).unwrap();
            let swept = press(&places, &sweep(&task, &plan, &world_from_mesh), density);
            for (known, new) in touched.iter_mut().zip(swept.touched) {
                *known |= new;
            }
            strokes += plan.strokes.len();
            way += plan.contact_distance();
            lean = lean.max(swept.lean);
        }
        let share = touched.iter().filter(|&&touched| touched).count() as f64 / places.len() as f64;
        println!(
            "{name}: {:.3} % touched, {count} patches, {strokes} strokes of {way:.2} m, lean {:.2}°",
            100.0 * share,
            lean.to_degrees()
        );
        assert!(share >= TOUCHED_BY_PATCHES, "{name}: {share}");
    }
}
