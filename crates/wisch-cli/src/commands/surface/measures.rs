//! Measures of a sheet: bends, normals, and where a tool touches it.

use serde::Serialize;
use wisch::geometry::{Point3, Sheet, Vector3};

/// A value and where on the mesh it occurs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct PlacedValue {
    pub(super) value: f64,
    /// Point in the frame of the mesh [m].
    pub(super) at: [f64; 3],
}

impl PlacedValue {
    pub(super) fn new(value: f64, at: Point3) -> Self {
        Self {
            value,
            at: at.coords.into(),
        }
    }
}

/// Principal curvatures and normals of a sheet.
pub(super) struct Measures {
    /// Largest curvature that bulges towards the tool [1/m]; negative if there is none.
    pub(super) bulge: PlacedValue,
    /// Least curvature, negative in a hollow [1/m].
    pub(super) hollow: PlacedValue,
    /// Mean normal.
    pub(super) mean_normal: Vector3,
    /// Mean and largest angle of the normals from their mean [rad].
    pub(super) mean_lean: f64,
    pub(super) largest_lean: PlacedValue,
    /// Share of the area that the tool touches with its whole footprint if its sides follow the principal directions.
    pub(super) touched_share: f64,
    /// Largest compression that the whole footprint needs [m].
    pub(super) needed_compression: PlacedValue,
}

impl Measures {
    /// Measures a sheet for a tool with a footprint of these sides and a compression depth [m].
    pub(super) fn new(sheet: &Sheet, tool_size: [f64; 2], depth: f64) -> Self {
        let first = sheet
            .vertices()
            .next()
            .map_or_else(Point3::origin, |v| v.point);
        let mut bulge = PlacedValue::new(f64::NEG_INFINITY, first);
        let mut hollow = PlacedValue::new(f64::INFINITY, first);
        let mut needed = PlacedValue::new(0.0, first);
        let (mut touched, mut area, mut sum) = (0.0, 0.0, Vector3::zeros());
        for vertex in sheet.vertices() {
            let [larger, smaller] = principal_curvatures(&vertex.bend);
            if larger > bulge.value {
                bulge = PlacedValue::new(larger, vertex.point);
            }
            if smaller < hollow.value {
                hollow = PlacedValue::new(smaller, vertex.point);
            }
            let compression = needed_compression([larger, smaller], tool_size);
            if compression > needed.value {
                needed = PlacedValue::new(compression, vertex.point);
            }
            touched += if compression <= depth {
                vertex.area
            } else {
                0.0
            };
            area += vertex.area;
            sum += vertex.normal * vertex.area;
        }
        let mean_normal = sum.try_normalize(0.0).unwrap_or_else(Vector3::z);
        let (mut mean_lean, mut largest_lean) = (0.0, PlacedValue::new(0.0, first));
        for vertex in sheet.vertices() {
            let lean = vertex.normal.angle(&mean_normal);
            mean_lean += lean * vertex.area / area;
            if lean > largest_lean.value {
                largest_lean = PlacedValue::new(lean, vertex.point);
            }
        }
        Self {
            bulge,
            hollow,
            mean_normal,
            mean_lean,
            largest_lean,
            touched_share: touched / area,
            needed_compression: needed,
        }
    }
}

/// Returns the principal curvatures [1/m], the larger first.
pub(super) fn principal_curvatures(bend: &nalgebra::Matrix2<f64>) -> [f64; 2] {
    let mean = 0.5 * bend.trace();
    let half = 0.5 * (bend[(0, 0)] - bend[(1, 1)]);
    let twist = 0.5 * (bend[(0, 1)] + bend[(1, 0)]);
    let radius = (half * half + twist * twist).sqrt();
    [mean + radius, mean - radius]
}

/// Returns the compression [m] with which a rectangular pad of even stiffness touches with its whole footprint, in the
/// better of the two ways to lay its sides along the principal directions.
///
/// Under the pad of mean compression δ, the surface is lower than its tangent plane by ½(κ₁x² + κ₂y²). The least
/// compression is δ − Σ κL²/12 over bulges (at the corners) − Σ |κ|L²/24 over hollows (in the middle).
pub(super) fn needed_compression([larger, smaller]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    let along = |curvature: f64, side: f64| {
        let share = if curvature > 0.0 { 12.0 } else { 24.0 };
        curvature.abs() * side * side / share
    };
    (along(larger, x) + along(smaller, y)).min(along(larger, y) + along(smaller, x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pad_lies_on_bulges_and_in_hollows_up_to_the_closed_forms() {
        // 10 × 6 cm with 10 mm: bulges of 8.3 cm radius across, balls of 11.3 cm, hollows of 4.2 cm, bowls of 5.7 cm. A
        // cylinder is met across its long side if it has no other choice, which a square pad has not.
        let pad = [0.1, 0.06];
        let square = [0.1, 0.1];
        assert!((needed_compression([1.0 / 0.0833, 0.0], square) - 0.01).abs() < 1e-4);
        assert!((needed_compression([1.0 / 0.1133, 1.0 / 0.1133], pad) - 0.01).abs() < 1e-4);
        assert!((needed_compression([0.0, -1.0 / 0.0417], square) - 0.01).abs() < 1e-4);
        assert!((needed_compression([-1.0 / 0.0567, -1.0 / 0.0567], pad) - 0.01).abs() < 1e-4);
        // The short side goes across the bend.
        assert!((needed_compression([12.0, 0.0], pad) - 0.0036).abs() < 1e-9);
        let numeric = |[k1, k2]: [f64; 2], [x, y]: [f64; 2]| {
            let depth = |i: i32, j: i32| {
                let (u, v) = (x * f64::from(i) / 200.0, y * f64::from(j) / 200.0);
                -0.5 * (k1 * u * u + k2 * v * v)
            };
            let range = || (-100..=100).flat_map(|i| (-100..=100).map(move |j| (i, j)));
            let mean = range().map(|(i, j)| depth(i, j)).sum::<f64>() / 201.0 / 201.0;
            mean - range()
                .map(|(i, j)| depth(i, j))
                .fold(f64::INFINITY, f64::min)
        };
        for bends in [[2.0, 2.0], [2.0, -2.0], [-4.0, -4.0], [11.5, -0.3]] {
            let [one, other] = [pad, [pad[1], pad[0]]].map(|sides| numeric(bends, sides));
            let expected = one.min(other);
            let found = needed_compression(bends, pad);
            assert!(
                (found / expected - 1.0).abs() < 0.02,
                "{bends:?}: {found} {expected}"
            );
        }
    }
}
