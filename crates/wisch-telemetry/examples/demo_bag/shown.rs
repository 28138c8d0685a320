//! Data for viewers in the synthetic log: a robot, a board with a hole on a table, a tool, and the strokes.

use super::wiping::Wiping;
use wisch::geometry::{Mesh, PlanarPose, Point2, Polygon, Pose, Vector2, Vector3};
use wisch::plan::Stroke;
use wisch::represent::{GoalState, SceneObject, ScenePart, Surface};
use wisch::robot::RobotModel;
use wisch_telemetry::{BagRobot, BagScene, BagWriter};

/// A robot with the joints of the synthetic log.
pub const URDF: &str = include_str!("arm.urdf");
/// Pose of the robot's root.
pub const WORLD_FROM_ROOT: [f64; 3] = [0.0, -0.6, 0.77];

/// Writes robot, scene, tool and strokes.
///
/// # Errors
/// If the robot is invalid, or writing fails.
pub fn write(bag: &mut BagWriter, wiping: &Wiping) -> Result<(), Box<dyn std::error::Error>> {
    let model = RobotModel::from_urdf("arm.urdf", URDF, &mut |_| Err("no meshes".to_owned()))?;
    let [x, y, z] = WORLD_FROM_ROOT;
    bag.write_robot(&BagRobot {
        urdf: URDF,
        model: &model,
        world_from_root: Pose::translation(x, y, z),
    })?;
    let corner = Vector2::new(0.18, -0.12);
    let hole = [[0.0, 0.0], [0.01, 0.0], [0.01, 0.01]].map(|[x, y]| Point2::new(x, y) + corner);
    let outline = Polygon::rectangle(Vector2::new(0.40, 0.28));
    let surface = Surface {
        name: "board".into(),
        outline: Polygon::new(outline.outer().to_vec(), vec![hole.to_vec()]),
        world_from_surface: wiping.world_from_surface,
        skim_edges: vec![],
        shape: Default::default(),
    };
    let below = |depth: f64| wiping.world_from_surface * Pose::translation(0.0, 0.0, -depth);
    let object = |name: &str, part, size: [f64; 3], depth| {
        Ok::<_, wisch::geometry::MeshError>(SceneObject {
            name: name.into(),
            part,
            mesh: Mesh::cuboid(Vector3::from(size))?,
            world_from_object: below(depth),
        })
    };
    let objects = [
        object("board", ScenePart::Carrier, [0.40, 0.28, 0.02], 0.01)?,
        object("table", ScenePart::Obstacle, [1.2, 0.8, 0.04], 0.04)?,
    ];
    let tool = Mesh::cuboid(Vector3::new(0.06, 0.09, 0.03))?
        .transform(&Pose::translation(0.0, 0.0, 0.015));
    bag.write_scene(&BagScene {
        surface: &surface,
        objects: &objects,
        tool: &tool,
        goal: &GoalState::Collected {
            center: Point2::new(0.13, -0.08),
            radius: 0.05,
        },
    })?;
    let pose = |x: f64, y: f64| PlanarPose {
        position: Point2::new(x, y),
        heading: 0.0,
    };
    let x = wiping.extent[0] / 2.0;
    let across = |y: f64| Stroke {
        nodes: vec![0, 1],
        poses: vec![pose(-x, y), pose(x, y)],
    };
    let touch = Stroke {
        nodes: vec![0],
        poses: vec![pose(0.0, 0.0)],
    };
    bag.write_strokes(&[across(-0.05), touch, across(0.05)])?;
    Ok(())
}
