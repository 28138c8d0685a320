//! A recording that grows, as server-sent events: an event a line, numbered, so that whoever comes back goes on where the
//! line broke off.

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

/// How often a file is looked at that has not grown.
const LOOK_AGAIN: Duration = Duration::from_millis(40);
/// How often something is sent where nothing happens.
const HEARTBEAT: Duration = Duration::from_secs(10);
/// How often it is looked whether the run's process is there.
const LOOK_FOR_PROCESS: Duration = Duration::from_millis(500);
/// How the piece begins that ends a recording.
const LAST_PIECE: &[u8] = b"{\"piece\":\"ended\"";
/// Longest line of a recording [bytes]. The longest that wisch writes hold meshes, and have a few million.
const LONGEST_LINE: usize = 16 << 20;
/// What is read at once [bytes].
const CHUNK: usize = 1 << 16;
/// When the browser comes back after a break [ms].
const RETRY_MS: u64 = 500;

/// The lines of a recording after the first `after` ones, as they come.
pub struct Tail {
    live: LiveFolder,
    id: String,
    source: Source,
    /// What was read of a line that is not whole.
    partial: Vec<u8>,
    /// Lines that were read.
    lines: u64,
    /// Lines that whoever asks has.
    after: u64,
    /// Whether the piece was read that ends a recording.
    has_last_piece: bool,
    /// Whether its process was gone when it was last looked for.
    is_in_doubt: bool,
    has_ended: bool,
    last_look: Instant,
    last_sent: Instant,
    /// One of as many as may be open at once.
    _permit: OwnedSemaphorePermit,
}

/// Where lines come from.
enum Source {
    /// A file that grows.
    Growing(File),
    /// What is kept in an episode.
    Kept(Box<GzDecoder<File>>),
}

/// What came of reading on.
enum Step {
    Text(String),
    Wait,
}

impl Tail {
    /// Of a run that goes on.
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

    /// Of a run whose episode is there.
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

    /// As an answer, which is sent as fast as it is taken.
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
                    Step::Wait => tokio::time::sleep(LOOK_AGAIN).await,
                }
            };
            let mut tail = tail;
            tail.last_sent = Instant::now();
            Some((Ok(Bytes::from(text)), (tail, None)))
        });
        let headers = [(header::CONTENT_TYPE, "text/event-stream; charset=utf-8")];
        (headers, Body::from_stream(events)).into_response()
    }

    /// Reads on, as far as a chunk goes.
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
                let why = format!("line {line} is longer than {limit} MiB: this is no recording");
                return self.end(text, "broken", &why);
            }
        }
        Step::Text(text)
    }

    /// When all is read that is there by now.
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
        if self.last_look.elapsed() > LOOK_FOR_PROCESS {
            self.last_look = Instant::now();
            // What it wrote just before it was gone is to be read before this is believed.
            self.is_in_doubt = !self.live.goes_on(&self.id);
        }
        Step::Wait
    }

    fn end(&mut self, text: String, state: &str, message: &str) -> Step {
        self.has_ended = true;
        let said = json!({ "state": state, "message": message });
        // After this the browser is not to come back.
        Step::Text(text + &format!("event: end\ndata: {said}\n\n"))
    }

    /// Takes in what was read, and writes whole lines that are new as events.
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
