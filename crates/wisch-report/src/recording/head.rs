//! The first piece of a recording: task, program, robot and tool.

use super::logged::{LoggedEpisode, LoggedRobot, LoggedTask};
use super::robot::RobotRecord;
use super::{RECORDING_SCHEMA, RecordingHead, words};
use crate::scene::{MeshRecord, Meshes, Solid};
use serde::Serialize;
use wisch::geometry::Pose;
use wisch::robot::Appearance;

/// Radius of the ball that stands for a tool of unknown shape [m].
const UNKNOWN_TOOL: f64 = 0.02;

#[derive(Serialize)]
pub(super) struct Head<'a> {
    piece: &'static str,
    schema: u32,
    title: &'a str,
    program: &'a str,
    begun: Option<String>,
    task: Option<TaskRecord<'a>>,
    robot: Option<RobotRecord<'a>>,
    tool: ToolRecord,
    meshes: Vec<MeshRecord>,
}

#[derive(Serialize)]
struct TaskRecord<'a> {
    action: &'static str,
    medium: &'a str,
    tool: &'a str,
    surface: &'a str,
    strategy: &'static str,
    seed: u64,
    target: f64,
    asked: String,
}

#[derive(Serialize)]
struct ToolRecord {
    link: Option<usize>,
    solid: Solid,
}

impl<'a> Head<'a> {
    pub(super) fn new(head: &RecordingHead<'a>, meshes: &mut Meshes) -> Self {
        let robot = head.cell.map(|cell| LoggedRobot {
            model: cell.robot(),
            tip: cell.tip(),
            tip_from_tool: *cell.tip_from_tool(),
        });
        let task = LoggedTask {
            task: head.task,
            strategy: head.strategy,
            target: head.target,
        };
        let episode = LoggedEpisode {
            title: head.title,
            program: head.program,
            task: Some(task),
            robot,
        };
        Self::of_episode(&episode, head.appearance, meshes)
    }

    /// Makes the head of an episode. `appearance`: visual geometry of the robot; `None` shows its collision geometry.
    pub(super) fn of_episode(
        episode: &LoggedEpisode<'a>,
        appearance: Option<&Appearance>,
        meshes: &mut Meshes,
    ) -> Self {
        let robot = (episode.robot)
            .map(|robot| RobotRecord::new(robot.model, robot.tip, appearance, meshes));
        let (link, pose) = match episode.robot {
            Some(robot) => (Some(robot.tip.index()), robot.tip_from_tool),
            None => (None, Pose::identity()),
        };
        let solid = match episode.task {
            Some(known) => meshes.solid(&pose, &known.task.tool.mesh),
            None => Solid::ball(&pose, UNKNOWN_TOOL),
        };
        Self {
            piece: "head",
            schema: RECORDING_SCHEMA,
            title: episode.title,
            program: episode.program,
            // A run of the same task and seed gives the same bytes.
            begun: None,
            task: episode.task.map(TaskRecord::new),
            robot,
            tool: ToolRecord { link, solid },
            meshes: meshes.since(0),
        }
    }
}

impl<'a> TaskRecord<'a> {
    fn new(known: LoggedTask<'a>) -> Self {
        let task = known.task;
        Self {
            action: task.action.as_str(),
            medium: &task.medium,
            tool: &task.tool.name,
            surface: &task.surface.name,
            strategy: known.strategy.as_str(),
            seed: task.seed,
            target: known.target,
            asked: words::describe_task(task, known.target),
        }
    }
}
