//! Scores of the detection of pushes by people.

use serde::{Deserialize, Serialize};
use std::iter::Sum;
use std::ops::Add;

/// Touches that are less than this time apart count as one push [s], as in the interpreter.
const GAP: f64 = 0.35;
/// Maximum time between a true and a detected start or end [s].
const TOLERANCE: f64 = 0.05;

/// True and detected pushes of one or more rounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct PushCounts {
    /// Rounds.
    pub rounds: usize,
    /// Rounds without a push.
    pub undisturbed: usize,
    /// Pushes that ended before the end of their round.
    pub pushes: usize,
    /// Detected pushes.
    pub found: usize,
    /// Detected pushes whose detected start is within 50 ms.
    pub starts: usize,
    /// Detected pushes whose detected end is within 50 ms.
    pub ends: usize,
    /// Detections in rounds without a push, when robot or tool touched an object of the scene.
    #[serde(default)]
    pub obstructed: usize,
    /// False detections: in rounds without a push and without such a touch.
    #[serde(rename = "invented")]
    pub false_detections: usize,
}

impl PushCounts {
    /// Counts the pushes of a round. All intervals are start and end since the round began \[s\].
    ///
    /// - `duration`: duration of the round \[s\].
    /// - `touches`: intervals during which a hand touched the tool.
    /// - `obstructions`: intervals during which robot or tool touched an object of the scene.
    /// - `detected`: detected pushes.
    pub fn count(
        duration: f64,
        touches: &[[f64; 2]],
        obstructions: &[[f64; 2]],
        detected: &[[f64; 2]],
    ) -> Self {
        let mut pushes: Vec<[f64; 2]> = Vec::new();
        for &[start, end] in touches {
            match pushes.last_mut() {
                Some(before) if start <= before[1] + GAP => before[1] = before[1].max(end),
                _ => pushes.push([start, end]),
            }
        }
        let is_undisturbed = pushes.is_empty();
        // A push that lasts beyond the end of the round has no end to detect.
        pushes.retain(|[_, end]| end + TOLERANCE < duration);
        let is_obstructed = |detected: &&[f64; 2]| {
            let around =
                |at: &&[f64; 2]| detected[0] <= at[1] + GAP && detected[1] >= at[0] - TOLERANCE;
            obstructions.iter().any(|at| around(&at))
        };
        let obstructed = detected.iter().filter(is_obstructed).count();
        let [obstructed, false_detections] = if is_undisturbed {
            [obstructed, detected.len() - obstructed]
        } else {
            [0; 2]
        };
        let mut counts = Self {
            rounds: 1,
            undisturbed: usize::from(is_undisturbed),
            pushes: pushes.len(),
            obstructed,
            false_detections,
            ..Self::default()
        };
        for [start, end] in pushes {
            let during = detected.iter().filter(|detected| {
                detected[0] < end + TOLERANCE && detected[1] > start - TOLERANCE
            });
            let whole = during
                .copied()
                .reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
            let Some([first, last]) = whole else { continue };
            counts.found += 1;
            counts.starts += usize::from((first - start).abs() <= TOLERANCE);
            counts.ends += usize::from((last - end).abs() <= TOLERANCE);
        }
        counts
    }
}

impl Add for PushCounts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            rounds: self.rounds + other.rounds,
            undisturbed: self.undisturbed + other.undisturbed,
            pushes: self.pushes + other.pushes,
            found: self.found + other.found,
            starts: self.starts + other.starts,
            ends: self.ends + other.ends,
            obstructed: self.obstructed + other.obstructed,
            false_detections: self.false_detections + other.false_detections,
        }
    }
}

impl Sum for PushCounts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn touches_close_in_time_are_one_push() {
        let touches = [[1.0, 1.5], [1.7, 2.0], [5.0, 5.5], [9.0, 10.0]];
        let detected = [[1.02, 1.6], [1.65, 2.2]];
        let counts = PushCounts::count(10.0, &touches, &[], &detected);
        let expected = PushCounts {
            rounds: 1,
            pushes: 2,
            found: 1,
            starts: 1,
            ..PushCounts::default()
        };
        assert_eq!(
            counts, expected,
            "the last is cut off, the second not detected"
        );
        let calm = PushCounts::count(10.0, &[], &[], &detected);
        assert_eq!(
            (calm.undisturbed, calm.false_detections, calm.pushes),
            (1, 2, 0)
        );
        // A cup is struck a moment before the detection.
        let struck = PushCounts::count(10.0, &[], &[[0.8, 0.9], [3.0, 3.1]], &detected);
        assert_eq!((struck.obstructed, struck.false_detections), (1, 1));
        let both: PushCounts = [counts, calm].into_iter().sum();
        assert_eq!((both.rounds, both.pushes, both.false_detections), (2, 2, 2));
    }
}
