//! Poses or forces over time, and how they are paired.

use super::error::ReadFault;
use super::frames::Frames;
use super::options::WrenchSign;
use super::quantity::{Quantity, QuantityError};
use super::ros2::NANOSECONDS_PER_SECOND;
use std::collections::BTreeMap;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::WrenchQuality;
use wisch::represent::Observation;
use wisch::robot::{JointMotion, JointTransform};

/// Number of late entries in a row that may show a clock that was set back.
const LATE_RUN: usize = 10;
/// Least number of them that repeat the time of an earlier entry, and most earlier entries that are compared.
const LEAST_REPEATED: usize = 8;
const MOST_EARLIER: usize = 10_000;

/// Values of one quantity in a log, by time.
#[derive(Debug, Clone)]
pub(crate) struct Track<Q> {
    /// Source of the values, as messages call it.
    pub name: String,
    /// Frame in which the values are stated; empty if the log names none.
    pub frame: String,
    /// Frame whose pose the values are; empty if the log names none.
    pub child: String,
    /// Times [ns] and values; once the track is finished, each time is later than the previous one.
    pub entries: Vec<(i64, Q)>,
    /// Largest delay of an entry that is still sorted in [ns].
    window: i64,
    /// Latest time in the current part, which is a file [ns].
    latest: Option<i64>,
    /// Number of entries that came after a later one of their part, and their largest delay [ns].
    late: (usize, i64),
    /// Number of entries at the end that all came after a later one.
    late_run: usize,
    /// Number of entries dropped because their time equals the previous one.
    pub repeated: usize,
    /// Number of entries dropped because their numbers are not valid.
    pub skipped: usize,
    /// Place and fault of the first of these.
    pub first_skipped: Option<(String, QuantityError)>,
}

/// Raw contents of a log, before frames, signs and units are resolved.
pub(crate) struct RawLog {
    pub poses: Track<Pose>,
    pub wrenches: Track<Vector3>,
    pub axes: Option<String>,
    pub start: Option<i64>,
    pub unfinished: bool,
    /// Transforms between frames.
    pub frames: Frames,
    /// Positions of the robot's joints.
    pub joints: JointPositions,
    /// Name of the executed task, if the writer states it.
    pub task: Option<String>,
    /// Digest of the surface's mesh, if the writer states it.
    pub surface_mesh: Option<String>,
    /// Nominal press force [N], if the writer states it.
    pub press_force_n: Option<f64>,
    /// Number of the executed round, if the writer states it.
    pub round: Option<usize>,
    /// Camera observations of the dirt before and after the round.
    pub looks: [Option<Observation>; 2],
    /// Times [ns] from which the wrench has a quality, in their order; it is usable before the first.
    pub qualities: Vec<(i64, WrenchQuality)>,
    /// Sign convention of the forces, if the log states it.
    pub sign: Option<WrenchSign>,
    /// Units that are assumed, in a sentence.
    pub assumed_units: Option<String>,
    /// Remarks: what the reader assumed or did.
    pub remarks: Vec<String>,
}

/// Positions of joints over time, by name.
#[derive(Debug, Clone, Default)]
pub(crate) struct JointPositions {
    /// Times [ns] and positions [rad or m] of the requested joints.
    entries: BTreeMap<String, Vec<(i64, f64)>>,
}

impl RawLog {
    /// Quality of the wrench at a time [ns].
    pub fn quality_at(&self, time: i64) -> WrenchQuality {
        let next = self.qualities.partition_point(|(start, _)| *start <= time);
        let current = next.checked_sub(1).map(|at| self.qualities[at].1);
        current.unwrap_or_default()
    }
}

