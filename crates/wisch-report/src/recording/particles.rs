//! Particles over time, each step as its difference from the step before.

use super::samples::round_to;
use crate::scene::to_tenth;
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::geometry::Point2;
use wisch::interpret::Belief;
use wisch::represent::{GoalState, ParticleDistribution, Performance, Surface};

/// Maximum number of particles that are shown at one time.
const MAX_SHOWN: usize = 1_500;
/// Smallest side of a cell of a belief's density [m].
const DENSITY_CELL: f64 = 0.01;
/// Smallest expected number of particles of a shown cell.
const LEAST_EXPECTED: f64 = 0.02;
/// Largest share of the dirt in cells that a density leaves out [1].
const MAX_HIDDEN: f64 = 0.02;
/// Number of cells that are never merged.
const FEW_CELLS: usize = 4;
/// Maximum number of cells of a density.
const MAX_CELLS: usize = 4_000;
/// Maximum number of changes of particles in a round.
const MAX_CHANGES: usize = 24_000;

/// Time [s]; indices of removed particles in the step before; x, y of added particles in tenths of a millimetre.
pub(super) type ParticleStep = (f64, Vec<usize>, Vec<i64>);

/// Particles at a time [s].
pub(super) struct Moment {
    pub(super) time: f64,
    pub(super) places: Vec<Point2>,
}

/// Returns the steps between moments.
pub(super) fn steps(moments: &[Moment]) -> Vec<ParticleStep> {
    let most = moments.iter().map(|moment| moment.places.len()).max();
    let one_in = most.unwrap_or(0).div_ceil(MAX_SHOWN).max(1);
    let mut now: Vec<[i64; 2]> = Vec::new();
    let mut budget = MAX_CHANGES;
    let mut steps = Vec::new();
    for (i, moment) in moments.iter().enumerate() {
        let is_last = i + 1 == moments.len();
        let places = moment.places.iter().map(to_tenths);
        let mut wanted: BTreeMap<[i64; 2], usize> = BTreeMap::new();
        for place in places.filter(|place| is_shown(*place, one_in)) {
            *wanted.entry(place).or_default() += 1;
        }
        let mut removed = Vec::new();
        let mut next = Vec::new();
        for (index, place) in now.iter().enumerate() {
            match wanted.get_mut(place) {
                Some(count) if *count > 0 => {
                    *count -= 1;
                    next.push(*place);
                }
                _ => removed.push(index),
            }
        }
        let added: Vec<[i64; 2]> = (wanted.into_iter())
            .flat_map(|(place, count)| std::iter::repeat_n(place, count))
            .collect();
        // Beyond the budget, moments are skipped, except the first and the last.
        let changes = removed.len() + added.len();
        if changes > budget && !is_last && i > 0 {
            continue;
        }
        budget = budget.saturating_sub(changes);
        next.extend(&added);
        now = next;
        let time = round_to(moment.time, 1e3);
        steps.push((time, removed, added.into_flattened()));
    }
    steps
}

/// Returns the positions of particles on the surface, thinned.
pub(super) fn flatten_remaining(particles: &ParticleDistribution) -> Vec<i64> {
    let remaining = particles.remaining().map(|p| to_tenths(&p));
    let one_in = particles.len().div_ceil(MAX_SHOWN).max(1);
    let shown = remaining.filter(|place| is_shown(*place, one_in));
    shown.flatten().collect()
}

/// Returns positions, thinned.
pub(super) fn flatten_places(places: impl ExactSizeIterator<Item = Point2>) -> Vec<i64> {
    let one_in = places.len().div_ceil(MAX_SHOWN).max(1);
    let places = places.map(|p| to_tenths(&p));
    places
        .filter(|place| is_shown(*place, one_in))
        .flatten()
        .collect()
}

/// The density of a belief.
#[derive(Debug, Serialize)]
pub(super) struct DensityRecord {
    /// Side of a square cell [m].
    cell: f64,
    /// Middles of the cells.
    places: Vec<i64>,
    /// Expected number of particles in each cell.
    expected: Vec<f64>,
    /// Expected number of particles on the surface, also in cells that are left out.
    remaining: f64,
    /// Expected number of particles in the goal area, where dirt is collected.
    #[serde(skip_serializing_if = "Option::is_none")]
    goal: Option<f64>,
}

