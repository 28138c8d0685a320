//! `wisch surface split`: divides a mesh into patches that unroll with little stretch.

use super::checked::{ReadMesh, advise, read_mesh, remark_on_smoothing};
use super::measures::{Measures, PlacedValue};
use super::record::{StretchRecord, ToolRecord, stretch_record};
use super::report::{describe_chart, describe_part, format_place, touched_area};
use super::{check_name_of_picture, draw_chart, write};
use crate::args::{GlobalArgs, SurfaceMeshArgs, SurfaceSplitArgs};
use crate::commands::words::{format_count, internal, percent};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use serde::Serialize;
use std::path::Path;
use wisch::geometry::{Atlas, MAX_CHARTS, Mesh, Point2, Sheet, SheetConfig, SheetError};
use wisch_io::NewFolder;
use wisch_report::{PatchesInput, patches_drawing};

/// The schema of the object.
const SCHEMA: u32 = 1;

/// The object that `--json` prints. Lengths are in metres, angles in radians, stretches and shares in 1.
#[derive(Serialize)]
struct SplitRecord<'a> {
    format: &'static str,
    schema: u32,
    file: &'a str,
    /// Why the mesh is not divided, and what to do.
    problem: Option<String>,
    advice: Option<String>,
    notes: &'a [String],
    triangles: usize,
    tool: ToolRecord,
    patches: Vec<PatchRecord>,
    seams: Vec<SeamRecord>,
}

#[derive(Serialize)]
struct PatchRecord {
    /// From 1, as in `surface.mesh.patch`.
    number: usize,
    triangles: usize,
    area_m2: f64,
    /// The point at the chart's origin, in the frame of the mesh.
    middle_m: [f64; 3],
    stretch: StretchRecord,
    mean_normal: [f64; 3],
    mean_lean_rad: f64,
    largest_lean: PlacedValue,
    touched_share: f64,
    needed_compression: PlacedValue,
}

#[derive(Serialize)]
struct SeamRecord {
    patches: [usize; 2],
    length_m: f64,
}

/// A divided mesh.
struct SplitMesh<'a> {
    args: &'a SurfaceMeshArgs,
    read: ReadMesh,
    atlas: Result<Atlas, SheetError>,
    /// Largest number of patches.
    most: usize,
    /// Measures of each patch.
    measures: Vec<Measures>,
}

/// Divides the mesh, reports on the patches, and writes them.
pub fn split_surface(args: &SurfaceSplitArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    check_name_of_picture(args.picture.as_deref())?;
    if let Some(out) = args.out.as_deref().filter(|out| out.exists()) {
        return Err(Failure::new("the folder exists already")
            .within(out)
            .with_help("choose another folder with --out"));
    }
    let mut read = read_mesh(&args.mesh)?;
    let most = usize::from(args.max_patches);
    let atlas = match Atlas::from_mesh(&read.mesh, &read.config, most) {
        Err(error @ SheetError::Setting { .. }) => return Err(Failure::new(error)),
        atlas => atlas,
    };
    let charts = atlas.iter().flat_map(Atlas::charts);
    let measure = |chart| Measures::new(chart, args.mesh.tool_size, args.mesh.compression_depth_m);
    let measures = charts.map(measure).collect();
    let by_smoothing =
        |one: &&Sheet, other: &&Sheet| one.smoothed_by().total_cmp(&other.smoothed_by());
    let most_smoothed = (atlas.iter().flat_map(Atlas::charts)).max_by(by_smoothing);
    let smoothing =
        most_smoothed.and_then(|chart| remark_on_smoothing(chart, &args.mesh, &read.config));
    read.notes.extend(smoothing);
    let split = SplitMesh {
        args: &args.mesh,
        read,
        atlas,
        most,
        measures,
    };
    if let Ok(atlas) = &split.atlas {
        let picture = || split.draw(atlas);
        if let Some(path) = &args.picture {
            write(path, picture())?;
        }
        if let Some(out) = &args.out {
            split.write_patches(atlas, out, &picture())?;
        }
    }
    if args.json {
        print(&split.record()?)?;
    } else if !global.quiet {
        print(&split.report(args))?;
    }
    Ok(match split.atlas {
        Ok(_) => Outcome::Done,
        Err(_) => Outcome::GoalNotMet,
    })
}

