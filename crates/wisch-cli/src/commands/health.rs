//! `wisch memory health`: drifts and sudden changes over the episodes of a memory.

use super::memory::{broken, open};
use super::words::counted;
use crate::args::{MemoryHealthArgs, suggest};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_json, remark};
use std::collections::BTreeSet;
use wisch_memory::health::{
    ChannelAssessment, ChannelHealth, ChannelState, FALSE_ALARM_RATE, FEWEST_EPISODES, GroupHealth,
    HealthChannel, HealthFinding, HealthFindingKind, HealthLimit, HealthReport, HealthTrend,
    RunGroup, SuddenChange, assess_groups, gather_groups,
};
use wisch_memory::local_date_and_time;

/// Columns of the table at most.
const WIDTH: usize = 100;

/// Assesses the runs of a memory and prints what was found.
pub fn health(args: &MemoryHealthArgs) -> Result<Outcome, Failure> {
    let catalogue = open(&args.memory)?.catalogue().map_err(broken)?;
    for why in catalogue.omitted_episodes() {
        let verify = suggest("memory verify");
        remark(&format!("{why}: left out; {verify} lists damaged files"));
    }
    let groups = select(gather_groups(&catalogue), args)?;
    let report = assess_groups(&groups);
    if args.json {
        print_json(&report)?;
    } else if groups.is_empty() {
        print("the memory has no rounds; wisch run adds an episode\n")?;
    } else {
        print(&in_words(&report))?;
    }
    Ok(if report.needs_attention {
        Outcome::GoalNotMet
    } else {
        Outcome::Done
    })
}

/// Returns the groups with the requested robot, tool and surface.
fn select(groups: Vec<RunGroup>, args: &MemoryHealthArgs) -> Result<Vec<RunGroup>, Failure> {
    type NameOf = fn(&RunGroup) -> Option<&str>;
    let options: [(&str, &Option<String>, NameOf); 3] = [
        ("robot", &args.robot, |group| group.robot.as_deref()),
        ("tool", &args.tool, |group| group.tool.as_deref()),
        ("surface", &args.surface, |group| group.surface.as_deref()),
    ];
    let mut selected = groups.clone();
    for (option, asked, name_of) in options {
        let Some(asked) = asked else {
            continue;
        };
        let asked = asked.strip_prefix("semco:").unwrap_or(asked);
        let known: BTreeSet<&str> = groups.iter().filter_map(name_of).collect();
        if !known.contains(asked) {
            let known: Vec<&str> = known.into_iter().collect();
            let help = if known.is_empty() {
                format!("no episode of the memory names a {option}")
            } else {
                format!("the episodes name: {}", known.join(", "))
            };
            let error = format!("--{option} {asked:?}: no episode of the memory has this {option}");
            return Err(Failure::new(error).with_help(help));
        }
        selected.retain(|group| name_of(group) == Some(asked));
    }
    if selected.is_empty() && !groups.is_empty() {
        let error = "no episode has all of the names that --robot, --tool and --surface state";
        return Err(Failure::new(error).with_help("leave one of them out"));
    }
    Ok(selected)
}

fn in_words(report: &HealthReport) -> String {
    let groups = report.groups.iter().map(group_in_words);
    let mut text: String = groups.collect();
    let alarms = report
        .groups
        .iter()
        .filter(|group| group.needs_attention)
        .count();
    let groups = counted(report.groups.len(), "group");
    text += &match alarms {
        0 => format!("{groups}: nothing is found that needs attention"),
        1 => format!("{groups}: 1 needs attention"),
        _ => format!("{groups}: {alarms} need attention"),
    };
    let short = report
        .groups
        .iter()
        .filter(|group| group.runs < FEWEST_EPISODES);
    text += &match short.count() {
        0 => "\n".to_owned(),
        short => format!("; too few episodes in {short}\n"),
    };
    if report.tests == 0 {
        return text;
    }
    text += &wrap(
        0,
        &format!(
            "p: probability that chance explains the slope, adjusted to {} (Holm). \
             If runs scatter independently and normally, and nothing changes, any drift or sudden change is shown with a probability of at most {FALSE_ALARM_RATE}.",
            counted(report.tests, "test")
        ),
    );
    text + &wrap(
        0,
        "Tracking errors are not assessed: they are in the telemetry of an episode, which health does not read.",
    )
}

fn group_in_words(group: &GroupHealth) -> String {
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
    let mut text = wrap(0, &things.join(" · "));
    let mut runs = counted(group.runs, "run");
    if let (Some(first), Some(last)) = (group.first_s, group.last_s) {
        let [first, last] = [first, last].map(local_date_and_time);
        runs += &format!(", {first} to {last}");
    }
    if group.undated_runs > 0 {
        let undated = counted(group.undated_runs, "run");
        runs += &format!("; {undated} left out, because the date is unknown");
    }
    text += &wrap(2, &runs);
    if group.runs < FEWEST_EPISODES {
        return text + &format!("  {}\n\n", too_few("", group.runs, FEWEST_EPISODES));
    }
    text += &format!(
        "  {:<14}  {:>5}  {:>11}  {:<34}  {:>8}  finding\n",
        "channel", "runs", "now", "per run (95 % interval)", "p"
    );
    for channel in &group.channels {
        text += &channel_in_words(channel);
    }
    text + "\n"
}

