//! Sparse symmetric linear systems of a triangle mesh: L D Lᵀ in an order by nested dissection.

use crate::geometry::Point2;

/// Number of vertices that are no longer divided.
const LEAF: usize = 24;

/// A factorised symmetric positive definite matrix.
pub(super) struct Factor {
    /// Vertex at each row.
    order: Vec<u32>,
    /// Ranges of `rows` and `values` by column of L.
    starts: Vec<usize>,
    rows: Vec<u32>,
    values: Vec<f64>,
    diagonal: Vec<f64>,
}

/// A symmetric matrix: the diagonal, and the entries beside it by vertex in ascending order.
pub(super) struct SymmetricMatrix {
    pub(super) diagonal: Vec<f64>,
    pub(super) beside: Vec<Vec<(u32, f64)>>,
}

impl Factor {
    /// Factorises a matrix whose vertices lie at `places`, which decide on the order only.
    ///
    /// Row by row along the elimination tree (Davis, *Algorithm 849: A Concise Sparse Cholesky Factorization Package*,
    /// 2005).
    pub(super) fn new(matrix: &SymmetricMatrix, places: &[Point2]) -> Self {
        let order = dissect(matrix, places);
        let count = order.len();
        let mut row_of = vec![0u32; count];
        for (row, &vertex) in (0u32..).zip(&order) {
            row_of[vertex as usize] = row;
        }
        let before = |row: usize| {
            let entries = matrix.beside[order[row] as usize].iter();
            entries
                .map(|&(vertex, value)| (row_of[vertex as usize] as usize, value))
                .filter(move |&(column, _)| column < row)
        };
        // The tree, and the number of entries of each column.
        const NONE: usize = usize::MAX;
        let (mut parent, mut mark) = (vec![NONE; count], vec![NONE; count]);
        let mut lengths = vec![0usize; count];
        for row in 0..count {
            mark[row] = row;
            for (column, _) in before(row) {
                let mut at = column;
                while mark[at] != row {
                    if parent[at] == NONE {
                        parent[at] = row;
                    }
                    lengths[at] += 1;
                    mark[at] = row;
                    at = parent[at];
                }
            }
        }
        let mut starts = vec![0; count + 1];
        for i in 0..count {
            starts[i + 1] = starts[i] + lengths[i];
        }
        let (mut rows, mut values) = (vec![0u32; starts[count]], vec![0f64; starts[count]]);
        let (mut diagonal, mut work) = (vec![0f64; count], vec![0f64; count]);
        let mut filled = vec![0usize; count];
        let (mut pattern, mut path): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        mark.fill(NONE);
        for row in 0..count {
            mark[row] = row;
            pattern.clear();
            for (column, value) in before(row) {
                work[column] += value;
                path.clear();
                let mut at = column;
                while mark[at] != row {
                    path.push(at);
                    mark[at] = row;
                    at = parent[at];
                }
                pattern.extend(path.iter().rev());
            }
            let mut pivot = matrix.diagonal[order[row] as usize];
            // From the last path backwards, which is a topological order.
            for &column in pattern.iter().rev() {
                let value = std::mem::take(&mut work[column]);
                let begin = starts[column];
                for k in begin..begin + filled[column] {
                    work[rows[k] as usize] -= values[k] * value;
                }
                let entry = value / diagonal[column];
                pivot -= entry * value;
                let end = begin + filled[column];
                (rows[end], values[end]) = (row as u32, entry);
                filled[column] += 1;
            }
            // Rounding must not turn a pivot of zero negative.
            diagonal[row] = pivot
                .max(1e-14 * matrix.diagonal[order[row] as usize].abs())
                .max(f64::MIN_POSITIVE);
        }
        Self {
            order,
            starts,
            rows,
            values,
            diagonal,
        }
    }

    /// Solves the system for two right-hand sides by vertex, in place.
    pub(super) fn solve(&self, right: &mut [[f64; 2]]) {
        let mut x: Vec<[f64; 2]> = self.order.iter().map(|&i| right[i as usize]).collect();
        for column in 0..x.len() {
            let [a, b] = x[column];
            for k in self.starts[column]..self.starts[column + 1] {
                let target = &mut x[self.rows[k] as usize];
                target[0] -= self.values[k] * a;
                target[1] -= self.values[k] * b;
            }
        }
        for column in (0..x.len()).rev() {
            let [mut a, mut b] = x[column].map(|value| value / self.diagonal[column]);
            for k in self.starts[column]..self.starts[column + 1] {
                let known = x[self.rows[k] as usize];
                a -= self.values[k] * known[0];
                b -= self.values[k] * known[1];
            }
            x[column] = [a, b];
        }
        for (&vertex, value) in self.order.iter().zip(x) {
            right[vertex as usize] = value;
        }
    }
}

