//! Ctrl-C during a run: how to go on with it, or how it ends in order.

use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{complain_of, remark};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::flag::{register, register_conditional_shutdown};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

/// What shells say of a program that Ctrl-C ended.
const EXIT_INTERRUPTED: i32 = 130;
/// How often it is looked for.
const PERIOD: Duration = Duration::from_millis(20);

/// From now on, Ctrl-C, SIGTERM and SIGHUP ask for an end in order, which the flag says: a robot is told to stop, and what it
/// did is interpreted and kept. The second of them ends the program, and every executor, at once.
///
/// # Errors
/// What the system says.
pub fn end_in_order() -> Result<Arc<AtomicBool>, Failure> {
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
            remark("ending in order: what was executed is kept; a second signal ends at once");
        }
    });
    Ok(stop)
}

/// From now on, Ctrl-C ends the program as a kill would, so that what `--resume` goes on with stays, and says so. The
/// number is that of the rounds that are kept: whoever keeps one counts it up.
///
/// # Errors
/// What the system says.
pub fn say_how_to_resume(progress: &Progress, kept: usize) -> Result<Arc<AtomicUsize>, Failure> {
    let kept = Arc::new(AtomicUsize::new(kept));
    let interrupted = Arc::new(AtomicBool::new(false));
    let failed = |error| Failure::new(format!("Ctrl-C: {error}"));
    // The second one does not wait for anything. It looks at the flag before the first one sets it.
    register_conditional_shutdown(SIGINT, EXIT_INTERRUPTED, Arc::clone(&interrupted))
        .and_then(|_| register(SIGINT, Arc::clone(&interrupted)))
        .map_err(failed)?;
    let clear = progress.clearing();
    let counted = Arc::clone(&kept);
    std::thread::spawn(move || {
        while !interrupted.load(Ordering::SeqCst) {
            std::thread::sleep(PERIOD);
        }
        clear();
        complain_of(&interruption(counted.load(Ordering::SeqCst)));
        std::process::exit(EXIT_INTERRUPTED)
    });
    Ok(kept)
}

fn interruption(kept: usize) -> Failure {
    if kept == 0 {
        return Failure::new("interrupted before the first round was over, so nothing is kept");
    }
    Failure::new(format!("interrupted after round {kept}"))
        .with_help("the same command with --resume goes on from there")
}