impl SplitMesh<'_> {
    fn draw(&self, atlas: &Atlas) -> String {
        patches_drawing(&PatchesInput {
            title: &self.read.name,
            patches: &atlas.overview(),
        })
    }

    /// Writes the patches into a folder, which appears complete or not at all.
    fn write_patches(&self, atlas: &Atlas, out: &Path, picture: &str) -> Result<(), Failure> {
        let cannot = |error: std::io::Error| {
            Failure::new(format!("cannot write there: {error}")).within(out)
        };
        let folder = NewFolder::begin(out)?;
        let new = folder.path();
        std::fs::create_dir(&new).map_err(cannot)?;
        write(&new.join("patches.svg"), picture)?;
        for (index, chart) in atlas.charts().iter().enumerate() {
            let number = index + 1;
            let file = |ending: &str| new.join(format!("patch-{number}.{ending}"));
            let mesh: Mesh = atlas.patch_mesh(index);
            write(&file("stl"), mesh.to_binary_stl())?;
            let title = format!("{}, patch {number}", self.read.name);
            write(&file("svg"), draw_chart(&title, chart, self.args))?;
        }
        Ok(folder.finish()?)
    }

    /// Returns what to do about a problem.
    fn advise(&self, problem: &SheetError) -> String {
        let coarser = "take a larger tool, which smooths the mesh (--tool-radius), or cut the mesh";
        if self.most < MAX_CHARTS {
            let more = format!("allow more patches with --max-patches, or {coarser}");
            advise(problem, &more)
        } else {
            advise(problem, coarser)
        }
    }

    fn config(&self) -> &SheetConfig {
        &self.read.config
    }

    fn report(&self, args: &SurfaceSplitArgs) -> String {
        let count = format_count(self.read.mesh.triangles().len(), "triangle");
        let mut text = format!("{}: {count}\n", self.read.name);
        let mut line = |name: &str, value: &str| text += &format!("  {name:<11} {value}\n");
        let atlas = match &self.atlas {
            Ok(atlas) => atlas,
            Err(problem) => {
                line("problem", &problem.to_string());
                line("advice", &self.advise(problem));
                return text;
            }
        };
        let area: f64 = atlas.charts().iter().map(|chart| chart.area()).sum();
        if let Some(chart) = atlas.charts().first() {
            line("part", &describe_part(chart.survey(), area));
        }
        line("patches", &atlas.charts().len().to_string());
        let seams = atlas.seams();
        for (index, (chart, measures)) in atlas.charts().iter().zip(&self.measures).enumerate() {
            let stretch = chart.stretch();
            let (area, size) = (chart.area(), describe_chart(chart));
            let middle = format_place(&chart.extend(Point2::origin()).point.coords.into());
            line(
                &format!("patch {}", index + 1),
                &format!("{area:.4} m2, {size}, about {middle}"),
            );
            line(
                "",
                &format!(
                    "stretch {} on 99 % of the area, {} at most; normals {:.2} rad from their mean at most",
                    percent(stretch.p99),
                    percent(stretch.most),
                    measures.largest_lean.value
                ),
            );
            line(
                "",
                &format!(
                    "the tool touches {} of {} with its whole footprint",
                    percent(measures.touched_share),
                    touched_area(chart, self.args.compression_depth_m)
                ),
            );
            let with = |&[one, two]: &[usize; 2]| match (one == index, two == index) {
                (true, _) => Some(two),
                (_, true) => Some(one),
                _ => None,
            };
            let own = (seams.iter()).filter_map(|seam| Some((with(&seam.patches)?, seam.length)));
            let own: Vec<String> = own
                .map(|(other, length)| format!("{} ({length:.3} m)", other + 1))
                .collect();
            if !own.is_empty() {
                line("", &format!("seams with {}", own.join(", ")));
            }
        }
        for note in &self.read.notes {
            line("note", note);
        }
        for path in args.picture.iter().chain(&args.out) {
            line("written", &path.display().to_string());
        }
        text
    }

    fn record(&self) -> Result<String, Failure> {
        let charts = self.atlas.iter().flat_map(Atlas::charts);
        let patches = charts.zip(&self.measures).zip(1..);
        let patch = |((chart, measures), number): ((&wisch::geometry::Sheet, &Measures), usize)| {
            PatchRecord {
                number,
                triangles: chart.triangle_count(),
                area_m2: chart.area(),
                middle_m: chart.extend(Point2::origin()).point.coords.into(),
                stretch: stretch_record(chart, self.config().stretch_limit),
                mean_normal: measures.mean_normal.into(),
                mean_lean_rad: measures.mean_lean,
                largest_lean: measures.largest_lean,
                touched_share: measures.touched_share,
                needed_compression: measures.needed_compression,
            }
        };
        let seams = self.atlas.iter().flat_map(Atlas::seams);
        let record = SplitRecord {
            format: "wisch-surface-split",
            schema: SCHEMA,
            file: &self.read.name,
            problem: self.atlas.as_ref().err().map(ToString::to_string),
            advice: (self.atlas.as_ref().err()).map(|problem| self.advise(problem)),
            notes: &self.read.notes,
            triangles: self.read.mesh.triangles().len(),
            tool: ToolRecord::new(self.args, self.config().tool_radius),
            patches: patches.map(patch).collect(),
            seams: seams
                .map(|seam| SeamRecord {
                    patches: seam.patches.map(|index| index + 1),
                    length_m: seam.length,
                })
                .collect(),
        };
        let text = serde_json::to_string(&record).map_err(internal)?;
        Ok(text + "\n")
    }
}
