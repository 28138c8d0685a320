//! Meshes of curved surfaces.

use wisch::geometry::{Mesh, Point2, Point3};

/// Number of vertices along each side of a mesh.
const SIDE: u32 = 41;

/// Returns the mesh of a surface over a rectangle about the origin of its parameters, of these sides \[m\], with its triangles
/// turned upwards where `point` keeps x and y.
pub fn mesh_over(sides: [f64; 2], point: impl Fn(Point2) -> Point3) -> Mesh {
    let share = |i: u32| f64::from(i) / f64::from(SIDE - 1) - 0.5;
    let vertices = (0..SIDE * SIDE).map(|i| {
        let place = [share(i % SIDE) * sides[0], share(i / SIDE) * sides[1]];
        point(Point2::from(place))
    });
    let triangles = (0..SIDE - 1).flat_map(|row| {
        (0..SIDE - 1).flat_map(move |column| {
            let a = row * SIDE + column;
            [[a, a + 1, a + SIDE + 1], [a, a + SIDE + 1, a + SIDE]]
        })
    });
    Mesh::new(vertices.collect(), triangles.collect()).unwrap()
}
