//! The arm at one base pose: a stroke from touching down to lifting off, its edges (Algorithm 1 of paper §3.3),
//! the local and the global method, and free motion between strokes.

pub(super) mod arm;
mod edge;
pub(super) mod free_motion;
pub(super) mod free_yaw;
mod global;
pub(super) mod joint_tour;
pub(super) mod joint_travel;
pub(super) mod stroke_run;
pub(super) mod tool_redundancy;
