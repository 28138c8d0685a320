//! The result of following a plan: motions in the order of execution, and abandoned nodes.

use super::{Trajectory, TrajectorySample};
use crate::digits::format_beside_limit;
use crate::geometry::{PlanarPose, Pose};
use crate::plan::Stroke;
use crate::robot::Range;
use std::fmt;

/// Period at which joint movement is summed [s].
const MOVEMENT_PERIOD: f64 = 0.01;

/// The purpose of a motion, which determines what may move and what the tool may touch.
///
/// ```
/// use wisch::follow::Phase;
/// // The third stroke, and what files call "transfer".
/// assert!(Phase::Wipe(2).is_contact());
/// assert_eq!(Phase::FreeMotion.as_str(), "transfer");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Phase {
    /// The base drives to another pose, the arm holds still.
    Drive,
    /// The arm moves freely, the tool is clear of the surface.
    FreeMotion,
    /// The tool moves above the surface at the height of lifts between strokes.
    Lifted,
    /// The tool moves down to the surface.
    Lower,
    /// The tool wipes in contact; the number is the stroke's index in [`Followed::strokes`].
    Wipe(usize),
    /// The tool lifts off the surface.
    Lift,
}

impl Phase {
    /// Whether the tool is in contact during the whole motion.
    pub const fn is_contact(self) -> bool {
        matches!(self, Self::Wipe(_))
    }

    /// Index of the wiped stroke in [`Followed::strokes`]; `None` for other motions.
    pub const fn stroke(self) -> Option<usize> {
        match self {
            Self::Wipe(stroke) => Some(stroke),
            _ => None,
        }
    }

    /// Name of the phase in files and messages.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Drive => "drive",
            Self::FreeMotion => "transfer",
            Self::Lifted => "lifted",
            Self::Lower => "lower",
            Self::Wipe(_) => "wipe",
            Self::Lift => "lift",
        }
    }
}

/// Pose of the tool relative to the target surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolPose {
    /// Tool centre point and heading in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Height above the surface \[m\].
    pub height: f64,
    /// Lean about the tool's tilt axis \[rad\]; 0 for tools without a tilt axis.
    pub tilt: f64,
}

impl ToolPose {
    /// Returns the pose at share `s` of the way to another pose, 0 being this one. Position, height, heading
    /// and tilt change linearly; the heading is not wrapped to ±π.
    pub fn interpolate(&self, to: &Self, s: f64) -> Self {
        let between = |a: f64, b: f64| a + s * (b - a);
        let (a, b) = (&self.surface_from_tool, &to.surface_from_tool);
        Self {
            surface_from_tool: PlanarPose::new(
                a.position + (b.position - a.position) * s,
                between(a.heading, b.heading),
            ),
            height: between(self.height, to.height),
            tilt: between(self.tilt, to.tilt),
        }
    }

    /// Returns the pose at the same place, heading and tilt, at a height above the surface \[m\].
    pub fn with_height(&self, height: f64) -> Self {
        Self { height, ..*self }
    }

    /// Distance of the tool centre point to another pose \[m\].
    pub fn distance(&self, to: &Self) -> f64 {
        let flat = (to.surface_from_tool.position - self.surface_from_tool.position).norm();
        flat.hypot(to.height - self.height)
    }
}

/// Deviation of the tool from its line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LineDeviation {
    /// Largest distance of the tool centre point \[m\].
    pub position: f64,
    /// Largest angle to the orientation of the line at that place \[rad\].
    pub rotation: f64,
}

/// Deviation of the second hand from its grip.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GripDeviation {
    /// Distance of the hand's outermost point from the grip \[m\].
    pub position: f64,
    /// Angle by which the hand leans on the bar beyond the limit \[rad\].
    pub lean: f64,
}

/// A motion from rest to rest.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Purpose of the motion.
    pub phase: Phase,
    /// Start time \[s\].
    pub start: f64,
    /// All n variables of the robot over time, from 0 to the motion's duration.
    pub trajectory: Trajectory,
    /// Corners of the tool's line, between which pose and height change linearly; empty if the tool follows no
    /// line.
    pub tool_line: Vec<ToolPose>,
}

impl Motion {
    /// End time \[s\], on the same clock as `start`.
    pub fn end(&self) -> f64 {
        self.start + self.trajectory.duration()
    }
}

