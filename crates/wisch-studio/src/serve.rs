//! The server: its requests and their handlers.

use crate::browser;
use crate::connections::{self, addresses_of_machine};
use crate::gate::{Gate, nonce, page_policy, pass};
use crate::kept::{body_of_file, body_of_unpacked, open_recording};
use crate::library::Library;
use crate::live::{LiveFolder, LiveRun, RunState};
use crate::questions::{LIMITS, Question, Questions};
use crate::refusal::Refusal;
use crate::runs::{Runs, StartOrder};
use crate::scenarios::{self, Scenario};
use crate::stream::Tail;
use crate::vocabulary::vocabulary;
use crate::watch::changes;
use axum::body::{Body, Bytes};
use axum::extract::rejection::JsonRejection;
use axum::extract::{Path, Query, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Json, Router, middleware};
use futures_util::stream;
use serde::Deserialize;
use serde_json::{Value, json};
use std::io;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tempfile::TempPath;
use tokio::net::TcpListener;
use tokio::sync::{Semaphore, watch};
use wisch_memory::health::{DescribedHealth, assess_groups, gather_groups};
use wisch_memory::{Memory, MemoryError, live_path};

/// Largest number of simultaneous event streams.
const MOST_STREAMS: usize = 64;
/// Interval of messages on a stream without changes.
const HEARTBEAT: Duration = Duration::from_secs(10);

/// Icon: a board that is wiped from left to right.
const ICON: &str = "<link rel=\"icon\" href=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 \
                    16 16'%3E%3Crect x='1' y='2' width='14' height='12' rx='2' fill='%23f3e3c3'/%3E%3Cpath d='M3 11h5l5-6' \
                    fill='none' stroke='%230072b2' stroke-width='3'/%3E%3C/svg%3E\">";

/// Configuration of the server.
#[derive(Debug, Clone)]
pub struct Config {
    /// Folder of the memory, created if necessary.
    pub memory: PathBuf,
    /// Program that runs tasks.
    pub wisch: PathBuf,
    /// Prolog system, `wisch-prolog` or `swipl`; `None` for the first that is installed.
    pub engine: Option<PathBuf>,
    /// JSON file of the shipped tasks; `None` for those that the program lists.
    pub scenarios: Option<PathBuf>,
    /// Address to listen at.
    pub host: IpAddr,
    /// Port; 0 for any free port.
    pub port: u16,
}

/// Why the studio cannot start.
#[derive(Debug, thiserror::Error)]
pub enum StudioError {
    /// The memory cannot be opened.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// The address is not available.
    #[error("{address}: {error}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The system provides no random numbers.
    #[error("the operating system provides no random numbers: {0}")]
    Random(getrandom::Error),
    /// The shipped tasks cannot be listed.
    #[error("{0}")]
    Scenarios(String),
    /// A path cannot be resolved.
    #[error("{}: {error}", path.display())]
    Path {
        /// The path.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
}

/// A listening server.
#[derive(Debug)]
pub struct Studio {
    listener: TcpListener,
    url: String,
    urls_from_elsewhere: Vec<String>,
    gate: Arc<Gate>,
    state: Arc<ServerState>,
}

/// Shared state of the handlers.
#[derive(Debug)]
struct ServerState {
    library: Arc<Library>,
    live: LiveFolder,
    runs: Runs,
    questions: Questions,
    scenarios: Vec<Scenario>,
    streams: Arc<Semaphore>,
    changes: watch::Receiver<u64>,
    /// File that redirects the browser to the page; removed once the page was opened.
    redirect: Mutex<Option<TempPath>>,
}

type Answer = Result<Response, Refusal>;

impl Studio {
    /// Starts to listen; [`Self::serve`] answers requests.
    ///
    /// # Errors
    /// If the memory, the address or the list of tasks is not available.
    pub async fn begin(config: &Config) -> Result<Self, StudioError> {
        let memory = Memory::create(&config.memory)?;
        // Runs get the absolute path, so that they use the same folder.
        let folder = std::fs::canonicalize(memory.folder()).map_err(|error| StudioError::Path {
            path: config.memory.clone(),
            error,
        })?;
        let memory = Memory::open(&folder)?;
        let scenarios = match &config.scenarios {
            Some(file) => scenarios::read(file).map_err(StudioError::Scenarios)?,
            None => scenarios::listed_by(&config.wisch),
        };
        let address = SocketAddr::new(config.host, config.port);
        let listening = TcpListener::bind(address).await;
        let listener = listening.map_err(|error| StudioError::Listen { address, error })?;
        let bound = listener.local_addr();
        let bound = bound.map_err(|error| StudioError::Listen { address, error })?;
        let gate = Arc::new(Gate::new(bound).map_err(StudioError::Random)?);
        let live = LiveFolder::new(&folder, &config.wisch);
        let library = Arc::new(Library::new(memory));
        let state = ServerState {
            runs: Runs::new(&config.wisch, &folder, live.clone()),
            questions: Questions::new(Arc::clone(&library), config.engine.clone()),
            scenarios,
            streams: Arc::new(Semaphore::new(MOST_STREAMS)),
            changes: changes(Arc::clone(&library), live.clone()),
            library,
            live,
            redirect: Mutex::default(),
        };
        let elsewhere = addresses_of_machine(bound);
        let elsewhere = elsewhere.map_err(|error| StudioError::Listen { address, error })?;
        let url = |address: SocketAddr| format!("http://{address}/{}/", gate.token());
        Ok(Self {
            url: url(local_address(bound)),
            urls_from_elsewhere: elsewhere.into_iter().map(url).collect(),
            listener,
            gate,
            state: Arc::new(state),
        })
    }

