//! A spinner for people; nothing for pipes.

use crate::args::GlobalArgs;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;
use wisch::source_location::visible;

/// How often the spinner turns.
const TICK: Duration = Duration::from_millis(100);

/// Says on standard error what is going on, if that is a terminal; clears itself away at the end.
pub struct Progress {
    spinner: ProgressBar,
}

impl Progress {
    /// Starts to spin.
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

    /// Does something that prints, without the spinner in between.
    pub fn aside(&self, print: impl FnOnce()) {
        self.spinner.suspend(print);
    }

    /// Takes the spinner away, from whatever thread.
    pub fn clearing(&self) -> impl FnOnce() + Send + use<> {
        let spinner = self.spinner.clone();
        move || spinner.finish_and_clear()
    }

    /// Says what is being done now.
    pub fn say(&self, what: impl Into<std::borrow::Cow<'static, str>>) {
        let what = what.into();
        self.spinner.set_message(visible(&what).into_owned());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.spinner.finish_and_clear();
    }
}
