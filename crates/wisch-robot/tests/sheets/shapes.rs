//! Meshes of curved surfaces.

use wisch_robot::geometry::{Mesh, Point2, Point3};

/// Returns a grid of `columns` × `rows` cells over a rectangle \[m\] about the origin, mapped into space; its normals are
/// those of the map's x × y.
pub fn grid(
    [columns, rows]: [u32; 2],
    [width, depth]: [f64; 2],
    map: impl Fn(f64, f64) -> Point3,
) -> Mesh {
    grid_where([columns, rows], [width, depth], map, |_, _| true)
}

/// Like [`grid`], without the cells whose middle is not kept.
pub fn grid_where(
    [columns, rows]: [u32; 2],
    [width, depth]: [f64; 2],
    map: impl Fn(f64, f64) -> Point3,
    keep: impl Fn(f64, f64) -> bool,
) -> Mesh {
    let x = |i: f64| width * (i / f64::from(columns) - 0.5);
    let y = |j: f64| depth * (j / f64::from(rows) - 0.5);
    let vertices = (0..=rows)
        .flat_map(|j| (0..=columns).map(move |i| (i, j)))
        .map(|(i, j)| map(x(f64::from(i)), y(f64::from(j))))
        .collect();
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    let mut triangles = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            if !keep(x(f64::from(i) + 0.5), y(f64::from(j) + 0.5)) {
                continue;
            }
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            // Diagonals alternate, so that none of the directions is preferred.
            if (i + j) % 2 == 1 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    Mesh::new(vertices, triangles).unwrap()
}

/// Returns a disc of concentric rings, mapped into space from polar coordinates (radius \[1\], angle \[rad\]).
pub fn disc(rings: u32, map: impl Fn(f64, f64) -> Point3) -> Mesh {
    let mut vertices = vec![map(0.0, 0.0)];
    for ring in 1..=rings {
        for k in 0..6 * ring {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(6 * ring);
            vertices.push(map(f64::from(ring) / f64::from(rings), angle));
        }
    }
    let at = |ring: u32, k: u32| match ring {
        0 => 0,
        _ => 1 + 3 * ring * (ring - 1) + k % (6 * ring),
    };
    let mut triangles = Vec::new();
    for ring in 1..=rings {
        for sector in 0..6 {
            for j in 0..ring {
                let (outer, inner) = (sector * ring + j, sector * (ring - 1) + j);
                triangles.push([at(ring - 1, inner), at(ring, outer), at(ring, outer + 1)]);
                if j + 1 < ring {
                    triangles.push([
                        at(ring - 1, inner),
                        at(ring, outer + 1),
                        at(ring - 1, inner + 1),
                    ]);
                }
            }
        }
    }
    Mesh::new(vertices, triangles).unwrap()
}

/// A cylinder along y of radius R \[m\] that bulges to +z (hollow for R < 0), over a chart of this size \[m\].
pub fn cylinder(cells: [u32; 2], size: [f64; 2], radius: f64) -> Mesh {
    grid(cells, size, |s, y| {
        Point3::new(
            radius * (s / radius).sin(),
            y,
            radius * (s / radius).cos() - radius,
        )
    })
}

/// The saddle z = (x² − y²)/2R, R = 0.5 m, over 0.6 × 0.4 m.
pub fn saddle(cells: [u32; 2]) -> Mesh {
    grid(cells, [0.6, 0.4], |x, y| Point3::new(x, y, x * x - y * y))
}

/// A cap of a sphere of radius R \[m\] to the polar angle θ \[rad\]: outside about +z, or inside for R < 0.
pub fn cap(rings: u32, radius: f64, angle: f64) -> Mesh {
    disc(rings, |share, around| {
        let polar = share * angle;
        let across = radius.abs() * polar.sin();
        let z = radius * (polar.cos() - 1.0);
        Point3::new(across * around.cos(), across * around.sin(), z)
    })
}

/// A door of 1.0 × 0.6 m: barrels of 1.2 m and 4 m radius, with a crease of 6 mm over 20 mm.
pub fn door(cells: [u32; 2]) -> Mesh {
    grid(cells, [1.0, 0.6], |x, y| {
        let crease = 0.006 * ((y - 0.05 - 0.1 * x) / 0.02).tanh();
        Point3::new(x, y, -x * x / 8.0 - y * y / 2.4 + crease)
    })
}

/// A wavy panel of 1.0 × 0.8 m with a round hole.
pub fn wavy(cells: [u32; 2]) -> Mesh {
    let height = |x: f64, y: f64| 0.01 * ((6.0 * x).sin() + (5.0 * y).cos());
    grid_where(
        cells,
        [1.0, 0.8],
        |x, y| Point3::new(x, y, height(x, y)),
        |x, y| (Point2::new(x, y) - Point2::new(0.1, -0.05)).norm() > 0.15,
    )
}
