//! The first piece of a recording: task, program, robot and tool.

use super::robot::RobotRecord;
use super::{RECORDING_SCHEMA, RecordingHead, words};
use crate::scene::{MeshRecord, Meshes, Solid};
use serde::Serialize;
use wisch::geometry::Pose;

#[derive(Serialize)]
pub(super) struct Head<'a> {
    piece: &'static str,
    schema: u32,
    title: &'a str,
    program: &'a str,
    begun: Option<String>,
    task: TaskRecord<'a>,
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
        let task = head.task;
        let robot = head
            .cell
            .map(|cell| RobotRecord::new(cell, head.appearance, meshes));
        let (link, pose) = match head.cell {
            Some(cell) => (Some(cell.tip().index()), *cell.tip_from_tool()),
            None => (None, Pose::identity()),
        };
        let tool = ToolRecord {
            link,
            solid: meshes.solid(&pose, &task.tool.mesh),
        };
        Self {
            piece: "head",
            schema: RECORDING_SCHEMA,
            title: head.title,
            program: head.program,
            // A run of the same task and seed gives the same bytes.
            begun: None,
            task: TaskRecord {
                action: task.action.as_str(),
                medium: &task.medium,
                tool: &task.tool.name,
                surface: &task.surface.name,
                strategy: head.strategy.as_str(),
                seed: task.seed,
                target: head.target,
                asked: words::describe_task(task, head.target),
            },
            robot,
            tool,
            meshes: meshes.since(0),
        }
    }
}
