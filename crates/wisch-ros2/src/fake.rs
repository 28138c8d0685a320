//! A robot that stands in for a real one: a simulated world behind the topics, services and action of a robot file.

mod arm;
mod commands;
mod servers;

use crate::link::Link;
use crate::messages::{
    Bool, Float64, Header, JointStateMessage, PointMessage, SafetyMode, Stamp,
    TrajectoryControllerState, Vector, VectorPair, WrenchStamped,
};
use crate::robot_file::{Distro, RobotFile};
use arm::FakeArm;
use commands::{Command, Commands};
use nalgebra::Vector3;
use ros2_client::Publisher;
use servers::Servers;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};
use wisch::control::ControlConfig;
use wisch::follow::{Followed, Workcell};
use wisch::run::MotionOrder;
use wisch_io::{LoadOptions, Robot, load_task};
use wisch_sim::{Dirt, LiveArm, WorkSurface};

pub(crate) use commands::COMMANDS;

/// Periods of the controller between two joint states, and between two states of the controller.
const STATE_PERIODS: u64 = 2;
const SLOW_PERIODS: u64 = 10;
/// Lag behind real time from which the world no longer tries to catch up.
const MOST_LAG: Duration = Duration::from_millis(20);
/// Frame that headers of wrenches have if the robot file names the link of the sensor.
const SENSOR_FRAME: &str = "fake_sensor";

/// What the arm measured in the last period.
#[derive(Debug, Clone, Default)]
struct Measured {
    positions: Vec<f64>,
    velocities: Vec<f64>,
    efforts: Vec<f64>,
    /// Force of the surroundings on the tool, in the axes of the world [N].
    force: Vector3<f64>,
}

/// Publishers of the robot's topics.
struct Topics {
    joints: Publisher<JointStateMessage>,
    wrench: Option<Publisher<WrenchStamped>>,
    progress: Option<Publisher<TrajectoryControllerState>>,
    scaling: Option<Publisher<Float64>>,
    safety: Option<Publisher<SafetyMode>>,
    program: Option<Publisher<Bool>>,
}

impl Topics {
    fn open(link: &mut Link, file: &RobotFile) -> Result<Self, crate::link::LinkError> {
        let joint_state = ["sensor_msgs", "JointState"];
        let joints = link.publisher(&file.motion.joint_states, joint_state, false)?;
        let wrench = (file.force.topic.as_ref())
            .map(|topic| link.publisher(topic, ["geometry_msgs", "WrenchStamped"], false))
            .transpose()?;
        let state = ["control_msgs", "JointTrajectoryControllerState"];
        let progress = (file.motion.progress.as_ref())
            .map(|topic| link.publisher(topic, state, false))
            .transpose()?;
        let scaling = (file.motion.scaling.as_ref())
            .map(|topic| link.publisher(topic, ["std_msgs", "Float64"], false))
            .transpose()?;
        let safety = (file.stop.safety.as_ref())
            .map(|topic| link.publisher(topic, ["ur_dashboard_msgs", "SafetyMode"], true))
            .transpose()?;
        let program = (file.stop.program.as_ref())
            .map(|topic| link.publisher(topic, ["std_msgs", "Bool"], true))
            .transpose()?;
        Ok(Self {
            joints,
            wrench,
            progress,
            scaling,
            safety,
            program,
        })
    }
}

