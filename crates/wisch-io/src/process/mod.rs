//! An executor in another process: any program that implements the protocol of `docs/executor-protocol.md`.

mod backlog;
mod child;
mod described;
mod intake;
mod message;
mod observation;
mod pause_switch;
mod printable;
mod progress;
mod status;

pub use child::kill_executors;
pub use described::DriverRobotRecord;
pub use intake::{DoneRecord, EndingRecord, Intake, SampleRecord, StopKindRecord, WrenchAxes};
pub use message::MAX_SILENCE_S;
pub use observation::ObservationRecord;
pub use pause_switch::PauseSwitch;
pub use status::{PauseRecord, ResumeRecord, StampClockRecord, WrenchQualityRecord};

use child::{ChildGroup, Heard, MotionWatch, shortened};
use message::{FromChild, MotionHead, ReadyRecord, ToChild, TrajectoryPoint};
use printable::printable;
use progress::Progress;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use wisch::follow::Workcell;
use wisch::represent::{Observation, SurfaceShape, Task};
use wisch::run::{
    Execution, Executor, ExecutorError, MotionOrder, RobotState, SampleSink, Setpoint,
};

/// The newest version of the protocol.
pub const EXECUTOR_PROTOCOL: u32 = 2;

/// All versions of the protocol that a child may speak.
const VERSIONS: [u32; 2] = [1, EXECUTOR_PROTOCOL];

/// Default limit of silence, after which the child is abandoned.
const SILENCE: Duration = Duration::from_secs(60);
/// Time for the child to end by itself after its last request.
const FAREWELL: Duration = Duration::from_secs(2);
/// Time for a faulty or abandoned child to end by itself.
const FAREWELL_AFTER_FAULT: Duration = Duration::from_millis(300);
/// Maximum length of a child's text in messages [characters].
const MAX_SHOWN: usize = 400;
/// Longest time between a request to pause and the answer.
const PAUSE_LIMIT: Duration = Duration::from_secs(5);
/// Period at which the end of a pause before a motion is checked.
const PAUSE_POLL: Duration = Duration::from_millis(20);
/// Sampling period of the trajectories that the child receives [s].
const TRAJECTORY_PERIOD: f64 = 0.01;

/// An executor in a child process (a robot driver or a simulator), which communicates over its standard streams.
///
/// Its standard error is copied to this program's standard error, with control characters escaped. The child has its own
/// process group. When the executor is dropped, the child is asked to end; after two seconds its group is killed.
///
/// ```
/// use wisch_io::ProcessExecutor;
/// let error = ProcessExecutor::start("no-such-program", &[]).unwrap_err();
/// assert!(error.to_string().contains("no-such-program"));
/// ```
#[derive(Debug)]
pub struct ProcessExecutor {
    name: String,
    child: ChildGroup,
    silence: Duration,
    /// Set by the caller to stop the motion.
    stop: Arc<AtomicBool>,
    /// Set by an operator to pause the motion.
    pause: Arc<PauseSwitch>,
    /// What the child is able to do.
    ready: ReadyRecord,
    /// Whether it violated the protocol or is abandoned.
    is_faulty: bool,
    /// Whether its last motion has ended, or it has received a stop for it.
    was_stopped: bool,
    /// Whether it has received `prepare` and no `finish` yet.
    is_prepared: bool,
}

/// Settings of an executor in a child process.
#[derive(Debug, Clone)]
pub struct ProcessOptions {
    /// Limit for the greeting and between all later messages.
    pub silence: Duration,
    /// Flag that the caller sets to stop the child's motion at any time.
    pub stop: Arc<AtomicBool>,
    /// Switch with which an operator pauses motions.
    pub pause: Arc<PauseSwitch>,
    /// The robot's description, which the child receives with the greeting; `None` sends none.
    pub robot: Option<DriverRobotRecord>,
}

impl Default for ProcessOptions {
    /// A limit of one minute, and no description of a robot.
    fn default() -> Self {
        Self {
            silence: SILENCE,
            stop: Arc::default(),
            pause: Arc::default(),
            robot: None,
        }
    }
}

/// What ends the wait for a message early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heeds {
    Nothing,
    /// A request to stop.
    Interruption,
    /// A request to stop, or another wish than the child has received: to pause, or to continue.
    Operator {
        paused: bool,
    },
}

/// The reason why no message arrived.
enum Unheard {
    Silent,
    Interrupted,
}

