//! Evaluations over many simulated worlds: what the method believes against what is so.
//!
//! A world is drawn by a seed ([`WorldCase`]): which task, how the world differs from what the robot believes of it, and
//! what disturbs it. [`WorldCase::evaluate`] lets the method wipe in it, asks three simpler ways to believe on the very
//! same rounds, and holds each against what is so. [`Calibration`] sums up many worlds. [`ScenarioRun`] is a shipped scenario
//! in its own world, with a seed. [`WipingScore`] is a task that is planned, followed or executed once: the paper's
//! Table 1 ([`Table1Case`]) is made of such runs, and so are sweeps over any keys of a task ([`Axis`]). What seeds
//! are for: [`SeedUse`].

mod baselines;
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
pub use interval::binomial_interval;
pub use picture::Picture;
pub use protocol::SeedUse;
pub use pushes::PushCounts;
pub use quantity::{Quantity, QuantitySummary, Statistics, summary};
pub use scenario::{Quartiles, ScenarioRound, ScenarioRun, ScenarioScores};
pub use scores::{Calibration, ClaimCounts, GroupScores, LevelCoverage, MethodScores};
pub use sweep::{Axis, AxisError, SweepCase, SweepCell, SweepRun, SweepSetup, cells, sweep_cells};
pub use table1::{PaperFigures, Table1Case, Table1Row, Table1Run, Table1Setup, table1_rows};
pub use task_case::{TaskCase, UnknownCell};
pub use trial::{BeliefScore, EvaluationError, LEVELS, RoundScore, WorldScore};
pub use variants::Variant;
pub use wiping::{ExecutionScore, MotionScore, WipingExtent, WipingOptions, WipingScore};
pub use world::{Disturbance, MismatchKind, Senses, WorldCase};