fn too_few(since: &str, found: usize, needed: usize) -> String {
    format!("too few episodes{since} ({found} of {needed})")
}

fn channel_in_words(health: &ChannelHealth) -> String {
    let unit = DisplayUnit::of(health.channel);
    let begin = format!("  {:<14}  {:>5}", health.channel.as_str(), health.recorded);
    let assessment = match &health.state {
        ChannelState::NotRecorded => return format!("{begin}  not recorded\n"),
        ChannelState::TooFew { needed } => {
            return format!("{begin}  {}\n", too_few("", health.recorded, *needed));
        }
        ChannelState::Outdated { runs } => {
            let runs = counted(*runs, "run");
            return format!("{begin}  unknown: not recorded in the last {runs}\n");
        }
        ChannelState::Assessed(assessment) => assessment,
    };
    let state = state_in_words(assessment);
    let mut text = match &assessment.trend {
        Some(trend) => {
            let now = unit.value(trend.value);
            let slope = unit.slope(trend);
            let p = p_text(trend.p_adjusted);
            format!("{begin}  {now:>11}  {slope:<34}  {p:>8}  {state}\n")
        }
        None => {
            let since = " since the sudden change";
            let few = too_few(since, assessment.runs_since, FEWEST_EPISODES);
            format!("{begin}  {few:<57}  {state}\n")
        }
    };
    let found = |kind| {
        assessment
            .findings
            .iter()
            .find(|finding| finding.kind == kind)
    };
    if let Some(change) = &assessment.change {
        let finding = found(HealthFindingKind::SuddenChange);
        text += &change_in_words(change, assessment.runs_since, unit, finding);
    }
    if let Some(trend) = assessment.trend.as_ref().filter(|trend| trend.is_drift) {
        let finding = found(HealthFindingKind::Drift);
        text += &drift_in_words(trend, &assessment.limits, unit, finding);
    }
    if let (Some(finding), Some(trend)) = (found(HealthFindingKind::BeyondLimit), &assessment.trend)
    {
        let [low, high] = trend.value_within;
        let [least, most] = &assessment.limits;
        let below = least.as_ref().filter(|limit| high < limit.value);
        let above = most.as_ref().filter(|limit| low > limit.value);
        if let Some(limit) = below.or(above) {
            let limit = limit_in_words(limit, unit);
            text += &wrap(4, &format!("beyond {limit}: {}", finding.advice));
        }
    }
    text
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
        "too few to tell"
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
    let runs = counted(runs, "run");
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
    let sentence = format!("{what} {runs} ago, at {time}: from {before} to {after} ({p}){advice}");
    wrap(4, &sentence)
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
            let latest = runs
                .latest
                .map_or_else(|| "never".to_owned(), |latest| format!("{latest:.0}"));
            format!(
                "drift: in {:.0} runs ({:.0} to {latest}) at {}",
                runs.estimate,
                runs.earliest,
                limit_in_words(limit, unit)
            )
        }
        (None, Some(limit)) => format!("drift, already beyond {}", limit_in_words(limit, unit)),
        (_, None) => "drift without a limit in its direction".to_owned(),
    };
    let advice = finding.map_or_else(String::new, |finding| format!("; {}", finding.advice));
    wrap(4, &(sentence + &advice))
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

/// Breaks a sentence into lines of [`WIDTH`] columns at most, where its words allow it.
fn wrap(indent: usize, sentence: &str) -> String {
    let mut text = String::new();
    let mut column = 0;
    for word in sentence.split_whitespace() {
        let width = word.chars().count();
        if column == 0 || column + 1 + width > WIDTH {
            let is_first = text.is_empty();
            let indent = if is_first { indent } else { indent + 2 };
            text += if is_first { "" } else { "\n" };
            text += &" ".repeat(indent);
            column = indent;
        } else {
            text.push(' ');
            column += 1;
        }
        text += word;
        column += width;
    }
    text + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let text = wrap(4, &"word ".repeat(60));
        assert!(text.lines().count() > 2);
        assert!(
            text.lines()
                .all(|line| line.starts_with("    word") && line.len() <= WIDTH
                    || line.starts_with("      word"))
        );
        assert_eq!(wrap(2, "a  b"), "  a b\n");
    }

    #[test]
    fn a_zero_has_no_sign() {
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(number(-0.1, 2), "-0.10");
        assert_eq!(p_text(2e-7), "< 0.0001");
    }
}
