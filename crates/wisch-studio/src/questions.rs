//! Queries to the memory: one engine for all clients, on a thread of its own, which stops together with the engine.

use crate::library::Library;
use crate::refusal::Refusal;
use axum::http::StatusCode;
use serde::Deserialize;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant, SystemTime};
use tokio::sync::oneshot;
use wisch_memory::Catalogue;
use wisch_memory::ask::{
    AskError, AskLimits, Assertions, EngineCommand, QuerySession, TelemetryPredicates, locate_fault,
};
use wisch_memory::view::{answers_json, gather};

/// Limits of a query, the same as those of `wisch ask`.
pub const LIMITS: AskLimits = AskLimits {
    time: Duration::from_secs(60),
    memory: 4096 << 20,
    answers: 1000,
};
/// Largest number of waiting queries.
const MOST_WAITING: usize = 8;
/// Longest query [bytes].
const LONGEST: usize = 20_000;
/// Interval at which an abandoned query is stopped.
const INTERRUPT_INTERVAL: Duration = Duration::from_millis(50);
/// File of the statements by queries.
const STATEMENTS_FILE: &str = "told.jsonl";

/// A query from the page.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Question {
    query: String,
    /// Largest number of answers, within the limit of `wisch ask`.
    #[serde(default)]
    limit: Option<usize>,
}

/// Interface to the engine's thread.
#[derive(Debug)]
pub struct Questions {
    jobs: SyncSender<Job>,
    now: Arc<Now>,
    next: AtomicU64,
}

/// The current job.
#[derive(Debug, Default)]
struct Now {
    /// Number of the job; 0 for none.
    number: AtomicU64,
    interrupt: Mutex<Option<Arc<AtomicBool>>>,
}

#[derive(Debug)]
struct Job {
    number: u64,
    question: Question,
    reply: oneshot::Sender<Value>,
}

impl Questions {
    /// Creates the interface to a memory, with this engine or the first one that is installed.
    pub fn new(library: Arc<Library>, engine: Option<PathBuf>) -> Self {
        let (jobs, waiting) = sync_channel(MOST_WAITING);
        let now = Arc::new(Now::default());
        let known = Arc::clone(&now);
        std::thread::spawn(move || answer_all(&library, engine.as_deref(), &waiting, &known));
        Self {
            jobs,
            now,
            next: AtomicU64::new(1),
        }
    }

    /// Returns the answer or the error of a query, as the page expects it. A query is ended if its client disconnects.
    pub async fn ask(&self, question: Question) -> Result<Value, Refusal> {
        if question.query.len() > LONGEST {
            let why = format!("a query has at most {LONGEST} bytes");
            return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, why));
        }
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let (reply, answer) = oneshot::channel();
        let job = Job {
            number,
            question,
            reply,
        };
        self.jobs.try_send(job).map_err(|error| match error {
            TrySendError::Full(_) => Refusal::new(
                StatusCode::SERVICE_UNAVAILABLE,
                "too many queries are waiting; ask again in a moment",
            ),
            TrySendError::Disconnected(_) => Refusal::failed("the query engine has stopped"),
        })?;
        let waiting = Waiting {
            number,
            now: Arc::clone(&self.now),
        };
        let answered = answer.await;
        drop(waiting);
        answered.map_err(|_| Refusal::failed("the query was not answered"))
    }
}

/// A client that waits for an answer.
struct Waiting {
    number: u64,
    now: Arc<Now>,
}

impl Drop for Waiting {
    fn drop(&mut self) {
        let (number, now) = (self.number, Arc::clone(&self.now));
        if now.number.load(Ordering::SeqCst) != number {
            return;
        }
        // Repeated, because a query that is just starting resets the flag.
        std::thread::spawn(move || {
            while now.number.load(Ordering::SeqCst) == number {
                if let Some(interrupt) = &*lock(&now.interrupt) {
                    interrupt.store(true, Ordering::Relaxed);
                }
                std::thread::sleep(INTERRUPT_INTERVAL);
            }
        });
    }
}

