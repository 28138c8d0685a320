//! A floor round an arm, wiped with a round pad: how far the joints move, with the tool turned as planned and with its yaw left
//! to the robot.
//!
//! ```text
//! cargo run --release --package wisch --example floor -- [bandwidth for kde, m] [CSV file with a target's x and y in each row, m]
//! ```
//!
//! Without a file, targets are 50 mm apart all round the shipped arm of seven joints, from 0.3 to 0.72 m off its foot.

use std::f64::consts::TAU;
use std::time::Instant;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, follow};
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Region, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, HeadingRule, Plan, PlanConfig, plan, predict};
use wisch::represent::{Action, ParticleDistribution, SceneObject, ScenePart, Surface, Task, Tool};
use wisch_testkit::{AnyError, arm7, interaction, sponge};

/// Distance between targets [m].
const PITCH: f64 = 0.05;
/// Radius of the pad [m]: it covers a square of the pitch.
const PAD: f64 = 0.036;
/// Where the targets are from the foot of the arm [m].
const REACH: [f64; 2] = [0.3, 0.72];

fn main() -> Result<(), AnyError> {
    let mut arguments = std::env::args().skip(1);
    let bandwidth = arguments.next().map(|text| text.parse()).transpose()?;
    let targets = arguments
        .next()
        .map_or_else(|| Ok(ring()), |path| read(&path))?;
    let task = floor(&targets)?;
    let robot = arm7();
    let cell = Workcell::new(
        robot.model.clone(),
        Some(&robot.srdf),
        &task,
        &WorkcellConfig::default(),
    )?;
    println!("{} targets", targets.len());
    println!(
        "{:9} {:8} {:>8} {:>8} {:>6} {:>9} {:>9} {:>7} {:>7}",
        "plan", "yaw", "contact", "in all", "lifts", "abandoned", "covered", "exec s", "comp s"
    );
    for strategy in CoverageStrategy::ALL {
        for (yaw, heading, free_yaw) in [
            ("blended", HeadingRule::Blended, false),
            ("best", HeadingRule::Best, false),
            ("free", HeadingRule::Best, true),
        ] {
            let begin = Instant::now();
            let config = PlanConfig {
                strategy: strategy.into(),
                heading,
                bandwidth,
                ..PlanConfig::default()
            };
            let plan = plan(&task, &config)?;
            let config = FollowConfig {
                free_yaw,
                ..FollowConfig::default()
            };
            let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ())?;
            let seconds = begin.elapsed().as_secs_f64();
            let wiped = Plan {
                strokes: followed.strokes.clone(),
                ..plan.clone()
            };
            let [contact, all] = followed.joint_movement(cell.arm_variables());
            println!(
                "{:9} {yaw:8} {contact:8.1} {all:8.1} {:6} {:9} {:8.1}% {:7.1} {seconds:7.2}",
                strategy.to_string(),
                followed.strokes.len(),
                followed.abandoned.len(),
                100.0 * predict(&task, &wiped, |_| ()).performance.ratio(),
                followed.duration(),
            );
        }
    }
    Ok(())
}

fn read(path: &str) -> Result<Vec<Point2>, AnyError> {
    let text = std::fs::read_to_string(path)?;
    let row = |line: &str| -> Option<Point2> {
        let mut numbers = line.split(',').map(|field| field.trim().parse().ok());
        Some(Point2::new(numbers.next()??, numbers.next()??))
    };
    Ok(text.lines().filter_map(row).collect())
}

fn ring() -> Vec<Point2> {
    let most = (REACH[1] / PITCH) as i32;
    let all = (-most..=most).flat_map(|i| (-most..=most).map(move |j| [i, j]));
    all.map(|[i, j]| Point2::new(PITCH * f64::from(i), PITCH * f64::from(j)))
        .filter(|place| (REACH[0]..=REACH[1]).contains(&place.coords.norm()))
        .collect()
}

fn floor(targets: &[Point2]) -> Result<Task, AnyError> {
    let reach = targets
        .iter()
        .map(|place| place.coords.amax())
        .fold(0.0, f64::max)
        + 2.0 * PAD;
    let corner = |i: usize| {
        let angle = TAU * i as f64 / 32.0;
        Point2::new(PAD * libm::cos(angle), PAD * libm::sin(angle))
    };
    let mesh = Mesh::cylinder(PAD, 0.05, 32)?;
    Ok(Task {
        name: "floor".into(),
        action: Action::Absorb,
        surface: Surface {
            name: "floor".into(),
            world_from_surface: Pose::identity(),
            skim_edges: Vec::new(),
            outline: Polygon::rectangle(Vector2::new(2.0 * reach, 2.0 * reach)),
        },
        scene: vec![SceneObject {
            name: "floor".into(),
            part: ScenePart::Carrier,
            mesh: Mesh::cuboid(Vector3::new(2.0 * reach, 2.0 * reach, 0.02))?,
            world_from_object: Pose::translation(0.0, 0.0, -0.01),
        }],
        tool: Tool {
            name: "pad".into(),
            mesh: mesh.transformed(&Pose::translation(0.0, 0.0, 0.025)),
            footprint: Region::new(vec![Polygon::new(
                (0..32).map(corner).collect(),
                Vec::new(),
            )]),
            area_of_effect: Vector2::new(2.0 * PAD, 2.0 * PAD),
            ..sponge()
        },
        medium: "dust".into(),
        interaction: interaction(),
        particles: ParticleDistribution::new(targets)?,
        collect_goal: None,
        treatment: None,
        tool_start: targets.first().copied().unwrap_or_else(Point2::origin),
        seed: 1,
    })
}
