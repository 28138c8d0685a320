//! The chain that a map is made of: where it may be, and how it gets from one pose to one nearby.

use super::{MapError, MapTool};
use crate::geometry::{Point3, Pose, Vector3};
use crate::robot::{Chain, Drive, JointKind, LinkId, MAX_CHAIN, Range, RobotModel};
use nalgebra::{SMatrix, SVector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;

/// Positions of a chain's variables [rad or m]; those beyond its number of variables do not count.
pub(super) type Positions = [f64; MAX_CHAIN];

pub(super) struct Arm {
    pub(super) chain: Chain,
    tip_from_tool: Pose,
    /// Limits of the chain's variables; infinite for a joint that turns without limits.
    ranges: Vec<Range>,
    /// Joints of the robot that follow variables of the chain, and their limits.
    followers: Vec<(Drive, Range)>,
    /// Farthest that the tool can be from the base [m].
    pub(super) reach: f64,
}

/// Where a tool is and where its z axis points, in the base.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolGoal {
    pub(super) point: Point3,
    pub(super) axis: Vector3,
}

const ROUND_AND_ROUND: Range = Range {
    lower: f64::NEG_INFINITY,
    upper: f64::INFINITY,
};
const ONCE_ROUND: Range = Range {
    lower: -PI,
    upper: PI,
};

/// How near to a goal counts as there: far below a cell.
const POINT_TOLERANCE: f64 = 1e-3; // [m]
const AXIS_TOLERANCE: f64 = 5e-3; // [rad]

/// A radian of the tool's axis counts as this many metres: about a hand and its tool.
const LENGTH_PER_RADIAN: f64 = 0.2;

/// Steps after which a goal is given up. From a cell to the next three or four are enough.
const MAX_STEPS: usize = 15;

/// Most that a joint moves in a step [rad or m]: the tool's motion is not linear beyond.
const MAX_STEP: f64 = 0.5;

/// Damping of the first step [m²], the least and the most; beyond it steps are too short to help.
const DAMPING: f64 = 1e-4;
const MIN_DAMPING: f64 = 1e-9;
const MAX_DAMPING: f64 = 1.0;

/// A step that leaves more than this share of the error is the last: the goal is out of reach.
const STALLED: f64 = 0.98;

/// Offset of the tool from its goal: three of place, two of the axis in the tool's x and y [m].
type Offset = SVector<f64, 5>;

/// How the tool moves with each variable, in the same rows.
type Rates = SMatrix<f64, 5, MAX_CHAIN>;

impl Arm {
    pub(super) fn new(tool: &MapTool<'_>) -> Result<Self, MapError> {
        let &MapTool {
            robot,
            base,
            tip,
            tip_from_tool,
            ..
        } = tool;
        let chain = robot.chain(base, tip)?;
        let mut ranges = Vec::with_capacity(chain.dof());
        for &variable in chain.variables() {
            let joint = robot.variable(variable);
            ranges.push(match joint.limits.position {
                Some(range) => range,
                None if joint.kind == JointKind::Revolute => ROUND_AND_ROUND,
                None => return Err(unlimited(&joint.name)),
            });
        }
        let follows_the_chain = |drive: &Drive| {
            let is_own = |(variable, _): &(usize, f64)| chain.variables().contains(variable);
            drive.terms.iter().any(is_own)
        };
        let followers = robot.joints().iter().filter_map(|joint| {
            let limits = joint.limits.position?;
            follows_the_chain(&joint.drive).then(|| (joint.drive.clone(), limits))
        });
        Ok(Self {
            followers: followers.collect(),
            reach: reach(robot, base, tip)? + tip_from_tool.translation.vector.norm(),
            chain,
            tip_from_tool,
            ranges,
        })
    }

    /// Positions anywhere within the limits of the variables; once round if there are none.
    pub(super) fn sample(&self, random: &mut ChaCha8Rng) -> Positions {
        let mut q = [0.0; MAX_CHAIN];
        for (q, range) in q.iter_mut().zip(&self.ranges) {
            let Range { lower, upper } = if *range == ROUND_AND_ROUND {
                ONCE_ROUND
            } else {
                *range
            };
            *q = lower + (upper - lower) * random.random::<f64>();
        }
        q
    }

    /// Whether all joints that move with the chain are within their limits at these positions of the
    /// robot.
    pub(super) fn is_within_limits(&self, all: &[f64]) -> bool {
        self.followers
            .iter()
            .all(|(drive, limits)| (limits.lower..=limits.upper).contains(&drive.position(all)))
    }

    /// The tool at these positions.
    pub(super) fn tool(&self, q: &Positions) -> Option<ToolGoal> {
        let kinematics = self.chain.forward_kinematics(&q[..self.chain.dof()]).ok()?;
        let base_from_tool = kinematics.base_from_tip() * self.tip_from_tool;
        Some(ToolGoal {
            point: base_from_tool.translation.vector.into(),
            axis: base_from_tool.rotation * Vector3::z(),
        })
    }

