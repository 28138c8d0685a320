//! The tree of a robot's moving joints, without fixed joints.

use super::link_names::{is_finger, is_gripper, is_wrist};
use crate::geometry::Vector3;
use crate::{Joint, JointId, JointKind, LinkId, RobotModel};

/// Least number of independent joints of an arm.
pub(super) const MIN_ARM_JOINTS: usize = 4;
/// Largest length of a finger, as a share of the length of the arm that carries it [1].
const MAX_FINGER_SHARE: f64 = 0.35;
/// Largest travel of a finger that slides [m].
const MAX_FINGER_TRAVEL: f64 = 0.15;

/// The moving joints of a robot; indices are those of [`RobotModel::joints`].
pub(super) struct JointTree<'a> {
    pub robot: &'a RobotModel,
    /// The next moving joint above each joint.
    above: Vec<Option<usize>>,
    /// The next moving joints below each joint; empty for a fixed joint.
    below: Vec<Vec<usize>>,
    /// Joints that move a base over the floor.
    base: Vec<usize>,
    /// Whether each joint is part of a gripper.
    is_gripper: Vec<bool>,
}

impl<'a> JointTree<'a> {
    pub fn new(robot: &'a RobotModel) -> Self {
        let count = robot.joints().len();
        let mut tree = Self {
            robot,
            above: vec![None; count],
            below: vec![Vec::new(); count],
            base: Vec::new(),
            is_gripper: vec![false; count],
        };
        for (i, joint) in robot.joints().iter().enumerate() {
            let above = tree.moving_above(joint.parent);
            tree.above[i] = above;
            if let (true, Some(above)) = (moves(joint), above) {
                tree.below[above].push(i);
            }
        }
        tree.base = tree.find_planar_base();
        // A joint comes after the joints above it.
        for i in 0..count {
            let carrier = tree.above[i];
            tree.is_gripper[i] = carrier.is_some_and(|above| tree.is_gripper[above])
                || moves(&robot.joints()[i]) && tree.begins_gripper(i);
        }
        tree
    }

    /// Returns the nearest moving joint above a link.
    pub fn moving_above(&self, link: LinkId) -> Option<usize> {
        let joint = |link: LinkId| self.robot.links()[link.index()].parent.map(JointId::index);
        let upward =
            std::iter::successors(joint(link), |&at| joint(self.robot.joints()[at].parent));
        upward
            .into_iter()
            .find(|&at| moves(&self.robot.joints()[at]))
    }

    /// Returns the moving joints from the first one after a mobile base to the joint `last`.
    pub fn path(&self, last: usize) -> Vec<usize> {
        let upward = std::iter::successors(Some(last), |&at| self.above[at]);
        let mut path: Vec<usize> = upward.filter(|at| !self.base.contains(at)).collect();
        path.reverse();
        path
    }

    /// Returns the moving joints of an arm directly below a joint, or those without a joint above.
    pub fn limbs_below(&self, joint: Option<usize>) -> Vec<usize> {
        let all = 0..self.above.len();
        let begins = |&i: &usize| {
            moves(&self.robot.joints()[i]) && self.above[i] == joint && !self.is_gripper[i]
        };
        all.filter(begins).collect()
    }

    /// Whether a link is part of a gripper: by its name, or because a finger or another part is fixed to it.
    pub fn is_gripper_link(&self, link: LinkId) -> bool {
        is_gripper(&self.robot.links()[link.index()].name) || self.finger_on(link).is_some()
    }

    /// Returns the link of the first moving part of a gripper on a link.
    pub fn finger_on(&self, link: LinkId) -> Option<LinkId> {
        let mut joints = self.robot.joints().iter().enumerate();
        let finger =
            joints.find(|(i, joint)| joint.parent == link && self.is_gripper[*i] && moves(joint));
        finger.map(|(_, joint)| joint.child)
    }

    /// Returns the link that a mobile base moves; `None` for a robot without one.
    pub fn platform(&self) -> Option<LinkId> {
        let last = self.base.last()?;
        Some(self.robot.joints()[*last].child)
    }

    /// Whether a joint is part of a mobile base.
    pub fn is_base(&self, joint: usize) -> bool {
        self.base.contains(&joint)
    }

