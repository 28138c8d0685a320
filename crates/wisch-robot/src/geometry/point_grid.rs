//! Spatial hash of points in square cells, for neighbour queries.

use super::Point2;
use std::collections::HashMap;

/// Numbered points in the square cells of a plane; a query costs in proportion to the nearby points.
///
/// Results depend on the points alone, not on the storage order of the cells.
#[derive(Debug, Clone)]
pub struct PointGrid {
    cell: f64,
    cells: HashMap<[i64; 2], Vec<(usize, Point2)>>,
    /// Least and largest cell that ever held a point.
    bounds: [[i64; 2]; 2],
    count: usize,
}

impl PointGrid {
    /// Returns an empty grid with cells of this side \[m\], which is best near the query distances.
    pub fn new(cell: f64) -> Self {
        Self {
            cell: if cell.is_normal() { cell.abs() } else { 1.0 },
            cells: HashMap::new(),
            bounds: [[i64::MAX; 2], [i64::MIN; 2]],
            count: 0,
        }
    }

    /// Returns a grid of these points, numbered from 0.
    pub fn from_points(points: &[Point2], cell: f64) -> Self {
        let mut grid = Self::new(cell);
        for (number, &point) in points.iter().enumerate() {
            grid.insert(number, point);
        }
        grid
    }

    /// Number of points in the grid.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the grid holds no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds a point with its number.
    pub fn insert(&mut self, number: usize, point: Point2) {
        let cell = self.cell_of(point);
        let [low, high] = &mut self.bounds;
        for ((low, high), at) in low.iter_mut().zip(high).zip(cell) {
            *low = (*low).min(at);
            *high = (*high).max(at);
        }
        self.cells.entry(cell).or_default().push((number, point));
        self.count += 1;
    }

    /// Removes the point of this number; `point` is its position.
    pub fn remove(&mut self, number: usize, point: Point2) {
        if let Some(held) = self.cells.get_mut(&self.cell_of(point))
            && let Some(at) = held.iter().position(|(known, _)| *known == number)
        {
            held.swap_remove(at);
            self.count -= 1;
        }
    }

    /// Removes every point at most `radius` from a place \[m\], and returns their numbers in ascending order.
    pub fn remove_within(&mut self, place: Point2, radius: f64) -> Vec<usize> {
        let mut removed = Vec::new();
        for cell in self.cells_within(place, radius) {
            if let Some(held) = self.cells.get_mut(&cell) {
                held.retain(|(number, point)| {
                    let is_near = (point - place).norm() <= radius;
                    if is_near {
                        removed.push(*number);
                    }
                    !is_near
                });
            }
        }
        self.count -= removed.len();
        removed.sort_unstable();
        removed
    }

    /// Whether a point at most `radius` from a place \[m\] meets the condition.
    pub fn has_within(
        &self,
        place: Point2,
        radius: f64,
        mut is_asked_for: impl FnMut(usize, Point2) -> bool,
    ) -> bool {
        self.cells_within(place, radius)
            .filter_map(|cell| self.cells.get(&cell))
            .flatten()
            .any(|&(number, point)| (point - place).norm() <= radius && is_asked_for(number, point))
    }

    /// Calls `call` with every point at most `radius` from a place \[m\], in arbitrary order.
    pub fn visit_within(&self, place: Point2, radius: f64, mut call: impl FnMut(usize, Point2)) {
        self.has_within(place, radius, |number, point| {
            call(number, point);
            false
        });
    }

