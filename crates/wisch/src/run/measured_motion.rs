//! The measurements of one motion: whether the robot moved as ordered, and where it ended.

use super::pose_agreement::PoseAgreement;
use super::{Ending, Execution, ExecutorError, PlannedRound, RunError, TelemetrySample};
use crate::follow::{Followed, Workcell};
use crate::geometry::{Point3, Vector3};
use crate::interpret::Doubt;
use std::sync::Arc;

/// Least time over which movements are compared, and speeds are measured [s].
const WINDOW: f64 = 0.5;
/// Least time over which the speed at the end is measured [s].
const SPEED_WINDOW: f64 = 0.05;
/// Least ordered movement in a window at which a robot that stands still shows [rad or m].
const ORDERED: f64 = 0.03;
/// Largest measured movement of a robot that stands still: over the ordered one \[1\], and [rad or m].
const STILL: [f64; 2] = [0.02, 0.002];
/// Least time of standing still that is stated [s], and least share of the ordered motion \[1\].
const LEAST_STILL: [f64; 2] = [1.0, 0.2];
/// Least period at which the ordered path of the tool is compared [s], and largest number of its points.
const PATH_PERIOD: f64 = 0.05;
const PATH_POINTS: f64 = 2_000.0;
/// Distance from every point of the ordered path above which the tool is off its path [m].
const OFF_PATH: f64 = 0.1;
/// Time in which a robot that was stopped moves on at its last speed, at most [s]: twice that time in which it brakes evenly.
const BRAKING: f64 = 0.3;
/// Largest distance between the last measured position of the tool and the stated end of a motion [m]: errors of a tracker
/// that measures the tool.
const POSE_TOLERANCE: f64 = 0.1;

/// A measured state of the robot.
#[derive(Debug, Clone)]
struct MeasuredState {
    time: f64,
    /// Joint positions [rad or m], the last measured ones; empty if they are not measured.
    positions: Vec<f64>,
    /// Time at which they were measured [s].
    positions_time: f64,
    /// Position of the tool in the world [m].
    tool: Point3,
}

impl MeasuredState {
    /// Largest movement of a joint until another state [rad or m]; that of the tool [m] if the joints are not measured.
    fn movement_to(&self, other: &Self) -> f64 {
        if self.positions.is_empty() || other.positions.is_empty() {
            return (other.tool - self.tool).norm();
        }
        farthest(&self.positions, &other.positions).map_or(0.0, |(_, distance)| distance)
    }
}

/// The measurements of one motion so far, beside the contact forces.
pub(super) struct MeasuredMotion<'a> {
    planned: &'a PlannedRound,
    agreement: PoseAgreement<'a>,
    /// Period of the points of `path` and `off` [s].
    period: f64,
    /// Ordered positions of the tool in the world [m].
    path: Vec<Point3>,
    /// The last state, and two earlier ones at least [`SPEED_WINDOW`] apart: speeds are those since the earlier one.
    last: Option<MeasuredState>,
    earlier: [Option<MeasuredState>; 2],
    /// First state of the window in which the movement is compared.
    window: Option<MeasuredState>,
    /// Time for which the robot was ordered to move, and of this the time for which it stood still [s].
    ordered: f64,
    still: f64,
    /// Distances from the ordered path [m].
    off: Vec<f64>,
    /// Time from which on the next sample is compared with the path [s].
    next: f64,
}

impl<'a> MeasuredMotion<'a> {
    /// Returns the measurements of a motion that has not begun.
    pub fn new(planned: &'a PlannedRound) -> Self {
        let duration = planned.followed.duration();
        let period = PATH_PERIOD.max(duration / PATH_POINTS);
        let steps = (duration / period).ceil() as usize;
        let path = (0..=steps).filter_map(|k| tool_at(planned, k as f64 * period));
        Self {
            planned,
            period,
            agreement: PoseAgreement::new(&planned.cell),
            path: path.collect(),
            last: None,
            earlier: [None, None],
            window: None,
            ordered: 0.0,
            still: 0.0,
            off: Vec::new(),
            next: f64::NEG_INFINITY,
        }
    }

    /// Whether a sample has stated joint positions.
    pub fn has_positions(&self) -> bool {
        (self.last.as_ref()).is_some_and(|last| !last.positions.is_empty())
    }

