//! The robot's part of a run: who follows, the motion, and what is said of it.

use super::prepare::Prepared;
use super::words::percent;
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::records::FollowingSummary;
use crate::report::{
    Contact, Frames, MotionInput, ParticleFrame, Phase as ShownPhase, Placement, RatedPlace,
};
use crate::robots::Robot;
use std::time::Instant;
use wisch::follow::{
    Audit, FollowConfig, Followed, Phase, TrajectorySample, Workcell, WorkcellConfig, audit, follow,
};
use wisch::geometry::{Pose, Vector3};
use wisch::plan::Plan;
use wisch::represent::{Fate, RobotDescription, RobotRecord, ScenePart, Task};

/// What `--robot` says to leave the robot out.
const NO_ROBOT: &str = "none";
/// Period of what is shown of a motion [s].
const SHOWN_PERIOD: f64 = 0.05;

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
    /// How long finding it took [s].
    pub time_s: f64,
}

/// The robot that is to follow, if there is one.
pub fn chosen(args: &RobotArgs, prepared: &Prepared) -> Option<RobotRecord> {
    let in_file = prepared.file.robot();
    let record = match args.robot.as_deref() {
        Some(NO_ROBOT) => return None,
        Some(text) => RobotRecord {
            description: Robot::description(text),
            group: None,
            world_from_robot: in_file.and_then(|robot| robot.world_from_robot),
        },
        None => in_file?.clone(),
    };
    Some(RobotRecord {
        group: args.group.clone().or(record.group),
        ..record
    })
}

/// Lets the robot follow the plan.
pub fn follow_plan(
    record: &RobotRecord,
    args: &RobotArgs,
    task_args: &TaskArgs,
    prepared: &Prepared,
    plan: &Plan,
    progress: &Progress,
) -> Result<Following, Failure> {
    let task = &prepared.task;
    let robot = Robot::read(
        &record.description,
        &task_args.task,
        args.map.as_deref(),
        &args.packages,
    )?;
    let name = robot.model.name().to_owned();
    progress.say(format!("following with {name}"));
    let start = Instant::now();
    let config = WorkcellConfig {
        group: record.group.clone(),
        world_from_robot: record.world_from_robot.or_else(|| before_surface(task)),
        ..WorkcellConfig::default()
    };
    let in_task = |error: &dyn std::fmt::Display| prepared.failure(task_args, error);
    let cell = Workcell::new(robot.model, robot.srdf.as_ref(), task, &config)
        .map_err(|error| in_task(&error).with_help(help_for(&record.description)))?;
    let config = FollowConfig {
        seed: prepared.config.seed,
        ..FollowConfig::default()
    };
    let nodes: usize = plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum();
    let mut say = |passed: usize| {
        progress.say(format!("following with {name}: {passed} of {nodes} nodes"));
    };
    let followed = follow(task, plan, &cell, robot.map.as_ref(), &config, &mut say)
        .map_err(|error| in_task(&error).with_help(help_for(&record.description)))?;
    let time_s = start.elapsed().as_secs_f64();
    progress.say("checking the motion");
    let audit = audit(&followed, &cell, task, &config).map_err(|error| in_task(&error))?;
    Ok(Following {
        robot: name,
        cell,
        followed,
        audit,
        time_s,
    })
}

fn help_for(description: &RobotDescription) -> String {
    match description {
        RobotDescription::Named(_) => {
            "[robot] in the task file says where the robot stands; --robot none leaves it out"
                .into()
        }
        RobotDescription::Files { urdf, .. } => format!(
            "[robot] in the task file says where the robot stands, the SRDF beside {urdf} which \
             group wipes and a \"ready\" state that touches nothing"
        ),
    }
}

/// Where the scene shows the robot, facing the surface; on the floor.
fn before_surface(task: &Task) -> Option<Pose> {
    let stands = task
        .scene
        .iter()
        .find(|object| object.part == ScenePart::Robot)?;
    let at = stands.world_from_object.translation.vector;
    let towards = task.surface.world_from_surface.translation.vector - at;
    Some(Pose::new(
        Vector3::new(at.x, at.y, 0.0),
        Vector3::z() * towards.y.atan2(towards.x),
    ))
}

