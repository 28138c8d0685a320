//! Detections that an observation holds twice.
//!
//! Two causes are distinguished from dirt that lies close together: a list in which nearly all rows occur the same
//! number of times, and detections of the same dirt by two images or two runs of a detector. A few equal rows are no
//! proof of a repetition, because coordinates that are rounded to a pixel are equal by chance where dirt lies close
//! together. Chance explains close pairs where dirt lies in a heap, so that each distance is compared with the
//! distance of the next neighbour, which states how dense the dirt is there.

use super::Observation;
use crate::geometry::{Bounds2, Point2, PointGrid};
use std::collections::{HashMap, HashSet};

/// Least number of distinct places in a list of which all rows are repeated, and least share of these places that occur
/// the same number of times \[1\].
const FEWEST: usize = 5;
const LEAST_REPEATED: f64 = 0.8;
/// Logarithm of the probability below which chance does not explain close pairs: one in a million.
const PAIRS_BY_CHANCE: f64 = -13.8;
/// Distance in a close pair over that of the next neighbour \[1\]. Along a line of dirt, such as one that a tool has
/// pushed together, chance alone gives a place such a neighbour with this probability; in an area, with its square.
const CLOSE: f64 = 0.2;
/// Largest distance in a close pair, in standard deviations of the distance of two detections of the same dirt \[1\].
const SAME: f64 = 3.0;
/// Largest distance in the pairs of a repeated image, over the median distance of its close pairs \[1\].
const REPEATED: f64 = 3.0;

impl Observation {
    /// Removes detections that repeat another one, and returns their number. `error`: standard deviation of a detection's
    /// position, along x and along y \[m\].
    ///
    /// Of equal coordinates, one detection remains if nearly all coordinates occur the same number of times, and more
    /// than once. Of a close pair, the first detection remains, but only if chance does not explain the number of
    /// pairs.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::represent::Observation;
    /// let places = [[0.1012, 0.0204], [0.0231, -0.0517], [0.09, 0.03], [-0.1, 0.02], [-0.02, 0.07]];
    /// let mut seen = Observation {
    ///     detections: places.repeat(2).into_iter().map(Point2::from).collect(),
    ///     ..Observation::default()
    /// };
    /// assert_eq!(seen.merge_repeated(2e-3), 5);
    /// ```
    pub fn merge_repeated(&mut self, error: f64) -> usize {
        let before = self.detections.len();
        let (distinct, numbers) = distinct_places(&self.detections);
        if stand_equally_often(&self.detections, &numbers) {
            self.detections.clone_from(&distinct);
        }
        let neighbours = Neighbours::of(&distinct);
        let seconds = neighbours.repeated(SAME * std::f64::consts::SQRT_2 * error);
        (self.detections).retain(|place| !seconds.contains(&numbers[&key(*place)]));
        before - self.detections.len()
    }
}

/// Bits of a place that are equal for equal coordinates.
fn key(place: Point2) -> [u64; 2] {
    [place.x, place.y].map(|along| (along + 0.0).to_bits())
}

/// Returns the distinct places in their order, and the number of each by its key.
fn distinct_places(places: &[Point2]) -> (Vec<Point2>, HashMap<[u64; 2], usize>) {
    let mut numbers = HashMap::new();
    let mut distinct = Vec::new();
    for &place in places {
        numbers.entry(key(place)).or_insert_with(|| {
            distinct.push(place);
            distinct.len() - 1
        });
    }
    (distinct, numbers)
}

/// Whether nearly all of the distinct places occur the same number of times in a list, and more than once.
fn stand_equally_often(places: &[Point2], numbers: &HashMap<[u64; 2], usize>) -> bool {
    let distinct = numbers.len();
    let mut times = vec![0_usize; distinct];
    for place in places {
        times[numbers[&key(*place)]] += 1;
    }
    times.sort_unstable();
    let usual = times.get(distinct / 2).copied().unwrap_or_default();
    let alike = times.iter().filter(|times| **times == usual).count();
    distinct >= FEWEST && usual > 1 && alike as f64 >= LEAST_REPEATED * distinct as f64
}

/// The nearest neighbour of each place, and the distances of the two nearest ones \[m\].
struct Neighbours(Vec<Option<(usize, [f64; 2])>>);

impl Neighbours {
    fn of(places: &[Point2]) -> Self {
        let size =
            Bounds2::from_points(places.iter().copied()).map_or(1.0, |bounds| bounds.size().max());
        let mut grid = PointGrid::from_points(places, size / (places.len().max(1) as f64).sqrt());
        let nearest = |(i, &place): (usize, &Point2)| {
            grid.remove(i, place);
            let first = grid.nearest(place);
            let found = first.map(|first| {
                grid.remove(first, places[first]);
                let second = grid.nearest(place);
                grid.insert(first, places[first]);
                let distance = |other: usize| (places[other] - place).norm();
                let next = second.map_or(f64::INFINITY, distance);
                (first, [distance(first), next])
            });
            grid.insert(i, place);
            found
        };
        Self(places.iter().enumerate().map(nearest).collect())
    }

