//! Whether a followed plan is what it should be: limits, clearance and the tool's line over the whole
//! timed motion, seen from its samples alone.
//!
//! Nothing here knows how the motion was found. Between samples the motion of every body is bounded, so
//! that "clear" holds at every time and not only at the samples.

use super::second_arm::off_grip;
use super::{
    CheckConfig, Fault, FollowConfig, FollowError, Followed, GripDeviation, JointPath, Motion,
    Phase, ToolPose, Touch, Trajectory, TrajectorySample, Workcell, trajectory_faults,
};
use crate::geometry::Pose;
use crate::represent::Task;

/// Period of the samples [s].
const PERIOD: f64 = 0.01;
/// Distances beyond this are not told apart [m].
const FAR: f64 = 0.5;
/// Steps in which an arc of the line is compared.
const LINE_STEP: f64 = 1e-3;

/// How far the tool leaves its line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LineDeviation {
    /// Largest distance of the tool centre point [m].
    pub position: f64,
    /// Largest angle to the orientation that the line has there [rad].
    pub rotation: f64,
}

/// A way in which a followed plan is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionFault {
    /// A motion breaks the limits of its joints or does not keep to its times.
    #[error("motion {motion}: {fault}")]
    Trajectory {
        /// The motion's number.
        motion: usize,
        /// What is wrong.
        fault: Fault,
    },
    /// A joint is outside its range; those that follow several others included.
    #[error("at {time:.3} s: {fault}")]
    Limit {
        /// When [s].
        time: f64,
        /// Which joint.
        fault: crate::robot::LimitFault,
    },
    /// A motion does not begin where and when the one before ends.
    #[error("motion {motion} begins {step} from where the one before ends, {gap} s later")]
    Gap {
        /// The later motion's number.
        motion: usize,
        /// The widest step of a joint [rad or m].
        step: f64,
        /// The time between [s].
        gap: f64,
    },
    /// Two bodies that must not touch do.
    #[error("at {time:.3} s: {a:?} comes within {distance:.5} m of {b:?}")]
    Contact {
        /// When [s].
        time: f64,
        /// One body.
        a: String,
        /// The other.
        b: String,
        /// Their distance [m]; negative inside.
        distance: f64,
    },
    /// The tool leaves its line.
    #[error("motion {motion}: the tool leaves its line by {position:.5} m and {rotation:.5} rad")]
    OffLine {
        /// The motion's number.
        motion: usize,
        /// How far [m].
        position: f64,
        /// How far turned [rad].
        rotation: f64,
    },
    /// The second hand leaves its grip on the tool.
    #[error(
        "at {time:.3} s: the second hand is {position:.5} m off its grip and leans {lean:.4} rad too far"
    )]
    OffGrip {
        /// When [s].
        time: f64,
        /// How far [m].
        position: f64,
        /// How much further than the grip allows [rad].
        lean: f64,
    },
    /// The base moves while the tool wipes.
    #[error("motion {motion}: the base moves while the tool is at the surface")]
    BaseMoves {
        /// The motion's number.
        motion: usize,
    },
}

/// What a followed plan keeps to.
#[derive(Debug, Clone, PartialEq)]
pub struct Audit {
    /// How far the tool leaves its lines over all motions.
    pub line: LineDeviation,
    /// How far the second hand leaves its grip over all motions; nothing where one hand holds the tool.
    pub grip: GripDeviation,
    /// Smallest distance of bodies that must not touch, at most 0.5 m; the tool and the object that
    /// carries the surface count where the tool is not coming down, wiping or lifting off [m].
    pub min_clearance: f64,
    /// What is wrong; empty for a sound motion.
    pub faults: Vec<MotionFault>,
}

/// Checks every motion: limits of position, velocity and acceleration, coupled limits, clearance at every
/// time, the tool's line, the second hand's grip, joints between motions, and that the base stands still while the tool is down.
///
/// # Errors
/// If the motions are not of this robot.
pub fn audit(
    followed: &Followed,
    cell: &Workcell,
    task: &Task,
    config: &FollowConfig,
) -> Result<Audit, FollowError> {
    let mut audit = Audit {
        line: LineDeviation::default(),
        grip: GripDeviation::default(),
        min_clearance: FAR,
        faults: Vec::new(),
    };
    let mut before: Option<(f64, Vec<f64>)> = None;
    for (number, motion) in followed.motions.iter().enumerate() {
        let samples: Vec<TrajectorySample> = motion.trajectory.samples(PERIOD).collect();
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            continue;
        };
        if let Some((end, q)) = &before {
            gap(number, motion, *end, q, &first.q, &mut audit.faults);
        }
        before = Some((motion.end(), last.q.clone()));
        limits(number, motion, &samples, cell, &mut audit.faults)?;
        clearance(motion, &samples, cell, &mut audit)?;
        grip(motion, &samples, cell, &mut audit)?;
        base(number, motion.phase, &samples, cell, &mut audit.faults);
        let off = line_deviation(cell, task, &motion.trajectory, &motion.tool_line)?;
        if off.position > config.line_tolerance || off.rotation > config.turn_tolerance {
            audit.faults.push(MotionFault::OffLine {
                motion: number,
                position: off.position,
                rotation: off.rotation,
            });
        }
        audit.line.position = audit.line.position.max(off.position);
        audit.line.rotation = audit.line.rotation.max(off.rotation);
    }
    Ok(audit)
}

