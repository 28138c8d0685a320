//! Ctrl-C during a run: how to go on with it.

use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::complain_of;
use signal_hook::consts::SIGINT;
use signal_hook::flag::{register, register_conditional_shutdown};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

/// What shells say of a program that Ctrl-C ended.
const EXIT_INTERRUPTED: i32 = 130;
/// How often it is looked for.
const PERIOD: Duration = Duration::from_millis(50);

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
