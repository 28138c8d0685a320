//! Reasons for a plan: the gain of each stroke and of one more stroke, the yaw of the tool, and rated base poses.

use super::particles::{flatten_remaining, line};
use super::samples::{round_share, round_to};
use super::treated::TreatedPlaces;
use crate::draw::format_decimal;
use serde::Serialize;
use std::f64::consts::PI;
use wisch::follow::{Followed, Placement, RatedBasePose};
use wisch::geometry::{PlanarPose, Vector2, wrap_angle};
use wisch::plan::{Plan, Prediction, Stroke, predict};
use wisch::represent::{Performance, Task};

/// Largest number of strokes, times particles, for which the plans without one stroke are predicted, and that for films, whose
/// flow is predicted too. Either takes some tenths of a second.
const MAX_WORK: usize = 100_000;
const MAX_FILM_WORK: usize = 5_000;
/// Smallest gain of a repeated stroke that is stated [1].
const LEAST_GAIN: f64 = 5e-4;
/// Angle from which a stroke counts as turned against the plan [rad].
const TURNED: f64 = 0.087;
/// Directions of travel in half a turn among which the widest sweep is sought.
const DIRECTIONS: usize = 180;

/// The prediction for a plan without one of its strokes.
#[derive(Debug, Serialize)]
pub(super) struct LeftOut {
    stroke: usize,
    performance: f64,
    /// Lost share [1].
    lost: f64,
    particles: Vec<i64>,
    /// Values of the treated places, in steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    treated: Option<Vec<i64>>,
}

/// The stroke that gains most when it is repeated at the end.
#[derive(Debug, Serialize)]
pub(super) struct Repeated {
    gain: f64,
    line: Vec<i64>,
    /// Distance in contact [m].
    way: f64,
}

/// Base poses that were rated, and the indices of the chosen ones.
#[derive(Debug, Serialize)]
pub(super) struct RatedBases {
    /// x, y [m] and yaw [rad] in the world, and share of the path in reach; `None` for a chosen base that was not among
    /// the rated ones.
    poses: Vec<(f64, f64, f64, Option<f64>)>,
    chosen: Vec<usize>,
}

/// The reasons of a plan that the page shows; empty parts are left out.
#[derive(Debug, Default, Serialize)]
pub(super) struct Reasons {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    without: Vec<LeftOut>,
    #[serde(skip_serializing_if = "Option::is_none")]
    another: Option<Repeated>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bases: Option<RatedBases>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    headings: Vec<String>,
}

impl Reasons {
    /// Finds the reasons. `wiped`: the plan as the robot wipes it, with its prediction.
    pub(super) fn new(
        task: &Task,
        plan: &Plan,
        wiped: &Plan,
        followed: Option<&Followed>,
        prediction: &Prediction,
    ) -> Self {
        let most = if task.has_running_film() {
            MAX_FILM_WORK
        } else {
            MAX_WORK
        };
        let work = wiped.strokes.len().saturating_mul(task.particles.len());
        let (without, another) = if work <= most {
            (
                leave_out_each(task, wiped),
                repeat_best(task, wiped, prediction),
            )
        } else {
            (Vec::new(), None)
        };
        Self {
            without,
            another,
            bases: followed.and_then(|followed| rate_bases(&followed.rated, &followed.placements)),
            headings: (wiped.strokes.iter())
                .map(|stroke| explain_heading(task, plan, stroke))
                .collect(),
        }
    }
}

/// Returns the predicted share of lost dirt [1].
pub(super) fn find_lost_share(performance: &Performance) -> f64 {
    round_share(performance.lost as f64 / performance.initial.max(1) as f64)
}

fn predict_strokes(task: &Task, wiped: &Plan, strokes: Vec<Stroke>) -> Prediction {
    let plan = Plan {
        strokes,
        ..wiped.clone()
    };
    predict(task, &plan, |_| ())
}

fn leave_out_each(task: &Task, wiped: &Plan) -> Vec<LeftOut> {
    let places = TreatedPlaces::new(task);
    let without = |stroke: usize| {
        let mut strokes = wiped.strokes.clone();
        strokes.remove(stroke);
        let found = predict_strokes(task, wiped, strokes);
        LeftOut {
            stroke,
            performance: round_share(found.performance.ratio()),
            lost: find_lost_share(&found.performance),
            particles: match places {
                Some(_) => Vec::new(),
                None => flatten_remaining(&found.particles),
            },
            treated: (places.as_ref()).and_then(|places| places.values(&found.particles)),
        }
    };
    (0..wiped.strokes.len()).map(without).collect()
}

