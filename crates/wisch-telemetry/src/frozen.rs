//! Forces and poses that stay the same for long, because their sensor or its driver has stopped.

use std::collections::BTreeMap;
use wisch::geometry::{Pose, Vector3};

/// Longest time for which a working sensor repeats a force other than zero \[ns\], and zero, if it does so once: a sensor with
/// a dead band returns zero while it rests.
const LONGEST_REPEAT: i64 = 500_000_000;
const LONGEST_ZERO: i64 = 2_000_000_000;
/// Least number of equal forces in this time.
const LEAST_REPEATS: usize = 10;
/// Least share of the other forces that differ from the one before: a log without noise shows no stopped sensor \[1\].
const LEAST_CHANGES: f64 = 0.8;
/// Least share of the log that they have \[1\].
const LEAST_OTHERS: f64 = 0.3;
/// Longest time for which a pose repeats exactly while the force changes \[ns\], time over which forces are averaged \[ns\],
/// and least change of these means, as a share of that over the whole log \[1\].
const LONGEST_STILL: i64 = 1_000_000_000;
const AVERAGED: i64 = 250_000_000;
const LEAST_FORCE_CHANGE: f64 = 0.3;

/// Returns the intervals in which the pose repeats exactly although the force changes \[ns\], from the first repetition to the
/// last: whoever sends the poses has stopped. The pose of a robot at rest may repeat, but then its force stays the same.
pub(crate) fn find_frozen_poses(poses: &[(i64, Pose)], forces: &[(i64, Vector3)]) -> Vec<[i64; 2]> {
    let all = force_change(forces);
    (poses.chunk_by(|a, b| a.1 == b.1))
        .filter(|run| run.len() > LEAST_REPEATS && run[run.len() - 1].0 - run[0].0 > LONGEST_STILL)
        .map(|run| [run[1].0, run[run.len() - 1].0])
        .filter(|[from, to]| {
            let first = forces.partition_point(|(time, _)| time < from);
            let last = forces.partition_point(|(time, _)| time <= to);
            all > 0.0 && force_change(&forces[first..last]) > LEAST_FORCE_CHANGE * all
        })
        .collect()
}

/// Size of the range of the forces, averaged over short times.
fn force_change(forces: &[(i64, Vector3)]) -> f64 {
    let means = forces.chunk_by(|a, b| a.0.div_euclid(AVERAGED) == b.0.div_euclid(AVERAGED));
    let means = means.map(|part| {
        let sum: Vector3 = part.iter().map(|(_, force)| force).sum();
        sum / part.len() as f64
    });
    let range = means.fold(None, |range: Option<[Vector3; 2]>, mean| match range {
        None => Some([mean, mean]),
        Some([low, high]) => Some([low.inf(&mean), high.sup(&mean)]),
    });
    range.map_or(0.0, |[low, high]| (high - low).norm())
}

