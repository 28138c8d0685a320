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

/// Consecutive samples as one piece: at most 10 ms, 1 mm of travel and 2° of rotation, and more in
/// very long logs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPiece {
    /// Time of the first and of the last sample \[s\]; the piece represents the time [`span`](Self::span).
    pub time: [f64; 2],
    /// The tool centre point at the last sample, in the frame of the believed surface \[m\]; on a curved surface that
    /// lies elsewhere, in the chart of the surface at its fitted pose.
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
    /// Mean distance of the tool centre point from the fitted plane \[m\], positive on the outer
    /// side; from the believed surface if no plane was found. A compliant tool is in contact at
    /// heights below its compression.
    pub height: f64,
    /// Slope of the fitted plane against the tool's underside at the last sample, in the tool frame \[1\]: rise of the
    /// surface towards the hand per metre along the tool's x and y. A compliant tool presses harder where it rises.
    /// Zero if no plane was found.
    pub slope: Vector2,
    /// Classification of the piece.
    pub touch: Touch,
}

/// Longest time that a piece represents before its first sample and after its last sample [s]. The
/// rest of a longer gap belongs to no piece.
const LONGEST_REACH: f64 = 0.5;

impl PathPiece {
    /// Whether the tool was on the fitted plane.
    pub const fn is_on_plane(&self) -> bool {
        matches!(self.touch, Touch::Weak | Touch::Confident)
    }

    /// Whether the tool is in contact: on the fitted plane, with at least this share of the nominal force \[1\].
    ///
    /// [`Interpretation::contact_share`](crate::interpret::Interpretation::contact_share) counts such pieces, with the
    /// second number of [`EventConfig::contact_share`](crate::interpret::EventConfig::contact_share).
    pub fn is_in_contact(&self, least_share: f64) -> bool {
        self.is_on_plane() && self.normalized_force >= least_share
    }

    /// Returns the time that a piece of a path represents \[s\]: from half way to the piece before, to half way to the
    /// next one.
    ///
    /// A piece of a slow log has a single sample, but represents the time between two samples. Next to a gap, a piece
    /// represents at most 0.5 s of it.
    ///
    /// # Panics
    /// If the path has no piece of this index.
    ///
    /// ```
    /// use wisch::interpret::{PathPiece, Touch};
    /// # use wisch::geometry::{Point3, Vector2};
    /// # let piece = |time: f64| PathPiece {
    /// #     time: [time, time],
    /// #     position: Point3::origin(),
    /// #     heading: 0.0,
    /// #     normal_force: -10.0,
    /// #     tangential_force: 0.0,
    /// #     normalized_force: 1.0,
    /// #     height: 0.0,
    /// #     slope: Vector2::zeros(),
    /// #     touch: Touch::Confident,
    /// # };
    /// // Samples at 10 Hz, a piece each.
    /// let path = [piece(1.0), piece(1.1), piece(1.2)];
    /// let [start, end] = PathPiece::span(&path, 1);
    /// assert!((start - 1.05).abs() < 1e-12 && (end - 1.15).abs() < 1e-12);
    /// ```
    pub fn span(path: &[Self], index: usize) -> [f64; 2] {
        let [first, last] = path[index].time;
        let before = index.checked_sub(1).map_or(first, |i| path[i].time[1]);
        let after = path.get(index + 1).map_or(last, |next| next.time[0]);
        [
            (0.5 * (before + first)).max(first - LONGEST_REACH),
            (0.5 * (last + after)).min(last + LONGEST_REACH),
        ]
    }

    /// Returns the duration of the time that a piece of a path represents \[s\]; see [`span`](Self::span).
    ///
    /// # Panics
    /// If the path has no piece of this index.
    pub fn duration(path: &[Self], index: usize) -> f64 {
        let [start, end] = Self::span(path, index);
        end - start
    }
}

/// Plane fitted to the confident contacts (11), in the frame of the believed surface; for a curved surface, the plane that
/// touches it at its fitted pose.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(time: [f64; 2]) -> PathPiece {
        PathPiece {
            time,
            position: Point3::origin(),
            heading: 0.0,
            normal_force: -10.0,
            tangential_force: 0.0,
            normalized_force: 1.0,
            height: 0.0,
            slope: Vector2::zeros(),
            touch: Touch::Confident,
        }
    }

    #[test]
    fn pieces_share_the_time_between_them_but_not_a_gap() {
        let path = [[1.0, 1.0], [1.5, 1.75], [10.0, 10.0]].map(piece);
        let spans = [0, 1, 2].map(|i| PathPiece::span(&path, i));
        assert_eq!(spans, [[1.0, 1.25], [1.25, 2.25], [9.5, 10.0]]);
        assert_eq!(PathPiece::duration(&path, 1), 1.0);
        assert_eq!(PathPiece::duration(&path[..1], 0), 0.0);
    }
}
