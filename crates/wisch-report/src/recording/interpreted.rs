//! The pieces of a finished round: its result, and the simulated world's ground truth.

use super::incidents::{Incident, find_incidents};
use super::particles::{DensityRecord, find_density, flatten_remaining};
use super::samples::{round_share, round_to};
use super::surface::BendRecord;
use super::treated::TreatedPlaces;
use super::{RoundTruth, words};
use crate::scene::to_seven_numbers;
use serde::Serialize;
use std::borrow::Cow;
use wisch::interpret::{Diagnosis, Estimate, Event, EventKind, Interpretation};
use wisch::represent::{GoalState, ParticleDistribution, Performance, Surface};
use wisch::run::Round;

#[derive(Serialize)]
pub(super) struct Interpreted {
    piece: &'static str,
    round: usize,
    duration: f64,
    estimate: EstimateRecord,
    by_touch: EstimateRecord,
    verdict: &'static str,
    ending: &'static str,
    words: Vec<String>,
    found: Option<[f64; 7]>,
    events: Vec<EventRecord>,
    contacts: Vec<[f64; 2]>,
    incidents: Vec<Incident>,
    particles: Vec<i64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    density: Option<DensityRecord>,
    /// Mean values of the treated places over the belief, in steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    treated: Option<Vec<i64>>,
}

#[derive(Serialize)]
struct EstimateRecord {
    mean: f64,
    low: f64,
    high: f64,
}

#[derive(Serialize)]
pub(super) struct EventRecord {
    pub(super) kind: Cow<'static, str>,
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) words: String,
    pub(super) by_hand: bool,
}

#[derive(Serialize)]
pub(super) struct Truth {
    piece: &'static str,
    round: usize,
    performance: Option<f64>,
    particles: Option<Vec<i64>>,
    /// Number of particles on the surface, of which `particles` may be a part.
    #[serde(skip_serializing_if = "Option::is_none")]
    remaining: Option<usize>,
    /// True values of the treated places, in steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    treated: Option<Vec<i64>>,
    pushes: Vec<[f64; 2]>,
    surface: Option<[f64; 7]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<BendRecord>,
}

impl Interpreted {
    pub(super) fn new(round: &Round, target: f64, places: Option<&TreatedPlaces>) -> Self {
        let (motion, found) = (&round.motion, &round.interpretation);
        let is_shown = |event: &&Event| !event.kind.is_phase() && event.kind != EventKind::Contact;
        Self {
            piece: "interpreted",
            round: motion.number,
            duration: round_to(round.execution.duration, 1e3),
            estimate: EstimateRecord::new(found.performance),
            by_touch: EstimateRecord::new(found.by_touch),
            verdict: round.verdict.as_str(),
            ending: round.execution.ending.as_str(),
            words: words::describe_round(round, target),
            found: match &found.diagnosis {
                Diagnosis::Relocalize { world_from_surface } => {
                    Some(to_seven_numbers(world_from_surface))
                }
                _ => None,
            },
            events: (found.events.iter().filter(is_shown))
                .map(EventRecord::new)
                .collect(),
            contacts: list_contacts(found),
            incidents: find_incidents(round),
            particles: match places {
                Some(_) => Vec::new(),
                None => flatten_remaining(
                    find_typical_replay(found, &motion.plan.graph.goal, &motion.task.surface)
                        .unwrap_or(&motion.task.particles),
                ),
            },
            density: places.is_none().then(|| {
                find_density(&found.belief, &motion.plan.graph.goal, &motion.task.surface)
            }),
            treated: places.and_then(|places| places.mean_values(&found.belief)),
        }
    }
}

impl EstimateRecord {
    fn new(estimate: Estimate) -> Self {
        let [mean, low, high] = [estimate.mean, estimate.low, estimate.high].map(round_share);
        Self { mean, low, high }
    }
}

impl EventRecord {
    fn new(event: &Event) -> Self {
        Self {
            kind: crate::rounds::words::kind_name(event.kind).into(),
            start: round_to(event.start, 1e3),
            end: round_to(event.end, 1e3),
            words: crate::rounds::words::describe_evidence(event),
            by_hand: event.kind.is_by_hand(),
        }
    }
}

impl Truth {
    pub(super) fn new(truth: &RoundTruth<'_>, places: Option<&TreatedPlaces>) -> Self {
        let dirt = truth.particles.filter(|_| places.is_none());
        Self {
            piece: "truth",
            round: truth.round,
            performance: truth.performance.map(round_share),
            particles: match places {
                Some(_) => None,
                None => truth.particles.map(flatten_remaining),
            },
            remaining: dirt.map(|particles| particles.remaining().count()),
            treated: places
                .zip(truth.particles)
                .and_then(|(places, surface)| places.values(surface)),
            pushes: (truth.pushes.iter())
                .map(|times| times.map(|time| round_to(time, 1e3)))
                .collect(),
            surface: truth.world_from_surface.as_ref().map(to_seven_numbers),
            shape: truth.surface_shape.map(BendRecord::new),
        }
    }
}

/// Returns the belief's replay whose performance is nearest to the mean estimate, as a typical particle distribution.
fn find_typical_replay<'a>(
    found: &'a Interpretation,
    goal: &GoalState,
    surface: &Surface,
) -> Option<&'a ParticleDistribution> {
    let mean = found.performance.mean;
    let off = |particles: &ParticleDistribution| {
        (Performance::evaluate(particles, goal, surface).ratio() - mean).abs()
    };
    let replays = found.belief.members().iter();
    replays.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// Returns the detected contacts [s], whose number the summary of the round states.
fn list_contacts(found: &Interpretation) -> Vec<[f64; 2]> {
    let contacts = (found.events.iter()).filter(|event| event.kind == EventKind::Contact);
    contacts
        .map(|contact| [contact.start, contact.end].map(|time| round_to(time, 1e3)))
        .collect()
}
