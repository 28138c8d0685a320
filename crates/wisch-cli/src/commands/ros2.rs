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

/// The executor of a ROS 2 robot, which asks the operator before each round.
pub struct OperatedRobot {
    process: ProcessExecutor,
    asks: bool,
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
        Ok(Self { process, asks })
    }
}

impl Executor for OperatedRobot {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        self.process.prepare(cell)
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        self.process.finish()
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let round = order.round;
        let question = format!(
            "round {round}: the robot moves for {:.0} s as planned. Is nobody within reach? Type y to move it",
            order.followed.duration()
        );
        if self.asks && !ask(&question) {
            let text = format!("round {round}: the operator did not answer y, so nothing moves");
            return Err(ExecutorError::new(text));
        }
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
