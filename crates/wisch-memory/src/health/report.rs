//! What an assessment of a memory found, as records for people and programs.

use super::cause::DriftCause;
use super::channel::HealthChannel;
use super::group::RunSource;
use serde::Serialize;

/// The assessment of all groups of a memory.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HealthReport {
    /// Whether a channel of a group has a finding.
    pub needs_attention: bool,
    /// Largest probability of a drift or sudden change among the findings where nothing changes \[1\].
    pub false_alarm_rate: f64,
    /// Number of tests to which the probabilities are adjusted.
    pub tests: usize,
    /// The assessed groups, in their order.
    pub groups: Vec<GroupHealth>,
}

/// The assessment of one group of runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupHealth {
    /// Name of the robot, if known.
    pub robot: Option<String>,
    /// Name of the tool.
    pub tool: Option<String>,
    /// Name of the surface.
    pub surface: Option<String>,
    /// Name of the dirt.
    pub medium: Option<String>,
    /// Press force of the task \[N\], if the episodes state it.
    pub press_force_n: Option<f64>,
    /// How the values were obtained.
    pub source: RunSource,
    /// Number of assessed runs.
    pub runs: usize,
    /// Number of runs that are left out because their dates are unknown.
    pub undated_runs: usize,
    /// Number of the newest ten runs whose force shows no contact, although the tool was at the surface.
    pub newest_without_contact: usize,
    /// Start of the first run [s since 1970]; `None` without a run.
    pub first_s: Option<f64>,
    /// Start of the last run [s since 1970]; `None` without a run.
    pub last_s: Option<f64>,
    /// Whether a channel has a finding.
    pub needs_attention: bool,
    /// The channels, in the order of [`HealthChannel::ALL`].
    pub channels: Vec<ChannelHealth>,
}

/// The assessment of a channel of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChannelHealth {
    /// The channel.
    pub channel: HealthChannel,
    /// Unit of its values; 1 stands for a share.
    pub unit: &'static str,
    /// Number of runs that record it.
    pub recorded: usize,
    /// The state of its assessment, with the results.
    #[serde(flatten)]
    pub state: ChannelState,
}

/// The state of a channel's assessment, with its results.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum ChannelState {
    /// No run records it.
    NotRecorded,
    /// Too few runs record it.
    TooFew {
        /// Number of runs from which it is assessed.
        needed: usize,
    },
    /// Many of the last runs do not record it, so that its present value is unknown.
    Outdated {
        /// Number of runs since it was recorded.
        runs: usize,
    },
    /// Its course was assessed.
    Assessed(Box<ChannelAssessment>),
}

/// The course of a channel over the runs of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChannelAssessment {
    /// The last sudden change, if there is one.
    pub change: Option<SuddenChange>,
    /// Number of runs since then, with those that do not record the channel.
    pub runs_since: usize,
    /// The course since then; `None` if too few runs follow the change.
    pub trend: Option<HealthTrend>,
    /// The newest runs, which may differ from the course.
    pub newest: NewestRuns,
    /// Lower and upper limit; `None` for a side without a limit.
    pub limits: [Option<HealthLimit>; 2],
    /// Findings that need attention; empty without any.
    pub findings: Vec<HealthFinding>,
}

/// A sudden change of a channel between two runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SuddenChange {
    /// Start of the first run after it [s since 1970].
    pub time_s: f64,
    /// Value before it, in the unit of the channel.
    pub before: f64,
    /// Value after it.
    pub after: f64,
    /// Probability that chance explains it \[1\].
    pub p: f64,
    /// Probability `p`, adjusted to the number of tests of the report \[1\].
    pub p_adjusted: f64,
    /// Whether chance does not explain it.
    pub is_shown: bool,
}

/// The course of a channel since its last sudden change.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HealthTrend {
    /// Value of the fitted line at the last run, in the unit of the channel.
    pub value: f64,
    /// Its approximate 95 % interval.
    pub value_within: [f64; 2],
    /// Slope per run, in the unit of the channel; for a stiffness, the change of its logarithm.
    pub per_run: f64,
    /// Its 95 % interval.
    pub per_run_within: [f64; 2],
    /// Probability that chance explains the slope \[1\].
    pub p: f64,
    /// Probability `p`, adjusted to the number of tests of the report \[1\].
    pub p_adjusted: f64,
    /// Whether chance does not explain the slope, and the change exceeds the resolution of the channel.
    pub is_drift: bool,
    /// Whether the number of runs can show a drift at all, beside the other tests of the report.
    pub can_show_drift: bool,
    /// Number of runs until a limit is reached; `None` without a drift towards a limit.
    pub runs_to_limit: Option<RunsToLimit>,
}

/// The newest runs that record a channel, without regard to earlier ones.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NewestRuns {
    /// Number of these runs.
    pub runs: usize,
    /// Their mean, in the unit of the channel; for a stiffness, the geometric mean.
    pub value: f64,
    /// Its 95 % interval.
    pub value_within: [f64; 2],
}

/// A limit of a channel, beyond which it needs attention, with the reason.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HealthLimit {
    /// The value, in the unit of the channel.
    pub value: f64,
    /// The reason why this value is a limit, in words.
    pub meaning: &'static str,
}

impl ChannelAssessment {
    /// Whether the newest runs contradict the course: their intervals have no value in common.
    pub(super) fn is_off_trend(&self, trend: &HealthTrend) -> bool {
        let ([low, high], [least, most]) = (self.newest.value_within, trend.value_within);
        low > most || high < least
    }
}

/// Returns the limit beyond which all values of an interval lie, and whether it is the upper one.
pub(super) fn find_passed(
    [least, most]: &[Option<HealthLimit>; 2],
    [low, high]: [f64; 2],
) -> Option<(&HealthLimit, bool)> {
    let below = least.as_ref().filter(|limit| high < limit.value);
    let above = most.as_ref().filter(|limit| low > limit.value);
    below
        .map(|limit| (limit, false))
        .or(above.map(|limit| (limit, true)))
}

/// The number of further runs until a drifting channel reaches its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunsToLimit {
    /// Number of runs by the estimated slope.
    pub estimate: f64,
    /// Number of runs by the fastest slope of the 95 % interval, from the end of the value's interval next to the limit.
    pub earliest: f64,
    /// Number of runs by the slowest slope, from the other end; `None` if that slope never reaches the limit.
    pub latest: Option<f64>,
}

/// Something that needs attention, with advice.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HealthFinding {
    /// Its kind.
    pub kind: HealthFindingKind,
    /// Cause of a change of the offset, where it was determined.
    pub cause: Option<DriftCause>,
    /// Advice on what to do about it.
    pub advice: &'static str,
}

/// The kind of a finding about a channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HealthFindingKind {
    /// The value changes from run to run.
    Drift,
    /// The value changed between two of the last runs.
    SuddenChange,
    /// The value has passed a limit.
    BeyondLimit,
}
