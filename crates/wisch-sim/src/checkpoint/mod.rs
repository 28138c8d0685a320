//! Checkpoints: the executed rounds of a run on disk, so that a killed run can resume.
//!
//! A resumed run recomputes planning and interpretation, with the same result. Only the execution
//! takes long: a checkpoint holds its outcome and the exact times of its samples, and the round's
//! bag holds the samples.

mod record;

use crate::GroundTruth;
use record::{CHECKPOINT_SCHEMA, CheckpointRecord};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use wisch::represent::Observation;
use wisch::run::{RecordedRound, RecordedSample, Round};

/// Version of the records whose samples are in a separate file, each sample with its time first.
const SCHEMA_WITH_SAMPLES: u32 = 5;
/// Numbers in a sample of such a file beside those of the joints: time, two poses and two wrenches.
const NUMBERS: usize = 1 + 2 * 7 + 2 * 6;
/// Bytes of a number.
const BYTES: usize = size_of::<f64>();
/// Largest difference between a time and the same time in a bag, which is in nanoseconds [s].
const ROUNDED_S: f64 = 1e-9;

/// A round of an earlier run, and the time that executing it took.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckpointRound {
    /// Telemetry and outcome of the round.
    pub recorded: RecordedRound,
    /// Observation before the first round; `None` for later rounds, or without a camera.
    pub first_observation: Option<Observation>,
    /// Ground truth of the round.
    pub truth: GroundTruth,
    /// Wall-clock time that the simulation took \[s\].
    pub executing_s: f64,
}

/// Writer and reader of checkpoints: keeps the times of the samples, and writes each round's outcome at its end.
#[derive(Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    identity: u64,
    /// Times of the samples of the round that is being executed [s].
    times: Vec<f64>,
}

impl Checkpoints {
    /// Opens the checkpoints of the run with this `identity`, a hash of all its inputs, in `folder`.
    pub fn new(folder: &Path, identity: u64) -> Self {
        Self {
            folder: folder.to_owned(),
            identity,
            times: Vec::new(),
        }
    }

    /// Begins the record of a round.
    pub fn begin(&mut self) {
        self.times.clear();
    }

    /// Adds a sample. `time`: since the round began \[s\].
    pub fn sample(&mut self, time: f64) {
        self.times.push(time);
    }

    /// Writes the record of a finished round.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn keep(
        &mut self,
        round: &Round,
        first_observation: Option<&Observation>,
        truth: &GroundTruth,
        executing_s: f64,
    ) -> io::Result<()> {
        let looks = [first_observation, round.interpretation.observation.as_ref()];
        let times = std::mem::take(&mut self.times);
        let record = CheckpointRecord::new(
            &round.execution,
            truth,
            looks,
            self.identity,
            times,
            executing_s,
        );
        let text = serde_json::to_string(&record).map_err(io::Error::other)?;
        let number = round.motion.number;
        // The record marks the checkpoint as complete, so it is written last and renamed as a whole.
        let unfinished = self.folder.join("record");
        fs::write(&unfinished, text)
            .and_then(|()| fs::rename(&unfinished, record_path(&self.folder, number)))
    }

    /// Reads the rounds that a killed run with this identity left, in order, up to the first that is missing.
    ///
    /// `samples`: returns the samples in the bag of a round, counted from 1; `None` if its bag cannot be read.
    pub fn read(
        &self,
        samples: impl Fn(usize) -> Option<Vec<RecordedSample>>,
    ) -> impl Iterator<Item = CheckpointRound> {
        (1..).map_while(move |number| self.read_round(number, &samples))
    }

    /// Returns the number of rounds that a killed run with another identity left.
    pub fn count_rounds_of_another_run(&self) -> usize {
        let records = (1..).map_while(|number| self.read_record(number));
        records
            .filter(|record| record.identity != self.identity)
            .count()
    }

    fn read_record(&self, number: usize) -> Option<CheckpointRecord> {
        let text = fs::read(record_path(&self.folder, number)).ok()?;
        serde_json::from_slice(&text).ok()
    }

    fn read_round(
        &self,
        number: usize,
        samples: impl Fn(usize) -> Option<Vec<RecordedSample>>,
    ) -> Option<CheckpointRound> {
        let record = self.read_record(number)?;
        if record.identity != self.identity {
            return None;
        }
        let times = match record.schema {
            CHECKPOINT_SCHEMA => record.times_s.clone(),
            SCHEMA_WITH_SAMPLES => {
                let path = self.folder.join(format!("round-{number}.samples"));
                times_of_samples(&fs::read(path).ok()?, record.counts)
            }
            _ => return None,
        };
        let mut samples = samples(number)?;
        if times.len() != samples.len() {
            return None;
        }
        for (sample, time) in samples.iter_mut().zip(times) {
            // The bag is not the one of this round.
            if (sample.time - time).abs() > ROUNDED_S {
                return None;
            }
            sample.time = time;
        }
        let executing_s = record.executing_s;
        let [first_observation, observation] = record.observations();
        let (execution, truth) = record.into_execution();
        Some(CheckpointRound {
            executing_s,
            first_observation,
            recorded: RecordedRound {
                samples,
                execution,
                observation,
            },
            truth,
        })
    }
}

/// Returns the times in a file of samples \[s\], as version 0.2.0 wrote it. `counts`: number of positions, velocities and
/// efforts in each sample.
fn times_of_samples(bytes: &[u8], counts: [usize; 3]) -> Vec<f64> {
    let joints: usize = counts.iter().sum();
    let samples = bytes.chunks_exact((NUMBERS + joints) * BYTES);
    let times = samples.map(|sample| {
        let mut time = [0; BYTES];
        time.copy_from_slice(&sample[..BYTES]);
        f64::from_le_bytes(time)
    });
    times.collect()
}

fn record_path(state: &Path, number: usize) -> PathBuf {
    state.join(format!("round-{number}.json"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_earlier_versions_are_read() {
        let samples = [0.001, 0.1 + 0.2].map(|time| {
            let mut numbers = [0.0_f64; NUMBERS + 4];
            numbers[0] = time;
            numbers
        });
        let bytes: Vec<u8> = (samples.iter().flatten())
            .flat_map(|number| number.to_le_bytes())
            .collect();
        assert_eq!(times_of_samples(&bytes, [2, 2, 0]), [0.001, 0.1 + 0.2]);
    }
}
