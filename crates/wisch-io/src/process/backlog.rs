//! The lines of a child that wait to be read, so that slow observers neither delay the child nor hide its silence.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Most lines that wait, of a child that may be kept waiting.
const MAX_LINES: usize = 64;
/// Most lines that wait, of a child that executes in real time: 20 s of samples at 1 kHz.
const MAX_REAL_TIME_LINES: usize = 20_000;
/// Most bytes of these lines.
const MAX_BYTES: usize = 32 << 20;

/// A line, or the reason why further lines are ignored.
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
    /// The lines, each with the time at which it was received.
    lines: VecDeque<(Instant, Line)>,
    bytes: usize,
    is_real_time: bool,
    dropped: usize,
    /// Whether no more lines are added.
    has_ended: bool,
    /// Whether no more lines are taken.
    is_closed: bool,
    /// Whether the reading thread waits for space; then the child may be unable to write, and its
    /// silence is no fault.
    is_full: bool,
    /// The watch over a motion.
    watch: Option<Watch>,
    /// The silence that the last watch has noticed, as the text that was added to the lines; empty
    /// for another fault, `None` without a fault.
    noticed: Option<String>,
}

/// Watches whether a child falls silent during a motion.
#[derive(Debug, Clone, Copy)]
struct Watch {
    /// Longest time between two lines.
    silence: Duration,
    /// Time at which the last line was received.
    heard: Instant,
    /// Whether the motion is paused; then silence is no fault.
    is_paused: bool,
    /// Whether the child has reported an error.
    has_failed: bool,
}

