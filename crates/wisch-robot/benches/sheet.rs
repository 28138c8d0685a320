//! Charts of meshes of 10,000 and of 1,000,000 triangles.

use divan::{Bencher, black_box};
use wisch_robot::geometry::{Mesh, Point3, Sheet, SheetConfig};

fn main() {
    divan::main();
}

/// Returns a bulging panel of 1.0 × 0.6 m of this number of triangles.
fn panel(triangles: u32) -> Mesh {
    let rows = (f64::from(triangles) * 0.3).sqrt() as u32;
    let columns = triangles / (2 * rows);
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    let vertices = (0..=rows)
        .flat_map(|j| (0..=columns).map(move |i| (i, j)))
        .map(|(i, j)| {
            let x = f64::from(i) / f64::from(columns) - 0.5;
            let y = 0.6 * f64::from(j) / f64::from(rows) - 0.3;
            Point3::new(x, y, -x * x / 8.0 - y * y / 2.4)
        })
        .collect();
    let triangles = (0..rows)
        .flat_map(|j| (0..columns).map(move |i| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Mesh::new(vertices, triangles).unwrap()
}

#[divan::bench(args = [10_000, 1_000_000], sample_count = 3)]
fn make_sheet(bencher: Bencher, triangles: u32) {
    let mesh = panel(triangles);
    bencher.bench(|| Sheet::from_mesh(black_box(&mesh), &SheetConfig::default()));
}
