//! Random problems of following: a robot, a surface in front of it, and obstacles.

use crate::parts::{interaction, sponge};
use crate::shipped::{AnyError, ShippedRobot};
use nalgebra::{Translation3, UnitQuaternion};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};
use wisch::follow::{FollowConfig, Followed, Workcell, WorkcellConfig, audit, follow};
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan};
use wisch::represent::{
    Action, Mount, ParticleDistribution, SceneObject, ScenePart, Surface, Task, Tool,
};

/// Thickness of the plate whose upper face is the surface [m].
const PLATE: f64 = 0.02;

/// A task with a robot and their configurations.
pub struct Problem {
    /// Index of the robot in [`crate::robots`].
    pub robot: usize,
    /// Surface, scene, tool and dirt.
    pub task: Task,
    /// Configuration of the planner.
    pub plan: PlanConfig,
    /// Placement of the robot.
    pub cell: WorkcellConfig,
}

/// Outcome of a planning problem: followed, or the reason why it was not.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum SolvedProblem {
    /// Every node is reached.
    Whole,
    /// Some nodes are abandoned.
    Partly,
    /// All nodes are abandoned.
    NotAtAll,
    /// The problem was rejected, before or during planning or following.
    Refused(String),
    /// The motion has faults.
    Faulty(Vec<String>),
}

/// A planning problem with the motion that was found for it.
pub struct FollowedProblem {
    /// The motion.
    pub motion: Followed,
    /// Its faults.
    pub faults: Vec<String>,
}

impl Problem {
    /// Returns the problem of a seed: every fifth for the humanoid, the others in equal parts for both arms.
    pub fn random(seed: u64) -> Result<Self, AnyError> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let random = &mut random;
        let robot = match seed % 5 {
            4 => 2,
            _ => random.random_range(0..2),
        };
        let size = Vector2::new(random.random_range(0.1..0.5), random.random_range(0.1..0.4));
        // The humanoid works at the height of a table and drives to it.
        let (distance, height, away) = match robot {
            2 => (0.0, 0.6..1.1, random.random_range(1.0..1.5)),
            _ => (random.random_range(0.3..0.8), 0.0..0.6, 0.0),
        };
        let bearing = random.random_range(-PI..PI);
        let place = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), bearing)
            * Vector3::new(distance, 0.0, random.random_range(height));
        let world_from_surface = Pose::from_parts(place.into(), orientation(random, bearing));
        let action = Action::WIPING[random.random_range(0..Action::WIPING.len())];
        let strategies = [CoverageStrategy::Grid, CoverageStrategy::Kde];
        let strategy = strategies[random.random_range(0..2)];
        let particles = particles(random, size);
        let scene = scene(random, size, &world_from_surface)?;
        let robot_at = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), bearing);
        Ok(Self {
            robot,
            task: Task {
                name: format!("problem {seed}"),
                action,
                surface: Surface {
                    name: "plate".into(),
                    outline: Polygon::rectangle(size),
                    world_from_surface,
                    skim_edges: vec![random.random_range(0..4)],
                    shape: Default::default(),
                },
                scene,
                // The problems are chosen for this mount.
                tool: Tool {
                    mount: Some(Mount::Hand { lean: 0.8 }),
                    ..sponge()
                },
                medium: "breadcrumbs".into(),
                interaction: interaction(),
                particles: ParticleDistribution::new(&particles)?,
                collect_goal: None,
                treatment: None,
                mobility: Default::default(),
                tool_start: Point2::new(-size.x, -size.y),
                seed,
            },
            plan: PlanConfig {
                strategy: strategy.into(),
                seed,
                ..PlanConfig::default()
            },
            cell: WorkcellConfig {
                world_from_robot: Some(Pose::from_parts(
                    Translation3::from(robot_at * Vector3::new(-away, 0.0, 0.0)),
                    if away > 0.0 {
                        robot_at
                    } else {
                        UnitQuaternion::identity()
                    },
                )),
                ..WorkcellConfig::default()
            },
        })
    }

    /// Plans the problem, follows the plan and audits the motion.
    pub fn outcome(&self, robots: &[ShippedRobot]) -> SolvedProblem {
        match self.followed(&robots[self.robot]) {
            Err(error) => SolvedProblem::Refused(kind(&error.to_string())),
            Ok(FollowedProblem { motion, faults }) => {
                match (faults.is_empty(), motion.abandoned.is_empty()) {
                    (false, _) => SolvedProblem::Faulty(faults),
                    (true, true) => SolvedProblem::Whole,
                    (true, false) if motion.strokes.is_empty() => SolvedProblem::NotAtAll,
                    (true, false) => SolvedProblem::Partly,
                }
            }
        }
    }

    /// Returns the motion and its faults.
    pub fn followed(&self, robot: &ShippedRobot) -> Result<FollowedProblem, AnyError> {
        self.follow_with(robot, &FollowConfig::default())
    }

    /// Returns the motion and its faults, with another configuration.
    pub fn follow_with(
        &self,
        robot: &ShippedRobot,
        config: &FollowConfig,
    ) -> Result<FollowedProblem, AnyError> {
        let plan = plan(&self.task, &self.plan)?;
        let cell = Workcell::new(
            robot.model.clone(),
            Some(&robot.srdf),
            &self.task,
            &self.cell,
        )?;
        let map = robot.map.as_ref();
        let motion = follow(&self.task, &plan, &cell, map, config, &mut |_| ())?;
        let audit = audit(&motion, &cell, &self.task, config)?;
        let mut faults: Vec<String> = audit.faults.iter().map(ToString::to_string).collect();
        faults.extend(lost_nodes(&plan, &motion));
        Ok(FollowedProblem { motion, faults })
    }
}