/// Why a node could not be reached.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Obstruction {
    /// No configuration puts the tool at the pose.
    #[error("out of reach by {position_error:.3} m and {rotation_error:.2} rad")]
    OutOfReach {
        /// Distance of the nearest configuration found \[m\].
        position_error: f64,
        /// Rotation of the nearest configuration found from the pose \[rad\].
        rotation_error: f64,
    },
    /// A joint has reached its limit.
    #[error("joint {joint:?} is at a limit of its range, {:.4} to {:.4} {unit}", limits.lower, limits.upper)]
    JointLimit {
        /// Name of the joint.
        joint: String,
        /// Range of the joint [rad or m].
        limits: Range,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// Two parts of the robot come too close to each other.
    #[error(
        "{a:?} comes too close to {b:?}: clearance {} m, expected at least {limit} m",
        format_beside_limit(*limit, *distance, 4)
    )]
    SelfCollision {
        /// First part.
        a: String,
        /// Second part.
        b: String,
        /// Distance between them \[m\], negative if they penetrate.
        distance: f64,
        /// Least distance at which the way is free \[m\].
        limit: f64,
    },
    /// The robot or its tool comes too close to the scene.
    #[error(
        "{body:?} comes too close to {object:?}: clearance {} m, expected at least {limit} m",
        format_beside_limit(*limit, *distance, 4)
    )]
    SceneCollision {
        /// Name of the link or tool.
        body: String,
        /// Name of the object.
        object: String,
        /// Distance between them \[m\], negative if they penetrate.
        distance: f64,
        /// Least distance at which the way is free \[m\].
        limit: f64,
    },
    /// The second hand does not reach its grip on the tool.
    #[error("the second hand is off its grip by {position_error:.3} m and {rotation_error:.2} rad")]
    SecondHand {
        /// Distance of the nearest configuration found from the grip \[m\].
        position_error: f64,
        /// Rotation of the nearest configuration found from the grip \[rad\].
        rotation_error: f64,
    },
    /// The next pose on the line needs a jump of the joints.
    #[error("joint {joint:?} would jump by {step:.3} {unit} between two poses of the line")]
    Jump {
        /// The joint that moves most.
        joint: String,
        /// Step of the joint [rad or m].
        step: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
}

impl Obstruction {
    /// An unreachable pose of which nothing else is known.
    pub(super) const fn unreachable() -> Self {
        Self::OutOfReach {
            position_error: f64::INFINITY,
            rotation_error: f64::INFINITY,
        }
    }
}

/// A failed attempt to reach a node.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// Rotation about the surface normal against the planned heading \[rad\].
    pub rotation: f64,
    /// Lean about the tool's tilt axis \[rad\].
    pub tilt: f64,
    /// Followed share of the edge, 0 to 1.
    pub progress: f64,
    /// The obstruction that ended the attempt.
    pub obstruction: Obstruction,
}

/// A node that the robot could not reach.
#[derive(Debug, Clone, PartialEq)]
pub struct AbandonedNode {
    /// Index of the node in the graph.
    pub node: usize,
    /// Index of the planned stroke that contains it.
    pub stroke: usize,
    /// The failed attempts.
    pub attempts: Vec<Attempt>,
}

impl AbandonedNode {
    /// Returns the obstruction of the attempt that came farthest, the earliest of equals; `None` if no base pose reaches
    /// the node, so that nothing was attempted.
    pub fn obstruction(&self) -> Option<&Obstruction> {
        let farthest =
            (self.attempts.iter().rev()).max_by(|a, b| a.progress.total_cmp(&b.progress));
        farthest.map(|attempt| &attempt.obstruction)
    }
}

impl fmt::Display for AbandonedNode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.obstruction() {
            Some(obstruction) => write!(f, "node {}: {obstruction}", self.node),
            None => write!(f, "node {}: no base pose reaches it", self.node),
        }
    }
}

/// A base pose from which the tool wipes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Position and heading in the plane of the world's floor.
    pub world_from_base: PlanarPose,
    /// Expected reachability of the rest of the path from here, 0 to 1.
    pub rating: f64,
}

/// A candidate base pose with the rating by which the placement chooses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedBasePose {
    /// Position and heading in the plane of the world's floor.
    pub world_from_base: PlanarPose,
    /// Share of the path that is in reach from here, 0 to 1; `None` where the robot cannot stand.
    pub rating: Option<f64>,
}

