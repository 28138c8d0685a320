//! What the program adds to the sinks of a run: progress for people, real time, and checkpoints.

use super::job::Job;
use crate::progress::Progress;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use wisch::run::RunEvent;
use wisch_sim::Checkpoints;

/// Between two updates of the progress [samples].
const SAY_EVERY: usize = 200;

/// Shows progress, keeps what a killed run can be resumed with, and waits where a run is to take as long as its motions.
pub struct Watch<'a> {
    progress: &'a Progress,
    pub checkpoints: Checkpoints,
    /// Where they are.
    pub state: PathBuf,
    /// Rounds that an earlier run executed.
    taken_over: usize,
    is_realtime: bool,
    samples: usize,
    round: usize,
    begin: Instant,
    /// How long the round's motion takes [s].
    duration: f64,
}

impl<'a> Watch<'a> {
    /// Watches the rounds after so many that an earlier run executed.
    pub fn new(
        job: &Job<'a>,
        checkpoints: Checkpoints,
        taken_over: usize,
        is_realtime: bool,
    ) -> Self {
        Self {
            progress: job.progress,
            checkpoints,
            state: job.folder.state(),
            taken_over,
            is_realtime,
            samples: 0,
            round: 0,
            begin: Instant::now(),
            duration: 0.0,
        }
    }

    /// Takes in one event; no failure is said before the round is over.
    pub fn on_event(&mut self, event: &RunEvent<'_>) {
        show(self.progress, event);
        match event {
            RunEvent::Executing(planned) => {
                self.round = planned.number;
                self.duration = planned.followed.duration();
                self.samples = 0;
                self.begin = Instant::now();
                if self.round > self.taken_over {
                    self.checkpoints.begin(planned.number);
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
                self.checkpoints.sample(sample);
                if self.is_realtime {
                    let ahead = Duration::try_from_secs_f64(sample.time).unwrap_or_default();
                    std::thread::sleep(ahead.saturating_sub(self.begin.elapsed()));
                }
            }
            _ => {}
        }
    }
}

/// Shows people which stage a run is in.
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
