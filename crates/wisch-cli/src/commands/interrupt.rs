//! Signals: a command removes what it has not finished and ends; a run with an executor stops the robot first.

use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{hold_back, print_error, remark};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGUSR1};
use signal_hook::flag::{register, register_conditional_shutdown};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, TryLockError};
use std::time::{Duration, Instant};
use wisch_io::{PauseSwitch, kill_executors, remove_unfinished};

/// Exit code of a program that a signal ended, less the number of the signal, as shells define it.
const EXIT_BY_SIGNAL: i32 = 128;
/// Period at which the flag of a signal is checked.
const PERIOD: Duration = Duration::from_millis(20);
/// Longest time that a signal waits for a round whose verdict is being decided: a file system may block its checkpoint.
const PATIENCE: Duration = Duration::from_secs(2);

/// The flag of [`stop_on_signal`] and the switch of [`pause_on_signal`]: one of each, as a command over several patches
/// runs several times, and a signal between two runs counts for the next.
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();
static PAUSE: OnceLock<Arc<PauseSwitch>> = OnceLock::new();
/// Whether the command handles Ctrl-C itself.
static HANDLES_CTRL_C: AtomicBool = AtomicBool::new(false);

/// Installs handlers with which Ctrl-C, SIGTERM and SIGHUP remove what the command has not finished, and end the program.
///
/// After [`stop_on_signal`], the first signal requests a clean stop, and the second ends the program and all executors. While
/// unfinished files are removed, a further signal ends the program at once. A signal that is ignored from the beginning, as
/// `nohup` ignores SIGHUP, stays ignored; only Linux states which ones are.
///
/// # Errors
/// If the system refuses a handler.
pub fn listen() -> Result<(), Failure> {
    let mut flags = Vec::new();
    let is_ending = Arc::new(AtomicBool::new(false));
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    for signal in [SIGINT, SIGTERM, SIGHUP] {
        if is_ignored(signal, &status) {
            continue;
        }
        let flag = Arc::new(AtomicBool::new(false));
        let exit = EXIT_BY_SIGNAL + signal;
        register_conditional_shutdown(signal, exit, Arc::clone(&is_ending))
            .and_then(|_| register(signal, Arc::clone(&flag)))
            .map_err(|error| Failure::new(format!("signal {signal}: {error}")))?;
        flags.push((signal, flag));
    }
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PERIOD);
            let mut flags = flags.iter();
            let Some((signal, _)) = flags.find(|(_, flag)| flag.swap(false, Ordering::SeqCst))
            else {
                continue;
            };
            if *signal == SIGINT && HANDLES_CTRL_C.load(Ordering::SeqCst) {
                continue;
            }
            match STOP.get() {
                Some(stop) if !stop.swap(true, Ordering::SeqCst) => {
                    // Nobody may read standard error, and the next signal must not wait for that.
                    std::thread::spawn(|| {
                        remark(
                            "stopping the robot and keeping the executed part; a second signal ends the program at once",
                        );
                    });
                }
                _ => end(*signal, &is_ending),
            }
        }
    });
    Ok(())
}

/// Whether the process ignores a signal. `status`: the text of `/proc/self/status`; empty where the system has none.
fn is_ignored(signal: i32, status: &str) -> bool {
    let mask = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    // Bit 0 is signal 1.
    mask.is_some_and(|mask| (mask >> (signal - 1)) & 1 == 1)
}

/// Leaves Ctrl-C to the command: to a prompt, where it ends a query and not the program.
pub fn leave_ctrl_c() {
    HANDLES_CTRL_C.store(true, Ordering::SeqCst);
}

/// Removes what is unfinished, and ends the program and all executors. After `is_ending` is set, a signal ends it at once.
fn end(signal: i32, is_ending: &AtomicBool) -> ! {
    hold_back();
    kill_executors();
    is_ending.store(true, Ordering::SeqCst);
    // Held to the end, so that no round is completed meanwhile.
    let run = try_lock_unfinished(PATIENCE);
    remove_unfinished();
    let failure = match run.as_deref() {
        Some(Some(run)) => {
            (run.clear)();
            interruption(run.kept)
        }
        Some(None) => Failure::new("interrupted"),
        None => Failure::new("interrupted while the result of a round was written").with_help(
            "add --resume to the same command to continue after the last round that was written",
        ),
    };
    print_error(&failure);
    std::process::exit(EXIT_BY_SIGNAL + signal)
}

/// Lets signals request a clean stop.
///
/// The first signal sets the returned flag, the same in every call: the robot is stopped, and the executed part of the round is
/// interpreted and kept. The second signal ends the program and all executors at once.
pub fn stop_on_signal() -> Arc<AtomicBool> {
    Arc::clone(STOP.get_or_init(Arc::default))
}

/// Whether a signal has requested a stop since the program began.
pub fn is_stop_requested() -> bool {
    (STOP.get()).is_some_and(|stop| stop.load(Ordering::SeqCst))
}

