//! Objects of the scene, with their roles in the task.

use crate::geometry::{Mesh, Pose};

/// Role of an object in the task.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ScenePart {
    /// An obstacle for robot and tool.
    Obstacle,
    /// The object whose face is the target surface: an obstacle for the robot, touched by the tool.
    Carrier,
    /// A picture of the robot at its pose; no obstacle.
    Robot,
    /// A picture of the tool; no obstacle.
    Tool,
}

/// An object of the scene, as a mesh at a pose in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneObject {
    /// Name in the task file.
    pub name: String,
    /// Role in the task.
    pub part: ScenePart,
    /// Its mesh in its own frame \[m\].
    pub mesh: Mesh,
    /// Its pose in the world.
    pub world_from_object: Pose,
}