    /// Takes a sample.
    pub fn take(&mut self, sample: &TelemetrySample<'_>) {
        self.agreement.add(sample);
        let mut state = MeasuredState {
            time: sample.time,
            positions: sample.positions.to_vec(),
            positions_time: sample.time,
            tool: Point3::from(sample.world_from_tool.translation.vector),
        };
        let is_fresh = !state.positions.is_empty() || !self.has_positions();
        if let (false, Some(last)) = (is_fresh, &self.last) {
            // Positions may have a lower rate than poses.
            state.positions.clone_from(&last.positions);
            state.positions_time = last.positions_time;
        }
        let is_due = |before: &Option<MeasuredState>, period: f64| {
            (before.as_ref()).is_none_or(|before| state.time - before.time >= period)
        };
        if is_due(&self.earlier[1], SPEED_WINDOW) {
            self.earlier.swap(0, 1);
            self.earlier[1] = Some(state.clone());
        }
        if state.time >= self.next {
            self.next = state.time + self.period;
            let distances = self.path.iter().map(|place| (place - state.tool).norm());
            self.off.extend(distances.min_by(f64::total_cmp));
        }
        if sample.status.is_paused {
            self.window = None;
        } else if is_fresh
            && is_due(&self.window, WINDOW)
            && let Some(before) = self.window.replace(state.clone())
        {
            self.compare_movement(&before, &state);
        }
        self.last = Some(state);
    }

    /// Compares the measured with the ordered movement between two states.
    fn compare_movement(&mut self, before: &MeasuredState, after: &MeasuredState) {
        let lasts = after.time - before.time;
        if lasts > 2.0 * WINDOW {
            // The samples have a gap.
            return;
        }
        let ordered = [before, after].map(|state| {
            let at = self.planned.followed.sample(state.time)?;
            Some(MeasuredState {
                time: state.time,
                positions_time: state.time,
                positions: match state.positions.is_empty() {
                    true => Vec::new(),
                    false => at.q,
                },
                tool: tool_at(self.planned, state.time)?,
            })
        });
        let [Some(from), Some(to)] = ordered else {
            return;
        };
        let (ordered, measured) = (from.movement_to(&to), before.movement_to(after));
        if ordered > ORDERED {
            self.ordered += lasts;
            if measured < STILL[1].min(STILL[0] * ordered) {
                self.still += lasts;
            }
        }
    }

    /// Returns the doubts about the motion: contradictory measurements, or a robot that did not move as ordered.
    pub fn list_doubts(&self) -> Vec<Doubt> {
        let mut off = self.off.clone();
        off.sort_by(f64::total_cmp);
        let middle = off.get(off.len() / 2).copied();
        let is_still = self.still >= LEAST_STILL[0].max(LEAST_STILL[1] * self.ordered);
        let still = is_still.then_some(Doubt::RobotStoodStill {
            time: self.still,
            ordered: self.ordered,
        });
        let off = middle.filter(|distance| *distance > OFF_PATH);
        let off = off.map(|distance| Doubt::RobotOffPath { distance });
        let doubts = [self.agreement.find_doubt(), still, off];
        doubts.into_iter().flatten().collect()
    }

    /// Returns the known data of a motion that ended with an error; `None` if nothing was measured.
    pub fn keep_execution(&self, executed: &Result<Execution, ExecutorError>) -> Option<Execution> {
        let (pauses, dropped_samples) = match executed {
            Ok(execution) => (&execution.pauses[..], execution.dropped_samples),
            Err(error) => (error.pauses(), error.dropped_samples()),
        };
        self.last.as_ref().map(|last| Execution {
            duration: last.time,
            ending: Ending::Stopped,
            positions: last.positions.clone(),
            pauses: pauses.to_vec(),
            dropped_samples,
        })
    }

    /// Returns where the motion ended: by the last sample, or by the end that the executor states if the samples have no
    /// joint positions; `None` if nothing states it.
    ///
    /// `tolerance`: largest distance of a joint at rest [rad or m].
    ///
    /// # Errors
    /// If the stated end is farther from the last sample than the robot can have moved since.
    pub fn find_end(
        &self,
        execution: &Execution,
        tolerance: f64,
    ) -> Result<Option<MeasuredEnd>, RunError> {
        let PlannedRound { followed, cell, .. } = self.planned;
        let is_complete = execution.ending == Ending::Complete;
        let braking = if is_complete { 0.0 } else { BRAKING };
        let stated = &execution.positions;
        let last = self.last.as_ref();
        let age_of = |time: f64| (execution.duration - time).max(0.0);
        let end = |positions: &[f64], speeds: &[f64], age: f64, by| {
            let fastest = top_speeds(followed);
            let allowed = speeds.iter().zip(&fastest);
            MeasuredEnd {
                round: self.planned.number,
                cell: Arc::clone(cell),
                by,
                positions: positions.to_vec(),
                allowed: allowed
                    .map(|(speed, fastest)| tolerance + braking * speed + age * fastest)
                    .collect(),
            }
        };
        if let Some(last) = last.filter(|last| !last.positions.is_empty()) {
            let age = age_of(last.positions_time);
            let end = end(&last.positions, &self.speeds(last), age, "the last sample");
            if !stated.is_empty() {
                end.check(stated, "the end of the motion")?;
            }
            return Ok(Some(end));
        }
        let planned = followed.sample(execution.duration);
        let at_end = match stated.is_empty() {
            false => Some(&stated[..]),
            true if is_complete => planned.as_ref().map(|at| &at.q[..]),
            true => None,
        };
        if let (Some(last), Some(q)) = (last, at_end)
            && let Some(tool) = tool_of(cell, q)
        {
            let moved = self.tool_speed(last) * braking + self.top_tool_speed() * age_of(last.time);
            let (distance, limit) = ((tool - last.tool).norm(), POSE_TOLERANCE + moved);
            if distance > limit || distance.is_nan() {
                let round = self.planned.number;
                return Err(RunError::EndsElsewhere {
                    round,
                    distance,
                    limit,
                });
            }
        }
        Ok(planned.filter(|_| !stated.is_empty()).map(|planned| {
            let speeds: Vec<f64> = planned.qd.iter().map(|speed| speed.abs()).collect();
            end(stated, &speeds, 0.0, "the end of the motion")
        }))
    }

