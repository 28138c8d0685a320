//! The effect over time as numbers for the page's player.

use super::frames::{Frame, thinning};
use super::layers::Drawing;
use crate::draw::{
    View,
    surface::{Outcome, Particle},
};
use serde::Serialize;
use wisch::geometry::{PlanarPose, Point2};

/// Most particles that the player moves.
pub(crate) const MAX_MOVED: usize = 1_500;

/// What the player's script reads. Places are tenths of picture units, distances millimetres.
#[derive(Debug, Serialize)]
pub(crate) struct Player {
    /// Units of the picture per metre.
    scale: f64,
    /// Per frame: distance, share at the goal in tenths of a per cent.
    frames: Vec<(i64, i64)>,
    /// Per particle: x, y, outcome at the beginning.
    begin: Vec<(i64, i64, u8)>,
    /// Per frame after the first: particle, x, y, outcome of those that changed since the one before.
    changes: Vec<Vec<(usize, i64, i64, u8)>>,
    /// Motions in contact: distance at their begin and end, x, y, heading [mrad] at begin and end, stroke.
    motions: Vec<[i64; 9]>,
    /// The footprint's rings round the tool centre point.
    footprint: Vec<Vec<(i64, i64)>>,
    /// Where the tool waits: x, y, heading [mrad].
    start: (i64, i64, i64),
}

/// Every how many-th particle of the frames the player moves.
pub(crate) fn step(drawing: &Drawing) -> usize {
    let kept = drawing
        .input
        .frames
        .all()
        .first()
        .map_or(0, |frame| frame.particles.len());
    thinning(kept, MAX_MOVED)
}

impl Player {
    pub(crate) fn new(drawing: &Drawing, view: &View) -> Self {
        let input = drawing.input;
        let frames = input.frames.all();
        let step = step(drawing);
        let entry = |particle: &Particle| {
            let (x, y) = tenths(view, particle.0);
            let outcome = match drawing.outcome(*particle) {
                Outcome::Left => 0,
                Outcome::Done => 1,
                Outcome::Lost => 2,
                Outcome::Gone => 3,
            };
            (x, y, outcome)
        };
        let state = |frame: &Frame| -> Vec<(i64, i64, u8)> {
            frame.particles.iter().step_by(step).map(entry).collect()
        };
        let begin = frames.first().map(state).unwrap_or_default();
        let mut now = begin.clone();
        let changes = frames
            .iter()
            .skip(1)
            .map(|frame| {
                let next = state(frame);
                let changed = (0..next.len())
                    .filter(|&i| next[i] != now[i])
                    .map(|i| (i, next[i].0, next[i].1, next[i].2))
                    .collect();
                now = next;
                changed
            })
            .collect();
        let mut distance = 0.0;
        let mut motions = Vec::new();
        let place = |pose: &PlanarPose| {
            let (x, y) = tenths(view, pose.position);
            (x, y, thousandths(pose.heading))
        };
        for (i, stroke) in input.plan.strokes.iter().enumerate() {
            for motion in stroke.motions() {
                let from = thousandths(distance);
                distance += (motion.to.position - motion.from.position).norm();
                let to = thousandths(distance);
                let [(ax, ay, ah), (bx, by, bh)] = [&motion.from, &motion.to].map(place);
                motions.push([from, to, ax, ay, ah, bx, by, bh, i as i64]);
            }
        }
        let origin = view.at_origin();
        let footprint = input
            .task
            .tool
            .footprint
            .polygons()
            .iter()
            .flat_map(|polygon| polygon.rings())
            .map(|ring| ring.iter().map(|&p| tenths(&origin, p)).collect())
            .collect();
        let start = (frames.first()).map_or((0, 0, 0), |frame| place(&frame.surface_from_tool));
        Self {
            scale: view.scale,
            frames: frames
                .iter()
                .map(|f| {
                    let share = thousandths(f.performance.ratio());
                    (thousandths(f.distance), share)
                })
                .collect(),
            begin,
            changes,
            motions,
            footprint,
            start,
        }
    }
}

fn tenths(view: &View, p: Point2) -> (i64, i64) {
    let (x, y) = view.at(p);
    ((x * 10.0).round() as i64, (y * 10.0).round() as i64)
}

fn thousandths(value: f64) -> i64 {
    (value * 1000.0).round() as i64
}
