//! Meshes of curved surfaces, with the tool above them.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};
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

/// The inside of a wok: the cap of a sphere of this radius \[m\] to 60° from its pole, open upwards.
pub fn bowl(radius: f64) -> Mesh {
    cap(radius, -1.0)
}

/// A dome: the cap of a sphere of this radius \[m\] to 60° from its pole, seen from outside.
pub fn dome(radius: f64) -> Mesh {
    cap(radius, 1.0)
}

/// The cap of a sphere to 60° from its pole, which lies at the origin: hollow upwards for a negative `side`.
fn cap(radius: f64, side: f64) -> Mesh {
    let (rings, around) = (24, 96);
    let mut vertices = vec![Point3::origin()];
    let mut triangles: Vec<[u32; 3]> = (0..around)
        .map(|k| [0, 1 + k, 1 + (k + 1) % around])
        .collect();
    for ring in 1..=rings {
        let polar = FRAC_PI_3 * f64::from(ring) / f64::from(rings);
        for k in 0..around {
            let angle = TAU * f64::from(k) / f64::from(around);
            vertices.push(Point3::new(
                radius * polar.sin() * angle.cos(),
                radius * polar.sin() * angle.sin(),
                side * radius * (polar.cos() - 1.0),
            ));
            if ring > 1 {
                let inner = 1 + (ring - 2) * around;
                let next = (k + 1) % around;
                let [a, b] = [inner + k, inner + next];
                triangles.extend([[a, a + around, b + around], [a, b + around, b]]);
            }
        }
    }
    Mesh::new(vertices, triangles).unwrap()
}

/// The inside of a bathtub of 0.9 × 0.5 × 0.25 m whose edges and corners are rounded with 0.1 m, open upwards.
pub fn bathtub() -> Mesh {
    let (radius, depth) = (0.1, 0.25);
    // The flat part of the floor, and parts of an edge's arc.
    let (cells, flat, arc) = ([34, 16], [0.7, 0.3], 16);
    let floor = mesh_over(cells, flat, |p| Point3::new(p.x, p.y, 0.0));
    let (mut vertices, mut triangles) = (floor.vertices().to_vec(), floor.triangles().to_vec());
    let [columns, rows] = cells;
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    // The border of the floor, with the directions outwards; at a corner, the directions turn.
    let mut border: Vec<(u32, f64)> = Vec::new();
    let turn = |corner: u32, from: f64| {
        (0..=arc)
            .map(|k| (corner, from + FRAC_PI_2 * f64::from(k) / f64::from(arc)))
            .collect::<Vec<_>>()
    };
    border.extend(turn(at(0, 0), PI));
    border.extend((1..columns).map(|i| (at(i, 0), -FRAC_PI_2)));
    border.extend(turn(at(columns, 0), -FRAC_PI_2));
    border.extend((1..rows).map(|j| (at(columns, j), 0.0)));
    border.extend(turn(at(columns, rows), 0.0));
    border.extend((1..columns).rev().map(|i| (at(i, rows), FRAC_PI_2)));
    border.extend(turn(at(0, rows), FRAC_PI_2));
    border.extend((1..rows).rev().map(|j| (at(0, j), PI)));
    // Profiles from the floor upwards: distance outwards and height.
    let of_arc = (1..=arc).map(|k| {
        let angle = FRAC_PI_2 * f64::from(k) / f64::from(arc);
        [radius * angle.sin(), radius * (1.0 - angle.cos())]
    });
    let of_wall = (1..=arc).map(|k| {
        [
            radius,
            radius + (depth - radius) * f64::from(k) / f64::from(arc),
        ]
    });
    let mut below: Vec<u32> = border.iter().map(|&(i, _)| i).collect();
    for [out, height] in of_arc.chain(of_wall) {
        let first = vertices.len() as u32;
        for &(i, direction) in &border {
            let foot = vertices[i as usize];
            let (sine, cosine) = direction.sin_cos();
            vertices.push(Point3::new(
                foot.x + out * cosine,
                foot.y + out * sine,
                height,
            ));
        }
        let count = border.len();
        for k in 0..count {
            let next = (k + 1) % count;
            let [a, b, c, d] = [below[k], below[next], first + k as u32, first + next as u32];
            triangles.push([a, c, d]);
            if a != b {
                triangles.push([a, d, b]);
            }
        }
        below = (first..first + count as u32).collect();
    }
    Mesh::new(vertices, triangles).unwrap()
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
