//! What `--json` prints, and what a killed run goes on with. SI units, radians; keys end in their unit.

mod rounds;
mod summary;

pub use rounds::{LoopSummary, RoundSummary, RoundTimes};
pub use summary::{FollowingSummary, PredictionSummary, SUMMARY_SCHEMA, Summary};