    /// Number of variables that move the joints of a path.
    pub fn count_variables(&self, path: &[usize]) -> usize {
        let terms = path
            .iter()
            .flat_map(|&i| &self.robot.joints()[i].drive.terms);
        let mut variables: Vec<usize> = terms.map(|&(variable, _)| variable).collect();
        variables.sort_unstable();
        variables.dedup();
        variables.len()
    }

    /// Returns the joints of a base that slides along x and y and rotates about z, if the robot begins with one.
    fn find_planar_base(&self) -> Vec<usize> {
        let parts = [
            (JointKind::Prismatic, Vector3::x()),
            (JointKind::Prismatic, Vector3::y()),
            (JointKind::Revolute, Vector3::z()),
        ];
        let mut base = Vec::new();
        for (kind, axis) in parts {
            let last = base.last().copied();
            let next = self.limbs_below(last);
            let is_part = |&i: &usize| {
                let joint = &self.robot.joints()[i];
                let is_own = matches!(joint.drive.terms[..], [(_, 1.0)]);
                joint.kind == kind && joint.axis.into_inner() == axis && is_own
            };
            match next[..] {
                [only] if is_part(&only) => base.push(only),
                _ => return Vec::new(),
            }
        }
        base
    }

    /// Whether a gripper begins with this joint: it hangs on an arm, and its name, its motion or its size say so.
    fn begins_gripper(&self, joint: usize) -> bool {
        let Some(above) = self.above[joint] else {
            return false;
        };
        let arm = self.path(above);
        if self.count_variables(&arm) < MIN_ARM_JOINTS {
            return false;
        }
        let own = &self.robot.joints()[joint];
        let child = &self.robot.links()[own.child.index()].name;
        let is_named = is_gripper(&own.name) || is_finger(child);
        if is_named && !is_wrist(&own.name) {
            return true;
        }
        let variables: Vec<usize> = (arm.iter())
            .flat_map(|&i| self.robot.joints()[i].drive.terms.iter().map(|&(v, _)| v))
            .collect();
        let follows_finger =
            !self.is_variable(joint) && !own.drive.terms.iter().any(|(v, _)| variables.contains(v));
        let travel = own
            .limits
            .position
            .map_or(f64::INFINITY, |l| l.upper - l.lower);
        let slides_little = own.kind == JointKind::Prismatic
            && travel <= MAX_FINGER_TRAVEL
            && self.below[joint].is_empty()
            && arm.len() > MIN_ARM_JOINTS;
        follows_finger || slides_little || self.is_finger_among_others(above, &arm)
    }

    /// Whether several short branches hang on a joint, as the fingers of a hand do.
    fn is_finger_among_others(&self, above: usize, arm: &[usize]) -> bool {
        let branches = &self.below[above];
        let length: f64 = arm.iter().map(|&i| self.offset(i)).sum();
        let is_short =
            |&i: &usize| self.offset(i) + self.length_below(i) <= MAX_FINGER_SHARE * length;
        branches.len() > 1 && branches.iter().all(is_short)
    }

    fn is_variable(&self, joint: usize) -> bool {
        self.robot.variables().iter().any(|id| id.index() == joint)
    }

    /// Distance of a joint from the next moving joint above it, along the fixed joints between them [m].
    fn offset(&self, joint: usize) -> f64 {
        let mut at = joint;
        let mut offset = 0.0;
        loop {
            let own = &self.robot.joints()[at];
            offset += own.parent_from_joint.translation.vector.norm();
            match self.robot.links()[own.parent.index()].parent {
                Some(id) if !moves(&self.robot.joints()[id.index()]) => at = id.index(),
                _ => return offset,
            }
        }
    }

    /// Length of the longest branch below a joint [m].
    fn length_below(&self, joint: usize) -> f64 {
        let mut longest: f64 = 0.0;
        let mut open: Vec<(usize, f64)> = vec![(joint, 0.0)];
        while let Some((at, length)) = open.pop() {
            longest = longest.max(length);
            let below = self.below[at].iter();
            open.extend(below.map(|&next| (next, length + self.offset(next))));
        }
        longest
    }
}

fn moves(joint: &Joint) -> bool {
    joint.kind != JointKind::Fixed && joint.drive.terms.iter().any(|&(_, factor)| factor != 0.0)
}
