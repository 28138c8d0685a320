//! Files and folders that are not at their targets yet, which an interrupted program removes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

/// The files and folders that this process would leave behind if it ended now, by a number.
static UNFINISHED: Mutex<Register> = Mutex::new(Register {
    next: 0,
    paths: BTreeMap::new(),
});

struct Register {
    next: u64,
    paths: BTreeMap<u64, Vec<UnfinishedPath>>,
}

/// A path that an interruption removes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnfinishedPath {
    /// A file, or a folder with its contents.
    Whole(PathBuf),
    /// A folder that is removed only if it is empty.
    EmptyFolder(PathBuf),
}

/// Longest wait of an interruption for a file that is created or moved meanwhile: a file system may block it.
const PATIENCE: Duration = Duration::from_secs(2);
/// Period at which the wait tries again.
const PERIOD: Duration = Duration::from_millis(20);

fn register() -> MutexGuard<'static, Register> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Locks the register; `None` if that takes longer than [`PATIENCE`].
fn try_register() -> Option<MutexGuard<'static, Register>> {
    let begin = Instant::now();
    loop {
        match UNFINISHED.try_lock() {
            Ok(all) => return Some(all),
            Err(TryLockError::Poisoned(all)) => return Some(all.into_inner()),
            Err(TryLockError::WouldBlock) if begin.elapsed() < PATIENCE => {
                std::thread::sleep(PERIOD);
            }
            Err(TryLockError::WouldBlock) => return None,
        }
    }
}

/// Files and folders that are not at their targets yet, which [`remove_unfinished`] removes while
/// this guard exists.
///
/// ```
/// use wisch_io::{Unfinished, UnfinishedPath};
/// # let folder = tempfile::tempdir()?;
/// # let (aside, target) = (folder.path().join(".a.part"), folder.path().join("a"));
/// let unfinished = Unfinished::create(|| {
///     std::fs::write(&aside, "half")?;
///     Ok::<_, std::io::Error>(((), vec![UnfinishedPath::Whole(aside.clone())]))
/// })?
/// .1;
/// unfinished.place(|| std::fs::rename(&aside, &target))?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Unfinished(u64);

impl Unfinished {
    /// Creates files or folders, and guards the returned paths. An interruption comes before or after it, not in between.
    ///
    /// # Errors
    /// The error of `create`.
    pub fn create<T, E>(
        create: impl FnOnce() -> Result<(T, Vec<UnfinishedPath>), E>,
    ) -> Result<(T, Self), E> {
        let mut all = register();
        let (created, paths) = create()?;
        let number = all.next;
        all.next += 1;
        all.paths.insert(number, paths);
        Ok((created, Self(number)))
    }

    /// Moves the files or folders to their place. An interruption comes before or after it, not in between.
    ///
    /// # Errors
    /// The error of `moved`.
    pub fn place<T, E>(self, moved: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        let mut all = register();
        let moved = moved();
        all.paths.remove(&self.0);
        drop(all);
        moved
    }

    /// Lets an interruption keep the paths from now on.
    pub fn keep(&self) {
        register().paths.remove(&self.0);
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        self.keep();
    }
}

/// Removes what is unfinished, before the program ends because of a signal. Folders are removed with their contents.
///
/// From now on, another thread that creates or finishes a file waits for ever: call it only before the process exits. If such
/// a thread takes longer than 2 s, nothing is removed, and the next command removes what is left.
pub fn remove_unfinished() {
    let Some(all) = try_register() else {
        return;
    };
    let paths = || all.paths.values().flatten();
    for path in paths() {
        if let UnfinishedPath::Whole(path) = path {
            remove_whole(path);
        }
    }
    for path in paths() {
        if let UnfinishedPath::EmptyFolder(path) = path {
            // Folders with contents stay.
            let _ = fs::remove_dir(path);
        }
    }
    std::mem::forget(all);
}

fn remove_whole(path: &Path) {
    // A thread that still writes into a folder may add a file meanwhile. The next command removes what is left.
    let remove = || fs::remove_dir_all(path).or_else(|_| fs::remove_file(path));
    let _ = remove().or_else(|_| remove());
}
