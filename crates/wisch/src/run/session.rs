//! The loop itself: a session advances one stage at a time.

mod executing;
mod first;
mod planning;

use super::detections::check_detections;
use super::measured_motion::MeasuredEnd;
use super::stance::root_pose;
use super::{
    AfterStop, Ending, Execution, Executor, ExecutorError, FirstPlan, Observer, OwnStrategy,
    PlannedRound, RobotSetup, RobotState, Round, RunConfig, RunError, RunEvent, RunWarning,
    WarningWatch,
};
use crate::follow::{Audit, FollowError, Workcell, WorkcellConfig, audit, follow, retreat};
use crate::interpret::{Belief, Doubt, Interpretation, Interpreter, ObservationUpdate};
use crate::plan::{Plan, predict};
use crate::recover::{
    RoundOutcome, TerminationPolicy, Verdict, expected_performance, is_done, limit_verdict,
    may_be_undone, next_task,
};
use crate::represent::{GoalState, Observation, Task};
use planning::NextPlan;
use std::sync::{Arc, OnceLock};

/// The stage that a session has completed.
///
/// ```
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::identity());
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// use wisch::run::NoExecutor;
/// let mut session = Session::new(&task, RunConfig::default());
/// assert_eq!(session.step(&mut NoExecutor, &mut ignore_events)?, Stage::Planned);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The strokes are planned.
    Planned,
    /// The joint motion and its predicted effect are computed.
    Followed,
    /// The motion is checked.
    Audited,
    /// The motion is executed.
    Executed,
    /// The measured data are interpreted.
    Interpreted,
    /// The verdict on the round is known.
    Decided,
    /// The session has ended.
    Ended,
}

/// A wiping task from its first plan to its last verdict.
///
/// ```
/// use wisch::run::{NoExecutor, Session, Stage, ignore_events};
/// # use wisch::represent::Task;
/// # fn plan_only(task: &Task) -> Result<(), Box<dyn std::error::Error>> {
/// let mut session = Session::new(task, Default::default());
/// session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
/// let metres = session.plan().map(|plan| plan.contact_distance());
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct Session<'a> {
    performer: Option<RobotSetup<'a>>,
    config: RunConfig,
    task: Task,
    belief: Belief,
    workcell: WorkcellConfig,
    /// Robot, tool and scene, from the first followed plan until the robot's base or the surface
    /// moves.
    cell: OnceLock<Result<Arc<Workcell>, FollowError>>,
    given: Option<Plan>,
    /// The plan of another session for the first round, until this session plans.
    first: Option<FirstPlan<'a>>,
    /// Whether the first round uses it.
    is_first_used: bool,
    own: Option<OwnStrategy<'a>>,
    goal: Option<GoalState>,
    judge: TerminationPolicy,
    state: State,
    rounds: Vec<Round>,
    /// The observation before the first round, if there is a camera; the outer `None` before it is taken.
    first_observation: Option<Option<Observation>>,
    /// Predicted range of the number of detections in the first observation, if it shows none.
    unseen: Option<[f64; 2]>,
    /// Compares the run with earlier runs.
    watch: Option<WarningWatch<'a>>,
    /// Warnings of the watch in the current round.
    warnings: Vec<RunWarning>,
    /// Doubts about the data of the current round that its interpretation does not find.
    doubts: Vec<Doubt>,
    is_stopped: bool,
    /// Last known joint positions, all n variables [rad or m]; `None` before the first measurement.
    stands: Option<Vec<f64>>,
    /// Measured end of the last motion; `None` before the first, and after a replayed one.
    measured_end: Option<MeasuredEnd>,
    /// Whether the last motion ended early, so that the next one begins with a retreat.
    retreats: bool,
    /// The error that ended the current execution.
    failure: Option<RunError>,
    /// Whether the executor is prepared for motions, so that it has to finish.
    is_prepared: bool,
    /// The error with which the executor finished, if there was one.
    finish_failure: Option<ExecutorError>,
}

/// Progress of the current round.
#[derive(Debug)]
enum State {
    Begin,
    Planned(NextPlan),
    Followed(Box<PlannedRound>),
    Audited(Box<PlannedRound>, Audit),
    Executed(Box<PlannedRound>, Audit, Execution, Box<Interpreter>),
    Interpreted(Box<PlannedRound>, Audit, Execution, Box<Interpretation>),
    /// Ended; with the motion that was not executed because of its faults, if there is one.
    Ended(Option<Box<(PlannedRound, Audit)>>),
}

