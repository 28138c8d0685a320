//! A motion for the tests: the humanoid drives to the chopping board and wipes it.

use super::input::*;
use std::path::Path;
use wisch::follow::TrajectorySample;
use wisch::follow::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, TcpWaypoint, plan};
use wisch::represent::{Action, Task};
use wisch::robot::{LinkId, RobotModel};
use wisch_io::{LoadOptions, load_task, read, read_text};

/// Ready pose of the paper's robot: torso, right arm [deg].
const TORSO: [f64; 3] = [0.0, -48.527, 97.386];
const ARM: [f64; 7] = [-60.532, -107.672, -26.066, 106.409, -5.171, -41.724, 9.236];
/// Base poses before driving and for wiping: x, y [m], yaw [rad].
const FROM: [f64; 3] = [0.75, -1.75, 2.2];
const AT: [f64; 3] = [-0.05, -0.74, std::f64::consts::FRAC_PI_2];
/// Largest height at which the tool counts as wiping [m].
const TOUCH: f64 = 0.004;

pub(crate) struct Demo {
    pub(crate) robot: RobotModel,
    pub(crate) task: Task,
    pub(crate) samples: Vec<TrajectorySample>,
    pub(crate) phases: Vec<ShownPhase>,
    pub(crate) placements: Vec<BasePose>,
    pub(crate) ratings: Vec<CandidateBase>,
}

impl Demo {
    pub(crate) fn new() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let urdf = read_text(&root.join("robots/humanoid.urdf")).expect("the shipped robot");
        let robot = RobotModel::from_urdf("humanoid", &urdf, &mut |path| {
            read(Path::new(path)).map_err(|error| error.to_string())
        })
        .expect("the shipped robot can be used");
        let task = load_task_file(&root.join("scenarios/chopping-board.toml"));
        let config = PlanConfig {
            strategy: CoverageStrategy::Kde.into(),
            seed: 1,
            lift_height: 0.06,
            ..PlanConfig::default()
        };
        let plan = plan(&task, &config).expect("a plan");
        let samples = sample_strokes(&robot, &task, &plan);
        let mut demo = Self {
            robot,
            task,
            samples,
            phases: Vec::new(),
            placements: [FROM, AT].map(|[x, y, yaw]| BasePose { x, y, yaw }).into(),
            ratings: list_ratings(),
        };
        demo.phases = list_phases(&demo.input());
        demo
    }

    pub(crate) fn input(&self) -> MotionInput<'_> {
        MotionInput {
            robot: &self.robot,
            world_from_root: Pose::identity(),
            task: &self.task,
            tool_link: self.robot.link("right_tcp").expect("a hand"),
            link_from_tool: Pose::identity(),
            samples: &self.samples,
            phases: &self.phases,
            placements: &self.placements,
            ratings: &self.ratings,
        }
    }
}

