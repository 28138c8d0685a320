//! Ends an executor that hands on nothing any more.

use crate::error::plain;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Between two looks.
const LOOK: Duration = Duration::from_millis(20);

/// Watches one call of an executor, and interrupts its thread as Ctrl-C would when it gives no sign of life for too long.
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
    /// Watches from now on; nothing without a limit.
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
                    // It may have ended while this thread waited for its turn.
                    if !watched.is_over.load(Ordering::SeqCst) {
                        watched.has_fired.store(true, Ordering::SeqCst);
                        let _ = interrupt(py, ident, is_main);
                    }
                });
                // One that swallows the interruption gets another.
                *watched.last.lock().unwrap_or_else(PoisonError::into_inner) = Instant::now();
            }
        });
        Ok(Some(Self {
            limit,
            shared,
            thread: Mutex::new(Some(thread)),
        }))
    }

    /// There was a sign of life.
    pub fn touch(&self) {
        *(self.shared.last.lock()).unwrap_or_else(PoisonError::into_inner) = Instant::now();
    }

    /// Watches no longer; what the call came to, or that it was given up, with what was missing of it.
    pub fn end<T>(&self, py: Python<'_>, result: PyResult<T>, missing: &str) -> PyResult<T> {
        self.shared.is_over.store(true, Ordering::SeqCst);
        let thread = (self.thread.lock().unwrap_or_else(PoisonError::into_inner)).take();
        py.detach(|| thread.map(JoinHandle::join));
        if !self.shared.has_fired.load(Ordering::SeqCst) {
            return result;
        }
        // An interruption that came too late to be seen is not to be taken for the user's.
        let late = py.check_signals();
        let seconds = self.limit.as_secs_f64();
        match result {
            Err(error) if !error.is_instance_of::<PyKeyboardInterrupt>(py) => Err(error),
            Ok(value) if late.is_err() => Ok(value),
            _ => Err(plain(format!("the executor {missing} for {seconds} s"))),
        }
    }
}

/// As Ctrl-C does; a thread that is not the main one is told by an exception of its own.
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
