//! Poses and measurements from the telemetry of episodes.

use super::error::{AskError, QueryFault};
use super::reply::HostRefusal;
use super::rows::name_of;
use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, EpisodeRow, entries};
use crate::frames::{FrameError, Frames, PoseAt, Sampling, scene_of};
use crate::store::Memory;
use crate::telemetry::Telemetry;
use std::collections::HashMap;
use std::fmt::Display;
use std::ops::Range;
use std::rc::Rc;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::UnusableWrenches;
use wisch::robot::RobotModel;

/// File of the robot's description in an episode.
const ROBOT_FILE: &str = "robot.urdf";
/// Atom of a request that names no particular episode.
const ANY: &str = "any";
/// Time after the end of an interval up to which a sample still belongs to it \[s\]: times since
/// 1970 are exact to 2e-7 s.
const SAME_TIME: f64 = 1e-6;
/// Longest time before or after a sample that it represents in a mean [s], as for the contact of a round.
const LONGEST_REACH: f64 = 0.5;
/// Largest number of poses in a query's trajectory.
const MAX_POSES: usize = 200_000;

/// Telemetry of a memory's episodes, cached after the first use.
#[derive(Default)]
pub struct TelemetryPredicates {
    memory: Option<Memory>,
    /// Telemetry of each round, or the reason why it is not readable.
    rounds: HashMap<(String, usize), Result<Rc<Telemetry>, QueryFault>>,
    robots: HashMap<String, Option<Rc<RobotModel>>>,
    remarks: Vec<String>,
}

/// Part of a round, in its own time [s].
struct Span {
    telemetry: Rc<Telemetry>,
    /// The robot; `None` for a log.
    robot: Option<Rc<RobotModel>>,
    /// Name of the tool, if the episode states it.
    tool: String,
    /// Bias of the force that the round's interpretation subtracts, along the surface's normal, in the world [N].
    bias: Vector3,
    /// Start of the round [s since 1970].
    began: f64,
    from: f64,
    to: f64,
}

impl TelemetryPredicates {
    /// Opens the telemetry of a memory's episodes.
    pub fn new(memory: Memory) -> Self {
        Self {
            memory: Some(memory),
            ..Self::default()
        }
    }

    /// Returns remarks on episodes left out since the last call, and clears them.
    pub(super) fn take_remarks(&mut self) -> Vec<String> {
        std::mem::take(&mut self.remarks)
    }

    /// Answers a request about telemetry: `Episode-Answer` for each episode with an answer.
    pub(super) fn rows(
        &mut self,
        catalogue: &Catalogue,
        request: &Term,
    ) -> Result<Vec<Term>, HostRefusal> {
        let Some((name, arguments)) = request.parts() else {
            return Err(AskError::unexpected(request).into());
        };
        let facts = match (name, arguments) {
            ("pose", [Term::Atom(thing), time]) => {
                let time = number(time)?;
                let sampling = Sampling::Count(1);
                self.by_episode(catalogue, [time, time], None, |spans| {
                    let found = trajectory(spans, thing, sampling)?;
                    let first = found.into_iter().next().map(|(_, pose)| pose);
                    first.ok_or_else(|| fault("the interval holds no sample".to_owned()))
                })?
            }
            ("last_pose", [Term::Atom(thing)]) => vec![self.last_pose(catalogue, thing)?],
            ("trajectory", [Term::Atom(thing), from, to, sampling, Term::Atom(of)]) => {
                let interval = [number(from)?, number(to)?];
                let sampling = sampling_of(sampling)?;
                self.by_episode(catalogue, interval, Some(of), |spans| {
                    let timed = trajectory(spans, thing, sampling)?.into_iter();
                    let timed =
                        timed.map(|(time, pose)| Term::compound("-", [Term::Float(time), pose]));
                    Ok(Term::List(timed.collect()))
                })?
            }
            (
                "telemetry",
                [
                    Term::Atom(channel),
                    from,
                    to,
                    Term::Atom(statistic),
                    Term::Atom(of),
                ],
            ) => {
                let interval = [number(from)?, number(to)?];
                let mut unusable = UnusableWrenches::default();
                let found = self.by_episode(catalogue, interval, Some(of), |spans| {
                    let mut values = Vec::new();
                    for span in spans {
                        values.extend(channel_values(span, channel, &mut unusable)?);
                    }
                    // NaN stands for a value that was not measured or not stated.
                    values.retain(|(value, _)| !value.is_nan());
                    Ok(Term::Float(statistic_of(&values, statistic)?))
                });
                self.state_unusable(channel, unusable);
                found?
            }
            _ => return Err(AskError::unexpected(request).into()),
        };
        Ok(facts)
    }

