//! The shapes of the shipped tools. Tool frame: origin (the TCP) at the centre of the contact face,
//! z up out of the surface, x along the motion, y along the broad side; metres.

use std::f64::consts::TAU;
use wisch_robot::geometry::{Mesh, MeshError, Point2, Point3, Pose, Vector2};

/// A tool and the file it is written to.
pub struct ToolMesh {
    pub file_name: &'static str,
    pub mesh: Mesh,
}

/// All shipped tools.
pub fn all() -> Result<Vec<ToolMesh>, MeshError> {
    let tools = [
        ("sponge.stl", sponge()?),
        ("broom.stl", broom()?),
        ("window_wiper.stl", window_wiper()?),
        ("brush.stl", brush()?),
        ("vacuum_nozzle.stl", vacuum_nozzle()?),
    ];
    Ok(tools
        .map(|(file_name, mesh)| ToolMesh { file_name, mesh })
        .into())
}

/// The paper's sponge, its broad side across the motion: the footprint is the area of effect.
fn sponge() -> Result<Mesh, MeshError> {
    block([0.07, 0.11], 0.0, 0.05)
}

/// Rows and columns of a broom's tufts, and the spacing of both [m].
pub const BROOM_TUFTS: [u32; 2] = [5, 36];
const BROOM_PITCH: [f64; 2] = [0.0115, 0.011];
/// By how much of the spacing each row is shifted along y.
const BROOM_SHIFTS: [f64; 5] = [0.25, -0.25, 0.0, 0.25, -0.25];
/// Length of a broom's stick [m].
const BROOM_STICK: f64 = 1.26;

/// Circumradius of a broom's tuft at its tip [m].
pub const BROOM_TUFT_RADIUS: f64 = 0.0045;

/// A 0.06 × 0.40 m head on bristles of some 60 mm, in hexagonal tufts that taper towards the tip.
/// Rows are shifted against each other, so that no lane along x stays open. Half a turn maps it onto itself.
/// The stick stands upright, and is as long as two hands need who sweep standing: up to 1.36 m.
fn broom() -> Result<Mesh, MeshError> {
    const BRISTLES: f64 = 0.060;
    let tufts = lattice(BROOM_TUFTS, BROOM_PITCH)
        .enumerate()
        .map(|(i, center)| {
            // Worn unevenly by 0 to 1 mm; the outermost tufts, full length, touch first.
            let i = i as u32;
            let opposite = BROOM_TUFTS[0] * BROOM_TUFTS[1] - 1 - i;
            let wear = 1e-4 * f64::from(i.min(opposite) * 7 % 11);
            let shift = BROOM_SHIFTS[(i / BROOM_TUFTS[1]) as usize] * BROOM_PITCH[1];
            let center = center + Vector2::new(0.0, shift);
            let tip = polygon(6, BROOM_TUFT_RADIUS, center);
            let root = polygon(6, 1.1 * BROOM_TUFT_RADIUS, center);
            loft(&[(tip, wear), (root, BRISTLES + SUNK)])
        });
    let head = block([0.06, 0.40], BRISTLES, BRISTLES + 0.04);
    let stick = handle(0.0125, BRISTLES + 0.04, BROOM_STICK);
    joined(tufts.chain([head, stick]))
}

/// A rubber wedge, 4 mm at the contact, in a holder with a handle.
fn window_wiper() -> Result<Mesh, MeshError> {
    let rubber = loft(&[
        (rectangle([0.004, 0.35]), 0.0),
        (rectangle([0.010, 0.35]), 0.03 + SUNK),
    ]);
    let holder = block([0.02, 0.36], 0.03, 0.055);
    joined([rubber, holder, handle(0.0125, 0.055, 0.15)])
}

/// Rows and columns of a brush's tufts, and the spacing of both [m].
pub const BRUSH_TUFTS: [u32; 2] = [5, 12];
const BRUSH_PITCH: [f64; 2] = [0.015, 0.016];

/// Circumradius of a brush's tuft [m].
pub const BRUSH_TUFT_RADIUS: f64 = 0.005;

