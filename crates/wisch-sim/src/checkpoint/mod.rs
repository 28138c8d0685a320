//! Checkpoints: the executed rounds of a run on disk, so that a killed run can resume.
//!
//! A resumed run recomputes planning and interpretation, with the same result. A checkpoint holds what takes long to
//! compute: the outcome of the execution, and its telemetry.

mod record;

use crate::GroundTruth;
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use record::{CHECKPOINT_SCHEMA, CheckpointRecord};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use wisch::geometry::{Pose, Vector3};
use wisch::represent::Observation;
use wisch::run::{RecordedRound, RecordedSample, Round, TelemetrySample, Wrench};

/// Numbers in a sample beside those of the joints: time, two poses and two wrenches.
const NUMBERS: usize = 1 + 2 * POSE + 2 * WRENCH;
const POSE: usize = 7;
const WRENCH: usize = 6;
/// Bytes of a number.
const BYTES: usize = size_of::<f64>();

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

/// Writer and reader of checkpoints: writes telemetry as it arrives, and each round's outcome at its end.
#[derive(Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    identity: u64,
    writing: Option<Writing>,
}

/// The file of the round that is being executed.
#[derive(Debug)]
struct Writing {
    file: io::Result<BufWriter<File>>,
    samples: usize,
    /// Number of positions, velocities and efforts in a sample.
    counts: [usize; 3],
}

impl Checkpoints {
    /// Opens the checkpoints of the run with this `identity`, a hash of all its inputs, in `folder`.
    pub fn new(folder: &Path, identity: u64) -> Self {
        Self {
            folder: folder.to_owned(),
            identity,
            writing: None,
        }
    }

    /// Begins the record of a round. `number`: from 1.
    pub fn begin(&mut self, number: usize) {
        self.writing = Some(Writing {
            file: File::create(samples_path(&self.folder, number)).map(BufWriter::new),
            samples: 0,
            counts: [0; 3],
        });
    }

    /// Writes a sample. [`Self::keep`] reports a failure to write.
    pub fn sample(&mut self, sample: &TelemetrySample<'_>) {
        let Some(writing) = &mut self.writing else {
            return;
        };
        let Ok(file) = &mut writing.file else {
            return;
        };
        writing.samples += 1;
        writing.counts = [sample.positions, sample.velocities, sample.efforts].map(<[f64]>::len);
        if let Err(error) = write(file, sample) {
            writing.file = Err(error);
        }
    }

