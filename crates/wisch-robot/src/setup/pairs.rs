//! Pairs of links that need no collision check, from random postures.

use super::postures::{
    MAX_NEAR_VARIABLES, default_posture, held_posture, is_within_limits, random_stream, range_of,
    variables_between,
};
use super::{ArmChain, SetupConfig, SetupError, SetupStage};
use crate::clearance::{PairDistance, draw_posture};
use crate::{CollisionModel, DisabledPair, LinkId, RobotModel};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of postures of a random stream; threads take streams in any order.
const CHUNK: usize = 250;
/// Largest number of draws per posture, to get enough postures within the limits of joints that
/// follow others.
const MAX_DRAWS: usize = 20;
/// Share of the postures in which a pair overlaps that is called "Always" [1]; as in MoveIt's Setup Assistant.
const ALWAYS_SHARE: f64 = 0.95;
/// The same for near links [1].
const NEAR_SHARE: f64 = 0.5;
/// Share of the postures in which a pair overlaps that may be called "Default" [1].
const DEFAULT_SHARE: f64 = 0.5;
/// Number of steps of a descent to the least distance of a pair.
const DESCENT_STEPS: i32 = 300;
/// First step of a descent, as a share of a joint's range, and its factor from step to step [1].
const FIRST_STEP: f64 = 0.2;
const STEP_FACTOR: f64 = 0.985;

/// Pairs of links that are not checked against each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinkPairs {
    /// The pairs with their reasons, in the order Adjacent, Never, Always, Default.
    pub disabled: Vec<DisabledPair>,
    /// Pairs called `Always` that overlap or are close in fewer than 95 % of the postures: near
    /// links that are checked in no posture, although they are apart in some.
    pub often: Vec<[LinkId; 2]>,
    /// Number of pairs of links with shapes.
    pub total: usize,
    /// Number of pairs that collide in no random posture but come within the margin in a descent, and so stay checked.
    pub near: usize,
    /// Number of random postures within the limits.
    pub samples: usize,
}

impl LinkPairs {
    /// Number of pairs with a reason.
    pub fn count(&self, reason: &str) -> usize {
        self.disabled
            .iter()
            .filter(|pair| pair.reason == reason)
            .count()
    }
}

/// Finds the pairs of links that need no collision check, with the reasons of MoveIt's Setup Assistant:
///
/// - `Adjacent`: one link holds the other, and no link between them has shapes.
/// - `Never`: the pair overlaps in no random posture, and a descent from the closest one ends farther apart than
///   [`SetupConfig::never_margin`]. A pair that random postures merely miss stays checked.
/// - `Always`: the pair overlaps or is within 6 mm, which leaves no room to plan, in at least 95 % of the postures. For
///   near links 50 % are enough, because convex shapes are coarser than the links. Near links have at most three
///   variables between them.
/// - `Default`: the pair overlaps in the default posture: at 0, or in the middle of the limits of a joint that cannot be
///   at 0. The links are near, or the pair overlaps in at least half of the random postures as well. A pair that no
///   group moves is also `Default` if it overlaps in the posture of [`held_posture`], where it stays.
///
/// Postures are drawn within the limits of all joints. `progress` is called occasionally, from several threads and not
/// always in order, with a stage, the work done and all work.
///
/// # Errors
/// If a setting is out of range, or a group does not fit the robot.
///
/// # Panics
/// If a link of a group belongs to another, larger robot.
pub fn sample_pairs(
    robot: &RobotModel,
    arms: &[ArmChain],
    config: &SetupConfig,
    progress: impl Fn(SetupStage, usize, usize) + Sync,
) -> Result<LinkPairs, SetupError> {
    config.check()?;
    let model = CollisionModel::of_links(robot);
    let links = model.checked_links();
    let (default, held) = (default_posture(robot), held_posture(robot).0);
    let (distances, samples) = measure(robot, &model, &held, config, &progress);
    let least = descend_all(robot, &model, &distances, config, &progress);
    let mut moved = Vec::new();
    for group in arms.iter().flat_map(|arm| &arm.groups) {
        let chain = robot.chain(group.group.base, group.group.tip)?;
        moved.extend_from_slice(chain.variables());
    }
    let neighbours = model.neighbouring_links().into_iter();
    let mut pairs: Vec<([LinkId; 2], &str)> = neighbours.map(|pair| (pair, "Adjacent")).collect();
    let fixed = model.fixed_links();
    let total = pairs.len() + fixed.len() + links.len();
    let overlap = |always: bool| if always { "Always" } else { "Never" };
    pairs.extend(
        fixed
            .into_iter()
            .map(|(pair, overlaps)| (pair, overlap(overlaps))),
    );
    let (mut near, mut often) = (0, Vec::new());
    for (i, &pair) in links.iter().enumerate() {
        let share = distances[i].overlaps as f64 / samples.max(1) as f64;
        let between = variables_between(robot, pair);
        let is_held = || !between.iter().any(|v| moved.contains(v));
        let overlaps_at = |q: &[f64]| model.pair_distance(i, q, 0.0) <= 0.0;
        let is_near = between.len() <= MAX_NEAR_VARIABLES;
        let always = if is_near { NEAR_SHARE } else { ALWAYS_SHARE };
        let close_share = distances[i].close as f64 / samples.max(1) as f64;
        if close_share >= always {
            pairs.push((pair, "Always"));
            if close_share < ALWAYS_SHARE {
                often.push(pair);
            }
        } else if distances[i].overlaps == 0 && samples > 0 {
            match least[i] > config.never_margin {
                true => pairs.push((pair, "Never")),
                false => near += 1,
            }
        } else if (is_near || share >= DEFAULT_SHARE) && overlaps_at(&default)
            || is_held() && overlaps_at(&held)
        {
            pairs.push((pair, "Default"));
        }
    }
    let order = |reason: &str| {
        ["Adjacent", "Never", "Always", "Default"]
            .iter()
            .position(|r| *r == reason)
    };
    pairs.sort_by_key(|(pair, reason)| (order(reason), *pair));
    let disabled = pairs.into_iter().map(|([a, b], reason)| DisabledPair {
        a,
        b,
        reason: reason.to_owned(),
    });
    Ok(LinkPairs {
        disabled: disabled.collect(),
        often,
        total,
        near,
        samples,
    })
}

