//! Poses in space and in the plane of a surface.

use super::{Point2, Vector2};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use std::f64::consts::{PI, TAU};

/// A rigid transform in space; variable names state its frames: `world_from_surface * point_in_surface`.
pub type Pose = nalgebra::Isometry3<f64>;

/// Returns a pose as seven numbers: x, y, z \[m\], then the unit quaternion x, y, z, w. Files, the executor protocol and
/// pages have this form.
///
/// ```
/// use wisch_robot::geometry::{Pose, flatten_pose, restore_pose};
/// let world_from_tool = Pose::translation(0.1, 0.2, 0.3);
/// let numbers = flatten_pose(&world_from_tool);
/// assert_eq!(numbers, [0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0]);
/// assert_eq!(restore_pose(&numbers), world_from_tool);
/// ```
pub fn flatten_pose(pose: &Pose) -> [f64; 7] {
    let (p, q) = (pose.translation.vector, pose.rotation.coords);
    [p.x, p.y, p.z, q.x, q.y, q.z, q.w]
}

/// Returns the pose of seven numbers, in the order of [`flatten_pose`]. The quaternion is normalised.
pub fn restore_pose(&[x, y, z, i, j, k, w]: &[f64; 7]) -> Pose {
    Pose::from_parts(
        Translation3::new(x, y, z),
        UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k)),
    )
}

/// Pose of a tool in the plane of the surface: position of its tool centre point, and yaw.
///
/// The yaw `heading` is the angle \[rad\] from the surface's x axis to the tool's x axis. The
/// tool's y axis is its broad side, so a tool wipes best when it moves in the direction of its yaw.
///
/// ```
/// use wisch_robot::geometry::{PlanarPose, Point2};
/// let surface_from_tool = PlanarPose::new(Point2::new(1.0, 0.0), std::f64::consts::FRAC_PI_2);
/// let tip_in_surface = surface_from_tool.transform(Point2::new(0.5, 0.0));
/// assert!((tip_in_surface - Point2::new(1.0, 0.5)).norm() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanarPose {
    /// Tool centre point in the surface frame \[m\].
    pub position: Point2,
    /// Yaw: angle of the tool's x axis in the surface frame \[rad\].
    pub heading: f64,
}

impl PlanarPose {
    /// Returns a pose with position \[m\] and yaw \[rad\].
    pub const fn new(position: Point2, heading: f64) -> Self {
        Self { position, heading }
    }

    /// Maps a point of the tool frame into the surface frame.
    pub fn transform(&self, point_in_tool: Point2) -> Point2 {
        let (sin, cos) = self.heading.sin_cos();
        Point2::new(
            self.position.x + cos * point_in_tool.x - sin * point_in_tool.y,
            self.position.y + sin * point_in_tool.x + cos * point_in_tool.y,
        )
    }

    /// Maps a point of the surface frame into the tool frame.
    pub fn inverse_transform(&self, point_in_surface: Point2) -> Point2 {
        let (sin, cos) = self.heading.sin_cos();
        let d: Vector2 = point_in_surface - self.position;
        Point2::new(cos * d.x + sin * d.y, -sin * d.x + cos * d.y)
    }
}

/// Returns the equal angle in (−π, π] \[rad\].
pub fn wrap_angle(angle: f64) -> f64 {
    let wrapped = angle.rem_euclid(TAU);
    if wrapped > PI { wrapped - TAU } else { wrapped }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn inverse_undoes_transform(x in -5.0..5.0, y in -5.0..5.0, h in -10.0..10.0, u in -1.0..1.0, v in -1.0..1.0) {
            let surface_from_tool = PlanarPose::new(Point2::new(x, y), h);
            let point_in_tool = Point2::new(u, v);
            let back = surface_from_tool.inverse_transform(surface_from_tool.transform(point_in_tool));
            prop_assert!((back - point_in_tool).norm() < 1e-12);
        }

        #[test]
        fn wrapped_angles_are_equal_modulo_a_turn(a in -100.0..100.0) {
            let w = wrap_angle(a);
            prop_assert!(w > -PI && w <= PI);
            prop_assert!(((w - a) / TAU - ((w - a) / TAU).round()).abs() < 1e-9);
        }
    }
}
