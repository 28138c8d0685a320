//! The robot's part of a run: who follows, the motion, and what is said of it.

use super::prepare::Prepared;
use super::words::percent;
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use wisch::follow::{
    AbandonedNode, Audit, FollowConfig, FollowError, Followed, Workcell, WorkcellConfig, follow,
};
use wisch::plan::Plan;
use wisch::robot::CapabilityMap;
use wisch::run::{PlannedRound, Round, Session};
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
    /// Of the motions of all rounds that were executed, or else of this one.
    pub total: Total,
}

/// Of the motions of all rounds together.
#[derive(Debug, Clone, Copy, Default)]
pub struct Total {
    /// How many there are.
    pub rounds: usize,
    /// How long they last, and how long of it the tool wipes [s].
    pub time: [f64; 2],
    /// How far the arm's joints move while the tool wipes, and in all [rad].
    pub joint_movement: [f64; 2],
    /// Way of the tool in contact, and in all [m].
    pub distance: [f64; 2],
    /// How far the tool leaves its line at most [m], [rad].
    pub off_line: [f64; 2],
    /// How near bodies that must not touch come at least [m].
    pub clearance: f64,
}

impl Total {
    /// Of rounds that were executed.
    fn of_rounds(rounds: &[Round]) -> Self {
        let mut total = Self {
            rounds: rounds.len(),
            clearance: f64::INFINITY,
            ..Self::default()
        };
        let add = |sum: &mut [f64; 2], more: [f64; 2]| {
            sum[0] += more[0];
            sum[1] += more[1];
        };
        for round in rounds {
            let executed = round.executed();
            let duration = round.execution.duration;
            add(&mut total.time, [duration, executed.contact_time]);
            add(&mut total.joint_movement, executed.joint_movement);
            add(&mut total.distance, executed.distance);
            total.audited(&round.audit);
        }
        total
    }

    /// Of a motion that is not executed.
    fn of_motion(planned: &PlannedRound, audit: &Audit) -> Self {
        let PlannedRound { cell, followed, .. } = planned;
        let wiped = planned.wiped();
        let mut total = Self {
            rounds: 0,
            // The sum of nothing is -0.
            time: [followed.duration(), followed.contact_time() + 0.0],
            joint_movement: followed.joint_movement(cell.arm_variables()),
            distance: [wiped.contact_distance(), wiped.total_distance()],
            off_line: [0.0; 2],
            clearance: f64::INFINITY,
        };
        total.audited(audit);
        total
    }

    fn audited(&mut self, audit: &Audit) {
        self.off_line[0] = self.off_line[0].max(audit.line.position);
        self.off_line[1] = self.off_line[1].max(audit.line.rotation);
        self.clearance = self.clearance.min(audit.min_clearance);
    }

    /// What they are of, in words: nothing of a single motion.
    pub fn in_words(&self) -> String {
        match self.rounds {
            0 | 1 => String::new(),
            rounds => format!(" in {rounds} rounds"),
        }
    }
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
        let total = match session.rounds() {
            [] => Total::of_motion(planned, audit),
            rounds => Total::of_rounds(rounds),
        };
        Some(Self {
            total,
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
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
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
            execution_time_s: total.time[0],
            contact_time_s: total.time[1],
            first_obstruction: (self.followed.abandoned.first()).map(first_obstruction),
            following_time_s: self.time_s,
            max_path_deviation_m: total.off_line[0],
            max_turn_deviation_rad: total.off_line[1],
            min_clearance_m: total.clearance,
            faults: self.audit.faults.len(),
        }
    }

    /// What it keeps to, for people.
    pub fn facts(&self) -> Vec<(String, String)> {
        let followed = &self.followed;
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
        let rounds = total.in_words();
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
            ("Execution time", format!("{:.1} s{rounds}", total.time[0])),
            ("Time in contact", format!("{:.1} s{rounds}", total.time[1])),
            (
                "Joint movement",
                format!("{in_contact:.1} rad in contact, {in_all:.1} rad in all{rounds}"),
            ),
            (
                "Off the line at most",
                format!(
                    "{:.2} mm, {:.2}°",
                    1e3 * total.off_line[0],
                    total.off_line[1].to_degrees()
                ),
            ),
            (
                "Clearance at least",
                format!("{:.1} mm", 1e3 * total.clearance),
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
