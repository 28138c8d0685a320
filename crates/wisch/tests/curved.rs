//! The method on a surface that is rolled onto a cylinder.

use proptest::prelude::*;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;
use wisch::control::{ControlConfig, press_into_surface};
use wisch::follow::{FollowConfig, MotionFault, Phase, ToolPose, Workcell, audit, follow};
use wisch::geometry::{PlanarPose, Point2, Point3, Polygon, Pose, SheetConfig, Vector2, Vector3};
use wisch::interpret::{Belief, InterpretConfig, TouchSample, Uncertainty, interpret};
use wisch::plan::{BendContact, Plan, PlanConfig, PlanError, Strategy, plan, predict};
use wisch::represent::{
    Action, Cone, Effect, ElasticFoundation, Fate, GoalState, MeshShape, ParticleDistribution,
    ParticleField, Surface, SurfaceShape, Task, Tool, ToolMotion, Treatment, effective_pressure,
};
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, SampleSink, ignore_events};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::{block, board, cell, curved_meshes::mesh_over, faults, planned};

const fn cylinder(radius: f64, axis: f64) -> SurfaceShape {
    SurfaceShape::Cylinder { radius, axis }
}

/// A board without a scene under a soft pad of 10 mm.
pub fn task(action: Action, shape: SurfaceShape) -> Task {
    let mut task = board(action, [0.5, 0.0, 0.2]);
    task.scene.clear();
    task.interaction.compression_depth_m = 0.01;
    task.surface.shape = shape;
    task
}

proptest! {
    #[test]
    fn a_chart_places_what_it_charts(
        (size, is_convex, axis) in (0.05..20.0_f64, any::<bool>(), -PI..PI),
        (roll, along, share) in (-2.5..2.5_f64, -1.0..1.0_f64, -0.4..0.4_f64),
    ) {
        let radius = if is_convex { size } else { -size };
        let shape = cylinder(radius, axis);
        let across = Vector2::new(-axis.sin(), axis.cos());
        let place = Point2::from(Vector2::new(axis.cos(), axis.sin()) * along + across * (radius * roll));
        let height = share * size.min(1.0);
        let pose = shape.place(place, height);
        let found = shape.chart(pose.translation.vector.into());
        prop_assert!((found.place - place).norm() < 1e-9 && (found.height - height).abs() < 1e-9);
        // The outward normal is radial: from the axis, or towards it in a hollow.
        let middle = Vector3::new(axis.cos(), axis.sin(), 0.0) * along - Vector3::z() * radius;
        let outward = (pose.translation.vector - middle) / (radius + height);
        prop_assert!((pose.rotation * Vector3::z() - outward).norm() < 1e-9);
        // x and y of the frame are those of the chart: moved by a little, the foot moves along them.
        let step = 1e-6;
        let beside = shape.place(place + Vector2::x() * step, 0.0).translation.vector;
        let foot = shape.place(place, 0.0);
        prop_assert!(((beside - foot.translation.vector) / step - foot.rotation * Vector3::x()).norm() < 1e-4);
        prop_assert!((shape.turn_between(Point2::origin(), place) - roll.abs()).abs() < 1e-9);
    }
}

#[test]
fn a_bend_is_one_over_the_radius_across_the_axis() {
    let bend = cylinder(-0.5, FRAC_PI_2).bend(Point2::origin());
    assert!((bend - nalgebra::Matrix2::new(-2.0, 0.0, 0.0, 0.0)).norm() < 1e-12);
    // Twice as large a radius as any sagitta could show: a plane.
    let flat = cylinder(1e9, 0.3);
    for place in [[0.3, -0.2], [-1.0, 0.7]].map(Point2::from) {
        let off = flat.place(place, 0.05).translation.vector - Vector3::new(place.x, place.y, 0.05);
        assert!(off.norm() < 1e-9 && flat.orientation(place).angle() < 1e-8);
        let back = flat.chart(Point3::new(place.x, place.y, 0.05));
        assert!((back.place - place).norm() < 1e-9 && (back.height - 0.05).abs() < 1e-9);
    }
}

pub fn strokes_of(task: &Task, strategy: Strategy) -> Plan {
    let config = PlanConfig {
        strategy,
        ..PlanConfig::default()
    };
    plan(task, &config).unwrap()
}

