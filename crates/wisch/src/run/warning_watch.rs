//! A watch that compares a run with earlier runs while the robot wipes.

use super::{RunEvent, RunWarning};
use std::fmt;

/// A function that receives the events of a run and returns the resulting warnings.
type Warn<'a> = dyn FnMut(&RunEvent<'_>) -> Vec<RunWarning> + Send + Sync + 'a;

/// A function that compares a run with earlier runs; `wisch_memory::warnings` has one.
///
/// It receives [`RunEvent::Executing`] and [`RunEvent::Sample`].
///
/// ```
/// use wisch::represent::Task;
/// use wisch::run::{RunEvent, Session, WarningWatch};
/// # fn watched(task: &Task) {
/// let mut samples = 0;
/// let watch = WarningWatch::new(move |event| {
///     samples += usize::from(matches!(event, RunEvent::Sample(_)));
///     Vec::new()
/// });
/// let session = Session::new(task, Default::default()).with_warnings(watch);
/// # }
/// ```
pub struct WarningWatch<'a> {
    warn: Box<Warn<'a>>,
    passive_rounds: usize,
}

impl<'a> WarningWatch<'a> {
    /// Returns the watch of a function.
    pub fn new(warn: impl FnMut(&RunEvent<'_>) -> Vec<RunWarning> + Send + Sync + 'a) -> Self {
        Self {
            warn: Box::new(warn),
            passive_rounds: 0,
        }
    }

    /// Sets the number of first rounds whose warnings end neither the stroke nor the run, because
    /// these rounds are replayed.
    #[must_use]
    pub fn with_replayed_rounds(self, passive_rounds: usize) -> Self {
        Self {
            passive_rounds,
            ..self
        }
    }

    /// Whether warnings of a round, counted from 1, may end the stroke or the run.
    pub(super) const fn may_end(&self, round: usize) -> bool {
        round > self.passive_rounds
    }

    /// Passes an event to the function and returns its warnings.
    pub(super) fn check(&mut self, event: &RunEvent<'_>) -> Vec<RunWarning> {
        (self.warn)(event)
    }
}

impl fmt::Debug for WarningWatch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WarningWatch")
            .field("passive_rounds", &self.passive_rounds)
            .finish_non_exhaustive()
    }
}
