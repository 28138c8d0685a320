//! Poses or forces over time, and the two of them together.

use super::error::ReadFault;
use super::frames::Frames;
use super::quantity::{Quantity, QuantityError};
use super::ros2::NANOSECONDS_PER_SECOND;
use std::collections::BTreeMap;
use wisch::geometry::{Pose, Vector3};
use wisch::represent::Observation;
use wisch::robot::{JointMotion, JointTransform};

/// What a log says of one quantity, in the order of time.
#[derive(Debug, Clone)]
pub(crate) struct Track<Q> {
    /// Where it comes from, as messages call it.
    pub name: String,
    /// The frame that it is said to be in; empty where nothing is said.
    pub frame: String,
    /// The frame whose pose it is; empty where nothing is said.
    pub child: String,
    /// Times [ns], each later than the one before, and values.
    pub entries: Vec<(i64, Q)>,
    /// How many entries were left out, as they bore the time of the one before.
    pub repeated: usize,
    /// How many entries were left out, as they are no such quantity.
    pub skipped: usize,
    /// The first of these.
    pub first_skipped: Option<(String, QuantityError)>,
}

/// What a file says, before it is understood.
pub(crate) struct RawLog {
    pub poses: Track<Pose>,
    pub wrenches: Track<Vector3>,
    pub axes: Option<String>,
    pub start: Option<i64>,
    pub unfinished: bool,
    /// Which frame is where in which other.
    pub frames: Frames,
    /// Where the robot's joints were.
    pub joints: JointPositions,
    /// The name of the task that was executed, where the writer says it.
    pub task: Option<String>,
    /// Which round of its run was executed, where the writer says it.
    pub round: Option<usize>,
    /// What was seen of the dirt before and after.
    pub looks: [Option<Observation>; 2],
    /// A table's line of units, and what it means by columns that are read.
    pub units: Option<UnitsLine>,
}

/// Where joints were, by name.
#[derive(Debug, Clone, Default)]
pub(crate) struct JointPositions {
    /// Times [ns] and positions [rad or m] of those that are looked for.
    entries: BTreeMap<String, Vec<(i64, f64)>>,
}

impl JointPositions {
    /// Nothing yet, of what says where the links of moving joints are.
    pub fn of(joints: &[JointTransform]) -> Self {
        let moving = (joints.iter()).filter(|joint| joint.motion != JointMotion::Fixed);
        let names = moving.flat_map(|joint| {
            let others = joint.mimic.iter().flat_map(|mimic| &mimic.terms);
            std::iter::once(&joint.joint).chain(others.map(|(name, _)| name))
        });
        Self {
            entries: names.map(|name| (name.clone(), Vec::new())).collect(),
        }
    }

    /// Whether none is looked for.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Whether the log tells the position of any.
    pub fn are_known(&self) -> bool {
        self.entries.values().any(|entries| !entries.is_empty())
    }

    /// Takes a position in, if it is looked for.
    pub fn push(&mut self, name: &str, time: i64, position: f64) {
        if let Some(entries) = self.entries.get_mut(name) {
            entries.push((time, position));
        }
    }

    /// Puts everything into the order of time.
    pub fn sort(&mut self) {
        for entries in self.entries.values_mut() {
            entries.sort_by_key(|entry| entry.0);
        }
    }

    /// Times [ns] and positions [rad or m] of a joint: its own, or by those that it follows at the times of all of them.
    pub fn of_joint(&self, joint: &JointTransform) -> Vec<(i64, f64)> {
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

/// A line of units in a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitsLine {
    /// The units of the columns that are read, in our order, each with our name of the column.
    pub units: Vec<(String, String)>,
    /// Those that are not known, which are taken for SI units.
    pub unknown: Vec<(String, String)>,
}

impl<Q: Quantity> Track<Q> {
    /// Nothing yet.
    pub fn new(name: String) -> Self {
        Self {
            name,
            frame: String::new(),
            child: String::new(),
            entries: Vec::new(),
            repeated: 0,
            skipped: 0,
            first_skipped: None,
        }
    }

