//! When the joints are where along one motion, so that the tool stays on its line and in both hands.

use super::audit::{grip_deviation, line_deviation};
use super::{
    FollowConfig, FollowError, GripDeviation, JointPath, Phase, TimingConfig, ToolPose, Trajectory,
    Workcell, time_path,
};
use crate::represent::Task;

/// How far a joint may leave its path in free motion [rad or m]; small beside the clearance kept.
const FREE_BLEND: f64 = 5e-4;
/// The same where the tool follows a line, before it is known how far that takes the tool off.
const LINE_BLEND: f64 = 2e-4;
/// Period at which the second hand's grip is looked at [s].
const GRIP_PERIOD: f64 = 0.01;
/// How often the blend is halved until the tool stays on its line.
const HALVINGS: usize = 6;

/// The fastest motion along a path of all n variables; `None` if nothing moves.
pub(super) fn timed(
    cell: &Workcell,
    task: &Task,
    config: &FollowConfig,
    phase: Phase,
    path: &[Vec<f64>],
    tool_line: &[ToolPose],
) -> Result<Option<Trajectory>, FollowError> {
    if path.len() < 2 || path.windows(2).all(|pair| pair[0] == pair[1]) {
        return Ok(None);
    }
    let mut joints = JointPath::new(path)?;
    let speed = match phase {
        Phase::Wipe(_) => Some(config.contact_speed),
        Phase::Lower => Some(config.approach_speed),
        Phase::Drive | Phase::Transfer | Phase::Lifted | Phase::Lift => None,
    };
    if let Some(speed) = speed {
        let line = segment_lengths(cell, path)?;
        joints = joints.with_segment_times(line.iter().map(|way| way / speed).collect())?;
    }
    let mut blend = if tool_line.is_empty() {
        FREE_BLEND
    } else {
        LINE_BLEND
    };
    for _ in 0..HALVINGS {
        let timing = TimingConfig {
            blend_tolerance: blend,
            ..TimingConfig::default()
        };
        let trajectory = time_path(&joints, cell.limits(), &timing)?;
        let off = line_deviation(cell, task, &trajectory, tool_line)?;
        let is_on_line =
            off.position <= config.line_tolerance && off.rotation <= config.turn_tolerance;
        if is_on_line && worst_grip(cell, &trajectory)?.is_held() {
            return Ok(Some(trajectory));
        }
        blend /= 2.0;
    }
    let timing = TimingConfig {
        blend_tolerance: blend,
        ..TimingConfig::default()
    };
    Ok(Some(time_path(&joints, cell.limits(), &timing)?))
}

/// How far the second hand leaves its grip over a motion.
fn worst_grip(cell: &Workcell, trajectory: &Trajectory) -> Result<GripDeviation, FollowError> {
    let mut worst = GripDeviation::default();
    if cell.second().is_some() {
        for sample in trajectory.samples(GRIP_PERIOD) {
            worst = worst.max(grip_deviation(cell, &sample.q)?);
        }
    }
    Ok(worst)
}

/// How far the tool moves from each configuration to the next [m].
fn segment_lengths(cell: &Workcell, path: &[Vec<f64>]) -> Result<Vec<f64>, FollowError> {
    let mut places = Vec::with_capacity(path.len());
    for q in path {
        let kinematics = cell.robot().forward_kinematics(q)?;
        let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        places.push(root_from_tool.translation.vector);
    }
    Ok(places
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).norm())
        .collect())
}
