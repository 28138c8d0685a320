//! Robots that speak ROS 2. The companion program `wisch-ros2` connects to them.

use super::companion::Companion;
use super::words::internal;
use crate::args::{GlobalArgs, LoopArgs, RobotDoctorArgs, RobotFakeArgs, RobotPushTestArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, ask, remark};
use nalgebra::Translation3;
use std::io::IsTerminal;
use std::process::Command;
use wisch::follow::Workcell;
use wisch::geometry::Vector3;
use wisch::represent::{Observation, Surface, Task};
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, RobotState, SampleSink};
use wisch_io::{ProcessExecutor, ProcessOptions};

const ROS2: Companion = Companion {
    name: "wisch-ros2",
    building: "building wisch-ros2; this happens once and takes several minutes",
    is_workspace: true,
};

/// Shows what a robot reports, and what forbids a motion.
pub fn doctor(args: &RobotDoctorArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let mut program = begin(global, "doctor")?;
    program.arg(&args.robot);
    run_to_end(program)
}

/// Tests sign and axes of a robot's force.
pub fn push_test(args: &RobotPushTestArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let mut program = begin(global, "push-test")?;
    program.arg(&args.robot);
    program.args(args.yes.then_some("--yes"));
    run_to_end(program)
}

/// Stands in for a robot.
pub fn fake(args: &RobotFakeArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let mut program = begin(global, "fake")?;
    program.arg(&args.task).arg("--as").arg(&args.robot);
    for setting in &args.settings {
        program.args(["--set", setting]);
    }
    if let Some(seed) = args.seed {
        program.args(["--seed", &seed.to_string()]);
    }
    run_to_end(program)
}

fn begin(global: &GlobalArgs, command: &str) -> Result<Command, Failure> {
    let mut program = Command::new(ROS2.find_or_build(global)?);
    program.arg(command);
    Ok(program)
}

fn run_to_end(mut program: Command) -> Result<Outcome, Failure> {
    let status = program.status();
    let status = status.map_err(|error| Failure::new(format!("{}: {error}", ROS2.name)))?;
    match status.code() {
        Some(0) => Ok(Outcome::Done),
        Some(1) => Ok(Outcome::GoalNotMet),
        // The program has printed the reason.
        _ => Err(Failure::new(format!("{} ended: {status}", ROS2.name))),
    }
}

/// The executor of a ROS 2 robot, which asks the operator before each round, and before controllers become active.
pub struct OperatedRobot<E = ProcessExecutor> {
    process: E,
    /// Asks a question and returns whether the operator permits it; `None` permits every round.
    permit: Option<fn(&str) -> bool>,
    is_prepared: bool,
}

impl OperatedRobot {
    /// Connects to the robot of `--on`.
    ///
    /// # Errors
    /// If the companion program is missing, the robot is refused, or there is no terminal to ask on.
    pub fn start(
        args: &LoopArgs,
        global: &GlobalArgs,
        options: ProcessOptions,
    ) -> Result<Self, Failure> {
        let file = (args.on.as_ref()).ok_or_else(|| internal("there is no robot file"))?;
        let asks = !args.yes_every_round;
        if asks && !std::io::stdin().is_terminal() {
            let text = "--on asks before each round, but standard input is not a terminal";
            return Err(Failure::new(text)
                .with_help("use a terminal, or --yes-every-round if nobody is within reach"));
        }
        let program = ROS2.find_or_build(global)?;
        let [program, file] = [program.display(), file.display()].map(|path| path.to_string());
        let mut words = vec!["execute".to_owned(), file];
        words.extend(["--speed".to_owned(), args.speed.to_string()]);
        words.extend(args.air.is_some().then(|| "--air".to_owned()));
        words.extend(asks.then(|| "--operated".to_owned()));
        let process = ProcessExecutor::start_with(&program, &words, options);
        let process = process.map_err(|error| {
            Failure::new(error).with_help("docs/ros2.md says what is refused, and what to do")
        })?;
        let permit: fn(&str) -> bool = ask;
        Ok(Self {
            process,
            permit: asks.then_some(permit),
            is_prepared: false,
        })
    }
}

impl<E: Executor> OperatedRobot<E> {
    /// Prepares the robot unless it is prepared.
    fn prepare_once(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        if !self.is_prepared {
            self.process.prepare(cell)?;
            self.is_prepared = true;
        }
        Ok(())
    }
}

