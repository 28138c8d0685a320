//! The audit: whether a motion keeps its limits, its clearance and the tool's line at every time.
//!
//! The audit does not know how the motion was found or timed. It reads positions from the timed motion,
//! computes the tool's pose from the robot model by kinematics of its own, and takes limits from the robot
//! model. It shares only data and the collision model, which has its own tests (`robot/clearance`). Penetration
//! of the target surface is checked without the collision model (`surface.rs`). Between samples the motion of
//! every body is bounded, so that clearance holds at every time and not only at the samples.

mod dynamics;
mod given_mesh;
mod kinematics;
mod line;
mod surface;

pub use wisch_robot::timing::{
    MotionEnd, RateKind, TrajectoryCheckConfig, TrajectoryFault, trajectory_faults,
};

use crate::digits::format_beside_limit;
use crate::follow::{
    AllowedContact, FollowConfig, FollowError, Followed, GRIP_TOLERANCE, GripDeviation, JointLimit,
    JointLimits, JointPath, LEAN_TOLERANCE, LineDeviation, Motion, Phase, Trajectory,
    TrajectorySample, Workcell,
};
use crate::geometry::Vector3;
use crate::represent::Task;
use crate::robot::{Joint, LimitFault, RobotError, RobotModel};
use dynamics::{ToolLoad, joint_efforts};
use line::{Line, off_grip, world_from_tool};
use surface::{SurfaceCheck, SurfaceFault};

/// Period at which limits and clearance are checked [s].
const PERIOD: f64 = 0.01;
/// Period at which the tool's line and the second hand's grip are checked [s].
const LINE_PERIOD: f64 = 0.002;
/// Time before the end in which only the last sample is taken [s].
const LAST: f64 = 1e-9;
/// Gravitational acceleration in the world [m/s²].
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);
/// Relative excess of an effort over its limit that is allowed for rounding [1].
const EFFORT_TOLERANCE: f64 = 1e-6;
/// Relative excess of the tool's speed over its limit that is allowed [1].
const SPEED_TOLERANCE: f64 = 0.01;
/// Largest distance that is reported [m]; greater distances are reported as this value.
const FAR: f64 = 0.5;

