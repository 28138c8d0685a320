//! The telemetry of an episode's round, taken from the bag of the round.

use std::collections::VecDeque;
use std::path::Path;
use wisch::follow::Phase;
use wisch::run::{RecordedSample, TelemetrySample};
use wisch_memory::{TelemetryError, TelemetryWriter};
use wisch_telemetry::read_samples;

/// Time for which samples stay in memory [s]. A bag that fails loses at most its last chunks, each of a second.
const RECENT_S: f64 = 5.0;
/// Largest difference between a time and the same time in a bag, which is in nanoseconds [s].
const ROUNDED_S: f64 = 1e-9;

/// The telemetry of the current round, while its samples go into the bag.
pub(crate) struct BagCopy {
    telemetry: TelemetryWriter,
    /// First sample's time [s], index and phase of each motion, as executed: a robot may run slower than planned. A bag does
    /// not hold them.
    motions: Vec<(f64, usize, Phase)>,
    /// The latest samples, which a bag that fails may lack.
    recent: VecDeque<RecordedSample>,
    /// Whether earlier samples were dropped from memory.
    has_dropped: bool,
}

impl BagCopy {
    pub const fn new(telemetry: TelemetryWriter) -> Self {
        Self {
            telemetry,
            motions: Vec::new(),
            recent: VecDeque::new(),
            has_dropped: false,
        }
    }

    /// Keeps a sample in memory for a while.
    pub fn watch(&mut self, sample: &TelemetrySample<'_>) {
        let is_old = |first: &RecordedSample| first.time < sample.time - RECENT_S;
        while self.recent.front().is_some_and(is_old) {
            self.recent.pop_front();
            self.has_dropped = true;
        }
        let (motion, phase) = (sample.motion, sample.phase);
        let is_same =
            |&(_, known, during): &(f64, usize, Phase)| (known, during) == (motion, phase);
        if !self.motions.last().is_some_and(is_same) {
            self.motions.push((sample.time, motion, phase));
        }
        self.recent.push_back(sample.into());
    }

    /// Copies the samples of the finished bag, and finishes the telemetry.
    pub fn finish(mut self, bag: &Path) -> Result<(), String> {
        let (_, read, written) = self.copy(bag);
        match read.and(written.map_err(|error| error.to_string())) {
            Ok(()) => (self.telemetry.finish()).map_err(|error| error.to_string()),
            Err(error) => {
                self.telemetry.abandon();
                Err(error)
            }
        }
    }

    /// Copies the samples of a bag whose writing failed, and adds the samples that it lacks.
    /// Returns the telemetry, which continues without the bag.
    pub fn recover(mut self, bag: &Path) -> Result<TelemetryWriter, String> {
        // The bag ends at its fault.
        let (last, _, mut written) = self.copy(bag);
        let recent = std::mem::take(&mut self.recent);
        let is_known = |time: f64| last.is_some_and(|last| time <= last + ROUNDED_S);
        let joins = recent.front().is_none_or(|first| is_known(first.time));
        for sample in recent.iter().filter(|sample| !is_known(sample.time)) {
            written = written.and_then(|()| self.write(sample));
        }
        let fault = match written {
            Err(error) => error.to_string(),
            Ok(()) if self.has_dropped && !joins => {
                format!("{}: the bag lacks earlier samples", bag.display())
            }
            Ok(()) => return Ok(self.telemetry),
        };
        self.telemetry.abandon();
        Err(fault)
    }

    /// Discards the telemetry.
    pub fn abandon(self) {
        self.telemetry.abandon();
    }

    /// Copies the samples of a bag. Returns the time of the last one [s], and whether reading and writing succeeded.
    fn copy(
        &mut self,
        bag: &Path,
    ) -> (Option<f64>, Result<(), String>, Result<(), TelemetryError>) {
        let (mut last, mut written) = (None, Ok(()));
        let read = read_samples(bag, |sample| {
            if written.is_ok() {
                last = Some(sample.time);
                written = self.write(&sample);
            }
        });
        (last, read.map_err(|error| error.to_string()), written)
    }

    fn write(&mut self, recorded: &RecordedSample) -> Result<(), TelemetryError> {
        let time = recorded.time + ROUNDED_S;
        let next = self.motions.partition_point(|(start, ..)| *start <= time);
        let during = self.motions.get(next.saturating_sub(1));
        let sample = during.and_then(|&(_, motion, phase)| recorded.to_sample(motion, phase));
        sample.map_or(Ok(()), |sample| self.telemetry.write(&sample))
    }
}
