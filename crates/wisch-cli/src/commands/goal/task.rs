//! The wiping actions that may serve a goal of several parts, with their expected times.

use super::super::follow::{Chosen, read_robot, workcell_config};
use super::super::prepare::{load, stage_failure};
use super::super::swept::{SweptSurface, find_collected};
use super::super::words::{internal, percent};
use super::summary::{CHANGE, EMPTY, ExpectedAction, SPEED};
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use wisch::geometry::Point2;
use wisch::goal::{Sequence, Situation, StepPlace, StepTimes, Wiping};
use wisch::represent::Action;
use wisch::run::{Executor, FirstPlan, NoExecutor, RunConfig, Session};
use wisch_io::{GoalFile, KeptFiles, LoadOptions, LoadedTask, Robot, RoundTimes};
use wisch_record::{RunSink, StageSink};
use wisch_sim::{WorkSurface, World};

/// Least predicted performance at which further rounds are expected to reach a target [1].
const LEAST_PREDICTED: f64 = 0.05;

/// The expectation of a wiping action.
#[derive(Debug, Clone)]
pub(super) enum Expected {
    /// It is expected to reach its target.
    Reaches {
        /// Time of a round, with the robot's whole motion, or of the strokes without a robot [s].
        round_s: f64,
        /// Expected number of rounds.
        rounds: f64,
        /// Predicted performance of a round [1].
        predicted: f64,
    },
    /// It is impossible, for this reason.
    Impossible(String),
}

/// The plan by which the time of a wiping action was predicted, kept for the first round of its step.
pub struct KeptPlan<'a> {
    /// The plan, with its motion if there is a robot.
    pub first: Box<FirstPlan<'a>>,
    /// Computation times of its stages.
    pub times: RoundTimes,
}

/// A task with a goal of several parts, and the expectations of the actions that may serve it.
pub struct GoalTask<'a> {
    pub(super) args: &'a TaskArgs,
    pub(super) file: &'a GoalFile,
    pub(super) expected: BTreeMap<Wiping, Expected>,
    /// Origins of the surfaces in the world [m].
    surfaces: BTreeMap<String, [f64; 3]>,
    has_robot: bool,
    /// Target performances of the actions [1].
    targets: BTreeMap<Wiping, f64>,
    /// Actions whose dirt a camera observes.
    pub(super) observed: BTreeSet<Wiping>,
    /// The planned strokes of the possible actions, and the dirt that they are predicted to collect.
    swept: BTreeMap<Wiping, SweptSurface>,
    /// The plans of the possible actions.
    plans: BTreeMap<Wiping, KeptPlan<'a>>,
}

/// Reads the task if its goal has several parts; otherwise returns `None`.
///
/// # Errors
/// If the task file cannot be read or is invalid.
pub fn read_goal(args: &TaskArgs) -> Result<Option<GoalFile>, Failure> {
    let options = LoadOptions {
        settings: args.settings.clone(),
        knowledge: args.knowledge.clone(),
        action: args.action,
        strategy: args.strategy,
        seed: args.seed,
    };
    Ok(GoalFile::read(&args.task, &options)?)
}

