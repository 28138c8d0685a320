//! The execution of a round's motion.

use super::{Session, Stage, State};
use crate::follow::Audit;
use crate::geometry::Vector3;
use crate::interpret::{
    InterpretConfig, InterpretError, Interpreter, TouchSample, UnusableWrenches,
};
use crate::run::measured_motion::MeasuredMotion;
use crate::run::stance::{check_first_sample, check_positions, check_rest, check_start};
use crate::run::stroke_watch::StrokeWatch;
use crate::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, Observer, OnWarning, PlannedRound,
    RunConfig, RunError, RunEvent, RunWarning, StrokeEnd, TelemetrySample, WarningWatch,
    check_score,
};
use std::ops::ControlFlow;

/// The checks that may end a round within a stroke.
struct RoundWatch<'s, 'a> {
    /// Checks whether the stroke has an effect.
    stroke: Option<StrokeWatch>,
    /// Compares the round with earlier runs.
    watch: Option<&'s mut WarningWatch<'a>>,
    on_warning: OnWarning,
    warnings: Vec<RunWarning>,
    ended_early: Option<Ending>,
    /// Whether a warning stops the run.
    is_stopped: bool,
}

impl<'s, 'a> RoundWatch<'s, 'a> {
    /// Begins the checks of a round, and reports it to the watch for warnings.
    fn begin(
        config: &RunConfig,
        watch: Option<&'s mut WarningWatch<'a>>,
        planned: &PlannedRound,
    ) -> Self {
        let mut on_warning = config.on_warning;
        let mut watch = watch.filter(|_| on_warning != OnWarning::Ignore);
        if let Some(watch) = &mut watch {
            watch.check(&RunEvent::Executing(planned));
            if !watch.may_end(planned.number) {
                on_warning = OnWarning::Report;
            }
        }
        Self {
            stroke: (config.end_strokes_early).then(|| StrokeWatch::new(&planned.task)),
            watch,
            on_warning,
            warnings: Vec::new(),
            ended_early: None,
            is_stopped: false,
        }
    }

    /// Checks a sample; `Break` ends the round.
    fn check(
        &mut self,
        sample: &TelemetrySample<'_>,
        observer: &mut Observer<'_>,
    ) -> ControlFlow<()> {
        if let Some(watch) = &mut self.watch {
            for warning in watch.check(&RunEvent::Sample(sample)) {
                let flow = observer(&RunEvent::Warned(&warning));
                let cause = StrokeEnd::Warned {
                    channel: warning.channel,
                };
                self.warnings.push(warning);
                match self.on_warning {
                    OnWarning::Stop => self.is_stopped = true,
                    OnWarning::EndStroke if self.ended_early.is_none() => {
                        let time = sample.time;
                        self.ended_early = Some(Ending::Early { time, cause });
                    }
                    _ => {}
                }
                if flow.is_break() {
                    return flow;
                }
            }
        }
        if self.ended_early.is_none()
            && sample.status.shows_motion()
            && let Some(cause) = (self.stroke.as_mut()).and_then(|stroke| stroke.check(sample))
        {
            let time = sample.time;
            self.ended_early = Some(Ending::Early { time, cause });
        }
        match self.is_stopped || self.ended_early.is_some() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }
}