/// A cylinder unrolls without stretch, so the plan is that of the plane, to the last bit.
#[test]
fn a_plan_and_its_effect_are_those_of_the_unrolled_board() {
    for action in [Action::Absorb, Action::Collect] {
        let flat = task(action, SurfaceShape::Plane);
        for strategy in [
            Strategy::Adaptive,
            wisch::plan::CoverageStrategy::Grid.into(),
        ] {
            let wanted = strokes_of(&flat, strategy);
            for (radius, axis) in [(0.3, 0.4), (0.5, FRAC_PI_2), (2.0, 0.0), (-0.3, 1.0)] {
                let rolled = task(action, cylinder(radius, axis));
                let found = strokes_of(&rolled, strategy);
                assert_eq!(found.strokes, wanted.strokes, "{radius}");
                let [a, b] = [(&rolled, &found), (&flat, &wanted)]
                    .map(|(task, plan)| predict(task, plan, |_| ()).particles);
                assert_eq!(a, b, "{radius}");
            }
        }
    }
}

/// Swept in space, the pad touches the places that the plan touches in the chart.
#[test]
fn a_plan_touches_in_space_what_it_touches_in_the_chart() {
    let rolled = task(Action::Absorb, cylinder(0.5, 0.7));
    let plan = planned(&rolled);
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let places: Vec<Point2> = (0..2000)
        .map(|_| {
            Point2::new(
                0.24 * (random.random::<f64>() - 0.5),
                0.18 * (random.random::<f64>() - 0.5),
            )
        })
        .collect();
    let poses: Vec<PlanarPose> = (plan.strokes.iter())
        .flat_map(|stroke| stroke.poses.windows(2))
        .flat_map(|pair| {
            let (from, to) = (pair[0], pair[1]);
            let count = ((to.position - from.position).norm() / 5e-4)
                .ceil()
                .max(1.0) as usize;
            (0..=count).map(move |i| {
                let share = i as f64 / count as f64;
                let heading = from.heading + (to.heading - from.heading) * share;
                PlanarPose::new(
                    from.position + (to.position - from.position) * share,
                    heading,
                )
            })
        })
        .collect();
    let footprint = &rolled.tool.footprint;
    let tools: Vec<Pose> = (poses.iter())
        .map(|pose| {
            let pose = ToolPose {
                surface_from_tool: *pose,
                height: 0.0,
                tilt: 0.0,
            };
            Workcell::world_from_tool(&rolled, &pose).inverse()
        })
        .collect();
    let from_chart = |pose: &PlanarPose, place: Point2| {
        let (sine, cosine) = pose.heading.sin_cos();
        let d = place - pose.position;
        Point2::new(cosine * d.x + sine * d.y, cosine * d.y - sine * d.x)
    };
    let mut otherwise = 0;
    for place in &places {
        let in_chart = poses
            .iter()
            .any(|pose| footprint.contains(from_chart(pose, *place)));
        let point: Point3 = rolled
            .surface
            .world_from_place(*place, 0.0)
            .translation
            .vector
            .into();
        let in_space = tools
            .iter()
            .any(|tool| footprint.contains((tool * point).xy()));
        otherwise += usize::from(in_chart != in_space);
    }
    assert!(
        otherwise * 1000 <= 3 * places.len(),
        "{otherwise} of {}",
        places.len()
    );
}

