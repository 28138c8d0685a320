use super::*;
use crate::geometry::{Mesh, Point3, Polygon, Pose, SheetConfig};
use crate::represent::{Cone, MeshShape};
use std::sync::Arc;

/// A board of 0.6 x 0.4 m that leans towards −x.
fn leaning(slope: f64) -> Surface {
    let pose = Pose::new(Vector3::new(0.5, 0.0, 0.4), -Vector3::y() * slope);
    Surface::new("board", Polygon::rectangle(Vector2::new(0.6, 0.4)), pose)
}

/// A surface of 1.4 x 1 m of this shape, at the origin.
fn bent(shape: SurfaceShape, turn: Vector3) -> Surface {
    let outline = Polygon::rectangle(Vector2::new(1.4, 1.0));
    let mut surface = Surface::new("bent", outline, Pose::new(Vector3::zeros(), turn));
    surface.shape = shape;
    surface
}

fn dirt() -> ParticleDistribution {
    let places = [[0.2, 0.1], [-0.1, -0.15], [0.25, 0.0]].map(Point2::from);
    ParticleDistribution::new(&places).unwrap()
}

fn slide(at_rest: f64, sliding: f64) -> DirtSlide {
    let friction = DirtFriction { at_rest, sliding };
    DirtSlide::new(friction, OccupiedArea::default())
}

fn height(surface: &Surface, place: Point2) -> f64 {
    surface.world_from_place(place, 0.0).translation.z
}

#[test]
fn dirt_rests_up_to_the_angle_of_friction_and_slides_off_the_lower_edge_beyond_it() {
    let steepest = 0.3_f64.atan();
    let rests = |slope: f64, friction: f64| {
        slide_down(&dirt(), &leaning(slope), &slide(friction, friction)).is_none()
    };
    assert!(rests(steepest - 1e-6, 0.3) && !rests(steepest + 1e-6, 0.3));
    assert!(rests(0.0, 0.0));
    let (slid, steep) = slide_down(&dirt(), &leaning(0.7), &slide(0.3, 0.2)).unwrap();
    assert_eq!((steep.lay, steep.slid, steep.left), (3, 3, 3));
    assert!((steep.slope - 0.7).abs() < 1e-12);
    assert_eq!(slid.tally().initial, 3);
    for ((before, _), (after, fate)) in dirt().iter().zip(slid.iter()) {
        // Straight down to x = −0.3 or 0.3, the lower of the two.
        assert!(height(&leaning(0.7), after) < height(&leaning(0.7), before));
        assert!((after.x.abs() - 0.301).abs() < 1e-9 && (after.y - before.y).abs() < 1e-9);
        let edge = if after.x < 0.0 { 3 } else { 1 };
        assert_eq!(fate, Fate::OffSurface { edge });
        let end = slide(0.3, 0.2).find_end(&leaning(0.7), before).unwrap();
        assert!((end.length - (after - before).norm() + BEYOND).abs() < 1e-6);
    }
}

#[test]
fn dirt_on_the_upper_border_slides_over_the_whole_surface() {
    // The board leans towards −x, so that its upper border is at one of x = ±0.3.
    let surface = leaning(0.7);
    for x in [-0.3, 0.3] {
        let on_border = Point2::new(x, 0.1);
        let is_upper = height(&surface, on_border) > height(&surface, Point2::origin());
        let end = slide(0.3, 0.2).find_end(&surface, on_border).unwrap();
        assert_eq!(end.place.x.signum() == x.signum(), !is_upper);
        assert_ne!(end.fate, Fate::FALLEN, "{end:?}");
    }
}

