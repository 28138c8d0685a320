//! The geometric environment: the objects of the scene and what each is to the wiping tool.

use crate::geometry::{Mesh, Pose};

/// What an object is to the task.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ScenePart {
    /// It stands in the way of robot and tool.
    Obstacle,
    /// Its face is the target surface: in the way of the robot, touched by the tool.
    Carrier,
    /// It shows where the robot stands.
    Robot,
    /// It shows the tool.
    Tool,
}

/// One object of the scene, as a mesh in the world frame.
#[derive(Debug, Clone)]
pub struct SceneObject {
    /// Name in the task file.
    pub name: String,
    /// What it is to the task.
    pub part: ScenePart,
    /// Its surface in its own frame [m].
    pub mesh: Mesh,
    /// Where it stands.
    pub world_from_object: Pose,
}