    /// Returns the number of the nearest point at most `radius` from a place \[m\]; the least number among equally near
    /// points. If more than `most` points are in range, only `most` of them are compared, which bounds the cost of
    /// crowds.
    pub fn nearest_within(&self, place: Point2, radius: f64, most: usize) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        let mut met = 0;
        self.has_within(place, radius, |number, point| {
            let found = ((point - place).norm(), number);
            if best.is_none_or(|best| found < best) {
                best = Some(found);
            }
            met += 1;
            met == most
        });
        best.map(|(_, number)| number)
    }

    /// Returns the number of the point nearest to a place, the least among equally near ones; `None` if the grid is
    /// empty.
    pub fn nearest(&self, place: Point2) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        let mut take = |held: &[(usize, Point2)]| {
            for &(number, point) in held {
                let found = ((point - place).norm(), number);
                if best.is_none_or(|best| found < best) {
                    best = Some(found);
                }
            }
            best
        };
        let [x, y] = self.cell_of(place);
        let farthest = (0..2)
            .flat_map(|axis| [self.bounds[0][axis], self.bounds[1][axis]].map(|end| (axis, end)))
            .map(|(axis, end)| end.saturating_sub([x, y][axis]).saturating_abs())
            .max()
            .filter(|_| self.count > 0)?;
        let mut visited = 0;
        for ring in 0..=farthest {
            // All remaining points lie beyond the rings searched so far.
            if let Some((distance, number)) = take(&[])
                && distance < (ring - 1) as f64 * self.cell
            {
                return Some(number);
            }
            // In a sparse grid it is faster to visit the occupied cells.
            visited += 8 * ring;
            if visited as usize > self.cells.len() {
                let held = self.cells.values();
                return held
                    .fold(None, |_, held| take(held))
                    .map(|(_, number)| number);
            }
            for column in x - ring..=x + ring {
                let is_side = (column - x).abs() == ring;
                let step = if is_side || ring == 0 { 1 } else { 2 * ring };
                let mut row = y - ring;
                while row <= y + ring {
                    if let Some(held) = self.cells.get(&[column, row]) {
                        take(held);
                    }
                    row += step;
                }
            }
        }
        take(&[]).map(|(_, number)| number)
    }

    /// Iterates over the cells that a circle about a place may meet.
    fn cells_within(&self, place: Point2, radius: f64) -> impl Iterator<Item = [i64; 2]> + use<> {
        let [left, bottom] = self.cell_of(Point2::new(place.x - radius, place.y - radius));
        let [right, top] = self.cell_of(Point2::new(place.x + radius, place.y + radius));
        let [[first, lowest], [last, highest]] = self.bounds;
        let (left, right) = (left.max(first), right.min(last));
        let (bottom, top) = (bottom.max(lowest), top.min(highest));
        (left..=right).flat_map(move |column| (bottom..=top).map(move |row| [column, row]))
    }

    /// Cells beyond the range of an integer are merged; places on a surface never lie there.
    fn cell_of(&self, point: Point2) -> [i64; 2] {
        const MOST: f64 = 1e15;
        [point.x, point.y].map(|along| (along / self.cell).floor().clamp(-MOST, MOST) as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = Point2> {
        // Few values, so that many places are equally near.
        (-20..20_i32, -20..20_i32).prop_map(|(x, y)| Point2::new(f64::from(x), f64::from(y)))
    }

    proptest! {
        #[test]
        fn answers_are_those_of_looking_at_every_point(
            points in prop::collection::vec(place(), 0..60),
            gone in prop::collection::vec(0..60_usize, 0..30),
            at in place(),
            cell in 0.3..9.0_f64,
            radius in 0.0..12.0_f64,
        ) {
            let mut grid = PointGrid::from_points(&points, cell);
            let mut left: Vec<usize> = (0..points.len()).collect();
            for number in gone {
                if let Some(known) = left.iter().position(|left| *left == number) {
                    left.remove(known);
                    grid.remove(number, points[number]);
                }
            }
            prop_assert_eq!(grid.len(), left.len());
            let distance = |number: usize| (points[number] - at).norm();
            let nearest = left.iter().copied().min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            prop_assert_eq!(grid.nearest(at), nearest);
            let near_enough = nearest.filter(|&number| distance(number) <= radius);
            prop_assert_eq!(grid.nearest_within(at, radius, usize::MAX), near_enough);
            let near: Vec<usize> = left.iter().copied().filter(|&n| distance(n) <= radius).collect();
            let mut found = Vec::new();
            grid.visit_within(at, radius, |number, _| found.push(number));
            found.sort_unstable();
            prop_assert_eq!(&found, &near);
            prop_assert_eq!(grid.remove_within(at, radius), near);
            prop_assert!(!grid.has_within(at, radius, |_, _| true));
        }
    }
}
