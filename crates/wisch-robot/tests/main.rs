//! The tests of robots and geometry, one module for each of their parts.

mod articulation;
mod capability;
mod clearance;
mod ik;
mod robot;
mod setup;
mod sheets;
mod srdf;
mod timing;
mod tolerated;
mod tool_meshes;
