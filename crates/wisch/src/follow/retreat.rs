//! From where a robot was stopped back to its ready posture: off the surface first.

use super::path::arm::Arm;
use super::path::free_motion::free_motion;
use super::path::taut::movement;
use super::{FollowConfig, FollowError, Motion, Phase, Workcell, schedule};
use crate::represent::Task;
use crate::robot::JointPositions;

/// How often a way to the ready posture is looked for.
const WAYS: u64 = 3;
/// A robot whose joints are together no farther from its ready posture than this is there [rad].
const AT_READY: f64 = 1e-3;
/// Ways shorter than this are none [m].
const NO_WAY: f64 = 1e-4;

/// Plans the way from where the robot was measured to be to its ready posture: along the normal of the surface until the
/// tool is lifted, no faster than it would come down, then by free motion.
///
/// `from`: all n variables [rad or m]; within their limits they are the begin of the first motion, but for those that
/// neither the base nor the group that wipes moves, which are those of the ready posture. `height`: over the surface, to
/// which the tool is lifted [m]. No motions where the robot is in its ready posture.
///
/// # Errors
/// Something is in the way, or there is no way to the ready posture.
pub fn retreat(
    task: &Task,
    cell: &Workcell,
    from: &[f64],
    height: f64,
    config: &FollowConfig,
) -> Result<Vec<Motion>, FollowError> {
    let base = cell.base_pose(cell.ready());
    let arm = Arm::new(cell, task, config, &base)?;
    let limits = cell.limits().joints();
    let within: Vec<f64> = (from.iter().zip(limits))
        .map(|(q, limit)| q.clamp(limit.lower, limit.upper))
        .collect();
    let (at, ready) = (arm.of_robot(&within), arm.ready());
    if movement(&[at, ready]) < AT_READY {
        return Ok(Vec::new());
    }
    let blocked = |why| FollowError::NoRetreat { why };
    let way = height - arm.height(&at).unwrap_or(0.0);
    let up = if way > NO_WAY {
        arm.risen(&at, way).map_err(|why| blocked(Some(why)))?
    } else {
        Vec::new()
    };
    let top = *up.last().unwrap_or(&at);
    let back = (0..WAYS)
        .find_map(|i| free_motion(&arm, &top, &ready, config.seed.wrapping_add(i)))
        .ok_or_else(|| blocked(None))?;
    let up: Vec<JointPositions> = std::iter::once(at).chain(up).collect();
    let mut motions: Vec<Motion> = Vec::new();
    // It goes up no faster than it comes down.
    for (phase, timed_as, path) in [
        (Phase::Lift, Phase::Lower, up),
        (Phase::FreeMotion, Phase::FreeMotion, back),
    ] {
        let path: Vec<Vec<f64>> = path.iter().map(|q| arm.to_robot(q)).collect();
        let timed = schedule::timed(cell, task, config, timed_as, &path, &[])?;
        motions.extend(timed.map(|trajectory| Motion {
            phase,
            start: motions.last().map_or(0.0, Motion::end),
            trajectory,
            tool_line: Vec::new(),
        }));
    }
    Ok(motions)
}
