//! From a path on the command line to a task that can be planned.

use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use std::ops::{Deref, DerefMut};
use wisch::plan::Strategy;
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::SimulationSettings;

/// A task with what the command line says about it.
pub struct Prepared {
    /// The task, its file and how to plan it.
    pub loaded: LoadedTask,
    /// What a simulated execution takes for real.
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
    /// Reads the task file and everything that it refers to, and says what it takes for granted.
    pub fn read(args: &TaskArgs) -> Result<Self, Failure> {
        let prepared = Self::load(args)?;
        prepared.assumptions.iter().for_each(|text| remark(text));
        Ok(prepared)
    }

    /// The same without a word.
    pub fn load(args: &TaskArgs) -> Result<Self, Failure> {
        let options = LoadOptions {
            settings: args.settings.clone(),
            knowledge: args.knowledge.clone(),
            action: args.action,
            strategy: args.strategy,
            seed: args.seed,
        };
        let loaded = load_task(&args.task, &options)?;
        let reality = SimulationSettings::of(&loaded)
            .map_err(|error| Failure::new(error).within(&args.task))?;
        Ok(Self { loaded, reality })
    }

    /// Most rounds.
    pub fn max_rounds(&self) -> usize {
        self.file.max_rounds()
    }

    /// How the nodes are placed.
    pub fn strategy(&self) -> Strategy {
        self.config.strategy
    }

    /// A failure of a later stage, with the name of the task file.
    pub fn failure(&self, args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", args.task.display()))
    }
}
