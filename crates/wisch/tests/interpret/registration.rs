//! Registration of contacts against shapes whose real pose is planted.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;
use wisch::geometry::{Point2, Point3, Pose, SheetConfig, Vector2, Vector3};
use wisch::interpret::{PlaneConfig, ShapeFit, fit_plane, fit_shape};
use wisch::random::normal_pair;
use wisch::represent::{Cone, MeshShape, SurfaceShape};
use wisch_testkit::curved_meshes::mesh_over;

/// Sides of the surfaces [m].
const SIDES: [f64; 2] = [0.6, 0.4];
/// Standard deviation of the contacts' heights [m], and share of the contacts at which the tool was lifted [1].
const NOISE: f64 = 1e-4;
const LIFTED: f64 = 0.3;

fn shape_of(sides: [f64; 2], point: impl Fn(Point2) -> Point3) -> SurfaceShape {
    let config = SheetConfig {
        tool_radius: 0.0583,
        ..SheetConfig::default()
    };
    let (shape, _) = MeshShape::from_mesh(&mesh_over([40, 40], sides, point), &config).unwrap();
    SurfaceShape::Mesh(Arc::new(shape))
}

/// Positions along three strokes in each direction.
fn places(sides: [f64; 2]) -> Vec<Point2> {
    let lanes = [-0.4, 0.0, 0.4];
    let along = (0..200).map(|i| 0.9 * (f64::from(i) / 199.0 - 0.5));
    along
        .flat_map(|share| {
            lanes
                .into_iter()
                .flat_map(move |lane| [[share, lane], [lane, share]])
        })
        .map(|[x, y]| Point2::new(sides[0] * x, sides[1] * y))
        .collect()
}

/// The planted pose of the real surface: (2, -3, 3.5) mm and 1.5°.
fn planted() -> Pose {
    let turn = Vector3::new(0.6, 0.7, -0.4).normalize() * 1.5_f64.to_radians();
    Pose::new(Vector3::new(2e-3, -3e-3, 3.5e-3), turn)
}

/// Contacts on the moved surface, as they are measured.
fn measured(shape: &SurfaceShape, sides: [f64; 2], moved: &Pose) -> Vec<Point3> {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let places = places(sides).into_iter();
    let contact = places.map(|place| {
        let lifted = random.random::<f64>() < LIFTED;
        let error = normal_pair(&mut random).x * NOISE;
        let height = if lifted {
            5e-3 + 0.025 * random.random::<f64>()
        } else {
            error
        };
        moved * Point3::from(shape.place(place, height).translation.vector)
    });
    contact.collect()
}

/// Root mean square distance of the real surface from the fitted one [m].
fn offset(fit: &ShapeFit, shape: &SurfaceShape, sides: [f64; 2], moved: &Pose) -> f64 {
    let places = places(sides);
    let squares = places.iter().map(|place| {
        let real = moved * Point3::from(shape.place(*place, 0.0).translation.vector);
        fit.height(shape, real).powi(2)
    });
    (squares.sum::<f64>() / places.len() as f64).sqrt()
}

/// Checks how many degrees of freedom of a shape contacts determine, and the distance of the fit
/// from the truth [m].
fn check(name: &str, shape: &SurfaceShape, sides: [f64; 2], determined: usize, limit: f64) {
    let moved = planted();
    let points = measured(shape, sides, &moved);
    let fit = fit_shape(&points, shape, &PlaneConfig::default(), 1).expect("a fit");
    assert_eq!(fit.determined, determined, "{name}");
    let off = offset(&fit, shape, sides, &moved);
    assert!(off <= limit, "{name}: {off}");
    let share = fit.inliers as f64 / points.len() as f64;
    assert!(
        (share - (1.0 - LIFTED)).abs() < 0.05,
        "{name}: {share} of the contacts"
    );
    assert!((fit.rms - NOISE).abs() < 0.5 * NOISE, "{name}: {}", fit.rms);
}

#[test]
fn contacts_determine_a_developable_shape_up_to_motions_along_itself() {
    for (radius, axis) in [(0.5, FRAC_PI_2), (0.5, 0.3), (-0.4, FRAC_PI_2)] {
        let shape = SurfaceShape::Cylinder { radius, axis };
        check("cylinder", &shape, SIDES, 4, 5e-5);
    }
    for (radius, half_angle) in [(0.4, 0.6), (-0.5, 0.5)] {
        let cone = Cone {
            radius,
            half_angle,
            axis: 0.2,
        };
        check("cone", &SurfaceShape::Cone(cone), SIDES, 5, 5e-5);
    }
}

