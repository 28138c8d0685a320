//! One round of a session: the planned motion, and the result of its execution.

use super::{Ending, Execution, RunWarning};
use crate::follow::{Audit, Followed, Workcell};
use crate::geometry::Vector3;
use crate::interpret::{Belief, Interpretation};
use crate::plan::{Plan, Prediction, predict};
use crate::recover::Verdict;
use crate::represent::Task;
use crate::robot::JointKind;
use std::sync::Arc;

/// Period at which the path of the tool is summed [s].
const TRAVEL_PERIOD: f64 = 0.01;

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
    /// Robot, tool and scene; all plans of a round share them.
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

    /// Returns times and lengths of the motion up to a time \[s\].
    pub fn motion_until(&self, end: f64) -> ExecutedMotion {
        let Self { cell, followed, .. } = self;
        let slides = |&&i: &&usize| cell.robot().variable(i).kind == JointKind::Prismatic;
        let (slides, turns): (Vec<usize>, Vec<usize>) =
            (cell.arm_variables().iter()).partition(slides);
        let [in_contact, total] = tool_travel(cell, followed, end);
        let [all_in_contact, _] = match end.is_finite() {
            true => tool_travel(cell, followed, f64::INFINITY),
            false => [in_contact, total],
        };
        let share = if all_in_contact > 0.0 {
            in_contact / all_in_contact
        } else {
            0.0
        };
        let wiped = self.executable_plan().contact_distance() * share;
        ExecutedMotion {
            contact_time: followed.contact_time_until(end),
            joint_movement: followed.joint_movement_until(&turns, end),
            slide_movement: (!slides.is_empty())
                .then(|| followed.joint_movement_until(&slides, end)),
            distance: [wiped, total.max(wiped)],
        }
    }

    /// Share of the particles that the plan is predicted to leave because of the abandoned nodes
    /// \[1\].
    pub fn abandoned_share(&self) -> f64 {
        if self.followed.abandoned.is_empty() {
            return 0.0;
        }
        let planned = predict(&self.task, &self.plan, |_| ());
        (planned.performance.ratio() - self.prediction.performance.ratio()).max(0.0)
    }
}

/// Returns the path length of the tool centre point in the world up to a time `end` \[s\]: in contact, and in total [m].
fn tool_travel(cell: &Workcell, followed: &Followed, end: f64) -> [f64; 2] {
    let mut travel = [0.0; 2];
    for motion in &followed.motions {
        let samples = motion.trajectory.samples(TRAVEL_PERIOD);
        let places =
            (samples.take_while(|sample| motion.start + sample.time <= end)).map_while(|sample| {
                let kinematics = cell.robot().forward_kinematics(&sample.q).ok()?;
                let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
                Some(root_from_tool.translation.vector)
            });
        let mut before = None;
        for place in places {
            let step = before.map_or(0.0, |before: Vector3| (place - before).norm());
            travel[1] += step;
            if motion.phase.is_contact() {
                travel[0] += step;
            }
            before = Some(place);
        }
    }
    travel
}

/// Times and lengths of a round's motion, or of its executed part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ExecutedMotion {
    /// Time in contact \[s\].
    pub contact_time: f64,
    /// Path length of the arm's revolute joints in joint space \[rad\]: in contact, and in total.
    pub joint_movement: [f64; 2],
    /// Path length of the arm's prismatic joints \[m\]: in contact, and in total; `None` for an arm
    /// without any.
    pub slide_movement: Option<[f64; 2]>,
    /// Path length of the tool centre point \[m\]: in contact, along the strokes that the robot follows; in total, in the
    /// world over the whole motion, with the way from the ready posture, between the strokes and back.
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
    /// Warnings during the execution, in the order of time.
    pub warnings: Vec<RunWarning>,
    /// The verdict on the round.
    pub verdict: Verdict,
}

impl Round {
    /// Returns the executed part of the motion: all of a complete one, else the planned part up to the time at
    /// which it ended.
    pub fn executed_motion(&self) -> ExecutedMotion {
        self.motion.motion_until(match self.execution.ending {
            Ending::Complete => f64::INFINITY,
            _ => self.execution.duration,
        })
    }
}
