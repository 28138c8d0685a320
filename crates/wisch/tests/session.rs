//! The loop with executors and observers of the tests: when it ends, and which calls it never
//! makes.

mod executor_data;
mod first_plan;

use std::ops::ControlFlow;
use std::sync::Arc;
use wisch::follow::{FollowConfig, MotionFault, Phase};
use wisch::geometry::Point2;
use wisch::interpret::TouchSample;
use wisch::plan::{Strategy, YawRule};
use wisch::recover::{Verdict, is_claimable};
use wisch::represent::{Observation, SensorModel, Task};
use wisch::run::{
    AfterStop, CandidateEvaluation, Ending, Execution, Executor, ExecutorError, MotionOrder,
    NoExecutor, PlannedRound, Round, RunConfig, RunError, RunEvent, SampleSink, Session, Stage,
    StopCause, StopKind, ignore_events,
};
use wisch_io::{LoadOptions, LoadedTask, Robot, load_task};

/// A robot whose tool follows its path exactly, and measures a share of the press force while it wipes.
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

/// Returns the kind of an event.
fn kind(event: &RunEvent<'_>) -> &'static str {
    match event {
        RunEvent::Planning { .. } => "planning",
        RunEvent::Evaluated { .. } => "considered",
        RunEvent::Planned { .. } => "planned",
        RunEvent::Following { .. } => "following",
        RunEvent::Predicting { .. } => "predicting",
        RunEvent::Audited { .. } => "audited",
        RunEvent::Executing(_) => "executing",
        RunEvent::Sample(_) => "sample",
        RunEvent::Warned(_) => "warned",
        RunEvent::Interpreting { .. } => "interpreting",
        RunEvent::Observed { .. } => "observed",
        RunEvent::Decided(_) => "decided",
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
    "decided",
];

/// Runs a session that is stopped at the first event of a kind. Returns the kinds of its events,
/// and the verdict.
fn stopped_at(
    loaded: &LoadedTask,
    robot: &Robot,
    executor: &mut Toy,
    stop: &str,
) -> (Vec<&'static str>, Option<Verdict>, Vec<Round>) {
    let config = RunConfig {
        target: 1.0,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.robot_setup());
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
    assert_eq!(session.step(executor, &mut ignore_events), Ok(Stage::Ended));
    (seen, verdict, session.into_rounds())
}

/// A toy with a camera: it detects all the dirt at its believed positions before the first round,
/// and in the middle of the goal after a round.
struct SeeingToy {
    toy: Toy,
    goal: Point2,
    looks: usize,
}

impl Executor for SeeingToy {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.toy.execute(order, sink)
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        self.looks += 1;
        let collected = |_| self.goal;
        let mut detections: Vec<Point2> = task.particles.iter().map(|(place, _)| place).collect();
        if self.toy.executed > 0 {
            detections = detections.into_iter().map(collected).collect();
        }
        Ok(Some(Observation {
            detections,
            ..Observation::default()
        }))
    }
}

#[test]
fn a_toy_that_sees_the_dirt_at_the_goal_meets_it() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let sharp = SensorModel {
        detection: 1.0,
        half_size_m: 0.0,
        false_alarms_per_m2: 0.0,
        position_error_m: 1e-3,
    };
    let config = RunConfig {
        sight: Some(loaded.sight(sharp)),
        ..loaded.run.clone()
    };
    let session = Session::new(&loaded.task, config).with_belief(loaded.belief());
    let mut session = session.with_robot(robot.robot_setup());
    let mut toy = SeeingToy {
        toy: Toy::new(1.0),
        goal: loaded.task.collect_goal.expect("a place"),
        looks: 0,
    };
    let mut observed = Vec::new();
    let mut look = |event: &RunEvent<'_>| {
        if let RunEvent::Observed { round, observation } = event {
            observed.push((*round, observation.detections.len()));
        }
        ControlFlow::Continue(())
    };
    session.run(&mut toy, &mut look).expect("it ends");
    let count = loaded.task.particles.len();
    assert_eq!(observed, [(0, count), (1, count)]);
    let [round] = session.rounds() else {
        panic!("{} rounds", session.rounds().len());
    };
    assert_eq!((round.verdict, toy.looks), (Verdict::GoalMet, 2));
    assert_eq!(round.interpretation.performance.low, 1.0);
    assert!(round.interpretation.by_touch.low < 1.0);
    assert_eq!(
        session
            .first_observation()
            .map(|seen| seen.detections.len()),
        Some(count)
    );
    // A session without a camera requests no observation.
    let touch_only = RunConfig {
        sight: None,
        ..loaded.run.clone()
    };
    let blind = Session::new(&loaded.task, touch_only);
    let mut blind = blind.with_robot(robot.robot_setup());
    toy.looks = 0;
    blind
        .run_until(Stage::Decided, &mut toy, &mut ignore_events)
        .expect("it ends");
    assert_eq!(toy.looks, 0);
}

