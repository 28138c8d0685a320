//! Motion of a tool in contact.

use crate::geometry::{PlanarPose, Vector2};

/// Distance kept between a carried particle and the footprint [m], so that rounding never puts it back under the tool.
pub(super) const CLEARANCE: f64 = 1e-9;

/// A motion of the tool in contact: position and yaw change linearly from one pose to the other.
///
/// The rotation is `to.heading - from.heading`, not wrapped, so the caller chooses its direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolMotion {
    /// Pose of the tool in the surface frame at the beginning.
    pub from: PlanarPose,
    /// Pose of the tool in the surface frame at the end.
    pub to: PlanarPose,
}

impl ToolMotion {
    /// Returns the direction of travel (a unit vector; x if there is no travel) and the distance \[m\].
    pub fn travel(&self) -> (Vector2, f64) {
        let travel: Vector2 = self.to.position - self.from.position;
        let length = travel.norm();
        if length > 0.0 {
            (travel / length, length)
        } else {
            (Vector2::x(), 0.0)
        }
    }

    /// Rotation of the tool, positive counter-clockwise \[rad\].
    pub fn turn(&self) -> f64 {
        self.to.heading - self.from.heading
    }
}
