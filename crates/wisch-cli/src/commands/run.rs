//! `wisch run`, `wisch plan`, `wisch predict` and `wisch follow`: the stages, and the folder with their results.

use super::follow::{Chosen, Following, follow_plan};
use super::prepare::Prepared;
use super::results::{internal, out_folder, write};
use super::rounds::{Done, first_following, wipe};
use super::summary::{in_words, summary};
use super::words::counted;
use crate::args::{
    FollowArgs, GlobalArgs, LoopArgs, PredictArgs, ResultArgs, RobotArgs, RunArgs, TaskArgs,
    WipeArgs,
};
use crate::assets::read_text;
use crate::failure::Failure;
use crate::output::OutputFolder;
use crate::progress::Progress;
use crate::records::{PlanRecord, PredictionSummary};
use crate::terminal::{Outcome, print, remark};
use crate::workplace::{Found, Leftover};
use std::path::Path;
use std::time::Instant;
use wisch::plan::{Plan, Prediction, plan, predict};
use wisch_report::EffectFrames;

/// How far to go.
#[derive(Debug, Clone, Copy)]
enum Extent<'a> {
    Plan,
    Predict,
    /// With the robot of the task, if there is one, round by round.
    Run(&'a RobotArgs, &'a LoopArgs),
    /// With the robot of the task, which has to have one.
    Follow(&'a RobotArgs),
}

/// `wisch run`: the closed loop with the task's robot; without one, plan and predict.
pub fn run(args: &WipeArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let follow = &args.follow;
    let extent = Extent::Run(&follow.robot, &args.rounds);
    work(
        &follow.task,
        &follow.results,
        follow.plan.as_deref(),
        extent,
        global,
    )
}

/// `wisch follow`: plan, follow and predict; without a robot there is nothing to do.
pub fn follow_only(args: &FollowArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    let extent = Extent::Follow(&args.robot);
    work(&args.task, &args.results, plan, extent, global)
}

/// `wisch plan`.
pub fn plan_only(args: &RunArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    work(&args.task, &args.results, None, Extent::Plan, global)
}

/// `wisch predict`: plan only where no plan is given.
pub fn predict_only(args: &PredictArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    work(&args.task, &args.results, plan, Extent::Predict, global)
}

/// The outcome of the stages.
pub(super) struct Results {
    pub plan: Plan,
    /// `None` where a plan was given.
    pub planning_time_s: Option<f64>,
    pub following: Option<Following>,
    /// Share of the particles that abandoned nodes cost.
    pub abandoned_share: f64,
    pub predicted: Option<(Prediction, EffectFrames)>,
    /// What was executed.
    pub rounds: Vec<Done>,
}

fn work(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let mut prepared = Prepared::read(task_args)?;
    let robot = match extent {
        Extent::Plan | Extent::Predict => None,
        Extent::Run(args, _) => Chosen::new(args, &prepared)?,
        Extent::Follow(args) => Some(Chosen::new(args, &prepared)?.ok_or_else(|| {
            prepared
                .failure(task_args, "there is no robot to follow the plan")
                .with_help("add a [robot] table to the task, or name a robot with --robot")
        })?),
    };
    let given = plan_file
        .map(|path| given_plan(path, &mut prepared))
        .transpose()?;
    let out = out_folder(results, &prepared);
    // Before the long part: nobody likes to wait for "permission denied".
    let leftover = match extent {
        Extent::Run(_, rounds) if rounds.resume => Leftover::TakeOver,
        _ => Leftover::Remove,
    };
    let folder = OutputFolder::begin(&out, leftover)?;
    if !global.quiet {
        progress.aside(|| say_what_was_found(folder.found(), leftover));
    }

    let mut episode = None;
    let results_of = match (extent, &robot) {
        (Extent::Run(_, rounds), Some(robot)) => {
            let (done, kept) = wipe(
                robot, rounds, task_args, &prepared, given, &folder, &progress,
            )?;
            episode = kept;
            progress.say("checking the motion");
            executed(done, task_args, &prepared)?
        }
        _ => stages(
            task_args,
            &prepared,
            given,
            extent,
            robot.as_ref(),
            &progress,
        )?,
    };
    progress.say("writing the results");
    write(&folder, &prepared, &results_of)?;
    folder.finish()?;
    drop(progress);

    let summary = summary(&prepared, &results_of, &out);
    if results.json {
        print(&format!(
            "{}\n",
            serde_json::to_string(&summary).map_err(internal)?
        ))?;
    } else if !global.quiet {
        print(&in_words(&summary, &results_of.rounds, &out))?;
        if let Some(place) = episode {
            print(&format!("  {:<18} {}\n", "episode", place.display()))?;
        }
    }
    Ok(match summary.prediction {
        Some(PredictionSummary {
            goal_met: false, ..
        }) => Outcome::GoalNotMet,
        _ => Outcome::Done,
    })
}

