//! Triangle meshes: primitives, changes of frame, cuts, and files in memory.

mod collada;
mod height_field;
mod obj;
mod ply;
mod read;

pub(crate) use collada::{MAX_ATTRIBUTES, most_attributes};
pub use read::MeshFormat;

use super::{DisjointSets, Point3, Pose, Vector3};
use crate::fnv::Fnv;
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Largest absolute coordinate of a mesh \[m\].
pub const MAX_COORDINATE: f64 = 1e4;

/// Largest number of triangles of a mesh.
pub const MAX_TRIANGLES: usize = 5_000_000;

/// Range of the number of segments of a round primitive.
const SEGMENTS: std::ops::RangeInclusive<u32> = 3..=1024;

/// A triangle mesh, in a frame that its owner states.
///
/// The corners of a triangle are counter-clockwise as seen from outside the solid. Every index names a vertex, every
/// coordinate is finite and at most [`MAX_COORDINATE`], and there is at least one triangle.
///
/// ```
/// use wisch_robot::geometry::{Mesh, Vector3};
/// let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05))?;
/// assert_eq!(sponge.triangles().len(), 12);
/// assert_eq!(sponge.extent(), 0.11);
/// # Ok::<(), wisch_robot::geometry::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<Point3>,
    triangles: Vec<[u32; 3]>,
}

/// A reason why bytes or arrays are no mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A fault in the mesh of this name.
    #[error("mesh {name:?}: {fault}")]
    InMesh {
        /// Name of the mesh, as given to the reader.
        name: String,
        /// What is wrong.
        fault: Box<MeshError>,
    },
    /// The mesh is empty.
    #[error("it has no triangle")]
    Empty,
    /// The file has vertices, but no face.
    #[error(
        "it has points and no face (number of points: {points}): a point cloud has to be meshed first"
    )]
    PointCloud {
        /// Number of points.
        points: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error(
        "triangle {triangle} names vertex {index}, but there are {vertices} vertices (counted from 0)"
    )]
    IndexOutOfRange {
        /// Index of the triangle.
        triangle: usize,
        /// Index of the vertex.
        index: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// A coordinate is not finite or too large.
    #[error("vertex {vertex}: {axis} = {value} m exceeds the limit of ±{MAX_COORDINATE} m")]
    CoordinateOutOfRange {
        /// Index of the vertex.
        vertex: usize,
        /// Axis: x, y or z.
        axis: char,
        /// The coordinate \[m\].
        value: f64,
    },
    /// More triangles than [`MAX_TRIANGLES`].
    #[error("{count} triangles exceed the limit of {MAX_TRIANGLES}")]
    TooManyTriangles {
        /// Number of triangles.
        count: usize,
    },
    /// A file has too many parts.
    #[error("{count} {what} exceed the limit of {limit}")]
    TooManyParts {
        /// Kind of the part.
        what: &'static str,
        /// Number of the parts.
        count: usize,
        /// Largest number.
        limit: usize,
    },
    /// A size of a primitive is no valid length.
    #[error("{what} = {value} m is not above 0 m and at most {MAX_COORDINATE} m")]
    Size {
        /// Name of the size.
        what: &'static str,
        /// Its value \[m\].
        value: f64,
    },
    /// Too few or too many segments round a primitive.
    #[error("{segments} segments are not within {} to {}", SEGMENTS.start(), SEGMENTS.end())]
    Segments {
        /// Number of segments.
        segments: u32,
    },
    /// The header of a binary STL announces more or fewer triangles than the file holds.
    #[error(
        "its header announces {declared} triangles, but its {bytes} bytes have room for {room}"
    )]
    TriangleCount {
        /// Number of triangles in the header.
        declared: u32,
        /// Length of the file \[bytes\].
        bytes: usize,
        /// Number of triangles that fit into it.
        room: usize,
    },
    /// A text does not follow its format.
    #[error("line {line}: {reason}")]
    SyntaxAt {
        /// Number of the line, from 1.
        line: usize,
        /// What is wrong there.
        reason: String,
    },
    /// Bytes do not follow their format; the reason ends in line:column if they are known.
    #[error("{reason}")]
    Syntax {
        /// What is wrong.
        reason: String,
    },
}

