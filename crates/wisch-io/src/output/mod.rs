//! Folders of results, which are written beside their target and moved there when complete.

mod replacement;
mod staging_dir;

pub use staging_dir::{KilledRuns, Leftover};

use crate::error::Error;
use crate::records::{INTERPRETATION_FORMAT, PLAN_FORMAT};
use serde::Deserialize;
use staging_dir::{StagingDir, find_newest};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The plan. This file or the next one identifies a folder of results.
pub const PLAN_FILE: &str = "plan.json";
/// Name of the file with the interpretation of a log.
pub const INTERPRETATION_FILE: &str = "interpretation.json";
/// Name of the file with the estimated particles.
pub const PARTICLES_ESTIMATED_FILE: &str = "particles-estimated.csv";
/// The true particles of the simulation.
pub const PARTICLES_TRUE_FILE: &str = "particles-true.csv";
/// Name of the file with the summaries of the rounds.
pub const ROUNDS_FILE: &str = "rounds.json";
/// Name of the file with the believed particles before wiping.
pub const PARTICLES_BEFORE_FILE: &str = "particles-before.csv";
/// Name of the file with the predicted particles after wiping.
pub const PARTICLES_AFTER_FILE: &str = "particles-after.csv";
/// The record of how the robot follows the plan.
pub const FOLLOWING_FILE: &str = "following.json";
/// The robot's motion as a ROS 2 message.
pub const TRAJECTORY_FILE: &str = "trajectory.json";
/// The robot's motion as YAML, in results of earlier versions.
const OLD_TRAJECTORY_FILE: &str = "trajectory.yaml";
/// The tool's path as a table.
pub const TCP_PATH_FILE: &str = "tcp-path.csv";
/// The recording for the report, as compressed JSON lines.
pub const RECORDING_FILE: &str = "recording.jsonl.gz";
/// Name of the file with the report.
pub const REPORT_FILE: &str = "report.html";

/// Returns the subfolder of a file in a folder of results; the main files are at the top level.
fn subfolder(name: &str) -> &'static str {
    let is = |ending: &str| name.ends_with(ending);
    if is(".svg") || is(".png") {
        "figures"
    } else if is(".mcap") {
        "telemetry"
    } else if name.starts_with("particles-") {
        "particles"
    } else if [FOLLOWING_FILE, TRAJECTORY_FILE, TCP_PATH_FILE]
        .contains(&of_first_round(name).as_str())
    {
        "trajectories"
    } else {
        ""
    }
}

/// Returns the name of a round's file: the plain name for the first round, else a name with the number, such as
/// `plan-round-2.json`.
pub fn round_file_name(name: &str, round: usize) -> String {
    match name.rsplit_once('.') {
        Some((stem, ending)) if round > 1 => format!("{stem}-round-{round}.{ending}"),
        _ => name.to_owned(),
    }
}

/// Returns the name of the same file for the first round.
fn of_first_round(name: &str) -> String {
    let parts = name.rsplit_once('.').and_then(|(stem, ending)| {
        let (stem, round) = stem.rsplit_once("-round-")?;
        let is_number = round.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| format!("{stem}.{ending}"))
    });
    parts.unwrap_or_else(|| name.to_owned())
}

/// Subfolder of a staging folder with the checkpoints.
const STATE: &str = "state";

/// The subfolders of a folder of results.
const SUBFOLDERS: [&str; 4] = ["figures", "telemetry", "particles", "trajectories"];

/// Returns the path of a file within a folder of results.
pub fn path_in_results(name: &str) -> PathBuf {
    Path::new(subfolder(name)).join(name)
}

/// An unfinished file, which appears at its target complete or not at all.
pub struct OutputFile {
    target: PathBuf,
    file: tempfile::NamedTempFile,
}

impl OutputFile {
    /// Begins a file beside `target`, which [`Self::finish`] moves there.
    ///
    /// # Errors
    /// If the target is a folder, or the file cannot be written.
    pub fn begin(target: &Path) -> Result<Self, Error> {
        if target.is_dir() {
            return Err(refused(
                target,
                "cannot write the file: this is a folder",
                OTHER_FILE,
            ));
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

    /// Writes the contents and moves the file to its target.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, contents: &[u8]) -> Result<(), Error> {
        let Self { target, file } = self;
        let failed = |error: io::Error| cannot_write(&target, &error);
        fs::write(file.path(), contents).map_err(failed)?;
        file.persist(&target).map_err(|error| failed(error.error))?;
        Ok(())
    }
}

/// Parent folders that were created for a target. When dropped, it removes those that are still empty.
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
            // Folders with contents stay.
            let _ = fs::remove_dir(folder);
        }
    }
}

