//! Posture in the null space of the tool.

use super::error::Target;
use super::step::Task;
use super::{IkConfig, IkSolver, JointPositions, RotationGoal, check_target};
use crate::RobotError;

/// Length of self-motion at which it ends [rad or m].
const SHORTEST: f64 = 1e-6;

impl IkSolver {
    /// Moves the chain from `start`, its n positions [rad or m], towards the posture and out of the outer parts of the
    /// limits, while the tool keeps its pose within the tolerances, in the rotations that count. It ends when no such
    /// motion remains, or after [`IkConfig::max_iterations`] steps. A start outside the limits is first projected
    /// inside, which moves the tool.
    ///
    /// # Errors
    /// If `start` does not have n finite values, or a value of `config` is out of range.
    pub fn relax(
        &self,
        goal: RotationGoal,
        start: &[f64],
        config: &IkConfig,
    ) -> Result<JointPositions, RobotError> {
        let mut q = self.inside(start)?;
        let base_from_tool =
            self.chain.forward_kinematics(&q)?.base_from_tip() * self.tip_from_tool;
        let target = check_target(&base_from_tool, goal, config)?;
        let back_only = IkConfig {
            posture_gain: 0.0,
            limit_gain: 0.0,
            ..*config
        };
        let mut longest = config.max_step;
        for _ in 0..config.max_iterations {
            let aside = self.self_motion(&target, &q, longest, config)?;
            let back = self.descend(&target, aside, &back_only)?;
            if back.has_reached(config) && self.tension(&back.q, config) < self.tension(&q, config)
            {
                q = back.q;
                longest = (2.0 * longest).min(config.max_step);
            } else {
                longest *= 0.5;
            }
            if longest < SHORTEST {
                break;
            }
        }
        Ok(q)
    }

    /// Null-space projection (1 − J†J) z, which moves the tool only in second order.
    fn self_motion(
        &self,
        target: &Target,
        q: &JointPositions,
        longest: f64,
        config: &IkConfig,
    ) -> Result<JointPositions, RobotError> {
        let place = self.place(target, q)?;
        let task = Task {
            columns: self.columns(target.goal, &place),
            residual: place.error.vector(),
            drift: self.drift(q, config),
            damping: super::descent::MIN_DAMPING,
            max_drift: longest,
            max_step: config.max_step,
        };
        Ok(self.apply_step(q, &task.step(q, &self.limits)))
    }

    /// Returns z, the negative gradient of [`tension`](Self::tension).
    pub(super) fn drift(&self, q: &[f64], config: &IkConfig) -> JointPositions {
        let mut drift = JointPositions::zeros(q.len());
        for (i, own) in drift.iter_mut().enumerate() {
            *own = config.posture_gain * (self.posture[i] - q[i]);
        }
        for limit in self.limits.iter() {
            let inwards = limit.way_inwards(limit.value(q));
            limit.add_to(&mut drift, config.limit_gain * inwards);
        }
        drift
    }

    /// Returns ½ Σ gain · distance², for the posture and for the outer parts of the limits.
    fn tension(&self, q: &[f64], config: &IkConfig) -> f64 {
        let apart = self.posture.iter().zip(q).map(|(p, q)| (p - q) * (p - q));
        let inwards = self
            .limits
            .iter()
            .map(|limit| limit.way_inwards(limit.value(q)).powi(2));
        0.5 * (config.posture_gain * apart.sum::<f64>() + config.limit_gain * inwards.sum::<f64>())
    }

    /// Returns positions after a step that keeps the limits.
    pub(super) fn apply_step(&self, q: &JointPositions, step: &[f64]) -> JointPositions {
        let mut next = *q;
        for (own, step) in next.iter_mut().zip(step) {
            *own += step;
        }
        self.limits.round(&mut next);
        next
    }
}
