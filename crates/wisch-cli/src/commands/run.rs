//! `wisch run`, `wisch plan`, `wisch predict` and `wisch follow`: the stages, and the folder with their results.

use super::PROGRAM;
use super::budget::in_evaluations;
use super::follow::{Chosen, performer};
use super::interrupt::end_in_order;
use super::job::Job;
use super::out_folder::out_folder;
use super::prepare::Prepared;
use super::rounds::{Executed, Kept, execute, say_where};
use super::summary::{in_words, summary};
use super::watch::show;
use super::words::{counted, internal};
use crate::args::{
    FollowArgs, GlobalArgs, LoopArgs, PlanArgs, PredictArgs, ResultArgs, RobotArgs, TaskArgs,
    WipeArgs,
};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use std::path::Path;
use std::sync::atomic::Ordering;
use wisch::interpret::Belief;
use wisch::plan::{Plan, Strategy, check_strokes, describe_over_border, predict};
use wisch::recover::Verdict;
use wisch::run::{Ending, NoExecutor, RunEvent, Stage};
use wisch_io::OutputFolder;
use wisch_io::{Found, Leftover, Replaceable};
use wisch_io::{PlanRecord, read_text};
use wisch_record::{KeptEpisode, RecordOptions, RunRecord, RunResults, StageSink, write_results};
use wisch_report::EffectFrames;

/// Most particles of a run: the least members of a belief take 2 GiB for so many.
const MOST_IN_A_RUN: usize = 1_000_000;

/// What is said where the operator has to act.
const WAITS: &str = "the robot was stopped, and waits for its operator; with execution.after_stop = \"retreat\" the task goes on by itself";

/// How far to go.
#[derive(Debug, Clone, Copy)]
enum Extent<'a> {
    /// With all plans that there are to choose from, if somebody wants to see them, which takes the task's robot.
    Plan {
        explain: bool,
        /// As if it were known where the dirt lies.
        known_dirt: bool,
    },
    Predict,
    /// With the robot of the task, if there is one, round by round.
    Run(&'a RobotArgs, &'a LoopArgs),
    /// With the robot of the task, which has to have one.
    Follow(&'a RobotArgs),
}

impl Extent<'_> {
    const fn is_run(&self) -> bool {
        matches!(self, Self::Run(..))
    }

    /// What the name of the folder ends in.
    const fn suffix(&self, has_robot: bool) -> &'static str {
        match self {
            Self::Run(..) if has_robot => "",
            Self::Run(..) | Self::Predict => "-predicted",
            Self::Follow(_) => "-followed",
            Self::Plan { .. } => "-planned",
        }
    }

    /// Whether standard output is taken by events, among which words have no place.
    fn has_events_on_stdout(&self) -> bool {
        matches!(self, Self::Run(_, rounds) if rounds.events.as_deref() == Some(Path::new("-")))
    }
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
pub fn plan_only(args: &PlanArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let PlanArgs {
        explain,
        known_dirt,
        ..
    } = *args;
    let extent = Extent::Plan {
        explain,
        known_dirt,
    };
    work(&args.task, &args.results, None, extent, global)
}

/// `wisch predict`: plan only where no plan is given.
pub fn predict_only(args: &PredictArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    work(&args.task, &args.results, plan, Extent::Predict, global)
}

