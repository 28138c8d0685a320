//! Watchdog that interrupts an executor which passes no samples.

use crate::error::plain;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Interval of the checks.
const LOOK: Duration = Duration::from_millis(5);
/// Time that an interrupted executor has to stop, beyond the limit.
const TIME_TO_STOP: Duration = Duration::from_secs(5);
/// Longest pause of a motion: a year.
const LONGEST_PAUSE: Duration = Duration::from_secs(31_557_600);

/// Watchdog of one call of an executor: interrupts its thread as Ctrl-C does, when no sample arrives for too long.
pub struct Watchdog {
    limit: Duration,
    shared: Arc<Shared>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

struct Shared {
    last: Mutex<Instant>,
    is_over: AtomicBool,
    has_fired: AtomicBool,
}

impl Shared {
    fn last(&self) -> Instant {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Watchdog {
    /// Starts watching; returns `None` without a limit.
    pub fn begin(py: Python<'_>, limit: Option<Duration>) -> PyResult<Option<Self>> {
        let Some(limit) = limit else {
            return Ok(None);
        };
        let threading = py.import("threading")?;
        let ident: u64 = threading.call_method0("get_ident")?.extract()?;
        let main = threading.call_method0("main_thread")?;
        let is_main = main.getattr("ident")?.extract::<u64>()? == ident;
        let shared = Arc::new(Shared {
            last: Mutex::new(Instant::now()),
            is_over: AtomicBool::new(false),
            has_fired: AtomicBool::new(false),
        });
        let watched = Arc::clone(&shared);
        let thread = std::thread::spawn(move || {
            while !watched.is_over.load(Ordering::SeqCst) {
                std::thread::sleep(LOOK);
                if watched.last().elapsed() < limit {
                    continue;
                }
                Python::attach(|py| {
                    // The call may have ended while this thread waited for the lock.
                    if !watched.is_over.load(Ordering::SeqCst) {
                        watched.has_fired.store(true, Ordering::SeqCst);
                        let _ = interrupt(py, ident, is_main);
                    }
                });
                // An executor that catches the interrupt gets another, but first has time to stop its robot.
                let next = Instant::now() + TIME_TO_STOP;
                *watched.last.lock().unwrap_or_else(PoisonError::into_inner) = next;
            }
        });
        Ok(Some(Self {
            limit,
            shared,
            thread: Mutex::new(Some(thread)),
        }))
    }

    /// Records a sign of life.
    pub fn touch(&self) {
        *(self.shared.last.lock()).unwrap_or_else(PoisonError::into_inner) = Instant::now();
    }

    /// Ignores silence until the next sign of life, because the motion is paused.
    pub fn suspend(&self) {
        let later = Instant::now().checked_add(LONGEST_PAUSE);
        if let Some(later) = later {
            *(self.shared.last.lock()).unwrap_or_else(PoisonError::into_inner) = later;
        }
    }

    /// Stops watching. Returns the result of the call, or the error that it took too long, naming what is missing.
    pub fn end<T>(&self, py: Python<'_>, result: PyResult<T>, missing: &str) -> PyResult<T> {
        self.shared.is_over.store(true, Ordering::SeqCst);
        let thread = (self.thread.lock().unwrap_or_else(PoisonError::into_inner)).take();
        py.detach(|| thread.map(JoinHandle::join));
        if !self.shared.has_fired.load(Ordering::SeqCst) {
            return result;
        }
        // A late interrupt must not be taken for the user's Ctrl-C.
        let late = py.check_signals();
        let seconds = self.limit.as_secs_f64();
        match result {
            Err(error) if !error.is_instance_of::<PyKeyboardInterrupt>(py) => Err(error),
            Ok(value) if late.is_err() => Ok(value),
            _ => Err(plain(format!("the executor {missing} for {seconds} s"))),
        }
    }
}

/// Interrupts as Ctrl-C does; a thread other than the main one gets an exception of its own.
fn interrupt(py: Python<'_>, ident: u64, is_main: bool) -> PyResult<()> {
    if is_main {
        let signal = py.import("signal")?;
        let number = signal.getattr("SIGINT")?;
        signal.call_method1("pthread_kill", (ident, number))?;
        return Ok(());
    }
    let ctypes = py.import("ctypes")?;
    let exception = py.get_type::<PyKeyboardInterrupt>();
    let exception = ctypes.call_method1("py_object", (exception,))?;
    let ident = ctypes.call_method1("c_ulong", (ident,))?;
    let api = ctypes.getattr("pythonapi")?;
    api.call_method1("PyThreadState_SetAsyncExc", (ident, exception))?;
    Ok(())
}
