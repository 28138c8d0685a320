//! Solves for poses that the shipped robots can reach: `ik [COUNT] [FOLDER]`, from the repository's root.
//!
//! Each pose is that of random joint positions within the limits, coupled ones included. Prints per
//! chain how many are solved, from the middle of the limits and by random restarts, and the µs per pose; and
//! how many of those can be followed by one descent to a pose 5 mm beside, which may be out of reach. With
//! FOLDER it writes the poses, one per line: x, y, z [m] and the quaternion x, y, z, w of the tip in the base.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;
use std::path::Path;
use std::time::Instant;
use wisch_robot::geometry::{Pose, Vector3};
use wisch_robot::{IkConfig, IkOutcome, IkSolver, JointKind, RobotModel, RotationGoal};

type Failure = Box<dyn std::error::Error>;

/// Name, file, base and tip of a chain.
const CHAINS: [[&str; 4]; 4] = [
    ["humanoid-10", "humanoid", "platform", "right_tcp"],
    ["humanoid-13", "humanoid", "world", "right_tcp"],
    ["arm7", "arm7", "link_0", "tcp"],
    ["arm6", "arm6", "link_0", "tcp"],
];

/// Farthest that the base stands from the origin along x and y [m].
const BASE_REACH: f64 = 1.0;

/// How far beside a solved pose the followed one is [m].
const STEP: f64 = 5e-3;

/// Random positions within the limits of the chain, the other joints at rest.
fn positions(robot: &RobotModel, solver: &IkSolver, random: &mut ChaCha8Rng) -> Vec<f64> {
    let mut all = vec![0.0; robot.dof()];
    loop {
        for &i in solver.chain().variables() {
            let joint = robot.variable(i);
            let range = joint.limits.position;
            let (lower, upper) = match joint.kind {
                JointKind::Prismatic => (-BASE_REACH, BASE_REACH),
                _ => range.map_or((-PI, PI), |range| (range.lower, range.upper)),
            };
            all[i] = random.random_range(lower..upper);
        }
        if robot
            .limit_faults(&all)
            .is_ok_and(|faults| faults.is_empty())
        {
            return solver.chain().variables().iter().map(|&i| all[i]).collect();
        }
    }
}

fn quantile(sorted: &[f64], part: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted
        .get((part * last as f64).round() as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

fn run(
    chain: [&str; 4],
    goal: RotationGoal,
    count: usize,
    folder: Option<&str>,
) -> Result<(), Failure> {
    let [name, file, base, tip] = chain;
    let file = format!("robots/{file}.urdf");
    let text = std::fs::read_to_string(&file)?;
    let robot = RobotModel::from_urdf(&file, &text, &mut |_| Err("no meshes".into()))?;
    let (base, tip) = (robot.link(base)?, robot.link(tip)?);
    let solver = IkSolver::new(&robot, base, tip, Pose::identity())?;
    let config = IkConfig::default();

    let mut random = ChaCha8Rng::seed_from_u64(114);
    let mut poses = Vec::new();
    for _ in 0..count {
        let q = positions(&robot, &solver, &mut random);
        poses.push(solver.chain().forward_kinematics(&q)?.base_from_tip());
    }
    if let (Some(folder), RotationGoal::Full) = (folder, goal) {
        let mut writer = csv::WriterBuilder::new()
            .has_headers(false)
            .from_path(Path::new(folder).join(format!("{name}.csv")))?;
        for pose in &poses {
            writer.serialize((
                pose.translation.vector.as_slice(),
                pose.rotation.coords.as_slice(),
            ))?;
        }
        writer.flush()?;
    }

    let mut times = Vec::new();
    let mut follow_times = Vec::new();
    let (mut solved, mut followed) = (0, 0);
    for (seed, base_from_tool) in poses.iter().enumerate() {
        let begin = Instant::now();
        let outcome = solver.solve(base_from_tool, goal, &[], seed as u64, &config)?;
        times.push(1e6 * begin.elapsed().as_secs_f64());
        let IkOutcome::Solved(q) = outcome else {
            continue;
        };
        solved += 1;
        let direction = [0; 3].map(|_| random.random_range(-1.0..1.0));
        let mut beside = *base_from_tool;
        beside.translation.vector += STEP * Vector3::from(direction).normalize();
        let begin = Instant::now();
        let outcome = solver.solve_from(&beside, goal, &q, &config)?;
        follow_times.push(1e6 * begin.elapsed().as_secs_f64());
        followed += usize::from(matches!(outcome, IkOutcome::Solved(_)));
    }
    times.sort_by(f64::total_cmp);
    follow_times.sort_by(f64::total_cmp);
    let mean = times.iter().sum::<f64>() / times.len().max(1) as f64;
    println!(
        "{name},{goal:?},{:.3},{:.1},{mean:.1},{:.1},{:.3},{:.2}",
        100.0 * f64::from(solved) / count as f64,
        quantile(&times, 0.5),
        quantile(&times, 0.99),
        100.0 * followed as f64 / f64::from(solved),
        quantile(&follow_times, 0.5),
    );
    Ok(())
}

fn main() -> Result<(), Failure> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().map_or(Ok(10_000), |count| count.parse())?;
    let folder = arguments.next();
    println!(
        "chain,goal,solved_percent,median_us,mean_us,p99_us,followed_percent,follow_median_us"
    );
    for goal in [RotationGoal::Full, RotationGoal::AboutToolZFree] {
        for chain in CHAINS {
            run(chain, goal, count, folder.as_deref())?;
        }
    }
    Ok(())
}
