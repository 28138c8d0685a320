//! Folders of results, which are written beside their target and moved there when complete.

mod replacement;
mod staging_dir;
mod unfinished;

pub use staging_dir::{KilledRuns, Leftover};
pub use unfinished::{Unfinished, UnfinishedPath, remove_unfinished};

use crate::error::Error;
use crate::records::{INTERPRETATION_FORMAT, PLAN_FORMAT};
use serde::Deserialize;
use staging_dir::{StagingDir, find_newest};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{NamedTempFile, PersistError};

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

/// Ending of a file that is not complete yet, and the mark before the random part of its name: `.NAME.wisch-RANDOM.part`.
const PART_ENDING: &str = ".part";
const PART_MARK: &str = ".wisch-";
/// Number of random characters in the name of an unfinished file.
const RANDOM_LEN: usize = 6;
/// Longest part of the target's name in that of its unfinished file [bytes]: file systems allow 255 bytes for all of it.
const MAX_PART_NAME: usize = 200;
/// Largest number of links from one path to its file, as on Linux.
const MAX_LINKS: usize = 40;

/// An unfinished file, which appears at its target complete or not at all. An interruption removes it; if the process is
/// killed, the next file in the same folder does.
pub struct OutputFile {
    target: PathBuf,
    /// `None` for a target that is no regular file, such as `/dev/stdout`, which is written in place.
    part: Option<Part>,
}

/// A file beside its target, locked as long as it is written.
struct Part {
    // Dropped in this order: the file is removed while it is guarded.
    file: NamedTempFile,
    unfinished: Unfinished,
}

impl OutputFile {
    /// Begins a file beside `target`, which [`Self::finish`] moves there.
    ///
    /// A file that is replaced keeps its permissions. The file behind a link is replaced, not the link.
    ///
    /// # Errors
    /// If the target is a folder or read-only, or the file cannot be written.
    pub fn begin(target: &Path) -> Result<Self, Error> {
        let replaced = fs::metadata(target).ok();
        if replaced.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(refused(
                target,
                "cannot write the file: this is a folder",
                OTHER_FILE,
            ));
        }
        if replaced
            .as_ref()
            .is_some_and(|replaced| !replaced.is_file())
        {
            return Ok(Self {
                target: target.to_owned(),
                part: None,
            });
        }
        let target = follow_links(target).map_err(|error| cannot_write_file(target, &error))?;
        let kept = replaced.map(|replaced| replaced.permissions());
        if kept.as_ref().is_some_and(fs::Permissions::readonly) {
            return Err(refused(
                &target,
                "cannot replace the file: it is read-only",
                OTHER_FILE,
            ));
        }
        let part =
            Part::begin(&target, kept).map_err(|error| cannot_write_file(&target, &error))?;
        Ok(Self {
            target,
            part: Some(part),
        })
    }

    /// Writes the contents and moves the file to its target.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, contents: &[u8]) -> Result<(), Error> {
        self.place(contents, |file, target| file.persist(target))
    }

    /// Writes the contents and moves the file to its target, which must not exist.
    ///
    /// # Errors
    /// If the target exists meanwhile, or the file cannot be written.
    pub fn finish_new(self, contents: &[u8]) -> Result<(), Error> {
        self.place(contents, |file, target| file.persist_noclobber(target))
    }

    fn place(
        self,
        contents: &[u8],
        persist: impl FnOnce(NamedTempFile, &Path) -> Result<File, PersistError>,
    ) -> Result<(), Error> {
        let Self { target, part } = self;
        let failed = |error: io::Error| cannot_write_file(&target, &error);
        let Some(Part {
            mut file,
            unfinished,
        }) = part
        else {
            return fs::write(&target, contents).map_err(failed);
        };
        file.write_all(contents).map_err(failed)?;
        let placed = unfinished.place(|| persist(file, &target));
        placed.map_err(|error| match error.error.kind() {
            ErrorKind::AlreadyExists => refused(&target, "it exists already", OTHER_FILE),
            _ => failed(error.error),
        })?;
        Ok(())
    }
}

/// Returns the path behind links, also if no file exists there yet.
fn follow_links(target: &Path) -> io::Result<PathBuf> {
    let mut target = target.to_owned();
    for _ in 0..MAX_LINKS {
        let Ok(next) = fs::read_link(&target) else {
            return Ok(target);
        };
        // A link is relative to its folder.
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other(format!("more than {MAX_LINKS} links")))
}

impl Part {
    /// Begins a file for `target`. `permissions`: those of the replaced file.
    fn begin(target: &Path, permissions: Option<fs::Permissions>) -> io::Result<Self> {
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        // Another process must not take a file that is not locked yet for one that a killed process has left.
        let _turn = File::open(folder).and_then(|folder| folder.lock().map(|()| folder));
        remove_dead_parts(folder);
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        let (file, unfinished) = Unfinished::create(|| {
            let file = new_part(folder, &part_prefix(&name))?;
            let path = UnfinishedPath::Whole(file.path().to_owned());
            io::Result::Ok((file, vec![path]))
        })?;
        if let Some(permissions) = permissions {
            file.as_file().set_permissions(permissions)?;
        }
        // Without locks, a killed process's file stays.
        let _ = file.as_file().try_lock();
        Ok(Self { file, unfinished })
    }
}

