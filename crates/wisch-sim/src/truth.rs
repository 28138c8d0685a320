//! Ground truth of the simulated world, for reports and tests; planner and interpreter never read it.

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
    /// Adds a value (Welford 1962).
    pub(crate) fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
    }

    /// Returns the spread of `count` values with the given mean and sum of squared differences from it.
    pub const fn from_moments(count: usize, mean: f64, squares: f64) -> Self {
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

    /// Number of values that were summarised.
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Mean of the values; 0 without values.
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// Standard deviation of the values; 0 without values.
    pub fn deviation(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// The ground truth of one execution in the simulated world.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundTruth {
    /// The dirt after the execution.
    pub dirt: Dirt,
    /// Normal force of the surface on the tool while it slides and no person pushes \[N\].
    pub contact_force: Spread,
    /// Largest distance of the tool centre point from the real surface, along its normal, at the same times \[m\].
    pub max_plane_distance: f64,
    /// Largest norm of the controller's force f_c over the whole execution \[N\].
    pub max_controller_force: f64,
    /// Share of the sliding time without contact \[1\].
    pub lost_share: f64,
    /// Largest distance along the surface between commanded and true tool position, while the tool
    /// slides and no person pushes \[m\].
    pub max_lateral_error: f64,
    /// Begin and end of every push \[s\], by time. A push counts only while the hand touches the tool, not when the tool
    /// outruns it.
    pub pushes: Vec<[f64; 2]>,
    /// Begin and end of every contact of robot or tool with something other than the surface \[s\], by time.
    pub obstructions: Vec<[f64; 2]>,
    /// Areas that robot and tool hide from the camera after the execution: convex hulls in the xy
    /// plane of the real surface's frame \[m\]. Empty without a camera, or if the arm does not hide
    /// anything from it.
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
