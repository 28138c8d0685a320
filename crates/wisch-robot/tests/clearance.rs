//! Collisions of the shipped robots.

use proptest::prelude::*;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use wisch_robot::geometry::{Mesh, Point3, Pose, Vector3};
use wisch_robot::{
    AllowedReason, CollisionModel, Margins, RobotError, RobotModel, SEGMENT_RESOLUTION, Shape, Srdf,
};

pub(crate) fn committed(file: &str) -> String {
    let path = format!("{}/../../robots/{file}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

pub(crate) fn robot(name: &str) -> RobotModel {
    let no_meshes = &mut |_: &str| Err("the shipped robots have no meshes".to_owned());
    let file = format!("{name}.urdf");
    RobotModel::from_urdf(&file, &committed(&file), no_meshes).unwrap()
}

pub(crate) fn srdf(name: &str, robot: &RobotModel) -> Srdf {
    let file = format!("{name}.srdf");
    Srdf::parse(&file, &committed(&file), robot).unwrap()
}

fn model(name: &str) -> (RobotModel, Srdf, CollisionModel) {
    let robot = robot(name);
    let srdf = srdf(name, &robot);
    let model = CollisionModel::new(&robot, Some(&srdf)).unwrap();
    (robot, srdf, model)
}

pub(crate) static HUMANOID: LazyLock<(RobotModel, Srdf, CollisionModel)> =
    LazyLock::new(|| model("humanoid"));

fn ready(name: &str) -> Vec<f64> {
    let (robot, srdf, _) = model(name);
    srdf.state("ready")
        .unwrap()
        .apply_to(&vec![0.0; robot.dof()])
}

/// Positions from numbers within 0 to 1, within the limits of the variables and ±1 elsewhere.
fn posture(robot: &RobotModel, shares: &[f64]) -> Vec<f64> {
    let position = |(i, share): (usize, &f64)| match robot.variable(i).limits.position {
        Some(range) if range.upper < 50.0 => range.lower + share * (range.upper - range.lower),
        _ => 2.0 * share - 1.0,
    };
    shares.iter().enumerate().map(position).collect()
}

fn shares() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.0..1.0f64, 22)
}

fn is_send_and_sync<T: Send + Sync>() {}

#[test]
fn a_model_is_shared_by_threads() {
    is_send_and_sync::<CollisionModel>();
}

#[test]
fn the_ready_postures_are_free() {
    for name in ["humanoid", "arm7", "arm6"] {
        let (_, _, model) = model(name);
        let clearance = model.clearance(&ready(name), f64::INFINITY).unwrap();
        let nearest = clearance.pair.map(|pair| model.describe(&pair));
        assert!(clearance.distance > 0.005, "{name}: {nearest:?}");
    }
}

/// Most postures are free: a model that always collides would satisfy other tests trivially.
#[test]
fn many_postures_are_free() {
    for (name, expected) in [("humanoid", 400), ("arm7", 900), ("arm6", 750)] {
        let (robot, _, model) = model(name);
        let is_free = |i: &usize| {
            let share = |k: usize| (0.5 + *i as f64 * (2.0 + k as f64).sqrt()).fract();
            let q = posture(&robot, &(0..robot.dof()).map(share).collect::<Vec<_>>());
            model.collision(&q, 0.0).unwrap().is_none()
        };
        let free = (0..1000).filter(is_free).count();
        assert!(free > expected, "{name}: {free} of 1000");
    }
}

#[test]
fn what_may_touch_in_the_humanoid_is_what_should() {
    let (_, _, model) = &*HUMANOID;
    let mut allowed: Vec<String> = model
        .allowed_pairs()
        .map(|(a, b, reason)| format!("{a} {b} {reason:?}"))
        .collect();
    allowed.sort();
    let expected = [
        "left_arm_2_link left_arm_4_link Neighbours",
        "left_arm_4_link left_tcp Neighbours",
        "right_arm_2_link right_arm_4_link Neighbours",
        "right_arm_4_link right_tcp Neighbours",
        "torso_2_link torso_3_link Neighbours",
        "torso_3_link torso_4_link Neighbours",
        "torso_4_link head_2_link Neighbours",
        "torso_4_link left_arm_2_link Neighbours",
        "torso_4_link right_arm_2_link Neighbours",
        "torso_foot torso_2_link Neighbours",
    ];
    assert_eq!(allowed, expected);
}

