//! Folders of results, which are written beside their target and moved there when complete.

mod fault;
mod file;
mod replacement;
mod staging_dir;
mod unfinished;

pub use file::OutputFile;
pub use staging_dir::{KilledRuns, Leftover};
pub use unfinished::{Unfinished, UnfinishedPath, remove_unfinished};

use crate::error::Error;
use crate::records::{INTERPRETATION_FORMAT, PLAN_FORMAT};
use fault::{MOVE_AWAY, OTHER_FOLDER, cannot_write, refused};
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

/// A folder that is written beside its target under another name, and appears there complete or not
/// at all. An interruption removes it; if the process is killed, the next folder for the same
/// target does.
pub struct NewFolder {
    target: PathBuf,
    staging: StagingDir,
    /// Dropped after `staging`, which they contain.
    _made: MadeFolders,
}

impl NewFolder {
    /// Begins a folder for `target`, which must not exist.
    ///
    /// # Errors
    /// If the target exists, another process writes it, or the folder cannot be written.
    pub fn begin(target: &Path) -> Result<Self, Error> {
        let target = resolved(target)?;
        if target.exists() {
            return Err(refused(&target, "it exists already", OTHER_FOLDER));
        }
        let (staging, _, made) = begin_staging(&target, Leftover::Remove)?;
        Ok(Self {
            target,
            staging,
            _made: made,
        })
    }

    /// Path at which the caller writes the folder, which does not exist yet.
    pub fn path(&self) -> PathBuf {
        self.staging.path().join(replacement::NEW)
    }

    /// Moves the folder to its target.
    ///
    /// # Errors
    /// If the folder cannot be moved, or the target exists meanwhile.
    pub fn finish(self) -> Result<(), Error> {
        let Self {
            target, staging, ..
        } = self;
        if target.exists() {
            return Err(refused(&target, "it exists already", OTHER_FOLDER));
        }
        let moved = staging.place(|staging| fs::rename(staging.join(replacement::NEW), &target));
        moved.map_err(|error| cannot_write(&target, &error))
    }
}

/// Makes the parents of a target, and a staging folder beside it.
fn begin_staging(
    target: &Path,
    leftover: Leftover,
) -> Result<(StagingDir, KilledRuns, MadeFolders), Error> {
    let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
        return Err(refused(
            target,
            "results cannot replace this folder",
            OTHER_FOLDER,
        ));
    };
    let made = MadeFolders::make(parent).map_err(|error| cannot_write(parent, &error))?;
    let begun = StagingDir::begin(parent, &name.to_string_lossy(), leftover, target);
    let (staging, found) = begun.map_err(|error| match error.kind() {
        ErrorKind::ResourceBusy => refused(
            target,
            "another wisch process is writing results there",
            "wait for it, or choose another folder with --out",
        ),
        _ => cannot_write(parent, &error),
    })?;
    Ok((staging, found, made))
}

/// Parent folders that were created for a target. When dropped, it removes those that are still empty.
struct MadeFolders {
    folders: Vec<PathBuf>,
    _unfinished: Unfinished,
}

impl MadeFolders {
    fn make(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|folder| !folder.exists());
        let missing: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
        // An interruption removes them if they are empty.
        // The parents last, which may be empty then.
        let parents = (missing.iter().cloned())
            .map(UnfinishedPath::EmptyFolder)
            .collect();
        let ((), unfinished) =
            Unfinished::create(|| fs::create_dir_all(folder).map(|()| ((), parents)))?;
        Ok(Self {
            folders: missing,
            _unfinished: unfinished,
        })
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        for folder in &self.folders {
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
        let (staging, found, made) = begin_staging(&target, leftover)?;
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

    /// Lets an interruption keep the checkpoints from now on, so that the run can be resumed.
    pub fn keep_if_interrupted(&self) {
        self.staging.keep_if_interrupted();
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
        let target = &self.target;
        (self.staging)
            .place(|staging| replacement::put_in_place(staging, target))
            .map_err(|error| cannot_write(target, &error))
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

    pub(super) fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_folder_that_is_written_aside_appears_whole_and_takes_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("deep/new");
        let dropped = NewFolder::begin(&target).expect("a folder");
        fs::create_dir(dropped.path()).expect("a folder");
        drop(dropped);
        assert_eq!(names(folder.path()), [] as [&str; 0]);
        let new = NewFolder::begin(&target).expect("a folder");
        fs::create_dir(new.path()).expect("a folder");
        fs::write(new.path().join("file"), "whole").expect("a file");
        new.finish().expect("in place");
        assert_eq!(names(&folder.path().join("deep")), ["new"]);
        let Err(error) = NewFolder::begin(&target) else {
            panic!("it exists");
        };
        assert!(error.to_string().contains("it exists already"), "{error}");
    }
}
