//! The Prolog engine of `wisch ask`: Scryer Prolog in a process of its own, so that a runaway query or a panic ends the
//! query and not the program.
//!
//! `wisch ask` starts it with a file of predicates, and sends queries over its standard streams. It always ends
//! together with the program that started it, even during a query.

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

/// Answers queries from standard input to standard output until the input ends, with the predicates of a file and a
/// memory limit \[bytes\].
fn work(memory: &str, program: &str) -> Result<(), String> {
    #[cfg(unix)]
    end_with_the_program().map_err(|error| format!("standard input: {error}"))?;
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

/// Ends this process at once when the other end of its standard input closes. On Linux, the kernel also ends it with
/// the thread that started it.
#[cfg(unix)]
fn end_with_the_program() -> std::io::Result<()> {
    use rustix::event::{PollFd, PollFlags, poll};
    use rustix::process::{Signal, getpid, kill_process};
    #[cfg(target_os = "linux")]
    rustix::process::set_parent_process_death_signal(Some(Signal::KILL))?;
    // If the program has ended before this line, the stream is closed already.
    let watch = move || {
        let input = std::io::stdin();
        let gone = PollFlags::HUP | PollFlags::ERR;
        loop {
            // Incoming data do not wake this thread.
            let mut streams = [PollFd::new(&input, PollFlags::empty())];
            let woken = poll(&mut streams, None);
            if woken.is_ok() && streams[0].revents().intersects(gone) {
                // Returning would not suffice, because queries run on another thread.
                let _ = kill_process(getpid(), Signal::KILL);
            }
        }
    };
    std::thread::Builder::new().spawn(watch).map(drop)
}