/// Describes nodes of a plan that are neither reached nor abandoned, and nodes of the motion that were not planned.
pub fn lost_nodes(plan: &Plan, followed: &Followed) -> Option<String> {
    let planned: BTreeSet<usize> = (plan.strokes.iter())
        .flat_map(|stroke| stroke.nodes.iter().copied())
        .collect();
    let mut told: BTreeSet<usize> = (followed.strokes.iter())
        .flat_map(|stroke| stroke.nodes.iter().copied())
        .collect();
    told.extend(followed.abandoned.iter().map(|node| node.node));
    let lost: Vec<&usize> = planned.symmetric_difference(&told).collect();
    (!lost.is_empty()).then(|| format!("nodes {lost:?} are lost"))
}

/// Returns an orientation: mostly upward and tilted by up to 60°, sometimes upright in front of the robot, or overhead.
fn orientation(random: &mut ChaCha8Rng, bearing: f64) -> UnitQuaternion<f64> {
    let about = |angle: f64| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
    let over = |angle: f64| UnitQuaternion::from_axis_angle(&Vector3::y_axis(), angle);
    let turn = random.random_range(0.0..TAU);
    let tilted = match random.random_range(0..20) {
        // The normal points towards the robot.
        0..3 => about(bearing) * over(-FRAC_PI_2),
        3..5 => over(PI),
        _ => about(random.random_range(0.0..TAU)) * over(random.random_range(0.0..FRAC_PI_3)),
    };
    tilted * about(turn)
}

fn particles(random: &mut ChaCha8Rng, size: Vector2) -> Vec<Point2> {
    let count = random.random_range(10..=60);
    let mut at = |length: f64| length * random.random_range(-0.5..0.5);
    (0..count)
        .map(|_| Point2::new(at(size.x), at(size.y)))
        .collect()
}

/// Returns the plate, and up to six boxes and cylinders on and around it.
fn scene(
    random: &mut ChaCha8Rng,
    size: Vector2,
    world_from_surface: &Pose,
) -> Result<Vec<SceneObject>, AnyError> {
    let mut scene = vec![SceneObject {
        name: "plate".into(),
        part: ScenePart::Carrier,
        mesh: Mesh::cuboid(Vector3::new(size.x, size.y, PLATE))?,
        world_from_object: world_from_surface * Translation3::new(0.0, 0.0, -PLATE / 2.0),
    }];
    for number in 0..random.random_range(0..=6) {
        let mut length = || random.random_range(0.02..0.12);
        let (a, b, height) = (length(), length(), 2.0 * length());
        let mesh = if random.random_bool(0.5) {
            Mesh::cuboid(Vector3::new(a, b, height))?
        } else {
            Mesh::cylinder(a / 2.0, height, 24)?
        };
        let mut at = |length: f64| (length / 2.0 + 0.2) * random.random_range(-1.0..1.0);
        let standing = Translation3::new(at(size.x), at(size.y), height / 2.0);
        scene.push(SceneObject {
            name: format!("thing {number}"),
            part: ScenePart::Obstacle,
            mesh,
            world_from_object: world_from_surface * standing,
        });
    }
    Ok(scene)
}

/// Returns an error without its numbers, so that similar errors can be counted.
fn kind(message: &str) -> String {
    let digits = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    message
        .split_whitespace()
        .filter(|word| !word.contains(digits))
        .collect::<Vec<_>>()
        .join(" ")
}
