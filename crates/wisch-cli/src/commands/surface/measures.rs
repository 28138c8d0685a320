//! Measures of a sheet: bends, normals, and where a tool touches it.

use serde::Serialize;
use wisch::geometry::{Point3, Sheet, Vector3};
use wisch::represent::{find_needed_compression, principal_curvatures};

/// A value and where on the mesh it occurs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct PlacedValue {
    pub(super) value: f64,
    /// Point in the frame of the mesh [m].
    pub(super) at: [f64; 3],
}

impl PlacedValue {
    pub(super) fn new(value: f64, at: Point3) -> Self {
        Self {
            value,
            at: at.coords.into(),
        }
    }
}

/// Principal curvatures and normals of a sheet.
pub(super) struct Measures {
    /// Largest curvature that bulges towards the tool [1/m]; negative if there is none.
    pub(super) bulge: PlacedValue,
    /// Least curvature, negative in a hollow [1/m].
    pub(super) hollow: PlacedValue,
    /// Mean normal.
    pub(super) mean_normal: Vector3,
    /// Mean and largest angle of the normals from their mean [rad].
    pub(super) mean_lean: f64,
    pub(super) largest_lean: PlacedValue,
    /// Share of the area that the tool touches with its whole footprint if its sides follow the principal directions.
    pub(super) touched_share: f64,
    /// Largest compression that the whole footprint needs [m].
    pub(super) needed_compression: PlacedValue,
}

impl Measures {
    /// Measures a sheet for a tool with a footprint of these sides and a compression depth [m].
    pub(super) fn new(sheet: &Sheet, tool_size: [f64; 2], depth: f64) -> Self {
        let first = sheet
            .vertices()
            .next()
            .map_or_else(Point3::origin, |v| v.point);
        let mut bulge = PlacedValue::new(f64::NEG_INFINITY, first);
        let mut hollow = PlacedValue::new(f64::INFINITY, first);
        let mut needed = PlacedValue::new(0.0, first);
        let (mut touched, mut area, mut sum) = (0.0, 0.0, Vector3::zeros());
        for vertex in sheet.vertices() {
            let [larger, smaller] = principal_curvatures(&vertex.bend);
            if larger > bulge.value {
                bulge = PlacedValue::new(larger, vertex.point);
            }
            if smaller < hollow.value {
                hollow = PlacedValue::new(smaller, vertex.point);
            }
            let compression = find_needed_compression([larger, smaller], tool_size);
            if compression > needed.value {
                needed = PlacedValue::new(compression, vertex.point);
            }
            touched += if compression <= depth {
                vertex.area
            } else {
                0.0
            };
            area += vertex.area;
            sum += vertex.normal * vertex.area;
        }
        let mean_normal = sum.try_normalize(0.0).unwrap_or_else(Vector3::z);
        let (mut mean_lean, mut largest_lean) = (0.0, PlacedValue::new(0.0, first));
        for vertex in sheet.vertices() {
            let lean = vertex.normal.angle(&mean_normal);
            mean_lean += lean * vertex.area / area;
            if lean > largest_lean.value {
                largest_lean = PlacedValue::new(lean, vertex.point);
            }
        }
        Self {
            bulge,
            hollow,
            mean_normal,
            mean_lean,
            largest_lean,
            touched_share: touched / area,
            needed_compression: needed,
        }
    }
}
