//! Forces that stay the same for long, because their sensor or its driver has stopped.

use std::collections::BTreeMap;
use wisch::geometry::Vector3;

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