/// The same motion in parts that begin at these shares of it.
fn split(motion: &ToolMotion, shares: &[f64]) -> Vec<ToolMotion> {
    let at = |share: f64| PlanarPose {
        position: motion.from.position + (motion.to.position - motion.from.position) * share,
        heading: motion.from.heading + motion.turn() * share,
    };
    let ends = [&[0.0], shares, &[1.0]].concat();
    (ends.windows(2))
        .map(|pair| ToolMotion {
            from: at(pair[0]),
            to: at(pair[1]),
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    /// Particles are conserved, and a motion that is split anywhere has the same effect, also where a part of the tool
    /// touches.
    #[test]
    fn a_split_motion_has_the_same_effect_on_a_bend(
        (radius, axis, compression) in (0.2..3.0_f64, 0.0..PI, 0.0..4e-3_f64),
        (is_hollow, heading, turn) in (any::<bool>(), -PI..PI, prop_oneof![Just(0.0), 0.3..2.0_f64]),
        half_angle in prop_oneof![Just(0.0), 0.05..0.8_f64],
        (to_x, to_y) in (-0.15..0.15_f64, -0.1..0.1_f64),
        shares in prop::collection::vec(0.01..0.99_f64, 1..5),
        kind in prop_oneof![Just(Effect::Absorb), Just(Effect::Push), Just(Effect::Treat)],
        seed in 0..1000_u64,
    ) {
        let mut shares = shares;
        shares.sort_by(f64::total_cmp);
        let radius = if is_hollow { -radius } else { radius };
        // Particles that are pushed over a cone come to places with another bend.
        let shape = if half_angle > 0.0 && kind != Effect::Push {
            SurfaceShape::Cone(Cone { radius, half_angle, axis })
        } else {
            cylinder(radius, axis)
        };
        let mut rolled = task(Action::Absorb, shape);
        rolled.interaction.compression_depth_m = compression;
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let places: Vec<Point2> = (0..200)
            .map(|_| Point2::new(0.3 * (random.random::<f64>() - 0.5), 0.2 * (random.random::<f64>() - 0.5)))
            .collect();
        let particles = ParticleDistribution::new(&places).unwrap();
        let motion = ToolMotion {
            from: PlanarPose::new(Point2::new(-0.05, 0.02), heading),
            to: PlanarPose::new(Point2::new(to_x, to_y), heading + turn),
        };
        let after = |motions: &[ToolMotion]| {
            let mut field = ParticleField::new(&particles);
            let mut model = rolled.effect_model(&rolled.tool.footprint, kind);
            for motion in motions {
                model.apply(&mut field, &rolled.surface, motion);
            }
            field.distribution()
        };
        let [whole, parts] = [after(&[motion]), after(&split(&motion, &shares))];
        let tally = whole.tally();
        prop_assert_eq!(tally.remaining + tally.absorbed + tally.off_surface, places.len());
        let mut otherwise = 0;
        for i in 0..places.len() {
            match (whole.fate(i), parts.fate(i)) {
                (Fate::Treated { passes: p }, Fate::Treated { passes: q }) => {
                    prop_assert!((p - q).abs() < 1e-4, "{} {}", p, q);
                }
                (Fate::OnSurface, Fate::OnSurface) => {
                    let moved = (whole.position(i) - parts.position(i)).norm();
                    prop_assert!(moved < 1e-6, "{}: {}", i, moved);
                }
                (Fate::OffSurface { .. }, _) | (_, Fate::OffSurface { .. }) => {
                    otherwise += usize::from(whole.fate(i) != parts.fate(i));
                }
                (a, b) => prop_assert_eq!(a, b),
            }
        }
        // The border is crossed by the chords of a path, which lie within 30 µm of it: near a corner or along the border,
        // a particle may leave over another edge.
        prop_assert!(otherwise <= 1, "{} of {}", otherwise, places.len());
    }
}

/// The pressure at a particle's place acts on it: a particle is absorbed if f′ ever reaches the
/// limit over it.
#[test]
fn only_what_is_pressed_hard_enough_is_wiped() {
    for (radius, axis) in [(0.5, 0.0), (0.5, 0.6), (-0.5, 0.0), (-0.5, FRAC_PI_2)] {
        let mut rolled = task(Action::Absorb, cylinder(radius, axis));
        rolled.interaction.compression_depth_m = 0.0;
        let tool = ElasticFoundation::from_interaction(&rolled.tool.footprint, &rolled.interaction)
            .unwrap();
        let least = effective_pressure(&rolled.interaction.likelihood);
        let pressure = tool.press_upright(&rolled.surface.shape.bend(Point2::origin()), 0.2);
        let motion = ToolMotion {
            from: PlanarPose::new(Point2::new(-0.05, -0.01), 0.2),
            to: PlanarPose::new(Point2::new(0.04, 0.02), 0.2),
        };
        let places: Vec<Point2> = (0..60)
            .flat_map(|i| {
                (0..40).map(move |j| {
                    Point2::new(
                        -0.147 + 0.005 * f64::from(i),
                        -0.0973 + 0.005 * f64::from(j),
                    )
                })
            })
            .collect();
        let mut field = ParticleField::new(&ParticleDistribution::new(&places).unwrap());
        let mut model = rolled.effect_model(&rolled.tool.footprint, Effect::Absorb);
        model.apply(&mut field, &rolled.surface, &motion);
        let after = field.distribution();
        let mut absorbed = 0;
        for (i, place) in places.iter().enumerate() {
            let most = (0..=2000).map(|step| {
                let share = f64::from(step) / 2000.0;
                let at = PlanarPose::new(
                    motion.from.position + (motion.to.position - motion.from.position) * share,
                    0.2,
                );
                let under = at.inverse_transform(*place);
                if rolled.tool.footprint.contains(under) {
                    pressure.evaluate(under)
                } else {
                    0.0
                }
            });
            let most = most.fold(0.0, f64::max);
            // At the border of the acting part, the samples may err by a step.
            if (most - least).abs() > 0.05 {
                assert_eq!(
                    after.fate(i) == Fate::Absorbed,
                    most > least,
                    "{radius} {axis} {place}: {most}"
                );
                absorbed += usize::from(most > least);
            }
        }
        assert!(absorbed > 50, "{absorbed}");
    }
}

/// A polish of a board of 0.6 × 0.4 m by a pad with these sides along and across the motion [m].
pub fn polish(pad: [f64; 2], compression: f64, shape: SurfaceShape) -> Task {
    let mut polish = task(Action::Polish, shape);
    polish.tool = Tool::pad("pad", Vector3::new(pad[0], pad[1], 0.04)).unwrap();
    polish.surface.outline = Polygon::rectangle(Vector2::new(0.6, 0.4));
    let places: Vec<Point2> = (0..60)
        .flat_map(|i| (0..40).map(move |j| [i, j].map(f64::from)))
        .map(|[i, j]| Point2::new(0.01 * i - 0.295, 0.01 * j - 0.195))
        .collect();
    polish.particles = ParticleDistribution::new(&places).unwrap();
    polish.treatment = Some(Treatment::Polish {
        passes: 1,
        max_passes: 20,
        preston: None,
    });
    polish.interaction.compression_depth_m = compression;
    polish
}

/// A rigid tool whose long side is across the bend touches 39 % of its width and leaves 61 %.
#[test]
fn lanes_of_a_rigid_tool_turn_its_long_side_along_the_axis_or_lie_closer() {
    let touched = |task: &Task, yaw: f64| {
        let tool =
            ElasticFoundation::from_interaction(&task.tool.footprint, &task.interaction).unwrap();
        tool.touched_share(&tool.press_upright(&task.surface.shape.bend(Point2::origin()), yaw))
    };
    let performance = |task: &Task, plan: &Plan| predict(task, plan, |_| ()).performance.ratio();
    let heading = |plan: &Plan| plan.strokes[0].poses[0].heading;
    let pad = [0.06, 0.1];
    let flat = strokes_of(&polish(pad, 0.0, SurfaceShape::Plane), Strategy::Lanes);
    let axis = heading(&flat);
    let rigid = polish(pad, 0.0, cylinder(0.5, axis));
    let [across, along] = [axis, axis + FRAC_PI_2].map(|yaw| touched(&rigid, yaw));
    assert!((1.0 - across - 0.61).abs() < 0.005 && (along - 0.55).abs() < 0.005);
    let contact = BendContact::from_task(&rigid).unwrap();
    assert!(contact.touched_share[0] <= across && contact.touched_share[1] >= along);
    // The lanes of a plane leave more than half; those of the bend turn by a right angle.
    assert!(performance(&rigid, &flat) < 0.5);
    let plan = strokes_of(&rigid, Strategy::Lanes);
    assert!(libm::cos(heading(&plan) - axis).abs() < 1e-9);
    assert!(performance(&rigid, &plan) > 0.999);
    // A tool whose long side is along the motion stays along the axis, in lanes as narrow as what it touches.
    for axis in [0.0, FRAC_PI_2, 0.4] {
        let long = polish([0.1, 0.06], 0.0, cylinder(0.5, axis));
        let plan = strokes_of(&long, Strategy::Lanes);
        let side = Vector2::new(-libm::sin(axis), libm::cos(axis));
        let mut lanes: Vec<f64> = (plan.strokes.iter())
            .map(|stroke| stroke.poses[0].position.coords.dot(&side))
            .collect();
        lanes.sort_by(f64::total_cmp);
        let pitches = lanes.windows(2).map(|pair| pair[1] - pair[0]);
        let pitches: Vec<f64> = pitches.filter(|&pitch| pitch > 1e-6).collect();
        let widest = pitches.iter().copied().fold(0.0, f64::max);
        let touched = 0.06 * touched(&long, axis);
        assert!(libm::sin(heading(&plan) - axis).abs() < 1e-9, "{axis}");
        assert!(
            pitches.len() > 5 && widest <= touched,
            "{lanes:?} {touched}"
        );
        assert!(performance(&long, &plan) > 0.99, "{axis}");
    }
    // A soft tool lies on the bend, so that its plan is that of the plane.
    let [soft, flat] =
        [cylinder(0.5, 0.4), SurfaceShape::Plane].map(|shape| polish(pad, 0.01, shape));
    assert_eq!(
        BendContact::from_task(&soft).unwrap().touched_share,
        [1.0; 2]
    );
    let [bent, flat] = [soft, flat].map(|task| strokes_of(&task, Strategy::Lanes).strokes);
    assert_eq!(bent, flat);
    // In a hollow, a rigid tool rides on its ends. Lanes as close as each of them is wide cover the surface.
    let hollow = polish(pad, 0.0, cylinder(-0.5, 0.3));
    let plan = strokes_of(&hollow, Strategy::Lanes);
    let found = performance(&hollow, &plan);
    assert!(found > 0.95, "{found}");
    // The ends of the short side begin 1.9 cm from the middle: they never reach the middle of a hollow 3 cm wide.
    let mut narrow = hollow;
    narrow.surface.shape = cylinder(-0.5, 0.0);
    narrow.surface.outline = Polygon::rectangle(Vector2::new(0.3, 0.03));
    let places: Vec<Point2> = (0..30)
        .map(|i| Point2::new(0.0, 0.001 * f64::from(i) - 0.0145))
        .collect();
    narrow.particles = ParticleDistribution::new(&places).unwrap();
    let share = strokes_of(&narrow, Strategy::Lanes).unreachable_share;
    assert!(share > 0.1 && share < 0.5, "{share}");
    narrow.surface.shape = cylinder(0.5, 0.0);
    assert_eq!(strokes_of(&narrow, Strategy::Lanes).unreachable_share, 0.0);
}

#[test]
fn what_the_model_does_not_hold_for_is_refused_with_place_value_and_limit() {
    let refused = |task: &Task| plan(task, &PlanConfig::default()).unwrap_err();
    // A flat tool that is wider than a gutter does not fit into it.
    let mut gutter = task(Action::Absorb, cylinder(-0.06, 0.0));
    gutter.surface.outline = Polygon::rectangle(Vector2::new(0.3, 0.2));
    let error = refused(&gutter).to_string();
    assert!(
        error.contains("\"board\"") && error.contains("0.065 m") && error.contains("-0.060 m"),
        "{error}"
    );
    let error = refused(&task(Action::Absorb, cylinder(0.04, FRAC_PI_2)));
    assert!(error.to_string().contains("reaches"), "{error}");
    let error = refused(&task(Action::Absorb, cylinder(f64::NAN, 0.0)));
    assert!(matches!(error, PlanError::Shape { .. }), "{error}");
    let mut near = task(Action::Absorb, cylinder(1.0, 0.0));
    near.scene
        .push(block("cup", [0.05, 0.05, 0.1], [0.55, 0.0, 0.25]));
    let error = refused(&near);
    assert!(matches!(error, PlanError::ObstacleOnBend { .. }), "{error}");
    near.scene[0] = block("cup", [0.05, 0.05, 0.1], [0.9, 0.0, 0.25]);
    assert!(plan(&near, &PlanConfig::default()).is_ok());
}

/// The arm keeps the tool's axis along the normal, which the audit checks with a geometry of its
/// own.
#[test]
fn the_tool_follows_the_bend_and_the_audit_sees_a_lean() {
    let config = FollowConfig::default();
    for radius in [0.3, 0.5, -0.5] {
        let rolled = task(Action::Absorb, cylinder(radius, FRAC_PI_2));
        let (plan, cell) = (planned(&rolled), cell(&rolled));
        let followed = follow(&rolled, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(
            faults(&rolled, &plan, &cell, &followed),
            [] as [String; 0],
            "{radius}"
        );
        let found = audit(&followed, &cell, &rolled, &config).unwrap();
        assert!(found.line.rotation < 1.0_f64.to_radians(), "{radius}");
        // The same motion on a plane, and on a cylinder on whose rim the normal leans by 5° less.
        let rim: f64 = 0.12;
        let other = 1.0 / (1.0 / radius - 5.0_f64.to_radians() / rim);
        for shape in [SurfaceShape::Plane, cylinder(other, FRAC_PI_2)] {
            let flat = task(Action::Absorb, shape.clone());
            let faults = audit(&followed, &cell, &flat, &config).unwrap().faults;
            let is_off_line = |fault: &MotionFault| matches!(fault, MotionFault::OffLine { .. });
            assert!(
                faults.iter().any(is_off_line),
                "{radius} {shape:?}: {faults:?}"
            );
        }
    }
}

#[test]
fn the_controller_presses_along_the_normal_of_the_place() {
    let rolled = task(Action::Absorb, cylinder(0.5, FRAC_PI_2));
    let place = Point2::new(0.1, 0.03);
    let tool = rolled.surface.world_from_place(place, 0.0);
    let pressed = press_into_surface(
        tool,
        Some(Phase::Wipe(0)),
        &rolled,
        &ControlConfig::default(),
    );
    let by = tool.inverse() * pressed;
    assert!(by.translation.vector.xy().norm() < 1e-12 && by.translation.z < 0.0);
    let above = rolled.surface.world_from_place(place, 0.2);
    let free = press_into_surface(
        above,
        Some(Phase::Wipe(0)),
        &rolled,
        &ControlConfig::default(),
    );
    assert_eq!(free, above);
}

/// A robot whose tool follows its path exactly, and measures the press force along the normal while it wipes.
struct Obedient;

impl Executor for Obedient {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let surface = &order.task.surface;
        Ok(order.play(0.01, sink, |at| {
            let place = surface
                .chart(at.world_from_tool.translation.vector.into())
                .place;
            let press = order.task.interaction.press_force_n * f64::from(at.phase.is_contact());
            TouchSample::new(at.time, at.world_from_tool, surface.normal(place) * press)
        }))
    }
}

#[test]
fn a_session_wipes_a_bend_as_it_wipes_a_plane() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenarios/arm-board.toml"
    );
    let mut loaded = load_task(path.as_ref(), &LoadOptions::default()).expect("a task");
    loaded.task.scene.clear();
    let robot = loaded.robot().expect("a robot").expect("it names one");
    let mut performed = Vec::new();
    let cone = Cone {
        radius: 0.8,
        half_angle: 0.3,
        axis: FRAC_PI_2,
    };
    for shape in [
        SurfaceShape::Plane,
        cylinder(1.0, FRAC_PI_2),
        SurfaceShape::Cone(cone),
    ] {
        loaded.task.surface.shape = shape.clone();
        let mut session = loaded.session().with_robot(robot.robot_setup());
        session
            .run(&mut Obedient, &mut ignore_events)
            .expect("it ends");
        let round = &session.rounds()[0];
        let found = &round.interpretation;
        assert_eq!(found.doubts, [], "{shape:?}");
        assert!(
            found.events.iter().all(|event| !event.kind.is_by_hand()),
            "{:?}",
            found.events
        );
        performed.push((found.contact_share.unwrap(), found.performance.mean));
    }
    let [flat, bends @ ..] = &performed[..] else {
        panic!()
    };
    for bent in bends {
        assert!(
            (flat.0 - bent.0).abs() < 0.02 && (flat.1 - bent.1).abs() < 0.02,
            "{performed:?}"
        );
    }
}

