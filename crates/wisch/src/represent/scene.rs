//! The geometric environment: objects that stand round the target surface.

use crate::geometry::{Mesh, Pose};

/// One object of the scene, as a mesh in the world frame.
#[derive(Debug, Clone)]
pub struct SceneObject {
    /// Name in the task file.
    pub name: String,
    /// Its surface in its own frame [m].
    pub mesh: Mesh,
    /// Where it stands.
    pub world_from_object: Pose,
}
