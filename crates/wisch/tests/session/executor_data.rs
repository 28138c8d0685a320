//! What executors state: positions, velocities, poses and observations that contradict what is known.

use super::{Toy, loaded, robot};
use nalgebra::Translation3;
use std::ops::ControlFlow;
use wisch::geometry::Point2;
use wisch::interpret::{Doubt, TouchSample};
use wisch::represent::{Observation, Task};
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, NoExecutor, RobotState, RunConfig,
    RunEvent, SampleSink, Session, Stage, StopCause, StopKind, TelemetrySample, ignore_events,
};

/// Reports its first sample late, with the joints in the opposite order or in their own.
struct Late {
    is_reversed: bool,
}

impl Executor for Late {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let at = order.setpoint(3.0).expect("it moves");
        let mut positions = at.positions.clone();
        if self.is_reversed {
            positions.reverse();
        }
        let touch = TouchSample::new(at.time, at.world_from_tool, order.task.surface_reaction());
        let sample = TelemetrySample {
            positions: &positions,
            ..TelemetrySample::from_touch(&touch, at.motion, at.phase)
        };
        let _ = sink(&sample);
        Err(ExecutorError::new("it was accepted"))
    }
}

#[test]
fn a_first_sample_is_checked_at_any_time() {
    let loaded = loaded();
    let robot = robot(&loaded);
    for (is_reversed, expected) in [
        (true, "from its motion until then"),
        (false, "it was accepted"),
    ] {
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let error = session.run(&mut Late { is_reversed }, &mut ignore_events);
        let error = error.expect_err("it fails").to_string();
        assert!(error.contains(expected), "{is_reversed}: {error}");
    }
}

