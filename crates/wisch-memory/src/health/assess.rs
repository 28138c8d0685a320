//! Drifts, sudden changes, limits, forecasts and advice for groups of runs.

use super::cause::{DriftCause, find_cause};
use super::change::find_changes;
use super::channel::HealthChannel;
use super::group::{FirstRound, RunGroup};
use super::median::median;
use super::report::{
    ChannelAssessment, ChannelHealth, ChannelState, GroupHealth, HealthFinding, HealthFindingKind,
    HealthLimit, HealthReport, HealthTrend, NewestRuns, RunsToLimit, SuddenChange, find_passed,
};
use super::slope::RobustLine;
use wisch::interpret::EventConfig;

/// Least number of episodes from which a trend is computed.
pub const FEWEST_EPISODES: usize = 7;
/// Largest probability of a drift or sudden change in the report of a memory in which nothing changes \[1\].
pub const FALSE_ALARM_RATE: f64 = 0.01;
/// Number of runs during which a sudden change needs attention; afterwards, the values since then count as usual.
pub const NEW_CHANGE_RUNS: usize = 10;

/// Number of the newest runs whose mean is compared with the limits, without regard to earlier runs.
const NEWEST: usize = 3;
/// Quantiles of Student's distribution with two, three, … degrees of freedom that leave 2.5 % above them.
const STUDENT: [f64; 5] = [4.302_653, 3.182_446, 2.776_445, 2.570_582, 2.446_912];

/// Least number of episodes with a test for a sudden change: four on either side.
const FEWEST_WITH_CHANGE: usize = 8;
/// Least mean contact force, as a share of the press force of the task \[1\]. At half of that
/// force, the sponge of the knowledge base still affects 92 % of the crumbs; at a third, less than
/// half.
const LEAST_FORCE: f64 = 0.5;
/// Least contact share \[1\]: below it, `interpret` doubts that a log shows wiping.
const LEAST_CONTACT: f64 = 0.3;
/// Offset \[m\] and tilt \[rad\] from which `interpret` relocalises a surface.
const RELOCALIZE_OFFSET: f64 = 3e-3;
const RELOCALIZE_TILT: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// Assesses every channel of every group. The probabilities are adjusted to the tests of all given groups.
///
/// ```
/// use wisch_memory::Catalogue;
/// use wisch_memory::health::{assess_groups, gather_groups};
/// let report = assess_groups(&gather_groups(&Catalogue::default()));
/// assert!(report.groups.is_empty() && !report.needs_attention);
/// ```
pub fn assess_groups(groups: &[RunGroup]) -> HealthReport {
    let mut tests = Vec::new();
    let mut all_series: Vec<Vec<Option<ChannelSeries>>> = Vec::new();
    for group in groups {
        let of_group = HealthChannel::ALL.map(|channel| ChannelSeries::of(group, channel));
        for series in of_group.iter().flatten() {
            tests.extend(series.p_values());
        }
        all_series.push(of_group.into());
    }
    let count = tests.len();
    let adjusted = adjust(&tests);
    let mut adjusted = adjusted.into_iter();
    let groups = groups.iter().zip(all_series).map(|(group, all_series)| {
        let channels = HealthChannel::ALL.into_iter().zip(all_series);
        let channels = channels.map(|(channel, series)| {
            let recorded = group
                .rounds
                .iter()
                .filter(|round| round.value(channel).is_some())
                .count();
            let state = match series {
                Some(series) => {
                    let assessment = series.assess(group, &mut adjusted, count);
                    ChannelState::Assessed(Box::new(assessment))
                }
                None if unrecorded_runs(group, channel) > NEW_CHANGE_RUNS && recorded > 0 => {
                    ChannelState::Outdated {
                        runs: unrecorded_runs(group, channel),
                    }
                }
                None if recorded == 0 && !group.rounds.is_empty() => ChannelState::NotRecorded,
                None => ChannelState::TooFew {
                    needed: FEWEST_EPISODES,
                },
            };
            ChannelHealth {
                channel,
                unit: channel.unit(),
                recorded,
                state,
            }
        });
        describe_group(group, channels.collect())
    });
    let groups: Vec<GroupHealth> = groups.collect();
    HealthReport {
        needs_attention: groups.iter().any(|group| group.needs_attention),
        false_alarm_rate: FALSE_ALARM_RATE,
        tests: tests.len(),
        groups,
    }
}