/// A hard pad touches a bulge of 0.3 m with the middle 5.8 cm of its 11 cm, and sinks in by 0.9 mm.
#[test]
fn what_the_edge_of_a_pad_does_not_touch_is_not_credited() {
    let mut rolled = task(Action::Absorb, cylinder(0.3, 0.0));
    rolled.interaction.compression_depth_m = 5e-4;
    let places: Vec<Point2> = (0..9)
        .flat_map(|i| {
            (0..21)
                .map(move |j| Point2::new(0.01 * f64::from(i) - 0.04, 0.005 * f64::from(j) - 0.05))
        })
        .collect();
    rolled.particles = ParticleDistribution::new(&places).unwrap();
    let tool =
        ElasticFoundation::from_interaction(&rolled.tool.footprint, &rolled.interaction).unwrap();
    let pressure = tool.press_upright(&rolled.surface.shape.bend(Point2::origin()), 0.0);
    let sinking = 5e-4 * (pressure.middle - 1.0);
    assert!((sinking - 9e-4).abs() < 1e-4, "{sinking}");
    let press = rolled.interaction.press_force_n;
    let samples: Vec<TouchSample> = (0..6000)
        .map(|i| {
            let time = 1e-3 * f64::from(i);
            let x = (0.04 * (time - 3.0)).clamp(-0.08, 0.08);
            let lift = (0.05 * ((time - 3.0).abs() - 2.0)).max(0.0);
            let place = Point2::new(x, 0.0);
            let pose = rolled.surface.world_from_place(place, lift - sinking);
            let force = rolled.surface.normal(place) * if lift > 0.0 { 0.0 } else { press };
            TouchSample::new(time, pose, force)
        })
        .collect();
    let read = |task: &Task| {
        let believed = Belief::from_particles(task.particles.clone());
        let config = InterpretConfig {
            uncertainty: Uncertainty::NONE,
            ..InterpretConfig::from_task(task)
        };
        let found = interpret(&samples, task, &believed, &GoalState::Absorbed, &config).unwrap();
        // Share of the members in which each particle is absorbed.
        let members = found.belief.members();
        let absorbed = |i: usize| {
            members
                .iter()
                .filter(|dirt| dirt.fate(i) == Fate::Absorbed)
                .count()
        };
        let shares: Vec<f64> = (0..places.len())
            .map(|i| absorbed(i) as f64 / members.len() as f64)
            .collect();
        (found.plane.expect("a plane").offset, shares)
    };
    let (offset, shares) = read(&rolled);
    assert!(offset.abs() < 1e-4, "{offset}");
    for (place, share) in places.iter().zip(&shares) {
        if place.y.abs() < 0.024 {
            assert!(*share > 0.9, "{place} {share}");
        } else if place.y.abs() > 0.0295 {
            assert_eq!(*share, 0.0, "{place}");
        }
    }
    // A soft pad lies on the bend, and the particles under its path are absorbed.
    rolled.interaction.compression_depth_m = 0.01;
    let soft = rolled.clone();
    let (_, shares) = read(&soft);
    assert!(shares.iter().all(|&share| share > 0.6), "{shares:?}");
}

