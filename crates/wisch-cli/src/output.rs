//! The folder with the results: written beside its place and moved there whole.

use crate::failure::Failure;
use crate::workplace::{Found, Leftover, Workplace};
use serde::Deserialize;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use wisch_io::{INTERPRETATION_FORMAT, PLAN_FORMAT};

/// The plan. By this file, or by the next, a folder of results is known.
pub const PLAN_FILE: &str = "plan.json";
/// What a log says.
pub const INTERPRETATION_FILE: &str = "interpretation.json";
/// The particles as they are estimated to lie.
pub const PARTICLES_ESTIMATED_FILE: &str = "particles-estimated.csv";
/// The simulated particles as they really lie.
pub const PARTICLES_TRUE_FILE: &str = "particles-true.csv";
/// What happened in each round.
pub const ROUNDS_FILE: &str = "rounds.json";
/// The particles as they are believed to lie.
pub const PARTICLES_BEFORE_FILE: &str = "particles-before.csv";
/// The particles as they are predicted to lie.
pub const PARTICLES_AFTER_FILE: &str = "particles-after.csv";
/// How the robot follows the plan.
pub const FOLLOWING_FILE: &str = "following.json";
/// The robot's motion as a ROS 2 message.
pub const TRAJECTORY_JSON_FILE: &str = "trajectory.json";
/// The same as YAML.
pub const TRAJECTORY_YAML_FILE: &str = "trajectory.yaml";
/// The tool's path as a table.
pub const TCP_PATH_FILE: &str = "tcp-path.csv";
/// The report.
pub const REPORT_FILE: &str = "report.html";

/// A file in the making: in the end it is there whole or not at all.
pub struct OutputFile {
    target: PathBuf,
    file: tempfile::NamedTempFile,
}

impl OutputFile {
    /// Begins a file that is to stand at `target`.
    ///
    /// # Errors
    /// If a folder stands there, or nothing can be written.
    pub fn begin(target: &Path) -> Result<Self, Failure> {
        if target.is_dir() {
            return Err(Failure::new(format!(
                "{}: a file is to be written, but a folder stands there",
                target.display()
            ))
            .with_help("choose another file with --out"));
        }
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let file = tempfile::NamedTempFile::new_in(folder)
            .map_err(|error| cannot_write(target, &error))?;
        Ok(Self {
            target: target.to_path_buf(),
            file,
        })
    }

    /// Moves the file to its place, with these contents.
    ///
    /// # Errors
    /// What the system says.
    pub fn finish(self, contents: &[u8]) -> Result<(), Failure> {
        let Self { target, file } = self;
        let failed = |error: io::Error| cannot_write(&target, &error);
        fs::write(file.path(), contents).map_err(failed)?;
        file.persist(&target).map_err(|error| failed(error.error))?;
        Ok(())
    }
}

/// Folders that were made on the way to a target. Dropped, those that are still empty go again.
struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    fn make(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|folder| !folder.exists());
        let missing = missing.map(Path::to_path_buf).collect();
        fs::create_dir_all(folder)?;
        Ok(Self(missing))
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        for folder in &self.0 {
            // Those that hold something stay.
            let _ = fs::remove_dir(folder);
        }
    }
}

/// A folder of results in the making. Dropped unfinished, it leaves nothing behind.
pub struct OutputFolder {
    target: PathBuf,
    /// Holds `new`, `old` while folders change places, and `state`, which is of use only if this run dies.
    workplace: Workplace,
    found: Found,
    /// Dropped after `workplace`, which stands in them.
    _made: MadeFolders,
}

