//! The report of `wisch surface check` in words.

use super::checked::CheckedMesh;
use super::measures::{Measures, PlacedValue};
use crate::commands::words::{format_count, percent};
use wisch::geometry::{MeshSurvey, Sheet};

/// Bends that lower the surface by less than this over the radius of the tool count as none [m].
const NOTICED_SAG: f64 = 5e-5;

/// Describes the mesh, its chart, and what is wrong.
pub(super) fn report(checked: &CheckedMesh) -> String {
    let size = checked.extent;
    let mut text = format!(
        "{}: {}, {:.3} x {:.3} x {:.3} m\n",
        checked.name,
        format_count(checked.triangles, "triangle"),
        size.x,
        size.y,
        size.z
    );
    let mut line = |name: &str, value: &str| text += &format!("  {name:<11} {value}\n");
    if let Some((sheet, measures)) = &checked.sheet {
        line("part", &describe_part(sheet.survey(), sheet.area()));
        if let Some(repairs) = describe_repairs(sheet.survey()) {
            line("repairs", &repairs);
        }
        line("borders", &describe_borders(sheet.survey()));
        line("chart", &describe_chart(sheet));
        line("stretch", &describe_stretch(sheet));
        line("bend", &describe_bend(checked, measures));
        line("normals", &describe_normals(measures));
        line(
            "smoothing",
            &format!(
                "up to {:.2} mm, at {}",
                1e3 * sheet.smoothed_by(),
                format_place(&sheet.smoothed_at().coords.into())
            ),
        );
        line("tool", &describe_contact(checked, sheet, measures));
    }
    for note in &checked.notes {
        line("note", note);
    }
    if let (Some(path), Some(_)) = (checked.picture, &checked.sheet) {
        line("picture", &path.display().to_string());
    }
    match &checked.problem {
        None => line("usable", "yes, in one chart"),
        Some(problem) => {
            line("usable", "not as it is");
            line("problem", &problem.to_string());
            if let Some(advice) = checked.advice() {
                line("advice", &advice);
            }
        }
    }
    text
}

pub(super) fn describe_part(survey: &MeshSurvey, area: f64) -> String {
    let parts = survey.part_areas.len();
    let all: f64 = survey.part_areas.iter().sum();
    let taken = survey.part_areas[survey.taken_part];
    let mut text = match parts {
        1 => "the whole mesh".to_owned(),
        _ => format!(
            "number {} by size of {}, {} of the area; --seed-point takes another",
            survey.taken_part + 1,
            format_count(parts, "part"),
            percent(taken / all)
        ),
    };
    if survey.side_triangles < survey.part_triangles {
        text += &format!(
            "; the side towards the tool has {} of {} triangles",
            survey.side_triangles, survey.part_triangles
        );
    }
    if survey.is_turned {
        text += "; its triangles were turned towards the tool";
    }
    format!("{text}; {area:.4} m2")
}

fn describe_repairs(survey: &MeshSurvey) -> Option<String> {
    let repairs = &survey.repairs;
    let mut parts = Vec::new();
    if repairs.welded > 0 {
        parts.push(format!(
            "merged {}",
            format_count(repairs.welded, "near vertex").replace("vertexs", "vertices")
        ));
    }
    if repairs.dropped > 0 {
        parts.push(format!(
            "dropped {} without area or repeated",
            format_count(repairs.dropped, "triangle")
        ));
    }
    if repairs.split > 0 {
        parts.push(format!(
            "split {} at vertices within them",
            format_count(repairs.split, "edge")
        ));
    }
    if survey.flipped > 0 {
        parts.push(format!(
            "turned {} of {} triangles to the side of the other ones",
            survey.flipped, survey.part_triangles
        ));
    }
    if survey.shared_edges > 0 {
        parts.push(format!(
            "cut {} that more than two triangles share",
            format_count(survey.shared_edges, "edge")
        ));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn describe_borders(survey: &MeshSurvey) -> String {
    match survey.border_lengths.as_slice() {
        [] => "none: the surface is closed".to_owned(),
        [outer] => format!("{outer:.3} m, no hole"),
        [outer, holes @ ..] => {
            let count = holes.len();
            let holes = holes.iter().take(3).map(|length| format!("{length:.3}"));
            let rest = if count > 3 { ", ..." } else { "" };
            format!(
                "{outer:.3} m; {} of {}{rest} m around",
                format_count(count, "hole"),
                holes.collect::<Vec<_>>().join(", ")
            )
        }
    }
}

pub(super) fn describe_chart(sheet: &Sheet) -> String {
    let bounds = wisch::geometry::Bounds2::from_points(sheet.outline().outer().iter().copied());
    let size = bounds.map_or_else(Default::default, |bounds| bounds.size());
    format!(
        "{:.3} x {:.3} m, {}",
        size.x,
        size.y,
        format_count(sheet.triangle_count(), "triangle")
    )
}

fn describe_stretch(sheet: &Sheet) -> String {
    let stretch = sheet.stretch();
    format!(
        "{} at most, at {}; {} on 99 % of the area, {} in the median, {} over a disc of the tool's radius",
        percent(stretch.most),
        format_place(&stretch.at.coords.into()),
        percent(stretch.p99),
        percent(stretch.median),
        percent(stretch.at_tool_scale)
    )
}

fn describe_bend(checked: &CheckedMesh, measures: &Measures) -> String {
    let reach = checked.tool_radius;
    let radius = |bend: &PlacedValue, name: &str, sign: f64| {
        if 0.5 * sign * bend.value * reach * reach > NOTICED_SAG {
            let radius = 1.0 / bend.value.abs();
            format!(
                "{name} to a radius of {radius:.3} m at {}",
                format_place(&bend.at)
            )
        } else {
            format!("no {name}")
        }
    };
    format!(
        "{}; {}",
        radius(&measures.bulge, "bulges", 1.0),
        radius(&measures.hollow, "hollows", -1.0)
    )
}

fn describe_normals(measures: &Measures) -> String {
    let n = measures.mean_normal;
    format!(
        "{:.3} rad from their mean ({:.2}, {:.2}, {:.2}) on average, {:.3} rad at most, at {}",
        measures.mean_lean,
        n.x,
        n.y,
        n.z,
        measures.largest_lean.value,
        format_place(&measures.largest_lean.at)
    )
}

fn describe_contact(checked: &CheckedMesh, sheet: &Sheet, measures: &Measures) -> String {
    let [x, y] = checked.args.tool_size;
    let needed = &measures.needed_compression;
    format!(
        "{x:.3} x {y:.3} m with {:.1} mm of compression touches with its whole footprint on {} of {}, at the better of two yaws; \
         it needs at most {:.1} mm, at {}",
        1e3 * checked.args.compression_depth_m,
        percent(measures.touched_share),
        touched_area(sheet, checked.args.compression_depth_m),
        1e3 * needed.value,
        format_place(&needed.at)
    )
}

/// The area to which a share that the tool touches refers, in words; the smoothed one, where the tool does not follow the mesh.
pub(super) fn touched_area(sheet: &Sheet, depth: f64) -> &'static str {
    if sheet.is_smoothed_beyond(depth) {
        "the smoothed area (on the mesh as given, less: the smoothing exceeds the compression)"
    } else {
        "the area"
    }
}

/// Formats a place [m].
pub(super) fn format_place(at: &[f64; 3]) -> String {
    let [x, y, z] = at;
    format!("({x:.3}, {y:.3}, {z:.3}) m")
}