/// Two rods on one post that overlap in every posture, on links without shapes, and a third that
/// sometimes touches them.
const CROWDED: &str = r#"<robot name="crowded">
  <link name="post"/>
  <link name="a"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="b"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="c"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <joint name="ja" type="continuous"><parent link="post"/><child link="a"/><axis xyz="0 0 1"/></joint>
  <joint name="jb" type="continuous"><parent link="post"/><child link="b"/><origin xyz="0.1 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="jc" type="prismatic"><parent link="post"/><child link="c"/><axis xyz="1 0 0"/><limit lower="-1" upper="1"/></joint>
</robot>"#;

fn parsed(text: &str) -> RobotModel {
    RobotModel::from_urdf("text.urdf", text, &mut |_| Err("no meshes".into())).unwrap()
}

#[test]
fn pairs_that_always_overlap_may_touch() {
    let model = CollisionModel::new(&parsed(CROWDED), None).unwrap();
    let allowed: Vec<_> = model.allowed_pairs().collect();
    assert_eq!(allowed, [("a", "b", AllowedReason::AlwaysColliding)]);
    let checked: Vec<_> = model.checked_pairs().collect();
    assert_eq!(checked, [("a", "c"), ("b", "c")]);
}

fn ball(radius: f64) -> Mesh {
    Mesh::sphere(radius, 24).unwrap()
}

#[test]
fn planted_collisions_are_found_and_named() {
    let (robot, _, model) = &*HUMANOID;
    let q = ready("humanoid");
    let kinematics = robot.forward_kinematics(&q).unwrap();
    // An obstacle put on each link that has shapes, about its first shape.
    for (i, link) in robot.links().iter().enumerate() {
        let Some(shape) = link.collision.first() else {
            continue;
        };
        let id = robot.link(&link.name).unwrap();
        let at = kinematics.world_from_link(id) * shape.link_from_shape;
        let mut planted = model.clone();
        let name = format!("ball {i}");
        planted.add_obstacle(&name, at, &ball(0.01)).unwrap();
        let clearance = planted.clearance(&q, 1.0).unwrap();
        let contact = clearance.pair.unwrap();
        assert!(contact.distance < 0.0);
        assert_eq!(planted.name(contact.b), name);
        let contact = planted.collision(&q, 0.0).unwrap().unwrap();
        assert_eq!(planted.name(contact.b), name);
        planted.allow(&link.name, &name).unwrap();
        let now = planted.collision(&q, 0.0).unwrap();
        assert!(now.is_none_or(|c| planted.name(c.a) != link.name));
    }
    // A hand through the chest: the elbow folded, the arm turned in.
    let mut q = q;
    let at = |name: &str| {
        let joint = robot.joint(name).unwrap();
        robot.variables().iter().position(|v| *v == joint).unwrap()
    };
    let mut named = BTreeSet::new();
    for turn in -16..16 {
        q[at("right_arm_3")] = f64::from(turn) / 16.0 * 2.9;
        if let Some(contact) = model.collision(&q, 0.0).unwrap() {
            named.insert((model.name(contact.a), model.name(contact.b)));
        }
    }
    assert!(
        named
            .iter()
            .any(|(a, b)| a.starts_with("torso") && b.starts_with("right_")),
        "{named:?}"
    );
}

#[test]
fn a_tool_is_checked_but_not_against_its_hand() {
    let (robot, _, model) = &*HUMANOID;
    let mut model = model.clone();
    let tcp = robot.link("right_tcp").unwrap();
    let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap();
    model
        .attach("sponge", tcp, Pose::identity(), &sponge)
        .unwrap();
    let with: BTreeSet<&str> = model
        .checked_pairs()
        .filter(|(a, b)| *a == "sponge" || *b == "sponge")
        .map(|(a, _)| a)
        .collect();
    let expected = [
        "head_2_link",
        "left_arm_2_link",
        "left_arm_4_link",
        "left_tcp",
        "right_arm_2_link",
        "torso_2_link",
        "torso_3_link",
        "torso_4_link",
        "torso_foot",
    ];
    assert_eq!(with, BTreeSet::from(expected));
    let q = ready("humanoid");
    let world_from_tool = robot.forward_kinematics(&q).unwrap().world_from_link(tcp);
    model
        .add_obstacle("crumb", world_from_tool, &ball(0.005))
        .unwrap();
    // The hand's shape extends beyond the TCP.
    model.allow("right_tcp", "crumb").unwrap();
    let contact = model.collision(&q, 0.0).unwrap().unwrap();
    assert_eq!(
        model.describe(&contact),
        "\"sponge\" and \"crumb\" overlap by at least 0.0002 m"
    );
}

