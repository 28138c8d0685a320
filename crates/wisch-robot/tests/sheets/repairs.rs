//! Meshes as they are found: other orders, flipped and thin triangles, gaps, holes and several parts.

use super::shapes::{cylinder, door, grid, wavy};
use proptest::prelude::*;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wisch_robot::geometry::{Mesh, Point3, Sheet, SheetConfig, SheetError, Vector3};

fn draft(mesh: &Mesh) -> Sheet {
    Sheet::draft(mesh, &SheetConfig::default()).unwrap()
}

/// Returns the mesh with its vertices and triangles in another order.
fn shuffle(mesh: &Mesh, seed: u64) -> Mesh {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut order: Vec<usize> = (0..mesh.vertices().len()).collect();
    order.shuffle(&mut random);
    let mut number = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        number[old] = new as u32;
    }
    let mut triangles: Vec<[u32; 3]> = (mesh.triangles().iter())
        .map(|t| {
            let mut t = t.map(|i| number[i as usize]);
            t.rotate_left(random.random_range(0..3));
            t
        })
        .collect();
    triangles.shuffle(&mut random);
    let vertices = order.iter().map(|&old| mesh.vertices()[old]).collect();
    Mesh::new(vertices, triangles).unwrap()
}

#[test]
fn the_order_of_a_file_changes_nothing() {
    for mesh in [door([50, 40]), wavy([40, 30])] {
        let expected = draft(&mesh);
        for seed in 1000..1003 {
            let found = draft(&shuffle(&mesh, seed));
            assert!((found.stretch().most - expected.stretch().most).abs() < 1e-9);
            assert_eq!(found.outline(), expected.outline());
        }
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let bytes = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let sheet = pool.install(|| draft(&door([50, 40])));
        let numbers: Vec<u64> = sheet
            .vertices()
            .flat_map(|v| [v.place.x, v.place.y, v.point.z, v.normal.x, v.bend[(0, 1)]])
            .map(f64::to_bits)
            .collect();
        numbers
    };
    assert_eq!(bytes(1), bytes(16));
}

#[test]
fn flipped_triangles_are_turned_to_the_side_of_the_larger_share() {
    let mesh = grid([5, 4], [0.5, 0.4], |x, y| Point3::new(x, y, 0.0));
    let mut triangles = mesh.triangles().to_vec();
    triangles[..17].iter_mut().for_each(|t| t.swap(0, 1));
    let mesh = Mesh::new(mesh.vertices().to_vec(), triangles).unwrap();
    let sheet = draft(&mesh);
    assert_eq!(
        (sheet.survey().flipped, sheet.survey().part_triangles),
        (17, 40)
    );
    assert!(
        sheet
            .vertices()
            .all(|v| (v.normal - Vector3::z()).norm() < 1e-12)
    );
    let mut config = SheetConfig::default();
    config.choice.towards = Some(-Vector3::z());
    let turned = Sheet::draft(&mesh, &config).unwrap();
    assert!(turned.survey().is_turned);
    assert!(
        turned
            .vertices()
            .all(|v| (v.normal + Vector3::z()).norm() < 1e-12)
    );
}

#[test]
fn gaps_of_rounding_and_vertices_within_edges_are_closed() {
    // Two panels side by side: the right one has vertices in the middle of the left one's edges, a micrometre off.
    let left = grid([4, 4], [0.4, 0.4], |x, y| Point3::new(x - 0.2, y, 0.0));
    let right = grid([8, 8], [0.4, 0.4], |x, y| {
        Point3::new(x + 0.2 + 3e-7, y, 0.0)
    });
    let sheet = draft(&Mesh::merge([left, right]).unwrap());
    let survey = sheet.survey();
    assert_eq!(survey.part_areas.len(), 1, "{survey:?}");
    assert_eq!((survey.repairs.welded, survey.repairs.split), (5, 4));
    assert_eq!(survey.border_lengths.len(), 1);
    assert!((sheet.area() - 0.32).abs() < 1e-6);
    assert!(sheet.stretch().most < 1e-5);
}

#[test]
fn thin_triangles_do_no_harm() {
    // Needles and triangles without height: a grid with columns of 0.1 µm, and a vertex on the middle of each long edge.
    let mut widths = vec![0.0];
    for i in 0..20 {
        let last: f64 = widths[widths.len() - 1];
        widths.extend([
            last + 2e-6,
            last + 0.02 + if i % 2 == 0 { 1e-3 } else { 0.0 },
        ]);
    }
    let count = widths.len() as u32 - 1;
    let mesh = grid([count, 12], [f64::from(count), 0.3], |i, y| {
        let i = (i + 0.5 * f64::from(count)).round() as usize;
        let angle = widths[i] / 0.5;
        Point3::new(0.5 * angle.sin(), y, 0.5 * angle.cos())
    });
    let sheet = draft(&mesh);
    assert_eq!(sheet.check(), Ok(()));
    let area = 0.3 * widths[widths.len() - 1];
    assert!(
        (sheet.area() / area - 1.0).abs() < 1e-3,
        "{} {area}",
        sheet.area()
    );
    assert!(sheet.stretch().most < 1e-3, "{:?}", sheet.stretch());
}

