//! One round of a session: what is about to be executed, and what came of it.

use super::{Ending, Execution};
use crate::follow::{Audit, Followed, Workcell};
use crate::interpret::{Belief, Interpretation};
use crate::plan::{Plan, Prediction, predict};
use crate::recover::Verdict;
use crate::represent::Task;

/// What is about to be executed.
#[derive(Debug, Clone)]
pub struct PlannedRound {
    /// The round, from 1.
    pub number: usize,
    /// The task as it was believed.
    pub task: Task,
    /// Where the dirt was believed to lie.
    pub believed: Belief,
    /// The plan.
    pub plan: Plan,
    /// Robot, tool and scene.
    pub cell: Workcell,
    /// The joint motion.
    pub followed: Followed,
    /// What it is predicted to do.
    pub prediction: Prediction,
}

impl PlannedRound {
    /// The plan as the robot wipes it: without what had to be given up.
    pub fn wiped(&self) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..self.plan.clone()
        }
    }

    /// Share of the particles that abandoned nodes are predicted to cost [1].
    pub fn abandoned_share(&self) -> f64 {
        if self.followed.abandoned.is_empty() {
            return 0.0;
        }
        let planned = predict(&self.task, &self.plan, |_| ());
        (planned.performance.ratio() - self.prediction.performance.ratio()).max(0.0)
    }
}

/// How much of a round's motion was executed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ExecutedMotion {
    /// Time during which the tool wiped [s].
    pub contact_time: f64,
    /// Length of the way of the arm's joints while the tool wiped, and in all [rad].
    pub joint_movement: [f64; 2],
    /// Way of the tool in contact, and in all [m].
    pub distance: [f64; 2],
}

/// One round that is over: what was planned, executed and felt, and what follows.
#[derive(Debug, Clone)]
pub struct Round {
    /// What was planned.
    pub motion: PlannedRound,
    /// What an independent check says of its motion; one with faults is never executed.
    pub audit: Audit,
    /// What was executed.
    pub execution: Execution,
    /// What the robot makes of it.
    pub interpretation: Interpretation,
    /// What follows.
    pub verdict: Verdict,
}

impl Round {
    /// How much of the motion was executed: all of one that is complete, of another what was planned until it ended.
    pub fn executed(&self) -> ExecutedMotion {
        let PlannedRound { cell, followed, .. } = &self.motion;
        let end = match self.execution.ending {
            Ending::Complete => f64::INFINITY,
            _ => self.execution.duration,
        };
        let wiped = self.motion.wiped();
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
