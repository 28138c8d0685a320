//! What `--json` prints, and what a killed run goes on with. SI units, radians; keys end in their unit.

mod past;
mod rounds;
mod summary;

pub use past::{PAST_SCHEMA, PastRecord};
pub use rounds::{LoopSummary, RoundSummary, RoundTimes};
pub use summary::{FollowingSummary, PredictionSummary, SUMMARY_SCHEMA, Summary};