#[test]
fn dirt_rests_above_an_object_and_falls_off_walls_and_ceilings() {
    let surface = leaning(0.7);
    let bar = Mesh::cuboid(Vector3::new(0.02, 0.4, 0.02)).unwrap();
    let barred = DirtSlide::new(
        DirtFriction::constant(0.3),
        OccupiedArea::from_scene([&bar]),
    );
    let (slid, steep) = slide_down(&dirt(), &surface, &barred).unwrap();
    // The bar lies across at x = 0; what lies below it slides off.
    let down = surface.world_from_surface.rotation.inverse() * -Vector3::z();
    let above = dirt().iter().filter(|(p, _)| p.x * down.x < 0.0).count();
    assert_eq!((steep.left, steep.slid), (3 - above, 3));
    for (place, fate) in slid.iter().filter(|(_, fate)| *fate == Fate::OnSurface) {
        assert!((0.01..0.0125).contains(&place.x.abs()), "{place} {fate:?}");
    }
    // Once they rest, they rest.
    assert_eq!(barred.settle(&slid, &surface), slid);
    for slope in [1.6, 2.0, PI] {
        let (fallen, steep) = slide_down(&dirt(), &leaning(slope), &slide(5.0, 5.0)).unwrap();
        assert_eq!(steep.left, 3, "{slope}");
        assert_eq!(fallen.fate(0), Fate::FALLEN);
    }
}

/// Acceptance: an arc to the angle atan μ_k, of exact length.
#[test]
fn dirt_in_a_gutter_slides_along_an_arc_to_the_angle_of_sliding_friction() {
    for (axis, turn) in [(FRAC_PI_2, 0.0), (FRAC_PI_2, 0.2), (0.0, 0.0), (0.7, 0.0)] {
        // A turn about the axis moves the lowest line of the gutter.
        let about = Vector3::new(axis.cos(), axis.sin(), 0.0) * turn;
        let gutter = bent(SurfaceShape::Cylinder { radius: -0.5, axis }, about);
        let across = Vector2::new(-axis.sin(), axis.cos());
        for lies in [0.42, -0.45] {
            let from = Point2::from(across * lies);
            let end = slide(0.4, 0.25).find_end(&gutter, from).unwrap();
            let lean = gutter.normal(end.place).angle(&Vector3::z());
            assert!((lean.tan() - 0.25).abs() < 1e-9, "{axis} {turn}: {lean}");
            let from_lean = gutter.normal(from).angle(&Vector3::z());
            assert!((end.length - 0.5 * (from_lean - lean)).abs() < 1e-9);
            assert!(
                (end.place - from)
                    .dot(&Vector2::new(across.y, -across.x))
                    .abs()
                    < 1e-12
            );
            // The same path in parts, as after each stroke, ends in the same place.
            let integrated = slide(0.4, 0.25).integrate(&gutter, from);
            assert!((integrated.place - end.place).norm() < 1e-9);
            assert!((integrated.length - end.length).abs() < 1e-9);
            let half = from + (end.place - from) * 0.5;
            let again = slide(0.25, 0.25).find_end(&gutter, half).unwrap();
            assert!((again.place - end.place).norm() < 1e-9);
        }
    }
}

#[test]
fn dirt_on_a_bulge_slides_over_the_border_or_falls_where_the_surface_faces_down() {
    let axis = FRAC_PI_2;
    let pipe = |radius| bent(SurfaceShape::Cylinder { radius, axis }, Vector3::zeros());
    let slide = slide(0.5, 0.4);
    assert_eq!(
        slide.find_end(&pipe(0.5), Point2::new(0.5 * 0.46, 0.0)),
        None
    );
    // The border is at 0.7 m, and a quarter of a pipe of 0.3 m at 0.47 m.
    let off = slide.find_end(&pipe(0.5), Point2::new(0.3, 0.1)).unwrap();
    assert_eq!(off.fate, Fate::OffSurface { edge: 1 });
    assert!((off.length - 0.4).abs() < 1e-9);
    let fallen = slide.find_end(&pipe(0.3), Point2::new(-0.3, 0.1)).unwrap();
    assert_eq!(fallen.fate, Fate::FALLEN);
    assert!((fallen.place - Point2::new(-0.3 * FRAC_PI_2, 0.1)).norm() < 1e-9);
    assert!((fallen.length - (0.3 * FRAC_PI_2 - 0.3)).abs() < 1e-9);
}

