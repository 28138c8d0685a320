//! One round of a session: the planned motion, and the result of its execution.

use super::{Ending, Execution};
use crate::follow::{Audit, Followed, Workcell};
use crate::interpret::{Belief, Interpretation};
use crate::plan::{Plan, Prediction, predict};
use crate::recover::Verdict;
use crate::represent::Task;
use std::sync::Arc;

/// The plan and motion of a round before its execution.
#[derive(Debug, Clone)]
pub struct PlannedRound {
    /// The round, from 1.
    pub number: usize,
    /// The task with the estimate of the round.
    pub task: Task,
    /// The belief about the dirt before the round.
    pub believed: Belief,
    /// The plan.
    pub plan: Plan,
    /// Robot, tool and scene, which all plans of a round share.
    pub cell: Arc<Workcell>,
    /// The joint motion.
    pub followed: Followed,
    /// The predicted effect of the motion.
    pub prediction: Prediction,
}

impl PlannedRound {
    /// Returns the plan as the robot executes it: without abandoned nodes.
    pub fn executable_plan(&self) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..self.plan.clone()
        }
    }

    /// Share of the particles that the abandoned nodes are predicted to cost \[1\].
    pub fn abandoned_share(&self) -> f64 {
        if self.followed.abandoned.is_empty() {
            return 0.0;
        }
        let planned = predict(&self.task, &self.plan, |_| ());
        (planned.performance.ratio() - self.prediction.performance.ratio()).max(0.0)
    }
}

/// The executed part of a round's motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ExecutedMotion {
    /// Time in contact \[s\].
    pub contact_time: f64,
    /// Length of the arm's joint path in contact, and in total \[rad\].
    pub joint_movement: [f64; 2],
    /// Path length of the tool in contact, and in total \[m\].
    pub distance: [f64; 2],
}

/// A completed round: plan, execution, interpretation and verdict.
#[derive(Debug, Clone)]
pub struct Round {
    /// The plan and its motion.
    pub motion: PlannedRound,
    /// Result of the independent check of the motion; a motion with faults is never executed.
    pub audit: Audit,
    /// Result of the execution.
    pub execution: Execution,
    /// The interpretation of the measured data.
    pub interpretation: Interpretation,
    /// The verdict on the round.
    pub verdict: Verdict,
}

impl Round {
    /// Returns the executed part of the motion: all of a complete one, else the planned part up to the time at
    /// which it ended.
    pub fn executed_motion(&self) -> ExecutedMotion {
        let PlannedRound { cell, followed, .. } = &self.motion;
        let end = match self.execution.ending {
            Ending::Complete => f64::INFINITY,
            _ => self.execution.duration,
        };
        let wiped = self.motion.executable_plan();
        let contact_time = followed.contact_time_until(end);
        let share = |part: f64, whole: f64| {
            if whole > 0.0 {
                (part / whole).min(1.0)
            } else {
                0.0
            }
        };
        ExecutedMotion {
            contact_time,
            joint_movement: followed.joint_movement_until(cell.arm_variables(), end),
            distance: [
                wiped.contact_distance() * share(contact_time, followed.contact_time()),
                wiped.total_distance() * share(end, followed.duration()),
            ],
        }
    }
}
