//! The virtual joint of an SRDF, which joins the root of a robot to the world. A planar one is a base that drives.

use super::repair::Repaired;
use super::urdf::{Reader, elements};
use super::xml::escape;
use roxmltree::{Document, Node};

/// Kind of a virtual joint that is a base that drives.
const PLANAR: &str = "planar";
/// Limits of a base that a virtual joint declares, as an SRDF has none: velocity [m/s and rad/s], acceleration \[m/s² and
/// rad/s²\], effort [N and Nm].
pub const ASSUMED_BASE_LIMITS: [f64; 3] = [0.5, 1.0, 10_000.0];

/// A virtual joint of an SRDF: how the root of the robot is joined to the world.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VirtualJoint {
    /// Name of the joint.
    pub name: String,
    /// Kind: `fixed`, `planar` or `floating`.
    pub kind: String,
    /// Frame of the world, which becomes the root of the robot.
    pub parent_frame: String,
    /// The root link of the URDF.
    pub child_link: String,
}

impl VirtualJoint {
    /// Returns the planar base of a robot whose URDF has this root link.
    pub fn planar(root_link: &str) -> Self {
        Self {
            name: "base".to_owned(),
            kind: PLANAR.to_owned(),
            parent_frame: "odom".to_owned(),
            child_link: root_link.to_owned(),
        }
    }

    /// Whether it is a base that drives.
    pub fn is_planar(&self) -> bool {
        self.kind == PLANAR
    }

    /// Returns the URDF with this planar joint between the parent frame, as the new root, and its child link. The joint has
    /// the [`ASSUMED_BASE_LIMITS`].
    /// The lines of the text keep their numbers. `None` if the joint is not planar, if its child is not the root link,
    /// or if the text is no URDF or has a link or joint of its name already.
    ///
    /// ```
    /// use wisch_robot::{RobotModel, VirtualJoint};
    /// let urdf = r#"<robot name="cart"><link name="base_link"/></robot>"#;
    /// let whole = VirtualJoint::planar("base_link").carry(urdf).unwrap();
    /// let robot = RobotModel::from_urdf("cart.urdf", &whole, &mut |_| Err("no meshes".into()))?;
    /// assert_eq!(robot.dof(), 3); // x, y and theta
    /// assert_eq!(VirtualJoint::planar("wheel").carry(urdf), None);
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    pub fn carry(&self, urdf: &str) -> Option<String> {
        let repaired = Repaired::new(urdf);
        let document = Reader::new("", &repaired.text).document().ok()?;
        let root = document.root_element();
        let parents = elements(root, "joint").filter_map(|joint| {
            let child = elements(joint, "child").next()?;
            child.attribute("link")
        });
        let has = |kind: &'static str, name: &str| {
            elements(root, kind).any(|node| node.attribute("name") == Some(name))
        };
        let is_root = has("link", &self.child_link)
            && parents.into_iter().all(|child| child != self.child_link);
        let is_new = !has("link", &self.parent_frame) && !has("joint", &self.name);
        if !(self.is_planar() && is_root && is_new) {
            return None;
        }
        let end = root.range().start + urdf[root.range()].rfind("</")?;
        let [name, parent, child] =
            [&self.name, &self.parent_frame, &self.child_link].map(|name| escape(name));
        let [velocity, acceleration, effort] = ASSUMED_BASE_LIMITS;
        let base = format!(
            "<link name=\"{parent}\"/><joint name=\"{name}\" type=\"{PLANAR}\"><parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"0 0 1\"/><limit velocity=\"{velocity}\" acceleration=\"{acceleration}\" effort=\"{effort}\"/></joint>"
        );
        Some([&urdf[..end], &base, &urdf[end..]].concat())
    }
}

/// Returns the URDF of a robot on the base that its SRDF declares: with the planar virtual joint, if it has one that joins
/// the root link to the world, otherwise as it is. A text that is no SRDF declares nothing.
///
/// ```
/// let urdf = r#"<robot name="cart"><link name="base_link"/></robot>"#;
/// let srdf = r#"<robot name="cart">
///   <virtual_joint name="world_joint" type="planar" parent_frame="odom" child_link="base_link"/>
/// </robot>"#;
/// assert!(wisch_robot::urdf_on_base(urdf, srdf).contains(r#"<joint name="world_joint" type="planar">"#));
/// assert_eq!(wisch_robot::urdf_on_base(urdf, &srdf.replace("planar", "fixed")), urdf);
/// ```
pub fn urdf_on_base(urdf: &str, srdf: &str) -> String {
    let repaired = Repaired::new(srdf);
    let document = Reader::new("", &repaired.text).document();
    let carried = document.ok().and_then(|document| {
        let joints = virtual_joints(&document);
        joints.into_iter().find_map(|(_, joint)| joint.carry(urdf))
    });
    carried.unwrap_or_else(|| urdf.to_owned())
}

/// Returns the virtual joints of an SRDF that have all attributes, with their elements.
pub(super) fn virtual_joints<'a, 'i>(
    document: &'a Document<'i>,
) -> Vec<(Node<'a, 'i>, VirtualJoint)> {
    let joints = elements(document.root_element(), "virtual_joint").filter_map(|node| {
        let text = |name: &str| node.attribute(name).map(|text| text.trim().to_owned());
        let joint = VirtualJoint {
            name: text("name")?,
            kind: text("type")?,
            parent_frame: text("parent_frame")?,
            child_link: text("child_link")?,
        };
        Some((node, joint))
    });
    joints.collect()
}
