//! The episodic memory: it stores wipings, and answers queries.

use crate::arrays::vector;
use crate::error::{Details, failed, plain};
use crate::session::{PROGRAM, PySession};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use wisch::run::RunEvent;
use wisch_io::{ExecutedBy, RoundTimes};
use wisch_memory::Memory;
use wisch_memory::ask::{Answers, AskError, EngineCommand, QuerySession, Term};
use wisch_record::{EpisodeSink, EpisodeTarget, FinishedRound, RecordError, RunSink};

/// Interval of the checks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);
/// Advice on the installation of a Prolog engine.
const NO_ENGINE: &str = "install SWI-Prolog (swipl), or wisch-prolog from wisch's source: cargo install --path crates/wisch-prolog --locked";

/// Memory of episodes in a folder.
#[pyclass(name = "Memory", module = "wisch", frozen)]
pub struct PyMemory {
    folder: PathBuf,
    asking: Mutex<Option<Asking>>,
}

/// An engine with its facts, on a thread of its own.
struct Asking {
    queries: Sender<String>,
    answers: Receiver<Result<Answers, AskError>>,
    interrupt: Arc<AtomicBool>,
}

impl Asking {
    fn begin(folder: &Path, memory: Memory, engine: EngineCommand) -> PyResult<Self> {
        let (queries, asked) = channel::<String>();
        let (answer, answers) = channel();
        let (begun, begins) = channel();
        std::thread::spawn(move || {
            let mut asker = match QuerySession::open(memory, engine) {
                Ok(asker) => asker,
                Err(error) => {
                    let _ = begun.send(Err(error));
                    return;
                }
            };
            let _ = begun.send(Ok(asker.interrupt()));
            for query in asked {
                if answer.send(asker.ask(&query)).is_err() {
                    return;
                }
            }
        });
        let interrupt = begins.recv().map_err(|_| engine_error())?;
        Ok(Self {
            queries,
            answers,
            interrupt: interrupt.map_err(|error| memory_error(folder, error))?,
        })
    }
}

fn engine_error() -> PyErr {
    plain("internal error: the thread of the queries has ended; please report it")
}

fn memory_error(folder: &Path, error: impl std::fmt::Display) -> PyErr {
    let details = Details {
        file: Some(folder.display().to_string()),
        ..Details::default()
    };
    failed(error, details)
}

impl PyMemory {
    fn memory(&self) -> PyResult<Memory> {
        Memory::open(&self.folder).map_err(|error| memory_error(&self.folder, error))
    }

    fn begin(&self) -> PyResult<Asking> {
        let engine = EngineCommand::find().ok_or_else(|| {
            let details = Details {
                help: Some(NO_ENGINE.to_owned()),
                ..Details::default()
            };
            failed("there is no Prolog engine to ask the memory", details)
        })?;
        Asking::begin(&self.folder, self.memory()?, engine)
    }

    /// Returns the answers; Ctrl-C ends the query, and later queries are possible.
    fn answers(&self, py: Python<'_>, query: String) -> PyResult<Answers> {
        let mut slot = self.asking.lock().unwrap_or_else(PoisonError::into_inner);
        let Asking {
            queries,
            mut answers,
            interrupt,
        } = match slot.take() {
            Some(asking) => asking,
            None => self.begin()?,
        };
        queries.send(query).map_err(|_| engine_error())?;
        let mut interrupted = Ok(());
        let answered = loop {
            let (answer, back) = py.detach(move || (answers.recv_timeout(LOOK), answers));
            answers = back;
            match answer {
                Ok(answered) => break answered,
                Err(RecvTimeoutError::Disconnected) => return Err(engine_error()),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Err(error) = py.check_signals() {
                interrupt.store(true, Ordering::SeqCst);
                interrupted = Err(error);
            }
        };
        *slot = Some(Asking {
            queries,
            answers,
            interrupt,
        });
        interrupted?;
        answered.map_err(plain)
    }
}

/// Converts a term to a Python object: atoms and variables become strings, compound terms tuples of name and arguments.
fn object<'py>(py: Python<'py>, term: &Term) -> PyResult<Bound<'py, PyAny>> {
    Ok(match term {
        Term::Variable(name) | Term::Atom(name) => name.into_pyobject(py)?.into_any(),
        Term::Integer(number) => number.into_pyobject(py)?.into_any(),
        Term::Float(number) => number.into_pyobject(py)?.into_any(),
        Term::List(terms) => {
            let objects: PyResult<Vec<_>> = terms.iter().map(|term| object(py, term)).collect();
            PyList::new(py, objects?)?.into_any()
        }
        Term::Compound(name, arguments) => {
            let objects: PyResult<Vec<_>> = arguments.iter().map(|term| object(py, term)).collect();
            (name, PyList::new(py, objects?)?)
                .into_pyobject(py)?
                .into_any()
        }
    })
}

