//! Runs the stages on one surface, and writes the folder of results.

use super::PROGRAM;
use super::budget::in_evaluations;
use super::extent::{Extent, choose_robot};
use super::follow::read_robot;
use super::goal::KeptPlan;
use super::interrupt::{pause_on_signal, stop_on_signal};
use super::job::{Job, RoundStart, add_kept_times};
use super::out_folder::out_folder;
use super::prepare::{self, stage_failure};
use super::ros2::raise;
use super::rounds::{Executed, Kept, execute, remark_episode_folder};
use super::summary::{in_words, summary};
use super::swept::{SweptSurface, find_collected};
use super::watch::show;
use super::words::{format_count, internal};
use crate::args::{GlobalArgs, LoopArgs, ResultArgs, RobotArgs, TaskArgs, suggest};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{print, remark};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use wisch::interpret::Belief;
use wisch::plan::{Plan, Strategy, check_strokes, describe_over_border, predict};
use wisch::recover::Verdict;
use wisch::represent::ParticleError;
use wisch::run::{AfterStop, Ending, NoExecutor, OnWarning, RunConfig, RunEvent, Stage};
use wisch_io::{KeptFiles, KilledRuns, Leftover, LoadedTask, OutputFolder, Replaceable};
use wisch_io::{PlanRecord, Summary, read_text};
use wisch_record::{
    KeptEpisode, RecordOptions, RunClock, RunRecord, RunResults, StageSink, write_results,
};
use wisch_report::EffectFrames;

/// The note after a stop that the operator has to clear.
const WAITS: &str = "the robot was stopped and waits for its operator";
/// The note after a stop that followed a warning.
const WARNED: &str = "a warning stopped the run, and the robot waits for its operator";
/// The advice after such a stop.
const RETREAT: &str = "set execution.after_stop = \"retreat\" to resume automatically";

/// The result of a command on a surface.
pub(super) struct SurfaceOutcome {
    /// The summary.
    pub summary: Summary,
    /// Whether the goal is met.
    pub is_met: bool,
    /// Its strokes, and the dirt that it has collected.
    pub swept: SweptSurface,
    /// Whether the run waits for its operator, or was interrupted.
    pub is_stopped: bool,
    /// Name of the kept episode, if one was kept.
    pub episode: Option<String>,
}

/// The source of the first plan.
pub(super) enum PlanSource<'a> {
    /// The plan file that the user gives, if there is one.
    File(Option<&'a Path>),
    /// The plan that was computed to predict the time of a step, if it is kept.
    Kept(Option<KeptPlan<'a>>),
}

impl<'a> PlanSource<'a> {
    /// Reads the plan.
    fn read(self, prepared: &mut LoadedTask) -> Result<RoundStart<'a>, Failure> {
        Ok(match self {
            Self::File(path) => RoundStart {
                given: path
                    .map(|path| read_given_plan(path, prepared))
                    .transpose()?,
                kept: None,
            },
            Self::Kept(kept) => RoundStart { given: None, kept },
        })
    }
}

fn begin(global: &GlobalArgs) -> (Progress, RunClock) {
    let progress = Progress::start(global);
    progress.say("reading the task");
    (progress, RunClock::start())
}

