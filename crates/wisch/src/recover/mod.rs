//! Recovery: from an interpretation to the next task or the end of a session; paper §4.3.

mod next_task;
mod verdict;

pub use next_task::{
    PLANNING_DRAWS, expected_performance, is_done, next_task, recovery_candidate_count, relocate,
    remaining_dirt,
};
pub use verdict::{
    Claim, FALSE_CLAIM_MARGIN, MAX_FALSE_CLAIM_PROBABILITY, MIN_PROGRESS, Pace, RoundOutcome,
    TerminationPolicy, Verdict, assess_goal, assess_log, exceeds_max_passes, find_excess_passes,
    is_claimable, limit_verdict, may_be_undone, may_exceed_max_passes,
};
