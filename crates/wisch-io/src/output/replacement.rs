//! Replaces one folder by another, atomically if the system supports it; the next run completes an interrupted replacement.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The new results, complete or not.
pub(super) const NEW: &str = "new";
/// The earlier contents of the target, on systems that cannot exchange two folders.
const OLD: &str = "old";
/// File that marks complete results; it identifies their folder.
const WHOLE: &str = "whole";

/// Moves `new` of a staging folder to the target. The earlier contents stay in the staging folder.
///
/// # Errors
/// If the folders cannot be moved; the target is then unchanged.
pub(super) fn put_in_place(staging: &Path, target: &Path) -> io::Result<()> {
    let new = staging.join(NEW);
    if let Some(identity) = identity(&new)? {
        fs::write(staging.join(WHOLE), identity)?;
    }
    if !target.exists() {
        return fs::rename(&new, target);
    }
    match exchange(&new, target) {
        Err(error) if error.kind() == ErrorKind::Unsupported => replace(staging, target),
        exchanged => exchanged,
    }
}

/// Replaces by two renames. After a kill between them, the target is missing until [`complete`] is called.
fn replace(staging: &Path, target: &Path) -> io::Result<()> {
    let (new, old) = (staging.join(NEW), staging.join(OLD));
    fs::rename(target, &old)?;
    fs::rename(new, target).inspect_err(|_| {
        // If this fails, too, the first error is reported.
        let _ = fs::rename(&old, target);
    })
}

/// The state of a replacement that a kill interrupted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Left {
    /// The results were incomplete, or not at the target.
    Unfinished,
    /// The results are at the target.
    Finished,
}

/// Completes a killed run's replacement: if the target is missing, restores the earlier contents, or moves the new results
/// there if they are complete.
///
/// # Errors
/// If a folder cannot be moved.
pub(super) fn complete(staging: &Path, target: &Path) -> io::Result<Left> {
    let (new, old) = (staging.join(NEW), staging.join(OLD));
    let whole = match fs::read_to_string(staging.join(WHOLE)) {
        Ok(text) => Some(text),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    if whole.is_some() && identity(target)? == whole {
        return Ok(Left::Finished);
    }
    if old.is_dir() && !target.exists() {
        if whole.is_some() && identity(&new)? == whole {
            fs::rename(&new, target)?;
            return Ok(Left::Finished);
        }
        fs::rename(&old, target)?;
    }
    Ok(Left::Unfinished)
}

/// Returns a folder's identity, which survives moves; `None` if there is no folder or the system has no identities.
fn identity(folder: &Path) -> io::Result<Option<String>> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        match fs::metadata(folder) {
            Ok(meta) => Ok(Some(format!("{}:{}", meta.dev(), meta.ino()))),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }
    #[cfg(not(unix))]
    {
        let _ = folder;
        Ok(None)
    }
}

/// Exchanges two folders.
///
/// # Errors
/// [`ErrorKind::Unsupported`] if the system cannot exchange folders, or another system error.
#[cfg(target_os = "linux")]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    match renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(()),
        Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => Err(ErrorKind::Unsupported.into()),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(target_os = "linux"))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(ErrorKind::Unsupported.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    /// A target with old results, and a staging folder with new ones.
    fn folders() -> (tempfile::TempDir, PathBuf, PathBuf) {
        let parent = tempfile::tempdir().expect("a folder");
        let (staging, target) = (parent.path().join(".out.a"), parent.path().join("out"));
        fs::create_dir_all(staging.join(NEW)).expect("a folder");
        fs::create_dir(&target).expect("a folder");
        fs::write(target.join("is"), "old").expect("a file");
        fs::write(staging.join("new/is"), "new").expect("a file");
        (parent, staging, target)
    }

    fn found(target: &Path) -> String {
        fs::read_to_string(target.join("is")).unwrap_or_else(|_| "nothing".to_owned())
    }

    #[test]
    fn new_results_replace_old_ones_with_and_without_exchange() {
        let (_parent, staging, target) = folders();
        put_in_place(&staging, &target).expect("in place");
        assert_eq!(found(&target), "new");
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Finished
        );

        let (_parent, staging, target) = folders();
        replace(&staging, &target).expect("in place");
        assert_eq!(
            (found(&target), found(&staging.join(OLD))),
            ("new".into(), "old".into())
        );
    }

    #[test]
    fn a_kill_at_any_moment_loses_neither_old_nor_new_results() {
        // A kill before the new results are complete: the old ones are at the target.
        let (_parent, staging, target) = folders();
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Unfinished
        );
        assert_eq!(found(&target), "old");

        // A kill between the two renames: the new results are complete.
        let (_parent, staging, target) = folders();
        let whole = identity(&staging.join(NEW))
            .expect("a folder")
            .expect("a folder");
        fs::write(staging.join(WHOLE), whole).expect("a file");
        fs::rename(&target, staging.join(OLD)).expect("moved");
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Finished
        );
        assert_eq!(found(&target), "new");

        // The same without the mark that the new results are complete.
        let (_parent, staging, target) = folders();
        fs::rename(&target, staging.join(OLD)).expect("moved");
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Unfinished
        );
        assert_eq!(found(&target), "old");
    }
}
