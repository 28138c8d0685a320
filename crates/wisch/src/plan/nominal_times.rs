//! Nominal durations of a plan's motions, during which a liquid film runs.

use super::Plan;
use crate::geometry::{PlanarPose, Point2};
use crate::represent::{DirtMobility, Task, ToolMotion, ToolPace};

/// Longest part of a motion after which the film is moved [s].
const LONGEST_PART: f64 = 0.5;

/// Nominal times of a task's motions; all are 0 if the dirt does not run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NominalTimes(Option<ToolPace>);

impl NominalTimes {
    pub(super) fn of(task: &Task) -> Self {
        match task.mobility {
            DirtMobility::Runs(film) if task.has_running_film() => Self(Some(film.pace)),
            _ => Self(None),
        }
    }

    /// Returns the time from the end of one stroke, or from the start of the tool, to the contact of the next [s].
    fn lifted(&self, from: Point2, to: Point2) -> f64 {
        (self.0).map_or(0.0, |pace| pace.landing + (to - from).norm() / pace.lifted)
    }

    /// Returns the parts of a motion in contact, each with its time [s].
    pub(super) fn parts(
        &self,
        motion: &ToolMotion,
    ) -> impl Iterator<Item = (ToolMotion, f64)> + use<> {
        let motion = *motion;
        let time = (self.0).map_or(0.0, |pace| motion.travel().1 / pace.contact);
        let count = (time / LONGEST_PART).ceil().max(1.0) as u32;
        let at = move |part: u32| {
            if part == 0 {
                return motion.from;
            }
            if part == count {
                return motion.to;
            }
            let share = f64::from(part) / f64::from(count);
            let way = motion.to.position - motion.from.position;
            let heading = motion.from.heading + motion.turn() * share;
            PlanarPose::new(motion.from.position + way * share, heading)
        };
        (0..count).map(move |part| {
            let (from, to) = (at(part), at(part + 1));
            (ToolMotion { from, to }, time / f64::from(count))
        })
    }

    /// Returns the times before the strokes of a plan [s].
    pub(super) fn before(&self, plan: &Plan) -> Vec<f64> {
        let poses = plan.strokes.iter().map(|stroke| &stroke.poses[..]);
        self.before_strokes(plan.tool_start, poses)
    }

    /// Returns the times before strokes, given by their poses [s]: from the tool's start, and from stroke to stroke.
    pub(super) fn before_strokes<'a>(
        &self,
        start: Point2,
        strokes: impl IntoIterator<Item = &'a [PlanarPose]>,
    ) -> Vec<f64> {
        let mut from = start;
        let times = strokes.into_iter().map(|poses| {
            let ends = [poses.first(), poses.last()];
            let [begin, end] = ends.map(|pose| pose.map_or(from, |pose| pose.position));
            let time = self.lifted(from, begin);
            from = end;
            time
        });
        times.collect()
    }
}