impl<'a> GoalTask<'a> {
    /// Plans every action that may serve the goal, and predicts its time and performance.
    ///
    /// `robot`: the robot that follows the plans; `None` to plan the strokes only. `is_run`: whether the steps are to be executed,
    /// so that the camera, if there is one, first observes the dirt. `known`: receives the robot once it is read.
    ///
    /// # Errors
    /// If the goal or the robot is invalid. An action that cannot be planned is no error, but impossible.
    pub fn evaluate(
        args: &'a TaskArgs,
        file: &'a GoalFile,
        (robot, is_run): (Option<&RobotArgs>, bool),
        known: &'a OnceCell<Robot>,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let situation = file
            .situation()
            .map_err(|error| stage_failure(args, error))?;
        let mut task = Self {
            args,
            file,
            expected: BTreeMap::new(),
            surfaces: BTreeMap::new(),
            has_robot: false,
            targets: BTreeMap::new(),
            observed: BTreeSet::new(),
            swept: BTreeMap::new(),
            plans: BTreeMap::new(),
        };
        let wipings = situation.list_possible_wipings(&file.goal);
        for (wiping, number) in wipings.iter().zip(1..) {
            progress.say(format!("planning {wiping} ({number} of {})", wipings.len()));
            let part = task.build_part_arguments(&situation, wiping, &[])?;
            let loaded = match load(&part, &KeptFiles::default()) {
                Ok(loaded) => loaded,
                // The file as a whole is valid; it lacks what this action needs.
                Err(failure) => {
                    let why = Expected::Impossible(failure.to_string());
                    task.expected.insert(wiping.clone(), why);
                    continue;
                }
            };
            let at = loaded.task.surface.world_from_surface.translation.vector;
            task.surfaces.insert(wiping.surface.clone(), at.into());
            let chosen = robot
                .map(|robot| Chosen::new(robot, &loaded))
                .transpose()?
                .flatten();
            if let (Some(chosen), None) = (&chosen, known.get()) {
                let read = read_robot(chosen, &part)?;
                known.get_or_init(|| read);
            }
            let robot = chosen.as_ref().zip(known.get());
            task.has_robot |= robot.is_some();
            if loaded.file.camera.is_some() {
                task.observed.insert(wiping.clone());
            }
            task.targets.insert(wiping.clone(), loaded.run.target);
            let expected = match estimate_action(&loaded, robot, is_run) {
                Ok(Expectation {
                    expected,
                    swept,
                    plan,
                }) => {
                    task.swept.insert(wiping.clone(), swept);
                    task.plans.extend(plan.map(|plan| (wiping.clone(), plan)));
                    expected
                }
                Err(why) => Expected::Impossible(why),
            };
            task.expected.insert(wiping.clone(), expected);
        }
        Ok(task)
    }