    /// Returns the address of the page for browsers of this machine, with the token.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// Returns the addresses of the page for other machines, if the server listens at all addresses.
    pub fn urls_from_elsewhere(&self) -> &[String] {
        &self.urls_from_elsewhere
    }

    /// Opens the page in the browser. The address holds the token and appears in no list of processes.
    ///
    /// # Errors
    /// If the system has no program that opens it.
    pub fn open_in_browser(&self) -> io::Result<()> {
        // Confined browsers can only read visible folders of their user, so the file must be in one.
        let any = live_path(self.state.library.memory().folder(), "any", "html");
        let folder = any.parent().unwrap_or(&any);
        let file = browser::redirect_file(folder, &self.url)?;
        let opened = browser::open(&file);
        *self.state.redirect() = Some(file);
        opened
    }

    /// Answers requests until `until` completes, then stops the runs that it started.
    pub async fn serve(self, until: impl Future<Output = ()> + Send) {
        let state = Arc::clone(&self.state);
        let router = router(self.gate, self.state);
        // Streams stay open, so that clients learn how their runs end.
        let open = connections::answer(self.listener, router, connections::LIMITS, until).await;
        state.redirect().take();
        state.runs.stop_all().await;
        drop(open);
    }
}

/// Returns the address by which browsers of this machine reach a listener.
fn local_address(bound: SocketAddr) -> SocketAddr {
    let ip = match bound.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    SocketAddr::new(ip, bound.port())
}

fn router(gate: Arc<Gate>, state: Arc<ServerState>) -> Router {
    let at = |path: &str| format!("/{}/{path}", gate.token());
    Router::new()
        .route(&at(""), get(page))
        .route(&at("api/overview"), get(overview))
        .route(&at("api/overview/events"), get(overview_events))
        .route(&at("api/episodes/{id}/recording"), get(recording))
        .route(&at("api/runs"), post(begin_run))
        .route(&at("api/runs/{id}/stream"), get(run_stream))
        .route(&at("api/runs/{id}/stop"), post(stop_run))
        .route(&at("api/runs/{id}/clear"), post(clear_run))
        .route(&at("api/ask"), post(ask))
        .route(&at("api/vocabulary"), get(words))
        .route(&at("api/health"), get(health))
        .fallback(|| async { StatusCode::NOT_FOUND })
        .with_state(state)
        .layer(middleware::from_fn_with_state(gate, pass))
}

async fn page(State(state): State<Arc<ServerState>>) -> Answer {
    state.redirect().take();
    let nonce = nonce().map_err(Refusal::failed)?;
    // The page's only script is at its end.
    let page = wisch_web::studio_page();
    let (before, after) = page.split_at(page.find("<main").unwrap_or(0));
    // Browsers request another icon if the page has none.
    let before = before.replacen("</title>", &format!("</title>\n{ICON}"), 1);
    let script = format!("<script nonce=\"{nonce}\">");
    let page = format!("{before}{}", after.replacen("<script>", &script, 1));
    let headers = [
        (header::CONTENT_TYPE, "text/html; charset=utf-8".to_owned()),
        (header::CONTENT_SECURITY_POLICY, page_policy(&nonce)),
    ];
    Ok((headers, page).into_response())
}

#[derive(Debug, Default, Deserialize)]
struct Wanted {
    #[serde(default)]
    find: String,
}

async fn overview(State(state): State<Arc<ServerState>>, Query(wanted): Query<Wanted>) -> Answer {
    let found = tokio::task::spawn_blocking(move || -> Result<Value, Refusal> {
        let list = state.library.list(&wanted.find)?;
        let runs: Vec<Value> = state.live.runs().iter().map(|run| state.run(run)).collect();
        Ok(json!({
            "memory": state.library.memory().folder(),
            "list": list,
            "runs": runs,
            "scenarios": state.scenarios,
            "limits": { "answers": LIMITS.answers, "seconds": LIMITS.time.as_secs() },
        }))
    });
    Ok(Json(found.await??).into_response())
}

impl ServerState {
    /// Returns the summary of a run.
    fn run(&self, run: &LiveRun) -> Value {
        let mut summary = serde_json::to_value(run).unwrap_or_default();
        summary["own"] = json!(self.runs.is_own(&run.id));
        if run.state == RunState::Lost {
            summary["message"] = json!(self.runs.last_words(&run.id));
        }
        summary
    }