    /// Returns the second place of each pair of places that two images show, at most `most` \[m\] apart; none if chance
    /// explains the pairs that are much closer to each other than to a third place.
    fn repeated(&self, most: f64) -> HashSet<usize> {
        let is_close = |[distance, next]: [f64; 2]| distance < CLOSE * next && next.is_finite();
        let close = self.pairs(most, is_close);
        let trials = self.0.len() as f64 / 2.0;
        if pairs_by_chance(close.len() as f64 / trials, trials) >= PAIRS_BY_CHANCE {
            return HashSet::new();
        }
        let mut distances: Vec<f64> = close.iter().map(|(_, distance)| *distance).collect();
        distances.sort_unstable_by(f64::total_cmp);
        let typical = distances[distances.len() / 2];
        let all = self.pairs(most.min(REPEATED * typical), |_| true);
        all.into_iter().map(|(second, _)| second).collect()
    }

    /// Returns the second place and the distance of each pair of places that are each other's nearest neighbours, at most
    /// `most` \[m\] apart, and meet a condition on the distances of their two nearest neighbours.
    fn pairs(&self, most: f64, is_asked_for: impl Fn([f64; 2]) -> bool) -> Vec<(usize, f64)> {
        let nearest = |i: usize| {
            let (nearest, distances) = self.0[i]?;
            (distances[0] <= most && is_asked_for(distances)).then_some((nearest, distances[0]))
        };
        let seconds = (0..self.0.len()).filter_map(|i| {
            let (first, distance) = nearest(i)?;
            (first < i && nearest(first)?.0 == i).then_some((i, distance))
        });
        seconds.collect()
    }
}

/// Bound on the logarithm of the probability of at least this share of close pairs in a number of trials (Chernoff bound of
/// the binomial distribution).
fn pairs_by_chance(share: f64, trials: f64) -> f64 {
    let share = share.min(1.0);
    if trials <= 0.0 || share <= CLOSE {
        return 0.0;
    }
    let term = |found: f64, expected: f64| {
        if found > 0.0 {
            found * libm::log(found / expected)
        } else {
            0.0
        }
    };
    -trials * (term(share, CLOSE) + term(1.0 - share, 1.0 - CLOSE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::normal_pair;
    use rand::RngExt;
    use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

    const ERROR: f64 = 2e-3;

    fn merged(places: &[Point2]) -> usize {
        let mut seen = Observation {
            detections: places.to_vec(),
            ..Observation::default()
        };
        let repeated = seen.merge_repeated(ERROR);
        assert_eq!(seen.detections.len() + repeated, places.len());
        repeated
    }

    fn rounded(places: &[Point2], step: f64) -> Vec<Point2> {
        let rounded = |along: f64| (along / step).round() * step;
        places.iter().map(|place| place.map(rounded)).collect()
    }

    /// Uniform dirt on a board, in a heap, and along a line, each `count` places.
    fn dirt(count: usize, seed: u64) -> [Vec<Point2>; 3] {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut between = |size: f64| size * (random.random::<f64>() - 0.5);
        let uniform = (0..count)
            .map(|_| Point2::new(between(0.32), between(0.24)))
            .collect();
        let line = (0..count).map(|_| Point2::new(between(0.1), 0.0)).collect();
        let heap = (0..count)
            .map(|_| Point2::from(normal_pair(&mut random) * 0.01))
            .collect();
        [uniform, heap, line]
    }

    #[test]
    fn dirt_that_lies_close_together_is_not_repeated() {
        for seed in 0..100 {
            for count in [2, 10, 60, 300] {
                for places in dirt(count, seed) {
                    assert_eq!(merged(&places), 0, "{seed} {count}");
                    // Coordinates on a grid, such as that of pixels, are equal by chance.
                    for step in [1e-2, 5e-3, 2.5e-3, 1.0 / 256.0, 1e-3, 1e-4] {
                        let equal = merged(&rounded(&places, step));
                        assert_eq!(equal, 0, "{seed} {count} {step}");
                    }
                }
            }
        }
    }

    #[test]
    fn rows_of_a_list_that_holds_all_of_them_equally_often_count_once() {
        for seed in 0..20 {
            for step in [1e-2, 1e-3, 1e-6] {
                let [uniform, ..] = dirt(27, seed);
                let (places, _) = distinct_places(&rounded(&uniform, step));
                let all = places.len();
                assert_eq!(merged(&places.repeat(2)), all, "{seed} {step}");
                assert_eq!(merged(&places.repeat(3)), 2 * all, "{seed} {step}");
                // Two rows more, as of another image, change nothing.
                let more = [&places.repeat(2)[..], &places[..2]].concat();
                assert_eq!(merged(&more), all + 2, "{seed} {step}");
            }
        }
    }

    #[test]
    fn dirt_that_two_images_show_counts_once() {
        for seed in 0..20 {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            let [places, _, _] = dirt(27, seed);
            for apart in [1e-5, 5e-4] {
                let again = places
                    .iter()
                    .map(|place| place + normal_pair(&mut random) * apart);
                let rows = [&places[..], &again.collect::<Vec<_>>()].concat();
                assert!(merged(&rows) >= 24, "{seed} {apart}: {}", merged(&rows));
            }
        }
    }
}
