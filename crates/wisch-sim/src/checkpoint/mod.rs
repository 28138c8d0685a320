//! Rounds on the disk while a run goes on, so that it can be resumed should it be killed.
//!
//! What a round began with and what followed from it is computed anew, which gives the same; what is kept is
//! what takes long to compute: how the execution went, and what was measured.

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

/// Numbers of a sample beside those of the joints: time, two poses and two wrenches.
const NUMBERS: usize = 1 + 2 * POSE + 2 * WRENCH;
const POSE: usize = 7;
const WRENCH: usize = 6;
/// Bytes of a number.
const BYTES: usize = size_of::<f64>();

/// A round of an earlier run, and how long executing it took.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptRound {
    /// What was measured, and how it went.
    pub recorded: RecordedRound,
    /// What was seen before it, where it is the first and something looked.
    pub first_look: Option<Observation>,
    /// What the simulated world knows of it.
    pub truth: GroundTruth,
    /// How long simulating took [s].
    pub executing_s: f64,
}

/// Puts what is measured on the disk as it comes, and after every round what became of it.
#[derive(Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    identity: u64,
    writing: Option<Writing>,
}

/// A round that is being executed.
#[derive(Debug)]
struct Writing {
    file: io::Result<BufWriter<File>>,
    samples: usize,
    /// How many positions, velocities and efforts a sample has.
    counts: [usize; 3],
}

impl Checkpoints {
    /// Checkpoints in a folder, of a run that is told from others by this number.
    pub fn new(folder: &Path, identity: u64) -> Self {
        Self {
            folder: folder.to_owned(),
            identity,
            writing: None,
        }
    }

    /// Begins a round.
    pub fn begin(&mut self, number: usize) {
        self.writing = Some(Writing {
            file: File::create(samples_path(&self.folder, number)).map(BufWriter::new),
            samples: 0,
            counts: [0; 3],
        });
    }

    /// Takes down a sample. That this fails is said when the round is over.
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

    /// Puts a round on the disk.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep(
        &mut self,
        round: &Round,
        first_look: Option<&Observation>,
        truth: &GroundTruth,
        executing_s: f64,
    ) -> io::Result<()> {
        let writing = self.writing.take();
        let writing = writing.ok_or_else(|| io::Error::other("no round has begun"))?;
        writing.file?.flush()?;
        let looks = [first_look, round.interpretation.observation.as_ref()];
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
        // The record, which says that all is there, comes last, and whole or not at all.
        let unfinished = self.folder.join("record");
        fs::write(&unfinished, text)
            .and_then(|()| fs::rename(&unfinished, record_path(&self.folder, number)))
    }

    /// The rounds that a killed run left, as far as they are of this very run, in their order.
    pub fn read(&self) -> impl Iterator<Item = KeptRound> {
        (1..).map_while(|number| read_round(&self.folder, number, self.identity))
    }
}

fn read_round(state: &Path, number: usize, identity: u64) -> Option<KeptRound> {
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
        let [first_look, observation] = record.looks();
        let (execution, truth) = record.executed();
        KeptRound {
            executing_s,
            first_look,
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

/// A sample as it was, to the last bit.
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
        // No normalisation.
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
        assert_eq!(back.during(3, Phase::Wipe(2)), Some(sample));
    }
}
