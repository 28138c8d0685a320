//! x
#[allow(dead_code, unused_imports)] // used by the commands
mod report;

fn main() {}
