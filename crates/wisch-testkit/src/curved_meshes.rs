//! Meshes of curved surfaces, with the tool above them.

use wisch::geometry::{Mesh, Point2, Point3};

/// A mesh of a shipped scenario.
pub struct ScenarioMesh {
    /// Name of its file in `scenarios/meshes`.
    pub file_name: &'static str,
    /// The mesh.
    pub mesh: Mesh,
}

/// Returns the mesh of a surface over a rectangle about the origin of its parameters, with its triangles turned upwards where
/// `point` keeps x and y.
///
/// - `cells`: numbers of squares along x and y, each of two triangles.
/// - `sides`: sides of the rectangle \[m\].
pub fn mesh_over(cells: [u32; 2], sides: [f64; 2], point: impl Fn(Point2) -> Point3) -> Mesh {
    let [columns, rows] = cells;
    let place = |i: u32, j: u32| {
        let [x, y] = [(i, columns), (j, rows)].map(|(i, n)| f64::from(i) / f64::from(n) - 0.5);
        Point2::new(x * sides[0], y * sides[1])
    };
    let vertices = (0..=rows).flat_map(|j| (0..=columns).map(move |i| place(i, j)));
    let triangles = (0..rows).flat_map(|row| {
        (0..columns).flat_map(move |column| {
            let a = row * (columns + 1) + column;
            let above = a + columns + 1;
            [[a, a + 1, above + 1], [a, above + 1, above]]
        })
    });
    Mesh::new(vertices.map(point).collect(), triangles.collect()).unwrap()
}

/// A cylinder along y of this radius \[m\], over 0.6 × 0.4 m: a bulge, or a hollow for a negative radius.
pub fn pipe(radius: f64) -> Mesh {
    mesh_over([60, 40], [0.6, 0.4], |p| {
        let angle = p.x / radius;
        Point3::new(radius * angle.sin(), p.y, radius * (angle.cos() - 1.0))
    })
}

/// The saddle z = (x² − y²)/2R with R = 0.5 m, over 0.4 × 0.3 m: a larger one needs two charts.
pub fn saddle() -> Mesh {
    mesh_over([40, 30], [0.4, 0.3], |p| {
        Point3::new(p.x, p.y, p.x * p.x - p.y * p.y)
    })
}

/// A car door of 1.0 × 0.6 m in 9,600 triangles: barrels of 4 m and 1.2 m radius, with a crease of 6 mm over 20 mm.
pub fn door() -> Mesh {
    let crease = |p: Point2| 0.006 * ((p.y - 0.05 - 0.1 * p.x) / 0.02).tanh();
    mesh_over([80, 60], [1.0, 0.6], |p| barrels(p, crease(p)))
}

/// Two barrels across each other, of 4 m radius along x and 1.2 m along y, with an additional height \[m\].
fn barrels(p: Point2, height: f64) -> Point3 {
    Point3::new(p.x, p.y, height - p.x * p.x / 8.0 - p.y * p.y / 2.4)
}

/// Returns the meshes of the shipped scenarios. `cargo run -p wisch-testkit --example scenario_meshes` writes their files.
pub fn scenario_meshes() -> [ScenarioMesh; 2] {
    let crease = |p: Point2| 0.004 * ((p.y - 0.04 - 0.1 * p.x) / 0.02).tanh();
    [
        // The side of a wash basin: hollows of 0.6 m and 0.8 m radius.
        ScenarioMesh {
            file_name: "basin.stl",
            mesh: mesh_over([30, 24], [0.30, 0.24], |p| {
                Point3::new(p.x, p.y, p.x * p.x / 1.2 + p.y * p.y / 1.6)
            }),
        },
        ScenarioMesh {
            file_name: "car-door.stl",
            mesh: mesh_over([36, 30], [0.60, 0.36], |p| barrels(p, crease(p))),
        },
    ]
}
