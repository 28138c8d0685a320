//! Reader of the samples of a bag that wisch wrote, to the last bit of every number but the time.

use super::container::{Ending, Entry, entries};
use super::status::{from_message, from_text};
use super::topic::{NOTES, Topic};
use crate::error::{ReadError, ReadFault};
use crate::ros2::messages::{
    NANOSECONDS_PER_SECOND, Pose, RecordedJointState, RecordedPose, RecordedText,
    RecordedTimeReference, RecordedWrench, Wrench,
};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use wisch::run::{RecordedSample, SampleStatus};

/// Topics of a sample, in the order in which [`BagWriter`](super::BagWriter) writes them.
const OF_A_SAMPLE: [Topic; 5] = [
    Topic::Joints,
    Topic::Commanded,
    Topic::Measured,
    Topic::Controller,
    Topic::External,
];

/// Reads the samples of a bag that [`BagWriter`](crate::BagWriter) has finished, in their order. Each call of `each`
/// receives one sample, so that the bag is never in memory as a whole.
///
/// The numbers are those that were written, except the time: it is rounded to nanoseconds since the log's time 0.
///
/// # Errors
/// If the file cannot be read, is not such a bag, or is not finished.
pub fn read_samples(path: &Path, mut each: impl FnMut(RecordedSample)) -> Result<(), ReadError> {
    let fault = |fault| ReadError {
        file: path.display().to_string(),
        fault,
    };
    let file = File::open(path).map_err(|error| fault(ReadFault::System(error)))?;
    let (mut collector, mut is_ours) = (Collector::default(), false);
    let ending = entries(BufReader::new(file), &mut |entry| match entry {
        Entry::Message(channel, time, data) => {
            let taken = collector.take(&channel.topic, time, data);
            taken.map(|sample| sample.into_iter().for_each(&mut each))
        }
        Entry::Notes(name, _) => {
            is_ours |= name == NOTES;
            Ok(())
        }
    });
    match ending.map_err(fault)? {
        Ending::CutOff { byte } => Err(fault(ReadFault::Truncated { byte })),
        Ending::Footer if !is_ours => Err(fault(ReadFault::Sample {
            topic: OF_A_SAMPLE[0].names().0.to_owned(),
            problem: "the bag was not written by wisch".to_owned(),
        })),
        Ending::Footer => Ok(()),
    }
}

/// The messages of one sample.
#[derive(Default)]
struct Collector {
    /// Number of messages of the sample so far.
    count: usize,
    /// Time of these messages [ns].
    time: u64,
    joints: Vec<f64>,
    counts: [usize; 3],
    poses: [Option<Pose>; 2],
    controller: Option<Wrench>,
    /// Status of the samples from now on; its stamp is that of the next sample.
    status: SampleStatus,
}

impl Collector {
    /// Takes a message; returns the sample that it completes.
    fn take(
        &mut self,
        topic: &str,
        time: u64,
        data: &[u8],
    ) -> Result<Option<RecordedSample>, ReadFault> {
        if let Some(taken) = self.take_status(topic, data) {
            return taken.map(|()| None).map_err(|problem| ReadFault::Sample {
                topic: topic.to_owned(),
                problem,
            });
        }
        let Some(place) = (OF_A_SAMPLE.iter()).position(|known| known.names().0 == topic) else {
            return Ok(None);
        };
        let fault = |problem: String| ReadFault::Sample {
            topic: topic.to_owned(),
            problem,
        };
        if place != self.count || (place > 0 && time != self.time) {
            let problem = format!("a message at {time} ns belongs to no sample");
            return Err(fault(problem));
        }
        (self.time, self.count) = (time, (place + 1) % OF_A_SAMPLE.len());
        let message = |error: cdr::Error| fault(error.to_string());
        match OF_A_SAMPLE[place] {
            Topic::Joints => {
                let state: RecordedJointState = cdr::deserialize(data).map_err(message)?;
                let lists = [state.position, state.velocity, state.effort];
                self.counts = lists.each_ref().map(Vec::len);
                self.joints = lists.concat();
            }
            Topic::Commanded | Topic::Measured => {
                let pose: RecordedPose = cdr::deserialize(data).map_err(message)?;
                self.poses[place - 1] = Some(pose.pose);
            }
            Topic::Controller => {
                let wrench: RecordedWrench = cdr::deserialize(data).map_err(message)?;
                self.controller = Some(wrench.wrench);
            }
            _ => {
                let external: RecordedWrench = cdr::deserialize(data).map_err(message)?;
                let [commanded, measured] = std::mem::take(&mut self.poses);
                let (Some(commanded), Some(measured), Some(controller)) =
                    (commanded, measured, self.controller.take())
                else {
                    return Ok(None);
                };
                return Ok(Some(RecordedSample {
                    time: time as f64 / NANOSECONDS_PER_SECOND as f64,
                    joints: std::mem::take(&mut self.joints),
                    counts: self.counts,
                    world_from_commanded: commanded.into(),
                    world_from_tool: measured.into(),
                    controller: controller.into(),
                    external: external.wrench.into(),
                    status: self.take_sample_status(),
                }));
            }
        }
        Ok(None)
    }
}

