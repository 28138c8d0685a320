//! Evaluations in many simulated worlds, which compare estimates with ground truth.
//!
//! A seed determines a world ([`WorldCase`]): its task, how it differs from the robot's belief, and its disturbances.
//! [`WorldCase::evaluate`] runs the method in the world, and compares the method's estimates and those of three simpler
//! estimators on the same rounds with ground truth. [`Calibration`] summarises many worlds. [`ScenarioRun`] is one run of a
//! shipped scenario in its own world, and [`GoalRunScore`] one run of a goal of several parts. [`WipingScore`] scores a task
//! that is planned, followed or executed once; the paper's Table 1 ([`Table1Case`]) and sweeps over keys of a task ([`Axis`])
//! consist of these scores. [`SeedUse`] defines the ranges of seeds. An [`EvidenceFile`] keeps published figures with command,
//! seeds, code and machine, so that they can be measured again.

mod baselines;
mod evidence;
mod figures;
mod goal_run;
mod interval;
mod picture;
mod protocol;
mod pushes;
mod quantity;
mod scenario;
mod scores;
mod simulated;
mod sweep;
mod table1;
mod task_case;
mod trial;
mod variants;
mod wiping;
mod world;

pub use baselines::Baselines;
pub use evidence::{
    EvidenceError, EvidenceFile, PLANNING_CODE, PublishedFigure, PublishedInterval,
    PublishedTarget, SIMULATION_CODE,
};
pub use figures::{
    calibration_figures, goal_figures, scenario_figures, sweep_figures, table1_figures,
};
pub use goal_run::{GoalPartScore, GoalPartScores, GoalRunScore, GoalScores};
pub use interval::binomial_interval;
pub use picture::Picture;
pub use protocol::SeedUse;
pub use pushes::PushCounts;
pub use quantity::{Quantity, QuantitySummary, Statistics, summarise_quantities};
pub use scenario::{Quartiles, ScenarioRound, ScenarioRun, ScenarioScores};
pub use scores::{Calibration, ClaimCounts, GroupScores, LevelCoverage, MethodScores};
pub use sweep::{
    Axis, AxisError, SweepCase, SweepCell, SweepRun, SweepSetup, group_sweep_runs,
    list_combinations,
};
pub use table1::{PaperFigures, Table1Case, Table1Row, Table1Run, Table1Setup, build_table1_rows};
pub use task_case::{TaskCase, UnknownCell};
pub use trial::{BeliefScore, EvaluationError, LEVELS, RoundScore, WorldScore};
pub use variants::Variant;
pub use wiping::{ExecutionScore, MotionScore, WipingExtent, WipingOptions, WipingScore};
pub use world::{Disturbance, MismatchKind, Senses, WorldCase};
