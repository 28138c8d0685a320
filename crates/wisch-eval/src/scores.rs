//! Many worlds summed up.

use crate::interval::binomial_interval;
use crate::pushes::PushCounts;
use crate::trial::{BeliefScore, LEVELS, RoundScore, WorldScore};
use crate::variants::Variant;
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::recover::FALSE_BY;

/// What many worlds say of the method and of simpler ways to believe.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Calibration {
    /// How many worlds.
    pub worlds: usize,
    /// How many rounds in them.
    pub rounds: usize,
    /// Over all rounds: the method, then the baselines.
    pub methods: Vec<MethodScores>,
    /// Over the rounds of worlds of one kind each.
    pub groups: Vec<GroupScores>,
    /// Over the worlds.
    pub claims: ClaimCounts,
    /// Over all rounds.
    pub pushes: PushCounts,
}

/// How one way to believe did.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodScores {
    /// What it is.
    pub name: String,
    /// Mean continuous ranked probability score; of a single number, its error.
    pub crps: f64,
    /// Mean of |expected - so|.
    pub error: f64,
    /// Mean of expected - so.
    pub bias: f64,
    /// Of each of [`LEVELS`]; none of a single number.
    pub coverage: Vec<LevelCoverage>,
}

/// How often the interval of a level held what was so.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelCoverage {
    /// The level [1].
    pub level: f64,
    /// Share of the rounds [1].
    pub share: f64,
    /// Its 95 % interval (Clopper and Pearson).
    pub bounds: [f64; 2],
    /// Mean width of the interval [1].
    pub width: f64,
}

/// The method in worlds of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupScores {
    /// What they have in common.
    pub kind: &'static str,
    /// Which of these.
    pub name: String,
    /// Worlds.
    pub worlds: usize,
    /// Rounds.
    pub rounds: usize,
    /// The method.
    pub method: MethodScores,
    /// The paper's rule, its mean error.
    pub paper_error: f64,
    /// Share of the worlds that end at 90 % or more [1].
    pub ended_at_90: f64,
    /// Claims.
    pub claims: ClaimCounts,
}

/// Goals claimed and met at the end of worlds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct ClaimCounts {
    /// Worlds in which the goal was claimed.
    pub claimed: usize,
    /// Worlds in which it was met.
    pub met: usize,
    /// Claimed and met.
    pub claimed_and_met: usize,
    /// Claimed, and farther than 10 points below the target.
    pub false_claims: usize,
    /// Worlds that ended with "unknowable by touch".
    pub unknowable: usize,
}

impl ClaimCounts {
    fn of<'a>(worlds: impl Iterator<Item = &'a WorldScore>) -> Self {
        let mut counts = Self::default();
        for world in worlds {
            let Some(last) = world.rounds.last() else {
                continue;
            };
            let is_met = last.outcome >= world.target;
            counts.claimed += usize::from(last.is_claimed);
            counts.met += usize::from(is_met);
            counts.claimed_and_met += usize::from(is_met && last.is_claimed);
            let is_false = last.is_claimed && last.outcome < world.target - FALSE_BY;
            counts.false_claims += usize::from(is_false);
            counts.unknowable += usize::from(last.verdict == "unknowable by touch");
        }
        counts
    }
}

impl MethodScores {
    fn of_beliefs<'a>(
        name: &str,
        rounds: impl Iterator<Item = (&'a BeliefScore, f64)> + Clone,
    ) -> Self {
        let count = rounds.clone().count();
        let n = count.max(1) as f64;
        let mean = |of: &dyn Fn(&BeliefScore, f64) -> f64| {
            rounds
                .clone()
                .map(|(belief, outcome)| of(belief, outcome))
                .sum::<f64>()
                / n
        };
        let coverage = LEVELS.into_iter().enumerate().map(|(i, level)| {
            let held = rounds
                .clone()
                .filter(|(belief, outcome)| belief.holds(i, *outcome))
                .count();
            LevelCoverage {
                level,
                share: held as f64 / n,
                bounds: binomial_interval(held, count),
                width: mean(&|belief, _| belief.intervals[i][1] - belief.intervals[i][0]),
            }
        });
        Self {
            name: name.to_owned(),
            crps: mean(&|belief, _| belief.crps),
            error: mean(&|belief, outcome| (belief.mean - outcome).abs()),
            bias: mean(&|belief, outcome| belief.mean - outcome),
            coverage: coverage.collect(),
        }
    }

    fn of_numbers(name: &str, rounds: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        let n = rounds.clone().count().max(1) as f64;
        let error = rounds
            .clone()
            .map(|(said, so)| (said - so).abs())
            .sum::<f64>()
            / n;
        Self {
            name: name.to_owned(),
            crps: error,
            error,
            bias: rounds.map(|(said, so)| said - so).sum::<f64>() / n,
            coverage: Vec::new(),
        }
    }
}

impl Calibration {
    /// Sums up worlds, in whatever order, with these variants.
    pub fn of(worlds: &[WorldScore], variants: &[Variant]) -> Self {
        let rounds: Vec<&RoundScore> = worlds.iter().flat_map(|world| &world.rounds).collect();
        let each = || rounds.iter().copied();
        let mut methods = vec![
            method(&rounds),
            MethodScores::of_numbers("prediction", each().map(|r| (r.prediction, r.outcome))),
            MethodScores::of_beliefs(
                "force-blind replay",
                each().map(|r| (&r.force_blind, r.outcome)),
            ),
            MethodScores::of_numbers("the paper's rule", each().map(|r| (r.paper, r.outcome))),
        ];
        for (index, variant) in variants.iter().enumerate() {
            let all = each().filter_map(|r| Some((r.variants.get(index)?, r.outcome)));
            methods.push(MethodScores::of_beliefs(&variant.name, all));
        }
        let mut groups: BTreeMap<(usize, String), (&'static str, Vec<&WorldScore>)> =
            BTreeMap::new();
        for world in worlds {
            let case = &world.case;
            let names = [
                ("mismatch", case.mismatch.as_str().to_owned()),
                ("disturbance", case.disturbance.as_str().to_owned()),
                ("task", case.task.name()),
            ];
            for (order, (kind, name)) in names.into_iter().enumerate() {
                let group = groups.entry((order, name)).or_insert((kind, Vec::new()));
                group.1.push(world);
            }
        }
        let groups = groups.into_iter().map(|((_, name), (kind, worlds))| {
            let rounds: Vec<&RoundScore> = worlds.iter().flat_map(|world| &world.rounds).collect();
            let errors = rounds
                .iter()
                .map(|round| (round.paper - round.outcome).abs());
            let last = worlds.iter().filter_map(|world| world.rounds.last());
            let well = last.filter(|round| round.outcome >= 0.9).count();
            GroupScores {
                kind,
                name,
                worlds: worlds.len(),
                rounds: rounds.len(),
                method: method(&rounds),
                paper_error: errors.sum::<f64>() / rounds.len().max(1) as f64,
                ended_at_90: well as f64 / worlds.len() as f64,
                claims: ClaimCounts::of(worlds.into_iter()),
            }
        });
        Self {
            worlds: worlds.len(),
            rounds: rounds.len(),
            methods,
            groups: groups.collect(),
            claims: ClaimCounts::of(worlds.iter()),
            pushes: rounds.iter().map(|round| round.pushes).sum(),
        }
    }
}

fn method(rounds: &[&RoundScore]) -> MethodScores {
    MethodScores::of_beliefs(
        "wisch",
        rounds.iter().map(|round| (&round.belief, round.outcome)),
    )
}
