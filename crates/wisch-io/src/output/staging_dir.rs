//! The hidden staging folder in which results are written, and the staging folders of killed runs.

use super::replacement::{Left, complete};
use super::{Unfinished, UnfinishedPath};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// Lock file of the process that works in the folder; the system releases the lock when the process ends.
const LOCK_FILE: &str = "lock";

/// The treatment of a killed run's staging folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Leftover {
    /// Remove it.
    Remove,
    /// Take over the newest one and remove the others.
    TakeOver,
}

/// What killed runs left for a target.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KilledRuns {
    /// Removed folders.
    pub removed: Vec<PathBuf>,
    /// Whether a folder was taken over.
    pub is_taken_over: bool,
    /// Whether a run was killed after its results had reached their target.
    pub is_finished: bool,
}

/// A hidden folder beside a target, on the same file system. It is removed when dropped. A folder
/// that was taken over from a killed run is removed only after the results have reached their
/// target: until then the run can be resumed.
#[derive(Debug)]
pub(super) struct StagingDir {
    path: PathBuf,
    removes: bool,
    _lock: File,
    /// `None` for a folder of a killed run. Dropped after the folder is removed.
    unfinished: Option<Unfinished>,
}

impl StagingDir {
    /// Makes a staging folder for the results `name` in `parent`, whose path is `target`, and returns the leftovers of
    /// killed runs. An interrupted replacement of the target is completed first.
    ///
    /// # Errors
    /// [`io::ErrorKind::ResourceBusy`] if a running process writes results to the same target, or a system error.
    pub fn begin(
        parent: &Path,
        name: &str,
        leftover: Leftover,
        target: &Path,
    ) -> io::Result<(Self, KilledRuns)> {
        let prefix = format!(".{name}.");
        // Of two simultaneous processes, the first locks its folder before the other checks. If folders cannot be locked,
        // both may see each other and fail.
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
        let taken = taken.map(|mut place| {
            place.removes = false;
            place
        });
        let removed = dead.iter().map(|place| place.path.clone()).collect();
        // Removed when dropped.
        drop(dead);
        let found = KilledRuns {
            removed,
            is_taken_over: taken.is_some(),
            is_finished,
        };
        let place = match taken {
            Some(place) => place,
            None => Self::new(parent, &prefix)?,
        };
        // Checked while holding the own lock: of two simultaneous processes, at most one continues.
        let (_, living) = staging_dirs(parent, &prefix)?;
        if living.iter().any(|other| *other != place.path) {
            return Err(io::ErrorKind::ResourceBusy.into());
        }
        Ok((place, found))
    }

    fn new(parent: &Path, prefix: &str) -> io::Result<Self> {
        loop {
            let (path, unfinished) = Unfinished::create(|| {
                let folder = tempfile::Builder::new().prefix(prefix).tempdir_in(parent)?;
                let path = folder.keep();
                io::Result::Ok((path.clone(), vec![UnfinishedPath::Whole(path)]))
            })?;
            let lock = File::create(path.join(LOCK_FILE))?;
            lock.lock()?;
            let mut place = Self::locked(path, lock);
            place.unfinished = Some(unfinished);
            // Between creating and locking, another process may have removed the folder as a leftover.
            if place.path.join(LOCK_FILE).is_file() {
                return Ok(place);
            }
        }
    }

    fn locked(path: PathBuf, lock: File) -> Self {
        Self {
            path,
            removes: true,
            _lock: lock,
            unfinished: None,
        }
    }

    /// Moves its contents to their place, and removes the folder, also one that was taken over.
    ///
    /// # Errors
    /// The error of `moved`; then a folder that was taken over stays.
    pub fn place(mut self, moved: impl FnOnce(&Path) -> io::Result<()>) -> io::Result<()> {
        match self.unfinished.take() {
            Some(unfinished) => unfinished.place(|| moved(&self.path)),
            None => moved(&self.path),
        }?;
        self.removes = true;
        Ok(())
    }

    /// Lets an interruption keep the folder from now on.
    pub fn keep_if_interrupted(&self) {
        if let Some(unfinished) = &self.unfinished {
            unfinished.keep();
        }
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for StagingDir {
    fn drop(&mut self) {
        if self.removes {
            // If removal fails, the next run finds the folder.
            let _ = fs::remove_dir_all(&self.path);
        }
    }
}

/// Returns the newest staging folder beside a target, whether or not a process works in it.
pub(super) fn find_newest(parent: &Path, name: &str) -> Option<PathBuf> {
    let prefix = format!(".{name}.");
    let folders = fs::read_dir(parent).ok()?.filter_map(|entry| {
        let path = entry.ok()?.path();
        let name = path.file_name()?.to_str()?;
        let rest = name.strip_prefix(&prefix)?;
        let is_ours = !rest.is_empty() && rest.chars().all(char::is_alphanumeric);
        let lock = is_ours.then(|| fs::metadata(path.join(LOCK_FILE)))?.ok()?;
        Some((lock.modified().ok()?, path))
    });
    folders.max().map(|(_, path)| path)
}

/// Returns the unlocked staging folders, which this process has locked, the newest last; and those locked by others.
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
                dead.push((modified, StagingDir::locked(path, lock)));
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
        // An error leaves it for the next attempt, and only results remove it.
        drop(place);
        assert!(dead.exists());
        let target = parent.path().join("board");
        let again = StagingDir::begin(parent.path(), "board", Leftover::TakeOver, &target);
        let (place, _) = again.expect("a staging folder");
        place.place(|_| Ok(())).expect("in place");
        assert!(!dead.exists());
    }
}
