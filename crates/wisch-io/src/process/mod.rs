//! An executor in another process: any program that speaks the protocol of `docs/executor-protocol.md`.

mod intake;
mod message;

pub use intake::{DoneRecord, EndingRecord, Intake, ObservationRecord, SampleRecord};

use message::{FromChild, MotionHead, ToChild};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::time::{Duration, Instant};
use wisch::represent::{Observation, Task};
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, SampleSink, Setpoint};

/// The version of the protocol.
pub const EXECUTOR_PROTOCOL: u32 = 1;

/// Longest line that is read [bytes].
const MAX_LINE: u64 = 1 << 20;
/// Lines that may wait to be taken in.
const QUEUE: usize = 4096;
/// A child that says nothing for so long is given up.
const SILENCE: Duration = Duration::from_secs(60);
/// A child has this long to end by itself when nothing more is asked of it.
const FAREWELL: Duration = Duration::from_secs(2);
/// Period at which trajectories are handed over [s].
const TRAJECTORY_PERIOD: f64 = 0.01;

/// A robot, a simulator or a stand-in that runs as a process of its own and is spoken to over its standard streams.
///
/// Its standard error goes where this program's goes. Dropped, it is asked to end, and ended after two seconds.
#[derive(Debug)]
pub struct ProcessExecutor {
    name: String,
    child: Child,
    /// `None` once nothing more is to be said.
    input: Option<Sender<Vec<u8>>>,
    lines: Receiver<Result<String, String>>,
    silence: Duration,
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
    /// A program that does not start, or that does not greet in this version of the protocol within a minute.
    pub fn start(program: &str, arguments: &[String]) -> Result<Self, ExecutorError> {
        Self::start_within(program, arguments, SILENCE)
    }

    /// The same with another limit than a minute, to the greeting and to all silence after it.
    ///
    /// # Errors
    /// As [`Self::start`].
    pub fn start_within(
        program: &str,
        arguments: &[String],
        silence: Duration,
    ) -> Result<Self, ExecutorError> {
        let failed = |error| ExecutorError::new(format!("executor {program:?}: {error}"));
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| failed(error.to_string()))?;
        let (sender, lines) = sync_channel(QUEUE);
        if let Some(output) = child.stdout.take() {
            std::thread::spawn(move || read_lines(BufReader::new(output), &sender));
        }
        let (input, messages) = channel();
        if let Some(stdin) = child.stdin.take() {
            std::thread::spawn(move || write_lines(stdin, &messages));
        }
        let mut executor = Self {
            name: program.to_owned(),
            input: Some(input),
            child,
            lines,
            silence,
        };
        executor.say(&ToChild::Hello {
            protocol: "wisch-executor",
            version: EXECUTOR_PROTOCOL,
        })?;
        match executor.hear()? {
            FromChild::Ready { version } if version == EXECUTOR_PROTOCOL => Ok(executor),
            FromChild::Ready { version } => Err(executor.fault(format!(
                "it speaks version {version} of the protocol, not {EXECUTOR_PROTOCOL}"
            ))),
            other => Err(executor.fault(format!("expected \"ready\", found {}", other.kind()))),
        }
    }

    /// Gives a child up that says nothing for so long, or goes on for so long after it was told to stop; a minute unless
    /// told.
    #[must_use]
    pub fn with_silence_limit(mut self, silence: Duration) -> Self {
        self.silence = silence;
        self
    }

    fn fault(&self, problem: impl std::fmt::Display) -> ExecutorError {
        ExecutorError::new(format!("executor {:?}: {problem}", self.name))
    }

    fn say(&mut self, message: &ToChild<'_>) -> Result<(), ExecutorError> {
        let mut line = serde_json::to_vec(message).map_err(|error| self.fault(error))?;
        line.push(b'\n');
        // One that no longer listens has ended, which is found out when it is listened to.
        let _ = self.input.as_ref().map(|input| input.send(line));
        Ok(())
    }

    fn hear(&mut self) -> Result<FromChild, ExecutorError> {
        let line = match self.lines.recv_timeout(self.silence) {
            Ok(line) => line.map_err(|problem| self.fault(problem))?,
            Err(RecvTimeoutError::Timeout) => {
                let seconds = self.silence.as_secs_f64();
                return Err(self.fault(format!("it said nothing for {seconds} s")));
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(self.fault("it ended before it was done"));
            }
        };
        let message = serde_json::from_str(&line);
        match message.map_err(|error| self.fault(format!("{error} in {}", shortened(&line))))? {
            FromChild::Error(problem) => Err(self.fault(problem)),
            message => Ok(message),
        }
    }

    fn order(&mut self, order: &MotionOrder<'_>) -> Result<(), ExecutorError> {
        let points: Vec<Setpoint> = order.setpoints(TRAJECTORY_PERIOD).collect();
        if points.is_empty() {
            return Err(self.fault("the motion is empty"));
        }
        self.say(&ToChild::Execute(MotionHead::new(order, points.len())))?;
        for point in points {
            self.say(&ToChild::Point(point.into()))?;
        }
        Ok(())
    }
}

