//! What is checked before the robot moves.

use super::Driver;
use crate::motion::{Part, WipingMotion, goal_bytes};
use crate::pace::GoalPace;
use crate::robot_file::ForceKind;
use nalgebra::Vector3;
use std::time::{Duration, Instant};
use wisch::geometry::Point3;

/// Largest joint velocity of a robot at rest [rad/s or m/s].
pub(super) const REST: f64 = 0.02;
/// Speeds may exceed a limit of the planner by this factor: the knots deviate a little from its trajectory.
const SPEED_ROUNDING: f64 = 1.05;
/// Rest after a switch of controllers, and the largest movement of a joint in that time [rad or m].
const SETTLE: Duration = Duration::from_millis(500);
const SETTLE_MOVEMENT: f64 = 2e-3;
/// Longest wait for a controller to become active.
const ACTIVE_TIMEOUT: Duration = Duration::from_secs(3);

impl Driver {
    /// Returns the names of the file's controllers that are inactive.
    ///
    /// # Errors
    /// If the controller manager does not answer within `limit`, or else within the usual time.
    pub(super) fn inactive_controllers(
        &self,
        limit: Option<Duration>,
    ) -> Result<Vec<String>, String> {
        let connection = &self.connection;
        let listed = match limit {
            Some(limit) => connection.manager.list_within(limit),
            None => connection.manager.list(),
        };
        let listed = listed.map_err(|error| error.to_string())?;
        let needed = connection.file.motion.controllers.iter();
        let is_active = |name: &String| {
            let found = listed.iter().find(|controller| controller.name == *name);
            found.is_some_and(|controller| controller.is_active)
        };
        Ok(needed.filter(|name| !is_active(name)).cloned().collect())
    }

    /// Activates the controllers that are `missing`, and checks that nothing moves then.
    ///
    /// # Errors
    /// If a controller does not become active, or a joint moves.
    pub(super) fn activate(&self, missing: Vec<String>) -> Result<(), String> {
        let connection = &self.connection;
        if missing.is_empty() {
            return Ok(());
        }
        let before = self.positions()?;
        let activated = connection.manager.activate(missing);
        activated.map_err(|error| error.to_string())?;
        let deadline = Instant::now() + ACTIVE_TIMEOUT;
        loop {
            let missing = self.inactive_controllers(None)?;
            if missing.is_empty() {
                break;
            }
            if Instant::now() >= deadline {
                let seconds = ACTIVE_TIMEOUT.as_secs();
                let names = missing.join(", ");
                return Err(format!("{names} has not become active within {seconds} s"));
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        std::thread::sleep(SETTLE);
        let after = self.positions()?;
        for (name, (before, after)) in connection.names.iter().zip(before.iter().zip(&after)) {
            let moved = (after - before).abs();
            if moved > SETTLE_MOVEMENT {
                return Err(format!(
                    "joint {name:?} moved by {moved:.4} rad when the controllers became active; the limit is {SETTLE_MOVEMENT} rad"
                ));
            }
        }
        Ok(())
    }

    pub(super) fn positions(&self) -> Result<Vec<f64>, String> {
        let readings = self.connection.readings.lock();
        let joints = readings.joints.as_ref();
        let joints = joints.ok_or("the robot has sent no state")?;
        Ok(joints.positions.clone())
    }

    /// Returns the tool's position in the world.
    pub(super) fn tool_at(&self, motion: &WipingMotion, positions: &[f64]) -> Option<Vector3<f64>> {
        let frames = &self.connection.frames;
        let tip = frames.link(&motion.head.tip)?;
        let root_from_tip = frames.root_from_link(positions, tip)?;
        let tool = motion.world_from_root * root_from_tip * motion.tip_from_tool;
        Some((tool * Point3::origin()).coords)
    }

    /// Refuses a motion that this robot must not execute.
    ///
    /// # Errors
    /// The first reason, with value and limit.
    pub(super) fn refuse_motion(
        &self,
        motion: &WipingMotion,
        parts: &[Part],
    ) -> Result<(), String> {
        let file = &self.connection.file;
        let names = &self.connection.names;
        let (head, limits) = (&motion.head, &file.limits);
        if head.joints != *names {
            return Err(format!(
                "the motion moves {}; expected the joints of {}: {}",
                head.joints.join(", "),
                file.urdf,
                names.join(", ")
            ));
        }
        if self.connection.frames.link(&head.tip).is_none() {
            return Err(format!(
                "the tool is on link {:?}, which the URDF of {} lacks",
                head.tip,
                file.path.display()
            ));
        }
        if head.phases.iter().any(|phase| phase.phase == "drive") {
            return Err("the motion moves a base; expected a robot with a fixed base".to_owned());
        }
        let presses = !self.options.is_in_air && head.gap_m.is_none();
        if presses && head.press_force_n > limits.force_n && file.force.kind != ForceKind::None {
            return Err(format!(
                "the motion presses with {:.1} N, more than limits.force_n = {} N",
                head.press_force_n, limits.force_n
            ));
        }
        let planned = motion.greatest_tool_speed(|positions| self.tool_at(motion, positions));
        let [speed, time] = [planned[0] * self.options.speed, planned[1]];
        if speed > SPEED_ROUNDING * limits.tool_speed_m_s {
            return Err(format!(
                "the tool moves at {speed:.3} m/s at {time:.1} s, faster than limits.tool_speed_m_s = {} m/s; \
                 set plan.free_speed_m_per_s in the task, or a lower --speed",
                limits.tool_speed_m_s
            ));
        }
        for part in parts {
            let begin = &motion.knots[part.knots[0]];
            let pace = GoalPace::from_rest(begin.time, self.options.speed);
            let goal = motion.goal(part, &pace, &begin.positions, names, 1.0);
            let bytes = goal_bytes(&goal);
            if bytes > file.motion.most_bytes {
                return Err(format!(
                    "a goal of the motion has {bytes} bytes at motion.knot_error_rad = {}, more than motion.most_bytes = {}",
                    file.motion.knot_error_rad, file.motion.most_bytes
                ));
            }
        }
        Ok(())
    }

    /// Refuses a robot that must not move now, or stands elsewhere than at the start of the motion.
    ///
    /// # Errors
    /// The first reason, with value and limit.
    pub(super) fn refuse_state(&self, motion: &WipingMotion) -> Result<(), String> {
        let faults = self.connection.faults(&self.connection.survey());
        if let Some(fault) = faults.first() {
            return Err(fault.clone());
        }
        let readings = self.connection.readings.lock();
        let joints = readings.joints.as_ref();
        let joints = joints.ok_or("the robot has sent no state")?;
        let names = &self.connection.names;
        for (name, velocity) in names.iter().zip(&joints.velocities) {
            if velocity.abs() > REST {
                return Err(format!(
                    "joint {name:?} moves at {velocity:.3} rad/s; a motion begins at rest, below {REST} rad/s"
                ));
            }
        }
        let limit = self.connection.file.limits.start_rad;
        let start = &motion.knots[0].positions;
        for (name, (measured, start)) in names.iter().zip(joints.positions.iter().zip(start)) {
            let distance = (measured - start).abs();
            if distance > limit {
                return Err(format!(
                    "joint {name:?} is {distance:.3} rad from the start of the motion, more than limits.start_rad = {limit} rad"
                ));
            }
        }
        Ok(())
    }
}