#[pymethods]
impl PyMemory {
    /// Opens the memory in a folder, creating it if necessary.
    #[new]
    #[pyo3(signature = (folder = PathBuf::from("episodes")))]
    fn new(folder: PathBuf) -> PyResult<Self> {
        Memory::create(&folder).map_err(|error| memory_error(&folder, error))?;
        Ok(Self {
            folder,
            asking: Mutex::default(),
        })
    }

    /// Folder of the memory.
    #[getter]
    fn folder(&self) -> PathBuf {
        self.folder.clone()
    }

    /// Names of the episodes.
    #[getter]
    fn episodes(&self) -> PyResult<Vec<String>> {
        let episodes = self.memory()?.episodes();
        episodes.map_err(|error| memory_error(&self.folder, error))
    }

    /// Answers a query in Prolog (`wisch ask --list` lists the predicates): returns a dict per answer, from the names
    /// of its variables to their values.
    fn ask<'py>(&self, py: Python<'py>, query: String) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let answers = self.answers(py, query)?;
        let rows = answers.rows.iter().map(|row| {
            let answer = PyDict::new(py);
            for (name, term) in answers.names.iter().zip(row) {
                answer.set_item(name, object(py, term)?)?;
            }
            Ok(answer)
        });
        rows.collect()
    }

    /// Returns columns of an episode's telemetry by their names, as arrays: all columns, or the given ones.
    #[pyo3(signature = (episode, round = 1, columns = None))]
    fn telemetry<'py>(
        &self,
        py: Python<'py>,
        episode: &str,
        round: usize,
        columns: Option<Vec<String>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let refused = |error: &dyn std::fmt::Display| memory_error(&self.folder, error);
        let episode = self.memory()?.episode(episode);
        let episode = episode.map_err(|error| refused(&error))?;
        let telemetry = episode.telemetry(round).map_err(|error| refused(&error))?;
        let rows = 0..telemetry.rows();
        let names = match columns {
            Some(names) => names,
            None => {
                let others = telemetry.columns().into_iter();
                let others = others.filter(|name| *name != "time");
                others.map(str::to_owned).collect()
            }
        };
        let all = PyDict::new(py);
        let times = telemetry.times(rows.clone());
        all.set_item(
            "time_s",
            vector(py, times.map_err(|error| refused(&error))?),
        )?;
        for name in names {
            let values = py.detach(|| telemetry.values(&name, rows.clone()));
            let values = values.map_err(|error| refused(&error))?;
            all.set_item(name, vector(py, values))?;
        }
        Ok(all)
    }

    /// Stores the finished rounds of a session as an episode, and returns its name.
    fn remember(&self, py: Python<'_>, session: &PySession) -> PyResult<String> {
        let rounds = session.rounds(py)?;
        let rounds: Vec<_> = rounds.iter().map(|round| round.get()).collect();
        if rounds.is_empty() {
            return Err(plain("the session has no finished round"));
        }
        let refused = |error: RecordError| memory_error(&self.folder, error);
        let target = EpisodeTarget {
            memory: self.folder.clone(),
            executor: session.executor(),
            names: None,
            clock: Some(session.clock()),
        };
        let mut sink = EpisodeSink::begin(target)
            .map_err(refused)?
            .with_replayed_events();
        let mut finished = Vec::new();
        for round in &rounds {
            let motion = &round.round.motion;
            if let Some(telemetry) = &round.telemetry {
                let mut record = |event: &RunEvent<'_>| sink.on_event(event);
                record(&RunEvent::Executing(motion)).map_err(plain)?;
                telemetry.get().each(py, &motion.followed, |sample| {
                    record(&RunEvent::Sample(sample))
                })?;
                let round = motion.number;
                record(&RunEvent::Interpreting { round }).map_err(plain)?;
            }
            finished.push(FinishedRound {
                round: (*round.round).clone(),
                times: RoundTimes::default(),
                executed_by: ExecutedBy::Executor,
                truth: None,
            });
        }
        let first_observation = session.read_first_observation(py)?;
        let (loaded, files) = (&session.task, session.robot_files());
        let episode = sink.commit(&finished, first_observation, loaded, files, None, PROGRAM);
        let episode = episode.map_err(refused)?;
        // The engine does not know the new episode.
        *self.asking.lock().unwrap_or_else(PoisonError::into_inner) = None;
        Ok(episode.id)
    }

    fn __repr__(&self) -> String {
        format!("<wisch.Memory in {:?}>", self.folder)
    }
}