#[test]
fn a_toy_that_only_feels_claims_what_it_may_and_says_what_it_cannot_know() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let mut toy = Toy::new(1.0);
    let mut last = None;
    let mut look = |event: &RunEvent<'_>| {
        if let RunEvent::Ended(verdict) = event {
            last = *verdict;
        }
        ControlFlow::Continue(())
    };
    session.run(&mut toy, &mut look).expect("it ends");
    let rounds = session.rounds();
    assert_eq!(toy.executed, rounds.len());
    let end = rounds.last().expect("a round");
    assert_eq!(last, Some(end.verdict));
    let is_claimed = is_claimable(&end.interpretation.distribution, loaded.run.target);
    assert_eq!(end.verdict == Verdict::GoalMet, is_claimed);
    for round in rounds {
        assert_eq!(round.execution.ending, Ending::Complete);
        assert_eq!(round.execution.duration, round.motion.followed.duration());
        let mean = round.interpretation.performance.mean;
        assert!(mean >= 0.8, "{mean}");
    }
}

#[test]
fn a_toy_that_feels_nothing_ends_without_contact() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let mut toy = Toy::new(0.0);
    session.run(&mut toy, &mut ignore_events).expect("it ends");
    assert_eq!(toy.executed, 1);
    assert_eq!(session.rounds()[0].verdict, Verdict::Undecidable);
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
            // The samples are interpreted, and no other stage begins.
            assert_eq!(of_round, ROUND, "{stop}");
        } else {
            // The current stage may be completed.
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
    let mut config = loaded.run.clone();
    config.follow = FollowConfig {
        line_tolerance: 1e-5,
        turn_tolerance: 1e-4,
        ..config.follow
    };
    let mut session = Session::new(&loaded.task, config).with_robot(robot.robot_setup());
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
    let (planned, audit) = session.first_motion().expect("the motion that was refused");
    assert!(planned.followed.duration() > 0.0);
    let is_off_line = |fault: &MotionFault| matches!(fault, MotionFault::OffLine { .. });
    assert!(audit.faults.iter().any(is_off_line), "{:?}", audit.faults);
    assert_eq!(session.audit(), Some(audit));
    let refused = session.refused_motion().map(|(planned, _)| planned.number);
    assert_eq!(refused, Some(1));
}

