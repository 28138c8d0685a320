//! Whether robots, tools and surfaces change over the episodes of a memory: drifts, sudden changes,
//! and forecasts of when a limit is reached.
//!
//! [`gather_groups`] collects the first rounds of the same robot, tool, surface, dirt, press force and kind of run.
//! [`assess_groups`] assesses each channel of each group.
//!
//! - **Sudden change**: two lines fit a part of the series much better than one. Its probability is the larger one of the
//!   F-test and of the test of Mann and Whitney (1947), times the number of places at which a change may be.
//! - **Drift**: the slope since the last sudden change, by the median of the slopes of all pairs of runs (Theil 1950, Sen
//!   1968) and the test of Kendall (1938). Single outliers do not move it. The runs are assumed to scatter independently.
//! - **False alarms**: the probabilities of all channels and groups are adjusted after Holm (1979). In a memory in which
//!   nothing changes, the probability of any finding of these two kinds is [`FALSE_ALARM_RATE`] at most.

mod assess;
mod cause;
mod change;
mod channel;
mod group;
mod median;
mod report;
mod slope;
mod words;

pub use assess::{FALSE_ALARM_RATE, FEWEST_EPISODES, NEW_CHANGE_RUNS, assess_groups};
pub use cause::DriftCause;
pub use channel::HealthChannel;
pub use group::{FirstRun, RunGroup, RunSource, gather_groups, group_runs};
pub use report::{
    ChannelAssessment, ChannelHealth, ChannelState, GroupHealth, HealthFinding, HealthFindingKind,
    HealthLimit, HealthReport, HealthTrend, NewestRuns, RunsToLimit, SuddenChange,
};
pub use words::{ChannelWords, DescribedHealth, GroupWords, HealthWords, TrendWords};

pub(crate) use cause::{LEAST_OFFSET, find_cause};
pub(crate) use change::find_changes;
pub(crate) use median::median;
pub(crate) use slope::RobustLine;