    /// Adds what the log says next; `place` tells where it says so. What is no such quantity is left out and counted.
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
        match self.entries.last() {
            Some(&(last, _)) if time < last => Err(ReadFault::Backwards {
                place: place(),
                time: seconds(time),
                last: seconds(last),
            }),
            Some(&(last, _)) if time == last => {
                self.repeated += 1;
                Ok(())
            }
            _ => {
                self.entries.push((time, value));
                Ok(())
            }
        }
    }

    /// The same track if there is anything in it.
    ///
    /// # Errors
    /// What the first entry is instead, if none is such a quantity.
    pub fn filled(self) -> Result<Self, ReadFault> {
        match self.first_skipped {
            Some((place, error)) if self.entries.is_empty() => {
                Err(ReadFault::Quantity { place, error })
            }
            _ => Ok(self),
        }
    }

    /// Whether it says different things at different times.
    pub fn changes(&self) -> bool {
        self.entries.windows(2).any(|pair| pair[0].1 != pair[1].1)
    }

    /// First and last time [s]; 0 where there is none.
    fn times(&self) -> [f64; 2] {
        [self.entries.first(), self.entries.last()]
            .map(|entry| entry.map_or(0.0, |&(time, _)| seconds(time)))
    }
}

/// Seconds of nanoseconds.
pub(crate) fn seconds(time: i64) -> f64 {
    time as f64 / NANOSECONDS_PER_SECOND as f64
}

/// Both quantities at the times of the one that is told more often, the other in between two of its own times.
///
/// # Errors
/// No time at which both are known.
pub(crate) fn paired<P: Quantity, W: Quantity>(
    poses: &Track<P>,
    wrenches: &Track<W>,
    max_gap: f64,
) -> Result<Vec<(i64, P, W)>, ReadFault> {
    let pairs: Vec<_> = if poses.entries.len() >= wrenches.entries.len() {
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
    Ok(pairs)
}

/// The entries of one track with the other's value at their times, where that is known.
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
        let mut track = Track::new(name.to_owned());
        for (time, value) in entries {
            track.push(time, Ok(value), || name.to_owned()).unwrap();
        }
        track
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
    fn a_gap_in_the_rarer_one_leaves_a_gap() {
        let pairs = paired(&poses(0..=10), &forces([0, 4, 9]), 4.5e-9).unwrap();
        let times: Vec<i64> = pairs.iter().map(|(time, ..)| *time).collect();
        assert_eq!(times, [0, 1, 2, 3, 4, 9], "between 4 and 9 lies too much");
    }

    #[test]
    fn what_is_never_there_at_the_same_time_is_refused_with_both_times() {
        let second = NANOSECONDS_PER_SECOND as i64;
        let refused = paired(&poses([0, second]), &forces([2 * second, 3 * second]), 0.1);
        assert_eq!(
            refused.unwrap_err().to_string(),
            "/pose covers 0.000 to 1.000 s and /force 2.000 to 3.000 s: at no time are there both, at most 0.1 s apart"
        );
        assert!(paired(&poses([]), &forces([]), 0.1).is_err());
    }

    #[test]
    fn time_may_stand_still_but_not_go_back() {
        let mut track = forces([5, 7]);
        track
            .push(7, Ok(Vector3::zeros()), || "here".to_owned())
            .unwrap();
        assert_eq!((track.entries.len(), track.repeated), (2, 1));
        let back = track.push(6, Ok(Vector3::zeros()), || "message 4".to_owned());
        let shown = back.unwrap_err().to_string();
        assert!(
            shown.starts_with("message 4: its time of 0.000000006 s is before"),
            "{shown}"
        );
    }

    proptest! {
        /// What is linear in time is met exactly, whichever of the two is told more often.
        #[test]
        fn linear_motion_is_kept(times in prop::collection::btree_set(0_i64..1000, 2..40), step in 1_i64..50) {
            let regular = (0..=1000 / step).map(|k| k * step);
            let pairs = paired(&poses(times), &forces(regular), 1.0);
            for (time, pose, force) in pairs.into_iter().flatten() {
                prop_assert!((pose.translation.x - time as f64).abs() < 1e-9);
                prop_assert!((force.x - time as f64).abs() < 1e-9);
            }
        }
    }
}