/// A 0.08 × 0.20 m block on straight eight-sided tufts.
fn brush() -> Result<Mesh, MeshError> {
    const BRISTLES: f64 = 0.030;
    let tufts = lattice(BRUSH_TUFTS, BRUSH_PITCH).map(|center| {
        let section = polygon(8, BRUSH_TUFT_RADIUS, center);
        loft(&[(section.clone(), 0.0), (section, BRISTLES + SUNK)])
    });
    let back = block([0.08, 0.20], BRISTLES, BRISTLES + 0.02);
    joined(tufts.chain([back]))
}

/// Outer size of a vacuum nozzle and width of its rim [m].
pub const NOZZLE_SIZE: [f64; 2] = [0.09, 0.30];
pub const NOZZLE_RIM: f64 = 0.008;

/// A box with a suction mouth all over its underside but for the rim, and a stub for the hose.
fn vacuum_nozzle() -> Result<Mesh, MeshError> {
    const MOUTH_DEPTH: f64 = 0.03;
    const HEIGHT: f64 = 0.05;
    let outer = rectangle(NOZZLE_SIZE);
    let mouth = rectangle(NOZZLE_SIZE.map(|side| side - 2.0 * NOZZLE_RIM));
    // One closed surface: lid, walls, underside of the rim, walls of the mouth, roof of the mouth.
    let body = loft(&[
        (mouth.clone(), MOUTH_DEPTH),
        (mouth, 0.0),
        (outer.clone(), 0.0),
        (outer, HEIGHT),
    ]);
    joined([body, handle(0.02, HEIGHT, 0.12)])
}

/// How far parts that are joined reach into each other [m].
const SUNK: f64 = 0.002;

/// A box over the rectangle of the given size about z, from one height to another.
fn block(size: [f64; 2], bottom: f64, top: f64) -> Result<Mesh, MeshError> {
    loft(&[(rectangle(size), bottom), (rectangle(size), top)])
}

/// A round stub that stands on the tool.
fn handle(radius: f64, foot: f64, length: f64) -> Result<Mesh, MeshError> {
    let height = length + SUNK;
    let lifted = Pose::translation(0.0, 0.0, foot - SUNK + height / 2.0);
    Ok(Mesh::cylinder(radius, height, 24)?.transform(&lifted))
}

fn joined(parts: impl IntoIterator<Item = Result<Mesh, MeshError>>) -> Result<Mesh, MeshError> {
    Mesh::merge(parts.into_iter().collect::<Result<Vec<_>, _>>()?)
}

/// Points of a lattice centred on the origin: `counts` and `pitch` along x and y.
fn lattice(counts: [u32; 2], pitch: [f64; 2]) -> impl Iterator<Item = Point2> {
    let at =
        move |axis: usize, i: u32| pitch[axis] * (f64::from(i) - f64::from(counts[axis] - 1) / 2.0);
    (0..counts[0]).flat_map(move |i| (0..counts[1]).map(move |j| Point2::new(at(0, i), at(1, j))))
}

/// A regular polygon, counter-clockwise.
fn polygon(corners: u32, radius: f64, center: Point2) -> Vec<Point2> {
    let angle = |i: u32| TAU * f64::from(i) / f64::from(corners);
    (0..corners)
        .map(|i| center + radius * Vector2::new(angle(i).cos(), angle(i).sin()))
        .collect()
}

fn rectangle(size: [f64; 2]) -> Vec<Point2> {
    let [x, y] = size.map(|side| side / 2.0);
    [(-x, -y), (x, -y), (x, y), (-x, y)]
        .map(|(x, y)| Point2::new(x, y))
        .to_vec()
}

/// A surface through convex rings of equally many corners at their heights, closed by both end rings.
fn loft(rings: &[(Vec<Point2>, f64)]) -> Result<Mesh, MeshError> {
    let n = rings[0].0.len() as u32;
    let vertices = rings
        .iter()
        .flat_map(|(ring, z)| ring.iter().map(|p| Point3::new(p.x, p.y, *z)));
    let last = (rings.len() as u32 - 1) * n;
    let ends = (1..n - 1).flat_map(|i| [[0, i + 1, i], [last, last + i, last + i + 1]]);
    let walls = (0..last / n).flat_map(|ring| {
        (0..n).flat_map(move |i| {
            let (a, b) = (ring * n + i, ring * n + (i + 1) % n);
            [[a, b, b + n], [a, b + n, a + n]]
        })
    });
    Mesh::new(vertices.collect(), ends.chain(walls).collect())
}