    /// Returns the state before the first step. It contains which wiping actions are expected to pass over dirt that another
    /// action collects.
    ///
    /// # Errors
    /// If the task does not fit the knowledge base.
    pub fn situation(&self) -> Result<Situation<'a>, Failure> {
        let situation = self.file.situation();
        let mut situation = situation.map_err(|error| stage_failure(self.args, error))?;
        for (collecting, heap) in &self.swept {
            for (other, swept) in &self.swept {
                let is_beside = collecting.action == Action::Collect
                    && other.surface == collecting.surface
                    && other.medium != collecting.medium;
                if is_beside && self.is_spoiled(collecting, &heap.collected, swept)? {
                    situation.note_sweep(other, &collecting.medium);
                }
            }
        }
        Ok(situation)
    }

    /// Whether strokes pass over more of the collected dirt than the target of its collection permits.
    ///
    /// `collecting`: the action that collects; `heap`: its dirt, in the frame of the surface [m]; `swept`: the strokes.
    pub(super) fn is_spoiled(
        &self,
        collecting: &Wiping,
        heap: &[Point2],
        swept: &SweptSurface,
    ) -> Result<bool, Failure> {
        let share = swept.share_covered(heap).map_err(internal)?;
        let target = self.targets.get(collecting).copied();
        Ok(share > 1.0 - target.unwrap_or(1.0))
    }

    /// Takes the plans of the possible actions, for the steps.
    pub fn take_plans(&mut self) -> BTreeMap<Wiping, KeptPlan<'a>> {
        std::mem::take(&mut self.plans)
    }

    /// Whether a robot follows the strokes.
    pub const fn has_robot(&self) -> bool {
        self.has_robot
    }

    /// Returns the arguments of a task of one part: a wiping action. `further`: additional settings, as key and value.
    ///
    /// # Errors
    /// If the domain has no effect of the action.
    pub fn build_part_arguments(
        &self,
        situation: &Situation<'_>,
        wiping: &Wiping,
        further: &[(&str, String)],
    ) -> Result<TaskArgs, Failure> {
        let Wiping {
            action,
            tool,
            medium,
            surface,
        } = wiping;
        let fact = situation.find_effect_of(wiping);
        let fact = fact.ok_or_else(|| internal("a wiping action has no effect"))?;
        let text = |text: &str| serde_json::Value::from(text).to_string();
        let own = [
            ("goal", text(&fact.to_string())),
            (
                "name",
                text(&format!("{}-{action}-{medium}-{surface}", self.file.name)),
            ),
            ("tool.name", text(tool)),
            ("tool.in_hand", text(tool)),
            ("tool.available", "[]".to_owned()),
        ];
        let mut args = self.args.clone();
        let added = own.iter().chain(further);
        args.settings
            .extend(added.map(|(key, value)| ((*key).to_owned(), value.clone())));
        Ok(args)
    }

    /// Plans the sequence of least expected time from a situation. `place`: where the robot is.
    ///
    /// # Errors
    /// As [`Situation::plan`].
    pub fn plan(
        &self,
        situation: &Situation<'_>,
        place: StepPlace<'_>,
    ) -> Result<Sequence, Failure> {
        let sequence = situation.plan(&self.file.goal, place, self);
        sequence.map_err(|error| stage_failure(self.args, error))
    }

    /// Returns the expectations of all actions that may serve the goal.
    pub(super) fn expected_actions(&self) -> Vec<ExpectedAction> {
        let actions = self.expected.iter().map(|(wiping, expected)| {
            let (numbers, impossible) = match expected {
                Expected::Reaches {
                    round_s,
                    rounds,
                    predicted,
                } => (Some([*round_s, *rounds, *predicted]), None),
                Expected::Impossible(why) => (None, Some(why.clone())),
            };
            ExpectedAction {
                wiping: wiping.to_string(),
                round_s: numbers.map(|[round_s, _, _]| round_s),
                rounds: numbers.map(|[_, rounds, _]| rounds),
                predicted: numbers.map(|[_, _, predicted]| predicted),
                impossible,
            }
        });
        actions.collect()
    }

    /// Returns a place in the world [m]: the origin of a surface, or the position of a tool in the rack; `None` if it is unknown.
    fn find_place(&self, place: StepPlace<'_>) -> Option<[f64; 3]> {
        match place {
            StepPlace::Start => None,
            StepPlace::Surface(name) => self.surfaces.get(name).copied(),
            StepPlace::Rack(name) => {
                let mut tools = self.file.tools.iter();
                tools.find(|tool| tool.name == name)?.position
            }
        }
    }
}

impl StepTimes for GoalTask<'_> {
    fn wiping(&self, wiping: &Wiping) -> Option<f64> {
        match self.expected.get(wiping)? {
            Expected::Reaches {
                round_s, rounds, ..
            } => Some(round_s * rounds),
            Expected::Impossible(_) => None,
        }
    }

    fn handling(&self, name: &str) -> f64 {
        if name == "empty" { EMPTY } else { CHANGE }
    }

    fn moving(&self, from: StepPlace<'_>, to: StepPlace<'_>) -> f64 {
        match (self.find_place(from), self.find_place(to)) {
            (Some(from), Some(to)) => {
                let squares = from.iter().zip(to).map(|(a, b)| (a - b).powi(2));
                squares.sum::<f64>().sqrt() / SPEED
            }
            _ => 0.0,
        }
    }
}

/// What is known of a possible action.
struct Expectation<'r> {
    expected: Expected,
    /// The planned strokes.
    swept: SweptSurface,
    plan: Option<KeptPlan<'r>>,
}