#[test]
fn a_shape_has_limits() {
    let surface = |shape| Surface {
        shape,
        ..Surface::new(
            "pipe",
            Polygon::rectangle(Vector2::new(0.6, 0.1)),
            Pose::identity(),
        )
    };
    assert_eq!(surface(cylinder(0.13, FRAC_PI_2)).shape_fault(), None);
    let closed = surface(cylinder(0.11, FRAC_PI_2)).shape_fault().unwrap();
    assert!(
        closed.to_string().contains("156° about the axis"),
        "{closed}"
    );
    assert!(surface(cylinder(0.001, 0.0)).shape_fault().is_some());
}

/// A tool that hovers does not bend with the surface: its ends hover higher over a bulge, and meet a hollow.
#[test]
fn a_tool_that_hovers_is_refused_where_the_bend_exceeds_its_gap() {
    let hovering = |radius: f64, gap: f64| {
        let mut task = task(Action::Absorb, cylinder(radius, FRAC_PI_2));
        task.interaction.gap_m = gap;
        plan(&task, &PlanConfig::default()).map(|_| ())
    };
    for radius in [0.5, -0.5] {
        let error = hovering(radius, 0.001).unwrap_err();
        assert!(
            matches!(error, PlanError::HoversOffBend { sag, limit, .. } if sag > limit),
            "{error}"
        );
    }
    assert_eq!(hovering(20.0, 0.003), Ok(()));
    assert_eq!(hovering(-20.0, 0.003), Ok(()));
}

