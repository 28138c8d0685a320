//! The robot's part of a run: who follows, and from where.

use super::prepare::Prepared;
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use wisch::follow::{FollowConfig, FollowError, Workcell, WorkcellConfig, follow};
use wisch::plan::Plan;
use wisch::robot::CapabilityMap;
use wisch_io::{Robot, RobotDescription, RobotRecord};

/// What `--robot` says to leave the robot out.
const NO_ROBOT: &str = "none";

/// The robot that is to follow, with what the command line says of it.
pub struct Chosen<'a> {
    record: RobotRecord,
    args: &'a RobotArgs,
}

impl<'a> Chosen<'a> {
    /// The robot that is to follow, if there is one.
    ///
    /// # Errors
    /// Options that are of no use without a robot.
    pub fn new(args: &'a RobotArgs, prepared: &Prepared) -> Result<Option<Self>, Failure> {
        let in_file = prepared.file.robot();
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
    /// A failure to follow, with what can be done about it.
    pub fn cannot_follow(
        &self,
        error: &FollowError,
        task_args: &TaskArgs,
        prepared: &Prepared,
    ) -> Failure {
        cannot_follow(error, &self.record, task_args, prepared)
    }
}

fn no_robot(args: &RobotArgs) -> Result<(), Failure> {
    let useless = [
        ("--group", args.group.is_some()),
        ("--map", args.map.is_some()),
    ];
    match useless.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(
            Failure::new(format!("{option}: there is no robot to use it"))
                .with_help("add a [robot] table to the task, or name a robot with --robot"),
        ),
        None => Ok(()),
    }
}

/// The robot, as it is described; says what is odd about it and what is assumed of it.
pub fn performer(chosen: &Chosen<'_>, task_args: &TaskArgs) -> Result<Robot, Failure> {
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

/// Which part of the robot wipes, and where the robot stands.
pub fn workcell_config(chosen: &Chosen<'_>, prepared: &Prepared) -> WorkcellConfig {
    chosen.record.workcell_config(&prepared.task)
}

/// Robot, tool and scene, and what is known of the robot's reach.
pub fn workcell(
    chosen: &Chosen<'_>,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Result<(Workcell, Option<CapabilityMap>), Failure> {
    let robot = performer(chosen, task_args)?;
    let config = workcell_config(chosen, prepared);
    let cell = Workcell::new(robot.model, robot.srdf.as_ref(), &prepared.task, &config)
        .map_err(|error| cannot_follow(&error, &chosen.record, task_args, prepared))?;
    Ok((cell, robot.map))
}

/// Whether the robot can start; there need not be a plan.
pub fn can_start(
    cell: &Workcell,
    chosen: &Chosen<'_>,
    task_args: &TaskArgs,
    prepared: &Prepared,
    plan: &Plan,
) -> Result<(), Failure> {
    let nothing = Plan {
        strokes: Vec::new(),
        ..plan.clone()
    };
    let config = FollowConfig::default();
    follow(&prepared.task, &nothing, cell, None, &config, &mut |_| ())
        .map_err(|error| cannot_follow(&error, &chosen.record, task_args, prepared))?;
    Ok(())
}

/// Which robot stands where, in one line.
pub fn stand_in_words(cell: &Workcell) -> String {
    let robot = cell.robot();
    let tip = &robot.links()[cell.tip().index()].name;
    let place = match cell.base() {
        Some(base) => {
            let [x, y, yaw] = [base.x, base.y, base.yaw].map(|i| cell.ready()[i]);
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
    format!("{} holds the tool with {tip}; it {place}", robot.name())
}

fn cannot_follow(
    error: &FollowError,
    record: &RobotRecord,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Failure {
    let failure = prepared.failure(task_args, error);
    match (error, &record.description) {
        (FollowError::UnknownGroup(_), _) => {
            failure.with_help("groups are those of the robot's SRDF; without --group and group in [robot], its first wipes")
        }
        (_, RobotDescription::Named(_)) => failure.with_help(
            "[robot] in the task file says where the robot stands; --robot none leaves it out",
        ),
        (_, RobotDescription::Files { urdf, .. }) => failure.with_help(format!(
            "[robot] in the task file says where the robot stands, the SRDF beside {urdf} which \
             group wipes and a \"ready\" state that touches nothing"
        )),
    }
}
