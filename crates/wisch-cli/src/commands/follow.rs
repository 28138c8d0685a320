//! The robot that follows plans: its description, its workcell and its first posture.

use super::prepare::stage_failure;
use crate::args::{RobotArgs, TaskArgs, suggest};
use crate::failure::Failure;
use crate::terminal::remark;
use std::path::Path;
use wisch::follow::{FollowError, Followed, Workcell, WorkcellConfig, follow};
use wisch::plan::Plan;
use wisch::robot::{CapabilityMap, RobotError};
use wisch_io::{LoadedTask, Robot, RobotDescription, RobotRecord, shell_word};

/// Value of `--robot` for no robot.
const NO_ROBOT: &str = "none";

/// The robot of the task file or the command line, with the options for it.
pub struct Chosen<'a> {
    record: RobotRecord,
    args: &'a RobotArgs,
}

impl<'a> Chosen<'a> {
    /// Chooses the robot of `--robot`, else the task's robot; `None` without either.
    ///
    /// # Errors
    /// If there is no robot but `--group` or `--map` is given.
    pub fn new(args: &'a RobotArgs, prepared: &LoadedTask) -> Result<Option<Self>, Failure> {
        let in_file = prepared.file.robot.as_ref();
        let record = match (args.robot.as_deref(), in_file) {
            (Some(NO_ROBOT), _) | (None, None) => return no_robot(args).map(|()| None),
            (Some(text), _) => RobotRecord {
                description: Robot::description(text),
                group: None,
                second_group: None,
                world_from_robot: in_file.and_then(|robot| robot.world_from_robot),
            },
            (None, Some(record)) => record.clone(),
        };
        let group = args.group.clone().or(record.group);
        let record = RobotRecord { group, ..record };
        Ok(Some(Self { record, args }))
    }
}

impl Chosen<'_> {
    /// Makes a failure from an error of following, with advice.
    pub fn cannot_follow(&self, error: &FollowError, task_args: &TaskArgs) -> Failure {
        cannot_follow(error, &self.record, task_args)
    }
}

fn no_robot(args: &RobotArgs) -> Result<(), Failure> {
    let useless = [
        ("--group", args.group.is_some()),
        ("--map", args.map.is_some()),
    ];
    match useless.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(Failure::new(format!(
            "{option}: needs a robot, but the task has none"
        ))
        .with_help("add a [robot] table to the task, or choose a robot with --robot")),
        None => Ok(()),
    }
}

/// Reads the robot's description and prints its warnings and assumptions as notes.
pub fn read_robot(chosen: &Chosen<'_>, task_args: &TaskArgs) -> Result<Robot, Failure> {
    let Chosen { record, args } = chosen;
    let task_file = &task_args.task;
    let robot = Robot::read(
        &record.description,
        task_file,
        args.map.as_deref(),
        &args.packages,
    )
    .map_err(|error| match args.robot {
        Some(_) => Failure::from(error),
        None => Failure::from(error).within(task_file),
    })?;
    robot.remarks().iter().for_each(|text| remark(text));
    Ok(robot)
}

/// The planning groups that wipe, and the pose of the robot.
pub fn workcell_config(chosen: &Chosen<'_>, prepared: &LoadedTask) -> WorkcellConfig {
    chosen.record.workcell_config(&prepared.task)
}

/// Reads the robot and returns its workcell with the tool and the scene, and its capability map if it has one.
pub fn workcell(
    chosen: &Chosen<'_>,
    task_args: &TaskArgs,
    prepared: &LoadedTask,
) -> Result<(Workcell, Option<CapabilityMap>), Failure> {
    let robot = read_robot(chosen, task_args)?;
    let config = workcell_config(chosen, prepared);
    let cell = Workcell::new(robot.model, robot.srdf.as_ref(), &prepared.task, &config)
        .map_err(|error| cannot_follow(&error, &chosen.record, task_args))?;
    Ok((cell, robot.map))
}

/// Follows a plan, to see what of it the robot reaches.
pub fn follow_plan(
    (cell, map): &(Workcell, Option<CapabilityMap>),
    chosen: &Chosen<'_>,
    task_args: &TaskArgs,
    prepared: &LoadedTask,
    plan: &Plan,
    progress: &mut dyn FnMut(usize),
) -> Result<Followed, Failure> {
    let config = prepared.run.follow.clone();
    follow(&prepared.task, plan, cell, map.as_ref(), &config, progress)
        .map_err(|error| cannot_follow(&error, &chosen.record, task_args))
}

/// Describes in one line the robot, the link that holds the tool, and the robot's position.
pub fn describe_stand(cell: &Workcell) -> String {
    let robot = cell.robot();
    let place = match cell.base() {
        Some(base) => {
            let [x, y, yaw] = [base.x, base.y, base.yaw].map(|i| cell.ready_posture()[i]);
            format!(
                "starts at ({x:.3}, {y:.3}) m, heading {:.1}°, and moves its base",
                yaw.to_degrees()
            )
        }
        None => {
            let at = cell.world_from_root().translation.vector;
            format!("is fixed at ({:.3}, {:.3}, {:.3}) m", at.x, at.y, at.z)
        }
    };
    format!("{}; it {place}", robot.name())
}

fn cannot_follow(error: &FollowError, record: &RobotRecord, task_args: &TaskArgs) -> Failure {
    let failure = stage_failure(task_args, error);
    match (error, &record.description) {
        (
            FollowError::Robot(_) | FollowError::TooSlow { .. },
            RobotDescription::Files { urdf, .. },
        ) => {
            let failure = Failure::new(error).within(Path::new(urdf));
            match error {
                FollowError::Robot(RobotError::ChainTooLong { .. }) => failure.with_help(
                    "name a group with a shorter chain in the robot's SRDF, or make joints that need not move fixed",
                ),
                _ => failure.with_help(format!(
                    "see all findings with {}",
                    suggest(&format!("robot check {}", shell_word(urdf)))
                )),
            }
        }
        (FollowError::UnknownGroup(_), _) => {
            failure.with_help("choose a group of the robot's SRDF with --group, or group in [robot]; the default is the first group")
        }
        (_, RobotDescription::Named(_)) => failure.with_help(
            "set the robot's position in the task's [robot] table, or use no robot with --robot none",
        ),
        (_, RobotDescription::Files { urdf, .. }) => failure.with_help(format!(
            "check the robot's position in the task's [robot] table, and in the SRDF beside {urdf} the planning \
             group and a collision-free state named \"ready\""
        )),
    }
}
