//! Stretch of lengths in a chart.

use super::flatten::{FlatTriangle, doubled_area};
use super::topology::Triangles;
use crate::geometry::{Point2, Point3, PointGrid};
use nalgebra::Matrix2;

/// Share of the area that must be within the limit of the stretch [1].
const LIMITED_SHARE: f64 = 0.99;

/// Differences of lengths in a chart from those on the surface.
///
/// The stretch of a triangle is max(σ₁, 1/σ₂) − 1, with the singular values σ₁ ≥ σ₂ of its map into the chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetStretch {
    /// Largest stretch of a triangle \[1\].
    pub most: f64,
    /// Where the stretch is largest, in the frame of the mesh \[m\].
    pub at: Point3,
    /// Stretch that 99 % of the area do not exceed \[1\].
    pub p99: f64,
    /// Stretch that 95 % of the area do not exceed \[1\].
    pub p95: f64,
    /// Median over the area \[1\].
    pub median: f64,
    /// Largest stretch of a disc of the tool's radius \[1\]: of the mean metric of the triangles in it.
    pub at_tool_scale: f64,
    /// Share of the area beyond the limit \[1\].
    pub share_beyond: f64,
    /// Number of triangles that lie upside down in the chart.
    pub folded: usize,
    /// The first triangle that lies upside down \[m\].
    pub folded_at: Option<Point3>,
}

/// Returns the map of a triangle's own plane into the chart.
pub(super) fn chart_from_triangle(
    flat: &FlatTriangle,
    places: &[Point2],
    triangle: [u32; 3],
) -> Option<Matrix2<f64>> {
    let [a, b, c] = triangle.map(|i| places[i as usize]);
    let own = Matrix2::from_columns(&[flat.corners[1], flat.corners[2]]);
    Some(Matrix2::from_columns(&[b - a, c - a]) * own.try_inverse()?)
}

/// Returns the singular values of a matrix, the larger first.
fn singular_values(m: &Matrix2<f64>) -> [f64; 2] {
    let (e, f) = (0.5 * (m[(0, 0)] + m[(1, 1)]), 0.5 * (m[(0, 0)] - m[(1, 1)]));
    let (g, h) = (0.5 * (m[(1, 0)] + m[(0, 1)]), 0.5 * (m[(1, 0)] - m[(0, 1)]));
    let (q, r) = ((e * e + h * h).sqrt(), (f * f + g * g).sqrt());
    [q + r, (q - r).abs()]
}

fn stretch_of([larger, smaller]: [f64; 2]) -> f64 {
    if smaller > 0.0 {
        larger.max(1.0 / smaller) - 1.0
    } else {
        f64::INFINITY
    }
}

/// Returns the stretch of each triangle \[1\]; zero for a triangle without area.
pub(super) fn triangle_stretches(
    surface: &Triangles,
    flat: &[FlatTriangle],
    places: &[Point2],
) -> Vec<f64> {
    (surface.triangles.iter().zip(flat))
        .map(|(&triangle, flat)| {
            let map = chart_from_triangle(flat, places, triangle);
            map.map_or(0.0, |map| stretch_of(singular_values(&map)))
        })
        .collect()
}

/// Returns the share of the area whose stretch exceeds a limit \[1\].
pub(super) fn share_beyond(flat: &[FlatTriangle], stretches: &[f64], limit: f64) -> f64 {
    let total: f64 = flat.iter().map(|flat| flat.area).sum();
    let beyond = (stretches.iter().zip(flat))
        .filter(|(stretch, _)| **stretch > limit)
        .fold(0.0, |sum, (_, flat)| sum + flat.area);
    beyond / total.max(f64::MIN_POSITIVE)
}

/// Measures a chart; `limit` is that of the stretch \[1\], `radius` that of the tool \[m\].
pub(super) fn measure(
    surface: &Triangles,
    flat: &[FlatTriangle],
    places: &[Point2],
    stretches: &[f64],
    limit: f64,
    radius: f64,
) -> SheetStretch {
    let centre = |t: usize| {
        let [a, b, c] = surface.corners(surface.triangles[t]);
        Point3::from((a.coords + b.coords + c.coords) / 3.0)
    };
    let worst = (0..stretches.len()).max_by(|&one, &other| {
        stretches[one]
            .total_cmp(&stretches[other])
            .then(other.cmp(&one))
    });
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    order.sort_by(|&one, &other| {
        stretches[one]
            .total_cmp(&stretches[other])
            .then(one.cmp(&other))
    });
    let total: f64 = flat.iter().map(|flat| flat.area).sum();
    let quantile = |share: f64| {
        let mut sum = 0.0;
        let found = order.iter().find(|&&t| {
            sum += flat[t].area;
            sum >= share * total
        });
        found.map_or(0.0, |&t| stretches[t])
    };
    let folded: Vec<usize> = (0..surface.triangles.len())
        .filter(|&t| doubled_area(places, surface.triangles[t]) < 0.0)
        .collect();
    SheetStretch {
        most: worst.map_or(0.0, |t| stretches[t]),
        at: worst.map_or(Point3::origin(), centre),
        p99: quantile(LIMITED_SHARE),
        p95: quantile(0.95),
        median: quantile(0.5),
        at_tool_scale: stretch_of_discs(surface, flat, places, radius),
        share_beyond: share_beyond(flat, stretches, limit),
        folded: folded.len(),
        folded_at: folded.first().map(|&t| centre(t)),
    }
}

/// Returns the largest stretch of the mean metric in a disc, over discs half a radius apart.
fn stretch_of_discs(
    surface: &Triangles,
    flat: &[FlatTriangle],
    places: &[Point2],
    radius: f64,
) -> f64 {
    // Surface lengths in terms of the chart: the metric is M = (J Jᵀ)⁻¹ of the map J into the chart.
    let metrics: Vec<Option<Matrix2<f64>>> = (surface.triangles.iter().zip(flat))
        .map(|(&triangle, flat)| {
            let map = chart_from_triangle(flat, places, triangle)?;
            (map * map.transpose()).try_inverse()
        })
        .collect();
    let centres: Vec<Point2> = (surface.triangles.iter())
        .map(|triangle| {
            let [a, b, c] = triangle.map(|i| places[i as usize].coords);
            Point2::from((a + b + c) / 3.0)
        })
        .collect();
    let grid = PointGrid::from_points(&centres, radius);
    let step = 0.5 * radius;
    let mut middles = std::collections::BTreeMap::new();
    for &centre in &centres {
        let cell = [centre.x, centre.y].map(|c| (c / step).round() as i64);
        middles.entry(cell).or_insert(centre);
    }
    let mut most: f64 = 0.0;
    for middle in middles.into_values() {
        // The order of the visits is arbitrary, that of a sum is not.
        let mut near = Vec::new();
        grid.visit_within(middle, radius, |t, _| near.push(t));
        near.sort_unstable();
        let (mut sum, mut area) = (Matrix2::zeros(), 0.0);
        for t in near {
            if let Some(metric) = metrics[t] {
                sum += metric * flat[t].area;
                area += flat[t].area;
            }
        }
        if area > 0.0 {
            let [larger, smaller] = singular_values(&(sum / area)).map(f64::sqrt);
            most = most.max(stretch_of([1.0 / smaller, 1.0 / larger]));
        }
    }
    most
}
