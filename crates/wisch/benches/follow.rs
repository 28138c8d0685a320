//! Cost of a tool's free yaw: 500 waypoints of a line × 36 angles of the tool about the surface
//! normal, for the arm of seven joints, with inverse kinematics and self-collision; on all threads,
//! and on one.

use divan::{Bencher, black_box};
use nalgebra::{Translation3, UnitQuaternion};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use wisch::geometry::{Pose, Vector3};
use wisch::robot::{
    CollisionModel, IkConfig, IkOutcome, IkSolver, JointPositions, RobotModel, RotationGoal, Srdf,
};

fn main() {
    divan::main();
}

const WAYPOINTS: usize = 500;
const ANGLES: usize = 36;
/// Clearance between links [m].
const MARGIN: f64 = 5e-3;

struct Arm {
    ik: IkSolver,
    collisions: CollisionModel,
    config: IkConfig,
}

fn arm() -> Arm {
    let urdf = include_str!("../../../robots/arm7.urdf");
    let robot = RobotModel::from_urdf("arm7", urdf, &mut |_| Err(String::new())).unwrap();
    let srdf = include_str!("../../../robots/arm7.srdf");
    let srdf = Srdf::parse("arm7", srdf, &robot).unwrap();
    let tip = robot.link("tcp").unwrap();
    let tip_from_tool = Pose::translation(0.0, 0.0, 0.1);
    Arm {
        ik: IkSolver::new(&robot, robot.root(), tip, tip_from_tool).unwrap(),
        collisions: CollisionModel::new(&robot, Some(&srdf)).unwrap(),
        config: IkConfig {
            position_tolerance: 1e-5,
            rotation_tolerance: 1e-4,
            max_restarts: 10,
            ..IkConfig::default()
        },
    }
}

/// Five lanes of 0.4 m before the arm, 0.1 m apart, the tool pointing down.
fn base_from_tool(waypoint: usize, angle: usize) -> Pose {
    let per_lane = WAYPOINTS / 5;
    let (lane, along) = (waypoint / per_lane, waypoint % per_lane);
    let share = along as f64 / (per_lane - 1) as f64;
    let y = if lane.is_multiple_of(2) {
        share
    } else {
        1.0 - share
    };
    let place = Translation3::new(0.35 + 0.1 * lane as f64, 0.4 * (y - 0.5), 0.2);
    let turn = TAU * angle as f64 / ANGLES as f64;
    let down = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
    Pose::from_parts(
        place,
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn) * down,
    )
}

/// Returns the number of waypoints that are in reach and free of collision with the tool at an
/// angle, each solved from the one before.
fn free_waypoints(arm: &Arm, angle: usize) -> usize {
    let mut at: JointPositions = *arm.ik.posture();
    let mut free = 0;
    for waypoint in 0..WAYPOINTS {
        let pose = base_from_tool(waypoint, angle);
        let near = arm
            .ik
            .solve_from(&pose, RotationGoal::Full, &at, &arm.config);
        let outcome = match near {
            Ok(IkOutcome::Stuck { .. }) => {
                (arm.ik).solve(&pose, RotationGoal::Full, &[&at[..]], 1, &arm.config)
            }
            solved => solved,
        };
        let Ok(IkOutcome::Solved(q)) = outcome else {
            continue;
        };
        at = q;
        free += usize::from(arm.collisions.collision(&q, MARGIN).unwrap().is_none());
    }
    free
}

#[divan::bench(sample_count = 10)]
fn waypoints_500_times_36_angles_on_all_threads(bencher: Bencher) {
    let arm = arm();
    let all = || -> usize {
        (0..ANGLES)
            .into_par_iter()
            .map(|angle| free_waypoints(&arm, angle))
            .sum()
    };
    println!("{} of {} free", all(), WAYPOINTS * ANGLES);
    bencher.bench_local(|| black_box(all()));
}

#[divan::bench(sample_count = 5)]
fn waypoints_500_times_36_angles_on_one_thread(bencher: Bencher) {
    let arm = arm();
    bencher.bench_local(|| -> usize { (0..ANGLES).map(|angle| free_waypoints(&arm, angle)).sum() });
}
