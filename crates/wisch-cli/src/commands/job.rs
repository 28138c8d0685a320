//! The inputs that all commands with a session share.

use super::follow::{Chosen, workcell_config};
use super::goal::KeptPlan;
use super::prepare::stage_failure;
use crate::args::{LoopArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use wisch::follow::WorkcellConfig;
use wisch::plan::Plan;
use wisch::represent::ParticleError;
use wisch::run::{Pace, PlannedRound, Round, RunConfig, RunError, Session};
use wisch_io::{LoadedTask, OutputFolder, Robot, RoundTimes};
use wisch_record::{RoundGroundTruth, RunClock, StageSink};
use wisch_sim::GroundTruth;

/// Number of single-stroke rounds that replace one round of a whole plan.
const GREEDY_ROUNDS: usize = 10;

/// The inputs of a command that runs a session.
pub(super) struct Job<'a> {
    /// Arguments of the task.
    pub task_args: &'a TaskArgs,
    /// The task.
    pub prepared: &'a LoadedTask,
    /// The robot with its options; `None` without a robot.
    pub robot: Option<(&'a Chosen<'a>, &'a Robot)>,
    /// Folder of results.
    pub folder: &'a OutputFolder,
    /// Display of the current activity.
    pub progress: &'a Progress,
    /// When the command began.
    pub clock: RunClock,
}

/// The plan of the first round, if it is known before the round.
#[derive(Default)]
pub(super) struct RoundStart<'a> {
    /// A plan that the user gives.
    pub given: Option<Plan>,
    /// A plan that was computed for the same task, and is used if all its inputs are the same.
    pub kept: Option<KeptPlan<'a>>,
}

impl RoundStart<'_> {
    /// Returns the computation times of the kept plan [s]; 0 without one.
    pub fn kept_times(&self) -> RoundTimes {
        (self.kept.as_ref()).map_or_else(RoundTimes::default, |kept| kept.times)
    }
}

/// Adds the computation times of a kept plan to those of the first round, if the session has used it.
pub(super) fn add_kept_times(stages: &mut StageSink, session: &Session<'_>, times: RoundTimes) {
    if session.has_used_first_plan() {
        let round = stages.round(1);
        round.planning_s += times.planning_s;
        round.following_s += times.following_s;
    }
}

impl Job<'_> {
    /// Returns the settings of the stages and the maximum number of rounds.
    pub fn config(&self, args: Option<&LoopArgs>) -> RunConfig {
        let (pace, usual_rounds) = if args.is_some_and(|args| args.greedy) {
            (Pace::Greedy, GREEDY_ROUNDS * self.prepared.run.max_rounds)
        } else {
            (self.prepared.run.pace, self.prepared.run.max_rounds)
        };
        // Above the surface there is nothing to learn from a second round.
        let rounds = args.and_then(|args| args.rounds.or(args.air.map(|_| 1)));
        RunConfig {
            workcell: (self.robot.as_ref()).map_or_else(WorkcellConfig::default, |(chosen, _)| {
                workcell_config(chosen, self.prepared)
            }),
            max_rounds: rounds.map_or(usual_rounds, usize::from),
            pace,
            ..self.prepared.run.clone()
        }
    }

    /// Makes a session for the task. `start`: the plan of the first round, if there is one.
    pub fn session<'s>(&'s self, config: RunConfig, start: RoundStart<'s>) -> Session<'s> {
        let session = Session::new(&self.prepared.task, config)
            .with_belief(self.prepared.belief())
            .with_plan(start.given)
            .with_first_plan(start.kept.map(|kept| *kept.first));
        match self.robot {
            Some((_, robot)) => session.with_robot(robot.robot_setup()),
            None => session,
        }
    }

    /// Makes a failure from an error of the session.
    pub fn failed(&self, error: RunError) -> Failure {
        match (error, &self.robot) {
            (RunError::Follow(error), Some((chosen, _))) => {
                chosen.cannot_follow(&error, self.task_args)
            }
            (error, _) => stage_failure(self.task_args, error),
        }
    }
}

/// Returns the simulated world's ground truth of the finished rounds.
pub(super) fn list_truths(
    prepared: &LoadedTask,
    rounds: &[Round],
    truths: &[GroundTruth],
) -> Result<Vec<RoundGroundTruth>, ParticleError> {
    let believed = prepared.task.surface.world_from_surface;
    let world_from_surface = Some(believed * prepared.simulation.believed_from_real);
    let known = rounds.iter().zip(truths).map(|(round, truth)| {
        let PlannedRound {
            number,
            task,
            plan,
            followed,
            ..
        } = &round.motion;
        let schedule = prepared.simulation.schedule(*number, followed);
        Ok(RoundGroundTruth {
            particles: truth.particles()?,
            performance: truth.performance(&plan.graph.goal, &task.surface)?,
            pushes: (schedule.pushes.iter())
                .map(|(start, push)| [*start, start + push.duration])
                .collect(),
            missed: schedule.missed,
            world_from_surface,
            surface_shape: prepared.simulation.shape.clone(),
        })
    });
    known.collect()
}