/// Says what became of killed runs.
fn say_what_was_found(found: &Found, leftover: Leftover) {
    for path in &found.removed {
        let path = path.display();
        remark(&format!("removed {path}, which a killed run left behind"));
    }
    if leftover == Leftover::TakeOver && !found.is_taken_over {
        remark("no killed run left anything to go on with: beginning with round 1");
    }
}

/// Plan, follow, predict what is followed.
fn stages(
    task_args: &TaskArgs,
    prepared: &Prepared,
    given: Option<Plan>,
    extent: Extent<'_>,
    robot: Option<&Chosen<'_>>,
    progress: &Progress,
) -> Result<Results, Failure> {
    let task = &prepared.task;
    let (plan, planning_time_s) = match given {
        Some(plan) => (plan, None),
        None => {
            progress.say(format!("planning ({})", prepared.strategy()));
            let start = Instant::now();
            let plan =
                plan(task, &prepared.config).map_err(|error| prepared.failure(task_args, error))?;
            (plan, Some(start.elapsed().as_secs_f64()))
        }
    };
    let following = robot
        .map(|robot| follow_plan(robot, task_args, prepared, &plan, progress))
        .transpose()?;
    let mut abandoned_share = 0.0;
    let predicted = match extent {
        Extent::Plan => None,
        Extent::Predict | Extent::Run(..) | Extent::Follow(_) => {
            let wiped = (following.as_ref()).map_or_else(|| plan.clone(), |f| f.plan(&plan));
            progress.say(format!(
                "predicting {}",
                counted(wiped.strokes.len(), "stroke")
            ));
            let mut frames = EffectFrames::new(task, &wiped);
            let prediction = predict(task, &wiped, |p| frames.watch(p));
            if following
                .as_ref()
                .is_some_and(|f| !f.followed.abandoned.is_empty())
            {
                let hoped = predict(task, &plan, |_| ()).performance.ratio();
                abandoned_share = (hoped - prediction.performance.ratio()).max(0.0);
            }
            Some((prediction, frames))
        }
    };
    Ok(Results {
        plan,
        planning_time_s,
        following,
        abandoned_share,
        predicted,
        rounds: Vec::new(),
    })
}

/// The outcome of rounds: plan, motion and prediction are those of the first.
fn executed(
    rounds: Vec<Done>,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Result<Results, Failure> {
    let first = rounds.first().ok_or_else(|| internal("no round was run"))?;
    let following = first_following(first, task_args, prepared)?;
    let plan = first.round.motion.plan.clone();
    let task = &prepared.task;
    let wiped = following.plan(&plan);
    let mut frames = EffectFrames::new(task, &wiped);
    let prediction = predict(task, &wiped, |p| frames.watch(p));
    let hoped = predict(task, &plan, |_| ()).performance.ratio();
    Ok(Results {
        planning_time_s: Some(first.times.planning_s),
        abandoned_share: (hoped - prediction.performance.ratio()).max(0.0),
        following: Some(following),
        predicted: Some((prediction, frames)),
        plan,
        rounds,
    })
}

/// Reads a plan, and takes over what it was made with.
pub(super) fn given_plan(path: &Path, prepared: &mut Prepared) -> Result<Plan, Failure> {
    let text = read_text(path)?;
    let in_file = |error| Failure::new(format!("{}: {error}", path.display()));
    let record = PlanRecord::parse(&text).map_err(in_file)?;
    let plan = record.to_plan(&prepared.task).map_err(in_file)?;
    prepared.config.strategy = plan.strategy;
    Ok(plan)
}
