//! A part of a mesh at the scale of a tool, before it is unrolled.

use super::error::SheetError;
use super::part::{MeshSurvey, PartChoice, take_part};
use super::quadric::{LocalFit, fit_vertices};
use super::remesh::{has_edges_beyond, remesh, split_long_edges};
use super::topology::Triangles;
use crate::geometry::{Mesh, Point3};
use std::f64::consts::PI;

/// Range of the radius of a tool \[m\].
pub const TOOL_RADIUS_RANGE: [f64; 2] = [0.002, 2.0];
/// Largest number of triangles of a chart.
pub const MAX_SHEET_TRIANGLES: usize = 200_000;
/// Longest edge of a chart's triangles, relative to the radius of the tool [1].
const EDGE_SHARE: f64 = 0.25;
/// Longest edge of the samples of a mesh of very many triangles, relative to that of the chart [1].
const SAMPLE_SHARE: f64 = 1.0 / 3.0;

/// Settings with which a sheet is made of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetConfig {
    /// Radius r_s of the tool's collision sphere \[m\]: shapes much smaller than the tool are smoothed.
    pub tool_radius: f64,
    /// The part and the side of the mesh that are wiped.
    pub choice: PartChoice,
    /// Largest stretch of 99 % of the area \[1\].
    pub stretch_limit: f64,
}

impl Default for SheetConfig {
    fn default() -> Self {
        Self {
            tool_radius: 0.06,
            choice: PartChoice::default(),
            stretch_limit: 0.03,
        }
    }
}

/// A surface at the scale of a tool, before it is unrolled.
#[derive(Clone)]
pub(super) struct Prepared {
    pub(super) surface: Triangles,
    /// The vertices before smoothing, which lie on the mesh as given.
    pub(super) given: Vec<Point3>,
    pub(super) fits: Vec<LocalFit>,
    pub(super) survey: MeshSurvey,
    pub(super) smoothed_by: f64,
    /// Vertex before smoothing that moved farthest [m].
    pub(super) smoothed_at: Point3,
    /// Whether each triangle lies beyond the seams of a patch; empty if there are none beyond.
    pub(super) is_beyond: Vec<bool>,
}

impl Prepared {
    /// Takes the chosen part, remeshes and smooths it.
    pub(super) fn new(mesh: &Mesh, config: &SheetConfig) -> Result<Self, SheetError> {
        check_settings(config)?;
        let part = take_part(mesh, &config.choice)?;
        let longest = EDGE_SHARE * config.tool_radius;
        // Triangles of edges up to `longest` have at most this area.
        let largest = 0.25 * 3f64.sqrt() * longest * longest;
        if part.surface.area() / largest > MAX_SHEET_TRIANGLES as f64 {
            return Err(too_large(config));
        }
        let mut samples = split_long_edges(&part.surface, longest);
        if samples.triangles.len() > MAX_SHEET_TRIANGLES {
            samples = remesh(&part.surface, SAMPLE_SHARE * longest);
        }
        let mut surface = remesh(&samples, longest);
        if surface.triangles.len() > MAX_SHEET_TRIANGLES {
            return Err(too_large(config));
        }
        if surface.triangles.is_empty() {
            return Err(SheetError::NoArea {
                triangles: part.surface.triangles.len(),
            });
        }
        // Of a mesh of very many triangles, only the coarser surface has edges that are short everywhere.
        let samples = if has_edges_beyond(&samples, longest) {
            surface.clone()
        } else {
            samples
        };
        let fits = fit_vertices(&surface, &samples, config.tool_radius, longest);
        let given = surface.vertices.clone();
        let (smoothed_by, smoothed_at) = find_most_smoothed(&given, &fits);
        for (vertex, fit) in surface.vertices.iter_mut().zip(&fits) {
            *vertex = fit.point;
        }
        Ok(Self {
            surface,
            given,
            fits,
            survey: part.survey,
            smoothed_by,
            smoothed_at,
            is_beyond: Vec::new(),
        })
    }

    /// Whether a triangle lies beyond the seams of a patch.
    pub(super) fn is_beyond(&self, triangle: usize) -> bool {
        self.is_beyond.get(triangle).copied().unwrap_or(false)
    }

    /// Returns a part of the surface.
    pub(super) fn select(&self, triangles: &[u32]) -> Self {
        let used = self.surface.used_vertices(triangles);
        let (surface, origins) = self.surface.select(triangles).with_single_fans();
        let origin = |&origin: &u32| used[origin as usize] as usize;
        let origins: Vec<usize> = origins.iter().map(origin).collect();
        let given: Vec<Point3> = origins.iter().map(|&i| self.given[i]).collect();
        let fits: Vec<LocalFit> = origins.iter().map(|&i| self.fits[i]).collect();
        let (smoothed_by, smoothed_at) = find_most_smoothed(&given, &fits);
        Self {
            surface,
            given,
            fits,
            survey: self.survey.clone(),
            smoothed_by,
            smoothed_at,
            is_beyond: Vec::new(),
        }
    }
}

/// Returns the largest distance by which smoothing moves a vertex [m], and that vertex; a surface has at least one.
fn find_most_smoothed(given: &[Point3], fits: &[LocalFit]) -> (f64, Point3) {
    let moved =
        (given.iter().zip(fits)).map(|(vertex, fit)| ((vertex - fit.point).norm(), *vertex));
    moved.fold(
        (0.0, given[0]),
        |most, one| {
            if one.0 > most.0 { one } else { most }
        },
    )
}

/// The error of a surface with too many triangles.
pub(super) fn too_large(config: &SheetConfig) -> SheetError {
    SheetError::TooLarge {
        tool_radius: config.tool_radius,
        limit: MAX_SHEET_TRIANGLES,
    }
}

fn check_settings(config: &SheetConfig) -> Result<(), SheetError> {
    let check = |name, value: f64, limits: [f64; 2]| {
        if (limits[0]..=limits[1]).contains(&value) {
            Ok(())
        } else {
            Err(SheetError::Setting {
                name,
                value,
                limits,
            })
        }
    };
    check("tool radius [m]", config.tool_radius, TOOL_RADIUS_RANGE)?;
    check("limit of the stretch", config.stretch_limit, [0.001, 1.0])?;
    if let Some(lean) = config.choice.largest_lean {
        check("largest lean [rad]", lean, [0.01, PI])?;
    }
    let infinite = |v: &f64| !v.is_finite();
    for vector in [
        config.choice.towards,
        config.choice.seed_point.map(|p| p.coords),
    ] {
        if let Some(&value) = vector.iter().flat_map(|v| v.iter()).find(|v| infinite(v)) {
            let limits = [-1e4, 1e4];
            return Err(SheetError::Setting {
                name: "coordinate of the seed point or direction",
                value,
                limits,
            });
        }
    }
    if let Some(value) = config
        .choice
        .towards
        .map(|towards| towards.norm())
        .filter(|&n| n < 1e-9)
    {
        return Err(SheetError::Setting {
            name: "length of the direction to the tool",
            value,
            limits: [1e-9, 1e9],
        });
    }
    Ok(())
}
