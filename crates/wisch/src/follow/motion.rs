//! What following a plan gives: motions in the order of execution, and what had to be given up.

use super::{Trajectory, TrajectorySample};
use crate::geometry::{PlanarPose, Pose};
use crate::plan::Stroke;
use crate::robot::Range;

/// How finely movement is summed up [s].
const MOVEMENT_PERIOD: f64 = 0.01;

/// What a motion is for, and by that what may move and what the tool may touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Phase {
    /// The base moves to another placement, the arm holds still.
    Drive,
    /// The arm moves freely, the tool clear of the surface.
    FreeMotion,
    /// The tool moves over the surface at the height to which it is lifted between strokes.
    Lifted,
    /// The tool comes down to the surface.
    Lower,
    /// The tool wipes in contact: the stroke's number in [`Followed::strokes`].
    Wipe(usize),
    /// The tool comes off the surface.
    Lift,
}

impl Phase {
    /// Whether the tool touches the surface all the time.
    pub const fn is_contact(self) -> bool {
        matches!(self, Self::Wipe(_))
    }

    /// Index of the stroke in [`Followed::strokes`] that is wiped; `None` where nothing is.
    pub const fn stroke(self) -> Option<usize> {
        match self {
            Self::Wipe(stroke) => Some(stroke),
            _ => None,
        }
    }

    /// One word for people and files.
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

/// Where the tool is, in terms of the target surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolPose {
    /// Tool centre point and heading in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Height above the surface [m].
    pub height: f64,
    /// How far it leans about its tilt axis [rad]; 0 for tools that have none.
    pub tilt: f64,
}

impl ToolPose {
    /// The pose at share `s` of the way to another, 0 being here: position, height, heading and tilt change linearly, the
    /// heading without being wrapped to ±π.
    pub fn towards(&self, to: &Self, s: f64) -> Self {
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

    /// The same place, heading and tilt at a height above the surface [m].
    pub fn lifted(&self, height: f64) -> Self {
        Self { height, ..*self }
    }

    /// Way of the tool centre point to another pose [m].
    pub fn distance(&self, to: &Self) -> f64 {
        let flat = (to.surface_from_tool.position - self.surface_from_tool.position).norm();
        flat.hypot(to.height - self.height)
    }
}

/// How far the tool leaves its line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LineDeviation {
    /// Largest distance of the tool centre point [m].
    pub position: f64,
    /// Largest angle to the orientation that the line has there [rad].
    pub rotation: f64,
}

/// How far the second hand is from where the tool wants it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GripDeviation {
    /// Distance of the hand's outermost point from the grip [m].
    pub position: f64,
    /// How much further than allowed the hand leans on the bar [rad].
    pub lean: f64,
}

/// One motion from rest to rest.
#[derive(Debug, Clone)]
pub struct Motion {
    /// What it is for.
    pub phase: Phase,
    /// When it begins [s].
    pub start: f64,
    /// All n variables of the robot over time, from 0 to the motion's duration.
    pub trajectory: Trajectory,
    /// The corners of the tool's line, between which pose and height change linearly; empty where the
    /// tool follows no line.
    pub tool_line: Vec<ToolPose>,
}

impl Motion {
    /// When it ends [s], counted as `start` is from the beginning of all motions.
    pub fn end(&self) -> f64 {
        self.start + self.trajectory.duration()
    }
}

/// Why a way to a node was given up.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Obstruction {
    /// No configuration puts the tool there.
    #[error("out of reach by {position_error:.3} m and {rotation_error:.2} rad")]
    OutOfReach {
        /// How far the nearest configuration found is away [m].
        position_error: f64,
        /// How far it is turned away [rad].
        rotation_error: f64,
    },
    /// Out of reach because a joint has come to its limit.
    #[error("joint {joint:?} is at its limit of {} to {}", limits.lower, limits.upper)]
    JointLimit {
        /// The joint.
        joint: String,
        /// Its range [rad or m].
        limits: Range,
    },
    /// Two parts of the robot come too close.
    #[error("{a:?} comes within {distance:.4} m of {b:?}")]
    SelfCollision {
        /// One part.
        a: String,
        /// The other.
        b: String,
        /// Their distance [m], negative inside.
        distance: f64,
    },
    /// The robot or its tool comes too close to the scene.
    #[error("{body:?} comes within {distance:.4} m of {object:?}")]
    SceneCollision {
        /// Link or tool.
        body: String,
        /// Object of the scene.
        object: String,
        /// Their distance [m], negative inside.
        distance: f64,
    },
    /// The second hand does not reach its grip on the tool.
    #[error("the second hand is off its grip by {position_error:.3} m and {rotation_error:.2} rad")]
    SecondHand {
        /// How far the nearest configuration found is away [m].
        position_error: f64,
        /// How far it is turned away [rad].
        rotation_error: f64,
    },
    /// The next pose on the line needs a jump of the joints.
    #[error("joint {joint:?} would jump by {step:.3} between two poses of the line")]
    Jump {
        /// The joint that moves most.
        joint: String,
        /// How far [rad or m].
        step: f64,
    },
}

