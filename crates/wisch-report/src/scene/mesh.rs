//! Meshes for a page: fewer triangles where there are too many.

use std::collections::BTreeMap;
use wisch::geometry::{Mesh, Point3};

/// Cells along the longest side with which thinning begins.
const FINEST: f64 = 256.0;

/// A mesh as it is embedded.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Thinned {
    pub(crate) vertices: Vec<Point3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// At most `most` triangles (at least 12) of about the same shape: vertices that share a cell of a
/// grid become their mean, and the grid is coarsened until it suffices (Rossignac and Borrel, 1993).
pub(crate) fn thinned(mesh: &Mesh, most: usize) -> Thinned {
    let mut thinned = Thinned {
        vertices: mesh.vertices().to_vec(),
        triangles: mesh.triangles().to_vec(),
    };
    let mut cells = FINEST;
    while thinned.triangles.len() > most.max(12) && cells >= 1.0 {
        thinned = clustered(mesh, mesh.extent() / cells);
        cells *= 0.7;
    }
    thinned
}

fn clustered(mesh: &Mesh, cell: f64) -> Thinned {
    let low = mesh.bounds().0;
    let mut clusters: BTreeMap<[i64; 3], (u32, Point3, f64)> = BTreeMap::new();
    let mut cluster_of = Vec::with_capacity(mesh.vertices().len());
    for vertex in mesh.vertices() {
        let key = [0, 1, 2].map(|i| ((vertex[i] - low[i]) / cell).floor() as i64);
        let index = clusters.len() as u32;
        let (index, sum, count) = clusters
            .entry(key)
            .or_insert((index, Point3::origin(), 0.0));
        sum.coords += vertex.coords;
        *count += 1.0;
        cluster_of.push(*index);
    }
    let mut vertices = vec![Point3::origin(); clusters.len()];
    for (index, sum, count) in clusters.into_values() {
        vertices[index as usize] = sum / count;
    }
    let moved = |corners: &[u32; 3]| corners.map(|corner| cluster_of[corner as usize]);
    let mut triangles: Vec<[u32; 3]> = mesh
        .triangles()
        .iter()
        .map(moved)
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    // Folded together, several triangles may have become the same.
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
    use wisch::geometry::Vector3;

    #[test]
    fn a_thinned_mesh_keeps_its_size() {
        let ball = Mesh::sphere(0.2, 200).expect("a ball");
        let thin = thinned(&ball, 900);
        assert!(thin.triangles.len() <= 900 && thin.triangles.len() > 300);
        for vertex in &thin.vertices {
            // A cell's mean lies within the ball, by no more than the height of a cap as wide as a cell.
            assert!(vertex.coords.norm() < 0.2 + 1e-9 && vertex.coords.norm() > 0.19);
        }
        let cuboid = Mesh::cuboid(Vector3::new(0.1, 0.2, 0.3)).expect("a box");
        assert_eq!(thinned(&cuboid, 900).triangles, cuboid.triangles());
    }
}
