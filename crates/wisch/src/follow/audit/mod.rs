//! Whether a followed plan keeps its limits, its clearance and the tool's line over the whole timed motion.
//!
//! Nothing here knows how the motion was found or timed: positions are read off the timed motion, the tool's pose
//! is computed from the robot model by kinematics of the audit's own, and limits are the robot model's. Shared
//! are only data, and the collision model, which is tested by itself (`robot/clearance`). Between samples the
//! motion of every body is bounded, so that "clear" holds at every time and not only at the samples.

mod kinematics;
mod line;
mod trajectory;

pub use trajectory::{CheckConfig, End, Rate, TrajectoryFault, trajectory_faults};

use crate::follow::{
    AllowedContact, FollowConfig, FollowError, Followed, GRIP_TOLERANCE, GripDeviation, JointLimit,
    JointLimits, JointPath, LEAN_TOLERANCE, LineDeviation, Motion, Phase, Trajectory,
    TrajectorySample, Workcell,
};
use crate::represent::Task;
use crate::robot::{LimitFault, RobotError, RobotModel};
use line::{Line, off_grip, world_from_tool};

/// Period at which limits and clearance are looked at [s].
const PERIOD: f64 = 0.01;
/// Period at which the tool's line and the second hand's grip are looked at [s].
const LINE_PERIOD: f64 = 0.002;
/// The time before the end in which no sample is taken but the last [s].
const LAST: f64 = 1e-9;
/// Distances beyond this are not told apart [m].
const FAR: f64 = 0.5;

/// A way in which a followed plan is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionFault {
    /// A motion breaks the limits of its joints or does not keep to its times.
    #[error("motion {motion}: {fault}")]
    Trajectory {
        /// The motion's number.
        motion: usize,
        /// What is wrong.
        fault: TrajectoryFault,
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
    let robot = cell.robot();
    let limits = joint_limits(cell)?;
    let mut audit = Audit {
        line: LineDeviation::default(),
        grip: GripDeviation::default(),
        min_clearance: FAR,
        faults: Vec::new(),
    };
    let mut before: Option<(f64, Vec<f64>)> = None;
    for (number, motion) in followed.motions.iter().enumerate() {
        let samples = samples(&motion.trajectory, PERIOD);
        let [first, .., last] = &samples[..] else {
            continue;
        };
        if first.q.len() != robot.dof() {
            return Err(FollowError::Robot(RobotError::Length {
                what: "positions",
                found: first.q.len(),
                expected: robot.dof(),
            }));
        }
        if let Some((end, q)) = &before {
            gap(number, motion, *end, q, &first.q, &mut audit.faults);
        }
        before = Some((motion.start + last.time, last.q.clone()));
        coupled_limits(motion, &samples, robot, &mut audit.faults);
        timing(number, &samples, &limits, &mut audit.faults)?;
        clearance(motion, &samples, cell, &mut audit)?;
        base(number, motion.phase, &samples, cell, &mut audit.faults);
        let samples = self::samples(&motion.trajectory, LINE_PERIOD);
        grip(motion, &samples, cell, &mut audit);
        on_line(number, motion, &samples, cell, task, config, &mut audit);
    }
    Ok(audit)
}

/// The states at 0, p, 2p, … for a period p [s], and at the end of the motion.
fn samples(trajectory: &Trajectory, period: f64) -> Vec<TrajectorySample> {
    let end = trajectory.duration();
    let count = ((end - LAST) / period).ceil().max(0.0) as usize;
    let times = (0..count).map(|k| k as f64 * period).chain([end]);
    times.map(|time| trajectory.sample(time)).collect()
}

