//! Settings of the planner.

use super::{CoverageStrategy, HeadingRule, Strategy};

/// Planner settings. Tool, medium and action come from the task.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanConfig {
    /// How strokes are found.
    pub strategy: Strategy,
    /// Seed of the random tree, of the tour's kicks and of the search for strokes.
    pub seed: u64,
    /// Bandwidth of the density estimate [m]; `None` takes it from the data.
    pub bandwidth: Option<f64>,
    /// How the tool is turned along the strokes of a coverage strategy.
    pub heading: HeadingRule,
    /// How high the tool is lifted between strokes [m].
    pub lift_height: f64,
    /// How far the tool may go in contact [m]; `None` as far as it takes.
    pub max_distance: Option<f64>,
    /// How long strokes are searched for.
    pub search: SearchConfig,
}

/// How strokes are searched for ([`Strategy::Adaptive`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchConfig {
    /// Plans that are tried: the same plan for the same number, however long that takes.
    pub evaluations: usize,
    /// By how much the tool may be off its way to either side, and still do what the plan says [m]. What only the tool exactly on
    /// its way reaches counts half.
    pub margin_m: f64,
}

impl Default for PlanConfig {
    /// By a grid, lifted by 5 cm, as far as it takes.
    fn default() -> Self {
        Self {
            strategy: CoverageStrategy::Grid.into(),
            seed: 0,
            bandwidth: None,
            heading: HeadingRule::default(),
            lift_height: 0.05,
            max_distance: None,
            search: SearchConfig::default(),
        }
    }
}

impl Default for SearchConfig {
    /// As many as take about a second for 80 particles on a board, and the tracking error of a compliant arm.
    fn default() -> Self {
        Self {
            evaluations: 60_000,
            margin_m: 0.003,
        }
    }
}
