//! Distances of solids against parry's shapes, which share no closed form with them.

use super::super::frame::Frame;
use super::super::{Collision, Shape};
use super::mesh;
use super::solid::distance;
use crate::geometry::{Mesh, Point3, Pose, Vector3};
use nalgebra::{Translation3, UnitQuaternion};
use parry3d_f64::math::{Pose as ParryPose, Rotation, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::{Ball, ConvexPolyhedron, Cuboid, Cylinder, Segment, Shape as ParryShape};
use proptest::prelude::*;

fn parry_pose(pose: &Pose) -> ParryPose {
    let (t, q) = (pose.translation.vector, pose.rotation);
    let rotation = Rotation::from_xyzw(q.i, q.j, q.k, q.w);
    ParryPose::from_parts(Vector::new(t.x, t.y, t.z), rotation)
}

fn pose() -> impl Strategy<Value = Pose> {
    let coordinate = -1.0..1.0f64;
    let turn = [coordinate.clone(), coordinate.clone(), coordinate.clone()];
    ([coordinate.clone(), coordinate.clone(), coordinate], turn).prop_map(|(t, r)| {
        let rotation = UnitQuaternion::from_scaled_axis(3.0 * Vector3::from(r));
        Pose::from_parts(Translation3::from(Vector3::from(t)), rotation)
    })
}

/// Returns a solid of each kind, and the corresponding shape of parry.
fn solid(kind: usize, [a, b, c]: [f64; 3]) -> (Shape, Box<dyn ParryShape>) {
    match kind {
        0 => (Shape::Sphere { radius: a }, Box::new(Ball::new(a))),
        // Parry has a closed form for segments, but none for capsules.
        1 => {
            let ends = [-0.5, 0.5].map(|side| Vector::new(0.0, 0.0, side * b));
            let shape = Shape::Capsule {
                radius: a,
                length: b,
            };
            (shape, Box::new(Segment::new(ends[0], ends[1])))
        }
        2 => {
            let size = Vector3::new(a, b, c);
            (
                Shape::Box { size },
                Box::new(Cuboid::new(Vector::new(a, b, c) / 2.0)),
            )
        }
        3 => {
            // Parry's is along y.
            let shape = Shape::Cylinder {
                radius: a,
                length: b,
            };
            (shape, Box::new(Cylinder::new(b / 2.0, a)))
        }
        _ => {
            let mesh = Mesh::cylinder(a, b, 7).unwrap();
            let points: Vec<Vector> = mesh
                .vertices()
                .iter()
                .map(|p| Vector::new(p.x, p.y, p.z))
                .collect();
            let hull = ConvexPolyhedron::from_convex_hull(&points).unwrap();
            (Shape::Mesh(mesh), Box::new(hull))
        }
    }
}

fn ours(link_from_shape: Pose, shape: Shape) -> (Frame, super::solid::Solid) {
    let (placed, solid) = mesh::of_shape(&Collision {
        link_from_shape,
        shape,
    });
    (Frame::from_pose(&placed), solid)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn distances_are_those_of_parry(
        kinds in [0..5usize, 0..5usize],
        sizes in [[0.05..0.6f64, 0.05..0.6, 0.05..0.6], [0.05..0.6f64, 0.05..0.6, 0.05..0.6]],
        poses in [pose(), pose()],
    ) {
        let [(shape_a, parry_a), (shape_b, parry_b)] = [0, 1].map(|i| solid(kinds[i], sizes[i]));
        let parry_at = |i: usize| {
            let y_to_z = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2);
            let turned = if kinds[i] == 3 { poses[i] * y_to_z } else { poses[i] };
            parry_pose(&turned)
        };
        let of_cores = query::distance(&parry_at(0), &*parry_a, &parry_at(1), &*parry_b)
            .unwrap()
            .distance;
        let radius = |i: usize| if kinds[i] == 1 { sizes[i][0] } else { 0.0 };
        let expected = of_cores - radius(0) - radius(1);
        let (a, b) = (ours(poses[0], shape_a), ours(poses[1], shape_b));
        let found = distance((&a.1, &a.0), (&b.1, &b.0), f64::INFINITY);
        let swapped = distance((&b.1, &b.0), (&a.1, &a.0), f64::INFINITY);
        // Where there is no closed form, the method has a relative tolerance of 5e-8, but may stop
        // short of it where a surface is curved.
        let is_round = kinds.iter().all(|&kind| kind < 2);
        let is_curved = kinds.contains(&3);
        let tolerance = if is_round { 1e-9 } else if is_curved { 1e-5 } else { 2e-7 };
        prop_assert!((found - swapped).abs() < tolerance);
        if expected > 0.0 {
            prop_assert!((found - expected).abs() < tolerance, "{found} and {expected}");
        } else {
            // The depth that `distance` returns is a lower bound.
            prop_assert!(found < 1e-7, "{found} though they intersect");
        }
        // A distance that is not below the limit counts as infinite.
        prop_assert_eq!(distance((&a.1, &a.0), (&b.1, &b.0), found.max(0.0)).is_finite(), found < 0.0);
    }

    #[test]
    fn a_ball_or_capsule_and_a_box_are_as_far_apart_as_brute_force_says(
        from in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        to in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        half in [0.01..0.6f64, 0.01..0.6, 0.01..0.6],
    ) {
        let (from, to, half) = (Vector3::from(from), Vector3::from(to), Vector3::from(half));
        let found = super::solid::segment_box([from, to], &half);
        // Golden section on a convex function.
        let at = |t: f64| {
            let p = from + t * (to - from);
            (p - p.zip_map(&half, |x, h| x.clamp(-h, h))).norm()
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..200 {
            let (a, b) = (low + (high - low) * 0.382, low + (high - low) * 0.618);
            if at(a) < at(b) { high = b } else { low = a }
        }
        prop_assert!((found - at((low + high) / 2.0)).abs() < 1e-9);
    }

    #[test]
    fn nearly_parallel_segments_have_their_distance(
        from in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        tilt in -1e-6..1e-6f64,
        length in 0.0..1.0f64,
    ) {
        // Along x and nearly so, one above the other somewhere.
        let a = [Vector3::zeros(), Vector3::new(1.0, 0.0, 0.0)];
        let start = Vector3::from(from);
        let b = [start, start + length * Vector3::new(1.0, tilt, -tilt)];
        let found = super::solid::segment_segment(a, b);
        let nearest = (0..=1000).map(|i| {
            let p = b[0] + (b[1] - b[0]) * f64::from(i) / 1000.0;
            (p - Vector3::new(p.x.clamp(0.0, 1.0), 0.0, 0.0)).norm()
        }).fold(f64::INFINITY, f64::min);
        prop_assert!(found <= nearest + 1e-9, "{found} {nearest}");
        prop_assert!(found >= nearest - 2e-3, "{found} {nearest}");
    }
}

fn placed(mesh: &Mesh) -> super::Placed {
    mesh::obstacle("it", mesh).unwrap()
}

#[test]
fn boxes_are_recognised_however_they_lie() {
    let size = Vector3::new(0.3, 0.5, 0.2);
    let turn = UnitQuaternion::from_euler_angles(0.4, -0.7, 2.0);
    let pose = Pose::from_parts(Translation3::new(1.0, 2.0, -0.5), turn);
    let cuboid = Mesh::cuboid(size).unwrap();
    let moved = Mesh::new(
        cuboid.vertices().iter().map(|p| pose * p).collect(),
        cuboid.triangles().to_vec(),
    )
    .unwrap();
    for mesh in [&cuboid, &moved] {
        let (_, solid) = placed(mesh);
        assert!(matches!(solid.core, super::solid::Core::Box), "{solid:?}");
        let mut sides: Vec<f64> = solid.half.iter().map(|h| 2.0 * h).collect();
        sides.sort_by(f64::total_cmp);
        for (side, expected) in sides.iter().zip([0.2, 0.3, 0.5]) {
            assert!((side - expected).abs() < 1e-12);
        }
    }
    // A box with one corner pulled out is not a box.
    let mut corners = cuboid.vertices().to_vec();
    corners[7] *= 1.1;
    let odd = Mesh::new(corners, cuboid.triangles().to_vec()).unwrap();
    assert!(!matches!(mesh::hull(&odd).1.core, super::solid::Core::Box));
}

#[test]
fn the_hull_of_many_points_is_inflated_by_the_dropped_ones() {
    let ball = Mesh::sphere(0.1, 60).unwrap();
    let (mesh_from_solid, solid) = mesh::hull(&ball);
    assert!(
        solid.radius > 0.0 && solid.radius < 2e-3,
        "{}",
        solid.radius
    );
    let frame = Frame::from_pose(&mesh_from_solid);
    for p in ball.vertices() {
        let point = ours(
            Pose::translation(p.x, p.y, p.z),
            Shape::Sphere { radius: 0.0 },
        );
        assert!(distance((&solid, &frame), (&point.1, &point.0), f64::INFINITY) < 1e-9);
    }
}

/// An L of two boxes, which is not convex, closed.
fn angle() -> Mesh {
    let outline = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 0.2],
        [0.2, 0.2],
        [0.2, 1.0],
        [0.0, 1.0],
    ];
    let mut vertices = Vec::new();
    for z in [0.0, 0.3] {
        vertices.extend(outline.iter().map(|&[x, y]| Point3::new(x, y, z)));
    }
    let faces: [[u32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = faces.iter().map(|&[a, b, c]| [a, c, b]).collect();
    triangles.extend(faces.iter().map(|face| face.map(|i| i + 6)));
    for i in 0..6u32 {
        let j = (i + 1) % 6;
        triangles.extend([[i, j, j + 6], [i, j + 6, i + 6]]);
    }
    Mesh::new(vertices, triangles).unwrap()
}

fn to_ball(mesh: &Mesh, [x, y, z]: [f64; 3], radius: f64) -> f64 {
    let (pose, solid) = placed(mesh);
    let ball = ours(Pose::translation(x, y, z), Shape::Sphere { radius });
    distance(
        (&solid, &Frame::from_pose(&pose)),
        (&ball.1, &ball.0),
        f64::INFINITY,
    )
}

#[test]
fn a_closed_surface_is_solid_and_keeps_its_notch() {
    let angle = angle();
    // In the notch it is free, as deep as the walls are away.
    assert!((to_ball(&angle, [0.6, 0.6, 0.15], 0.1) - 0.3).abs() < 1e-7);
    // Wholly inside, far from every triangle.
    assert_eq!(to_ball(&angle, [0.1, 0.5, 0.15], 0.01), -0.01);
    let inside_out = angle
        .triangles()
        .iter()
        .map(|&[a, b, c]| [a, c, b])
        .collect();
    let inside_out = Mesh::new(angle.vertices().to_vec(), inside_out).unwrap();
    assert_eq!(to_ball(&inside_out, [0.1, 0.5, 0.15], 0.01), -0.01);
    assert!((to_ball(&inside_out, [0.6, 0.6, 0.15], 0.1) - 0.3).abs() < 1e-7);
}

#[test]
fn an_open_surface_is_only_its_triangles() {
    let angle = angle();
    let open = Mesh::new(angle.vertices().to_vec(), angle.triangles()[1..].to_vec()).unwrap();
    assert!((to_ball(&open, [0.1, 0.5, 0.15], 0.01) - 0.09).abs() < 1e-7);
}

#[test]
fn flat_and_thin_meshes_have_distances() {
    let corner = [
        Point3::origin(),
        Point3::new(1.0, 0.0, 0.0),
        Point3::new(0.0, 1.0, 0.0),
    ];
    let sheet = Mesh::new(corner.to_vec(), vec![[0, 1, 2]]).unwrap();
    let line = Mesh::new(vec![corner[0], corner[1], corner[1]], vec![[0, 1, 2]]).unwrap();
    let point = Mesh::new(vec![corner[0]; 3], vec![[0, 1, 2]]).unwrap();
    for mesh in [&sheet, &line, &point] {
        assert!((to_ball(mesh, [0.0, 0.0, 0.5], 0.1) - 0.4).abs() < 1e-7);
        let (pose, solid) = mesh::hull(mesh);
        let ball = ours(
            Pose::translation(0.0, 0.0, 0.5),
            Shape::Sphere { radius: 0.1 },
        );
        let frame = Frame::from_pose(&pose);
        let apart = distance((&solid, &frame), (&ball.1, &ball.0), f64::INFINITY);
        assert!((apart - 0.4).abs() < 1e-7);
    }
}