/// Stands in for the robot of a file until the command `quit`, or until it is killed.
///
/// # Errors
/// If the task or the robot cannot be read, or DDS refuses.
pub(crate) fn simulate_robot(
    task: &Path,
    file: &RobotFile,
    settings: &[String],
    seed: Option<u64>,
) -> Result<(), String> {
    if file.link.ros_distro != Distro::Jazzy {
        return Err("link.ros_distro: the fake robot has the messages of jazzy only".to_owned());
    }
    let settings: Result<Vec<(String, String)>, String> = (settings.iter())
        .map(|text| {
            let (key, value) = text
                .split_once('=')
                .ok_or_else(|| format!("--set {text}: expected KEY=VALUE"))?;
            Ok((key.to_owned(), value.to_owned()))
        })
        .collect();
    let options = LoadOptions {
        settings: settings?,
        seed,
        ..LoadOptions::default()
    };
    let loaded = load_task(task, &options).map_err(|error| error.to_string())?;
    let frames = crate::frames::Frames::read(&file.path, &file.urdf, file.base_frame.as_deref())?;
    let robot = Robot::load(&frames.source).map_err(|error| error.to_string())?;
    let record = loaded.file.robot.as_ref();
    let record = record.ok_or("the task has no [robot], so the robot's position is not known")?;
    let config = record.workcell_config(&loaded.task);
    let cell = Workcell::new(robot.model, robot.srdf.as_ref(), &loaded.task, &config);
    let cell = cell.map_err(|error| error.to_string())?;
    let world = loaded.simulation.clone();
    let seed = loaded.task.seed;
    let dirt = Dirt::draw(&WorkSurface::from_task(&loaded.task), &world, seed);
    let dirt = dirt.map_err(|error| error.to_string())?;
    let at_rest = Followed::new(*cell.tip_from_tool());
    let order = MotionOrder {
        round: 1,
        seed,
        task: &loaded.task,
        cell: &cell,
        followed: &at_rest,
    };
    let control = ControlConfig::default();
    let live = LiveArm::new(&order, &world, &dirt, &control).map_err(|error| error.to_string())?;
    let mut link = Link::open(&file.link, "fake_robot").map_err(|error| error.to_string())?;
    let topics = Topics::open(&mut link, file).map_err(|error| error.to_string())?;
    let servers = Servers::open(&mut link, file).map_err(|error| error.to_string())?;
    let press_force = loaded.task.interaction.contact_force();
    let names = frames.joint_names();
    let arm = FakeArm::new(names, cell.ready_posture(), press_force);
    log(&format!(
        "ready: {} in {}",
        cell.robot().name(),
        link.network
    ));
    let mut stand_in = StandIn {
        file,
        cell: &cell,
        topics,
        servers,
        arm,
        commands: Commands::start(),
        is_silent: [false; 3],
        is_shuffled: false,
        jumps: vec![0.0; cell.robot().dof()],
        clock_offset: 0.0,
        sign: 1.0,
        tare: Vector3::zeros(),
        push: (Vector3::zeros(), Instant::now()),
        measured: Measured::default(),
    };
    stand_in.publish_modes();
    stand_in.run(live, control.period)
}

/// Prints an event with the time of this computer's clock, for tests and for people.
fn log(text: &str) {
    println!("{:.4} {text}", now_seconds());
}

/// Time since 1970 [s].
fn now_seconds() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0.0, |since| since.as_secs_f64())
}

/// A running fake robot.
struct StandIn<'a> {
    file: &'a RobotFile,
    cell: &'a Workcell,
    topics: Topics,
    servers: Servers,
    arm: FakeArm,
    commands: Commands,
    /// Whether joint states, wrenches, and states of the controller are not sent.
    is_silent: [bool; 3],
    is_shuffled: bool,
    /// Error of each joint's stated position [rad or m].
    jumps: Vec<f64>,
    clock_offset: f64,
    sign: f64,
    /// The sensor's zero, and a push on the tool with its end, in the axes of the world [N].
    tare: Vector3<f64>,
    push: (Vector3<f64>, Instant),
    measured: Measured,
}

