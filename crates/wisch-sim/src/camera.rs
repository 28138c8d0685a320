//! A simulated camera straight above the real surface.

use crate::{Dirt, SimulationSettings};
use nalgebra::{Point, SVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};
use wisch::follow::Workcell;
use wisch::geometry::{Bounds2, Mesh, Point2, Point3, Polygon, Pose, Region, Vector2, Vector3};
use wisch::random::normal_pair;
use wisch::represent::{Fate, Observation, Surface, SurfaceShape, Task};
use wisch::robot::{RobotError, Shape};

/// Separates the random numbers of observations from those of a task with the same seed.
const OBSERVATION_SEED: u64 = 0x6c6f_6f6b_7300_0000;
/// Number of points around the rim of a cylinder, a capsule or a sphere.
const RIM: usize = 16;
/// Number of draws after which a false alarm falls beside the surface.
const DRAWS: usize = 10_000;

/// Largest angle between the normal of a place and the camera's axis at which the place is seen [rad].
const WIDEST_VIEW: f64 = PI / 3.0;
/// Largest length of the edges of hulls that hide a curved surface [m]: on the surface, straight
/// edges are bent.
const HULL_STEP: f64 = 0.02;
/// Largest number of cells of a cone's or mesh's chart that are examined.
const MOST_CELLS: f64 = 10_000.0;

/// Identifies an observation by world, round and number, so that it can be drawn again.
#[derive(Debug, Clone, Copy)]
pub struct ObservationIndex {
    /// Seed of the world.
    pub seed: u64,
    /// Number of rounds so far.
    pub rounds: u64,
    /// Number of observations since the last round.
    pub number: u64,
}

/// Returns what the camera detects, in the believed surface frame; `None` without a camera.
///
/// `dirt` is the ground truth, and `hidden` the convex hulls that hide it, in the xy plane of the real surface's frame
/// [m]. Each visible grain is detected with a probability by its diameter, at a position with normal error; false alarms
/// are Poisson distributed over the outline. Places that lean away from the camera by more than 60°
/// count as hidden.
pub fn observe(
    settings: &SimulationSettings,
    task: &Task,
    real: &Surface,
    dirt: &Dirt,
    hidden: &[Vec<Point2>],
    index: ObservationIndex,
) -> Option<Observation> {
    let sensor = settings.camera?.sensor;
    let mut random = ChaCha8Rng::seed_from_u64(index.seed ^ OBSERVATION_SEED);
    random.set_stream((index.rounds << 32) | index.number);
    let surface = &task.surface;
    let believed_from_real = surface.world_from_surface.inverse() * real.world_from_surface;
    // An object at a point of space appears on the believed surface below it.
    let believed = |point: Point3| surface.shape.place_below((believed_from_real * point).xy());
    let polygon = |hull: &Vec<Point2>| Polygon::new(hull.clone(), vec![]);
    let hidden_in_real = Region::new(hidden.iter().map(polygon).collect());
    let mut seen = Observation {
        detections: Vec::new(),
        hidden: project_hidden(surface, &believed_from_real, hidden),
    };
    for grain in dirt.grains() {
        // Drawn for every grain, visible or not, so that the fate of one grain changes no other detection.
        let (chance, error) = (random.random::<f64>(), normal_pair(&mut random));
        let in_real =
            |place: Point2| -> Point3 { real.shape.place(place, 0.0).translation.vector.into() };
        let is_hidden = is_turned_away(&real.shape, grain.position)
            || hidden_in_real.contains(in_real(grain.position).xy());
        let lies = grain.fate == Fate::OnSurface && !is_hidden;
        if lies && chance < sensor.detection_of(2.0 * grain.radius) {
            let place = grain.position + error * sensor.position_error_m;
            seen.detections.extend(believed(in_real(place)));
        }
    }
    let outline = &task.surface.outline;
    let bounds = Bounds2::from_points(outline.outer().iter().copied())?;
    let expected = sensor.false_alarms_per_m2 * outline.area();
    for _ in 0..poisson(expected, &mut random) {
        let mut places = (0..DRAWS).map(|_| {
            let share = Vector2::new(random.random(), random.random());
            bounds.min + bounds.size().component_mul(&share)
        });
        let place = places.find(|place| outline.contains(*place));
        let shown = place.filter(|place| !seen.is_hidden(*place));
        seen.detections.extend(shown);
    }
    Some(seen)
}

