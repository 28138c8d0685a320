//! Limits of a statement: time, memory, and depth of its text.

use super::statement::depth;
use crate::store::FleetError;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Largest depth of a statement. A thread's stack of [`STACK`] holds the planner's recursion over it.
const DEEPEST: usize = 1000;
/// Stack of each thread that plans or answers statements [bytes]. The system allocates only the part that is used.
pub const STACK: usize = 256 << 20;
/// Interval of the checks of time and memory.
const LOOK_AGAIN: Duration = Duration::from_millis(20);
/// The program is ended this long after a statement's time limit, if the statement does not end by itself.
const GRACE: Duration = Duration::from_secs(5);
/// Exit code of an error.
const EXIT_ERROR: i32 = 2;

/// Limits of a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SqlLimits {
    /// Longest time from planning to the last row.
    pub time: Duration,
    /// Largest memory of the program [bytes]. Half of it is for sorting, grouping and joining; sorting and grouping
    /// beyond that use the disk.
    pub memory: usize,
}

impl Default for SqlLimits {
    fn default() -> Self {
        Self {
            time: Duration::from_secs(300),
            memory: 4096 << 20,
        }
    }
}

impl SqlLimits {
    /// Memory for sorting, grouping and joining [bytes].
    pub(super) fn pool(&self) -> usize {
        self.memory / 2
    }

    /// Runs a statement within its time limit.
    ///
    /// # Errors
    /// The error of the statement, or that its time is over.
    pub async fn within<T>(
        &self,
        work: impl Future<Output = Result<T, FleetError>>,
    ) -> Result<T, FleetError> {
        match tokio::time::timeout(self.time, work).await {
            Ok(done) => done,
            Err(_) => Err(FleetError::Asked(self.time_error())),
        }
    }

    fn time_error(&self) -> String {
        let limit = self.time.as_secs_f64();
        format!("the statement takes longer than the limit of {limit} s; --timeout raises it")
    }

    fn memory_error(&self) -> String {
        let limit = self.memory >> 20;
        format!(
            "the statement takes more memory than the limit of {limit} MB; --memory-limit raises it"
        )
    }
}

/// Checks that a statement is not too deep for the planner.
///
/// # Errors
/// If the statement is too deep.
pub(super) fn check(sql: &str) -> Result<(), FleetError> {
    let found = depth(sql);
    if found <= DEEPEST {
        return Ok(());
    }
    Err(FleetError::Asked(format!(
        "the statement has {found} operators, brackets and joined tables, at most {DEEPEST} are planned: \
         use IN (…) for long lists, or several statements"
    )))
}

/// Watchdog that ends the program with an error once a statement exceeds a limit. Memory of row functions is in no
/// pool, and a computation that never waits cannot be cancelled.
#[derive(Debug)]
pub struct LimitWatch {
    limits: SqlLimits,
    begun: Instant,
    /// Deadline of the current statement [ms since `begun`]; 0 for none.
    deadline: AtomicU64,
    /// Folders that are removed with the program.
    folders: Mutex<Vec<PathBuf>>,
}

impl LimitWatch {
    /// Starts watching this program.
    pub fn begin(limits: SqlLimits) -> Arc<Self> {
        let watch = Arc::new(Self {
            limits,
            begun: Instant::now(),
            deadline: AtomicU64::new(0),
            folders: Mutex::default(),
        });
        let watching = Arc::clone(&watch);
        thread::spawn(move || watching.watch());
        watch
    }

    /// Registers a folder that is removed if the program is ended.
    pub fn remove_at_end(&self, folder: PathBuf) {
        self.folders().push(folder);
    }

    /// Runs a statement within its limits.
    ///
    /// # Errors
    /// The error of the statement, or that its time is over.
    pub async fn within<T>(
        &self,
        work: impl Future<Output = Result<T, FleetError>>,
    ) -> Result<T, FleetError> {
        let deadline = self.begun.elapsed() + self.limits.time + GRACE;
        let deadline = u64::try_from(deadline.as_millis()).unwrap_or(u64::MAX);
        self.deadline.store(deadline, Ordering::Relaxed);
        let done = self.limits.within(work).await;
        self.deadline.store(0, Ordering::Relaxed);
        done
    }

    fn watch(&self) {
        loop {
            thread::sleep(LOOK_AGAIN);
            let deadline = self.deadline.load(Ordering::Relaxed);
            if deadline == 0 {
                continue;
            }
            let what = if self.begun.elapsed() > Duration::from_millis(deadline) {
                self.limits.time_error()
            } else if resident().is_some_and(|bytes| bytes > self.limits.memory) {
                self.limits.memory_error()
            } else {
                continue;
            };
            for folder in self.folders().iter() {
                let _ = std::fs::remove_dir_all(folder);
            }
            eprintln!("error: {what}");
            std::process::exit(EXIT_ERROR);
        }
    }

    fn folders(&self) -> std::sync::MutexGuard<'_, Vec<PathBuf>> {
        self.folders.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the present memory of this program [bytes], where the system reports it.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kilobytes: usize = line.trim().strip_suffix(" kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_statement_that_is_too_deep_is_refused_with_its_depth() {
        let chain = |links: usize| format!("SELECT 1{}", "+1".repeat(links));
        assert!(check(&chain(999)).is_ok());
        let error = check(&chain(1000)).unwrap_err().to_string();
        assert!(
            error.contains("1001") && error.contains("at most 1000"),
            "{error}"
        );
    }

    #[tokio::test]
    async fn a_statement_beyond_its_time_is_cancelled() {
        let limits = SqlLimits {
            time: Duration::from_millis(10),
            ..SqlLimits::default()
        };
        let error = limits
            .within(std::future::pending::<Result<(), FleetError>>())
            .await;
        let error = error.unwrap_err().to_string();
        assert!(
            error.contains("0.01 s") && error.contains("--timeout"),
            "{error}"
        );
        assert!(
            limits
                .within(async { Ok(1) })
                .await
                .is_ok_and(|one| one == 1)
        );
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn memory_is_measured() {
        let before = resident().unwrap();
        let large = vec![1_u8; 64 << 20];
        assert!(resident().unwrap() > before + (32 << 20));
        assert!(large.iter().all(|byte| *byte == 1));
    }
}
