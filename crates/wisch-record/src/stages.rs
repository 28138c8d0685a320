//! Durations of the stages of each round.

use crate::sink::{RunSink, SinkError};
use std::time::Instant;
use wisch::run::RunEvent;
use wisch_io::RoundTimes;

/// A sink that measures the duration of every stage. It never fails.
#[derive(Debug)]
pub struct StageSink {
    /// Durations of the stages of the rounds that have begun, by number.
    rounds: Vec<RoundTimes>,
    since: Instant,
}

impl Default for StageSink {
    /// Starts measuring.
    fn default() -> Self {
        Self {
            rounds: Vec::new(),
            since: Instant::now(),
        }
    }
}

impl StageSink {
    /// The durations of a round's stages. `number`: from 1.
    pub fn round(&mut self, number: usize) -> &mut RoundTimes {
        self.rounds
            .resize(self.rounds.len().max(number), RoundTimes::default());
        &mut self.rounds[number - 1]
    }

    /// Adds the time since the last call to a stage of a round.
    fn take(&mut self, round: usize, part: impl Fn(&mut RoundTimes) -> &mut f64) {
        let seconds = self.since.elapsed().as_secs_f64();
        *part(self.round(round)) += seconds;
        self.since = Instant::now();
    }
}

impl RunSink for StageSink {
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        match event {
            RunEvent::Planning { .. } => self.since = Instant::now(),
            RunEvent::Planned { round, .. } => self.take(*round, |times| &mut times.planning_s),
            RunEvent::Audited { round, .. } => self.take(*round, |times| &mut times.following_s),
            RunEvent::Interpreting { round } => self.take(*round, |times| &mut times.executing_s),
            RunEvent::Decided(round) => {
                self.take(round.motion.number, |times| &mut times.interpreting_s);
            }
            RunEvent::Predicting { .. }
            | RunEvent::Evaluated { .. }
            | RunEvent::Following { .. }
            | RunEvent::Sample(_)
            | RunEvent::Warned(_)
            | RunEvent::Executing(_)
            | RunEvent::Observed { .. }
            | RunEvent::Ended(_) => {}
        }
        Ok(())
    }
}