fn describe_group(group: &RunGroup, channels: Vec<ChannelHealth>) -> GroupHealth {
    let newest = group.rounds.iter().rev().take(NEW_CHANGE_RUNS);
    let newest_without_contact = newest.filter(|round| round.shows_no_contact()).count();
    let has_findings = channels.iter().any(|channel| match &channel.state {
        ChannelState::Assessed(assessment) => !assessment.findings.is_empty(),
        ChannelState::NotRecorded | ChannelState::TooFew { .. } | ChannelState::Outdated { .. } => {
            false
        }
    });
    let begin = |round: Option<&FirstRound>| round.map(|round| round.interval[0]);
    GroupHealth {
        robot: group.robot.clone(),
        tool: group.tool.clone(),
        surface: group.surface.clone(),
        medium: group.medium.clone(),
        press_force_n: group.press_force_n,
        source: group.source,
        runs: group.rounds.len(),
        undated_runs: group.undated,
        newest_without_contact,
        first_s: begin(group.rounds.first()),
        last_s: begin(group.rounds.last()),
        needs_attention: has_findings || newest_without_contact >= NEWEST,
        channels,
    }
}

/// Returns the number of runs after the last one that records a channel.
fn unrecorded_runs(group: &RunGroup, channel: HealthChannel) -> usize {
    let newest = group.rounds.iter().rev();
    newest
        .take_while(|round| round.value(channel).is_none())
        .count()
}

/// Adjusts p-values for the number of tests (Holm 1979): if nothing has changed, the least adjusted
/// one is below α with a probability of α at most, however the tests depend on each other.
#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
fn adjust(p_values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|a, b| p_values[*a].total_cmp(&p_values[*b]));
    let mut adjusted = vec![1.0; p_values.len()];
    let mut largest: f64 = 0.0;
    for (rank, place) in order.into_iter().enumerate() {
        let factor = (p_values.len() - rank) as f64;
        largest = largest.max((factor * p_values[place]).min(1.0));
        adjusted[place] = largest;
    }
    adjusted
}

/// The series of a channel of a group, in the scale of the fit, before the probabilities are adjusted.
struct ChannelSeries<'a> {
    channel: HealthChannel,
    /// The rounds that record the channel, and their values.
    rounds: Vec<&'a FirstRound>,
    values: Vec<f64>,
    /// Number of runs of the group since the last sudden change.
    runs_since: usize,
    /// The last sudden change: first index after it, values before and after, and its probability.
    change: Option<(usize, [f64; 2], f64)>,
    /// First index of the part before the last sudden change.
    before: usize,
    /// The line since the last change, if enough runs follow it.
    line: Option<RobustLine>,
}

impl<'a> ChannelSeries<'a> {
    fn of(group: &'a RunGroup, channel: HealthChannel) -> Option<Self> {
        let recorded = group.rounds.iter().enumerate();
        let recorded = recorded.filter_map(|(k, round)| Some(((round, k), round.value(channel)?)));
        let (recorded, values): (Vec<_>, Vec<f64>) = recorded.unzip();
        if values.len() < FEWEST_EPISODES || unrecorded_runs(group, channel) > NEW_CHANGE_RUNS {
            return None;
        }
        let (rounds, indices): (Vec<_>, Vec<usize>) = recorded.into_iter().unzip();
        let places: Vec<f64> = indices.iter().map(|&k| k as f64).collect();
        let scatter = channel.resolution();
        let changes = find_changes(&values, scatter);
        let since = changes.last().map_or(0, |change| change.place);
        let earlier = changes.len().checked_sub(2).map_or(0, |k| changes[k].place);
        let fit = |from: usize, to: usize| {
            RobustLine::fit_at(&places[from..to], &values[from..to], scatter)
        };
        let latest = fit(since, values.len());
        let change = changes.last().map(|change| {
            let [_, before] = fit(earlier, since).ends;
            (change.place, [before, latest.ends[0]], change.p)
        });
        let is_enough = values.len() - since >= FEWEST_EPISODES;
        Some(Self {
            channel,
            rounds,
            runs_since: group.rounds.len() - indices[since],
            change,
            before: earlier,
            line: is_enough.then_some(latest),
            values,
        })
    }

    /// Index of the first run since the last sudden change.
    fn since(&self) -> usize {
        self.change.map_or(0, |(place, ..)| place)
    }

