//! The method on a surface that is rolled onto a cone.

use super::curved::{polish, strokes_of, task};
use proptest::prelude::*;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::{FRAC_PI_2, PI};
use wisch::follow::{FollowConfig, MotionFault, audit, follow};
use wisch::geometry::{Point2, Point3, Polygon, Pose, Vector2, Vector3};
use wisch::plan::{BendContact, CoverageStrategy, Strategy, predict};
use wisch::represent::{Action, Cone, ElasticFoundation, ShapeFault, Surface, SurfaceShape};
use wisch_testkit::{cell, faults, planned};

const fn cone(radius: f64, half_angle: f64, axis: f64) -> SurfaceShape {
    SurfaceShape::Cone(Cone {
        radius,
        half_angle,
        axis,
    })
}

/// Bulges and hollows, narrow and wide, that widen along x, along y and askew.
const CONES: [SurfaceShape; 4] = [
    cone(0.4, 0.4, 0.4),
    cone(0.5, 0.15, FRAC_PI_2),
    cone(2.0, 1.2, PI),
    cone(-0.4, 0.3, 1.0),
];

fn point_over(shape: &SurfaceShape, place: Point2, height: f64) -> Vector3 {
    shape.place(place, height).translation.vector
}

proptest! {
    #[test]
    fn a_chart_places_what_it_charts(
        (size, is_convex, axis, half_angle) in (0.05..20.0_f64, any::<bool>(), -PI..PI, 0.01..1.4_f64),
        (roll, share, lift) in (-2.5..2.5_f64, 0.3..2.0_f64, -0.2..0.2_f64),
    ) {
        let radius = if is_convex { size } else { -size };
        let shape = cone(radius, half_angle, axis);
        let along = Vector2::new(axis.cos(), axis.sin());
        let across = Vector2::new(-along.y, along.x);
        // In polar coordinates about the apex, a rotation by θ in the chart is one by θ / sin α
        // about the axis.
        let slant = size / half_angle.sin();
        let turn = roll * half_angle.sin() * radius.signum();
        let distance = slant * share;
        let place = Point2::from(along * (distance * turn.cos() - slant) + across * (distance * turn.sin()));
        let height = lift * (size * share / half_angle.cos()).min(1.0);
        let pose = shape.place(place, height);
        let point = pose.translation.vector;
        let scale = slant.max(1.0);
        let found = shape.chart(point.into());
        prop_assert!((found.place - place).norm() < 1e-9 * scale, "{} {}", found.place, place);
        prop_assert!((found.height - height).abs() < 1e-9 * scale, "{} {}", found.height, height);
        prop_assert!((shape.roll(place) - roll).abs() < 1e-9);
        // The foot is as far from the apex as in the chart, and half the opening angle off the axis.
        let foot = point - pose.rotation * Vector3::z() * height;
        let apex = Vector3::new(along.x, along.y, 0.0) * -slant;
        let axis_in_space = Vector3::new(along.x, along.y, 0.0) * half_angle.cos()
            - Vector3::z() * (half_angle.sin() * radius.signum());
        prop_assert!(((foot - apex).norm() - distance).abs() < 1e-9 * scale);
        prop_assert!(((foot - apex).angle(&axis_in_space) - half_angle).abs() < 1e-7);
        // The angle about the axis is that of the roll.
        let off_axis = |p: Vector3| p - axis_in_space * p.dot(&axis_in_space);
        prop_assert!((off_axis(foot - apex).angle(&off_axis(-apex)) - roll.abs()).abs() < 1e-6);
        // The normal is at right angles to the line through the apex, and leans from the axis, or to it in a hollow.
        let normal = pose.rotation * Vector3::z();
        prop_assert!(normal.dot(&(foot - apex)).abs() < 1e-9 * scale);
        let outward = off_axis(foot - apex).normalize() * radius.signum();
        prop_assert!((normal.dot(&outward) - half_angle.cos()).abs() < 1e-9);
        // x and y of the frame are those of the chart: moved by a little, the foot moves along them.
        let step = 1e-6 * scale;
        for (direction, wanted) in [(Vector2::x(), Vector3::x()), (Vector2::y(), Vector3::y())] {
            let [before, after] = [-step, step].map(|step| point_over(&shape, place + direction * step, 0.0));
            prop_assert!(((after - before) / (2.0 * step) - pose.rotation * wanted).norm() < 1e-4);
        }
    }

    /// The second fundamental form is the change of the normal.
    #[test]
    fn a_bend_is_the_turn_of_the_normal(
        (size, is_convex, axis, half_angle) in (0.2..3.0_f64, any::<bool>(), -PI..PI, 0.05..1.3_f64),
        (x, y) in (-0.1..0.1_f64, -0.1..0.1_f64),
    ) {
        let shape = cone(if is_convex { size } else { -size }, half_angle, axis);
        let place = Point2::new(x, y);
        let frame = shape.place(place, 0.0).rotation;
        let bend = shape.bend(place);
        let step = 1e-6;
        for (i, direction) in [Vector2::x(), Vector2::y()].into_iter().enumerate() {
            let [before, after] = [-step, step].map(|step| shape.orientation(place + direction * step) * Vector3::z());
            let turn = frame.inverse() * ((after - before) / (2.0 * step));
            prop_assert!((turn.xy() - bend.column(i)).norm() < 1e-6, "{turn} {bend}");
        }
        let to = Point2::new(-y, x);
        let turned = shape.turn_between(place, to);
        let normal = |share: f64| shape.orientation(place + (to - place) * share) * Vector3::z();
        let way: f64 = (0..400).map(|i| normal(f64::from(i) / 400.0).angle(&normal(f64::from(i + 1) / 400.0))).sum();
        prop_assert!((turned - way).abs() < 1e-5, "{} {}", turned, way);
        // Seen along z, the place is found again.
        let point = point_over(&shape, place, 0.0);
        let seen = shape.place_below(point.xy().into()).unwrap();
        prop_assert!((seen - place).norm() < 1e-9, "{} {}", seen, place);
    }
}

