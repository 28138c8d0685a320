//! A spinner on terminals; no output in pipes.

use crate::args::GlobalArgs;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;
use wisch::source_location::escape_controls;

/// Period of the spinner.
const TICK: Duration = Duration::from_millis(100);

/// A spinner that shows the current activity on standard error, if that is a terminal. It is cleared when dropped.
pub struct Progress {
    spinner: ProgressBar,
}

impl Progress {
    /// Starts the spinner.
    pub fn start(args: &GlobalArgs) -> Self {
        let spinner = if args.quiet || !std::io::stderr().is_terminal() {
            ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
        } else {
            let spinner = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} ({elapsed})") {
                spinner.set_style(style);
            }
            spinner.enable_steady_tick(TICK);
            spinner
        };
        Self { spinner }
    }

    /// Runs a function that prints while the spinner is hidden.
    pub fn aside(&self, print: impl FnOnce()) {
        self.spinner.suspend(print);
    }

    /// Returns a function that clears the spinner; any thread can call it.
    pub fn clearing(&self) -> impl Fn() + Send + use<> {
        let spinner = self.spinner.clone();
        move || spinner.finish_and_clear()
    }

    /// Shows the current activity.
    pub fn say(&self, what: impl Into<std::borrow::Cow<'static, str>>) {
        let what = what.into();
        self.spinner
            .set_message(escape_controls(&what).into_owned());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.spinner.finish_and_clear();
    }
}