impl OutputFolder {
    /// Begins a folder that is to stand at `target`, or goes on with one that a killed run left behind.
    ///
    /// # Errors
    /// If something else than results of an earlier run stands there, or nothing can be written.
    pub fn begin(target: &Path, leftover: Leftover) -> Result<Self, Failure> {
        let target = resolved(target)?;
        check_replaceable(&target)?;
        let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
            return Err(Failure::new(format!(
                "{}: results cannot replace this folder",
                target.display()
            )));
        };
        let made = MadeFolders::make(parent).map_err(|error| cannot_write(parent, &error))?;
        let (workplace, found) = Workplace::begin(parent, &name.to_string_lossy(), leftover)
            .map_err(|error| cannot_write(parent, &error))?;
        let folder = Self {
            target,
            workplace,
            found,
            _made: made,
        };
        for path in [folder.new_path(), folder.state()] {
            fs::create_dir_all(&path).map_err(|error| cannot_write(&path, &error))?;
        }
        Ok(folder)
    }

    /// Adds a file.
    ///
    /// # Errors
    /// What the system says.
    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> Result<(), Failure> {
        fs::write(self.new_path().join(name), contents)
            .map_err(|error| cannot_write(&self.target.join(name), &error))
    }

    /// What was found of killed runs.
    pub const fn found(&self) -> &Found {
        &self.found
    }

    /// Where is kept what a run is to go on with, should it be killed.
    pub fn state(&self) -> PathBuf {
        self.workplace.path().join("state")
    }

    /// Removes all files, of what a killed run left behind, that are not named.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep_only(&self, names: &[String]) -> Result<(), Failure> {
        let failed = |error: io::Error| cannot_write(&self.new_path(), &error);
        for entry in fs::read_dir(self.new_path()).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            if !names.contains(&entry.file_name().to_string_lossy().into_owned()) {
                fs::remove_file(entry.path()).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// Where a file stands that others write before the folder is finished.
    pub fn place(&self, name: &str) -> PathBuf {
        self.new_path().join(name)
    }

    /// Moves the folder to its place, and what stood there away.
    ///
    /// # Errors
    /// What the system says; then what stood there stands there still.
    pub fn finish(self) -> Result<(), Failure> {
        let old = self.workplace.path().join("old");
        // Someone may have put something there while we were planning.
        check_replaceable(&self.target)?;
        let replaced = match fs::rename(&self.target, &old) {
            Ok(()) => true,
            Err(error) if error.kind() == ErrorKind::NotFound => false,
            Err(error) => return Err(cannot_write(&self.target, &error)),
        };
        fs::rename(self.new_path(), &self.target).map_err(|error| {
            if replaced {
                // If even this fails, the first error is the one to tell.
                let _ = fs::rename(&old, &self.target);
            }
            cannot_write(&self.target, &error)
        })
    }

    fn new_path(&self) -> PathBuf {
        self.workplace.path().join("new")
    }
}

/// The absolute path, with a link to a folder followed.
fn resolved(target: &Path) -> Result<PathBuf, Failure> {
    match target.canonicalize() {
        Ok(path) => Ok(path),
        Err(error) if error.kind() == ErrorKind::NotFound => std::path::absolute(target),
        Err(error) => Err(error),
    }
    .map_err(|error| cannot_write(target, &error))
}

/// Whether nothing would be lost: there is nothing, an empty folder, or results that we wrote.
fn check_replaceable(target: &Path) -> Result<(), Failure> {
    let refuse = |reason: String| {
        Err(Failure::new(format!("{}: {reason}", target.display()))
            .with_help("choose another folder with --out, or move this one away"))
    };
    let entries = match fs::read_dir(target) {
        Ok(entries) => entries,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        Err(error) if error.kind() == ErrorKind::NotADirectory => {
            return refuse("results need a folder, but a file stands there".to_owned());
        }
        Err(error) => return Err(cannot_write(target, &error)),
    };
    let mut names: Vec<String> = entries
        .filter_map(|entry| Some(entry.ok()?.file_name().to_string_lossy().into_owned()))
        .collect();
    names.sort();
    if names.is_empty() {
        return Ok(());
    }
    let is_known = is_of_ours(&target.join(PLAN_FILE), PLAN_FORMAT)
        || is_of_ours(&target.join(INTERPRETATION_FILE), INTERPRETATION_FORMAT);
    if !is_known {
        return refuse(format!(
            "the folder is not empty and holds no {PLAN_FILE} of wisch, so it is not replaced"
        ));
    }
    match names.iter().find(|name| !is_result_file(name)) {
        Some(name) => refuse(format!(
            "the folder also holds {name:?}, which wisch did not write, so it is not replaced"
        )),
        None => Ok(()),
    }
}

fn is_of_ours(path: &Path, format: &str) -> bool {
    #[derive(Deserialize)]
    struct Marker {
        format: String,
    }
    fs::read(path)
        .ok()
        .and_then(|bytes| serde_json::from_slice::<Marker>(&bytes).ok())
        .is_some_and(|marker| marker.format == format)
}

/// Whether a file of that name may be one of the results, of which the pictures are many.
fn is_result_file(name: &str) -> bool {
    let fixed = [
        PLAN_FILE,
        INTERPRETATION_FILE,
        PARTICLES_ESTIMATED_FILE,
        PARTICLES_TRUE_FILE,
        ROUNDS_FILE,
        PARTICLES_BEFORE_FILE,
        PARTICLES_AFTER_FILE,
        FOLLOWING_FILE,
        TRAJECTORY_JSON_FILE,
        TRAJECTORY_YAML_FILE,
        TCP_PATH_FILE,
        REPORT_FILE,
    ];
    let is_bag = name.starts_with("round-") && name.ends_with(".mcap");
    let is_picture = name.ends_with(".svg") || name.ends_with(".png");
    fixed.contains(&name) || is_bag || is_picture
}

fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::new(format!("{}: cannot write there: {error}", path.display()))
        .with_help("choose another folder with --out")
}
