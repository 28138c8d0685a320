//! Whether a followed plan keeps its limits, its clearance and the tool's line over the whole timed motion.
//!
//! Nothing here knows how the motion was found or timed: positions are read off the timed motion, the tool's pose
//! is computed from the robot model by kinematics of the audit's own, and limits are the robot model's. Shared
//! are only data, and the collision model, which is tested by itself (`robot/clearance`); whether anything is in the target surface
//! is seen without it (`surface.rs`). Between samples the
//! motion of every body is bounded, so that "clear" holds at every time and not only at the samples.

mod dynamics;
mod kinematics;
mod line;
mod surface;

pub use wisch_robot::timing::{CheckConfig, End, Rate, TrajectoryFault, trajectory_faults};

use crate::follow::{
    AllowedContact, FollowConfig, FollowError, Followed, GRIP_TOLERANCE, GripDeviation, JointLimit,
    JointLimits, JointPath, LEAN_TOLERANCE, LineDeviation, Motion, Phase, Trajectory,
    TrajectorySample, Workcell,
};
use crate::geometry::Vector3;
use crate::represent::Task;
use crate::robot::{Joint, LimitFault, RobotError, RobotModel};
use dynamics::joint_efforts;
use line::{Line, off_grip, world_from_tool};
use surface::{SurfaceCheck, SurfaceFault};

/// Period at which limits and clearance are looked at [s].
const PERIOD: f64 = 0.01;
/// Period at which the tool's line and the second hand's grip are looked at [s].
const LINE_PERIOD: f64 = 0.002;
/// The time before the end in which no sample is taken but the last [s].
const LAST: f64 = 1e-9;
/// Acceleration of a falling body in the world [m/s²].
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);
/// How far an effort may exceed its limit, relative to it; for rounding.
const EFFORT_TOLERANCE: f64 = 1e-6;
/// Distances beyond this are not told apart [m].
const FAR: f64 = 0.5;

/// A way in which a followed plan is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionFault {
    /// A motion breaks the limits of its joints or does not keep to its times.
    #[error("motion {motion}: {fault}{}", named(fault, joint))]
    Trajectory {
        /// The motion's number.
        motion: usize,
        /// The joint of the fault, if it is one joint's; joints that follow others are numbered behind the
        /// variables.
        joint: Option<String>,
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
    /// A joint needs more effort than it has to carry and accelerate the robot's own bodies; tool and contact not
    /// counted.
    #[error(
        "at {time:.3} s: joint {joint:?} needs {effort:.2} {unit} to carry and move the robot, its limit is {limit} {unit}"
    )]
    Effort {
        /// When [s].
        time: f64,
        /// The joint.
        joint: String,
        /// What it needs [Nm or N].
        effort: f64,
        /// What it has [Nm or N].
        limit: f64,
        /// "Nm" or "N".
        unit: &'static str,
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
    /// Robot, hand or tool is in the target surface or has passed through it, or the tool is behind it.
    #[error(
        "at {time:.3} s: {body:?} is {depth:.4} m below the surface {surface:?}, at ({:.3}, {:.3}) m of it",
        place[0], place[1]
    )]
    ThroughSurface {
        /// When it is deepest [s].
        time: f64,
        /// Link or tool.
        body: String,
        /// The surface.
        surface: String,
        /// How far its lowest point is below the surface [m].
        depth: f64,
        /// Where, in the surface frame [m].
        place: [f64; 2],
    },
    /// The tool is pressed where the surface has a hole.
    #[error(
        "at {time:.3} s: the tool is pressed over a hole of the surface {surface:?}, at ({:.3}, {:.3}) m of it",
        place[0], place[1]
    )]
    OverHole {
        /// When first [s].
        time: f64,
        /// The surface.
        surface: String,
        /// Where the tool centre point is, in the surface frame [m].
        place: [f64; 2],
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

/// The name of the joint that a fault has by its number.
fn named(fault: &TrajectoryFault, joint: &Option<String>) -> String {
    match (fault.joint(), joint) {
        (Some(number), Some(name)) => format!(" (joint {number} is {name:?})"),
        _ => String::new(),
    }
}

/// Checks every motion: limits of position, velocity and acceleration of every joint, those that follow others
/// included, efforts for the robot's own weight and inertia, clearance at every time, the tool's line, the second hand's grip, joints
/// between motions, that the base stands still while the tool is down, that nothing but the pad in contact is in the target surface
/// or behind it, and that the tool is pressed over no hole.
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
    let moving = MovingJoints::new(cell)?;
    let surface = SurfaceCheck::new(cell, task, config);
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
        ranges(motion, &samples, robot, &mut audit.faults);
        timing(number, &samples, &moving, &mut audit.faults)?;
        efforts(motion, &samples, cell, &mut audit.faults);
        clearance(motion, &samples, cell, &mut audit)?;
        base(number, motion.phase, &samples, cell, &mut audit.faults);
        let surface_faults = surface
            .iter()
            .flat_map(|check| check.faults(motion, &samples));
        (audit.faults).extend(surface_faults.map(|fault| before_surface(fault, motion, task)));
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

/// The joints that move: the n variables, then those that follow them.
struct MovingJoints<'a> {
    robot: &'a RobotModel,
    followers: Vec<&'a Joint>,
    /// Of velocity and acceleration; ranges are looked at by themselves.
    limits: JointLimits,
}