/// Installs a handler with which SIGUSR1 pauses the motion of an executor, and SIGUSR1 again lets it continue.
///
/// # Errors
/// If the system refuses the handler.
pub fn pause_on_signal() -> Result<Arc<PauseSwitch>, Failure> {
    if let Some(switch) = PAUSE.get() {
        return Ok(Arc::clone(switch));
    }
    let signalled = Arc::new(AtomicBool::new(false));
    register(SIGUSR1, Arc::clone(&signalled))
        .map_err(|error| Failure::new(format!("signal {SIGUSR1}: {error}")))?;
    let switch = Arc::new(PauseSwitch::default());
    let turned = Arc::clone(&switch);
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PERIOD);
            if signalled.swap(false, Ordering::SeqCst) {
                remark(match (turned.toggle(), turned.is_supported()) {
                    (true, true) => "pausing the robot; another SIGUSR1 lets it continue",
                    (true, false) => {
                        "this executor cannot pause during a motion: the run pauses before the next one, and Ctrl-C stops the robot; another SIGUSR1 lets it continue"
                    }
                    (false, _) => "the robot continues",
                });
            }
        }
    });
    Ok(Arc::clone(PAUSE.get_or_init(|| switch)))
}

/// A run that a signal ends at once.
pub struct UnfinishedRun {
    /// Number of rounds with a checkpoint.
    pub kept: usize,
    clear: Box<dyn Fn() + Send>,
}

/// The run in progress: one at a time, as a command over several patches runs several times.
static UNFINISHED: Mutex<Option<UnfinishedRun>> = Mutex::new(None);

fn lock_unfinished() -> MutexGuard<'static, Option<UnfinishedRun>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Locks the run in progress; `None` if that takes longer than `patience`.
fn try_lock_unfinished(patience: Duration) -> Option<MutexGuard<'static, Option<UnfinishedRun>>> {
    let begin = Instant::now();
    loop {
        match UNFINISHED.try_lock() {
            Ok(run) => return Some(run),
            Err(TryLockError::Poisoned(run)) => return Some(run.into_inner()),
            Err(TryLockError::WouldBlock) if begin.elapsed() < patience => {
                std::thread::sleep(PERIOD);
            }
            Err(TryLockError::WouldBlock) => return None,
        }
    }
}

/// Lets a signal print how to resume the run. `kept`: number of rounds with a checkpoint.
pub fn say_how_to_resume(progress: &Progress, kept: usize) {
    *lock_unfinished() = Some(UnfinishedRun {
        kept,
        clear: Box::new(progress.clearing()),
    });
}

/// Delays signals until the returned guard is dropped: a round is decided, and its checkpoint is written now.
pub fn delay_signals() -> MutexGuard<'static, Option<UnfinishedRun>> {
    lock_unfinished()
}

/// The part of the command that is in progress, where a command consists of several runs.
static PART: Mutex<Option<CommandPart>> = Mutex::new(None);

/// A part of a command, such as a step of a goal or a patch of a surface.
#[derive(Debug)]
struct CommandPart {
    /// Name of the part, such as `step 5`.
    name: String,
    /// Folder of the results of all parts.
    out: PathBuf,
    /// Folder of this part's results, unless it exists from an earlier run.
    folder: Option<PathBuf>,
    /// Whether `out` has results of earlier parts.
    has_earlier: bool,
}

/// Lets a signal print which part of the command it ends, and where the results of the finished parts are.
///
/// # Parameters
/// - `name`: name of the part, such as `step 5`.
/// - `out`: folder of the results of all parts; `folder`: that of this part.
/// - `has_earlier`: whether `out` has results of earlier parts.
pub fn say_which_part(name: String, out: &Path, folder: &Path, has_earlier: bool) {
    *PART.lock().unwrap_or_else(PoisonError::into_inner) = Some(CommandPart {
        name,
        out: out.to_owned(),
        folder: (!folder.exists()).then(|| folder.to_owned()),
        has_earlier,
    });
}

impl CommandPart {
    fn interruption(&self) -> Failure {
        let Self { name, out, .. } = self;
        let is_finished = (self.folder.as_ref()).is_some_and(|folder| folder.exists());
        let what = match (is_finished, self.has_earlier) {
            (true, _) => format!("interrupted after {name}"),
            (false, true) => format!("interrupted during {name}; its results are not kept"),
            (false, false) => {
                return Failure::new(format!("interrupted during {name}; nothing is kept"));
            }
        };
        Failure::new(what).with_help(format!(
            "the results of what is finished are in {}; they cannot be resumed",
            out.display()
        ))
    }
}

fn interruption(kept: usize) -> Failure {
    let part = PART.lock().unwrap_or_else(PoisonError::into_inner).take();
    if let Some(part) = part {
        return part.interruption();
    }
    if kept == 0 {
        return Failure::new("interrupted during the first round; nothing is kept");
    }
    Failure::new(format!("interrupted after round {kept}"))
        .with_help("add --resume to the same command to continue from there")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_signal_that_is_ignored_from_the_begin_is_found() {
        // As `nohup` leaves it: SIGHUP, and SIGPIPE of the runtime.
        let status = "Name:\twisch\nSigBlk:\t0000000000000003\nSigIgn:\t0000000000001001\nSigCgt:\t0000000000000002\n";
        assert!(is_ignored(SIGHUP, status));
        assert!(!is_ignored(SIGINT, status) && !is_ignored(SIGTERM, status));
        assert!(!is_ignored(SIGHUP, "") && !is_ignored(SIGHUP, "SigIgn:\tx\n"));
    }
}
