//! The program `wisch`. Its code is in the library, which the Python wheel contains, too.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(wisch_cli::main_with(std::env::args_os()))
}
