//! The messages of the executor protocol, version 2, over the standard streams.

use serde::Deserialize;
use serde_json::{Value, json};
use std::io::{BufRead, Read, Write};
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, sync_channel};
use std::time::Duration;

/// The version that this program speaks.
pub(crate) const VERSION: u32 = 2;
/// Longest line that is read [bytes].
const MAX_LINE: u64 = 1 << 20;
/// Messages that wait for wisch to read them: 8 s of samples at 250 Hz.
const OUTGOING: usize = 2000;
/// Longest text of a stop's reason [characters].
const MAX_REASON: usize = 400;

/// A message from wisch.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Request {
    Hello(Value),
    Prepare,
    Finish,
    Execute(Box<MotionHead>),
    Point(PointRecord),
    Stop,
    Pause,
    Resume,
    State,
    Observe(Value),
    /// The end of input.
    #[serde(skip)]
    End,
    /// A line that is no message; the text says why.
    #[serde(skip)]
    Invalid(String),
}

/// The head of a motion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct MotionHead {
    pub round: usize,
    pub joints: Vec<String>,
    pub world_from_surface: [f64; 7],
    pub press_force_n: f64,
    pub gap_m: Option<f64>,
    pub duration_s: f64,
    pub phases: Vec<PhaseRecord>,
    pub points: usize,
    pub tip: String,
    pub tip_from_tool: [f64; 7],
    pub world_from_root: [f64; 7],
}

/// A phase of a motion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct PhaseRecord {
    pub phase: String,
    pub start_s: f64,
    pub end_s: f64,
}

/// A knot of a motion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct PointRecord {
    pub time_s: f64,
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    pub accelerations: Vec<f64>,
    pub world_from_tool: [f64; 7],
}

/// Messages from wisch, which a thread reads.
pub(crate) struct Incoming(Receiver<Request>);

impl Incoming {
    /// Starts to read standard input.
    pub fn start() -> Self {
        let (send, receive) = sync_channel(1 << 16);
        std::thread::spawn(move || {
            let mut input = std::io::stdin().lock();
            loop {
                let mut line = Vec::new();
                let read = input.by_ref().take(MAX_LINE).read_until(b'\n', &mut line);
                let request = match read {
                    Ok(0) | Err(_) => Request::End,
                    Ok(_) if line.iter().all(u8::is_ascii_whitespace) => continue,
                    Ok(_) => serde_json::from_slice(&line)
                        .unwrap_or_else(|error| Request::Invalid(error.to_string())),
                };
                let ends = request == Request::End;
                if send.send(request).is_err() || ends {
                    return;
                }
            }
        });
        Self(receive)
    }

    /// Waits for the next message.
    pub fn next(&self) -> Request {
        self.0.recv().unwrap_or(Request::End)
    }

    /// Waits for the next message, at most for `limit`.
    pub fn next_within(&self, limit: Duration) -> Option<Request> {
        self.0.recv_timeout(limit).ok()
    }

    /// The next message if there is one.
    pub fn poll(&self) -> Option<Request> {
        match self.0.try_recv() {
            Ok(request) => Some(request),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Request::End),
        }
    }
}

/// Messages to wisch, which a thread writes, so that a reader that stalls does not stall the supervision of the robot.
pub(crate) struct Outgoing {
    lines: Option<SyncSender<String>>,
    writer: Option<std::thread::JoinHandle<()>>,
}

impl Outgoing {
    /// Starts to write to standard output.
    pub fn start() -> Self {
        let (send, receive) = sync_channel::<String>(OUTGOING);
        let writer = std::thread::spawn(move || {
            let mut output = std::io::stdout().lock();
            for line in receive {
                let written = output.write_all(line.as_bytes());
                if written.and_then(|()| output.flush()).is_err() {
                    return;
                }
            }
        });
        Self {
            lines: Some(send),
            writer: Some(writer),
        }
    }

    /// Queues a message. Returns whether there was space for it.
    pub fn say(&self, message: &Value) -> bool {
        let line = format!("{message}\n");
        (self.lines.as_ref()).is_some_and(|lines| lines.try_send(line).is_ok())
    }

    /// Queues a message, and waits for space if there is none.
    pub fn say_surely(&self, message: &Value) {
        if let Some(lines) = &self.lines {
            let _ = lines.send(format!("{message}\n"));
        }
    }
}

impl Drop for Outgoing {
    fn drop(&mut self) {
        self.lines = None;
        if let Some(writer) = self.writer.take() {
            let _ = writer.join();
        }
    }
}

/// Kinds of stops, as the protocol names them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Overload,
    Tolerance,
    ProtectiveStop,
    EmergencyStop,
    Operator,
    LinkLost,
}

impl Kind {
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Overload => "overload",
            Self::Tolerance => "tolerance",
            Self::ProtectiveStop => "protective_stop",
            Self::EmergencyStop => "emergency_stop",
            Self::Operator => "operator",
            Self::LinkLost => "link_lost",
        }
    }
}

/// How a motion ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum MotionEnding {
    Complete,
    /// wisch asked for the stop.
    Stopped,
    Stop(Kind, String),
    /// wisch has ended.
    Deserted,
}

impl MotionEnding {
    /// The value of `ending` in the protocol. `time`: since the start of the motion [s].
    pub fn to_json(&self, time: f64) -> Value {
        match self {
            Self::Complete => json!("complete"),
            Self::Stopped | Self::Deserted => json!("stopped"),
            Self::Stop(kind, reason) => {
                let reason: String = reason.chars().take(MAX_REASON).collect();
                json!({"stop": {"kind": kind.as_str(), "time_s": time, "reason": reason}})
            }
        }
    }
}