/// Whether a place leans too far away from the camera to be seen.
fn is_turned_away(shape: &SurfaceShape, place: Point2) -> bool {
    match shape {
        SurfaceShape::Cone(_) | SurfaceShape::Mesh(_) => {
            (shape.orientation(place) * Vector3::z()).angle(&Vector3::z()) > WIDEST_VIEW
        }
        _ => shape.turn_between(Point2::origin(), place) > WIDEST_VIEW,
    }
}

/// Returns the area of the believed surface that the camera does not see, in its chart: behind
/// `hidden`, hulls in the xy plane of the real surface's frame [m], and where the surface leans too
/// far away.
fn project_hidden(surface: &Surface, believed_from_real: &Pose, hidden: &[Vec<Point2>]) -> Region {
    let believed = |place: &Point2| (believed_from_real * Point3::new(place.x, place.y, 0.0)).xy();
    let hulls = hidden
        .iter()
        .map(|hull| hull.iter().map(believed).collect());
    let (radius, axis) = match &surface.shape {
        SurfaceShape::Plane => {
            let polygons = hulls.map(|ring| Polygon::new(ring, vec![]));
            return Region::new(polygons.collect());
        }
        SurfaceShape::Cone(_) | SurfaceShape::Mesh(_) => return hidden_cells(surface, hulls),
        &SurfaceShape::Cylinder { radius, axis } => (radius, axis),
    };
    let along = Vector2::new(libm::cos(axis), libm::sin(axis));
    let across = Vector2::new(-along.y, along.x);
    let places = surface.outline.outer();
    let most = |along: Vector2| {
        let reach = places.iter().map(|p| along.dot(&p.coords).abs());
        reach.fold(0.0, f64::max)
    };
    let (length, reach) = (most(along), most(across));
    // An overhanging rim of a hollow hides what lies below it.
    let view = if radius < 0.0 {
        WIDEST_VIEW.min(PI - reach / radius.abs())
    } else {
        WIDEST_VIEW
    };
    // A hull is limited to the part of the surface that does not lean away.
    let widest = radius.abs() * libm::sin(view);
    let on_surface = |point: Point2| {
        let (v, u) = (along.dot(&point.coords), across.dot(&point.coords));
        let seen = Point2::from(along * v + across * u.clamp(-widest, widest));
        surface.shape.place_below(seen).unwrap_or(seen)
    };
    let mut polygons: Vec<Polygon> = hulls
        .map(|ring: Vec<Point2>| {
            let fine = subdivide(&ring, HULL_STEP);
            Polygon::new(fine.into_iter().map(on_surface).collect(), vec![])
        })
        .collect();
    let border = radius.abs() * view;
    if reach > border {
        for [near, far] in [[border, reach], [-reach, -border]] {
            let corner = |v: f64, u: f64| Point2::from(along * v + across * u);
            let strip = vec![
                corner(-length, near),
                corner(length, near),
                corner(length, far),
                corner(-length, far),
            ];
            polygons.push(Polygon::new(strip, vec![]));
        }
    }
    Region::new(polygons)
}