/// The earlier results that may be replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Replaceable {
    /// All results.
    All,
    /// Results without measurements of a run.
    AllButRuns,
}

/// An unfinished folder of results. If it is dropped before it is finished, it leaves no files.
pub struct OutputFolder {
    target: PathBuf,
    /// Contains `new`, the files of [`replacement`], and `state`, which a resumed run reads.
    staging: StagingDir,
    found: KilledRuns,
    /// Dropped after `staging`, which they contain.
    _made: MadeFolders,
}

impl OutputFolder {
    /// Begins a folder for `target`, or takes over the folder of a killed run.
    ///
    /// # Errors
    /// If the target holds other files than results, or results that may not be replaced, if another process writes
    /// results to this target, or if the folder cannot be written.
    pub fn begin(
        target: &Path,
        leftover: Leftover,
        replaceable: Replaceable,
    ) -> Result<Self, Error> {
        let target = resolved(target)?;
        check_replaceable(&target)?;
        let is_run = [
            path_in_results(ROUNDS_FILE),
            path_in_results("round-1.mcap"),
        ]
        .iter()
        .any(|name| target.join(name).exists());
        if is_run && replaceable == Replaceable::AllButRuns {
            return Err(refused(
                &target,
                "the folder holds a run's measurements, which this command cannot reproduce, so it is not replaced",
                "choose another folder with --out, or replace it with --force",
            ));
        }
        let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
            return Err(refused(
                &target,
                "results cannot replace this folder",
                OTHER_FOLDER,
            ));
        };
        let made = MadeFolders::make(parent).map_err(|error| cannot_write(parent, &error))?;
        let (staging, found) =
            StagingDir::begin(parent, &name.to_string_lossy(), leftover, &target).map_err(
                |error| match error.kind() {
                    ErrorKind::ResourceBusy => refused(
                        &target,
                        "another wisch process is writing results there",
                        "wait for it, or choose another folder with --out",
                    ),
                    _ => cannot_write(parent, &error),
                },
            )?;
        let folder = Self {
            target,
            staging,
            found,
            _made: made,
        };
        let subfolders = SUBFOLDERS.map(|name| folder.new_path().join(name));
        for path in subfolders.into_iter().chain([folder.checkpoint_folder()]) {
            fs::create_dir_all(&path).map_err(|error| cannot_write(&path, &error))?;
        }
        Ok(folder)
    }

    /// Adds a file to its subfolder.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> Result<(), Error> {
        fs::write(self.file_path(name), contents)
            .map_err(|error| cannot_write(&self.target.join(path_in_results(name)), &error))
    }

    /// What killed runs left for this target.
    pub fn leftovers(&self) -> &KilledRuns {
        &self.found
    }

    /// The folder, beside the target, that holds results and checkpoints until they are complete.
    pub fn staging_path(&self) -> &Path {
        self.staging.path()
    }

    /// The folder of the run's checkpoints.
    pub fn checkpoint_folder(&self) -> PathBuf {
        self.staging.path().join(STATE)
    }

    /// Returns the folder of the checkpoints that [`Self::begin`] would take over for a target; `None` without a killed run.
    pub fn find_checkpoints(target: &Path) -> Option<PathBuf> {
        let target = resolved(target).ok()?;
        let name = target.file_name()?.to_string_lossy().into_owned();
        Some(find_newest(target.parent()?, &name)?.join(STATE))
    }

    /// Path at which the results appear.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Removes all files of a killed run except the named files.
    ///
    /// # Errors
    /// If a file cannot be removed.
    pub fn keep_only(&self, names: &[String]) -> Result<(), Error> {
        let failed = |error: io::Error| cannot_write(&self.new_path(), &error);
        for (path, name) in files(&self.new_path()).map_err(failed)? {
            if !names.contains(&name) {
                fs::remove_file(path).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// Returns the path for a file that the caller writes before the folder is finished.
    pub fn file_path(&self, name: &str) -> PathBuf {
        self.new_path().join(path_in_results(name))
    }

    /// Moves the folder to its target and removes the earlier results.
    ///
    /// # Errors
    /// If the folder cannot be moved; the target is then unchanged.
    pub fn finish(self) -> Result<(), Error> {
        for subfolder in SUBFOLDERS {
            // Folders with contents stay.
            let _ = fs::remove_dir(self.new_path().join(subfolder));
        }
        // The target may have changed since the beginning.
        check_replaceable(&self.target)?;
        replacement::put_in_place(self.staging.path(), &self.target)
            .map_err(|error| cannot_write(&self.target, &error))?;
        self.staging.remove();
        Ok(())
    }

    fn new_path(&self) -> PathBuf {
        self.staging.path().join(replacement::NEW)
    }
}

/// Returns the absolute path; links to folders are resolved.
fn resolved(target: &Path) -> Result<PathBuf, Error> {
    match target.canonicalize() {
        Ok(path) => Ok(path),
        Err(error) if error.kind() == ErrorKind::NotFound => std::path::absolute(target),
        Err(error) => Err(error),
    }
    .map_err(|error| cannot_write(target, &error))
}

/// Checks that a replacement loses no foreign files: the target is missing, empty, or holds results of wisch.
fn check_replaceable(target: &Path) -> Result<(), Error> {
    let refuse = |reason: String| Err(refused(target, reason, MOVE_AWAY));
    let mut names: Vec<String> = match files(target) {
        Ok(found) => found.into_iter().map(|(_, name)| name).collect(),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        Err(error) if error.kind() == ErrorKind::NotADirectory => {
            return refuse("results need a folder, but this is a file".to_owned());
        }
        Err(error) => return Err(cannot_write(target, &error)),
    };
    names.sort();
    if names.is_empty() {
        return Ok(());
    }
    let is_known = is_of_ours(&target.join(PLAN_FILE), PLAN_FORMAT)
        || is_of_ours(&target.join(INTERPRETATION_FILE), INTERPRETATION_FORMAT);
    if !is_known {
        return refuse(format!(
            "the folder is not empty and contains no {PLAN_FILE} of wisch, so it is not replaced"
        ));
    }
    match names.iter().find(|name| !is_result_file(name)) {
        Some(name) => refuse(format!(
            "the folder also contains {name:?}, which wisch did not write, so it is not replaced"
        )),
        None => Ok(()),
    }
}

/// Lists the contents of a folder of results and its subfolders: paths and names.
fn files(folder: &Path) -> io::Result<Vec<(PathBuf, String)>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if SUBFOLDERS.contains(&name.as_str()) && entry.file_type()?.is_dir() {
            for inner in fs::read_dir(entry.path())? {
                let inner = inner?;
                let name = inner.file_name().to_string_lossy().into_owned();
                found.push((inner.path(), name));
            }
        } else {
            found.push((entry.path(), name));
        }
    }
    Ok(found)
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

/// Whether a file name is that of a result, including pictures.
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
        TRAJECTORY_FILE,
        OLD_TRAJECTORY_FILE,
        TCP_PATH_FILE,
        RECORDING_FILE,
        REPORT_FILE,
    ];
    // A run that ends in the middle of a round leaves its bag unfinished.
    let is_bag = name.starts_with("round-")
        && name
            .strip_suffix(".active")
            .unwrap_or(name)
            .ends_with(".mcap");
    let is_picture = name.ends_with(".svg") || name.ends_with(".png");
    fixed.contains(&of_first_round(name).as_str()) || is_bag || is_picture
}

const OTHER_FILE: &str = "choose another file with --out";
const OTHER_FOLDER: &str = "choose another folder with --out";
const MOVE_AWAY: &str = "choose another folder with --out, or move this one away";

fn refused(path: &Path, problem: impl ToString, help: &'static str) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem: problem.to_string(),
        help,
    }
}

fn cannot_write(path: &Path, error: &io::Error) -> Error {
    refused(path, format!("cannot write there: {error}"), OTHER_FOLDER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_of_every_round_are_results() {
        let names = [
            PLAN_FILE,
            FOLLOWING_FILE,
            TRAJECTORY_FILE,
            OLD_TRAJECTORY_FILE,
            TCP_PATH_FILE,
        ];
        for name in names {
            assert!(is_result_file(name), "{name}");
            let later = round_file_name(name, 12);
            assert!(is_result_file(&later), "{later}");
            assert_eq!(of_first_round(&later), name);
        }
        assert!(is_result_file("round-2.mcap") && is_result_file("round-2.mcap.active"));
        assert!(!is_result_file("notes-round-2.txt"));
    }
}
