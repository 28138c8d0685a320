//! The robot of an episode, so that frames can be computed when its files have long changed.

use crate::store::{Episode, EpisodeWriter, MemoryError, URDF_FILE};
use std::collections::BTreeMap;
use wisch::robot::RobotModel;

const SRDF_FILE: &str = "robot.srdf";
/// Says which file holds which mesh.
const MESHES_FILE: &str = "robot-meshes.json";

/// A robot's description as files.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RobotText {
    /// The URDF.
    pub urdf: String,
    /// The SRDF, if there is one.
    pub srdf: Option<String>,
    /// The collision meshes, under the names that the URDF gives them.
    pub meshes: Vec<(String, Vec<u8>)>,
}

impl RobotText {
    /// Adds them to an episode.
    ///
    /// # Errors
    /// What the system says.
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
            // A mesh of several links is read several times.
            if files.contains_key(name.as_str()) {
                continue;
            }
            let file = format!("robot-meshes/{}", files.len());
            writer.attach(&file, bytes)?;
            files.insert(name, file);
        }
        // Texts always have a form in JSON.
        let files = serde_json::to_vec(&files).unwrap_or_default();
        writer.attach(MESHES_FILE, files)
    }
}

impl Episode {
    /// The robot that wiped.
    ///
    /// # Errors
    /// An episode without a robot, as of a log, or a description that cannot be read.
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
        let mut mesh = |name: &str| {
            let file = files.get(name).ok_or_else(|| format!("{name}: not kept"))?;
            self.attachment(file).map_err(|error| error.to_string())
        };
        RobotModel::from_urdf(&path.display().to_string(), &urdf, &mut mesh)
            .map_err(|error| broken(error.to_string()))
    }
}
