//! A small board in front of the arm with seven joints.

use crate::parts::{interaction, sponge, surface};
use crate::problems::lost_nodes;
use crate::shipped::{ShippedRobot, robot};
use wisch::follow::{FollowConfig, Followed, Workcell, WorkcellConfig, audit};
use wisch::geometry::{Mesh, Point2, Pose, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, YawRule, plan};
use wisch::represent::{Action, ParticleDistribution, SceneObject, ScenePart, Surface, Task};

/// Extent of the board [m].
const BOARD: [f64; 2] = [0.24, 0.18];

/// Returns the arm with seven joints.
pub fn arm7() -> ShippedRobot {
    robot("arm7")
}

/// Returns a box obstacle of a size \[m\] around a point in the world.
pub fn block(name: &str, size: [f64; 3], at: [f64; 3]) -> SceneObject {
    SceneObject {
        name: name.into(),
        part: ScenePart::Obstacle,
        mesh: Mesh::cuboid(Vector3::from(size)).unwrap(),
        world_from_object: Pose::translation(at[0], at[1], at[2]),
    }
}

/// Returns the task with the centre of the board's upper face at a point in the world, and 24 crumbs on a lattice.
pub fn board(action: Action, [x, y, z]: [f64; 3]) -> Task {
    let size = Vector2::from(BOARD);
    let crumbs: Vec<Point2> = (0..24)
        .map(|i| ((i % 6) as f64, (i / 6) as f64))
        .map(|(i, j)| Point2::new(0.04 * (i - 2.5), 0.04 * (j - 1.5)))
        .collect();
    Task {
        name: "board".into(),
        action,
        surface: Surface {
            world_from_surface: Pose::translation(x, y, z),
            ..surface(BOARD)
        },
        scene: vec![SceneObject {
            part: ScenePart::Carrier,
            ..block("board", [size.x, size.y, 0.02], [x, y, z - 0.01])
        }],
        tool: sponge(),
        medium: "breadcrumbs".into(),
        interaction: interaction(),
        particles: ParticleDistribution::new(&crumbs).unwrap(),
        collect_goal: None,
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::new(-0.2, 0.0),
        seed: 1,
    }
}

/// Returns a plan that covers the task on a grid.
pub fn planned(task: &Task) -> Plan {
    let config = PlanConfig {
        strategy: CoverageStrategy::Grid.into(),
        seed: 1,
        yaw: YawRule::Blended,
        ..PlanConfig::default()
    };
    plan(task, &config).unwrap()
}

/// Returns a plan with only its first stroke.
pub fn first_stroke(plan: Plan) -> Plan {
    Plan {
        strokes: plan.strokes.into_iter().take(1).collect(),
        ..plan
    }
}

/// Returns the workcell of the arm with seven joints and the board.
pub fn cell(task: &Task) -> Workcell {
    let robot = arm7();
    let config = WorkcellConfig::default();
    Workcell::new(robot.model, Some(&robot.srdf), task, &config).unwrap()
}

/// Returns all faults of a followed plan: findings of the audit, lost nodes, and strokes that differ from the executed
/// line.
pub fn faults(task: &Task, plan: &Plan, cell: &Workcell, followed: &Followed) -> Vec<String> {
    let audit = audit(followed, cell, task, &FollowConfig::default()).unwrap();
    let mut faults: Vec<String> = audit.faults.iter().map(ToString::to_string).collect();
    faults.extend(lost_nodes(plan, followed));
    for (number, stroke) in followed.strokes.iter().enumerate() {
        let wiped: Vec<_> = (followed.motions.iter())
            .filter(|motion| motion.phase.stroke() == Some(number))
            .flat_map(|motion| &motion.tool_line)
            .map(|pose| pose.surface_from_tool)
            .collect();
        // A stroke of one node is a touch, without motion in contact.
        if wiped != stroke.poses && stroke.poses.len() > 1 {
            faults.push(format!("stroke {number} is not the executed line"));
        }
    }
    faults
}