/// Returns the square cells of a chart that a camera does not see: those behind hulls, in the xy plane of the surface's
/// frame [m], those that lean too far away, and those below another part of a cylinder or a mesh.
fn hidden_cells(surface: &Surface, hulls: impl Iterator<Item = Vec<Point2>>) -> Region {
    let hulls = Region::new(hulls.map(|ring| Polygon::new(ring, vec![])).collect());
    let Some(bounds) = Bounds2::from_points(surface.outline.outer().iter().copied()) else {
        return hulls;
    };
    let size = bounds.size();
    let cell = HULL_STEP.max((size.x * size.y / MOST_CELLS).sqrt());
    let [columns, rows] = [size.x, size.y].map(|side| (side / cell).ceil() as usize);
    let is_hidden = |place: Point2| {
        let point = surface.shape.place(place, 0.0).translation.vector.xy();
        is_turned_away(&surface.shape, place)
            || hulls.contains(point.into())
            || surface
                .shape
                .place_below(point.into())
                .is_none_or(|seen| (seen - place).norm() > cell)
    };
    let mut strips = Vec::new();
    for row in 0..rows {
        let y = bounds.min.y + cell * row as f64;
        let middle = |column: usize| {
            Point2::new(bounds.min.x + cell * (column as f64 + 0.5), y + 0.5 * cell)
        };
        let hidden: Vec<bool> = (0..columns)
            .map(|column| {
                let place = middle(column);
                surface.outline.contains(place) && is_hidden(place)
            })
            .collect();
        let mut first = 0;
        for group in hidden.chunk_by(|one, other| one == other) {
            let last = first + group.len();
            if group[0] {
                let x = [first, last].map(|column| bounds.min.x + cell * column as f64);
                let corners = [[x[0], y], [x[1], y], [x[1], y + cell], [x[0], y + cell]];
                strips.push(Polygon::new(corners.map(Point2::from).to_vec(), vec![]));
            }
            first = last;
        }
    }
    Region::new(strips)
}

/// Returns a ring with points added so that no edge is longer than `step` [m].
fn subdivide(ring: &[Point2], step: f64) -> Vec<Point2> {
    let next = ring.iter().cycle().skip(1);
    let edges = ring.iter().zip(next);
    edges
        .flat_map(|(from, to)| {
            let along = to - from;
            let parts = (along.norm() / step).ceil().max(1.0) as usize;
            (0..parts).map(move |i| from + along * (i as f64 / parts as f64))
        })
        .collect()
}

/// Draws from the Poisson distribution: the number of unit exponential gaps that fit into `mean`.
fn poisson(mean: f64, random: &mut ChaCha8Rng) -> usize {
    let gaps = std::iter::repeat_with(|| -libm::log(1.0 - random.random::<f64>()));
    let ends = gaps.scan(0.0, |end, gap| {
        *end += gap;
        Some(*end)
    });
    ends.take_while(|end| *end < mean).count()
}

/// Returns the hulls that hide the real surface from a camera straight above it: the convex hull of
/// each solid of robot and tool that rises above the surface, in the xy plane of that surface's
/// frame [m].
///
/// `positions` are the robot's variables [rad or m], `tool` the vertices of the tool's parts in its own frame [m].
///
/// # Errors
/// If `positions` do not match the robot's variables.
pub fn hide_behind(
    cell: &Workcell,
    positions: &[f64],
    tool: &[Vec<Point3>],
    tip_from_tool: &Pose,
    real: &Surface,
) -> Result<Vec<Vec<Point2>>, RobotError> {
    let robot = cell.robot();
    let kinematics = robot.forward_kinematics(positions)?;
    let real_from_root = real.world_from_surface.inverse() * cell.world_from_root();
    let places = real.outline.outer().iter();
    let heights = places.map(|place| real.shape.place(*place, 0.0).translation.z);
    let lowest = heights.fold(0.0, f64::min);
    let mut hulls = Vec::new();
    let mut add = |real_from_solid: &Pose, corners: &[Point3]| {
        let corners: Vec<Point3> = corners.iter().map(|p| real_from_solid * p).collect();
        if corners.iter().any(|corner| corner.z > lowest) {
            hulls.push(hull(corners.iter().map(Point::xy).collect()));
        }
    };
    for link in robot.links() {
        let real_from_link = real_from_root * kinematics.world_from_link(robot.link(&link.name)?);
        for collision in &link.collision {
            let real_from_shape = real_from_link * collision.link_from_shape;
            add(&real_from_shape, &corners(&collision.shape));
        }
    }
    let real_from_tool = real_from_root * kinematics.world_from_link(cell.tip()) * tip_from_tool;
    tool.iter().for_each(|part| add(&real_from_tool, part));
    Ok(hulls)
}

