//! The progress of a motion, and when a child is abandoned.

use super::Intake;
use std::time::{Duration, Instant};

/// Additional time, beyond the limit of silence, for motions without progress.
const PROGRESS_ALLOWANCE: Duration = Duration::from_millis(500);
/// Trajectory time that counts as progress [s].
const PROGRESS: f64 = 0.1;

/// Progress of a motion, by the clock and by the samples.
pub(super) struct Progress {
    /// Trajectory time at the last progress [s].
    mark: f64,
    /// Time of the last progress, by the clock and by the samples [s].
    at: Instant,
    sample_time: f64,
    /// Time at which the child received a stop.
    pub told: Option<Instant>,
    /// Time at which the child was asked to pause, if it has to.
    pub asked: Option<Instant>,
    /// Whether the motion is paused; then a lack of progress is no fault.
    is_paused: bool,
}

impl Progress {
    pub fn begin() -> Self {
        let now = Instant::now();
        Self {
            mark: 0.0,
            at: now,
            sample_time: 0.0,
            told: None,
            asked: None,
            is_paused: false,
        }
    }

    /// Notes a sample. `received`: the time of its reception.
    pub fn hear(&mut self, intake: &Intake<'_>, received: Instant) {
        let reached = intake.trajectory_time();
        if reached >= self.mark + PROGRESS || reached >= intake.end() && self.mark < intake.end() {
            self.mark = reached;
            self.at = received;
            self.sample_time = intake.time();
        }
    }

    /// Notes that the motion is paused; then a lack of progress is no fault.
    pub const fn pause(&mut self) {
        self.is_paused = true;
    }

    /// Notes that the motion continues; the pause does not count as a lack of progress.
    pub fn resume(&mut self, intake: &Intake<'_>, received: Instant) {
        self.is_paused = false;
        self.at = received;
        self.sample_time = intake.time_reported();
    }

    /// Returns the time until which the next message is awaited. `patience`: limit of a motion
    /// without progress, and after a stop.
    pub fn deadline(&self, patience: Duration) -> Instant {
        match self.told {
            Some(told) => told + patience,
            None if self.is_paused => Instant::now() + patience,
            None => {
                let until = self.at + patience + PROGRESS_ALLOWANCE;
                // The answer to a request to pause is due earlier.
                (self.asked).map_or(until, |asked| until.min(asked + super::PAUSE_LIMIT))
            }
        }
    }

    /// Returns the reason to abandon a child whose motion does not end or progress. `now`: the time at which the last message
    /// was received, or the time until which none was.
    pub fn overdue(&self, silence: Duration, intake: &Intake<'_>, now: Instant) -> Option<String> {
        let seconds = silence.as_secs_f64();
        if let Some(told) = self.told {
            return (now.saturating_duration_since(told) >= silence)
                .then(|| format!("it still sends samples {seconds} s after \"stop\""));
        }
        if self.is_paused {
            return None;
        }
        let is_late = now.saturating_duration_since(self.at) >= silence + PROGRESS_ALLOWANCE
            || intake.time() - self.sample_time > seconds + PROGRESS_ALLOWANCE.as_secs_f64();
        is_late.then(|| {
            let (at, end) = (self.mark, intake.end());
            if at >= end {
                format!("it still sends samples {seconds} s after the end of its motion without \"done\"")
            } else {
                format!("no progress for {seconds} s, at {at:.1} s of a motion of {end:.1} s")
            }
        })
    }
}