/// Returns the expected number of particles on the surface in each cell. The cells are as small as [`MAX_CELLS`] and
/// [`MAX_HIDDEN`] allow; of those that hold next to nothing, at most this share of the dirt is left out.
pub(super) fn find_density(belief: &Belief, goal: &GoalState, surface: &Surface) -> DensityRecord {
    let mean = |value: &dyn Fn(&ParticleDistribution) -> usize| {
        let total: f64 = belief.weights().iter().sum();
        let weighted = (belief.members().iter().zip(belief.weights()))
            .map(|(member, weight)| weight * value(member) as f64);
        weighted.fold(0.0, |sum, value| sum + value) / total
    };
    let collects = matches!(goal, GoalState::Collected { .. });
    let in_goal =
        |member: &ParticleDistribution| Performance::evaluate(member, goal, surface).achieved;
    let remaining = mean(&|member| member.remaining().count());
    let mut cell = DENSITY_CELL;
    let mut cells = count_expected(belief, cell);
    let shown = loop {
        let shown: Vec<([i64; 2], f64)> = (cells.iter())
            .filter(|(_, count)| **count >= LEAST_EXPECTED)
            .map(|(index, count)| (*index, round_to(*count, 1e2)))
            .collect();
        let held: f64 = shown
            .iter()
            .map(|(_, count)| count)
            .fold(0.0, |sum, count| sum + count);
        let is_complete = held >= (1.0 - MAX_HIDDEN) * remaining || cells.len() <= FEW_CELLS;
        if shown.len() <= MAX_CELLS && is_complete {
            break shown;
        }
        cell *= 2.0;
        let mut wider = BTreeMap::new();
        for (index, count) in cells {
            *wider
                .entry(index.map(|side: i64| side.div_euclid(2)))
                .or_default() += count;
        }
        cells = wider;
    };
    let (places, expected): (Vec<[i64; 2]>, Vec<f64>) = (shown.into_iter())
        .map(|(index, count)| {
            (
                index.map(|side| to_tenth((side as f64 + 0.5) * cell)),
                count,
            )
        })
        .unzip();
    DensityRecord {
        cell,
        places: places.into_flattened(),
        expected,
        remaining: round_to(remaining, 1e2),
        goal: collects.then(|| round_to(mean(&in_goal), 1e2)),
    }
}

fn count_expected(belief: &Belief, cell: f64) -> BTreeMap<[i64; 2], f64> {
    let total: f64 = belief.weights().iter().sum();
    let mut cells: BTreeMap<[i64; 2], f64> = BTreeMap::new();
    for (member, weight) in belief.members().iter().zip(belief.weights()) {
        for place in member.remaining() {
            let index = [place.x, place.y].map(|side| (side / cell).floor() as i64);
            *cells.entry(index).or_default() += weight / total;
        }
    }
    cells
}

/// Returns all points: x, y alternating, in tenths of a millimetre.
pub(super) fn line<'a>(points: impl IntoIterator<Item = &'a Point2>) -> Vec<i64> {
    points.into_iter().flat_map(to_tenths).collect()
}

/// Whether a particle is among the shown ones, of which there is one in `one_in`. The choice depends only on its position, so
/// that a resting particle is shown in every step or in none.
fn is_shown([x, y]: [i64; 2], one_in: usize) -> bool {
    // Fibonacci hashing: multiples of 2^64 over the golden ratio spread evenly.
    const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;
    let mixed = (x as u64).wrapping_mul(SPREAD) ^ (y as u64).wrapping_mul(SPREAD.rotate_left(32));
    (mixed.wrapping_mul(SPREAD) >> 32).is_multiple_of(one_in as u64)
}

fn to_tenths(p: &Point2) -> [i64; 2] {
    [to_tenth(p.x), to_tenth(p.y)]
}