/// Works on one surface, and prints its summary for people. `summarised` receives the summary as soon as it is complete.
pub(super) fn wipe_surface(
    task_args: &TaskArgs,
    results: &ResultArgs,
    source: PlanSource<'_>,
    extent: Extent<'_>,
    global: &GlobalArgs,
    summarised: &dyn Fn(&Summary) -> Result<(), Failure>,
) -> Result<SurfaceOutcome, Failure> {
    let (progress, clock) = begin(global);
    let kept = read_kept(extent, task_args, results)?;
    let task_args = &in_evaluations(&extent.apply_touch_only(task_args), &kept)?;
    let mut prepared = prepare::read_with(task_args, &kept)?;
    if let Some(height) = extent.rounds().and_then(|rounds| rounds.air) {
        raise(&mut prepared.task.surface, height);
    }
    let any_robot = RobotArgs::default();
    let chosen = choose_robot(extent, &any_robot, task_args, &prepared)?;
    let start = source.read(&mut prepared)?;
    if chosen.is_none() && start.given.is_none() {
        remark_unweighed(&prepared);
    }
    let out = out_folder(
        results,
        &prepared.task.name,
        extent.suffix(chosen.is_some()),
    );
    let ends_cleanly = |rounds: &LoopArgs| rounds.has_executor() || rounds.live;
    let stop = (extent.rounds().is_some_and(ends_cleanly)).then(stop_on_signal);
    if extent.rounds().is_some_and(LoopArgs::has_executor) {
        // A pause that comes before the executor starts holds before the first motion.
        pause_on_signal()?;
    }
    // The folder comes before the long computation, so that a missing permission is reported at once.
    let is_replacing_all = results.force || (extent.is_run() && chosen.is_some());
    let folder = begin_folder(&out, extent, is_replacing_all, (&progress, global))?;
    check_resumed_robot(&folder, chosen.is_some(), task_args)?;

    let robot = (chosen.as_ref())
        .map(|chosen| {
            progress.say("reading the robot");
            Ok::<_, Failure>((chosen, read_robot(chosen, task_args)?))
        })
        .transpose()?;
    let job = Job {
        task_args,
        prepared: &prepared,
        robot: robot.as_ref().map(|(chosen, robot)| (*chosen, robot)),
        folder: &folder,
        progress: &progress,
        clock,
    };
    let Executed {
        results: results_of,
        kept: episode,
        broken,
    } = match (extent, &robot) {
        (Extent::Run(_, rounds), Some(_)) => execute(&job, rounds, start, stop.as_ref(), global)?,
        _ => simulate_effect(&job, extent, start)?,
    };
    progress.say("writing the results");
    let written = write_results(&folder, &prepared, &results_of).map_err(Failure::from);
    let written = written.and_then(|()| Ok(folder.finish()?));
    drop(progress);
    if written.is_err() || broken.is_some() {
        remark_episode_folder(&episode);
    }
    written?;
    if let Some(failure) = broken {
        let rounds = format_count(results_of.rounds.len(), "round");
        remark(&format!(
            "{rounds} kept in {}; the last round holds its executed part",
            out.display()
        ));
        return Err(failure);
    }

    let summary = summary(&prepared, &results_of, &out);
    summarised(&summary)?;
    if !results.json && !global.quiet && !extent.has_events_on_stdout() {
        let texts = in_words(&summary, (&results_of.rounds, &out), extent.executor());
        print(&(texts + &episode_in_words(&episode)))?;
    }
    // The results are complete at this point, even if the episode could not be kept.
    let episode = episode?.map(remark_on).transpose()?;
    remark_unseen(&results_of);
    let is_interrupted = stop.is_some_and(|stop| stop.load(Ordering::SeqCst));
    if let Some(note) = note_on_stop(&results_of, &prepared.run).filter(|_| !is_interrupted) {
        remark(&note);
    }
    let is_executed = extent.is_run() && chosen.is_some();
    Ok(SurfaceOutcome {
        is_met: results_of.is_goal_met(prepared.run.target),
        summary,
        swept: find_swept(&results_of, is_executed).map_err(internal)?,
        is_stopped: is_interrupted || is_stopped(&results_of),
        episode,
    })
}

/// Returns the strokes of the executed rounds, or else those of the plan if none was to be executed, and what was collected.
fn find_swept(results: &RunResults, is_executed: bool) -> Result<SweptSurface, ParticleError> {
    let motions = results.rounds.iter().map(|done| &done.round.motion);
    let executed = motions.map(|motion| (motion.task.clone(), motion.executable_plan()));
    let plans = if is_executed {
        executed.collect()
    } else {
        vec![(results.task.clone(), results.plan.clone())]
    };
    let goal = results.plan.graph.goal;
    let collected = match (results.rounds.last(), &results.predicted) {
        (Some(last), _) => {
            let estimated = last.round.interpretation.belief.sample(results.task.seed)?;
            find_collected(&estimated, goal)
        }
        (None, Some((predicted, _))) if !is_executed => find_collected(&predicted.particles, goal),
        (None, _) => Vec::new(),
    };
    Ok(SweptSurface { plans, collected })
}

/// States that nothing was wiped because the camera detects no dirt.
fn remark_unseen(results: &RunResults) {
    if let Some([least, most]) = results.unseen.filter(|_| results.rounds.is_empty()) {
        remark(&format!(
            "the camera detects no dirt, where {least:.0} to {most:.0} detections were expected: the surface is clean, or the camera does not see the dirt; nothing was wiped (--touch-only wipes without the camera)"
        ));
    }
    let moves_dirt = results.task.treatment.is_none();
    if results.is_unmeasured && results.plan.strokes.is_empty() && moves_dirt {
        remark(
            "nothing was wiped, as the plan has no stroke, and nothing shows whether dirt is left: a camera would (perception.senses)",
        );
    }
}