    fn last_pose(&mut self, catalogue: &Catalogue, thing: &str) -> Result<Term, QueryFault> {
        let mut episodes: Vec<&EpisodeRow> = catalogue.episodes().iter().collect();
        episodes.sort_by(|a, b| b.interval[0].total_cmp(&a.interval[0]));
        let mut first = None;
        for episode in episodes {
            for round in (1..=episode.rounds.len()).rev() {
                let span = self.span(
                    catalogue,
                    episode,
                    round,
                    [f64::NEG_INFINITY, f64::INFINITY],
                );
                let found = span.and_then(|span| match span {
                    Some(span) => {
                        let from = span.to;
                        poses(&Span { from, ..span }, thing, Sampling::Count(1))
                    }
                    None => Ok(Vec::new()),
                });
                match found {
                    Ok(found) if found.is_empty() => {}
                    Ok(found) => return Ok(pose(&found[0])),
                    // An earlier round may have the pose.
                    Err(error) => {
                        first.get_or_insert(error);
                    }
                }
            }
        }
        Err(first.unwrap_or_else(|| fault("no episode has telemetry".to_owned())))
    }

    /// Returns an answer of each episode with telemetry in an interval [s since 1970], with the episode's name. If the
    /// request names something of an episode, only that episode answers. An episode that fails is left out with a
    /// remark, if another one answers.
    fn by_episode(
        &mut self,
        catalogue: &Catalogue,
        interval: [f64; 2],
        of: Option<&str>,
        mut answer: impl FnMut(&[Span]) -> Result<Term, QueryFault>,
    ) -> Result<Vec<Term>, QueryFault> {
        if self.memory.is_none() {
            return Err(fault("the memory has no telemetry".to_owned()));
        }
        let of = of.filter(|of| *of != ANY);
        let only = of.and_then(|of| catalogue.find(of.strip_prefix("semco:")?));
        let rows = match only {
            Some(id) => vec![catalogue.episode_of(id)],
            None => catalogue.episodes_during(interval),
        };
        let (mut answers, mut faults, mut is_any_left_out) = (Vec::new(), Vec::new(), false);
        for row in rows {
            let found = self.spans(catalogue, row, interval);
            let found =
                found.and_then(|spans| (!spans.is_empty()).then(|| answer(&spans)).transpose());
            match found {
                Ok(Some(found)) => {
                    let name = name_of(catalogue, row.first);
                    answers.push(Term::compound("-", [name, found]));
                }
                Ok(None) => {}
                // An episode's fault is not the query's: other episodes still answer.
                Err(error @ QueryFault::Recording { .. }) => {
                    self.leave_out(&row.id, &error);
                    is_any_left_out = true;
                }
                Err(error) => faults.push((row.id.clone(), error)),
            }
        }
        if answers.is_empty() && faults.is_empty() && is_any_left_out {
            return Ok(answers);
        }
        if answers.is_empty() {
            let [from, to] = interval;
            let nothing = || match from <= to {
                true => fault(format!(
                    "no telemetry was recorded between {from} and {to} s"
                )),
                false => fault(format!("the interval [{from}, {to}] ends before it begins")),
            };
            let first = faults.into_iter().next();
            return Err(first.map_or_else(nothing, |(_, error)| error));
        }
        for (id, error) in faults {
            self.leave_out(&id, &error);
        }
        Ok(answers)
    }

    /// States how many samples have no usable wrench, and are not counted as force.
    fn state_unusable(&mut self, channel: &str, unusable: UnusableWrenches) {
        let count = unusable.count();
        let remark = format!(
            "telemetry({channel}, …): the wrench of {count} samples is not usable by its wrench_quality, and is left out"
        );
        if count > 0 && !self.remarks.contains(&remark) {
            self.remarks.push(remark);
        }
    }

    fn leave_out(&mut self, id: &str, error: &QueryFault) {
        let remark = format!("episode {id} is left out: {error}");
        if !self.remarks.contains(&remark) {
            self.remarks.push(remark);
        }
    }

