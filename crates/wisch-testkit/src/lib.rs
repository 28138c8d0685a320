//! Tasks, surfaces and robots for the tests, examples and benches of the other crates.
//!
//! Unit tests inside `wisch` and `wisch-io` cannot use this crate: it is built with another instance of their types.

mod any_task;
mod board;
pub mod curved_meshes;
mod parts;
mod problems;
mod relief;
mod shipped;
mod whole;

pub use any_task::any_task;
pub use board::{arm7, block, board, cell, faults, first_stroke, planned};
pub use parts::{interaction, sponge, surface};
pub use problems::{FollowedProblem, Problem, SolvedProblem, lost_nodes};
pub use relief::{Relief, ReliefWipe};
pub use shipped::{AnyError, ShippedRobot, TABLE_1, humanoid, robots, root, scenario};
pub use whole::{by_density, run_config};
