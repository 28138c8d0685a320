//! Algorithm 1 of paper §3.3: an edge is followed with the tool's free degrees of freedom.

use super::arm::Arm;
use super::global::{self, Leg};
use super::tool_redundancy::{ToolOrientation, change, deviation, nearest_first, turned_along};
use crate::follow::{AllowedContact, Attempt, SearchScope, ToolPose};
use crate::geometry::PlanarPose;
use crate::represent::Action;
use crate::robot::JointPositions;

/// Most that the tool turns on an edge beyond what is planned [rad]: turning on the spot scatters what lies under
/// it, so that further than this it is better lifted and put down again.
const MAX_TURN: f64 = 0.8;

/// Follows an edge in contact to a node: as planned to the configuration `near` that is known there, if one is; else
/// locally in every orientation, nearest first, then, if asked for, by the global search.
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
        let to = turned_along(planned, as_planned, from);
        let found = arm.along(start, from, &to, Some(near), AllowedContact::Surface);
        if let Ok(configurations) = found {
            return Ok(Leg {
                configurations,
                line: vec![to],
                turned: deviation(as_planned, planned[0], from, symmetric),
            });
        }
    }
    let mut order = nearest_first(orientations, planned[0], from, symmetric);
    // Where the orientation makes no difference, neither does turning.
    if arm.task.action != Action::Absorb {
        order.retain(|orientation| change(planned[0], orientation, from).abs() <= MAX_TURN);
    }
    for orientation in &order {
        let to = turned_along(planned, orientation, from);
        match arm.along(start, from, &to, None, AllowedContact::Surface) {
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