    /// Returns the probabilities of the tests of this channel: of a sudden change, and of a slope.
    fn p_values(&self) -> impl Iterator<Item = f64> {
        let has_change_test = self.values.len() >= FEWEST_WITH_CHANGE;
        let change = has_change_test.then(|| self.change.map_or(1.0, |(.., p)| p));
        change
            .into_iter()
            .chain(self.line.as_ref().map(|line| line.p))
    }

    /// Completes the assessment. `adjusted`: the adjusted probabilities of [`Self::p_values`], in the same order.
    fn assess(
        &self,
        group: &RunGroup,
        adjusted: &mut impl Iterator<Item = f64>,
        tests: usize,
    ) -> ChannelAssessment {
        let mut next = || adjusted.next().unwrap_or(1.0);
        let channel = self.channel;
        let change_p = (self.values.len() >= FEWEST_WITH_CHANGE).then(&mut next);
        let change = self.change.map(|(place, values, p)| {
            let [before, after] = values.map(|value| channel.unscaled(value));
            let p_adjusted = change_p.unwrap_or(1.0);
            SuddenChange {
                time_s: self.rounds[place].interval[0],
                before,
                after,
                p,
                p_adjusted,
                is_shown: p_adjusted <= FALSE_ALARM_RATE,
            }
        });
        let limits = self.limits(group);
        let trend = self
            .line
            .as_ref()
            .map(|line| self.trend(line, (next(), tests), &limits));
        let newest = self.newest();
        let courses = (change.as_ref(), trend.as_ref(), &newest);
        let findings = self.findings(group, courses, &limits);
        ChannelAssessment {
            change,
            runs_since: self.runs_since,
            trend,
            newest,
            limits,
            findings,
        }
    }

    /// Returns the mean of the newest runs, or of all runs since a sudden change that are too few for a line. Its interval
    /// respects the resolution of the channel.
    #[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
    fn newest(&self) -> NewestRuns {
        let runs = match self.line {
            Some(_) => NEWEST,
            None => (self.values.len() - self.since()).max(NEWEST),
        };
        let newest = &self.values[self.values.len().saturating_sub(runs)..];
        let student = STUDENT[(newest.len().saturating_sub(NEWEST)).min(STUDENT.len() - 1)];
        let count = newest.len() as f64;
        let mean = newest.iter().sum::<f64>() / count;
        let squares: f64 = newest.iter().map(|value| (value - mean).powi(2)).sum();
        let deviation = (squares / (count - 1.0)).sqrt();
        let error = student * deviation.max(self.channel.resolution()) / count.sqrt();
        NewestRuns {
            runs: newest.len(),
            value: self.channel.unscaled(mean),
            value_within: [mean - error, mean + error].map(|value| self.channel.unscaled(value)),
        }
    }

    fn trend(
        &self,
        line: &RobustLine,
        (p_adjusted, tests): (f64, usize),
        limits: &[Option<HealthLimit>; 2],
    ) -> HealthTrend {
        let channel = self.channel;
        let [first, last] = line.ends;
        let is_drift =
            p_adjusted <= FALSE_ALARM_RATE && (last - first).abs() >= channel.resolution();
        let limit = limits[usize::from(line.slope > 0.0)].as_ref();
        let limit = limit
            .and_then(|limit| channel.scale(limit.value))
            .filter(|_| is_drift);
        let [low, high] = [last - line.uncertainty, last + line.uncertainty];
        HealthTrend {
            value: channel.unscaled(last),
            value_within: [low, high].map(|value| channel.unscaled(value)),
            per_run: line.slope,
            per_run_within: line.slope_within,
            p: line.p,
            p_adjusted,
            is_drift,
            can_show_drift: tests as f64 * line.least_p <= FALSE_ALARM_RATE,
            runs_to_limit: limit.and_then(|limit| forecast(line, limit)),
        }
    }

