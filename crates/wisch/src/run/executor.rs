//! The seam between the method and a world: what executes a motion, be it a simulator, a robot or a recording.

use super::{Execution, MotionOrder, RecordedSample, TelemetrySample};
use crate::represent::{Observation, Task};
use std::collections::VecDeque;
use std::fmt::Display;
use std::ops::ControlFlow;

/// Takes what is measured, sample by sample in the order of time, and may stop the execution.
pub type SampleSink<'a> = dyn FnMut(&TelemetrySample<'_>) -> ControlFlow<()> + 'a;

/// The only door to a world.
///
/// Nothing here tells the truth about the world: an executor hands out what a robot measures. A simulator opens its
/// truth elsewhere, for evaluations, and is nowhere within reach of this library:
///
/// ```compile_fail,E0432
/// use wisch_sim::World;
/// ```
///
/// ```
/// use std::ops::ControlFlow;
/// use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, SampleSink};
///
/// /// A robot that stays where it is.
/// struct Idle;
///
/// impl Executor for Idle {
///     fn execute(
///         &mut self,
///         order: &MotionOrder<'_>,
///         _: &mut SampleSink<'_>,
///     ) -> Result<Execution, ExecutorError> {
///         Ok(Execution::at_rest(order.cell.ready()))
///     }
/// }
/// ```
pub trait Executor {
    /// Executes a motion and hands every sample to the sink; ends early, as [`Stopped`](super::Ending::Stopped), when
    /// the sink says so.
    ///
    /// # Errors
    /// The world cannot execute it. That the robot stopped itself is no error but an [`Ending`](super::Ending).
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError>;

    /// Reports where the robot stands: all n variables [rad or m]; `None` where it does not know.
    ///
    /// # Errors
    /// The robot knows, and fails to say so.
    fn state(&mut self) -> Result<Option<Vec<f64>>, ExecutorError> {
        Ok(None)
    }

    /// Looks at the surface and tells what is seen of the dirt, in the frame of the task's surface; `None` where nothing
    /// can look.
    ///
    /// # Errors
    /// There is a camera, and it fails.
    fn observe(&mut self, _task: &Task) -> Result<Option<Observation>, ExecutorError> {
        Ok(None)
    }
}

impl<E: Executor + ?Sized> Executor for &mut E {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        (**self).execute(order, sink)
    }

    fn state(&mut self) -> Result<Option<Vec<f64>>, ExecutorError> {
        (**self).state()
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        (**self).observe(task)
    }
}

/// Why a world could not execute a motion, in its own words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ExecutorError {
    message: String,
}

impl ExecutorError {
    /// An error that says what the world says.
    pub fn new(cause: impl Display) -> Self {
        Self {
            message: cause.to_string(),
        }
    }
}

/// A round that was executed before: what was measured, and how it went.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedRound {
    /// What was measured, in the order of time.
    pub samples: Vec<RecordedSample>,
    /// How it went.
    pub execution: Execution,
    /// What was seen afterwards, if anything looked.
    pub observation: Option<Observation>,
}

/// Plays rounds that were executed before, then goes on with another executor.
///
/// A session that is killed and begun again computes the same motions; what was executed of them need not be
/// executed again.
#[derive(Debug, Clone)]
pub struct Recording<E> {
    rounds: VecDeque<RecordedRound>,
    /// What was seen before the first of them and after each.
    looks: VecDeque<Option<Observation>>,
    then: E,
}

impl<E> Recording<E> {
    /// Plays these rounds in their order, then hands the motions on; `first` was seen before the first of them.
    pub fn new(first: Option<Observation>, rounds: Vec<RecordedRound>, then: E) -> Self {
        let mut looks = VecDeque::new();
        if !rounds.is_empty() {
            looks.push_back(first);
            looks.extend(rounds.iter().map(|round| round.observation.clone()));
        }
        Self {
            rounds: rounds.into(),
            looks,
            then,
        }
    }

    /// The executor of the rounds after the recorded ones.
    pub const fn inner(&self) -> &E {
        &self.then
    }
}

impl<E: Executor> Executor for Recording<E> {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let Some(round) = self.rounds.pop_front() else {
            return self.then.execute(order, sink);
        };
        for recorded in &round.samples {
            let during = order.motion_at(recorded.time);
            let sample = during.and_then(|(motion, phase)| recorded.during(motion, phase));
            let Some(sample) = sample else {
                break;
            };
            if sink(&sample).is_break() {
                break;
            }
        }
        Ok(round.execution)
    }

    fn state(&mut self) -> Result<Option<Vec<f64>>, ExecutorError> {
        if self.rounds.is_empty() {
            self.then.state()
        } else {
            Ok(None)
        }
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        match self.looks.pop_front() {
            Some(look) => Ok(look),
            None => self.then.observe(task),
        }
    }
}

/// No world at all, for sessions that end before anything is executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NoExecutor;

impl Executor for NoExecutor {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        _: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let round = order.round;
        Err(ExecutorError::new(format!(
            "round {round}: there is no executor for this motion"
        )))
    }
}
