//! From a path on the command line to a task that can be planned.

use crate::args::TaskArgs;
use crate::failure::Failure;
use wisch::plan::{CoverageStrategy, PlanConfig};
use wisch::represent::Task;
use wisch_io::{Derivation, InputDigest, LoadOptions, LoadedTask, TaskFile, load_task};
use wisch_sim::SimulationSettings;

/// A task with what the command line says about it.
pub struct Prepared {
    /// The task file.
    pub file: TaskFile,
    /// The task.
    pub task: Task,
    /// How to plan it.
    pub config: PlanConfig,
    /// What a simulated execution takes for real.
    pub reality: SimulationSettings,
    /// The goal and the steps that reach it, where the file states a goal and not an action.
    pub derived: Option<Derivation>,
    /// Of all that was read for it.
    pub inputs: InputDigest,
}

impl Prepared {
    /// Reads the task file and everything that it refers to.
    pub fn read(args: &TaskArgs) -> Result<Self, Failure> {
        let options = LoadOptions {
            settings: args.settings.clone(),
            knowledge: args.knowledge.clone(),
            action: args.action,
            strategy: args.strategy,
            seed: args.seed,
        };
        let LoadedTask {
            file,
            task,
            config,
            derived,
            knowledge,
            inputs,
        } = load_task(&args.task, &options)?;
        let reality = SimulationSettings::of(file.execution(), &task, &knowledge)
            .map_err(|error| Failure::new(error).within(&args.task))?;
        Ok(Self {
            file,
            task,
            config,
            reality,
            derived,
            inputs,
        })
    }

    /// Most rounds.
    pub fn max_rounds(&self) -> usize {
        self.file.max_rounds()
    }

    /// How the nodes are placed.
    pub fn strategy(&self) -> CoverageStrategy {
        self.config.strategy
    }

    /// A failure of a later stage, with the name of the task file.
    pub fn failure(&self, args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", args.task.display()))
    }
}