/// Makes a file that others may read, as the process's mask of permissions allows.
fn new_part(folder: &Path, prefix: &str) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
        .prefix(prefix)
        .rand_bytes(RANDOM_LEN)
        .suffix(PART_ENDING)
        .tempfile_in(folder)
}

/// Removes the unfinished files of killed processes in a folder. Files that cannot be removed stay.
fn remove_dead_parts(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !is_part_name(&name) {
            continue;
        }
        let path = entry.path();
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_file && File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Returns the begin of the name of an unfinished file for a target's name, which is cut if it is long.
fn part_prefix(name: &str) -> String {
    let end = name.floor_char_boundary(MAX_PART_NAME);
    format!(".{}{PART_MARK}", &name[..end])
}

/// Whether a file has the name of an unfinished file of this program.
fn is_part_name(name: &str) -> bool {
    let name = name
        .strip_suffix(PART_ENDING)
        .and_then(|name| name.strip_prefix('.'));
    name.and_then(|name| name.rsplit_once(PART_MARK))
        .is_some_and(|(_, random)| {
            random.len() == RANDOM_LEN && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
        })
}

/// A folder that is written aside and appears at its target complete or not at all. An interruption removes it; if the
/// process is killed, the next folder for the same target does.
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

const OTHER_FILE: &str = "choose another file";
const OTHER_FOLDER: &str = "choose another folder with --out";
const MOVE_AWAY: &str = "choose another folder with --out, or move this one away";

fn refused(path: &Path, problem: impl ToString, help: &'static str) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem: problem.to_string(),
        help,
    }
}

fn cannot_write_file(path: &Path, error: &io::Error) -> Error {
    refused(path, format!("cannot write there: {error}"), OTHER_FILE)
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

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_that_is_written_aside_removes_only_those_of_dead_processes() {
        let folder = tempfile::tempdir().expect("a folder");
        let living = OutputFile::begin(&folder.path().join("a.txt")).expect("a file");
        let [of_living] = &names(folder.path())[..] else {
            panic!("one file");
        };
        let of_others = [
            ".a.wisch-x1y2.z.part",
            ".b.txt.x1y2z3.part",
            ".cache.sqlite.part",
            ".notes.part",
        ];
        for name in of_others.iter().chain(&[".b.txt.wisch-x1y2z3.part"]) {
            fs::write(folder.path().join(name), "half").expect("a file");
        }
        let dropped = OutputFile::begin(&folder.path().join("c.txt")).expect("a file");
        assert_eq!(names(folder.path()).len(), of_others.len() + 2);
        assert!(folder.path().join(of_living).exists());
        drop(dropped);
        living.finish(b"whole").expect("in place");
        let left = names(folder.path());
        assert_eq!(left[..of_others.len()], of_others);
        assert_eq!(left[of_others.len()..], ["a.txt"]);
    }

    #[test]
    fn a_file_with_the_longest_name_is_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let name = format!("a{}", "é".repeat(127));
        let begun = OutputFile::begin(&folder.path().join(&name)).expect("a file");
        begun.finish(b"whole").expect("in place");
        assert_eq!(names(folder.path()), [name]);
    }

    #[test]
    fn a_new_file_replaces_none_that_appears_meanwhile() {
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("a.txt");
        let begun = OutputFile::begin(&target).expect("a file");
        fs::write(&target, "of another program").expect("a file");
        let error = begun.finish_new(b"new").expect_err("it exists");
        assert!(error.to_string().contains("it exists already"), "{error}");
        assert_eq!(fs::read(&target).expect("a file"), b"of another program");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_replaced_file_keeps_its_permissions_and_a_read_only_one_its_contents() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("a.txt");
        fs::write(&target, "old").expect("a file");
        let allow = |mode| {
            fs::set_permissions(&target, fs::Permissions::from_mode(mode)).expect("permissions");
        };
        allow(0o600);
        let begun = OutputFile::begin(&target).expect("a file");
        begun.finish(b"new").expect("in place");
        let mode = fs::metadata(&target).expect("a file").permissions().mode();
        assert_eq!(mode & 0o777, 0o600);
        allow(0o444);
        let Err(error) = OutputFile::begin(&target) else {
            panic!("it is read-only");
        };
        assert!(error.to_string().contains("read-only"), "{error}");
        assert_eq!(names(folder.path()), ["a.txt"]);
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

    #[cfg(unix)]
    #[test]
    fn links_and_devices_are_written_and_not_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [link, file] = ["link", "file"].map(|name| folder.path().join(name));
        fs::write(&file, "old").expect("a file");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        let begun = OutputFile::begin(&link).expect("a file");
        begun.finish(b"new").expect("in place");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"new");
        // Also if the link shows where the file will be.
        fs::remove_file(&file).expect("a file");
        std::os::unix::fs::symlink("link", folder.path().join("second")).expect("a link");
        let begun = OutputFile::begin(&folder.path().join("second")).expect("a file");
        begun.finish(b"first").expect("in place");
        assert!(link.is_symlink() && !file.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"first");
        let null = Path::new("/dev/null");
        let begun = OutputFile::begin(null).expect("a device");
        begun.finish(b"new").expect("written");
        assert!(!null.is_file());
    }
}