/// A plan as joint motion of a robot: trajectories of all its variables in order, and the abandoned nodes;
/// paper §3.3.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The motions in order; each begins where and when the last one ends.
    pub motions: Vec<Motion>,
    /// The strokes as executed, with the headings used; a planned stroke may be cut into several.
    pub strokes: Vec<Stroke>,
    /// Base poses in order; empty for a robot with a fixed base.
    pub placements: Vec<Placement>,
    /// Rated base poses for the whole path.
    pub rated: Vec<RatedBasePose>,
    /// Reachability of each node of the plan's graph from the best base pose, by the capability map, from 0
    /// (out of reach of all) to 1. It extends the semantic directed graph. Empty without a map.
    pub node_reachability: Vec<f64>,
    /// Abandoned nodes.
    pub abandoned: Vec<AbandonedNode>,
    /// The tool in the frame of the link that holds it.
    pub tip_from_tool: Pose,
}

impl Followed {
    /// Returns no motions: the robot stays where it is, with the tool at this pose in the frame of the link that holds it.
    pub const fn new(tip_from_tool: Pose) -> Self {
        Self {
            motions: Vec::new(),
            strokes: Vec::new(),
            placements: Vec::new(),
            rated: Vec::new(),
            node_reachability: Vec::new(),
            abandoned: Vec::new(),
            tip_from_tool,
        }
    }

    /// Time from the start to the end of all motions \[s\].
    pub fn duration(&self) -> f64 {
        self.motions.last().map_or(0.0, Motion::end)
    }

    /// Returns the motion at a time \[s\]: the first before the start, the last after the end.
    pub fn motion_at(&self, time: f64) -> Option<&Motion> {
        self.motions.get(self.index_at(time))
    }

    /// Returns the index of the motion at a time \[s\], as for [`Self::motion_at`].
    pub fn index_at(&self, time: f64) -> usize {
        let next = self.motions.partition_point(|motion| motion.start <= time);
        next.saturating_sub(1)
    }

    /// Returns the state of all n variables at a time \[s\]; at rest before the start and after the end. `None`
    /// without motions.
    pub fn sample(&self, time: f64) -> Option<TrajectorySample> {
        let motion = self.motion_at(time)?;
        let sample = motion.trajectory.sample(time - motion.start);
        Some(TrajectorySample { time, ..sample })
    }

    /// Returns these motions after the motions `first`; their times are shifted by the end time of
    /// `first`.
    #[must_use]
    pub fn prepend(mut self, first: Vec<Motion>) -> Self {
        let begin = first.last().map_or(0.0, Motion::end);
        for motion in &mut self.motions {
            motion.start += begin;
        }
        self.motions.splice(0..0, first);
        self
    }

    /// Duration of all motions in contact \[s\].
    pub fn contact_time(&self) -> f64 {
        self.contact_time_until(f64::INFINITY)
    }

    /// Time in contact of a motion that ends early, at `end` \[s\].
    pub fn contact_time_until(&self, end: f64) -> f64 {
        let contact = self.motions.iter().filter(|m| m.phase.is_contact());
        contact.fold(0.0, |sum, motion| {
            sum + (end - motion.start).clamp(0.0, motion.trajectory.duration())
        })
    }

    /// Length of the joint path of some of the variables: in contact, and in total \[rad\].
    pub fn joint_movement(&self, variables: &[usize]) -> [f64; 2] {
        self.joint_movement_until(variables, f64::INFINITY)
    }

    /// Length of the joint path of a motion that ends early, at `end` \[s\]: in contact, and in total \[rad\].
    pub fn joint_movement_until(&self, variables: &[usize], end: f64) -> [f64; 2] {
        let mut movement = [0.0; 2];
        for motion in &self.motions {
            let mut samples = motion.trajectory.samples(MOVEMENT_PERIOD);
            let Some(mut before) = samples.next() else {
                continue;
            };
            let mut moved = 0.0;
            for sample in samples.take_while(|sample| motion.start + sample.time <= end) {
                let squares = variables
                    .iter()
                    .map(|&i| (sample.q[i] - before.q[i]).powi(2));
                moved += squares.sum::<f64>().sqrt();
                before = sample;
            }
            movement[1] += moved;
            if motion.phase.is_contact() {
                movement[0] += moved;
            }
        }
        movement
    }
}