    fn redirect(&self) -> std::sync::MutexGuard<'_, Option<TempPath>> {
        self.redirect.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn stream_permit(&self) -> Result<tokio::sync::OwnedSemaphorePermit, Refusal> {
        Arc::clone(&self.streams).try_acquire_owned().map_err(|_| {
            let why = format!("{MOST_STREAMS} streams are open already; close a page");
            Refusal::new(StatusCode::SERVICE_UNAVAILABLE, why)
        })
    }
}

async fn overview_events(State(state): State<Arc<ServerState>>) -> Answer {
    let permit = state.stream_permit()?;
    let changes = state.changes.clone();
    let events = stream::unfold(
        (changes, permit, true),
        |(mut changes, permit, first)| async move {
            let text = if first {
                "retry: 1000\n\n".to_owned()
            } else {
                tokio::select! {
                    changed = changes.changed() => {
                        changed.ok()?;
                        format!("event: changed\ndata: {}\n\n", *changes.borrow_and_update())
                    }
                    () = tokio::time::sleep(HEARTBEAT) => ": still here\n\n".to_owned(),
                }
            };
            Some((
                Ok::<_, io::Error>(Bytes::from(text)),
                (changes, permit, false),
            ))
        },
    );
    let headers = [(header::CONTENT_TYPE, "text/event-stream; charset=utf-8")];
    Ok((headers, Body::from_stream(events)).into_response())
}

async fn recording(
    State(state): State<Arc<ServerState>>,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Answer {
    let file = open_recording(Arc::clone(&state.library), id.clone()).await?;
    let kind = (header::CONTENT_TYPE, "application/x-ndjson; charset=utf-8");
    let accepted = headers.get(header::ACCEPT_ENCODING);
    let accepted = accepted.and_then(|accepted| accepted.to_str().ok());
    if accepted.is_some_and(|accepted| accepted.contains("gzip")) {
        let gzip = [(header::CONTENT_ENCODING, "gzip")];
        return Ok(([kind], gzip, body_of_file(file)).into_response());
    }
    let body = body_of_unpacked(file).await;
    let body =
        body.map_err(|error| Refusal::failed(format!("the recording of episode {id}: {error}")))?;
    Ok(([kind], body).into_response())
}

#[derive(Debug, Default, Deserialize)]
struct After {
    #[serde(default)]
    after: u64,
}

async fn run_stream(
    State(state): State<Arc<ServerState>>,
    Path(id): Path<String>,
    Query(After { after }): Query<After>,
    headers: HeaderMap,
) -> Answer {
    let last = headers.get("last-event-id");
    let last = last.and_then(|last| last.to_str().ok()?.parse().ok());
    let after = last.unwrap_or(after);
    let permit = state.stream_permit()?;
    let live = state.live.clone();
    let tail = if live.recording(&id).is_some() {
        Tail::growing(live, &id, after, permit)?
    } else {
        let kept = open_recording(Arc::clone(&state.library), id.clone()).await;
        let kept = kept.map_err(|_| Refusal::unknown(format!("there is no run {id:?}")))?;
        Tail::kept(live, &id, kept, after, permit)
    };
    Ok(tail.into_response())
}

async fn begin_run(
    State(state): State<Arc<ServerState>>,
    order: Result<Json<StartOrder>, JsonRejection>,
) -> Answer {
    let Json(order) = order.map_err(unreadable)?;
    let shipped: Vec<String> = state.scenarios.iter().map(|one| one.name.clone()).collect();
    let id = state.runs.begin(&order, &shipped).await?;
    Ok((StatusCode::CREATED, Json(json!({ "run": id }))).into_response())
}

async fn stop_run(State(state): State<Arc<ServerState>>, Path(id): Path<String>) -> Answer {
    state.runs.stop(&id)?;
    Ok((StatusCode::ACCEPTED, Json(json!({ "stopping": id }))).into_response())
}

async fn clear_run(State(state): State<Arc<ServerState>>, Path(id): Path<String>) -> Answer {
    if state.live.clear(&id).map_err(Refusal::failed)? {
        return Ok(Json(json!({ "cleared": id })).into_response());
    }
    let why = format!("there is no run {id:?} that has ended");
    Err(Refusal::new(StatusCode::CONFLICT, why))
}

async fn ask(
    State(state): State<Arc<ServerState>>,
    question: Result<Json<Question>, JsonRejection>,
) -> Answer {
    let Json(question) = question.map_err(unreadable)?;
    Ok(Json(state.questions.ask(question).await?).into_response())
}

async fn words() -> Answer {
    Ok(Json(vocabulary()).into_response())
}

/// Answers with the JSON of `wisch memory health`.
async fn health(State(state): State<Arc<ServerState>>) -> Answer {
    let assessed = tokio::task::spawn_blocking(move || -> Result<DescribedHealth, Refusal> {
        let groups = gather_groups(&*state.library.catalogue()?);
        Ok(assess_groups(&groups).into())
    });
    Ok(Json(assessed.await??).into_response())
}

fn unreadable(rejection: JsonRejection) -> Refusal {
    Refusal::new(rejection.status(), rejection.body_text())
}
