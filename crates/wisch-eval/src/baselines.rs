//! Three simpler ways to believe, asked on the very rounds that the method executed.

use std::ops::ControlFlow;
use wisch::interpret::{
    Belief, InterpretConfig, InterpretError, Interpreter, PerformanceDistribution, TouchSample,
    Uncertainty,
};
use wisch::represent::{GoalState, Task};
use wisch::run::{MotionOrder, PlannedRound};

/// Period at which a robot that feels nothing takes its contact for granted [s].
const PERIOD: f64 = 0.01;

/// What simpler ways believe after a round.
#[derive(Debug, Clone, PartialEq)]
pub struct Baseline {
    /// (a) What the plan was predicted to do.
    pub prediction: f64,
    /// (b) A replay of the plan with contact wherever the plan has it, by the same ensemble.
    pub force_blind: PerformanceDistribution,
    /// (c) The paper's rule: one draw of the dirt, the law as it stands, what was felt; a single number.
    pub paper: f64,
}

/// The three ways, over the rounds of a world.
#[derive(Debug, Clone)]
pub struct Baselines {
    blind: Belief,
    single: Belief,
}

impl Baselines {
    /// Before the first round: the method's own prior, and the one draw that the task has.
    pub fn new(prior: &Belief, task: &Task) -> Self {
        Self {
            blind: prior.clone(),
            single: Belief::certain(task.particles.clone()),
        }
    }

    /// Goes through a round with what was felt in it.
    ///
    /// # Errors
    /// What an interpretation refuses.
    pub fn after(
        &mut self,
        planned: &PlannedRound,
        felt: &[TouchSample],
        goal: &GoalState,
    ) -> Result<Baseline, InterpretError> {
        let task = &planned.task;
        let config = InterpretConfig::of(task);
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
        for sample in felt {
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
