//! Random tasks for planning: surfaces, tools, objects and dirt of all shapes.

use crate::parts::{interaction, sponge};
use crate::shipped::AnyError;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Region, Vector2, Vector3};
use wisch::represent::{
    Action, Cluster, DirtArea, OccupiedArea, SceneObject, ScenePart, Surface, Task, Tool,
    cluster_particles, uniform_particles,
};

/// Returns the task of a seed: any action with any tool on any surface, which may have notches, holes and objects on
/// it.
///
/// # Errors
/// If the objects leave no space for dirt on the surface.
pub fn any_task(seed: u64) -> Result<Task, AnyError> {
    let random = &mut ChaCha8Rng::seed_from_u64(seed);
    let action = Action::WIPING[random.random_range(0..Action::WIPING.len())];
    let outline = outline(random);
    let edges = outline.outer().len();
    let count = random.random_range(1..=edges);
    let first = random.random_range(0..edges);
    let scene = scene(random, &outline)?;
    let occupied = OccupiedArea::from_scene(
        scene
            .iter()
            .map(|object| object.mesh.transform(&object.world_from_object))
            .collect::<Vec<_>>()
            .iter(),
    );
    let area = DirtArea {
        outline: &outline,
        occupied: &occupied,
    };
    let particles = random.random_range(20..=120);
    let particles = if random.random_bool(0.3) {
        uniform_particles(area, particles, seed)?
    } else {
        let clusters: Vec<Cluster> = (0..random.random_range(1..=4))
            .map(|_| Cluster {
                center: somewhere(random, &outline),
                sigma: random.random_range(0.01..0.1),
                weight: random.random_range(0.2..1.0),
            })
            .collect();
        cluster_particles(area, &clusters, particles, seed)?
    };
    let collect_goal = random.random_bool(0.5).then(|| somewhere(random, &outline));
    Ok(Task {
        name: format!("task {seed}"),
        action,
        surface: Surface {
            name: "surface".into(),
            world_from_surface: Pose::identity(),
            skim_edges: (first..first + count).map(|edge| edge % edges).collect(),
            shape: Default::default(),
            outline,
        },
        scene,
        tool: tool(random)?,
        medium: "breadcrumbs".into(),
        interaction: interaction(),
        particles,
        collect_goal,
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::origin(),
        seed,
    })
}

/// Returns a rectangle, an L or a star of five to nine corners; a third of them with a hole.
fn outline(random: &mut impl Rng) -> Polygon {
    let size = Vector2::new(
        random.random_range(0.3..1.5),
        random.random_range(0.25..0.9),
    );
    let at = |x: f64, y: f64| Point2::new(size.x * x, size.y * y);
    let outer = match random.random_range(0..3) {
        0 => vec![at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)],
        1 => {
            let (x, y) = (
                random.random_range(-0.1..0.3),
                random.random_range(-0.1..0.3),
            );
            vec![
                at(-0.5, -0.5),
                at(0.5, -0.5),
                at(0.5, y),
                at(x, y),
                at(x, 0.5),
                at(-0.5, 0.5),
            ]
        }
        _ => {
            let corners = random.random_range(5..=9);
            let corner = |i: usize| {
                let angle = TAU * i as f64 / corners as f64;
                let reach = random.random_range(0.3..0.5);
                at(reach * libm::cos(angle), reach * libm::sin(angle))
            };
            (0..corners).map(corner).collect()
        }
    };
    let holes = if random.random_bool(0.3) {
        // About the centre, within the narrowest star.
        let half = size.min() * random.random_range(0.05..0.15);
        let corner = |x: f64, y: f64| Point2::new(x * half - 0.1 * size.x, y * half - 0.1 * size.y);
        vec![vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(0.0, 1.0),
        ]]
    } else {
        Vec::new()
    };
    Polygon::new(outer, holes)
}

/// Returns up to four boxes and cylinders on the surface.
fn scene(random: &mut impl Rng, outline: &Polygon) -> Result<Vec<SceneObject>, AnyError> {
    (0..random.random_range(0..=4))
        .map(|number| {
            let mut length = || random.random_range(0.02..0.12);
            let (a, b) = (length(), length());
            let mesh = if random.random_bool(0.5) {
                Mesh::cuboid(Vector3::new(a, b, 0.1))?
            } else {
                Mesh::cylinder(a / 2.0, 0.1, 24)?
            };
            let place = somewhere(random, outline);
            Ok(SceneObject {
                name: format!("thing {number}"),
                part: ScenePart::Obstacle,
                mesh,
                world_from_object: Pose::translation(place.x, place.y, 0.05),
            })
        })
        .collect()
}

/// Returns a box, a triangle, a disc or an angle of any depth and width.
fn tool(random: &mut impl Rng) -> Result<Tool, AnyError> {
    let size = Vector2::new(
        random.random_range(0.02..0.12),
        random.random_range(0.05..0.25),
    );
    let at = |x: f64, y: f64| Point2::new(size.x * x, size.y * y);
    let footprint = match random.random_range(0..4) {
        0 => Polygon::rectangle(size),
        1 => Polygon::new(
            vec![at(-0.5, -0.5), at(0.5, 0.0), at(-0.5, 0.5)],
            Vec::new(),
        ),
        2 => {
            let corner = |i: usize| {
                let angle = TAU * i as f64 / 16.0;
                at(0.5 * libm::cos(angle), 0.5 * libm::sin(angle))
            };
            Polygon::new((0..16).map(corner).collect(), Vec::new())
        }
        _ => {
            let corners = [
                (-0.5, -0.5),
                (0.5, -0.5),
                (0.5, -0.2),
                (0.0, -0.2),
                (0.0, 0.5),
                (-0.5, 0.5),
            ];
            Polygon::new(corners.map(|(x, y)| at(x, y)).to_vec(), Vec::new())
        }
    };
    let tool_from_mesh = Pose::translation(0.0, 0.0, 0.025);
    Ok(Tool {
        name: "tool".into(),
        mesh: Mesh::cuboid(Vector3::new(size.x, size.y, 0.05))?.transform(&tool_from_mesh),
        footprint: Region::new(vec![footprint]),
        area_of_effect: size,
        ..sponge()
    })
}

/// Returns a point on a surface.
fn somewhere(random: &mut impl Rng, outline: &Polygon) -> Point2 {
    loop {
        let place = Point2::new(
            random.random_range(-0.75..0.75),
            random.random_range(-0.45..0.45),
        );
        if outline.contains(place) {
            return place;
        }
    }
}
