//! Repair of a mesh's connections: vertices that nearly coincide, repeated triangles, vertices within a neighbour's edge.

use super::topology::Triangles;
use crate::geometry::{Mesh, Point3, Vector3};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Largest distance between vertices that become one, relative to the diagonal of the mesh [1]: above the rounding of
/// single precision.
const WELD_TOLERANCE: f64 = 1e-6;
/// Rounds of splitting edges at vertices that lie on them.
const MAX_SPLIT_ROUNDS: usize = 4;

/// Counts of the changes that the repair of a mesh made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshRepairs {
    /// Vertices that were merged into another.
    pub welded: usize,
    /// Triangles without area or without three different vertices, or equal to another.
    pub dropped: usize,
    /// Edges of one triangle on which a vertex of a neighbour lies, and that were split there.
    pub split: usize,
}

/// Returns the mesh with its vertices and triangles in an order that depends on the coordinates alone, welded and
/// repaired.
pub(super) fn weld(mesh: &Mesh) -> (Triangles, MeshRepairs) {
    let (low, high) = mesh.bounds();
    let tolerance = WELD_TOLERANCE * (high - low).norm();
    // Sorted by x, then y, then z: results do not depend on the order in the file.
    let mut order: Vec<u32> = (0..mesh.vertices().len() as u32).collect();
    let key = |i: u32| {
        let p = mesh.vertices()[i as usize];
        [p.x + 0.0, p.y + 0.0, p.z + 0.0]
    };
    order.sort_by(|&a, &b| {
        let [a, b] = [key(a), key(b)];
        (a[0].total_cmp(&b[0]))
            .then(a[1].total_cmp(&b[1]))
            .then(a[2].total_cmp(&b[2]))
    });
    let mut repairs = MeshRepairs::default();
    let mut result = Triangles::default();
    let mut number = vec![0u32; order.len()];
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    // Cells much larger than the tolerance: most points have all near ones in their own.
    let side = (64.0 * tolerance).max(f64::MIN_POSITIVE);
    let cell_of = |p: Point3| [p.x, p.y, p.z].map(|c| (c / side).floor() as i64);
    let reach = Vector3::repeat(tolerance);
    for vertex in order {
        let point = mesh.vertices()[vertex as usize];
        let [low, high] = [cell_of(point - reach), cell_of(point + reach)];
        let near = vertices_in(&cells, low, high)
            .filter(|&i| (result.vertices[i as usize] - point).norm() <= tolerance)
            .min();
        number[vertex as usize] = if let Some(known) = near {
            repairs.welded += usize::from(result.vertices[known as usize] != point);
            known
        } else {
            let new = result.vertices.len() as u32;
            result.vertices.push(point);
            cells.entry(cell_of(point)).or_default().push(new);
            new
        };
    }
    let mut seen = BTreeSet::new();
    for corners in mesh.triangles() {
        let [a, b, c] = corners.map(|i| number[i as usize]);
        // The smallest corner comes first.
        let corners = match a.min(b).min(c) {
            least if least == a => [a, b, c],
            least if least == b => [b, c, a],
            _ => [c, a, b],
        };
        let mut set = corners;
        set.sort_unstable();
        if a == b || b == c || c == a || !seen.insert(set) {
            repairs.dropped += 1;
        } else {
            result.triangles.push(corners);
        }
    }
    repairs.dropped += drop_slivers(&mut result, tolerance);
    result.triangles.sort_unstable();
    for _ in 0..MAX_SPLIT_ROUNDS {
        let split = split_at_neighbours(&mut result, tolerance);
        repairs.split += split;
        if split == 0 {
            break;
        }
    }
    (result, repairs)
}

