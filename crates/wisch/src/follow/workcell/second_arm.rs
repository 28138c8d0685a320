//! The second hand on a tool: its arm follows the leading arm.
//!
//! The hand's outermost point stays at the tool's second grip. The hand turns freely about the bar there, and
//! leans on it no further than the grip allows. Between two configurations it turns as little as possible, so
//! that the path of the leading arm determines that of the second.

use super::grasp::tip_from_hand;
use crate::follow::{FollowError, GripDeviation, Obstruction};
use crate::geometry::{Point3, Pose, Vector3};
use crate::represent::SecondGrip;
use crate::robot::{
    Chain, IkConfig, IkOutcome, IkSolver, JointPositions, LinkAxis, LinkId, RobotError, RobotModel,
    RotationGoal, rotation_from_z,
};
use nalgebra::{Translation3, Unit, UnitQuaternion};
use std::f64::consts::FRAC_PI_2;

/// Largest distance of the second hand from its grip on the tool \[m\].
pub const GRIP_TOLERANCE: f64 = 2e-3;
/// Allowance by which a hand may lean on its bar beyond the limit, for rounding and between samples \[rad\].
pub const LEAN_TOLERANCE: f64 = 1e-2;

/// An arm that holds the tool of another, leading arm.
#[derive(Debug, Clone)]
pub struct SecondArm {
    /// Inverse kinematics from the link at which the arms part to the hand. The z axis of its tool
    /// is the hand's y axis.
    ik: IkSolver,
    /// Chain from the group's base to that link.
    trunk: Chain,
    /// Indices of the trunk's variables among the leading arm's.
    trunk_in_leading: Vec<usize>,
    /// Chain from the group's base to the leading hand.
    leading: Chain,
    leading_tip_from_tool: Pose,
    tip_from_hand: Pose,
    grip: SecondGrip,
}

impl GripDeviation {
    /// Whether the hand keeps its grip.
    pub fn is_held(&self) -> bool {
        self.position <= GRIP_TOLERANCE && self.lean <= LEAN_TOLERANCE
    }

    /// Returns for each component the larger of both deviations.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            lean: self.lean.max(other.lean),
        }
    }
}

