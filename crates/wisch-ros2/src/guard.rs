//! The guard: a second process that stops the robot when the first one has ended or hangs.
//!
//! A trajectory controller executes its goal to the end, whether or not the client still runs. The guard holds the other end
//! of a pipe. While the robot may move, the first process sends a line over it several times a second. When the pipe closes, or
//! no line arrives for a while, the guard cancels all goals of the action and ends force mode.

use crate::link::{Link, LinkError};
use crate::messages::{CancelRequest, EmptyRequest, TriggerResponse};
use crate::robot_file::{ForceKind, RobotFile};
use crate::service::Service;
use ros2_client::action::CancelGoalResponse;
use std::cell::Cell;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{
    Receiver, RecvTimeoutError, SyncSender, TrySendError, channel, sync_channel,
};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Lines of the first process: the robot may move; still running; the robot rests; the guard is to end.
const ARMED: &str = "armed";
const BEAT: &str = "beat";
const RESTS: &str = "rests";
const END: &str = "end";
/// Line with which the guard says that it is connected.
const READY: &str = "ready";
/// Period of the lines while the robot may move, and the longest silence then.
const BEAT_PERIOD: Duration = Duration::from_millis(50);
pub(crate) const LONGEST_SILENCE: Duration = Duration::from_millis(500);
/// Lines that wait for the guard to read them.
const LINES: usize = 8;
/// Period of the stop, the least time for which it is repeated, as a goal may still be on its way, and the longest time that
/// the guard waits for an answer.
const REPEAT: Duration = Duration::from_millis(50);
const LEAST_STOP: Duration = Duration::from_secs(1);
const LONGEST_STOP: Duration = Duration::from_secs(10);

/// A running guard. When this is dropped, it ends without a stop, unless it is armed or the program panics.
pub(crate) struct Guard {
    child: Child,
    /// Lines for the thread that writes to the guard's pipe, so that a guard that hangs does not block this program.
    lines: Option<SyncSender<&'static str>>,
    writer: Option<JoinHandle<()>>,
    /// Whether the robot may still move.
    is_armed: bool,
    /// Time of the latest beat.
    beaten: Cell<Instant>,
}

impl Guard {
    /// Starts the guard and waits until it is connected.
    ///
    /// # Errors
    /// If it does not start or does not connect.
    pub fn start(robot_file: &Path) -> Result<Self, String> {
        let failed = |error: std::io::Error| format!("the guard does not start: {error}");
        let program = std::env::current_exe().map_err(failed)?;
        let mut command = Command::new(program);
        command.arg("guard").arg(robot_file);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        // A group of its own, so that what kills the first process does not kill the guard.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn().map_err(failed)?;
        let (Some(mut pipe), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("the guard has no pipes".to_owned());
        };
        let mut line = String::new();
        let read = BufReader::new(output).read_line(&mut line);
        if read.is_err() || line.trim() != READY {
            let _ = child.wait();
            return Err("the guard is not connected; its error is above".to_owned());
        }
        let (send, receive) = sync_channel::<&'static str>(LINES);
        let writer = std::thread::spawn(move || {
            for line in receive {
                if writeln!(pipe, "{line}")
                    .and_then(|()| pipe.flush())
                    .is_err()
                {
                    return;
                }
            }
        });
        Ok(Self {
            child,
            lines: Some(send),
            writer: Some(writer),
            is_armed: false,
            beaten: Cell::new(Instant::now()),
        })
    }

    /// Sets whether the robot may move. While it may, [`Self::beat`] must be called at least every half second.
    ///
    /// # Errors
    /// If the guard has ended or does not read.
    pub fn set_armed(&mut self, is_armed: bool) -> Result<(), String> {
        self.is_armed = is_armed;
        self.beaten.set(Instant::now());
        self.send(if is_armed { ARMED } else { RESTS })
    }

    /// Tells the guard that this program still supervises the robot.
    ///
    /// # Errors
    /// If the guard has ended or does not read.
    pub fn beat(&self) -> Result<(), String> {
        if self.beaten.get().elapsed() < BEAT_PERIOD {
            return Ok(());
        }
        self.beaten.set(Instant::now());
        self.send(BEAT)
    }