/// Returns the vertices in an order of little fill-in: those on both sides of a cut before those on the cut (George, 1973).
fn dissect(matrix: &SymmetricMatrix, places: &[Point2]) -> Vec<u32> {
    let mut order = Vec::with_capacity(places.len());
    // Half in which a vertex lies, by the number of the cut.
    let mut half = vec![0u64; places.len()];
    let mut cuts = 0;
    // Groups from the last to the first of the order; a cut is ordered as it is.
    let mut open = vec![((0..places.len() as u32).collect::<Vec<u32>>(), false)];
    while let Some((mut group, is_cut)) = open.pop() {
        if is_cut || group.len() <= LEAF {
            order.extend(group.iter().rev());
            continue;
        }
        let extent = |axis: usize| {
            let values = group.iter().map(|&i| places[i as usize][axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            });
            high - low
        };
        let axis = usize::from(extent(1) > extent(0));
        let by_place = |one: &u32, other: &u32| {
            let [a, b] = [one, other].map(|i| places[*i as usize][axis]);
            a.total_cmp(&b).then(one.cmp(other))
        };
        let middle = group.len() / 2;
        group.select_nth_unstable_by(middle, by_place);
        let mut upper = group.split_off(middle);
        group.sort_unstable();
        upper.sort_unstable();
        cuts += 2;
        group.iter().for_each(|&i| half[i as usize] = cuts);
        upper.iter().for_each(|&i| half[i as usize] = cuts + 1);
        let touches = |i: &u32| {
            let mut beside = matrix.beside[*i as usize].iter();
            beside.any(|&(other, _)| half[other as usize] == cuts + 1)
        };
        let (cut, lower): (Vec<u32>, Vec<u32>) = group.into_iter().partition(touches);
        // The cut is last in elimination: it is pushed on top, because the order is reversed in the end.
        open.push((lower, false));
        open.push((upper, false));
        open.push((cut, true));
    }
    order.reverse();
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_of_resistors_is_solved() {
        let side = 23u32;
        let at = |x: u32, y: u32| y * side + x;
        let count = (side * side) as usize;
        let mut matrix = SymmetricMatrix {
            diagonal: vec![1e-3; count],
            beside: vec![Vec::new(); count],
        };
        let mut link = |a: u32, b: u32, weight: f64| {
            for (from, to) in [(a, b), (b, a)] {
                matrix.beside[from as usize].push((to, -weight));
                matrix.diagonal[from as usize] += weight;
            }
        };
        for y in 0..side {
            for x in 0..side {
                if x + 1 < side {
                    link(at(x, y), at(x + 1, y), 1.0 + 0.1 * f64::from(y));
                }
                if y + 1 < side {
                    link(at(x, y), at(x, y + 1), 2.0 - 0.05 * f64::from(x));
                }
            }
        }
        let places: Vec<Point2> = (0..side * side)
            .map(|i| Point2::new(f64::from(i % side), f64::from(i / side)))
            .collect();
        let expected: Vec<[f64; 2]> = (places.iter())
            .map(|p| [p.x * p.y - 3.0, (7.0 * p.x).rem_euclid(5.0)])
            .collect();
        let mut right: Vec<[f64; 2]> = (0..count)
            .map(|i| {
                [0, 1].map(|k| {
                    let beside = matrix.beside[i].iter();
                    matrix.diagonal[i] * expected[i][k]
                        + beside
                            .map(|&(j, w)| w * expected[j as usize][k])
                            .sum::<f64>()
                })
            })
            .collect();
        let factor = Factor::new(&matrix, &places);
        factor.solve(&mut right);
        for (found, expected) in right.iter().zip(&expected) {
            for k in 0..2 {
                assert!(
                    (found[k] - expected[k]).abs() < 1e-8,
                    "{found:?} {expected:?}"
                );
            }
        }
        // Nested dissection fills O(n log n) entries: about 31/4 n log2 n (George, 1973).
        let bound = 7.75 * count as f64 * (count as f64).log2();
        assert!(
            (factor.values.len() as f64) < bound,
            "{} entries",
            factor.values.len()
        );
    }
}