/// A board of the size of [`task`]'s over a mesh, in the pose of that task's surface.
fn on_mesh(action: Action, point: impl Fn(Point2) -> Point3) -> Task {
    let mut task = task(action, SurfaceShape::Plane);
    let bounds = task.surface.outline.outer().iter();
    let size = bounds.fold(Vector2::zeros(), |size, p| {
        size.sup(&(p.coords.abs() * 2.0))
    });
    let mesh = mesh_over([40, 40], [size.x, size.y], point);
    let config = SheetConfig {
        tool_radius: task.tool.collision_radius(),
        ..SheetConfig::default()
    };
    let (shape, mesh_from_surface) = MeshShape::from_mesh(&mesh, &config).unwrap();
    task.surface.outline = shape.outline();
    task.surface.world_from_surface *= mesh_from_surface;
    task.surface.shape = SurfaceShape::Mesh(Arc::new(shape));
    task
}

fn pipe_point(radius: f64) -> impl Fn(Point2) -> Point3 {
    move |p| {
        let angle = p.x / radius;
        Point3::new(radius * angle.sin(), p.y, radius * (angle.cos() - 1.0))
    }
}

/// A dish that bulges in both directions.
fn dish_point(p: Point2) -> Point3 {
    Point3::new(p.x, p.y, -0.9 * p.x * p.x - 0.5 * p.y * p.y)
}

