//! Timing of one motion: the fastest along its path that keeps the tool on its line and in both hands.
//!
//! What is accepted here is audited by other code (`audit/`); neither may use the other's.

use super::workcell::second_arm::off_grip;
use super::{
    FollowConfig, FollowError, GripDeviation, JointPath, LineDeviation, Phase, TimingConfig,
    ToolPose, Trajectory, Workcell, time_path,
};
use crate::geometry::Pose;
use crate::represent::Task;

/// How far a joint may leave its path in free motion [rad or m]; small beside the clearance kept.
const FREE_BLEND: f64 = 5e-4;
/// The same where the tool follows a line, before it is known how far that takes the tool off.
const LINE_BLEND: f64 = 2e-4;
/// Period at which the second hand's grip is looked at [s].
const GRIP_PERIOD: f64 = 0.01;
/// Period at which the tool is compared with its line [s].
const LINE_PERIOD: f64 = 0.005;
/// Steps in which an arc of the line is compared [m or rad].
const LINE_STEP: f64 = 1e-3;
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
        Phase::Drive | Phase::FreeMotion | Phase::Lifted | Phase::Lift => None,
    };
    if let Some(speed) = speed {
        let line = segment_lengths(cell, path)?;
        joints = joints.with_segment_times(line.iter().map(|way| way / speed).collect())?;
    }
    let timed = |blend_tolerance| {
        let timing = TimingConfig {
            blend_tolerance,
            ..TimingConfig::default()
        };
        time_path(&joints, cell.limits(), &timing)
    };
    let mut blend = if tool_line.is_empty() {
        FREE_BLEND
    } else {
        LINE_BLEND
    };
    for _ in 0..HALVINGS {
        let trajectory = timed(blend)?;
        let off = line_deviation(cell, task, &trajectory, tool_line)?;
        let is_on_line =
            off.position <= config.line_tolerance && off.rotation <= config.turn_tolerance;
        if is_on_line && worst_grip(cell, &trajectory)?.is_held() {
            return Ok(Some(trajectory));
        }
        blend /= 2.0;
    }
    Ok(Some(timed(blend)?))
}

/// How far the second hand leaves its grip over a motion; nothing if one hand holds the tool.
fn worst_grip(cell: &Workcell, trajectory: &Trajectory) -> Result<GripDeviation, FollowError> {
    let mut worst = GripDeviation::default();
    let Some(second) = cell.second() else {
        return Ok(worst);
    };
    for sample in trajectory.samples(GRIP_PERIOD) {
        let kinematics = cell.robot().forward_kinematics(&sample.q)?;
        let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        let hand = second.chain().tip();
        let root_from_hand = kinematics.world_from_link(hand) * second.tip_from_hand();
        worst = worst.max(off_grip(second.grip(), &root_from_tool, &root_from_hand));
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

/// How far the tool leaves its line at any time of a motion; nothing if it follows none.
///
/// The tool is compared with the nearest point of the line that lies no earlier than the one before, at the
/// begin and the end of the motion with those of the line.
fn line_deviation(
    cell: &Workcell,
    task: &Task,
    trajectory: &Trajectory,
    corners: &[ToolPose],
) -> Result<LineDeviation, FollowError> {
    let mut deviation = LineDeviation::default();
    if corners.len() < 2 {
        return Ok(deviation);
    }
    let line = Line::new(task, corners);
    let mut at = 0;
    let mut add = |off: LineDeviation| {
        deviation.position = deviation.position.max(off.position);
        deviation.rotation = deviation.rotation.max(off.rotation);
    };
    let mut last = None;
    for sample in trajectory.samples(LINE_PERIOD) {
        let kinematics = cell.robot().forward_kinematics(&sample.q)?;
        let world_from_tool =
            cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        if last.is_none() {
            add(between(&line.poses[0], &line.poses[0], &world_from_tool));
        }
        add(line.off(&mut at, &world_from_tool));
        last = Some(world_from_tool);
    }
    if let (Some(tool), Some(end)) = (last, line.poses.last()) {
        add(between(end, end, &tool));
    }
    Ok(deviation)
}

/// The line of the tool, cut finely.
struct Line {
    poses: Vec<Pose>,
}

impl Line {
    fn new(task: &Task, corners: &[ToolPose]) -> Self {
        let mut poses = vec![Workcell::world_from_tool(task, &corners[0])];
        for pair in corners.windows(2) {
            let turn = (pair[1].surface_from_tool.heading - pair[0].surface_from_tool.heading)
                .abs()
                .max((pair[1].tilt - pair[0].tilt).abs());
            // A milliradian counts as a millimetre.
            let count = (pair[0].distance(&pair[1]).max(turn) / LINE_STEP)
                .ceil()
                .max(1.0) as usize;
            poses.extend((1..=count).map(|i| {
                Workcell::world_from_tool(task, &pair[0].towards(&pair[1], i as f64 / count as f64))
            }));
        }
        Self { poses }
    }

    /// How far a pose is off the line from `at` on, which moves along.
    fn off(&self, at: &mut usize, pose: &Pose) -> LineDeviation {
        let measure = |i: usize| between(&self.poses[i], &self.poses[i + 1], pose);
        let cost = |off: &LineDeviation| off.position + 0.1 * off.rotation;
        let last = self.poses.len() - 2;
        let mut best = measure(*at);
        // Far enough to pass what may be skipped at a rounded corner.
        const AHEAD: usize = 120;
        for i in *at + 1..=(*at + AHEAD).min(last) {
            let off = measure(i);
            if cost(&off) < cost(&best) {
                best = off;
                *at = i;
            }
        }
        best
    }
}

/// How far a pose is off the straight way between two others.
fn between(from: &Pose, to: &Pose, pose: &Pose) -> LineDeviation {
    let along = to.translation.vector - from.translation.vector;
    let length = along.norm_squared();
    let since = pose.translation.vector - from.translation.vector;
    let turn = from.rotation.angle_to(&to.rotation);
    let s = if length > 0.0 {
        (since.dot(&along) / length).clamp(0.0, 1.0)
    } else if turn > 0.0 {
        (from.rotation.angle_to(&pose.rotation) / turn).clamp(0.0, 1.0)
    } else {
        0.0
    };
    LineDeviation {
        position: (since - along * s).norm(),
        rotation: from
            .rotation
            .slerp(&to.rotation, s)
            .angle_to(&pose.rotation),
    }
}