    /// Returns the lower and upper limit of the channel, in its unit.
    fn limits(&self, group: &RunGroup) -> [Option<HealthLimit>; 2] {
        let at = |value: f64, meaning| Some(HealthLimit { value, meaning });
        match self.channel {
            HealthChannel::ContactForce => group.press_force_n.map_or([None, None], |force| {
                let most = EventConfig::default().overload[0];
                [
                    at(LEAST_FORCE * force, "half of the press force"),
                    at(most * force, "an overload"),
                ]
            }),
            HealthChannel::ContactShare => {
                [at(LEAST_CONTACT, "below which a log is doubted"), None]
            }
            HealthChannel::Offset => {
                let relocalised = "from which a surface is relocalised";
                let (most, meanings) = match compression(group) {
                    Some(depth) => (
                        depth,
                        [
                            "at which the tool loses contact",
                            "at which the tool presses twice as hard",
                        ],
                    ),
                    None => (RELOCALIZE_OFFSET, [relocalised; 2]),
                };
                [at(-most, meanings[0]), at(most, meanings[1])]
            }
            HealthChannel::Tilt => [
                None,
                at(RELOCALIZE_TILT, "from which a surface is relocalised"),
            ],
            HealthChannel::Stiffness => {
                let first = self.line.as_ref().map(|line| line.ends[0].exp());
                let half = first.and_then(|first| {
                    at(0.5 * first, "half of the stiffness after the last change")
                });
                [half, None]
            }
            HealthChannel::Performance => [self.least_performance(), None],
        }
    }

    /// Returns the target, unless the plans already predict less for their first rounds.
    fn least_performance(&self) -> Option<HealthLimit> {
        let latest = &self.rounds[self.since()..];
        let target = latest.iter().rev().find_map(|round| round.target)?;
        let mut predicted: Vec<f64> = latest.iter().filter_map(|round| round.predicted).collect();
        let is_reachable = predicted.is_empty() || median(&mut predicted) >= target;
        is_reachable.then_some(HealthLimit {
            value: target,
            meaning: "the target",
        })
    }

    fn findings(
        &self,
        group: &RunGroup,
        (change, trend, newest): (Option<&SuddenChange>, Option<&HealthTrend>, &NewestRuns),
        limits: &[Option<HealthLimit>; 2],
    ) -> Vec<HealthFinding> {
        let mut findings = Vec::new();
        let mut add = |kind, by: f64, from: usize, sudden: Option<usize>| {
            let cause = self.cause(from, sudden);
            findings.push(HealthFinding {
                kind,
                cause,
                advice: advise(self.channel, by, cause),
            });
        };
        if let Some(change) = change.filter(|change| change.is_shown)
            && self.runs_since <= NEW_CHANGE_RUNS
            && !is_repair(self.channel, change, group.press_force_n)
        {
            add(
                HealthFindingKind::SuddenChange,
                change.after - change.before,
                self.before,
                Some(self.since() - self.before),
            );
        }
        if let Some(trend) = trend
            && trend.is_drift
            && !self.improves(trend, group.press_force_n)
        {
            add(HealthFindingKind::Drift, trend.per_run, self.since(), None);
        }
        let by_trend = trend.and_then(|trend| find_passed(limits, trend.value_within));
        if let Some((_, is_upper)) = by_trend.or_else(|| find_passed(limits, newest.value_within)) {
            let by = if is_upper { 1.0 } else { -1.0 };
            add(HealthFindingKind::BeyondLimit, by, 0, None);
        }
        findings
    }

    /// Whether a drift brings the value closer to its ideal, see [`off`].
    fn improves(&self, trend: &HealthTrend, asked: Option<f64>) -> bool {
        let first = self
            .line
            .as_ref()
            .map(|line| self.channel.unscaled(line.ends[0]));
        match (self.channel, first) {
            (HealthChannel::ContactForce | HealthChannel::Offset, Some(first)) => {
                off(self.channel, trend.value, asked) < off(self.channel, first, asked)
            }
            _ => self.channel.is_better(trend.per_run),
        }
    }

    /// Returns the cause of a change of the offset among the runs from index `from`. `sudden`:
    /// first index after a sudden change, counted from `from`.
    fn cause(&self, from: usize, sudden: Option<usize>) -> Option<DriftCause> {
        if self.channel != HealthChannel::Offset {
            return None;
        }
        let touches = self.rounds[from..].iter().map(|round| {
            let force = round.value(HealthChannel::ContactForce);
            [force, round.value(HealthChannel::Stiffness).map(f64::exp)]
        });
        let found = find_cause(&self.values[from..], &touches.collect::<Vec<_>>(), sudden);
        found.map(|(_, cause)| cause)
    }
}