/// The mesh of a cylinder is the cylinder, up to its facets and the fit of the bend.
#[test]
fn the_mesh_of_a_cylinder_is_that_cylinder() {
    for radius in [0.5, -0.8] {
        let meshed = on_mesh(Action::Absorb, pipe_point(radius));
        let rolled = task(Action::Absorb, cylinder(radius, FRAC_PI_2));
        let mut random = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..200 {
            let place = [0.23, 0.17].map(|side| side * (random.random::<f64>() - 0.5));
            let place = Point2::from(place);
            let height = 0.05 * random.random::<f64>();
            let [found, wanted] =
                [&meshed, &rolled].map(|t| t.surface.world_from_place(place, height));
            let apart = wanted.inverse() * found;
            assert!(
                apart.translation.vector.norm() < 1e-3,
                "{radius} {place}: {apart}"
            );
            assert!(apart.rotation.angle() < 0.02, "{radius} {place}: {apart}");
            let back = meshed.surface.chart(found.translation.vector.into());
            let off = (back.place - place).norm() + (back.height - height).abs();
            assert!(off < 2e-3, "{radius} {place}: {off}");
            let bend = meshed.surface.shape.bend(place) - rolled.surface.shape.bend(place);
            assert!(bend.norm() < 0.1 / radius.abs(), "{radius} {place}: {bend}");
        }
        // A camera along the axis of the surface's frame sees the same places.
        for place in [[0.1, 0.05], [-0.11, 0.0], [0.02, -0.07]].map(Point2::from) {
            let below = meshed
                .surface
                .shape
                .place(place, 0.0)
                .translation
                .vector
                .xy();
            let seen = meshed.surface.shape.place_below(below.into()).unwrap();
            assert!((seen - place).norm() < 1e-6, "{radius} {place}: {seen}");
        }
        // Beyond the border, the surface continues straight.
        let beyond = Point2::new(0.14, 0.0);
        let [found, wanted] =
            [&meshed, &rolled].map(|t| t.surface.world_from_place(beyond, 0.0).translation.vector);
        assert!((found - wanted).norm() < 2e-3, "{radius}: {found} {wanted}");
        let back = meshed.surface.chart(found.into());
        assert!((back.place - beyond).norm() < 1e-6 && back.height.abs() < 1e-6);
        let [found, wanted] = [&meshed, &rolled].map(|task| {
            let plan = strokes_of(task, wisch::plan::CoverageStrategy::Grid.into());
            (
                predict(task, &plan, |_| ()).particles.tally().absorbed,
                plan.contact_distance(),
            )
        });
        assert_eq!(found.0, wanted.0, "{radius}");
        assert!(
            (found.1 / wanted.1 - 1.0).abs() < 0.1,
            "{found:?} {wanted:?}"
        );
    }
}

