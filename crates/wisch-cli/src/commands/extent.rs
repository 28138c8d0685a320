//! How far a command takes a task: planned, predicted, followed, or run.

use super::follow::Chosen;
use super::prepare::stage_failure;
use crate::args::{LoopArgs, RobotArgs, TaskArgs};
use crate::failure::Failure;
use std::path::Path;
use wisch::plan::Strategy;
use wisch_io::LoadedTask;

/// Maximum number of particles of a run: with this number, the smallest belief takes 2 GiB.
const MOST_IN_A_RUN: usize = 1_000_000;

/// The last stage of a command, with its options.
#[derive(Debug, Clone, Copy)]
pub(super) enum Extent<'a> {
    /// Plan only. `explain` compares the plans of all strategies, which needs the task's robot.
    Plan {
        explain: bool,
        /// Plan as if the positions of the dirt were known exactly.
        known_dirt: bool,
    },
    Predict,
    /// Run the loop with the task's robot, or predict without a robot.
    Run(&'a RobotArgs, &'a LoopArgs),
    /// Follow with the task's robot, which must exist.
    Follow(&'a RobotArgs),
}

impl Extent<'_> {
    /// Whether the command runs the loop.
    pub const fn is_run(&self) -> bool {
        matches!(self, Self::Run(..))
    }

    /// Options of the rounds of a run.
    pub const fn rounds(&self) -> Option<&LoopArgs> {
        match self {
            Self::Run(_, rounds) => Some(rounds),
            _ => None,
        }
    }

    /// Name of what executes the motions, if it is not the simulated world.
    pub fn executor(&self) -> &'static str {
        match self.rounds() {
            Some(rounds) if rounds.on.is_some() => "the robot of --on",
            _ => "the program of --executor",
        }
    }

    /// Suffix of the default folder of results.
    pub const fn suffix(&self, has_robot: bool) -> &'static str {
        match self {
            Self::Run(..) if has_robot => "",
            Self::Run(..) | Self::Predict => "-predicted",
            Self::Follow(_) => "-followed",
            Self::Plan { .. } => "-planned",
        }
    }

    /// Returns the arguments of the task, without a camera if the options say so.
    pub fn apply_touch_only(&self, args: &TaskArgs) -> TaskArgs {
        match self.rounds() {
            Some(rounds) if rounds.touch_only => args.clone().touch_only(),
            _ => args.clone(),
        }
    }

    /// Whether events go to standard output, so that no summary may be printed there.
    pub fn has_events_on_stdout(&self) -> bool {
        (self.rounds()).is_some_and(|rounds| rounds.events.as_deref() == Some(Path::new("-")))
    }
}

/// Returns the given option that is for a single surface, if there is one.
pub(super) fn find_single_option(
    plan_file: Option<&Path>,
    extent: Extent<'_>,
) -> Option<&'static str> {
    let rounds = extent.rounds();
    let options = [
        ("--plan", plan_file.is_some()),
        ("--resume", rounds.is_some_and(|rounds| rounds.resume)),
        (
            "--events",
            rounds.is_some_and(|rounds| rounds.events.is_some()),
        ),
    ];
    let given = options.into_iter().find(|(_, is_given)| *is_given);
    given.map(|(option, _)| option)
}

/// Chooses the robot of commands that need one. The comparison of plans needs it, because a score includes execution time.
pub(super) fn choose_robot<'a>(
    extent: Extent<'a>,
    any: &'a RobotArgs,
    task_args: &TaskArgs,
    prepared: &LoadedTask,
) -> Result<Option<Chosen<'a>>, Failure> {
    let is_weighed = matches!(extent, Extent::Plan { explain: true, .. })
        || prepared.run.plan.strategy == Strategy::Best;
    let chosen = match extent {
        Extent::Plan { .. } if is_weighed => Chosen::new(any, prepared)?,
        Extent::Plan { .. } | Extent::Predict => None,
        Extent::Run(args, _) | Extent::Follow(args) => Chosen::new(args, prepared)?,
    };
    if matches!(extent, Extent::Follow(_)) && chosen.is_none() {
        let problem = "wisch follow needs a robot, but the task has none";
        return Err(stage_failure(task_args, problem)
            .with_help("add a [robot] table to the task, or choose a robot with --robot"));
    }
    if chosen.is_none() && extent.rounds().is_some_and(|rounds| rounds.on.is_some()) {
        let failure = stage_failure(task_args, "--on needs a robot, but the task has none");
        return Err(failure.with_help("name the robot of the robot file with --robot URDF"));
    }
    let particles = prepared.task.particles.len();
    if extent.is_run() && chosen.is_some() && particles > MOST_IN_A_RUN {
        let problem = format!(
            "{particles} particles exceed the limit of {MOST_IN_A_RUN} for a run, whose belief holds many copies of them"
        );
        let failure = stage_failure(task_args, problem);
        return Err(failure.with_help(
            "reduce particles.count, or use plan, predict or follow, which have no such limit",
        ));
    }
    Ok(chosen)
}
