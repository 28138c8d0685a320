//! Recognition of a recording that the memory has already, by its samples.

use crate::catalogue::{EpisodeRow, entries};
use crate::store::{Memory, MemoryError};
use wisch::geometry::Point2;
use wisch::interpret::TouchSample;
use wisch::represent::Observation;

/// Text of the remark of an episode whose log was imported before its recording was complete.
pub const CUT_REMARK: &str = "the log is incomplete: its writer did not finish it";

/// Largest difference of the times of one sample in two recordings [s]: files keep nanoseconds.
const SAME_TIME: f64 = 1e-6;
/// Largest differences of one sample in two recordings: of the position [m], times 1 plus its norm; of the quaternion; and
/// of the force [N], times 1 plus a hundredth of its norm. Files keep single precision, and tables at least 3 decimals of
/// millimetres, quaternions and newtons.
const SAME_POSITION: f64 = 1e-6;
const SAME_ROTATION: f64 = 1e-3;
const SAME_FORCE: f64 = 1e-3;
/// Distance below which two observations state the same place [m].
const SAME_PLACE: f64 = 1e-5;
/// Least share of the time and of the samples of the shorter recording that the other one must hold [1]; samples whose wrench
/// is not usable are missing.
const LEAST_SHARED: f64 = 0.9;
/// Largest share of the samples whose forces may differ where their times and poses are equal [1], and the number that may in
/// any recording: a log is read without single outliers of the force, which an episode keeps.
const MOST_OUTLIERS: f64 = 0.01;
const OUTLIERS: usize = 5;
/// Least number of samples that show that a shorter recording is a part of a longer one.
const LEAST_SAMPLES: usize = 20;
/// Least distance by which the tool moves in a recording that is only a part of another one [m]: tools at rest are alike.
const LEAST_WAY: f64 = 0.01;
/// Number of samples at the beginning of a kept round that are compared before the whole round is read.
const PROBE: usize = 2_000;
/// Largest difference of the durations of a round in two recordings: absolute [s], and relative [1].
const SAME_DURATION: [f64; 2] = [0.1, 0.01];

/// A round of an episode that holds a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KnownRound {
    /// Name of the episode.
    pub episode: String,
    /// Number of the round in the episode, from 1.
    pub round: usize,
}

/// Returns whether two recordings hold the same motion: the same poses and forces at the same times.
///
/// One of them may be cut at its end, lack samples, have a lower rate, or lack single outliers of the force. Robots with noise never repeat a motion, but a
/// simulation with the same seed does.
///
/// ```
/// use wisch::geometry::{Pose, Vector3};
/// use wisch::interpret::TouchSample;
/// use wisch_memory::is_same_motion;
/// let sample = |i: i32, force: f64| {
///     let x = 0.01 * f64::from(i);
///     TouchSample::new(0.1 * f64::from(i), Pose::translation(x, 0.0, 0.0), Vector3::new(0.0, 0.0, force))
/// };
/// let one: Vec<TouchSample> = (0..50).map(|i| sample(i, 10.0)).collect();
/// let other: Vec<TouchSample> = (0..50).map(|i| sample(i, 9.9)).collect();
/// assert!(is_same_motion(&one, &one) && is_same_motion(&one[..30], &one));
/// assert!(!is_same_motion(&one, &other));
/// let mut spiked = one.clone();
/// spiked[20].force.z = 500.0;
/// assert!(is_same_motion(&one, &spiked));
/// ```
pub fn is_same_motion(one: &[TouchSample], other: &[TouchSample]) -> bool {
    let (Some(first), Some(last)) = (one.first().zip(other.first()), one.last().zip(other.last()))
    else {
        return false;
    };
    let from = first.0.time.max(first.1.time) - SAME_TIME;
    let to = last.0.time.min(last.1.time) + SAME_TIME;
    let span = (last.0.time - first.0.time).min(last.1.time - first.1.time);
    let shared = |samples: &[TouchSample]| {
        let inside = samples.iter().filter(|s| (from..=to).contains(&s.time));
        inside.count()
    };
    let least = shared(one).min(shared(other));
    let is_whole = one.len() == other.len();
    if to - from < LEAST_SHARED * span || (least < LEAST_SAMPLES && !is_whole) {
        return false;
    }
    let (mut i, mut j, mut same, mut outliers) = (0, 0, 0, 0);
    while let (Some(a), Some(b)) = (one.get(i), other.get(j)) {
        if a.time < b.time - SAME_TIME {
            i += 1;
        } else if b.time < a.time - SAME_TIME {
            j += 1;
        } else if is_same_pose(a, b) {
            if is_same_force(a, b) {
                same += 1;
            } else {
                outliers += 1;
            }
            i += 1;
            j += 1;
        } else {
            return false;
        }
    }
    let most = OUTLIERS.max((MOST_OUTLIERS * same as f64) as usize);
    outliers <= most && same > 0 && same as f64 >= LEAST_SHARED * least as f64
}