#[test]
fn velocities_are_checked_without_positions() {
    /// Measures velocities alone.
    struct Turning(Vec<f64>);

    impl Executor for Turning {
        fn execute(
            &mut self,
            _: &MotionOrder<'_>,
            _: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            Err(ExecutorError::new("it was executed"))
        }

        fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
            Ok(Some(RobotState {
                positions: Vec::new(),
                velocities: self.0.clone(),
            }))
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    for (velocities, expected) in [
        (
            vec![0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0],
            "moves at 0.500 rad/s",
        ),
        (
            vec![0.0; 3],
            "reported 3 joint velocities before the motion, expected 7",
        ),
        (vec![0.0; 7], "it was executed"),
    ] {
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let error = session.run(&mut Turning(velocities), &mut ignore_events);
        let error = error.expect_err("it is refused").to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn a_motion_does_not_begin_while_the_robot_moves() {
    /// A robot at the start of the motion that still moves.
    struct Moving(f64);

    impl Executor for Moving {
        fn execute(
            &mut self,
            _: &MotionOrder<'_>,
            _: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            Err(ExecutorError::new("it was executed"))
        }

        fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
            let positions = ready();
            let mut velocities = vec![0.0; positions.len()];
            velocities[1] = self.0;
            Ok(Some(RobotState {
                positions,
                velocities,
            }))
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    for (velocity, expected) in [
        (
            -0.3,
            "moves at 0.300 rad/s, more than the limit of 0.02 rad/s for a robot at rest",
        ),
        (0.019, "it was executed"),
    ] {
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let error = session.run(&mut Moving(velocity), &mut ignore_events);
        let error = error.expect_err("it is refused").to_string();
        assert!(error.contains(expected), "{velocity}: {error}");
    }
}

/// The posture in which the first motion begins.
fn ready() -> Vec<f64> {
    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session
        .run_until(Stage::Followed, &mut NoExecutor, &mut ignore_events)
        .expect("a motion");
    let planned = session.planned_round().expect("a motion");
    planned.cell.ready_posture().to_vec()
}

#[test]
fn a_motion_that_begins_elsewhere_is_not_executed() {
    /// A robot that reports other positions than those of its ready posture.
    struct Elsewhere(f64);

    impl Executor for Elsewhere {
        fn execute(
            &mut self,
            _: &MotionOrder<'_>,
            _: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            Err(ExecutorError::new("it was executed"))
        }

        fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
            let mut state = ready();
            state[2] += self.0;
            Ok(Some(state.into()))
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    for (off, expected) in [
        (
            2.88,
            "is 2.880 rad from the start of the motion, more than the limit of 0.05 rad (execution.start_rad), so the motion \
             is not executed; move the joint to ",
        ),
        (-0.051, "is 0.051 rad from the start"),
        (0.049, "it was executed"),
    ] {
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let error = session.run(&mut Elsewhere(off), &mut ignore_events);
        let error = error.expect_err("it is refused").to_string();
        assert!(error.contains(expected), "{off}: {error}");
    }
}

#[test]
fn a_camera_that_fails_after_a_motion_loses_no_round() {
    /// Observes the dirt once, before the first round.
    struct Blinded(Toy, bool);

    impl Executor for Blinded {
        fn execute(
            &mut self,
            order: &MotionOrder<'_>,
            sink: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            self.0.execute(order, sink)
        }

        fn observe(&mut self, _: &Task) -> Result<Option<Observation>, ExecutorError> {
            if std::mem::replace(&mut self.1, true) {
                return Err(ExecutorError::new("camera 1: no picture"));
            }
            Ok(None)
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let mut decided = 0;
    let error = session.run(&mut Blinded(Toy::new(0.95), false), &mut |event| {
        decided += usize::from(matches!(event, RunEvent::Decided(_)));
        ControlFlow::Continue(())
    });
    let error = error.expect_err("it fails").to_string();
    assert_eq!(error, "camera 1: no picture");
    assert_eq!((session.rounds().len(), decided), (1, 1));
    assert!(session.rounds()[0].interpretation.plane.is_some());
}

#[test]
fn poses_that_contradict_the_joint_positions_raise_a_doubt() {
    /// Measures joint positions, and poses so far beside them [m].
    struct Beside(f64);

    impl Executor for Beside {
        fn execute(
            &mut self,
            order: &MotionOrder<'_>,
            sink: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            let mut execution = Execution::from_positions(&[]);
            for at in order.setpoints(0.02) {
                let share = 0.95 * f64::from(at.phase.is_contact());
                let force = order.task.surface_reaction() * share;
                let pose = Translation3::new(self.0, 0.0, 0.0) * at.world_from_tool;
                let touch = TouchSample::new(at.time, pose, force);
                let _ = sink(&TelemetrySample {
                    positions: &at.positions,
                    ..TelemetrySample::from_touch(&touch, at.motion, at.phase)
                });
                (execution.duration, execution.positions) = (at.time, at.positions);
            }
            Ok(execution)
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    let contradiction = |off: f64| {
        let mut session = loaded.session().with_robot(robot.robot_setup());
        session
            .run_until(Stage::Decided, &mut Beside(off), &mut ignore_events)
            .expect("a round");
        let doubts = &session.rounds()[0].interpretation.doubts;
        let found = doubts
            .iter()
            .find(|doubt| matches!(doubt, Doubt::PositionsContradictPose { .. }));
        found.map(Doubt::is_decisive)
    };
    let found = [0.0, 0.005, 0.02, 0.05].map(contradiction);
    assert_eq!(found, [None, None, Some(false), Some(true)]);
}

#[test]
fn a_crumb_on_the_floor_ends_no_run() {
    /// Sees all dirt before the first round, and a crumb half a metre beside a clean surface after it.
    struct Tidy(Toy);

    impl Executor for Tidy {
        fn execute(
            &mut self,
            order: &MotionOrder<'_>,
            sink: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            self.0.execute(order, sink)
        }

        fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
            let detections = if self.0.executed == 0 {
                task.particles.iter().map(|(place, _)| place).collect()
            } else {
                vec![Point2::new(0.66, 0.0)]
            };
            Ok(Some(Observation {
                detections,
                ..Observation::default()
            }))
        }
    }

    let loaded = loaded();
    let robot = robot(&loaded);
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session
        .run_until(
            Stage::Decided,
            &mut Tidy(Toy::new(0.95)),
            &mut ignore_events,
        )
        .expect("a round");
    let interpretation = &session.rounds()[0].interpretation;
    let doubts = &interpretation.doubts;
    let is_left_out = |doubt: &Doubt| matches!(doubt, Doubt::DetectionsBeside { left_out: 1, .. });
    assert!(doubts.iter().any(is_left_out), "{doubts:?}");
    let seen = interpretation.observation.as_ref().expect("a camera");
    assert!(seen.detections.is_empty());
}

/// Statement about the joint positions after a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stated {
    Nothing,
    Measured,
    /// The positions at the planned end of the motion.
    Planned,
}

/// A robot that an obstacle blocks during its first motion.
#[derive(Debug, Clone, Copy)]
struct Blocked {
    /// Share of the duration after which it stands still.
    after: f64,
    /// Share of the duration after which a push ends the motion.
    pushed_after: f64,
    measures_joints: bool,
    end: Stated,
    state: Stated,
    executed: usize,
}

/// A robot that measures its joints, is blocked after 60 % of its motion, and reports the measured end.
const BLOCKED: Blocked = Blocked {
    after: 0.6,
    pushed_after: 1.0,
    measures_joints: true,
    end: Stated::Measured,
    state: Stated::Nothing,
    executed: 0,
};

/// A [`Blocked`] robot with the positions at the last measured and at the planned end.
struct BlockedRobot {
    robot: Blocked,
    measured: Vec<f64>,
    planned: Vec<f64>,
}

impl BlockedRobot {
    fn positions(&self, stated: Stated) -> Vec<f64> {
        match stated {
            Stated::Nothing => Vec::new(),
            Stated::Measured => self.measured.clone(),
            Stated::Planned => self.planned.clone(),
        }
    }
}

impl Executor for BlockedRobot {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        self.robot.executed += 1;
        let setpoints: Vec<_> = order.setpoints(0.01).collect();
        let share = |share: f64| (share * (setpoints.len() - 1) as f64) as usize;
        let (blocked, last) = (share(self.robot.after), share(self.robot.pushed_after));
        self.planned
            .clone_from(&setpoints[setpoints.len() - 1].positions);
        for (k, planned) in setpoints.iter().enumerate().take(last + 1) {
            let at = &setpoints[if self.robot.executed == 1 {
                k.min(blocked)
            } else {
                k
            }];
            let share = 0.95 * f64::from(at.phase.is_contact());
            let force = order.task.surface_reaction() * share;
            let touch = TouchSample::new(planned.time, at.world_from_tool, force);
            self.measured.clone_from(&at.positions);
            let positions = match self.robot.measures_joints {
                true => &at.positions[..],
                false => &[],
            };
            let _ = sink(&TelemetrySample {
                positions,
                ..TelemetrySample::from_touch(&touch, planned.motion, planned.phase)
            });
        }
        let time = setpoints[last].time;
        let stop = Ending::ProtectiveStop {
            time,
            cause: StopCause::Reported {
                kind: StopKind::Push,
                reason: "a hand".to_owned(),
            },
        };
        Ok(Execution {
            duration: time,
            ending: match last + 1 < setpoints.len() {
                true => stop,
                false => Ending::Complete,
            },
            ..Execution::from_positions(&self.positions(self.robot.end))
        })
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        let state = self.positions(self.robot.state);
        Ok((self.robot.executed > 0).then(|| state.into()))
    }
}

/// Lets a robot execute up to two motions. Returns the error, the number of motions, and the doubts about the first one.
fn run_blocked(robot: Blocked) -> (String, usize, Vec<Doubt>) {
    let loaded = loaded();
    let setup = self::robot(&loaded);
    let config = RunConfig {
        target: 1.0,
        max_rounds: 2,
        sight: None,
        ..loaded.run.clone()
    };
    let mut session = Session::new(&loaded.task, config).with_robot(setup.robot_setup());
    let mut executor = BlockedRobot {
        robot,
        measured: Vec::new(),
        planned: Vec::new(),
    };
    let ended = session.run(&mut executor, &mut ignore_events);
    let error = ended
        .err()
        .map_or_else(String::new, |error| error.to_string());
    let doubts = session.rounds()[0].interpretation.doubts.clone();
    (error, executor.robot.executed, doubts)
}

#[test]
fn no_motion_follows_where_the_end_or_the_state_contradicts_the_last_sample() {
    let by_end = "by the last sample, but at";
    let cases = [
        (
            Blocked {
                end: Stated::Planned,
                ..BLOCKED
            },
            "by the end of the motion, ",
        ),
        (
            Blocked {
                state: Stated::Planned,
                ..BLOCKED
            },
            "by the state between the motions, ",
        ),
        (
            Blocked {
                end: Stated::Planned,
                state: Stated::Planned,
                ..BLOCKED
            },
            "by the end of the motion, ",
        ),
        // A push stops the robot at once, and the end is that of the plan.
        (
            Blocked {
                after: 1.0,
                pushed_after: 0.3,
                end: Stated::Planned,
                ..BLOCKED
            },
            "by the end of the motion, ",
        ),
        (
            Blocked {
                after: 1.0,
                pushed_after: 0.3,
                state: Stated::Planned,
                ..BLOCKED
            },
            "by the state between the motions, ",
        ),
    ];
    for (robot, expected) in cases {
        let (error, executed, _) = run_blocked(robot);
        for part in [
            expected,
            by_end,
            "joint \"",
            "(execution.start_rad",
            "apart",
        ] {
            assert!(error.contains(part), "{robot:?}: {error}");
        }
        assert_eq!(executed, 1, "{robot:?}");
    }
    // Poses alone show that the robot has not reached the end, whether it is stated or not.
    for end in [Stated::Planned, Stated::Nothing] {
        let robot = Blocked {
            measures_joints: false,
            end,
            ..BLOCKED
        };
        let (error, executed, _) = run_blocked(robot);
        assert!(
            error.contains("m from the end of the motion, more than the limit of 0.1"),
            "{error}"
        );
        assert_eq!(executed, 1, "{end:?}");
    }
    // Where both agree, the next motion does not begin, because the robot is not at its start.
    let (error, executed, _) = run_blocked(BLOCKED);
    assert!(error.contains("from the start of the motion"), "{error}");
    assert_eq!(executed, 1);
    for (after, pushed_after, state) in [
        (1.0, 1.0, Stated::Planned),
        (1.0, 0.3, Stated::Measured),
        (1.0, 0.3, Stated::Nothing),
    ] {
        let robot = Blocked {
            after,
            pushed_after,
            state,
            ..BLOCKED
        };
        let (error, executed, _) = run_blocked(robot);
        assert_eq!((error.as_str(), executed), ("", 2), "{robot:?}");
    }
}

#[test]
fn a_robot_that_stood_still_is_stated() {
    let stood = |after: f64, measures_joints: bool| {
        let (_, _, doubts) = run_blocked(Blocked {
            after,
            measures_joints,
            ..BLOCKED
        });
        let mut found = doubts.iter().filter_map(|doubt| match doubt {
            Doubt::RobotStoodStill { time, ordered } => Some(time / ordered),
            _ => None,
        });
        found.next()
    };
    for measures_joints in [true, false] {
        assert_eq!(stood(1.0, measures_joints), None);
        let share = stood(0.6, measures_joints).expect("it stood still");
        assert!((share - 0.4).abs() < 0.1, "{share}");
    }
}
