//! The motion of a tool in contact.

use crate::geometry::{PlanarPose, Vector2};

/// Distance kept between a carried particle and the footprint, so that rounding never puts it back
/// under the tool [m].
pub(super) const CLEARANCE: f64 = 1e-9;

/// A motion of the tool in contact: position and heading change linearly from one pose to the other.
///
/// The turn is `to.heading - from.heading`, not wrapped: the caller chooses which way round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolMotion {
    /// Pose of the tool in the surface frame at the beginning.
    pub from: PlanarPose,
    /// Pose of the tool in the surface frame at the end.
    pub to: PlanarPose,
}

impl ToolMotion {
    /// Direction of travel (a unit vector; x where there is none) and distance travelled [m].
    pub fn travel(&self) -> (Vector2, f64) {
        let travel: Vector2 = self.to.position - self.from.position;
        let length = travel.norm();
        if length > 0.0 {
            (travel / length, length)
        } else {
            (Vector2::x(), 0.0)
        }
    }

    /// How far the tool turns on the way, positive counter-clockwise [rad].
    pub fn turn(&self) -> f64 {
        self.to.heading - self.from.heading
    }
}
