//! Trials of ready postures: a plan over the task's whole surface is followed from each.

use rayon::prelude::*;
use wisch::follow::{Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, Planner, Strategy};
use wisch::robot::setup::{ArmChain, ReadyPosture, SetupError};
use wisch::robot::{Group, GroupState, READY_STATE, RobotModel, Srdf};
use wisch_io::LoadedTask;

/// Most nodes of a plan that is followed from several postures; larger plans take too long.
const MOST_NODES: usize = 1000;

/// Result of the trial of a ready posture.
#[derive(Debug, Clone, Copy)]
pub struct Tried {
    /// Number of postures from which the plan was followed.
    pub postures: usize,
    /// Number of nodes of the plan.
    pub nodes: usize,
    /// Number of nodes that are out of reach from the chosen posture.
    pub abandoned: usize,
}

/// A plan over a task's surface that is followed with each ready posture.
pub struct Trial<'a> {
    task: &'a LoadedTask,
    plan: Plan,
    config: WorkcellConfig,
}

impl<'a> Trial<'a> {
    /// Plans over the whole surface of a task; `None` without a plan of a size that can be tried.
    pub fn new(task: &'a LoadedTask, config: WorkcellConfig) -> Option<Self> {
        let strategy = if task.task.action.treats() {
            Strategy::Lanes
        } else {
            CoverageStrategy::Grid.into()
        };
        let planning = PlanConfig {
            strategy,
            ..task.run.plan.clone()
        };
        let plan = Planner::new(&task.task, &planning).plan().ok()?;
        (1..=MOST_NODES)
            .contains(&plan.graph.nodes.len())
            .then_some(Self { task, plan, config })
    }

    /// Returns the posture from which the fewest nodes are abandoned, the first of several. If none can be the start of
    /// a motion, it returns the first one without a result.
    ///
    /// `postures`: at least one.
    ///
    /// # Errors
    /// If an arm does not fit the robot.
    pub fn choose(
        &self,
        robot: &RobotModel,
        srdf: &Srdf,
        arms: &[ArmChain],
        group: &Group,
        mut postures: Vec<ReadyPosture>,
    ) -> Result<(ReadyPosture, Option<Tried>), SetupError> {
        let abandoned = |posture: &ReadyPosture| {
            let mut srdf = srdf.clone();
            let ready = [(group.clone(), posture.clone())];
            srdf.states.splice(0..0, states(robot, arms, &ready)?);
            Ok(self.count_abandoned(robot, &srdf))
        };
        let counts: Vec<Option<usize>> =
            (postures.par_iter().map(abandoned)).collect::<Result<_, SetupError>>()?;
        let (count, nodes) = (postures.len(), self.plan.graph.nodes.len());
        let least = counts.iter().copied().flatten().min();
        let best = counts.iter().position(|&count| count == least);
        let chosen = postures.swap_remove(best.unwrap_or(0));
        let tried = least.map(|abandoned| Tried {
            postures: count,
            nodes,
            abandoned,
        });
        Ok((chosen, tried))
    }

    /// Returns the number of nodes that are abandoned; `None` if the robot cannot begin.
    fn count_abandoned(&self, robot: &RobotModel, srdf: &Srdf) -> Option<usize> {
        let task = &self.task.task;
        let cell = Workcell::new(robot.clone(), Some(srdf), task, &self.config).ok()?;
        let config = self.task.run.follow.clone();
        let followed = follow(task, &self.plan, &cell, None, &config, &mut |_| {}).ok()?;
        Some(followed.abandoned.len())
    }
}

/// Returns the ready states of all groups, from the last posture, which has all arms in place.
pub(super) fn states(
    robot: &RobotModel,
    arms: &[ArmChain],
    ready: &[(Group, ReadyPosture)],
) -> Result<Vec<GroupState>, SetupError> {
    let Some((_, last)) = ready.last() else {
        return Ok(Vec::new());
    };
    let groups = arms.iter().flat_map(|arm| &arm.groups);
    let states = groups.map(|proposed| {
        let group = &proposed.group;
        let chain = robot.chain(group.base, group.tip)?;
        let positions = chain.variables().iter().map(|&v| (v, last.q[v]));
        Ok(GroupState {
            name: READY_STATE.to_owned(),
            group: group.name.clone(),
            positions: positions.collect(),
        })
    });
    states.collect()
}