/// Plans the task of an action, with the robot if there is one, and predicts time and performance. In a run with a camera, the
/// plan is for the observed dirt, as in the first round of the step, or for the task's estimate if no such plan serves. The
/// error is the reason why the action is impossible.
fn estimate_action<'r>(
    loaded: &LoadedTask,
    robot: Option<(&Chosen<'_>, &'r Robot)>,
    is_run: bool,
) -> Result<Expectation<'r>, String> {
    if is_run && robot.is_some() && loaded.run.sight.is_some() {
        let surface = WorkSurface::from_task(&loaded.task);
        let world = World::new(&surface, loaded.simulation.clone(), loaded.task.seed);
        let observed = world.map_err(|error| error.to_string());
        let observed =
            observed.and_then(|mut world| estimate_action_with(loaded, robot, &mut world));
        if observed.is_ok() {
            return observed;
        }
    }
    estimate_action_with(loaded, robot, &mut NoExecutor)
}

/// Plans and predicts like [`estimate_action`]. `executor`: observes the dirt before the plan if it has a camera, and moves nothing.
fn estimate_action_with<'r>(
    loaded: &LoadedTask,
    robot: Option<(&Chosen<'_>, &'r Robot)>,
    executor: &mut dyn Executor,
) -> Result<Expectation<'r>, String> {
    let config = RunConfig {
        workcell: robot.map_or_else(Default::default, |(chosen, _)| {
            workcell_config(chosen, loaded)
        }),
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config).with_belief(loaded.belief());
    if let Some((_, robot)) = robot {
        session = session.with_robot(robot.robot_setup());
    }
    let mut stages = StageSink::default();
    let first = session.plan_first(executor, &mut |event| {
        // It measures times only, and never fails.
        let _ = stages.on_event(event);
        ControlFlow::Continue(())
    });
    let first = first.map_err(|error| error.to_string())?;
    if session.unseen_dirt().is_some() {
        return Err("the camera detects no dirt".to_owned());
    }
    let (round_s, prediction, plan) = match (session.first_motion(), session.plan()) {
        (Some((_, audit)), _) if !audit.is_sound() => {
            let fault = audit.faults.first().map(ToString::to_string);
            return Err(format!("unsafe motion: {}", fault.unwrap_or_default()));
        }
        (Some((motion, _)), _) => {
            let prediction = motion.prediction.clone();
            (
                motion.followed.duration(),
                prediction,
                motion.executable_plan(),
            )
        }
        (None, Some(plan)) => {
            let predicted = wisch::plan::predict(&loaded.task, plan, |_| {});
            (plan.total_distance() / SPEED, predicted, plan.clone())
        }
        (None, None) => return Err("there is no plan".to_owned()),
    };
    let performance = prediction.performance;
    let (predicted, target) = (performance.ratio(), loaded.run.target);
    let lost = performance.lost as f64 / performance.initial.max(1) as f64;
    if lost > 1.0 - target {
        let lost = percent(lost);
        if loaded.task.action.treats() {
            return Err(format!(
                "a plan would coat {lost} of the points too thickly, and the target is {}",
                percent(target)
            ));
        }
        return Err(format!(
            "a plan would lose {lost} of the dirt over an edge, and the target is {}",
            percent(target)
        ));
    }
    if predicted < LEAST_PREDICTED {
        return Err(format!(
            "a plan is predicted to reach {} only, and the target is {}",
            percent(predicted),
            percent(target)
        ));
    }
    // A round leaves the share 1 - r of the dirt, and n rounds (1 - r)^n.
    let rounds = if predicted >= target {
        1.0
    } else {
        ((1.0 - target).max(1e-3).ln() / (1.0 - predicted).ln()).max(1.0)
    };
    let expected = Expected::Reaches {
        round_s,
        rounds,
        predicted,
    };
    let swept = SweptSurface {
        collected: find_collected(&prediction.particles, plan.graph.goal),
        plans: vec![(loaded.task.clone(), plan)],
    };
    let times = *stages.round(1);
    let plan = first.map(|first| KeptPlan {
        first: Box::new(first),
        times,
    });
    Ok(Expectation {
        expected,
        swept,
        plan,
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::job::{Job, RoundStart};
    use super::*;
    use crate::args::{Cli, Command};
    use wisch::run::ignore_events;
    use wisch_io::{Leftover, OutputFolder, Replaceable};
    use wisch_record::RunClock;

    /// Two media on a board before an arm, with a rack of tools.
    const BOARD: &str = r#"
        schema = 1
        name = "board"
        seed = 1
        goal = "(and (collected breadcrumbs chopping_board) (absorbed water chopping_board))"
        strategy = "kde"
        [tool]
        rack = [{ name = "sponge" }, { name = "brush" }]
        [surface]
        name = "chopping_board"
        size_m = [0.28, 0.20]
        position_m = [0.0, 0.0, 0.77]
        [[medium]]
        name = "water"
        particles = { source = "clusters", count = 20, clusters = [{ center_m = [-0.08, 0.04], sigma_m = 0.02 }] }
        [[medium]]
        name = "breadcrumbs"
        particles = { source = "uniform", count = 20 }
        collect = { goal_m = [0.06, -0.03] }
        [perception]
        senses = ["touch", "sight"]
        [robot]
        name = "arm7"
        position_m = [0.0, -0.45, 0.75]
        rpy_rad = [0.0, 0.0, 1.5707963267948966]
    "#;

    #[test]
    fn the_plan_that_predicts_a_step_is_the_plan_of_its_first_round() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("board.toml");
        std::fs::write(&path, BOARD).expect("written");
        let words = ["wisch".as_ref(), "run".as_ref(), path.as_os_str()];
        let cli = Cli::read(&words.map(std::ffi::OsStr::to_owned)).expect("a command");
        let Command::Run(run) = &cli.command else {
            panic!("another command");
        };
        let (task_args, robot_args) = (&run.follow.task, &run.follow.robot);
        let file = read_goal(task_args).expect("a task").expect("two parts");
        let (known, progress) = (OnceCell::new(), Progress::start(&cli.global));
        let robot = (Some(robot_args), true);
        let task = GoalTask::evaluate(task_args, &file, robot, &known, &progress);
        let mut task = task.expect("an evaluation");
        let plans = task.take_plans();
        assert!(plans.len() >= 2, "{:?}", task.expected);
        assert!(plans.keys().all(|wiping| task.wiping(wiping).is_some()));

        let situation = task.situation().expect("a situation");
        let out = folder.path().join("out");
        let out = OutputFolder::begin(&out, Leftover::Remove, Replaceable::All).expect("a folder");
        for (wiping, kept) in plans {
            let args = task
                .build_part_arguments(&situation, &wiping, &[])
                .expect("a part");
            let prepared = load(&args, &KeptFiles::default()).expect("a task");
            let chosen = Chosen::new(robot_args, &prepared).expect("a robot");
            let chosen = chosen.expect("a robot");
            let read = read_robot(&chosen, &args).expect("a robot");
            let job = Job {
                task_args: &args,
                prepared: &prepared,
                robot: Some((&chosen, &read)),
                folder: &out,
                progress: &progress,
                clock: RunClock::start(),
            };
            let start = RoundStart {
                given: None,
                kept: Some(kept),
            };
            let mut session = job.session(job.config(Some(&run.rounds)), start);
            // The world of the step shows the same dirt as the world of the prediction.
            let surface = WorkSurface::from_task(&prepared.task);
            let world = World::new(&surface, prepared.simulation.clone(), prepared.task.seed);
            let step = session.step(&mut world.expect("a world"), &mut ignore_events);
            step.expect("a plan");
            assert!(session.first_observation().is_some());
            assert!(session.has_used_first_plan(), "{wiping} is planned twice");
        }
    }
}