#[test]
fn steps_by_hand_and_one_go_are_the_same() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let config = RunConfig {
        target: 1.0,
        max_rounds: 2,
        ..loaded.run.clone()
    };
    let session = || Session::new(&loaded.task, config.clone()).with_robot(robot.robot_setup());

    let mut whole = session();
    whole
        .run(&mut Toy::new(0.95), &mut ignore_events)
        .expect("it ends");

    let (mut stepped, mut toy) = (session(), Toy::new(0.95));
    let mut stages = Vec::new();
    while stages.last() != Some(&Stage::Ended) {
        stages.push(stepped.step(&mut toy, &mut ignore_events).expect("a stage"));
    }
    let round = [
        Stage::Planned,
        Stage::Followed,
        Stage::Audited,
        Stage::Executed,
        Stage::Interpreted,
        Stage::Decided,
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
    let error = session.run(&mut NoExecutor, &mut ignore_events);
    assert_eq!(error, Err(RunError::NoRobot));

    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let error = session.run(&mut NoExecutor, &mut ignore_events);
    let error = error.expect_err("nothing executes").to_string();
    assert_eq!(error, "round 1: there is no executor for this motion");
}

/// A driver with another number of joints.
struct Headless;

impl Executor for Headless {
    fn execute(
        &mut self,
        _: &MotionOrder<'_>,
        _: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        Ok(Execution::from_positions(&[0.0; 3]))
    }
}

#[test]
fn an_executor_has_to_leave_all_joints_somewhere() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let error = session.run(&mut Headless, &mut ignore_events);
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

#[test]
fn the_best_of_all_plans_has_the_highest_score_with_the_robot() {
    let mut loaded = loaded();
    loaded.run.plan.strategy = Strategy::Best;
    loaded.run.plan.search.evaluations = 2_000;
    // The arm can follow the planned yaw if the tool need not turn on the spot.
    loaded.run.plan.yaw = YawRule::Blended;
    let robot = robot(&loaded);
    let session = || Session::new(&loaded.task, loaded.run.clone());
    let alone = session().evaluate_candidates().expect("plans");
    let mut session = session().with_robot(robot.robot_setup());
    let considered = session.evaluate_candidates().expect("plans");
    let strategies: Vec<&str> = considered.iter().map(|one| one.strategy.as_str()).collect();
    assert_eq!(strategies, ["grid", "rrt", "kde", "adaptive"]);
    let mut as_planned = 0;
    for (one, alone) in considered.iter().zip(&alone) {
        let motion = one.motion.expect("the arm reaches all of the board");
        assert!(motion.duration > 5.0, "{motion:?}");
        assert_eq!(motion.abandoned, 0);
        assert_eq!(alone.motion, None);
        let [predicted, without] =
            [one, alone].map(|one| one.prediction.as_ref().expect("a plan").performance);
        if predicted != without {
            // At the limit of a wrist joint, the yaw of the tool differs a little.
            assert!(predicted.achieved.abs_diff(without.achieved) <= 2);
            continue;
        }
        as_planned += 1;
        // All nodes are reached. The robot only adds the cost of time, one percent for half a
        // minute.
        let [score, without] =
            [one, alone].map(|one| one.candidate.as_ref().expect("a plan").score.total);
        let cost = without - score;
        assert!(
            (cost - 0.01 * motion.duration / 30.0).abs() < 0.15 * cost,
            "{cost}"
        );
    }
    assert!(as_planned >= 3);
    let mut told = Vec::new();
    let mut listen = |event: &RunEvent<'_>| {
        if let RunEvent::Evaluated { round, considered } = event {
            told.push((*round, considered.iter().map(|one| one.strategy).collect()));
        }
        ControlFlow::Continue(())
    };
    session
        .run_until(Stage::Planned, &mut NoExecutor, &mut listen)
        .expect("a plan");
    let strategies: Vec<Strategy> = considered.iter().map(|one| one.strategy).collect();
    assert_eq!(told, [(1, strategies)], "who looks on is told once");
    let score = |one: &CandidateEvaluation| one.candidate.as_ref().expect("a plan").score.total;
    let best = (considered.iter()).max_by(|a, b| score(a).total_cmp(&score(b)));
    let best = best.and_then(|best| best.candidate.as_ref().ok());
    assert_eq!(session.plan(), best.map(|best| &best.plan));

    // For a robot that reaches nothing, every strategy has a reason instead of a plan.
    loaded.task.surface.world_from_surface.translation.vector.x += 10.0;
    let far = Session::new(&loaded.task, loaded.run.clone()).with_robot(robot.robot_setup());
    for one in far.evaluate_candidates().expect("plans") {
        let abandoned = one.motion.map(|motion| motion.abandoned);
        assert!(
            one.candidate.is_err() || abandoned > Some(0),
            "{abandoned:?}"
        );
    }
}

