//! Algorithm 1 of paper §3.3: follows an edge with the tool's free degrees of freedom.

use super::arm::Arm;
use super::global::{self, Leg};
use super::tool_redundancy::{ToolOrientation, change, deviation, nearest_first, turn_along_edge};
use crate::follow::{AllowedContact, Attempt, SearchScope, ToolPose};
use crate::geometry::PlanarPose;
use crate::represent::Action;
use crate::robot::JointPositions;

/// Largest rotation of the tool on an edge beyond the planned one [rad]. Turning on the spot scatters the dirt
/// under the tool, so that beyond this it is lifted and put down again.
const MAX_TURN: f64 = 0.8;

/// Follows an edge in contact to a node. First it tries the planned orientation, towards the known
/// configuration `near`, if any; then the local method in every orientation, nearest first; then the global
/// search, if enabled.
pub(in crate::follow) fn follow_edge(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    planned: [&PlanarPose; 2],
    near: Option<&JointPositions>,
    orientations: &[ToolOrientation],
    search: SearchScope,
) -> Result<Leg, Vec<Attempt>> {
    let mut attempts = Vec::new();
    let symmetric = arm.task.tool.is_half_turn_symmetric();
    if let (Some(near), Some(as_planned)) = (near, orientations.first()) {
        let to = turn_along_edge(planned, as_planned, from);
        let found = arm.follow_line(start, from, &to, Some(near), AllowedContact::Surface);
        if let Ok(configurations) = found {
            return Ok(Leg {
                configurations,
                line: vec![to],
                turned: deviation(as_planned, planned[0], from, symmetric),
            });
        }
    }
    let mut order = nearest_first(orientations, planned[0], from, symmetric);
    // Where the orientation does not matter, turning does not either.
    if arm.task.action != Action::Absorb {
        order.retain(|orientation| change(planned[0], orientation, from).abs() <= MAX_TURN);
    }
    for orientation in &order {
        let to = turn_along_edge(planned, orientation, from);
        match arm.follow_line(start, from, &to, None, AllowedContact::Surface) {
            Ok(configurations) => {
                return Ok(Leg {
                    configurations,
                    line: vec![to],
                    turned: deviation(orientation, planned[0], from, symmetric),
                });
            }
            Err(broken) => attempts.push(Attempt {
                rotation: orientation.rotation,
                tilt: orientation.tilt,
                progress: broken.progress,
                obstruction: broken.obstruction,
            }),
        }
    }
    match search {
        SearchScope::Local => Err(attempts),
        SearchScope::Global => global::search(arm, start, from, planned, &order).ok_or(attempts),
    }
}
