//! A report in words. The command prints them, and the studio shows them.

use super::assess::{FALSE_ALARM_RATE, FEWEST_EPISODES, NEW_CHANGE_RUNS};
use super::channel::HealthChannel;
use super::report::{
    ChannelAssessment, ChannelHealth, ChannelState, GroupHealth, HealthFinding, HealthFindingKind,
    HealthLimit, HealthReport, HealthTrend, NewestRuns, RunsToLimit, SuddenChange, find_passed,
};
use crate::id::local_date_and_time;
use serde::Serialize;

/// A report with its words: the JSON of `wisch memory health`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DescribedHealth {
    /// The numbers.
    #[serde(flatten)]
    pub report: HealthReport,
    /// The same in words.
    pub words: HealthWords,
}

/// A health report in words, for people and pages.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HealthWords {
    /// The groups, in the order of the report.
    pub groups: Vec<GroupWords>,
    /// Number of groups, and of those that need attention or have too few runs.
    pub summary: String,
    /// The meaning of the probabilities, and what is not assessed.
    pub remarks: Vec<String>,
}

/// A group of runs in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupWords {
    /// Robot, tool, surface, dirt, press force and source.
    pub things: String,
    /// Number of runs with their dates.
    pub runs: String,
    /// States that there are too few runs, which leaves all channels unknown; `None` if there are enough.
    pub too_few: Option<String>,
    /// Whether a channel has a finding.
    pub needs_attention: bool,
    /// The channels, in the order of [`HealthChannel::ALL`].
    pub channels: Vec<ChannelWords>,
}

/// A channel of a group in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChannelWords {
    /// Name of the channel.
    pub channel: &'static str,
    /// Number of runs that record it.
    pub recorded: usize,
    /// Its trend over the runs, as far as it is known.
    #[serde(flatten)]
    pub trend: TrendWords,
    /// The findings in a few words; `None` if the channel is not assessed.
    pub finding: Option<&'static str>,
    /// Whether it has a finding that needs attention.
    pub needs_attention: bool,
    /// Sudden change, forecast and limit, with advice.
    pub sentences: Vec<String>,
}

/// The trend of a channel in words, or the reason why it is unknown.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum TrendWords {
    /// The line since the last sudden change.
    Line {
        /// Present value, with its unit.
        now: String,
        /// Change per run with its 95 % interval and its unit.
        per_run: String,
        /// Adjusted probability that chance explains it.
        p: String,
    },
    /// There is no line.
    Unknown {
        /// The reason.
        unknown: String,
    },
}

impl From<HealthReport> for DescribedHealth {
    fn from(report: HealthReport) -> Self {
        Self {
            words: HealthWords {
                groups: report.groups.iter().map(GroupWords::of).collect(),
                summary: summarise(&report),
                remarks: remarks_on(&report),
            },
            report,
        }
    }
}

fn summarise(report: &HealthReport) -> String {
    if report.groups.is_empty() {
        return "the memory has no rounds; wisch run adds an episode".to_owned();
    }
    let count = |is_one: fn(&GroupHealth) -> bool| {
        let some = report.groups.iter().filter(|group| is_one(group));
        some.count()
    };
    let groups = count_with_noun(report.groups.len(), "group");
    let text = match count(|group| group.needs_attention) {
        0 => format!("{groups}: nothing is found that needs attention"),
        1 => format!("{groups}: 1 needs attention"),
        alarms => format!("{groups}: {alarms} need attention"),
    };
    match count(|group| group.runs < FEWEST_EPISODES) {
        0 => text,
        short => format!("{text}; too few episodes in {short}"),
    }
}

fn remarks_on(report: &HealthReport) -> Vec<String> {
    if report.tests == 0 {
        return Vec::new();
    }
    let tests = count_with_noun(report.tests, "test");
    vec![
        format!(
            "p: probability that chance explains the slope, adjusted to {tests} (Holm). \
             If runs scatter independently and normally, and nothing changes, any drift or sudden change is shown with a probability of at most {FALSE_ALARM_RATE}."
        ),
        "Tracking errors are not assessed: they are in the telemetry of an episode, which health does not read.".to_owned(),
    ]
}

