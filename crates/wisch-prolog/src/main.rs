//! The Prolog engine of `wisch ask`: Scryer Prolog in a process of its own, so that a runaway or a panic ends a query
//! and not the program.
//!
//! `wisch ask` begins it, hands it the predicates as a file, and asks it over its standard streams.

use scryer_prolog::{MachineBuilder, StreamConfig};
use std::process::ExitCode;

const USAGE: &str = "usage: wisch-prolog MEMORY_BYTES PROGRAM.pl
This is the Prolog engine of wisch: wisch ask begins it by itself.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [memory, program] = arguments.as_slice() else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    match work(memory, program) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Answers queries from standard input to standard output until it ends, with the predicates of a file, in so much
/// memory [bytes].
fn work(memory: &str, program: &str) -> Result<(), String> {
    let bytes = memory.parse::<u64>();
    let bytes = bytes.map_err(|error| format!("memory limit {memory:?}: {error}"))?;
    rlimit::setrlimit(rlimit::Resource::AS, bytes, bytes)
        .map_err(|error| format!("memory limit of {bytes} bytes: {error}"))?;
    let text = std::fs::read_to_string(program).map_err(|error| format!("{program}: {error}"))?;
    let streams = StreamConfig::stdio();
    let mut machine = MachineBuilder::default().with_streams(streams).build();
    machine.load_module_string("user", text);
    for _ in machine.run_query("main.") {}
    Ok(())
}
