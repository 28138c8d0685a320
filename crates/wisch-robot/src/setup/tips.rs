//! The link of an arm that holds the tool.

use super::joint_tree::JointTree;
use super::link_names::{TIP_KINDS, is_in_grasp, is_sensor, tip_kind};
use super::postures::middle_posture;
use super::region::hand_extent;
use crate::geometry::Vector3;
use crate::{JointKind, LinkAxis, LinkId};
use std::cmp::Reverse;
use std::f64::consts::FRAC_PI_3;

/// Distance from a joint to the tip that gives a direction [m].
const MIN_DISTANCE: f64 = 0.03;
/// Angle by which another axis must be nearer to the direction of the hand than z [rad].
const AXIS_MARGIN: f64 = 0.1;
/// Largest angle of a z axis that points away from the hand [rad].
const MAX_TILT: f64 = FRAC_PI_3;

/// A link that holds the tool, with the reason for choosing it.
pub(super) struct Tip {
    pub link: LinkId,
    /// Reason, in words.
    pub reason: String,
    /// A link of the gripper beyond it.
    pub gripper: Option<LinkId>,
    /// The axis that points out of the hand.
    pub axis: LinkAxis,
    /// Angle between that axis and the direction to the link from the last joints [rad].
    pub tilt: f64,
}

/// A link that is fixed to the last moving link of an arm.
struct Candidate {
    link: LinkId,
    /// Number of fixed joints before it.
    depth: usize,
    /// Whether it is part of a gripper.
    in_gripper: bool,
    kind: usize,
    is_sensor: bool,
    axis: LinkAxis,
    tilt: f64,
}

/// Chooses the link that holds the tool among those fixed to the last moving link: one whose z axis points away from
/// the hand, then by its name, then the one that holds the gripper, then the outermost that is no sensor.
pub(super) fn choose_tip(tree: &JointTree<'_>, joints: &[usize], last: usize) -> Tip {
    let robot = tree.robot;
    let first = robot.joints()[last].child;
    let mut gripper_holder = None;
    let candidates = list_candidates(tree, joints, first, &mut gripper_holder);
    let holder = gripper_holder.map(|(holder, _)| holder);
    let by_name = |c: &&Candidate| {
        (
            c.kind,
            c.is_sensor,
            c.in_gripper,
            Some(c.link) != holder,
            Reverse(c.depth),
        )
    };
    let best = candidates
        .iter()
        .min_by_key(|c| (c.axis != LinkAxis::Z || c.tilt > MAX_TILT, by_name(c)));
    let gripper = (gripper_holder.map(|(_, part)| part)).or_else(|| tree.finger_on(first));
    let Some(best) = best else {
        let (axis, tilt) = outward_axis(tree, joints, first);
        return Tip {
            link: first,
            reason: TIP_KINDS[TIP_KINDS.len() - 1].to_owned(),
            gripper,
            axis,
            tilt,
        };
    };
    let named = candidates
        .iter()
        .min_by_key(by_name)
        .filter(|named| named.kind < best.kind);
    let reason = match named {
        Some(named) => format!(
            "its z axis points away from the hand, unlike that of {}",
            robot.links()[named.link.index()].name
        ),
        None if best.kind + 1 == TIP_KINDS.len() && Some(best.link) == holder => {
            "it holds the gripper".to_owned()
        }
        None => TIP_KINDS[best.kind].to_owned(),
    };
    Tip {
        link: best.link,
        reason,
        gripper: gripper.filter(|_| !best.in_gripper && !is_in_grasp(best.kind)),
        axis: best.axis,
        tilt: best.tilt,
    }
}

/// Lists the links that are fixed to `first`, itself included; sets the link that holds a gripper and the gripper's
/// first part.
fn list_candidates(
    tree: &JointTree<'_>,
    joints: &[usize],
    first: LinkId,
    gripper_holder: &mut Option<(LinkId, LinkId)>,
) -> Vec<Candidate> {
    let robot = tree.robot;
    let candidate = |link: LinkId, depth: usize, in_gripper: bool| {
        let name = &robot.links()[link.index()].name;
        let (axis, tilt) = outward_axis(tree, joints, link);
        Candidate {
            link,
            depth,
            in_gripper,
            kind: tip_kind(name),
            is_sensor: is_sensor(name),
            axis,
            tilt,
        }
    };
    let mut found = vec![candidate(first, 0, false)];
    let mut at = 0;
    while let Some(&Candidate {
        link,
        depth,
        in_gripper,
        ..
    }) = found.get(at)
    {
        at += 1;
        let below = robot.joints().iter();
        for joint in below.filter(|joint| joint.parent == link && joint.kind == JointKind::Fixed) {
            let is_gripper = in_gripper || tree.is_gripper_link(joint.child);
            if is_gripper && !in_gripper {
                gripper_holder.get_or_insert((link, joint.child));
            }
            found.push(candidate(joint.child, depth + 1, is_gripper));
        }
    }
    found
}

/// Returns the axis of a tip that is nearest to the direction from the last of `joints` to it, and the angle between the two
/// [rad]. A tip at that joint's place has the direction of the joint's axis, away from the joint before it, or else to the side on
/// which its shapes reach farther.
pub(super) fn outward_axis(tree: &JointTree<'_>, joints: &[usize], tip: LinkId) -> (LinkAxis, f64) {
    let robot = tree.robot;
    let last = joints.last().map(|&last| &robot.joints()[last]);
    let middle = middle_posture(robot);
    let kinematics = robot.forward_kinematics(&middle);
    let (Some(last), Ok(kinematics)) = (last, kinematics) else {
        return (LinkAxis::default(), 0.0);
    };
    let world_from_tip = kinematics.world_from_link(tip);
    let world_from_joint = kinematics.world_from_link(last.child);
    let tilt = |axis: LinkAxis, direction: &Vector3| {
        let out = world_from_tip.rotation * axis.frame().rotation * Vector3::z();
        out.angle(direction)
    };
    let nearest = |direction: &Vector3| {
        // z is the usual axis.
        let cost = |axis: LinkAxis| {
            let margin = if axis == LinkAxis::Z {
                AXIS_MARGIN
            } else {
                0.0
            };
            tilt(axis, direction) - margin
        };
        let axes = LinkAxis::ALL.into_iter();
        let nearest = axes.min_by(|&a, &b| cost(a).total_cmp(&cost(b)));
        let axis = nearest.unwrap_or_default();
        (axis, tilt(axis, direction))
    };
    let apart = world_from_tip.translation.vector - world_from_joint.translation.vector;
    if apart.norm() >= MIN_DISTANCE {
        return nearest(&apart);
    }
    let along = world_from_joint.rotation * last.axis.into_inner();
    // The joint before it is on the inner side.
    let before = joints.iter().rev().nth(1);
    let step = before.map_or(0.0, |&before| {
        let inner = kinematics.world_from_link(robot.joints()[before].child);
        let step = world_from_joint.translation.vector - inner.translation.vector;
        along.dot(&step)
    });
    if step.abs() >= MIN_DISTANCE {
        return nearest(&(along * step.signum()));
    }
    let [(there, tilt), (back, _)] = [along, -along].map(|direction| nearest(&direction));
    // The shapes of a hand reach farther outwards than inwards; without shapes, the usual frame has z outwards.
    let reach = |axis| hand_extent(robot, tip, axis, &middle).ok();
    let is_back = match reach(there).zip(reach(back)) {
        Some((reach, reach_back)) if reach != reach_back => reach_back > reach,
        _ => back == LinkAxis::Z,
    };
    (if is_back { back } else { there }, tilt)
}
