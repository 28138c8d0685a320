//! Forces and poses that do not change for a long time, because their sensor or its driver has
//! stopped.

use super::ros2::NANOSECONDS_PER_SECOND;
use std::collections::BTreeMap;
use wisch::geometry::{Pose, Vector3};

/// Longest time for which a working sensor repeats a force \[ns\]: a force other than zero; and
/// zero, if the sensor repeats it only once. A sensor with a dead band returns zero while it is
/// unloaded.
const LONGEST_REPEAT: i64 = 500_000_000;
const LONGEST_ZERO: i64 = 2_000_000_000;
/// Least number of equal forces in this time.
const LEAST_REPEATS: usize = 10;
/// Least share of the remaining forces that differ from the previous force \[1\]: in a log without
/// noise, a stopped sensor cannot be detected.
const LEAST_CHANGES: f64 = 0.8;
/// Least share of the remaining forces in the log \[1\].
const LEAST_OTHERS: f64 = 0.3;
/// Least number of forces outside of long repetitions, and least share of them that differ from the one before \[1\], of a
/// sensor with noise.
const NOISY: (usize, f64) = (100, 0.98);
/// Least number of measurements that are held, least median number of entries of each, share of the median by which this
/// number may differ, and least share of the measurements for which it does not differ more \[1\].
const LEAST_HELD: usize = 10;
const LEAST_LENGTH: usize = 4;
const HELD_SPREAD: f64 = 0.2;
const MOSTLY_HELD: f64 = 0.8;
/// Least period of such measurements \[ns\].
const LEAST_PERIOD: i64 = 50_000_000;
/// Longest time for which a pose repeats exactly while the force changes \[ns\]; least distance
/// \[m\] and angle \[rad\] between this pose and the next one.
const LONGEST_STILL: i64 = 1_000_000_000;
const ELSEWHERE: [f64; 2] = [5e-3, 0.05];
/// Least number of forces that are averaged. And the least change of their means: in standard
/// errors, and as a share of the change over the whole log, for a pose that continues at another
/// place and for a pose that repeats until the end \[1\].
const AVERAGED: usize = 10;
const LEAST_ERRORS: f64 = 8.0;
const LEAST_FORCE_CHANGE: [f64; 2] = [0.3, 0.6];

/// Returns the intervals in which the pose repeats exactly although the force changes \[ns\], from the first repetition to the
/// last: their source has stopped.
///
/// The pose of a robot at rest may repeat as well. But such a robot continues from the pose at
/// which it rested, and the force on a resting tool changes little.
pub(crate) fn find_frozen_poses(poses: &[(i64, Pose)], forces: &[(i64, Vector3)]) -> Vec<[i64; 2]> {
    let error = LEAST_ERRORS * standard_error(forces);
    let all = force_change(forces);
    let mut frozen = Vec::new();
    let mut first = 0;
    for run in poses.chunk_by(|a, b| a.1 == b.1) {
        let next = poses.get(first + run.len());
        first += run.len();
        let last = run[run.len() - 1].0;
        if run.len() <= LEAST_REPEATS || last.saturating_sub(run[0].0) <= LONGEST_STILL {
            continue;
        }
        let share = match next {
            Some((_, next)) if is_elsewhere(&run[0].1, next) => LEAST_FORCE_CHANGE[0],
            Some(_) => continue,
            None => LEAST_FORCE_CHANGE[1],
        };
        let from = forces.partition_point(|(time, _)| *time < run[1].0);
        let to = forces.partition_point(|(time, _)| *time <= last);
        let change = force_change(&forces[from..to]);
        if change > error && change > share * all {
            frozen.push([run[1].0, last]);
        }
    }
    frozen
}

/// Whether forces without a pose change as much as if the tool touched the surface meanwhile. `all`: all forces of the log.
pub(crate) fn shows_contact(alone: &[(i64, Vector3)], all: &[(i64, Vector3)]) -> bool {
    let change = force_change(alone);
    change > LEAST_ERRORS * standard_error(all)
        && change > LEAST_FORCE_CHANGE[1] * force_change(all)
}

fn is_elsewhere(before: &Pose, after: &Pose) -> bool {
    let distance = (after.translation.vector - before.translation.vector).norm();
    distance > ELSEWHERE[0] || before.rotation.angle_to(&after.rotation) > ELSEWHERE[1]
}