    /// Returns the parts of an episode's rounds in an interval [s since 1970].
    fn spans(
        &mut self,
        catalogue: &Catalogue,
        episode: &EpisodeRow,
        interval: [f64; 2],
    ) -> Result<Vec<Span>, QueryFault> {
        let mut spans = Vec::new();
        for round in 1..=episode.rounds.len() {
            spans.extend(self.span(catalogue, episode, round, interval)?);
        }
        Ok(spans)
    }

    fn span(
        &mut self,
        catalogue: &Catalogue,
        episode: &EpisodeRow,
        round: usize,
        [from, to]: [f64; 2],
    ) -> Result<Option<Span>, QueryFault> {
        let began = episode.rounds[round - 1];
        // A round ends where the next begins, so rounds outside the interval need not be opened.
        let ends = episode
            .rounds
            .get(round)
            .copied()
            .unwrap_or(episode.interval[1]);
        if began > to || ends < from {
            return Ok(None);
        }
        let telemetry = self.telemetry(episode, round)?;
        let Some([first, last]) = telemetry.interval() else {
            return Ok(None);
        };
        let (from, to) = (
            (from - began).max(first),
            (to - began + SAME_TIME).min(last),
        );
        if from > to {
            return Ok(None);
        }
        Ok(Some(Span {
            robot: self.robot(&episode.id)?,
            tool: tool_of(catalogue, episode),
            bias: bias_of(catalogue, episode, round, &telemetry)?,
            telemetry,
            began,
            from,
            to,
        }))
    }

    fn telemetry(
        &mut self,
        episode: &EpisodeRow,
        round: usize,
    ) -> Result<Rc<Telemetry>, QueryFault> {
        let key = (episode.id.clone(), round);
        if let Some(telemetry) = self.rounds.get(&key) {
            return telemetry.clone();
        }
        let Some(memory) = &self.memory else {
            return Err(fault("the memory has no telemetry".to_owned()));
        };
        let opened = memory.episode(&episode.id);
        let telemetry = opened.and_then(|opened| {
            if opened.has_telemetry(round)? {
                opened.telemetry(round)
            } else {
                Err(opened.without_telemetry(round))
            }
        });
        let telemetry = telemetry.map(Rc::new).map_err(unread);
        self.rounds.insert(key, telemetry.clone());
        telemetry
    }

    /// Returns the robot of an episode; `None` for an imported log.
    fn robot(&mut self, episode: &str) -> Result<Option<Rc<RobotModel>>, QueryFault> {
        if let Some(robot) = self.robots.get(episode) {
            return Ok(robot.clone());
        }
        let Some(memory) = &self.memory else {
            return Ok(None);
        };
        let opened = memory.episode(episode).map_err(unread)?;
        let robot = if opened.has_robot() {
            let bytes = opened.attachment(ROBOT_FILE).map_err(unread)?;
            let text = String::from_utf8(bytes).map_err(unread)?;
            let robot = RobotModel::from_urdf(ROBOT_FILE, &text, &mut |mesh| {
                // Frames need no meshes.
                Err(format!("{mesh}: meshes are not loaded"))
            });
            Some(Rc::new(robot.map_err(unread)?))
        } else {
            None
        };
        self.robots.insert(episode.to_owned(), robot.clone());
        Ok(robot)
    }
}

/// Wraps a fault of an episode.
fn unread(what: impl Display) -> QueryFault {
    QueryFault::Recording {
        what: what.to_string(),
    }
}

/// Returns the name of an episode's tool; `tool` if the episode does not state it.
pub(crate) fn tool_of(catalogue: &Catalogue, row: &EpisodeRow) -> String {
    let tools = catalogue.relations("semco:usesTool");
    let mut nodes = (row.first..row.first + row.len).flat_map(|id| entries(tools, id));
    match nodes.next() {
        Some((_, CatalogueNode::Shared(number))) => {
            local(&catalogue.shared_individuals()[*number as usize]).to_owned()
        }
        _ => "tool".to_owned(),
    }
}

/// Returns the bias of the force in a round, along the normal of the believed surface, in the world [N]; zero if the
/// interpretation found none, or if the episode does not hold the surface's pose.
fn bias_of(
    catalogue: &Catalogue,
    row: &EpisodeRow,
    round: usize,
    telemetry: &Telemetry,
) -> Result<Vector3, QueryFault> {
    let numbers = catalogue.numbers("semco:round");
    let nodes = (row.first..row.first + row.len)
        .filter(|&id| (entries(numbers, id).iter()).any(|(_, number)| *number == round as f64));
    let biases = nodes.flat_map(|id| entries(catalogue.numbers("semco:forceBias"), id));
    let Some((_, bias)) = biases.into_iter().next() else {
        return Ok(Vector3::zeros());
    };
    let scene = scene_of(telemetry).map_err(frame_fault)?;
    Ok(scene.map_or_else(Vector3::zeros, |scene| {
        let world_from_surface: Pose = scene.world_from_surface.into();
        world_from_surface.rotation * Vector3::z() * *bias
    }))
}

