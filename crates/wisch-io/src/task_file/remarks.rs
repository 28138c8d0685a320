//! Remarks on a resolved task: which part of a file was used, and which values are probably errors.

use super::carrier::carrier_remark;
use super::extent::{LARGE_OBJECT, OBJECT_EXTENT, USUAL_OBJECT};
use wisch::geometry::{Bounds2, LikelyUnits, Mesh, Point3, Sheet};
use wisch::represent::{SceneObject, ScenePart, SurfaceShape, Task};

/// Distance of the middle of a contact area from the tool centre point above which a remark is made, over the radius of
/// the tool's collision sphere [1].
const BESIDE_CENTRE: f64 = 0.25;
/// Distance of a tool's underside from z = 0 of its frame above which a remark is made: at least this [m], and this share of
/// the tool's compression [1].
const OFF_CONTACT_PLANE: [f64; 2] = [1e-3, 0.1];
/// Distance of the points of a treated surface above which a remark is made, over the length of the tool across its lanes [1].
const WIDEST_SPACING: f64 = 0.2;
/// Largest height above or below a flat surface at which an obstacle counts as ending there [m].
const LARGEST_STEP: f64 = 5e-3;
/// Ratio of a scene mesh's length to the surface's length above which a remark is made [1].
const PER_SURFACE: f64 = 10.0;

/// Returns remarks on the files and numbers of a task, one sentence or more each.
pub(crate) fn task_remarks(task: &Task) -> Vec<String> {
    let mut remarks = surface_remarks(task);
    remarks.extend(smoothing_remark(task));
    remarks.extend(tool_remark(task));
    remarks.extend(underside_remark(task));
    remarks.extend(points_remark(task));
    remarks.extend(unit_remarks(task));
    remarks.extend(uncarried_remarks(task));
    remarks.extend(carrier_remark(task));
    remarks
}

/// Returns remarks on obstacles that end at a flat surface which no object carries: they may be what carries it.
fn uncarried_remarks(task: &Task) -> Vec<String> {
    let is_carried = (task.scene.iter()).any(|object| object.part == ScenePart::Carrier);
    let bounds = Bounds2::from_points(task.surface.outline.outer().iter().copied());
    let Some(bounds) = bounds.filter(|_| task.surface.shape.is_plane() && !is_carried) else {
        return Vec::new();
    };
    let middle = nalgebra::center(&bounds.min, &bounds.max);
    let obstacles = task.obstacles().zip(task.obstacles_in_surface());
    let below = obstacles.filter(|(_, mesh)| {
        let lies_below = |corners: [Point3; 3]| {
            let sides = [0, 1, 2].map(|i| {
                let (from, to) = (corners[i].xy(), corners[(i + 1) % 3].xy());
                (to - from).perp(&(middle - from))
            });
            let is_covered =
                sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0);
            is_covered && corners.iter().all(|corner| corner.z.abs() <= LARGEST_STEP)
        };
        mesh.bounds().1.z <= LARGEST_STEP && mesh.corners().any(lies_below)
    });
    let remark = |(object, _): (&SceneObject, _)| {
        let name = &object.name;
        format!(
            "object {name:?} ends at the surface, which no object carries: a robot and its tool keep clear of it as of any obstacle; if it lies under the surface and carries it, add carried_by = {name:?} to [surface]"
        )
    };
    below.map(remark).collect()
}

/// Returns remarks on the part of a mesh that is the surface: which one was taken, and whether it
/// is smaller than the tool.
fn surface_remarks(task: &Task) -> Vec<String> {
    let SurfaceShape::Mesh(mesh) = &task.surface.shape else {
        return Vec::new();
    };
    let (name, survey) = (&task.surface.name, mesh.sheet().survey());
    let mut remarks = Vec::new();
    if let Some(patch) = mesh.patch() {
        let seams = if task.action.treats() {
            "strokes reach over the seams, where passes and coats on the other patches are not counted"
        } else {
            "dirt that is pushed over a seam counts as lost"
        };
        remarks.push(format!(
            "surface {name:?} is patch {} of {} of its mesh, {:.3} of {:.3} m2; the robot avoids the other patches, and {seams}",
            patch.index + 1,
            patch.areas().count(),
            mesh.sheet().area(),
            patch.areas().sum::<f64>()
        ));
    }
    let all: f64 = survey.part_areas.iter().sum();
    let parts = survey.part_areas.len();
    if parts > 1 {
        let taken = survey.part_areas[survey.taken_part];
        remarks.push(format!(
            "surface {name:?} is 1 of {parts} parts of its mesh, {taken:.3} of {all:.3} m2; surface.mesh.seed_point_m takes another part, and the rest is no obstacle"
        ));
    }
    if survey.side_triangles < survey.part_triangles {
        remarks.push(format!(
            "surface {name:?} is the side of its mesh that faces the tool, {:.3} of {all:.3} m2; the rest is no obstacle",
            (mesh.patch()).map_or(mesh.sheet().area(), |patch| patch.areas().sum())
        ));
    }
    let size = |bounds: Option<Bounds2>| bounds.map_or(0.0, |bounds| bounds.size().max());
    let surface = size(Bounds2::from_points(
        task.surface.outline.outer().iter().copied(),
    ));
    let tool = size(task.tool.footprint.bounds());
    if surface < tool {
        remarks.push(format!(
            "surface {name:?} is {surface:.4} m long, less than the tool with {tool:.4} m: check its scale"
        ));
    }
    remarks
}