    /// Positions within the limits of the variables that put the tool to a goal, by a descent from
    /// positions that put it nearby (Levenberg 1944, Marquardt 1963). Joints at a limit that would go
    /// further stand still. None if the descent ends elsewhere.
    pub(super) fn approach(&self, goal: &ToolGoal, start: &Positions) -> Option<Positions> {
        let mut q = *start;
        for (q, range) in q.iter_mut().zip(&self.ranges) {
            *q = q.max(range.lower).min(range.upper);
        }
        let (mut offset, mut rates) = self.offset(goal, &q)?;
        let mut damping = DAMPING;
        for _ in 0..MAX_STEPS {
            if is_there(&offset) {
                return Some(q);
            }
            let next = self.step(&q, &offset, &rates, damping)?;
            let (next_offset, next_rates) = self.offset(goal, &next)?;
            let left = next_offset.norm() / offset.norm();
            if left < 1.0 {
                (q, offset, rates) = (next, next_offset, next_rates);
                damping = (damping / 4.0).max(MIN_DAMPING);
            } else {
                damping *= 10.0;
            }
            if damping > MAX_DAMPING || (STALLED..1.0).contains(&left) {
                break;
            }
        }
        is_there(&offset).then_some(q)
    }

    /// One damped step towards the goal: Jᵀ (J Jᵀ + λ)⁻¹ e of the joints that may move.
    fn step(
        &self,
        q: &Positions,
        offset: &Offset,
        rates: &Rates,
        damping: f64,
    ) -> Option<Positions> {
        let ranges = self.ranges.iter().enumerate();
        let mut moving = *rates;
        for (i, range) in ranges.clone() {
            let towards = rates.column(i).dot(offset);
            if (towards > 0.0 && q[i] >= range.upper) || (towards < 0.0 && q[i] <= range.lower) {
                moving.column_mut(i).fill(0.0);
            }
        }
        let mut normal = SMatrix::<f64, 5, 5>::identity() * damping;
        for (i, _) in ranges.clone() {
            normal.ger(1.0, &moving.column(i), &moving.column(i), 1.0);
        }
        let along = normal.cholesky()?.solve(offset);
        let mut next = *q;
        for (i, range) in ranges {
            let step = moving.column(i).dot(&along).clamp(-MAX_STEP, MAX_STEP);
            next[i] = (q[i] + step).max(range.lower).min(range.upper);
        }
        Some(next)
    }

    fn offset(&self, goal: &ToolGoal, q: &Positions) -> Option<(Offset, Rates)> {
        let kinematics = self.chain.forward_kinematics(&q[..self.chain.dof()]).ok()?;
        let base_from_tool = kinematics.base_from_tip() * self.tip_from_tool;
        let axes = base_from_tool.rotation.to_rotation_matrix();
        let [x, y, z] = [0, 1, 2].map(|i| Vector3::from(axes.matrix().column(i)));
        let place = goal.point.coords - base_from_tool.translation.vector;
        let turn = turn_between(&z, &goal.axis, &x) * LENGTH_PER_RADIAN;
        let offset = Offset::new(place.x, place.y, place.z, x.dot(&turn), y.dot(&turn));
        let tool_in_tip = Point3::from(self.tip_from_tool.translation.vector);
        let jacobian = kinematics.jacobian(tool_in_tip);
        let mut rates = Rates::zeros();
        for (mut rates, column) in rates.column_iter_mut().zip(jacobian.view().column_iter()) {
            let turn = Vector3::from(column.fixed_rows::<3>(3)) * LENGTH_PER_RADIAN;
            rates
                .fixed_rows_mut::<3>(0)
                .copy_from(&column.fixed_rows::<3>(0));
            (rates[3], rates[4]) = (x.dot(&turn), y.dot(&turn));
        }
        Some((offset, rates))
    }
}

fn is_there(offset: &Offset) -> bool {
    offset.fixed_rows::<3>(0).norm() <= POINT_TOLERANCE
        && offset.fixed_rows::<2>(3).norm() <= AXIS_TOLERANCE * LENGTH_PER_RADIAN
}

/// The rotation vector [rad] that turns one direction into another; `across` if they are opposite.
fn turn_between(from: &Vector3, to: &Vector3, across: &Vector3) -> Vector3 {
    let normal = from.cross(to);
    let (sin, cos) = (normal.norm(), from.dot(to));
    let angle = sin.atan2(cos);
    if sin > 0.0 {
        normal * (angle / sin)
    } else {
        across * angle
    }
}

/// Sum of the distances between the joints from `base` to `tip`, stretched as far as they slide [m].
fn reach(robot: &RobotModel, base: LinkId, tip: LinkId) -> Result<f64, MapError> {
    let mut reach = 0.0;
    let mut at = tip;
    while let Some(id) = robot.links()[at.index()].parent
        && at != base
    {
        let joint = &robot.joints()[id.index()];
        reach += joint.parent_from_joint.translation.vector.norm();
        if joint.kind == JointKind::Prismatic {
            let limits = joint
                .limits
                .position
                .ok_or_else(|| unlimited(&joint.name))?;
            reach += limits.lower.abs().max(limits.upper.abs());
        }
        at = joint.parent;
    }
    Ok(reach)
}

fn unlimited(joint: &str) -> MapError {
    MapError::Unlimited {
        joint: joint.to_owned(),
    }
}
