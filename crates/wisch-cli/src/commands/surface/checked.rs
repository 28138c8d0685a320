//! A mesh that was checked for use as a curved surface.

use super::measures::Measures;
use crate::args::SurfaceMeshArgs;
use crate::failure::Failure;
use std::path::Path;
use wisch::geometry::{
    LikelyUnits, Mesh, MeshFormat, PartChoice, Point3, Sheet, SheetConfig, SheetError, Vector3,
};
use wisch_io::{read, up_axis_remark};

/// Usual lengths of a surface that is wiped [m]; a mesh outside them is probably in another unit.
const USUAL_EXTENT: [f64; 2] = [0.02, 20.0];
/// Length of most surfaces that are wiped [m].
const LIKELY_EXTENT: [f64; 2] = [0.1, 5.0];
/// Smoothing that moves the surface by more than this share of the compression depth is remarked on [1].
const NOTICED_SMOOTHING: f64 = 0.25;

/// A checked mesh.
pub(super) struct CheckedMesh<'a> {
    pub(super) args: &'a SurfaceMeshArgs,
    pub(super) picture: Option<&'a Path>,
    pub(super) name: String,
    pub(super) tool_radius: f64,
    pub(super) triangles: usize,
    pub(super) extent: Vector3,
    /// The chart; none if there cannot be one.
    pub(super) sheet: Option<(Sheet, Measures)>,
    /// Why the mesh is not usable as it is.
    pub(super) problem: Option<SheetError>,
    pub(super) notes: Vec<String>,
}

/// A mesh that was read, with how it is unrolled.
pub(super) struct ReadMesh {
    pub(super) name: String,
    pub(super) mesh: Mesh,
    pub(super) config: SheetConfig,
    pub(super) notes: Vec<String>,
}

/// Reads the mesh.
pub(super) fn read_mesh(args: &SurfaceMeshArgs) -> Result<ReadMesh, Failure> {
    let name = args.file.display().to_string();
    let format = MeshFormat::from_file_name(&name).ok_or_else(|| {
        Failure::new(format!(
            "{name}: the name of a mesh file must end in {}",
            MeshFormat::EXTENSIONS
        ))
    })?;
    let bytes = read(&args.file)?;
    let mesh = Mesh::parse(&bytes, format, &name).map_err(Failure::new)?;
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
    let mut notes: Vec<String> = up_axis_remark(&name, &bytes).into_iter().collect();
    if let Some(units) = LikelyUnits::guess(mesh.extent(), LIKELY_EXTENT, USUAL_EXTENT) {
        notes.push(format!(
            "the mesh is {:.4} m long; {units} with --scale {}",
            mesh.extent(),
            units.factors(|metres| (metres * args.scale).to_string())
        ));
    }
    Ok(ReadMesh {
        name,
        mesh,
        config,
        notes,
    })
}

/// Reads the mesh and unrolls it.
pub(super) fn check<'a>(
    args: &'a SurfaceMeshArgs,
    picture: Option<&'a Path>,
) -> Result<CheckedMesh<'a>, Failure> {
    let ReadMesh {
        name,
        mesh,
        config,
        mut notes,
    } = read_mesh(args)?;
    let (low, high) = mesh.bounds();
    let (sheet, problem) = match Sheet::draft(&mesh, &config) {
        Ok(sheet) => {
            let problem = sheet.check().err();
            let measures = Measures::new(&sheet, args.tool_size, args.compression_depth_m);
            notes.extend(remark_on_smoothing(&sheet, args, &config));
            (Some((sheet, measures)), problem)
        }
        Err(error @ SheetError::Setting { .. }) => return Err(Failure::new(error)),
        Err(error) => (None, Some(error)),
    };
    Ok(CheckedMesh {
        args,
        picture,
        name,
        tool_radius: config.tool_radius,
        triangles: mesh.triangles().len(),
        extent: high - low,
        sheet,
        problem,
        notes,
    })
}

/// A note on a smoothing that the tool's compression does not make up for.
pub(super) fn remark_on_smoothing(
    sheet: &Sheet,
    args: &SurfaceMeshArgs,
    config: &SheetConfig,
) -> Option<String> {
    let smoothed = sheet.smoothed_by();
    let is_beyond = sheet.is_smoothed_beyond(args.compression_depth_m);
    (is_beyond || smoothed > NOTICED_SMOOTHING * args.compression_depth_m).then(|| {
        let consequence = if is_beyond {
            "; that is more than its compression, and contact with these shapes is not predicted"
        } else {
            ""
        };
        let at = sheet.smoothed_at();
        format!(
            "smoothing to the scale of the tool moved the surface by up to {:.1} mm, at ({:.3}, {:.3}, {:.3}) m: the mesh has shapes that a tool of \
             {:.3} m radius does not follow{consequence}",
            1e3 * smoothed,
            at.x,
            at.y,
            at.z,
            config.tool_radius
        )
    })
}

/// Returns what to do about a mesh that does not unroll within the limit.
///
/// `divide`: what to do if several charts are needed.
pub(super) fn advise(problem: &SheetError, divide: &str) -> String {
    match problem {
        SheetError::Closed { .. } => {
            "state the direction from the surface to the tool, such as --towards 0,0,1"
        }
        SheetError::NoSide { .. } => "correct --towards, or take a larger --largest-lean",
        SheetError::TooLarge { .. } => {
            "state the unit of the file with --scale, take a larger --tool-radius, or cut the mesh"
        }
        SheetError::Stretched { .. }
        | SheetError::Folded { .. }
        | SheetError::Overlapping { .. } => divide,
        _ => "repair the mesh in a mesh editor",
    }
    .to_owned()
}

impl CheckedMesh<'_> {
    /// Returns what to do about the problem.
    pub(super) fn advice(&self) -> Option<String> {
        let divide = format!(
            "divide the surface into patches with wisch surface split {}, or take a part with --towards and --largest-lean",
            self.name
        );
        Some(advise(self.problem.as_ref()?, &divide))
    }
}