/// Returns a remark on a mesh of whose shape smoothing removed more than the tool makes up for.
fn smoothing_remark(task: &Task) -> Option<String> {
    let SurfaceShape::Mesh(mesh) = &task.surface.shape else {
        return None;
    };
    let (sheet, depth) = (mesh.sheet(), task.interaction.compression_depth_m);
    let at = sheet.smoothed_at();
    sheet.is_smoothed_beyond(depth).then(|| {
        format!(
            "surface {:?}: smoothing to the scale of the tool moved its mesh by up to {:.1} mm, at ({:.3}, {:.3}, {:.3}) m of the file; the tool makes up for {:.1} mm. Plan, prediction, estimate and simulation take the smoothed surface: contact with the grooves or ridges of the mesh is not predicted, and the true performance may be lower. Take a smaller or softer tool, or remove these shapes from the mesh",
            task.surface.name,
            1e3 * sheet.smoothed_by(),
            at.x,
            at.y,
            at.z,
            1e3 * Sheet::limit_smoothing(depth)
        )
    })
}

/// Returns a remark on a tool whose contact area has its middle beside the tool centre point.
fn tool_remark(task: &Task) -> Option<String> {
    let tool = &task.tool;
    let middle = tool.footprint.bounds()?.center();
    let aside = middle.coords.norm();
    (aside > BESIDE_CENTRE * tool.collision_radius()).then(|| {
        format!(
            "tool {:?}: the middle of its contact area lies at ({:.0}, {:.0}) mm of its origin, the tool centre point. Objects are avoided by {:.0} mm about this point only, and the offset of the surface is estimated as if the tool pressed there: move the origin of the mesh to the middle of the contact area",
            tool.name,
            1e3 * middle.x,
            1e3 * middle.y,
            1e3 * tool.collision_radius()
        )
    })
}

/// Largest distance of a tool's underside from z = 0 of its frame that needs no remark [m].
fn limit_underside(compression_depth: f64) -> f64 {
    let [least, share] = OFF_CONTACT_PLANE;
    least.max(share * compression_depth)
}

/// Returns the height of the lowest point of a tool's mesh over z = 0 of its file \[m\], if it is farther from there than 1 mm and
/// than a tenth of the compression \[m\]; `None` for a smaller distance.
///
/// `gap`: by how much the mesh was raised, for a tool that hovers \[m\].
pub fn find_underside_offset(mesh: &Mesh, gap: f64, compression_depth: f64) -> Option<f64> {
    let (low, _) = mesh.bounds();
    let offset = low.z - gap;
    (offset.abs() > limit_underside(compression_depth)).then_some(offset)
}

/// Returns a remark on a tool whose mesh does not begin at z = 0 of its frame, which poses in contact hold on the surface.
fn underside_remark(task: &Task) -> Option<String> {
    let (tool, interaction) = (&task.tool, &task.interaction);
    let (gap, depth) = (interaction.gap_m, interaction.compression_depth_m);
    let offset = find_underside_offset(&tool.mesh, gap, depth)?;
    let (off, limit) = (1e3 * offset.abs(), 1e3 * limit_underside(depth));
    let (side, consequence) = if offset > 0.0 {
        (
            "above",
            format!("the tool stays {off:.1} mm above the surface"),
        )
    } else {
        (
            "below",
            format!(
                "the tool is pressed {off:.1} mm too deep, and the robot may avoid the surface as an obstacle"
            ),
        )
    };
    Some(format!(
        "tool {:?}: the lowest point of its mesh lies {off:.1} mm {side} z = 0 of the file, where at most {limit:.1} mm are expected. Poses hold z = 0 at the contact plane, so {consequence}: move the mesh in the file until its underside lies at z = 0",
        tool.name
    ))
}

/// Returns a remark on points of a treated surface that are so few that the tool passes between them, or along a border.
fn points_remark(task: &Task) -> Option<String> {
    let width = task.tool.footprint.bounds()?.size().max();
    let count = task.particles.len();
    let area = task.surface.outline.area();
    let spacing = (area / count.max(1) as f64).sqrt();
    let limit = WIDEST_SPACING * width;
    (task.action.treats() && spacing > limit).then(|| {
        format!(
            "the performance is that of {count} points, which lie {spacing:.3} m apart, and not of the surface between them: lanes follow the points, so that strips of up to {:.3} m along the borders may stay untreated. The tool is {width:.3} m wide: multiply particles.count by at least {:.1}",
            0.5 * spacing,
            // Rows and columns of points are whole.
            1.2 * (spacing / limit).powi(2)
        )
    })
}

/// Returns remarks on scene meshes that are probably in other units: objects much longer than the surface.
fn unit_remarks(task: &Task) -> Vec<String> {
    let bounds = Bounds2::from_points(task.surface.outline.outer().iter().copied());
    let surface = bounds.map_or(0.0, |bounds| bounds.size().max());
    let limit = (PER_SURFACE * surface).max(LARGE_OBJECT);
    let large = (task.scene.iter()).filter(|object| object.mesh.extent() > limit);
    large
        .map(|object| {
            let extent = object.mesh.extent();
            let possible = [OBJECT_EXTENT[0], LARGE_OBJECT];
            let units = LikelyUnits::guess(extent, USUAL_OBJECT, possible);
            let unit = units.map_or(String::new(), |units| {
                format!("; if it should be smaller, {units}")
            });
            format!(
                "scene object {:?} is {extent:.1} m long, the surface {surface:.2} m{unit}",
                object.name
            )
        })
        .collect()
}