impl<'a> MovingJoints<'a> {
    /// Limits are those of the robot model. Where it gives none, a variable has the work cell's, and a joint that
    /// follows variables what these can make it do.
    fn new(cell: &'a Workcell) -> Result<Self, FollowError> {
        let robot = cell.robot();
        let is_follower = |i: usize| robot.variables().iter().all(|id| id.index() != i);
        let moves = |joint: &Joint| joint.drive.terms.iter().any(|(_, factor)| *factor != 0.0);
        let joints = robot.joints().iter().enumerate();
        let followers: Vec<&Joint> = joints
            .filter(|&(i, joint)| is_follower(i) && moves(joint))
            .map(|(_, joint)| joint)
            .collect();
        let limit = |joint: &Joint, velocity: f64, acceleration: f64| JointLimit {
            name: joint.name.clone(),
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            velocity: joint.limits.velocity.unwrap_or(velocity),
            acceleration: joint.limits.acceleration.unwrap_or(acceleration),
        };
        let assumed = cell.limits().joints().iter().enumerate();
        let mut limits: Vec<JointLimit> = assumed
            .map(|(i, assumed)| limit(robot.variable(i), assumed.velocity, assumed.acceleration))
            .collect();
        for joint in &followers {
            let (mut velocity, mut acceleration) = (0.0, 0.0);
            for &(variable, factor) in &joint.drive.terms {
                velocity += factor.abs() * limits[variable].velocity;
                acceleration += factor.abs() * limits[variable].acceleration;
            }
            limits.push(limit(joint, velocity, acceleration));
        }
        Ok(Self {
            robot,
            followers,
            limits: JointLimits::new(limits)?,
        })
    }

    /// The state of all of them at the state of the variables.
    fn state(&self, variables: &TrajectorySample) -> TrajectorySample {
        let mut state = variables.clone();
        for joint in &self.followers {
            let sum = |of: &[f64]| -> f64 {
                let terms = joint.drive.terms.iter();
                terms.map(|(i, factor)| factor * of[*i]).sum()
            };
            state.q.push(joint.drive.offset + sum(&variables.q));
            state.qd.push(sum(&variables.qd));
            state.qdd.push(sum(&variables.qdd));
        }
        state
    }

    fn name(&self, number: usize) -> &str {
        match number.checked_sub(self.robot.dof()) {
            None => &self.robot.variable(number).name,
            Some(follower) => &self.followers[follower].name,
        }
    }
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

/// Positions of all joints, those that follow others included.
fn ranges(
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
    moving: &MovingJoints,
    faults: &mut Vec<MotionFault>,
) -> Result<(), FollowError> {
    let states: Vec<TrajectorySample> = samples.iter().map(|sample| moving.state(sample)).collect();
    let path: Vec<&[f64]> = states.iter().map(|state| state.q.as_slice()).collect();
    // The samples themselves are the path: what is checked here is not the way but its times.
    let path = JointPath::new(&path)?;
    let found = trajectory_faults(&states, &path, &moving.limits, &CheckConfig::default());
    faults.extend(found.into_iter().map(|fault| MotionFault::Trajectory {
        motion: number,
        joint: fault.joint().map(|joint| moving.name(joint).to_owned()),
        fault,
    }));
    Ok(())
}

/// Efforts against the limits of all joints: of a variable, what moves it and all that follows it; of a joint that
/// follows others, what passes through it. A limit that is not positive is none.
fn efforts(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    faults: &mut Vec<MotionFault>,
) {
    let robot = cell.robot();
    let gravity_in_root = cell.world_from_root().rotation.inverse() * GRAVITY;
    let is_variable = |i: usize| robot.variables().iter().any(|id| id.index() == i);
    for sample in samples {
        let through = joint_efforts(robot, sample, gravity_in_root);
        let mut of_variables = vec![0.0; robot.dof()];
        for (joint, effort) in robot.joints().iter().zip(&through) {
            for &(variable, factor) in &joint.drive.terms {
                of_variables[variable] += factor * effort;
            }
        }
        for (i, joint) in robot.joints().iter().enumerate() {
            let Some(limit) = joint.limits.effort.filter(|limit| *limit > 0.0) else {
                continue;
            };
            let effort = match joint.drive.terms[..] {
                [(variable, _)] if is_variable(i) => of_variables[variable],
                _ => through[i],
            };
            if effort.abs() > limit * (1.0 + EFFORT_TOLERANCE) {
                faults.push(MotionFault::Effort {
                    time: motion.start + sample.time,
                    joint: joint.name.clone(),
                    effort,
                    limit,
                    unit: joint.kind.effort_unit(),
                });
            }
        }
    }
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

/// A fault before the target surface, in the time of all motions.
fn before_surface(fault: SurfaceFault, motion: &Motion, task: &Task) -> MotionFault {
    let surface = task.surface.name.clone();
    match fault {
        SurfaceFault::Through {
            time,
            body,
            depth,
            place,
        } => MotionFault::ThroughSurface {
            time: motion.start + time,
            body,
            surface,
            depth,
            place: place.into(),
        },
        SurfaceFault::OverHole { time, place } => MotionFault::OverHole {
            time: motion.start + time,
            surface,
            place: place.into(),
        },
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
