//! The axis that a COLLADA file declares to point up, which is not applied.

use wisch::geometry::MeshFormat;

/// Returns a remark on a mesh file that declares another axis than z to point up; `file`: its name.
///
/// ```
/// use wisch_io::up_axis_remark;
/// let remark = up_axis_remark("door.dae", b"<asset><up_axis>Y_UP</up_axis></asset>");
/// assert!(remark.is_some_and(|remark| remark.starts_with("mesh \"door.dae\": <up_axis> is Y_UP")));
/// assert_eq!(up_axis_remark("door.dae", b"<asset><up_axis>Z_UP</up_axis></asset>"), None);
/// ```
pub fn up_axis_remark(file: &str, bytes: &[u8]) -> Option<String> {
    if MeshFormat::from_file_name(file) != Some(MeshFormat::Collada) {
        return None;
    }
    let (_, rest) = std::str::from_utf8(bytes).ok()?.split_once("<up_axis>")?;
    let (declared, _) = rest.split_once('<')?;
    let (axis, rotation) = match declared.trim() {
        "X_UP" => ("X_UP", "[0.0, -1.5708, 0.0]"),
        "Y_UP" => ("Y_UP", "[1.5708, 0.0, 0.0]"),
        _ => return None,
    };
    Some(format!(
        "mesh {file:?}: <up_axis> is {axis}, which is not applied, as in ROS: the file's x, y and z are taken as they stand. If the mesh lies on its side, export it with Z_UP, or, for a surface or object, turn it with rpy_rad = {rotation}"
    ))
}
