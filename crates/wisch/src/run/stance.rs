//! The robot's position before and after a motion.

use super::{Execution, PlannedRound, RobotState, RunConfig, RunError, TelemetrySample};
use crate::follow::{Followed, Workcell};
use crate::geometry::{PlanarPose, Point2, Pose, Vector3};
use nalgebra::{Translation3, UnitQuaternion};

/// Checks that an execution reports the positions of all joints, or none.
pub(super) fn check_positions(
    execution: Execution,
    cell: &Workcell,
    round: usize,
) -> Result<Execution, RunError> {
    let (found, expected) = (execution.positions.len(), cell.robot().dof());
    if found == expected || found == 0 {
        return Ok(execution);
    }
    Err(RunError::Positions {
        round,
        found,
        expected,
    })
}

/// Speed of a joint above which a robot is not at rest [rad/s or m/s]: above the noise of encoders.
const AT_REST: f64 = 0.02;

/// Checks that the robot is at rest, if its velocities are measured.
pub(super) fn check_rest(state: &RobotState, planned: &PlannedRound) -> Result<(), RunError> {
    let (round, robot) = (planned.number, planned.cell.robot());
    let (found, expected) = (state.velocities.len(), robot.dof());
    if found == 0 {
        return Ok(());
    }
    if found != expected {
        return Err(RunError::Velocities {
            round,
            found,
            expected,
        });
    }
    let speeds = state.velocities.iter().map(|velocity| velocity.abs());
    let fastest = speeds.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    match fastest {
        Some((i, velocity)) if velocity > AT_REST || velocity.is_nan() => Err(RunError::Moving {
            round,
            joint: robot.variable(i).name.clone(),
            velocity,
            limit: AT_REST,
            unit: robot.variable(i).kind.unit(),
        }),
        _ => Ok(()),
    }
}

/// Checks that the robot is where its motion begins. `limit`: largest distance of a joint [rad or m].
pub(super) fn check_start(
    stands: &[f64],
    planned: &PlannedRound,
    limit: f64,
) -> Result<(), RunError> {
    let PlannedRound {
        number: round,
        cell,
        followed,
        ..
    } = planned;
    let Some(start) = followed.sample(0.0) else {
        return Ok(());
    };
    let (found, expected) = (stands.len(), start.q.len());
    if found != expected {
        return Err(RunError::Positions {
            round: *round,
            found,
            expected,
        });
    }
    let distances = stands.iter().zip(&start.q).map(|(a, b)| (a - b).abs());
    let farthest = distances.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    match farthest {
        Some((i, distance)) if distance > limit || distance.is_nan() => {
            let joint = cell.robot().variable(i);
            Err(RunError::Start {
                round: *round,
                joint: joint.name.clone(),
                distance,
                limit,
                start: start.q[i],
                unit: joint.kind.unit(),
            })
        }
        _ => Ok(()),
    }
}

/// Latest time of a motion's first sample at which the robot is still near the start of the motion [s].
const BEGINNING: f64 = 1.0;
/// Step in which a later first sample is compared with the motion until then [s]: within one step,
/// every joint moves only a little.
const WAY_STEP: f64 = 0.05;
/// Distance of a joint from the start of a motion, or from its setpoint, up to which a motion that
/// has just begun explains it [rad or m].
const NEAR_START: f64 = 0.3;

/// Checks that the first measured positions of a motion are near its start, or later on its way until then: the robot
/// stands there, and the executor reports the joints in their order and units. `tolerance`: largest distance before the
/// motion [rad or m].
pub(super) fn check_first_sample(
    sample: &TelemetrySample<'_>,
    planned: &PlannedRound,
    tolerance: f64,
) -> Result<(), RunError> {
    let setpoints = [0.0, sample.time].map(|time| planned.followed.sample(time));
    let [Some(start), Some(present)] = setpoints else {
        return Ok(());
    };
    if sample.positions.len() != start.q.len() {
        return Ok(());
    }
    let limit = NEAR_START.max(tolerance);
    let nearest = |(position, (start, present)): (&f64, (&f64, &f64))| {
        (position - start).abs().min((position - present).abs())
    };
    let (distances, place): (Vec<f64>, _) = if sample.time <= BEGINNING {
        let setpoints = start.q.iter().zip(&present.q);
        let distances = sample.positions.iter().zip(setpoints).map(nearest);
        (distances.collect(), "the start of the motion")
    } else {
        let distances = distances_from_way(sample.positions, &planned.followed, sample.time);
        (distances, "its motion until then")
    };
    let farthest = distances.into_iter().enumerate();
    match farthest.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((i, distance)) if distance > limit || distance.is_nan() => {
            let joint = planned.cell.robot().variable(i);
            Err(RunError::StartsElsewhere {
                round: planned.number,
                time: sample.time,
                joint: joint.name.clone(),
                distance,
                place,
                limit,
                unit: joint.kind.unit(),
            })
        }
        _ => Ok(()),
    }
}

/// Returns the distance of each joint from the nearest point of a motion until a time [rad or m]: a robot may be slower
/// than planned.
fn distances_from_way(positions: &[f64], followed: &Followed, time: f64) -> Vec<f64> {
    let until = time.min(followed.duration());
    let steps = (until / WAY_STEP).ceil().max(1.0) as usize;
    let way = (0..=steps).filter_map(|k| followed.sample(until * k as f64 / steps as f64));
    let distances = way.map(|at| {
        let joints = positions.iter().zip(&at.q);
        joints.map(|(a, b)| (a - b).abs()).collect::<Vec<f64>>()
    });
    let largest = |distances: &[f64]| distances.iter().copied().fold(0.0, f64::max);
    let nearest = distances.min_by(|a, b| largest(a).total_cmp(&largest(b)));
    nearest.unwrap_or_default()
}

/// Returns the pose of the robot's root after an execution; the planned pose if the joints are not measured.
pub(super) fn root_pose(planned: &PlannedRound, execution: &Execution, config: &RunConfig) -> Pose {
    let PlannedRound { cell, followed, .. } = planned;
    let Some(base) = cell.base() else {
        return *cell.world_from_root();
    };
    let measured = Some(&execution.positions)
        .filter(|q| !q.is_empty())
        .cloned();
    let as_planned = |followed: &Followed| followed.sample(execution.duration).map(|at| at.q);
    let q = measured
        .or_else(|| as_planned(followed))
        .unwrap_or_else(|| cell.ready_posture().to_vec());
    let at = PlanarPose::new(Point2::new(q[base.x], q[base.y]), q[base.yaw]);
    let start = config
        .workcell
        .world_from_robot
        .unwrap_or_else(Pose::identity);
    Pose::from_parts(
        Translation3::new(at.position.x, at.position.y, start.translation.z),
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), at.heading),
    )
}