impl ProcessExecutor {
    /// Starts a program with its arguments and waits until it is ready.
    ///
    /// ```no_run
    /// let robot = wisch_io::ProcessExecutor::start("python3", &["my_robot.py".to_owned()])?;
    /// # Ok::<(), wisch::run::ExecutorError>(())
    /// ```
    ///
    /// # Errors
    /// If the program does not start, or does not send its greeting in this protocol version within a minute.
    pub fn start(program: &str, arguments: &[String]) -> Result<Self, ExecutorError> {
        Self::start_with(program, arguments, ProcessOptions::default())
    }

    /// Starts a program with settings.
    ///
    /// # Errors
    /// As [`Self::start`].
    pub fn start_with(
        program: &str,
        arguments: &[String],
        options: ProcessOptions,
    ) -> Result<Self, ExecutorError> {
        let child = ChildGroup::start(program, arguments)
            .map_err(|error| ExecutorError::new(format!("executor {program:?}: {error}")))?;
        let mut executor = Self {
            name: program.to_owned(),
            child,
            silence: options.silence,
            stop: options.stop,
            pause: options.pause,
            ready: ReadyRecord::default(),
            is_faulty: false,
            was_stopped: true,
            is_prepared: false,
        };
        executor.say(&ToChild::Hello {
            protocol: "wisch-executor",
            version: VERSIONS[0],
            versions: VERSIONS,
            robot: options.robot.as_ref().filter(|robot| robot.has_space()),
        })?;
        match executor.answer()? {
            FromChild::Ready(ready) => {
                ready.check().map_err(|problem| executor.fault(problem))?;
                executor.ready = ready;
                executor.pause.set_supported(ready.pauses);
                if ready.real_time {
                    executor.child.backlog().set_real_time();
                }
                Ok(executor)
            }
            other => Err(executor.unexpected("\"ready\"", &other)),
        }
    }

    /// Sets the time after which a child is abandoned that sends no message, makes no progress along its motion, or continues
    /// after a stop; default one minute.
    #[must_use]
    pub fn with_silence_limit(mut self, silence: Duration) -> Self {
        self.silence = silence;
        self
    }

    /// Marks the child as faulty, so that it gets no further requests, and returns the error.
    fn fault(&mut self, problem: impl std::fmt::Display) -> ExecutorError {
        self.is_faulty = true;
        let problem = printable(&problem.to_string(), MAX_SHOWN);
        ExecutorError::new(format!("executor {:?}: {problem}", self.name))
    }

    fn interruption(&mut self) -> ExecutorError {
        self.fault("interrupted before the motion began")
            .with_interruption()
    }

    fn unexpected(&mut self, wanted: &str, found: &FromChild) -> ExecutorError {
        self.fault(format!("expected {wanted}, found {}", found.kind()))
    }

    fn silent(&mut self, silence: Duration) -> ExecutorError {
        let seconds = silence.as_secs_f64();
        self.fault(format!("no message for {seconds} s"))
    }

    fn is_interrupted(&self) -> bool {
        self.stop.load(Ordering::SeqCst)
    }

    fn line(&mut self, message: &ToChild<'_>) -> Result<Vec<u8>, ExecutorError> {
        let mut line = serde_json::to_vec(message).map_err(|error| self.fault(error))?;
        line.push(b'\n');
        Ok(line)
    }

    fn say(&mut self, message: &ToChild<'_>) -> Result<(), ExecutorError> {
        let line = self.line(message)?;
        self.child.say(line);
        Ok(())
    }

    /// Sends a request, unless the child has sent a message without a request, which is an error.
    fn ask(&mut self, request: &ToChild<'_>) -> Result<(), ExecutorError> {
        self.check_unasked()?;
        self.say(request)
    }

    /// Refuses a message that has arrived without a request: it would be taken for the answer to
    /// the next one.
    fn check_unasked(&mut self) -> Result<(), ExecutorError> {
        let Some(line) = self.child.take_unasked() else {
            return Ok(());
        };
        let line = line.map_err(|problem| self.fault(problem))?;
        match serde_json::from_str::<FromChild>(&line) {
            Ok(FromChild::Error(problem)) => Err(self.fault(problem)),
            Ok(message) => Err(self.fault(format!("it sent {} without a request", message.kind()))),
            Err(error) => Err(self.fault(line_fault(&line, &error))),
        }
    }

    /// Waits for the next message until the deadline, or until an event that `heeds` names.
    fn hear(
        &mut self,
        deadline: Instant,
        heeds: Heeds,
    ) -> Result<Result<FromChild, Unheard>, ExecutorError> {
        let heard = self.hear_timed(deadline, heeds)?;
        Ok(heard.map(|(message, _)| message))
    }

