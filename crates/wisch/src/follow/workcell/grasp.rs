//! How hands hold a tool, and the tool's shape in the hand.

use super::PlanningGroup;
use super::holder::HolderCylinder;
use crate::follow::FollowError;
use crate::geometry::{Mesh, Point3, Pose, Vector3};
use crate::represent::{Mount, Tool};
use crate::robot::setup::hand_extent;
use crate::robot::{DiagnosticKind, LinkAxis, LinkId, RobotModel, Srdf, Subject};
use nalgebra::{Translation3, UnitQuaternion};
use std::f64::consts::PI;
use std::fmt;

/// Largest distance of a hand from the tool that it holds [m].
const AT_TOOL: f64 = 0.02;

/// A tool as the robot holds it.
///
/// Its text says how, and what is assumed: `square on link "tool0", 0.103 m out of it (assumed)`.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldTool {
    /// Name of the link that holds the tool.
    pub link: String,
    /// The tool in the frame of that link.
    pub tip_from_tool: Pose,
    /// How the tool is held; `None` if its pose is given.
    pub mount: Option<Mount>,
    /// The link's axis that points out of the hand.
    pub axis: LinkAxis,
    /// Source of the mount: declared or assumed.
    pub source: MountSource,
    /// The holder between a flange and the tool at a declared distance from it, which collision checks include.
    pub holder: Option<HolderCylinder>,
    /// Distance between hand and tool at a declared grip, which collision checks do not include \[m\]; `None` where the
    /// tool is at the hand.
    pub unchecked_gap: Option<f64>,
}

/// Where the mount of a tool comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MountSource {
    /// The task, the knowledge base or the caller declares it.
    Declared,
    /// The SRDF has an end effector at the group's tip, and may give its lean over the tool.
    Srdf,
    /// Nothing declares it: the tool is square on the flange.
    Assumed,
}

impl HeldTool {
    /// Returns a tool at a declared pose in the frame of its link.
    pub(super) fn at_pose(robot: &RobotModel, tip: LinkId, tip_from_tool: Pose) -> Self {
        Self {
            link: robot.links()[tip.index()].name.clone(),
            tip_from_tool,
            mount: None,
            axis: LinkAxis::default(),
            source: MountSource::Declared,
            holder: None,
            unchecked_gap: None,
        }
    }

    /// Chooses how a group holds a tool: as the tool declares, else as the SRDF declares for the group's tip, else
    /// square on the flange.
    pub(super) fn choose(
        robot: &RobotModel,
        srdf: Option<&Srdf>,
        group: &PlanningGroup,
        tool: &Tool,
    ) -> Result<Self, FollowError> {
        let (mount, source) = match tool.mount {
            Some(mount) => (mount, MountSource::Declared),
            None => group.mount(srdf),
        };
        let known = srdf.and_then(|srdf| srdf.tool_holder(group.tip));
        let own_axis = match mount {
            Mount::Flange { axis, .. } => axis,
            Mount::Hand { .. } | Mount::Grip(_) => None,
        };
        let axis = own_axis
            .or_else(|| known.map(|holder| holder.axis))
            .unwrap_or_default();
        let is_distance_declared = matches!(
            mount,
            Mount::Flange {
                distance: Some(_),
                ..
            }
        );
        if !is_distance_declared {
            check_hand_shapes(robot, group.tip)?;
        }
        let hand = tip_from_hand(robot, group.tip, axis, &group.ready)?;
        let holder = match mount {
            Mount::Flange {
                distance: Some(face),
                holder_radius,
                ..
            } => HolderCylinder::between(hand.translation.vector.norm(), face, holder_radius, tool),
            _ => None,
        };
        let tip_from_tool = match mount {
            Mount::Flange { yaw, distance, .. } => {
                let at = |distance| axis.frame() * Pose::translation(0.0, 0.0, distance);
                distance.map_or(hand, at) * hold_square(tool, yaw)
            }
            Mount::Hand { lean } => hand * hold_rear_edge(tool, lean),
            Mount::Grip(grip) => hand * grip.tool_from_hand.inverse(),
        };
        let unchecked_gap = match mount {
            Mount::Grip(grip) => find_gap(tool, &grip.tool_from_hand),
            Mount::Flange { .. } | Mount::Hand { .. } => None,
        };
        Ok(Self {
            mount: Some(mount),
            axis,
            source,
            holder,
            unchecked_gap,
            ..Self::at_pose(robot, group.tip, tip_from_tool)
        })
    }
}

