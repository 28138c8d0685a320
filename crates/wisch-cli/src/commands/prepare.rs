//! From a path on the command line to a task that can be planned.

use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use std::ops::{Deref, DerefMut};
use wisch::plan::Strategy;
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::SimulationSettings;

/// A task with the overrides of the command line.
pub struct Prepared {
    /// The task, its file and its planner settings.
    pub loaded: LoadedTask,
    /// The simulated world's ground truth: where it differs from the task.
    pub reality: SimulationSettings,
}

impl Deref for Prepared {
    type Target = LoadedTask;

    fn deref(&self) -> &LoadedTask {
        &self.loaded
    }
}

impl DerefMut for Prepared {
    fn deref_mut(&mut self) -> &mut LoadedTask {
        &mut self.loaded
    }
}

impl Prepared {
    /// Reads the task file and all files that it names, and prints its assumptions as notes.
    pub fn read(args: &TaskArgs) -> Result<Self, Failure> {
        let prepared = Self::load(args)?;
        prepared.assumptions.iter().for_each(|text| remark(text));
        Ok(prepared)
    }

    /// Reads the task file like [`read`](Self::read), without notes.
    pub fn load(args: &TaskArgs) -> Result<Self, Failure> {
        let options = LoadOptions {
            settings: args.settings.clone(),
            knowledge: args.knowledge.clone(),
            action: args.action,
            strategy: args.strategy,
            seed: args.seed,
        };
        let loaded = load_task(&args.task, &options)?;
        let reality = SimulationSettings::from_task(&loaded)
            .map_err(|error| Failure::new(error).within(&args.task))?;
        Ok(Self { loaded, reality })
    }

    /// The task's maximum number of rounds.
    pub fn max_rounds(&self) -> usize {
        self.file.max_rounds()
    }

    /// The strategy that plans the strokes.
    pub fn strategy(&self) -> Strategy {
        self.config.strategy
    }

    /// Makes a failure from a later stage's error, with the name of the task file.
    pub fn failure(&self, args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", args.task.display()))
    }
}
