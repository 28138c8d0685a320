//! The tests of the program, one module for each of its parts.

mod ask;
mod cli;
mod curved;
mod earlier_versions;
mod eval;
mod evidence;
mod executor;
mod export;
#[cfg(unix)]
mod film;
#[cfg(unix)]
mod fleet;
mod follow;
mod goals;
mod interpret;
#[cfg(unix)]
mod interrupted;
#[cfg(target_os = "linux")]
mod kills;
mod learn;
mod learn_pools;
mod lock_files;
mod memory;
mod memory_faults;
mod memory_health;
mod memory_import;
mod memory_warnings;
mod mesh_files;
mod patches;
mod plain_output;
mod plans;
mod press_force;
mod program;
mod recording;
mod robot;
mod robot_setup;
#[cfg(unix)]
mod ros2;
mod rounds;
#[cfg(target_os = "linux")]
mod signals;
#[cfg(unix)]
mod studio;
mod surfaces;
mod units;
mod wipings;
mod wrong_inputs;