/// A gripper as real robots have it: the tool centre point is a frame without shapes, fixed to the palm.
#[test]
fn fingers_may_touch_the_tool_that_they_hold() {
    let robot = parsed(
        r#"<robot name="gripper">
  <link name="arm"><collision><origin xyz="0 0 -0.3"/><geometry><sphere radius="0.05"/></geometry></collision></link>
  <link name="palm"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <link name="finger"><collision><origin xyz="0 0 0.1"/><geometry><sphere radius="0.02"/></geometry></collision></link>
  <link name="fingertip"><collision><origin xyz="0 0 0.12"/><geometry><sphere radius="0.01"/></geometry></collision></link>
  <link name="tcp"/>
  <joint name="wrist" type="prismatic"><parent link="arm"/><child link="palm"/><axis xyz="0 0 1"/><limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
  <joint name="grip" type="prismatic"><parent link="palm"/><child link="finger"/><axis xyz="1 0 0"/><limit lower="0" upper="0.04" velocity="1" effort="1"/></joint>
  <joint name="bend" type="revolute"><parent link="finger"/><child link="fingertip"/><axis xyz="0 1 0"/><limit lower="0" upper="1" velocity="1" effort="1"/><mimic joint="grip"/></joint>
  <joint name="at" type="fixed"><parent link="palm"/><child link="tcp"/><origin xyz="0 0 0.1"/></joint>
</robot>"#,
    );
    let mut model = CollisionModel::new(&robot, None).unwrap();
    let tcp = robot.link("tcp").unwrap();
    model
        .attach("sponge", tcp, Pose::identity(), &ball(0.04))
        .unwrap();
    assert_eq!(model.collision(&[0.0, 0.0], 0.0).unwrap(), None);
    let checked: Vec<_> = model
        .checked_pairs()
        .filter(|(a, b)| *a == "sponge" || *b == "sponge")
        .collect();
    assert_eq!(checked, [("arm", "sponge")]);
}

#[test]
fn names_poses_and_arrays_that_are_wrong_are_refused() {
    let robot = parsed(CROWDED);
    let mut model = CollisionModel::new(&robot, None).unwrap();
    let mesh = ball(0.1);
    let nowhere = Pose::translation(f64::NAN, 0.0, 0.0);
    let faults = [
        (
            model.allow("a", "cc"),
            "unknown link, body or obstacle \"cc\"; known: c",
        ),
        (
            model.add_obstacle("a", Pose::identity(), &mesh),
            "body \"a\": a link, body or obstacle of this name already exists",
        ),
        (
            model.add_obstacle("wall", nowhere, &mesh),
            "body \"wall\": its pose is not finite",
        ),
        (
            model.attach("tool", robot.root(), nowhere, &mesh),
            "body \"tool\": its pose is not finite",
        ),
        (
            model.clearance(&[0.0; 2], 1.0).map(|_| ()),
            "positions has 2 values, the robot has 3 variables",
        ),
        (
            model.clearance(&[0.0, f64::NAN, 0.0], 1.0).map(|_| ()),
            "joint \"jb\": positions NaN is not finite",
        ),
        (
            model.clearance(&[0.0; 3], -0.5).map(|_| ()),
            "distance to look up to is -0.5 m, expected at least 0 m",
        ),
        (
            model.collision(&[0.0; 3], f64::NAN).map(|_| ()),
            "margin is NaN m, expected at least 0 m",
        ),
        (
            model.segment_contact(&[0.0; 3], &[0.0; 4], 0.0).map(|_| ()),
            "positions has 4 values, the robot has 3 variables",
        ),
    ];
    for (result, expected) in faults {
        let message = result.unwrap_err().to_string();
        assert!(message.starts_with(expected), "{message}");
    }
    let far = HUMANOID.0.link("right_tcp").unwrap();
    let foreign = model.attach("tool", far, Pose::identity(), &mesh);
    assert!(matches!(foreign, Err(RobotError::ForeignLink { .. })));
    assert_eq!(model.motion_bound(&[0.0; 3], &[0.0; 2]), f64::INFINITY);
    // A position far beyond any plausible one.
    for q in [[1e300; 3], [f64::MAX; 3], [-f64::MAX; 3]] {
        model.clearance(&q, f64::INFINITY).unwrap();
        model.collision(&q, 0.1).unwrap();
    }
}

