//! Quantities of a wiping run, and their statistics over seeds.

use crate::scenario::Quartiles;
use crate::wiping::{ExecutionScore, MotionScore, WipingScore};
use serde::Serialize;
use std::collections::BTreeMap;

/// A quantity of a run. Its name ends in its unit; quantities without a unit are counts or shares \[1\].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// [`WipingScore::planned`].
    Planned,
    /// The field `predicted` of [`WipingScore`].
    Predicted,
    /// [`WipingScore::limited`].
    Limited,
    /// [`ExecutionScore::estimated`].
    Estimated,
    /// [`ExecutionScore::first`].
    TruthRound1,
    /// [`ExecutionScore::truth`].
    Truth,
    /// [`WipingScore::predicted_loss`].
    PredictedLoss,
    /// [`ExecutionScore::loss`].
    TrueLoss,
    /// [`WipingScore::out_of_reach`].
    OutOfReach,
    /// [`WipingScore::distance_m`].
    DistanceM,
    /// [`WipingScore::lifts`].
    Lifts,
    /// [`WipingScore::nodes`].
    Nodes,
    /// [`MotionScore::abandoned`].
    Abandoned,
    /// [`MotionScore::placements`].
    Placements,
    /// [`MotionScore::faults`].
    Faults,
    /// [`ExecutionScore::rounds`].
    Rounds,
    /// [`WipingScore::execution_s`].
    ExecutionS,
    /// [`MotionScore::contact_s`].
    ContactS,
    /// [`WipingScore::computation_s`]: the only quantity that depends on the machine.
    ComputationS,
}

impl Quantity {
    /// All quantities, in the order of tables.
    pub const ALL: [Self; 19] = [
        Self::Planned,
        Self::Predicted,
        Self::Limited,
        Self::Estimated,
        Self::TruthRound1,
        Self::Truth,
        Self::PredictedLoss,
        Self::TrueLoss,
        Self::OutOfReach,
        Self::DistanceM,
        Self::Lifts,
        Self::Nodes,
        Self::Abandoned,
        Self::Placements,
        Self::Faults,
        Self::Rounds,
        Self::ExecutionS,
        Self::ContactS,
        Self::ComputationS,
    ];

    /// Name of the quantity in files, with its unit.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Planned => "planned",
            Self::Predicted => "predicted",
            Self::Limited => "limited",
            Self::Estimated => "estimated",
            Self::TruthRound1 => "truth_round1",
            Self::Truth => "truth",
            Self::PredictedLoss => "predicted_loss",
            Self::TrueLoss => "true_loss",
            Self::OutOfReach => "out_of_reach",
            Self::DistanceM => "distance_m",
            Self::Lifts => "lifts",
            Self::Nodes => "nodes",
            Self::Abandoned => "abandoned",
            Self::Placements => "placements",
            Self::Faults => "faults",
            Self::Rounds => "rounds",
            Self::ExecutionS => "execution_s",
            Self::ContactS => "contact_s",
            Self::ComputationS => "computation_s",
        }
    }

    /// Returns the value of the quantity in a run; `None` if the run has no such value, because it was not followed or executed.
    pub fn value(self, score: &WipingScore) -> Option<f64> {
        let motion = |of: fn(&MotionScore) -> f64| score.motion.as_ref().map(of);
        let executed = |of: fn(&ExecutionScore) -> f64| score.execution.as_ref().map(of);
        match self {
            Self::Planned => Some(score.planned),
            Self::Predicted => Some(score.predicted),
            Self::Limited => score.limited,
            Self::Estimated => executed(|execution| execution.estimated),
            Self::TruthRound1 => executed(|execution| execution.first),
            Self::Truth => executed(|execution| execution.truth),
            Self::PredictedLoss => Some(score.predicted_loss),
            Self::TrueLoss => executed(|execution| execution.loss),
            Self::OutOfReach => Some(score.out_of_reach),
            Self::DistanceM => Some(score.distance_m),
            Self::Lifts => Some(score.lifts as f64),
            Self::Nodes => Some(score.nodes as f64),
            Self::Abandoned => motion(|motion| motion.abandoned as f64),
            Self::Placements => motion(|motion| motion.placements as f64),
            Self::Faults => motion(|motion| motion.faults as f64),
            Self::Rounds => executed(|execution| execution.rounds as f64),
            Self::ExecutionS => score.execution_s(),
            Self::ContactS => motion(|motion| motion.contact_s),
            Self::ComputationS => Some(score.computation_s),
        }
    }
}

/// Statistics of a quantity over several runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Statistics {
    /// Arithmetic mean.
    pub mean: f64,
    /// Minimum, quartiles and maximum.
    pub quartiles: Quartiles,
}

/// Statistics of each quantity that at least one run has.
pub type QuantitySummary = BTreeMap<Quantity, Statistics>;

/// Returns the statistics of each quantity over several runs.
pub fn summarise_quantities<'a>(
    scores: impl IntoIterator<Item = &'a WipingScore> + Clone,
) -> QuantitySummary {
    let of = |quantity: Quantity| {
        let values: Vec<f64> = (scores.clone().into_iter())
            .filter_map(|score| quantity.value(score))
            .collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let quartiles = Quartiles::from_values(values)?;
        Some((quantity, Statistics { mean, quartiles }))
    };
    Quantity::ALL.into_iter().filter_map(of).collect()
}