/// The limits of all n variables: those of the robot model, and where it gives none the work cell's.
fn joint_limits(cell: &Workcell) -> Result<JointLimits, FollowError> {
    let limit = |(i, assumed): (usize, &JointLimit)| {
        let joint = cell.robot().variable(i);
        let range = joint.limits.position;
        JointLimit {
            name: joint.name.clone(),
            lower: range.map_or(f64::NEG_INFINITY, |range| range.lower),
            upper: range.map_or(f64::INFINITY, |range| range.upper),
            velocity: joint.limits.velocity.unwrap_or(assumed.velocity),
            acceleration: joint.limits.acceleration.unwrap_or(assumed.acceleration),
        }
    };
    let assumed = cell.limits().joints().iter().enumerate();
    Ok(JointLimits::new(assumed.map(limit).collect())?)
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

/// Positions of all joints, those that follow several others included.
fn coupled_limits(
    motion: &Motion,
    samples: &[TrajectorySample],
    robot: &RobotModel,
    faults: &mut Vec<MotionFault>,
) {
    for sample in samples {
        for joint in robot.joints() {
            let terms = joint.drive.terms.iter();
            let moved: f64 = terms.map(|(i, factor)| factor * sample.q[*i]).sum();
            let position = joint.drive.offset + moved;
            let Some(limits) = joint.limits.position else {
                continue;
            };
            if !(limits.lower..=limits.upper).contains(&position) {
                faults.push(MotionFault::Limit {
                    time: motion.start + sample.time,
                    fault: LimitFault {
                        joint: joint.name.clone(),
                        position,
                        limits,
                        unit: joint.kind.unit(),
                    },
                });
            }
        }
    }
}

fn timing(
    number: usize,
    samples: &[TrajectorySample],
    limits: &JointLimits,
    faults: &mut Vec<MotionFault>,
) -> Result<(), FollowError> {
    let path: Vec<&[f64]> = samples.iter().map(|sample| sample.q.as_slice()).collect();
    // The samples themselves are the path: what is checked here is not the way but its times.
    let path = JointPath::new(&path)?;
    let found = trajectory_faults(samples, &path, limits, &CheckConfig::default());
    faults.extend(found.into_iter().map(|fault| MotionFault::Trajectory {
        motion: number,
        fault,
    }));
    Ok(())
}

fn clearance(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    audit: &mut Audit,
) -> Result<(), FollowError> {
    let allowed = match motion.phase {
        Phase::Wipe(_) | Phase::Lower | Phase::Lift => AllowedContact::Surface,
        Phase::Drive | Phase::FreeMotion | Phase::Lifted => AllowedContact::None,
    };
    let model = cell.all_collisions(allowed);
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

fn grip(motion: &Motion, samples: &[TrajectorySample], cell: &Workcell, audit: &mut Audit) {
    for sample in samples {
        let GripDeviation { position, lean } = off_grip(cell, &sample.q);
        audit.grip.position = audit.grip.position.max(position);
        audit.grip.lean = audit.grip.lean.max(lean);
        if position > GRIP_TOLERANCE || lean > LEAN_TOLERANCE {
            audit.faults.push(MotionFault::OffGrip {
                time: motion.start + sample.time,
                position,
                lean,
            });
        }
    }
}

/// How far the tool leaves its line at any time of a motion, where it follows one: at the begin and the end of the
/// motion from those of the line, in between from the nearest place of the line that is not behind the last.
fn on_line(
    number: usize,
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    task: &Task,
    config: &FollowConfig,
    audit: &mut Audit,
) {
    let Some(mut line) = Line::new(task, &motion.tool_line) else {
        return;
    };
    let mut worst = LineDeviation::default();
    for (i, sample) in samples.iter().enumerate() {
        let tool = world_from_tool(cell, &sample.q);
        let mut add = |off: LineDeviation| {
            worst.position = worst.position.max(off.position);
            worst.rotation = worst.rotation.max(off.rotation);
        };
        if i == 0 {
            add(line.off_begin(&tool));
        }
        add(line.off(&tool));
        if i + 1 == samples.len() {
            add(line.off_end(&tool));
        }
    }
    let LineDeviation { position, rotation } = worst;
    audit.line.position = audit.line.position.max(position);
    audit.line.rotation = audit.line.rotation.max(rotation);
    if position > config.line_tolerance || rotation > config.turn_tolerance {
        audit.faults.push(MotionFault::OffLine {
            motion: number,
            position,
            rotation,
        });
    }
}

fn base(
    number: usize,
    phase: Phase,
    samples: &[TrajectorySample],
    cell: &Workcell,
    faults: &mut Vec<MotionFault>,
) {
    let Some(base) = cell.base() else { return };
    if matches!(phase, Phase::Drive | Phase::FreeMotion) {
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

impl Audit {
    /// Whether the audit found no fault, so that the motion may be executed.
    pub fn is_sound(&self) -> bool {
        self.faults.is_empty()
    }
}
