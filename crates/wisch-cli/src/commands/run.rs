//! `wisch run`, `wisch plan`, `wisch predict` and `wisch follow`: run the stages and write the folder of results.

use super::extent::{Extent, choose_robot, find_single_option};
use super::goal::{GoalEpisode, GoalRun, GoalSummary, GoalTask, read_goal, read_step_number};
use super::interrupt::{is_stop_requested, say_which_part};
use super::out_folder::out_folder;
use super::patches::{PatchesSummary, TaskPatches, remark_earlier_patches};
use super::prepare::stage_failure;
use super::wipe::{PlanSource, wipe_surface};
use super::words::internal;
use crate::args::{
    FollowArgs, GlobalArgs, LoopArgs, PlanArgs, PredictArgs, ResultArgs, RobotArgs, TaskArgs,
    WipeArgs,
};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json, remark};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use wisch_io::{GoalFile, OutputFile, PLAN_FILE, REPORT_FILE, Summary, wipes_all_patches};
use wisch_record::RunClock;

/// The file of the steps of a goal, in the folder of results.
const STEPS_FILE: &str = "steps.json";

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
        let work = (task_args, &file);
        let done = work_on_goal(work, results, plan_file, extent, global)?;
        let summary = done.summary;
        if results.json {
            print_json(&summary)?;
        } else if !global.quiet {
            let kept = done.kept.as_ref().ok().and_then(Option::as_ref);
            let kept = kept.map(|place| format!("  {:<18} {}\n", "episode", place.display()));
            print(&(summary.in_words() + &kept.unwrap_or_default()))?;
        }
        if let Some(failure) = done.broken {
            return Err(failure);
        }
        // The results are complete at this point, even if the episode could not be kept.
        done.kept?;
        summary.is_met()
    } else if wipes_all_patches(&task_args.task, &task_args.settings)? {
        work_on_patches(task_args, results, plan_file, extent, global)?
    } else {
        let summarised = |summary: &Summary| match results.json {
            true => print_json(summary),
            false => Ok(()),
        };
        let source = PlanSource::File(plan_file);
        wipe_surface(task_args, results, source, extent, global, &summarised)?.is_met
    };
    Ok(if is_met {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// Runs a task with a goal of several parts, without printing its summary.
pub(super) fn run_goal(
    args: &FollowArgs,
    rounds: &LoopArgs,
    global: &GlobalArgs,
) -> Result<GoalSummary, Failure> {
    let file = read_goal(&args.task)?;
    let file = file.ok_or_else(|| stage_failure(&args.task, "the goal has a single part"))?;
    let (extent, work) = (Extent::Run(&args.robot, rounds), (&args.task, &file));
    let done = work_on_goal(work, &args.results, None, extent, global)?;
    done.broken.map_or(Ok(done.summary), Err)
}

/// The results of a command for a goal of several parts.
struct GoalDone {
    summary: GoalSummary,
    /// The failure of a step after the first one; the summary holds the steps before it.
    broken: Option<Failure>,
    /// The folder of the goal's episode; `None` if no episode was requested.
    kept: Result<Option<PathBuf>, Failure>,
}

/// Works on a goal of several parts, one step after another.
fn work_on_goal(
    (task_args, file): (&TaskArgs, &GoalFile),
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<GoalDone, Failure> {
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
    let task_args = &extent.apply_touch_only(task_args);
    let any_robot = RobotArgs::default();
    let robot = match extent {
        Extent::Run(args, _) | Extent::Follow(args) => Some(args),
        Extent::Plan { .. } | Extent::Predict => Some(&any_robot),
    };
    let progress = Progress::start(global);
    let known = OnceCell::new();
    let mut task =
        GoalTask::evaluate(task_args, file, (robot, extent.is_run()), &known, &progress)?;
    let plans = task.take_plans();
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
    remove_earlier_steps(&out)?;
    // Also if no step is needed.
    std::fs::create_dir_all(&out).map_err(|error| Failure::new(error).within(&out))?;
    let run = GoalRun::begin(&task, plans, is_executed, out.clone())?;
    let memory = extent.rounds().map(|rounds| &rounds.memory);
    let memory = memory.filter(|memory| is_executed && !memory.no_memory);
    let mut episode = memory.map(|memory| GoalEpisode {
        memory: memory.memory.clone(),
        clock: RunClock::start(),
        step_episodes: BTreeMap::new(),
    });
    let (summary, broken) = run.run(&mut |args, folder, plan| {
        let of_step = ResultArgs {
            out: Some(folder.to_owned()),
            force: results.force,
            json: results.json,
        };
        let source = PlanSource::Kept(plan);
        let mut done = wipe_surface(args, &of_step, source, extent, global, &|_| Ok(()))?;
        done.is_stopped |= is_stop_requested();
        if let (Some(goal), Some(number), Some(id)) =
            (&mut episode, read_step_number(folder), done.episode.clone())
        {
            goal.step_episodes.insert(number, id);
        }
        Ok(done)
    })?;
    let kept = episode.map_or(Ok(None), |episode| episode.keep(file, &summary));
    let json = serde_json::to_vec_pretty(&summary).map_err(internal)?;
    OutputFile::begin(&out.join(STEPS_FILE))?.finish(&json)?;
    OutputFile::begin(&out.join(REPORT_FILE))?.finish(summary.page().as_bytes())?;
    Ok(GoalDone {
        summary,
        broken,
        kept,
    })
}

/// Removes the folders of steps that an earlier run has listed in a folder of results.
fn remove_earlier_steps(out: &Path) -> Result<(), Failure> {
    let Ok(text) = std::fs::read_to_string(out.join(STEPS_FILE)) else {
        return Ok(());
    };
    let listed: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    let count = listed["steps"].as_array().map_or(0, Vec::len);
    for folder in (1..=count).map(|number| out.join(format!("step-{number}"))) {
        if folder.join(PLAN_FILE).exists() {
            let removed = std::fs::remove_dir_all(&folder);
            removed.map_err(|error| Failure::new(error).within(&folder))?;
        }
    }
    Ok(())
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
        let folder = out.join(format!("patch-{number}"));
        let name = format!("patch {number} of {count}");
        say_which_part(name, &out, &folder, !summaries.is_empty());
        let of_patch = ResultArgs {
            out: Some(folder),
            force: results.force,
            json: results.json,
        };
        let source = PlanSource::File(None);
        let done = match wipe_surface(task_args, &of_patch, source, extent, global, &|_| Ok(())) {
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
