//! Durations of the stages of each round, and its predicted effect.

use crate::sink::{RunSink, SinkError};
use std::time::Instant;
use wisch::plan::Plan;
use wisch::represent::Task;
use wisch::run::RunEvent;
use wisch_io::RoundTimes;
use wisch_report::EffectFrames;

/// Durations and predicted effect of a round.
#[derive(Debug, Clone, Default)]
pub struct RoundStages {
    /// Durations of its stages.
    pub times: RoundTimes,
    /// Predicted effect over time; `None` for a plan without strokes.
    pub frames: Option<EffectFrames>,
}

impl RoundStages {
    /// Returns the predicted effect of the round on a task's particles, over time.
    pub fn effect(&self, task: &Task, wiped: &Plan) -> EffectFrames {
        let frames = self.frames.clone();
        frames.unwrap_or_else(|| EffectFrames::new(task, wiped))
    }
}

/// A sink that measures the duration of every stage and keeps the predicted effect. It never fails.
#[derive(Debug)]
pub struct StageSink {
    /// The rounds that have begun, by number.
    rounds: Vec<RoundStages>,
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
    /// The entry of a round. `number`: from 1.
    pub fn round(&mut self, number: usize) -> &mut RoundStages {
        self.rounds
            .resize(self.rounds.len().max(number), RoundStages::default());
        &mut self.rounds[number - 1]
    }

    /// Adds the time since the last call to a stage of a round.
    fn take(&mut self, round: usize, part: impl Fn(&mut RoundTimes) -> &mut f64) {
        let seconds = self.since.elapsed().as_secs_f64();
        *part(&mut self.round(round).times) += seconds;
        self.since = Instant::now();
    }
}

impl RunSink for StageSink {
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        match event {
            RunEvent::Planning { .. } => self.since = Instant::now(),
            RunEvent::Planned { round, .. } => self.take(*round, |times| &mut times.planning_s),
            RunEvent::Predicting {
                round,
                task,
                wiped,
                progress,
            } => {
                let frames = &mut self.round(*round).frames;
                let begin = || EffectFrames::new(task, wiped);
                frames.get_or_insert_with(begin).record(progress);
            }
            RunEvent::Audited { round, .. } => self.take(*round, |times| &mut times.following_s),
            RunEvent::Interpreting { round } => self.take(*round, |times| &mut times.executing_s),
            RunEvent::Decided(round) => {
                self.take(round.motion.number, |times| &mut times.interpreting_s);
            }
            RunEvent::Evaluated { .. }
            | RunEvent::Following { .. }
            | RunEvent::Sample(_)
            | RunEvent::Executing(_)
            | RunEvent::Observed { .. }
            | RunEvent::Ended(_) => {}
        }
        Ok(())
    }
}
