//! Transforms between the links of a URDF, independent of everything else in it.

use super::elements::Urdf;
use crate::RobotError;
use crate::geometry::{Pose, Vector3};
use nalgebra::{Translation3, UnitQuaternion, UnitVector3};

/// Motion of a joint's child link, in the frame of the joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointMotion {
    /// No motion.
    Fixed,
    /// Rotation about an axis by the joint's position \[rad\].
    Revolute(UnitVector3<f64>),
    /// Translation along an axis by the joint's position \[m\].
    Prismatic(UnitVector3<f64>),
}

/// Transform from a link to its parent, as a function of the joint's position.
#[derive(Debug, Clone, PartialEq)]
pub struct JointTransform {
    /// Name of the joint.
    pub joint: String,
    /// Parent link.
    pub parent: String,
    /// Child link.
    pub child: String,
    /// Pose of the child in the parent at position 0.
    pub parent_from_joint: Pose,
    /// Motion of the joint.
    pub motion: JointMotion,
    /// Rule by which it follows other joints; `None` if it is independent.
    pub mimic: Option<JointMimic>,
}

/// Position of a joint as a function of other joints: `offset + Σ factor · position`.
#[derive(Debug, Clone, PartialEq)]
pub struct JointMimic {
    /// Position of this joint if the positions of the other joints are 0 [rad or m].
    pub offset: f64,
    /// Names of the other joints, with their factors.
    pub terms: Vec<(String, f64)>,
}

impl JointTransform {
    /// Returns the pose of the child in the parent at a position of the joint [rad or m].
    pub fn parent_from_child(&self, position: f64) -> Pose {
        let moved = match self.motion {
            JointMotion::Fixed => Pose::identity(),
            JointMotion::Revolute(axis) => Pose::from_parts(
                Translation3::identity(),
                UnitQuaternion::from_axis_angle(&axis, position),
            ),
            JointMotion::Prismatic(axis) => Pose::from_parts(
                Translation3::from(axis.into_inner() * position),
                UnitQuaternion::identity(),
            ),
        };
        self.parent_from_joint * moved
    }
}

/// Returns the transforms of a URDF's joints, without checking anything else, so that it works without the robot's
/// meshes. Floating joints and joints of unknown types are left out.
///
/// ```
/// let urdf = r#"<robot name="lift"><link name="floor"/><link name="table"/>
///     <joint name="spindle" type="prismatic"><parent link="floor"/><child link="table"/>
///     <origin xyz="0 0 0.4"/><axis xyz="0 0 1"/><limit lower="0" upper="1" velocity="1" effort="1"/></joint></robot>"#;
/// let joints = wisch_robot::joint_transforms("lift.urdf", urdf)?;
/// assert_eq!(joints[0].parent_from_child(0.1).translation.z, 0.5);
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
///
/// # Errors
/// If the text is no URDF or exceeds a limit.
pub fn joint_transforms(file: &str, text: &str) -> Result<Vec<JointTransform>, RobotError> {
    let urdf = Urdf::read(file, text)?;
    let axis = |axis: Vector3| UnitVector3::try_new(axis, f64::MIN_POSITIVE);
    let mimics = &urdf.mimics;
    let joints = urdf.joints.iter().filter_map(|joint| {
        let motion = match joint.kind.as_str() {
            "fixed" => JointMotion::Fixed,
            "revolute" | "continuous" => JointMotion::Revolute(axis(joint.axis)?),
            "prismatic" => JointMotion::Prismatic(axis(joint.axis)?),
            _ => return None,
        };
        let mimic = mimics.iter().find(|mimic| mimic.joint == joint.name);
        Some(JointTransform {
            joint: joint.name.clone(),
            parent: joint.parent.clone(),
            child: joint.child.clone(),
            parent_from_joint: joint.parent_from_joint,
            motion,
            mimic: mimic.map(|mimic| JointMimic {
                offset: mimic.offset,
                terms: mimic.terms.clone(),
            }),
        })
    });
    Ok(joints.collect())
}
