//! The result of the push test, which belongs to one configuration of a robot.

use crate::frames::Frames;
use crate::robot_file::RobotFile;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::io::Write;
use std::path::PathBuf;

/// The schema of the file.
const SCHEMA: u32 = 1;

/// The result of a push test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Commissioning {
    pub schema: u32,
    /// SHA-256 of the robot file and the URDF.
    pub configuration: String,
    /// 1 if the sensor reports the force of the surroundings on the tool, -1 if it reports the opposite.
    pub sign: f64,
    /// Angle between the pushes and the measured forces [degrees].
    pub angle_deg: f64,
    /// Largest force after taring, and its drift in a minute [N].
    pub tared_n: f64,
    pub drift_n_per_min: f64,
}

/// Returns the hash of a configuration.
pub(crate) fn configuration_hash(file: &RobotFile, frames: &Frames) -> String {
    let mut hash = Sha256::new();
    // The lengths separate the two texts.
    for text in [&file.text, &frames.urdf] {
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text.as_bytes());
    }
    let digest = hash.finalize();
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Commissioning {
    /// Returns the result for a configuration.
    pub fn new(file: &RobotFile, frames: &Frames, sign: f64) -> Self {
        Self {
            schema: SCHEMA,
            configuration: configuration_hash(file, frames),
            sign,
            angle_deg: 0.0,
            tared_n: 0.0,
            drift_n_per_min: 0.0,
        }
    }

    /// Reads the result of a configuration.
    ///
    /// # Errors
    /// If there is none, it is invalid, or it belongs to another configuration. The text says what to do.
    pub fn read(file: &RobotFile, frames: &Frames) -> Result<Self, String> {
        let path = file.commissioning_path();
        let shown = path.display();
        let again = format!("run: wisch robot push-test {}", file.path.display());
        let text = std::fs::read_to_string(&path)
            .map_err(|error| format!("{shown}: {error}; the robot is not commissioned, {again}"))?;
        let read: Self = toml::from_str(&text)
            .map_err(|error| format!("{shown}: {}; {again}", error.message()))?;
        let expected = configuration_hash(file, frames);
        if read.schema != SCHEMA || read.configuration != expected {
            return Err(format!(
                "{shown} belongs to configuration {}, but {} and its URDF are {expected}; {again}",
                shortened(&read.configuration),
                file.path.display()
            ));
        }
        if read.sign.abs() != 1.0 {
            return Err(format!(
                "{shown}: sign = {}: expected 1 or -1; {again}",
                read.sign
            ));
        }
        Ok(read)
    }

    /// Writes the result beside the robot file, whole or not at all. Returns its path.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, file: &RobotFile) -> Result<PathBuf, String> {
        let path = file.commissioning_path();
        let failed = |error: String| format!("{}: {error}", path.display());
        let text = toml::to_string(self).map_err(|error| failed(error.to_string()))?;
        let folder = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(std::path::Path::new("."));
        let mut builder = tempfile::Builder::new();
        // As other new files have them; temporary files are readable by their owner only.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let written = builder.tempfile_in(folder).and_then(|mut part| {
            part.write_all(b"# The result of `wisch robot push-test`. It holds for this robot file and URDF only.\n")?;
            part.write_all(text.as_bytes())?;
            part.as_file().sync_all()?;
            part.persist(&path).map_err(|error| error.error)
        });
        written.map_err(|error| failed(error.to_string()))?;
        Ok(path)
    }
}

/// The first digits of a hash.
fn shortened(hash: &str) -> &str {
    hash.get(..12).unwrap_or(hash)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "schema = 1\nurdf = \"arm7\"\n[motion]\naction = \"/jtc/follow_joint_trajectory\"\n\
                        controllers = [\"jtc\"]\n[force]\nkind = \"none\"\n";

    #[test]
    fn a_result_holds_for_its_configuration_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("R.toml");
        let file = RobotFile::parse(&path, TEXT.to_owned()).unwrap();
        let frames = Frames::read(&path, "arm7", None).unwrap();
        let missing = Commissioning::read(&file, &frames).unwrap_err();
        assert!(missing.contains("push-test"), "{missing}");
        let result = Commissioning::new(&file, &frames, -1.0);
        let written = result.write(&file).unwrap();
        assert_eq!(written, folder.path().join("R.commissioned.toml"));
        assert_eq!(Commissioning::read(&file, &frames), Ok(result));
        let other = RobotFile::parse(&path, format!("{TEXT}[limits]\nforce_n = 10\n")).unwrap();
        let error = Commissioning::read(&other, &frames).unwrap_err();
        assert!(error.contains("belongs to configuration"), "{error}");
    }
}
