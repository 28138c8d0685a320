//! `wisch surface check`: whether a mesh is usable as a curved surface.

mod checked;
mod measures;
mod record;
mod report;

use self::checked::check;
use self::record::check_record;
use self::report::report;
use crate::args::{GlobalArgs, SurfaceCheckArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use wisch::represent::{find_needed_compression, principal_curvatures};
use wisch_report::{SheetInput, sheet_drawing};

/// Reads the mesh, unrolls it, and reports on it.
pub fn check_surface(args: &SurfaceCheckArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    if let Some(path) = args.picture.as_deref()
        && path.extension().is_none_or(|ending| ending != "svg")
    {
        let path = path.display();
        return Err(Failure::new(format!(
            "--picture {path}: the file name must end in .svg"
        )));
    }
    let checked = check(args)?;
    if let (Some(path), Some((sheet, _))) = (&args.picture, &checked.sheet) {
        let picture = sheet_drawing(&SheetInput {
            title: &checked.name,
            sheet,
            stretch_limit: args.stretch_limit,
            needed_compression: &|point| {
                find_needed_compression(principal_curvatures(&point.bend), args.tool_size)
            },
            compression_depth: args.compression_depth_m,
        });
        std::fs::write(path, picture).map_err(|error| {
            Failure::new(format!("{}: cannot write there: {error}", path.display()))
        })?;
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