impl GroupWords {
    fn of(group: &GroupHealth) -> Self {
        let name = |name: &Option<String>, what: &str| {
            name.clone().unwrap_or_else(|| format!("unknown {what}"))
        };
        let force = group.press_force_n.map_or_else(
            || "press force not recorded".to_owned(),
            |force| format!("{force:?} N"),
        );
        let things = [
            name(&group.robot, "robot"),
            name(&group.tool, "tool"),
            name(&group.surface, "surface"),
            name(&group.medium, "dirt"),
            force,
            group.source.as_str().to_owned(),
        ];
        let mut runs = count_with_noun(group.runs, "run");
        if let (Some(first), Some(last)) = (group.first_s, group.last_s) {
            let [first, last] = [first, last].map(local_date_and_time);
            runs += &format!(", {first} to {last}");
        }
        if group.undated_runs > 0 {
            let undated = count_with_noun(group.undated_runs, "run");
            runs += &format!("; {undated} left out, because the date is unknown");
        }
        let recorded = group.channels[HealthChannel::Performance as usize].recorded;
        if recorded > 0 && recorded < group.runs {
            let unknown = count_with_noun(group.runs - recorded, "run");
            runs += &format!(
                "; the performance of {unknown} is left out: it is unknown, or only known from below"
            );
        }
        if group.newest_without_contact > 0 {
            let newest = count_with_noun(group.runs.min(NEW_CHANGE_RUNS), "run");
            runs += &format!(
                "; {} of the newest {newest} show no contact at the surface: check the force sensor with a known weight, and whether the tool presses",
                group.newest_without_contact
            );
        }
        let is_short = group.runs < FEWEST_EPISODES;
        Self {
            things: things.join(" · "),
            runs,
            too_few: is_short.then(|| too_few("", group.runs, FEWEST_EPISODES)),
            needs_attention: group.needs_attention,
            channels: group.channels.iter().map(ChannelWords::of).collect(),
        }
    }
}

fn too_few(since: &str, found: usize, needed: usize) -> String {
    format!("too few episodes{since} ({found} of {needed})")
}

impl ChannelWords {
    fn of(health: &ChannelHealth) -> Self {
        let unknown = match &health.state {
            ChannelState::Assessed(assessment) => return Self::of_assessed(health, assessment),
            ChannelState::NotRecorded => "not recorded".to_owned(),
            ChannelState::TooFew { needed } => too_few("", health.recorded, *needed),
            ChannelState::Outdated { runs } => {
                let runs = count_with_noun(*runs, "run");
                format!("unknown: not recorded in the last {runs}")
            }
        };
        Self {
            channel: health.channel.as_str(),
            recorded: health.recorded,
            trend: TrendWords::Unknown { unknown },
            finding: None,
            needs_attention: false,
            sentences: Vec::new(),
        }
    }

    fn of_assessed(health: &ChannelHealth, assessment: &ChannelAssessment) -> Self {
        let unit = DisplayUnit::of(health.channel);
        let trend = match &assessment.trend {
            Some(trend) => TrendWords::Line {
                now: unit.value(if assessment.is_off_trend(trend) {
                    assessment.newest.value
                } else {
                    trend.value
                }),
                per_run: unit.slope(trend),
                p: p_text(trend.p_adjusted),
            },
            None => TrendWords::Unknown {
                unknown: too_few(
                    " since the sudden change",
                    assessment.runs_since,
                    FEWEST_EPISODES,
                ),
            },
        };
        Self {
            channel: health.channel.as_str(),
            recorded: health.recorded,
            trend,
            finding: Some(state_in_words(assessment)),
            needs_attention: !assessment.findings.is_empty(),
            sentences: sentences_on(assessment, unit),
        }
    }
}

