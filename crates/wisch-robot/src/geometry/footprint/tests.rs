use super::*;
use crate::geometry::{Pose, Vector3};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn cuboid(x: f64, y: f64, z: f64) -> Mesh {
    Mesh::cuboid(Vector3::new(x, y, z)).expect("sizes are positive")
}

fn moved(mesh: &Mesh, x: f64, y: f64, z: f64) -> Mesh {
    mesh.transform(&Pose::translation(x, y, z))
}

fn merge(meshes: impl IntoIterator<Item = Mesh>) -> Mesh {
    Mesh::merge(meshes).expect("there are meshes")
}

/// A tube about z from z = 0 to 0.1 m with a wall from 0.03 to 0.04 m radius.
fn tube(segments: u32) -> Mesh {
    let profile = [(0.03, 0.0), (0.04, 0.0), (0.04, 0.1), (0.03, 0.1)];
    let vertices = (0..segments).flat_map(|i| {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(segments)).sin_cos();
        profile.map(|(r, z)| Point3::new(r * cos, r * sin, z))
    });
    let triangles = (0..segments).flat_map(|i| {
        (0..4).flat_map(move |k| {
            let at = |i: u32, k: u32| i % segments * 4 + k % 4;
            let [a, b, c, d] = [at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
            [[a, b, c], [a, c, d]]
        })
    });
    Mesh::new(vertices.collect(), triangles.collect()).expect("the tube is valid")
}

/// The triangles of a mesh that satisfy a condition.
fn only(mesh: &Mesh, keep: impl Fn([Point3; 3]) -> bool) -> Mesh {
    let kept = mesh
        .corners()
        .zip(mesh.triangles())
        .filter(|(corners, _)| keep(*corners));
    let triangles = kept.map(|(_, &t)| t).collect();
    Mesh::new(mesh.vertices().to_vec(), triangles).expect("some are left")
}

