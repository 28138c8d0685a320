//! The piece of a robot: links, joints and shapes.

use crate::scene::{Meshes, Solid, to_seven_numbers, vector};
use serde::Serialize;
use wisch::robot::{Appearance, Joint, JointKind, Link, LinkId, RobotModel, Shape, Visual};

/// Maximum number of triangles of a mesh.
pub(super) const MAX_TRIANGLES: usize = 2_000;
/// Maximum number of triangles of all visual meshes of a robot together, and of one of them.
const MAX_SHOWN_TRIANGLES: usize = 40_000;
const MAX_SHOWN_TRIANGLES_OF_ONE: usize = 5_000;
/// Maximum number of triangles of a collision mesh beside visual geometry.
const MAX_COLLISION_TRIANGLES: usize = 500;

#[derive(Serialize)]
pub(super) struct RobotRecord<'a> {
    name: &'a str,
    variables: Vec<&'a str>,
    /// Joint i holds link i + 1.
    joints: Vec<JointRecord<'a>>,
    links: Vec<LinkRecord<'a>>,
}

#[derive(Serialize)]
struct JointRecord<'a> {
    parent: usize,
    pose: [f64; 7],
    axis: [f64; 3],
    kind: &'static str,
    offset: f64,
    terms: &'a [(usize, f64)],
}

#[derive(Serialize)]
struct LinkRecord<'a> {
    name: &'a str,
    /// Whether it belongs to the arm that holds the tool.
    arm: bool,
    /// Whether the shapes are visual geometry rather than collision geometry.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    visual: bool,
    shapes: Vec<Solid>,
    /// Collision geometry, beside visual geometry.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    collision: Vec<Solid>,
}

impl<'a> RobotRecord<'a> {
    pub(super) fn new(
        robot: &'a RobotModel,
        tip: LinkId,
        appearance: Option<&Appearance>,
        meshes: &mut Meshes,
    ) -> Self {
        let arm = find_arm_links(robot, tip);
        let appearance = appearance.filter(|looks| !looks.is_empty());
        let looks = |link: &Link| appearance?.visuals(robot.link(&link.name).ok()?);
        let shown = robot.links().iter().filter_map(looks).flatten();
        let shown = shown.filter(|part| matches!(part.shape, Shape::Mesh(_)));
        let most = (MAX_SHOWN_TRIANGLES / shown.count().max(1)).min(MAX_SHOWN_TRIANGLES_OF_ONE);
        let links = (robot.links().iter().enumerate()).map(|(i, link)| {
            let looks = looks(link);
            let collision = |most: usize, meshes: &mut Meshes| -> Vec<Solid> {
                let parts = link.collision.iter();
                parts
                    .map(|part| meshes.shape_within(&part.link_from_shape, &part.shape, most))
                    .collect()
            };
            let (shapes, collision) = match looks {
                Some(visuals) => (
                    (visuals.iter())
                        .map(|visual| build_visual_solid(visual, most, meshes))
                        .collect(),
                    collision(MAX_COLLISION_TRIANGLES, meshes),
                ),
                None => (collision(MAX_TRIANGLES, meshes), Vec::new()),
            };
            LinkRecord {
                name: &link.name,
                arm: arm.contains(&i),
                visual: looks.is_some(),
                shapes,
                collision,
            }
        });
        Self {
            name: robot.name(),
            variables: (0..robot.dof())
                .map(|i| robot.variable(i).name.as_str())
                .collect(),
            links: links.collect(),
            joints: robot.joints().iter().map(JointRecord::new).collect(),
        }
    }
}

fn build_visual_solid(visual: &Visual, most: usize, meshes: &mut Meshes) -> Solid {
    let solid = meshes.shape_within(&visual.link_from_shape, &visual.shape, most);
    match visual.color {
        Some(rgba) => solid.with_colour(rgba),
        None => solid,
    }
}

impl<'a> JointRecord<'a> {
    fn new(joint: &'a Joint) -> Self {
        Self {
            parent: joint.parent.index(),
            pose: to_seven_numbers(&joint.parent_from_joint),
            axis: vector(&joint.axis),
            kind: match joint.kind {
                JointKind::Fixed => "fixed",
                JointKind::Revolute => "revolute",
                JointKind::Prismatic => "prismatic",
            },
            offset: joint.drive.offset,
            terms: &joint.drive.terms,
        }
    }
}

/// Returns the links of the arm: those from the last fork before the tool to the tool. A fork is a link that also carries
/// another moving branch; a hand with fingers does not count.
fn find_arm_links(robot: &RobotModel, tool_link: LinkId) -> Vec<usize> {
    let holder = |link: usize| {
        robot.links()[link]
            .parent
            .map(|id| &robot.joints()[id.index()])
    };
    // Whether a variable moves something at or beyond a link.
    let mut moves = vec![false; robot.links().len()];
    for joint in robot.joints().iter().rev() {
        let child = joint.child.index();
        moves[joint.parent.index()] |= moves[child] || joint.kind != JointKind::Fixed;
    }
    let is_fork = |link: usize, way: usize| {
        let others =
            (robot.joints().iter()).filter(|j| j.parent.index() == link && j.child.index() != way);
        let mut moving = others.filter(|j| moves[j.child.index()] || j.kind != JointKind::Fixed);
        moving.next().is_some()
    };
    let mut root = tool_link.index();
    let mut is_beyond_hand = false;
    while let Some(joint) = holder(root) {
        let parent = joint.parent.index();
        is_beyond_hand |= joint.kind != JointKind::Fixed;
        if (is_beyond_hand && is_fork(parent, root)) || holder(parent).is_none() {
            break;
        }
        root = parent;
    }
    let mut arm = vec![root];
    for joint in robot.joints() {
        if arm.contains(&joint.parent.index()) {
            arm.push(joint.child.index());
        }
    }
    arm
}