    fn send(&self, line: &'static str) -> Result<(), String> {
        let sent = self.lines.as_ref().map(|lines| lines.try_send(line));
        match sent {
            Some(Ok(())) => Ok(()),
            Some(Err(TrySendError::Full(_))) => Err(
                "the guard does not read its messages, so nothing would stop the robot".to_owned(),
            ),
            _ => Err("the guard has ended, so nothing would stop the robot".to_owned()),
        }
    }

    /// Whether the guard still runs.
    pub fn is_alive(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        let stays = self.is_armed || std::thread::panicking();
        if !stays {
            let _ = self.send(END);
        }
        // The pipe closes. An armed guard then stops the robot.
        self.lines = None;
        if let Some(writer) = self.writer.take().filter(|_| !stays) {
            let _ = writer.join();
            let _ = self.child.wait();
        }
    }
}

/// Runs as the guard of a robot file, until standard input ends.
///
/// # Errors
/// If the robot's services are not found.
pub(crate) fn watch(file: &RobotFile) -> Result<(), LinkError> {
    let mut link = Link::open(&file.link, "wisch_guard")?;
    let deadline = Instant::now() + Duration::from_secs_f64(file.link.discovery_s);
    let choice = file.link.service_mapping;
    let name = format!("{}/_action/cancel_goal", file.motion.action);
    let kind = ["action_msgs", "CancelGoal"];
    let cancel = Service::<CancelRequest, CancelGoalResponse>::connect(
        &mut link, &name, kind, choice, deadline,
    )?;
    let release = if file.force.kind == ForceKind::UrForceMode {
        let kind = ["std_srvs", "Trigger"];
        let service = Service::<EmptyRequest, TriggerResponse>::connect(
            &mut link,
            &file.force.stop,
            kind,
            choice,
            deadline,
        )?;
        Some(service)
    } else {
        None
    };
    println!("{READY}");
    let _ = std::io::stdout().flush();
    let Some(why) = wait_for_silence(&read_lines()) else {
        return Ok(());
    };
    let begin = Instant::now();
    let (mut is_canceled, mut is_released) = (false, release.is_none());
    loop {
        let canceling = cancel.send(CancelRequest::ALL);
        let releasing = release
            .as_ref()
            .map(|release| release.send(EmptyRequest::default()));
        std::thread::sleep(REPEAT);
        is_canceled |= canceling.is_ok_and(|id| cancel.answer(id).is_some());
        if let (Some(release), Some(Ok(id))) = (&release, releasing) {
            is_released |= release.answer(id).is_some_and(|answer| answer.success);
        }
        let is_done = is_canceled && is_released && begin.elapsed() >= LEAST_STOP;
        if is_done || begin.elapsed() >= LONGEST_STOP {
            break;
        }
    }
    eprintln!(
        "wisch-ros2: the executor {why} without a confirmed stop, so the guard {}",
        match (is_canceled, is_released) {
            (true, true) => "has canceled its goal",
            _ => "canceled its goal, but the robot has not answered",
        }
    );
    Ok(())
}

/// Starts to read standard input, line by line, on a thread.
fn read_lines() -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
    });
    receive
}

/// Waits until the first process has ended, or hangs while the robot may move. Returns which of them, or `None` if it has
/// asked the guard to end.
fn wait_for_silence(lines: &Receiver<String>) -> Option<&'static str> {
    let mut is_armed = false;
    loop {
        let line = if is_armed {
            lines.recv_timeout(LONGEST_SILENCE)
        } else {
            lines.recv().map_err(|_| RecvTimeoutError::Disconnected)
        };
        match line.as_deref().map(str::trim) {
            Ok(ARMED) => is_armed = true,
            Ok(RESTS) => is_armed = false,
            Ok(END) => return None,
            Ok(_) => {}
            Err(RecvTimeoutError::Disconnected) => return Some("ended"),
            Err(RecvTimeoutError::Timeout) => return Some("is silent"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_counts_only_while_the_robot_may_move() {
        let (send, lines) = channel();
        let say = |line: &str| send.send(line.to_owned()).unwrap();
        say(ARMED);
        say(BEAT);
        assert_eq!(wait_for_silence(&lines), Some("is silent"));
        for line in [ARMED, RESTS, END] {
            say(line);
        }
        assert_eq!(wait_for_silence(&lines), None);
        drop(send);
        assert_eq!(wait_for_silence(&lines), Some("ended"));
    }
}