/// The humanoid with a sponge in its right hand before a table, and only its right arm moves.
fn at_the_table() -> &'static (CollisionModel, CollisionModel) {
    static MODEL: LazyLock<(CollisionModel, CollisionModel)> = LazyLock::new(|| {
        let (robot, _, model) = &*HUMANOID;
        let mut model = model.clone();
        let tcp = robot.link("right_tcp").unwrap();
        let sponge = Mesh::cylinder(0.04, 0.1, 9).unwrap();
        model
            .attach("sponge", tcp, Pose::translation(0.0, 0.0, 0.2), &sponge)
            .unwrap();
        let table = Mesh::cuboid(Vector3::new(1.2, 0.8, 0.04)).unwrap();
        model
            .add_obstacle("table", Pose::translation(0.9, 0.0, 0.73), &table)
            .unwrap();
        model
            .add_obstacle(
                "post",
                Pose::translation(0.6, -0.3, 1.2),
                &Mesh::cylinder(0.03, 0.5, 12).unwrap(),
            )
            .unwrap();
        let base = |i: usize| i < 3;
        let arm: Vec<usize> = (0..robot.dof())
            .filter(|&i| !base(i) && robot.variable(i).name.starts_with("right_arm"))
            .collect();
        let arm_only = model.with_variables(&arm);
        (model, arm_only)
    });
    &MODEL
}

