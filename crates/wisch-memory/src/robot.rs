//! The robot of an episode, stored with it so that frames can be computed after the robot's own files have changed.

use crate::store::{Episode, EpisodeWriter, MemoryError, URDF_FILE};
use std::collections::BTreeMap;
use wisch::robot::RobotModel;

const SRDF_FILE: &str = "robot.srdf";
/// File that maps the meshes of the description to files.
const MESHES_FILE: &str = "robot-meshes.json";

/// The files of a robot's description, as an episode keeps them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RobotText {
    /// The URDF.
    pub urdf: String,
    /// The SRDF, if there is one.
    pub srdf: Option<String>,
    /// The collision meshes, by their names in the URDF.
    pub meshes: Vec<(String, Vec<u8>)>,
}

impl RobotText {
    /// Adds the files to an episode.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn attach_to(&self, writer: &EpisodeWriter) -> Result<(), MemoryError> {
        writer.attach(URDF_FILE, &self.urdf)?;
        if let Some(srdf) = &self.srdf {
            writer.attach(SRDF_FILE, srdf)?;
        }
        if self.meshes.is_empty() {
            return Ok(());
        }
        let mut files: BTreeMap<&str, String> = BTreeMap::new();
        for (name, bytes) in &self.meshes {
            // Several links may use the same mesh.
            if files.contains_key(name.as_str()) {
                continue;
            }
            let file = format!("robot-meshes/{}", files.len());
            writer.attach(&file, bytes)?;
            files.insert(name, file);
        }
        // Texts always serialise to JSON.
        let files = serde_json::to_vec(&files).unwrap_or_default();
        writer.attach(MESHES_FILE, files)
    }
}

impl Episode {
    /// Returns the model of the robot.
    ///
    /// # Errors
    /// If the episode has no robot, for example after the import of a log, or if the description cannot be read.
    pub fn robot(&self) -> Result<RobotModel, MemoryError> {
        let path = self.folder().join(URDF_FILE);
        let broken = |what: String| MemoryError::Json {
            path: path.clone(),
            what,
        };
        let urdf = self.attachment(URDF_FILE)?;
        let urdf = String::from_utf8(urdf).map_err(|error| broken(error.to_string()))?;
        let has_meshes = self.folder().join(MESHES_FILE).is_file();
        let files: BTreeMap<String, String> = if has_meshes {
            serde_json::from_slice(&self.attachment(MESHES_FILE)?)
                .map_err(|error| broken(format!("{MESHES_FILE}: {error}")))?
        } else {
            BTreeMap::new()
        };
        // The episode does not list a mesh that was already missing when it was recorded, so its
        // absence is no damage. A listed mesh must be readable.
        let mut damaged: Option<String> = None;
        let mut mesh = |name: &str| {
            let file = files
                .get(name)
                .ok_or_else(|| format!("{name}: the episode does not hold this mesh"))?;
            self.attachment(file).map_err(|error| {
                let error = error.to_string();
                damaged.get_or_insert_with(|| error.clone());
                error
            })
        };
        let robot = RobotModel::from_urdf(&path.display().to_string(), &urdf, &mut mesh)
            .map_err(|error| broken(error.to_string()))?;
        damaged.map_or(Ok(robot), |error| Err(broken(error)))
    }
}