/// The tool follows the normals of a mesh, and the audit measures it against the mesh as given.
#[test]
fn the_tool_follows_a_mesh_and_the_audit_sees_a_lean() {
    let config = FollowConfig::default();
    let meshed = on_mesh(Action::Absorb, dish_point);
    let (plan, cell) = (planned(&meshed), cell(&meshed));
    let followed = follow(&meshed, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    assert_eq!(faults(&meshed, &plan, &cell, &followed), [] as [String; 0]);
    // The same motion where the mesh as given leans by 5°, or lies 3 mm lower.
    let lean = Pose::new(Vector3::zeros(), Vector3::x() * 5.0_f64.to_radians());
    for moved in [lean, Pose::translation(0.0, 0.0, -3e-3)] {
        let SurfaceShape::Mesh(shape) = &meshed.surface.shape else {
            panic!("it is a mesh");
        };
        let scanned = MeshShape::clone(shape).with_mesh(shape.mesh().transform(&moved));
        let mut other = meshed.clone();
        other.surface.shape = SurfaceShape::Mesh(Arc::new(scanned));
        let faults = audit(&followed, &cell, &other, &config).unwrap().faults;
        let is_off = |fault: &MotionFault| matches!(fault, MotionFault::OffMesh { .. });
        assert!(faults.iter().any(is_off), "{moved}: {faults:?}");
    }
}