impl fmt::Display for HeldTool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let link = &self.link;
        match self.mount {
            None => write!(
                f,
                "at a given pose on link {link:?}; collisions of the part between link and tool are not checked"
            )?,
            Some(Mount::Flange { .. }) => {
                let out = self.axis.frame().inverse() * self.tip_from_tool.translation.vector;
                let (out, axis) = (out.z, self.axis);
                write!(
                    f,
                    "square on link {link:?}, contact plane {out:.3} m along its {axis} axis"
                )?;
            }
            Some(Mount::Hand { lean }) => write!(
                f,
                "by the rear edge of its upper face, the hand of link {link:?} leaning back by {lean:.2} rad"
            )?,
            Some(Mount::Grip(_)) => write!(f, "by its grip on link {link:?}")?,
        }
        match self.source {
            MountSource::Declared => {}
            MountSource::Srdf => f.write_str(" (from the SRDF)")?,
            MountSource::Assumed => f.write_str(" (assumed)")?,
        }
        if let Some(gap) = self.unchecked_gap {
            write!(
                f,
                "; the part between hand and tool, {gap:.3} m long, is not checked for collisions"
            )?;
        }
        (self.holder.iter()).try_for_each(|holder| write!(f, "; {holder}, checked for collisions"))
    }
}

/// Returns the distance of a hand from the box around the tool that it holds \[m\]; `None` if it is at the tool.
fn find_gap(tool: &Tool, tool_from_hand: &Pose) -> Option<f64> {
    let (low, high) = tool.mesh.bounds();
    let hand = tool_from_hand.translation.vector;
    let nearest = hand.sup(&low.coords).inf(&high.coords);
    let gap = (hand - nearest).norm();
    (gap > AT_TOOL).then_some(gap)
}

/// Refuses a hand of which a collision mesh cannot be read: the tool would be held inside it.
fn check_hand_shapes(robot: &RobotModel, tip: LinkId) -> Result<(), FollowError> {
    let links = robot.carried_links(tip).into_iter();
    let names: Vec<&str> = links
        .map(|link| robot.links()[link.index()].name.as_str())
        .collect();
    let unread = robot.diagnostics().iter().find_map(|found| {
        let Subject::Link(link) = &found.subject else {
            return None;
        };
        let is_unread = found.kind == DiagnosticKind::Mesh && names.contains(&link.as_str());
        is_unread.then(|| (link.clone(), found.value.clone()))
    });
    match unread {
        Some((link, why)) => Err(FollowError::UnknownHand { link, why }),
        None => Ok(()),
    }
}

/// Returns the end of a hand in the frame of its link: its z axis is the link's `axis`, and it is at the outermost
/// point of the shapes of the link and of all links that it carries, in a posture `q` (n).
pub(in crate::follow) fn tip_from_hand(
    robot: &RobotModel,
    tip: LinkId,
    axis: LinkAxis,
    q: &[f64],
) -> Result<Pose, FollowError> {
    let reach = hand_extent(robot, tip, axis, q)?;
    Ok(axis.frame() * Pose::translation(0.0, 0.0, reach))
}

/// Returns the pose of the tool in the flange, the middle of its upper face square on it.
fn hold_square(tool: &Tool, yaw: f64) -> Pose {
    let (_, high) = tool.mesh.bounds();
    let turned = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI)
        * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
    turned * Translation3::from(-Vector3::new(0.0, 0.0, high.z))
}

/// Returns the pose of the tool in the hand, held at the rear edge of its upper face, with the hand leaning
/// back.
fn hold_rear_edge(tool: &Tool, lean: f64) -> Pose {
    let (low, high) = tool.mesh.bounds();
    let turned = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), lean);
    let grasped_in_tool = Vector3::new(low.x, 0.0, high.z);
    turned * Translation3::from(-grasped_in_tool)
}

/// Returns the tool without its rim. It may keep less clearance from the scene than the margin, because the
/// plan already keeps the collision sphere clear, which just contains the tool.
pub(in crate::follow) fn without_rim(mesh: &Mesh, rim: f64) -> Result<Mesh, FollowError> {
    let (low, high) = mesh.bounds();
    let middle = nalgebra::center(&low, &high);
    let size = high - low;
    let share = size.map(|side| ((side - 2.0 * rim) / side.max(f64::MIN_POSITIVE)).max(0.1));
    let vertices = mesh.vertices().iter();
    let vertices = vertices.map(|v| middle + (v - middle).component_mul(&share));
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).map_err(FollowError::Tool)
}

/// Returns the tool without compression: its underside lies below the tool centre point by the depth of its
/// compression in contact.
pub(in crate::follow) fn relax(mesh: &Mesh, compression_depth: f64) -> Result<Mesh, FollowError> {
    let stretched = |v: &Point3| {
        let share = (1.0 - v.z / (2.0 * compression_depth)).clamp(0.0, 1.0);
        Point3::new(v.x, v.y, v.z - compression_depth * share)
    };
    if compression_depth <= 0.0 {
        return Ok(mesh.clone());
    }
    let vertices = mesh.vertices().iter().map(stretched);
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).map_err(FollowError::Tool)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_at_rest_hangs_as_low_as_it_is_compressed_when_it_wipes() {
        let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap();
        let (low, high) = sponge.bounds();
        let (low_at_rest, high_at_rest) = relax(&sponge, 0.005).unwrap().bounds();
        assert!(
            (low.z - low_at_rest.z - 0.005).abs() < 1e-12,
            "{low_at_rest}"
        );
        assert_eq!((high, low.xy()), (high_at_rest, low_at_rest.xy()));
        assert_eq!(relax(&sponge, 0.0).unwrap(), sponge);
    }
}