impl<'a> Session<'a> {
    /// Returns a session before its first plan. Every seed derives from the task's.
    pub fn new(task: &Task, mut config: RunConfig) -> Self {
        config.plan.seed = task.seed;
        config.follow.seed = task.seed;
        Self {
            performer: None,
            belief: Belief::from_particles(task.particles.clone()),
            task: task.clone(),
            workcell: config.workcell.clone(),
            cell: OnceLock::new(),
            given: None,
            first: None,
            is_first_used: false,
            own: None,
            goal: None,
            judge: TerminationPolicy::new(config.target, config.pace),
            state: State::Begin,
            rounds: Vec::new(),
            first_observation: None,
            unseen: None,
            doubts: Vec::new(),
            watch: None,
            warnings: Vec::new(),
            is_stopped: false,
            stands: None,
            measured_end: None,
            retreats: false,
            failure: None,
            is_prepared: false,
            finish_failure: None,
            config,
        }
    }

    /// Adds a robot that follows the plans.
    #[must_use]
    pub fn with_robot(self, performer: RobotSetup<'a>) -> Self {
        Self {
            performer: Some(performer),
            cell: OnceLock::new(),
            ..self
        }
    }

    /// Sets the belief about the dirt; without it, the task's particles are the known dirt.
    #[must_use]
    pub fn with_belief(self, belief: Belief) -> Self {
        Self { belief, ..self }
    }

    /// The observation before the first round, if there is a camera.
    pub fn first_observation(&self) -> Option<&Observation> {
        self.first_observation.as_ref()?.as_ref()
    }

    /// Range of the number of detections that the belief predicted before the first round (5 % and
    /// 95 % quantiles), if the observation shows none: the surface is clean, or the camera does not
    /// detect the dirt. The goal is then unknown.
    pub const fn unseen_dirt(&self) -> Option<[f64; 2]> {
        self.unseen
    }

    /// Sets the plan for the first round; with `None` the session plans it.
    #[must_use]
    pub fn with_plan(self, given: Option<Plan>) -> Self {
        Self { given, ..self }
    }

    /// Sets a strategy of the user; the session plans every round by it that has no given plan.
    #[must_use]
    pub fn with_strategy(self, own: OwnStrategy<'a>) -> Self {
        Self {
            own: Some(own),
            ..self
        }
    }

    /// Adds a watch that compares the run with earlier runs while the robot wipes.
    /// [`RunConfig::on_warning`] determines the consequence of its warnings.
    #[must_use]
    pub fn with_warnings(self, watch: WarningWatch<'a>) -> Self {
        Self {
            watch: Some(watch),
            ..self
        }
    }

    /// The plan of the current round, or of the last one.
    pub fn plan(&self) -> Option<&Plan> {
        match &self.state {
            State::Planned(next) => Some(next.plan()),
            _ => self.planned_round().map(|planned| &planned.plan),
        }
    }

    /// The planned motion of the current round, or of the last one.
    pub fn planned_round(&self) -> Option<&PlannedRound> {
        match &self.state {
            State::Followed(planned)
            | State::Audited(planned, _)
            | State::Executed(planned, ..)
            | State::Interpreted(planned, ..) => Some(planned),
            State::Ended(Some(refused)) => Some(&refused.0),
            State::Begin | State::Planned(_) | State::Ended(None) => {
                self.rounds.last().map(|round| &round.motion)
            }
        }
    }

    /// The audit of the motion of [`Self::planned_round`]; `None` before the check.
    pub fn audit(&self) -> Option<&Audit> {
        match &self.state {
            State::Audited(_, audit)
            | State::Executed(_, audit, ..)
            | State::Interpreted(_, audit, ..) => Some(audit),
            State::Ended(Some(refused)) => Some(&refused.1),
            State::Planned(_) | State::Followed(_) => None,
            State::Begin | State::Ended(None) => self.rounds.last().map(|round| &round.audit),
        }
    }

    /// The first round's motion with its audit; `None` before the check.
    pub fn first_motion(&self) -> Option<(&PlannedRound, &Audit)> {
        match self.rounds.first() {
            Some(round) => Some((&round.motion, &round.audit)),
            None => self.planned_round().zip(self.audit()),
        }
    }