/// States that plans are compared without the task's robot, where another command compares them with it: once for all steps
/// of a goal.
fn remark_unweighed(prepared: &LoadedTask) {
    static STATED: AtomicBool = AtomicBool::new(false);
    if prepared.run.plan.strategy == Strategy::Best
        && prepared.file.robot.is_some()
        && !STATED.swap(true, Ordering::Relaxed)
    {
        remark(
            "strategy best compares plans without the robot's execution times here; wisch plan, follow and run with the robot include them, and may choose another plan",
        );
    }
}

/// Checks that a resumed run has a robot, as the killed run had.
fn check_resumed_robot(
    folder: &OutputFolder,
    has_robot: bool,
    task_args: &TaskArgs,
) -> Result<(), Failure> {
    if has_robot || !folder.leftovers().is_taken_over {
        return Ok(());
    }
    let problem = "--resume needs the robot of the killed run";
    Err(stage_failure(task_args, problem))
}

/// Returns the files that a killed run has kept, if this run resumes it.
fn read_kept(
    extent: Extent<'_>,
    task_args: &TaskArgs,
    results: &ResultArgs,
) -> Result<KeptFiles, Failure> {
    match extent.rounds() {
        Some(rounds) if rounds.resume => prepare::read_kept(task_args, |name| {
            out_folder(results, name, extent.suffix(true))
        }),
        _ => Ok(KeptFiles::default()),
    }
}

/// Begins the folder of results; with `--resume` it takes over the state of a killed run.
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
        progress.aside(|| say_what_was_found(folder.leftovers(), leftover));
    }
    if leftover == Leftover::TakeOver && folder.leftovers().is_finished {
        return Err(Failure::new(format!(
            "{}: nothing to resume: the killed run was complete, and its results are in this folder",
            out.display()
        ))
        .with_help("leave out --resume to start a new run"));
    }
    Ok(folder)
}

/// The summary's line with the folder of the kept episode.
fn episode_in_words(kept: &Kept) -> String {
    match kept {
        Ok(Some(kept)) => format!("  {:<18} {}\n", "episode", kept.place.display()),
        _ => String::new(),
    }
}

/// Prints the notes about a kept episode, and returns its name. Missing telemetry is an error.
fn remark_on(kept: KeptEpisode) -> Result<String, Failure> {
    for what in &kept.remarks {
        remark(what);
    }
    if kept.without.is_empty() {
        return Ok(kept.id);
    }
    Err(Failure::new(format!(
        "{}: the episode was kept without {}",
        kept.place.display(),
        kept.without.join(", nor ")
    ))
    .with_help(format!(
        "queries of telemetry skip this episode; {} removes it",
        suggest(&format!("memory forget {}", kept.id))
    )))
}

/// Whether the last round was stopped, whatever its verdict.
fn is_stopped(results: &RunResults) -> bool {
    (results.rounds.last()).is_some_and(|done| {
        let ending = &done.round.execution.ending;
        matches!(ending, Ending::ProtectiveStop { .. } | Ending::Stopped)
    })
}

/// Returns a note if the run ended because the robot waits for its operator.
fn note_on_stop(results: &RunResults, config: &RunConfig) -> Option<String> {
    let last = &results.rounds.last()?.round;
    let is_warned = config.on_warning == OnWarning::Stop && !last.warnings.is_empty();
    if is_warned && last.execution.ending == Ending::Stopped {
        return Some(WARNED.to_owned());
    }
    if last.verdict != Verdict::Again {
        return None;
    }
    let continues = |after_stop: AfterStop| match &last.execution.ending {
        Ending::Stopped => after_stop != AfterStop::Wait,
        Ending::ProtectiveStop { cause, .. } => cause.kind().may_continue(after_stop),
        Ending::Complete | Ending::Early { .. } => true,
    };
    if continues(config.after_stop) {
        None
    } else if continues(AfterStop::Retreat) {
        Some(format!("{WAITS}; {RETREAT}"))
    } else {
        Some(WAITS.to_owned())
    }
}

/// Prints notes about the leftovers of killed runs.
fn say_what_was_found(found: &KilledRuns, leftover: Leftover) {
    for path in &found.removed {
        let path = path.display();
        remark(&format!("removed {path}, left behind by a killed run"));
    }
    if leftover == Leftover::TakeOver && !found.is_taken_over {
        remark("no killed run to resume: starting with round 1");
    }
}