fn answer_all(library: &Library, engine: Option<&Path>, jobs: &Receiver<Job>, now: &Now) {
    let mut open: Option<Open> = None;
    for job in jobs {
        if job.reply.is_closed() {
            continue;
        }
        now.number.store(job.number, Ordering::SeqCst);
        let began = Instant::now();
        let answered = open_memory(&mut open, library, engine, now)
            .and_then(|open| answer(open, library, &job.question));
        now.number.store(0, Ordering::SeqCst);
        let seconds = began.elapsed().as_secs_f64();
        let reply = match answered {
            Ok(mut reply) => {
                reply["seconds"] = json!(seconds);
                reply
            }
            Err(error) => fault_json(&error, &job.question.query),
        };
        let _ = job.reply.send(reply);
    }
}

/// An opened memory, in its state at that time.
struct Open {
    asker: QuerySession,
    catalogue: Arc<Catalogue>,
    statements: StatementsState,
}

/// State of the file of statements, which reveals changes by other programs.
type StatementsState = Option<(u64, Option<SystemTime>)>;

fn open_memory<'a>(
    open: &'a mut Option<Open>,
    library: &Library,
    engine: Option<&Path>,
    now: &Now,
) -> Result<&'a mut Open, AskError> {
    let catalogue = library.catalogue()?;
    let folder = library.memory().folder();
    let statements = statements_state(folder);
    let is_current =
        |open: &Open| Arc::ptr_eq(&open.catalogue, &catalogue) && open.statements == statements;
    let stays = open.take().filter(is_current);
    let current = match stays {
        Some(current) => current,
        None => {
            let asker = QuerySession::new(
                command(engine)?,
                LIMITS,
                Arc::clone(&catalogue),
                TelemetryPredicates::new(library.memory().clone()),
                Assertions::read(folder)?,
            );
            *lock(&now.interrupt) = Some(asker.interrupt());
            Open {
                asker,
                catalogue,
                statements,
            }
        }
    };
    Ok(open.insert(current))
}

fn statements_state(folder: &Path) -> StatementsState {
    let metadata = std::fs::metadata(folder.join(STATEMENTS_FILE)).ok()?;
    Some((metadata.len(), metadata.modified().ok()))
}

fn command(engine: Option<&Path>) -> Result<EngineCommand, AskError> {
    let found = match engine {
        Some(path) => {
            let is_swi = path.file_stem().is_some_and(|name| name == "swipl");
            Some(if is_swi {
                EngineCommand::Swi(path.to_path_buf())
            } else {
                EngineCommand::Scryer(path.to_path_buf())
            })
        }
        None => EngineCommand::find(),
    };
    found.ok_or_else(|| {
        let why = "neither wisch-prolog nor swipl can be found; install one of them";
        AskError::CannotStart(std::io::Error::new(std::io::ErrorKind::NotFound, why))
    })
}

fn answer(open: &mut Open, library: &Library, question: &Question) -> Result<Value, AskError> {
    let mut answers = open.asker.ask(&question.query)?;
    // The engine already knows this query's own statements.
    open.statements = statements_state(library.memory().folder());
    let limit = question.limit.unwrap_or(LIMITS.answers).max(1);
    if answers.rows.len() > limit {
        answers.rows.truncate(limit);
        answers.is_cut = true;
    }
    let catalogue = &open.catalogue;
    let view = gather(&answers.views, &answers.rows, library.memory(), catalogue);
    let view = view.map_err(|error| error.to_string());
    let view = view.as_ref().map_err(String::as_str);
    Ok(answers_json(&question.query, &answers, view, catalogue))
}

fn fault_json(error: &AskError, query: &str) -> Value {
    let mut entry = Map::new();
    entry.insert("message".to_owned(), json!(error.to_string()));
    if let AskError::Fault(fault) = error
        && let Some(place) = locate_fault(fault, query)
    {
        entry.insert("offset".to_owned(), json!(place.offset));
        entry.insert("length".to_owned(), json!(place.length));
        entry.insert("line".to_owned(), json!(place.line));
        entry.insert("column".to_owned(), json!(place.column));
    }
    json!({ "error": entry })
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