#[test]
fn strokes_are_searched_for_where_the_robot_reaches() {
    let mut loaded = loaded();
    loaded.run.plan.strategy = Strategy::Adaptive;
    loaded.run.plan.search.evaluations = 4_000;
    // So far away that the arm reaches only the nearer part of the board.
    loaded.task.surface.world_from_surface.translation.vector.y += 0.32;
    let robot = robot(&loaded);
    let session = || Session::new(&loaded.task, loaded.run.clone());
    let followed = |session: Session<'_>| {
        let mut session = session.with_robot(robot.robot_setup());
        let until = Stage::Followed;
        session
            .run_until(until, &mut NoExecutor, &mut ignore_events)
            .expect("a motion");
        let round = session.planned_round().expect("a motion");
        let performance = round.prediction.performance.ratio();
        (round.followed.abandoned.len(), performance)
    };
    let mut alone = session();
    alone
        .run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)
        .expect("a plan");
    let (failed, reached) = followed(session().with_plan(alone.plan().cloned()));
    let (fails, reaches) = followed(session());
    assert!(failed > 0, "all is in reach");
    assert!(
        reaches > reached + 0.05,
        "{reached} {reaches}, {failed} {fails} abandoned"
    );
}

/// A robot that stops itself after this time of its first motion, and records the begins and ends
/// of its motions.
struct Guarded {
    toy: Toy,
    stops_at: f64,
    /// Joint positions at the start of each motion.
    begins: Vec<Vec<f64>>,
    /// Joint positions at the end of the last motion.
    stands: Vec<f64>,
    kind: StopKind,
}

impl Guarded {
    const fn new(stops_at: f64) -> Self {
        Self {
            kind: StopKind::ProtectiveStop,
            toy: Toy::new(0.95),
            stops_at,
            begins: Vec::new(),
            stands: Vec::new(),
        }
    }
}

impl Executor for Guarded {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.begins
            .push(order.setpoint(0.0).expect("it moves").positions);
        let is_first = self.begins.len() == 1;
        let mut execution = self.toy.execute(order, &mut |sample| {
            sink(sample)?;
            if is_first && sample.time > self.stops_at {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        })?;
        if execution.ending == Ending::Stopped {
            execution.ending = Ending::ProtectiveStop {
                time: execution.duration,
                cause: StopCause::Reported {
                    kind: self.kind,
                    reason: "a hand is in the way".to_owned(),
                },
            };
        }
        self.stands.clone_from(&execution.positions);
        Ok(execution)
    }
}

