//! A receiver of a run's events that shows progress, writes checkpoints and paces the run to real time.

use super::job::Job;
use crate::progress::Progress;
use crate::terminal::remark;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use wisch::run::RunEvent;
use wisch_sim::Checkpoints;

/// Number of samples between two updates of the progress.
const SAY_EVERY: usize = 200;

/// A receiver of events that shows progress, writes checkpoints for `--resume`, and waits for real time if requested.
pub struct Watch<'a> {
    progress: &'a Progress,
    /// Checkpoints of the run.
    pub checkpoints: Checkpoints,
    /// Folder of the checkpoints.
    pub state: PathBuf,
    /// Rounds that an earlier run executed.
    taken_over: usize,
    is_realtime: bool,
    samples: usize,
    round: usize,
    begin: Instant,
    /// Duration of the round's motion [s].
    duration: f64,
}

impl<'a> Watch<'a> {
    /// Makes a receiver. `taken_over`: number of rounds that a killed run has executed.
    pub fn new(
        job: &Job<'a>,
        checkpoints: Checkpoints,
        taken_over: usize,
        is_realtime: bool,
    ) -> Self {
        Self {
            progress: job.progress,
            checkpoints,
            state: job.folder.checkpoint_folder(),
            taken_over,
            is_realtime,
            samples: 0,
            round: 0,
            begin: Instant::now(),
            duration: 0.0,
        }
    }

    /// Prints a note beside the progress.
    pub fn say(&self, text: &str) {
        self.progress.aside(|| remark(text));
    }

    /// Receives an event. Failures of checkpoints are reported at the end of the round.
    pub fn on_event(&mut self, event: &RunEvent<'_>) {
        show(self.progress, event);
        match event {
            RunEvent::Executing(planned) => {
                self.round = planned.number;
                self.duration = planned.followed.duration();
                self.samples = 0;
                self.begin = Instant::now();
                if self.round > self.taken_over {
                    self.checkpoints.begin();
                }
            }
            RunEvent::Sample(sample) if self.round > self.taken_over => {
                if self.samples.is_multiple_of(SAY_EVERY) {
                    self.progress.say(format!(
                        "round {}: wiping, {:.1} of {:.1} s",
                        self.round, sample.time, self.duration
                    ));
                }
                self.samples += 1;
                self.checkpoints.sample(sample.time);
                if self.is_realtime {
                    let ahead = Duration::try_from_secs_f64(sample.time).unwrap_or_default();
                    std::thread::sleep(ahead.saturating_sub(self.begin.elapsed()));
                }
            }
            _ => {}
        }
    }
}

/// Shows the current stage of a run.
pub fn show(progress: &Progress, event: &RunEvent<'_>) {
    match event {
        RunEvent::Planning { round } => progress.say(format!("round {round}: planning")),
        RunEvent::Following {
            round,
            passed,
            nodes,
        } => progress.say(format!(
            "round {round}: following, {passed} of {nodes} nodes"
        )),
        RunEvent::Interpreting { round } => progress.say(format!("round {round}: interpreting")),
        _ => {}
    }
}