#[test]
fn triangles_between_corners_on_one_line_are_dropped() {
    // The third corner lies on the line of the first two, up to rounding.
    for height in [0.0, 1e-8, -1e-8] {
        let corners = [
            [0.0, 0.0],
            [0.4, 0.0],
            [0.2, height],
            [0.2, 0.3],
            [0.2, -0.3],
        ];
        let vertices = corners.map(|[x, y]| Point3::new(x, y, 0.1)).to_vec();
        let border = vec![[0, 1, 2], [0, 2, 3], [2, 1, 3]];
        // With a triangle on the other side, the third corner lies within its edge.
        let inside = [&border[..], &[[1, 0, 4]]].concat();
        for (triangles, split, area) in [(border, 0, 0.06), (inside, 1, 0.12)] {
            let sheet = draft(&Mesh::new(vertices.clone(), triangles).unwrap());
            assert_eq!(sheet.check(), Ok(()), "{height}");
            let repairs = sheet.survey().repairs;
            assert_eq!((repairs.dropped, repairs.split), (1, split), "{height}");
            assert!((sheet.area() - area).abs() < 1e-6, "{}", sheet.area());
        }
    }
}

#[test]
fn a_repeated_triangle_and_one_without_area_are_dropped() {
    let mesh = grid([6, 6], [0.3, 0.3], |x, y| Point3::new(x, y, 0.0));
    let mut triangles = mesh.triangles().to_vec();
    triangles.extend([triangles[5], [3, 3, 4]]);
    let sheet = draft(&Mesh::new(mesh.vertices().to_vec(), triangles).unwrap());
    assert_eq!(sheet.survey().repairs.dropped, 2);
    assert!((sheet.area() - 0.09).abs() < 1e-9);
    let flat = Mesh::new(vec![Point3::origin(); 3], vec![[0, 1, 2]]).unwrap();
    let error = Sheet::draft(&flat, &SheetConfig::default()).err();
    assert_eq!(error, Some(SheetError::NoArea { triangles: 1 }));
}

#[test]
fn holes_are_kept_and_parts_are_chosen() {
    let sheet = draft(&wavy([100, 80]));
    assert_eq!(sheet.outline().holes().len(), 1);
    let hole = std::f64::consts::PI * 0.15 * 0.15;
    assert!((sheet.outline().area() / (0.8 - hole) - 1.0).abs() < 0.02);
    let small = grid([6, 6], [0.3, 0.3], |x, y| Point3::new(x + 2.0, y, 0.5));
    let mesh = Mesh::merge([cylinder([30, 20], [0.6, 0.4], 0.5), small]).unwrap();
    let sheet = draft(&mesh);
    assert_eq!(
        (sheet.survey().taken_part, sheet.survey().part_areas.len()),
        (0, 2)
    );
    let mut config = SheetConfig::default();
    config.choice.seed_point = Some(Point3::new(1.7, 0.0, 0.3));
    let sheet = Sheet::draft(&mesh, &config).unwrap();
    assert_eq!(sheet.survey().taken_part, 1);
    assert!((sheet.area() - 0.09).abs() < 1e-9);
}

#[test]
fn a_strip_with_one_side_is_refused() {
    let strip = grid([60, 4], [60.0, 0.2], |i, y| {
        let angle = std::f64::consts::TAU * i / 60.0;
        let across = y * (0.5 * angle).cos();
        Point3::new(
            (0.5 + across) * angle.cos(),
            (0.5 + across) * angle.sin(),
            y * (0.5 * angle).sin(),
        )
    });
    let error = Sheet::draft(&strip, &SheetConfig::default()).err().unwrap();
    assert!(matches!(error, SheetError::NotOrientable { .. }), "{error}");
}

/// Meshes without a plan: vertices on a coarse grid of 4 mm, and triangles of any three of them.
fn any_mesh() -> impl Strategy<Value = Mesh> {
    let vertices = prop::collection::vec(prop::array::uniform3(-16i8..16), 3..24);
    let triangles = prop::collection::vec(prop::array::uniform3(any::<u8>()), 1..60);
    (vertices, triangles).prop_map(|(vertices, triangles)| {
        let count = vertices.len() as u32;
        let vertices = vertices
            .iter()
            .map(|p| Point3::from(p.map(|c| 0.004 * f64::from(c))))
            .collect();
        let triangles = triangles
            .iter()
            .map(|t| t.map(|i| u32::from(i) % count))
            .collect();
        Mesh::new(vertices, triangles).unwrap()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn every_mesh_is_unrolled_or_refused(mesh in any_mesh(), is_towards in any::<bool>()) {
        let mut config = SheetConfig::default();
        config.choice.towards = is_towards.then(Vector3::z);
        if let Ok(sheet) = Sheet::draft(&mesh, &config) {
            prop_assert!(sheet.area() > 0.0);
            prop_assert!(sheet.stretch().most >= 0.0);
            let is_usable = sheet.check().is_ok();
            for vertex in sheet.vertices().step_by(7) {
                prop_assert!((vertex.normal.norm() - 1.0).abs() < 1e-9);
                let foot = sheet.chart(vertex.point);
                prop_assert!(foot.height.is_finite());
                if is_usable {
                    prop_assert!(foot.beyond < 1e-6 && foot.height.abs() < 1e-6);
                }
            }
        }
    }
}