#[test]
fn a_model_for_some_variables_leaves_out_what_they_do_not_move() {
    let (all, arm) = at_the_table();
    let pairs: Vec<_> = arm.checked_pairs().collect();
    assert!(pairs.len() < all.checked_pairs().count());
    for (a, b) in &pairs {
        let moved = |name: &str| name.starts_with("right_") || name == "sponge";
        assert!(moved(a) != moved(b) || (moved(a) && moved(b)), "{a} {b}");
        assert!(!a.starts_with("left_") || !b.starts_with("left_"));
    }
    // All bodies that the arm moves are in the model.
    let lost = all.checked_pairs().filter(|pair| !pairs.contains(pair));
    for (a, b) in lost {
        assert!(
            !a.starts_with("right_") && !b.starts_with("right_") && b != "sponge",
            "{a} {b}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn the_clearance_is_the_least_and_pruning_changes_nothing(shares in shares(), up_to in 0.0..0.3f64) {
        let (robot, ..) = &*HUMANOID;
        let (model, arm) = at_the_table();
        let q = posture(robot, &shares);
        let all = model.clearance(&q, f64::INFINITY).unwrap();
        let near = model.clearance(&q, up_to).unwrap();
        prop_assert_eq!(near.distance, all.distance.min(up_to));
        prop_assert_eq!(near.pair.is_some(), all.distance < up_to);
        prop_assert_eq!(model.collision(&q, up_to).unwrap().is_some(), all.distance <= up_to);
        prop_assert!(arm.clearance(&q, f64::INFINITY).unwrap().distance >= all.distance);
        prop_assert_eq!(all, model.clearance(&q, f64::INFINITY).unwrap());
    }

    #[test]
    fn nothing_moves_further_than_its_bound(from in shares(), to in shares(), step in 0.01..1.0f64) {
        let (robot, ..) = &*HUMANOID;
        let from = posture(robot, &from);
        let to: Vec<f64> = posture(robot, &to).iter().zip(&from).map(|(b, a)| a + step * (b - a)).collect();
        let bound = at_the_table().0.motion_bound(&from, &to);
        // The extreme points of every shape.
        let mut points: Vec<(usize, Point3)> = Vec::new();
        for (i, link) in robot.links().iter().enumerate() {
            for collision in &link.collision {
                let tip = match collision.shape {
                    Shape::Capsule { radius, length } => radius + length / 2.0,
                    Shape::Sphere { radius } => radius,
                    _ => 0.0,
                };
                let tips = [-tip, tip].map(|z| collision.link_from_shape * Point3::new(0.0, 0.0, z));
                points.extend(tips.map(|p| (i, p)));
            }
        }
        let places = |q: &[f64]| -> Vec<Point3> {
            let kinematics = robot.forward_kinematics(q).unwrap();
            let place = |&(i, p): &(usize, Point3)| {
                let id = robot.link(&robot.links()[i].name).unwrap();
                kinematics.world_from_link(id) * p
            };
            points.iter().map(place).collect()
        };
        let start = places(&from);
        for i in 1..=10 {
            let q: Vec<f64> = from.iter().zip(&to).map(|(a, b)| a + f64::from(i) / 10.0 * (b - a)).collect();
            for (a, b) in start.iter().zip(places(&q)) {
                prop_assert!((b - a).norm() <= bound, "{} > {bound}", (b - a).norm());
            }
        }
    }

    #[test]
    fn a_segment_is_free_only_if_all_its_postures_are(
        from in shares(),
        to in shares(),
        step in 0.01..0.5f64,
        margin in prop_oneof![Just(0.0), 0.0..0.05f64],
    ) {
        let (robot, ..) = &*HUMANOID;
        let from = posture(robot, &from);
        let to: Vec<f64> = posture(robot, &to).iter().zip(&from).map(|(b, a)| a + step * (b - a)).collect();
        for model in [&at_the_table().0, &at_the_table().1] {
            let found = model.segment_contact(&from, &to, margin).unwrap();
            let mut least = f64::INFINITY;
            for i in 0..=300 {
                let t = f64::from(i) / 300.0;
                let q: Vec<f64> = from.iter().zip(&to).map(|(a, b)| a + t * (b - a)).collect();
                least = least.min(model.clearance(&q, 1.0).unwrap().distance);
            }
            if found.is_none() {
                prop_assert!(least > margin, "{least} m, margin {margin} m");
            } else {
                // Bodies that are reported as a contact come that near between the samples.
                let spacing = model.motion_bound(&from, &to) / 300.0;
                prop_assert!(least <= margin + SEGMENT_RESOLUTION + spacing, "{least} m, margin {margin} m");
            }
        }
    }
}

/// Three links that may touch, before a thin pole.
fn before_a_pole() -> CollisionModel {
    let mut model = CollisionModel::new(&parsed(CROWDED), None).unwrap();
    model.allow("a", "c").unwrap();
    model.allow("b", "c").unwrap();
    let post = Mesh::cylinder(0.001, 1.0, 8).unwrap();
    model
        .add_obstacle("pole", Pose::translation(0.5, 0.0, 0.0), &post)
        .unwrap();
    model
}

#[test]
fn obstacles_may_have_a_margin_of_their_own() {
    let model = before_a_pole();
    let (from, to) = ([0.0, 0.0, -1.0], [0.0, 0.0, -0.9]);
    let apart = model.clearance(&to, 1.0).unwrap();
    let pair = apart.pair.unwrap();
    assert_eq!((model.name(pair.a), model.name(pair.b)), ("b", "pole"));
    for (own, obstacles, is_free) in [
        (0.0, 0.9, true),
        (0.0, 1.1, false),
        // No two bodies of the robot itself are as near to each other.
        (1.1, 0.9, true),
    ] {
        let [own, obstacles] = [own, obstacles].map(|share: f64| share * apart.distance);
        let margins = Margins { own, obstacles };
        let at_end = model.collision(&to, margins).unwrap();
        let on_way = model.segment_contact(&from, &to, margins).unwrap();
        assert_eq!(
            [at_end.is_none(), on_way.is_none()],
            [is_free; 2],
            "{margins:?}"
        );
    }
    assert!(
        model
            .collision(
                &to,
                Margins {
                    own: 0.0,
                    obstacles: -1.0
                }
            )
            .is_err()
    );
}

#[test]
fn sampling_too_coarsely_misses_what_a_segment_finds() {
    // A fast pass by a thin post: free at both ends and in the middle.
    let model = before_a_pole();
    let (from, to) = ([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]);
    for q in [from, [0.0; 3], to] {
        assert!(model.collision(&q, 0.0).unwrap().is_none());
    }
    let contact = model.segment_contact(&from, &to, 0.0).unwrap().unwrap();
    assert_eq!(
        (model.name(contact.a), model.name(contact.b)),
        ("c", "pole")
    );
    assert!(
        model
            .segment_contact(&from, &[0.0, 0.0, 0.29], 0.0)
            .unwrap()
            .is_none()
    );
}

#[test]
fn the_ready_humanoid_keeps_its_capsules_apart() {
    let (robot, ..) = &*HUMANOID;
    let model = CollisionModel::new(robot, Some(&srdf("humanoid", robot))).unwrap();
    let clearance = model.clearance(&ready("humanoid"), 1.0).unwrap();
    assert!(clearance.distance > 0.025, "{clearance:?}");
}

#[test]
fn ready_arms_point_down_before_their_base() {
    for name in ["arm7", "arm6"] {
        let robot = robot(name);
        let kinematics = robot.forward_kinematics(&ready(name)).unwrap();
        let world_from_tcp = kinematics.world_from_link(robot.link("tcp").unwrap());
        let down = world_from_tcp * Vector3::z();
        assert!(down.z < -0.999, "{name}: {down:?}");
        let at = world_from_tcp.translation.vector;
        assert!(
            at.x > 0.25 && at.y.abs() < 0.2 && at.z > 0.1,
            "{name}: {at:?}"
        );
    }
}
/// The nearest of many obstacles, and contacts on segments, against models of one obstacle each.
#[test]
fn many_obstacles_are_as_near_as_each_by_itself() {
    let (robot, srdf, model) = &*HUMANOID;
    let many = 600;
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let place = |random: &mut ChaCha8Rng| {
        let [x, y, z] = [0; 3].map(|_| random.random_range(-1.5..1.5));
        Pose::translation(x, y, z + 1.0)
    };
    let names: Vec<String> = (0..many).map(|i| format!("box {i}")).collect();
    let poses: Vec<Pose> = (0..many).map(|_| place(&mut random)).collect();
    let mesh = Mesh::cuboid(Vector3::new(0.03, 0.05, 0.02)).unwrap();
    let objects = names.iter().zip(&poses);
    let objects = objects.map(|(name, pose)| (name.as_str(), *pose, &mesh));
    let mut all = model.clone();
    all.add_obstacles(objects.clone()).unwrap();
    let alone: Vec<CollisionModel> = objects
        .map(|(name, pose, mesh)| {
            let mut alone = model.clone();
            alone.add_obstacle(name, pose, mesh).unwrap();
            alone
        })
        .collect();
    let ready = srdf
        .state("ready")
        .unwrap()
        .apply_to(&vec![0.0; robot.dof()]);
    for turn in [0.0, 0.7, -1.1] {
        let mut q = ready.clone();
        q[2] += turn;
        let to: Vec<f64> = q.iter().map(|position| position + 0.05).collect();
        let nearest = all.clearance(&q, f64::INFINITY).unwrap().distance;
        let apart = alone
            .iter()
            .map(|one| one.clearance(&q, f64::INFINITY).unwrap().distance);
        assert_eq!(nearest, apart.fold(f64::INFINITY, f64::min));
        for margin in [0.0, 0.02] {
            let touches = all.collision(&q, margin).unwrap().is_some();
            let mut one_by_one = alone.iter().map(|one| one.collision(&q, margin).unwrap());
            assert_eq!(touches, one_by_one.any(|contact| contact.is_some()));
            let touches = all.segment_contact(&q, &to, margin).unwrap();
            let mut one_by_one = alone
                .iter()
                .map(|one| one.segment_contact(&q, &to, margin).unwrap());
            assert_eq!(
                touches.is_some(),
                one_by_one.any(|contact| contact.is_some())
            );
        }
    }
    assert_eq!(
        all.checked_pairs().count(),
        model.checked_pairs().count() + many * movers(&all)
    );
}

/// Number of links that are checked against an obstacle.
fn movers(model: &CollisionModel) -> usize {
    let pairs = model.checked_pairs();
    pairs.filter(|(_, obstacle)| *obstacle == "box 0").count()
}
