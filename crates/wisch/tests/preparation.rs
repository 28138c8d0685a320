//! The calls with which a session prepares its executor and lets it finish.

use std::ops::ControlFlow;
use wisch::follow::Workcell;
use wisch::interpret::TouchSample;
use wisch::run::{
    Execution, Executor, ExecutorError, MotionOrder, RobotState, RunConfig, RunError, RunEvent,
    SampleSink, Session, Stage, ignore_events,
};
use wisch_io::{LoadOptions, LoadedTask, Robot, load_task};

/// A robot that follows its path, records every call, and fails in the call of this name.
#[derive(Default)]
struct Noting {
    calls: Vec<&'static str>,
    fails_in: &'static str,
}

impl Noting {
    fn note(&mut self, call: &'static str) -> Result<(), ExecutorError> {
        self.calls.push(call);
        if self.fails_in == call {
            return Err(ExecutorError::new(format!("{call} does not work")));
        }
        Ok(())
    }
}

impl Executor for Noting {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        assert_eq!(cell.robot().name(), "arm7");
        self.note("prepare")
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.note("execute")?;
        Ok(order.play(0.01, sink, |at| {
            let share = 0.95 * f64::from(at.phase.is_contact());
            let force = order.task.surface_reaction() * share;
            TouchSample::new(at.time, at.world_from_tool, force)
        }))
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        self.note("state").map(|()| None)
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        self.note("finish")
    }
}

fn loaded() -> (LoadedTask, Robot) {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenarios/arm-board.toml"
    );
    let loaded = load_task(path.as_ref(), &LoadOptions::default()).expect("a task");
    let robot = loaded.robot().expect("a robot").expect("it names one");
    (loaded, robot)
}

/// Runs two rounds at most, and stops at a sample if `is_stopped`. Returns the calls, the result and the failure to finish.
fn run(
    fails_in: &'static str,
    is_stopped: bool,
) -> (Vec<&'static str>, Result<(), RunError>, Option<String>) {
    let (loaded, robot) = loaded();
    let config = RunConfig {
        target: 1.0,
        max_rounds: 2,
        sight: None,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.robot_setup());
    let mut executor = Noting {
        calls: Vec::new(),
        fails_in,
    };
    let result = session.run(&mut executor, &mut |event| match event {
        RunEvent::Sample(_) if is_stopped => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    let failure = session.finish_failure().map(ToString::to_string);
    (executor.calls, result, failure)
}

fn count(calls: &[&str], name: &str) -> usize {
    calls.iter().filter(|call| **call == name).count()
}

#[test]
fn an_executor_is_prepared_before_its_first_motion_and_finishes_after_its_last() {
    let (calls, result, failure) = run("", false);
    assert_eq!((result, failure), (Ok(()), None));
    assert_eq!(count(&calls, "execute"), 2, "{calls:?}");
    assert_eq!(count(&calls, "prepare"), 1, "{calls:?}");
    // The first call is a state for planning.
    assert_eq!(calls[..4], ["state", "prepare", "state", "execute"]);
    assert_eq!(count(&calls, "finish"), 1, "{calls:?}");
    assert_eq!(calls.last(), Some(&"finish"));
}

#[test]
fn an_executor_finishes_once_after_a_stop_or_an_error() {
    let (calls, result, _) = run("", true);
    assert_eq!(result, Ok(()));
    assert_eq!(calls[1..], ["prepare", "state", "execute", "finish"]);
    let (calls, result, _) = run("execute", false);
    assert!(matches!(result, Err(RunError::Execute(_))), "{result:?}");
    assert_eq!(calls[1..], ["prepare", "state", "execute", "finish"]);
}

#[test]
fn nothing_moves_if_an_executor_cannot_be_prepared() {
    let (calls, result, failure) = run("prepare", false);
    let error = result.expect_err("it fails").to_string();
    assert_eq!(error, "prepare does not work");
    assert_eq!((calls, failure), (vec!["state", "prepare"], None));
}

#[test]
fn a_failure_to_finish_leaves_the_rounds_as_they_are() {
    let (calls, result, failure) = run("finish", false);
    assert_eq!(result, Ok(()));
    assert_eq!(failure.as_deref(), Some("finish does not work"));
    assert_eq!(count(&calls, "finish"), 1, "{calls:?}");
}

#[test]
fn a_session_that_is_left_early_finishes_on_request_and_prepares_again() {
    let (loaded, robot) = loaded();
    let config = RunConfig {
        target: 1.0,
        max_rounds: 2,
        sight: None,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.robot_setup());
    let mut executor = Noting::default();
    session
        .run_until(Stage::Executed, &mut executor, &mut ignore_events)
        .expect("a round");
    session.finish_executor(&mut executor);
    session.finish_executor(&mut executor);
    assert_eq!(count(&executor.calls, "finish"), 1);
    let run = session.run(&mut executor, &mut ignore_events);
    assert_eq!(run, Ok(()));
    assert_eq!(count(&executor.calls, "prepare"), 2, "{:?}", executor.calls);
    assert_eq!(count(&executor.calls, "finish"), 2, "{:?}", executor.calls);
}