/// Returns the depth \[m\] by which the force compresses the tool, from the press force (or the
/// measured force if the episodes state none) and the measured stiffness.
fn compression(group: &RunGroup) -> Option<f64> {
    let middle = |channel| {
        let values = group.rounds.iter().filter_map(|round| round.value(channel));
        let mut values: Vec<f64> = values.collect();
        (!values.is_empty()).then(|| median(&mut values))
    };
    let force = group
        .press_force_n
        .or_else(|| middle(HealthChannel::ContactForce))?;
    let depth = force / middle(HealthChannel::Stiffness)?.exp();
    (depth > 0.0 && depth.is_finite()).then_some(depth)
}

/// Returns the number of runs until a drifting line reaches a limit in its direction; `None` if it
/// is already beyond the limit.
fn forecast(line: &RobustLine, limit: f64) -> Option<RunsToLimit> {
    let sign = line.slope.signum();
    let distance = sign * (limit - line.ends[1]);
    let [low, high] = line.slope_within.map(|slope| sign * slope);
    let (slow, fast) = (low.min(high), low.max(high));
    (distance > 0.0).then(|| RunsToLimit {
        estimate: distance / line.slope.abs(),
        earliest: (distance - line.uncertainty).max(0.0) / fast,
        latest: (slow > 0.0).then(|| (distance + line.uncertainty) / slow),
    })
}

/// Returns the deviation of a value from its ideal; less is better. The ideal is `asked` (the press
/// force) for the contact force, and 0 for the offset. Of the other channels, less tilt or a larger
/// value is better.
fn off(channel: HealthChannel, value: f64, asked: Option<f64>) -> f64 {
    match channel {
        HealthChannel::ContactForce => asked.map_or(0.0, |asked| (value - asked).abs()),
        HealthChannel::Offset => value.abs(),
        HealthChannel::Tilt => value,
        HealthChannel::Stiffness | HealthChannel::ContactShare | HealthChannel::Performance => {
            -value
        }
    }
}

/// Whether a sudden change brought the value clearly closer to its ideal, as a relocalised surface
/// or a new tool does.
fn is_repair(channel: HealthChannel, change: &SuddenChange, asked: Option<f64>) -> bool {
    let [before, after] = [change.before, change.after].map(|value| off(channel, value, asked));
    match channel {
        HealthChannel::ContactForce | HealthChannel::Offset | HealthChannel::Tilt => {
            after < 0.5 * before
        }
        // A tool that becomes much stiffer has dried, or is another one.
        HealthChannel::Stiffness => after < before && change.after < 2.0 * change.before,
        HealthChannel::ContactShare | HealthChannel::Performance => after < before,
    }
}

/// Returns the advice on a change. `by`: a number with the sign of the change.
fn advise(channel: HealthChannel, by: f64, cause: Option<DriftCause>) -> &'static str {
    match channel {
        HealthChannel::Offset => match cause {
            Some(DriftCause::WornTool) => {
                "replace the tool: it sinks in deeper under the same force"
            }
            Some(DriftCause::StifferTool) => {
                "check the tool: it has become stiffer, and sinks in less under the same force"
            }
            Some(DriftCause::ToolAndSurface) => {
                "replace the tool, then relocalise the surface: both have a part in the change"
            }
            Some(DriftCause::LoweredSurface | DriftCause::RaisedSurface) if by < 0.0 => {
                "relocalise the surface: it is lower"
            }
            Some(DriftCause::LoweredSurface | DriftCause::RaisedSurface) => {
                "relocalise the surface: it is higher"
            }
            Some(DriftCause::Unknown) => {
                "relocalise the surface; without force and stiffness of each run, a worn tool is not excluded"
            }
            None => {
                "relocalise the surface; the cause is not determined for so small a change or so few runs"
            }
        },
        HealthChannel::Tilt => "relocalise the surface: it is tilted relative to the task's pose",
        HealthChannel::ContactForce => {
            "tare the force sensor and check it with a known weight; then relocalise the surface"
        }
        HealthChannel::ContactShare => "relocalise the surface, and check that it is flat",
        HealthChannel::Stiffness if by < 0.0 => "replace the tool: it becomes softer",
        HealthChannel::Stiffness => {
            "check the tool: it becomes stiffer, for example because it dries"
        }
        HealthChannel::Performance => {
            "compare the last reports with earlier ones, and with the prediction: tool, dirt, surface or plan"
        }
    }
}
