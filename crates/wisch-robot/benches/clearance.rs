//! The humanoid against itself and against the scene of the chopping board: one posture, one segment.

use divan::{Bencher, black_box};
use wisch_robot::geometry::{Mesh, Pose, Vector3};
use wisch_robot::{CollisionModel, RobotModel, Srdf};

fn main() {
    divan::main();
}

struct Humanoid {
    robot: RobotModel,
    model: CollisionModel,
    ready: Vec<f64>,
}

fn humanoid() -> Humanoid {
    let text = include_str!("../../../robots/humanoid.urdf");
    let robot = RobotModel::from_urdf("humanoid", text, &mut |_| Err(String::new())).unwrap();
    let text = include_str!("../../../robots/humanoid.srdf");
    let srdf = Srdf::parse("humanoid", text, &robot).unwrap();
    let model = CollisionModel::new(&robot, Some(&srdf)).unwrap();
    let mut ready = vec![0.0; robot.dof()];
    ready = srdf.state("ready").unwrap().apply_to(&ready);
    Humanoid {
        robot,
        model,
        ready,
    }
}

/// The boxes of `scenarios/chopping-board.toml`, and the sponge in the right hand.
fn with_scene(mut humanoid: Humanoid) -> Humanoid {
    let boxes = [
        ("board", [0.40, 0.28, 0.02], [0.0, 0.0, 0.76]),
        ("tabletop", [1.20, 0.80, 0.04], [0.0, 0.15, 0.73]),
        ("leg_left_front", [0.06, 0.06, 0.71], [-0.55, -0.20, 0.355]),
        ("leg_right_front", [0.06, 0.06, 0.71], [0.55, -0.20, 0.355]),
        ("leg_left_back", [0.06, 0.06, 0.71], [-0.55, 0.50, 0.355]),
        ("leg_right_back", [0.06, 0.06, 0.71], [0.55, 0.50, 0.355]),
        ("shelf", [1.20, 0.30, 0.04], [0.0, 0.60, 1.30]),
    ];
    // The robot stands at (0, -0.9), facing +y.
    let root_from_world = Pose::new(
        Vector3::new(0.9, 0.0, 0.0),
        Vector3::z() * -std::f64::consts::FRAC_PI_2,
    );
    for (name, size, [x, y, z]) in boxes {
        let mesh = Mesh::cuboid(Vector3::from(size)).unwrap();
        let root_from_object = root_from_world * Pose::translation(x, y, z);
        humanoid
            .model
            .add_obstacle(name, root_from_object, &mesh)
            .unwrap();
    }
    let tcp = humanoid.robot.link("right_tcp").unwrap();
    let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap();
    humanoid
        .model
        .attach("sponge", tcp, Pose::identity(), &sponge)
        .unwrap();
    humanoid
}

fn of_right_arm(mut humanoid: Humanoid) -> Humanoid {
    let right = |i: &usize| humanoid.robot.variable(*i).name.starts_with("right_arm");
    let arm: Vec<usize> = (0..humanoid.robot.dof()).filter(right).collect();
    humanoid.model = humanoid.model.with_variables(&arm);
    humanoid
}

const MODELS: [&str; 4] = ["whole", "right arm", "whole, scene", "right arm, scene"];

fn named(name: &str) -> Humanoid {
    match name {
        "whole" => humanoid(),
        "right arm" => of_right_arm(humanoid()),
        "whole, scene" => with_scene(humanoid()),
        _ => of_right_arm(with_scene(humanoid())),
    }
}

#[divan::bench(args = MODELS, sample_size = 100)]
fn nearest_of_all(bencher: Bencher, name: &str) {
    let Humanoid { model, ready, .. } = named(name);
    bencher.bench_local(|| model.clearance(black_box(&ready), f64::INFINITY).unwrap());
}

#[divan::bench(args = MODELS, sample_size = 100)]
fn clear_by_5_mm(bencher: Bencher, name: &str) {
    let Humanoid { model, ready, .. } = named(name);
    assert!(model.collision(&ready, 0.005).unwrap().is_none());
    bencher.bench_local(|| model.collision(black_box(&ready), 0.005).unwrap());
}

/// 0.1 rad of every joint of the right arm.
#[divan::bench(args = MODELS, sample_size = 10)]
fn segment_clear_by_5_mm(bencher: Bencher, name: &str) {
    let Humanoid {
        model,
        ready,
        robot,
    } = named(name);
    let mut to = ready.clone();
    for (i, position) in to.iter_mut().enumerate() {
        if robot.variable(i).name.starts_with("right_arm") {
            *position += 0.1;
        }
    }
    bencher.bench_local(|| {
        model
            .segment_contact(black_box(&ready), &to, 0.005)
            .unwrap()
    });
}

#[divan::bench]
fn model_of_the_humanoid(bencher: Bencher) {
    let Humanoid { robot, .. } = humanoid();
    bencher.bench_local(|| CollisionModel::new(&robot, None).unwrap());
}
