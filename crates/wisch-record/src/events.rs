//! The events of a run as JSON lines.

use crate::sink::{RunSink, SinkError};
use std::fmt;
use std::io::Write;
use wisch::run::RunEvent;
use wisch_io::EventWriter;

/// A sink that writes events as JSON lines, like `wisch run --events`.
pub struct EventSink<W> {
    name: String,
    writer: EventWriter<W>,
}

impl<W: Write> EventSink<W> {
    /// Makes a sink. `name`: name of the output in error messages.
    pub fn new(name: impl Into<String>, output: W) -> Self {
        Self {
            name: name.into(),
            writer: EventWriter::new(output),
        }
    }
}

impl<W: Write> RunSink for EventSink<W> {
    /// Writes one event. A failure, such as a closed pipe, stops the run cleanly.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.writer.write(event).map_err(|error| {
            SinkError::stop_run(format!("{}: cannot write events: {error}", self.name))
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