fn work(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    if results.json && extent.has_events_on_stdout() {
        let failure = Failure::new("--json and --events - both take standard output");
        return Err(failure.with_help("write the events to a file: --events FILE"));
    }
    let progress = Progress::start(global);
    progress.say("reading the task");
    let mut task_args = in_evaluations(task_args)?;
    if matches!(extent, Extent::Run(_, rounds) if rounds.touch_only) {
        task_args = task_args.touch_only();
    }
    let task_args = &task_args;
    let mut prepared = Prepared::read(task_args)?;
    let any_robot = RobotArgs::default();
    let chosen = choose_robot(extent, &any_robot, task_args, &prepared)?;
    let given = plan_file
        .map(|path| given_plan(path, &mut prepared))
        .transpose()?;
    let out = out_folder(results, &prepared, extent.suffix(chosen.is_some()));
    // From before there is anything on the disk that an end would leave there.
    let stop = match extent {
        Extent::Run(_, rounds) if rounds.executor.is_some() || rounds.live => Some(end_in_order()?),
        _ => None,
    };
    // Before the long part: nobody likes to wait for "permission denied".
    let is_replacing_all = results.force || (extent.is_run() && chosen.is_some());
    let folder = begin_folder(&out, extent, is_replacing_all, (&progress, global))?;

    let robot = (chosen.as_ref())
        .map(|chosen| {
            progress.say("reading the robot");
            Ok::<_, Failure>((chosen, performer(chosen, task_args)?))
        })
        .transpose()?;
    let job = Job {
        task_args,
        prepared: &prepared,
        robot: robot.as_ref().map(|(chosen, robot)| (*chosen, robot)),
        folder: &folder,
        progress: &progress,
    };
    let Executed {
        results: results_of,
        kept: episode,
        broken,
    } = match (extent, &robot) {
        (Extent::Run(_, rounds), Some(_)) => execute(&job, rounds, given, stop.as_ref())?,
        _ => Executed {
            results: simulate_effect(&job, extent, given)?,
            kept: Ok(None),
            broken: None,
        },
    };
    progress.say("writing the results");
    let written = write_results(&folder, &prepared.loaded, &results_of).map_err(Failure::from);
    let written = written.and_then(|()| Ok(folder.finish()?));
    drop(progress);
    if written.is_err() || broken.is_some() {
        say_where(&episode);
    }
    written?;
    if let Some(failure) = broken {
        let rounds = counted(results_of.rounds.len(), "round");
        remark(&format!(
            "{rounds} kept, as far as executed, in {}",
            out.display()
        ));
        return Err(failure);
    }

    let summary = summary(&prepared, &results_of, &out);
    if results.json {
        let line = serde_json::to_string(&summary).map_err(internal)?;
        print(&(line + "\n"))?;
    } else if !global.quiet && !extent.has_events_on_stdout() {
        print(&in_words(&summary, &results_of.rounds, &out))?;
        print(&episode_in_words(&episode))?;
    }
    // The results are there by now, whatever became of the episode.
    if let Some(kept) = episode? {
        remark_on(&kept)?;
    }
    let is_interrupted = stop.is_some_and(|stop| stop.load(Ordering::SeqCst));
    if waits_for_the_operator(&results_of) && !is_interrupted {
        remark(WAITS);
    }
    let is_met = results_of.is_goal_met(prepared.file.target_performance());
    Ok(if is_met {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// The robot that is to follow, where one is needed. Which plan is the best is a question of how long a robot takes.
fn choose_robot<'a>(
    extent: Extent<'a>,
    any: &'a RobotArgs,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Result<Option<Chosen<'a>>, Failure> {
    let is_weighed = matches!(extent, Extent::Plan { explain: true, .. })
        || prepared.config.strategy == Strategy::Best;
    let chosen = match extent {
        Extent::Plan { .. } if is_weighed => Chosen::new(any, prepared)?,
        Extent::Plan { .. } | Extent::Predict => None,
        Extent::Run(args, _) | Extent::Follow(args) => Chosen::new(args, prepared)?,
    };
    if matches!(extent, Extent::Follow(_)) && chosen.is_none() {
        return Err(prepared
            .failure(task_args, "there is no robot to follow the plan")
            .with_help("add a [robot] table to the task, or name a robot with --robot"));
    }
    let particles = prepared.task.particles.len();
    if extent.is_run() && chosen.is_some() && particles > MOST_IN_A_RUN {
        let problem = format!(
            "{particles} particles exceed the limit of {MOST_IN_A_RUN} for a run, whose belief holds them many times"
        );
        let failure = prepared.failure(task_args, problem);
        return Err(failure.with_help("plan, predict and follow take more"));
    }
    Ok(chosen)
}

/// The folder of the results, with what a killed run left there if that is to go on.
fn begin_folder(
    out: &Path,
    extent: Extent<'_>,
    is_replacing_all: bool,
    (progress, global): (&Progress, &GlobalArgs),
) -> Result<OutputFolder, Failure> {
    let leftover = match extent {
        Extent::Run(_, rounds) if rounds.resume => Leftover::TakeOver,
        _ => Leftover::Remove,
    };
    let replaceable = if is_replacing_all {
        Replaceable::All
    } else {
        Replaceable::AllButRuns
    };
    let folder = OutputFolder::begin(out, leftover, replaceable)?;
    if !global.quiet {
        progress.aside(|| say_what_was_found(folder.found(), leftover));
    }
    if leftover == Leftover::TakeOver && folder.found().is_finished {
        return Err(Failure::new(format!(
            "{}: there is nothing to resume: the killed run was complete, and its results stand there",
            out.display()
        ))
        .with_help("without --resume, wisch run begins anew"));
    }
    Ok(folder)
}

/// Where the episode is kept, if it is.
fn episode_in_words(kept: &Kept) -> String {
    match kept {
        Ok(Some(kept)) => format!("  {:<18} {}\n", "episode", kept.place.display()),
        _ => String::new(),
    }
}

/// Says what there is to say of an episode that was kept; what it lacks is an error.
fn remark_on(kept: &KeptEpisode) -> Result<(), Failure> {
    for what in &kept.remarks {
        remark(what);
    }
    if kept.without.is_empty() {
        return Ok(());
    }
    Err(Failure::new(format!(
        "{}: the episode is kept without {}",
        kept.place.display(),
        kept.without.join(", nor ")
    ))
    .with_help("queries of telemetry leave it out; wisch memory forget ID removes it"))
}

/// Whether a person or a safety system ended the last round, and nothing followed.
fn waits_for_the_operator(results: &RunResults) -> bool {
    results.rounds.last().is_some_and(|done| {
        let ending = &done.round.execution.ending;
        matches!(ending, Ending::ProtectiveStop { .. } | Ending::Stopped)
            && done.round.verdict == Verdict::Again
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

/// Plans, follows if there is a robot, and predicts; executes nothing.
fn simulate_effect(
    job: &Job<'_>,
    extent: Extent<'_>,
    given: Option<Plan>,
) -> Result<RunResults, Failure> {
    let is_given = given.is_some();
    let mut session = job.session(job.config(None), given);
    if let Extent::Plan {
        known_dirt: true, ..
    } = extent
    {
        session = session.with_belief(Belief::certain(job.prepared.task.particles.clone()));
    }
    let considered = match extent {
        Extent::Plan { explain: true, .. } => {
            job.progress.say("planning by every strategy");
            let considered = session.considered();
            Some(considered.map_err(|error| job.failed(error))?)
        }
        _ => None,
    };
    let until = match (extent, job.robot) {
        (Extent::Plan { .. }, _) | (_, None) => Stage::Planned,
        (_, Some(_)) => Stage::Audited,
    };
    let loaded = &job.prepared.loaded;
    let options = RecordOptions {
        program: PROGRAM.to_owned(),
        workcell: Some(job.config(None).workcell),
        ..RecordOptions::default()
    };
    let robot = job.robot.map(|(_, robot)| robot);
    let mut record = RunRecord::begin(loaded, robot, options)?;
    record.remarks().iter().for_each(|text| remark(text));
    let mut look = |event: &RunEvent<'_>| {
        show(job.progress, event);
        record.on_event(event)
    };
    (session.run_until(until, &mut NoExecutor, &mut look)).map_err(|error| job.failed(error))?;
    let mut results = match (session.plan(), session.first()) {
        (_, Some(_)) => RunResults::of(&session, record.stages_mut())?,
        (Some(plan), None) => predicted_only(job, extent, plan, record.stages_mut()),
        (None, None) => return Err(internal("no plan was made")),
    };
    results.considered = considered;
    if is_given {
        results.planning_time_s = None;
    }
    if results.predicted.is_none() {
        return Ok(results);
    }
    Ok(record.keep(loaded, robot, results, None)?.results)
}

/// A plan that no robot follows, with what it is predicted to do where that is asked for.
fn predicted_only(
    job: &Job<'_>,
    extent: Extent<'_>,
    plan: &Plan,
    stages: &mut StageSink,
) -> RunResults {
    let task = &job.prepared.task;
    let predicted = (!matches!(extent, Extent::Plan { .. })).then(|| {
        let strokes = counted(plan.strokes.len(), "stroke");
        job.progress.say(format!("predicting {strokes}"));
        let mut frames = EffectFrames::new(task, plan);
        (predict(task, plan, |p| frames.watch(p)), frames)
    });
    RunResults {
        task: task.clone(),
        plan: plan.clone(),
        planning_time_s: Some(stages.round(1).times.planning_s),
        following: None,
        predicted,
        considered: None,
        rounds: Vec::new(),
        recording: Vec::new(),
    }
}

/// Reads a plan, and takes over what it was made with.
pub(super) fn given_plan(path: &Path, prepared: &mut Prepared) -> Result<Plan, Failure> {
    let text = read_text(path)?;
    let in_file = |error| Failure::new(format!("{}: {error}", path.display()));
    let record = PlanRecord::parse(&text).map_err(in_file)?;
    let plan = record.to_plan(&prepared.task).map_err(in_file)?;
    let over_border = check_strokes(&prepared.task, &plan.strokes);
    for sentence in describe_over_border(&over_border.map_err(internal)?) {
        remark(&format!("{}: {sentence}", path.display()));
    }
    prepared.config.strategy = plan.strategy;
    Ok(plan)
}
