//! The arms of a robot, and the planning groups of each.

use super::SetupError;
use super::joint_tree::{JointTree, MIN_ARM_JOINTS};
use super::link_names::{is_head, is_leg, side};
use super::tips::{Tip, choose_tip, outward_axis};
use crate::{Group, JointKind, LinkAxis, LinkId, RobotModel};

/// Largest number of arms of a robot.
const MAX_ARMS: usize = 16;
/// Number of joints at the end of a chain whose names say whether it is a leg or a head.
const NAMED_JOINTS: usize = 4;
/// Cosine of the largest angle between the axis of a lift and the vertical [1].
const MIN_VERTICAL: f64 = 0.7;

/// An arm with its planning groups.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmChain {
    /// Name: "arm" for the only one, else with its side or number, such as "left_arm".
    pub name: String,
    /// Groups, at least one; the first has every joint from the robot's base on, the last only those of this arm.
    pub groups: Vec<ProposedGroup>,
    /// A link of the gripper that hangs on the tip, if there is one.
    pub gripper: Option<LinkId>,
    /// Axis of the tip along which a tool is held: the nearest to the direction from the last joints to the tip.
    pub tip_axis: LinkAxis,
    /// Angle between `tip_axis` and that direction \[rad\].
    pub tip_tilt: f64,
}

/// A planning group, with the reason for proposing it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProposedGroup {
    /// The group.
    pub group: Group,
    /// Number of variables that move its tip.
    pub joints: usize,
    /// Reason for its base and its tip, in words.
    pub reason: String,
}

/// The joints and the tip of an arm, before it has a name.
struct Limb {
    /// Moving joints after a mobile base.
    joints: Vec<usize>,
    tip: Tip,
}

/// Finds the arms of a robot: the chains with at least four independent joints that are no legs or heads. A gripper at
/// the end is no part of an arm. `tips` names the links at the ends instead, if it is not empty.
///
/// An arm's base is the link before its first joint, or the one that a planar base moves along x and y and about z.
/// An arm behind a lift, a rail or a torso has two groups: the first with these joints, the second without.
///
/// The arm with the most joints of its own comes first; arms of equal size keep the order of the URDF.
///
/// ```
/// # let text = include_str!("../../../../robots/humanoid.urdf");
/// # let robot = wisch_robot::RobotModel::from_urdf("h", text, &mut |_| Err(String::new()))?;
/// let arms = wisch_robot::setup::find_arms(&robot, &[])?;
/// let groups = arms.iter().flat_map(|arm| &arm.groups);
/// let names: Vec<&str> = groups.map(|proposed| proposed.group.name.as_str()).collect();
/// assert_eq!(names, ["right_arm_with_torso", "right_arm", "left_arm_with_torso", "left_arm"]);
/// # Ok::<(), wisch_robot::setup::SetupError>(())
/// ```
///
/// # Errors
/// If there is no arm, its joints have no range, or no joint moves a named tip.
///
/// # Panics
/// If a link belongs to another, larger robot.
pub fn find_arms(robot: &RobotModel, tips: &[LinkId]) -> Result<Vec<ArmChain>, SetupError> {
    let tree = JointTree::new(robot);
    let limbs = if tips.is_empty() {
        find_limbs(&tree)?
    } else {
        tips.iter()
            .map(|&tip| limb_to(&tree, tip))
            .collect::<Result<_, _>>()?
    };
    let names = name_limbs(&tree, &limbs);
    let is_shared = |joint: usize| {
        limbs
            .iter()
            .filter(|limb| limb.joints.contains(&joint))
            .count()
            > 1
    };
    let arms = limbs.iter().zip(names).map(|(limb, name)| ArmChain {
        groups: propose_groups(&tree, limb, &name, is_shared),
        name,
        gripper: limb.tip.gripper,
        tip_axis: limb.tip.axis,
        tip_tilt: limb.tip.tilt,
    });
    let (mut movable, mut locked) = (Vec::new(), None);
    for arm in arms {
        match find_locked(robot, &arm)? {
            Some(found) => locked = locked.or(Some(found)),
            None => movable.push(arm),
        }
    }
    // A locked arm beside another arm does not count, unless the caller named it.
    match locked {
        Some(locked) if movable.is_empty() || !tips.is_empty() => Err(locked),
        _ => Ok(movable),
    }
}

