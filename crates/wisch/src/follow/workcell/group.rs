//! The part of a robot that wipes, the base that carries it, and its ready posture.

use crate::follow::FollowError;
use crate::geometry::Vector3;
use crate::robot::{JointKind, LinkId, READY_STATE, RobotModel, Srdf};
use crate::source_location::UnknownName;

/// A base that moves over the floor: the variables of its position and heading in the root frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlanarBase {
    /// Variable of x.
    pub x: usize,
    /// Variable of y.
    pub y: usize,
    /// Variable of the heading.
    pub yaw: usize,
}

/// The part of a robot that wipes.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanningGroup {
    /// The link at which its chain begins.
    pub base: LinkId,
    /// The link that holds the tool.
    pub tip: LinkId,
    /// The robot's ready posture: the SRDF's states of that name, and the middle of the limits for all other
    /// variables; all n variables [rad or m].
    pub ready: Vec<f64>,
}

impl PlanningGroup {
    /// Returns the group with a name, or the SRDF's first, or without an SRDF the longest chain.
    ///
    /// # Errors
    /// The SRDF has no group of that name.
    pub fn choose(
        robot: &RobotModel,
        srdf: Option<&Srdf>,
        name: Option<&str>,
    ) -> Result<Self, FollowError> {
        let groups = srdf.map_or(&[][..], |srdf| &srdf.groups);
        let (base, tip) = match name {
            Some(name) => match groups.iter().find(|group| group.name == name) {
                Some(group) => (group.base, group.tip),
                None => {
                    let known = groups.iter().map(|group| group.name.as_str());
                    let unknown = UnknownName::new("group", name, known);
                    return Err(FollowError::UnknownGroup(Box::new(unknown)));
                }
            },
            None => (groups.first())
                .map_or_else(|| longest_chain(robot), |group| (group.base, group.tip)),
        };
        Ok(Self {
            base,
            tip,
            ready: ready(robot, srdf),
        })
    }
}

/// Returns the chain from the root to the link with the most moving joints before it.
fn longest_chain(robot: &RobotModel) -> (LinkId, LinkId) {
    let mut moving = vec![0; robot.links().len()];
    let mut best = robot.root();
    for joint in robot.joints() {
        let own = usize::from(joint.kind != JointKind::Fixed);
        moving[joint.child.index()] = moving[joint.parent.index()] + own;
        // The outermost of equal links: a flange behind fixed joints.
        if moving[joint.child.index()] >= moving[best.index()] {
            best = joint.child;
        }
    }
    (robot.root(), best)
}

/// Returns the planar base that carries a link: x, y and heading, if only these move it.
pub(in crate::follow) fn planar_base(
    robot: &RobotModel,
    link: LinkId,
) -> Result<Option<PlanarBase>, FollowError> {
    let mut moving: Vec<_> = (robot.joints_above(link))
        .filter(|joint| joint.kind != JointKind::Fixed)
        .collect();
    moving.reverse();
    let variable = |at: usize| match moving[at].drive.terms[..] {
        [(variable, 1.0)] => Some(variable),
        _ => None,
    };
    let axis = |at: usize| moving[at].axis.into_inner();
    let kinds: Vec<JointKind> = moving.iter().map(|joint| joint.kind).collect();
    match kinds[..] {
        [] => Ok(None),
        [
            JointKind::Prismatic,
            JointKind::Prismatic,
            JointKind::Revolute,
        ] if axis(0) == Vector3::x() && axis(1) == Vector3::y() && axis(2) == Vector3::z() => {
            match (variable(0), variable(1), variable(2)) {
                (Some(x), Some(y), Some(yaw)) => Ok(Some(PlanarBase { x, y, yaw })),
                _ => Ok(None),
            }
        }
        _ => Err(FollowError::NoPlanarBase {
            link: robot.links()[link.index()].name.clone(),
            joints: moving.iter().map(|joint| joint.name.clone()).collect(),
        }),
    }
}

/// Returns the SRDF's ready states, with the middle of the limits for all other variables.
fn ready(robot: &RobotModel, srdf: Option<&Srdf>) -> Vec<f64> {
    let middle = |i: usize| {
        let range = robot.variable(i).limits.position;
        range.map_or(0.0, |range| (range.lower + range.upper) / 2.0)
    };
    let mut q: Vec<f64> = (0..robot.dof()).map(middle).collect();
    set_named_state(&mut q, srdf, READY_STATE);
    q
}

/// Sets the positions of the SRDF's states of a name.
pub(in crate::follow) fn set_named_state(q: &mut [f64], srdf: Option<&Srdf>, state: &str) {
    let states = srdf.map_or(&[][..], |srdf| &srdf.states);
    for state in states.iter().filter(|known| known.name == state) {
        for &(variable, position) in &state.positions {
            q[variable] = position;
        }
    }
}

/// Returns a hand and the next link with shapes that holds it.
pub(in crate::follow) fn hand_and_holder(robot: &RobotModel, tip: LinkId) -> Vec<String> {
    let above = robot.joints_above(tip).map(|joint| joint.parent);
    std::iter::once(tip)
        .chain(above)
        .map(|link| &robot.links()[link.index()])
        .filter(|link| !link.collision.is_empty())
        .take(2)
        .map(|link| link.name.clone())
        .collect()
}

/// Returns the links with shapes that only the base moves, which therefore stand on the floor.
pub(in crate::follow) fn standing_links(robot: &RobotModel, base: &PlanarBase) -> Vec<String> {
    let variables = [base.x, base.y, base.yaw];
    let mut stands = vec![true; robot.links().len()];
    for joint in robot.joints() {
        let own = (joint.drive.terms.iter()).all(|(variable, _)| variables.contains(variable));
        stands[joint.child.index()] = stands[joint.parent.index()] && own;
    }
    let links = robot.links().iter().zip(stands);
    links
        .filter(|(link, stands)| *stands && !link.collision.is_empty())
        .map(|(link, _)| link.name.clone())
        .collect()
}
