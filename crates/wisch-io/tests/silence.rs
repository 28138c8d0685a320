//! A child that falls silent is stopped at once, however slow the observers are, and its pauses are kept.

use crate::process::{CHILD, has_python, loaded, motion, order};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};
use wisch::run::{Executor, ExecutorError, PlannedRound, RunConfig, Session, ignore_events};
use wisch_io::ProcessExecutor;

/// Returns the script of a child that executes one motion in real time, and permits itself a silence [s].
fn script(silence: f64, lines: &str) -> String {
    let ready =
        format!("say(ready={{\"version\": 2, \"real_time\": True, \"max_silence_s\": {silence}}})");
    CHILD.replace("say(ready={\"version\": 1})", &ready) + lines + "\n"
}

fn start(script: &str) -> ProcessExecutor {
    ProcessExecutor::start("python3", &["-c".to_owned(), script.to_owned()]).expect("it greets")
}

/// Lets a child execute a motion for an observer that takes no second sample before the child has
/// received "stop". Returns the error and the number of samples.
fn observed_slowly(planned: &PlannedRound, lines: &str) -> (ExecutorError, usize) {
    let folder = tempfile::tempdir().expect("a folder");
    let stopped = folder.path().join("stopped");
    let lines = format!("STOPPED = {:?}\n{lines}", stopped.display().to_string());
    let mut child = start(&script(0.3, &lines));
    let mut count = 0;
    let order = order(planned);
    let error = child.execute(&order, &mut |_| {
        count += 1;
        wait_for(&stopped);
        ControlFlow::Continue(())
    });
    (error.expect_err("it fails"), count)
}

fn wait_for(file: &Path) {
    let begin = Instant::now();
    while !file.exists() {
        let waited = begin.elapsed();
        assert!(waited < Duration::from_secs(30), "it has heard no stop");
        std::thread::sleep(Duration::from_millis(5));
    }
}

const HEAR_STOP: &str = "
if hear() == 'stop':
    open(STOPPED, 'w').close()
hear()
";

#[test]
fn a_silent_child_is_stopped_before_slow_observers_have_taken_its_samples() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = format!("[sample(k / 100) for k in range(500)]\n{HEAR_STOP}");
    let (error, count) = observed_slowly(&planned, &lines);
    let error = error.to_string();
    assert!(error.contains("no message for 0.3 s"), "{error}");
    assert_eq!(count, 500, "what was measured is kept");
}

#[test]
fn a_child_that_closes_its_output_or_reports_an_error_is_stopped_at_once() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let close = format!("sample(0); sample(0.01)\nimport os\nos.close(1)\n{HEAR_STOP}");
    let (error, _) = observed_slowly(&planned, &close);
    let error = error.to_string();
    assert!(error.contains("it closed its standard output"), "{error}");

    let fail = format!("sample(0); sample(0.01)\nsay(error='no current')\n{HEAR_STOP}");
    let (error, _) = observed_slowly(&planned, &fail);
    assert!(error.to_string().contains("no current"), "{error}");
}

#[test]
fn a_motion_that_ends_with_an_error_keeps_its_pauses() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let begin = "sample(0)\nsay(paused={'time_s': 0.5, 'reason': 'the pendant'})\nsay(resumed={'time_s': 2})\nsample(2.5)\nsample(2.6)\nsay(paused={'time_s': 3})\n";
    let mut child = start(&script(20.0, &format!("{begin}say(error='no current')")));
    let config = RunConfig {
        max_rounds: 1,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config)
        .with_belief(loaded.belief())
        .with_robot(robot.robot_setup());
    let run = session.run(&mut child, &mut ignore_events);
    let error = run.expect_err("it fails").to_string();
    assert!(error.contains("no current"), "{error}");
    let execution = &session.rounds()[0].execution;
    assert_eq!(execution.duration, 2.6);
    let pauses: Vec<_> = (execution.pauses.iter())
        .map(|pause| (pause.start, pause.end, pause.reason.as_str()))
        .collect();
    assert_eq!(pauses, [(0.5, Some(2.0), "the pendant"), (3.0, None, "")]);
}