#[test]
fn a_cone_that_hardly_widens_is_a_cylinder() {
    let narrow = cone(0.5, 1e-10, 0.3);
    let straight = SurfaceShape::Cylinder {
        radius: 0.5,
        axis: 0.3,
    };
    for place in [[0.3, -0.2], [-0.5, 0.7]].map(Point2::from) {
        let apart = straight.place(place, 0.05).inverse() * narrow.place(place, 0.05);
        assert!(apart.translation.vector.norm() < 1e-9 && apart.rotation.angle() < 1e-9);
        assert!((straight.bend(place) - narrow.bend(place)).norm() < 1e-8);
        let point = straight.place(place, 0.05).translation.vector;
        let back = narrow.chart(point.into());
        assert!((back.place - place).norm() < 1e-9 && (back.height - 0.05).abs() < 1e-9);
    }
    // A camera sees nothing beside a cone.
    assert_eq!(cone(0.5, 0.3, 0.0).place_below(Point2::new(0.0, 0.6)), None);
}

/// A cone unrolls without stretch, so the plan is that of the plane, to the last bit.
#[test]
fn a_plan_and_its_effect_are_those_of_the_unrolled_board() {
    for action in [Action::Absorb, Action::Collect] {
        let flat = task(action, SurfaceShape::Plane);
        for strategy in [Strategy::Adaptive, CoverageStrategy::Grid.into()] {
            let wanted = strokes_of(&flat, strategy);
            for shape in CONES {
                let rolled = task(action, shape.clone());
                // The whole pad touches the narrow end, too.
                let contact = BendContact::from_task(&rolled).unwrap();
                assert_eq!(contact.touched_share, [1.0; 2]);
                let found = strokes_of(&rolled, strategy);
                assert_eq!(found.strokes, wanted.strokes, "{shape:?}");
                let [a, b] = [(&rolled, &found), (&flat, &wanted)]
                    .map(|(task, plan)| predict(task, plan, |_| ()).particles);
                assert_eq!(a, b, "{shape:?}");
            }
        }
    }
}

/// The narrow end of a cone bends most: there, a rigid tool touches least.
#[test]
fn a_rigid_tool_touches_less_of_the_narrow_end() {
    let shape = cone(0.5, 0.5, 0.0);
    let rigid = polish([0.1, 0.06], 0.0, shape.clone());
    let tool = ElasticFoundation::from_interaction(&rigid.tool.footprint, &rigid.interaction);
    let tool = tool.unwrap();
    let share = |x: f64, yaw: f64| {
        tool.touched_share(&tool.press_upright(&shape.bend(Point2::new(x, 0.0)), yaw))
    };
    assert!(share(-0.3, FRAC_PI_2) < 0.9 * share(0.3, FRAC_PI_2));
    let contact = BendContact::from_task(&rigid).unwrap();
    let least = (0..90).map(|i| share(-0.3, f64::from(i) * PI / 90.0));
    let least = least.fold(f64::INFINITY, f64::min);
    assert!((contact.touched_share[0] - least).abs() < 1e-9, "{contact}");
    assert!(contact.touched_share[1] >= share(0.3, 0.0) - 1e-9);
    // Lanes that are as narrow as what touches at the narrow end cover all of it.
    let plan = strokes_of(&rigid, Strategy::Lanes);
    let done = predict(&rigid, &plan, |_| ()).performance.ratio();
    assert!(done > 0.99, "{done}");
    let soft = polish([0.1, 0.06], 0.01, shape);
    assert_eq!(
        BendContact::from_task(&soft).unwrap().touched_share,
        [1.0; 2]
    );
    let [bent, flat] = [soft, polish([0.1, 0.06], 0.01, SurfaceShape::Plane)]
        .map(|task| strokes_of(&task, Strategy::Lanes).strokes);
    assert_eq!(bent, flat);
}

