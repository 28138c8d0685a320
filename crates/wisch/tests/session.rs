//! The loop with executors and observers of the test's own: where it ends, and what it never does.

use std::ops::ControlFlow;
use wisch::follow::{FollowConfig, MotionFault};
use wisch::interpret::TouchSample;
use wisch::recover::Verdict;
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, NoExecutor, Round, RunConfig,
    RunError, RunEvent, SampleSink, Session, Stage, unobserved,
};
use wisch_io::{LoadOptions, LoadedTask, Robot, load_task};

/// A robot whose tool goes exactly where it is told to, and feels a share of the press force while it wipes.
struct Toy {
    share: f64,
    executed: usize,
}

impl Toy {
    const PERIOD: f64 = 0.01;

    const fn new(share: f64) -> Self {
        Self { share, executed: 0 }
    }
}

impl Executor for Toy {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.executed += 1;
        Ok(order.play(Self::PERIOD, sink, |at| {
            let share = self.share * f64::from(at.phase.is_contact());
            let force = order.task.surface_reaction() * share;
            TouchSample::new(at.time, at.world_from_tool, force)
        }))
    }
}

/// Must not be called.
struct Forbidden;

impl Executor for Forbidden {
    fn execute(
        &mut self,
        _: &MotionOrder<'_>,
        _: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        panic!("a motion with a fault is executed");
    }
}

fn loaded() -> LoadedTask {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenarios/arm-board.toml"
    );
    load_task(path.as_ref(), &LoadOptions::default()).expect("a task")
}

fn robot(loaded: &LoadedTask) -> Robot {
    loaded.robot().expect("a robot").expect("it names one")
}

/// What happened, without what repeats itself.
fn kind(event: &RunEvent<'_>) -> &'static str {
    match event {
        RunEvent::Planning { .. } => "planning",
        RunEvent::Planned { .. } => "planned",
        RunEvent::Following { .. } => "following",
        RunEvent::Predicting { .. } => "predicting",
        RunEvent::Audited { .. } => "audited",
        RunEvent::Executing(_) => "executing",
        RunEvent::Sample(_) => "sample",
        RunEvent::Interpreting { .. } => "interpreting",
        RunEvent::Judged(_) => "judged",
        RunEvent::Ended(_) => "ended",
    }
}

/// The events of one round, in their order.
const ROUND: [&str; 9] = [
    "planning",
    "planned",
    "following",
    "predicting",
    "audited",
    "executing",
    "sample",
    "interpreting",
    "judged",
];

/// Runs a session that is stopped at the first event of a kind; which kinds of events there were, and the verdict.
fn stopped_at(
    loaded: &LoadedTask,
    robot: &Robot,
    executor: &mut Toy,
    stop: &str,
) -> (Vec<&'static str>, Option<Verdict>, Vec<Round>) {
    let config = RunConfig {
        target: 1.0,
        ..loaded.run_config()
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.performer());
    let (mut seen, mut verdict) = (Vec::new(), None);
    let mut is_stopped = false;
    let result = session.run(executor, &mut |event| {
        let kind = kind(event);
        if seen.last() != Some(&kind) {
            seen.push(kind);
        }
        if let RunEvent::Ended(last) = event {
            verdict = *last;
        }
        if kind == stop && !is_stopped {
            is_stopped = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    result.expect("it ends");
    assert_eq!(session.step(executor, &mut unobserved), Ok(Stage::Ended));
    (seen, verdict, session.into_rounds())
}

#[test]
fn a_toy_that_presses_meets_the_goal() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.performer());
    let mut toy = Toy::new(1.0);
    let mut last = None;
    let mut look = |event: &RunEvent<'_>| {
        if let RunEvent::Ended(verdict) = event {
            last = *verdict;
        }
        ControlFlow::Continue(())
    };
    session.run(&mut toy, &mut look).expect("it ends");
    assert_eq!(last, Some(Verdict::GoalMet));
    let rounds = session.rounds();
    assert_eq!(toy.executed, rounds.len());
    assert_eq!(rounds.last().expect("a round").verdict, Verdict::GoalMet);
    for round in rounds {
        assert_eq!(round.execution.ending, Ending::Complete);
        assert_eq!(round.execution.duration, round.motion.followed.duration());
        assert!(round.interpretation.performance.mean >= 0.85);
    }
}

#[test]
fn a_toy_that_feels_nothing_ends_without_contact() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.performer());
    let mut toy = Toy::new(0.0);
    session.run(&mut toy, &mut unobserved).expect("it ends");
    assert_eq!(toy.executed, 1);
    assert_eq!(session.rounds()[0].verdict, Verdict::NoContact);
}