/// Every triangle cut into four at the middles of its sides.
fn subdivided(mesh: &Mesh) -> Mesh {
    let mut vertices = Vec::new();
    for [a, b, c] in mesh.corners() {
        let mid = |p: &Point3, q: &Point3| nalgebra::center(p, q);
        let (ab, bc, ca) = (mid(&a, &b), mid(&b, &c), mid(&c, &a));
        vertices.extend([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]);
    }
    let triangles = (0..vertices.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    Mesh::new(vertices, triangles.collect()).expect("as valid as before")
}

fn pieces_and_holes(region: &Region) -> (usize, usize) {
    let holes = region.polygons().iter().map(|p| p.holes().len()).sum();
    (region.polygons().len(), holes)
}

fn regular_polygon_area(radius: f64, corners: u32) -> f64 {
    f64::from(corners) / 2.0 * radius * radius * (TAU / f64::from(corners)).sin()
}

#[test]
fn a_box_leaves_its_rectangle() {
    let region = footprint(&cuboid(0.07, 0.11, 0.05), 0.004).expect("a footprint");
    let [polygon] = region.polygons() else {
        panic!("{region:?}")
    };
    assert!(polygon.holes().is_empty());
    assert_eq!(polygon.outer().len(), 4);
    for corner in polygon.outer() {
        assert!((corner.x.abs() - 0.035).abs() < 1e-9 && (corner.y.abs() - 0.055).abs() < 1e-9);
    }
}

#[test]
fn a_cylinder_leaves_its_polygon() {
    let mesh = Mesh::cylinder(0.05, 0.2, 12).expect("valid");
    let region = footprint(&mesh, 0.01).expect("a footprint");
    assert_eq!(region.polygons()[0].outer().len(), 12);
    assert!((region.area() - regular_polygon_area(0.05, 12)).abs() < 1e-10);
}

#[test]
fn a_sphere_leaves_a_disc_that_grows_with_the_depth() {
    let radius = 0.05;
    let mesh = Mesh::sphere(radius, 512).expect("valid");
    for depth in [0.001, 0.01, 0.03, 0.05] {
        let expected = PI * (2.0 * radius * depth - depth * depth);
        let area = footprint(&mesh, depth).expect("a footprint").area();
        // Facets of 512 segments lie within R π²/(2·512²) = 0.9 µm of the sphere, which at the
        // least depth is 0.1 % of it and so of the area.
        assert!(
            (area / expected - 1.0).abs() < 2e-3,
            "{depth}: {area} {expected}"
        );
    }
}

#[test]
fn a_depth_beyond_the_height_means_the_whole_mesh() {
    let mesh = Mesh::sphere(0.05, 64).expect("valid");
    let area = footprint(&mesh, 10.0).expect("a footprint").area();
    assert!((area - regular_polygon_area(0.05, 64)).abs() < 1e-9);
}

#[test]
fn a_tube_leaves_a_ring() {
    let region = footprint(&tube(48), 0.005).expect("a footprint");
    assert_eq!(pieces_and_holes(&region), (1, 1));
    let expected = regular_polygon_area(0.04, 48) - regular_polygon_area(0.03, 48);
    assert!((region.area() - expected).abs() < 1e-9);
    assert!(!region.contains(Point2::origin()));
    assert!(region.contains(Point2::new(0.035, 0.0)));
}

#[test]
fn apart_boxes_are_pieces_and_overlapping_ones_are_one() {
    let foot = cuboid(0.02, 0.02, 0.04);
    let apart = merge([foot.clone(), moved(&foot, 0.05, 0.0, 0.0)]);
    let region = footprint(&apart, 0.01).expect("a footprint");
    assert_eq!(pieces_and_holes(&region), (2, 0));
    assert!((region.area() - 8e-4).abs() < 1e-9);
    let overlapping = merge([foot.clone(), moved(&foot, 0.01, 0.0, 0.0)]);
    let region = footprint(&overlapping, 0.01).expect("a footprint");
    assert_eq!(pieces_and_holes(&region), (1, 0));
    assert_eq!(region.edges().count(), 4);
    assert!((region.area() - 6e-4).abs() < 1e-9);
}

#[test]
fn parts_above_the_slab_leave_no_footprint() {
    let foot = cuboid(0.02, 0.02, 0.04);
    let mesh = merge([foot.clone(), moved(&foot, 0.05, 0.0, 0.005)]);
    assert_eq!(
        pieces_and_holes(&footprint(&mesh, 0.004).expect("a footprint")),
        (1, 0)
    );
    assert_eq!(
        pieces_and_holes(&footprint(&mesh, 0.006).expect("a footprint")),
        (2, 0)
    );
}

#[test]
fn a_tube_without_end_faces_is_filled_by_its_section() {
    let wall = |corners: [Point3; 3]| corners.iter().any(|p| p.z != corners[0].z);
    let open = only(&tube(48), wall);
    assert!(!open.is_watertight());
    let region = footprint(&open, 0.005).expect("a footprint");
    assert_eq!(pieces_and_holes(&region), (1, 1));
    let expected = footprint(&tube(48), 0.005).expect("a footprint").area();
    assert!((region.area() - expected).abs() < 1e-9);
}

#[test]
fn a_gap_in_the_wall_does_not_matter_where_the_bottom_covers() {
    let whole = cuboid(0.07, 0.11, 0.05);
    let first_wall = whole.corners().find(|t| t.iter().any(|p| p.z != t[0].z));
    let torn = only(&whole, |corners| Some(corners) != first_wall);
    assert!((footprint(&torn, 0.004).expect("a footprint").area() - 0.07 * 0.11).abs() < 1e-9);
}

#[test]
fn an_open_wall_alone_is_an_error_that_counts_its_gaps() {
    let one_wall = |corners: [Point3; 3]| corners.iter().all(|p| p.x > 0.0);
    let sheet = only(&cuboid(0.07, 0.11, 0.05), one_wall);
    let error = footprint(&sheet, 0.004).unwrap_err();
    assert!(
        matches!(error, FootprintError::Open { gaps: 1, .. }),
        "{error:?}"
    );
}

#[test]
fn wrong_input_is_named_with_its_limit() {
    let mesh = cuboid(0.1, 0.1, 0.1);
    for bad in [0.0, -0.01, 1e-6, f64::NAN, f64::INFINITY] {
        let message = footprint(&mesh, bad).unwrap_err().to_string();
        assert_eq!(
            message,
            format!("compression depth {bad} m is not a finite depth of at least 0.00001 m")
        );
    }
    let far = moved(&mesh, 1e6, 0.0, 0.0);
    assert!(matches!(
        footprint(&far, 0.01),
        Err(FootprintError::OutOfRange { .. })
    ));
    let needle = cuboid(1e-6, 1e-6, 0.1);
    assert_eq!(
        footprint(&needle, 0.01),
        Err(FootprintError::Empty { depth: 0.01 })
    );
}

#[test]
fn too_many_edges_are_refused() {
    let tuft = cuboid(1e-4, 1e-4, 1e-3);
    let field = (0..160).flat_map(|i| (0..160).map(move |j| (f64::from(i), f64::from(j))));
    let brush = merge(field.map(|(i, j)| moved(&tuft, 3e-4 * i, 3e-4 * j, 0.0)));
    let edges = 4 * 160 * 160;
    assert_eq!(
        footprint(&brush, 1e-4),
        Err(FootprintError::TooManyEdges { edges })
    );
}

/// A few solids standing side by side, on and in each other.
fn solids() -> impl Strategy<Value = Mesh> {
    let size = 0.01..0.05f64;
    let solid = (
        0..3u8,
        size.clone(),
        size,
        -0.05..0.05f64,
        -0.05..0.05f64,
        0.0..0.02f64,
    );
    prop::collection::vec(solid, 1..5).prop_map(|solids| {
        merge(solids.into_iter().map(|(kind, a, b, x, y, z)| {
            let mesh = match kind {
                0 => Ok(cuboid(a, b, 0.03)),
                1 => Mesh::cylinder(a, b, 17),
                _ => Mesh::capsule(a / 2.0, b, 12),
            };
            moved(&mesh.expect("sizes are positive"), x, y, z)
        }))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_area_does_not_depend_on_the_heading(mesh in solids(), turn in -PI..PI, depth in 0.001..0.03f64) {
        let turned = mesh.transform(&Pose::rotation(Vector3::z() * turn));
        let (before, after) = (footprint(&mesh, depth), footprint(&turned, depth));
        let (before, after) = (before.expect("a footprint").area(), after.expect("a footprint").area());
        prop_assert!((before - after).abs() < 1e-9, "{before} {after}");
    }

    #[test]
    fn the_area_does_not_depend_on_the_triangles(mesh in solids(), depth in 0.001..0.03f64) {
        let before = footprint(&mesh, depth).expect("a footprint");
        let after = footprint(&subdivided(&mesh), depth).expect("a footprint");
        prop_assert!((before.area() - after.area()).abs() < 1e-9);
        prop_assert_eq!(before.polygons().len(), after.polygons().len());
    }

    /// The law by which the projected surface suffices for a closed mesh. A tip that hardly reaches below
    /// the section leaves a piece that is too small to be kept.
    #[test]
    fn the_section_lies_within_the_footprint(mesh in solids(), depth in 0.001..0.03f64) {
        let region = footprint(&mesh, depth).expect("a footprint");
        let (min, max) = mesh.bounds();
        let section = section(&mesh, (min.z + depth).min(max.z));
        prop_assert_eq!(section.gaps, 0);
        for ring in section.loops {
            let ring: Vec<_> = ring.into_iter().map(Point2::from).collect();
            if Polygon::new(ring.clone(), Vec::new()).area().abs() < MIN_AREA {
                continue;
            }
            for point in ring {
                prop_assert!(region.contains(point) || region.boundary_distance(point) < 1e-8);
            }
        }
    }

    #[test]
    fn a_deeper_press_covers_no_less(mesh in solids(), depth in 0.001..0.02f64, more in 0.0..0.02f64) {
        let shallow = footprint(&mesh, depth).expect("a footprint").area();
        let deep = footprint(&mesh, depth + more).expect("a footprint").area();
        prop_assert!(deep >= shallow - 1e-9);
    }
}
