//! Signals during a run: a clean stop, or a hint how to resume.

use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{complain_of, remark};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGUSR1};
use signal_hook::flag::{register, register_conditional_shutdown};
use std::fs::remove_dir_all;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;
use wisch_io::PauseSwitch;

/// Exit code of a program that Ctrl-C ended, as shells define it.
const EXIT_INTERRUPTED: i32 = 130;
/// Period at which the flag of a signal is checked.
const PERIOD: Duration = Duration::from_millis(20);

/// The flag of [`stop_on_signal`] and the switch of [`pause_on_signal`]: one of each, as a command over several patches
/// runs several times, and a signal between two runs counts for the next.
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();
static PAUSE: OnceLock<Arc<PauseSwitch>> = OnceLock::new();

/// Installs handlers with which Ctrl-C, SIGTERM and SIGHUP request a clean stop.
///
/// The first signal sets the returned flag, the same in every call: the robot is stopped, and the executed part of the round is interpreted and
/// kept. The second signal ends the program and all executors at once.
///
/// # Errors
/// If the system refuses a handler.
pub fn stop_on_signal() -> Result<Arc<AtomicBool>, Failure> {
    if let Some(stop) = STOP.get() {
        return Ok(Arc::clone(stop));
    }
    let signalled = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM, SIGHUP] {
        register(signal, Arc::clone(&signalled))
            .map_err(|error| Failure::new(format!("signal {signal}: {error}")))?;
    }
    let stop = Arc::new(AtomicBool::new(false));
    let asked = Arc::clone(&stop);
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PERIOD);
            if !signalled.swap(false, Ordering::SeqCst) {
                continue;
            }
            if asked.swap(true, Ordering::SeqCst) {
                wisch_io::kill_executors();
                std::process::exit(EXIT_INTERRUPTED);
            }
            remark(
                "stopping the robot and keeping the executed part; a second signal ends the program at once",
            );
        }
    });
    Ok(Arc::clone(STOP.get_or_init(|| stop)))
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

/// A run that Ctrl-C ends at once.
struct UnfinishedRun {
    /// Number of rounds with a checkpoint.
    kept: Arc<AtomicUsize>,
    /// Folder of the results, as long as it can be removed.
    staging: Option<PathBuf>,
    clear: Box<dyn Fn() + Send>,
}

/// The run in progress: one at a time, as a command over several patches runs several times.
static UNFINISHED: Mutex<Option<UnfinishedRun>> = Mutex::new(None);

fn unfinished() -> MutexGuard<'static, Option<UnfinishedRun>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Installs a handler with which Ctrl-C ends the program at once and prints how to resume.
///
/// The checkpoints stay, as after a kill. Without one, `staging`, the folder of the unfinished results, is removed until
/// [`keep_unfinished_results`]. `kept`: number of rounds with a checkpoint; the caller increments the returned counter after each
/// further checkpoint.
///
/// # Errors
/// If the system refuses the handler.
pub fn say_how_to_resume(
    progress: &Progress,
    kept: usize,
    staging: PathBuf,
) -> Result<Arc<AtomicUsize>, Failure> {
    let kept = Arc::new(AtomicUsize::new(kept));
    let before = unfinished().replace(UnfinishedRun {
        kept: Arc::clone(&kept),
        staging: Some(staging),
        clear: Box::new(progress.clearing()),
    });
    if before.is_some() {
        return Ok(kept);
    }
    let interrupted = Arc::new(AtomicBool::new(false));
    let failed = |error| Failure::new(format!("Ctrl-C: {error}"));
    // The second Ctrl-C ends the program at once: its handler reads the flag before the first one sets it.
    register_conditional_shutdown(SIGINT, EXIT_INTERRUPTED, Arc::clone(&interrupted))
        .and_then(|_| register(SIGINT, Arc::clone(&interrupted)))
        .map_err(failed)?;
    std::thread::spawn(move || {
        while !interrupted.load(Ordering::SeqCst) {
            std::thread::sleep(PERIOD);
        }
        // Held to the end, so that no results are put in place meanwhile.
        let run = unfinished();
        if let Some(run) = &*run {
            (run.clear)();
            let kept = run.kept.load(Ordering::SeqCst);
            if let (0, Some(staging)) = (kept, &run.staging) {
                // Again, if the run has written a file meanwhile; the next run removes what is left even so.
                let _ = remove_dir_all(staging).or_else(|_| remove_dir_all(staging));
            }
            complain_of(&interruption(kept));
        }
        std::process::exit(EXIT_INTERRUPTED)
    });
    Ok(kept)
}

/// Lets Ctrl-C keep the folder of unfinished results: it is about to be put in place.
pub fn keep_unfinished_results() {
    if let Some(run) = &mut *unfinished() {
        run.staging = None;
    }
}

fn interruption(kept: usize) -> Failure {
    if kept == 0 {
        return Failure::new("interrupted during the first round; nothing is kept");
    }
    Failure::new(format!("interrupted after round {kept}"))
        .with_help("add --resume to the same command to continue from there")
}
