//! Settings of the planner.

use super::{CoverageStrategy, Strategy, YawRule};

/// Planner settings. Tool, medium and action come from the task.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanConfig {
    /// How the planner finds strokes.
    pub strategy: Strategy,
    /// Seed of the random tree, of the tour's kicks and of the search for strokes.
    pub seed: u64,
    /// Bandwidth of the density estimate \[m\]; `None` takes it from the data.
    pub bandwidth: Option<f64>,
    /// How the planner turns the tool along the strokes of a coverage strategy.
    pub yaw: YawRule,
    /// Height by which the tool is lifted between strokes \[m\].
    pub lift_height: f64,
    /// Longest distance of the tool in contact \[m\]; `None` sets no limit.
    pub max_distance: Option<f64>,
    /// Effort of the search for strokes.
    pub search: SearchConfig,
}

/// Effort of the search for strokes ([`Strategy::Adaptive`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchConfig {
    /// Number of plans that the search evaluates. The same number gives the same plan, however long the search takes.
    pub evaluations: usize,
    /// Lateral error of the tool that the plan has to tolerate, to either side \[m\]. Dirt that only an exact
    /// tool reaches counts half.
    pub margin_m: f64,
}

impl Default for PlanConfig {
    /// The grid strategy, lifts of 5 cm, and no limit of the distance.
    fn default() -> Self {
        Self {
            strategy: CoverageStrategy::Grid.into(),
            seed: 0,
            bandwidth: None,
            yaw: YawRule::default(),
            lift_height: 0.05,
            max_distance: None,
            search: SearchConfig::default(),
        }
    }
}

impl Default for SearchConfig {
    /// Evaluations that take about a second for 80 particles on a board, and the tracking error of a compliant
    /// arm.
    fn default() -> Self {
        Self {
            evaluations: 60_000,
            margin_m: 0.003,
        }
    }
}
