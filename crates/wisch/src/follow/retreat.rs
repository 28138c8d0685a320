//! The retreat from where a robot was stopped to its ready posture: first off the surface.

use super::path::arm::Arm;
use super::path::free_motion::free_motion;
use super::path::joint_travel::movement;
use super::{FollowConfig, FollowError, Motion, Phase, Workcell, schedule};
use crate::represent::Task;
use crate::robot::JointPositions;

/// Number of searches for a path to the ready posture.
const RETURN_SEARCHES: u64 = 3;
/// Joint distance below which a robot is in its ready posture [rad].
const AT_READY: f64 = 1e-3;
/// Paths shorter than this are left out [m].
const MIN_LIFT: f64 = 1e-4;

/// Plans the retreat from the robot's measured state to its ready posture. The tool first lifts along the
/// normal of the surface, no faster than it would come down; a free motion follows.
///
/// `from`: all n variables [rad or m]. Within their limits they start the first motion. Variables that move
/// neither the base nor the planning group take their values from the ready posture. `height`: height of the
/// lift above the surface \[m\]. Returns no motions if the robot is in its ready posture.
///
/// # Errors
/// An obstacle prevents the lift, or no path to the ready posture was found.
pub fn retreat(
    task: &Task,
    cell: &Workcell,
    from: &[f64],
    height: f64,
    config: &FollowConfig,
) -> Result<Vec<Motion>, FollowError> {
    let base = cell.base_pose(cell.ready_posture());
    let arm = Arm::new(cell, task, config, &base)?;
    let limits = cell.limits().joints();
    let within: Vec<f64> = (from.iter().zip(limits))
        .map(|(q, limit)| q.clamp(limit.lower, limit.upper))
        .collect();
    let (at, ready) = (arm.group_variables(&within), arm.ready_posture());
    if movement(&[at, ready]) < AT_READY {
        return Ok(Vec::new());
    }
    let blocked = |why| FollowError::NoRetreat { why };
    let way = height - arm.height(&at).unwrap_or(0.0);
    let up = if way > MIN_LIFT {
        arm.lift_path(&at, way).map_err(|why| blocked(Some(why)))?
    } else {
        Vec::new()
    };
    let top = *up.last().unwrap_or(&at);
    let back = (0..RETURN_SEARCHES)
        .find_map(|i| free_motion(&arm, &top, &ready, config.seed.wrapping_add(i)))
        .ok_or_else(|| blocked(None))?;
    let up: Vec<JointPositions> = std::iter::once(at).chain(up).collect();
    let mut motions: Vec<Motion> = Vec::new();
    // The tool lifts no faster than it comes down.
    for (phase, timed_as, path) in [
        (Phase::Lift, Phase::Lower, up),
        (Phase::FreeMotion, Phase::FreeMotion, back),
    ] {
        let path: Vec<Vec<f64>> = path.iter().map(|q| arm.to_robot(q)).collect();
        let timed = schedule::time_motion(cell, task, config, timed_as, &path, &[])?;
        motions.extend(timed.map(|trajectory| Motion {
            phase,
            start: motions.last().map_or(0.0, Motion::end),
            trajectory,
            tool_line: Vec::new(),
        }));
    }
    Ok(motions)
}