impl SecondArm {
    /// Returns the arm that ends at `tip`, beside a leading arm.
    ///
    /// # Errors
    /// The arm has no variable of its own, or shares one with the leading arm.
    pub(in crate::follow) fn new(
        robot: &RobotModel,
        leading: &IkSolver,
        leading_tip_from_tool: Pose,
        tip: LinkId,
        grip: SecondGrip,
        posture: &[f64],
        limit_margin: f64,
    ) -> Result<Self, FollowError> {
        let leading = leading.chain();
        let fork = fork(robot, leading.tip(), tip);
        let trunk = robot.chain(leading.base(), fork)?;
        // The tool's z axis becomes the hand's y axis.
        let y_for_z = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -FRAC_PI_2);
        let tip_from_hand = tip_from_hand(robot, tip, LinkAxis::default(), posture)?;
        let ik = IkSolver::new(robot, fork, tip, tip_from_hand * y_for_z)?;
        let own = ik.chain().variables();
        if own.is_empty() {
            return Err(FollowError::NoSecondArm {
                link: robot.links()[tip.index()].name.clone(),
            });
        }
        if let Some(&shared) = own.iter().find(|i| leading.variables().contains(i)) {
            return Err(FollowError::SharedJoint {
                link: robot.links()[tip.index()].name.clone(),
                joint: robot.variable(shared).name.clone(),
            });
        }
        let posture: Vec<f64> = own.iter().map(|&i| posture[i]).collect();
        let place = |i: &usize| leading.variables().binary_search(i).ok();
        Ok(Self {
            trunk_in_leading: trunk.variables().iter().filter_map(place).collect(),
            trunk,
            leading: leading.clone(),
            leading_tip_from_tool,
            tip_from_hand,
            grip,
            ik: (ik.with_posture(&posture)?).with_limit_margin(limit_margin)?,
        })
    }

    /// The chain from the link at which the arms part to the second hand.
    pub const fn chain(&self) -> &Chain {
        self.ik.chain()
    }

    /// Returns the pose of the tool from the link at which the arms part.
    fn fork_from_tool(&self, leading: &[f64]) -> Result<Pose, RobotError> {
        let trunk: JointPositions = (self.trunk_in_leading.iter())
            .map(|&i| leading[i])
            .collect();
        let base_from_fork = self.trunk.forward_kinematics(&trunk)?.base_from_tip();
        let base_from_tip = self.leading.forward_kinematics(leading)?.base_from_tip();
        Ok(base_from_fork.inv_mul(&(base_from_tip * self.leading_tip_from_tool)))
    }

    /// Returns the pose for the second hand: its origin at the grip, its z axis along the hand's y axis, as
    /// near to `hand` as the bar allows.
    fn fork_from_grip(&self, fork_from_tool: &Pose, hand: &Vector3) -> Pose {
        let point = fork_from_tool * self.grip.point_in_tool;
        let bar = fork_from_tool * self.grip.axis_in_tool.into_inner();
        let along = limit_lean(&bar, hand, self.grip.max_lean);
        Pose::from_parts(Translation3::from(point), rotation_from_z(&along))
    }

    /// Returns positions of the second arm that keep the grip for these positions of the leading
    /// arm, near `start`. The hand keeps its current lean or, if that is out of reach, is set
    /// square to the bar.
    pub(in crate::follow) fn hold(
        &self,
        leading: &[f64],
        start: &[f64],
        config: &IkConfig,
    ) -> Result<JointPositions, Obstruction> {
        let solve = |fork_from_tool: &Pose, hand: &Vector3| {
            let target = self.fork_from_grip(fork_from_tool, hand);
            (self.ik).solve_from(&target, RotationGoal::AboutToolZFree, start, config)
        };
        let wanted = self
            .fork_from_tool(leading)
            .and_then(|fork_from_tool| Ok((fork_from_tool, self.hand_axis(start)?)));
        // All positions are computed here and finite.
        let (fork_from_tool, hand) = wanted.map_err(|_| Obstruction::unreachable())?;
        to_configuration(solve(&fork_from_tool, &hand)).or_else(|_| {
            let bar = fork_from_tool * self.grip.axis_in_tool.into_inner();
            to_configuration(solve(&fork_from_tool, &(bar * bar.dot(&hand).signum())))
        })
    }

    /// Does the same as [`Self::hold`] from several starts, then from random starts.
    pub(in crate::follow) fn hold_from_any_start(
        &self,
        leading: &[f64],
        starts: &[&[f64]],
        seed: u64,
        config: &IkConfig,
    ) -> Result<JointPositions, Obstruction> {
        let near = starts.iter().map(|start| self.hold(leading, start, config));
        if let Some(found) = near.into_iter().find_map(Result::ok) {
            return Ok(found);
        }
        let mut last = Obstruction::unreachable();
        for sign in [1.0, -1.0] {
            let solve = || {
                let fork_from_tool = self.fork_from_tool(leading)?;
                let bar = fork_from_tool * self.grip.axis_in_tool.into_inner();
                let target = self.fork_from_grip(&fork_from_tool, &(sign * bar));
                (self.ik).solve(&target, RotationGoal::AboutToolZFree, &[], seed, config)
            };
            match to_configuration(solve()) {
                Ok(found) => return Ok(found),
                Err(obstruction) => last = obstruction,
            }
        }
        Err(last)
    }

    fn hand_axis(&self, second: &[f64]) -> Result<Vector3, RobotError> {
        let fork_from_tip = self.chain().forward_kinematics(second)?.base_from_tip();
        Ok(fork_from_tip * Vector3::y())
    }

    /// Position and direction of the second hand's grip on the tool, in the tool frame.
    pub const fn grip(&self) -> &SecondGrip {
        &self.grip
    }

    /// The end of the second hand in the frame of its link.
    pub const fn tip_from_hand(&self) -> &Pose {
        &self.tip_from_hand
    }

    /// Deviation of the hand from its grip.
    pub(in crate::follow) fn deviation(
        &self,
        leading: &[f64],
        second: &[f64],
    ) -> Result<GripDeviation, RobotError> {
        let fork_from_tip = self.chain().forward_kinematics(second)?.base_from_tip();
        let fork_from_hand = fork_from_tip * self.tip_from_hand;
        let fork_from_tool = self.fork_from_tool(leading)?;
        Ok(off_grip(&self.grip, &fork_from_tool, &fork_from_hand))
    }
}

