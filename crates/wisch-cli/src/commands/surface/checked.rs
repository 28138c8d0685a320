//! A mesh that was checked for use as a curved surface.

use super::measures::Measures;
use crate::args::SurfaceCheckArgs;
use crate::failure::Failure;
use wisch::geometry::{
    LikelyUnit, MAX_CHARTS, Mesh, MeshFormat, PartChoice, Point3, Sheet, SheetConfig, SheetError,
    Vector3,
};
use wisch_io::read;

/// Usual lengths of a surface that is wiped [m]; a mesh outside them is probably in another unit.
const USUAL_EXTENT: [f64; 2] = [0.02, 20.0];
/// Smoothing that moves the surface by more than this share of the compression depth is remarked on [1].
const NOTICED_SMOOTHING: f64 = 0.25;

/// A checked mesh.
pub(super) struct CheckedMesh<'a> {
    pub(super) args: &'a SurfaceCheckArgs,
    pub(super) name: String,
    pub(super) tool_radius: f64,
    pub(super) triangles: usize,
    pub(super) extent: Vector3,
    /// The chart; none if there cannot be one.
    pub(super) sheet: Option<(Sheet, Measures)>,
    /// The charts if the surface was cut into several.
    pub(super) charts: Vec<Sheet>,
    /// Why the mesh is not usable as it is.
    pub(super) problem: Option<SheetError>,
    pub(super) notes: Vec<String>,
}

/// Reads the mesh and unrolls it.
pub(super) fn check(args: &SurfaceCheckArgs) -> Result<CheckedMesh<'_>, Failure> {
    let name = args.file.display().to_string();
    let format = MeshFormat::from_file_name(&name).ok_or_else(|| {
        Failure::new(format!(
            "{name}: the name of a mesh file must end in .stl, .obj, .dae or .ply"
        ))
    })?;
    let mesh = Mesh::parse(&read(&args.file)?, format, &name).map_err(Failure::new)?;
    let scaled = mesh.vertices().iter().map(|p| p * args.scale).collect();
    let mesh = Mesh::new(scaled, mesh.triangles().to_vec())
        .map_err(|error| Failure::new(format!("{name}, scaled by {}: {error}", args.scale)))?;
    let [x, y] = args.tool_size;
    let tool_radius = args.tool_radius.unwrap_or(0.5 * (x * x + y * y).sqrt());
    let config = SheetConfig {
        tool_radius,
        choice: PartChoice {
            seed_point: args.seed_point.map(Point3::from),
            towards: args.towards,
            largest_lean: args.largest_lean,
        },
        stretch_limit: args.stretch_limit,
    };
    let (low, high) = mesh.bounds();
    let mut notes = Vec::new();
    let [least, most] = USUAL_EXTENT;
    if let Some(unit) = LikelyUnit::guess(mesh.extent(), least, most) {
        notes.push(format!(
            "the mesh is {:.4} m long; {unit} with --scale {}",
            mesh.extent(),
            unit.metres * args.scale
        ));
    }
    let mut charts = Vec::new();
    let (sheet, problem) = match Sheet::draft(&mesh, &config) {
        Ok(sheet) => {
            let mut problem = sheet.check().err();
            if problem.is_some() && args.charts > 1 {
                match Sheet::split(&mesh, &config, usize::from(args.charts)) {
                    Ok(found) => (charts, problem) = (found, None),
                    Err(error) => problem = Some(error),
                }
            }
            let measures = Measures::new(&sheet, args.tool_size, args.compression_depth_m);
            let smoothed = sheet.smoothed_by();
            if smoothed > NOTICED_SMOOTHING * args.compression_depth_m {
                notes.push(format!(
                    "smoothing to the scale of the tool moved the surface by up to {:.1} mm: the mesh has shapes that a \
                     tool of {tool_radius:.3} m radius does not follow",
                    1e3 * smoothed
                ));
            }
            (Some((sheet, measures)), problem)
        }
        Err(error @ SheetError::Setting { .. }) => return Err(Failure::new(error)),
        Err(error) => (None, Some(error)),
    };
    Ok(CheckedMesh {
        args,
        name,
        tool_radius,
        triangles: mesh.triangles().len(),
        extent: high - low,
        sheet,
        charts,
        problem,
        notes,
    })
}

impl CheckedMesh<'_> {
    /// Returns what to do about the problem.
    pub(super) fn advice(&self) -> Option<String> {
        Some(match self.problem.as_ref()? {
            SheetError::Closed { .. } => {
                "state the direction from the surface to the tool, such as --towards 0,0,1".to_owned()
            }
            SheetError::NoSide { .. } => {
                "correct --towards, or take a larger --largest-lean".to_owned()
            }
            SheetError::TooLarge { .. } => {
                "state the unit of the file with --scale, take a larger --tool-radius, or cut the mesh".to_owned()
            }
            SheetError::Stretched { .. }
            | SheetError::Folded { .. }
            | SheetError::Overlapping { .. }
                if 2 * usize::from(self.args.charts) > MAX_CHARTS =>
            {
                "smooth the mesh in a mesh editor, or take a larger --tool-radius, which smooths it".to_owned()
            }
            SheetError::Stretched { .. }
            | SheetError::Folded { .. }
            | SheetError::Overlapping { .. } => {
                let least = self.sheet.as_ref().map_or(1, |(sheet, _)| sheet.estimate_charts());
                let least = least.clamp(2, MAX_CHARTS).max(2 * usize::from(self.args.charts));
                format!(
                    "allow several charts, such as --charts {}, or take a part with --towards and --largest-lean",
                    least.next_power_of_two().min(MAX_CHARTS)
                )
            }
            _ => "repair the mesh in a mesh editor".to_owned(),
        })
    }
}
