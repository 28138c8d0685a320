//! The humanoid: kinematics from the world to the right hand (13 variables), and the dynamics of the
//! whole robot (22 variables) and of an arm.

use divan::{Bencher, black_box};
use wisch_robot::RobotModel;
use wisch_robot::geometry::{Point3, Vector3};

fn main() {
    divan::main();
}

const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

fn robot(text: &str) -> RobotModel {
    RobotModel::from_urdf("shipped", text, &mut |_| Err(String::new())).unwrap()
}

fn humanoid() -> RobotModel {
    robot(include_str!("../../../robots/humanoid.urdf"))
}

fn arm7() -> RobotModel {
    robot(include_str!("../../../robots/arm7.urdf"))
}

fn positions(n: usize) -> Vec<f64> {
    (0..n).map(|i| 0.3 + 0.1 * i as f64).collect()
}

#[divan::bench(sample_size = 100)]
fn pose_and_jacobian_of_13_joints(bencher: Bencher) {
    let robot = humanoid();
    let tip = robot.link("right_tcp").unwrap();
    let chain = robot.chain(robot.root(), tip).unwrap();
    let q = positions(chain.dof());
    bencher.bench_local(|| {
        let kinematics = chain.forward_kinematics(black_box(&q)).unwrap();
        (
            kinematics.base_from_tip(),
            kinematics.jacobian(Point3::origin()),
        )
    });
}

#[divan::bench(sample_size = 100)]
fn poses_of_all_links_of_the_humanoid(bencher: Bencher) {
    let robot = humanoid();
    let q = positions(robot.dof());
    bencher.bench_local(|| robot.forward_kinematics(black_box(&q)).unwrap());
}

#[divan::bench(args = ["arm7", "humanoid"], sample_size = 100)]
fn mass_matrix(bencher: Bencher, name: &str) {
    let robot = if name == "arm7" { arm7() } else { humanoid() };
    let dynamics = robot.dynamics().unwrap();
    let q = positions(robot.dof());
    bencher.bench_local(|| dynamics.mass_matrix(black_box(&q)).unwrap());
}

#[divan::bench(args = ["arm7", "humanoid"], sample_size = 100)]
fn bias(bencher: Bencher, name: &str) {
    let robot = if name == "arm7" { arm7() } else { humanoid() };
    let dynamics = robot.dynamics().unwrap();
    let q = positions(robot.dof());
    bencher.bench_local(|| dynamics.bias(black_box(&q), &q, GRAVITY).unwrap());
}
