//! The holder between a flange and a tool that the task declares some distance away from it.

use crate::follow::FollowError;
use crate::geometry::{Mesh, Pose};
use crate::represent::Tool;
use crate::robot::LinkAxis;
use std::f64::consts::PI;
use std::fmt;

/// Largest radius that is assumed for a holder [m]: that of a flange of ISO 9409-1-50.
const FLANGE_RADIUS: f64 = 0.0315;
/// Least height of a holder's end above the contact plane [m], so that a thin tool keeps it clear of the surface.
const END_HEIGHT: f64 = 0.012;
/// Shortest holder that is checked for collisions [m].
const SHORTEST: f64 = 1e-3;
/// Number of edges of the prism around a holder.
const EDGES: u32 = 16;

/// The straight holder between a flange and a tool, as a cylinder along the axis that points out of the hand.
///
/// Its text says how large it is, and whether its radius is assumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HolderCylinder {
    /// Radius \[m\].
    pub radius: f64,
    /// Whether nothing declares the radius. Then it is that of a flange of ISO 9409-1-50, or half the width of the tool
    /// if that is less.
    pub is_assumed: bool,
    /// Distances of both ends from the origin of the link, along the axis \[m\].
    pub ends: [f64; 2],
}

impl HolderCylinder {
    /// Returns the holder from the end of a hand to the upper face of a tool; `None` if there is no space between them.
    ///
    /// `hand`, `face`: their distances from the origin of the link \[m\]; `radius`: as declared \[m\].
    pub(super) fn between(hand: f64, face: f64, radius: Option<f64>, tool: &Tool) -> Option<Self> {
        let (low, high) = tool.mesh.bounds();
        let width = (high.x - low.x).min(high.y - low.y);
        let end = face - (END_HEIGHT - high.z).max(0.0);
        (end - hand > SHORTEST).then_some(Self {
            radius: radius.unwrap_or(FLANGE_RADIUS.min(width / 2.0)),
            is_assumed: radius.is_none(),
            ends: [hand, end],
        })
    }

    /// Returns the prism around the holder, in the frame of the link.
    pub(in crate::follow) fn mesh(&self, axis: LinkAxis) -> Result<Mesh, FollowError> {
        let [start, end] = self.ends;
        let around = self.radius / (PI / f64::from(EDGES)).cos();
        let prism = Mesh::cylinder(around, end - start, EDGES).map_err(FollowError::Tool)?;
        let middle = Pose::translation(0.0, 0.0, f64::midpoint(start, end));
        Ok(prism.transform(&(axis.frame() * middle)))
    }
}

impl fmt::Display for HolderCylinder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let length = self.ends[1] - self.ends[0];
        let assumed = if self.is_assumed { " (assumed)" } else { "" };
        let radius = self.radius;
        write!(
            f,
            "holder {length:.3} m long, radius {radius:.4} m{assumed}"
        )
    }
}
