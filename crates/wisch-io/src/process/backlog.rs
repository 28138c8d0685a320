//! The lines of a child that wait to be read, so that slow observers do not delay the child.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Most lines that wait, of a child that may be kept waiting.
const MAX_LINES: usize = 64;
/// Most lines that wait, of a child that executes in real time: 20 s of samples at 1 kHz.
const MAX_REAL_TIME_LINES: usize = 20_000;
/// Most bytes of these lines.
const MAX_BYTES: usize = 32 << 20;

/// A line, or the reason why there are no more.
type Line = Result<String, String>;

/// A bounded queue of lines between the thread that reads a child's output and the thread that takes them.
///
/// If it is full, the reading thread waits, and the child with it. A child that executes in real time must not wait: then
/// the oldest sample is dropped and counted.
#[derive(Debug, Clone, Default)]
pub(super) struct Backlog {
    shared: Arc<(Mutex<Waiting>, Condvar)>,
}

#[derive(Debug, Default)]
struct Waiting {
    lines: VecDeque<Line>,
    bytes: usize,
    is_real_time: bool,
    dropped: usize,
    /// Whether no more lines are added.
    has_ended: bool,
    /// Whether no more lines are taken.
    is_closed: bool,
}

/// Why no line was taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoLine {
    /// There was none within the time.
    TimedOut,
    /// There will be none.
    Ended,
}

impl Backlog {
    fn lock(&self) -> MutexGuard<'_, Waiting> {
        self.shared.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(
        &self,
        waiting: MutexGuard<'a, Waiting>,
        time: Duration,
    ) -> MutexGuard<'a, Waiting> {
        let waited = self.shared.1.wait_timeout(waiting, time);
        waited.unwrap_or_else(PoisonError::into_inner).0
    }

    /// Sets that the child executes in real time, so that it never waits.
    pub fn set_real_time(&self) {
        self.lock().is_real_time = true;
        self.shared.1.notify_all();
    }

    /// Number of samples that were dropped so far.
    pub fn dropped_count(&self) -> usize {
        self.lock().dropped
    }

    /// Adds a line, if need be after waiting for space. Returns whether further lines are taken.
    pub fn push(&self, line: Line) -> bool {
        let length = line.as_ref().map_or(0, String::len);
        let mut waiting = self.lock();
        loop {
            if waiting.is_closed {
                return false;
            }
            if waiting.has_space(length) || waiting.is_real_time && waiting.drop_sample() {
                break;
            }
            waiting = self.wait(waiting, Duration::from_secs(1));
        }
        waiting.bytes += length;
        waiting.lines.push_back(line);
        drop(waiting);
        self.shared.1.notify_all();
        true
    }

    /// Takes the oldest line; waits for it until the deadline.
    pub fn take(&self, deadline: Instant) -> Result<Line, NoLine> {
        let mut waiting = self.lock();
        loop {
            if let Some(line) = waiting.lines.pop_front() {
                waiting.bytes -= line.as_ref().map_or(0, String::len);
                drop(waiting);
                self.shared.1.notify_all();
                return Ok(line);
            }
            if waiting.has_ended {
                return Err(NoLine::Ended);
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(NoLine::TimedOut);
            }
            waiting = self.wait(waiting, left);
        }
    }

    /// Notes that no more lines are added.
    pub fn end(&self) {
        self.lock().has_ended = true;
        self.shared.1.notify_all();
    }

    /// Notes that no more lines are taken, so that the reading thread does not wait.
    pub fn close(&self) {
        self.lock().is_closed = true;
        self.shared.1.notify_all();
    }
}

impl Waiting {
    fn has_space(&self, length: usize) -> bool {
        let most = if self.is_real_time {
            MAX_REAL_TIME_LINES
        } else {
            MAX_LINES
        };
        let is_within = self.bytes + length <= MAX_BYTES;
        self.lines.is_empty() || self.lines.len() < most && is_within
    }

    /// Drops the oldest sample, if one of the first lines is a sample.
    fn drop_sample(&mut self) -> bool {
        let is_sample = |line: &Line| line.as_ref().is_ok_and(|line| is_sample(line));
        let Some(at) = self.lines.iter().position(is_sample) else {
            return false;
        };
        if let Some(Ok(line)) = self.lines.remove(at) {
            self.bytes -= line.len();
        }
        self.dropped += 1;
        true
    }
}

/// Whether a line is a message with a sample.
fn is_sample(line: &str) -> bool {
    let begin = line.trim_start().strip_prefix('{');
    begin.is_some_and(|rest| rest.trim_start().starts_with("\"sample\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(number: usize) -> Line {
        Ok(format!("{{ \"sample\": {{\"time_s\": {number}}}}}"))
    }

    fn now() -> Instant {
        Instant::now()
    }

    #[test]
    fn a_full_backlog_of_a_real_time_child_drops_its_oldest_samples() {
        let backlog = Backlog::default();
        backlog.set_real_time();
        assert!(backlog.push(Ok("{\"paused\": {\"time_s\": 0}}".to_owned())));
        for number in 0..MAX_REAL_TIME_LINES + 10 {
            assert!(backlog.push(sample(number)));
        }
        assert_eq!(backlog.dropped_count(), 11);
        let first = backlog.take(now()).unwrap().unwrap();
        assert!(first.contains("paused"), "other messages are kept: {first}");
        assert_eq!(backlog.take(now()), Ok(sample(11)));
        backlog.end();
        let rest = std::iter::from_fn(|| backlog.take(now()).ok()).count();
        assert_eq!(rest, MAX_REAL_TIME_LINES - 2);
        assert_eq!(backlog.take(now()), Err(NoLine::Ended));
    }

    #[test]
    fn another_child_waits_until_its_lines_are_taken() {
        let backlog = Backlog::default();
        let writer = backlog.clone();
        let thread = std::thread::spawn(move || (0..500).all(|number| writer.push(sample(number))));
        for number in 0..500 {
            let deadline = now() + Duration::from_secs(60);
            assert_eq!(backlog.take(deadline), Ok(sample(number)));
        }
        assert!(thread.join().unwrap());
        assert_eq!(backlog.dropped_count(), 0);
        assert_eq!(backlog.take(now()), Err(NoLine::TimedOut));
        backlog.close();
        assert!(!backlog.push(sample(0)));
    }

    #[test]
    fn the_bytes_that_wait_are_limited() {
        let backlog = Backlog::default();
        backlog.set_real_time();
        let long = || Ok(format!("{{\"sample\": {}}}", " ".repeat(1 << 20)));
        for _ in 0..100 {
            assert!(backlog.push(long()));
        }
        assert!(backlog.lock().bytes <= MAX_BYTES);
        assert_eq!(backlog.dropped_count(), 100 - backlog.lock().lines.len());
    }
}