fn sentences_on(assessment: &ChannelAssessment, unit: DisplayUnit) -> Vec<String> {
    let found = |kind| {
        let mut findings = assessment.findings.iter();
        findings.find(|finding| finding.kind == kind)
    };
    let mut sentences = Vec::new();
    if let Some(change) = &assessment.change {
        let finding = found(HealthFindingKind::SuddenChange);
        let runs = assessment.runs_since;
        sentences.push(change_in_words(change, runs, unit, finding));
    }
    if let Some(trend) = assessment.trend.as_ref().filter(|trend| trend.is_drift) {
        let finding = found(HealthFindingKind::Drift);
        sentences.push(drift_in_words(trend, &assessment.limits, unit, finding));
    }
    let (newest, trend) = (&assessment.newest, assessment.trend.as_ref());
    let finding = found(HealthFindingKind::BeyondLimit);
    if let Some(trend) = trend.filter(|trend| assessment.is_off_trend(trend)) {
        let line = unit.value(trend.value);
        let newest = newest_in_words(newest, unit);
        sentences.push(format!("{newest}, off the line, which ends at {line}"));
    } else if trend.is_none() && finding.is_some() {
        sentences.push(newest_in_words(newest, unit));
    }
    if let Some(finding) = finding {
        let limits = &assessment.limits;
        let by_trend = trend.and_then(|trend| find_passed(limits, trend.value_within));
        let passed = by_trend.or_else(|| find_passed(limits, newest.value_within));
        if let Some((limit, _)) = passed {
            let limit = limit_in_words(limit, unit);
            sentences.push(format!("beyond {limit}: {}", finding.advice));
        }
    }
    sentences
}

fn newest_in_words(newest: &NewestRuns, unit: DisplayUnit) -> String {
    let [low, high] = newest.value_within.map(|value| unit.value(value));
    let (runs, value) = (newest.runs, unit.value(newest.value));
    format!("the newest {runs} runs are at {value} ({low} to {high})")
}

/// Returns the findings of a channel in a few words.
fn state_in_words(assessment: &ChannelAssessment) -> &'static str {
    let has = |kind| {
        assessment
            .findings
            .iter()
            .any(|finding| finding.kind == kind)
    };
    let is_drift = assessment
        .trend
        .as_ref()
        .is_some_and(|trend| trend.is_drift);
    if has(HealthFindingKind::BeyondLimit) {
        "beyond limit"
    } else if has(HealthFindingKind::Drift) {
        "drift"
    } else if has(HealthFindingKind::SuddenChange) {
        "changed"
    } else if is_drift {
        "improves"
    } else if (assessment.trend.as_ref()).is_none_or(|trend| !trend.can_show_drift) {
        "too few runs"
    } else {
        "none"
    }
}

fn change_in_words(
    change: &SuddenChange,
    runs: usize,
    unit: DisplayUnit,
    finding: Option<&HealthFinding>,
) -> String {
    let [before, after] = [change.before, change.after].map(|value| unit.value(value));
    let advice = finding.map_or_else(String::new, |finding| format!(": {}", finding.advice));
    let runs = count_with_noun(runs, "run");
    let time = local_date_and_time(change.time_s);
    let p = match p_text(change.p_adjusted) {
        p if p.starts_with('<') => format!("p {p}"),
        p => format!("p = {p}"),
    };
    let what = if change.is_shown {
        "sudden change"
    } else {
        "possible sudden change, from which the line begins,"
    };
    format!("{what} {runs} ago, at {time}: from {before} to {after} ({p}){advice}")
}