    /// Waits for the next message like [`Self::hear`], and states when it was received.
    fn hear_timed(
        &mut self,
        deadline: Instant,
        heeds: Heeds,
    ) -> Result<Result<(FromChild, Instant), Unheard>, ExecutorError> {
        let (stop, pause) = (Arc::clone(&self.stop), Arc::clone(&self.pause));
        let is_stopped = || heeds != Heeds::Nothing && stop.load(Ordering::SeqCst);
        let is_paused =
            || matches!(heeds, Heeds::Operator { paused } if pause.is_wanted() != paused);
        let goes_on = || !(is_stopped() || is_paused());
        let (line, received) = match self.child.hear(deadline, goes_on) {
            Heard::Line(line, received) => (line, received),
            Heard::Over(problem) => return Err(self.fault(problem)),
            Heard::Nothing if heeds != Heeds::Nothing && self.is_interrupted() => {
                return Ok(Err(Unheard::Interrupted));
            }
            Heard::Nothing => return Ok(Err(Unheard::Silent)),
        };
        let message = serde_json::from_str(&line);
        match message.map_err(|error| self.fault(line_fault(&line, &error)))? {
            FromChild::Error(problem) => Err(self.fault(problem)),
            message => Ok(Ok((message, received))),
        }
    }

    /// Waits for the answer to a request.
    fn answer(&mut self) -> Result<FromChild, ExecutorError> {
        match self.hear(Instant::now() + self.silence, Heeds::Interruption)? {
            Ok(message) => Ok(message),
            Err(Unheard::Silent) => Err(self.silent(self.silence)),
            Err(Unheard::Interrupted) => Err(self
                .fault("interrupted before its answer")
                .with_interruption()),
        }
    }

    fn order(&mut self, order: &MotionOrder<'_>) -> Result<(), ExecutorError> {
        let version = self.ready.version;
        let points: Vec<Setpoint> = match self.ready.knot_error_rad {
            Some(error) => order.knots(error),
            None => order.setpoints(TRAJECTORY_PERIOD).collect(),
        };
        if points.is_empty() {
            return Err(self.fault("the motion is empty"));
        }
        let head = MotionHead::new(order, points.len(), version);
        self.ask(&ToChild::Execute(Box::new(head)))?;
        for point in points {
            self.say(&ToChild::Point(TrajectoryPoint::new(point, version)))?;
        }
        Ok(())
    }
}

/// Describes a line that is not a message of the protocol.
fn line_fault(line: &str, error: &serde_json::Error) -> String {
    let shown = shortened(line, error.column());
    let words = error.to_string();
    // The line number that follows counts from this line.
    let words = words.split(" at line ").next().unwrap_or_default();
    if error.is_data() {
        return format!("its line {shown} is not a message of the protocol: {words}");
    }
    // An array with more numbers than expected is JSON, but no data error.
    if serde_json::from_str::<serde::de::IgnoredAny>(line).is_ok() {
        let column = error.column();
        return format!(
            "its line {shown} is not a message of the protocol: {words} at column {column}; expected arrays of the documented length"
        );
    }
    format!(
        "its line {shown} is not JSON from column {} on ({words}); expected one message per line, such as \
         {{\"ready\": {{\"version\": {EXECUTOR_PROTOCOL}}}}}, and any other text on standard error",
        error.column()
    )
}