fn load_task_file(path: &Path) -> Task {
    let options = LoadOptions {
        action: Some(Action::Collect),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let loaded = load_task(path, &options);
    loaded.expect("the shipped scenario").task
}

/// Returns timed postures along the plan's path; each follows from the one before by damped least squares.
fn sample_strokes(robot: &RobotModel, task: &Task, plan: &Plan) -> Vec<TrajectorySample> {
    let index = |name: &str| {
        let joint = robot.joint(name).expect("a joint");
        let mut variables = robot.variables().iter();
        variables.position(|id| *id == joint).expect("a variable")
    };
    let mut q = vec![0.0; robot.dof()];
    let mut set = |prefix: &str, values: &[f64]| {
        for (i, value) in values.iter().enumerate() {
            q[index(&format!("{prefix}_{}", i + 1))] = value.to_radians();
        }
    };
    set("torso", &TORSO);
    set("right_arm", &ARM);
    set("left_arm", &ARM);
    set("head", &[0.0, 20.0]);
    let mut path = Vec::new();
    for base in [FROM, AT] {
        for (name, value) in ["base_x", "base_y", "base_yaw"].into_iter().zip(base) {
            q[index(name)] = value;
        }
        path.push(q.clone());
    }
    let tcp = robot.link("right_tcp").expect("a hand");
    let arm = (1..=7).map(|i| format!("right_arm_{i}"));
    let torso = (1..=3).map(|i| format!("torso_{i}"));
    let moving: Vec<usize> = torso.chain(arm).map(|name| index(&name)).collect();
    let home = q.clone();
    for target in list_waypoints(task, plan) {
        solve_reach(robot, tcp, &moving, &mut q, &target);
        path.push(q.clone());
    }
    path.push(home);
    let limits = robot.variables().iter().map(|id| {
        let joint = &robot.joints()[id.index()];
        let range = joint.limits.position;
        JointLimit {
            name: joint.name.clone(),
            lower: range.map_or(f64::NEG_INFINITY, |range| range.lower),
            upper: range.map_or(f64::INFINITY, |range| range.upper),
            velocity: joint.limits.velocity.unwrap_or(1.0),
            acceleration: joint.limits.acceleration.unwrap_or(10.0),
        }
    });
    let limits = JointLimits::new(limits.collect()).expect("limits");
    let segments = path.len() - 1;
    // The tool wipes at about 0.1 m/s.
    let times = (0..segments).map(|i| {
        if i == 0 || i + 1 == segments {
            0.0
        } else {
            0.1
        }
    });
    let path = JointPath::new(&path)
        .and_then(|path| path.with_segment_times(times.collect()))
        .expect("a path");
    let trajectory = time_path(&path, &limits, &TimingConfig::default()).expect("a trajectory");
    trajectory.samples(5e-3).collect()
}

/// Returns tool positions in the world, 1 cm apart [m].
fn list_waypoints(task: &Task, plan: &Plan) -> Vec<Point3> {
    let place = |w: &TcpWaypoint| {
        let position = w.surface_from_tool.position;
        task.surface.world_from_surface * Point3::new(position.x, position.y, w.height)
    };
    let corners: Vec<Point3> = plan.tcp_path().iter().map(place).collect();
    let mut points = Vec::new();
    for leg in corners.windows(2) {
        let steps = ((leg[1] - leg[0]).norm() / 0.01).ceil().max(1.0) as usize;
        let on_leg = (0..steps).map(|i| leg[0] + (leg[1] - leg[0]) * i as f64 / steps as f64);
        points.extend(on_leg);
    }
    points.extend(corners.last());
    points
}

/// Moves the tool centre to a point with its axis upright, within the joint limits.
fn solve_reach(robot: &RobotModel, tcp: LinkId, moving: &[usize], q: &mut [f64], target: &Point3) {
    for _ in 0..200 {
        let kinematics = robot.forward_kinematics(q).expect("n positions");
        let pose = kinematics.world_from_link(tcp);
        let offset = target.coords - pose.translation.vector;
        let tilt = (pose.rotation * Vector3::z()).cross(&Vector3::z());
        if offset.norm() < 1e-4 && tilt.norm() < 1e-3 {
            return;
        }
        let all = kinematics.jacobian(tcp, Point3::origin());
        // Three linear rows and two rows of the tilt; rotation about the vertical is free.
        let jacobian = all.select_columns(moving).rows(0, 5).into_owned();
        let mut error = jacobian.column(0).into_owned();
        error.copy_from_slice(&[offset.x, offset.y, offset.z, tilt.x, tilt.y]);
        let mut square = &jacobian * jacobian.transpose();
        (0..5).for_each(|i| square[(i, i)] += 1e-4);
        let Some(weights) = square.lu().solve(&error) else {
            return;
        };
        let step = jacobian.transpose() * weights;
        for (&variable, step) in moving.iter().zip(step.iter()) {
            let limits = robot.variable(variable).limits.position.expect("limits");
            q[variable] = (q[variable] + step.clamp(-0.2, 0.2)).clamp(limits.lower, limits.upper);
        }
    }
}

/// Derives the phases wiping, lifting and driving from the motion of tool and base.
fn list_phases(input: &MotionInput) -> Vec<ShownPhase> {
    let surface_from_world = input.task.surface.world_from_surface.inverse();
    let mut phases: Vec<ShownPhase> = Vec::new();
    let mut strokes = 0;
    for sample in input.samples {
        let kinematics = input
            .robot
            .forward_kinematics(&sample.q)
            .expect("n positions");
        let tool = kinematics.world_from_link(input.tool_link) * input.link_from_tool;
        let height = (surface_from_world * tool).translation.vector.z;
        let drives = sample.qd[..3].iter().any(|v| v.abs() > 1e-9);
        let (contact, name) = match () {
            () if drives => (ShownContact::Lifted, "drive to the board"),
            () if height < TOUCH => (ShownContact::Wiping, "stroke"),
            () => (ShownContact::Lifted, "lifted"),
        };
        match phases.last_mut() {
            Some(last) if last.name.starts_with(name) => last.end = sample.time,
            _ => {
                let stroke = (contact == ShownContact::Wiping).then_some(strokes);
                strokes += usize::from(stroke.is_some());
                phases.push(ShownPhase {
                    name: stroke.map_or(name.to_owned(), |i| format!("{name} {}", i + 1)),
                    start: sample.time,
                    end: sample.time,
                    contact,
                    stroke,
                });
            }
        }
    }
    phases
}

/// Returns a grid of rated positions; the best are about an arm's length from the board.
fn list_ratings() -> Vec<CandidateBase> {
    let step = 0.1;
    let column = move |x: i32| (-17..=4).map(move |y| (f64::from(x) * step, f64::from(y) * step));
    (-12..=12)
        .flat_map(column)
        .map(|(x, y)| CandidateBase {
            x,
            y,
            rating: (-((x.hypot(y) - 0.75) / 0.35).powi(2)).exp() * (0.7 - 0.3 * (y / 0.8).tanh()),
            blocked: x.abs() < 0.95 && y > -0.6,
        })
        .collect()
}
