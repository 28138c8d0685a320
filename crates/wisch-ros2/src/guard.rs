//! The guard: a second process that stops the robot when the first one has ended without saying so.
//!
//! A trajectory controller executes its goal to the end, whether or not the client still runs. The guard holds the other end
//! of a pipe. When the pipe closes, it cancels all goals of the action and ends force mode.

use crate::link::{Link, LinkError};
use crate::messages::{CancelRequest, EmptyRequest, TriggerResponse};
use crate::robot_file::{ForceKind, RobotFile};
use crate::service::Service;
use ros2_client::action::CancelGoalResponse;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::time::{Duration, Instant};

/// Line with which the first process ends the guard.
const END: &str = "end";
/// Line with which the guard says that it is connected.
const READY: &str = "ready";
/// Period of the stop, the least time for which it is repeated, as a goal may still be on its way, and the longest time that
/// the guard waits for an answer.
const REPEAT: Duration = Duration::from_millis(50);
const LEAST_STOP: Duration = Duration::from_secs(1);
const LONGEST_STOP: Duration = Duration::from_secs(10);

/// A running guard. When this is dropped, it ends without a stop, unless it is armed or the program panics.
pub(crate) struct Guard {
    child: Child,
    pipe: ChildStdin,
    /// Whether the robot may still move.
    is_armed: bool,
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
        let (Some(pipe), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("the guard has no pipes".to_owned());
        };
        let mut line = String::new();
        let read = BufReader::new(output).read_line(&mut line);
        if read.is_err() || line.trim() != READY {
            let _ = child.wait();
            return Err("the guard is not connected; its error is above".to_owned());
        }
        Ok(Self {
            child,
            pipe,
            is_armed: false,
        })
    }

    /// Sets whether the robot may still move, so that the guard has to stop it when this program ends.
    pub const fn set_armed(&mut self, is_armed: bool) {
        self.is_armed = is_armed;
    }

    /// Whether the guard still runs.
    pub fn is_alive(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        if self.is_armed || std::thread::panicking() {
            // The pipe closes, and the guard stops the robot.
            return;
        }
        let _ = writeln!(self.pipe, "{END}");
        let _ = self.pipe.flush();
        let _ = self.child.wait();
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
    let mut line = String::new();
    while let Ok(1..) = std::io::stdin().lock().read_line(&mut line) {
        if line.trim() == END {
            return Ok(());
        }
        line.clear();
    }
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
        "wisch-ros2: the executor ended without a confirmed stop, so the guard {}",
        match (is_canceled, is_released) {
            (true, true) => "has canceled its goal",
            _ => "canceled its goal, but the robot has not answered",
        }
    );
    Ok(())
}