/// Returns points whose convex hull is the shape; round shapes become prisms.
fn corners(shape: &Shape) -> Vec<Point3> {
    let ring = |radius: f64, z: f64| {
        (0..RIM).map(move |i| {
            let angle = TAU * i as f64 / RIM as f64;
            Point3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
        })
    };
    let ball = |radius: f64, z: f64| {
        let slices = (0..=RIM / 2).map(move |i| TAU * i as f64 / RIM as f64);
        slices.flat_map(move |polar| {
            let (sin, cos) = (libm::sin(polar), libm::cos(polar));
            ring(radius * sin, z + radius * cos)
        })
    };
    match shape {
        Shape::Box { size } => {
            let sides = [-0.5, 0.5];
            let corner = |x, y, z| Point3::from(size.component_mul(&SVector::from([x, y, z])));
            let faces = sides.map(|x| sides.map(|y| sides.map(|z| corner(x, y, z))));
            faces.as_flattened().as_flattened().to_vec()
        }
        Shape::Cylinder { radius, length } => [-0.5, 0.5]
            .into_iter()
            .flat_map(|end| ring(*radius, end * length))
            .collect(),
        Shape::Capsule { radius, length } => [-0.5, 0.5]
            .into_iter()
            .flat_map(|end| ball(*radius, end * length))
            .collect(),
        Shape::Sphere { radius } => ball(*radius, 0.0).collect(),
        Shape::Mesh(mesh) => Mesh::vertices(mesh).to_vec(),
    }
}

/// Returns the convex hull of the points, anticlockwise (Andrew's monotone chain, 1979).
pub(crate) fn hull(mut points: Vec<Point2>) -> Vec<Point2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = Point2>| {
        let mut chain: Vec<Point2> = Vec::new();
        for point in points {
            while let [.., before, last] = chain[..]
                && (last - before).perp(&(point - last)) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Vector3;

    #[test]
    fn a_hull_goes_round_its_points_once() {
        let inner = [(0.2, 0.3), (0.5, 0.5), (0.5, 0.0), (1.0, 1.0)];
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let points = inner.iter().chain(&corners);
        let found = hull(points.map(|&(x, y)| Point2::new(x, y)).collect());
        assert_eq!(found, corners.map(|(x, y)| Point2::new(x, y)));
        assert_eq!(hull(vec![Point2::origin(); 3]).len(), 1);
    }

    #[test]
    fn corners_span_their_shape() {
        let reach = |shape: &Shape, along: Vector3| {
            let corners = corners(shape);
            corners
                .iter()
                .map(|p| p.coords.dot(&along))
                .fold(0.0, f64::max)
        };
        let size = Vector3::new(1.0, 2.0, 3.0);
        let (radius, length) = (0.5, 2.0);
        for (shape, half) in [
            (Shape::Box { size }, [0.5, 1.0, 1.5]),
            (Shape::Cylinder { radius, length }, [0.5, 0.5, 1.0]),
            (Shape::Capsule { radius, length }, [0.5, 0.5, 1.5]),
            (Shape::Sphere { radius }, [0.5; 3]),
        ] {
            for (axis, half) in half.into_iter().enumerate() {
                let found = reach(&shape, Vector3::ith(axis, 1.0));
                assert!((found - half).abs() < 1e-12, "{shape:?}: {found}");
            }
        }
    }
}
