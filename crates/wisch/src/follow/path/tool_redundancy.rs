//! The redundancy of the task: which orientations the tool may have at a pose of the plan (paper §3.3).

use crate::follow::ToolPose;
use crate::geometry::{PlanarPose, wrap_angle};
use crate::represent::Tool;
use std::f64::consts::{PI, TAU};

/// Angles nearer than this count as the same [rad].
const SAME_ANGLE: f64 = 1e-6;

/// An orientation of the tool relative to the planned one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::follow) struct ToolOrientation {
    /// Rotation about the surface normal against the planned heading [rad].
    pub rotation: f64,
    /// Lean about the tilt axis [rad].
    pub tilt: f64,
}

/// Returns all orientations that a tool may have, in steps of `increment` [rad], nearest to the planned one
/// first.
///
/// A tool that is symmetric under half a turn may also be reversed: half a turn counts as no rotation, and the
/// lean changes its sign.
pub(in crate::follow) fn orientations(tool: &Tool, increment: f64) -> Vec<ToolOrientation> {
    let range = tool.rotation_about_normal;
    let whole_turn = range.max_rad - range.min_rad > TAU - increment / 2.0;
    let rotations = multiples(range.min_rad, range.max_rad, increment, whole_turn);
    let tilts = tool.tilt.map_or_else(
        || vec![0.0],
        |tilt| multiples(tilt.range.min_rad, tilt.range.max_rad, increment, false),
    );
    let symmetric = tool.is_half_turn_symmetric();
    let mut all: Vec<ToolOrientation> = rotations
        .iter()
        .flat_map(|&rotation| {
            tilts
                .iter()
                .map(move |&tilt| ToolOrientation { rotation, tilt })
        })
        .collect();
    if symmetric && !whole_turn {
        let reversed = |orientation: &ToolOrientation| ToolOrientation {
            rotation: wrap_angle(orientation.rotation + PI),
            tilt: -orientation.tilt,
        };
        let reversed: Vec<ToolOrientation> = (all.iter().map(reversed))
            .filter(|orientation| all.iter().all(|known| !is_same(known, orientation)))
            .collect();
        all.extend(reversed);
    }
    all.sort_by(|a, b| rank(a, symmetric).total_cmp(&rank(b, symmetric)));
    all
}

/// Returns orientations in the order of trial: by their angle from the planned one, and by the rotation on this
/// edge beyond the planned one.
pub(in crate::follow) fn nearest_first(
    orientations: &[ToolOrientation],
    begin: &PlanarPose,
    from: &ToolPose,
    symmetric: bool,
) -> Vec<ToolOrientation> {
    let mut order = orientations.to_vec();
    let cost = |orientation: &ToolOrientation| deviation(orientation, begin, from, symmetric);
    order.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    order
}

/// Returns the rotation of the tool from the plan at the end of an edge, and the additional rotation on the way
/// [rad].
pub(in crate::follow) fn deviation(
    orientation: &ToolOrientation,
    begin: &PlanarPose,
    from: &ToolPose,
    symmetric: bool,
) -> f64 {
    rank(orientation, symmetric) + change(begin, orientation, from).abs()
}

/// Returns the angle between an orientation and the planned one [rad], rounded for comparison.
pub(in crate::follow) fn rank(orientation: &ToolOrientation, symmetric: bool) -> f64 {
    let turned = wrap_angle(orientation.rotation).abs();
    let turned = if symmetric {
        turned.min(PI - turned)
    } else {
        turned
    };
    ((turned + orientation.tilt.abs()) / SAME_ANGLE).round() * SAME_ANGLE
}

/// Whether two orientations are the same up to whole turns.
fn is_same(a: &ToolOrientation, b: &ToolOrientation) -> bool {
    wrap_angle(a.rotation - b.rotation).abs() < SAME_ANGLE && (a.tilt - b.tilt).abs() < SAME_ANGLE
}

/// Returns the multiples of an increment within a range; the value nearest to zero if there is none.
fn multiples(min: f64, max: f64, increment: f64, whole_turn: bool) -> Vec<f64> {
    let slack = 1e-9;
    let first = ((min - slack) / increment).ceil() as i64;
    let last = ((max + slack) / increment).floor() as i64;
    let mut values: Vec<f64> = (first..=last).map(|i| i as f64 * increment).collect();
    if whole_turn && values.len() > 1 {
        // Half a turn in either direction gives the same orientation.
        values.remove(0);
    }
    if values.is_empty() {
        values.push(0.0_f64.clamp(min, max));
    }
    values
}