impl Collector {
    /// Takes a message about the next sample; `None` for a message of another topic.
    fn take_status(&mut self, topic: &str, data: &[u8]) -> Option<Result<(), String>> {
        if topic == Topic::Status.names().0 {
            let text = cdr::deserialize::<RecordedText>(data).map_err(|error| error.to_string());
            let status = text.and_then(|text| from_text(&text.data));
            return Some(status.map(|status| {
                let stamp = self.status.stamp;
                self.status = SampleStatus { stamp, ..status };
            }));
        }
        if topic == Topic::Stamp.names().0 {
            let message = cdr::deserialize::<RecordedTimeReference>(data);
            let message = message.map_err(|error| error.to_string());
            let stamp = message.and_then(|message| from_message(&message));
            return Some(stamp.map(|stamp| self.status.stamp = Some(stamp)));
        }
        None
    }

    /// Returns the status of the sample that is complete.
    const fn take_sample_status(&mut self) -> SampleStatus {
        let status = self.status;
        self.status.stamp = None;
        status
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BagHead, BagWriter};
    use nalgebra::{Quaternion, Translation3, UnitQuaternion};
    use wisch::control::Wrench;
    use wisch::follow::Phase;
    use wisch::geometry::{Pose, Vector3};
    use wisch::interpret::WrenchQuality;
    use wisch::run::{Stamp, StampClock, TelemetrySample};

    fn pose(first: f64) -> Pose {
        let rotation = UnitQuaternion::new_unchecked(Quaternion::new(0.4, 0.1, 0.2, 0.3));
        Pose::from_parts(Translation3::new(first, -2.0, 0.1), rotation)
    }

    fn wrench(first: f64) -> Wrench {
        Wrench {
            force: Vector3::new(first, -0.0, 9.9),
            moment: Vector3::new(0.1, 1.0 / 3.0, first),
        }
    }

    #[test]
    fn what_was_measured_comes_back_to_the_last_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("round-1.mcap");
        let head = BagHead {
            joints: vec!["a".to_owned(), "b".to_owned()],
            ..BagHead::default()
        };
        let mut bag = BagWriter::create(&path, head).unwrap();
        let mut written = Vec::new();
        for k in 0..2500_i32 {
            let value = f64::from(k) / 7.0;
            let sample = TelemetrySample {
                time: f64::from(k) / 1000.0,
                positions: &[value, -0.0],
                velocities: &[1e-300, f64::from(k).sqrt()],
                efforts: if k % 2 == 0 { &[] } else { &[0.1, 0.2] },
                world_from_commanded: pose(value),
                world_from_tool: pose(-value),
                controller: wrench(1e-300),
                external: wrench(value),
                motion: 3,
                phase: Phase::Wipe(2),
                status: SampleStatus {
                    stamp: (k % 3 > 0).then_some(Stamp {
                        nanoseconds: 1_764_150_000_123_456_789 + u64::try_from(k).unwrap(),
                        clock: StampClock::ALL[k as usize % 2],
                    }),
                    wrench: WrenchQuality::ALL[(k / 400) as usize % 4],
                    is_paused: (1000..1100).contains(&k),
                },
            };
            bag.write(&sample).unwrap();
            written.push(RecordedSample::from(&sample));
        }
        bag.finish().unwrap();
        let mut read = Vec::new();
        read_samples(&path, |sample| read.push(sample)).unwrap();
        assert_eq!(read, written);
    }

    #[test]
    fn an_unfinished_bag_and_another_file_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("round-1.mcap");
        let bag = BagWriter::create(&path, BagHead::default()).unwrap();
        bag.finish().unwrap();
        let whole = std::fs::read(&path).unwrap();
        std::fs::write(&path, &whole[..whole.len() / 2]).unwrap();
        let refused = read_samples(&path, |_| ()).unwrap_err().to_string();
        assert!(refused.contains("ends at byte"), "{refused}");
        std::fs::write(&path, "time,x\n").unwrap();
        let refused = read_samples(&path, |_| ()).unwrap_err().to_string();
        assert!(refused.contains("not a bag"), "{refused}");
    }
}
