//! `wisch footprint`: the area in which a tool touches the surface.

use crate::args::{FootprintArgs, GlobalArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use std::path::Path;
use wisch::geometry::{
    Mesh, MeshFormat, Polygon, RIGID_DEPTH, Region, Vector2, footprint as mesh_footprint,
};
use wisch::represent::{AngleRange, AreaOfEffect, KnowledgeBase, Tool, ToolEntry, ToolMesh};
use wisch_io::{
    KnowledgeSource, OutputFile, check_tool_extent, find_underside_offset, read, up_axis_remark,
};
use wisch_report::footprint_drawing;

/// A tool with the source of its footprint.
struct Touch {
    tool: Tool,
    compression_depth: f64,
    /// Whether the knowledge base gives an area of effect, which replaces the contact area.
    by_area_of_effect: bool,
    /// A remark on an axis that the mesh file declares to point up.
    up_axis: Option<String>,
}

/// Computes the footprint and prints its measures.
pub fn footprint(args: &FootprintArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    if let Some(path) = args.svg.as_deref()
        && path.extension().is_none_or(|ending| ending != "svg")
    {
        return Err(Failure::new(format!(
            "--svg {}: the file name must end in .svg",
            path.display()
        )));
    }
    let touch = match MeshFormat::from_file_name(&args.tool) {
        Some(format) => of_file(&args.tool, format, args.compression_depth_m)?,
        None => of_knowledge(args)?,
    };
    if let Some(path) = &args.svg {
        OutputFile::begin(path)?.finish(footprint_drawing(&touch.tool).as_bytes())?;
    }
    if !global.quiet {
        print(&in_words(&touch, args.svg.as_deref()))?;
    }
    Ok(Outcome::Done)
}

fn of_file(name: &str, format: MeshFormat, depth: Option<f64>) -> Result<Touch, Failure> {
    let bytes = read(Path::new(name))?;
    let Some(depth) = depth else {
        return Err(Failure::new(format!(
            "{name}: the compression depth of a mesh file is unknown"
        ))
        .with_help("give it with --compression-depth-m, such as 0.002 for a hard tool"));
    };
    measure_touch(name, &bytes, format, depth, None)
}

fn of_knowledge(args: &FootprintArgs) -> Result<Touch, Failure> {
    let source = KnowledgeSource::new(args.knowledge.as_deref());
    let knowledge = source.base()?;
    let entry = tool_entry(&args.tool, &knowledge)?;
    let ToolMesh::InKnowledge(file) = &entry.mesh else {
        return Err(Failure::new(format!(
            "tool {:?} has no mesh in the knowledge base",
            entry.name
        )));
    };
    let bytes = source.asset(file).map_err(Failure::new)?;
    let format = MeshFormat::from_file_name(file).ok_or_else(|| {
        Failure::new(format!(
            "tool {:?}: {file:?} is not a mesh file; its name must end in {}",
            entry.name,
            MeshFormat::EXTENSIONS
        ))
    })?;
    let depth = args
        .compression_depth_m
        .unwrap_or(entry.compression_depth_m.max(RIGID_DEPTH));
    measure_touch(&entry.name, &bytes, format, depth, entry.area_of_effect)
}

fn tool_entry<'a>(name: &str, knowledge: &'a KnowledgeBase) -> Result<&'a ToolEntry, Failure> {
    knowledge.tool(name).map_err(|error| {
        let failure = Failure::new(error);
        if Path::new(name).exists() {
            failure.with_help(format!(
                "{name:?} is a file, but the name of a mesh file must end in {}",
                MeshFormat::EXTENSIONS
            ))
        } else {
            failure.with_help(format!(
                "name a tool of the knowledge base, or a mesh file ({})",
                MeshFormat::EXTENSIONS
            ))
        }
    })
}

fn measure_touch(
    name: &str,
    bytes: &[u8],
    format: MeshFormat,
    compression_depth: f64,
    area_of_effect: Option<AreaOfEffect>,
) -> Result<Touch, Failure> {
    let in_tool = |error: &dyn std::fmt::Display| Failure::new(format!("{name}: {error}"));
    let mesh = Mesh::parse(bytes, format, name).map_err(Failure::new)?;
    check_tool_extent(&mesh).map_err(|problem| in_tool(&problem))?;
    let contact = mesh_footprint(&mesh, compression_depth).map_err(|error| in_tool(&error))?;
    let (footprint, size) = match area_of_effect {
        Some(AreaOfEffect { width_m, depth_m }) => {
            let size = Vector2::new(depth_m, width_m);
            (Region::new(vec![Polygon::rectangle(size)]), size)
        }
        None => {
            let bounds = contact
                .bounds()
                .ok_or_else(|| in_tool(&"the footprint is empty"))?;
            (contact, bounds.size())
        }
    };
    Ok(Touch {
        tool: Tool {
            name: name.to_owned(),
            mesh,
            footprint,
            area_of_effect: size,
            rotation_about_normal: AngleRange::FULL,
            tilt: None,
            mount: None,
            second_grip: None,
        },
        compression_depth,
        by_area_of_effect: area_of_effect.is_some(),
        up_axis: up_axis_remark(name, bytes),
    })
}

fn in_words(touch: &Touch, drawing: Option<&Path>) -> String {
    let tool = &touch.tool;
    let pieces = tool.footprint.polygons().len();
    let holes: usize = tool
        .footprint
        .polygons()
        .iter()
        .map(|p| p.holes().len())
        .sum();
    let size = tool.area_of_effect;
    let radius = tool.collision_radius();
    let mut lines = vec![
        ("compression", format!("{:.4} m", touch.compression_depth)),
        ("pieces", pieces.to_string()),
        ("holes", holes.to_string()),
        (
            "area",
            format!(
                "{:.6} m2 ({:.1} cm2)",
                tool.footprint.area(),
                1e4 * tool.footprint.area()
            ),
        ),
        (
            "area of effect",
            format!(
                "{:.4} m along the motion (x), {:.4} m across it (y)",
                size.x, size.y
            ),
        ),
        ("r_s", format!("{radius:.4} m")),
        ("d_s", format!("{:.4} m", 2.0 * radius)),
    ];
    if touch.by_area_of_effect {
        lines.push((
            "note",
            "the tool acts on the whole area of effect, not only in the contact area".to_owned(),
        ));
    }
    if let Some(offset) = find_underside_offset(&tool.mesh, 0.0, touch.compression_depth) {
        lines.push((
            "note",
            format!(
                "the lowest point of the mesh lies at z = {:.1} mm; tasks take z = 0 of the file for the contact plane",
                1e3 * offset
            ),
        ));
    }
    lines.extend((touch.up_axis.clone()).map(|remark| ("note", remark)));
    if let Some(path) = drawing {
        lines.push(("drawing", path.display().to_string()));
    }
    let mut text = format!("{}\n", tool.name);
    for (name, value) in lines {
        text += &format!("  {name:<15} {value}\n");
    }
    text
}
