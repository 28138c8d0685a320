//! The path of the tool with its forces.

use crate::geometry::{Point3, Pose, Vector2, Vector3};

/// A sample of a log: tool pose and force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TouchSample {
    /// Time \[s\]; later than that of the sample before.
    pub time: f64,
    /// Pose of the tool in the world; the tool centre point is the origin of its frame.
    pub world_from_tool: Pose,
    /// Force of the environment on the tool, in the axes of the world \[N\].
    pub force: Vector3,
}

impl TouchSample {
    /// Returns a sample: time \[s\], pose of the tool in the world, force on the tool in the axes of the world \[N\].
    ///
    /// ```
    /// use wisch::geometry::{Pose, Vector3};
    /// use wisch::interpret::TouchSample;
    /// // A tool that lies still and is pushed up with 10 N.
    /// let sample = TouchSample::new(0.5, Pose::translation(0.6, 0.0, 0.75), Vector3::new(0.0, 0.0, 10.0));
    /// assert_eq!(sample.time, 0.5);
    /// ```
    pub const fn new(time: f64, world_from_tool: Pose, force: Vector3) -> Self {
        Self {
            time,
            world_from_tool,
            force,
        }
    }
}

/// Classification of a piece of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Touch {
    /// Off the fitted plane, without force.
    Free,
    /// On the fitted plane with f′ below the confident band: a share of the particles responds.
    Weak,
    /// On the fitted plane with f′ in the confident band (10) or above it.
    Confident,
    /// A contact-like force off the plane: another object or a person pushes (Fig. 18).
    FalsePositive,
}

/// Consecutive samples as one piece, of at most a few milliseconds or a fraction of a millimetre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPiece {
    /// Time of the first and of the last sample \[s\].
    pub time: [f64; 2],
    /// The tool centre point at the last sample, in the frame of the believed surface \[m\].
    pub position: Point3,
    /// Yaw of the tool about the surface normal at the last sample \[rad\].
    pub heading: f64,
    /// Mean force of the tool on the surface along its outward normal, with the bias subtracted \[N\]: negative where the
    /// tool presses, as f_ext,n in (9).
    pub normal_force: f64,
    /// Mean tangential force \[N\].
    pub tangential_force: f64,
    /// f′ (9), at least 0: force over the nominal force, or over the usual press force of this log if it differs. At
    /// most 1, or the declared nominal force over the usual one if that is smaller.
    pub normalized_force: f64,
    /// Mean distance of the tool centre point from the fitted plane \[m\], positive on the outside; from the believed
    /// surface if no plane was found. A compliant tool touches below its compression depth.
    pub height: f64,
    /// Slope of the fitted plane against the tool's underside at the last sample, in the tool frame \[1\]: rise of the
    /// surface towards the hand per metre along the tool's x and y. A compliant tool presses harder where it rises.
    /// Zero if no plane was found.
    pub slope: Vector2,
    /// Classification of the piece.
    pub touch: Touch,
}

impl PathPiece {
    /// Whether the tool was on the fitted plane.
    pub const fn is_on_plane(&self) -> bool {
        matches!(self.touch, Touch::Weak | Touch::Confident)
    }
}

/// Plane fitted to the confident contacts (11), in the frame of the believed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedPlane {
    /// Point of the plane above the middle of the believed surface \[m\].
    pub point: Point3,
    /// Outward unit normal.
    pub normal: Vector3,
    /// Angle between the fitted normal and the believed one \[rad\].
    pub tilt: f64,
    /// Signed height of `point` over the believed surface \[m\].
    pub offset: f64,
    /// Number of directions along the surface in which the contacts spread far enough to determine a tilt: 2 for a full
    /// tilt, 1 for a tilt along a line, 0 for none. An undetermined tilt is 0.
    pub directions: usize,
    /// Number of confident positions on the plane.
    pub inliers: usize,
    /// Number of confident positions.
    pub confident: usize,
    /// Root mean square distance of the contacts used for the fit, weak ones included \[m\].
    pub rms: f64,
}