/// Standard error of the mean of [`AVERAGED`] forces.
fn standard_error(forces: &[(i64, Vector3)]) -> f64 {
    let mut steps: Vec<f64> = (forces.windows(2))
        .map(|pair| (pair[1].1 - pair[0].1).norm())
        .collect();
    steps.sort_unstable_by(f64::total_cmp);
    // The median distance of two normal vectors is 2.175 standard deviations of a component.
    let noise = steps.get(steps.len() / 2).copied().unwrap_or(0.0) / 2.175;
    noise / (AVERAGED as f64).sqrt()
}

/// Size of the range of the forces, averaged over a few.
fn force_change(forces: &[(i64, Vector3)]) -> f64 {
    let means = forces.chunks_exact(AVERAGED).map(|part| {
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
/// A sensor that stops has worked before, and stops at a value of its noise or at zero. A force
/// with which the log begins, or to which it returns, is that of an unloaded sensor with a coarse
/// resolution or a dead band; unless all other forces differ by noise.
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
    let (mut changes, mut others, mut excluded) = (0_usize, 0_usize, 0_usize);
    let mut is_first = true;
    let end = entries.last().map(|(time, _)| *time);
    let is_noisy = is_noisy(entries);
    for run in entries.chunk_by(|a, b| a.1 == b.1) {
        let [first, last] = [run[0].0, run[run.len() - 1].0];
        let is_zero = run[0].1 == Vector3::zeros();
        let longest = if is_zero {
            LONGEST_ZERO
        } else {
            LONGEST_REPEAT
        };
        let lasts = last.saturating_sub(first);
        let is_long = lasts > LONGEST_REPEAT && run.len() > LEAST_REPEATS;
        let is_sole = returns.get(&bits(&run[0].1)) == Some(&1);
        let has_stopped = is_noisy && Some(last) == end;
        let had_not_begun = is_noisy && !is_zero;
        if is_long && (!is_first || had_not_begun) && is_sole && lasts > longest {
            frozen.push([run[1].0, last]);
            if is_zero || has_stopped || is_first {
                excluded += run.len();
            }
        } else if !is_long {
            changes += 1;
            others += run.len();
        }
        is_first = false;
    }
    // A sensor may fail early in a log, or start late.
    let all = entries.len() - excluded;
    let [changes, others, all] = [changes, others, all].map(|count| count as f64);
    if changes < LEAST_CHANGES * others || others < LEAST_OTHERS * all {
        frozen.clear();
    }
    frozen
}

/// Whether there are many forces outside of long repetitions, and hardly any equals the one before.
fn is_noisy(entries: &[(i64, Vector3)]) -> bool {
    let is_short = |run: &&[(i64, Vector3)]| {
        run.len() <= LEAST_REPEATS
            || run[run.len() - 1].0.saturating_sub(run[0].0) <= LONGEST_REPEAT
    };
    let runs = entries.chunk_by(|a, b| a.1 == b.1).filter(is_short);
    let (changes, others) = runs.fold((0, 0), |(changes, others), run| {
        (changes + 1, others + run.len())
    });
    others >= NOISY.0 && changes as f64 >= NOISY.1 * others as f64
}

/// Returns the forces without the repetitions by a writer that holds each measurement until the next one, with the period of
/// the measurements \[s\]; `None` if the forces are not held.
pub(crate) fn find_held_forces(entries: &[(i64, Vector3)]) -> Option<(Vec<(i64, Vector3)>, f64)> {
    let runs: Vec<&[(i64, Vector3)]> = entries.chunk_by(|a, b| a.1 == b.1).collect();
    let [_, inner @ .., _] = &runs[..] else {
        return None;
    };
    let mut lengths: Vec<usize> = inner.iter().map(|run| run.len()).collect();
    lengths.sort_unstable();
    let median = *lengths.get(lengths.len() / 2)?;
    let allowed = (median as f64 * HELD_SPREAD).max(1.0);
    let is_regular = |length: &&usize| (**length as f64 - median as f64).abs() <= allowed;
    let regular = lengths.iter().filter(is_regular).count() as f64;
    if inner.len() < LEAST_HELD
        || median < LEAST_LENGTH
        || regular < MOSTLY_HELD * inner.len() as f64
    {
        return None;
    }
    let mut steps: Vec<i64> = (runs.windows(2))
        .map(|pair| pair[1][0].0.saturating_sub(pair[0][0].0))
        .collect();
    steps.sort_unstable();
    let period = steps[steps.len() / 2];
    if period < LEAST_PERIOD {
        return None;
    }
    let measured = runs.iter().map(|run| run[0]).collect();
    Some((measured, period as f64 / NANOSECONDS_PER_SECOND as f64))
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
        let begins = forces(&[0, 100, 500], 0.0);
        assert!(find_frozen(&begins).is_empty(), "without noise, at first");
        let late = forces(&[0, 900, 500], 1.0);
        assert_eq!(find_frozen(&late), [[10_000_000, 8_990_000_000]]);
        let early = forces(&[300, 1700], 1.0);
        assert_eq!(find_frozen(&early), [[3_010_000_000, 19_990_000_000]]);
        let returns = forces(&[300, 100, 100, 100, 100], 1.0);
        assert!(find_frozen(&returns).is_empty(), "a coarse resolution");
        let mut rests = forces(&[300, 100, 200], 1.0);
        for (_, force) in &mut rests[300..400] {
            *force = Vector3::zeros();
        }
        assert!(find_frozen(&rests).is_empty(), "a dead band around zero");
    }

    /// Poses and forces with their times.
    type Tracks = (Vec<(i64, Pose)>, Vec<(i64, Vector3)>);

    /// Returns 20 s of poses and forces at 100 Hz, with noise of the force. The pose moves at 0.1 m/s, rests from 4 to 14 s, and
    /// jumps by `jump` afterwards. In the seconds of its rest, the tool presses with the forces `press` in turn.
    fn rest(jump: f64, press: [f64; 2]) -> Tracks {
        let poses = (0..2000_i64).map(|k| {
            let moved = k.min(400) + (k - 1400).max(0);
            let place = moved as f64 * 1e-3 + if k > 1400 { jump } else { 0.0 };
            (k * 10_000_000, Pose::translation(place, 0.0, 0.0))
        });
        let forces = (0..2000_i64).map(|k| {
            let second = k / 100;
            let pressed = match second {
                4..14 => press[usize::from(second % 2 == 1)],
                _ => 10.0 * f64::from(second % 2 == 1),
            };
            let noise = ((k * 7919 % 1000) as f64 / 500.0 - 1.0) * 0.5;
            (k * 10_000_000, Vector3::new(noise, 0.0, pressed - noise))
        });
        (poses.collect(), forces.collect())
    }

    #[test]
    fn a_pose_that_repeats_while_the_force_changes_is_frozen() {
        let frozen = |(poses, forces): Tracks| find_frozen_poses(&poses, &forces);
        assert_eq!(
            frozen(rest(0.1, [0.0, 10.0])),
            [[4_010_000_000, 14_000_000_000]]
        );
        let nothing: [[i64; 2]; 0] = [];
        assert_eq!(
            frozen(rest(0.1, [0.0, 0.0])),
            nothing,
            "moved by hand in the air"
        );
        assert_eq!(
            frozen(rest(0.0, [10.0, 5.0])),
            nothing,
            "a stop that relaxes"
        );
        let (poses, forces) = rest(0.1, [0.0, 10.0]);
        let ends = find_frozen_poses(&poses[..1400], &forces[..1400]);
        assert_eq!(ends, [[4_010_000_000, 13_990_000_000]]);
        let (poses, forces) = rest(0.1, [0.0, 0.0]);
        assert_eq!(find_frozen_poses(&poses[..1400], &forces[..1400]), nothing);
    }

    #[test]
    fn forces_that_a_writer_holds_count_once() {
        let noisy = forces(&[2000], 1.0);
        assert_eq!(find_held_forces(&noisy), None);
        let held = |every: usize| -> Vec<(i64, Vector3)> {
            (0..noisy.len())
                .map(|k| (noisy[k].0, noisy[k / every * every].1))
                .collect()
        };
        for every in [10, 25, 100] {
            let (measured, period) = find_held_forces(&held(every)).unwrap();
            assert_eq!(measured.len(), noisy.len() / every);
            assert!((period - every as f64 / 100.0).abs() < 1e-9, "{period}");
        }
        assert_eq!(find_held_forces(&held(2)), None, "20 ms are no long time");
        // A sensor of coarse resolution repeats its values for other times.
        let coarse = noisy
            .iter()
            .map(|(time, force)| (*time, force.map(f64::round)));
        assert_eq!(find_held_forces(&coarse.collect::<Vec<_>>()), None);
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