/// Removes triangles whose height is within the tolerance, so that rounding decides on which side they lie; returns their
/// number. Where neighbours meet along the longest side, the vertex opposite to it then lies on their edge. A mesh of such
/// triangles alone keeps them.
fn drop_slivers(mesh: &mut Triangles, tolerance: f64) -> usize {
    let is_sliver = |&triangle: &[u32; 3]| {
        let [a, b, c] = mesh.corners(triangle);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        mesh.doubled_normal(triangle).norm() <= tolerance * longest
    };
    let kept: Vec<[u32; 3]> = (mesh.triangles.iter().copied())
        .filter(|triangle| !is_sliver(triangle))
        .collect();
    if kept.is_empty() {
        return 0;
    }
    let dropped = mesh.triangles.len() - kept.len();
    mesh.triangles = kept;
    dropped
}

/// Iterates over the vertices of the cells from `low` to `high`.
fn vertices_in(
    cells: &HashMap<[i64; 3], Vec<u32>>,
    low: [i64; 3],
    high: [i64; 3],
) -> impl Iterator<Item = u32> + '_ {
    let along = move |axis: usize| low[axis]..=high[axis];
    along(0)
        .flat_map(move |x| along(1).flat_map(move |y| along(2).map(move |z| [x, y, z])))
        .filter_map(|cell| cells.get(&cell))
        .flatten()
        .copied()
}

/// Splits border edges at border vertices that lie within them; returns the number of edges.
fn split_at_neighbours(mesh: &mut Triangles, tolerance: f64) -> usize {
    let sides = mesh.sides();
    let border: Vec<_> = (sides.chunk_by(|one, other| one.edge == other.edge))
        .filter(|group| group.len() == 1)
        .map(|group| group[0])
        .collect();
    let ends: BTreeSet<u32> = border.iter().flat_map(|side| side.edge).collect();
    let length = |edge: [u32; 2]| {
        let [a, b] = edge.map(|i| mesh.vertices[i as usize]);
        (b - a).norm()
    };
    let total: f64 = border.iter().map(|side| length(side.edge)).sum();
    let cell = (total / border.len().max(1) as f64).max(4.0 * tolerance);
    if cell <= 0.0 {
        return 0;
    }
    let cell_of = |p: Point3| [p.x, p.y, p.z].map(|c| (c / cell).floor() as i64);
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    for &i in &ends {
        cells
            .entry(cell_of(mesh.vertices[i as usize]))
            .or_default()
            .push(i);
    }
    // At most one side of a triangle is split in a round.
    let mut splits: BTreeMap<u32, (u8, Vec<u32>)> = BTreeMap::new();
    for side in &border {
        let [a, b] = side.edge.map(|i| mesh.vertices[i as usize]);
        let along = b - a;
        let steps = (along.norm() / cell).ceil().max(1.0) as usize;
        let mut on_edge: Vec<(f64, u32)> = Vec::new();
        for step in 0..=steps {
            let at = cell_of(a + along * (step as f64 / steps as f64));
            let [low, high] = [-1, 1].map(|offset| at.map(|c| c.saturating_add(offset)));
            for i in vertices_in(&cells, low, high) {
                let from_a = mesh.vertices[i as usize] - a;
                let t = from_a.dot(&along) / along.norm_squared();
                if !side.edge.contains(&i)
                    && t > 0.0
                    && t < 1.0
                    && (from_a - along * t).norm() <= tolerance
                {
                    on_edge.push((t, i));
                }
            }
        }
        if !on_edge.is_empty() {
            on_edge.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
            on_edge.dedup();
            let split = on_edge.into_iter().map(|(_, i)| i).collect();
            splits.entry(side.triangle).or_insert((side.side, split));
        }
    }
    for (&triangle, (side, inner)) in &splits {
        let corners = mesh.triangles[triangle as usize];
        let side = usize::from(*side);
        let [from, to, tip] = [0, 1, 2].map(|k| corners[(side + k) % 3]);
        if inner.contains(&tip) {
            continue;
        }
        let mut line = vec![from];
        if from < to {
            line.extend(inner);
        } else {
            line.extend(inner.iter().rev());
        }
        line.push(to);
        for (k, pair) in line.windows(2).enumerate() {
            let part = [pair[0], pair[1], tip];
            if k == 0 {
                mesh.triangles[triangle as usize] = part;
            } else {
                mesh.triangles.push(part);
            }
        }
    }
    splits.len()
}