impl Mesh {
    /// Returns a mesh of vertices \[m\] and triangles (three vertex indices each, counter-clockwise as seen from
    /// outside).
    ///
    /// # Errors
    /// If there is no triangle or more than [`MAX_TRIANGLES`], an index is not that of a vertex, or a coordinate is not
    /// finite or beyond [`MAX_COORDINATE`].
    pub fn new(vertices: Vec<Point3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        if triangles.len() > MAX_TRIANGLES {
            let count = triangles.len();
            return Err(MeshError::TooManyTriangles { count });
        }
        check_coordinates(&vertices)?;
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices.len()) {
                let vertices = vertices.len();
                return Err(MeshError::IndexOutOfRange {
                    triangle,
                    index,
                    vertices,
                });
            }
        }
        Ok(Self {
            vertices,
            triangles,
        })
    }

    /// Returns a box centred on the origin; `size` is its extent along x, y and z \[m\].
    ///
    /// # Errors
    /// If a size is not above zero or beyond [`MAX_COORDINATE`].
    pub fn cuboid(size: Vector3) -> Result<Self, MeshError> {
        check_size("size along x", size.x)?;
        check_size("size along y", size.y)?;
        check_size("size along z", size.z)?;
        let vertices = (0..8)
            .map(|i| {
                let side = |bit: u32| if i & bit == 0 { -0.5 } else { 0.5 };
                Point3::new(side(1) * size.x, side(2) * size.y, side(4) * size.z)
            })
            .collect();
        let quads = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = quads
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        Self::new(vertices, triangles)
    }

    /// Returns a cylinder along z, centred on the origin. Its rim is a regular polygon with a corner on the x axis,
    /// inscribed in the circle of `radius` \[m\]; `height` in metres.
    ///
    /// # Errors
    /// If a size is not above zero or beyond [`MAX_COORDINATE`], or `segments` not within 3 to 1024.
    pub fn cylinder(radius: f64, height: f64, segments: u32) -> Result<Self, MeshError> {
        check_size("radius", radius)?;
        check_size("height", height)?;
        let z = height / 2.0;
        Self::revolve(&[(radius, -z), (radius, z)], -z, z, segments)
    }

    /// Returns a sphere of `radius` \[m\] about the origin, of `segments` meridians and half as many rows. Its corners,
    /// including the poles on the z axis, lie on the sphere.
    ///
    /// # Errors
    /// If the radius is not above zero or beyond [`MAX_COORDINATE`], or `segments` not within 3 to 1024.
    pub fn sphere(radius: f64, segments: u32) -> Result<Self, MeshError> {
        check_size("radius", radius)?;
        let rows = (segments / 2).max(2);
        let rings: Vec<_> = (1..rows)
            .map(|row| {
                let latitude = PI * f64::from(row) / f64::from(rows) - FRAC_PI_2;
                (radius * latitude.cos(), radius * latitude.sin())
            })
            .collect();
        Self::revolve(&rings, -radius, radius, segments)
    }

    /// Returns a cylinder along z with hemispheres on both ends, centred on the origin. `height` is the distance
    /// between the centres of the hemispheres \[m\], and `radius` their radius \[m\].
    ///
    /// # Errors
    /// If a size is not above zero or beyond [`MAX_COORDINATE`], or `segments` not within 3 to 1024.
    pub fn capsule(radius: f64, height: f64, segments: u32) -> Result<Self, MeshError> {
        check_size("radius", radius)?;
        check_size("height", height)?;
        let rows = (segments / 4).max(1);
        let cap = |row: u32, sign: f64| {
            let latitude = FRAC_PI_2 * f64::from(row) / f64::from(rows);
            (
                radius * latitude.cos(),
                sign * (height / 2.0 + radius * latitude.sin()),
            )
        };
        let lower = (0..rows).rev().map(|row| cap(row, -1.0));
        let rings: Vec<_> = lower.chain((0..rows).map(|row| cap(row, 1.0))).collect();
        let pole = height / 2.0 + radius;
        Self::revolve(&rings, -pole, pole, segments)
    }

    /// Returns a solid of revolution about z: rings (radius, z) from bottom to top between two poles.
    fn revolve(
        rings: &[(f64, f64)],
        bottom: f64,
        top: f64,
        segments: u32,
    ) -> Result<Self, MeshError> {
        if !SEGMENTS.contains(&segments) {
            return Err(MeshError::Segments { segments });
        }
        let mut vertices = vec![Point3::new(0.0, 0.0, bottom)];
        for &(radius, z) in rings {
            vertices.extend((0..segments).map(|i| {
                let angle = TAU * f64::from(i) / f64::from(segments);
                Point3::new(radius * angle.cos(), radius * angle.sin(), z)
            }));
        }
        let pole = vertices.len() as u32;
        vertices.push(Point3::new(0.0, 0.0, top));
        let at = |ring: usize, i: u32| 1 + ring as u32 * segments + i % segments;
        let last = rings.len() - 1;
        let mut triangles = Vec::new();
        for i in 0..segments {
            triangles.push([0, at(0, i + 1), at(0, i)]);
            for ring in 0..last {
                let (a, b) = (at(ring, i), at(ring, i + 1));
                let (c, d) = (at(ring + 1, i + 1), at(ring + 1, i));
                triangles.extend([[a, b, c], [a, c, d]]);
            }
            triangles.push([pole, at(last, i), at(last, i + 1)]);
        }
        Self::new(vertices, triangles)
    }

    /// Merges meshes of the same frame.
    ///
    /// # Errors
    /// If there is no mesh, or more than [`MAX_TRIANGLES`] triangles together.
    pub fn merge(meshes: impl IntoIterator<Item = Self>) -> Result<Self, MeshError> {
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for mesh in meshes {
            let count = triangles.len() + mesh.triangles.len();
            if count > MAX_TRIANGLES {
                return Err(MeshError::TooManyTriangles { count });
            }
            let first = vertices.len() as u32;
            vertices.extend(mesh.vertices);
            triangles.extend(mesh.triangles.iter().map(|t| t.map(|i| i + first)));
        }
        Self::new(vertices, triangles)
    }

    /// Vertices in the mesh's own frame \[m\].
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// Triangles, as three vertex indices each.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Iterates over the corners of each triangle \[m\].
    pub fn corners(&self) -> impl Iterator<Item = [Point3; 3]> + '_ {
        self.triangles
            .iter()
            .map(|t| t.map(|i| self.vertices[i as usize]))
    }

    /// Returns the vertices of each connected part of the mesh, in the mesh's own frame \[m\]. Coincident vertices count
    /// as one.
    pub fn parts(&self) -> Vec<Vec<Point3>> {
        let key = |p: &Point3| [p.x, p.y, p.z].map(f64::to_bits);
        let mut places: BTreeMap<[u64; 3], usize> = BTreeMap::new();
        let at: Vec<usize> = (self.vertices.iter())
            .map(|p| {
                let next = places.len();
                *places.entry(key(p)).or_insert(next)
            })
            .collect();
        let mut sets = DisjointSets::new(places.len());
        for [a, b, c] in &self.triangles {
            sets.union(at[*a as usize], at[*b as usize]);
            sets.union(at[*a as usize], at[*c as usize]);
        }
        let mut parts: BTreeMap<usize, Vec<Point3>> = BTreeMap::new();
        for (place, vertex) in at.iter().zip(&self.vertices) {
            parts.entry(sets.find(*place)).or_default().push(*vertex);
        }
        parts.into_values().collect()
    }

    /// Returns the mesh in another frame, to which `other_from_mesh` maps this one.
    ///
    /// The result is not checked against [`MAX_COORDINATE`].
    pub fn transform(&self, other_from_mesh: &Pose) -> Self {
        Self {
            vertices: self
                .vertices
                .iter()
                .map(|&point| other_from_mesh * point)
                .collect(),
            triangles: self.triangles.clone(),
        }
    }

    /// Least and largest coordinates of the triangles' corners \[m\].
    pub fn bounds(&self) -> (Point3, Point3) {
        let nowhere = Point3::from(Vector3::repeat(f64::INFINITY));
        self.corners()
            .flatten()
            .fold((nowhere, -nowhere), |(min, max), p| {
                (min.inf(&p), max.sup(&p))
            })
    }

    /// Returns a digest of vertices, rounded to 1e-9 m, and triangles: FNV-1a with 128 bits. It does not protect against
    /// deliberate collisions.
    pub fn digest(&self) -> u128 {
        let mut hash = Fnv::new();
        hash.mesh(self);
        u128::from_le_bytes(hash.sum())
    }

    /// Longest side of the bounding box \[m\].
    ///
    /// The extent of a hand tool above about 20 m is probably in millimetres.
    pub fn extent(&self) -> f64 {
        let (min, max) = self.bounds();
        (max - min).max()
    }

    /// Returns the mesh with its triangles divided until no edge is longer than `longest` \[m\], or until there are 400,000
    /// triangles. Neighbours share the new vertices, so a watertight mesh stays so.
    ///
    /// ```
    /// use wisch_robot::geometry::{Mesh, Vector3};
    /// let cube = Mesh::cuboid(Vector3::new(0.1, 0.1, 0.1))?;
    /// let fine = cube.split_edges(0.03);
    /// let longest = fine.corners().flat_map(|[a, b, c]| [(b - a).norm(), (c - b).norm(), (a - c).norm()]);
    /// assert!(longest.fold(0.0, f64::max) <= 0.03 && fine.is_watertight());
    /// # Ok::<(), wisch_robot::geometry::MeshError>(())
    /// ```
    #[must_use]
    pub fn split_edges(&self, longest: f64) -> Self {
        self.split_edges_by(|a, b| (a - b).norm(), longest)
    }

    /// Returns the same surface in triangles of which no edge has a `measure` above `most`, within
    /// the limit on the number of triangles. `measure` must return the same value for both
    /// directions of an edge.
    #[must_use]
    pub fn split_edges_by(&self, measure: impl Fn(&Point3, &Point3) -> f64, most: f64) -> Self {
        const MOST_TRIANGLES: usize = 400_000;
        let mut vertices = self.vertices.clone();
        let mut triangles = self.triangles.clone();
        let mut middles = std::collections::BTreeMap::new();
        loop {
            let mut divided = Vec::with_capacity(2 * triangles.len());
            for &[a, b, c] in &triangles {
                let length = |i: u32, j: u32| measure(&vertices[i as usize], &vertices[j as usize]);
                // Of equal edges, the edge with the smallest numbers is taken, so that both
                // neighbours choose the same one.
                let shorter = |one: &[u32; 3], other: &[u32; 3]| {
                    let key = |[from, to, _]: &[u32; 3]| (*from.min(to), *from.max(to));
                    let [l, m] = [one, other].map(|side| length(side[0], side[1]));
                    l.total_cmp(&m).then(key(other).cmp(&key(one)))
                };
                let sides = [[a, b, c], [b, c, a], [c, a, b]];
                let [from, to, tip] = sides.into_iter().max_by(shorter).unwrap_or([a, b, c]);
                if length(from, to) <= most {
                    divided.push([a, b, c]);
                    continue;
                }
                let middle = *(middles.entry((from.min(to), from.max(to)))).or_insert_with(|| {
                    let [from, to] = [from, to].map(|i| vertices[i as usize]);
                    vertices.push(nalgebra::center(&from, &to));
                    vertices.len() as u32 - 1
                });
                divided.extend([[from, middle, tip], [middle, to, tip]]);
            }
            let is_done = divided.len() == triangles.len() || divided.len() > MOST_TRIANGLES;
            triangles = divided;
            if is_done {
                return Self {
                    vertices,
                    triangles,
                };
            }
        }
    }

    /// Returns the part of the surface at or above the plane z = `z` \[m\], as triangles; empty if all of it is below.
    /// The cut stays open.
    pub fn clip_above(&self, z: f64) -> Vec<[Point3; 3]> {
        self.corners()
            .flat_map(|corners| {
                let kept = cut(corners, z, Side::Above);
                (2..kept.len()).map(move |i| [kept[0], kept[i - 1], kept[i]])
            })
            .collect()
    }

    /// Whether the surface encloses a solid: every edge is traversed equally often in both directions. Coincident
    /// vertices count as one, so it does not matter how a file shares them.
    pub fn is_watertight(&self) -> bool {
        let mut balance: HashMap<(u32, u32), i64> = HashMap::new();
        for [a, b, c] in self.welded_triangles() {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if from != to {
                    *balance.entry((from.min(to), from.max(to))).or_default() +=
                        if from < to { 1 } else { -1 };
                }
            }
        }
        balance.values().all(|&b| b == 0)
    }

    /// Iterates over the triangles, with each index replaced by that of the first vertex at the same place.
    pub(super) fn welded_triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        let mut first_at = HashMap::new();
        let first: Vec<u32> = (0u32..)
            .zip(&self.vertices)
            .map(|(i, p)| *first_at.entry(place(*p)).or_insert(i))
            .collect();
        self.triangles
            .iter()
            .map(move |t| t.map(|i| first[i as usize]))
    }

    /// Returns the mesh with coincident vertices merged and unused ones dropped.
    fn weld(&self) -> Self {
        let mut index_at = HashMap::new();
        let mut vertices = Vec::new();
        let triangles = self
            .corners()
            .map(|corners| {
                corners.map(|p| {
                    *index_at.entry(place(p)).or_insert_with(|| {
                        vertices.push(p);
                        vertices.len() as u32 - 1
                    })
                })
            })
            .collect();
        Self {
            vertices,
            triangles,
        }
    }

    /// Returns the mesh as a binary STL in metres, with coordinates rounded to `f32`.
    pub fn to_binary_stl(&self) -> Vec<u8> {
        let mut bytes = b"binary STL, lengths in metres, written by wisch".to_vec();
        bytes.resize(80, b' ');
        bytes.extend((self.triangles.len() as u32).to_le_bytes());
        for [a, b, c] in self.corners() {
            let normal = (b - a)
                .cross(&(c - a))
                .try_normalize(0.0)
                .unwrap_or_default();
            for v in [normal, a.coords, b.coords, c.coords] {
                bytes.extend(v.iter().flat_map(|&x| (x as f32).to_le_bytes()));
            }
            bytes.extend(0u16.to_le_bytes());
        }
        bytes
    }
}

