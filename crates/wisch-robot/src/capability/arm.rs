//! The chain of a capability map: sampling within its limits, and descent from a pose to a nearby one.

use super::{MapError, MapRequest};
use crate::frame::rotation_from_z;
use crate::geometry::{Point3, Pose, Vector3};
use crate::{
    Drive, IkConfig, IkOutcome, IkSolver, JointKind, LinkId, MAX_CHAIN, Range, RobotModel,
    RotationGoal,
};
use nalgebra::Translation3;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;

/// Positions of a chain's variables [rad or m]; entries beyond the number of variables are unused.
pub(super) type Positions = [f64; MAX_CHAIN];

pub(super) struct Arm {
    solver: IkSolver,
    tip_from_tool: Pose,
    /// Ranges from which the chain's variables are sampled.
    ranges: Vec<Range>,
    /// Joints of the robot that follow the chain, with their limits.
    followers: Vec<(Drive, Range)>,
    /// Largest distance of the tool from the base [m].
    pub(super) reach: f64,
}

/// Position of the tool and direction of its z axis, in the base.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolGoal {
    pub(super) point: Point3,
    pub(super) axis: Vector3,
}

/// Range from which a revolute joint without limits is sampled.
const ONCE_ROUND: Range = Range {
    lower: -PI,
    upper: PI,
};

/// Settings of a descent to a goal one cell away. Tolerances are far below a cell, and three or four steps are enough;
/// a goal that takes many more is out of reach.
const DESCENT: IkConfig = IkConfig {
    position_tolerance: 1e-3,
    rotation_tolerance: 5e-3,
    max_iterations: 15,
    max_restarts: 0,
    posture_gain: 0.0,
    limit_gain: 0.0,
    max_step: 0.5,
};

impl Arm {
    pub(super) fn new(tool: &MapRequest<'_>) -> Result<Self, MapError> {
        let robot = tool.robot;
        let solver = IkSolver::new(robot, tool.base, tool.tip, tool.tip_from_tool)?;
        let variables = solver.chain().variables();
        let mut ranges = Vec::with_capacity(variables.len());
        for &variable in variables {
            let joint = robot.variable(variable);
            ranges.push(match joint.limits.position {
                Some(range) => range,
                None if joint.kind == JointKind::Revolute => ONCE_ROUND,
                None => return Err(unlimited(&joint.name)),
            });
        }
        let moves_with_chain =
            |drive: &Drive| drive.terms.iter().any(|(i, _)| variables.contains(i));
        let followers = robot.joints().iter().filter_map(|joint| {
            let limits = joint.limits.position?;
            moves_with_chain(&joint.drive).then(|| (joint.drive.clone(), limits))
        });
        Ok(Self {
            followers: followers.collect(),
            reach: reach(robot, tool.base, tool.tip)?
                + tool.tip_from_tool.translation.vector.norm(),
            solver,
            tip_from_tool: tool.tip_from_tool,
            ranges,
        })
    }

    /// Index of each variable of the chain among the robot's variables.
    pub(super) fn variables(&self) -> &[usize] {
        self.solver.chain().variables()
    }

    /// Draws positions within the limits of the variables; a full turn if there are none.
    pub(super) fn sample(&self, random: &mut ChaCha8Rng) -> Positions {
        let mut q = [0.0; MAX_CHAIN];
        for (q, range) in q.iter_mut().zip(&self.ranges) {
            *q = range.lower + (range.upper - range.lower) * random.random::<f64>();
        }
        q
    }

    /// Whether all joints that follow the chain are within their limits at these positions of the robot.
    pub(super) fn is_within_limits(&self, all: &[f64]) -> bool {
        self.followers
            .iter()
            .all(|(drive, limits)| (limits.lower..=limits.upper).contains(&drive.position(all)))
    }

    /// Returns the tool at these positions.
    pub(super) fn tool(&self, q: &Positions) -> Option<ToolGoal> {
        let chain = self.solver.chain();
        let kinematics = chain.forward_kinematics(&q[..chain.dof()]).ok()?;
        let base_from_tool = kinematics.base_from_tip() * self.tip_from_tool;
        Some(ToolGoal {
            point: base_from_tool.translation.vector.into(),
            axis: base_from_tool.rotation * Vector3::z(),
        })
    }

    /// Returns positions that put the tool at a goal, by a descent from nearby positions.
    pub(super) fn approach(&self, goal: &ToolGoal, start: &Positions) -> Option<Positions> {
        let place = Translation3::from(goal.point.coords);
        let base_from_tool = Pose::from_parts(place, rotation_from_z(&goal.axis));
        let start = &start[..self.variables().len()];
        let free = RotationGoal::AboutToolZFree;
        match self
            .solver
            .solve_from(&base_from_tool, free, start, &DESCENT)
        {
            Ok(IkOutcome::Solved(found)) => {
                let mut q = [0.0; MAX_CHAIN];
                q[..found.len()].copy_from_slice(&found);
                Some(q)
            }
            _ => None,
        }
    }
}

/// Returns the sum of the distances between the joints from `base` to `tip`, with sliding joints fully extended [m].
fn reach(robot: &RobotModel, base: LinkId, tip: LinkId) -> Result<f64, MapError> {
    let mut reach = 0.0;
    for joint in robot
        .joints_above(tip)
        .take_while(|joint| joint.child != base)
    {
        reach += joint.parent_from_joint.translation.vector.norm();
        if joint.kind == JointKind::Prismatic {
            let limits = joint.limits.position;
            let limits = limits.ok_or_else(|| unlimited(&joint.name))?;
            reach += limits.lower.abs().max(limits.upper.abs());
        }
    }
    Ok(reach)
}

fn unlimited(joint: &str) -> MapError {
    MapError::Unlimited {
        joint: joint.to_owned(),
    }
}
