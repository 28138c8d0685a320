//! The report of `wisch surface check` as JSON.

use super::checked::CheckedMesh;
use super::measures::PlacedValue;
use crate::args::SurfaceMeshArgs;
use crate::commands::words::internal;
use crate::failure::Failure;
use serde::Serialize;
use wisch::geometry::Sheet;

/// The schema of the object.
const SCHEMA: u32 = 1;

/// The object that `--json` prints. Lengths are in metres, angles in radians, stretches and shares in 1, curvatures in 1/m
/// and positive where the surface bulges towards the tool.
#[derive(Serialize)]
struct SurfaceRecord<'a> {
    format: &'static str,
    schema: u32,
    file: &'a str,
    usable: bool,
    /// Why the mesh is not usable as it is, and what to do.
    problem: Option<String>,
    advice: Option<String>,
    notes: &'a [String],
    triangles: usize,
    extent_m: [f64; 3],
    tool: ToolRecord,
    /// Null without a chart.
    mesh: Option<MeshRecord<'a>>,
    chart: Option<ChartRecord>,
}

/// The tool for which a mesh was unrolled.
#[derive(Serialize)]
pub(super) struct ToolRecord {
    size_m: [f64; 2],
    radius_m: f64,
    compression_depth_m: f64,
}

impl ToolRecord {
    pub(super) fn new(args: &SurfaceMeshArgs, radius: f64) -> Self {
        Self {
            size_m: args.tool_size,
            radius_m: radius,
            compression_depth_m: args.compression_depth_m,
        }
    }
}

#[derive(Serialize)]
struct MeshRecord<'a> {
    part_areas_m2: &'a [f64],
    taken_part: usize,
    part_triangles: usize,
    side_triangles: usize,
    closed: bool,
    turned: bool,
    flipped_triangles: usize,
    welded_vertices: usize,
    dropped_triangles: usize,
    split_edges: usize,
    shared_edges: usize,
    border_lengths_m: &'a [f64],
}

#[derive(Serialize)]
struct ChartRecord {
    triangles: usize,
    area_m2: f64,
    smoothed_by_m: f64,
    /// Point of the mesh that smoothing moved farthest.
    smoothed_at: [f64; 3],
    /// Whether smoothing removed shapes that the tool does not follow: `touched_share` then holds for the smoothed surface only.
    smoothed_beyond_compression: bool,
    estimated_charts: usize,
    stretch: StretchRecord,
    largest_bulge: PlacedValue,
    deepest_hollow: PlacedValue,
    mean_normal: [f64; 3],
    mean_lean_rad: f64,
    largest_lean: PlacedValue,
    touched_share: f64,
    needed_compression: PlacedValue,
}

/// How much a chart stretches lengths.
#[derive(Serialize)]
pub(super) struct StretchRecord {
    limit: f64,
    most: PlacedValue,
    p99: f64,
    p95: f64,
    median: f64,
    at_tool_scale: f64,
    share_beyond: f64,
    folded_triangles: usize,
}

/// Returns the object as a line.
pub(super) fn check_record(checked: &CheckedMesh) -> Result<String, Failure> {
    let record = SurfaceRecord {
        format: "wisch-surface-check",
        schema: SCHEMA,
        file: &checked.name,
        usable: checked.problem.is_none(),
        problem: checked.problem.as_ref().map(ToString::to_string),
        advice: checked.advice(),
        notes: &checked.notes,
        triangles: checked.triangles,
        extent_m: checked.extent.into(),
        tool: ToolRecord::new(checked.args, checked.tool_radius),
        mesh: checked.sheet.as_ref().map(|(sheet, _)| {
            let survey = sheet.survey();
            MeshRecord {
                part_areas_m2: &survey.part_areas,
                taken_part: survey.taken_part,
                part_triangles: survey.part_triangles,
                side_triangles: survey.side_triangles,
                closed: survey.is_closed,
                turned: survey.is_turned,
                flipped_triangles: survey.flipped,
                welded_vertices: survey.repairs.welded,
                dropped_triangles: survey.repairs.dropped,
                split_edges: survey.repairs.split,
                shared_edges: survey.shared_edges,
                border_lengths_m: &survey.border_lengths,
            }
        }),
        chart: checked.sheet.as_ref().map(|(sheet, measures)| ChartRecord {
            triangles: sheet.triangle_count(),
            area_m2: sheet.area(),
            smoothed_by_m: sheet.smoothed_by(),
            smoothed_at: sheet.smoothed_at().coords.into(),
            smoothed_beyond_compression: sheet.is_smoothed_beyond(checked.args.compression_depth_m),
            estimated_charts: sheet.estimate_charts(),
            stretch: stretch_record(sheet, checked.args.stretch_limit),
            largest_bulge: measures.bulge,
            deepest_hollow: measures.hollow,
            mean_normal: measures.mean_normal.into(),
            mean_lean_rad: measures.mean_lean,
            largest_lean: measures.largest_lean,
            touched_share: measures.touched_share,
            needed_compression: measures.needed_compression,
        }),
    };
    let text = serde_json::to_string(&record).map_err(internal)?;
    Ok(text + "\n")
}

/// Describes how much a chart stretches lengths.
pub(super) fn stretch_record(sheet: &Sheet, limit: f64) -> StretchRecord {
    let stretch = sheet.stretch();
    StretchRecord {
        limit,
        most: PlacedValue::new(stretch.most, stretch.at),
        p99: stretch.p99,
        p95: stretch.p95,
        median: stretch.median,
        at_tool_scale: stretch.at_tool_scale,
        share_beyond: stretch.share_beyond,
        folded_triangles: stretch.folded,
    }
}