/// Returns the deviation of a hand from a grip on a tool, both in one frame.
pub(in crate::follow) fn off_grip(
    grip: &SecondGrip,
    from_tool: &Pose,
    from_hand: &Pose,
) -> GripDeviation {
    let hand: Point3 = from_hand.translation.vector.into();
    let bar = from_tool * grip.axis_in_tool.into_inner();
    let across = from_hand * Vector3::y();
    let angle = bar.cross(&across).norm().atan2(bar.dot(&across).abs());
    GripDeviation {
        position: (from_tool * grip.point_in_tool - hand).norm(),
        lean: (angle - grip.max_lean).max(0.0),
    }
}

/// Returns the direction nearest to `hand` that is within `max_lean` of the bar; the bar has no sense of
/// direction.
fn limit_lean(bar: &Vector3, hand: &Vector3, max_lean: f64) -> Vector3 {
    let bar = if bar.dot(hand) < 0.0 { -bar } else { *bar };
    let normal = bar.cross(hand);
    let angle = normal.norm().atan2(bar.dot(hand));
    if angle <= max_lean {
        return *hand;
    }
    UnitQuaternion::from_axis_angle(&Unit::new_normalize(normal), max_lean) * bar
}

fn to_configuration(outcome: Result<IkOutcome, RobotError>) -> Result<JointPositions, Obstruction> {
    match outcome {
        Ok(IkOutcome::Solved(q)) => Ok(q),
        Ok(IkOutcome::Stuck {
            position_error,
            rotation_error,
            ..
        }) => Err(Obstruction::SecondHand {
            position_error,
            rotation_error,
        }),
        // All poses and starts are computed here and finite.
        Err(_) => Err(Obstruction::unreachable()),
    }
}

/// Returns the last link that is common to the chains of two links.
fn fork(robot: &RobotModel, a: LinkId, b: LinkId) -> LinkId {
    let up = |link| std::iter::once(link).chain(robot.joints_above(link).map(|joint| joint.parent));
    let of_a: Vec<LinkId> = up(a).collect();
    (up(b).find(|link| of_a.contains(link))).unwrap_or_else(|| robot.root())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn unit() -> impl Strategy<Value = Vector3> {
        [-1.0..1.0, -1.0..1.0, -1.0..1.0]
            .prop_map(Vector3::from)
            .prop_filter("long enough to normalize", |v| v.norm() > 1e-2)
            .prop_map(|v| v.normalize())
    }

    proptest! {
        #[test]
        fn a_hand_leans_no_further_than_allowed_and_turns_no_more_than_it_must(
            bar in unit(), hand in unit(), max_lean in 0.0..FRAC_PI_2,
        ) {
            let along = limit_lean(&bar, &hand, max_lean);
            let line = |v: &Vector3| bar.cross(v).norm().atan2(bar.dot(v).abs());
            prop_assert!((along.norm() - 1.0).abs() < 1e-12);
            prop_assert!(line(&along) <= max_lean + 1e-9);
            let turned = along.cross(&hand).norm().atan2(along.dot(&hand));
            prop_assert!((turned - (line(&hand) - max_lean).max(0.0)).abs() < 1e-9);
        }
    }

    #[test]
    fn a_hand_beside_or_along_its_bar_is_off_its_grip_by_just_that() {
        let grip = SecondGrip {
            point_in_tool: Point3::new(0.0, 0.0, 1.0),
            axis_in_tool: Vector3::z_axis(),
            max_lean: 0.5,
        };
        let tool = Pose::new(Vector3::new(0.3, -0.2, 0.1), Vector3::new(0.2, 0.5, -0.4));
        let leaning = |lean: f64| {
            let y_up = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2 + lean);
            tool * Pose::from_parts(Translation3::new(0.0, 0.003, 1.004), y_up)
        };
        for (lean, too_far) in [
            (0.0, 0.0),
            (0.4, 0.0),
            (0.7, 0.2),
            (PI, 0.0),
            (PI - 0.6, 0.1),
        ] {
            let off = off_grip(&grip, &tool, &leaning(lean));
            assert!((off.position - 0.005).abs() < 1e-12);
            assert!((off.lean - too_far).abs() < 1e-9, "{lean}: {}", off.lean);
            assert!(!off.is_held());
        }
        let held = tool * Pose::new(Vector3::z(), Vector3::x() * FRAC_PI_2);
        assert!(off_grip(&grip, &tool, &held).is_held());
    }
}
