//! The paper's Table 1 (§3.4): three surfaces, three actions, and the strategies.

use crate::quantity::{Quantity, QuantitySummary, summarise_quantities};
use crate::task_case::TaskCase;
use crate::wiping::{WipingExtent, WipingOptions, WipingScore};
use serde::{Deserialize, Serialize};
use std::path::Path;
use wisch::plan::{CoverageStrategy, Strategy};
use wisch_io::LoadOptions;

/// Tolerance for means that differ only by rounding [%].
const ROUNDING: f64 = 1e-9;

/// The paper's figures of a cell and strategy: means of five trials.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PaperFigures {
    /// Path length in contact \[m\].
    pub distance_m: f64,
    /// Computation time \[s\], in 2019.
    pub computation_s: f64,
    /// Execution time \[s\].
    pub execution_s: f64,
    /// Performance [%].
    pub performance_percent: f64,
}

/// Table 1: action × surface × strategy.
const PAPER: [[[PaperFigures; 3]; 3]; 3] = {
    const fn of(
        distance_m: f64,
        computation_s: f64,
        execution_s: f64,
        performance_percent: f64,
    ) -> PaperFigures {
        PaperFigures {
            distance_m,
            computation_s,
            execution_s,
            performance_percent,
        }
    }
    [
        [
            [
                of(1.52, 45.96, 18.01, 84.25),
                of(1.41, 57.12, 25.92, 85.00),
                of(1.90, 62.00, 27.71, 95.75),
            ],
            [
                of(4.34, 144.47, 41.30, 77.00),
                of(4.10, 312.45, 66.96, 79.50),
                of(3.24, 169.92, 52.45, 70.50),
            ],
            [
                of(4.44, 314.04, 77.59, 90.13),
                of(4.84, 423.21, 111.90, 90.50),
                of(4.69, 417.66, 66.11, 91.00),
            ],
        ],
        [
            [
                of(1.54, 69.89, 16.17, 86.50),
                of(1.45, 68.48, 32.42, 86.75),
                of(1.90, 72.24, 43.28, 90.50),
            ],
            [
                of(3.68, 110.92, 65.71, 70.25),
                of(3.60, 161.60, 83.36, 69.25),
                of(2.92, 270.56, 62.14, 41.75),
            ],
            [
                of(4.97, 885.45, 112.47, 48.50),
                of(4.76, 262.55, 116.26, 39.25),
                of(4.22, 428.05, 97.56, 62.75),
            ],
        ],
        [
            [
                of(1.81, 107.17, 32.11, 88.00),
                of(1.62, 44.25, 26.51, 80.25),
                of(2.01, 90.57, 45.81, 97.00),
            ],
            [
                of(5.48, 211.14, 113.37, 71.75),
                of(4.95, 200.34, 122.75, 65.50),
                of(3.75, 275.58, 102.48, 53.00),
            ],
            [
                of(5.58, 325.97, 108.18, 94.50),
                of(5.65, 212.34, 103.29, 88.50),
                of(5.89, 199.03, 96.03, 88.50),
            ],
        ],
    ]
};

impl PaperFigures {
    /// Returns the figures of a cell for a strategy of the paper; `None` for another strategy.
    pub fn find(task: TaskCase, strategy: Strategy) -> Option<Self> {
        let mut all = CoverageStrategy::ALL.into_iter();
        let column = all.position(|covering| Strategy::from(covering) == strategy)?;
        Some(PAPER[task.action_index()][task.place_index()][column])
    }

    /// Returns the best of the paper's three strategies in each figure, for the comparison of other strategies.
    pub fn find_best(task: TaskCase) -> Self {
        let [first, rest @ ..] = PAPER[task.action_index()][task.place_index()];
        rest.into_iter().fold(first, |best, other| Self {
            distance_m: best.distance_m.min(other.distance_m),
            computation_s: best.computation_s.min(other.computation_s),
            execution_s: best.execution_s.min(other.execution_s),
            performance_percent: best.performance_percent.max(other.performance_percent),
        })
    }
}

/// A case of the table: cell, strategy and seed.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Table1Case {
    /// The cell.
    pub task: TaskCase,
    /// Name of the strategy.
    pub strategy: String,
    /// The seed.
    pub seed: u64,
}

/// The common setup of a table's runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table1Setup {
    /// Last stage of each run.
    pub extent: WipingExtent,
    /// Whether to evaluate also a plan at most as long as the shortest path of the paper's three strategies.
    pub is_limited: bool,
    /// Overrides of every task: keys and values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub settings: Vec<(String, String)>,
    /// Seed whose runs have pictures.
    pub pictured_seed: u64,
}

/// A run of Table 1 with its score.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table1Run {
    /// The case.
    pub case: Table1Case,
    /// The common setup.
    pub setup: Table1Setup,
    /// The score.
    pub score: WipingScore,
}

impl Table1Case {
    /// Returns the options to load the task.
    pub fn load_options(&self, setup: &Table1Setup) -> Result<LoadOptions, String> {
        let strategy: Strategy = self.strategy.parse().map_err(|e| format!("{e}"))?;
        Ok(LoadOptions {
            settings: setup.settings.clone(),
            action: Some(self.task.action()),
            strategy: Some(strategy),
            seed: Some(self.seed),
            ..LoadOptions::default()
        })
    }

    /// Name of the case, such as `collect board by kde, seed 3`.
    pub fn name(&self) -> String {
        let (action, place) = (self.task.action(), self.task.place());
        format!("{action} {place} by {}, seed {}", self.strategy, self.seed)
    }

