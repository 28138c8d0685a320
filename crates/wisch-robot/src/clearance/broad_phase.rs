//! Broad phase of the collision checks: a bounding-volume hierarchy of all obstacles.

use super::BodyId;
use super::solid::{AxisAlignedBox, vector};
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};
use std::sync::Arc;

/// Reduction of the distance between boxes [m], so that rounding excludes nothing.
const ROUNDING: f64 = 1e-9;

/// Obstacles, indexed by place.
#[derive(Debug, Clone, Default)]
pub(super) struct Obstacles {
    bodies: Arc<[BodyId]>,
    /// Its leaves have the indices of the bodies.
    tree: Arc<Bvh>,
}

impl Obstacles {
    /// Builds the hierarchy from obstacles and their bounding boxes.
    pub fn new(obstacles: impl Iterator<Item = (BodyId, AxisAlignedBox)>) -> Self {
        let (bodies, boxes): (Vec<BodyId>, Vec<Aabb>) = obstacles
            .map(|(body, AxisAlignedBox { low, high })| {
                (body, Aabb::new(vector(&low), vector(&high)))
            })
            .unzip();
        Self {
            bodies: bodies.into(),
            tree: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes).into(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Adds the obstacles whose boxes are at most `up_to` from a box [m], sorted.
    pub fn find_near(&self, bounds: &AxisAlignedBox, up_to: f64, found: &mut Vec<BodyId>) {
        let (low, high) = (vector(&bounds.low), vector(&bounds.high));
        // An overlapping body may overlap more deeply than the one found so far.
        let limit = up_to.max(0.0) + ROUNDING;
        let near = self.tree.leaves(|node| {
            let gap = (node.mins() - high).max(low - node.maxs());
            let apart = gap.max(parry3d_f64::math::Vector::ZERO);
            apart.length() <= limit
        });
        found.extend(near.map(|leaf| self.bodies[leaf as usize]));
        found.sort_unstable();
    }
}
