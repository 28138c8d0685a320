//! Files and folders that are written aside and not in place yet, which an interrupted program removes.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What this process would leave behind if it ended now, by a number.
static UNFINISHED: Mutex<Register> = Mutex::new(Register {
    next: 0,
    paths: BTreeMap::new(),
});

struct Register {
    next: u64,
    paths: BTreeMap<u64, Vec<PathBuf>>,
}

fn register() -> MutexGuard<'static, Register> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Files and folders that are written aside, which [`remove_unfinished`] removes while this guard exists.
///
/// ```
/// use wisch_io::Unfinished;
/// # let folder = tempfile::tempdir()?;
/// # let (aside, target) = (folder.path().join(".a.part"), folder.path().join("a"));
/// let unfinished = Unfinished::create(|| {
///     std::fs::write(&aside, "half")?;
///     Ok::<_, std::io::Error>(((), vec![aside.clone()]))
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
        create: impl FnOnce() -> Result<(T, Vec<PathBuf>), E>,
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

/// Removes what is unfinished, before the program ends because of a signal. Folders are removed with their contents; a path
/// with a trailing `/` only if it is empty.
///
/// From now on, another thread that creates or finishes a file waits for ever: call it only before the process exits.
pub fn remove_unfinished() {
    let all = register();
    let is_parent = |path: &PathBuf| path.to_string_lossy().ends_with('/');
    let (parents, paths): (Vec<&PathBuf>, Vec<&PathBuf>) = all
        .paths
        .values()
        .flatten()
        .partition(|path| is_parent(path));
    for path in paths {
        // A thread that still writes into a folder may add a file meanwhile. The next command removes what is left.
        let remove = || fs::remove_dir_all(path).or_else(|_| fs::remove_file(path));
        let _ = remove().or_else(|_| remove());
    }
    for path in parents {
        // Folders with contents stay.
        let _ = fs::remove_dir(path);
    }
    std::mem::forget(all);
}
