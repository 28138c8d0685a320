//! One folder takes the place of another, at once where the system can; what a kill interrupts is completed later.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The results, whole or in the making.
pub(super) const NEW: &str = "new";
/// What stood at the target, on systems that cannot exchange two folders.
const OLD: &str = "old";
/// Written when the results are whole: which folder they are.
const WHOLE: &str = "whole";

/// Puts `new` of a staging folder at the target. What stood there stays in the staging folder.
///
/// # Errors
/// What the system says; then what stood there stands there still.
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

/// By two renames: killed between them, the target is missing until [`complete`] is called.
fn replace(staging: &Path, target: &Path) -> io::Result<()> {
    let (new, old) = (staging.join(NEW), staging.join(OLD));
    fs::rename(target, &old)?;
    fs::rename(new, target).inspect_err(|_| {
        // If even this fails, the first error is the one to tell.
        let _ = fs::rename(&old, target);
    })
}

/// What a killed run had done when it was killed while its results were put in place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Left {
    /// Its results were not whole yet, or not in place.
    Unfinished,
    /// Its results stand at the target.
    Finished,
}

/// Sees to the target of a killed run: where it is missing, what stood there comes back, or the new results if they are whole.
///
/// # Errors
/// What the system says.
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

/// What tells a folder from all others, wherever it is moved; `None` where there is no such folder, or nothing tells it.
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

/// Lets two folders change places.
///
/// # Errors
/// [`ErrorKind::Unsupported`] where the system cannot, and what else it says.
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
        // Before the new ones are whole: the old ones stand there.
        let (_parent, staging, target) = folders();
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Unfinished
        );
        assert_eq!(found(&target), "old");

        // Between the two renames: the new ones were whole.
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

        // The same by a program that did not say that they were whole.
        let (_parent, staging, target) = folders();
        fs::rename(&target, staging.join(OLD)).expect("moved");
        assert_eq!(
            complete(&staging, &target).expect("seen to"),
            Left::Unfinished
        );
        assert_eq!(found(&target), "old");
    }
}
