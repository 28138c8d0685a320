//! Meshes for a page, with a limited number of triangles.

use nalgebra::Matrix3;
use std::collections::BTreeMap;
use wisch::geometry::{Mesh, Point3, Vector3};

/// Number of cells along the longest side in the first grid.
const FINEST: f64 = 256.0;
/// Ratio of the cells of a grid to those of the grid before [1].
const COARSER: f64 = 0.88;
/// Weight that pulls a vertex to the mean of its cell, relative to the planes [1].
const PULL: f64 = 1e-3;

/// A mesh for embedding.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Thinned {
    pub(crate) vertices: Vec<Point3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Reduces a mesh to at most `most` (at least 12) triangles of about the same shape (Lindstrom, 2000). Vertices that share a
/// grid cell are merged at the point nearest to the planes of their triangles; the grid is coarsened until the limit holds.
pub(crate) fn resample(mesh: &Mesh, most: usize) -> Thinned {
    let mut thinned = Thinned {
        vertices: mesh.vertices().to_vec(),
        triangles: mesh.triangles().to_vec(),
    };
    if thinned.triangles.len() <= most.max(12) {
        return thinned;
    }
    let planes = collect_vertex_planes(mesh);
    let mut cells = FINEST;
    while thinned.triangles.len() > most.max(12) && cells >= 1.0 {
        thinned = cluster_vertices(mesh, &planes, mesh.extent() / cells);
        cells *= COARSER;
    }
    thinned
}

/// The squared distance of a point x to the planes of triangles, weighted by area: the sum of area (n·x - offset)².
#[derive(Debug, Clone, Copy, Default)]
struct Planes {
    /// Sum of area n nᵀ.
    normals: Matrix3<f64>,
    /// Sum of area offset n.
    offsets: Vector3,
}

impl Planes {
    fn add(&mut self, other: &Self) {
        self.normals += other.normals;
        self.offsets += other.offsets;
    }

    /// Returns the point nearest to the planes, with a weak pull to `mean`, which decides on flat parts.
    fn nearest(&self, mean: Point3) -> Option<Point3> {
        let pull = PULL * self.normals.trace();
        let matrix = self.normals + Matrix3::from_diagonal_element(pull);
        let solution = matrix
            .cholesky()?
            .solve(&(self.offsets + mean.coords * pull));
        Some(Point3::from(solution))
    }
}

/// Returns the planes of the triangles at each vertex.
fn collect_vertex_planes(mesh: &Mesh) -> Vec<Planes> {
    let mut planes = vec![Planes::default(); mesh.vertices().len()];
    for (corners, [a, b, c]) in mesh.triangles().iter().zip(mesh.corners()) {
        let across = (b - a).cross(&(c - a));
        let area = across.norm();
        if area == 0.0 {
            continue;
        }
        let normal = across / area;
        let plane = Planes {
            normals: normal * normal.transpose() * area,
            offsets: normal * (normal.dot(&a.coords) * area),
        };
        for &corner in corners {
            planes[corner as usize].add(&plane);
        }
    }
    planes
}

/// The vertices of a cell.
#[derive(Default)]
struct Cluster {
    index: u32,
    sum: Vector3,
    count: f64,
    planes: Planes,
}

fn cluster_vertices(mesh: &Mesh, planes: &[Planes], cell: f64) -> Thinned {
    let low = mesh.bounds().0;
    let mut clusters: BTreeMap<[i64; 3], Cluster> = BTreeMap::new();
    let mut cluster_of = Vec::with_capacity(mesh.vertices().len());
    for (vertex, planes) in mesh.vertices().iter().zip(planes) {
        let key = [0, 1, 2].map(|i| ((vertex[i] - low[i]) / cell).floor() as i64);
        let index = clusters.len() as u32;
        let cluster = clusters.entry(key).or_insert_with(|| Cluster {
            index,
            ..Cluster::default()
        });
        cluster.sum += vertex.coords;
        cluster.count += 1.0;
        cluster.planes.add(planes);
        cluster_of.push(cluster.index);
    }
    let mut vertices = vec![Point3::origin(); clusters.len()];
    for (key, cluster) in clusters {
        let mean = Point3::from(cluster.sum / cluster.count);
        let near = cluster.planes.nearest(mean).unwrap_or(mean);
        // A vertex stays in its cell, so that no two vertices swap.
        let kept = [0, 1, 2].map(|i| {
            let from = low[i] + key[i] as f64 * cell;
            near[i].clamp(from, from + cell)
        });
        vertices[cluster.index as usize] = Point3::from(kept);
    }
    let moved = |corners: &[u32; 3]| corners.map(|corner| cluster_of[corner as usize]);
    let mut triangles: Vec<[u32; 3]> = mesh
        .triangles()
        .iter()
        .map(moved)
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    // Merging can make triangles equal.
    triangles.sort_unstable();
    triangles.dedup();
    Thinned {
        vertices,
        triangles,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thinned_mesh_keeps_its_size() {
        let ball = Mesh::sphere(0.2, 200).expect("a ball");
        let thin = resample(&ball, 900);
        assert!(thin.triangles.len() <= 900 && thin.triangles.len() > 300);
        for vertex in &thin.vertices {
            assert!((vertex.coords.norm() - 0.2).abs() < 0.002, "{vertex}");
        }
        // Corners stay where they are, however coarse the grid.
        let mut fine = Mesh::cuboid(Vector3::new(0.1, 0.2, 0.3)).expect("a box");
        for _ in 0..4 {
            fine = subdivide(&fine);
        }
        let thin = resample(&fine, 300);
        assert!(thin.triangles.len() <= 300, "{}", thin.triangles.len());
        let far = thin
            .vertices
            .iter()
            .map(|v| v.coords.norm())
            .fold(0.0, f64::max);
        let corner = Vector3::new(0.05, 0.1, 0.15).norm();
        assert!((far - corner).abs() < 0.003, "{far} {corner}");
        let cuboid = Mesh::cuboid(Vector3::new(0.1, 0.2, 0.3)).expect("a box");
        assert_eq!(resample(&cuboid, 900).triangles, cuboid.triangles());
    }

    /// Splits each triangle into four.
    fn subdivide(mesh: &Mesh) -> Mesh {
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for [a, b, c] in mesh.corners() {
            let first = vertices.len() as u32;
            let middle = |p: Point3, q: Point3| nalgebra::center(&p, &q);
            vertices.extend([a, b, c, middle(a, b), middle(b, c), middle(c, a)]);
            for corners in [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]] {
                triangles.push(corners.map(|corner| first + corner));
            }
        }
        Mesh::new(vertices, triangles).expect("a mesh")
    }
}
