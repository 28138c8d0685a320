//! Kernel density estimation (2): nodes on the peaks of the particle density.

use crate::geometry::{Bounds2, Point2, PointGrid, Vector2};
use crate::plan::FreeSpace;

/// Samples of the density per bandwidth.
const SAMPLES_PER_BANDWIDTH: f64 = 10.0;
/// The Gaussian is cut off at this many bandwidths, where it has fallen to e⁻¹⁶.
const CUT_OFF: f64 = 4.0;
/// Most samples of a density map.
const MAX_SAMPLES: usize = 4_000_000;

/// Width of the kernel of (2), and reach of the tool at a peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KdeConfig {
    /// Bandwidth h \[m\]; `None` takes it from the data, see [`data_bandwidth`].
    pub bandwidth: Option<f64>,
    /// Distance within which the tool at a node reaches a particle \[m\].
    pub reach: f64,
}

/// Returns the bandwidth of the kernel of (2) for particles at `points` \[m\], by Scott's rule: h =
/// √2 σ N^(−1/6), at most r_s, which is `radius` \[m\].
///
/// The factor √2 is there because (2) divides by h² where a normal distribution divides by 2σ². The limit r_s
/// is there because a wider kernel blurs gaps that are wider than the tool.
pub fn data_bandwidth(points: &[Point2], radius: f64) -> f64 {
    if points.len() < 2 {
        return radius;
    }
    let count = points.len() as f64;
    let mean = points.iter().map(|p| p.coords).sum::<Vector2>() / count;
    let variance = points
        .iter()
        .map(|p| (p.coords - mean).norm_squared())
        .sum::<f64>()
        / (2.0 * (count - 1.0));
    let scott = (2.0 * variance).sqrt() * count.powf(-1.0 / 6.0);
    if scott > 0.0 {
        scott.min(radius)
    } else {
        radius
    }
}

/// The density K(x) of (2), sampled on a grid.
///
/// Each particle is distributed to the samples around it, then smoothed by the separable Gaussian. The relative
/// error stays below 1e-3 where the density is above a hundredth of its peak.
#[derive(Debug, Clone, PartialEq)]
pub struct CoverageDensity {
    origin: Point2,
    step: f64,
    columns: usize,
    rows: usize,
    values: Vec<f64>,
}

impl CoverageDensity {
    /// Samples the density of `points` over `bounds` with bandwidth h \[m\].
    pub fn new(points: &[Point2], bounds: Bounds2, bandwidth: f64) -> Self {
        let size = bounds.size();
        let finest = (size.x * size.y / MAX_SAMPLES as f64).sqrt();
        let step = (bandwidth / SAMPLES_PER_BANDWIDTH).max(finest);
        let margin = (CUT_OFF * bandwidth / step).ceil() as usize + 1;
        let columns = (size.x / step).ceil() as usize + 1 + 2 * margin;
        let rows = (size.y / step).ceil() as usize + 1 + 2 * margin;
        let origin = bounds.min - Vector2::new(1.0, 1.0) * (margin as f64 * step);
        let mut map = Self {
            origin,
            step,
            columns,
            rows,
            values: vec![0.0; columns * rows],
        };
        map.share_out(points);
        map.smooth(bandwidth);
        map
    }