impl JointPositions {
    /// Creates an empty record for the moving joints among `joints`, and for the joints that they follow.
    pub fn new(joints: &[JointTransform]) -> Self {
        let moving = (joints.iter()).filter(|joint| joint.motion != JointMotion::Fixed);
        let names = moving.flat_map(|joint| {
            let others = joint.mimic.iter().flat_map(|mimic| &mimic.terms);
            std::iter::once(&joint.joint).chain(others.map(|(name, _)| name))
        });
        Self {
            entries: names.map(|name| (name.clone(), Vec::new())).collect(),
        }
    }

    /// Whether no joint is requested.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Whether the log holds a position of any requested joint.
    pub fn are_known(&self) -> bool {
        self.entries.values().any(|entries| !entries.is_empty())
    }

    /// Adds a position [rad or m] at a time [ns], if the joint is requested.
    pub fn push(&mut self, name: &str, time: i64, position: f64) {
        if let Some(entries) = self.entries.get_mut(name) {
            entries.push((time, position));
        }
    }

    /// Shifts all times by `shift` [ns].
    pub fn shift(&mut self, shift: i64) {
        for (time, _) in self.entries.values_mut().flatten() {
            *time = time.saturating_add(shift);
        }
    }

    /// Sorts all positions by time, and adds transforms of the robot's fixed joints, and of those with known positions,
    /// to `frames`. Transforms from the log itself take precedence.
    pub fn add_to(&mut self, frames: &mut Frames, joints: &[JointTransform]) {
        for entries in self.entries.values_mut() {
            entries.sort_by_key(|entry| entry.0);
        }
        for joint in joints {
            let (parent, child) = (&joint.parent, &joint.child);
            if frames.parent(child).is_some() {
                continue;
            }
            if joint.motion == JointMotion::Fixed {
                frames.insert(parent, child, 0, joint.parent_from_child(0.0), true);
            }
            for (time, position) in self.of_joint(joint) {
                frames.insert(
                    parent,
                    child,
                    time,
                    joint.parent_from_child(position),
                    false,
                );
            }
        }
    }

    /// Returns times [ns] and positions [rad or m] of a joint: its own, or computed from the joints that it follows at
    /// their common times.
    fn of_joint(&self, joint: &JointTransform) -> Vec<(i64, f64)> {
        let own = self.entries.get(&joint.joint).filter(|own| !own.is_empty());
        let Some(mimic) = joint.mimic.as_ref().filter(|_| own.is_none()) else {
            return own.cloned().unwrap_or_default();
        };
        let at = |name: &str, time: i64| {
            let entries = self.entries.get(name)?;
            let found = entries.binary_search_by_key(&time, |entry| entry.0).ok()?;
            Some(entries[found].1)
        };
        let first = mimic
            .terms
            .first()
            .and_then(|(name, _)| self.entries.get(name));
        let times = first.into_iter().flatten().map(|entry| entry.0);
        let position = |time: i64| {
            let sum = mimic
                .terms
                .iter()
                .try_fold(mimic.offset, |sum, (name, factor)| {
                    Some(sum + factor * at(name, time)?)
                });
            Some((time, sum?))
        };
        times.filter_map(position).collect()
    }
}

impl<Q: Quantity> Track<Q> {
    /// Creates an empty track; `window` is the largest delay of an entry that is still sorted in [s].
    pub fn new(name: String, window: f64) -> Self {
        Self {
            name,
            frame: String::new(),
            child: String::new(),
            entries: Vec::new(),
            window: (window * NANOSECONDS_PER_SECOND as f64) as i64,
            latest: None,
            late: (0, 0),
            late_run: 0,
            repeated: 0,
            skipped: 0,
            first_skipped: None,
        }
    }

    /// Begins the next part of the log, whose times may overlap with those of earlier parts.
    pub fn begin_part(&mut self) {
        self.latest = None;
        self.late_run = 0;
    }

