//! Map of the residuals of a fit: distances of the contacts from the fitted surface, by place.

use crate::geometry::Point2;
use std::collections::BTreeMap;

/// Side of the square cells of the map \[m\].
pub const RESIDUAL_CELL: f64 = 0.02;

/// Median distance of the contacts in a cell of the chart from the fitted surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactResidual {
    /// Middle of the cell in the chart \[m\].
    pub place: Point2,
    /// Median height of the contacts over the fitted surface \[m\].
    pub height: f64,
    /// Number of contacts.
    pub contacts: usize,
}

/// Returns the cells with contacts, row by row. `contacts`: place and height over the fitted surface \[m\].
pub(super) fn map_residuals(
    contacts: impl IntoIterator<Item = (Point2, f64)>,
) -> Vec<ContactResidual> {
    let mut cells: BTreeMap<[i64; 2], Vec<f64>> = BTreeMap::new();
    for (place, height) in contacts {
        let cell = [place.y, place.x].map(|at| (at / RESIDUAL_CELL).floor() as i64);
        cells.entry(cell).or_default().push(height);
    }
    let residual = |([row, column], mut heights): ([i64; 2], Vec<f64>)| {
        heights.sort_unstable_by(f64::total_cmp);
        let middle = |cell: i64| (cell as f64 + 0.5) * RESIDUAL_CELL;
        ContactResidual {
            place: Point2::new(middle(column), middle(row)),
            height: heights[heights.len() / 2],
            contacts: heights.len(),
        }
    };
    cells.into_iter().map(residual).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_has_the_median_of_each_cell() {
        let contacts = [
            ([0.001, 0.001], 1e-4),
            ([0.019, 0.002], 3e-4),
            ([0.004, 0.019], 0.02),
            ([-0.001, 0.001], -2e-4),
            ([0.001, 0.021], 5e-4),
        ];
        let contacts = contacts.map(|([x, y], height)| (Point2::new(x, y), height));
        let found = map_residuals(contacts).into_iter();
        let found: Vec<_> = found
            .map(|cell| ([cell.place.x, cell.place.y], cell.height, cell.contacts))
            .collect();
        assert_eq!(
            found,
            [
                ([-0.01, 0.01], -2e-4, 1),
                ([0.01, 0.01], 3e-4, 3),
                ([0.01, 0.03], 5e-4, 1),
            ]
        );
    }
}
