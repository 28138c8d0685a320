//! Collisions of the shipped robots, and the SRDF files that come with them.

use proptest::prelude::*;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use wisch::geometry::{Mesh, Point3, Pose, Vector3};
use wisch::robot::{CollisionModel, Reason, RobotError, RobotModel, SEGMENT_RESOLUTION, Srdf};

fn committed(file: &str) -> String {
    let path = format!("{}/../../robots/{file}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn robot(name: &str) -> RobotModel {
    let no_meshes = &mut |_: &str| Err("the shipped robots have no meshes".to_owned());
    let file = format!("{name}.urdf");
    RobotModel::from_urdf(&file, &committed(&file), no_meshes).unwrap()
}

fn srdf(name: &str, robot: &RobotModel) -> Srdf {
    let file = format!("{name}.srdf");
    Srdf::parse(&file, &committed(&file), robot).unwrap()
}

fn model(name: &str) -> (RobotModel, Srdf, CollisionModel) {
    let robot = robot(name);
    let srdf = srdf(name, &robot);
    let model = CollisionModel::new(&robot, Some(&srdf)).unwrap();
    (robot, srdf, model)
}

static HUMANOID: LazyLock<(RobotModel, Srdf, CollisionModel)> = LazyLock::new(|| model("humanoid"));

fn ready(name: &str) -> Vec<f64> {
    let (robot, srdf, _) = model(name);
    srdf.state("ready")
        .unwrap()
        .applied_to(&vec![0.0; robot.dof()])
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
        println!("{name}: {nearest:?}");
        for (a, b, reason) in model.allowed_pairs() {
            println!("  {a} {b} {reason:?}");
        }
    }
}

#[test]
fn many_postures_are_free() {
    for name in ["humanoid", "arm7", "arm6"] {
        let (robot, _, model) = model(name);
        let mut free = 0;
        let mut hits = std::collections::BTreeMap::<String, usize>::new();
        for i in 0..1000 {
            let share = |k: usize| (0.5 + (i as f64) * (2.0 + k as f64).sqrt()).fract();
            let q = posture(&robot, &(0..robot.dof()).map(share).collect::<Vec<_>>());
            match model.collision(&q, 0.0).unwrap() {
                None => free += 1,
                Some(c) => {
                    *hits
                        .entry(format!("{} {}", model.name(c.a), model.name(c.b)))
                        .or_default() += 1
                }
            }
        }
        println!("{name}: {free} {hits:?}");
        assert!(free > 100, "{name}: {free} of 1000");
    }
}
