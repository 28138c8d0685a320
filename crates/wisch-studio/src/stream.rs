//! A growing recording as server-sent events: a numbered event per line, so that a client can resume after an
//! interruption.

use crate::live::LiveFolder;
use crate::refusal::Refusal;
use axum::body::{Body, Bytes};
use axum::http::header;
use axum::response::{IntoResponse, Response};
use flate2::read::GzDecoder;
use futures_util::stream;
use serde_json::json;
use std::fs::File;
use std::io::{self, Read};
use std::time::{Duration, Instant};
use tokio::sync::OwnedSemaphorePermit;

/// Interval of checks whether a file has grown.
const CHECK_INTERVAL: Duration = Duration::from_millis(40);
/// Interval of messages on an idle stream.
const HEARTBEAT: Duration = Duration::from_secs(10);
/// Interval of checks whether the run's process exists.
const PROCESS_CHECK_INTERVAL: Duration = Duration::from_millis(500);
/// Start of the piece that ends a recording.
const LAST_PIECE: &[u8] = b"{\"piece\":\"ended\"";
/// Longest line of a recording [bytes]. The longest lines that wisch writes hold meshes, of a few million bytes.
const LONGEST_LINE: usize = 16 << 20;
/// Number of bytes read at once.
const CHUNK: usize = 1 << 16;
/// Time after which the browser reconnects [ms].
const RETRY_MS: u64 = 500;

/// Lines of a recording after the first `after` lines, as they arrive.
pub struct Tail {
    live: LiveFolder,
    id: String,
    source: Source,
    /// Start of an incomplete line.
    partial: Vec<u8>,
    /// Number of lines read.
    lines: u64,
    /// Number of lines that the client has.
    after: u64,
    /// Whether the final piece of the recording was read.
    has_last_piece: bool,
    /// Whether its process was gone at the last check.
    is_in_doubt: bool,
    has_ended: bool,
    last_look: Instant,
    last_sent: Instant,
    /// Permit of an open stream; their number is limited.
    _permit: OwnedSemaphorePermit,
}

/// Source of the lines.
enum Source {
    /// A growing file.
    Growing(File),
    /// The recording of a stored episode.
    Kept(Box<GzDecoder<File>>),
}

/// Result of a reading step.
enum Step {
    Text(String),
    Wait,
}

impl Tail {
    /// Opens the stream of a live run.
    pub fn growing(
        live: LiveFolder,
        id: &str,
        after: u64,
        permit: OwnedSemaphorePermit,
    ) -> Result<Self, Refusal> {
        let path = live.recording(id);
        let path = path.ok_or_else(|| Refusal::unknown(format!("there is no run {id:?}")))?;
        let file = File::open(path).map_err(Refusal::failed)?;
        Ok(Self::new(live, id, Source::Growing(file), after, permit))
    }

    /// Opens the stream of a run whose episode is stored.
    pub fn kept(
        live: LiveFolder,
        id: &str,
        recording: File,
        after: u64,
        permit: OwnedSemaphorePermit,
    ) -> Self {
        let decoder = GzDecoder::new(recording);
        Self::new(live, id, Source::Kept(Box::new(decoder)), after, permit)
    }

    fn new(
        live: LiveFolder,
        id: &str,
        source: Source,
        after: u64,
        permit: OwnedSemaphorePermit,
    ) -> Self {
        Self {
            live,
            id: id.to_owned(),
            source,
            partial: Vec::new(),
            lines: 0,
            after,
            has_last_piece: false,
            is_in_doubt: false,
            has_ended: false,
            last_look: Instant::now(),
            last_sent: Instant::now(),
            _permit: permit,
        }
    }

    /// Returns a response that is sent as fast as the client takes it.
    pub fn into_response(self) -> Response {
        let begin = Bytes::from(format!("retry: {RETRY_MS}\n\n"));
        let events = stream::unfold((self, Some(begin)), |(mut tail, begin)| async move {
            if let Some(begin) = begin {
                return Some((Ok::<_, io::Error>(begin), (tail, None)));
            }
            if tail.has_ended {
                return None;
            }
            let (tail, text) = loop {
                let stepped = tokio::task::spawn_blocking(move || {
                    let step = tail.step();
                    (tail, step)
                });
                let step;
                (tail, step) = stepped.await.ok()?;
                match step {
                    Step::Text(text) => break (tail, text),
                    Step::Wait if tail.last_sent.elapsed() > HEARTBEAT => {
                        break (tail, ": still here\n\n".to_owned());
                    }
                    Step::Wait => tokio::time::sleep(CHECK_INTERVAL).await,
                }
            };
            let mut tail = tail;
            tail.last_sent = Instant::now();
            Some((Ok(Bytes::from(text)), (tail, None)))
        });
        let headers = [(header::CONTENT_TYPE, "text/event-stream; charset=utf-8")];
        (headers, Body::from_stream(events)).into_response()
    }

    /// Reads the next chunk.
    fn step(&mut self) -> Step {
        let mut text = String::new();
        let mut chunk = vec![0; CHUNK];
        while text.len() < CHUNK {
            let read = match &mut self.source {
                Source::Growing(file) => file.read(&mut chunk),
                Source::Kept(decoder) => decoder.read(&mut chunk),
            };
            match read {
                Ok(0) => return self.at_end(text),
                Ok(len) => self.take(&chunk[..len], &mut text),
                Err(error) => return self.end(text, "broken", &error.to_string()),
            }
            if self.partial.len() > LONGEST_LINE {
                let (line, limit) = (self.lines + 1, LONGEST_LINE >> 20);
                let why = format!(
                    "line {line} is longer than {limit} MiB, so the file is not a recording"
                );
                return self.end(text, "broken", &why);
            }
        }
        Step::Text(text)
    }

    /// Handles the end of what is written so far.
    fn at_end(&mut self, text: String) -> Step {
        if self.has_last_piece {
            return self.end(text, "ended", "");
        }
        if matches!(self.source, Source::Kept(_)) {
            return self.end(text, "lost", "");
        }
        if !text.is_empty() {
            self.is_in_doubt = false;
            return Step::Text(text);
        }
        if self.is_in_doubt {
            return self.end(text, "lost", "");
        }
        if self.last_look.elapsed() > PROCESS_CHECK_INTERVAL {
            self.last_look = Instant::now();
            // The process may have written more just before its end, so the file is read once more before its end is
            // reported.
            self.is_in_doubt = !self.live.goes_on(&self.id);
        }
        Step::Wait
    }

    fn end(&mut self, text: String, state: &str, message: &str) -> Step {
        self.has_ended = true;
        let body = json!({ "state": state, "message": message });
        // The browser must not reconnect after this event.
        Step::Text(text + &format!("event: end\ndata: {body}\n\n"))
    }

    /// Adds bytes, and writes complete new lines as events.
    fn take(&mut self, mut bytes: &[u8], text: &mut String) {
        while let Some(end) = bytes.iter().position(|byte| *byte == b'\n') {
            self.partial.extend_from_slice(&bytes[..end]);
            bytes = &bytes[end + 1..];
            self.lines += 1;
            self.has_last_piece = self.partial.starts_with(LAST_PIECE);
            if self.lines > self.after {
                text.push_str(&format!("id: {}\ndata: ", self.lines));
                let line = String::from_utf8_lossy(&self.partial);
                for (number, part) in line.split('\r').enumerate() {
                    text.push_str(if number > 0 { " " } else { "" });
                    text.push_str(part);
                }
                text.push_str("\n\n");
            }
            self.partial.clear();
        }
        self.partial.extend_from_slice(bytes);
    }
}
