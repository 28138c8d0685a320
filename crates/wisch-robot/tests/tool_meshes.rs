//! The shipped tool meshes: the committed files are what the generator writes, and each leaves the
//! footprint that the tool is made for.

#[path = "../examples/tool_meshes/shapes.rs"]
mod shapes;

use std::f64::consts::TAU;
use wisch_robot::geometry::{Mesh, MeshFormat, Point2, Region, Vector2, footprint};

/// Sizes are stored as `f32`: 0.4 m is off by less than 3e-8 m, which over a perimeter of at most
/// 6 m (all tufts of the broom) changes the area by less than this [m²].
const AREA_TOLERANCE: f64 = 1e-7;

fn committed(file_name: &str) -> Vec<u8> {
    let path = format!(
        "{}/../../knowledge/meshes/{file_name}",
        env!("CARGO_MANIFEST_DIR")
    );
    std::fs::read(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn footprint_of(file_name: &str, compression_depth: f64) -> Region {
    let mesh = Mesh::parse(&committed(file_name), MeshFormat::Stl, file_name).expect(file_name);
    footprint(&mesh, compression_depth).expect(file_name)
}

/// Polygons, holes, area [m²] and extent along x and y [m].
fn measures(region: &Region) -> (usize, usize, f64, Vector2) {
    let holes = region.polygons().iter().map(|p| p.holes().len()).sum();
    let size = region.bounds().expect("not empty").size();
    (region.polygons().len(), holes, region.area(), size)
}

fn regular_polygon_area(radius: f64, corners: u32) -> f64 {
    f64::from(corners) / 2.0 * radius * radius * (TAU / f64::from(corners)).sin()
}

#[test]
fn committed_files_are_what_the_generator_writes() {
    for tool in shapes::all().expect("the shapes are valid") {
        // assert_eq! would print both files.
        assert!(
            tool.mesh.to_binary_stl() == committed(tool.file_name),
            "{} differs",
            tool.file_name
        );
    }
}

#[test]
fn files_are_small_watertight_and_stand_on_their_contact_face() {
    for tool in shapes::all().expect("the shapes are valid") {
        let bytes = committed(tool.file_name);
        assert!(bytes.len() < 300_000);
        let mesh = Mesh::parse(&bytes, MeshFormat::Stl, tool.file_name).expect("our own file");
        assert!(mesh.is_watertight(), "{}", tool.file_name);
        let (min, max) = mesh.bounds();
        assert_eq!(min.z, 0.0);
        assert!(
            (min + max.coords).xy().coords.norm() < 1e-6,
            "{} is off centre",
            tool.file_name
        );
        // A person sweeps with a broom while standing.
        let longest = if tool.file_name == "broom.stl" {
            1.5
        } else {
            0.5
        };
        assert!(mesh.extent() < longest);
    }
}

#[test]
fn the_sponge_leaves_its_area_of_effect() {
    let (pieces, holes, area, size) = measures(&footprint_of("sponge.stl", 0.005));
    assert_eq!((pieces, holes), (1, 0));
    assert!((area - 0.07 * 0.11).abs() < AREA_TOLERANCE);
    assert!((size - Vector2::new(0.07, 0.11)).norm() < 1e-7);
}

#[test]
fn the_broom_leaves_a_piece_per_tuft() {
    let (pieces, holes, area, size) = measures(&footprint_of("broom.stl", 0.003));
    let [rows, columns] = shapes::BROOM_TUFTS;
    assert_eq!((pieces, holes), ((rows * columns) as usize, 0));
    // A tuft widens by a tenth over 62 mm, so 2 to 3 mm up by 0.3 to 0.5 % and its area by 0.6 to 1 %.
    let tips = f64::from(rows * columns) * regular_polygon_area(shapes::BROOM_TUFT_RADIUS, 6);
    assert!((1.006..1.010).contains(&(area / tips)), "{}", area / tips);
    assert!(size.x < 0.06 && size.y < 0.40);
}

#[test]
fn only_the_longest_tufts_of_the_broom_touch_lightly() {
    let (pieces, ..) = measures(&footprint_of("broom.stl", 5e-5));
    let [rows, columns] = shapes::BROOM_TUFTS;
    // Wear takes eleven values in turn, from both ends to the middle.
    assert_eq!(pieces, 2 * (rows * columns / 2).div_ceil(11) as usize);
}

#[test]
fn the_window_wiper_leaves_a_line() {
    let depth = 0.001;
    let (pieces, holes, area, size) = measures(&footprint_of("window_wiper.stl", depth));
    assert_eq!((pieces, holes), (1, 0));
    // The wedge widens from 4 to 10 mm over 32 mm.
    let width = 0.004 + 0.006 * depth / 0.032;
    assert!((area - width * 0.35).abs() < AREA_TOLERANCE);
    assert!((size - Vector2::new(width, 0.35)).norm() < 1e-7);
}

#[test]
fn the_brush_leaves_a_piece_per_tuft() {
    let (pieces, holes, area, size) = measures(&footprint_of("brush.stl", 0.002));
    let [rows, columns] = shapes::BRUSH_TUFTS;
    assert_eq!((pieces, holes), ((rows * columns) as usize, 0));
    let tufts = f64::from(rows * columns) * regular_polygon_area(shapes::BRUSH_TUFT_RADIUS, 8);
    assert!((area - tufts).abs() < AREA_TOLERANCE);
    assert!(size.x < 0.08 && size.y < 0.20);
}

#[test]
fn the_vacuum_nozzle_leaves_its_rim() {
    let region = footprint_of("vacuum_nozzle.stl", 0.002);
    let (pieces, holes, area, size) = measures(&region);
    assert_eq!((pieces, holes), (1, 1));
    let [x, y] = shapes::NOZZLE_SIZE;
    let rim = shapes::NOZZLE_RIM;
    assert!((area - (x * y - (x - 2.0 * rim) * (y - 2.0 * rim))).abs() < AREA_TOLERANCE);
    assert!((size - Vector2::new(x, y)).norm() < 1e-7);
    assert!(!region.contains(Point2::origin()));
}
