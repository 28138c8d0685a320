//! Random numbers that are the same on every platform.

use crate::geometry::Vector2;
use rand::{Rng, RngExt};

/// Two independent draws from N(0, 1) (Box and Muller, 1958).
pub fn normal_pair(random: &mut impl Rng) -> Vector2 {
    let (u, v) = (1.0 - random.random::<f64>(), random.random::<f64>());
    let angle = std::f64::consts::TAU * v;
    Vector2::new(libm::cos(angle), libm::sin(angle)) * (-2.0 * libm::log(u)).sqrt()
}

/// A draw from N(0, 1): the first of [`normal_pair`].
pub fn normal(random: &mut impl Rng) -> f64 {
    normal_pair(random).x
}

/// Returns a number uniform in (0, 1) for a key, an item and a draw, independent of the order of calls.
pub fn keyed_uniform(key: u64, item: u64, draw: u32) -> f64 {
    let mixed = mix(mix(key ^ mix(item)).wrapping_add(u64::from(draw)));
    // The upper 53 bits, each value at the middle of its step.
    ((mixed >> 11) as f64 + 0.5) * (1.0 / (1_u64 << 53) as f64)
}

/// SplitMix64's finaliser after its increment (Steele, Lea and Flood, 2014).
fn mix(value: u64) -> u64 {
    let z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

    /// Returns mean, variance and fourth moment.
    fn moments(numbers: impl Iterator<Item = f64> + Clone) -> [f64; 3] {
        let count = numbers.clone().count() as f64;
        let mean = numbers.clone().sum::<f64>() / count;
        let central = |power| numbers.clone().map(|x| (x - mean).powi(power)).sum::<f64>() / count;
        [mean, central(2), central(4)]
    }

    #[test]
    fn a_pair_is_standard_normal_and_independent() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let pairs: Vec<Vector2> = (0..100_000).map(|_| normal_pair(&mut random)).collect();
        for axis in [0, 1] {
            let [mean, variance, fourth] = moments(pairs.iter().map(|pair| pair[axis]));
            // Four standard errors of 100,000 draws: 1/√n, √2/√n and √96/√n.
            assert!(mean.abs() < 0.013, "{mean}");
            assert!((variance - 1.0).abs() < 0.018, "{variance}");
            assert!((fourth - 3.0).abs() < 0.124, "{fourth}");
        }
        let [covariance, ..] = moments(pairs.iter().map(|pair| pair.x * pair.y));
        assert!(covariance.abs() < 0.013, "{covariance}");
    }

    #[test]
    fn keyed_numbers_are_uniform_over_items_draws_and_keys() {
        let by: [fn(u32) -> f64; 3] = [
            |i| keyed_uniform(u64::from(i), 1, 2),
            |i| keyed_uniform(1, u64::from(i), 2),
            |i| keyed_uniform(1, 2, i),
        ];
        for draw in by {
            let [mean, variance, fourth] = moments((0..100_000).map(draw));
            // Four standard errors of 100,000 draws.
            assert!((mean - 0.5).abs() < 0.0037, "{mean}");
            assert!((variance - 1.0 / 12.0).abs() < 0.001, "{variance}");
            assert!((fourth - 1.0 / 80.0).abs() < 0.0003, "{fourth}");
            assert!((0..1000).map(draw).all(|x| x > 0.0 && x < 1.0));
        }
    }
}
