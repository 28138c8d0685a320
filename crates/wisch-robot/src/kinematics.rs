//! Forward kinematics and Jacobians of all links.

use super::model::motion;
use super::{JointKind, LinkId, RobotError, RobotModel};
use crate::geometry::{Point3, Pose, Vector3};
use nalgebra::{Matrix6xX, Vector6};

/// Poses of all links of a robot at a configuration.
///
/// | | meaning | shape |
/// |---|---|---|
/// | [`world_from_link`](Self::world_from_link) | pose of a link in the world | pose |
/// | [`jacobian`](Self::jacobian) | velocity of a point of a link, per velocity of the variables | 6 × n |
#[derive(Debug, Clone)]
pub struct Kinematics<'a> {
    pub(super) model: &'a RobotModel,
    world_from_link: Vec<Pose>,
}

impl RobotModel {
    /// Computes the poses of all links at positions `q` (n) [rad or m]. Limits are not checked.
    ///
    /// ```
    /// # use wisch_robot::RobotModel;
    /// # let text = r#"<robot name="r"><link name="wall"/><link name="rod"/>
    /// #   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 0 1"/></joint>
    /// # </robot>"#;
    /// # let robot = RobotModel::from_urdf("r", text, &mut |_| Err(String::new()))?;
    /// use wisch_robot::geometry::Point3;
    /// let kinematics = robot.forward_kinematics(&[std::f64::consts::FRAC_PI_2])?;
    /// let rod = robot.link("rod")?;
    /// let tip_in_rod = Point3::new(2.0, 0.0, 0.0);
    /// let tip_in_world = kinematics.world_from_link(rod) * tip_in_rod;
    /// assert!((tip_in_world - Point3::new(0.0, 2.0, 0.0)).norm() < 1e-12);
    /// // At 1 rad/s it moves at 2 m/s along −x and rotates at 1 rad/s about z.
    /// let per_velocity = kinematics.jacobian(rod, tip_in_rod);
    /// assert!((per_velocity[(0, 0)] + 2.0).abs() < 1e-12);
    /// assert!((per_velocity[(5, 0)] - 1.0).abs() < 1e-12);
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    pub fn forward_kinematics(&self, q: &[f64]) -> Result<Kinematics<'_>, RobotError> {
        self.check_values("positions", q)?;
        let mut world_from_link = Vec::with_capacity(self.links().len());
        world_from_link.push(Pose::identity());
        for joint in self.joints() {
            let parent_from_child =
                joint.parent_from_joint * motion(joint, joint.drive.position(q));
            world_from_link.push(world_from_link[joint.parent.0] * parent_from_child);
        }
        Ok(Kinematics {
            model: self,
            world_from_link,
        })
    }
}

impl Kinematics<'_> {
    /// Returns the pose of a link in the world, which is the frame of the root link.
    ///
    /// # Panics
    /// If the link belongs to another, larger robot.
    pub fn world_from_link(&self, link: LinkId) -> Pose {
        self.world_from_link[link.0]
    }

    /// Returns the Jacobian of a point of a link, 6 × n. The column of a variable is the velocity of the point (rows
    /// 0–2) [m/s] and the angular velocity of the link (rows 3–5) [rad/s] in the world, per unit velocity of that
    /// variable.
    ///
    /// # Panics
    /// If the link belongs to another, larger robot.
    pub fn jacobian(&self, link: LinkId, point_in_link: Point3) -> Matrix6xX<f64> {
        let mut jacobian = Matrix6xX::zeros(self.model.dof());
        let point = self.world_from_link[link.0] * point_in_link;
        let mut at = link;
        while let Some(id) = self.model.links()[at.0].parent {
            let joint = &self.model.joints()[id.0];
            let column = self.joint_column(id.0, point);
            for &(variable, factor) in &joint.drive.terms {
                jacobian.column_mut(variable).axpy(factor, &column, 1.0);
            }
            at = joint.parent;
        }
        jacobian
    }

    /// Axis of a joint in the world.
    pub(super) fn world_axis(&self, joint: usize) -> Vector3 {
        let joint = &self.model.joints()[joint];
        self.world_from_link[joint.child.0].rotation * joint.axis.into_inner()
    }

    /// Returns the velocity of a point in the world, linear first, when only this joint moves, at unit speed.
    pub(super) fn joint_column(&self, joint: usize, point: Point3) -> Vector6<f64> {
        let axis = self.world_axis(joint);
        let joint = &self.model.joints()[joint];
        let origin = self.world_from_link[joint.child.0].translation.vector;
        let (linear, angular) = match joint.kind {
            JointKind::Revolute => (axis.cross(&(point.coords - origin)), axis),
            JointKind::Prismatic => (axis, Vector3::zeros()),
            JointKind::Fixed => (Vector3::zeros(), Vector3::zeros()),
        };
        Vector6::new(
            linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
        )
    }
}