#[test]
fn contacts_determine_a_mesh_up_to_motions_along_itself() {
    let bowl = shape_of([0.15, 0.15], |p| {
        Point3::new(p.x, p.y, 0.25 - (0.0625 - p.x * p.x - p.y * p.y).sqrt())
    });
    check("bowl", &bowl, [0.15, 0.15], 3, 5e-5);
    let saddle = shape_of([0.4, 0.3], |p| {
        Point3::new(p.x, p.y, 0.6 * (p.x * p.x - p.y * p.y))
    });
    check("saddle", &saddle, [0.4, 0.3], 4, 1e-4);
    let waves = shape_of([0.5, 0.4], |p| {
        Point3::new(
            p.x,
            p.y,
            0.02 * (9.0 * p.x).sin() + 0.015 * (12.0 * p.y + 4.0 * p.x).cos(),
        )
    });
    check("waves", &waves, [0.5, 0.4], 6, 1e-4);
}

/// On a plane, the registration is the fit of a plane.
#[test]
fn on_a_plane_the_fit_is_that_of_the_plane() {
    let config = PlaneConfig::default();
    let sides = [0.4, 0.28];
    let points = measured(&SurfaceShape::Plane, sides, &planted());
    let plane = fit_plane(&points, &config, 1).expect("a plane");
    let fit = fit_shape(&points, &SurfaceShape::Plane, &config, 1).expect("a fit");
    assert_eq!((fit.determined, fit.inliers), (3, plane.inliers));
    assert_eq!(fit.rms.to_bits(), plane.rms.to_bits());
    let normal = fit.believed_from_real.rotation * Vector3::z();
    let slope = Vector2::new(-normal.x, -normal.y) / normal.z;
    assert!((slope - plane.slope).norm() < 1e-12);
    let height = fit.believed_from_real.translation.z;
    assert!((height - plane.height).abs() < 1e-12);
    for point in &points {
        let off = fit.height(&SurfaceShape::Plane, *point) - plane.distance(*point);
        assert!(off.abs() < 1e-12);
    }
    // One straight stroke determines a height and one slope.
    let line: Vec<Point3> = (0..200)
        .map(|i| Point3::new(1e-3 * f64::from(i), 0.0, 1e-3))
        .collect();
    let fit = fit_shape(&line, &SurfaceShape::Plane, &config, 1).expect("a fit");
    assert_eq!(fit.determined, 2);
}

/// On a narrow pipe, a shift of a fifth of its radius is too far for one linear step.
#[test]
fn a_pipe_is_found_from_several_starts() {
    let pipe = SurfaceShape::Cylinder {
        radius: 0.2,
        axis: FRAC_PI_2,
    };
    for shift in [0.03, -0.045, 0.06] {
        let moved = Pose::translation(shift, 0.0, 0.0);
        let points = measured(&pipe, [0.3, 0.3], &moved);
        let fit = fit_shape(&points, &pipe, &PlaneConfig::default(), 1).expect("a fit");
        assert_eq!(fit.determined, 4, "{shift}");
        let off = offset(&fit, &pipe, [0.3, 0.3], &moved);
        assert!(off <= 5e-5, "{shift}: {off}");
    }
}

/// Scattered points lie on no shape, and a stroke along a pipe's axis determines less than strokes across it.
#[test]
fn a_fit_needs_contacts_on_the_shape() {
    let config = PlaneConfig::default();
    let pipe = SurfaceShape::Cylinder {
        radius: 0.5,
        axis: 0.0,
    };
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let scattered: Vec<Point3> = (0..300)
        .map(|_| {
            Point3::from(Vector3::from_fn(|_, _| {
                0.3 * (random.random::<f64>() - 0.5)
            }))
        })
        .collect();
    assert_eq!(fit_shape(&scattered, &pipe, &config, 1), None);
    assert_eq!(fit_shape(&scattered[..5], &pipe, &config, 1), None);
    let line: Vec<Point3> = (0..200)
        .map(|i| Point3::new(1e-3 * f64::from(i), 0.0, 2e-3))
        .collect();
    let fit = fit_shape(&line, &pipe, &config, 1).expect("a fit");
    assert_eq!((fit.determined, fit.inliers), (2, 200));
}
