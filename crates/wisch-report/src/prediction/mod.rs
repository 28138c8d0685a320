//! What a plan is predicted to do: the surface with its particles, nodes and strokes, and the effect over time.

pub(crate) mod chart;
pub(crate) mod figures;
pub(crate) mod frames;
mod keys;
pub(crate) mod layers;