fn local(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}

fn frame_fault(error: FrameError) -> QueryFault {
    match error {
        FrameError::Unknown { .. }
        | FrameError::Time { .. }
        | FrameError::Gap { .. }
        | FrameError::Sampling { .. } => fault(error),
        FrameError::Scene { .. }
        | FrameError::Joint { .. }
        | FrameError::Empty { .. }
        | FrameError::Robot(_)
        | FrameError::Telemetry(_) => unread(error),
    }
}

fn fault(what: impl Display) -> QueryFault {
    QueryFault::Telemetry {
        what: what.to_string(),
    }
}

fn number(term: &Term) -> Result<f64, QueryFault> {
    term.as_number()
        .filter(|number| number.is_finite())
        .ok_or_else(|| fault(format!("{term} is not a time")))
}

fn sampling_of(term: &Term) -> Result<Sampling, QueryFault> {
    match term.parts() {
        Some(("dt", [period])) if period.as_number().is_some_and(|period| period > 0.0) => {
            Ok(Sampling::Every(period.as_number().unwrap_or_default()))
        }
        Some(("num_samples", [Term::Integer(count)])) if *count > 0 => Ok(Sampling::Count(
            usize::try_from(*count).unwrap_or(usize::MAX),
        )),
        _ => Err(fault(format!(
            "{term} is not a sampling; expected dt(Seconds) or num_samples(N), both positive"
        ))),
    }
}

/// Returns times [s since 1970] and poses of a thing in the world.
fn trajectory(
    spans: &[Span],
    thing: &str,
    sampling: Sampling,
) -> Result<Vec<(f64, Term)>, QueryFault> {
    let mut found = Vec::new();
    for span in spans {
        let poses = poses(span, thing, sampling)?;
        found.extend(poses.iter().map(|at| (span.began + at.time, pose(at))));
        if found.len() > MAX_POSES {
            return Err(fault(format!(
                "the trajectory has more than {MAX_POSES} poses; ask for a longer dt"
            )));
        }
    }
    Ok(found)
}

/// Computes max, min, mean or root mean square of values, each with the time that it represents [s].
fn statistic_of(values: &[(f64, f64)], statistic: &str) -> Result<f64, QueryFault> {
    let Some((first, _)) = values.first() else {
        return Err(fault("the interval holds no sample".to_owned()));
    };
    // Over time, so that it does not depend on the rate; a single moment lasts no time, and its samples count alike.
    let whole: f64 = values.iter().map(|(_, time)| time).sum();
    let mean = |of: fn(f64) -> f64| {
        // x₀ + Σ (x − x₀) t / Σ t is exact for equal values.
        let start = of(*first);
        let weighted = values.iter().map(|(value, time)| match whole > 0.0 {
            true => (of(*value) - start) * time / whole,
            false => (of(*value) - start) / values.len() as f64,
        });
        start + weighted.sum::<f64>()
    };
    let all = values.iter().map(|(value, _)| *value);
    match statistic {
        "max" => Ok(all.fold(f64::NEG_INFINITY, f64::max)),
        "min" => Ok(all.fold(f64::INFINITY, f64::min)),
        "mean" => Ok(mean(|value| value)),
        "rms" => Ok(mean(|value| value * value).sqrt()),
        other => Err(fault(format!(
            "{other} is not a statistic; expected max, min, mean or rms"
        ))),
    }
}

/// Returns poses of a thing; for tool and surface, also without a robot.
fn poses(span: &Span, thing: &str, sampling: Sampling) -> Result<Vec<PoseAt>, QueryFault> {
    let frames = match &span.robot {
        Some(robot) => Frames::new(robot, &span.telemetry),
        None => Frames::from_log(&span.telemetry, &span.tool),
    };
    let frames = frames.map_err(frame_fault)?;
    let found = match sampling {
        Sampling::Count(1) => frames.pose(local(thing), span.from).map(|pose| vec![pose]),
        _ => frames.trajectory(local(thing), [span.from, span.to], sampling),
    };
    found.map_err(frame_fault)
}

