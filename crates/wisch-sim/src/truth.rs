//! What the simulated world knows to be true, for reports and tests: never for plan or interpretation.

use super::Dirt;
use wisch::geometry::Point2;

/// Mean and spread of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    count: usize,
    mean: f64,
    squares: f64,
}

impl Spread {
    /// Takes in one value (Welford 1962).
    pub(crate) fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
    }

    /// The spread of `count` values with this mean and this sum of squared differences from it.
    pub const fn of(count: usize, mean: f64, squares: f64) -> Self {
        Self {
            count,
            mean,
            squares,
        }
    }

    /// Sum of the squared differences from the mean.
    pub const fn squares(&self) -> f64 {
        self.squares
    }

    /// How many values there were.
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Their mean; 0 without any.
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// Their standard deviation; 0 without any.
    pub fn deviation(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// The truth of one execution.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundTruth {
    /// The dirt afterwards.
    pub dirt: Dirt,
    /// Normal force of the surface on the tool while it slides over it and nobody pushes [N].
    pub contact_force: Spread,
    /// Greatest distance of the tool centre point from the plane of the real surface at these times [m].
    pub max_plane_distance: f64,
    /// Greatest size of f_c in all of the execution [N].
    pub max_controller_force: f64,
    /// Share of the sliding time without contact.
    pub lost_share: f64,
    /// Greatest size of the difference between where the tool was told to be along the surface and where
    /// it was, while it slides and nobody pushes [m].
    pub max_lateral_error: f64,
    /// From when to when a hand pressed on the tool without a break [s], in order; a hand that the tool outruns touches
    /// nothing.
    pub pushes: Vec<[f64; 2]>,
    /// From when to when robot or tool touched something other than the surface without a break [s], in order.
    pub obstructions: Vec<[f64; 2]>,
    /// What robot and tool hide from a camera afterwards: convex hulls in the frame of the real surface [m]; none where
    /// nothing looks, or sees past them.
    pub hidden: Vec<Vec<Point2>>,
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn a_spread_has_the_mean_and_deviation_of_its_values() {
        let mut spread = Spread::default();
        assert_eq!(
            (spread.count(), spread.mean(), spread.deviation()),
            (0, 0.0, 0.0)
        );
        for value in [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0] {
            spread.add(value);
        }
        assert_eq!(spread.count(), 8);
        assert!((spread.mean() - 5.0).abs() < 1e-12 && (spread.deviation() - 2.0).abs() < 1e-12);
    }
}
