//! The program; all of it is in the library, which the Python wheel carries too.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(wisch_cli::main_with(std::env::args_os()))
}
