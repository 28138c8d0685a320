//! Three simpler estimators, applied to the rounds that the method executed.

use std::ops::ControlFlow;
use wisch::interpret::{
    Belief, InterpretConfig, InterpretError, Interpreter, PerformanceDistribution, TouchSample,
    Uncertainty,
};
use wisch::represent::{GoalState, Task};
use wisch::run::{MotionOrder, PlannedRound};

/// Sampling period of the assumed contact of the force-blind replay [s].
const PERIOD: f64 = 0.01;

/// The estimates of the simpler estimators after a round.
#[derive(Debug, Clone, PartialEq)]
pub struct Baseline {
    /// (a) The plan's predicted performance.
    pub prediction: f64,
    /// (b) A force-blind replay: the same ensemble, with contact wherever the plan has contact.
    pub force_blind: PerformanceDistribution,
    /// (c) The paper's rule: one draw of the dirt, the nominal law, and the measured forces; a single number.
    pub paper: f64,
}

/// The state of the three estimators over the rounds of a world.
#[derive(Debug, Clone)]
pub struct Baselines {
    blind: Belief,
    single: Belief,
}

impl Baselines {
    /// Makes the estimators before the first round, from the method's prior and the task's particles.
    pub fn new(prior: &Belief, task: &Task) -> Self {
        Self {
            blind: prior.clone(),
            single: Belief::from_particles(task.particles.clone()),
        }
    }

    /// Updates the estimators with the measurements of a round.
    ///
    /// # Errors
    /// If the interpretation fails.
    pub fn update(
        &mut self,
        planned: &PlannedRound,
        touches: &[TouchSample],
        goal: &GoalState,
    ) -> Result<Baseline, InterpretError> {
        let task = &planned.task;
        let config = InterpretConfig::from_task(task);
        let order = MotionOrder {
            round: planned.number,
            seed: task.seed,
            task,
            cell: &planned.cell,
            followed: &planned.followed,
        };
        let mut blind = Interpreter::new(task, &config)?;
        let mut refused = None;
        order.play(
            PERIOD,
            &mut |sample| {
                let touch =
                    TouchSample::new(sample.time, sample.world_from_tool, sample.external.force);
                match blind.push(&touch) {
                    Ok(()) => ControlFlow::Continue(()),
                    Err(error) => {
                        refused = Some(error);
                        ControlFlow::Break(())
                    }
                }
            },
            |at| {
                let share = f64::from(at.phase.is_contact());
                TouchSample::new(at.time, at.world_from_tool, task.surface_reaction() * share)
            },
        );
        if let Some(error) = refused {
            return Err(error);
        }
        let blind = blind.conclude(&self.blind, goal)?;
        let paper = InterpretConfig {
            uncertainty: Uncertainty::NONE,
            replays: 1,
            ..config
        };
        let mut touch = Interpreter::new(task, &paper)?;
        for sample in touches {
            touch.push(sample)?;
        }
        let single = touch.conclude(&self.single, goal)?;
        self.blind = blind.belief;
        self.single = single.belief;
        Ok(Baseline {
            prediction: planned.prediction.performance.ratio(),
            force_blind: blind.distribution,
            paper: single.performance.mean,
        })
    }
}
