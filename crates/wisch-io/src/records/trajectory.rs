//! Trajectories for other programs: joint motion as ROS 2 messages, and the tool's path as a table.

use serde::Serialize;
use std::fmt::Write;
use std::io;
use wisch::follow::{FollowConfig, Followed, Phase, ToolPose, TrajectorySample, Workcell};
use wisch::geometry::{PlanarPose, Pose, wrap_angle};
use wisch::plan::Plan;
use wisch::represent::{Interaction, Task};

/// Period of the points [s], between which joint controllers interpolate.
const PERIOD: f64 = 0.02;
/// Resolution of written numbers: a micrometre, a microradian.
const PER_UNIT: f64 = 1e6;
const NANOSECONDS: f64 = 1e9;

/// `moveit_msgs/msg/RobotTrajectory`: a `trajectory_msgs/msg/JointTrajectory` of the joints and a
/// `trajectory_msgs/msg/MultiDOFJointTrajectory` of a base that moves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RobotTrajectory {
    joint_trajectory: JointTrajectory,
    multi_dof_joint_trajectory: MultiDofJointTrajectory,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct JointTrajectory {
    header: Header,
    joint_names: Vec<String>,
    points: Vec<Point>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct MultiDofJointTrajectory {
    header: Header,
    joint_names: Vec<String>,
    points: Vec<MultiDofPoint>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Header {
    stamp: Duration,
    frame_id: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
struct Duration {
    sec: i32,
    nanosec: u32,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Point {
    positions: Vec<f64>,
    velocities: Vec<f64>,
    accelerations: Vec<f64>,
    effort: [f64; 0],
    time_from_start: Duration,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct MultiDofPoint {
    transforms: [Transform; 1],
    velocities: [Twist; 1],
    accelerations: [Twist; 1],
    time_from_start: Duration,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Transform {
    translation: Xyz,
    rotation: Xyzw,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Twist {
    linear: Xyz,
    angular: Xyz,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Xyz {
    x: f64,
    y: f64,
    z: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Xyzw {
    x: f64,
    y: f64,
    z: f64,
    w: f64,
}

impl RobotTrajectory {
    /// Makes the message of the whole motion: the joints of the wiping group and of the second arm, and a mobile base.
    pub fn new(followed: &Followed, cell: &Workcell) -> Self {
        let robot = cell.robot();
        let variables = cell.arm_variables();
        let header = |frame: &str| Header {
            stamp: Duration { sec: 0, nanosec: 0 },
            frame_id: frame.to_owned(),
        };
        let samples = samples(followed);
        let chosen = |values: &[f64]| variables.iter().map(|&i| rounded(values[i])).collect();
        let name = |&i: &usize| robot.variable(i).name.clone();
        let points = samples.iter().map(|sample| Point {
            positions: chosen(&sample.q),
            velocities: chosen(&sample.qd),
            accelerations: chosen(&sample.qdd),
            effort: [],
            time_from_start: duration(sample.time),
        });
        let base_link = &robot.links()[cell.ik().chain().base().index()].name;
        let base = cell.base().map(|base| {
            let twist = move |values: &[f64]| Twist {
                linear: Xyz {
                    x: rounded(values[base.x]),
                    y: rounded(values[base.y]),
                    z: 0.0,
                },
                angular: Xyz {
                    x: 0.0,
                    y: 0.0,
                    z: rounded(values[base.yaw]),
                },
            };
            samples.iter().map(move |sample| {
                let (sin, cos) = (sample.q[base.yaw] / 2.0).sin_cos();
                MultiDofPoint {
                    transforms: [Transform {
                        translation: Xyz {
                            x: rounded(sample.q[base.x]),
                            y: rounded(sample.q[base.y]),
                            z: 0.0,
                        },
                        rotation: Xyzw {
                            x: 0.0,
                            y: 0.0,
                            z: rounded(sin),
                            w: rounded(cos),
                        },
                    }],
                    velocities: [twist(&sample.qd)],
                    accelerations: [twist(&sample.qdd)],
                    time_from_start: duration(sample.time),
                }
            })
        });
        Self {
            joint_trajectory: JointTrajectory {
                header: header(base_link),
                joint_names: variables.iter().map(name).collect(),
                points: points.collect(),
            },
            multi_dof_joint_trajectory: MultiDofJointTrajectory {
                header: header("world"),
                joint_names: base.iter().map(|_| base_link.clone()).collect(),
                points: base.into_iter().flatten().collect(),
            },
        }
    }

    /// Formats the message as JSON in one line, which `yaml.safe_load` and `ros2 topic pub` read as YAML, too.
    ///
    /// # Errors
    /// If a number is not finite.
    pub fn to_json(&self) -> serde_json::Result<String> {
        let mut text = Vec::new();
        let mut serializer = serde_json::Serializer::with_formatter(&mut text, WithPoint);
        self.serialize(&mut serializer)?;
        text.push(b'\n');
        Ok(String::from_utf8_lossy(&text).into_owned())
    }
}

/// Makes JSON numbers valid in YAML: YAML 1.1 reads 6e-6 as a string.
struct WithPoint;

impl serde_json::ser::Formatter for WithPoint {
    fn write_f64<W: io::Write + ?Sized>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        let digits = value.to_string();
        let point = if digits.contains('.') { "" } else { ".0" };
        write!(writer, "{digits}{point}")
    }
}

/// Formats the path of the tool centre point in the world over time, with stiffness and force for the controller.
///
/// Stiffness and force in contact are those of the knowledge base; free motion has no force.
pub fn tcp_path_csv(followed: &Followed, cell: &Workcell, interaction: &Interaction) -> String {
    let mut csv = String::from(PATH_HEADER);
    for sample in samples(followed) {
        let Some(motion) = followed.motion_at(sample.time) else {
            continue;
        };
        let Ok(kinematics) = cell.robot().forward_kinematics(&sample.q) else {
            continue;
        };
        let world_from_tool: Pose =
            cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        path_line(
            &mut csv,
            sample.time,
            motion.phase,
            &world_from_tool,
            interaction,
        );
    }
    csv
}

/// Formats the path of a plan without a robot: the tool is upright and moves at constant speed except when it is lowered or
/// lifted. It rotates no faster than its corners move at that speed. Times are nominal, not those of a robot.
pub fn planned_path_csv(task: &Task, plan: &Plan, config: &FollowConfig) -> String {
    let mut csv = String::from(PATH_HEADER);
    let mut time = 0.0;
    for (phase, from, to) in legs(plan) {
        let speed = match phase {
            Phase::Lower | Phase::Lift => config.approach_speed,
            _ => config.contact_speed,
        };
        let turn = to.surface_from_tool.heading - from.surface_from_tool.heading;
        let way = from.distance(&to).max(turn.abs() * plan.collision_radius);
        let count = (way / config.step).ceil().max(1.0) as usize;
        for i in 0..=count {
            let share = i as f64 / count as f64;
            let at = Workcell::world_from_tool(task, &from.interpolate(&to, share));
            let now = time + share * way / speed;
            path_line(&mut csv, now, phase, &at, &task.interaction);
        }
        time += way / speed;
    }
    csv
}

/// Returns the straight segments of the tool's path in a plan, from its start.
fn legs(plan: &Plan) -> Vec<(Phase, ToolPose, ToolPose)> {
    let on = |pose: PlanarPose| ToolPose {
        surface_from_tool: pose,
        height: 0.0,
        tilt: 0.0,
    };
    let mut legs = Vec::new();
    let mut last: Option<ToolPose> = None;
    for (number, stroke) in plan.strokes.iter().enumerate() {
        let (Some(&first), Some(&end)) = (stroke.poses.first(), stroke.poses.last()) else {
            continue;
        };
        let (first, end) = (on(first), on(end));
        let above = first.with_height(plan.lift_height);
        let mut from = last.unwrap_or_else(|| {
            let start = PlanarPose::new(plan.tool_start, first.surface_from_tool.heading);
            on(start).with_height(plan.lift_height)
        });
        // Out of contact, the tool rotates by the shorter angle.
        let (to, heading) = (
            above.surface_from_tool.heading,
            &mut from.surface_from_tool.heading,
        );
        *heading = to - wrap_angle(to - *heading);
        legs.push((Phase::Lifted, from, above));
        legs.push((Phase::Lower, above, first));
        let wiped = stroke
            .poses
            .windows(2)
            .map(|pair| (Phase::Wipe(number), on(pair[0]), on(pair[1])));
        legs.extend(wiped);
        let up = end.with_height(plan.lift_height);
        legs.push((Phase::Lift, end, up));
        last = Some(up);
    }
    legs
}

const PATH_HEADER: &str =
    "time_s,phase,stroke,x_m,y_m,z_m,qx,qy,qz,qw,stiffness_n_per_m,press_force_n\n";

/// A point of the tool's path.
fn path_line(
    csv: &mut String,
    time: f64,
    phase: Phase,
    world_from_tool: &Pose,
    interaction: &Interaction,
) {
    let at = world_from_tool.translation.vector;
    let turned = world_from_tool.rotation.coords;
    let force = if phase.is_contact() {
        interaction.contact_force()
    } else {
        0.0
    };
    let stroke = phase.stroke().map(|stroke| stroke.to_string());
    let _ = writeln!(
        csv,
        "{time:.3},{},{},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6},{},{force}",
        phase.as_str(),
        stroke.unwrap_or_default(),
        at.x,
        at.y,
        at.z,
        turned.x,
        turned.y,
        turned.z,
        turned.w,
        interaction.stiffness_n_per_m,
    );
}

/// Returns the states at 0, p, 2p, …, and at the end.
fn samples(followed: &Followed) -> Vec<TrajectorySample> {
    let count = (followed.duration() / PERIOD).ceil() as usize;
    (0..=count)
        .filter_map(|i| followed.sample((i as f64 * PERIOD).min(followed.duration())))
        .collect()
}

fn rounded(value: f64) -> f64 {
    // Avoid −0.0.
    (value * PER_UNIT).round() / PER_UNIT + 0.0
}

fn duration(time: f64) -> Duration {
    let sec = time.floor();
    let nanosec = ((time - sec) * NANOSECONDS).round();
    if nanosec >= NANOSECONDS {
        return Duration {
            sec: sec as i32 + 1,
            nanosec: 0,
        };
    }
    Duration {
        sec: sec as i32,
        nanosec: nanosec as u32,
    }
}
