//! The hidden folder in which results are made, and those that killed runs left beside them.

use super::replacement::{Left, complete};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// Held by whoever works in the folder: the system gives it back when a process ends, however it ends.
const LOCK_FILE: &str = "lock";

/// What becomes of what a killed run left behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Leftover {
    /// It is removed.
    Remove,
    /// The newest of it is taken over, the rest removed.
    TakeOver,
}

/// What was found of killed runs.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Found {
    /// Folders that were removed.
    pub removed: Vec<PathBuf>,
    /// Whether one was taken over.
    pub is_taken_over: bool,
    /// Whether a run was killed after its results had come to their place.
    pub is_finished: bool,
}

/// A hidden folder beside a target, on the same file system. Dropped, it is removed.
#[derive(Debug)]
pub(super) struct StagingDir {
    path: PathBuf,
    _lock: File,
}

impl StagingDir {
    /// A staging folder for what is to be called `name` in `parent` and stand at `target`, and what was there of dead runs.
    /// What a kill interrupted while it was put at the target is completed.
    ///
    /// # Errors
    /// [`io::ErrorKind::ResourceBusy`] if a living run makes results of that name, and what the system says.
    pub fn begin(
        parent: &Path,
        name: &str,
        leftover: Leftover,
        target: &Path,
    ) -> io::Result<(Self, Found)> {
        let prefix = format!(".{name}.");
        // Of two that begin at once, the first one holds its folder before the other looks. Where folders cannot be
        // locked, both may see each other and give way.
        let _turn = File::open(parent).and_then(|folder| folder.lock().map(|()| folder));
        let (all, _) = staging_dirs(parent, &prefix)?;
        let (mut dead, mut finished) = (Vec::new(), Vec::new());
        for place in all {
            match complete(place.path(), target)? {
                Left::Unfinished => dead.push(place),
                Left::Finished => finished.push(place),
            }
        }
        let is_finished = !finished.is_empty();
        drop(finished);
        let taken = match leftover {
            Leftover::Remove => None,
            Leftover::TakeOver => dead.pop(),
        };
        let removed = dead.iter().map(|place| place.path.clone()).collect();
        // Removed when dropped.
        drop(dead);
        let found = Found {
            removed,
            is_taken_over: taken.is_some(),
            is_finished,
        };
        let place = match taken {
            Some(place) => place,
            None => Self::new(parent, &prefix)?,
        };
        // Looked at with the own lock held: of two that begin at once, at most one goes on.
        let (_, living) = staging_dirs(parent, &prefix)?;
        if living.iter().any(|other| *other != place.path) {
            return Err(io::ErrorKind::ResourceBusy.into());
        }
        Ok((place, found))
    }

    fn new(parent: &Path, prefix: &str) -> io::Result<Self> {
        loop {
            let folder = tempfile::Builder::new().prefix(prefix).tempdir_in(parent)?;
            let path = folder.keep();
            let lock = File::create(path.join(LOCK_FILE))?;
            lock.lock()?;
            let place = Self { path, _lock: lock };
            // Between creating and locking, somebody may have taken it for left behind.
            if place.path.join(LOCK_FILE).is_file() {
                return Ok(place);
            }
        }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for StagingDir {
    fn drop(&mut self) {
        // What cannot be removed stays, and is found by the next run.
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// Staging folders that no living process held, now held by this one, the newest last; and those that one holds.
fn staging_dirs(parent: &Path, prefix: &str) -> io::Result<(Vec<StagingDir>, Vec<PathBuf>)> {
    let (mut dead, mut living) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(parent)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let is_ours = (name.strip_prefix(prefix))
            .is_some_and(|rest| !rest.is_empty() && rest.chars().all(char::is_alphanumeric));
        let path = entry.path();
        let lock = match File::options().write(true).open(path.join(LOCK_FILE)) {
            Ok(lock) if is_ours => lock,
            Err(error) if is_ours && error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => continue,
        };
        match lock.try_lock() {
            Ok(()) => {
                let modified = lock.metadata()?.modified()?;
                dead.push((modified, StagingDir { path, _lock: lock }));
            }
            Err(TryLockError::WouldBlock) => living.push(path),
            Err(TryLockError::Error(error)) => return Err(error),
        }
    }
    dead.sort_by(|a, b| (a.0, &a.1.path).cmp(&(b.0, &b.1.path)));
    let dead = dead.into_iter().map(|(_, place)| place).collect();
    Ok((dead, living))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;

    fn left_behind(parent: &Path, name: &str) -> PathBuf {
        let path = parent.join(name);
        fs::create_dir(&path).expect("a folder");
        fs::write(path.join(LOCK_FILE), "").expect("a file");
        path
    }

    #[test]
    fn only_what_nobody_holds_is_removed() {
        let parent = tempfile::tempdir().expect("a folder");
        let dead = left_behind(parent.path(), ".board.abc123");
        let others = left_behind(parent.path(), ".board.two.abc123");
        let foreign = parent.path().join(".board.xyz");
        fs::create_dir(&foreign).expect("a folder");
        let (living, found) = StagingDir::begin(
            parent.path(),
            "board",
            Leftover::Remove,
            &parent.path().join("board"),
        )
        .expect("a staging folder");
        assert_eq!(found.removed, std::slice::from_ref(&dead));
        assert!(!dead.exists() && others.exists() && foreign.exists());

        for leftover in [Leftover::TakeOver, Leftover::Remove] {
            let error = StagingDir::begin(
                parent.path(),
                "board",
                leftover,
                &parent.path().join("board"),
            );
            let error = error.expect_err("the first is held");
            assert_eq!(error.kind(), io::ErrorKind::ResourceBusy);
        }
        assert_eq!(fs::read_dir(parent.path()).expect("a folder").count(), 3);
        let path = living.path().to_path_buf();
        drop(living);
        assert!(!path.exists());
    }

    #[test]
    fn of_two_that_begin_at_once_one_goes_on() {
        let parent = tempfile::tempdir().expect("a folder");
        for leftover in [Leftover::Remove, Leftover::TakeOver] {
            for _ in 0..100 {
                let together = Barrier::new(2);
                let begin = || {
                    together.wait();
                    let begun = StagingDir::begin(
                        parent.path(),
                        "board",
                        leftover,
                        &parent.path().join("board"),
                    );
                    together.wait();
                    begun.map(drop).map_err(|error| error.kind())
                };
                let mut begun = std::thread::scope(|scope| {
                    let threads = [(); 2].map(|()| scope.spawn(begin));
                    threads.map(|thread| thread.join().expect("no panic"))
                });
                begun.sort();
                assert_eq!(begun, [Ok(()), Err(io::ErrorKind::ResourceBusy)]);
            }
        }
    }

    #[test]
    fn what_a_dead_run_left_is_taken_over() {
        let parent = tempfile::tempdir().expect("a folder");
        let dead = left_behind(parent.path(), ".board.abc123");
        let (place, found) = StagingDir::begin(
            parent.path(),
            "board",
            Leftover::TakeOver,
            &parent.path().join("board"),
        )
        .expect("a staging folder");
        assert!(found.is_taken_over && found.removed.is_empty());
        assert_eq!(place.path(), dead);
    }
}
