//! Solids in space, as the scripts of pages read them. Poses are x, y, z [m], quaternion x, y, z, w; vertices and
//! points come in tenths of a millimetre.

mod mesh;

use mesh::{Thinned, resample};
use serde::Serialize;
use wisch::geometry::{Mesh, Point3, Pose, Vector3};
use wisch::robot::Shape;

/// Lengths of meshes and points per metre.
const PER_METRE: f64 = 1e4;

/// The meshes of a page, each written once however often it is shown.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub(crate) struct Meshes {
    records: Vec<MeshRecord>,
    /// Most triangles of each.
    #[serde(skip)]
    most: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct MeshRecord {
    /// x, y, z of all vertices in turn.
    vertices: Vec<i64>,
    /// Three vertices each.
    triangles: Vec<u32>,
}

/// A shape at its place.
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
    /// One of [`Meshes`].
    Mesh {
        mesh: usize,
    },
}

impl Meshes {
    /// None yet; each may have at most `most` triangles, and is coarsened until it does.
    pub(crate) fn new(most: usize) -> Self {
        Self {
            records: Vec::new(),
            most,
        }
    }

    /// How many there are.
    pub(crate) const fn len(&self) -> usize {
        self.records.len()
    }

    /// Those from this one on.
    pub(crate) fn since(&self, first: usize) -> Vec<MeshRecord> {
        self.records[first..].to_vec()
    }

    /// A shape of a link; `pose` is its pose in the frame that it is shown in.
    pub(crate) fn shape(&mut self, pose: &Pose, shape: &Shape) -> Solid {
        self.shape_within(pose, shape, self.most)
    }

    /// The same; a mesh may have at most `most` triangles.
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

    /// A mesh at its pose.
    pub(crate) fn solid(&mut self, pose: &Pose, mesh: &Mesh) -> Solid {
        self.solid_within(pose, mesh, self.most)
    }

    fn solid_within(&mut self, pose: &Pose, mesh: &Mesh, most: usize) -> Solid {
        let Thinned {
            vertices,
            triangles,
        } = resample(mesh, most);
        let record = MeshRecord {
            vertices: tenths(vertices),
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
    /// A ball round the origin of a frame.
    pub(crate) fn ball(pose: &Pose, radius: f64) -> Self {
        Self::new(pose, Form::Sphere { radius })
    }

    fn new(pose: &Pose, form: Form) -> Self {
        Self {
            pose: seven(pose),
            form,
            color: None,
        }
    }

    /// The same in a colour: red, green, blue and opacity, in [0, 1].
    pub(crate) fn coloured(self, rgba: [f64; 4]) -> Self {
        let color = Some(rgba.map(|part| (part * 1e3).round() / 1e3));
        Self { color, ..self }
    }
}

/// A pose as seven numbers.
pub(crate) fn seven(pose: &Pose) -> [f64; 7] {
    let turn = pose.rotation.coords;
    let [x, y, z] = vector(&pose.translation.vector);
    let [i, j, k, w] = [turn.x, turn.y, turn.z, turn.w].map(rounded);
    [x, y, z, i, j, k, w]
}

/// Three numbers.
pub(crate) fn vector(v: &Vector3) -> [f64; 3] {
    [v.x, v.y, v.z].map(rounded)
}

/// To seven decimals, as a turn is amplified by the length of a robot.
fn rounded(value: f64) -> f64 {
    // Adding zero leaves no "-0.0".
    (value * 1e7).round() / 1e7 + 0.0
}

/// Points in turn.
pub(crate) fn tenths(points: impl IntoIterator<Item = Point3>) -> Vec<i64> {
    (points.into_iter())
        .flat_map(|p| [p.x, p.y, p.z].map(tenth))
        .collect()
}

/// A length [m] in tenths of a millimetre.
pub(crate) fn tenth(length: f64) -> i64 {
    (length * PER_METRE).round() as i64
}

/// A record within a page's script element: a "<" occurs only within texts, where "</script>" must not end it.
pub(crate) fn json(record: &impl Serialize) -> String {
    let data = serde_json::to_string(record).unwrap_or_default();
    data.replace('<', "\\u003c")
}