/// The side of a horizontal plane that is kept.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Above,
    Below,
}

/// Returns the part of a triangle on one side of the plane z = `z`, as a convex polygon of the same orientation.
pub(super) fn cut(corners: [Point3; 3], z: f64, side: Side) -> Vec<Point3> {
    let inside = |p: Point3| {
        if side == Side::Above {
            p.z >= z
        } else {
            p.z <= z
        }
    };
    let mut kept = Vec::with_capacity(4);
    for i in 0..3 {
        let (here, next) = (corners[i], corners[(i + 1) % 3]);
        if inside(here) {
            kept.push(here);
        }
        if inside(here) != inside(next) && here.z != z && next.z != z {
            kept.push(crossing(here, next, z));
        }
    }
    if kept.len() < 3 {
        kept.clear();
    }
    kept
}

/// Returns where the edge between two points of different height meets the plane z = `z`. The two triangles that share
/// an edge get exactly the same point.
pub(super) fn crossing(a: Point3, b: Point3, z: f64) -> Point3 {
    let (low, high) = if a.z < b.z { (a, b) } else { (b, a) };
    let mut point = low + (high - low) * ((z - low.z) / (high.z - low.z));
    point.z = z;
    point
}

/// Returns a key that is equal for equal coordinates (adding zero turns −0 into 0).
fn place(point: Point3) -> [u64; 3] {
    [point.x, point.y, point.z].map(|c| (c + 0.0).to_bits())
}

fn check_coordinates(vertices: &[Point3]) -> Result<(), MeshError> {
    for (vertex, point) in vertices.iter().enumerate() {
        for (axis, value) in [('x', point.x), ('y', point.y), ('z', point.z)] {
            if value.is_nan() || value.abs() > MAX_COORDINATE {
                return Err(MeshError::CoordinateOutOfRange {
                    vertex,
                    axis,
                    value,
                });
            }
        }
    }
    Ok(())
}

fn check_size(what: &'static str, value: f64) -> Result<(), MeshError> {
    if value > 0.0 && value <= MAX_COORDINATE {
        Ok(())
    } else {
        Err(MeshError::Size { what, value })
    }
}

#[cfg(test)]
mod tests;
