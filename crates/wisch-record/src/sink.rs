//! Sinks: receivers of a run's events.

use std::ops::ControlFlow;
use wisch::run::RunEvent;

/// A receiver of a run's events, in the order in which they happen.
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
    /// Receives one event.
    ///
    /// # Errors
    /// If the sink fails. The error states whether the run continues. A failed sink receives no further events.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError>;
}

/// The consequence of a sink's failure for the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AfterFailure {
    /// The run continues without the sink.
    ContinueRun,
    /// The run stops cleanly: no further motion begins, and the executed part is interpreted and kept.
    StopRun,
}

/// The failure of a sink, with its consequence for the run.
#[derive(Debug, thiserror::Error)]
#[error("{error}")]
pub struct SinkError {
    /// The cause.
    #[source]
    pub error: Box<dyn std::error::Error + Send + Sync>,
    /// The consequence for the run.
    pub after: AfterFailure,
}

impl SinkError {
    /// Makes a failure after which the run continues without the sink.
    pub fn continue_run(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self {
            error: error.into(),
            after: AfterFailure::ContinueRun,
        }
    }

    /// Makes a failure that stops the run cleanly.
    pub fn stop_run(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self {
            error: error.into(),
            after: AfterFailure::StopRun,
        }
    }
}

/// A set of sinks that receive the same events. It collects their failures.
#[derive(Default)]
pub struct SinkSet {
    sinks: Vec<Box<dyn RunSink + Send>>,
    failed: Vec<SinkError>,
    is_ending: bool,
}

impl SinkSet {
    /// Adds a sink at the end of the set.
    pub fn add(&mut self, sink: Box<dyn RunSink + Send>) {
        self.sinks.push(sink);
    }

    /// Passes an event to every sink that has not failed. Returns `Break` if a failure requires the session to stop cleanly.
    pub fn on_event(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        let failed = &mut self.failed;
        self.sinks.retain_mut(|sink| {
            let result = sink.on_event(event);
            result.map_err(|error| failed.push(error)).is_ok()
        });
        self.is_ending |= (self.failed.iter()).any(|error| error.after == AfterFailure::StopRun);
        if self.is_ending {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Returns the failures since the last call, in order of time.
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
        set.add(Box::new(Fails(
            Arc::clone(&first),
            AfterFailure::ContinueRun,
        )));
        let event = RunEvent::Planning { round: 1 };
        for _ in 0..4 {
            assert!(set.on_event(&event).is_continue());
        }
        assert_eq!(first.load(Ordering::SeqCst), 2);
        assert_eq!(set.take_failures().len(), 1);
        set.add(Box::new(Fails(Arc::clone(&second), AfterFailure::StopRun)));
        assert!(set.on_event(&event).is_continue());
        for _ in 0..2 {
            assert!(
                set.on_event(&event).is_break(),
                "every later event requests the stop"
            );
        }
        assert_eq!(set.take_failures()[0].to_string(), "disk full");
    }
}