/// On a gutter that leans along its axis, with the pull g sin β along the axis and g cos β sin χ across it, the steepest
/// way is v − v₀ = R tan β ln(tan(χ/2) / tan(χ₀/2)).
#[test]
fn the_way_down_a_gutter_that_leans_along_its_axis_is_the_closed_form() {
    let lean: f64 = 0.2;
    let shape = SurfaceShape::Cylinder {
        radius: -0.5,
        axis: 0.0,
    };
    // A turn about y by a positive angle lowers +x.
    let gutter = bent(shape, Vector3::y() * lean);
    let end = slide(0.6, 0.4)
        .find_end(&gutter, Point2::new(-0.5, 0.45))
        .unwrap();
    assert_eq!(end.fate, Fate::OnSurface);
    let tilt = gutter.normal(end.place).angle(&Vector3::z());
    assert!((tilt.tan() - 0.4).abs() < 1e-9);
    let angle = |y: f64| y / 0.5;
    let ratio = ((angle(end.place.y) / 2.0).tan() / (angle(0.45) / 2.0).tan()).ln();
    let along = -0.5 * lean.tan() * ratio;
    assert!((end.place.x + 0.5 - along).abs() < 1e-6, "{}", end.place);
}

#[test]
fn the_way_down_a_cone_and_a_bowl_follows_a_meridian() {
    // A funnel that opens upwards: the axis is vertical, and all its lines lean by the same angle.
    let half_angle = 0.5;
    let shape = SurfaceShape::Cone(Cone {
        radius: -0.8,
        half_angle,
        axis: 0.0,
    });
    // Turned about y until the axis, along which it widens, points up.
    let funnel = bent(shape, Vector3::y() * (half_angle - FRAC_PI_2));
    let from = Point2::new(0.3, 0.2);
    let end = slide(0.5, 0.5).find_end(&funnel, from).unwrap();
    assert!(matches!(end.fate, Fate::OffSurface { .. }), "{end:?}");
    let apex = Cone {
        radius: -0.8,
        half_angle,
        axis: 0.0,
    }
    .apex();
    let (begin, last) = (from - apex, end.place - apex);
    assert!(begin.perp(&last).abs() / last.norm() < 1e-9, "{end:?}");

    // A bowl of 0.6 m radius.
    let side = 41;
    let at = |i: usize| 0.7 * (i as f64 / (side - 1) as f64 - 0.5);
    let vertices = (0..side * side).map(|i| {
        let (x, y) = (at(i % side), at(i / side));
        Point3::new(x, y, 0.6 - (0.36 - x * x - y * y).max(0.0).sqrt())
    });
    let squares = (0..side - 1).flat_map(|j| (0..side - 1).map(move |i| (j * side + i) as u32));
    let side = side as u32;
    let triangles = squares.flat_map(|a| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]]);
    let bowl = Mesh::new(vertices.collect(), triangles.collect()).unwrap();
    let config = SheetConfig {
        stretch_limit: 0.2,
        ..SheetConfig::default()
    };
    let (shape, pose) = MeshShape::from_mesh(&bowl, &config).unwrap();
    let mut surface = Surface::new("bowl", shape.outline(), pose);
    surface.shape = SurfaceShape::Mesh(Arc::new(shape));
    let world = |place| surface.world_from_place(place, 0.0).translation.vector;
    for from in [[0.25, 0.1], [-0.2, 0.22], [0.02, -0.27]].map(Point2::from) {
        let end = slide(0.3, 0.2).find_end(&surface, from).unwrap();
        assert_eq!(end.fate, Fate::OnSurface);
        let lean = surface.normal(end.place).angle(&Vector3::z());
        assert!((lean.tan() - 0.2).abs() < 1e-9);
        let (begin, last) = (world(from).xy(), world(end.place).xy());
        assert!(begin.normalize().perp(&last).abs() < 2e-3, "{begin} {last}");
        assert!((last.norm() - 0.6 * 0.2_f64.atan().sin()).abs() < 3e-3);
    }
}