impl Executor for ProcessExecutor {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.order(order)?;
        let mut intake = Intake::new(order, sink);
        let mut stopped: Option<Instant> = None;
        loop {
            let sample = match self.hear()? {
                FromChild::Sample(sample) => sample,
                FromChild::Done(done) => return intake.done(done).map_err(|e| self.fault(e)),
                other => {
                    let kind = other.kind();
                    return Err(self.fault(format!("expected a sample, found {kind}")));
                }
            };
            intake.take(&sample).map_err(|e| self.fault(e))?;
            match stopped {
                Some(stopped) if stopped.elapsed() > self.silence => {
                    let seconds = self.silence.as_secs_f64();
                    return Err(self.fault(format!("it goes on {seconds} s after \"stop\"")));
                }
                None if intake.is_stopped() => {
                    stopped = Some(Instant::now());
                    self.say(&ToChild::Stop)?;
                }
                _ => {}
            }
        }
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        self.say(&ToChild::Observe {
            surface: &task.surface.name,
        })?;
        match self.hear()? {
            FromChild::Observation(None) => Ok(None),
            FromChild::Observation(Some(seen)) => seen
                .into_observation()
                .map(Some)
                .map_err(|error| self.fault(error)),
            other => {
                let kind = other.kind();
                Err(self.fault(format!("expected \"observation\", found {kind}")))
            }
        }
    }
}

impl Drop for ProcessExecutor {
    fn drop(&mut self) {
        // A closed input says that nothing more is asked.
        self.input = None;
        let begin = Instant::now();
        while begin.elapsed() < FAREWELL {
            match self.child.try_wait() {
                Ok(None) => std::thread::sleep(Duration::from_millis(10)),
                Ok(Some(_)) | Err(_) => return,
            }
        }
        // It may just have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Writes what is to be said until nothing more is, or nobody listens. A child that does not listen holds up this
/// thread and no other.
fn write_lines(mut stdin: ChildStdin, messages: &Receiver<Vec<u8>>) {
    for message in messages {
        if stdin
            .write_all(&message)
            .and_then(|()| stdin.flush())
            .is_err()
        {
            return;
        }
    }
}

/// Hands lines on until the child or the receiver is gone.
fn read_lines(mut output: impl BufRead, sender: &SyncSender<Result<String, String>>) {
    loop {
        let mut line = Vec::new();
        let read = std::io::Read::take(&mut output, MAX_LINE + 1).read_until(b'\n', &mut line);
        let line = match read {
            Ok(0) => return,
            Ok(_) if line.len() as u64 > MAX_LINE => {
                Err(format!("a line exceeds the limit of {MAX_LINE} bytes"))
            }
            Ok(_) => String::from_utf8(line).map_err(|_| "a line is not UTF-8 text".to_owned()),
            Err(error) => Err(error.to_string()),
        };
        let is_over = line.is_err();
        if sender.send(line).is_err() || is_over {
            return;
        }
    }
}

/// The beginning of a line, for messages.
fn shortened(line: &str) -> String {
    let shown: String = line.trim_end().chars().take(80).collect();
    format!("{shown:?}")
}