    /// The motion that was not executed because of its faults, with its audit, if the session ended with one.
    pub fn refused_motion(&self) -> Option<(&PlannedRound, &Audit)> {
        match &self.state {
            State::Ended(Some(refused)) if !refused.1.faults.is_empty() => {
                Some((&refused.0, &refused.1))
            }
            _ => None,
        }
    }

    /// The rounds with an execution and a verdict, in order; a motion with faults is not among them.
    pub fn rounds(&self) -> &[Round] {
        &self.rounds
    }

    /// Returns the same rounds as [`Self::rounds`], by value.
    pub fn into_rounds(self) -> Vec<Round> {
        self.rounds
    }

    /// Runs the session to its end.
    ///
    /// # Errors
    /// The errors of the stages, see [`RunError`]. If an execution fails, the data measured so far
    /// are first interpreted and get a verdict: the round is among [`Self::rounds`], with the
    /// ending [stopped](Ending::Stopped).
    pub fn run(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<(), RunError> {
        self.run_until(Stage::Ended, executor, observer)
    }

    /// Runs the session until it has completed a stage, or to its end.
    ///
    /// # Errors
    /// The errors of the stages, see [`RunError`].
    ///
    /// ```
    /// # use wisch::prelude::*;
    /// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
    /// # let surface = Surface::new("tray", outline, Pose::identity());
    /// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
    /// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
    /// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
    /// use wisch::run::NoExecutor;
    /// let mut session = Session::new(&task, RunConfig::default());
    /// session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
    /// assert!(session.plan().is_some() && session.rounds().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run_until(
        &mut self,
        stage: Stage,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<(), RunError> {
        loop {
            let reached = self.step(executor, observer)?;
            if reached == stage || reached == Stage::Ended {
                return Ok(());
            }
        }
    }

    /// Advances the session by one stage.
    ///
    /// At the end of the session, or after an error, a prepared executor
    /// [finishes](Executor::finish).
    ///
    /// # Errors
    /// The errors of the stage in the first round, see [`RunError`]. In later rounds, a missing
    /// plan or motion is a verdict.
    pub fn step(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let stage = self.advance(executor, observer);
        if matches!(stage, Ok(Stage::Ended) | Err(_)) {
            self.finish_executor(executor);
        }
        stage
    }

    fn advance(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        // An execution that was stopped is still interpreted and gets a verdict.
        if self.is_stopped && !matches!(self.state, State::Executed(..) | State::Interpreted(..)) {
            return Ok(self.end(None, observer));
        }
        let mut is_stopped = false;
        let mut watch = |event: &RunEvent<'_>| {
            let flow = observer(event);
            is_stopped |= flow.is_break();
            flow
        };
        let stage = match std::mem::replace(&mut self.state, State::Ended(None)) {
            State::Begin => self.plan_round(executor, &mut watch),
            State::Planned(next) => self.follow_round(next, &mut watch),
            State::Followed(planned) => self.audit_round(planned, &mut watch),
            State::Audited(planned, audit) => {
                self.execute_round(planned, audit, executor, &mut watch)
            }
            State::Executed(planned, audit, execution, interpreter) => {
                let executed = (planned, audit, execution);
                self.interpret_round(executed, *interpreter, executor, &mut watch)
            }
            State::Interpreted(planned, audit, execution, interpretation) => {
                self.judge_round(*planned, audit, execution, *interpretation, &mut watch)
            }
            State::Ended(refused) => {
                self.state = State::Ended(refused);
                Ok(Stage::Ended)
            }
        }?;
        self.is_stopped |= is_stopped && stage != Stage::Ended;
        Ok(stage)
    }

    /// Returns the goal of the first plan, which holds for all rounds.
    fn goal_of(&self, plan: &Plan) -> GoalState {
        self.goal.unwrap_or(plan.graph.goal)
    }

    fn number(&self) -> usize {
        self.rounds.len() + 1
    }

    /// Ends the session and reports it; `verdict`, if given, replaces that of the last round.
    fn end(&mut self, verdict: Option<Verdict>, observer: &mut Observer<'_>) -> Stage {
        if let (Some(last), Some(verdict)) = (self.rounds.last_mut(), verdict) {
            last.verdict = verdict;
        }
        self.is_stopped = false;
        self.state = State::Ended(None);
        let _ = observer(&RunEvent::Ended(verdict));
        Stage::Ended
    }

