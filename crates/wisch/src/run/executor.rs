//! The interface between the method and a world: an executor of motions, in a simulator, on a robot or from a
//! recording.

use super::{Execution, MotionOrder, Pause, RecordedSample, TelemetrySample};
use crate::follow::Workcell;
use crate::represent::{Observation, Task};
use std::collections::VecDeque;
use std::fmt::Display;
use std::ops::ControlFlow;

/// Receives the measured samples in the order of time, and may stop the execution.
pub type SampleSink<'a> = dyn FnMut(&TelemetrySample<'_>) -> ControlFlow<()> + 'a;

/// The interface to a world: the only way in which this library moves a robot and measures.
///
/// An executor reports what a robot measures, never the ground truth. A simulator offers its ground truth
/// through its own API, for evaluations; this library cannot access it:
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
///         Ok(Execution::from_positions(order.cell.ready_posture()))
///     }
/// }
/// ```
pub trait Executor {
    /// Prepares the robot for motions, before the first of a run; for example, switches controllers or tares a sensor.
    /// It must not move the robot.
    ///
    /// `cell`: the robot with the tool in its hand.
    ///
    /// # Errors
    /// If the robot cannot be prepared. Then nothing moves, and [`Self::finish`] is not called.
    fn prepare(&mut self, _cell: &Workcell) -> Result<(), ExecutorError> {
        Ok(())
    }

    /// Executes a motion and passes every sample to the sink; ends early, as
    /// [`Stopped`](super::Ending::Stopped), when the sink returns `Break`.
    ///
    /// # Errors
    /// If the world cannot execute the motion. A robot that stops itself is no error but an
    /// [`Ending`](super::Ending).
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError>;

    /// Reports the robot's measured state; `None` if the executor does not know it.
    ///
    /// A motion begins only if the robot is at its start and at rest.
    ///
    /// # Errors
    /// If the executor knows the state, but cannot read it.
    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        Ok(None)
    }

    /// Whether the next motion is replayed from a recording, so that the robot may have moved since.
    fn is_replay(&self) -> bool {
        false
    }

    /// Observes the dirt with a camera, in the frame of the task's surface; `None` without a camera.
    ///
    /// # Errors
    /// If the camera fails.
    fn observe(&mut self, _task: &Task) -> Result<Option<Observation>, ExecutorError> {
        Ok(None)
    }

    /// Reverses [`Self::prepare`] after the last motion of a run; for example, returns control of
    /// the robot. A session calls it once after every successful preparation, even after a stop or
    /// an error.
    ///
    /// # Errors
    /// If control is not returned. The rounds are kept.
    fn finish(&mut self) -> Result<(), ExecutorError> {
        Ok(())
    }
}

impl<E: Executor + ?Sized> Executor for &mut E {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        (**self).prepare(cell)
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        (**self).finish()
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        (**self).execute(order, sink)
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        (**self).state()
    }

    fn is_replay(&self) -> bool {
        (**self).is_replay()
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        (**self).observe(task)
    }
}

/// The measured state of a robot.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RobotState {
    /// Positions of all n variables [rad or m]; empty if they are not known.
    pub positions: Vec<f64>,
    /// Their velocities [rad/s or m/s]; empty if they are not measured.
    pub velocities: Vec<f64>,
}

impl From<Vec<f64>> for RobotState {
    /// Returns the state of a robot whose velocities are not measured.
    fn from(positions: Vec<f64>) -> Self {
        Self {
            positions,
            velocities: Vec::new(),
        }
    }
}

/// The reason why a world could not execute a motion, as the world reports it.
///
/// ```
/// use wisch::run::ExecutorError;
/// let error = ExecutorError::new("the driver is off");
/// assert!(error.to_string().contains("the driver is off"));
/// assert!(!error.is_interruption() && error.with_interruption().is_interruption());
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct ExecutorError {
    message: String,
    pauses: Vec<Pause>,
    dropped_samples: usize,
    is_interruption: bool,
}

impl ExecutorError {
    /// Returns an error with the text of its cause.
    pub fn new(cause: impl Display) -> Self {
        Self {
            message: cause.to_string(),
            pauses: Vec::new(),
            dropped_samples: 0,
            is_interruption: false,
        }
    }

    /// Marks the error as an interruption by the operator, and not as a fault of the executor.
    #[must_use]
    pub fn with_interruption(self) -> Self {
        Self {
            is_interruption: true,
            ..self
        }
    }

    /// Whether the operator interrupted the executor.
    pub const fn is_interruption(&self) -> bool {
        self.is_interruption
    }

    /// Adds the known data of a motion that ended with this error, in addition to the samples that
    /// the sink received.
    ///
    /// `pauses`: its pauses, in the order of time. `dropped_samples`: number of samples that did not reach the sink.
    #[must_use]
    pub fn with_execution(self, pauses: Vec<Pause>, dropped_samples: usize) -> Self {
        Self {
            pauses,
            dropped_samples,
            ..self
        }
    }

    /// The pauses of the motion that ended with this error.
    pub fn pauses(&self) -> &[Pause] {
        &self.pauses
    }

    /// Number of samples of that motion that did not reach the sink.
    pub const fn dropped_samples(&self) -> usize {
        self.dropped_samples
    }
}

/// A round that was executed earlier, with its samples.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedRound {
    /// The samples, in the order of time.
    pub samples: Vec<RecordedSample>,
    /// The result of the execution.
    pub execution: Execution,
    /// The observation after the round, if there was one.
    pub observation: Option<Observation>,
}

/// An executor that replays recorded rounds, then continues with another executor.
///
/// A session that was interrupted and starts again computes the same motions. With this executor,
/// it does not execute completed motions again.
#[derive(Debug, Clone)]
pub struct Recording<E> {
    rounds: VecDeque<RecordedRound>,
    /// Observations before the first recorded round and after each.
    observations: VecDeque<Option<Observation>>,
    then: E,
}

impl<E> Recording<E> {
    /// Returns an executor that replays `rounds` in order, then passes motions to `then`. `first`: the
    /// observation before the first round.
    pub fn new(first: Option<Observation>, rounds: Vec<RecordedRound>, then: E) -> Self {
        let mut observations = VecDeque::new();
        if !rounds.is_empty() {
            observations.push_back(first);
            observations.extend(rounds.iter().map(|round| round.observation.clone()));
        }
        Self {
            rounds: rounds.into(),
            observations,
            then,
        }
    }

    /// Returns the executor that executes the rounds after the recorded rounds.
    pub const fn inner(&self) -> &E {
        &self.then
    }
}

impl<E: Executor> Executor for Recording<E> {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        self.then.prepare(cell)
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        self.then.finish()
    }

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
            let sample = during.and_then(|(motion, phase)| recorded.to_sample(motion, phase));
            let Some(sample) = sample else {
                break;
            };
            if sink(&sample).is_break() {
                break;
            }
        }
        Ok(round.execution)
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        if self.rounds.is_empty() {
            self.then.state()
        } else {
            Ok(None)
        }
    }

    fn is_replay(&self) -> bool {
        !self.rounds.is_empty()
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        match self.observations.pop_front() {
            Some(look) => Ok(look),
            None => self.then.observe(task),
        }
    }
}

/// An executor without a world, for sessions that end before any execution.
///
/// ```
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::identity());
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// use wisch::run::NoExecutor;
/// // A session that only plans needs no executor.
/// let mut session = Session::new(&task, RunConfig::default());
/// session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