impl<E: Executor> Executor for OperatedRobot<E> {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        if self.permit.is_some() {
            // Controllers become active only after the first question.
            return Ok(());
        }
        self.prepare_once(cell)
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        self.is_prepared = false;
        self.process.finish()
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let round = order.round;
        let first = if self.is_prepared {
            ""
        } else {
            "controllers that are inactive become active, and "
        };
        let question = format!(
            "round {round}: {first}the robot moves for {:.0} s as planned. Is nobody within reach? Type y to move it",
            order.followed.duration()
        );
        if self.permit.is_some_and(|permit| !permit(&question)) {
            let text = format!("round {round}: the operator did not answer y, so nothing moves");
            return Err(ExecutorError::new(text));
        }
        self.prepare_once(order.cell)?;
        self.process.execute(order, sink)
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        self.process.state()
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        self.process.observe(task)
    }
}

/// Raises a surface along its normal by the height of `--air` [m], and prints a note.
pub fn raise(surface: &mut Surface, height: f64) {
    let normal = surface.world_from_surface * Vector3::z();
    surface.world_from_surface = Translation3::from(normal * height) * surface.world_from_surface;
    remark(&format!(
        "the robot wipes {height} m above the surface, without force; the estimate means nothing"
    ));
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::ControlFlow;
    use wisch::follow::Followed;
    use wisch::run::Ending;
    use wisch_io::{LoadOptions, load_task};

    /// An executor that notes what it is asked for.
    #[derive(Default)]
    struct NotedCalls(Vec<&'static str>);

    impl Executor for NotedCalls {
        fn prepare(&mut self, _: &Workcell) -> Result<(), ExecutorError> {
            self.0.push("prepare");
            Ok(())
        }

        fn finish(&mut self) -> Result<(), ExecutorError> {
            self.0.push("finish");
            Ok(())
        }

        fn execute(
            &mut self,
            _: &MotionOrder<'_>,
            _: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            self.0.push("execute");
            Ok(Execution::from_positions(&[]))
        }

        fn observe(&mut self, _: &Task) -> Result<Option<Observation>, ExecutorError> {
            Ok(None)
        }
    }

    /// Two rounds on a robot; returns what was asked of it, and how the rounds ended.
    fn two_rounds(permit: Option<fn(&str) -> bool>) -> (Vec<&'static str>, Vec<bool>) {
        let loaded = load_task("arm-board".as_ref(), &LoadOptions::default()).unwrap();
        let robot = loaded.robot().unwrap().unwrap();
        let record = loaded.file.robot.as_ref().unwrap();
        let config = record.workcell_config(&loaded.task);
        let cell = Workcell::new(robot.model, robot.srdf.as_ref(), &loaded.task, &config).unwrap();
        let mut operated = OperatedRobot {
            process: NotedCalls::default(),
            permit,
            is_prepared: false,
        };
        operated.prepare(&cell).unwrap();
        operated.process.0.push("prepared");
        let at_rest = Followed::new(*cell.tip_from_tool());
        let ended = [1, 2].map(|round| {
            let order = MotionOrder {
                round,
                seed: 1,
                task: &loaded.task,
                cell: &cell,
                followed: &at_rest,
            };
            let executed = operated.execute(&order, &mut |_| ControlFlow::Continue(()));
            executed.is_ok_and(|execution| execution.ending == Ending::Complete)
        });
        operated.finish().unwrap();
        (operated.process.0, ended.to_vec())
    }

    #[test]
    fn controllers_become_active_only_after_the_first_permission() {
        let (calls, ended) = two_rounds(Some(|_| false));
        assert_eq!(calls, ["prepared", "finish"]);
        assert_eq!(ended, [false, false]);
        let (calls, ended) = two_rounds(Some(|_| true));
        assert_eq!(
            calls,
            ["prepared", "prepare", "execute", "execute", "finish"]
        );
        assert_eq!(ended, [true, true]);
        let names_controllers = |question: &str| question.contains("become active");
        let (calls, ended) = two_rounds(Some(names_controllers));
        assert_eq!(calls, ["prepared", "prepare", "execute", "finish"]);
        assert_eq!(ended, [true, false]);
        let (calls, _) = two_rounds(None);
        assert_eq!(
            calls,
            ["prepare", "prepared", "execute", "execute", "finish"]
        );
    }
}