/// Returns the stroke whose repetition at the end gains most; `None` if none gains.
fn repeat_best(task: &Task, wiped: &Plan, prediction: &Prediction) -> Option<Repeated> {
    let whole = prediction.performance.ratio();
    let after = Task {
        particles: prediction.particles.clone(),
        ..task.clone()
    };
    let gain = |stroke: &Stroke| {
        let found = predict_strokes(&after, wiped, vec![stroke.clone()]);
        found.performance.ratio() - whole
    };
    let gains = wiped.strokes.iter().map(|stroke| (gain(stroke), stroke));
    let (gain, stroke) = gains
        .filter(|(gain, _)| *gain >= LEAST_GAIN)
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Repeated {
        gain: round_share(gain),
        line: line(stroke.poses.iter().map(|pose| &pose.position)),
        way: round_to(stroke.length(), 1e3),
    })
}

/// Returns the rated base poses at which the robot can stand; `None` if none was rated.
pub(super) fn rate_bases(rated: &[RatedBasePose], placements: &[Placement]) -> Option<RatedBases> {
    let flat = |pose: &PlanarPose, share: Option<f64>| {
        let at = pose.position;
        let [x, y, heading] = [at.x, at.y, pose.heading].map(|value| round_to(value, 1e3));
        (x, y, heading, share.map(|share| round_to(share, 1e3)))
    };
    let mut poses: Vec<(f64, f64, f64, Option<f64>)> = (rated.iter())
        .filter(|pose| pose.rating.is_some())
        .map(|pose| flat(&pose.world_from_base, pose.rating))
        .collect();
    if poses.is_empty() {
        return None;
    }
    let mut chosen = Vec::new();
    for placement in placements {
        // A placement's rating is another quantity: how amply the rest of the path is reached.
        let pose = flat(&placement.world_from_base, None);
        let is_same = |other: &(f64, f64, f64, Option<f64>)| {
            (other.0, other.1, other.2) == (pose.0, pose.1, pose.2)
        };
        let known = poses.iter().position(is_same);
        chosen.push(known.unwrap_or_else(|| {
            poses.push(pose);
            poses.len() - 1
        }));
    }
    Some(RatedBases { poses, chosen })
}

/// Explains how the tool is turned in a stroke: the width that it sweeps, and how it differs from the plan.
fn explain_heading(task: &Task, plan: &Plan, stroke: &Stroke) -> String {
    let Some(first) = stroke.motions().find(|motion| motion.travel().1 > 0.0) else {
        return "The tool touches one place without moving along it.".to_owned();
    };
    let (along, _) = first.travel();
    let travel = along.y.atan2(along.x) - first.from.heading;
    let swept = measure_sweep(task, travel);
    let (least, widest) = (0..DIRECTIONS)
        .map(|k| measure_sweep(task, PI * k as f64 / DIRECTIONS as f64))
        .fold((swept, swept), |(least, widest), width| {
            (least.min(width), widest.max(width))
        });
    // In steps of 5 mm, so that nearly equal strokes have the same sentence.
    let [swept, least, widest] =
        [swept, least, widest].map(|width| format_decimal(5.0 * (1e3 * width / 5.0).round(), 0));
    let lane = if least == widest {
        format!("The tool covers a lane of about {swept} mm")
    } else {
        format!(
            "The tool first covers a lane of about {swept} mm, of {least} to {widest} mm that its footprint allows"
        )
    };
    match measure_turn_against_plan(task, plan, stroke) {
        Some(turn) if turn.abs() > TURNED => format!(
            "{lane}. The robot turns the tool by {} degrees against the plan.",
            format_decimal(turn.to_degrees(), 0)
        ),
        _ => format!("{lane}."),
    }
}

/// Returns the width of the contact area across a direction in the tool frame [m].
fn measure_sweep(task: &Task, direction: f64) -> f64 {
    let across = Vector2::new(-direction.sin(), direction.cos());
    let polygons = task.tool.footprint.polygons().iter();
    let sides = polygons
        .flat_map(|polygon| polygon.outer())
        .map(|corner| corner.coords.dot(&across));
    let (low, high) = sides.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), side| {
        (low.min(side), high.max(side))
    });
    (high - low).max(0.0)
}

/// Returns by how much a stroke is turned against the planned one at its first node [rad]. Half a turn of a symmetric
/// contact area is none.
fn measure_turn_against_plan(task: &Task, plan: &Plan, stroke: &Stroke) -> Option<f64> {
    let node = *stroke.nodes.first()?;
    let planned = plan.strokes.iter().find_map(|planned| {
        let at = planned.nodes.iter().position(|&other| other == node)?;
        planned.poses.get(at)
    })?;
    let turn = wrap_angle(stroke.poses.first()?.heading - planned.heading);
    let half = turn.abs() > PI / 2.0 && task.tool.is_half_turn_symmetric();
    Some(if half { wrap_angle(turn + PI) } else { turn })
}