    /// Adds an entry; `place` names where the log states it. Invalid numbers are dropped and counted.
    ///
    /// # Errors
    /// If the time is earlier than the latest one of the part by more than the window.
    pub fn push(
        &mut self,
        time: i64,
        value: Result<Q, QuantityError>,
        place: impl Fn() -> String,
    ) -> Result<(), ReadFault> {
        let value = match value {
            Ok(value) => value,
            Err(error) => {
                self.skipped += 1;
                self.first_skipped.get_or_insert_with(|| (place(), error));
                return Ok(());
            }
        };
        if let Some(latest) = self.latest.filter(|&latest| time < latest) {
            let lateness = latest.saturating_sub(time);
            if lateness > self.window {
                return Err(ReadFault::Backwards {
                    place: place(),
                    time: seconds(time),
                    last: seconds(latest),
                    limit: seconds(self.window),
                });
            }
            self.late = (self.late.0 + 1, self.late.1.max(lateness));
            self.late_run += 1;
        } else {
            self.latest = Some(time);
            self.late_run = 0;
        }
        self.entries.push((time, value));
        if self.late_run == LATE_RUN && self.repeats_times() {
            return Err(ReadFault::ClockSetBack {
                place: place(),
                time: seconds(self.entries[self.entries.len() - LATE_RUN].0),
                last: self.latest.map_or(0.0, seconds),
            });
        }
        Ok(())
    }

    /// Whether the last entries, which are all late, have about the times of earlier entries with other values: their clock was
    /// set back. Messages that were only delayed have times of their own.
    fn repeats_times(&self) -> bool {
        let (earlier, run) = self.entries.split_at(self.entries.len() - LATE_RUN);
        let [first, last] = [run[0].0, run[LATE_RUN - 1].0];
        if !run.is_sorted_by_key(|entry| entry.0) {
            return false;
        }
        let near = last.saturating_sub(first) / (4 * LATE_RUN as i64);
        let mut others: Vec<i64> = (earlier.iter().rev().take(MOST_EARLIER))
            .take_while(|entry| entry.0 >= first.saturating_sub(near))
            .filter(|entry| !run.contains(entry))
            .map(|entry| entry.0)
            .collect();
        others.sort_unstable();
        let is_repeated = |entry: &&(i64, Q)| {
            let next = others.partition_point(|time| *time < entry.0.saturating_sub(near));
            others
                .get(next)
                .is_some_and(|time| *time <= entry.0.saturating_add(near))
        };
        run.iter().filter(is_repeated).count() >= LEAST_REPEATED
    }

    /// Returns the track sorted by time, or empty. Of entries with the same time, the first is kept.
    ///
    /// # Errors
    /// The fault of the first entry, if no entry is valid.
    pub fn finish(mut self) -> Result<Self, ReadFault> {
        match self.first_skipped {
            Some((place, error)) if self.entries.is_empty() => {
                return Err(ReadFault::Quantity { place, error });
            }
            _ => {}
        }
        if !self.entries.is_sorted_by_key(|entry| entry.0) {
            self.entries.sort_by_key(|entry| entry.0);
        }
        let count = self.entries.len();
        self.entries.dedup_by_key(|entry| entry.0);
        self.repeated += count - self.entries.len();
        Ok(self)
    }

    /// Returns a remark about late entries that were sorted in, if there were any.
    pub fn reordering(&self) -> Option<String> {
        let (count, lateness) = self.late;
        let (verb, limit) = (
            if count == 1 { "was" } else { "were" },
            seconds(self.window),
        );
        (count > 0).then(|| {
            format!(
                "{count} of {} came up to {:.3} s late and {verb} sorted by time (limit {limit} s)",
                self.name,
                seconds(lateness)
            )
        })
    }

    /// First and last time [s]; 0 for an empty track.
    fn times(&self) -> [f64; 2] {
        [self.entries.first(), self.entries.last()]
            .map(|entry| entry.map_or(0.0, |&(time, _)| seconds(time)))
    }
}

/// Converts nanoseconds to seconds.
pub(crate) fn seconds(time: i64) -> f64 {
    time as f64 / NANOSECONDS_PER_SECOND as f64
}

