//! The controllers of the fake robot: a trajectory controller with speed scaling, and force mode.

use crate::messages::{PointMessage, TrajectoryGoal};
use crate::motion::quintic;
use wisch::follow::TrajectorySample;

/// Time over which the press force rises and falls [s].
const PRESS_RAMP: f64 = 0.2;
/// Speed at which `move` displaces a joint [rad/s].
const MOVE_SPEED: f64 = 0.5;
/// Deceleration of each joint when its goal ends early [rad/s² or m/s²].
const BRAKING: f64 = 5.0;

/// A trajectory that the controller follows.
struct Followed {
    /// State at the beginning and at each point: time [s], and position, velocity, acceleration of each joint.
    knots: Vec<(f64, Vec<[f64; 3]>)>,
    time: f64,
}

/// The controllers.
pub(super) struct FakeArm {
    names: Vec<String>,
    setpoint: TrajectorySample,
    measured: Vec<f64>,
    trajectory: Option<Followed>,
    /// Time on the present or last trajectory [s].
    trajectory_time: f64,
    scaling: f64,
    /// Force at which the simulated controller presses fully [N].
    full_force: f64,
    /// Present and wanted share of the press.
    press: [f64; 2],
    /// Joints that `move` displaces, with what is left, and how far they are from the trajectory by that [rad].
    displaced: Vec<f64>,
    aside: Vec<f64>,
    pub safety_mode: u8,
    pub program_runs: bool,
    pub is_rejecting: bool,
}

impl FakeArm {
    /// Returns the controllers of an arm at rest. `full_force`: press force of the task [N].
    pub fn new(names: Vec<String>, positions: &[f64], full_force: f64) -> Self {
        Self {
            displaced: vec![0.0; names.len()],
            aside: vec![0.0; names.len()],
            names,
            setpoint: TrajectorySample::from_positions(positions),
            measured: positions.to_vec(),
            trajectory: None,
            trajectory_time: 0.0,
            scaling: 1.0,
            full_force,
            press: [0.0; 2],
            safety_mode: 1,
            program_runs: true,
            is_rejecting: false,
        }
    }

    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Share of the commanded speed at which the controller runs; 0 in a stop.
    pub fn scaling(&self) -> f64 {
        if self.safety_mode == 1 {
            self.scaling
        } else {
            0.0
        }
    }

    pub fn set_scaling(&mut self, share: f64) {
        self.scaling = share;
    }

    /// Time on the present or last trajectory [s].
    pub const fn trajectory_time(&self) -> f64 {
        self.trajectory_time
    }

    /// Whether a trajectory is being followed.
    pub const fn is_busy(&self) -> bool {
        self.trajectory.is_some()
    }

    pub fn measure(&mut self, positions: &[f64]) {
        self.measured.clear();
        self.measured.extend_from_slice(positions);
    }

    /// Displaces a joint, as a person does who moves the arm.
    pub fn displace(&mut self, joint: usize, distance: f64) {
        if let Some(left) = self.displaced.get_mut(joint) {
            *left = distance;
        }
    }

    /// Advances by one period [s]. Returns the setpoint, and the share of the press.
    pub fn advance(&mut self, period: f64) -> (TrajectorySample, f64) {
        let scaling = self.scaling();
        if let Some(trajectory) = &mut self.trajectory {
            trajectory.time += period * scaling;
            self.trajectory_time = trajectory.time;
            let states = sample(&trajectory.knots, trajectory.time);
            for (i, state) in states.into_iter().enumerate() {
                self.setpoint.q[i] = state[0] + self.aside[i];
                self.setpoint.qd[i] = state[1] * scaling;
                self.setpoint.qdd[i] = state[2] * scaling * scaling;
            }
        } else {
            self.brake(period);
        }
        for (i, left) in self.displaced.iter_mut().enumerate() {
            let step = left.clamp(-MOVE_SPEED * period, MOVE_SPEED * period);
            self.setpoint.q[i] += step;
            self.aside[i] += step;
            *left -= step;
        }
        let [share, wanted] = self.press;
        let step = period / PRESS_RAMP;
        self.press[0] = share + (wanted - share).clamp(-step, step);
        (self.setpoint.clone(), self.press[0])
    }

    /// Whether the trajectory has been followed to its end; it is removed then.
    pub fn take_completed(&mut self) -> bool {
        let is_over = self.trajectory.as_ref().is_some_and(|trajectory| {
            let end = trajectory.knots.last().map_or(0.0, |(time, _)| *time);
            trajectory.time >= end
        });
        if is_over {
            self.hold();
        }
        is_over
    }

    /// Ends the trajectory, brakes, and stays.
    pub fn hold(&mut self) {
        self.trajectory = None;
    }

    /// Slows the setpoint down for one period [s]. Robots brake when a goal ends early: the force of the compliant arm is
    /// limited, so that it would swing for seconds if the setpoint stood still at once.
    fn brake(&mut self, period: f64) {
        let TrajectorySample { q, qd, qdd, .. } = &mut self.setpoint;
        for ((q, qd), qdd) in q.iter_mut().zip(qd).zip(qdd) {
            let slowed = qd.clamp(-BRAKING * period, BRAKING * period);
            *q += *qd * period;
            *qd -= slowed;
            *qdd = -slowed / period;
        }
    }

    /// Presses with a force [N], or not at all.
    pub fn press_with(&mut self, force: f64) {
        self.press[1] = (force / self.full_force).clamp(0.0, 1.5);
    }