    /// Number of samples along x and y.
    pub fn shape(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Position of sample (column, row) \[m\].
    pub fn sample_position(&self, column: usize, row: usize) -> Point2 {
        self.origin + Vector2::new(column as f64, row as f64) * self.step
    }

    /// Density K at sample (column, row), by (2).
    ///
    /// # Panics
    /// Beyond [`CoverageDensity::shape`].
    pub fn sample(&self, column: usize, row: usize) -> f64 {
        self.values[row * self.columns + column]
    }

    /// Distributes each particle to the 4 × 4 samples around it, so that its moments up to the third are
    /// conserved.
    fn share_out(&mut self, points: &[Point2]) {
        let weight = 1.0 / points.len().max(1) as f64;
        for point in points {
            let at = (point - self.origin) / self.step;
            let inside = |v: f64, samples: usize| v >= 1.0 && v < samples as f64 - 2.0;
            if !(inside(at.x, self.columns) && inside(at.y, self.rows)) {
                continue;
            }
            let (column, row) = (at.x as usize, at.y as usize);
            let along_x = cubic_shares(at.x - column as f64);
            let along_y = cubic_shares(at.y - row as f64);
            for (j, share_y) in along_y.iter().enumerate() {
                let line = (row + j - 1) * self.columns + column - 1;
                for (cell, share_x) in self.values[line..line + 4].iter_mut().zip(along_x) {
                    *cell += weight * share_y * share_x;
                }
            }
        }
    }

    /// Convolves rows, then columns, with the Gaussian of (2).
    fn smooth(&mut self, bandwidth: f64) {
        let reach = (CUT_OFF * bandwidth / self.step).ceil() as usize;
        // exp(−d² / h²) at the distances d = i · step.
        let kernel: Vec<f64> = (0..=reach)
            .map(|i| (-(i as f64 * self.step / bandwidth).powi(2)).exp())
            .collect();
        let mut along_x = vec![0.0; self.values.len()];
        for row in 0..self.rows {
            let line = row * self.columns..(row + 1) * self.columns;
            let source = &self.values[line.clone()];
            let target = &mut along_x[line];
            for (i, &value) in source.iter().enumerate().filter(|(_, v)| **v != 0.0) {
                let first = i.saturating_sub(reach);
                let last = (i + reach).min(self.columns - 1);
                for (k, cell) in target[first..=last].iter_mut().enumerate() {
                    *cell += value * kernel[(first + k).abs_diff(i)];
                }
            }
        }
        self.values.fill(0.0);
        for row in 0..self.rows {
            let first = row.saturating_sub(reach);
            let last = (row + reach).min(self.rows - 1);
            for source_row in first..=last {
                let weight = kernel[row.abs_diff(source_row)];
                let source = &along_x[source_row * self.columns..][..self.columns];
                let target = &mut self.values[row * self.columns..][..self.columns];
                for (cell, value) in target.iter_mut().zip(source) {
                    *cell += weight * value;
                }
            }
        }
    }
}

/// Returns the weights of the samples at −1, 0, 1 and 2 for a particle at `offset` in [0, 1): those of cubic
/// interpolation.
fn cubic_shares(offset: f64) -> [f64; 4] {
    let f = offset;
    [
        -f * (f - 1.0) * (f - 2.0) / 6.0,
        (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0,
        -(f + 1.0) * f * (f - 2.0) / 2.0,
        (f + 1.0) * f * (f - 1.0) / 6.0,
    ]
}

/// Returns the peaks of the particle density in the surface frame \[m\], highest first.
///
/// Each peak keeps the clearance d_s = 2 r_s from the nodes before it and brings at least one particle into
/// reach, until every particle is within reach of a node. If no such peak is left while particles are still out
/// of reach, further peaks keep only r_s.
pub fn kde(space: &FreeSpace, particles: &[Point2], config: &KdeConfig) -> Vec<Point2> {
    let Some(bounds) = Bounds2::from_points(space.surface().outline.outer().iter().copied()) else {
        return Vec::new();
    };
    let radius = space.radius();
    let bandwidth = config
        .bandwidth
        .unwrap_or_else(|| data_bandwidth(particles, radius));
    let density = CoverageDensity::new(particles, bounds, bandwidth);
    let (columns, rows) = density.shape();
    let mut places: Vec<(f64, Point2)> = (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (column, row)))
        .map(|(column, row)| {
            let place = density.sample_position(column, row);
            (density.sample(column, row), place)
        })
        .filter(|(_, place)| space.is_free(*place))
        .collect();
    places.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut out_of_reach = PointGrid::from_points(particles, config.reach);
    let mut nodes: Vec<Point2> = Vec::new();
    let mut placed = PointGrid::new(2.0 * radius);
    for clearance in [2.0 * radius, radius] {
        for &(_, place) in &places {
            if out_of_reach.is_empty() {
                return nodes;
            }
            let is_too_near = |_, node: Point2| (node - place).norm() < clearance;
            if !placed.has_within(place, clearance, is_too_near)
                && out_of_reach.has_within(place, config.reach, |_, _| true)
            {
                placed.insert(nodes.len(), place);
                nodes.push(place);
                out_of_reach.remove_within(place, config.reach);
            }
        }
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The sum of (2), term by term.
    fn density(points: &[Point2], at: Point2, bandwidth: f64) -> f64 {
        let sum: f64 = points
            .iter()
            .map(|p| (-(p - at).norm_squared() / (bandwidth * bandwidth)).exp())
            .sum();
        sum / points.len() as f64
    }

    proptest! {
        #[test]
        fn the_map_agrees_with_the_sum(
            points in prop::collection::vec((-0.2..0.2f64, -0.14..0.14f64).prop_map(|(x, y)| Point2::new(x, y)), 1..60),
            bandwidth in 0.02..0.1f64,
        ) {
            let bounds = Bounds2 { min: Point2::new(-0.2, -0.14), max: Point2::new(0.2, 0.14) };
            let map = CoverageDensity::new(&points, bounds, bandwidth);
            let (columns, rows) = map.shape();
            let samples: Vec<(f64, f64)> = (0..rows)
                .flat_map(|row| (0..columns).map(move |column| (column, row)))
                .map(|(c, r)| (map.sample(c, r), density(&points, map.sample_position(c, r), bandwidth)))
                .collect();
            let peak = samples.iter().map(|(_, exact)| *exact).fold(0.0, f64::max);
            for (sampled, exact) in samples {
                if exact > peak / 100.0 {
                    prop_assert!((sampled / exact - 1.0).abs() < 1e-3, "{sampled} for {exact}");
                }
            }
        }
    }

    #[test]
    fn the_bandwidth_of_the_data_never_exceeds_the_tool() {
        let spread: Vec<Point2> = (0..100).map(|i| Point2::new(f64::from(i), 0.0)).collect();
        assert_eq!(data_bandwidth(&spread, 0.065), 0.065);
        assert_eq!(data_bandwidth(&spread[..1], 0.065), 0.065);
        let heap = vec![Point2::new(0.1, 0.1); 5];
        assert_eq!(data_bandwidth(&heap, 0.065), 0.065);
        let close: Vec<Point2> = spread.iter().map(|p| p * 1e-4).collect();
        // Steps of 0.1 mm: sum of squares n (n² − 1) / 12, over both axes' 2 (n − 1).
        let sigma = 1e-4 * (83_325.0_f64 / 198.0).sqrt();
        let scott = 2_f64.sqrt() * sigma * 100_f64.powf(-1.0 / 6.0);
        assert!((data_bandwidth(&close, 0.065) - scott).abs() < 1e-12);
    }
}
