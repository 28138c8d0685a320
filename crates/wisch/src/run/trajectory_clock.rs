//! Trajectory time from the reported state of a robot, which may run slower than planned, or pause.

use super::MotionOrder;
use crate::geometry::{Point3, Pose};

/// Period of the path points with which a measured state is compared [s].
const PERIOD: f64 = 0.01;
/// Fastest progress that is followed, over the planned speed [1].
const FASTEST: f64 = 2.0;
/// Time over which residuals are averaged [s].
const MEMORY: f64 = 1.0;
/// A residual below this is no evidence against the clock [rad or m].
const SMALL: f64 = 0.005;
/// A residual above this refutes the clock [rad or m].
const LARGE: f64 = 0.05;
/// Factor between the squared residuals that decides for the other hypothesis [1].
const CLEARLY: f64 = 4.0;
/// Weight of a rotation against a translation [m/rad].
const METRES_PER_RADIAN: f64 = 0.2;
/// A later place has to be nearer by more than this share of the distance [1].
const NEARER: f64 = 1e-9;

/// The trajectory time that a robot has reached, estimated from the states that it reports.
///
/// Two hypotheses are compared. In the first, trajectory time is the time of the sample: the robot
/// keeps the planned times, even if a person pushes it away. In the second, the robot follows the
/// path at another speed. The second hypothesis is used only if it explains the reported states
/// clearly better.
#[derive(Debug)]
pub struct TrajectoryClock {
    duration: f64,
    /// Planned positions of all joints, every [`PERIOD`]; empty where the robot reports none.
    joints: Vec<Vec<f64>>,
    /// Planned poses of the tool, as [`coordinates`].
    tool: Vec<Vec<f64>>,
    /// Time of the last sample [s].
    time: Option<f64>,
    /// Trajectory time by the path hypothesis [s].
    along: f64,
    /// Mean squared residuals of the two hypotheses [rad² or m²].
    by_clock: f64,
    by_path: f64,
    keeps_time: bool,
    /// Trajectory time that the robot itself reported last [s].
    reported: Option<f64>,
    /// Largest trajectory time so far [s].
    reached: f64,
}

/// A reported trajectory time that is earlier than the last reported one.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "trajectory time {now} s is earlier than the last reported time, {before} s; expected times that never decrease"
)]
pub struct TrajectoryTimeError {
    /// The reported time \[s\].
    pub now: f64,
    /// The time reported before \[s\].
    pub before: f64,
}

impl TrajectoryClock {
    /// Returns the clock of a motion that has not begun.
    pub fn new(order: &MotionOrder<'_>) -> Self {
        let setpoints = || order.setpoints(PERIOD);
        Self {
            duration: order.followed.duration(),
            joints: setpoints().map(|at| at.positions).collect(),
            tool: setpoints()
                .map(|at| coordinates(&at.world_from_tool))
                .collect(),
            time: None,
            along: 0.0,
            by_clock: 0.0,
            by_path: 0.0,
            keeps_time: true,
            reported: None,
            reached: 0.0,
        }
    }

    /// Updates the clock with the measurements at `time` and returns the trajectory time \[s\], from 0 to the
    /// motion's duration.
    ///
    /// `reported`: the trajectory time, if the robot knows it \[s\]. `positions`: all n joints, or empty where
    /// they are not measured; then the tool's pose is used.
    ///
    /// # Errors
    /// If the reported time is earlier than the last reported time.
    pub fn advance(
        &mut self,
        time: f64,
        reported: Option<f64>,
        positions: &[f64],
        world_from_tool: &Pose,
    ) -> Result<f64, TrajectoryTimeError> {
        let at = match reported {
            Some(now) => {
                if let Some(before) = self.reported.filter(|before| now < *before) {
                    return Err(TrajectoryTimeError { now, before });
                }
                self.reported = Some(now);
                self.along = now.clamp(0.0, self.duration);
                self.along
            }
            None => self.estimate(time, positions, world_from_tool),
        };
        self.time = Some(time);
        self.reached = self.reached.max(at);
        Ok(at)
    }

    /// The largest trajectory time so far \[s\].
    pub const fn time_reached(&self) -> f64 {
        self.reached
    }

    /// The planned position of the tool in the world at a trajectory time \[s\], to 10 ms.
    pub fn tool_position(&self, time: f64) -> Option<Point3> {
        let at = self.tool.get((time / PERIOD).round() as usize)?;
        Some(Point3::new(at[0], at[1], at[2]))
    }

    /// Estimates the trajectory time from the measured state, by the better of the two hypotheses [s].
    fn estimate(&mut self, time: f64, positions: &[f64], world_from_tool: &Pose) -> f64 {
        let by_clock = time.clamp(0.0, self.duration);
        let (state, path) = if positions.is_empty() {
            (coordinates(world_from_tool), &self.tool)
        } else {
            (positions.to_vec(), &self.joints)
        };
        let step = self.time.map_or(time.max(0.0), |before| time - before);
        let ahead = (FASTEST * step).max(2.0 * PERIOD);
        let (along, path_residual) = nearest(path, &state, [self.along, self.along + ahead]);
        let (_, clock_residual) = nearest(path, &state, [by_clock; 2]);
        // Exponential average of the squared residuals with the time constant MEMORY.
        let weight = 1.0 - libm::exp(-step / MEMORY);
        let average = |mean: &mut f64, residual: f64| {
            *mean += weight * (residual.min(1.0).powi(2) - *mean);
        };
        average(&mut self.by_clock, clock_residual);
        average(&mut self.by_path, path_residual);
        self.along = along;
        let small = SMALL * SMALL;
        if self.by_clock <= small.max(CLEARLY * self.by_path) && self.by_clock < LARGE * LARGE {
            self.keeps_time = true;
        } else if self.by_clock > CLEARLY * self.by_path {
            self.keeps_time = false;
        }
        // A person held the robot while its clock ran on.
        if self.keeps_time && self.by_path > CLEARLY * self.by_clock + small {
            self.along = by_clock;
            self.by_path = self.by_clock;
        }
        if self.keeps_time {
            by_clock
        } else {
            self.along
        }
    }
}

