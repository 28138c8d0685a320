//! `wisch run`, `wisch plan`, `wisch predict` and `wisch follow`: run the stages and write the folder of results.

use super::PROGRAM;
use super::budget::in_evaluations;
use super::follow::{Chosen, read_robot};
use super::interrupt::{is_stop_requested, pause_on_signal, stop_on_signal};
use super::job::Job;
use super::out_folder::out_folder;
use super::patches::{PatchesSummary, TaskPatches, remark_earlier_patches};
use super::prepare::{self, stage_failure};
use super::ros2::raise;
use super::rounds::{Executed, Kept, execute, remark_episode_folder};
use super::steps::{GoalRun, GoalTask, WipedStep, read_goal};
use super::summary::{in_words, summary};
use super::watch::show;
use super::words::{counted, internal};
use crate::args::{
    FollowArgs, GlobalArgs, LoopArgs, PlanArgs, PredictArgs, ResultArgs, RobotArgs, TaskArgs,
    WipeArgs, suggest,
};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json, remark};
use std::path::Path;
use std::sync::atomic::Ordering;
use wisch::interpret::Belief;
use wisch::plan::{Plan, Strategy, check_strokes, describe_over_border, predict};
use wisch::recover::Verdict;
use wisch::run::{AfterStop, Ending, NoExecutor, OnWarning, RunConfig, RunEvent, Stage};
use wisch_io::{GoalFile, KeptFiles, KilledRuns, Leftover, Replaceable};
use wisch_io::{LoadedTask, OutputFile, OutputFolder};
use wisch_io::{PLAN_FILE, PlanRecord, REPORT_FILE, Summary, read_text, wipes_all_patches};
use wisch_record::{
    KeptEpisode, RecordOptions, RunClock, RunRecord, RunResults, StageSink, write_results,
};
use wisch_report::EffectFrames;

/// Maximum number of particles of a run: with this number, the smallest belief takes 2 GiB.
const MOST_IN_A_RUN: usize = 1_000_000;

/// The file of the steps of a goal, in the folder of results.
const STEPS_FILE: &str = "steps.json";

/// The note after a stop that the operator has to clear.
const WAITS: &str = "the robot was stopped and waits for its operator";
/// The note after a stop that followed a warning.
const WARNED: &str = "a warning stopped the run, and the robot waits for its operator";
/// What to do if the next such stop shall not end the run.
const RETREAT: &str = "set execution.after_stop = \"retreat\" to resume automatically";

/// The last stage of a command, with its options.
#[derive(Debug, Clone, Copy)]
enum Extent<'a> {
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
    const fn is_run(&self) -> bool {
        matches!(self, Self::Run(..))
    }

    /// Options of the rounds of a run.
    const fn rounds(&self) -> Option<&LoopArgs> {
        match self {
            Self::Run(_, rounds) => Some(rounds),
            _ => None,
        }
    }

    /// Name of what executes the motions, if it is not the simulated world.
    fn executor(&self) -> &'static str {
        match self.rounds() {
            Some(rounds) if rounds.on.is_some() => "the robot of --on",
            _ => "the program of --executor",
        }
    }

    /// Suffix of the default folder of results.
    const fn suffix(&self, has_robot: bool) -> &'static str {
        match self {
            Self::Run(..) if has_robot => "",
            Self::Run(..) | Self::Predict => "-predicted",
            Self::Follow(_) => "-followed",
            Self::Plan { .. } => "-planned",
        }
    }

    /// Returns the arguments of the task, without a camera if the options say so.
    fn restrict_senses(&self, args: &TaskArgs) -> TaskArgs {
        match self.rounds() {
            Some(rounds) if rounds.touch_only => args.clone().touch_only(),
            _ => args.clone(),
        }
    }

    /// Whether events go to standard output, so that no summary may be printed there.
    fn has_events_on_stdout(&self) -> bool {
        (self.rounds()).is_some_and(|rounds| rounds.events.as_deref() == Some(Path::new("-")))
    }
}

/// Runs `wisch run`: the closed loop with the task's robot; without a robot, plans and predicts.
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

/// Runs `wisch follow`: plans, follows and predicts; fails without a robot.
pub fn follow_only(args: &FollowArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    let extent = Extent::Follow(&args.robot);
    work(&args.task, &args.results, plan, extent, global)
}

/// Runs `wisch plan`.
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

/// Runs `wisch predict`; plans first unless a plan is given.
pub fn predict_only(args: &PredictArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    work(&args.task, &args.results, plan, Extent::Predict, global)
}

/// What a command found on a surface.
struct Done {
    summary: Summary,
    is_met: bool,
    /// Whether the run waits for its operator, or was interrupted.
    is_stopped: bool,
}

