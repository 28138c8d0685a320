//! The part of a robot that wipes, the base that carries it, and its ready posture.

use super::MountSource;
use crate::follow::FollowError;
use crate::geometry::Vector3;
use crate::represent::Mount;
use crate::robot::setup::find_arms;
use crate::robot::{
    GroupState, HOME_STATE, Joint, JointKind, LinkId, READY_STATE, RobotModel, Srdf,
};
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
    /// The robot's ready posture: the SRDF's states "ready", for variables that these leave out its states "home", and the
    /// middle of the limits for all other variables; all n variables [rad or m].
    pub ready: Vec<f64>,
}

/// Where motions begin because no state of an SRDF says so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StartAssumption {
    /// What the SRDF lacks: the end of a sentence about the robot.
    pub lacks: String,
    /// Where motions begin, with the assumed positions \[rad or m\]: the end of a sentence.
    pub begins: String,
}

impl PlanningGroup {
    /// Returns the group with a name, or the SRDF's first. Without a group of an SRDF it is the first arm that
    /// [`find_arms`] finds, and without an arm the longest chain.
    ///
    /// # Errors
    /// [`FollowError::UnknownGroup`] if the SRDF has no group of that name.
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
                .map_or_else(|| assumed_chain(robot), |group| (group.base, group.tip)),
        };
        Ok(Self {
            base,
            tip,
            ready: ready(robot, srdf),
        })
    }

    /// Returns how the group holds a tool whose mount is not declared, and the source of this
    /// mount: the end effector of the SRDF at the group's tip. Without one, a square mount is
    /// assumed.
    pub fn mount(&self, srdf: Option<&Srdf>) -> (Mount, MountSource) {
        let holder = srdf.and_then(|srdf| srdf.tool_holder(self.tip));
        match holder.map(|holder| holder.hand_lean) {
            Some(Some(lean)) => (Mount::Hand { lean }, MountSource::Srdf),
            Some(None) => (Mount::SQUARE, MountSource::Srdf),
            None => (Mount::SQUARE, MountSource::Assumed),
        }
    }

    /// Returns the names of the joints that carry the group and are not its own, such as a lift; they stay at their
    /// positions of the ready posture.
    pub fn held_joints(&self, robot: &RobotModel) -> Vec<String> {
        held_joints(robot, self.base)
    }
}

/// Returns the chain of a robot without groups: its first arm, without a gripper at its end.
fn assumed_chain(robot: &RobotModel) -> (LinkId, LinkId) {
    // An error says that the robot has no arm.
    let arms = find_arms(robot, &[]);
    let first = arms.iter().flatten().flat_map(|arm| &arm.groups).next();
    first.map_or_else(
        || longest_chain(robot),
        |proposed| (proposed.group.base, proposed.group.tip),
    )
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

/// Returns the planar base that carries a link: the joints next to the root, if these are x, y and heading.
pub(in crate::follow) fn planar_base(robot: &RobotModel, link: LinkId) -> Option<PlanarBase> {
    let moving = moving_joints_above(robot, link);
    let [x, y, yaw] = moving.get(..3)? else {
        return None;
    };
    let variable = |joint: &Joint| match joint.drive.terms[..] {
        [(variable, 1.0)] => Some(variable),
        _ => None,
    };
    let is = |joint: &Joint, kind: JointKind, axis: Vector3| {
        joint.kind == kind && joint.axis.into_inner() == axis
    };
    let is_planar = is(x, JointKind::Prismatic, Vector3::x())
        && is(y, JointKind::Prismatic, Vector3::y())
        && is(yaw, JointKind::Revolute, Vector3::z());
    is_planar.then_some(())?;
    Some(PlanarBase {
        x: variable(x)?,
        y: variable(y)?,
        yaw: variable(yaw)?,
    })
}

/// Returns the names of the joints that carry a link and belong to no planar base: a lift, a rail or a torso. They stay
/// where the ready posture has them.
pub(in crate::follow) fn held_joints(robot: &RobotModel, link: LinkId) -> Vec<String> {
    let in_base = if planar_base(robot, link).is_some() {
        3
    } else {
        0
    };
    let moving = moving_joints_above(robot, link).into_iter().skip(in_base);
    moving.map(|joint| joint.name.clone()).collect()
}

/// Returns the joints that move a link, the one next to the root first.
fn moving_joints_above(robot: &RobotModel, link: LinkId) -> Vec<&Joint> {
    let joints = robot.joints_above(link);
    let mut moving: Vec<&Joint> = joints
        .filter(|joint| joint.kind != JointKind::Fixed)
        .collect();
    moving.reverse();
    moving
}

impl StartAssumption {
    /// Returns what is assumed; `None` if the SRDF's states "ready" set all joints. The states of single tools, such as
    /// "ready_broom", count too. The joints of a planar base are left out, as the task places the base.
    pub fn find(robot: &RobotModel, srdf: Option<&Srdf>) -> Option<Self> {
        let states = srdf.map_or(&[][..], |srdf| &srdf.states);
        let is_ready = |state: &GroupState| state.name.starts_with(READY_STATE);
        let is_home = |state: &GroupState| state.name == HOME_STATE;
        let base = PlanningGroup::choose(robot, srdf, None).ok();
        let base = base.and_then(|group| planar_base(robot, group.tip));
        let middles = ready(robot, None);
        let is_set = |variable: usize| {
            let mut own = states
                .iter()
                .filter(|state| is_ready(state) || is_home(state));
            own.any(|state| state.positions.iter().any(|(set, _)| *set == variable))
                || base.is_some_and(|base| [base.x, base.y, base.yaw].contains(&variable))
        };
        let joints: Vec<String> = (0..robot.dof())
            .filter(|&variable| !is_set(variable))
            .map(|variable| {
                let joint = robot.variable(variable);
                let unit = match joint.kind {
                    JointKind::Prismatic => "m",
                    _ => "rad",
                };
                // Without the sign of a zero.
                let position = (1e3 * middles[variable]).round() / 1e3 + 0.0;
                format!("{} = {position} {unit}", joint.name)
            })
            .collect();
        let (has_ready, has_home) = (states.iter().any(is_ready), states.iter().any(is_home));
        if has_ready && joints.is_empty() {
            return None;
        }
        let lacks = match srdf {
            None => format!("it has no SRDF, and so no state \"{READY_STATE}\""),
            Some(_) if !has_ready => format!("its SRDF has no state \"{READY_STATE}\""),
            Some(_) => {
                let states = if has_home { " and \"home\"" } else { "" };
                format!("its SRDF does not set all joints in \"{READY_STATE}\"{states}")
            }
        };
        let home = (!has_ready && has_home).then(|| format!("in its state \"{HOME_STATE}\""));
        let middle = (!joints.is_empty())
            .then(|| format!("with {} (middle of the limits)", joints.join(", ")));
        let begins: Vec<String> = home.into_iter().chain(middle).collect();
        Some(Self {
            lacks,
            begins: begins.join(", "),
        })
    }
}

/// Returns the SRDF's ready states, else its home states, with the middle of the limits for all other variables.
fn ready(robot: &RobotModel, srdf: Option<&Srdf>) -> Vec<f64> {
    let middle = |i: usize| {
        let range = robot.variable(i).limits.position;
        range.map_or(0.0, |range| (range.lower + range.upper) / 2.0)
    };
    let mut q: Vec<f64> = (0..robot.dof()).map(middle).collect();
    set_named_state(&mut q, srdf, HOME_STATE);
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