impl Following {
    /// The plan as the robot wipes it.
    pub fn plan(&self, plan: &Plan) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..plan.clone()
        }
    }

    /// The summary; `lost` is the share of particles that abandoned nodes cost.
    pub fn summary(&self, lost: f64) -> FollowingSummary {
        FollowingSummary {
            robot: self.robot.clone(),
            abandoned_nodes: self.followed.abandoned.len(),
            abandoned_share: lost,
            placements: (self.followed.placements.iter())
                .map(|placement| {
                    let at = placement.world_from_base;
                    [at.position.x, at.position.y, at.heading]
                })
                .collect(),
            execution_time_s: self.followed.duration(),
            contact_time_s: self.followed.contact_time(),
            following_time_s: self.time_s,
            max_path_deviation_m: self.audit.line.position,
            max_turn_deviation_rad: self.audit.line.rotation,
            min_clearance_m: self.audit.min_clearance,
            faults: self.audit.faults.len(),
        }
    }

    /// What it keeps to, for people.
    pub fn facts(&self, lost: f64) -> Vec<(String, String)> {
        let followed = &self.followed;
        let mut facts = vec![
            ("Robot", self.robot.clone()),
            (
                "Abandoned nodes",
                format!(
                    "{} ({} of the particles)",
                    followed.abandoned.len(),
                    percent(lost)
                ),
            ),
            ("Execution time", format!("{:.1} s", followed.duration())),
            (
                "Time in contact",
                format!("{:.1} s", followed.contact_time()),
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

    /// What the report shows of it.
    pub fn shown(&self, frames: &Frames) -> Shown {
        let count = (self.followed.duration() / SHOWN_PERIOD).ceil() as usize;
        let samples = (0..=count)
            .filter_map(|i| {
                self.followed
                    .sample((i as f64 * SHOWN_PERIOD).min(self.followed.duration()))
            })
            .collect();
        let phases = (self.followed.motions.iter())
            .map(|motion| ShownPhase {
                name: motion.phase.as_str().to_owned(),
                start: motion.start,
                end: motion.end(),
                contact: if motion.phase.is_contact() {
                    Contact::Wiping
                } else {
                    Contact::Lifted
                },
                stroke: motion.phase.stroke(),
            })
            .collect();
        let placements = (self.followed.placements.iter())
            .map(|placement| Placement {
                x: placement.world_from_base.position.x,
                y: placement.world_from_base.position.y,
                yaw: placement.world_from_base.heading,
            })
            .collect();
        let ratings = (self.followed.rated.iter())
            .map(|place| RatedPlace {
                x: place.world_from_base.position.x,
                y: place.world_from_base.position.y,
                rating: place.rating.unwrap_or(0.0),
                blocked: place.rating.is_none(),
            })
            .collect();
        Shown {
            samples,
            phases,
            placements,
            ratings,
            particles: self.particles(frames),
        }
    }

    /// The particles of a prediction's frames at the times at which the tool has come about that far:
    /// as if it wiped each stroke at one speed.
    fn particles(&self, frames: &Frames) -> Vec<ParticleFrame> {
        let mut before = vec![0.0];
        for stroke in &self.followed.strokes {
            before.push(before.last().unwrap_or(&0.0) + stroke.length());
        }
        let time = |stroke: usize, distance: f64| {
            let motions = &self.followed.motions;
            let motion = motions.iter().find(|m| m.phase == Phase::Wipe(stroke))?;
            let length = before.get(stroke + 1)? - before[stroke];
            let share =
                ((distance - before[stroke]) / length.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            Some(motion.start + share * motion.trajectory.duration())
        };
        let mut shown: Vec<ParticleFrame> = Vec::new();
        for frame in frames.all() {
            let since = shown.last().map_or(0.0, |last| last.time);
            let at = frame.stroke.and_then(|stroke| time(stroke, frame.distance));
            shown.push(ParticleFrame {
                time: at.unwrap_or(since).max(since),
                positions: (frame.particles.iter())
                    .filter(|(_, fate)| *fate == Fate::OnSurface)
                    .map(|(position, _)| *position)
                    .collect(),
            });
        }
        shown
    }
}

/// What a report shows of a motion.
pub struct Shown {
    samples: Vec<TrajectorySample>,
    phases: Vec<ShownPhase>,
    placements: Vec<Placement>,
    ratings: Vec<RatedPlace>,
    particles: Vec<ParticleFrame>,
}

impl Shown {
    /// The same with the robot and its scene.
    pub fn input<'a>(&'a self, following: &'a Following, task: &'a Task) -> MotionInput<'a> {
        MotionInput {
            robot: following.cell.robot(),
            world_from_root: *following.cell.world_from_root(),
            task,
            tool_link: following.cell.tip(),
            link_from_tool: *following.cell.tip_from_tool(),
            samples: &self.samples,
            phases: &self.phases,
            placements: &self.placements,
            ratings: &self.ratings,
            particles: &self.particles,
        }
    }
}
