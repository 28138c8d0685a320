//! The path of the tool, and what it felt on its way.

use crate::geometry::{Point3, Pose, Vector2, Vector3};

/// Where a tool was and what force it felt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TouchSample {
    /// Time [s]; later than that of the sample before.
    pub time: f64,
    /// The tool in the world, its tool centre point at the origin of its frame.
    pub world_from_tool: Pose,
    /// Force of the surroundings on the tool, in the axes of the world [N].
    pub force: Vector3,
}

impl TouchSample {
    /// At a time [s] the tool was there and felt this force [N].
    pub const fn new(time: f64, world_from_tool: Pose, force: Vector3) -> Self {
        Self {
            time,
            world_from_tool,
            force,
        }
    }
}

/// How a piece of the path was classified.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Touch {
    /// Away from the fitted plane, without force.
    Free,
    /// On the fitted plane, f′ below the confident band: a share of the effect.
    Weak,
    /// On the fitted plane with f′ in the confident band (10), or above it.
    Confident,
    /// A force like that of contact, but off the plane: something else pushes (Fig. 18).
    FalsePositive,
}

/// Some consecutive samples as one: at most a few milliseconds or a fraction of a millimetre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPiece {
    /// First and last time [s].
    pub time: [f64; 2],
    /// The tool centre point at the last sample, in the frame of the believed surface [m].
    pub position: Point3,
    /// Heading of the tool about the surface normal at the last sample [rad].
    pub heading: f64,
    /// Mean force of the tool on the surface along its outward normal, the bias taken off [N]: negative
    /// where it presses, as f_ext,n in (9).
    pub normal_force: f64,
    /// Mean size of the force along the surface [N].
    pub tangential_force: f64,
    /// f′ (9), at least 0: over the nominal force, or over that with which the tool mostly pressed in this log if it is
    /// another. At most 1, or the declared nominal force over that one if it is smaller.
    pub normalized_force: f64,
    /// Mean distance of the tool centre point from the fitted plane, positive outside [m]; from the believed
    /// surface where no plane was found. A tool that gives way touches from its compression depth down.
    pub height: f64,
    /// Slope of the fitted plane against the tool's underside at the last sample, in the frame of the tool [1]:
    /// by how much the surface rises towards the hand per metre along the tool's x and y. Where it rises, a
    /// tool that gives way presses harder. Zero where no plane was found.
    pub slope: Vector2,
    /// How it was classified.
    pub touch: Touch,
}

impl PathPiece {
    /// Whether the tool was on the fitted plane.
    pub const fn is_on_plane(&self) -> bool {
        matches!(self.touch, Touch::Weak | Touch::Confident)
    }
}

/// The plane of confident contacts (11), in the frame of the believed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedPlane {
    /// A point of it, above the middle of the believed surface [m].
    pub point: Point3,
    /// Its outward unit normal.
    pub normal: Vector3,
    /// Angle between its normal and the believed one [rad].
    pub tilt: f64,
    /// Signed height of `point` over the believed surface [m].
    pub offset: f64,
    /// In how many directions along the surface the contacts spread far enough to tell a tilt: 2 tell it, 1 tells it
    /// along their line only, 0 not at all. Where nothing tells it, it counts as none.
    pub directions: usize,
    /// Confident positions on it.
    pub inliers: usize,
    /// Confident positions in all.
    pub confident: usize,
    /// Root mean square distance of the contacts that it was fitted to, weaker ones included [m].
    pub rms: f64,
}
