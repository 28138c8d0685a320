//! `wisch robot setup`: proposes the SRDF of a robot that has only a URDF.

mod proposal;
mod text;
mod trial;

use crate::args::{GlobalArgs, RobotSetupArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use proposal::{Proposal, is_mobile, propose};
use std::path::{Path, PathBuf};
use text::{FailedRecord, SetupRecord, comments, describe, group_lines, next_steps, tip_note};
use wisch::robot::setup::{
    ArmChain, SetupConfig, SetupError, SetupStage, find_arms, find_table, held_posture,
};
use wisch::robot::{LinkId, RobotModel, VirtualJoint};
use wisch_io::{
    Error, LoadOptions, LoadedTask, OutputFile, RobotDescription, load_task, read_text,
    robot_meshes, robot_warnings,
};

/// Extension of the file.
const EXTENSION: &str = "srdf";

/// Searches groups, pairs and a ready posture, and writes them.
pub fn set_up(args: &RobotSetupArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the robot");
    let task = match &args.task {
        Some(path) => Some(load_task(
            path,
            &LoadOptions {
                settings: args.settings.clone(),
                ..LoadOptions::default()
            },
        )?),
        None => None,
    };
    let packages = list_packages(args, task.as_ref());
    let (robot, base) = read_robot(args, &packages)?;
    let tips = args.tips.iter().map(|tip| robot.link(tip));
    let tips: Vec<LinkId> = tips.collect::<Result<_, _>>().map_err(|error| {
        Failure::new(format!("--tip: {error}"))
            .with_help("name the link that holds the tool, such as tool0 or a flange")
    })?;
    // The file comes before the long computation, so that a missing permission is reported at once.
    let out = out_file(args)?;
    refuse_existing(&out, args.force)?;
    let file = OutputFile::begin(&out)?;
    let config = SetupConfig {
        seed: args.seed,
        ..SetupConfig::default()
    };
    let report = |stage, done, total| {
        let what = match stage {
            SetupStage::Pairs => "measuring pairs of links in random postures",
            SetupStage::NearestPostures => "searching the nearest posture of each pair",
            SetupStage::Ready => "searching a ready posture",
        };
        progress.say(format!("{what}: {done} of {total}"));
    };
    let mut proposal = match propose(&robot, &tips, task.as_ref(), &config, report) {
        Ok(proposal) => proposal,
        Err(
            error @ (SetupError::NoArm { .. }
            | SetupError::NoRange { .. }
            | SetupError::NoReadyPosture { .. }),
        ) => {
            drop((progress, file));
            let arms = find_arms(&robot, &tips).unwrap_or_default();
            return tell_failure(args, global, &robot, &error, &arms);
        }
        Err(error) => return Err(Failure::new(error).within(&args.file)),
    };
    proposal.srdf.virtual_joints.extend(base);
    progress.say("writing the SRDF");
    let comments = comments(&proposal, &robot, args, &config);
    let text = proposal.srdf.to_xml(&robot, &comments);
    refuse_existing(&out, args.force)?;
    file.finish(text.as_bytes())?;
    drop(progress);
    let warnings = robot_warnings(&robot);
    warnings.iter().for_each(|text| remark(text));
    if !warnings.is_empty() {
        remark("set the robot up again after these warnings are corrected");
    }
    tell(args, global, &robot, &proposal, &out)?;
    Ok(Outcome::Done)
}

/// Returns the folders of ROS packages: those of the command line, then those of the task.
fn list_packages(args: &RobotSetupArgs, task: Option<&LoadedTask>) -> Vec<(String, PathBuf)> {
    let mut packages = args.packages.clone();
    let description = task.and_then(|task| Some(&task.file.robot.as_ref()?.description));
    let folder = (args.task.as_deref()).and_then(Path::parent);
    if let Some(RobotDescription::Files {
        packages: of_task, ..
    }) = description
    {
        let folder = folder.unwrap_or(Path::new(""));
        let of_task = of_task.iter();
        packages.extend(of_task.map(|(name, path)| (name.clone(), folder.join(path))));
    }
    packages
}

/// Reads the robot; with `--mobile`, on a planar base, which is returned too.
fn read_robot(
    args: &RobotSetupArgs,
    packages: &[(String, PathBuf)],
) -> Result<(RobotModel, Option<VirtualJoint>), Failure> {
    let text = read_text(&args.file)?;
    let name = args.file.display().to_string();
    let mut meshes = robot_meshes(&args.file, packages);
    let mut read = |text: &str| {
        let read = RobotModel::from_urdf(&name, text, &mut meshes);
        let mut robot = read.map_err(|error| Error::Urdf {
            file: name.clone(),
            error: Box::new(error),
        })?;
        robot.assume_masses();
        Ok::<_, Failure>(robot)
    };
    let robot = read(&text)?;
    if !args.mobile {
        return Ok((robot, None));
    }
    if is_mobile(&robot, &find_arms(&robot, &[]).unwrap_or_default()) {
        return Err(
            Failure::new(format!("{name}: the robot has a base that drives already"))
                .with_help("leave --mobile out"),
        );
    }
    let base = VirtualJoint::planar(&robot.links()[robot.root().index()].name);
    let carried = base.carry(&text).ok_or_else(|| {
        let (joint, frame) = (&base.name, &base.parent_frame);
        Failure::new(format!(
            "{name}: --mobile adds the joint {joint:?} and the link {frame:?}, but one of them is there already"
        ))
        .with_help("rename it in the URDF")
    })?;
    Ok((read(&carried)?, Some(base)))
}

/// Returns the file of `--out`, else the file beside the URDF, where wisch finds the SRDF automatically.
fn out_file(args: &RobotSetupArgs) -> Result<PathBuf, Failure> {
    match &args.out {
        // The check prevents overwriting a task or a URDF by mistake.
        Some(out) if out.extension().is_none_or(|e| e != EXTENSION) => Err(Failure::new(format!(
            "{}: the file name of an SRDF must end in .{EXTENSION}",
            out.display()
        ))),
        Some(out) => Ok(out.clone()),
        None => Ok(args.file.with_extension(EXTENSION)),
    }
}

fn refuse_existing(out: &Path, force: bool) -> Result<(), Failure> {
    if force || !out.exists() {
        return Ok(());
    }
    let shown = out.display();
    Err(Failure::new(format!("{shown}: the file exists already"))
        .with_help("choose another name with --out, or overwrite it with --force"))
}

/// Describes where a surface is assumed without a task.
fn describe_assumed_place(robot: &RobotModel, arms: &[ArmChain]) -> String {
    let table = find_table(robot, arms, &held_posture(robot).0);
    match table.ok().flatten() {
        Some(top) => format!(
            "without a task, a table is assumed {:.3} m below the root of the robot, and the tool above both",
            -top
        ),
        None => {
            "without a task, a surface beside the robot is assumed, below its shoulder".to_owned()
        }
    }
}

/// Prints that a part of the SRDF could not be found.
fn tell_failure(
    args: &RobotSetupArgs,
    global: &GlobalArgs,
    robot: &RobotModel,
    error: &SetupError,
    arms: &[ArmChain],
) -> Result<Outcome, Failure> {
    let help = match error {
        SetupError::NoArm { .. } => "name the link that holds the tool with --tip".to_owned(),
        SetupError::NoRange { .. } => "correct the position limits in the URDF".to_owned(),
        _ if args.task.is_some() => {
            "move the robot or the surface in the task, or leave --task out".to_owned()
        }
        _ => format!(
            "{}: choose a task with --task, whose surface and obstacles are used instead, name another link with --tip, or check the collision shapes and the joint limits",
            describe_assumed_place(robot, arms)
        ),
    };
    if args.json {
        print(&FailedRecord::new(args, robot, error, &help).line()?)?;
    } else if !global.quiet {
        let name = robot.name();
        let mut text = format!("{name}: no SRDF written\n  {:<12} {error}\n", "reason");
        for arm in arms {
            let groups = group_lines(robot, arm).map(|line| ("group", line));
            let notes = tip_note(robot, arm).map(|note| ("note", note));
            for (label, line) in groups.chain(notes) {
                text += &format!("  {label:<12} {line}\n");
            }
        }
        print(&format!("{text}  {:<12} {help}\n", "try"))?;
    }
    Ok(Outcome::GoalNotMet)
}

fn tell(
    args: &RobotSetupArgs,
    global: &GlobalArgs,
    robot: &RobotModel,
    proposal: &Proposal,
    out: &Path,
) -> Result<(), Failure> {
    if args.json {
        print(&SetupRecord::new(args, robot, proposal, out).line()?)
    } else if global.quiet {
        Ok(())
    } else {
        let next = next_steps(args, robot, proposal, out);
        print(&(describe(args, robot, proposal, out) + &next))
    }
}