#[test]
fn an_observer_stops_the_session_at_every_event() {
    let loaded = loaded();
    let robot = robot(&loaded);
    for (index, stop) in ROUND.into_iter().enumerate() {
        let mut toy = Toy::new(1.0);
        let (seen, verdict, rounds) = stopped_at(&loaded, &robot, &mut toy, stop);
        let is_executed = index >= 6;
        assert_eq!(toy.executed, usize::from(is_executed), "{stop}");
        assert_eq!(rounds.len(), usize::from(is_executed), "{stop}");
        assert_eq!(seen.last(), Some(&"ended"), "{stop}");
        let of_round = &seen[..seen.len() - 1];
        if is_executed {
            // What was felt is interpreted, and nothing else begun.
            assert_eq!(of_round, ROUND, "{stop}");
        } else {
            // The stage at hand may be completed.
            let rest = &ROUND[..of_round.len()];
            assert!(
                of_round == rest && of_round.len() > index,
                "{stop}: {seen:?}"
            );
            assert!(of_round.len() <= 6, "{stop}: {seen:?}");
            assert_eq!(verdict, None, "{stop}");
        }
        if stop == "sample" {
            assert_eq!(rounds[0].execution.ending, Ending::Stopped);
            assert_eq!(rounds[0].execution.duration, 0.0);
        }
    }
}

#[test]
fn a_motion_with_a_fault_is_never_executed() {
    let loaded = loaded();
    let robot = robot(&loaded);
    // A hundredth of a millimetre is less than the timed joints keep between the poses that were solved.
    let mut config = loaded.run_config();
    config.follow = FollowConfig {
        line_tolerance: 1e-5,
        turn_tolerance: 1e-4,
        ..config.follow
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.performer());
    let mut verdict = None;
    let mut look = |event: &RunEvent<'_>| {
        assert!(!matches!(event, RunEvent::Executing(_)));
        if let RunEvent::Ended(last) = event {
            verdict = *last;
        }
        ControlFlow::Continue(())
    };
    session.run(&mut Forbidden, &mut look).expect("a verdict");
    assert_eq!(verdict, Some(Verdict::UnsafeMotion));
    assert!(session.rounds().is_empty());
    let (planned, audit) = session.first().expect("the motion that was refused");
    assert!(planned.followed.duration() > 0.0);
    let is_off_line = |fault: &MotionFault| matches!(fault, MotionFault::OffLine { .. });
    assert!(audit.faults.iter().any(is_off_line), "{:?}", audit.faults);
    assert_eq!(session.audit(), Some(audit));
}

#[test]
fn steps_by_hand_and_one_go_are_the_same() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let config = RunConfig {
        target: 1.0,
        max_rounds: 2,
        ..loaded.run_config()
    };
    let session = || Session::new(&loaded.task, config.clone()).with_robot(robot.performer());

    let mut whole = session();
    whole
        .run(&mut Toy::new(0.95), &mut unobserved)
        .expect("it ends");

    let (mut stepped, mut toy) = (session(), Toy::new(0.95));
    let mut stages = Vec::new();
    while stages.last() != Some(&Stage::Ended) {
        stages.push(stepped.step(&mut toy, &mut unobserved).expect("a stage"));
    }
    let round = [
        Stage::Planned,
        Stage::Followed,
        Stage::Audited,
        Stage::Executed,
        Stage::Interpreted,
        Stage::Judged,
    ];
    assert_eq!(stages[..6], round);
    assert_eq!(stages.len(), 12, "{stages:?}");
    assert_eq!(whole.rounds().len(), 2);
    assert_eq!(
        format!("{:?}", whole.rounds()),
        format!("{:?}", stepped.rounds())
    );
}

#[test]
fn a_session_without_a_robot_or_an_executor_says_so() {
    let loaded = loaded();
    let mut session = loaded.session();
    let error = session.run(&mut NoExecutor, &mut unobserved);
    assert_eq!(error, Err(RunError::NoRobot));

    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.performer());
    let error = session.run(&mut NoExecutor, &mut unobserved);
    let error = error.expect_err("nothing executes").to_string();
    assert_eq!(error, "round 1: there is no executor for this motion");
}

/// Stands for a driver that counts the joints otherwise.
struct Headless;

impl Executor for Headless {
    fn execute(
        &mut self,
        _: &MotionOrder<'_>,
        _: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        Ok(Execution::at_rest(&[0.0; 3]))
    }
}

#[test]
fn an_executor_has_to_leave_all_joints_somewhere() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.performer());
    let error = session.run(&mut Headless, &mut unobserved);
    let expected = robot.model.dof();
    let (round, found) = (1, 3);
    assert_eq!(
        error,
        Err(RunError::Positions {
            round,
            found,
            expected
        })
    );
}