    /// Runs the task of the case once.
    ///
    /// # Errors
    /// A message if a stage fails.
    pub fn evaluate(&self, setup: &Table1Setup) -> Result<Table1Run, String> {
        let options = WipingOptions {
            extent: setup.extent,
            is_certain: true,
            limit: (setup.is_limited).then(|| PaperFigures::find_best(self.task).distance_m),
            is_pictured: self.seed == setup.pictured_seed,
        };
        let load = self.load_options(setup)?;
        Ok(Table1Run {
            case: self.clone(),
            setup: setup.clone(),
            score: WipingScore::evaluate(Path::new(self.task.scenario()), &load, options)?,
        })
    }
}

/// A row of the table: a cell and a strategy, over the seeds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table1Row {
    /// Action.
    pub action: &'static str,
    /// Surface: board, table or windshield.
    pub surface: &'static str,
    /// Strategy.
    pub strategy: String,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that claimed the goal; `None` without execution.
    pub claimed: Option<usize>,
    /// The paper's figures; for a strategy that the paper does not have, the best of its three.
    pub paper: PaperFigures,
    /// Whether the paper has the strategy.
    pub is_papers_own: bool,
    /// Whether the mean of the predicted performance reaches the paper's.
    pub is_reached: bool,
    /// Statistics of the runs.
    pub ours: QuantitySummary,
}

/// Makes the table of runs, given in any order; its rows are sorted by action, surface and strategy as in the paper.
pub fn build_table1_rows(runs: &[Table1Run]) -> Vec<Table1Row> {
    let cells = TaskCase::cases_by_action().flat_map(|task| {
        Strategy::ALL
            .into_iter()
            .map(move |strategy| (task, strategy))
    });
    let row = |(task, strategy): (TaskCase, Strategy)| {
        let is_of =
            |run: &&Table1Run| run.case.task == task && run.case.strategy == strategy.as_str();
        let own: Vec<&WipingScore> = runs.iter().filter(is_of).map(|run| &run.score).collect();
        let ours = summarise_quantities(own.iter().copied());
        let papers = PaperFigures::find(task, strategy);
        let paper = papers.unwrap_or_else(|| PaperFigures::find_best(task));
        let predicted = ours.get(&Quantity::Predicted)?.mean;
        Some(Table1Row {
            action: task.action().as_str(),
            surface: task.place(),
            strategy: strategy.to_string(),
            runs: own.len(),
            claimed: WipingScore::count_claimed(&own),
            paper,
            is_papers_own: papers.is_some(),
            is_reached: 100.0 * predicted >= paper.performance_percent - ROUNDING,
            ours,
        })
    };
    cells.filter_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(task: TaskCase, strategy: &str, seed: u64, predicted: f64) -> Table1Run {
        let score = WipingScore {
            strategy: strategy.to_owned(),
            nodes: 3,
            lifts: 1,
            distance_m: 1.0,
            out_of_reach: 0.0,
            planned: predicted,
            predicted,
            predicted_loss: 0.0,
            limited: None,
            motion: None,
            execution: None,
            computation_s: 0.1,
            picture: None,
        };
        let setup = Table1Setup {
            extent: WipingExtent::Planned,
            is_limited: false,
            settings: Vec::new(),
            pictured_seed: 1,
        };
        let strategy = strategy.to_owned();
        let case = Table1Case {
            task,
            strategy,
            seed,
        };
        Table1Run { case, setup, score }
    }

    #[test]
    fn the_papers_figures_stand_where_its_table_has_them() {
        let named = |text: &str| TaskCase::parse(text).expect("a cell")[0];
        let of =
            |text: &str, strategy| PaperFigures::find(named(text), strategy).expect("the paper's");
        let kde = of("collect/windshield", CoverageStrategy::Kde.into());
        assert_eq!(
            (
                kde.distance_m,
                kde.computation_s,
                kde.execution_s,
                kde.performance_percent
            ),
            (4.22, 428.05, 97.56, 62.75)
        );
        let grid = of("skim/table", CoverageStrategy::Grid.into());
        assert_eq!((grid.distance_m, grid.performance_percent), (5.48, 71.75));
        assert_eq!(
            PaperFigures::find(named("skim/table"), Strategy::Adaptive),
            None
        );
        let best = PaperFigures::find_best(named("skim/table"));
        assert_eq!((best.distance_m, best.performance_percent), (3.75, 71.75));
    }

    #[test]
    fn rows_are_means_in_the_papers_order() {
        let named = |text: &str| TaskCase::parse(text).expect("a cell")[0];
        let (first, last) = (named("absorb/board"), named("skim/windshield"));
        let runs = [
            run(last, "kde", 1, 0.9),
            run(first, "adaptive", 1, 0.9),
            run(first, "grid", 2, 0.925),
            run(first, "grid", 1, 0.76),
        ];
        let rows = build_table1_rows(&runs);
        let names: Vec<_> = rows
            .iter()
            .map(|row| (row.action, row.surface, &*row.strategy, row.runs))
            .collect();
        let expected = [
            ("absorb", "board", "grid", 2),
            ("absorb", "board", "adaptive", 1),
            ("skim", "windshield", "kde", 1),
        ];
        assert_eq!(names, expected);
        // The mean of the two is the paper's 84.25 %; a strategy that the paper does not have is compared with its best,
        // 95.75 %.
        let reached: Vec<bool> = rows.iter().map(|row| row.is_reached).collect();
        assert_eq!(reached, [true, false, true]);
        assert_eq!(rows[1].paper.performance_percent, 95.75);
    }
}