    /// Plans a round: the given plan, the user's own strategy, or the planner.
    fn plan_round(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let round = self.number();
        if round > self.config.max_rounds {
            return Ok(self.end(None, observer));
        }
        if observer(&RunEvent::Planning { round }).is_break() && round > 1 {
            return Ok(self.end(None, observer));
        }
        if self.config.sight.is_some() && self.first_observation.is_none() {
            self.observe_first(executor, observer)?;
        }
        if let Some(state) = executor.state()? {
            self.take_state(state)?;
        }
        if self.retreats && self.stands.is_none() {
            return Err(RunError::UnknownState { round });
        }
        let next = match self.next_plan(observer) {
            Ok(None) => {
                let last = self.rounds.last();
                let verdict =
                    last.map(|round| self.judge.conclude_without_gain(&round.interpretation));
                return Ok(self.end(verdict, observer));
            }
            Ok(Some(next)) => next,
            Err(_) if round > 1 => return Ok(self.end(Some(Verdict::NoWay), observer)),
            Err(error) => return Err(error),
        };
        let plan = next.plan();
        self.goal.get_or_insert(plan.graph.goal);
        let _ = observer(&RunEvent::Planned { round, plan });
        self.state = State::Planned(next);
        Ok(Stage::Planned)
    }

    /// Observes the surface before the first round; the first plan uses the observation.
    fn observe_first(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<(), RunError> {
        let Some(observation) = executor.observe(&self.task)? else {
            self.first_observation = Some(None);
            return Ok(());
        };
        let error = (self.config.sight).map_or(0.0, |sight| sight.sensor.position_error_m);
        let surface = &self.task.surface;
        let (observation, left_out) = check_detections(observation, surface, error, true)?;
        self.doubts.extend(left_out);
        let _ = observer(&RunEvent::Observed {
            round: 0,
            observation: &observation,
        });
        if let Some(sight) = self.config.sight {
            // A camera cannot see that dirt is at a goal that the planner has not chosen yet: nothing counts as
            // done.
            let goal = self.task.goal().unwrap_or(GoalState::Skimmed);
            let update = ObservationUpdate {
                observation: &observation,
                sight,
                surface: &self.task.surface,
                goal: &goal,
                seed: self.task.seed,
            };
            self.unseen = update.find_unseen(&self.belief);
            self.belief = self.belief.observe(&update);
            self.task.particles = self.belief.sample(self.task.seed)?;
        }
        self.first_observation = Some(Some(observation));
        Ok(())
    }

    /// Computes the joint motion of the round's plan.
    fn follow_round(
        &mut self,
        next: NextPlan,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let planned = match next {
            NextPlan::Alone(plan) => self.compute_motion(plan, observer).map(Box::new),
            NextPlan::Followed(planned, progress) => {
                report_motion(&planned, &progress, observer);
                Ok(planned)
            }
        };
        match planned {
            Ok(planned) => {
                self.state = State::Followed(planned);
                Ok(Stage::Followed)
            }
            Err(_) if self.number() > 1 => Ok(self.end(Some(Verdict::NoWay), observer)),
            Err(error) => Err(error),
        }
    }

    /// Returns robot, tool and scene. All plans of a round share them, and later rounds until the surface or the robot moves.
    fn place_robot(&self, setup: RobotSetup<'_>) -> Result<Arc<Workcell>, FollowError> {
        let build = || {
            let robot = setup.robot.clone();
            let cell = Workcell::new(robot, setup.srdf, &self.task, &self.workcell)?;
            Ok(Arc::new(match &self.stands {
                Some(stands) => cell.with_turns_of(stands),
                None => cell,
            }))
        };
        self.cell.get_or_init(build).clone()
    }

    /// Sets the last known joint positions, which determine the start of a robot on a base.
    fn set_positions(&mut self, positions: Option<Vec<f64>>) {
        self.stands = positions;
        let is_on_base = |cell: &Arc<Workcell>| cell.base().is_some();
        if matches!(self.cell.get(), Some(Ok(cell)) if is_on_base(cell)) {
            self.cell = OnceLock::new();
        }
    }

    /// Takes the positions that the executor states between motions, if there are any.
    ///
    /// # Errors
    /// If they contradict the measured end of the last motion.
    fn take_state(&mut self, state: RobotState) -> Result<(), RunError> {
        if state.positions.is_empty() {
            return Ok(());
        }
        if let Some(end) = &self.measured_end {
            end.check(&state.positions, "the state between the motions")?;
        }
        self.set_positions(Some(state.positions));
        Ok(())
    }

    /// Computes the joint motion of a plan and its predicted effect.
    fn compute_motion(
        &self,
        plan: Plan,
        observer: &mut Observer<'_>,
    ) -> Result<PlannedRound, RunError> {
        let performer = self.performer.ok_or(RunError::NoRobot)?;
        let (task, round) = (&self.task, self.number());
        let cell = self.place_robot(performer)?;
        let nodes = plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum();
        let mut followed = follow(
            task,
            &plan,
            &cell,
            performer.map,
            &self.config.follow,
            &mut |passed| {
                let _ = observer(&RunEvent::Following {
                    round,
                    passed,
                    nodes,
                });
            },
        )?;
        if let (true, Some(from)) = (self.retreats, &self.stands) {
            let (height, config) = (plan.lift_height, &self.config.follow);
            followed = followed.prepend(retreat(task, &cell, from, height, config)?);
        }
        let wiped = Plan {
            strokes: followed.strokes.clone(),
            ..plan.clone()
        };
        let prediction = predict(task, &wiped, |progress| {
            let _ = observer(&RunEvent::Predicting {
                round,
                task,
                wiped: &wiped,
                progress: *progress,
            });
        });
        Ok(PlannedRound {
            number: round,
            task: task.clone(),
            believed: self.belief.clone(),
            plan,
            cell,
            followed,
            prediction,
        })
    }

    /// Audits the motion; a motion with faults ends the session.
    fn audit_round(
        &mut self,
        planned: Box<PlannedRound>,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let PlannedRound {
            number,
            task,
            cell,
            followed,
            ..
        } = &*planned;
        let audit = audit(followed, cell, task, &self.config.follow)?;
        let _ = observer(&RunEvent::Audited {
            round: *number,
            audit: &audit,
        });
        let is_empty = followed.strokes.is_empty();
        if audit.faults.is_empty() && !is_empty {
            self.state = State::Audited(planned, audit);
            return Ok(Stage::Audited);
        }
        // A motion without a stroke moves nothing; the executor gets no order.
        let verdict = if audit.faults.is_empty() {
            Verdict::NoWay
        } else {
            Verdict::UnsafeMotion
        };
        let ended = self.end(Some(verdict), observer);
        self.state = State::Ended(Some(Box::new((*planned, audit))));
        Ok(ended)
    }

    /// Interprets the measured data, and the camera's observation if there is one.
    fn interpret_round(
        &mut self,
        (planned, audit, execution): (Box<PlannedRound>, Audit, Execution),
        interpreter: Interpreter,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let round = planned.number;
        let _ = observer(&RunEvent::Interpreting { round });
        let goal = self.goal_of(&planned.plan);
        let mut interpretation = interpreter.conclude(&planned.believed, &goal)?;
        for doubt in std::mem::take(&mut self.doubts) {
            interpretation.add_doubt(doubt);
        }
        // After the executor has failed, the session does not request an observation from it.
        let sight = self.config.sight.filter(|_| self.failure.is_none());
        let seen = sight.map(|_| executor.observe(&planned.task)).transpose();
        let kept = seen.map_err(RunError::from).and_then(|seen| {
            let error = sight.map_or(0.0, |sight| sight.sensor.position_error_m);
            let keep = |seen| check_detections(seen, &planned.task.surface, error, false);
            seen.flatten().map(keep).transpose()
        });
        let (seen, left_out) = match kept {
            Ok(Some((seen, doubts))) => (Some(seen), doubts),
            Ok(None) => (None, Vec::new()),
            // The executed part gets a verdict by contact forces alone, and is kept.
            Err(error) => {
                self.failure = Some(error);
                (None, Vec::new())
            }
        };
        if let (Some(sight), Some(observation)) = (sight, seen) {
            let _ = observer(&RunEvent::Observed {
                round,
                observation: &observation,
            });
            interpretation.observe(&ObservationUpdate {
                observation: &observation,
                sight,
                surface: &planned.task.surface,
                goal: &goal,
                seed: planned.task.seed,
            });
        }
        for doubt in left_out {
            interpretation.add_doubt(doubt);
        }
        self.state = State::Interpreted(planned, audit, execution, Box::new(interpretation));
        Ok(Stage::Interpreted)
    }

    /// Reaches the verdict on the round; either ends the session or prepares the next round.
    fn judge_round(
        &mut self,
        planned: PlannedRound,
        audit: Audit,
        execution: Execution,
        interpretation: Interpretation,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        let (task, goal) = (&self.task, self.goal_of(&planned.plan));
        let next = next_task(task, &goal, &interpretation, task.seed.wrapping_add(1))?;
        let verdict = self.judge.verdict(&RoundOutcome {
            interpretation: &interpretation,
            performance_before: expected_performance(&self.belief, &goal, &task.surface),
            is_done: is_done(&interpretation.belief, &goal, &next.surface, next.seed)?,
            is_protective_stop: matches!(execution.ending, Ending::ProtectiveStop { .. }),
        });
        let verdict = limit_verdict(verdict, task, &interpretation, self.config.target);
        let verdict = self.limit_by_earlier_rounds(verdict, &interpretation);
        let was_stopped = match &execution.ending {
            Ending::Stopped => self.is_stopped || self.config.after_stop == AfterStop::Wait,
            Ending::ProtectiveStop { cause, .. } => {
                !cause.kind().may_continue(self.config.after_stop)
            }
            Ending::Complete | Ending::Early { .. } => false,
        };
        let stands = execution.positions.clone();
        self.set_positions(Some(stands).filter(|stands| !stands.is_empty()));
        self.retreats = execution.ending != Ending::Complete;
        self.belief = interpretation.belief.clone();
        self.workcell.world_from_robot = Some(root_pose(&planned, &execution, &self.config));
        // The scene moves with the surface.
        if next.surface.world_from_surface != self.task.surface.world_from_surface {
            self.cell = OnceLock::new();
        }
        self.task = next;
        let round = Round {
            motion: planned,
            audit,
            execution,
            interpretation,
            warnings: std::mem::take(&mut self.warnings),
            verdict,
        };
        let _ = observer(&RunEvent::Decided(&round));
        self.rounds.push(round);
        let is_last = was_stopped || self.rounds.len() >= self.config.max_rounds;
        if let Some(error) = self.failure.take() {
            self.end(Some(verdict), observer);
            return Err(error);
        }
        if verdict != Verdict::Again || is_last {
            return Ok(self.end(Some(verdict), observer));
        }
        self.state = State::Begin;
        Ok(Stage::Decided)
    }

    /// Returns `verdict`, or [`Verdict::Undecidable`] instead of [`Verdict::GoalMet`] if wiping that no log shows may have undone
    /// the goal in an earlier round, and no observation has shown the dirt since.
    fn limit_by_earlier_rounds(&self, verdict: Verdict, last: &Interpretation) -> Verdict {
        let shows_dirt = |interpretation: &Interpretation| {
            interpretation.observation.is_some() && self.task.treatment.is_none()
        };
        let earlier = self.rounds.iter().rev().map(|round| &round.interpretation);
        let mut unseen = (std::iter::once(last).chain(earlier))
            .take_while(|interpretation| !shows_dirt(interpretation))
            .skip(1);
        if verdict == Verdict::GoalMet
            && unseen.any(|interpretation| may_be_undone(&self.task, interpretation))
        {
            return Verdict::Undecidable;
        }
        verdict
    }
}

/// Reports a motion that was computed earlier to the observer, as if it were computed now. `progress`: numbers of nodes that
/// the computation passed.
fn report_motion(planned: &PlannedRound, progress: &[usize], observer: &mut Observer<'_>) {
    let PlannedRound {
        number: round,
        task,
        plan,
        ..
    } = planned;
    let nodes = plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum();
    for passed in progress {
        let _ = observer(&RunEvent::Following {
            round: *round,
            passed: *passed,
            nodes,
        });
    }
    let wiped = planned.executable_plan();
    predict(task, &wiped, |progress| {
        let _ = observer(&RunEvent::Predicting {
            round: *round,
            task,
            wiped: &wiped,
            progress: *progress,
        });
    });
}