/// Pairs poses and forces at the times of the more frequent one, with the other interpolated linearly in time.
///
/// # Errors
/// If both are known at no time.
pub(crate) fn pair<P: Quantity, W: Quantity>(
    poses: &Track<P>,
    wrenches: &Track<W>,
    max_gap: f64,
    at_wrenches: bool,
) -> Result<Vec<(i64, P, W)>, ReadFault> {
    let pairs: Vec<_> = if !at_wrenches && poses.entries.len() >= wrenches.entries.len() {
        at_times_of(&poses.entries, &wrenches.entries, max_gap).collect()
    } else {
        at_times_of(&wrenches.entries, &poses.entries, max_gap)
            .map(|(time, wrench, pose)| (time, pose, wrench))
            .collect()
    };
    if pairs.is_empty() {
        return Err(ReadFault::Apart {
            pose: poses.name.clone(),
            pose_times: poses.times(),
            wrench: wrenches.name.clone(),
            wrench_times: wrenches.times(),
            limit: max_gap,
        });
    }
    if let ([(time, ..)], repeated @ 1..) = (&pairs[..], poses.repeated) {
        return Err(ReadFault::SameTime {
            count: 1 + repeated,
            time: seconds(*time),
        });
    }
    Ok(pairs)
}

/// Returns the entries of one track with the other's interpolated value, where that is known.
fn at_times_of<A: Quantity, B: Quantity>(
    frequent: &[(i64, A)],
    rare: &[(i64, B)],
    max_gap: f64,
) -> impl Iterator<Item = (i64, A, B)> {
    let mut after = 0;
    frequent.iter().filter_map(move |&(time, value)| {
        while rare.get(after).is_some_and(|&(other, _)| other < time) {
            after += 1;
        }
        let (end, at_end) = rare.get(after)?;
        if *end == time {
            return Some((time, value, *at_end));
        }
        let (start, at_start) = rare.get(after.checked_sub(1)?)?;
        let gap = end.abs_diff(*start) as f64;
        // Share of the interval [start, end] at `time`, for the interpolation between both values.
        let share = time.abs_diff(*start) as f64 / gap;
        let is_near = gap / NANOSECONDS_PER_SECOND as f64 <= max_gap;
        is_near.then(|| (time, value, at_start.between(at_end, share)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn track<Q: Quantity>(name: &str, entries: impl IntoIterator<Item = (i64, Q)>) -> Track<Q> {
        let mut track = Track::new(name.to_owned(), 1.0);
        for (time, value) in entries {
            track.push(time, Ok(value), || name.to_owned()).unwrap();
        }
        track.finish().unwrap()
    }

    fn forces(times: impl IntoIterator<Item = i64>) -> Track<Vector3> {
        track(
            "/force",
            times.into_iter().map(|t| (t, Vector3::x() * t as f64)),
        )
    }

    fn poses(times: impl IntoIterator<Item = i64>) -> Track<Pose> {
        track(
            "/pose",
            times
                .into_iter()
                .map(|t| (t, Pose::translation(t as f64, 0.0, 0.0))),
        )
    }

    #[test]
    fn a_gap_in_the_rarer_track_leaves_a_gap() {
        let pairs = pair(&poses(0..=10), &forces([0, 4, 9]), 4.5e-9, false).unwrap();
        let times: Vec<i64> = pairs.iter().map(|(time, ..)| *time).collect();
        assert_eq!(
            times,
            [0, 1, 2, 3, 4, 9],
            "the gap from 4 to 9 exceeds the limit"
        );
    }

    #[test]
    fn tracks_without_overlap_are_refused_with_both_intervals() {
        let second = NANOSECONDS_PER_SECOND as i64;
        let refused = pair(
            &poses([0, second]),
            &forces([2 * second, 3 * second]),
            0.1,
            false,
        );
        assert_eq!(
            refused.unwrap_err().to_string(),
            "/pose covers 0.000 to 1.000 s and /force 2.000 to 3.000 s: they do not overlap within the limit of 0.1 s"
        );
        assert!(pair(&poses([]), &forces([]), 0.1, false).is_err());
    }

    #[test]
    fn a_clock_that_is_set_back_is_no_delay() {
        let step = NANOSECONDS_PER_SECOND as i64 / 100;
        let push = |track: &mut Track<Vector3>, time: i64, value: f64| {
            track.push(time * step, Ok(Vector3::x() * value), || {
                format!("line {time}")
            })
        };
        let window = 5.0;
        let mut track = Track::new("/force".to_owned(), window);
        (0..200).for_each(|k| push(&mut track, k, k as f64).unwrap());
        let again: Result<(), ReadFault> = (100..200).try_for_each(|k| push(&mut track, k, -1.0));
        let text = again.unwrap_err().to_string();
        assert!(
            text.starts_with("line 109: the clock was set back from 1.99 s to 1 s"),
            "{text}"
        );
        let mut sent_twice = Track::new("/force".to_owned(), window);
        (0..200).for_each(|k| push(&mut sent_twice, k, k as f64).unwrap());
        (100..200).for_each(|k| push(&mut sent_twice, k, k as f64).unwrap());
        let mut delayed = Track::new("/force".to_owned(), window);
        (0..100)
            .chain(150..200)
            .for_each(|k| push(&mut delayed, k, k as f64).unwrap());
        (100..150).for_each(|k| push(&mut delayed, k, k as f64).unwrap());
        assert_eq!(delayed.finish().unwrap().entries.len(), 200);
        // Every second entry comes late, in bursts.
        let mut two_ways = Track::new("/force".to_owned(), window);
        for burst in 0..5 {
            let times = |odd: i64| (0..20).map(move |k| 40 * burst + 2 * k + odd);
            (times(0).chain(times(1))).for_each(|k| push(&mut two_ways, k, k as f64).unwrap());
        }
        assert_eq!(two_ways.finish().unwrap().entries.len(), 200);
    }

    #[test]
    fn late_entries_are_sorted_within_a_window() {
        let second = NANOSECONDS_PER_SECOND as i64;
        let mut track = forces([]);
        let push = |track: &mut Track<Vector3>, time: i64| {
            let value = Ok(Vector3::x() * time as f64);
            track.push(time, value, || "message 4".to_owned())
        };
        for time in [5, 9, 7, 9] {
            push(&mut track, time).unwrap();
        }
        let back = push(&mut track, -second).unwrap_err().to_string();
        assert!(
            back.starts_with("message 4: its time of -1 s is 1.000000009 s earlier"),
            "{back}"
        );
        // Another file may begin before the end of the previous file.
        track.begin_part();
        push(&mut track, -second).unwrap();
        let track = track.finish().unwrap();
        let times: Vec<i64> = track.entries.iter().map(|entry| entry.0).collect();
        assert_eq!((times, track.repeated), (vec![-second, 5, 7, 9], 1));
        assert_eq!(
            track.reordering().unwrap(),
            "1 of /force came up to 0.000 s late and was sorted by time (limit 1 s)"
        );
    }

    proptest! {
        /// Linear motion is interpolated exactly, with either track as the more frequent one.
        #[test]
        fn linear_motion_is_interpolated_exactly(times in prop::collection::btree_set(0_i64..1000, 2..40), step in 1_i64..50) {
            let regular = (0..=1000 / step).map(|k| k * step);
            let pairs = pair(&poses(times), &forces(regular), 1.0, false);
            for (time, pose, force) in pairs.into_iter().flatten() {
                prop_assert!((pose.translation.x - time as f64).abs() < 1e-9);
                prop_assert!((force.x - time as f64).abs() < 1e-9);
            }
        }
    }
}
