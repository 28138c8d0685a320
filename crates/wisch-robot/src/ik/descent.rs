//! Descent from one start: damped steps, each accepted only if it lowers the error.

use super::error::{Target, TaskError};
use super::step::Task;
use super::{IkConfig, IkOutcome, IkSolver, JointPositions, MAX_CHAIN, RotationGoal};
use crate::geometry::Vector3;
use crate::{ChainKinematics, RobotError};
use nalgebra::Vector6;

/// Least damping, which keeps J Jᵀ invertible at singularities.
pub(super) const MIN_DAMPING: f64 = 1e-10;

/// Damping over the squared error: initial value and range.
const DAMPING: f64 = 1e-2;
const DAMPING_RANGE: [f64; 2] = [1e-4, 1e4];
const MORE: f64 = 8.0;
const LESS: f64 = 0.25;

/// A descent ends if this many steps have not lowered the squared error by this factor.
const PATIENCE: usize = 8;
const PROGRESS: f64 = 0.9;

/// End of a descent.
pub(super) struct Descent {
    pub(super) q: JointPositions,
    error: TaskError,
    within_limits: bool,
}

impl Descent {
    pub(super) fn has_reached(&self, config: &IkConfig) -> bool {
        self.within_limits && is_small(&self.error, config)
    }

    /// Returns this descent, unless the other has reached the target or is nearer to it.
    pub(super) fn or_better(self, other: Self, config: &IkConfig) -> Self {
        let better = other.has_reached(config) || other.error.squared() < self.error.squared();
        if better { other } else { self }
    }

    pub(super) fn outcome(&self, config: &IkConfig) -> IkOutcome {
        if self.has_reached(config) {
            return IkOutcome::Solved(self.q);
        }
        IkOutcome::Stuck {
            best: self.q,
            position_error: self.error.position.norm(),
            rotation_error: self.error.rotation.norm(),
        }
    }
}

fn is_small(error: &TaskError, config: &IkConfig) -> bool {
    error.position.norm() <= config.position_tolerance
        && error.rotation.norm() <= config.rotation_tolerance
}

/// Configuration of the chain, with the remaining error.
pub(super) struct Place<'a> {
    kinematics: ChainKinematics<'a>,
    tool_axis: Vector3,
    pub(super) error: TaskError,
    squared: f64,
}

impl IkSolver {
    pub(super) fn place(&self, target: &Target, q: &[f64]) -> Result<Place<'_>, RobotError> {
        let kinematics = self.chain.forward_kinematics(q)?;
        let base_from_tool = kinematics.base_from_tip() * self.tip_from_tool;
        let error = target.error(&base_from_tool);
        Ok(Place {
            tool_axis: base_from_tool.rotation * Vector3::z(),
            squared: error.squared(),
            kinematics,
            error,
        })
    }

    /// Descends from positions within the limits.
    pub(super) fn descend(
        &self,
        target: &Target,
        start: JointPositions,
        config: &IkConfig,
    ) -> Result<Descent, RobotError> {
        let mut q = start;
        let mut place = self.place(target, &q)?;
        let within_limits = self.limits.hold(&q);
        let mut damping = DAMPING;
        let mut columns = self.columns(target.goal, &place);
        let mut milestone = (0, place.squared);
        for iteration in 0..config.max_iterations {
            if is_small(&place.error, config) || !within_limits {
                break;
            }
            if place.squared < PROGRESS * milestone.1 {
                milestone = (iteration, place.squared);
            } else if iteration - milestone.0 >= PATIENCE {
                break;
            }
            let task = Task {
                columns,
                residual: place.error.vector(),
                drift: self.drift(&q, config),
                damping: damping * place.squared + MIN_DAMPING,
                max_drift: place.squared.sqrt(),
                max_step: config.max_step,
            };
            let next = self.apply_step(&q, &task.step(&q, &self.limits));
            let there = self.place(target, &next)?;
            if there.squared < place.squared {
                (q, place) = (next, there);
                columns = self.columns(target.goal, &place);
                damping = (damping * LESS).max(DAMPING_RANGE[0]);
            } else {
                damping = (damping * MORE).min(DAMPING_RANGE[1]);
            }
        }
        Ok(Descent {
            q,
            error: place.error,
            within_limits,
        })
    }

    /// Columns of J: linear velocity of the tool centre point and the angular velocity that counts, per variable.
    pub(super) fn columns(
        &self,
        goal: RotationGoal,
        place: &Place<'_>,
    ) -> [Vector6<f64>; MAX_CHAIN] {
        let jacobian = place.kinematics.jacobian(self.tool_in_tip);
        let mut columns = [Vector6::zeros(); MAX_CHAIN];
        for (own, column) in columns.iter_mut().zip(jacobian.view().column_iter()) {
            *own = column.into();
            if goal == RotationGoal::AboutToolZFree {
                let turn = own.fixed_rows::<3>(3).dot(&place.tool_axis);
                let mut rotation = own.fixed_rows_mut::<3>(3);
                rotation -= turn * place.tool_axis;
            }
        }
        columns
    }
}
