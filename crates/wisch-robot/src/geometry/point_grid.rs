//! Points in square cells, to find those near a place.

use super::Point2;
use std::collections::HashMap;

/// Numbered points in the square cells of a plane; finding those near a place costs what lies near it.
///
/// Answers depend on the points alone, never on the order in which the cells are stored.
#[derive(Debug, Clone)]
pub struct PointGrid {
    cell: f64,
    cells: HashMap<[i64; 2], Vec<(usize, Point2)>>,
    /// Least and greatest cell that ever held a point.
    bounds: [[i64; 2]; 2],
    count: usize,
}

impl PointGrid {
    /// An empty grid with cells of this side [m], which is best about as long as the distances that are asked for.
    pub fn new(cell: f64) -> Self {
        Self {
            cell: if cell.is_normal() { cell.abs() } else { 1.0 },
            cells: HashMap::new(),
            bounds: [[i64::MAX; 2], [i64::MIN; 2]],
            count: 0,
        }
    }

    /// A grid of these points, numbered from 0.
    pub fn of(points: &[Point2], cell: f64) -> Self {
        let mut grid = Self::new(cell);
        for (number, &point) in points.iter().enumerate() {
            grid.insert(number, point);
        }
        grid
    }

    /// How many points it holds.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Adds a point under a number.
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

    /// Removes the point of this number, which lies here.
    pub fn remove(&mut self, number: usize, point: Point2) {
        if let Some(held) = self.cells.get_mut(&self.cell_of(point))
            && let Some(at) = held.iter().position(|(known, _)| *known == number)
        {
            held.swap_remove(at);
            self.count -= 1;
        }
    }

    /// Removes every point at most this far from a place [m], and returns their numbers in ascending order.
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

    /// Whether some point at most this far from a place [m] is one that is asked for.
    pub fn any_within(
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

    /// Calls with every point at most this far from a place [m], in no order.
    pub fn within(&self, place: Point2, radius: f64, mut call: impl FnMut(usize, Point2)) {
        self.any_within(place, radius, |number, point| {
            call(number, point);
            false
        });
    }

    /// The number of the nearest point at most this far from a place [m], of equally near ones the least. Where more than `most`
    /// points are so near, the nearest of some `most` of them: crowds cost no more than that.
    pub fn nearest_within(&self, place: Point2, radius: f64, most: usize) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        let mut met = 0;
        self.any_within(place, radius, |number, point| {
            let found = ((point - place).norm(), number);
            if best.is_none_or(|best| found < best) {
                best = Some(found);
            }
            met += 1;
            met == most
        });
        best.map(|(_, number)| number)
    }

    /// The number of the point nearest to a place, of equally near ones the least; `None` without any point.
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
            // All that is left to look at lies farther than the rings before reach.
            if let Some((distance, number)) = take(&[])
                && distance < (ring - 1) as f64 * self.cell
            {
                return Some(number);
            }
            // Where most cells are empty, it is shorter to look at those that are not.
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

    /// The cells that a circle about a place may meet.
    fn cells_within(&self, place: Point2, radius: f64) -> impl Iterator<Item = [i64; 2]> + use<> {
        let [left, bottom] = self.cell_of(Point2::new(place.x - radius, place.y - radius));
        let [right, top] = self.cell_of(Point2::new(place.x + radius, place.y + radius));
        let [[first, lowest], [last, highest]] = self.bounds;
        let (left, right) = (left.max(first), right.min(last));
        let (bottom, top) = (bottom.max(lowest), top.min(highest));
        (left..=right).flat_map(move |column| (bottom..=top).map(move |row| [column, row]))
    }

    /// Beyond what an integer holds, cells are joined; finite places of a surface never are.
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
            let mut grid = PointGrid::of(&points, cell);
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
            grid.within(at, radius, |number, _| found.push(number));
            found.sort_unstable();
            prop_assert_eq!(&found, &near);
            prop_assert_eq!(grid.remove_within(at, radius), near);
            prop_assert!(!grid.any_within(at, radius, |_, _| true));
        }
    }
}
