//! Holding the robot after a fault or a request to stop.

use super::{MotionRun, TURN};
use crate::drive::checks::REST;
use crate::goals::GoalSender;
use crate::messages::EmptyRequest;
use ros2_client::RmwRequestId;
use ros2_client::action_msgs::CancelGoalResponseEnum;
use std::time::{Duration, Instant};

/// Longest wait for the robot to confirm a stop.
const HOLD: Duration = Duration::from_secs(1);
/// Period at which a stop is repeated until the robot confirms it.
const REPEAT: Duration = Duration::from_millis(100);

impl MotionRun<'_> {
    /// Cancels the goal and ends force mode, again and again, until the robot has confirmed that and rests.
    ///
    /// # Errors
    /// What it has not confirmed.
    pub(super) fn hold(&mut self) -> Result<(), String> {
        let mut is_canceled = self.goal.is_none();
        let mut is_released = !self.is_pressing || self.robot.force.is_none();
        let (mut canceling, mut releasing) = (None, None);
        let begin = Instant::now();
        let mut sent: Option<Instant> = None;
        while begin.elapsed() < HOLD {
            let _ = self.driver.guard.beat();
            if sent.is_none_or(|sent| sent.elapsed() >= REPEAT) {
                sent = Some(Instant::now());
                if let Some(goal) = self.goal.as_ref().filter(|_| !is_canceled) {
                    canceling = self.robot.action.cancel_goal(goal.id).ok();
                }
                if let Some(force) = self.robot.force.as_ref().filter(|_| !is_released) {
                    releasing = force.stop.send(EmptyRequest::default()).ok();
                }
            }
            is_canceled |= self.is_goal_gone(canceling);
            if let (Some(force), Some(request)) = (&self.robot.force, releasing) {
                let answer = force.stop.answer(request);
                is_released |= answer.is_some_and(|answer| answer.success);
            }
            let joints = self.robot.readings.wait(TURN).joints.clone();
            let rests = joints.is_some_and(|joints| {
                let is_slow = joints.velocities.iter().all(|v| v.abs() <= REST);
                let is_new = joints.number != self.latest.number;
                self.latest = joints;
                is_slow && is_new && !self.latest.velocities.is_empty()
            });
            if is_canceled && is_released && rests {
                self.goal = None;
                self.is_pressing = false;
                return Ok(());
            }
        }
        let seconds = HOLD.as_secs_f64();
        let (fastest, unit) = self.fastest_joint();
        Err(match (is_canceled, is_released) {
            (false, _) => format!("no answer to the cancel of its goal within {seconds} s"),
            (true, false) => format!("force mode was not ended within {seconds} s"),
            (true, true) => format!(
                "after {seconds} s a joint moves at {fastest:.3} {unit}/s, the limit is {REST} {unit}/s"
            ),
        })
    }

    /// Whether the robot no longer executes the goal, and will not begin it. A cancel may arrive before its goal: then it
    /// answers that it does not know the goal.
    fn is_goal_gone(&mut self, canceling: Option<RmwRequestId>) -> bool {
        let action = &self.robot.action;
        let Some(goal) = &mut self.goal else {
            return true;
        };
        if !goal.is_accepted {
            match GoalSender::answer(action, goal.request) {
                Some(answer) if answer.accepted => goal.is_accepted = true,
                Some(_) => return true,
                None => {}
            }
        }
        let answer = canceling.and_then(|request| action.receive_cancel_response(request).ok()?);
        answer.is_some_and(|answer| match answer.return_code {
            CancelGoalResponseEnum::None => true,
            CancelGoalResponseEnum::Rejected => false,
            // It has ended, or has not arrived yet.
            _ => goal.is_accepted,
        })
    }
}
