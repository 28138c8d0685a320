//! The elements of a URDF as typed.

use crate::Diagnostic;
use crate::geometry::{Pose, Vector3};
use nalgebra::Matrix3;

pub(crate) struct Urdf {
    pub robot: String,
    pub links: Vec<UrdfLink>,
    pub joints: Vec<UrdfJoint>,
    /// Mimics of several joints, an extension of URDF.
    pub mimics: Vec<UrdfMimic>,
    /// Findings that arose while the text was read.
    pub findings: Vec<Diagnostic>,
}

pub(crate) struct UrdfLink {
    pub name: String,
    /// Where its element starts [byte].
    pub at: usize,
    pub inertial: Option<UrdfInertial>,
    pub shapes: Vec<UrdfShape>,
}

#[derive(Clone)]
pub(crate) struct UrdfInertial {
    /// Where its element starts [byte].
    pub at: usize,
    pub mass: f64,
    pub link_from_inertia: Pose,
    pub about_center: Matrix3<f64>,
}

pub(crate) struct UrdfShape {
    /// Where its element starts [byte].
    pub at: usize,
    pub link_from_shape: Pose,
    pub geometry: UrdfGeometry,
}

pub(crate) enum UrdfGeometry {
    Box(Vector3),
    Cylinder { radius: f64, length: f64 },
    Capsule { radius: f64, length: f64 },
    Sphere(f64),
    Mesh { file: String, scale: Vector3 },
}

impl UrdfGeometry {
    /// Whether it is a primitive whose lengths are all 0, as a placeholder has them.
    pub fn is_point(&self) -> bool {
        match self {
            Self::Box(size) => size.max() <= 0.0,
            Self::Cylinder { radius, length } | Self::Capsule { radius, length } => {
                radius.max(*length) <= 0.0
            }
            Self::Sphere(radius) => *radius <= 0.0,
            Self::Mesh { .. } => false,
        }
    }
}

pub(crate) struct UrdfJoint {
    pub name: String,
    pub kind: String,
    /// Where its element starts [byte].
    pub at: usize,
    pub parent: String,
    pub child: String,
    pub parent_from_joint: Pose,
    pub axis: Vector3,
    pub limit: Option<UrdfLimit>,
    /// Limits of the safety controller, if narrower; `limit` includes them.
    pub soft_limits: Option<[f64; 2]>,
    /// Attribute of the position limit that is not stated beside the other one, so that 0 is assumed; `limit` includes it.
    pub assumed_limit: Option<&'static str>,
}

#[derive(Clone, Copy, Default)]
pub(crate) struct UrdfLimit {
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub velocity: Option<f64>,
    pub effort: Option<f64>,
    pub acceleration: Option<f64>,
}

pub(crate) struct UrdfMimic {
    /// Where its element starts [byte].
    pub at: usize,
    pub joint: String,
    pub offset: f64,
    pub terms: Vec<(String, f64)>,
}