fn gap(
    number: usize,
    motion: &Motion,
    end: f64,
    before: &[f64],
    first: &[f64],
    faults: &mut Vec<MotionFault>,
) {
    let steps = before.iter().zip(first).map(|(a, b)| (a - b).abs());
    let step = steps.fold(0.0, f64::max);
    let gap = motion.start - end;
    if step > 1e-9 || gap.abs() > 1e-9 {
        faults.push(MotionFault::Gap {
            motion: number,
            step,
            gap,
        });
    }
}

fn limits(
    number: usize,
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    faults: &mut Vec<MotionFault>,
) -> Result<(), FollowError> {
    for sample in samples {
        let found = cell.robot().limit_faults(&sample.q)?;
        faults.extend(found.into_iter().map(|fault| MotionFault::Limit {
            time: motion.start + sample.time,
            fault,
        }));
    }
    let path: Vec<&[f64]> = samples.iter().map(|sample| sample.q.as_slice()).collect();
    if path.len() > 1 {
        // The samples themselves are the path: what is checked here is not the way but its times.
        let path = JointPath::new(&path)?;
        let found = trajectory_faults(samples, &path, cell.limits(), &CheckConfig::default());
        faults.extend(found.into_iter().map(|fault| MotionFault::Trajectory {
            motion: number,
            fault,
        }));
    }
    Ok(())
}

fn clearance(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    audit: &mut Audit,
) -> Result<(), FollowError> {
    let touch = match motion.phase {
        Phase::Wipe(_) | Phase::Lower | Phase::Lift => Touch::Surface,
        Phase::Drive | Phase::Transfer | Phase::Lifted => Touch::Nothing,
    };
    let model = cell.all_collisions(touch);
    for pair in samples.windows(2) {
        // Bodies that overlap are told apart from those that touch by the fault below.
        let near = model.clearance(&pair[0].q, audit.min_clearance.max(0.0))?;
        audit.min_clearance = audit.min_clearance.min(near.distance);
        if let Some(contact) = model.segment_contact(&pair[0].q, &pair[1].q, 0.0)? {
            audit.faults.push(MotionFault::Contact {
                time: motion.start + pair[0].time,
                a: model.name(contact.a).to_owned(),
                b: model.name(contact.b).to_owned(),
                distance: contact.distance,
            });
        }
    }
    Ok(())
}

fn grip(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    audit: &mut Audit,
) -> Result<(), FollowError> {
    for sample in samples {
        let off = grip_deviation(cell, &sample.q)?;
        audit.grip = audit.grip.max(off);
        if !off.is_held() {
            audit.faults.push(MotionFault::OffGrip {
                time: motion.start + sample.time,
                position: off.position,
                lean: off.lean,
            });
        }
    }
    Ok(())
}

/// How far the second hand is off its grip at the positions of all n variables; nothing if there is none.
pub(super) fn grip_deviation(cell: &Workcell, q: &[f64]) -> Result<GripDeviation, FollowError> {
    let Some(second) = cell.second() else {
        return Ok(GripDeviation::default());
    };
    let kinematics = cell.robot().forward_kinematics(q)?;
    let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
    let root_from_hand = kinematics.world_from_link(second.chain().tip()) * second.tip_from_hand();
    Ok(off_grip(second.grip(), &root_from_tool, &root_from_hand))
}

fn base(
    number: usize,
    phase: Phase,
    samples: &[TrajectorySample],
    cell: &Workcell,
    faults: &mut Vec<MotionFault>,
) {
    let Some(base) = cell.base() else { return };
    if matches!(phase, Phase::Drive | Phase::Transfer) {
        return;
    }
    let place = |sample: &TrajectorySample| [base.x, base.y, base.yaw].map(|i| sample.q[i]);
    if samples
        .iter()
        .any(|sample| place(sample) != place(&samples[0]))
    {
        faults.push(MotionFault::BaseMoves { motion: number });
    }
}

/// How far the tool leaves its line at any time of a motion; nothing if it follows none.
///
/// The tool is compared with the nearest point of the line that lies no earlier than the one before, at the
/// begin and the end of the motion with those of the line.
pub(super) fn line_deviation(
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
    for sample in trajectory.samples(PERIOD / 2.0) {
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

impl Audit {
    /// Whether nothing is wrong.
    pub fn is_sound(&self) -> bool {
        self.faults.is_empty()
    }
}
