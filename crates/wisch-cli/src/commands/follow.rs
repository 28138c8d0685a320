//! The robot's part of a run: who follows, the motion, and what is said of it.

use super::prepare::Prepared;
use super::words::percent;
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use wisch::follow::{
    AbandonedNode, Audit, FollowConfig, FollowError, Followed, Workcell, WorkcellConfig, follow,
};
use wisch::plan::Plan;
use wisch::robot::CapabilityMap;
use wisch::run::Session;
use wisch_io::FollowingSummary;
use wisch_io::{Robot, RobotDescription, RobotRecord};

/// What `--robot` says to leave the robot out.
const NO_ROBOT: &str = "none";

/// A plan with the robot that followed it.
pub struct Following {
    /// The robot's name.
    pub robot: String,
    /// Robot, tool and scene.
    pub cell: Workcell,
    /// The motion.
    pub followed: Followed,
    /// What an independent check says of it.
    pub audit: Audit,
    /// Share of the particles that abandoned nodes cost [1].
    pub abandoned_share: f64,
    /// How long finding and checking it took [s].
    pub time_s: f64,
}

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

/// The robot, as it is described.
pub fn performer(chosen: &Chosen<'_>, task_args: &TaskArgs) -> Result<Robot, Failure> {
    let Chosen { record, args } = chosen;
    let task_file = &task_args.task;
    Robot::read(
        &record.description,
        task_file,
        args.map.as_deref(),
        &args.packages,
    )
    .map_err(|error| match args.robot {
        Some(_) => Failure::from(error),
        None => Failure::from(error).within(task_file),
    })
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

/// What was in the way of a node when it was last tried.
fn first_obstruction(abandoned: &AbandonedNode) -> String {
    let why = match abandoned.attempts.first() {
        Some(attempt) => attempt.obstruction.to_string(),
        None => "no place for the base leads there".to_owned(),
    };
    format!("node {}: {why}", abandoned.node)
}

impl Following {
    /// The first motion of a session; `None` if no robot followed a plan.
    pub fn of(session: &Session<'_>, time_s: f64) -> Option<Self> {
        let (planned, audit) = session.first()?;
        Some(Self {
            robot: planned.cell.robot().name().to_owned(),
            cell: planned.cell.clone(),
            followed: planned.followed.clone(),
            audit: audit.clone(),
            abandoned_share: planned.abandoned_share(),
            time_s,
        })
    }

    /// The plan as the robot wipes it.
    pub fn plan(&self, plan: &Plan) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..plan.clone()
        }
    }

    /// The summary.
    pub fn summary(&self) -> FollowingSummary {
        let [in_contact, in_all] = self.joint_movement();
        FollowingSummary {
            joint_movement_in_contact_rad: in_contact,
            joint_movement_rad: in_all,
            robot: self.robot.clone(),
            abandoned_nodes: self.followed.abandoned.len(),
            abandoned_share: self.abandoned_share,
            placements: (self.followed.placements.iter())
                .map(|placement| {
                    let at = placement.world_from_base;
                    [at.position.x, at.position.y, at.heading]
                })
                .collect(),
            execution_time_s: self.followed.duration(),
            // The sum of nothing is -0.
            contact_time_s: self.followed.contact_time() + 0.0,
            first_obstruction: (self.followed.abandoned.first()).map(first_obstruction),
            following_time_s: self.time_s,
            max_path_deviation_m: self.audit.line.position,
            max_turn_deviation_rad: self.audit.line.rotation,
            min_clearance_m: self.audit.min_clearance,
            faults: self.audit.faults.len(),
        }
    }

    fn joint_movement(&self) -> [f64; 2] {
        self.followed.joint_movement(self.cell.arm_variables())
    }

    /// What it keeps to, for people.
    pub fn facts(&self) -> Vec<(String, String)> {
        let followed = &self.followed;
        let [in_contact, in_all] = self.joint_movement();
        let mut facts = vec![
            ("Robot", self.robot.clone()),
            (
                "Abandoned nodes",
                format!(
                    "{} ({} of the particles)",
                    followed.abandoned.len(),
                    percent(self.abandoned_share)
                ),
            ),
            ("Execution time", format!("{:.1} s", followed.duration())),
            (
                "Time in contact",
                format!("{:.1} s", followed.contact_time()),
            ),
            (
                "Joint movement",
                format!("{in_contact:.1} rad in contact, {in_all:.1} rad in all"),
            ),
            (
                "Off the line at most",
                format!(
                    "{:.2} mm, {:.2}°",
                    1e3 * self.audit.line.position,
                    self.audit.line.rotation.to_degrees()
                ),
            ),
            (
                "Clearance at least",
                format!("{:.1} mm", 1e3 * self.audit.min_clearance),
            ),
        ];
        if self.cell.base().is_some() {
            facts.push((
                "Placements of the base",
                followed.placements.len().to_string(),
            ));
        }
        if self.cell.second().is_some() {
            let off = format!("{:.2} mm", 1e3 * self.audit.grip.position);
            facts.push(("Second hand off its grip at most", off));
        }
        if !self.audit.faults.is_empty() {
            facts.push((
                "Faults found by the check",
                self.audit.faults.len().to_string(),
            ));
        }
        (facts.into_iter())
            .map(|(label, value)| (label.to_owned(), value))
            .collect()
    }
}