/// Returns the error of an arm with a group of which no joint has a range, if there is one.
fn find_locked(robot: &RobotModel, arm: &ArmChain) -> Result<Option<SetupError>, SetupError> {
    for proposed in &arm.groups {
        let chain = robot.chain(proposed.group.base, proposed.group.tip)?;
        let has_range = |&variable: &usize| {
            let limits = robot.variable(variable).limits.position;
            limits.is_none_or(|limits| limits.upper > limits.lower)
        };
        if !chain.variables().iter().any(has_range) {
            return Ok(Some(SetupError::NoRange {
                robot: robot.name().to_owned(),
                joints: chain.variables().len(),
                tip: robot.links()[proposed.group.tip.index()].name.clone(),
            }));
        }
    }
    Ok(None)
}

/// Returns the limb that ends in a named link.
fn limb_to(tree: &JointTree<'_>, tip: LinkId) -> Result<Limb, SetupError> {
    let joints = tree.moving_above(tip).map(|last| tree.path(last));
    match joints {
        Some(joints) if !joints.is_empty() => {
            let (axis, tilt) = outward_axis(tree, &joints, tip);
            let tip = Tip {
                link: tip,
                reason: "given".to_owned(),
                gripper: None,
                axis,
                tilt,
            };
            Ok(Limb { joints, tip })
        }
        _ => Err(SetupError::FixedTip {
            tip: tree.robot.links()[tip.index()].name.clone(),
        }),
    }
}

/// Finds the chains that are long enough for an arm. At a branching, the branch with the most joints continues the
/// chain and each other branch begins a chain of its own; a head on a torso is thus short.
fn find_limbs(tree: &JointTree<'_>) -> Result<Vec<Limb>, SetupError> {
    let mut chains: Vec<Vec<usize>> = Vec::new();
    let mut begins: Vec<usize> = tree.limbs_below(None);
    while let Some(first) = begins.pop() {
        let mut chain = vec![first];
        let mut at = first;
        loop {
            let mut below = tree.limbs_below(Some(at));
            let depth = |&i: &usize| count_joints_from(tree, i);
            // Of equal branches the first one continues.
            let Some(next) = below.iter().copied().rev().max_by_key(depth) else {
                break;
            };
            below.retain(|&other| other != next);
            begins.extend(below);
            chain.push(next);
            at = next;
        }
        chain.retain(|&joint| !tree.is_base(joint));
        chains.push(chain);
    }
    let is_arm_like = |chain: &&Vec<usize>| {
        let end = chain.iter().rev().take(NAMED_JOINTS);
        let mut names = end.flat_map(|&joint| {
            let joint = &tree.robot.joints()[joint];
            [&joint.name, &tree.robot.links()[joint.child.index()].name]
        });
        !names.any(|name| is_leg(name) || is_head(name))
    };
    let size = |chain: &&Vec<usize>| tree.count_variables(chain);
    let mut arms: Vec<&Vec<usize>> = chains.iter().filter(is_arm_like).collect();
    // The first joint along the tree comes first among equals.
    arms.sort_by_key(|chain| (std::cmp::Reverse(size(chain)), chain.last().copied()));
    let Some(&longest) = arms.first().filter(|chain| size(chain) >= MIN_ARM_JOINTS) else {
        let longest = arms.first();
        let last = longest.and_then(|chain| chain.last());
        let link = |&joint: &usize| tree.robot.joints()[joint].child.index();
        return Err(SetupError::NoArm {
            robot: tree.robot.name().to_owned(),
            joints: longest.map_or(0, size),
            tip: last.map(|joint| tree.robot.links()[link(joint)].name.clone()),
            limit: MIN_ARM_JOINTS,
        });
    };
    debug_assert!(!longest.is_empty());
    arms.retain(|chain| size(chain) >= MIN_ARM_JOINTS);
    arms.truncate(MAX_ARMS);
    let ends = arms.iter().filter_map(|chain| chain.last());
    let limbs = ends.map(|&last| {
        let joints = tree.path(last);
        let tip = choose_tip(tree, &joints, last);
        Limb { joints, tip }
    });
    Ok(limbs.collect())
}

