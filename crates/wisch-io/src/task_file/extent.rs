//! Limits of the size of meshes, beyond which they are probably in another unit.

use super::TaskError;
use wisch::geometry::{LikelyUnit, Mesh};
use wisch::source_location::Place;

/// Limits of the longest side of a scene object: minimum, maximum, and usual maximum [m].
pub(super) const OBJECT_EXTENT: [f64; 2] = [1e-3, 20.0];
pub(super) const USUAL_OBJECT: f64 = 5.0;
/// Limits of the longest side of a tool: minimum, maximum, and usual minimum [m].
const TOOL_EXTENT: [f64; 2] = [5e-3, 3.0];
const USUAL_TOOL: f64 = 0.03;

/// A mesh whose longest side is outside its limits.
struct WrongExtent {
    /// Its longest side [m].
    extent: f64,
    /// The probable unit, and what to do.
    advice: String,
}

/// Whether the longest side of a mesh is within its limits [m]; if not, the error says in which unit it probably is, one in which it
/// is as long as is usual, and by `how` what to do about a factor to metres.
fn check_extent(
    mesh: &Mesh,
    [least, most]: [f64; 2],
    [usually_least, usually_most]: [f64; 2],
    how: impl FnOnce(f64) -> String,
) -> Result<(), WrongExtent> {
    let extent = mesh.extent();
    if (least..=most).contains(&extent) {
        return Ok(());
    }
    let advice = match LikelyUnit::guess(extent, usually_least, usually_most) {
        Some(unit) => format!("{unit}; {}", how(unit.metres)),
        None => "correct its scale".to_owned(),
    };
    Err(WrongExtent {
        extent: rounded(extent),
        advice,
    })
}

/// Checks the size of the mesh of a scene object or surface that the file multiplies by `scale`.
pub(super) fn check_object(
    mesh: &Mesh,
    (file, at): (&str, &Place),
    scale: f64,
) -> Result<(), TaskError> {
    let usual = [OBJECT_EXTENT[0], USUAL_OBJECT];
    let how = |metres| format!("use scale = {}", rounded(scale * metres));
    check_extent(mesh, OBJECT_EXTENT, usual, how)
        .map_err(|wrong| wrong.in_task(file, at, OBJECT_EXTENT))
}

/// Checks the size of the mesh of a tool.
pub(super) fn check_tool(mesh: &Mesh, (file, at): (&str, &Place)) -> Result<(), TaskError> {
    check_tool_mesh(mesh).map_err(|wrong| wrong.in_task(file, at, TOOL_EXTENT))
}

fn check_tool_mesh(mesh: &Mesh) -> Result<(), WrongExtent> {
    let usual = [USUAL_TOOL, TOOL_EXTENT[1]];
    check_extent(mesh, TOOL_EXTENT, usual, |_| {
        "save the mesh in metres".to_owned()
    })
}

/// Whether the longest side of a tool's mesh is within the limits of tasks, 5 mm to 3 m.
///
/// # Errors
/// If it is not: the length, the limits, and the unit in which the mesh probably is.
pub fn check_tool_extent(mesh: &Mesh) -> Result<(), String> {
    let [least, most] = TOOL_EXTENT;
    check_tool_mesh(mesh).map_err(|WrongExtent { extent, advice }| {
        format!("the mesh is {extent} m long, expected {least} m to {most} m: {advice}")
    })
}

impl WrongExtent {
    fn in_task(self, file: &str, at: &Place, limits: [f64; 2]) -> TaskError {
        TaskError::MeshScale {
            at: at.clone(),
            file: file.to_owned(),
            extent: self.extent,
            limits,
            advice: self.advice,
        }
    }
}

/// Formats a number without rounding errors in its last digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.4e}").parse().unwrap_or(number)
}