/// A fault that the audit found in a motion, with its place and value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionFault {
    /// A motion breaks the limits of its joints or does not keep to its times.
    #[error("motion {motion}: {fault}{}", joint_suffix(fault, joint))]
    Trajectory {
        /// Index of the motion.
        motion: usize,
        /// Name of the joint of the fault, if it concerns one joint; mimic joints are numbered after the
        /// variables.
        joint: Option<String>,
        /// The fault.
        fault: TrajectoryFault,
    },
    /// A joint is outside its range, mimic joints included.
    #[error("at {time:.3} s: {fault}")]
    Limit {
        /// Time \[s\].
        time: f64,
        /// The joint and its limit.
        fault: crate::robot::LimitFault,
    },
    /// A joint needs more effort than its limit to carry and accelerate the robot's own bodies, and to press with the
    /// task's force in contact. The tool's weight and friction are not counted.
    #[error(
        "at {time:.3} s: joint {joint:?} needs {} {unit} to carry and move the robot{}, more than its limit of {limit} {unit}",
        format_beside_limit(*limit, *effort, 2),
        press.map_or_else(String::new, |force| format!(" and to press with {force} N"))
    )]
    Effort {
        /// Time \[s\].
        time: f64,
        /// Name of the joint.
        joint: String,
        /// Required effort [Nm or N].
        effort: f64,
        /// Effort limit [Nm or N].
        limit: f64,
        /// "Nm" or "N".
        unit: &'static str,
        /// Press force that it includes \[N\]; `None` out of contact.
        press: Option<f64>,
    },
    /// A motion does not begin at the position and time at which the previous motion ends.
    #[error(
        "motion {motion} begins {step} (rad or m) away from the end of the last motion and {gap} s after it; expected no step and no gap"
    )]
    Gap {
        /// Index of the later motion.
        motion: usize,
        /// Largest step of a joint [rad or m].
        step: f64,
        /// Time between the motions \[s\].
        gap: f64,
    },
    /// Two bodies that must not touch come too close.
    #[error("at {time:.3} s: {a:?} comes too close to {b:?}: clearance {distance:.5} m")]
    Contact {
        /// Time \[s\].
        time: f64,
        /// First body.
        a: String,
        /// Second body.
        b: String,
        /// Distance between them \[m\]; negative if they penetrate.
        distance: f64,
    },
    /// Robot, hand or tool is in the target surface or has passed through it, or the tool is behind it.
    #[error(
        "at {time:.3} s: {body:?} is {depth:.4} m below the surface {surface:?}, at ({:.3}, {:.3}) m in its frame",
        place[0], place[1]
    )]
    ThroughSurface {
        /// Time of the largest depth \[s\].
        time: f64,
        /// Name of the link or tool.
        body: String,
        /// Name of the surface.
        surface: String,
        /// Depth of its lowest point below the surface \[m\].
        depth: f64,
        /// Position in the surface frame \[m\].
        place: [f64; 2],
    },
    /// The tool is pressed over a hole of the surface.
    #[error(
        "at {time:.3} s: the tool is pressed over a hole of the surface {surface:?}, at ({:.3}, {:.3}) m in its frame",
        place[0], place[1]
    )]
    OverHole {
        /// First time \[s\].
        time: f64,
        /// Name of the surface.
        surface: String,
        /// Position of the tool centre point in the surface frame \[m\].
        place: [f64; 2],
    },
    /// The pressed tool is too far from the given mesh of its surface, or its axis deviates from
    /// the mesh's normal.
    #[error(
        "at {time:.3} s: the pressed tool is {:.1} mm off the mesh of the surface {surface:?} and leans by {:.1}° over it, at ({:.3}, {:.3}) m in its chart",
        1e3 * distance, lean.to_degrees(), place[0], place[1]
    )]
    OffMesh {
        /// Time of the largest deviation \[s\].
        time: f64,
        /// Name of the surface.
        surface: String,
        /// Position of the tool centre point in the chart \[m\].
        place: [f64; 2],
        /// Distance of the tool centre point from the mesh \[m\].
        distance: f64,
        /// Angle between the tool's axis and the mean normal of the mesh under the tool \[rad\]; 0
        /// for a tool that may lean.
        lean: f64,
    },
    /// The tool is too far from its planned line.
    #[error("motion {motion}: the tool leaves its line by {position:.5} m and {rotation:.5} rad")]
    OffLine {
        /// Index of the motion.
        motion: usize,
        /// Largest distance \[m\].
        position: f64,
        /// Largest rotation \[rad\].
        rotation: f64,
    },
    /// The tool is faster than the task allows.
    #[error(
        "at {time:.3} s: the tool moves at {} m/s, more than {limit} m/s, the limit {of}",
        format_beside_limit(*limit, *speed, 4)
    )]
    TooFast {
        /// Time at which it is fastest \[s\].
        time: f64,
        /// Speed of the tool centre point [m/s].
        speed: f64,
        /// The limit [m/s].
        limit: f64,
        /// What the limit is for: `in contact`, `on the way to the surface` or `out of contact`.
        of: &'static str,
    },
    /// The second hand is off its grip on the tool.
    #[error(
        "at {time:.3} s: the second hand is {position:.5} m off its grip and leans {lean:.4} rad beyond its limit"
    )]
    OffGrip {
        /// Time \[s\].
        time: f64,
        /// Distance from the grip \[m\].
        position: f64,
        /// Lean beyond the limit of the grip \[rad\].
        lean: f64,
    },
    /// The base moves while the tool wipes.
    #[error("motion {motion}: the base moves while the tool is at the surface")]
    BaseMoves {
        /// Index of the motion.
        motion: usize,
    },
}

/// The result of an audit: the faults of all motions, and the least clearances.
#[derive(Debug, Clone, PartialEq)]
pub struct Audit {
    /// Largest deviation of the tool from its lines over all motions.
    pub line: LineDeviation,
    /// Largest deviation of the second hand from its grip over all motions; zero if one hand holds the tool.
    pub grip: GripDeviation,
    /// Smallest distance of bodies that must not touch, at most 0.5 m \[m\]. The distance between
    /// the tool and the object that carries the surface counts only in phases other than lowering,
    /// wiping and lifting off.
    pub min_clearance: f64,
    /// All faults; empty for a sound motion.
    pub faults: Vec<MotionFault>,
}

/// Returns the name of the joint that a fault gives by its number, as a suffix of the message.
fn joint_suffix(fault: &TrajectoryFault, joint: &Option<String>) -> String {
    match (fault.joint(), joint) {
        (Some(number), Some(name)) => format!(" (joint {number} is {name:?})"),
        _ => String::new(),
    }
}

