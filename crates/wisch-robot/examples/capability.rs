//! Makes capability maps and measures how well they agree with inverse kinematics.
//!
//! `capability NAME [key=value ...]`, where NAME is
//!
//! | name | chain |
//! |---|---|
//! | `arm` | humanoid, `right_arm_base` to `right_tcp`: 7 joints |
//! | `whole` | humanoid, `platform` to `right_tcp`: 10 joints, torso included |
//! | `arm6`, `arm7` | the arms, root to `tcp` |
//!
//! and the keys are the fields of `MapConfig`, `poses` (how many poses are compared), `attempts`
//! (descents before inverse kinematics gives a pose up) and `out` (a file for the map).
//!
//! Poses are held back: places uniform in the ball that the chain could reach at most, directions
//! uniform on the sphere. A pose counts as reachable if one descent from random positions ends within
//! all limits and free of self-collision.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::Mutex;
use std::time::Instant;
use wisch_robot::geometry::{Point3, Pose, Vector3};
use wisch_robot::{
    CapabilityMap, CollisionModel, IkConfig, IkOutcome, IkSolver, MapConfig, MapRequest, MapStage,
    RobotHash, RobotModel, RotationGoal,
};

type Failure = Box<dyn std::error::Error>;

/// Seed of the poses that are compared, other than those of the maps.
const HELD_BACK: u64 = 2019;

struct Case {
    name: &'static str,
    urdf: &'static str,
    base: &'static str,
    tip: &'static str,
    /// Of the ball that poses are taken from, in the base [m].
    center: Point3,
    /// Of the same [m]: as far as the tip can be from the centre.
    radius: f64,
}

/// Shoulder to TCP: 0.4 + 0.39 + 0.118; the hip is 0.69 above the platform, and the shoulder at most
/// 0.3 + 0.3 + 0.33 from it. The arms: from their second joints.
const CASES: [Case; 4] = [
    Case {
        name: "arm",
        urdf: include_str!("../../../robots/humanoid.urdf"),
        base: "right_arm_base",
        tip: "right_tcp",
        center: Point3::new(0.0, 0.0, 0.0),
        radius: 0.91,
    },
    Case {
        name: "whole",
        urdf: include_str!("../../../robots/humanoid.urdf"),
        base: "platform",
        tip: "right_tcp",
        center: Point3::new(0.0, 0.0, 0.69),
        radius: 1.85,
    },
    Case {
        name: "arm6",
        urdf: include_str!("../../../robots/arm6.urdf"),
        base: "",
        tip: "tcp",
        center: Point3::new(0.0, 0.0, 0.089),
        radius: 1.1,
    },
    Case {
        name: "arm7",
        urdf: include_str!("../../../robots/arm7.urdf"),
        base: "",
        tip: "tcp",
        center: Point3::new(0.0, 0.0, 0.333),
        radius: 0.9,
    },
];

fn main() -> Result<(), Failure> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_default();
    let case = CASES.iter().find(|case| case.name == name);
    let case = case.ok_or("usage: capability arm|whole|arm6|arm7 [key=value ...]")?;
    let mut config = MapConfig::default();
    let (mut poses, mut attempts, mut out) = (2000, 200, None);
    for argument in arguments {
        let (key, value) = argument.split_once('=').ok_or("expected key=value")?;
        match key {
            "voxel" => config.voxel = value.parse()?,
            "frequency" => config.frequency = value.parse()?,
            "samples" => config.samples = value.parse()?,
            "seed" => config.seed = value.parse()?,
            "starts" => config.starts = value.parse()?,
            "refinements" => config.refinements = value.parse()?,
            "poses" => poses = value.parse()?,
            "attempts" => attempts = value.parse()?,
            "out" => out = Some(value.to_owned()),
            _ => return Err(format!("no key {key:?}").into()),
        }
    }
    let no_meshes = &mut |_: &str| Err("no meshes".to_owned());
    let robot = RobotModel::from_urdf(case.name, case.urdf, no_meshes)?;
    let map = make(case, &robot, &config)?;
    let bytes = map.to_bytes();
    let begin = Instant::now();
    let back = CapabilityMap::from_bytes(case.name, &bytes, RobotHash::from_robot(&robot))?;
    let seconds = begin.elapsed().as_secs_f64();
    println!(
        "{:?} cells, {} bytes, read in {seconds:.2} s",
        map.shape(),
        bytes.len()
    );
    assert!(back == map, "the map does not come back from its bytes");
    if let Some(out) = out {
        std::fs::write(out, &bytes)?;
    }
    compare(case, &robot, &map, poses, attempts)
}

/// The base of a case; an empty name is the root.
fn tool<'a>(
    case: &Case,
    robot: &'a RobotModel,
    posture: &'a [f64],
) -> Result<MapRequest<'a>, Failure> {
    let is_root = case.base.is_empty();
    Ok(MapRequest {
        robot,
        base: if is_root {
            robot.root()
        } else {
            robot.link(case.base)?
        },
        tip: robot.link(case.tip)?,
        tip_from_tool: Pose::identity(),
        posture,
    })
}