impl Executor for ProcessExecutor {
    fn prepare(&mut self, _: &Workcell) -> Result<(), ExecutorError> {
        if !self.ready.prepares {
            return Ok(());
        }
        self.ask(&ToChild::Prepare)?;
        // An interruption is handled after the answer: a robot that is prepared for nothing is
        // better than one that is prepared by half.
        match self.hear(Instant::now() + self.silence, Heeds::Nothing)? {
            Ok(FromChild::Prepared) => {
                self.is_prepared = true;
                Ok(())
            }
            Ok(other) => Err(self.unexpected("\"prepared\"", &other)),
            Err(_) => Err(self.silent(self.silence)),
        }
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        let is_well = !self.is_faulty && !self.is_interrupted();
        // The robot is handed back even if its driver is at fault.
        let unasked = if is_well {
            self.check_unasked()
        } else {
            Ok(())
        };
        if !std::mem::take(&mut self.is_prepared) {
            return unasked;
        }
        self.stop_after_fault();
        self.say(&ToChild::Finish)?;
        let limit = if self.is_faulty {
            FAREWELL
        } else {
            self.silence
        };
        let deadline = Instant::now() + limit;
        if self.is_faulty || self.is_interrupted() {
            return unasked.and(self.hear_finished(deadline, limit));
        }
        match self.hear(deadline, Heeds::Nothing)? {
            Ok(FromChild::Finished) => Ok(()),
            Ok(other) => Err(self.unexpected("\"finished\"", &other)),
            Err(_) => Err(self.silent(limit)),
        }
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        if self.is_interrupted() {
            return Err(self.interruption());
        }
        self.check_shape(order.task)?;
        let clock = self.ready.stamp_clock.map(|clock| clock.0);
        let mut intake = Intake::new(order, sink).with_stamp_clock(clock);
        self.was_stopped = false;
        self.order(order)?;
        let dropped_before = self.child.backlog().dropped_count();
        let executed = self.receive(&mut intake, dropped_before).map_err(|error| {
            let dropped = self.child.backlog().dropped_count() - dropped_before;
            error.with_execution(intake.pauses().to_vec(), dropped)
        });
        // A robot whose driver failed must not go on while its data are interpreted.
        if executed.is_err() && !self.was_stopped {
            let _ = self.say(&ToChild::Stop);
        }
        self.was_stopped = true;
        executed
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        // A person may move a robot that is paused, so the state is asked for afterwards.
        self.wait_while_paused()?;
        if !self.ready.reports_state {
            return Ok(None);
        }
        self.ask(&ToChild::State)?;
        match self.answer()? {
            FromChild::State(state) => state.into_state().map_err(|error| self.fault(error)),
            other => Err(self.unexpected("\"state\"", &other)),
        }
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        self.check_shape(task)?;
        self.ask(&ToChild::Observe {
            surface: &task.surface.name,
        })?;
        match self.answer()? {
            FromChild::Observation(None) => Ok(None),
            FromChild::Observation(Some(_))
                if matches!(task.surface.shape, SurfaceShape::Mesh(_)) =>
            {
                let name = &task.surface.name;
                Err(self.fault(format!(
                    "surface {name:?} is a mesh, whose chart the protocol does not state, so that no detections can be given in it; expected {{\"observation\": null}}"
                )))
            }
            FromChild::Observation(Some(seen)) => seen
                .into_observation()
                .map(Some)
                .map_err(|error| self.fault(error)),
            other => Err(self.unexpected("\"observation\"", &other)),
        }
    }
}

impl ProcessExecutor {
    /// Refuses a curved surface for a child that does not accept one, and a mesh for a tool that leans.
    fn check_shape(&mut self, task: &Task) -> Result<(), ExecutorError> {
        let name = &task.surface.name;
        let problem = match task.surface.shape {
            SurfaceShape::Plane => return Ok(()),
            _ if !self.ready.accepts_curved => {
                "is curved, so that its normal differs from place to place; an executor that presses along the normal under the tool states accepts_curved in \"ready\""
            }
            // Along the axis of another tool, an executor finds the normal in world_from_tool.
            SurfaceShape::Mesh(_) if task.tool.tilt.is_some() => {
                "is a mesh, whose normals the protocol does not state where a tool may lean; choose a tool without tilt"
            }
            _ => return Ok(()),
        };
        Err(self.fault(format!("surface {name:?} {problem}")))
    }

    /// Waits for "finished" after a fault or an interruption; further messages about the
    /// interrupted request are ignored.
    fn hear_finished(&mut self, deadline: Instant, limit: Duration) -> Result<(), ExecutorError> {
        loop {
            match self.child.hear(deadline, || true) {
                Heard::Line(line, _) => match serde_json::from_str(&line) {
                    Ok(FromChild::Finished) => return Ok(()),
                    Ok(FromChild::Error(problem)) => return Err(self.fault(problem)),
                    _ => {}
                },
                Heard::Over(problem) => return Err(self.fault(problem)),
                Heard::Nothing => return Err(self.silent(limit)),
            }
        }
    }

    /// Stops a robot that may still be moving after a fault or an interruption.
    fn stop_after_fault(&mut self) {
        if (self.is_faulty || self.is_interrupted()) && !self.was_stopped {
            self.was_stopped = true;
            let _ = self.say(&ToChild::Stop);
        }
    }

    /// Waits while the operator pauses between motions.
    fn wait_while_paused(&mut self) -> Result<(), ExecutorError> {
        while self.pause.is_wanted() {
            if self.is_interrupted() {
                return Err(self.interruption());
            }
            std::thread::sleep(PAUSE_POLL);
        }
        Ok(())
    }

