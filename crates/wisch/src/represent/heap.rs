//! Room that dirt needs when it is carried together; the effect model has none of it.

/// Usual depth of a heap of all particles before a tool, over the radius r_s of the tool's collision sphere
/// [1]: what the simulated crumbs need before a sponge that comes at an angle.
pub const HEAP_DEPTH: f64 = 0.35;

/// Depth of a heap of a share of the particles, where one of all of them has `depth_of_all` [m]: the ground
/// that it covers grows with what lies in it.
pub fn heap_depth(depth_of_all: f64, share: f64) -> f64 {
    depth_of_all * share.max(0.0).sqrt()
}
