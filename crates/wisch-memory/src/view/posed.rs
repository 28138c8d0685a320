//! Poses of things for a view.

use super::{Figure, ViewError};
use crate::frames::{Frames, PoseAt, Sampling};
use wisch::geometry::Point3;

/// Largest number of points in a line.
const MAX_POINTS: usize = 1500;
/// Least time between points of a line [s].
const FINEST_STEP: f64 = 0.02;

/// Returns a name without its prefix, which is the name of the frame.
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

/// Returns the kind of the thing with a name.
pub(super) fn figure(frames: &Frames, name: &str) -> Figure {
    let scene = frames.scene();
    if frames.robot().is_some() && (name == scene.robot || name == "robot") {
        Figure::Robot
    } else if name == scene.tool || name == "tool" {
        Figure::Tool
    } else if name == scene.surface || name == "surface" {
        Figure::Surface
    } else {
        Figure::Frame
    }
}
