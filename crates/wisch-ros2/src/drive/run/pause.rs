//! Pauses: the goal is canceled, the robot rests, and another goal continues from where it stands.

use super::{ANSWER, MotionResult, MotionRun, ended_kind, stop};
use crate::goals::TrajectoryAction;
use crate::motion::Part;
use crate::pace::GoalPace;
use crate::protocol::Kind;
use ros2_client::action_msgs::{GoalId, GoalStatusEnum};
use serde_json::{Value, json};

/// Time on the trajectory within which the robot comes to rest after a cancel, at the planned speed [s].
const BRAKING_S: f64 = 1.0;
/// Reason of a pause, for the summary of the run.
const REASON: &str = "the operator";

impl MotionRun<'_> {
    /// Pauses as long as the operator wants it. No goal is active then, and a tool that presses keeps pressing.
    ///
    /// # Errors
    /// The ending of the motion, for example if somebody has moved the robot.
    pub(super) fn pause_if_wanted(&mut self) -> MotionResult<()> {
        if !self.wants_pause {
            return Ok(());
        }
        self.settle_briefly()?;
        if !self.wants_pause {
            return Ok(());
        }
        self.say_pause("paused", json!({"reason": REASON}))?;
        let rested = self.latest.positions.clone();
        while self.wants_pause {
            self.supervise_once()?;
            self.check_unmoved(&rested)?;
        }
        self.say_pause("resumed", json!({}))
    }

    /// Tells wisch that a pause begins or ends with the latest sample.
    fn say_pause(&self, what: &str, mut content: Value) -> MotionResult<()> {
        content["time_s"] = json!(self.sample_time.max(0.0));
        if self.outgoing.say(&json!({what: content})) {
            return Ok(());
        }
        stop(Kind::LinkLost, "wisch does not read the samples")
    }

    /// Ends a motion whose robot was moved while it paused. `rested`: positions at the start of the pause [rad or m].
    fn check_unmoved(&self, rested: &[f64]) -> MotionResult<()> {
        let limit = self.robot.file.limits.start_rad;
        let joints = rested.iter().zip(&self.latest.positions);
        for (name, (rested, measured)) in self.robot.names.iter().zip(joints) {
            let distance = (measured - rested).abs();
            if distance > limit {
                return stop(
                    Kind::Operator,
                    format!(
                        "joint {name:?} of the paused robot has moved by {distance:.3} rad, more than limits.start_rad = {limit} rad"
                    ),
                );
            }
        }
        Ok(())
    }

    /// Cancels the goal for a pause, and waits until it has ended. Returns whether it had reached its end before.
    pub(super) fn cancel_for_pause(
        &mut self,
        id: GoalId,
        mut result: impl FnMut(&TrajectoryAction) -> Option<GoalStatusEnum>,
    ) -> MotionResult<bool> {
        let _ = self.robot.action.cancel_goal(id);
        if let Some(goal) = &mut self.goal {
            goal.is_ending = true;
        }
        let status = self.wait("the end of a canceled goal", ANSWER, |run| {
            result(&run.robot.action)
        })?;
        self.goal = None;
        match status {
            GoalStatusEnum::Succeeded => Ok(true),
            GoalStatusEnum::Canceled => Ok(false),
            other => stop(
                ended_kind(other, 0),
                format!("the controller ended a canceled goal as {other:?}"),
            ),
        }
    }

    /// The pace of the rest of a part, from the time on the trajectory that is nearest to the robot: the robot brakes for a
    /// while after its goal is canceled.
    pub(super) fn resumed_pace(&self, part: &Part) -> GoalPace {
        let end = self.motion.knots[part.knots[1]].time;
        let speed = self.driver.options.speed;
        let latest = (self.trajectory_time + BRAKING_S * speed).min(end);
        let span = [self.trajectory_time.min(end), latest];
        let from = self.motion.nearest_time(&self.latest.positions, span);
        GoalPace::resume(from, end, speed)
    }
}