/// Self-collision of what the chain of a tool moves.
fn own_collisions(tool: &MapRequest<'_>) -> Result<CollisionModel, Failure> {
    let chain = tool.robot.chain(tool.base, tool.tip)?;
    Ok(CollisionModel::new(tool.robot, None)?.with_variables(chain.variables()))
}

fn make(case: &Case, robot: &RobotModel, config: &MapConfig) -> Result<CapabilityMap, Failure> {
    let posture = vec![0.0; robot.dof()];
    let tool = tool(case, robot, &posture)?;
    let collisions = own_collisions(&tool)?;
    let is_free = |q: &[f64]| matches!(collisions.collision(q, 0.0), Ok(None));
    let begin = Instant::now();
    let stages = Mutex::new(Vec::new());
    let progress = |stage: MapStage, done: u64, _| {
        if let Ok(mut stages) = stages.lock() {
            let now = begin.elapsed().as_secs_f64();
            stages.retain(|&(known, _, _)| known != stage);
            stages.push((stage, done, now));
        }
    };
    let map = CapabilityMap::build(&tool, is_free, config, progress)?;
    println!("{}: {config:?}", case.name);
    let mut before = 0.0;
    for (stage, done, end) in stages.into_inner()? {
        let rate = done as f64 / (end - before) / 1e3;
        println!(
            "{stage:?}: {done} in {:.1} s, {rate:.0} thousand per second",
            end - before
        );
        before = end;
    }
    Ok(map)
}

fn compare(
    case: &Case,
    robot: &RobotModel,
    map: &CapabilityMap,
    poses: usize,
    attempts: u64,
) -> Result<(), Failure> {
    let posture = vec![0.0; robot.dof()];
    let tool = tool(case, robot, &posture)?;
    let collisions = own_collisions(&tool)?;
    let solver = IkSolver::new(robot, tool.base, tool.tip, tool.tip_from_tool)?;
    let (goal, config) = (RotationGoal::AboutToolZFree, IkConfig::default());
    let variables = solver.chain().variables();
    let is_solved = |base_from_tool: &Pose| {
        let mut random = ChaCha8Rng::seed_from_u64(HELD_BACK);
        let mut all = posture.clone();
        (0..attempts).any(|_| {
            let start: Vec<f64> = variables
                .iter()
                .map(|&i| position(robot, i, &mut random))
                .collect();
            let outcome = solver.solve_from(base_from_tool, goal, &start, &config);
            let Ok(IkOutcome::Solved(q)) = outcome else {
                return false;
            };
            for (&variable, &q) in variables.iter().zip(q.iter()) {
                all[variable] = q;
            }
            matches!(collisions.collision(&all, 0.0), Ok(None))
        })
    };
    let mut random = ChaCha8Rng::seed_from_u64(HELD_BACK);
    let poses: Vec<Pose> = (0..poses).map(|_| pose(case, &mut random)).collect();
    let begin = Instant::now();
    let called: Vec<f64> = poses.iter().map(|pose| map.reachability(pose)).collect();
    let nanoseconds = begin.elapsed().as_secs_f64() / poses.len() as f64 * 1e9;
    println!("{nanoseconds:.0} ns per query");
    let solved: Vec<bool> = poses.par_iter().map(is_solved).collect();

    println!("| above | reachable | agree | called but not | of called | missed |");
    println!("|---|---|---|---|---|---|");
    for above in [0.4, 0.5, 0.6, 0.7] {
        let share = |is: &dyn Fn(bool, bool) -> bool| {
            let pairs = solved.iter().zip(&called);
            let count = pairs
                .filter(|&(&solved, &called)| is(solved, called > above))
                .count();
            100.0 * count as f64 / poses.len() as f64
        };
        let falsely = share(&|solved, called| called && !solved);
        println!(
            "| {above} | {:.1} % | {:.2} % | {falsely:.2} % | {:.2} % | {:.2} % |",
            share(&|solved, _| solved),
            share(&|solved, called| solved == called),
            100.0 * falsely / share(&|_, called| called),
            share(&|solved, called| solved && !called),
        );
    }
    Ok(())
}

/// A place in the ball of a case, and a direction on the sphere.
fn pose(case: &Case, random: &mut ChaCha8Rng) -> Pose {
    let mut in_ball = || loop {
        let v = Vector3::from_fn(|_, _| 2.0 * random.random::<f64>() - 1.0);
        if v.norm() <= 1.0 {
            return v;
        }
    };
    let point = case.center + case.radius * in_ball();
    let rotation = nalgebra::UnitQuaternion::rotation_between(&Vector3::z(), &in_ball());
    Pose::from_parts(point.coords.into(), rotation.unwrap_or_default())
}

/// A position of a variable within its limits; once round if there are none.
fn position(robot: &RobotModel, variable: usize, random: &mut ChaCha8Rng) -> f64 {
    let limits = robot.variable(variable).limits.position;
    let (lower, upper) = limits.map_or((-PI, PI), |range| (range.lower, range.upper));
    lower + (upper - lower) * random.random::<f64>()
}