impl StandIn<'_> {
    /// Runs the world in real time. `period`: of the controller [s].
    fn run(&mut self, mut live: LiveArm<'_>, period: f64) -> Result<(), String> {
        let step = Duration::from_secs_f64(period);
        let mut due = Instant::now();
        for number in 0_u64.. {
            let (setpoint, share) = self.arm.advance(period);
            let measured = &mut self.measured;
            let stopped = live.step(&setpoint, share, &mut |sample| {
                measured.positions.clear();
                measured.positions.extend_from_slice(sample.positions);
                measured.velocities.clear();
                measured.velocities.extend_from_slice(sample.velocities);
                measured.efforts.clear();
                measured.efforts.extend_from_slice(sample.efforts);
                measured.force = sample.external.force;
                ControlFlow::Continue(())
            });
            if let Some(cause) = stopped.map_err(|error| error.to_string())? {
                return Err(format!("the simulated robot stopped itself: {cause}"));
            }
            self.arm.measure(&self.measured.positions);
            if number % STATE_PERIODS == 0 {
                self.publish_states();
                self.serve();
            }
            if number % SLOW_PERIODS == 0 {
                self.publish_progress();
                while let Some(command) = self.commands.poll() {
                    if command == Command::Quit {
                        return Ok(());
                    }
                    self.execute_command(command);
                }
            }
            due += step;
            let now = Instant::now();
            match due.checked_duration_since(now) {
                Some(left) => std::thread::sleep(left),
                None if now - due > MOST_LAG => due = now,
                None => {}
            }
        }
        Ok(())
    }

    /// Answers requests of services and of the action.
    fn serve(&mut self) {
        if self.servers.serve(&mut self.arm) {
            self.tare = self.measured.force;
            log("tare");
        }
    }

    fn stamp(&self) -> Stamp {
        Stamp::from_seconds((now_seconds() + self.clock_offset).max(0.0))
    }

    /// Sends joint state and wrench.
    fn publish_states(&self) {
        let stamp = self.stamp();
        let names = self.arm.names();
        let mut order: Vec<usize> = (0..names.len()).collect();
        if self.is_shuffled {
            order.reverse();
        }
        let pick = |values: &[f64]| order.iter().map(|&i| values[i]).collect();
        let stated = self.measured.positions.iter().zip(&self.jumps);
        let stated: Vec<f64> = stated.map(|(position, jump)| position + jump).collect();
        if !self.is_silent[0] {
            let _ = self.topics.joints.publish(JointStateMessage {
                header: Header {
                    stamp,
                    frame_id: String::new(),
                },
                name: order.iter().map(|&i| names[i].clone()).collect(),
                position: pick(&stated),
                velocity: pick(&self.measured.velocities),
                effort: pick(&self.measured.efforts),
            });
        }
        let Some(wrench) = self.topics.wrench.as_ref().filter(|_| !self.is_silent[1]) else {
            return;
        };
        let (push, until) = self.push;
        let push = if Instant::now() < until {
            push
        } else {
            Vector3::zeros()
        };
        let force = self.measured.force + push - self.tare;
        let Some((frame_id, force)) = self.in_sensor_axes(force) else {
            return;
        };
        let force = force * self.sign;
        let _ = wrench.publish(WrenchStamped {
            header: Header { stamp, frame_id },
            wrench: VectorPair {
                linear: Vector {
                    x: force.x,
                    y: force.y,
                    z: force.z,
                },
                ..VectorPair::default()
            },
        });
    }

    /// Turns a force from the axes of the world into those of the sensor, with the frame of its header.
    fn in_sensor_axes(&self, force: Vector3<f64>) -> Option<(String, Vector3<f64>)> {
        let robot = self.cell.robot();
        let (frame, link) = match &self.file.force.link {
            Some(name) => (SENSOR_FRAME.to_owned(), robot.link(name).ok()?),
            None => {
                let tip = self.cell.tip();
                (robot.links()[tip.index()].name.clone(), tip)
            }
        };
        let kinematics = robot.forward_kinematics(&self.measured.positions).ok()?;
        let world_from_link = self.cell.world_from_root() * kinematics.world_from_link(link);
        Some((frame, world_from_link.rotation.inverse() * force))
    }

    /// Sends the state of the controller and the speed scaling.
    fn publish_progress(&self) {
        if self.is_silent[2] {
            return;
        }
        if let Some(scaling) = &self.topics.scaling {
            let data = self.arm.scaling() * self.file.motion.full_scaling;
            let _ = scaling.publish(Float64 { data });
        }
        if let Some(progress) = &self.topics.progress {
            let _ = progress.publish(TrajectoryControllerState {
                header: Header {
                    stamp: self.stamp(),
                    frame_id: String::new(),
                },
                joint_names: self.arm.names().to_vec(),
                reference: PointMessage {
                    time_from_start: Stamp::from_seconds(self.arm.trajectory_time()),
                    ..PointMessage::default()
                },
                speed_scaling_factor: self.arm.scaling(),
                ..TrajectoryControllerState::default()
            });
        }
    }

    /// Sends safety mode and whether the program runs; the topics are latched.
    fn publish_modes(&self) {
        if let Some(safety) = &self.topics.safety {
            let mode = self.arm.safety_mode;
            let _ = safety.publish(SafetyMode { mode });
        }
        if let Some(program) = &self.topics.program {
            let data = self.arm.program_runs;
            let _ = program.publish(Bool { data });
        }
    }

    /// Executes a command of a test or a person.
    fn execute_command(&mut self, command: Command) {
        log(&format!("command {command:?}"));
        match command {
            Command::Push(force, seconds) => {
                let end = Instant::now() + Duration::from_secs_f64(seconds);
                self.push = (Vector3::from(force), end);
            }
            Command::Scaling(share) => self.arm.set_scaling(share),
            Command::Safety(mode) => {
                self.arm.safety_mode = mode;
                self.publish_modes();
                if mode != 1 {
                    self.servers.abort(&mut self.arm, "safety stop");
                }
            }
            Command::Program(runs) => {
                self.arm.program_runs = runs;
                self.publish_modes();
                if !runs {
                    self.servers.abort(&mut self.arm, "the program has ended");
                }
            }
            Command::Silence(which) => self.is_silent[which] = true,
            Command::Speak => self.is_silent = [false; 3],
            Command::Shuffle => self.is_shuffled = !self.is_shuffled,
            Command::Move(joint, distance) => self.arm.displace(joint, distance),
            Command::Jump(joint, distance) => {
                if let Some(jump) = self.jumps.get_mut(joint) {
                    *jump = distance;
                }
            }
            Command::Clock(offset) => self.clock_offset = offset,
            Command::Sign(sign) => self.sign = sign,
            Command::Reject(is_rejecting) => self.arm.is_rejecting = is_rejecting,
            Command::Delay(seconds) => self.servers.delay = Duration::from_secs_f64(seconds),
            Command::Refuse(refuses) => self.servers.refuses_release = refuses,
            Command::Quit => {}
        }
    }
}
