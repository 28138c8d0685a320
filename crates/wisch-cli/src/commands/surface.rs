//! `wisch surface`: whether a mesh is usable as a curved surface, and its division into patches.

mod checked;
mod measures;
mod record;
mod report;
mod split;

use self::checked::check;
use self::record::check_record;
use self::report::report;
pub use self::split::split_surface;
use crate::args::{GlobalArgs, SurfaceCheckArgs, SurfaceMeshArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use std::path::Path;
use wisch::geometry::Sheet;
use wisch::represent::{find_needed_compression, principal_curvatures};
use wisch_io::OutputFile;
use wisch_report::{SheetInput, sheet_drawing};

/// Reads the mesh, unrolls it, and reports on it.
pub fn check_surface(args: &SurfaceCheckArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    check_name_of_picture(args.picture.as_deref())?;
    let checked = check(&args.mesh, args.picture.as_deref())?;
    if let (Some(path), Some((sheet, _))) = (&args.picture, &checked.sheet) {
        write(path, draw_chart(&checked.name, sheet, &args.mesh))?;
    }
    if args.json {
        print(&check_record(&checked)?)?;
    } else if !global.quiet {
        print(&report(&checked))?;
    }
    Ok(match checked.problem {
        None => Outcome::Done,
        Some(_) => Outcome::GoalNotMet,
    })
}

/// Checks that the name of a picture ends in .svg.
fn check_name_of_picture(path: Option<&Path>) -> Result<(), Failure> {
    match path {
        Some(path) if path.extension().is_none_or(|ending| ending != "svg") => {
            let path = path.display();
            Err(Failure::new(format!(
                "--picture {path}: the file name must end in .svg"
            )))
        }
        _ => Ok(()),
    }
}

/// Draws a chart as SVG.
fn draw_chart(title: &str, sheet: &Sheet, args: &SurfaceMeshArgs) -> String {
    sheet_drawing(&SheetInput {
        title,
        sheet,
        stretch_limit: args.stretch_limit,
        needed_compression: &|point| {
            find_needed_compression(principal_curvatures(&point.bend), args.tool_size)
        },
        compression_depth: args.compression_depth_m,
    })
}

fn write(path: &Path, contents: impl AsRef<[u8]>) -> Result<(), Failure> {
    Ok(OutputFile::begin(path)?.finish(contents.as_ref())?)
}
