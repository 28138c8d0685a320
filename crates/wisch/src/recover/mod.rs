//! Recovery: from an interpretation to the next task or the end of a session; paper §4.3.

mod next_task;
mod verdict;

pub use next_task::{
    PLANNING_DRAWS, believed_performance, is_done, next_task, recovery_candidates, relocalized,
    unfinished,
};
pub use verdict::{
    Claim, FALSE_BY, FALSE_CLAIMS, LEAST_PROGRESS, Pace, RoundJudge, RoundOutcome, Verdict,
    is_claimable, judge_log,
};