fn work(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    if results.json && extent.has_events_on_stdout() {
        let failure = Failure::new("--json and --events - both write to standard output");
        return Err(failure.with_help("write the events to a file: --events FILE"));
    }
    let is_met = if let Some(file) = read_goal(task_args)? {
        work_on_goal((task_args, &file), results, plan_file, extent, global)?
    } else if wipes_all_patches(&task_args.task, &task_args.settings)? {
        work_on_patches(task_args, results, plan_file, extent, global)?
    } else {
        let summarised = |summary: &Summary| match results.json {
            true => print_json(summary),
            false => Ok(()),
        };
        work_on_surface(task_args, results, plan_file, extent, global, &summarised)?.is_met
    };
    Ok(if is_met {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// Returns the given option that is for a single surface, if there is one.
fn find_single_option(plan_file: Option<&Path>, extent: Extent<'_>) -> Option<&'static str> {
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

/// Works on a goal of several parts, one step after another; returns whether every part of the goal holds.
fn work_on_goal(
    (task_args, file): (&TaskArgs, &GoalFile),
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<bool, Failure> {
    let has_executor = extent.rounds().is_some_and(LoopArgs::has_executor);
    // Nothing but the simulated world changes tools.
    let executor = Some("--executor or --on").filter(|_| has_executor);
    if let Some(option) = executor.or_else(|| find_single_option(plan_file, extent)) {
        let problem = format!("{option} is for one part of the goal, but the goal has several");
        let part = file.goal.parts().find(|(holds, _)| *holds);
        let part = part.map_or_else(String::new, |(_, fact)| fact.to_string());
        return Err(stage_failure(task_args, problem)
            .with_help(format!("choose the part: --set goal='{part}'")));
    }
    let task_args = &extent.restrict_senses(task_args);
    let any_robot = RobotArgs::default();
    let robot = match extent {
        Extent::Run(args, _) | Extent::Follow(args) => Some(args),
        Extent::Plan { .. } | Extent::Predict => Some(&any_robot),
    };
    let progress = Progress::start(global);
    let task = GoalTask::evaluate(task_args, file, robot, &progress)?;
    drop(progress);
    let out = out_folder(
        results,
        &file.name,
        extent.suffix(extent.is_run() && task.has_robot()),
    );
    let is_foreign = [PLAN_FILE, REPORT_FILE]
        .iter()
        .any(|name| out.join(name).exists())
        && !out.join(STEPS_FILE).exists();
    if is_foreign && !results.force {
        let problem = "the folder holds results that are not of the steps of a goal";
        return Err(Failure::new(problem)
            .within(&out)
            .with_help("choose another folder with --out, or replace files with --force"));
    }
    let is_executed = extent.is_run() && task.has_robot();
    // Also if no step is needed.
    std::fs::create_dir_all(&out).map_err(|error| Failure::new(error).within(&out))?;
    let run = GoalRun::begin(&task, is_executed, out.clone())?;
    let (summary, broken) = run.run(&mut |args, folder| {
        let of_step = ResultArgs {
            out: Some(folder.to_owned()),
            force: results.force,
            json: results.json,
        };
        let done = work_on_surface(args, &of_step, None, extent, global, &|_| Ok(()))?;
        Ok(WipedStep {
            is_met: done.is_met,
            is_stopped: done.is_stopped || is_stop_requested(),
            summary: done.summary,
        })
    })?;
    let json = serde_json::to_vec_pretty(&summary).map_err(internal)?;
    OutputFile::begin(&out.join(STEPS_FILE))?.finish(&json)?;
    OutputFile::begin(&out.join(REPORT_FILE))?.finish(summary.page().as_bytes())?;
    if results.json {
        print_json(&summary)?;
    } else if !global.quiet {
        print(&summary.in_words())?;
    }
    broken.map_or(Ok(summary.is_met()), Err)
}

/// Works on all patches of a divided mesh, one after another; returns whether the goal is met on all.
fn work_on_patches(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<bool, Failure> {
    if let Some(option) = find_single_option(plan_file, extent) {
        let problem = format!("{option} is for one patch, but surface.mesh.patch = \"all\"");
        return Err(stage_failure(task_args, problem)
            .with_help("choose the patch with --set surface.mesh.patch=1"));
    }
    let TaskPatches {
        tasks,
        first,
        atlas,
    } = TaskPatches::read(task_args)?;
    let any_robot = RobotArgs::default();
    let has_robot = choose_robot(extent, &any_robot, task_args, &first)?.is_some();
    let out = out_folder(results, &first.task.name, extent.suffix(has_robot));
    if out.join(PLAN_FILE).exists() {
        let problem = "the folder holds results of a single surface or patch, and those of all patches do not replace them, not even with --force";
        return Err(Failure::new(problem)
            .within(&out)
            .with_help("choose another folder with --out"));
    }
    let is_foreign = out.join(REPORT_FILE).exists() && !out.join("patch-1").exists();
    if is_foreign && !results.force {
        let problem = format!("the folder holds a file {REPORT_FILE} that is not of this task");
        return Err(Failure::new(problem)
            .within(&out)
            .with_help("choose another folder with --out, or replace the file with --force"));
    }
    let count = tasks.len();
    let (mut summaries, mut are_met) = (Vec::new(), true);
    let mut broken = None;
    for (task_args, number) in tasks.iter().zip(1..) {
        let of_patch = ResultArgs {
            out: Some(out.join(format!("patch-{number}"))),
            force: results.force,
            json: results.json,
        };
        let done = match work_on_surface(task_args, &of_patch, None, extent, global, &|_| Ok(())) {
            Ok(done) => done,
            Err(failure) => {
                let failure = failure.after(&format!("patch {number} of {count}"));
                if summaries.is_empty() {
                    return Err(failure);
                }
                let place = out.display();
                remark(&format!(
                    "the patches before it are finished and kept in {place}"
                ));
                broken = Some(failure);
                break;
            }
        };
        are_met &= done.is_met;
        summaries.push(done.summary);
        if done.is_stopped || is_stop_requested() {
            are_met = false;
            if number < count {
                remark(&format!(
                    "stopped on patch {number} of {count}: the patches after it are not wiped"
                ));
            }
            break;
        }
    }
    are_met &= summaries.len() == count;
    remark_earlier_patches(&out, summaries.len());
    let place = out.display().to_string();
    let summary = PatchesSummary::new(&first.task.name, summaries, count, are_met, place);
    if results.json {
        print_json(&summary)?;
    } else if !global.quiet {
        print(&summary.in_words())?;
    }
    let page = summary.page(&atlas);
    OutputFile::begin(&out.join(REPORT_FILE))?.finish(page.as_bytes())?;
    broken.map_or(Ok(are_met), Err)
}

/// Works on one surface, and prints its summary for people. `summarised` receives the summary as soon as it is complete.
fn work_on_surface(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
    summarised: &dyn Fn(&Summary) -> Result<(), Failure>,
) -> Result<Done, Failure> {
    let (progress, clock) = (Progress::start(global), RunClock::start());
    progress.say("reading the task");
    let kept = read_kept(extent, task_args, results)?;
    let task_args = &in_evaluations(&extent.restrict_senses(task_args), &kept)?;
    let mut prepared = prepare::read_with(task_args, &kept)?;
    if let Some(height) = extent.rounds().and_then(|rounds| rounds.air) {
        raise(&mut prepared.task.surface, height);
    }
    let any_robot = RobotArgs::default();
    let chosen = choose_robot(extent, &any_robot, task_args, &prepared)?;
    let given = plan_file
        .map(|path| given_plan(path, &mut prepared))
        .transpose()?;
    if chosen.is_none() && given.is_none() {
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
        (Extent::Run(_, rounds), Some(_)) => execute(&job, rounds, given, stop.as_ref(), global)?,
        _ => simulate_effect(&job, extent, given)?,
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
        let rounds = counted(results_of.rounds.len(), "round");
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
    if let Some(kept) = episode? {
        remark_on(&kept)?;
    }
    remark_unseen(&results_of);
    let is_interrupted = stop.is_some_and(|stop| stop.load(Ordering::SeqCst));
    if let Some(note) = note_on_stop(&results_of, &prepared.run).filter(|_| !is_interrupted) {
        remark(&note);
    }
    Ok(Done {
        is_met: results_of.is_goal_met(prepared.run.target),
        summary,
        is_stopped: is_interrupted || is_stopped(&results_of),
    })
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

/// States that plans are compared without the task's robot, where another command compares them with it.
fn remark_unweighed(prepared: &LoadedTask) {
    if prepared.run.plan.strategy == Strategy::Best && prepared.file.robot.is_some() {
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

/// Chooses the robot of commands that need one. The comparison of plans needs it, because a score includes execution time.
fn choose_robot<'a>(
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

/// Prints the notes about a kept episode. Missing telemetry is an error.
fn remark_on(kept: &KeptEpisode) -> Result<(), Failure> {
    for what in &kept.remarks {
        remark(what);
    }
    if kept.without.is_empty() {
        return Ok(());
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
    given: Option<Plan>,
) -> Result<Executed, Failure> {
    let is_given = given.is_some();
    let mut session = job.session(job.config(None), given);
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
    let mut look = |event: &RunEvent<'_>| {
        show(job.progress, event);
        record.on_event(event)
    };
    (session.run_until(until, &mut NoExecutor, &mut look)).map_err(|error| job.failed(error))?;
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
        let strokes = counted(plan.strokes.len(), "stroke");
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
pub(super) fn given_plan(path: &Path, prepared: &mut LoadedTask) -> Result<Plan, Failure> {
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
