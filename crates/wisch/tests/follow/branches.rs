//! A surface that the arm reaches, but not in the branch of the inverse kinematics of its ready posture.

use std::f64::consts::FRAC_PI_2;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, follow};
use wisch::geometry::Pose;
use wisch::represent::Action;
use wisch_testkit::{board, faults, planned, robots};

#[test]
fn an_upright_surface_is_wiped_whatever_branch_the_ready_posture_lies_in() {
    let [_, arm6, _] = robots();
    let mut task = board(Action::Skim, [0.0, 0.0, 0.0]);
    // A door half a metre before the arm, which it faces.
    let turned = nalgebra::UnitQuaternion::from_euler_angles(FRAC_PI_2, 0.0, 0.0);
    let upright = Pose::from_parts([0.0, 0.0, 0.2].into(), turned);
    task.surface.world_from_surface = upright;
    for part in &mut task.scene {
        part.world_from_object = upright * Pose::translation(0.0, 0.0, -0.01);
    }
    let plan = planned(&task);
    // From the elbow of the shipped ready posture, two links of the arm would collide at every node.
    let mut elbow_down = arm6.srdf.clone();
    for state in &mut elbow_down.states {
        let values = [2.8402, 1.3152, -2.2157, -2.2411, -1.2694, 0.0];
        for (joint, value) in state.positions.iter_mut().zip(values) {
            joint.1 = value;
        }
    }
    for srdf in [&arm6.srdf, &elbow_down] {
        let config = WorkcellConfig {
            world_from_robot: Some(Pose::new(
                [0.0, -0.6, 0.12].into(),
                [0.0, 0.0, FRAC_PI_2].into(),
            )),
            ..WorkcellConfig::default()
        };
        let cell = Workcell::new(arm6.model.clone(), Some(srdf), &task, &config).unwrap();
        let follows = FollowConfig::default();
        let followed = follow(&task, &plan, &cell, None, &follows, &mut |_| ()).unwrap();
        assert_eq!(followed.abandoned, []);
        assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    }
}
