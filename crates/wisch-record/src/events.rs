//! The events of a run as JSON lines.

use crate::sink::{RunSink, SinkError};
use std::fmt;
use std::io::Write;
use wisch::run::RunEvent;
use wisch_io::EventWriter;

/// Writes events as JSON lines, those of `wisch run --events`.
pub struct EventSink<W> {
    name: String,
    writer: EventWriter<W>,
}

impl<W: Write> EventSink<W> {
    /// Writes to this, which errors call by a name.
    pub fn new(name: impl Into<String>, output: W) -> Self {
        Self {
            name: name.into(),
            writer: EventWriter::new(output),
        }
    }
}

impl<W: Write> RunSink for EventSink<W> {
    /// Takes in one event. Where they cannot be written, as where a reader has gone, the run ends in order.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.writer.write(event).map_err(|error| {
            SinkError::end_in_order(format!("{}: cannot write there: {error}", self.name))
        })
    }
}

impl<W> fmt::Debug for EventSink<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("EventSink")
            .field("name", &self.name)
            .finish_non_exhaustive()
    }
}