/// Plans, follows if there is a robot, and predicts, without execution.
fn simulate_effect(
    job: &Job<'_>,
    extent: Extent<'_>,
    start: RoundStart<'_>,
) -> Result<Executed, Failure> {
    let (is_given, kept_times) = (start.given.is_some(), start.kept_times());
    let mut session = job.session(job.config(None), start);
    if let Extent::Plan {
        known_dirt: true, ..
    } = extent
    {
        session = session.with_belief(Belief::from_particles(job.prepared.task.particles.clone()));
    }
    let considered = match extent {
        Extent::Plan { explain: true, .. } => {
            job.progress.say("planning with every strategy");
            let considered = session.evaluate_candidates();
            let considered = considered.map_err(|error| job.failed(error))?;
            // The plan of the marked row is the one that is written.
            let strategy = job.prepared.run.plan.strategy;
            let row = (considered.iter()).find(|one| !is_given && one.strategy == strategy);
            if let Some(candidate) = row.and_then(|row| row.candidate.as_ref().ok()) {
                session = session.with_plan(Some(candidate.plan.clone()));
            }
            Some(considered)
        }
        _ => None,
    };
    let until = match (extent, job.robot) {
        (Extent::Plan { .. }, _) | (_, None) => Stage::Planned,
        (_, Some(_)) => Stage::Audited,
    };
    let loaded = &job.prepared;
    let options = RecordOptions {
        program: PROGRAM.to_owned(),
        workcell: Some(job.config(None).workcell),
        ..RecordOptions::default()
    };
    let robot = job.robot.map(|(_, robot)| robot);
    let mut record = RunRecord::begin(loaded, robot, options)?;
    record.remarks().iter().for_each(|text| remark(text));
    let mut handle_event = |event: &RunEvent<'_>| {
        show(job.progress, event);
        record.on_event(event)
    };
    (session.run_until(until, &mut NoExecutor, &mut handle_event))
        .map_err(|error| job.failed(error))?;
    add_kept_times(record.stages_mut(), &session, kept_times);
    let mut results = match (session.plan(), session.first_motion()) {
        (_, Some(_)) => record.results(&session)?,
        (Some(plan), None) => predict_without_robot(job, extent, plan, record.stages_mut()),
        (None, None) => return Err(internal("no plan was made")),
    };
    results.considered = considered;
    if is_given {
        results.planning_time_s = None;
    }
    if results.predicted.is_some() {
        results = record.keep(loaded, robot, results, None)?.results;
    }
    Ok(Executed {
        results,
        kept: Ok(None),
        broken: None,
    })
}

/// Returns the results of a plan that no robot follows, with its predicted effect unless only a plan was requested.
fn predict_without_robot(
    job: &Job<'_>,
    extent: Extent<'_>,
    plan: &Plan,
    stages: &mut StageSink,
) -> RunResults {
    let task = &job.prepared.task;
    let predicted = (!matches!(extent, Extent::Plan { .. })).then(|| {
        let strokes = format_count(plan.strokes.len(), "stroke");
        job.progress.say(format!("predicting {strokes}"));
        let mut frames = EffectFrames::new(task, plan);
        (predict(task, plan, |p| frames.record(p)), frames)
    });
    RunResults {
        task: task.clone(),
        plan: plan.clone(),
        planning_time_s: Some(stages.round(1).planning_s),
        following: None,
        predicted,
        considered: None,
        unseen: None,
        is_observed: false,
        is_unmeasured: false,
        rounds: Vec::new(),
        recording: Vec::new(),
        packed: Vec::new(),
    }
}

/// Reads a plan file, checks its strokes, and adopts its strategy.
pub(super) fn read_given_plan(path: &Path, prepared: &mut LoadedTask) -> Result<Plan, Failure> {
    let text = read_text(path)?;
    let in_file = |error| Failure::new(format!("{}: {error}", path.display()));
    let record = PlanRecord::parse(&text).map_err(in_file)?;
    let plan = record.to_plan(&prepared.task).map_err(in_file)?;
    for sentence in record.describe_differences(&plan, &prepared.task) {
        remark(&format!("{}: {sentence}", path.display()));
    }
    let over_border = check_strokes(&prepared.task, &plan.strokes);
    for sentence in describe_over_border(&over_border.map_err(internal)?) {
        remark(&format!("{}: {sentence}", path.display()));
    }
    prepared.run.plan.strategy = plan.strategy;
    Ok(plan)
}