impl Obstruction {
    /// Where nothing is known but that there is no way.
    pub(super) const fn unreachable() -> Self {
        Self::OutOfReach {
            position_error: f64::INFINITY,
            rotation_error: f64::INFINITY,
        }
    }
}

/// One way of reaching a node that was tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// Rotation about the surface normal against the planned heading [rad].
    pub rotation: f64,
    /// Lean about the tool's tilt axis [rad].
    pub tilt: f64,
    /// How far along the edge it went, 0 to 1.
    pub progress: f64,
    /// What stopped it.
    pub obstruction: Obstruction,
}

/// A node that no way leads to.
#[derive(Debug, Clone, PartialEq)]
pub struct AbandonedNode {
    /// Its number in the graph.
    pub node: usize,
    /// The planned stroke in which it was to be passed.
    pub stroke: usize,
    /// What was tried.
    pub attempts: Vec<Attempt>,
}

/// Where the base stands while the tool wipes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Position and heading in the plane of the world's floor.
    pub world_from_base: PlanarPose,
    /// How well the rest of the path was expected to be in reach from here, 0 to 1.
    pub rating: f64,
}

/// A place that was rated for the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedPlace {
    /// Position and heading in the plane of the world's floor.
    pub world_from_base: PlanarPose,
    /// Share of the path that is in reach from here, 0 to 1; `None` where the robot cannot stand.
    pub rating: Option<f64>,
}

/// A plan as joint motion of a robot: trajectories for all its variables, one after the other, and what had to be given
/// up; paper §3.3.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The motions in order; each begins where and when the one before ends.
    pub motions: Vec<Motion>,
    /// The strokes as they are wiped, with the headings that were used; a planned stroke may be cut
    /// into several.
    pub strokes: Vec<Stroke>,
    /// Where the base stands, in order; empty for a robot that is bolted down.
    pub placements: Vec<Placement>,
    /// Places for the base that were rated for the whole path.
    pub rated: Vec<RatedPlace>,
    /// How amply each node of the plan's graph is in reach, by the capability map and from that of the placements that suits
    /// it best, 0 (from none) to 1: what extends the semantic directed graph. Empty without a map.
    pub node_reachability: Vec<f64>,
    /// Nodes that are not passed.
    pub abandoned: Vec<AbandonedNode>,
    /// The tool in the frame of the link that holds it.
    pub tip_from_tool: Pose,
}

impl Followed {
    /// Time from the start to the end of all motions [s].
    pub fn duration(&self) -> f64 {
        self.motions.last().map_or(0.0, Motion::end)
    }

    /// The motion that runs at a time [s]: the first before the start, the last after the end.
    pub fn motion_at(&self, time: f64) -> Option<&Motion> {
        self.motions.get(self.index_at(time))
    }

    /// The index of that motion.
    pub fn index_at(&self, time: f64) -> usize {
        let next = self.motions.partition_point(|motion| motion.start <= time);
        next.saturating_sub(1)
    }

    /// The state of all n variables at a time [s]; at rest before the start and after the end.
    /// `None` if nothing moves.
    pub fn sample(&self, time: f64) -> Option<TrajectorySample> {
        let motion = self.motion_at(time)?;
        let sample = motion.trajectory.sample(time - motion.start);
        Some(TrajectorySample { time, ..sample })
    }

    /// The same after other motions, which come first.
    #[must_use]
    pub fn preceded_by(mut self, first: Vec<Motion>) -> Self {
        let begin = first.last().map_or(0.0, Motion::end);
        for motion in &mut self.motions {
            motion.start += begin;
        }
        self.motions.splice(0..0, first);
        self
    }

    /// Time during which the tool wipes [s].
    pub fn contact_time(&self) -> f64 {
        self.contact_time_until(f64::INFINITY)
    }

    /// Time during which the tool wipes, of a motion that is broken off at a time [s].
    pub fn contact_time_until(&self, end: f64) -> f64 {
        let contact = self.motions.iter().filter(|m| m.phase.is_contact());
        contact.fold(0.0, |sum, motion| {
            sum + (end - motion.start).clamp(0.0, motion.trajectory.duration())
        })
    }

    /// How far some of the variables move, the length of their way in joint space: while the tool wipes, and in all [rad].
    pub fn joint_movement(&self, variables: &[usize]) -> [f64; 2] {
        self.joint_movement_until(variables, f64::INFINITY)
    }

    /// The same of a motion that is broken off at a time [s].
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