/// Number of joints of the longest chain that begins with a joint.
fn count_joints_from(tree: &JointTree<'_>, joint: usize) -> usize {
    let mut most = 0;
    let mut open = vec![(joint, 1)];
    while let Some((at, depth)) = open.pop() {
        most = most.max(depth);
        let below = tree.limbs_below(Some(at)).into_iter();
        open.extend(below.map(|next| (next, depth + 1)));
    }
    most
}

/// Returns a name for each limb: "arm" for the only one, else with its side or number.
fn name_limbs(tree: &JointTree<'_>, limbs: &[Limb]) -> Vec<String> {
    let robot = tree.robot;
    let side_of = |limb: &Limb| {
        let joints = limb
            .joints
            .iter()
            .rev()
            .map(|&i| robot.joints()[i].name.as_str());
        let tip = robot.links()[limb.tip.link.index()].name.as_str();
        std::iter::once(tip).chain(joints).find_map(side)
    };
    let mut names: Vec<String> = Vec::new();
    for (i, limb) in limbs.iter().enumerate() {
        let name = match side_of(limb) {
            _ if limbs.len() == 1 => "arm".to_owned(),
            Some(side) => format!("{side}_arm"),
            None => format!("arm_{}", i + 1),
        };
        let is_taken = names.contains(&name);
        names.push(if is_taken {
            format!("{name}_{}", i + 1)
        } else {
            name
        });
    }
    names
}

/// Proposes the groups of a limb: with the joints that carry it, and without them if enough joints remain.
fn propose_groups(
    tree: &JointTree<'_>,
    limb: &Limb,
    name: &str,
    is_shared: impl Fn(usize) -> bool,
) -> Vec<ProposedGroup> {
    let robot = tree.robot;
    let slides = |joint: usize| robot.joints()[joint].kind == JointKind::Prismatic;
    let carries = |&joint: &usize| slides(joint) || is_shared(joint);
    let carriers = limb.joints.iter().copied().take_while(carries);
    let carriers: Vec<usize> = carriers.collect();
    let own = &limb.joints[carriers.len()..];
    let whole = &limb.joints[..];
    if carriers.is_empty() || tree.count_variables(own) < MIN_ARM_JOINTS {
        return vec![propose_group(tree, limb, whole, name, "")];
    }
    let is_vertical = |&joint: &usize| {
        let direction = direction_at_zero(robot, joint);
        direction.is_some_and(|z| z.abs() > MIN_VERTICAL)
    };
    let kind = match () {
        () if carriers.iter().any(|&joint| !slides(joint)) => "torso",
        () if carriers.iter().any(is_vertical) => "lift",
        () => "rail",
    };
    let with = format!("{name}_with_{kind}");
    vec![
        propose_group(tree, limb, whole, &with, &format!(", with the {kind}")),
        propose_group(tree, limb, own, name, &format!(", without the {kind}")),
    ]
}

fn propose_group(
    tree: &JointTree<'_>,
    limb: &Limb,
    joints: &[usize],
    name: &str,
    extent: &str,
) -> ProposedGroup {
    let robot = tree.robot;
    let first = joints.first().copied();
    let parent = first.map_or(robot.root(), |i| robot.joints()[i].parent);
    let platform = tree
        .platform()
        .filter(|_| first == limb.joints.first().copied());
    let base = platform.unwrap_or(parent);
    let link = |link: LinkId| &robot.links()[link.index()].name;
    let count = tree.count_variables(joints);
    ProposedGroup {
        reason: format!(
            "{count} joints from {} to {}{extent}. Tip: {}.",
            link(base),
            link(limb.tip.link),
            limb.tip.reason
        ),
        group: Group {
            name: name.to_owned(),
            base,
            tip: limb.tip.link,
        },
        joints: count,
    }
}

/// Returns the vertical part of a joint's axis when all variables are 0.
fn direction_at_zero(robot: &RobotModel, joint: usize) -> Option<f64> {
    let kinematics = robot.forward_kinematics(&vec![0.0; robot.dof()]).ok()?;
    let joint = &robot.joints()[joint];
    let world_from_child = kinematics.world_from_link(joint.child);
    Some((world_from_child.rotation * joint.axis.into_inner()).z)
}
