//! Pieces of measured samples.

use super::UnexecutedPlan;
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::follow::{Followed, Phase, ToolPose, Workcell};
use wisch::geometry::{Point3, Pose, Vector3, flatten_pose};
use wisch::represent::{ChartPoint, Surface};
use wisch::run::{PlannedRound, TelemetrySample};

/// Samples per second of a recording.
const RATE: f64 = 25.0;
/// Speed of the tool in a recording without a robot [m/s].
pub(super) const NOMINAL_SPEED: f64 = 0.1;
/// Number of samples in a piece.
const BATCH: usize = 10;
/// A force peak between two samples that exceeds them by this much is kept [N].
const PEAK: f64 = 5.0;

#[derive(Serialize)]
pub(super) struct Samples {
    piece: &'static str,
    round: usize,
    t: Vec<f64>,
    /// Positions by index of the variable.
    q: BTreeMap<usize, Vec<f64>>,
    tool: Vec<f64>,
    force: Vec<f64>,
    normal: Vec<f64>,
    height: Vec<f64>,
}

/// Samples of an unfinished piece.
#[derive(Debug, Default)]
pub(super) struct Batch {
    round: usize,
    surface: Option<Surface>,
    times: Vec<f64>,
    positions: Vec<Vec<f64>>,
    tool: Vec<f64>,
    force: Vec<f64>,
    normal: Vec<f64>,
    height: Vec<f64>,
    /// Positions at the end of the piece before; `None` before the first.
    last: Option<Vec<f64>>,
    last_time: Option<f64>,
    /// Largest normal force since the last sample [N].
    peak: f64,
}

impl Batch {
    pub(super) fn of(planned: &PlannedRound) -> Self {
        Self::new(planned.number, planned.task.surface.clone())
    }

    pub(super) fn new(round: usize, surface: Surface) -> Self {
        Self {
            round,
            surface: Some(surface),
            ..Self::default()
        }
    }

    /// Number of the round; 0 before the first.
    pub(super) const fn round(&self) -> usize {
        self.round
    }

    /// Adds a sample; returns whether a piece is full.
    pub(super) fn watch(&mut self, sample: &TelemetrySample<'_>) -> bool {
        // Sums of periods have rounding errors.
        const SLACK: f64 = 1e-6;
        let (_, normal) = self.measure(&sample.world_from_tool, &sample.external.force);
        if normal.abs() > self.peak.abs() {
            self.peak = normal;
        }
        if (self.last_time).is_some_and(|last| sample.time < last + 1.0 / RATE - SLACK) {
            return false;
        }
        let shown = if self.peak.abs() > normal.abs() + PEAK {
            self.peak
        } else {
            normal
        };
        self.peak = 0.0;
        let force = sample.external.force;
        self.push(
            sample.time,
            sample.positions,
            &sample.world_from_tool,
            force,
            shown,
        );
        self.times.len() >= BATCH
    }

    /// Returns the tool's height over the surface \[m\], and a force's part along the normal under the tool \[N\].
    fn measure(&self, world_from_tool: &Pose, force: &Vector3) -> (f64, f64) {
        let tool = Point3::from(world_from_tool.translation.vector);
        let Some(surface) = &self.surface else {
            return (tool.z, force.z);
        };
        let ChartPoint { place, height } = surface.chart(tool);
        let turn = surface.shape.orientation(place).inverse();
        let in_surface = turn * (surface.world_from_surface.inverse() * force);
        (height, in_surface.z)
    }

    fn push(&mut self, time: f64, q: &[f64], world_from_tool: &Pose, force: Vector3, normal: f64) {
        self.last_time = Some(time);
        self.times.push(round_to(time, 1e3));
        self.positions
            .push(q.iter().map(|&q| round_to(q, 1e4)).collect());
        self.tool.extend(round_pose(world_from_tool));
        self.force
            .extend([force.x, force.y, force.z].map(|f| round_to(f, 1e2)));
        self.normal.push(round_to(normal, 1e2));
        let (height, _) = self.measure(world_from_tool, &force);
        self.height.push(round_to(height, 1e4));
    }

