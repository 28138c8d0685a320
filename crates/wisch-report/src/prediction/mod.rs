//! Pictures of a plan and its predicted effect: particles, nodes and strokes on the surface, and the effect over time.

pub(crate) mod chart;
pub(crate) mod figures;
pub(crate) mod frames;
mod keys;
pub(crate) mod layers;