/// Returns a pose as numbers whose distances are metres: its origin and two of its axes, scaled.
fn coordinates(pose: &Pose) -> Vec<f64> {
    let turn = pose.rotation.to_rotation_matrix();
    let axes = turn.matrix();
    let scaled = axes.iter().take(6).map(|x| METRES_PER_RADIAN * x);
    pose.translation
        .vector
        .iter()
        .copied()
        .chain(scaled)
        .collect()
}

/// Returns the time within an interval at which a path is nearest to a state [s], and that distance.
fn nearest(path: &[Vec<f64>], state: &[f64], [from, to]: [f64; 2]) -> (f64, f64) {
    let end = path.len().saturating_sub(1) as f64;
    let [from, to] = [from, to].map(|time| (time / PERIOD).clamp(0.0, end));
    let mut best = (from, f64::INFINITY);
    let mut begin = from;
    loop {
        let i = begin.floor();
        let stop = (i + 1.0).min(to).max(begin);
        let (share, distance) = on_segment(path, i as usize, [begin - i, stop - i], state);
        if distance < best.1 * (1.0 - NEARER) {
            best = (i + share, distance);
        }
        if stop >= to {
            break;
        }
        begin = stop;
    }
    (best.0 * PERIOD, best.1)
}

/// Returns the share of a segment within an interval at which it is nearest to a state, and that distance.
fn on_segment(path: &[Vec<f64>], i: usize, [from, to]: [f64; 2], state: &[f64]) -> (f64, f64) {
    let Some(a) = path.get(i) else {
        return (from, f64::INFINITY);
    };
    let b = path.get(i + 1).unwrap_or(a);
    let (mut dot, mut square) = (0.0, 0.0);
    for ((a, b), x) in a.iter().zip(b).zip(state) {
        dot += (x - a) * (b - a);
        square += (b - a) * (b - a);
    }
    let share = if square > 0.0 { dot / square } else { from };
    let share = share.clamp(from, to);
    let off = a.iter().zip(b).zip(state).map(|((a, b), x)| {
        let at = a + share * (b - a);
        (x - at) * (x - at)
    });
    (share, off.sum::<f64>().sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A joint that moves to 1 and back five times, each way in 2 s, then rests for 1 s.
    fn clock() -> TrajectoryClock {
        let position = |time: f64| {
            let phase = (time.min(20.0) / 2.0).rem_euclid(2.0);
            if phase <= 1.0 { phase } else { 2.0 - phase }
        };
        let path: Vec<Vec<f64>> = (0..=2100)
            .map(|k| vec![position(f64::from(k) * PERIOD), 0.0])
            .collect();
        TrajectoryClock {
            duration: 21.0,
            tool: Vec::new(),
            joints: path,
            time: None,
            along: 0.0,
            by_clock: 0.0,
            by_path: 0.0,
            keeps_time: true,
            reported: None,
            reached: 0.0,
        }
    }

    /// Returns the largest error of the trajectory time [s], and the time of the last sample at which it
    /// exceeds 50 ms.
    fn worst(
        trajectory_time: impl Fn(f64) -> f64,
        push: impl Fn(f64) -> f64,
        end: f64,
    ) -> (f64, f64) {
        let mut clock = clock();
        let (mut worst, mut last) = (0.0_f64, 0.0);
        let mut time = 0.0;
        while time < end {
            let wanted = trajectory_time(time).min(21.0);
            let i = (wanted / PERIOD).round() as usize;
            let (wanted, mut at) = (i as f64 * PERIOD, clock.joints[i].clone());
            at[1] += push(time);
            let found = clock
                .advance(time, None, &at, &Pose::identity())
                .expect("nothing is reported");
            let off = (found - wanted).abs();
            worst = worst.max(off);
            if off > 0.05 {
                last = time;
            }
            time += PERIOD;
        }
        (worst, last)
    }

    #[test]
    fn a_robot_that_keeps_the_times_is_where_its_clock_says_even_if_pushed() {
        assert!(worst(|t| t, |_| 0.0, 20.0).0 < 1e-9);
        let pushed = |t: f64| if (5.0..9.0).contains(&t) { 0.3 } else { 0.0 };
        assert!(worst(|t| t, pushed, 20.0).0 < 1e-9);
    }

    #[test]
    fn a_slow_robot_and_one_that_pauses_are_followed_along_the_path() {
        for speed in [0.25, 0.5, 0.8, 0.97] {
            let (off, last) = worst(|t| speed * t, |_| 0.0, 20.0 / speed);
            assert!(off < 0.1 && last < 2.0, "{speed}: {off} s, {last} s");
        }
        let pauses = |t: f64| if t < 5.0 { t } else { (t - 3.0).max(5.0) };
        let (off, last) = worst(pauses, |_| 0.0, 23.0);
        assert!(off < 0.1 && last < 5.5, "{off} s until {last} s");
    }

    #[test]
    fn a_reported_trajectory_time_is_taken_and_does_not_go_back() {
        let mut clock = clock();
        let mut at =
            |time, reported| clock.advance(time, Some(reported), &[9.0, 9.0], &Pose::identity());
        assert_eq!(at(1.0, 0.4), Ok(0.4));
        assert_eq!(at(2.0, 99.0), Ok(21.0));
        let error = TrajectoryTimeError {
            now: 98.0,
            before: 99.0,
        };
        assert_eq!(at(3.0, 98.0), Err(error));
    }
}
