//! The discretised grid: it covers the whole surface without regard to the dirt.

use crate::geometry::{Bounds2, Point2};
use crate::plan::FreeSpace;

/// Returns the centres of the free square cells of pitch r_s in the surface frame \[m\], row by row
/// along x.
///
/// ⌊length / r_s⌋ cells per side of the outline's bounding box, centred on it (at least one).
pub fn grid(space: &FreeSpace) -> Vec<Point2> {
    free_cells(space, space.radius())
}

/// Returns the centres of the free square cells of this pitch [m].
pub(super) fn free_cells(space: &FreeSpace, pitch: f64) -> Vec<Point2> {
    let Some(bounds) = Bounds2::from_points(space.surface().outline.outer().iter().copied()) else {
        return Vec::new();
    };
    let [columns, rows] = shape(&bounds, pitch);
    let center = bounds.center();
    let offset = |i: usize, count: usize| (i as f64 - (count as f64 - 1.0) / 2.0) * pitch;
    (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (row, column)))
        .map(|(row, column)| {
            Point2::new(
                center.x + offset(column, columns),
                center.y + offset(row, rows),
            )
        })
        .filter(|&node| space.is_free(node))
        .collect()
}

/// Number of square cells of this pitch [m] in the surface's bounding box, free or not.
pub(super) fn cell_count(space: &FreeSpace, pitch: f64) -> usize {
    let bounds = Bounds2::from_points(space.surface().outline.outer().iter().copied());
    bounds.map_or(0, |bounds| shape(&bounds, pitch).iter().product())
}

/// Number of cells along x and along y.
fn shape(bounds: &Bounds2, pitch: f64) -> [usize; 2] {
    let cells = |length: f64| ((length / pitch) as usize).max(1);
    [cells(bounds.size().x), cells(bounds.size().y)]
}