/// The reason why no line was taken.
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

    /// Begins to watch a motion: from now on, the child sends a line within `silence` until its motion is done.
    pub fn begin_watch(&self, silence: Duration) {
        let mut waiting = self.lock();
        waiting.noticed = None;
        waiting.watch = Some(Watch {
            silence,
            heard: Instant::now(),
            is_paused: false,
            has_failed: false,
        });
    }

    /// Ends the watch. Returns whether it has noticed a fault.
    pub fn end_watch(&self) -> bool {
        let mut waiting = self.lock();
        waiting.watch = None;
        self.shared.1.notify_all();
        waiting.noticed.is_some()
    }

    /// Removes the silence that the last watch has noticed from the lines that wait.
    pub fn forget_fault(&self) {
        let mut waiting = self.lock();
        if let Some(fault) = waiting.noticed.take() {
            waiting
                .lines
                .retain(|(_, line)| line.as_ref().err() != Some(&fault));
        }
    }

    /// Waits until the child falls silent during the motion that is watched, reports an error, or ends its output. Returns
    /// whether it did; `false` if the watch ends before. Lines that wait to be taken do not count: the time is that of their
    /// reception.
    ///
    /// After a silence, the fault is added behind the lines that wait.
    pub fn wait_for_fault(&self) -> bool {
        let mut waiting = self.lock();
        loop {
            let Some(watch) = waiting.watch else {
                return false;
            };
            let left = if watch.is_paused || waiting.is_full {
                Duration::from_secs(1)
            } else {
                watch.silence.saturating_sub(watch.heard.elapsed())
            };
            let is_over = waiting.has_ended || watch.has_failed;
            if is_over || left.is_zero() {
                let mut fault = String::new();
                if !is_over {
                    fault = format!("no message for {} s", watch.silence.as_secs_f64());
                    waiting
                        .lines
                        .push_back((Instant::now(), Err(fault.clone())));
                }
                waiting.noticed = Some(fault);
                waiting.watch = None;
                self.shared.1.notify_all();
                return true;
            }
            waiting = self.wait(waiting, left);
        }
    }

    /// Adds a line, if need be after waiting for space. Returns whether further lines are taken.
    pub fn push(&self, line: Line) -> bool {
        let received = Instant::now();
        let length = line.as_ref().map_or(0, String::len);
        let mut waiting = self.lock();
        waiting.note(&line);
        loop {
            if waiting.is_closed {
                return false;
            }
            if waiting.has_space(length) || waiting.is_real_time && waiting.drop_sample() {
                break;
            }
            waiting.is_full = true;
            waiting = self.wait(waiting, Duration::from_secs(1));
        }
        if std::mem::take(&mut waiting.is_full)
            && let Some(watch) = &mut waiting.watch
        {
            // The child may have waited, too.
            watch.heard = Instant::now();
        }
        waiting.bytes += length;
        waiting.lines.push_back((received, line));
        drop(waiting);
        self.shared.1.notify_all();
        true
    }

    /// Takes the oldest line, with the time of its reception; waits for it until the deadline.
    pub fn take(&self, deadline: Instant) -> Result<(Instant, Line), NoLine> {
        let mut waiting = self.lock();
        loop {
            if let Some((received, line)) = waiting.lines.pop_front() {
                waiting.bytes -= line.as_ref().map_or(0, String::len);
                drop(waiting);
                self.shared.1.notify_all();
                return Ok((received, line));
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
    /// Notes a line that was received, for the watch over the motion.
    fn note(&mut self, line: &Line) {
        let Some(watch) = &mut self.watch else {
            return;
        };
        watch.heard = Instant::now();
        match line.as_deref().map_or("", kind_of) {
            "paused" => watch.is_paused = true,
            "resumed" => watch.is_paused = false,
            "error" => watch.has_failed = true,
            "done" => self.watch = None,
            _ => {}
        }
    }

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
        let is_sample = |line: &Line| line.as_deref().is_ok_and(|line| kind_of(line) == "sample");
        let Some(at) = self.lines.iter().position(|(_, line)| is_sample(line)) else {
            return false;
        };
        if let Some((_, Ok(line))) = self.lines.remove(at) {
            self.bytes -= line.len();
        }
        self.dropped += 1;
        true
    }
}

/// Returns the kind of the message in a line: the first key of its object; empty for another line.
fn kind_of(line: &str) -> &str {
    let begin = line.trim_start().strip_prefix('{');
    let key = begin.and_then(|rest| rest.trim_start().strip_prefix('"'));
    key.and_then(|rest| rest.split('"').next())
        .unwrap_or_default()
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

    /// Takes a line, without its time.
    fn take(backlog: &Backlog, deadline: Instant) -> Result<Line, NoLine> {
        backlog.take(deadline).map(|(_, line)| line)
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
        let first = take(&backlog, now()).unwrap().unwrap();
        assert!(first.contains("paused"), "other messages are kept: {first}");
        assert_eq!(take(&backlog, now()), Ok(sample(11)));
        backlog.end();
        let rest = std::iter::from_fn(|| take(&backlog, now()).ok()).count();
        assert_eq!(rest, MAX_REAL_TIME_LINES - 2);
        assert_eq!(take(&backlog, now()), Err(NoLine::Ended));
    }

    #[test]
    fn another_child_waits_until_its_lines_are_taken() {
        let backlog = Backlog::default();
        let writer = backlog.clone();
        let thread = std::thread::spawn(move || (0..500).all(|number| writer.push(sample(number))));
        for number in 0..500 {
            let deadline = now() + Duration::from_secs(60);
            assert_eq!(take(&backlog, deadline), Ok(sample(number)));
        }
        assert!(thread.join().unwrap());
        assert_eq!(backlog.dropped_count(), 0);
        assert_eq!(take(&backlog, now()), Err(NoLine::TimedOut));
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

    #[test]
    fn silence_is_counted_from_the_last_reception_whatever_waits_to_be_taken() {
        let backlog = Backlog::default();
        backlog.begin_watch(Duration::from_millis(30));
        assert!(backlog.push(sample(1)) && backlog.push(sample(2)));
        assert!(backlog.wait_for_fault(), "nobody has taken a line");
        let [first, second] = [(); 2].map(|()| take(&backlog, now()));
        assert_eq!([first, second], [Ok(sample(1)), Ok(sample(2))]);
        let fault = Err("no message for 0.03 s".to_owned());
        assert_eq!(take(&backlog, now()), Ok(fault));
        assert!(!backlog.wait_for_fault(), "it is reported once");
        assert!(backlog.end_watch());
        backlog.begin_watch(Duration::ZERO);
        assert!(backlog.wait_for_fault());
        backlog.forget_fault();
        assert_eq!(take(&backlog, now()), Err(NoLine::TimedOut));
    }

    #[test]
    fn a_motion_that_is_done_or_paused_may_be_silent_and_a_closed_output_is_no_motion() {
        let backlog = Backlog::default();
        let watch = || backlog.begin_watch(Duration::from_millis(1));
        watch();
        assert!(backlog.push(Ok("{\"done\": {}}".to_owned())));
        assert!(!backlog.wait_for_fault() && !backlog.end_watch());
        watch();
        assert!(backlog.push(Ok("{ \"paused\": {}}".to_owned())));
        std::thread::scope(|scope| {
            let silent = scope.spawn(|| backlog.wait_for_fault());
            std::thread::sleep(Duration::from_millis(50));
            assert!(!silent.is_finished());
            assert!(backlog.push(Ok("{\"resumed\": {}}".to_owned())));
            backlog.shared.1.notify_all();
            assert!(silent.join().unwrap());
        });
        backlog.begin_watch(Duration::from_secs(60));
        backlog.end();
        assert!(backlog.wait_for_fault());
    }
}
