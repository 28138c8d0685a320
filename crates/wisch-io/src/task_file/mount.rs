//! The mount of the tool on the robot, as a task declares it.

use super::TaskError;
use super::deserialize::At;
use super::tables::{MountName, MountTable};
use nalgebra::{Translation3, UnitQuaternion};
use wisch::geometry::Pose;
use wisch::represent::{Grip, Mount};

/// Lean of a hand over the tool that it holds by the rear edge, where the task declares none [rad].
const HAND_LEAN: f64 = 0.8;

/// Reads the table `tool.mount`.
///
/// # Errors
/// If keys belong to different mounts.
pub(super) fn mount(table: &At<MountTable>) -> Result<Mount, TaskError> {
    let given = &table.value;
    let on = given.on.as_ref();
    table.exactly_one(&[
        ("on", on.map(|on| &on.place)),
        ("point_m", given.point_m.as_ref().map(|point| &point.place)),
    ])?;
    let is_on = |name: MountName| on.is_some_and(|on| on.value == name);
    let (is_flange, is_hand) = (is_on(MountName::Flange), is_on(MountName::Hand));
    require(is_flange, &given.yaw_rad, "on = \"flange\"")?;
    require(is_flange, &given.distance_m, "on = \"flange\"")?;
    require(is_flange, &given.holder_radius_m, "on = \"flange\"")?;
    if let (Some(radius), None) = (&given.holder_radius_m, &given.distance_m) {
        return Err(radius.inconsistent("this key needs distance_m"));
    }
    require(is_flange, &given.axis, "on = \"flange\"")?;
    require(is_hand, &given.lean_rad, "on = \"hand\"")?;
    require(given.point_m.is_some(), &given.hand_rpy_rad, "point_m")?;
    if let Some(point) = &given.point_m {
        let turn = (given.hand_rpy_rad.as_ref()).ok_or_else(|| table.missing("hand_rpy_rad"))?;
        let [x, y, z] = point.value.map(|part| part.0);
        let [roll, pitch, yaw] = turn.value.map(|angle| angle.0);
        return Ok(Mount::Grip(Grip {
            tool_from_hand: Pose::from_parts(
                Translation3::new(x, y, z),
                UnitQuaternion::from_euler_angles(roll, pitch, yaw),
            ),
        }));
    }
    Ok(if is_hand {
        let lean = given.lean_rad.as_ref();
        Mount::Hand {
            lean: lean.map_or(HAND_LEAN, |lean| lean.value.0),
        }
    } else {
        Mount::Flange {
            yaw: given.yaw_rad.as_ref().map_or(0.0, |yaw| yaw.value.0),
            distance: (given.distance_m.as_ref()).map(|distance| distance.value.0),
            holder_radius: (given.holder_radius_m.as_ref()).map(|radius| radius.value.0),
            axis: given.axis.as_ref().map(|axis| axis.value.into()),
        }
    })
}

/// Checks that a key is given only together with its kind of mount.
fn require<T>(is_kind: bool, key: &Option<At<T>>, kind: &str) -> Result<(), TaskError> {
    match key {
        Some(key) if !is_kind => Err(key.inconsistent(format!("this key needs {kind}"))),
        _ => Ok(()),
    }
}