    /// Takes the collected samples as a piece.
    pub(super) fn take(&mut self) -> Option<Samples> {
        let last = self.positions.last()?.clone();
        let before = self.last.as_ref();
        let q = (0..last.len())
            .map(|i| (i, self.positions.iter().map(|q| q[i]).collect::<Vec<f64>>()))
            .filter(|(i, values)| match before {
                Some(before) => values.iter().any(|value| *value != before[*i]),
                None => true,
            })
            .collect();
        self.positions.clear();
        self.last = Some(last);
        let take = std::mem::take::<Vec<f64>>;
        Some(Samples {
            piece: "samples",
            round: self.round,
            t: take(&mut self.times),
            q,
            tool: take(&mut self.tool),
            force: take(&mut self.force),
            normal: take(&mut self.normal),
            height: take(&mut self.height),
        })
    }
}

/// Samples a motion that is not executed, at the rate of executed motions.
pub(super) fn planned(planned: &UnexecutedPlan<'_>) -> Vec<Samples> {
    let mut batch = Batch::new(1, planned.task.surface.clone());
    let mut pieces = Vec::new();
    match planned.followed {
        Some((cell, followed, _)) => {
            let count = (followed.duration() * RATE).ceil() as usize;
            for i in 0..=count {
                let time = (i as f64 / RATE).min(followed.duration());
                let Some(sample) = followed.sample(time) else {
                    continue;
                };
                let Some(tool) = find_world_from_tool(cell, &sample.q) else {
                    continue;
                };
                batch.push(time, &sample.q, &tool, Vector3::zeros(), 0.0);
                if batch.times.len() >= BATCH {
                    pieces.extend(batch.take());
                }
            }
        }
        None => {
            for frame in planned.frames.frames() {
                let at = ToolPose {
                    surface_from_tool: frame.surface_from_tool,
                    height: 0.0,
                    tilt: 0.0,
                };
                let pose = Workcell::world_from_tool(planned.task, &at);
                let time = frame.distance / NOMINAL_SPEED;
                batch.push(time, &[], &pose, Vector3::zeros(), 0.0);
            }
        }
    }
    pieces.extend(batch.take());
    pieces
}

fn find_world_from_tool(cell: &Workcell, q: &[f64]) -> Option<Pose> {
    let kinematics = cell.robot().forward_kinematics(q).ok()?;
    Some(cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool())
}

/// Returns the time at which the tool has covered a distance in contact [m], at constant speed within a stroke [s].
pub(super) fn seconds_at(
    followed: Option<&Followed>,
    stroke: Option<usize>,
    distance: f64,
) -> Option<f64> {
    let Some(followed) = followed else {
        return Some(distance / NOMINAL_SPEED);
    };
    let stroke = stroke?;
    let before: f64 = (followed.strokes.iter().take(stroke))
        .map(wisch::plan::Stroke::length)
        .sum();
    let length = followed.strokes.get(stroke)?.length();
    let motion = (followed.motions.iter()).find(|m| m.phase == Phase::Wipe(stroke))?;
    let share = ((distance - before) / length.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    Some(motion.start + share * motion.trajectory.duration())
}

/// Rounds a pose to a tenth of a millimetre and of a milliradian.
fn round_pose(pose: &Pose) -> [f64; 7] {
    flatten_pose(pose).map(|number| round_to(number, 1e4))
}

/// Rounds a share to a millionth: a page that shows tenths of a percent then rounds it as this program does.
pub(super) fn round_share(share: f64) -> f64 {
    round_to(share, 1e6)
}

/// Rounds a number to multiples of `1 / per_unit`; adding zero avoids "-0.0".
pub(super) fn round_to(value: f64, per_unit: f64) -> f64 {
    (value * per_unit).round() / per_unit + 0.0
}
