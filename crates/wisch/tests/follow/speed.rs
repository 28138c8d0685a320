//! Limits of the tool's speed, and of the time that joints need.

use std::path::Path;
use wisch::follow::{
    FollowConfig, FollowError, Followed, MotionFault, Phase, Workcell, WorkcellConfig, audit,
    follow,
};
use wisch::geometry::Vector3;
use wisch::represent::Action;
use wisch::robot::RobotModel;
use wisch::run::{NoExecutor, Stage, ignore_events};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::{board, cell, planned, root};

/// Period at which speeds are measured [s].
const PERIOD: f64 = 0.005;

/// Returns the greatest speed of the tool in contact [m/s].
fn fastest_in_contact(cell: &Workcell, followed: &Followed) -> f64 {
    let mut fastest: f64 = 0.0;
    for motion in &followed.motions {
        let place = |q: &[f64]| -> Vector3 {
            let kinematics = cell.robot().forward_kinematics(q).unwrap();
            let tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
            tool.translation.vector
        };
        let places: Vec<Vector3> = motion
            .trajectory
            .samples(PERIOD)
            .map(|at| place(&at.q))
            .collect();
        if matches!(motion.phase, Phase::Wipe(_)) {
            let speeds = places
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).norm() / PERIOD);
            fastest = speeds.fold(fastest, f64::max);
        }
    }
    fastest
}

#[test]
fn a_tool_keeps_its_speed_in_contact_where_the_joints_move_unevenly() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/coated-wall.toml");
    let loaded = load_task(&file, &LoadOptions::default()).unwrap();
    let mut session = loaded.session();
    (session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)).unwrap();
    let (task, plan) = (&loaded.task, session.plan().unwrap());
    let (cell, config) = (cell(task), &loaded.run.follow);
    let limit = config.contact_speed;
    assert!((limit - 0.032).abs() < 1e-12);
    let followed = follow(task, plan, &cell, None, config, &mut |_| ()).unwrap();
    let fastest = fastest_in_contact(&cell, &followed);
    assert!(
        fastest > 0.9 * limit && fastest < 1.01 * limit,
        "{fastest} m/s"
    );
    let found = audit(&followed, &cell, task, config).unwrap();
    assert_eq!(found.faults, []);
}

#[test]
fn the_audit_finds_a_tool_that_is_faster_than_its_limits() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let (plan, cell) = (planned(&task), cell(&task));
    let config = FollowConfig {
        contact_speed: 0.1,
        ..FollowConfig::default()
    };
    let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    assert!(audit(&followed, &cell, &task, &config).unwrap().is_sound());
    for (strict, expected) in [
        (
            FollowConfig {
                contact_speed: 0.095,
                ..config.clone()
            },
            "in contact",
        ),
        (
            FollowConfig {
                approach_speed: 0.01,
                ..config.clone()
            },
            "on the way to the surface",
        ),
        (
            FollowConfig {
                free_speed: 0.2,
                ..config.clone()
            },
            "out of contact",
        ),
    ] {
        let found = audit(&followed, &cell, &task, &strict).unwrap();
        let is_expected = |fault: &MotionFault| matches!(fault, MotionFault::TooFast { of, .. } if *of == expected);
        assert!(
            found.faults.iter().any(is_expected),
            "{expected}: {:?}",
            found.faults
        );
    }
}

#[test]
fn a_joint_that_would_need_years_is_an_error_that_names_it() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let plan = planned(&task);
    let text = std::fs::read_to_string(root().join("robots/arm7.urdf")).unwrap();
    let (head, joint) = text.split_once("<joint name=\"joint_2\"").unwrap();
    for (attribute, quantity) in [("velocity", "velocity"), ("acceleration", "acceleration")] {
        let (before, after) = joint.split_once(&format!("{attribute}=\"")).unwrap();
        let (_, after) = after.split_once('"').unwrap();
        let slow = format!("{head}<joint name=\"joint_2\"{before}{attribute}=\"1e-9\"{after}");
        let robot = RobotModel::from_urdf("slow.urdf", &slow, &mut |_| Err(String::new())).unwrap();
        let cell = Workcell::new(robot, None, &task, &WorkcellConfig::default()).unwrap();
        let refused = follow(
            &task,
            &plan,
            &cell,
            None,
            &FollowConfig::default(),
            &mut |_| (),
        );
        match refused {
            Err(error @ FollowError::TooSlow { duration, .. }) => {
                assert!(duration > 1200.0);
                let text = error.to_string();
                assert!(
                    text.contains("joint_2") && text.contains(quantity),
                    "{text}"
                );
                assert!(
                    text.contains("0.000000001 rad/s") && text.contains("1200 s"),
                    "{text}"
                );
            }
            other => panic!("{quantity}: {other:?}"),
        }
    }
}