    /// Speeds of the joints at the end, from the measured positions [rad/s or m/s].
    fn speeds(&self, last: &MeasuredState) -> Vec<f64> {
        let before = self.before(last);
        let speed = |(i, position): (usize, &f64)| {
            let before = before?;
            let moved = position - before.positions.get(i)?;
            let lasts = last.positions_time - before.positions_time;
            (lasts > 0.0).then(|| (moved / lasts).abs())
        };
        let speeds = last.positions.iter().enumerate().map(speed);
        speeds.map(|speed| speed.unwrap_or(0.0)).collect()
    }

    /// Speed of the tool at the end, from its measured poses [m/s].
    fn tool_speed(&self, last: &MeasuredState) -> f64 {
        let before = self.before(last);
        before.map_or(0.0, |before| {
            (last.tool - before.tool).norm() / (last.time - before.time)
        })
    }

    /// Largest ordered speed of the tool [m/s].
    fn top_tool_speed(&self) -> f64 {
        let steps = self.path.windows(2).map(|pair| (pair[1] - pair[0]).norm());
        steps.fold(0.0, f64::max) / self.period
    }

    /// A state shortly before the last one.
    fn before(&self, last: &MeasuredState) -> Option<&MeasuredState> {
        let mut earlier = self.earlier.iter().flatten();
        earlier.find(|before| before.time < last.time)
    }
}

/// Where a motion ended, by the measurements.
#[derive(Debug, Clone)]
pub(super) struct MeasuredEnd {
    round: usize,
    cell: Arc<Workcell>,
    /// The measurement, in words.
    by: &'static str,
    /// Joint positions, all n variables [rad or m].
    positions: Vec<f64>,
    /// Largest distance of each joint from them that the motion explains [rad or m].
    allowed: Vec<f64>,
}

impl MeasuredEnd {
    /// Joint positions at the end, all n variables [rad or m].
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// Checks that stated positions agree with the measured end. `message`: the statement, in words.
    pub fn check(&self, stated: &[f64], message: &'static str) -> Result<(), RunError> {
        let excess = |i: usize| (stated[i] - self.positions[i]).abs() - self.allowed[i];
        let count = stated.len().min(self.positions.len());
        let worst =
            (0..count.min(self.allowed.len())).max_by(|&i, &k| excess(i).total_cmp(&excess(k)));
        match worst {
            Some(i) if excess(i) > 0.0 || excess(i).is_nan() => {
                let joint = self.cell.robot().variable(i);
                Err(RunError::Whereabouts {
                    round: self.round,
                    joint: joint.name.clone(),
                    measured: self.positions[i],
                    by: self.by,
                    stated: stated[i],
                    message,
                    limit: self.allowed[i],
                    unit: joint.kind.unit(),
                })
            }
            _ => Ok(()),
        }
    }
}

/// Returns the joint with the largest distance, and this distance [rad or m].
fn farthest(one: &[f64], other: &[f64]) -> Option<(usize, f64)> {
    let distances = one.iter().zip(other).map(|(a, b)| (a - b).abs());
    distances.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Returns the largest ordered speed of each joint [rad/s or m/s].
fn top_speeds(followed: &Followed) -> Vec<f64> {
    let steps = (followed.duration() / PATH_PERIOD).ceil() as usize;
    let mut fastest: Vec<f64> = Vec::new();
    for k in 0..=steps {
        let Some(at) = followed.sample(k as f64 * PATH_PERIOD) else {
            break;
        };
        fastest.resize(at.qd.len(), 0.0);
        for (top, speed) in fastest.iter_mut().zip(&at.qd) {
            *top = top.max(speed.abs());
        }
    }
    fastest
}

/// Returns the ordered position of the tool in the world at a time \[s\].
fn tool_at(planned: &PlannedRound, time: f64) -> Option<Point3> {
    tool_of(&planned.cell, &planned.followed.sample(time)?.q)
}

/// Returns the position of the tool in the world for joint positions.
fn tool_of(cell: &Workcell, q: &[f64]) -> Option<Point3> {
    let kinematics = cell.robot().forward_kinematics(q).ok()?;
    let world_from_tool =
        cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
    let place: Vector3 = world_from_tool.translation.vector;
    Some(Point3::from(place))
}