/// The arm keeps the tool's axis along the normal, which the audit checks with a geometry of its
/// own.
#[test]
fn the_tool_follows_the_cone_and_the_audit_sees_a_lean() {
    let config = FollowConfig::default();
    for (radius, half_angle, axis) in [(0.5, 0.4, FRAC_PI_2), (0.4, 0.7, 0.3), (-0.5, 0.6, PI)] {
        let rolled = task(Action::Absorb, cone(radius, half_angle, axis));
        let (plan, cell) = (planned(&rolled), cell(&rolled));
        let followed = follow(&rolled, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(
            faults(&rolled, &plan, &cell, &followed),
            [] as [String; 0],
            "{radius}"
        );
        let found = audit(&followed, &cell, &rolled, &config).unwrap();
        assert!(found.line.rotation < 1.0_f64.to_radians(), "{radius}");
        // The same motion on a plane, on the cylinder of this radius, and on a cone that bends more.
        let others = [
            SurfaceShape::Plane,
            SurfaceShape::Cylinder { radius, axis },
            cone(radius / 1.5, half_angle, axis),
        ];
        for shape in others {
            let other = task(Action::Absorb, shape.clone());
            let faults = audit(&followed, &cell, &other, &config).unwrap().faults;
            let is_off_line = |fault: &MotionFault| matches!(fault, MotionFault::OffLine { .. });
            assert!(
                faults.iter().any(is_off_line),
                "{radius} {shape:?}: {faults:?}"
            );
        }
        // A lean of 5° of the whole surface.
        let mut leaning = rolled.clone();
        leaning.surface.world_from_surface *=
            Pose::new(Vector3::zeros(), Vector3::y() * 5.0_f64.to_radians());
        let faults = audit(&followed, &cell, &leaning, &config).unwrap().faults;
        assert!(!faults.is_empty(), "{radius}");
    }
}

/// The facets of the body below a cone lie on it.
#[test]
fn the_body_below_a_cone_ends_at_the_cone() {
    for shape in CONES {
        let surface = Surface {
            shape: shape.clone(),
            ..task(Action::Absorb, shape.clone()).surface
        };
        let solid = surface.solid_below(0.02).unwrap();
        let mut random = ChaCha8Rng::seed_from_u64(4);
        for corners in solid.corners() {
            let [a, b]: [f64; 2] = [random.random(), random.random()];
            let (a, b) = if a + b > 1.0 {
                (1.0 - a, 1.0 - b)
            } else {
                (a, b)
            };
            let point: Point3 =
                corners[0] + (corners[1] - corners[0]) * a + (corners[2] - corners[0]) * b;
            let height = shape.chart(point).height;
            assert!((-0.0203..=2e-4).contains(&height), "{shape:?}: {height}");
        }
    }
}

#[test]
fn a_cone_has_limits() {
    let fault = |size: [f64; 2], shape: SurfaceShape| {
        let outline = Polygon::rectangle(Vector2::from(size));
        Surface {
            shape,
            ..Surface::new("funnel", outline, Pose::identity())
        }
        .shape_fault()
    };
    // The apex is 0.25 m before the origin.
    let steep = |axis: f64| cone(0.25 * 0.5_f64.sin(), 0.5, axis);
    assert_eq!(fault([0.3, 0.1], steep(0.0)), None);
    let found = fault([0.48, 0.1], steep(0.0)).unwrap();
    assert!(
        matches!(found, ShapeFault::Apex { narrowest, .. } if narrowest < 0.01),
        "{found}"
    );
    assert!(
        found.to_string().contains("apex is at (-0.250, 0.000) m"),
        "{found}"
    );
    // The apex is on the surface.
    let found = fault([0.6, 0.1], steep(PI)).unwrap();
    assert!(
        matches!(found, ShapeFault::Apex { narrowest: 0.0, .. }),
        "{found}"
    );
    let found = fault([0.3, 0.6], steep(0.0)).unwrap();
    assert!(found.to_string().contains("about the axis of the cone"));
    // An outline behind the apex of a wide cone.
    let point = |[x, y]: [f64; 2]| Point2::new(x, y);
    let ring = [
        [0.2, -0.2],
        [0.2, 0.2],
        [-0.2, 0.2],
        [-0.2, -0.2],
        [-0.15, -0.19],
        [-0.15, 0.19],
        [0.19, 0.19],
        [0.19, -0.2],
    ];
    let mut around = Surface::new(
        "ring",
        Polygon::new(ring.map(point).to_vec(), Vec::new()),
        Pose::identity(),
    );
    around.shape = cone(0.1 * 1.5_f64.sin(), 1.5, 0.0);
    let found = around.shape_fault().unwrap();
    assert!(matches!(found, ShapeFault::Roll { .. }), "{found}");
    for (radius, half_angle) in [(0.5, 0.0), (0.5, 1.58), (0.5, f64::NAN), (0.001, 0.3)] {
        let found = fault([0.1, 0.1], cone(radius, half_angle, 0.0));
        assert!(found.is_some(), "{radius} {half_angle}");
    }
}
