//! A planar joint of a URDF, read as three joints: two prismatic ones and a revolute one.

use super::elements::{UrdfJoint, UrdfLimit, UrdfLink};
use crate::frame::rotation_from_z;
use crate::geometry::{Pose, Vector3};

/// Range of a planar joint in either direction [m]: a URDF gives none, and no floor is larger.
const EXTENT: f64 = 100.0;
/// Length of an axis below which it has no direction.
const MIN_AXIS: f64 = 1e-5;

/// Suffixes of the parts' names, as in an SRDF.
const PARTS: [&str; 3] = ["x", "y", "theta"];

/// Returns the joints of which a joint consists, and the links between them. The axis of a planar joint is the normal
/// of its plane; each part has its limits of velocity, acceleration and effort [m and rad].
pub(crate) fn split(joint: UrdfJoint) -> (Vec<UrdfJoint>, Vec<UrdfLink>) {
    if joint.kind != "planar" || joint.axis.norm() < MIN_AXIS {
        return (vec![joint], Vec::new());
    }
    let plane = rotation_from_z(&joint.axis.normalize());
    let limit = joint.limit.unwrap_or_default();
    let slide = UrdfLimit {
        lower: Some(-EXTENT),
        upper: Some(EXTENT),
        ..limit
    };
    let turn = UrdfLimit {
        lower: None,
        upper: None,
        ..limit
    };
    let kinds = [
        ("prismatic", Vector3::x(), slide),
        ("prismatic", Vector3::y(), slide),
        ("continuous", Vector3::z(), turn),
    ];
    let name = |part: &str| format!("{}/{part}", joint.name);
    let between = [PARTS[0], PARTS[1]].map(|part| format!("{}_link", name(part)));
    let parents = [&joint.parent, &between[0], &between[1]];
    let children = [&between[0], &between[1], &joint.child];
    let joints = (0..3).map(|i| UrdfJoint {
        name: name(PARTS[i]),
        kind: kinds[i].0.to_owned(),
        at: joint.at,
        parent: parents[i].clone(),
        child: children[i].clone(),
        parent_from_joint: if i == 0 {
            joint.parent_from_joint
        } else {
            Pose::identity()
        },
        axis: plane * kinds[i].1,
        limit: Some(kinds[i].2),
        soft_limits: None,
        assumed_limit: None,
    });
    let links = between.iter().map(|name| UrdfLink {
        name: name.clone(),
        at: joint.at,
        inertial: None,
        shapes: Vec::new(),
    });
    (joints.collect(), links.collect())
}