/// Checks every motion against the limits of the robot, the cell and the task.
///
/// - Positions, velocities and accelerations of all joints, mimic joints included, are within their
///   limits.
/// - Efforts for the robot's own weight and inertia, and in contact for the press force, are within their limits. The
///   press force is not counted for a tool in two hands.
/// - Bodies keep their clearance at every time.
/// - The tool keeps its limits of speed and its line, and the second hand its grip.
/// - Each motion begins at the position and time at which the previous motion ends.
/// - The base stands still while the tool is down.
/// - Only the pad in contact is in the target surface, and nothing is behind it.
/// - The tool is pressed over no hole.
///
/// # Errors
/// If the motions do not have the variables of this robot.
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
            check_gap(number, motion, *end, q, &first.q, &mut audit.faults);
        }
        before = Some((motion.start + last.time, last.q.clone()));
        check_ranges(motion, &samples, robot, &mut audit.faults);
        check_timing(number, &samples, &moving, &mut audit.faults)?;
        check_efforts(motion, &samples, cell, task, &mut audit.faults);
        check_clearance(motion, &samples, cell, &mut audit)?;
        check_base(number, motion.phase, &samples, cell, &mut audit.faults);
        let surface_faults = surface
            .iter()
            .flat_map(|check| check.faults(motion, &samples));
        (audit.faults).extend(surface_faults.map(|fault| surface_fault(fault, motion, task)));
        let samples = self::samples(&motion.trajectory, LINE_PERIOD);
        check_grip(motion, &samples, cell, &mut audit);
        check_speed(motion, &samples, cell, config, &mut audit.faults);
        check_line(number, motion, &samples, cell, task, config, &mut audit);
    }
    Ok(audit)
}

/// Returns the states at 0, p, 2p, … for a period p [s], and at the end of the motion.
fn samples(trajectory: &Trajectory, period: f64) -> Vec<TrajectorySample> {
    let end = trajectory.duration();
    let count = ((end - LAST) / period).ceil().max(0.0) as usize;
    let times = (0..count).map(|k| k as f64 * period).chain([end]);
    times.map(|time| trajectory.sample(time)).collect()
}

/// The moving joints: the n variables of the robot, then its mimic joints.
struct MovingJoints<'a> {
    robot: &'a RobotModel,
    followers: Vec<&'a Joint>,
    /// Limits of velocity and acceleration; ranges are checked separately.
    limits: JointLimits,
}

impl<'a> MovingJoints<'a> {
    /// Returns the limits of the robot model. Where it gives none, a variable has the work cell's limits, and a
    /// mimic joint the limits that follow from its variables.
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