#[test]
fn after_a_protective_stop_the_robot_waits_unless_the_task_says_otherwise() {
    let loaded = loaded();
    let robot = robot(&loaded);
    let config = |after_stop| RunConfig {
        target: 1.0,
        max_rounds: 2,
        sight: None,
        after_stop,
        ..loaded.run.clone()
    };
    let session = |after_stop| Session::new(&loaded.task, config(after_stop));

    let mut guarded = Guarded::new(8.0);
    let mut waiting = session(AfterStop::Wait).with_robot(robot.robot_setup());
    waiting
        .run(&mut guarded, &mut ignore_events)
        .expect("it ends");
    assert_eq!((waiting.rounds().len(), guarded.begins.len()), (1, 1));

    // At any time of the motion: in the air, on the surface, between strokes.
    for stops_at in [0.5, 4.0, 8.0, 12.0] {
        let mut guarded = Guarded::new(stops_at);
        let mut retreating = session(AfterStop::Retreat).with_robot(robot.robot_setup());
        let mut stopped = Vec::new();
        let mut look = |event: &RunEvent<'_>| {
            if let RunEvent::Decided(round) = event {
                stopped.push(round.execution.positions.clone());
            }
            ControlFlow::Continue(())
        };
        retreating.run(&mut guarded, &mut look).expect("it ends");
        let [first, second] = retreating.rounds() else {
            panic!("{stops_at}: {} rounds", retreating.rounds().len());
        };
        // If the surface has not moved, the workcell is reused.
        let [(before, cell), (after, same)] = [first, second].map(|round| {
            let PlannedRound { task, cell, .. } = &round.motion;
            (task.surface.world_from_surface, cell)
        });
        assert_eq!(Arc::ptr_eq(cell, same), before == after, "{stops_at}");
        // The next motion begins where the robot was stopped, and first lifts the tool.
        assert_eq!(guarded.begins[1], stopped[0], "{stops_at}");
        assert!(second.audit.is_sound(), "{stops_at}");
        let motions = &second.motion.followed.motions;
        let first = motions.first().expect("a motion");
        assert!(
            matches!(first.phase, Phase::Lift | Phase::FreeMotion),
            "{stops_at}: {first:?}"
        );
        let surface = &second.motion.task.surface.world_from_surface;
        let height = |time: f64| {
            let order = MotionOrder {
                round: 2,
                seed: 1,
                task: &second.motion.task,
                cell: &second.motion.cell,
                followed: &second.motion.followed,
            };
            let at = order.setpoint(time).expect("it moves");
            (surface.inverse() * at.world_from_tool).translation.vector
        };
        let (begin, up) = (height(0.0), height(first.end()));
        if first.phase == Phase::Lift {
            assert!(up.z > begin.z, "{stops_at}");
            assert!((up - begin).xy().norm() < 2e-3, "{stops_at}: {begin} {up}");
        }
        let lifted = second.motion.plan.lift_height;
        assert!(up.z >= lifted - 1e-3, "{stops_at}: {} m", up.z);
    }
}

#[test]
fn only_pushes_and_overloads_continue_by_themselves() {
    let loaded = loaded();
    let robot = robot(&loaded);
    for kind in StopKind::ALL {
        for after_stop in [AfterStop::Wait, AfterStop::Retreat] {
            let config = RunConfig {
                target: 1.0,
                max_rounds: 2,
                sight: None,
                after_stop,
                ..loaded.run.clone()
            };
            let mut session = Session::new(&loaded.task, config).with_robot(robot.robot_setup());
            let mut guarded = Guarded {
                kind,
                ..Guarded::new(8.0)
            };
            session
                .run(&mut guarded, &mut ignore_events)
                .expect("it ends");
            let continues = match kind {
                StopKind::Push | StopKind::Overload => true,
                StopKind::EmergencyStop | StopKind::Operator | StopKind::LinkLost => false,
                _ => after_stop == AfterStop::Retreat,
            };
            let motions = guarded.begins.len();
            assert_eq!(
                motions,
                if continues { 2 } else { 1 },
                "{kind}, {after_stop:?}"
            );
        }
    }
}

#[test]
fn a_motion_that_was_broken_off_is_not_complete_whatever_the_executor_says() {
    /// Calls every motion complete.
    struct Obstinate(Toy);

    impl Executor for Obstinate {
        fn execute(
            &mut self,
            order: &MotionOrder<'_>,
            sink: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            let execution = self.0.execute(order, sink)?;
            Ok(Execution {
                ending: Ending::Complete,
                ..execution
            })
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let mut stop_at_5_s = |event: &RunEvent<'_>| match event {
        RunEvent::Sample(sample) if sample.time > 5.0 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    session
        .run(&mut Obstinate(Toy::new(0.95)), &mut stop_at_5_s)
        .expect("it ends");
    assert_eq!(session.rounds()[0].execution.ending, Ending::Stopped);
}
