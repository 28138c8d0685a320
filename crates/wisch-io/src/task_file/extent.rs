//! Limits of the size of meshes, beyond which they are probably in another unit.

use super::TaskError;
use wisch::geometry::{LikelyUnits, Mesh};
use wisch::source_location::Place;

/// Limits of the longest side of a scene object, its length beyond which its unit is doubted, and its usual length [m].
pub(super) const OBJECT_EXTENT: [f64; 2] = [1e-3, 20.0];
pub(super) const LARGE_OBJECT: f64 = 5.0;
pub(super) const USUAL_OBJECT: [f64; 2] = [0.01, 2.0];
/// Usual length of a surface that is wiped [m].
pub(super) const USUAL_SURFACE: [f64; 2] = [0.1, 5.0];
/// Limits of the longest side of a tool, and its usual length [m].
const TOOL_EXTENT: [f64; 2] = [5e-3, 3.0];
const USUAL_TOOL: [f64; 2] = [0.03, 0.6];

/// A mesh whose longest side is outside its limits.
struct WrongExtent {
    /// Its longest side [m].
    extent: f64,
    /// The probable unit, and what to do.
    advice: String,
}

/// Checks that the longest side of a mesh is within its limits [m]. The error states the unit in
/// which the mesh probably is, one in which it has a usual length, and the advice that `how`
/// returns.
fn check_extent(
    mesh: &Mesh,
    [least, most]: [f64; 2],
    usual: [f64; 2],
    how: impl FnOnce(&LikelyUnits) -> String,
) -> Result<(), WrongExtent> {
    let extent = mesh.extent();
    if (least..=most).contains(&extent) {
        return Ok(());
    }
    let advice = match LikelyUnits::guess(extent, usual, [least, most]) {
        Some(units) => format!("{units}; {}", how(&units)),
        None => "correct its scale".to_owned(),
    };
    Err(WrongExtent {
        extent: rounded(extent),
        advice,
    })
}

/// Checks the size of the mesh of a scene object or surface that the file multiplies by `scale`; `usual` is its usual length [m].
pub(super) fn check_object(
    mesh: &Mesh,
    (file, at): (&str, &Place),
    scale: f64,
    usual: [f64; 2],
) -> Result<(), TaskError> {
    let how = |units: &LikelyUnits| {
        let factors = units.factors(|metres| rounded(scale * metres).to_string());
        format!("use scale = {factors}")
    };
    check_extent(mesh, OBJECT_EXTENT, usual, how)
        .map_err(|wrong| wrong.in_task(file, at, OBJECT_EXTENT))
}

/// Checks the size of the mesh of a tool.
pub(super) fn check_tool(mesh: &Mesh, (file, at): (&str, &Place)) -> Result<(), TaskError> {
    check_tool_mesh(mesh).map_err(|wrong| wrong.in_task(file, at, TOOL_EXTENT))
}

fn check_tool_mesh(mesh: &Mesh) -> Result<(), WrongExtent> {
    check_extent(mesh, TOOL_EXTENT, USUAL_TOOL, |_| {
        "save the mesh in metres".to_owned()
    })
}

/// Checks that the longest side of a tool's mesh is within the limits of tasks, 5 mm to 3 m.
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