    /// Returns the state of all moving joints for a state of the variables.
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

/// Checks that a motion begins where and when the last one ends.
fn check_gap(
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

/// Checks the positions of all joints, mimic joints included.
fn check_ranges(
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

/// Checks the velocities and accelerations of all joints at the samples and between them.
fn check_timing(
    number: usize,
    samples: &[TrajectorySample],
    moving: &MovingJoints,
    faults: &mut Vec<MotionFault>,
) -> Result<(), FollowError> {
    let states: Vec<TrajectorySample> = samples.iter().map(|sample| moving.state(sample)).collect();
    let path: Vec<&[f64]> = states.iter().map(|state| state.q.as_slice()).collect();
    // The samples themselves serve as the path: this check concerns the times, not the path.
    let path = JointPath::new(&path)?;
    let found = trajectory_faults(
        &states,
        &path,
        &moving.limits,
        &TrajectoryCheckConfig::default(),
    );
    faults.extend(found.into_iter().map(|fault| MotionFault::Trajectory {
        motion: number,
        joint: fault.joint().map(|joint| moving.name(joint).to_owned()),
        fault,
    }));
    Ok(())
}

/// Checks efforts against the limits of all joints. The effort of a variable includes all joints that it moves;
/// the effort of a mimic joint is what it transmits. A limit that is not positive counts as no limit.
fn check_efforts(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    task: &Task,
    faults: &mut Vec<MotionFault>,
) {
    let robot = cell.robot();
    let gravity_in_root = cell.world_from_root().rotation.inverse() * GRAVITY;
    let load = cell.tool_load(task, motion.phase);
    let load = load.map(|force| ToolLoad { cell, task, force });
    // Contact may begin late or be lost, so the efforts without it count as well.
    let loads = [None, load.as_ref()];
    let loads = if load.is_some() {
        &loads[..]
    } else {
        &loads[..1]
    };
    for sample in samples {
        let efforts: Vec<Vec<f64>> = (loads.iter())
            .map(|load| {
                driven_efforts(robot, &joint_efforts(robot, sample, gravity_in_root, *load))
            })
            .collect();
        for (i, joint) in robot.joints().iter().enumerate() {
            let Some(limit) = joint.limits.effort else {
                continue;
            };
            let both = efforts
                .iter()
                .zip(loads)
                .map(|(efforts, load)| (efforts[i], load));
            let largest = both.reduce(|a, b| if b.0.abs() > a.0.abs() { b } else { a });
            if let Some((effort, load)) = largest
                && effort.abs() > limit * (1.0 + EFFORT_TOLERANCE)
            {
                faults.push(MotionFault::Effort {
                    time: motion.start + sample.time,
                    joint: joint.name.clone(),
                    effort,
                    limit,
                    unit: joint.kind.effort_unit(),
                    press: load.map(|load| load.force),
                });
            }
        }
    }
}

/// Returns the effort of each joint from the efforts `through` all joints: a variable's effort
/// includes those of all joints that it moves.
fn driven_efforts(robot: &RobotModel, through: &[f64]) -> Vec<f64> {
    let mut efforts = through.to_vec();
    let mut of_variables = vec![0.0; robot.dof()];
    for (joint, effort) in robot.joints().iter().zip(through) {
        for &(variable, factor) in &joint.drive.terms {
            of_variables[variable] += factor * effort;
        }
    }
    for (variable, id) in robot.variables().iter().enumerate() {
        if let [(own, _)] = robot.joints()[id.index()].drive.terms[..]
            && own == variable
        {
            efforts[id.index()] = of_variables[variable];
        }
    }
    efforts
}

/// Checks the clearance between all bodies at every time of a motion.
fn check_clearance(
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
        // A distance of 0 does not distinguish overlap from contact; the fault below does.
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

/// Checks the grip of the second hand over a motion.
fn check_grip(motion: &Motion, samples: &[TrajectorySample], cell: &Workcell, audit: &mut Audit) {
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

/// Checks the speed of the tool over a motion against the limit of its phase.
fn check_speed(
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    config: &FollowConfig,
    faults: &mut Vec<MotionFault>,
) {
    let (limit, of) = match motion.phase {
        Phase::Wipe(_) => (config.contact_speed, "in contact"),
        Phase::Lower => (
            config.approach_speed.min(config.free_speed),
            "on the way to the surface",
        ),
        _ => (config.free_speed, "out of contact"),
    };
    let places = samples
        .iter()
        .map(|sample| (sample.time, world_from_tool(cell, &sample.q).origin));
    let places: Vec<(f64, Vector3)> = places.collect();
    let speeds = places.windows(2).filter_map(|pair| {
        let [(begin, from), (end, to)] = [pair[0], pair[1]];
        (end - begin > LAST).then(|| (begin, (to - from).norm() / (end - begin)))
    });
    let fastest = speeds.max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((time, speed)) = fastest
        && speed > limit * (1.0 + SPEED_TOLERANCE)
    {
        faults.push(MotionFault::TooFast {
            time: motion.start + time,
            speed,
            limit,
            of,
        });
    }
}

/// Checks the deviation of the tool from its line over a motion, which has to follow the whole line in its order.
fn check_line(
    number: usize,
    motion: &Motion,
    samples: &[TrajectorySample],
    cell: &Workcell,
    task: &Task,
    config: &FollowConfig,
    audit: &mut Audit,
) {
    let Some(line) = Line::new(task, &motion.tool_line) else {
        return;
    };
    let tools = samples
        .iter()
        .map(|sample| world_from_tool(cell, &sample.q));
    let LineDeviation { position, rotation } = line.deviation_of(tools);
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

/// Returns a fault of the surface check, with its time on the clock of all motions.
fn surface_fault(fault: SurfaceFault, motion: &Motion, task: &Task) -> MotionFault {
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
        SurfaceFault::OffMesh { time, place, off } => MotionFault::OffMesh {
            time: motion.start + time,
            surface,
            place: place.into(),
            distance: off.distance,
            lean: off.lean,
        },
    }
}

/// Checks that the base stands still while the tool is at the surface.
fn check_base(
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