fn drift_in_words(
    trend: &HealthTrend,
    limits: &[Option<HealthLimit>; 2],
    unit: DisplayUnit,
    finding: Option<&HealthFinding>,
) -> String {
    let limit = limits[usize::from(trend.per_run > 0.0)].as_ref();
    let sentence = match (&trend.runs_to_limit, limit) {
        (Some(runs), Some(limit)) => {
            let forecast = forecast_in_words(runs);
            format!("drift: {forecast} until {}", limit_in_words(limit, unit))
        }
        (None, Some(limit)) => format!("drift, already beyond {}", limit_in_words(limit, unit)),
        (_, None) => "drift without a limit in its direction".to_owned(),
    };
    let advice = finding.map_or_else(String::new, |finding| format!("; {}", finding.advice));
    sentence + &advice
}

fn forecast_in_words(runs: &RunsToLimit) -> String {
    let estimate = match runs.estimate.round() {
        few if few < 1.0 => "less than 1 run".to_owned(),
        1.0 => "about 1 run".to_owned(),
        many => format!("about {many:.0} runs"),
    };
    let earliest = runs.earliest;
    match runs.latest {
        Some(latest) => format!("{estimate} ({earliest:.0} to {latest:.0})"),
        None => format!("{estimate} ({earliest:.0} or more)"),
    }
}

fn limit_in_words(limit: &HealthLimit, unit: DisplayUnit) -> String {
    format!("{}, {}", unit.value(limit.value), limit.meaning)
}

/// Formats a probability [1].
fn p_text(p: f64) -> String {
    if p < 1e-4 {
        "< 0.0001".to_owned()
    } else {
        format!("{p:.4}")
    }
}

/// The unit in which people read a channel, with decimals.
#[derive(Debug, Clone, Copy)]
struct DisplayUnit {
    name: &'static str,
    factor: f64,
    decimals: usize,
    /// Unit of the slope, and its factor.
    slope: (&'static str, f64),
}

impl DisplayUnit {
    const fn same(name: &'static str, factor: f64, decimals: usize) -> Self {
        Self {
            name,
            factor,
            decimals,
            slope: (name, factor),
        }
    }

    const fn of(channel: HealthChannel) -> Self {
        match channel {
            HealthChannel::ContactForce => Self::same("N", 1.0, 2),
            HealthChannel::Offset => Self::same("mm", 1e3, 2),
            HealthChannel::Tilt => Self::same("°", 180.0 / std::f64::consts::PI, 2),
            HealthChannel::ContactShare | HealthChannel::Performance => Self::same("%", 100.0, 1),
            // The slope is that of the logarithm.
            HealthChannel::Stiffness => Self {
                slope: ("%", 100.0),
                ..Self::same("N/m", 1.0, 0)
            },
        }
    }

    fn value(self, value: f64) -> String {
        number(self.factor * value, self.decimals) + " " + self.name
    }

    fn slope(self, trend: &HealthTrend) -> String {
        let (name, factor) = self.slope;
        let decimals = self.decimals.max(1) + 1;
        let [low, high] = trend
            .per_run_within
            .map(|slope| number(factor * slope, decimals));
        let slope = number(factor * trend.per_run, decimals);
        format!("{slope} ({low} to {high}) {name}")
    }
}

/// Formats a number without the sign of a zero.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = !text.contains(|c: char| ('1'..='9').contains(&c));
    let unsigned = text.strip_prefix('-').filter(|_| is_zero);
    unsigned.map_or_else(|| text.clone(), str::to_owned)
}

/// Formats a count with its noun; the plural takes an s.
fn count_with_noun(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_has_no_sign() {
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(number(-0.1, 2), "-0.10");
        assert_eq!(p_text(2e-7), "< 0.0001");
    }

    #[test]
    fn a_forecast_states_its_interval() {
        let runs = |estimate, latest| RunsToLimit {
            estimate,
            earliest: 0.4,
            latest,
        };
        for (found, expected) in [
            (runs(5.2, Some(7.0)), "about 5 runs (0 to 7)"),
            (runs(1.2, None), "about 1 run (0 or more)"),
            (runs(0.4, Some(1.0)), "less than 1 run (0 to 1)"),
        ] {
            assert_eq!(forecast_in_words(&found), expected);
        }
    }
}
