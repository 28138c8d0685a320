//! Inverse kinematics of the shipped robots: poses from anywhere, and the next pose of a motion, 5 mm on.

use divan::{Bencher, black_box};
use wisch_robot::geometry::Pose;
use wisch_robot::{IkConfig, IkOutcome, IkSolver, JointPositions, RobotModel, RotationGoal};

fn main() {
    divan::main();
}

const CHAINS: [&str; 4] = ["humanoid-10", "humanoid-13", "arm7", "arm6"];
const POSES: usize = 200;

fn solver(name: &str) -> IkSolver {
    let (text, base, tip) = match name {
        "humanoid-10" => (
            include_str!("../../../robots/humanoid.urdf"),
            "platform",
            "right_tcp",
        ),
        "humanoid-13" => (
            include_str!("../../../robots/humanoid.urdf"),
            "world",
            "right_tcp",
        ),
        "arm7" => (include_str!("../../../robots/arm7.urdf"), "link_0", "tcp"),
        _ => (include_str!("../../../robots/arm6.urdf"), "link_0", "tcp"),
    };
    let robot = RobotModel::from_urdf(name, text, &mut |_| Err(String::new())).unwrap();
    let (base, tip) = (robot.link(base).unwrap(), robot.link(tip).unwrap());
    IkSolver::new(&robot, base, tip, Pose::identity()).unwrap()
}

/// Poses in reach: those of the posture turned by steps of an irrational part of a radian.
fn poses(solver: &IkSolver) -> Vec<Pose> {
    let pose = |k: usize| {
        let turned = |(i, q): (usize, &f64)| q + (2.4 * (k * (i + 1)) as f64).sin();
        let q: Vec<f64> = solver.posture().iter().enumerate().map(turned).collect();
        solver
            .chain()
            .forward_kinematics(&q)
            .unwrap()
            .base_from_tip()
    };
    (0..POSES).map(pose).collect()
}

#[divan::bench(args = CHAINS)]
fn solve(bencher: Bencher, name: &str) {
    let solver = solver(name);
    let poses = poses(&solver);
    let config = IkConfig::default();
    let mut next = (0..POSES).cycle();
    bencher.bench_local(|| {
        let pose = black_box(&poses[next.next().unwrap_or(0)]);
        solver.solve(pose, RotationGoal::Full, &[], 1, &config)
    });
}

#[divan::bench(args = CHAINS)]
fn follow(bencher: Bencher, name: &str) {
    let solver = solver(name);
    let config = IkConfig::default();
    let beside = |pose: Pose| -> Option<(Pose, JointPositions)> {
        let solved = solver.solve(&pose, RotationGoal::Full, &[], 1, &config);
        let Ok(IkOutcome::Solved(q)) = solved else {
            return None;
        };
        let mut beside = pose;
        beside.translation.z += 5e-3;
        Some((beside, q))
    };
    let followed: Vec<_> = poses(&solver).into_iter().filter_map(beside).collect();
    let mut next = (0..followed.len()).cycle();
    bencher.bench_local(|| {
        let (pose, q) = black_box(&followed[next.next().unwrap_or(0)]);
        solver.solve_from(pose, RotationGoal::Full, q, &config)
    });
}