/// Returns a planned pose with another rotation and tilt of the tool, on the surface, as it is first reached:
/// turned from `heading` by at most half a turn.
pub(in crate::follow) fn turn_pose(
    planned: &PlanarPose,
    orientation: &ToolOrientation,
    heading: f64,
) -> ToolPose {
    let turn = wrap_angle(planned.heading + orientation.rotation - heading);
    ToolPose {
        surface_from_tool: PlanarPose::new(planned.position, heading + turn),
        height: 0.0,
        tilt: orientation.tilt,
    }
}

/// Returns the end of an edge: the tool turns as planned, and by the change of its rotation against the plan.
///
/// The effect of a turning tool on particles depends on the direction of rotation, so that this direction is
/// kept.
pub(in crate::follow) fn turn_along_edge(
    planned: [&PlanarPose; 2],
    orientation: &ToolOrientation,
    from: &ToolPose,
) -> ToolPose {
    let [begin, end] = planned;
    let heading = from.surface_from_tool.heading;
    let turn = end.heading - begin.heading + change(begin, orientation, from);
    ToolPose {
        surface_from_tool: PlanarPose::new(end.position, heading + turn),
        height: 0.0,
        tilt: orientation.tilt,
    }
}

/// Returns the change of the rotation against the plan on an edge [rad].
pub(in crate::follow) fn change(
    begin: &PlanarPose,
    orientation: &ToolOrientation,
    from: &ToolPose,
) -> f64 {
    wrap_angle(orientation.rotation - (from.surface_from_tool.heading - begin.heading))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, Point2, Polygon, Region, Vector2, Vector3};
    use crate::represent::{AngleRange, TiltFreedom};

    fn tool(footprint: Polygon, range: f64) -> Tool {
        Tool {
            name: "blade".into(),
            mesh: Mesh::cuboid(Vector3::new(0.1, 0.3, 0.1)).unwrap(),
            footprint: Region::new(vec![footprint]),
            area_of_effect: Vector2::new(0.1, 0.3),
            rotation_about_normal: AngleRange {
                min_rad: -range,
                max_rad: range,
            },
            tilt: Some(TiltFreedom {
                axis_in_tool: Vector3::y_axis(),
                range: AngleRange {
                    min_rad: 0.0,
                    max_rad: 0.4,
                },
            }),
            mount: None,
            second_grip: None,
        }
    }

    #[test]
    fn a_symmetric_tool_may_be_reversed_leaning_the_other_way() {
        let blade = tool(Polygon::rectangle(Vector2::new(0.1, 0.3)), 0.5);
        let all = orientations(&blade, 0.2);
        // Five rotations and three tilts, and the same about half a turn.
        assert_eq!(all.len(), 2 * 5 * 3);
        for orientation in &all {
            let away = wrap_angle(orientation.rotation - PI).abs();
            let is_reversed = away < 0.5;
            assert!(is_reversed || orientation.rotation.abs() < 0.5);
            assert!(if is_reversed {
                orientation.tilt <= 0.0
            } else {
                orientation.tilt >= 0.0
            });
        }
        // It ranks like the planned one.
        assert_eq!(rank(&all[0], true), 0.0);
        assert_eq!(rank(&all[1], true), 0.0);
    }

    #[test]
    fn a_tool_that_turns_all_round_has_each_orientation_once() {
        let mut sponge = tool(Polygon::rectangle(Vector2::new(0.1, 0.3)), PI);
        sponge.tilt = None;
        assert_eq!(orientations(&sponge, PI / 6.0).len(), 12);
    }

    #[test]
    fn a_tool_with_a_leading_edge_is_not_reversed() {
        let corners = [[-0.05, -0.1], [0.05, -0.15], [0.05, 0.15], [-0.05, 0.1]];
        let corners = corners.map(|[x, y]| Point2::new(x, y)).to_vec();
        let scoop = tool(Polygon::new(corners, Vec::new()), 0.5);
        assert_eq!(orientations(&scoop, 0.2).len(), 5 * 3);
    }
}