impl Session<'_> {
    /// Calls [`Executor::finish`] once if the executor is prepared; does nothing otherwise.
    ///
    /// [`step`](Self::step) does this at the end of the session and after an error. Call it to leave a session before its
    /// end. If the session continues later, it prepares its executor again.
    pub fn finish_executor(&mut self, executor: &mut dyn Executor) {
        if std::mem::take(&mut self.is_prepared) {
            self.finish_failure = executor.finish().err();
        }
    }

    /// The error of [`Executor::finish`], if it failed. The rounds are not affected by it.
    pub const fn finish_failure(&self) -> Option<&ExecutorError> {
        self.finish_failure.as_ref()
    }

    /// Keeps the measured end of a motion, from which the next one begins; a contradiction to the stated end is the failure
    /// of the run.
    fn take_measured_end(
        &mut self,
        measured: &MeasuredMotion,
        execution: &mut Execution,
        is_replay: bool,
    ) {
        if self.failure.is_some() {
            return;
        }
        match measured.find_end(execution, self.config.start_tolerance) {
            Ok(end) => {
                if let (true, Some(end)) = (execution.positions.is_empty(), &end) {
                    execution.positions = end.positions().to_vec();
                }
                self.measured_end = end.filter(|_| !is_replay);
            }
            Err(error) => self.failure = Some(error),
        }
    }

    /// Executes the motion and passes each sample to the interpreter and the observer.
    pub(super) fn execute_round(
        &mut self,
        planned: Box<PlannedRound>,
        audit: Audit,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Stage, RunError> {
        if planned.number == 1 {
            // Plans of later rounds have a positive predicted gain.
            check_score(
                &planned.prediction,
                planned.task.action,
                self.config.min_score,
            )?;
        }
        if observer(&RunEvent::Executing(&planned)).is_break() {
            self.state = State::Audited(planned, audit);
            return Ok(Stage::Audited);
        }
        self.prepare_motion(&planned, executor)?;
        let config = InterpretConfig {
            has_one_clock: true,
            ..InterpretConfig::from_task(&planned.task)
        };
        let mut interpreter = Interpreter::new(&planned.task, &config)?;
        let order = MotionOrder {
            round: planned.number,
            seed: planned.task.seed,
            task: &planned.task,
            cell: &planned.cell,
            followed: &planned.followed,
        };
        let mut measured = MeasuredMotion::new(&planned);
        let is_replay = executor.is_replay();
        let mut refused: Option<RunError> = None;
        let tolerance = self.config.start_tolerance;
        let mut watch = RoundWatch::begin(&self.config, self.watch.as_mut(), &planned);
        let mut is_broken_off = false;
        let hovers = planned.task.interaction.hovers();
        let executed = executor.execute(&order, &mut |sample| {
            let mut taken = take_touch(&mut interpreter, sample, hovers).map_err(RunError::from);
            if !(measured.has_positions() || sample.positions.is_empty()) {
                taken = taken.and_then(|()| check_first_sample(sample, &planned, tolerance));
            }
            if let Err(error) = taken {
                refused = Some(error);
                return ControlFlow::Break(());
            }
            measured.take(sample);
            let mut flow = observer(&RunEvent::Sample(sample));
            if flow.is_continue() {
                flow = watch.check(sample, observer);
            }
            is_broken_off |= flow.is_break();
            flow
        });
        let RoundWatch {
            warnings,
            ended_early,
            is_stopped,
            ..
        } = watch;
        self.warnings = warnings;
        self.is_stopped |= is_stopped;
        self.doubts.extend(measured.list_doubts());
        let broken_off = measured.keep_execution(&executed);
        let executed = match (executed, refused) {
            (_, Some(error)) => Err(error),
            (Err(error), None) => Err(error.into()),
            (Ok(execution), None) => check_positions(execution, &planned.cell, planned.number),
        };
        let mut execution = match (executed, broken_off) {
            (Ok(execution), _) => execution,
            // The data measured until then are still interpreted and get a verdict.
            (Err(error), Some(broken_off)) => {
                self.failure = Some(error);
                broken_off
            }
            (Err(error), None) => return Err(error),
        };
        // An executor may call a motion complete although wisch stopped it.
        if is_broken_off && execution.ending == Ending::Complete {
            execution.ending = Ending::Stopped;
        }
        if execution.ending == Ending::Stopped
            && let Some(ending) = ended_early.filter(|_| !is_stopped)
        {
            execution.ending = ending;
        }
        self.take_measured_end(&measured, &mut execution, is_replay);
        self.state = State::Executed(planned, audit, execution, Box::new(interpreter));
        Ok(Stage::Executed)
    }

    /// Prepares the executor before its first motion, and checks that the robot rests where the motion begins.
    fn prepare_motion(
        &mut self,
        planned: &PlannedRound,
        executor: &mut dyn Executor,
    ) -> Result<(), RunError> {
        if !self.is_prepared {
            executor.prepare(&planned.cell)?;
            self.is_prepared = true;
        }
        if let Some(state) = executor.state()? {
            check_rest(&state, planned)?;
            self.take_state(state)?;
        }
        if let Some(stands) = &self.stands {
            check_start(stands, planned, self.config.start_tolerance)?;
        }
        Ok(())
    }
}

/// Passes a sample to the interpreter: as a sample with contact forces, or as a sample without a
/// usable wrench. A tool that `hovers` is interpreted by its poses alone.
fn take_touch(
    interpreter: &mut Interpreter,
    sample: &TelemetrySample<'_>,
    hovers: bool,
) -> Result<(), InterpretError> {
    let is_usable = sample.status.wrench.is_usable();
    if !is_usable && !hovers {
        let mut unusable = UnusableWrenches::default();
        unusable.add(sample.status.wrench);
        interpreter.skip(unusable);
        return Ok(());
    }
    interpreter.push(&TouchSample {
        time: sample.time,
        world_from_tool: sample.world_from_tool,
        force: if is_usable {
            sample.external.force
        } else {
            Vector3::zeros()
        },
    })
}
