//! Goals of several parts: a command wipes step by step, in the order of least expected time, and plans anew when a step
//! fails.

mod episode;
mod session;
mod summary;
mod task;

pub(super) use episode::{GoalEpisode, read_step_number};
pub(super) use session::GoalRun;
pub(super) use summary::{GoalPart, GoalSummary, TakenStep};
pub(super) use task::{GoalTask, KeptPlan, read_goal};
