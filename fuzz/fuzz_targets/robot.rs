//! URDF files, and computations with their robots.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::geometry::{Point3, Vector3};
use wisch::robot::{Appearance, RobotModel};

fuzz_target!(|text: &str| {
    let mut no_meshes = |_: &str| Err("no meshes".to_owned());
    let Ok(robot) = RobotModel::from_urdf("fuzz.urdf", text, &mut no_meshes) else {
        return;
    };
    let looks = Appearance::from_urdf("fuzz.urdf", text, &robot, &mut no_meshes);
    looks.expect("what makes a robot is a URDF");
    let q = vec![0.5; robot.dof()];
    let kinematics = robot.forward_kinematics(&q).expect("of the right length");
    for i in 0..robot.joints().len() {
        let tip = robot.joints()[i].child;
        kinematics.jacobian(tip, Point3::origin());
        let _ = robot.chain(robot.root(), tip);
    }
    if let Ok(dynamics) = robot.dynamics() {
        let _ = dynamics.bias(&q, &q, Vector3::new(0.0, 0.0, -9.81));
    }
});