    /// Writes the record of a finished round.
    ///
    /// # Errors
    /// If no round has begun, or a file cannot be written.
    pub fn keep(
        &mut self,
        round: &Round,
        first_observation: Option<&Observation>,
        truth: &GroundTruth,
        executing_s: f64,
    ) -> io::Result<()> {
        let writing = self.writing.take();
        let writing = writing
            .ok_or_else(|| io::Error::other("a checkpoint was kept before its round began"))?;
        writing.file?.flush()?;
        let looks = [first_observation, round.interpretation.observation.as_ref()];
        let record = CheckpointRecord::new(
            &round.execution,
            truth,
            looks,
            self.identity,
            (writing.samples, writing.counts),
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
    pub fn read(&self) -> impl Iterator<Item = CheckpointRound> {
        (1..).map_while(|number| read_round(&self.folder, number, self.identity))
    }
}

fn read_round(state: &Path, number: usize, identity: u64) -> Option<CheckpointRound> {
    let text = fs::read(record_path(state, number)).ok()?;
    let record: CheckpointRecord = serde_json::from_slice(&text).ok()?;
    if record.schema != CHECKPOINT_SCHEMA || record.identity != identity {
        return None;
    }
    let bytes = fs::read(samples_path(state, number)).ok()?;
    let joints: usize = record.counts.iter().sum();
    let length = (NUMBERS + joints) * BYTES;
    let samples = bytes.chunks_exact(length);
    let samples: Vec<RecordedSample> = samples.map(|bytes| read(bytes, record.counts)).collect();
    (samples.len() == record.samples).then(|| {
        let executing_s = record.executing_s;
        let [first_observation, observation] = record.observations();
        let (execution, truth) = record.into_execution();
        CheckpointRound {
            executing_s,
            first_observation,
            recorded: RecordedRound {
                samples,
                execution,
                observation,
            },
            truth,
        }
    })
}

fn write(file: &mut impl Write, sample: &TelemetrySample<'_>) -> io::Result<()> {
    let mut put = |numbers: &[f64]| {
        let mut numbers = numbers.iter();
        numbers.try_for_each(|number| file.write_all(&number.to_le_bytes()))
    };
    put(&[sample.time])?;
    for pose in [&sample.world_from_commanded, &sample.world_from_tool] {
        put(pose.translation.vector.as_slice())?;
        put(pose.rotation.coords.as_slice())?;
    }
    for wrench in [&sample.controller, &sample.external] {
        put(wrench.force.as_slice())?;
        put(wrench.moment.as_slice())?;
    }
    put(sample.positions)?;
    put(sample.velocities)?;
    put(sample.efforts)
}

/// Decodes a sample, bit for bit.
fn read(bytes: &[u8], counts: [usize; 3]) -> RecordedSample {
    let numbers = bytes.chunks_exact(BYTES).map(|bytes| {
        let mut eight = [0; BYTES];
        eight.copy_from_slice(bytes);
        f64::from_le_bytes(eight)
    });
    let numbers: Vec<f64> = numbers.collect();
    let vector = |at: usize| Vector3::new(numbers[at], numbers[at + 1], numbers[at + 2]);
    let pose = |at: usize| {
        let [x, y, z, w] = [3, 4, 5, 6].map(|i| numbers[at + i]);
        // Without normalisation, which would change the bits.
        let rotation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        Pose::from_parts(Translation3::from(vector(at)), rotation)
    };
    let wrench = |at: usize| Wrench {
        force: vector(at),
        moment: vector(at + 3),
    };
    let [commanded, tool] = [1, 1 + POSE];
    let [controller, external] = [1 + 2 * POSE, 1 + 2 * POSE + WRENCH];
    RecordedSample {
        time: numbers[0],
        joints: numbers[NUMBERS..].to_vec(),
        counts,
        world_from_commanded: pose(commanded),
        world_from_tool: pose(tool),
        controller: wrench(controller),
        external: wrench(external),
    }
}

fn record_path(state: &Path, number: usize) -> PathBuf {
    state.join(format!("round-{number}.json"))
}

fn samples_path(state: &Path, number: usize) -> PathBuf {
    state.join(format!("round-{number}.samples"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::follow::Phase;

    #[test]
    fn what_was_measured_comes_back_to_the_last_bit() {
        let pose = |first: f64| {
            let rotation = UnitQuaternion::new_unchecked(Quaternion::new(0.4, 0.1, 0.2, 0.3));
            Pose::from_parts(Translation3::new(first, -2.0, 0.1), rotation)
        };
        let wrench = |first: f64| Wrench {
            force: Vector3::new(first, -0.0, 9.9),
            moment: Vector3::new(0.1, 0.2, first),
        };
        let sample = TelemetrySample {
            time: 0.001,
            positions: &[1.0, 2.0],
            velocities: &[0.1, -0.1],
            efforts: &[1e-300],
            world_from_commanded: pose(1.0),
            world_from_tool: pose(1.5),
            controller: wrench(1e-300),
            external: wrench(3.0),
            motion: 3,
            phase: Phase::Wipe(2),
        };
        let mut bytes = Vec::new();
        write(&mut bytes, &sample).unwrap();
        let back = read(&bytes, [2, 2, 1]);
        assert_eq!(back, RecordedSample::from(&sample));
        assert_eq!(back.to_sample(3, Phase::Wipe(2)), Some(sample));
    }
}