/// Measures all pairs in random postures within the limits. Returns the number of these postures as well.
fn measure(
    robot: &RobotModel,
    model: &CollisionModel,
    held: &[f64],
    config: &SetupConfig,
    progress: &(impl Fn(SetupStage, usize, usize) + Sync),
) -> (Vec<PairDistance>, usize) {
    let pairs = model.checked_links().len();
    let total = config.pair_samples;
    let done = AtomicUsize::new(0);
    let of_chunk = |chunk: usize| {
        let mut random = random_stream(config.seed, chunk);
        let wanted = CHUNK.min(total - chunk * CHUNK);
        let mut known = vec![PairDistance::default(); pairs];
        let mut found = 0;
        for _ in 0..MAX_DRAWS * wanted {
            if found == wanted {
                break;
            }
            let q = hold_followers(robot, draw_posture(robot, &mut random), held);
            if is_within_limits(robot, &q) || !is_within_limits(robot, held) {
                model.add_posture(&q, &mut known);
                found += 1;
            }
        }
        let done = done.fetch_add(wanted, Ordering::Relaxed) + wanted;
        progress(SetupStage::Pairs, done, total);
        (known, found)
    };
    let chunks: Vec<_> = (0..total.div_ceil(CHUNK))
        .into_par_iter()
        .map(of_chunk)
        .collect();
    let mut all = vec![PairDistance::default(); pairs];
    let mut samples = 0;
    for (known, found) in chunks {
        samples += found;
        for (sum, own) in all.iter_mut().zip(known) {
            sum.merge(own);
        }
    }
    (all, samples)
}

/// Returns a posture with the variables of joints that would be outside their limits, because they follow others, at
/// the held posture.
fn hold_followers(robot: &RobotModel, mut q: Vec<f64>, held: &[f64]) -> Vec<f64> {
    let faults = robot.limit_faults(&q).unwrap_or_default();
    for fault in faults {
        let joints = robot.joints().iter();
        for joint in joints.filter(|joint| joint.name == fault.joint) {
            for &(variable, _) in &joint.drive.terms {
                q[variable] = held[variable];
            }
        }
    }
    q
}

/// Returns the least distance [m] of each pair, for pairs without overlap after a descent from their closest posture.
fn descend_all(
    robot: &RobotModel,
    model: &CollisionModel,
    distances: &[PairDistance],
    config: &SetupConfig,
    progress: &(impl Fn(SetupStage, usize, usize) + Sync),
) -> Vec<f64> {
    let links = model.checked_links();
    let done = AtomicUsize::new(0);
    let of_pair = |i: usize| {
        let known = &distances[i];
        let least = match known.overlaps {
            0 if !known.nearest.is_empty() => {
                let mut random = random_stream(config.seed.wrapping_add(1), i);
                let moving = variables_between(robot, links[i]);
                descend(
                    robot,
                    model,
                    i,
                    &moving,
                    known,
                    config.never_margin,
                    &mut random,
                )
            }
            _ => known.least,
        };
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        progress(SetupStage::NearestPostures, done, links.len());
        least
    };
    (0..links.len()).into_par_iter().map(of_pair).collect()
}

/// Descends by random steps of shrinking size until a pair is within `margin` [m]; returns its least distance [m].
fn descend(
    robot: &RobotModel,
    model: &CollisionModel,
    pair: usize,
    moving: &[usize],
    known: &PairDistance,
    margin: f64,
    random: &mut ChaCha8Rng,
) -> f64 {
    let (mut least, mut q) = (known.least, known.nearest.clone());
    for step in 0..DESCENT_STEPS {
        if least <= margin {
            break;
        }
        let size = FIRST_STEP * STEP_FACTOR.powi(step);
        let mut next = q.clone();
        for &variable in moving {
            let (lower, upper) = range_of(robot, variable);
            let change = size * (upper - lower) * (2.0 * random.random::<f64>() - 1.0);
            next[variable] = (next[variable] + change).clamp(lower, upper);
        }
        if !is_within_limits(robot, &next) {
            continue;
        }
        let distance = model.pair_distance(pair, &next, least);
        if distance < least {
            (least, q) = (distance, next);
        }
    }
    least
}
