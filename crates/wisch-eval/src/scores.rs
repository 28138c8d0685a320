//! Statistics over many worlds.

use crate::interval::binomial_interval;
use crate::pushes::PushCounts;
use crate::trial::{BeliefScore, LEVELS, RoundScore, WorldScore};
use crate::variants::Variant;
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::recover::{FALSE_CLAIM_MARGIN, Verdict};

/// The calibration of the method and of simpler estimators over many worlds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Calibration {
    /// Number of worlds.
    pub worlds: usize,
    /// Number of rounds in all worlds.
    pub rounds: usize,
    /// Scores over all rounds: the method first, then the baselines.
    pub methods: Vec<MethodScores>,
    /// Scores over the rounds of each group of worlds.
    pub groups: Vec<GroupScores>,
    /// Claimed and met goals over all worlds.
    pub claims: ClaimCounts,
    /// Detection of pushes over all rounds.
    pub pushes: PushCounts,
}

/// The scores of one estimator over many worlds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodScores {
    /// Name of the estimator.
    pub name: String,
    /// Mean continuous ranked probability score; for a single number, the mean absolute error.
    pub crps: f64,
    /// Mean of |expected - true|.
    pub error: f64,
    /// Mean of expected - true.
    pub bias: f64,
    /// Coverage of each of [`LEVELS`]; empty for a single number.
    pub coverage: Vec<LevelCoverage>,
}

/// Coverage of the intervals of one level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelCoverage {
    /// Level \[1\].
    pub level: f64,
    /// Share of the rounds whose interval contains the true performance \[1\].
    pub share: f64,
    /// 95 % confidence interval of that share (Clopper and Pearson).
    pub bounds: [f64; 2],
    /// Mean width of the interval \[1\].
    pub width: f64,
}

/// Scores of the method in a group of worlds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupScores {
    /// Property that defines the group.
    pub kind: &'static str,
    /// Value of that property.
    pub name: String,
    /// Number of worlds.
    pub worlds: usize,
    /// Number of rounds.
    pub rounds: usize,
    /// Scores of the method.
    pub method: MethodScores,
    /// Mean continuous ranked probability score of the force-blind replay.
    pub force_blind_crps: f64,
    /// Mean absolute error of the paper's rule.
    pub paper_error: f64,
    /// Share of the worlds with a true performance of at least 90 % at the end \[1\].
    pub ended_at_90: f64,
    /// Claimed and met goals.
    pub claims: ClaimCounts,
}

/// Goals claimed and met at the end of worlds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct ClaimCounts {
    /// Worlds in which the goal was claimed.
    pub claimed: usize,
    /// Worlds in which the goal was met.
    pub met: usize,
    /// Worlds in which the goal was claimed and met.
    pub claimed_and_met: usize,
    /// Worlds in which the goal was claimed more than 10 percentage points below the target.
    pub false_claims: usize,
    /// Worlds that ended with the verdict "undecided by touch".
    pub undecided_by_touch: usize,
}

/// Whether a verdict states that touch cannot decide. Version 0.2.0 wrote "unknowable by touch".
fn is_undecided(verdict: &str) -> bool {
    verdict == Verdict::UnknowableByTouch.as_str() || verdict == "unknowable by touch"
}

impl ClaimCounts {
    fn count<'a>(worlds: impl Iterator<Item = &'a WorldScore>) -> Self {
        let mut counts = Self::default();
        for world in worlds {
            let Some(last) = world.rounds.last() else {
                continue;
            };
            let is_met = last.outcome >= world.target;
            counts.claimed += usize::from(last.is_claimed);
            counts.met += usize::from(is_met);
            counts.claimed_and_met += usize::from(is_met && last.is_claimed);
            let is_false = last.is_claimed && last.outcome < world.target - FALSE_CLAIM_MARGIN;
            counts.false_claims += usize::from(is_false);
            counts.undecided_by_touch += usize::from(is_undecided(&last.verdict));
        }
        counts
    }
}

impl MethodScores {
    fn from_beliefs<'a>(
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

    fn from_numbers(name: &str, rounds: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
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
    /// Summarises worlds, in any order, with the given variants.
    pub fn summarise(worlds: &[WorldScore], variants: &[Variant]) -> Self {
        let rounds: Vec<&RoundScore> = worlds.iter().flat_map(|world| &world.rounds).collect();
        let each = || rounds.iter().copied();
        let mut methods = vec![
            score_method(&rounds),
            MethodScores::from_numbers("prediction", each().map(|r| (r.prediction, r.outcome))),
            MethodScores::from_beliefs(
                "force-blind replay",
                each().map(|r| (&r.force_blind, r.outcome)),
            ),
            MethodScores::from_numbers("the paper's rule", each().map(|r| (r.paper, r.outcome))),
        ];
        for (index, variant) in variants.iter().enumerate() {
            let all = each().filter_map(|r| Some((r.variants.get(index)?, r.outcome)));
            methods.push(MethodScores::from_beliefs(&variant.name, all));
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
            let blind = rounds.iter().map(|round| round.force_blind.crps);
            let last = worlds.iter().filter_map(|world| world.rounds.last());
            let well = last.filter(|round| round.outcome >= 0.9).count();
            GroupScores {
                kind,
                name,
                worlds: worlds.len(),
                rounds: rounds.len(),
                method: score_method(&rounds),
                force_blind_crps: blind.sum::<f64>() / rounds.len().max(1) as f64,
                paper_error: errors.sum::<f64>() / rounds.len().max(1) as f64,
                ended_at_90: well as f64 / worlds.len() as f64,
                claims: ClaimCounts::count(worlds.into_iter()),
            }
        });
        Self {
            worlds: worlds.len(),
            rounds: rounds.len(),
            methods,
            groups: groups.collect(),
            claims: ClaimCounts::count(worlds.iter()),
            pushes: rounds.iter().map(|round| round.pushes).sum(),
        }
    }
}

fn score_method(rounds: &[&RoundScore]) -> MethodScores {
    MethodScores::from_beliefs(
        "wisch",
        rounds.iter().map(|round| (&round.belief, round.outcome)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undecided_worlds_of_an_earlier_version_count() {
        let verdicts = ["undecided by touch", "unknowable by touch", "goal met"];
        assert_eq!(verdicts.map(is_undecided), [true, true, false]);
    }
}
