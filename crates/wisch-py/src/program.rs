//! The program `wisch` in the wheel.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the program with these arguments, its own name first. Returns its exit code.
#[pyfunction]
pub fn run_program(py: Python<'_>, args: Vec<OsString>) -> u8 {
    py.detach(|| wisch_cli::main_with(args))
}