    /// Begins to follow a trajectory from the measured positions.
    ///
    /// # Errors
    /// Why it is rejected.
    pub fn begin(&mut self, goal: &TrajectoryGoal) -> Result<(), String> {
        if self.is_rejecting || self.safety_mode != 1 || !self.program_runs {
            return Err("the robot may not move".to_owned());
        }
        if self.is_busy() {
            return Err("a trajectory is already being followed".to_owned());
        }
        let message = &goal.trajectory;
        if message.header.stamp.seconds() != 0.0 {
            return Err("the stamp is not 0".to_owned());
        }
        let index = |name: &String| message.joint_names.iter().position(|given| given == name);
        let order: Option<Vec<usize>> = self.names.iter().map(index).collect();
        let order = order.ok_or("a joint is missing")?;
        let first = self.measured.iter().map(|q| [*q, 0.0, 0.0]).collect();
        let mut knots: Vec<(f64, Vec<[f64; 3]>)> = vec![(0.0, first)];
        for point in &message.points {
            let time = point.time_from_start.seconds();
            if time <= knots[knots.len() - 1].0 {
                return Err(format!(
                    "the point at {time} s is not later than the one before"
                ));
            }
            knots.push((time, states(point, &order)?));
        }
        if knots.len() < 2 {
            return Err("there are no points".to_owned());
        }
        // The trajectory begins at the measured positions.
        self.aside.fill(0.0);
        self.trajectory = Some(Followed { knots, time: 0.0 });
        self.trajectory_time = 0.0;
        Ok(())
    }
}

/// The state of each joint at a point.
fn states(point: &PointMessage, order: &[usize]) -> Result<Vec<[f64; 3]>, String> {
    let lists = [&point.positions, &point.velocities, &point.accelerations];
    order
        .iter()
        .map(|&i| {
            let mut state = [0.0; 3];
            for (value, list) in state.iter_mut().zip(lists) {
                *value = *list.get(i).ok_or("a point lacks a joint")?;
            }
            Ok(state)
        })
        .collect()
}

/// The state of each joint at a time [s]; after the end, the last one.
fn sample(knots: &[(f64, Vec<[f64; 3]>)], time: f64) -> Vec<[f64; 3]> {
    let next = knots.partition_point(|(at, _)| *at <= time);
    let Some((to_time, to)) = knots.get(next) else {
        return knots
            .last()
            .map_or_else(Vec::new, |(_, states)| states.clone());
    };
    let (from_time, from) = &knots[next.saturating_sub(1)];
    let span = to_time - from_time;
    let share = ((time - from_time) / span).clamp(0.0, 1.0);
    (from.iter().zip(to))
        .map(|(from, to)| {
            let scale = |state: &[f64; 3]| [state[0], state[1] * span, state[2] * span * span];
            let [q, qd, qdd] = quintic(&[scale(from), scale(to)], share);
            [q, qd / span, qdd / (span * span)]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::{Stamp, TrajectoryMessage};

    fn goal(names: &[&str], point: [f64; 2]) -> TrajectoryGoal {
        TrajectoryGoal {
            trajectory: TrajectoryMessage {
                joint_names: names.iter().map(|name| (*name).to_owned()).collect(),
                points: vec![PointMessage {
                    positions: point.to_vec(),
                    velocities: vec![0.0; 2],
                    accelerations: vec![0.0; 2],
                    effort: Vec::new(),
                    time_from_start: Stamp::from_seconds(1.0),
                }],
                ..TrajectoryMessage::default()
            },
            ..TrajectoryGoal::default()
        }
    }

    fn arm() -> FakeArm {
        FakeArm::new(vec!["a".to_owned(), "b".to_owned()], &[0.0, 0.0], 5.0)
    }

    #[test]
    fn a_goal_that_ends_early_is_braked_to_rest() {
        let mut arm = arm();
        arm.begin(&goal(&["a", "b"], [2.0, 1.0])).unwrap();
        for _ in 0..500 {
            arm.advance(0.001);
        }
        let speed = arm.setpoint.qd[0];
        assert!(speed > 1.0, "{speed}");
        arm.hold();
        let (setpoint, _) = arm.advance(0.001);
        assert!((setpoint.qdd[0] + BRAKING).abs() < 1e-9 && setpoint.qd[0] < speed);
        let begin = setpoint.q[0];
        for _ in 0..1000 {
            arm.advance(0.001);
        }
        assert_eq!((arm.setpoint.qd[0], arm.setpoint.qdd[0]), (0.0, 0.0));
        // v²/2a
        let way = arm.setpoint.q[0] - begin;
        assert!(
            (way - speed * speed / (2.0 * BRAKING)).abs() < 0.01,
            "{way}"
        );
    }

    #[test]
    fn a_trajectory_is_followed_by_name_and_at_the_scaled_speed() {
        let mut arm = arm();
        arm.begin(&goal(&["b", "a"], [2.0, 1.0])).unwrap();
        arm.set_scaling(0.5);
        for _ in 0..1000 {
            arm.advance(0.001);
        }
        assert!((arm.trajectory_time() - 0.5).abs() < 1e-9);
        assert!((arm.setpoint.q[0] - 0.5).abs() < 1e-6);
        assert!(!arm.take_completed());
        for _ in 0..1001 {
            arm.advance(0.001);
        }
        assert!(arm.take_completed());
        assert_eq!(arm.setpoint.q, [1.0, 2.0]);
    }

    #[test]
    fn a_stopped_robot_rejects_goals_and_a_paused_one_rests() {
        let mut arm = arm();
        arm.safety_mode = 3;
        assert!(arm.begin(&goal(&["a", "b"], [1.0, 1.0])).is_err());
        arm.safety_mode = 1;
        arm.begin(&goal(&["a", "b"], [1.0, 1.0])).unwrap();
        arm.set_scaling(0.0);
        arm.advance(0.5);
        assert_eq!(arm.setpoint.q, [0.0, 0.0]);
    }
}
