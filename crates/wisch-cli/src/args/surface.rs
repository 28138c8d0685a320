//! Arguments of `surface`.

use clap::{Args, Subcommand, ValueHint};
use std::path::PathBuf;
use wisch::geometry::{MAX_CHARTS, Vector3};

/// The subcommands of `surface`.
#[derive(Debug, Subcommand)]
pub enum SurfaceCommand {
    /// Check whether a mesh is usable as a curved surface: its parts, its chart, and where a tool touches it
    #[command(after_help = "\
Examples:
  wisch surface check door.ply
  wisch surface check door.stl --scale 0.001 --tool-size 0.05,0.08 --picture door.svg
  wisch surface check part.stl --towards 0,0,1            one side of a closed body
  wisch surface check cart.ply --seed-point 0.8,-0.2,0.1  the part of the mesh near a point
  wisch surface check door.ply --json | jq .chart.stretch
  wisch surface check terrain.asc                         a height field over x and y

wisch merges vertices, orients the triangles, smooths the surface to the scale of the tool, and unrolls it into a chart with as little distortion as possible. The chart is usable if at most 1 % of its area is stretched by more than the limit, no triangle lies upside down, and the chart does not cover itself. `surface.mesh` of a task file takes a mesh that one chart covers; `wisch surface split` divides other meshes.

Exit codes: 0 the mesh is usable, 1 it is not usable as it is, 2 an error.")]
    Check(SurfaceCheckArgs),
    /// Divide a mesh that does not unroll into one chart into patches that do
    #[command(after_help = "\
Examples:
  wisch surface split wok.ply
  wisch surface split wok.ply --picture wok.svg
  wisch surface split tub.stl --scale 0.001 --towards 0,0,1 --out tub-patches
  wisch surface split wok.ply --json | jq '.patches[].area_m2'

wisch divides the surface into few patches whose charts stay within --stretch-limit, and numbers them so that each patch is near the previous one. The same mesh and options give the same patches. `surface.mesh.patch` of a task file takes one of them.

Exit codes: 0 the mesh is divided, 1 it is not usable as it is, 2 an error.")]
    Split(SurfaceSplitArgs),
}

/// Arguments of `surface check`.
#[derive(Debug, Args)]
pub struct SurfaceCheckArgs {
    #[command(flatten)]
    pub mesh: SurfaceMeshArgs,
    /// Draw the surface, unrolled into one chart, into this .svg file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub picture: Option<PathBuf>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `surface split`.
#[derive(Debug, Args)]
pub struct SurfaceSplitArgs {
    #[command(flatten)]
    pub mesh: SurfaceMeshArgs,
    /// Largest number of patches
    #[arg(long, value_name = "N", default_value_t = MAX_CHARTS as u16, value_parser = clap::value_parser!(u16).range(1..=MAX_CHARTS as i64))]
    pub max_patches: u16,
    /// Draw the patches, on the surface unrolled as one piece, into this .svg file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub picture: Option<PathBuf>,
    /// Write each patch as a mesh and a picture, and a picture of all, into this new folder
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// A mesh, the part of it that is the surface, and the tool.
#[derive(Debug, Args)]
pub struct SurfaceMeshArgs {
    /// Mesh file (.stl, .obj, .dae or .ply), or height field (.asc, Esri ASCII raster)
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Metres per unit of the file, such as 0.001 for millimetres
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = parse_factor)]
    pub scale: f64,
    /// Sides of the tool's footprint [m]
    #[arg(long, value_name = "X,Y", default_value = "0.06,0.10", value_parser = parse_sides)]
    pub tool_size: [f64; 2],
    /// Radius of the tool [m]: smaller shapes are smoothed [default: half the diagonal of its footprint]
    #[arg(long, value_name = "METRES", value_parser = parse_metres)]
    pub tool_radius: Option<f64>,
    /// Compression depth of the tool under nominal force [m]
    #[arg(long, value_name = "METRES", default_value_t = 0.01, value_parser = parse_metres)]
    pub compression_depth_m: f64,
    /// Take the part of the mesh that is nearest to this point [m] [default: the largest part]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_vector)]
    pub seed_point: Option<Vector3>,
    /// Direction from the surface to the tool; required for a closed mesh [default: the side to which the normals of most of the area point in the file]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_vector)]
    pub towards: Option<Vector3>,
    /// Leave out triangles whose normals deviate from --towards by more than this angle [rad] [default: 1.2 for a closed
    /// mesh, else no limit]
    #[arg(long, value_name = "RADIANS", requires = "towards")]
    pub largest_lean: Option<f64>,
    /// Largest stretch of lengths on 99 % of the area [1]
    #[arg(long, value_name = "SHARE", default_value_t = 0.03)]
    pub stretch_limit: f64,
}

fn parse_number(text: &str) -> Result<f64, String> {
    let number: f64 = (text.trim().parse()).map_err(|_| format!("{text:?} is not a number"))?;
    if number.is_finite() {
        Ok(number)
    } else {
        Err(format!("{text:?} is not finite"))
    }
}

fn parse_numbers<const N: usize>(text: &str, example: &str) -> Result<[f64; N], String> {
    let parts = text
        .split(',')
        .map(parse_number)
        .collect::<Result<Vec<f64>, _>>()?;
    let count = parts.len();
    parts
        .try_into()
        .map_err(|_| format!("{count} numbers, expected {N}; write them as {example}"))
}

fn parse_vector(text: &str) -> Result<Vector3, String> {
    parse_numbers(text, "0,0,1").map(|[x, y, z]| Vector3::new(x, y, z))
}

fn parse_sides(text: &str) -> Result<[f64; 2], String> {
    let sides = parse_numbers(text, "0.06,0.10")?;
    sides
        .map(check_range)
        .into_iter()
        .collect::<Result<Vec<f64>, _>>()?;
    Ok(sides)
}

fn parse_metres(text: &str) -> Result<f64, String> {
    parse_number(text).and_then(check_range)
}

fn check_range(length: f64) -> Result<f64, String> {
    if (1e-4..=5.0).contains(&length) {
        Ok(length)
    } else {
        Err(format!("{length} m is outside 0.0001 to 5 m"))
    }
}

fn parse_factor(text: &str) -> Result<f64, String> {
    let factor = parse_number(text)?;
    if (1e-6..=1e3).contains(&factor) {
        Ok(factor)
    } else {
        Err(format!("{factor} is outside 0.000001 to 1000"))
    }
}
