//! The surface of a round, in its chart.

use super::particles::line;
use crate::scene::to_seven_numbers;
use serde::Serialize;
use wisch::represent::{Surface, SurfaceShape};

/// Steps of the coordinates of a mesh [1/m].
const PER_METRE: f64 = 1e5;

#[derive(Serialize)]
pub(super) struct SurfaceRecord {
    pose: [f64; 7],
    rings: Vec<Vec<i64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<BendRecord>,
}

/// The shape of a surface, with the keys of plans and of the executor protocol.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(super) enum BendRecord {
    Plane,
    Cylinder {
        radius_m: f64,
        axis_rad: f64,
    },
    Cone {
        radius_m: f64,
        half_angle_rad: f64,
        axis_rad: f64,
    },
    Mesh {
        /// Points in the frame of the surface: x, y, z after each other [m].
        points: Vec<f64>,
        /// Their places in the chart: x, y [m].
        places: Vec<f64>,
        triangles: Vec<u32>,
    },
}

impl BendRecord {
    pub(super) fn new(shape: &SurfaceShape) -> Self {
        match shape {
            SurfaceShape::Plane => Self::Plane,
            &SurfaceShape::Cylinder { radius, axis } => Self::Cylinder {
                radius_m: radius,
                axis_rad: axis,
            },
            SurfaceShape::Cone(cone) => Self::Cone {
                radius_m: cone.radius,
                half_angle_rad: cone.half_angle,
                axis_rad: cone.axis,
            },
            SurfaceShape::Mesh(mesh) => {
                let sheet = mesh.sheet();
                let rounded = |x: &f64| (x * PER_METRE).round() / PER_METRE;
                let points = sheet
                    .vertices()
                    .flat_map(|v| [v.point.x, v.point.y, v.point.z]);
                let places = sheet.vertices().flat_map(|v| [v.place.x, v.place.y]);
                Self::Mesh {
                    points: points.map(|x| rounded(&x)).collect(),
                    places: places.map(|x| rounded(&x)).collect(),
                    triangles: sheet.triangles().flat_map(|(corners, _)| corners).collect(),
                }
            }
        }
    }
}

impl SurfaceRecord {
    pub(super) fn new(surface: &Surface) -> Self {
        Self {
            pose: to_seven_numbers(&surface.world_from_surface),
            rings: surface.outline.rings().map(line).collect(),
            shape: (!surface.shape.is_plane()).then(|| BendRecord::new(&surface.shape)),
        }
    }
}
