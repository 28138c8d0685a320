//! Evaluations over many simulated worlds: what the method believes against what is so.
//!
//! A world is drawn by a seed ([`WorldCase`]): which task, how the world differs from what the robot believes of it, and
//! what disturbs it. [`WorldCase::evaluate`] lets the method wipe in it, asks three simpler ways to believe on the very
//! same rounds, and holds each against what is so. [`Calibration`] sums up many worlds. [`ScenarioRun`] is a shipped scenario
//! in its own world, with a seed. Which seeds serve what is fixed:
//! [`SeedUse`].

mod baselines;
mod interval;
mod protocol;
mod pushes;
mod scenario;
mod scores;
mod trial;
mod variants;
mod world;

pub use baselines::Baselines;
pub use interval::binomial_interval;
pub use protocol::{ProtocolError, SeedUse};
pub use pushes::PushCounts;
pub use scenario::{Quartiles, ScenarioRound, ScenarioRun, ScenarioScores};
pub use scores::{Calibration, ClaimCounts, GroupScores, LevelCoverage, MethodScores};
pub use trial::{BeliefScore, EvaluationError, LEVELS, RoundScore, WorldScore};
pub use variants::Variant;
pub use world::{Disturbance, Mismatch, Senses, TaskCase, WorldCase};
