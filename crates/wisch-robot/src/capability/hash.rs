//! Hash that identifies robots with the same reach.

use crate::fnv::Fnv;
use crate::geometry::Pose;
use crate::{JointKind, RobotModel, Shape};
use std::fmt;

/// Hash of everything on which a robot's reach depends: the tree of links, the frames, axes and position limits of its
/// joints, and its collision shapes.
///
/// Lengths and rotations are rounded to 1e-9 (m, or of a unit quaternion). Comments, white space, masses, and velocity
/// and effort limits have no influence. The hash is FNV-1a with 128 bits (Fowler, Noll, Vo; IETF draft-eastlake-fnv);
/// it does not protect against deliberate collisions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct RobotHash(pub(super) [u8; 16]);

impl fmt::Display for RobotHash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", u128::from_le_bytes(self.0))
    }
}

impl Fnv {
    fn name(&mut self, name: &str) {
        self.count(name.len());
        self.bytes(name.as_bytes());
    }

    fn pose(&mut self, pose: &Pose) {
        pose.translation.vector.iter().for_each(|&v| self.number(v));
        // q and −q are the same rotation, and near w = 0 either may occur; the columns of the matrix are unique.
        let columns = pose.rotation.to_rotation_matrix();
        columns.matrix().iter().for_each(|&v| self.number(v));
    }
}

impl RobotHash {
    /// Returns the hash of a robot.
    ///
    /// ```
    /// # use wisch_robot::{RobotHash, RobotModel};
    /// let read = |text: &str| RobotModel::from_urdf("r", text, &mut |_| Err(String::new()));
    /// let arm = |upper: f64| format!(r#"<robot name="r"><link name="wall"/><link name="rod"/>
    ///     <joint name="pivot" type="revolute"><parent link="wall"/><child link="rod"/>
    ///       <limit lower="-1" upper="{upper}"/></joint></robot>"#);
    /// let hash = RobotHash::from_robot(&read(&arm(1.0))?);
    /// assert_eq!(hash, RobotHash::from_robot(&read(&arm(1.0).replace(' ', "  "))?));
    /// assert_ne!(hash, RobotHash::from_robot(&read(&arm(1.5))?));
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    pub fn from_robot(robot: &RobotModel) -> Self {
        let mut hash = Fnv::new();
        hash.count(robot.links().len());
        for link in robot.links() {
            hash.name(&link.name);
            hash.count(link.collision.len());
            for collision in &link.collision {
                hash.pose(&collision.link_from_shape);
                hash_shape(&mut hash, &collision.shape);
            }
        }
        for joint in robot.joints() {
            hash.name(&joint.name);
            hash.count(match joint.kind {
                JointKind::Fixed => 0,
                JointKind::Revolute => 1,
                JointKind::Prismatic => 2,
            });
            hash.count(joint.parent.index());
            hash.pose(&joint.parent_from_joint);
            joint.axis.iter().for_each(|&v| hash.number(v));
            hash.number(joint.drive.offset);
            hash.count(joint.drive.terms.len());
            for &(variable, factor) in &joint.drive.terms {
                hash.count(variable);
                hash.number(factor);
            }
            match joint.limits.position {
                None => hash.count(0),
                Some(range) => {
                    hash.count(1);
                    hash.number(range.lower);
                    hash.number(range.upper);
                }
            }
        }
        Self(hash.sum())
    }
}

fn hash_shape(hash: &mut Fnv, shape: &Shape) {
    match shape {
        Shape::Box { size } => {
            hash.count(0);
            size.iter().for_each(|&v| hash.number(v));
        }
        Shape::Cylinder { radius, length } => {
            hash.count(1);
            hash.number(*radius);
            hash.number(*length);
        }
        Shape::Capsule { radius, length } => {
            hash.count(2);
            hash.number(*radius);
            hash.number(*length);
        }
        Shape::Sphere { radius } => {
            hash.count(3);
            hash.number(*radius);
        }
        Shape::Mesh(mesh) => {
            hash.count(4);
            hash.mesh(mesh);
        }
    }
}