    /// Receives the samples of a motion until its end.
    fn receive(
        &mut self,
        intake: &mut Intake<'_>,
        dropped_before: usize,
    ) -> Result<Execution, ExecutorError> {
        let silence = (self.ready.max_silence_s).map_or(self.silence, |seconds| {
            self.silence.min(Duration::from_secs_f64(seconds))
        });
        let stop = self.line(&ToChild::Stop)?;
        let watch = self.child.watch(silence, stop);
        let executed = self.receive_watched(intake, &watch, dropped_before);
        self.was_stopped |= watch.end();
        executed
    }

    fn receive_watched(
        &mut self,
        intake: &mut Intake<'_>,
        watch: &MotionWatch,
        dropped_before: usize,
    ) -> Result<Execution, ExecutorError> {
        let mut progress = Progress::begin();
        let mut now = Instant::now();
        loop {
            if progress.told.is_none() && (intake.is_stopped() || self.is_interrupted()) {
                progress.told = Some(Instant::now());
                self.was_stopped = true;
                // A child that fell silent has received it already.
                if !watch.end() {
                    self.say(&ToChild::Stop)?;
                }
            }
            self.ask_for_pause(&mut progress, intake, now)?;
            let deadline = progress.deadline(self.silence);
            let heeds = match progress.told {
                None if self.ready.pauses => Heeds::Operator {
                    paused: progress.asked.is_some(),
                },
                None => Heeds::Interruption,
                Some(_) => Heeds::Nothing,
            };
            let heard = self.hear_timed(deadline, heeds)?;
            now = heard
                .as_ref()
                .map_or_else(|_| Instant::now(), |(_, received)| *received);
            match heard.map(|(message, _)| message) {
                Ok(FromChild::Sample(sample)) => {
                    intake.take(&sample).map_err(|e| self.fault(e))?;
                    progress.hear(intake, now);
                }
                Ok(FromChild::Paused(pause)) => {
                    intake.pause(&pause).map_err(|e| self.fault(e))?;
                    progress.pause();
                }
                Ok(FromChild::Resumed(resumed)) => {
                    intake.resume(resumed).map_err(|e| self.fault(e))?;
                    progress.resume(intake, now);
                    // Who continues at the robot ends the operator's pause.
                    if progress.asked.take().is_some() {
                        self.pause.end();
                    }
                }
                Ok(FromChild::Done(done)) => {
                    let dropped = self.child.backlog().dropped_count() - dropped_before;
                    intake.note_dropped(dropped);
                    if progress.told.is_some() || self.is_interrupted() || watch.end() {
                        intake.note_stop_request();
                    }
                    return intake.done(done).map_err(|e| self.fault(e));
                }
                Ok(other) => return Err(self.unexpected("a sample", &other)),
                Err(_) => {}
            }
            if let Some(problem) = progress.overdue(self.silence, intake, now) {
                return Err(self.fault(problem));
            }
        }
    }

    /// Passes the operator's wish to pause or to continue on to the child, once. `now`: time until which its messages are known.
    ///
    /// # Errors
    /// If the child continues although it was asked to pause.
    fn ask_for_pause(
        &mut self,
        progress: &mut Progress,
        intake: &Intake<'_>,
        now: Instant,
    ) -> Result<(), ExecutorError> {
        if !self.ready.pauses || progress.told.is_some() {
            return Ok(());
        }
        let is_wanted = self.pause.is_wanted();
        if is_wanted != progress.asked.is_some() {
            progress.asked = is_wanted.then(Instant::now);
            self.say(if is_wanted {
                &ToChild::Pause
            } else {
                &ToChild::Resume
            })?;
        }
        let goes_on = !intake.is_paused()
            && (progress.asked)
                .is_some_and(|asked| now.saturating_duration_since(asked) > PAUSE_LIMIT);
        if goes_on {
            let seconds = PAUSE_LIMIT.as_secs();
            return Err(self.fault(format!("it has not paused {seconds} s after \"pause\"")));
        }
        Ok(())
    }
}

impl Drop for ProcessExecutor {
    fn drop(&mut self) {
        self.stop_after_fault();
        let _ = self.finish();
        // A driver that prepares may be handing the robot back.
        self.child.end(if self.is_faulty && !self.ready.prepares {
            FAREWELL_AFTER_FAULT
        } else {
            FAREWELL
        });
    }
}
