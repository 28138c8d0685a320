//! Solids in the format of a recording. Poses are x, y, z [m] and a quaternion x, y, z, w; vertices and
//! points are in tenths of a millimetre.

mod mesh;

use mesh::{Thinned, resample};
use serde::Serialize;
use wisch::geometry::{Mesh, Point3, Pose, Vector3, flatten_pose};
use wisch::robot::Shape;

/// Units of vertices and points per metre.
const PER_METRE: f64 = 1e4;

/// The meshes of a page, each stored once.
#[derive(Debug)]
pub(crate) struct Meshes {
    records: Vec<MeshRecord>,
    /// Maximum number of triangles of a mesh.
    most: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct MeshRecord {
    /// x, y, z of all vertices, concatenated.
    vertices: Vec<i64>,
    /// Three vertex indices per triangle.
    triangles: Vec<u32>,
}

/// A shape at its pose.
#[derive(Debug, Serialize)]
pub(crate) struct Solid {
    pose: [f64; 7],
    #[serde(flatten)]
    form: Form,
    #[serde(skip_serializing_if = "Option::is_none")]
    color: Option<[f64; 4]>,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Form {
    Box {
        size: [f64; 3],
    },
    Cylinder {
        radius: f64,
        length: f64,
    },
    Capsule {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    /// Index into [`Meshes`].
    Mesh {
        mesh: usize,
    },
}

impl Meshes {
    /// Makes an empty collection, whose meshes are reduced to at most `most` triangles.
    pub(crate) fn new(most: usize) -> Self {
        Self {
            records: Vec::new(),
            most,
        }
    }

    /// Returns the number of meshes.
    pub(crate) const fn len(&self) -> usize {
        self.records.len()
    }

    /// Returns the meshes from index `first` on.
    pub(crate) fn since(&self, first: usize) -> Vec<MeshRecord> {
        self.records[first..].to_vec()
    }

    /// Adds a shape at its pose; a mesh is reduced to at most `most` triangles.
    pub(crate) fn shape_within(&mut self, pose: &Pose, shape: &Shape, most: usize) -> Solid {
        let form = match shape {
            Shape::Box { size } => Form::Box { size: vector(size) },
            &Shape::Cylinder { radius, length } => Form::Cylinder { radius, length },
            &Shape::Capsule { radius, length } => Form::Capsule { radius, length },
            &Shape::Sphere { radius } => Form::Sphere { radius },
            Shape::Mesh(mesh) => return self.solid_within(pose, mesh, most),
        };
        Solid::new(pose, form)
    }

    /// Adds a mesh at its pose.
    pub(crate) fn solid(&mut self, pose: &Pose, mesh: &Mesh) -> Solid {
        self.solid_within(pose, mesh, self.most)
    }

    fn solid_within(&mut self, pose: &Pose, mesh: &Mesh, most: usize) -> Solid {
        let Thinned {
            vertices,
            triangles,
        } = resample(mesh, most);
        let record = MeshRecord {
            vertices: list_tenths(vertices),
            triangles: triangles.into_flattened(),
        };
        let known = self.records.iter().position(|other| *other == record);
        let mesh = known.unwrap_or_else(|| {
            self.records.push(record);
            self.records.len() - 1
        });
        Solid::new(pose, Form::Mesh { mesh })
    }
}

impl Solid {
    /// Returns a ball around the origin of a frame.
    pub(crate) fn ball(pose: &Pose, radius: f64) -> Self {
        Self::new(pose, Form::Sphere { radius })
    }

    fn new(pose: &Pose, form: Form) -> Self {
        Self {
            pose: to_seven_numbers(pose),
            form,
            color: None,
        }
    }

    /// Sets the colour: red, green, blue and opacity, in [0, 1].
    pub(crate) fn with_colour(self, rgba: [f64; 4]) -> Self {
        let color = Some(rgba.map(|part| (part * 1e3).round() / 1e3));
        Self { color, ..self }
    }
}

/// Returns a pose as seven rounded numbers.
pub(crate) fn to_seven_numbers(pose: &Pose) -> [f64; 7] {
    flatten_pose(pose).map(round)
}

/// Returns a vector as three numbers.
pub(crate) fn vector(v: &Vector3) -> [f64; 3] {
    [v.x, v.y, v.z].map(round)
}

/// Rounds to seven decimals, because the length of a robot amplifies errors of rotation.
fn round(value: f64) -> f64 {
    // Adding zero leaves no "-0.0".
    (value * 1e7).round() / 1e7 + 0.0
}

/// Returns the coordinates of points, concatenated.
pub(crate) fn list_tenths(points: impl IntoIterator<Item = Point3>) -> Vec<i64> {
    (points.into_iter())
        .flat_map(|p| [p.x, p.y, p.z].map(to_tenth))
        .collect()
}

/// Converts a length [m] to tenths of a millimetre.
pub(crate) fn to_tenth(length: f64) -> i64 {
    (length * PER_METRE).round() as i64
}
