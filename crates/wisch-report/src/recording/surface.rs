//! The surface of a round, in its chart.

use super::particles::line;
use crate::scene::seven;
use serde::Serialize;
use wisch::represent::{Surface, SurfaceShape};

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
    Cylinder { radius_m: f64, axis_rad: f64 },
}

impl BendRecord {
    pub(super) const fn new(shape: &SurfaceShape) -> Self {
        match *shape {
            SurfaceShape::Plane => Self::Plane,
            SurfaceShape::Cylinder { radius, axis } => Self::Cylinder {
                radius_m: radius,
                axis_rad: axis,
            },
        }
    }
}

impl SurfaceRecord {
    pub(super) fn new(surface: &Surface) -> Self {
        Self {
            pose: seven(&surface.world_from_surface),
            rings: surface.outline.rings().map(line).collect(),
            shape: (!surface.shape.is_plane()).then(|| BendRecord::new(&surface.shape)),
        }
    }
}