/// Whether two samples of the same time have the same pose, in the precision of files.
fn is_same_pose(one: &TouchSample, other: &TouchSample) -> bool {
    let [a, b] = [one, other].map(|sample| sample.world_from_tool.translation.vector);
    let [p, q] = [one, other].map(|sample| sample.world_from_tool.rotation.coords);
    (a - b).norm() <= SAME_POSITION * (1.0 + a.norm())
        && (p - q).norm().min((p + q).norm()) <= SAME_ROTATION
}

/// Whether two samples have the same force, in the precision of files.
fn is_same_force(one: &TouchSample, other: &TouchSample) -> bool {
    (one.force - other.force).norm() <= SAME_FORCE * (1.0 + 0.01 * one.force.norm())
}

/// Returns whether the detections before and after two rounds may be the same. Detections are
/// compared up to the single precision of bags; an observation that one of the recordings lacks may
/// be any. Hidden areas are not compared.
pub fn may_be_same_observations(
    one: &[Option<Observation>; 2],
    other: &[Option<Observation>; 2],
) -> bool {
    let is_near = |(p, q): (&Point2, &Point2)| (p - q).norm() <= SAME_PLACE;
    one.iter().zip(other).all(|pair| match pair {
        (Some(one), Some(other)) => {
            let [one, other] = [&one.detections, &other.detections];
            one.len() == other.len() && one.iter().zip(other).all(is_near)
        }
        _ => true,
    })
}

/// A recording of a round that the memory may have already.
#[derive(Debug, Clone, Copy)]
pub struct RecordedMotion<'a> {
    /// Tool poses and forces.
    pub samples: &'a [TouchSample],
    /// Whether the recording lacks its end, because its writer was killed or is still writing.
    pub is_cut: bool,
    /// Name of the executed task, if the recording states it.
    pub task: Option<&'a str>,
    /// Observations of the dirt before and after the round, as far as the recording holds them.
    pub observations: &'a [Option<Observation>; 2],
}

impl Memory {
    /// Finds the round that holds a recorded motion, by its samples, whatever the files are called.
    ///
    /// A log of which the memory has only the beginning is found too, and so is the beginning of a log that was imported.
    /// Rounds of another task, with other observations, and rounds that cannot be read are skipped.
    ///
    /// # Errors
    /// If the folder cannot be listed.
    pub fn find_round(
        &self,
        recorded: &RecordedMotion<'_>,
    ) -> Result<Option<KnownRound>, MemoryError> {
        let Some(last) = recorded.samples.last() else {
            return Ok(None);
        };
        let catalogue = self.catalogue()?;
        let of_task = |row: &&EpisodeRow| recorded.task.is_none_or(|task| row.task == task);
        for row in catalogue.episodes().iter().filter(of_task) {
            let digests = catalogue.texts("semco:logDigest");
            let is_imported = !entries(digests, row.first).is_empty();
            for (place, start) in row.rounds.iter().enumerate() {
                let end = row.rounds.get(place + 1).copied();
                let longer = end.unwrap_or(row.interval[1]) - start - last.time;
                let [absolute, relative] = SAME_DURATION;
                let is_like = longer.abs() <= absolute + relative * last.time;
                // A logger may have been copied while it wrote.
                let may_be_part = is_imported || (recorded.is_cut && longer > 0.0);
                let round = place + 1;
                let least_way = if is_like { 0.0 } else { LEAST_WAY };
                if (is_like || may_be_part)
                    && self.holds(&row.id, round, recorded, least_way) == Some(true)
                {
                    return Ok(Some(KnownRound {
                        episode: row.id.clone(),
                        round,
                    }));
                }
            }
        }
        Ok(None)
    }

    /// Whether a round of an episode holds a recorded motion, in both of which the tool moves by at least `least_way` [m];
    /// `None` if it cannot be read.
    fn holds(
        &self,
        id: &str,
        round: usize,
        recorded: &RecordedMotion<'_>,
        least_way: f64,
    ) -> Option<bool> {
        let episode = self.episode(id).ok()?;
        let seen = episode.observations(round).ok()?;
        if seen.is_some_and(|seen| {
            !may_be_same_observations(&seen.observations, recorded.observations)
        }) {
            return Some(false);
        }
        let telemetry = episode.telemetry(round).ok()?;
        // Most rounds differ at once; reading a whole round takes longer.
        let some = 0..telemetry.rows().min(PROBE);
        let (probe, _) = telemetry.touch_samples_of(some).ok()?;
        if !probe.is_empty() && !is_same_motion(&probe, recorded.samples) {
            return Some(false);
        }
        let (kept, _) = telemetry.touch_samples().ok()?;
        let moves = |samples: &[TouchSample]| find_way(samples) >= least_way;
        Some(moves(&kept) && moves(recorded.samples) && is_same_motion(&kept, recorded.samples))
    }
}

/// Returns the largest distance of the tool from its first position [m].
fn find_way(samples: &[TouchSample]) -> f64 {
    let place = |sample: &TouchSample| sample.world_from_tool.translation.vector;
    let distances = samples
        .iter()
        .map(|sample| (place(sample) - place(&samples[0])).norm());
    distances.fold(0.0, f64::max)
}
