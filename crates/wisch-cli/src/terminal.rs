//! Terminal output and process setup: colours, threads, errors, panics, and the exit code.

use crate::args::{ColorChoice, GlobalArgs};
use crate::failure::Failure;
use std::ffi::OsString;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use wisch::source_location::escape_controls;

/// The outcome of a command that ran without an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The command is done, or the goal is met.
    Done,
    /// The command ran, but the goal is not met, or a check found faults.
    GoalNotMet,
}

/// Whether errors are shown in colours.
static COLOR: AtomicBool = AtomicBool::new(false);
/// Whether only errors are shown.
static QUIET: AtomicBool = AtomicBool::new(false);
/// Number of functions whose notes are not shown.
static HUSHED: AtomicUsize = AtomicUsize::new(0);
/// Whether the command line has `--json`.
static JSON: AtomicBool = AtomicBool::new(false);

/// Whether a result was printed.
static PRINTED: AtomicBool = AtomicBool::new(false);

/// Whether a signal ends the program, so that errors which this causes are not shown.
static HELD_BACK: AtomicBool = AtomicBool::new(false);

const EXIT_DONE: u8 = 0;
const EXIT_GOAL_NOT_MET: u8 = 1;
const EXIT_ERROR: u8 = 2;

/// Runs the program and returns its exit code: 0 done, 1 goal not met, 2 error or panic.
pub fn run(args: &[OsString], program: impl FnOnce() -> Result<Outcome, Failure>) -> u8 {
    let mut asked = args.iter().skip(1).take_while(|arg| *arg != "--");
    JSON.store(asked.any(|arg| arg == "--json"), Ordering::Relaxed);
    panic::set_hook(Box::new(|info| {
        if wisch_telemetry::catches_panics() {
            return;
        }
        let place = info
            .location()
            .map_or_else(String::new, |at| format!(" at {}:{}", at.file(), at.line()));
        let cause = info.payload_as_str().unwrap_or("no message");
        let error = format!("internal error{place}: {cause}");
        let help = "this is an error in wisch, not in your files; please report it";
        print_json_error(&error, Some(help));
        complain(&escape_controls(&format!("{error}\n  help: {help}")));
    }));
    // Unwinding drops the unfinished output folders, which removes them; an exit from the hook would leave them.
    let ended = panic::catch_unwind(AssertUnwindSafe(program));
    if HELD_BACK.load(Ordering::SeqCst) {
        // The thread that handles the signal ends the program.
        loop {
            std::thread::park();
        }
    }
    match ended {
        Ok(Ok(Outcome::Done)) => EXIT_DONE,
        Ok(Ok(Outcome::GoalNotMet)) => EXIT_GOAL_NOT_MET,
        Ok(Err(failure)) => {
            print_error(&failure);
            EXIT_ERROR
        }
        Err(_) => EXIT_ERROR,
    }
}

/// Lets the program end only by the thread that handles a signal, and not with the command.
pub fn hold_back() {
    HELD_BACK.store(true, Ordering::SeqCst);
}

/// Sets up colours and threads.
pub fn prepare(args: &GlobalArgs) -> Result<(), Failure> {
    let color = match args.color {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto => {
            std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
                && io::stderr().is_terminal()
        }
    };
    COLOR.store(color, Ordering::Relaxed);
    QUIET.store(args.quiet, Ordering::Relaxed);
    if let Some(threads) = args.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(threads))
            .build_global()
            .map_err(|error| Failure::new(format!("--threads {threads}: {error}")))?;
    }
    Ok(())
}

/// Prints an error in the form of the command-line parser's errors: one unbroken line, so that it can be searched for,
/// and one line with help.
pub fn print_error(failure: &Failure) {
    let (red, green, plain) = if COLOR.load(Ordering::Relaxed) {
        ("\x1b[1;31m", "\x1b[32m", "\x1b[0m")
    } else {
        ("", "", "")
    };
    print_json_error(&failure.to_string(), failure.help());
    let help = failure.help().map_or_else(String::new, |help| {
        format!("\n  {green}help:{plain} {}", escape_controls(help))
    });
    let sentence = failure.to_string();
    complain(&format!(
        "{red}error:{plain} {}{help}",
        escape_controls(&sentence)
    ));
}

/// Exits with the requested help text, or with the command-line parser's error.
pub fn exit_with_parser_message(error: &clap::Error) -> ! {
    if error.use_stderr() {
        let text = error.to_string();
        let sentence = text.lines().next().unwrap_or_default();
        print_json_error(sentence.trim_start_matches("error: "), None);
    }
    error.exit()
}

/// Prints the error as a JSON object if the command line has `--json` and no result was printed.
fn print_json_error(error: &str, help: Option<&str>) {
    if JSON.load(Ordering::Relaxed) && !PRINTED.load(Ordering::Relaxed) {
        // The reader may have closed the pipe.
        let _ = print(&format!(
            "{}\n",
            serde_json::json!({ "error": error, "help": help })
        ));
    }
}

/// Prints to standard output, without control characters. A closed pipe, as `head` leaves it, is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    PRINTED.store(true, Ordering::Relaxed);
    let text = escape_controls(text);
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::new(format!("standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints a record as one JSON object on one line.
pub fn print_json(record: &impl serde::Serialize) -> Result<(), Failure> {
    let line = serde_json::to_string(record).map_err(Failure::new)?;
    print(&(line + "\n"))
}

/// Prints a note on standard error, unless `--quiet` is given.
pub fn remark(text: &str) {
    if !QUIET.load(Ordering::Relaxed) && HUSHED.load(Ordering::Relaxed) == 0 {
        complain(&format!("note: {}", escape_controls(text)));
    }
}

/// Runs a function without the notes of any thread.
pub fn run_without_notes<T>(run: impl FnOnce() -> T) -> T {
    HUSHED.fetch_add(1, Ordering::Relaxed);
    let result = run();
    HUSHED.fetch_sub(1, Ordering::Relaxed);
    result
}

/// Asks a question on standard error. Returns whether the answer on standard input is y or yes.
pub fn ask(question: &str) -> bool {
    let _ = write!(io::stderr().lock(), "{}: ", escape_controls(question));
    let _ = io::stderr().flush();
    let mut answer = String::new();
    let read = io::stdin().read_line(&mut answer);
    read.is_ok() && ["y", "yes"].contains(&answer.trim().to_lowercase().as_str())
}

/// Prints to standard error and ignores failures.
fn complain(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
