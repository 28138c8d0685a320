//! What touch tells: contact, the plane of the real surface, events, and the estimated effect.

use super::Belief;
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

/// How a piece of the path was judged.
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
    /// f′ in [0, 1] (9).
    pub normalized_force: f64,
    /// Mean distance of the tool centre point from the fitted plane, positive outside [m]; from the believed
    /// surface where no plane was found. A tool that gives way touches from its compression depth down.
    pub height: f64,
    /// Slope of the fitted plane against the tool's underside at the last sample, in the frame of the tool [1]:
    /// by how much the surface rises towards the hand per metre along the tool's x and y. Where it rises, a
    /// tool that gives way presses harder. Zero where no plane was found.
    pub slope: Vector2,
    /// What it was judged to be.
    pub touch: Touch,
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
    /// Confident positions that it was fitted to.
    pub inliers: usize,
    /// Confident positions in all.
    pub confident: usize,
    /// Root mean square distance of the inliers [m].
    pub rms: f64,
}

/// What is to be made of the fitted plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Diagnosis {
    /// The surface is where it was believed.
    Localized,
    /// The surface is elsewhere: recovery plans on this pose of it.
    Relocalize {
        /// Where the surface is.
        world_from_surface: Pose,
    },
    /// Too few confident contacts for a plane: nothing can be said.
    NoContact,
}

/// What happened during an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EventKind {
    /// The tool was in contact.
    Contact,
    /// Between contacts of one stroke, the tool lost the surface.
    ContactLoss,
    /// Something pushed the tool off the plane or along it, with forces that are not those of wiping.
    Collision,
    /// The tool stuck and slipped.
    StickSlip,
    /// Phase: the tool came to the surface for the first time.
    Approach,
    /// Phase: the tool wiped, without being lifted.
    Stroke,
    /// Phase: the tool was lifted, and moved to the next stroke.
    Lift,
    /// Phase: the tool left the surface for the last time.
    Retreat,
}

impl EventKind {
    /// Whether it tells what the tool was about; such events follow one another over all of the log.
    ///
    /// ```
    /// use wisch::interpret::EventKind;
    ///
    /// assert!(EventKind::Stroke.is_phase());
    /// assert!(!EventKind::Contact.is_phase());
    /// ```
    pub const fn is_phase(self) -> bool {
        match self {
            Self::Approach | Self::Stroke | Self::Lift | Self::Retreat => true,
            Self::Contact | Self::ContactLoss | Self::Collision | Self::StickSlip => false,
        }
    }
}

/// Something that happened, with its evidence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// From [s].
    pub start: f64,
    /// To [s].
    pub end: f64,
    /// How many samples show it.
    pub samples: usize,
    /// Mean normal force [N], negative where the tool presses.
    pub mean_normal_force: f64,
    /// Largest size of the force [N].
    pub peak_force: f64,
    /// Largest distance from the fitted plane [m].
    pub peak_height: f64,
}

/// A share with a 90 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Mean over the replays.
    pub mean: f64,
    /// 5th percentile, less what the model leaves out.
    pub low: f64,
    /// 95th percentile, and what the model leaves out.
    pub high: f64,
}

impl Estimate {
    /// With an interval longer by a margin at either end, within 0 to 1.
    pub(super) fn widened(self, margin: f64) -> Self {
        Self {
            mean: self.mean,
            low: (self.low - margin).clamp(0.0, 1.0),
            high: (self.high + margin).clamp(0.0, 1.0),
        }
    }
}

/// What a log says.
#[derive(Debug, Clone)]
pub struct Interpretation {
    /// The path in pieces.
    pub path: Vec<PathPiece>,
    /// The plane, if there were contacts enough.
    pub plane: Option<FittedPlane>,
    /// Whether the surface is where it was believed.
    pub diagnosis: Diagnosis,
    /// What happened, by start.
    pub events: Vec<Event>,
    /// Bias of the normal force that was found in free motion and taken off [N].
    pub force_bias: f64,
    /// Time in contact over the time that the tool was on or near the surface.
    pub contact_share: f64,
    /// Where the dirt now is believed to lie.
    pub belief: Belief,
    /// The performance over the replays.
    pub performance: Estimate,
}
