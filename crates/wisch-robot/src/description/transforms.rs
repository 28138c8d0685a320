//! Where the links of a URDF are in one another, whatever else it says.

use super::elements::Urdf;
use crate::RobotError;
use crate::geometry::{Pose, Vector3};
use nalgebra::{Translation3, UnitQuaternion, UnitVector3};

/// How a joint moves the link that it holds, in the frame of the joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointMotion {
    /// Not at all.
    Fixed,
    /// It turns it about an axis, by the joint's position [rad].
    Revolute(UnitVector3<f64>),
    /// It slides it along an axis, by the joint's position [m].
    Prismatic(UnitVector3<f64>),
}

/// Where a link is in the one that it hangs on, by the position of the joint between them.
#[derive(Debug, Clone, PartialEq)]
pub struct JointTransform {
    /// The joint's name.
    pub joint: String,
    /// The link that holds the other.
    pub parent: String,
    /// The link that is held.
    pub child: String,
    /// The held link in the frame of the other, where the joint's position is 0.
    pub parent_from_joint: Pose,
    /// How it moves.
    pub motion: JointMotion,
    /// How it follows others, if it does.
    pub mimic: Option<JointMimic>,
}

/// A joint's position by those of others: `offset + Σ factor · position`.
#[derive(Debug, Clone, PartialEq)]
pub struct JointMimic {
    /// Its position where those are 0 [rad or m].
    pub offset: f64,
    /// The others by name, with their factors.
    pub terms: Vec<(String, f64)>,
}

impl JointTransform {
    /// The held link in the frame of the other, at a position of the joint [rad or m].
    pub fn at(&self, position: f64) -> Pose {
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

/// What the joints of a URDF make of their positions, whatever else it says: of a stranger's robot whose meshes are not
/// at hand, too. Joints of other kinds than fixed, revolute, continuous and prismatic are left out.
///
/// ```
/// let urdf = r#"<robot name="lift"><link name="floor"/><link name="table"/>
///     <joint name="spindle" type="prismatic"><parent link="floor"/><child link="table"/>
///     <origin xyz="0 0 0.4"/><axis xyz="0 0 1"/><limit lower="0" upper="1" velocity="1" effort="1"/></joint></robot>"#;
/// let joints = wisch_robot::joint_transforms("lift.urdf", urdf)?;
/// assert_eq!(joints[0].at(0.1).translation.z, 0.5);
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
///
/// # Errors
/// If the text is no URDF or larger than is read.
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
