//! Poses of things for a view.

use super::{Figure, ShownPart, ViewError};
use crate::frames::{Frames, PoseAt, Sampling};
use wisch::geometry::Point3;
use wisch::robot::RobotModel;

/// Largest number of points in a line.
const MAX_POINTS: usize = 1500;
/// Least time between points of a line [s].
const FINEST_STEP: f64 = 0.02;

/// Name of the frame.
pub(super) fn local(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}

pub(super) fn place(at: &PoseAt) -> Point3 {
    Point3::from(at.world_from_frame.translation.vector)
}

/// Returns the finely sampled path of a frame.
pub(super) fn line(
    frames: &Frames,
    frame: &str,
    [from, to]: [f64; 2],
) -> Result<Vec<Point3>, ViewError> {
    let step = ((to - from) / MAX_POINTS as f64).max(FINEST_STEP);
    let poses = frames.trajectory(frame, [from, to], Sampling::Every(step))?;
    Ok(poses.iter().map(place).collect())
}

pub(super) fn figure(frames: &Frames, name: &str, at: &PoseAt) -> Result<Figure, ViewError> {
    let scene = frames.scene();
    if let Some(robot) = frames.robot()
        && (name == scene.robot || name == "robot")
    {
        return Ok(Figure::Robot {
            parts: parts(frames, robot, at.time)?,
            world_from_tool: frames.pose("tool", at.time)?.world_from_frame,
        });
    }
    Ok(if name == scene.tool || name == "tool" {
        Figure::Tool(at.world_from_frame)
    } else if name == scene.surface || name == "surface" {
        Figure::Surface(at.world_from_frame)
    } else {
        Figure::Frame(at.world_from_frame)
    })
}

/// Returns the robot's solids at a time.
fn parts(frames: &Frames, robot: &RobotModel, time: f64) -> Result<Vec<ShownPart>, ViewError> {
    let poses = frames.links(time)?;
    let links = robot.links().iter().zip(poses);
    let parts = links.flat_map(|(link, world_from_link)| {
        link.collision.iter().map(move |solid| ShownPart {
            link: link.name.clone(),
            world_from_shape: world_from_link * solid.link_from_shape,
            shape: solid.shape.clone(),
        })
    });
    Ok(parts.collect())
}
