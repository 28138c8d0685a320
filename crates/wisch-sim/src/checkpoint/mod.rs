//! Rounds on the disk while a run goes on, so that it can be resumed should it be killed.
//!
//! What a round began with and what followed from it is computed anew, which gives the same; what is kept is
//! what takes long to compute or cannot be seen in a bag: how the execution went, and what was felt.

mod record;

use crate::GroundTruth;
use record::{CHECKPOINT_SCHEMA, CheckpointRecord};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::TouchSample;
use wisch::represent::Observation;
use wisch::run::{RecordedRound, Round, TelemetrySample};

/// Numbers of a sample: time, position, quaternion x, y, z, w, force.
const NUMBERS: usize = 11;
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

/// Takes down what is felt, and puts it on the disk after every round.
#[derive(Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    identity: u64,
    touches: Vec<u8>,
}

impl Checkpoints {
    /// Checkpoints in a folder, of a run that is told from others by this number.
    pub fn new(folder: &Path, identity: u64) -> Self {
        Self {
            folder: folder.to_owned(),
            identity,
            touches: Vec::new(),
        }
    }

    /// Begins a round.
    pub fn begin(&mut self) {
        self.touches.clear();
    }

    /// Takes down a sample.
    pub fn sample(&mut self, sample: &TelemetrySample<'_>) {
        let pose = &sample.world_from_tool;
        let (p, q) = (pose.translation.vector, pose.rotation.coords);
        let f = sample.external.force;
        let numbers: [f64; NUMBERS] = [
            sample.time,
            p.x,
            p.y,
            p.z,
            q.x,
            q.y,
            q.z,
            q.w,
            f.x,
            f.y,
            f.z,
        ];
        self.touches
            .extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    }

    /// Puts a round on the disk.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep(
        &self,
        round: &Round,
        first_look: Option<&Observation>,
        truth: &GroundTruth,
        executing_s: f64,
    ) -> io::Result<()> {
        let samples = self.touches.len() / (NUMBERS * BYTES);
        let looks = [first_look, round.interpretation.observation.as_ref()];
        let record = CheckpointRecord::new(
            &round.execution,
            truth,
            looks,
            self.identity,
            samples,
            executing_s,
        );
        let text = serde_json::to_string(&record).map_err(io::Error::other)?;
        let number = round.motion.number;
        // The record, which says that all is there, comes last, and whole or not at all.
        let unfinished = self.folder.join("record");
        fs::write(touches_path(&self.folder, number), &self.touches)
            .and_then(|()| fs::write(&unfinished, text))
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
    let bytes = fs::read(touches_path(state, number)).ok()?;
    let touches: Vec<TouchSample> = bytes.chunks_exact(NUMBERS * BYTES).map(touch).collect();
    (touches.len() == record.samples).then(|| {
        let executing_s = record.executing_s;
        let [first_look, observation] = record.looks();
        let (execution, truth) = record.executed();
        KeptRound {
            executing_s,
            first_look,
            recorded: RecordedRound {
                touches,
                execution,
                observation,
            },
            truth,
        }
    })
}

fn touch(bytes: &[u8]) -> TouchSample {
    let mut numbers = [0.0; NUMBERS];
    for (number, bytes) in numbers.iter_mut().zip(bytes.chunks_exact(BYTES)) {
        let mut eight = [0; BYTES];
        eight.copy_from_slice(bytes);
        *number = f64::from_le_bytes(eight);
    }
    let [time, x, y, z, qx, qy, qz, qw, fx, fy, fz] = numbers;
    let rotation = nalgebra::Quaternion::new(qw, qx, qy, qz);
    TouchSample {
        time,
        // As it was, to the last bit: no normalisation.
        world_from_tool: Pose::from_parts(
            nalgebra::Translation3::new(x, y, z),
            nalgebra::UnitQuaternion::new_unchecked(rotation),
        ),
        force: Vector3::new(fx, fy, fz),
    }
}

fn record_path(state: &Path, number: usize) -> PathBuf {
    state.join(format!("round-{number}.json"))
}

fn touches_path(state: &Path, number: usize) -> PathBuf {
    state.join(format!("round-{number}.felt"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_felt_comes_back_to_the_last_bit() {
        let numbers = [0.001, 1.0, -2.0, 0.1, 0.1, 0.2, 0.3, 0.4, 1e-300, -0.0, 9.9];
        let bytes: Vec<u8> = numbers.iter().flat_map(|n: &f64| n.to_le_bytes()).collect();
        let touch = touch(&bytes);
        let q = touch.world_from_tool.rotation.coords;
        assert_eq!([q.x, q.y, q.z, q.w], [0.1, 0.2, 0.3, 0.4], "not normalised");
        assert_eq!(touch.time, 0.001);
        assert_eq!(touch.world_from_tool.translation.vector.z, 0.1);
        assert_eq!(touch.force, Vector3::new(1e-300, -0.0, 9.9));
    }
}
