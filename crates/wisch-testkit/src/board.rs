//! A small board in front of the arm of seven joints.

use crate::parts::{interaction, sponge, surface};
use crate::problems::lost_nodes;
use crate::shipped::{ShippedRobot, robot};
use wisch::follow::{FollowConfig, Followed, Workcell, WorkcellConfig, audit};
use wisch::geometry::{Mesh, Point2, Pose, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, HeadingRule, Plan, PlanConfig, plan};
use wisch::represent::{Action, ParticleDistribution, SceneObject, ScenePart, Surface, Task};

/// Extent of the board [m].
const BOARD: [f64; 2] = [0.24, 0.18];

/// The arm of seven joints.
pub fn arm7() -> ShippedRobot {
    robot("arm7")
}

/// A box of a size [m] about a place in the world, to be kept clear of.
pub fn block(name: &str, size: [f64; 3], at: [f64; 3]) -> SceneObject {
    SceneObject {
        name: name.into(),
        part: ScenePart::Obstacle,
        mesh: Mesh::cuboid(Vector3::from(size)).unwrap(),
        world_from_object: Pose::translation(at[0], at[1], at[2]),
    }
}

/// The board with the middle of its upper face at a place in the world, 24 crumbs on a lattice.
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
        tool_start: Point2::new(-0.2, 0.0),
        seed: 1,
    }
}

/// What covers it on a grid.
pub fn planned(task: &Task) -> Plan {
    let config = PlanConfig {
        strategy: CoverageStrategy::Grid.into(),
        seed: 1,
        heading: HeadingRule::Blended,
        ..PlanConfig::default()
    };
    plan(task, &config).unwrap()
}

/// A plan with nothing but its first stroke.
pub fn first_stroke(plan: Plan) -> Plan {
    Plan {
        strokes: plan.strokes.into_iter().take(1).collect(),
        ..plan
    }
}

/// The arm of seven joints before it.
pub fn cell(task: &Task) -> Workcell {
    let robot = arm7();
    let config = WorkcellConfig::default();
    Workcell::new(robot.model, Some(&robot.srdf), task, &config).unwrap()
}

/// Everything that is wrong with a followed plan: what the audit finds, nodes that are lost, and strokes that
/// are not the line that is wiped.
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
        // A stroke of one node only touches: nothing moves while it wipes.
        if wiped != stroke.poses && stroke.poses.len() > 1 {
            faults.push(format!("stroke {number} is not the line that is wiped"));
        }
    }
    faults
}
