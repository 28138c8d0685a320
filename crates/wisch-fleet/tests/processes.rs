//! A cluster of processes on loopback. No process outlives its test.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Time after which a process counts as hanging. No statement of these tests takes nearly as long.
const HANG_TIME: Duration = Duration::from_secs(240);

pub fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_wisch-fleet"))
}

/// A process that does not outlive the test, and its first line.
pub struct Process {
    pub child: Child,
    first_line: String,
}

impl Process {
    /// Starts a process, and waits for its first line. Errors go to a file.
    fn begin(command: &mut Command, errors: &Path) -> Self {
        let errors = File::options()
            .create(true)
            .append(true)
            .open(errors)
            .unwrap();
        let command = command.stdin(Stdio::null()).stderr(errors);
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut process = Self {
            child,
            first_line: String::new(),
        };
        process.first_line = lines
            .next()
            .expect("it ended before its first line")
            .unwrap();
        process
    }

    pub fn kill(&mut self) {
        // An error means that the process has ended already.
        let _ = self.child.kill();
        self.child.wait().unwrap();
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.kill();
    }
}

pub struct Cluster {
    folder: PathBuf,
    pub scheduler: Process,
    pub executors: Vec<Process>,
    pub url: String,
}

impl Cluster {
    pub fn begin(folder: &Path, executors: usize, program: impl Fn() -> Command) -> Self {
        let errors = folder.join("errors.txt");
        let mut command = program();
        command.args(["scheduler", "--bind", "127.0.0.1:0"]);
        let scheduler = Process::begin(&mut command, &errors);
        let url = scheduler.first_line.rsplit(' ').next().unwrap().to_owned();
        assert!(url.starts_with("df://127.0.0.1:"), "{url}");
        let mut cluster = Self {
            folder: folder.to_path_buf(),
            scheduler,
            executors: Vec::new(),
            url,
        };
        for _ in 0..executors {
            cluster.add(program());
        }
        cluster
    }

    pub fn add(&mut self, mut program: Command) {
        let address = self.url.trim_start_matches("df://");
        program.args(["executor", "--scheduler", address, "--slots", "1"]);
        let executor = Process::begin(&mut program, &self.folder.join("errors.txt"));
        self.executors.push(executor);
    }

    /// Returns the messages of the scheduler and the executors.
    pub fn errors(&self) -> String {
        std::fs::read_to_string(self.folder.join("errors.txt")).unwrap()
    }

    /// Asks the cluster.
    pub fn ask(&self, mut program: Command, sources: &[&str], sql: &str) -> Output {
        program.args(["sql", sql, "--csv", "--cluster", &self.url]);
        run_in_time(program.args(sources), sql)
    }
}

/// Runs a program, and returns its output. Panics if the program hangs.
pub fn run_in_time(command: &mut Command, what: &str) -> Output {
    let command = command.stdin(Stdio::null()).stdout(Stdio::piped());
    let child = command.stderr(Stdio::piped()).spawn().unwrap();
    let mut guard = Guard(Some(child.id()));
    let waiting = std::thread::spawn(move || child.wait_with_output().unwrap());
    let begun = Instant::now();
    while !waiting.is_finished() {
        assert!(begun.elapsed() < HANG_TIME, "the program hangs: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
    guard.0 = None;
    waiting.join().unwrap()
}

/// Kills a process that hangs.
struct Guard(Option<u32>);

impl Drop for Guard {
    fn drop(&mut self) {
        if let Some(id) = self.0 {
            let _ = Command::new("kill").args(["-9", &id.to_string()]).status();
        }
    }
}

/// Returns the lines of an answer: the names, then the sorted rows.
pub fn sort_lines(output: &Output, what: &str) -> Vec<String> {
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{what}: {errors}");
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines[1..].sort();
    lines
}