/// Returns the intervals in which a force repeats for longer than a working sensor repeats it \[ns\], from the first
/// repetition to the last; none for a log whose forces have no noise.
///
/// A sensor that stops has worked before, and stops at a value of its noise or at zero. A force that the log begins with, or to
/// which it returns, is that of a quiet sensor with a coarse resolution or a dead band.
pub(crate) fn find_frozen(entries: &[(i64, Vector3)]) -> Vec<[i64; 2]> {
    // A sum with zero has no negative zero.
    let bits = |force: &Vector3| [force.x, force.y, force.z].map(|part| (part + 0.0).to_bits());
    let mut returns: BTreeMap<[u64; 3], usize> = BTreeMap::new();
    for run in entries
        .chunk_by(|a, b| a.1 == b.1)
        .filter(|run| run.len() > 1)
    {
        *returns.entry(bits(&run[0].1)).or_default() += 1;
    }
    let mut frozen = Vec::new();
    let (mut changes, mut others, mut zeros) = (0_usize, 0_usize, 0_usize);
    let mut is_first = true;
    for run in entries.chunk_by(|a, b| a.1 == b.1) {
        let [first, last] = [run[0].0, run[run.len() - 1].0];
        let is_zero = run[0].1 == Vector3::zeros();
        let longest = if is_zero {
            LONGEST_ZERO
        } else {
            LONGEST_REPEAT
        };
        let is_long = last - first > LONGEST_REPEAT && run.len() > LEAST_REPEATS;
        let is_sole = returns.get(&bits(&run[0].1)) == Some(&1);
        if is_long && !is_first && is_sole && last - first > longest {
            frozen.push([run[1].0, last]);
            if is_zero {
                zeros += run.len();
            }
        } else if !is_long {
            changes += 1;
            others += run.len();
        }
        is_first = false;
    }
    // A sensor may fail early in a log.
    let all = entries.len() - zeros;
    let [changes, others, all] = [changes, others, all].map(|count| count as f64);
    if changes < LEAST_CHANGES * others || others < LEAST_OTHERS * all {
        frozen.clear();
    }
    frozen
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Forces at 100 Hz: in turn noise and the same force, for these numbers of samples.
    fn forces(counts: &[usize], noise: f64) -> Vec<(i64, Vector3)> {
        let mut all: Vec<(i64, Vector3)> = Vec::new();
        for (part, &count) in counts.iter().enumerate() {
            for k in 0..count {
                let wobble = if part % 2 == 0 {
                    noise * (k as f64).sin()
                } else {
                    0.5
                };
                all.push((
                    all.len() as i64 * 10_000_000,
                    Vector3::new(0.0, wobble, 9.0),
                ));
            }
        }
        all
    }

    #[test]
    fn a_force_that_repeats_between_noise_is_frozen_from_its_first_repetition() {
        let expected = [[3_010_000_000, 3_990_000_000]];
        assert_eq!(find_frozen(&forces(&[300, 100, 200], 1.0)), expected);
        assert!(
            find_frozen(&forces(&[300, 40, 200], 1.0)).is_empty(),
            "too short"
        );
        assert!(
            find_frozen(&forces(&[300, 100, 200], 0.0)).is_empty(),
            "without noise"
        );
        let begins = forces(&[0, 100, 500], 1.0);
        assert!(
            find_frozen(&begins).is_empty(),
            "before the sensor has worked"
        );
        let returns = forces(&[300, 100, 100, 100, 100], 1.0);
        assert!(find_frozen(&returns).is_empty(), "a coarse resolution");
        let mut rests = forces(&[300, 100, 200], 1.0);
        for (_, force) in &mut rests[300..400] {
            *force = Vector3::zeros();
        }
        assert!(find_frozen(&rests).is_empty(), "a dead band around zero");
    }

    #[test]
    fn a_pose_that_repeats_while_the_force_changes_is_frozen() {
        // Ten seconds at 100 Hz: the pose moves for 4 s, then repeats; the tool presses in every other second.
        let poses: Vec<(i64, Pose)> = (0..1000)
            .map(|k: i64| {
                (
                    k * 10_000_000,
                    Pose::translation(k.min(400) as f64 * 1e-3, 0.0, 0.0),
                )
            })
            .collect();
        let pressing = |until: i64| -> Vec<(i64, Vector3)> {
            let force = |k: i64| {
                if k < until && k / 100 % 2 == 1 {
                    10.0
                } else {
                    0.0
                }
            };
            (0..1000)
                .map(|k| (k * 10_000_000, Vector3::new(0.0, 0.0, force(k))))
                .collect()
        };
        let repeats = vec![[4_010_000_000, 9_990_000_000]];
        assert_eq!(find_frozen_poses(&poses, &pressing(1000)), repeats);
        let rests = find_frozen_poses(&poses, &pressing(400));
        assert!(rests.is_empty(), "a robot that rests in the air: {rests:?}");
        assert!(find_frozen_poses(&poses[..450], &pressing(1000)).is_empty());
    }

    #[test]
    fn a_force_that_stays_zero_for_long_after_noise_is_frozen() {
        let mut dies = forces(&[300, 1000], 1.0);
        for (_, force) in &mut dies[300..] {
            *force = Vector3::zeros();
        }
        assert_eq!(find_frozen(&dies), [[3_010_000_000, 12_990_000_000]]);
        let mut rests = forces(&[300, 400, 200, 400, 200], 1.0);
        for (_, force) in rests[300..700].iter_mut() {
            *force = Vector3::zeros();
        }
        for (_, force) in rests[900..1300].iter_mut() {
            *force = Vector3::zeros();
        }
        assert!(find_frozen(&rests).is_empty(), "a dead band around zero");
    }
}
