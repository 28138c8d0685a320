//! Sinks: what takes in the events of a run while it goes on.

use std::ops::ControlFlow;
use wisch::run::RunEvent;

/// Takes in the events of a run, in the order in which they happen.
///
/// ```
/// use wisch::run::RunEvent;
/// use wisch_record::{RunSink, SinkError};
///
/// /// Counts the samples of a run.
/// #[derive(Default)]
/// struct SampleCount(usize);
///
/// impl RunSink for SampleCount {
///     fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
///         self.0 += usize::from(matches!(event, RunEvent::Sample(_)));
///         Ok(())
///     }
/// }
///
/// let mut count = SampleCount::default();
/// count.on_event(&RunEvent::Planning { round: 1 })?;
/// assert_eq!(count.0, 0);
/// # Ok::<(), SinkError>(())
/// ```
pub trait RunSink {
    /// Takes in one event.
    ///
    /// # Errors
    /// Whatever keeps the sink from its work, with what that means for the run. A sink that has failed gets no more events.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError>;
}

/// What the failure of a sink means for the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AfterFailure {
    /// The run goes on without the sink.
    GoOn,
    /// The run ends in order: no other motion begins, and what was executed is interpreted and kept.
    EndInOrder,
}

/// Why a sink takes in no more events.
#[derive(Debug, thiserror::Error)]
#[error("{error}")]
pub struct SinkError {
    /// What went wrong.
    #[source]
    pub error: Box<dyn std::error::Error + Send + Sync>,
    /// What that means for the run.
    pub after: AfterFailure,
}

impl SinkError {
    /// A failure without which the run goes on.
    pub fn go_on(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self {
            error: error.into(),
            after: AfterFailure::GoOn,
        }
    }

    /// A failure that ends the run in order.
    pub fn end_in_order(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self {
            error: error.into(),
            after: AfterFailure::EndInOrder,
        }
    }
}

/// Passes events on to several sinks, and remembers which of them failed.
#[derive(Default)]
pub struct SinkSet {
    sinks: Vec<Box<dyn RunSink + Send>>,
    failed: Vec<SinkError>,
    is_ending: bool,
}

impl SinkSet {
    /// Adds a sink, after those that are there.
    pub fn add(&mut self, sink: Box<dyn RunSink + Send>) {
        self.sinks.push(sink);
    }

    /// Passes an event on to every sink that has not failed. `Break` asks the session to end in order, because a sink
    /// failed whose failure means that.
    pub fn on_event(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        let failed = &mut self.failed;
        self.sinks.retain_mut(|sink| {
            let result = sink.on_event(event);
            result.map_err(|error| failed.push(error)).is_ok()
        });
        self.is_ending |= (self.failed.iter()).any(|error| error.after == AfterFailure::EndInOrder);
        if self.is_ending {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// The failures since the last call, in their order.
    pub fn take_failures(&mut self) -> Vec<SinkError> {
        std::mem::take(&mut self.failed)
    }
}

impl std::fmt::Debug for SinkSet {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SinkSet")
            .field("sinks", &self.sinks.len())
            .field("failed", &self.failed)
            .field("is_ending", &self.is_ending)
            .finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Fails at the second event.
    struct Fails(Arc<AtomicUsize>, AfterFailure);

    impl RunSink for Fails {
        fn on_event(&mut self, _: &RunEvent<'_>) -> Result<(), SinkError> {
            let after = self.1;
            match self.0.fetch_add(1, Ordering::SeqCst) {
                0 => Ok(()),
                _ => Err(SinkError {
                    error: "disk full".into(),
                    after,
                }),
            }
        }
    }

    #[test]
    fn a_sink_that_failed_gets_no_more_events_and_the_others_do() {
        let [first, second] = [(); 2].map(|()| Arc::new(AtomicUsize::new(0)));
        let mut set = SinkSet::default();
        set.add(Box::new(Fails(Arc::clone(&first), AfterFailure::GoOn)));
        let event = RunEvent::Planning { round: 1 };
        for _ in 0..4 {
            assert!(set.on_event(&event).is_continue());
        }
        assert_eq!(first.load(Ordering::SeqCst), 2);
        assert_eq!(set.take_failures().len(), 1);
        set.add(Box::new(Fails(
            Arc::clone(&second),
            AfterFailure::EndInOrder,
        )));
        assert!(set.on_event(&event).is_continue());
        for _ in 0..2 {
            assert!(
                set.on_event(&event).is_break(),
                "it goes on asking for the end"
            );
        }
        assert_eq!(set.take_failures()[0].to_string(), "disk full");
    }
}