/// [Frame, [X, Y, Z], [Qx, Qy, Qz, Qw]]
fn pose(at: &PoseAt) -> Term {
    let pose = &at.world_from_frame;
    let numbers = |numbers: &[f64]| Term::List(numbers.iter().copied().map(Term::Float).collect());
    Term::List(vec![
        Term::atom("world"),
        numbers(pose.translation.vector.as_slice()),
        numbers(pose.rotation.coords.as_slice()),
    ])
}

/// Returns the time that each row represents within the span [s]: half of the time since the previous row, and half of
/// the time to the next one, each of at most [`LONGEST_REACH`].
fn compute_durations(span: &Span, rows: &Range<usize>) -> Result<Vec<f64>, QueryFault> {
    let telemetry = &span.telemetry;
    let around = rows.start.saturating_sub(1)..(rows.end + 1).min(telemetry.rows());
    let times = telemetry.times(around.clone()).map_err(unread)?;
    let represented = rows.clone().map(|row| {
        let place = row - around.start;
        let time = times[place];
        let before = place.checked_sub(1).map_or(time, |k| times[k]);
        let after = times.get(place + 1).copied().unwrap_or(time);
        let begin = (0.5 * (before + time)).max(time - LONGEST_REACH);
        let end = (0.5 * (time + after)).min(time + LONGEST_REACH);
        (end.min(span.to) - begin.max(span.from)).max(0.0)
    });
    Ok(represented.collect())
}

/// Returns the values of a channel, each with the time that it represents [s], and counts the samples that are left out
/// because their wrench is not usable.
fn channel_values(
    span: &Span,
    channel: &str,
    unusable: &mut UnusableWrenches,
) -> Result<Vec<(f64, f64)>, QueryFault> {
    let telemetry = &span.telemetry;
    let rows = telemetry
        .rows_between([span.from, span.to])
        .map_err(unread)?;
    let column = |name: &str| telemetry.values(name, rows.clone()).map_err(unread);
    let timed = |values: Vec<f64>| -> Result<Vec<(f64, f64)>, QueryFault> {
        let times = compute_durations(span, &rows)?;
        Ok(values.into_iter().zip(times).collect())
    };
    // The force on the tool, as strokes and contacts state it: without the bias of the sensor.
    let forces = || -> Result<Vec<Vector3>, QueryFault> {
        let [x, y, z] = ["external/fx", "external/fy", "external/fz"].map(column);
        let axes = x?.into_iter().zip(y?).zip(z?);
        Ok(axes
            .map(|((x, y), z)| Vector3::new(x, y, z) - span.bias)
            .collect())
    };
    let mut usable = |forces: Vec<f64>| -> Result<Vec<(f64, f64)>, QueryFault> {
        let qualities = telemetry.wrench_qualities(rows.clone()).map_err(unread)?;
        for quality in &qualities {
            unusable.add(*quality);
        }
        let forces = timed(forces)?.into_iter().zip(qualities);
        let forces = forces.filter(|(_, quality)| quality.is_usable());
        Ok(forces.map(|(force, _)| force).collect())
    };
    match channel {
        "force" => usable(forces()?.iter().map(Vector3::norm).collect()),
        "vertical_force" => usable(forces()?.iter().map(|force| force.z).collect()),
        "speed" => {
            let times = telemetry.times(rows.clone()).map_err(unread)?;
            let [x, y, z] = ["measured/x", "measured/y", "measured/z"].map(column);
            let (x, y, z) = (x?, y?, z?);
            let steps = (1..times.len()).map(|k| {
                let distance = (x[k] - x[k - 1])
                    .hypot(y[k] - y[k - 1])
                    .hypot(z[k] - z[k - 1]);
                let step = times[k] - times[k - 1];
                (
                    distance / step.max(f64::MIN_POSITIVE),
                    step.min(2.0 * LONGEST_REACH),
                )
            });
            Ok(steps.collect())
        }
        joint if telemetry.joints().iter().any(|known| known == joint) => {
            timed(column(&format!("position/{joint}"))?)
        }
        name => {
            let columns = telemetry.columns();
            if columns.contains(&name) {
                return timed(column(name)?);
            }
            let known = ["force", "vertical_force", "speed"]
                .into_iter()
                .chain(columns);
            let error = wisch::source_location::UnknownName::new("channel", name, known);
            Err(QueryFault::Telemetry {
                what: error.to_string(),
            })
        }
    }
}
