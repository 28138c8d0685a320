//! The server: what is asked for, and who answers it.

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
use wisch_memory::{Memory, MemoryError, live_place};

/// Most answers at once that go on for as long as the page is open.
const MOST_STREAMS: usize = 64;
/// How often something is sent where nothing changes.
const HEARTBEAT: Duration = Duration::from_secs(10);

/// A board that is wiped from left to right.
const ICON: &str = "<link rel=\"icon\" href=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 \
                    16 16'%3E%3Crect x='1' y='2' width='14' height='12' rx='2' fill='%23f3e3c3'/%3E%3Cpath d='M3 11h5l5-6' \
                    fill='none' stroke='%230072b2' stroke-width='3'/%3E%3C/svg%3E\">";

/// What is served, and where.
#[derive(Debug, Clone)]
pub struct Config {
    /// Folder of the memory; it is made if it is not there.
    pub memory: PathBuf,
    /// The program that runs tasks.
    pub wisch: PathBuf,
    /// The Prolog system, `wisch-prolog` or `swipl`; else the first that is installed.
    pub engine: Option<PathBuf>,
    /// The shipped tasks in JSON; else as the program lists them.
    pub scenarios: Option<PathBuf>,
    /// The address to listen at.
    pub host: IpAddr,
    /// The port; 0: any that is free.
    pub port: u16,
}

/// Why the studio cannot begin.
#[derive(Debug, thiserror::Error)]
pub enum StudioError {
    /// No memory.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// Nowhere to listen.
    #[error("{address}: {error}")]
    Listen {
        /// Where.
        address: SocketAddr,
        /// Why.
        error: io::Error,
    },
    /// No random numbers.
    #[error("the system gives no random numbers: {0}")]
    Random(getrandom::Error),
    /// No list of shipped tasks.
    #[error("{0}")]
    Scenarios(String),
    /// A path that leads nowhere.
    #[error("{}: {error}", path.display())]
    Path {
        /// The path.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
}

/// A server that listens.
#[derive(Debug)]
pub struct Studio {
    listener: TcpListener,
    url: String,
    urls_from_elsewhere: Vec<String>,
    gate: Arc<Gate>,
    rooms: Arc<Rooms>,
}

/// All that answers draw on.
#[derive(Debug)]
struct Rooms {
    library: Arc<Library>,
    live: LiveFolder,
    runs: Runs,
    questions: Questions,
    scenarios: Vec<Scenario>,
    streams: Arc<Semaphore>,
    changes: watch::Receiver<u64>,
    /// Leads the browser to the page; gone once the page was opened.
    redirect: Mutex<Option<TempPath>>,
}

type Answer = Result<Response, Refusal>;

impl Studio {
    /// Listens; requests are answered by [`Self::serve`].
    ///
    /// # Errors
    /// No memory, no place to listen at, no list of tasks.
    pub async fn begin(config: &Config) -> Result<Self, StudioError> {
        let memory = Memory::create(&config.memory)?;
        // Runs begin in the same folder, whatever it is called from there.
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
        let live = LiveFolder::of(&folder, &config.wisch);
        let library = Arc::new(Library::new(memory));
        let rooms = Rooms {
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
            url: url(reached_from_here(bound)),
            urls_from_elsewhere: elsewhere.into_iter().map(url).collect(),
            listener,
            gate,
            rooms: Arc::new(rooms),
        })
    }

    /// Returns the address of the page for browsers of this machine, with the token.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// Returns the addresses of the page for other machines, where it listens at all addresses of this one.
    pub fn urls_from_elsewhere(&self) -> &[String] {
        &self.urls_from_elsewhere
    }

    /// Opens the page in the browser. The address, which holds the token, stands in no list of processes.
    ///
    /// # Errors
    /// If the system has no program for it.
    pub fn open_in_browser(&self) -> io::Result<()> {
        // Where browsers that are confined may read at all: in a visible folder of their user.
        let any = live_place(self.rooms.library.memory().folder(), "any", "html");
        let folder = any.parent().unwrap_or(&any);
        let file = browser::redirect_file(folder, &self.url)?;
        let opened = browser::open(&file);
        *self.rooms.redirect() = Some(file);
        opened
    }

    /// Answers until `until` is over, then ends the runs that were begun here.
    pub async fn serve(self, until: impl Future<Output = ()> + Send) {
        let rooms = Arc::clone(&self.rooms);
        let router = router(self.gate, self.rooms);
        // Whoever follows a run is told its end.
        let open = connections::answer(self.listener, router, connections::LIMITS, until).await;
        rooms.redirect().take();
        rooms.runs.stop_all().await;
        drop(open);
    }
}

/// Returns the address by which browsers of this machine reach a listener.
fn reached_from_here(bound: SocketAddr) -> SocketAddr {
    let ip = match bound.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    SocketAddr::new(ip, bound.port())
}

fn router(gate: Arc<Gate>, rooms: Arc<Rooms>) -> Router {
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
        .fallback(|| async { StatusCode::NOT_FOUND })
        .with_state(rooms)
        .layer(middleware::from_fn_with_state(gate, pass))
}

async fn page(State(rooms): State<Arc<Rooms>>) -> Answer {
    rooms.redirect().take();
    let nonce = nonce().map_err(Refusal::failed)?;
    // The only script of the page comes last.
    let page = wisch_web::studio_page();
    let (before, after) = page.split_at(page.find("<main").unwrap_or(0));
    // Browsers ask for an icon elsewhere if the page has none.
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

async fn overview(State(rooms): State<Arc<Rooms>>, Query(wanted): Query<Wanted>) -> Answer {
    let found = tokio::task::spawn_blocking(move || -> Result<Value, Refusal> {
        let list = rooms.library.list(&wanted.find)?;
        let runs: Vec<Value> = rooms.live.runs().iter().map(|run| rooms.run(run)).collect();
        Ok(json!({
            "memory": rooms.library.memory().folder(),
            "list": list,
            "runs": runs,
            "scenarios": rooms.scenarios,
            "limits": { "answers": LIMITS.answers, "seconds": LIMITS.time.as_secs() },
        }))
    });
    Ok(Json(found.await??).into_response())
}

impl Rooms {
    /// What is said of a run.
    fn run(&self, run: &LiveRun) -> Value {
        let mut said = serde_json::to_value(run).unwrap_or_default();
        said["own"] = json!(self.runs.is_own(&run.id));
        if run.state == RunState::Lost {
            said["message"] = json!(self.runs.last_words(&run.id));
        }
        said
    }

    fn redirect(&self) -> std::sync::MutexGuard<'_, Option<TempPath>> {
        self.redirect.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn stream_permit(&self) -> Result<tokio::sync::OwnedSemaphorePermit, Refusal> {
        Arc::clone(&self.streams).try_acquire_owned().map_err(|_| {
            let why = format!("{MOST_STREAMS} streams are open already: close a page");
            Refusal::new(StatusCode::SERVICE_UNAVAILABLE, why)
        })
    }
}

async fn overview_events(State(rooms): State<Arc<Rooms>>) -> Answer {
    let permit = rooms.stream_permit()?;
    let changes = rooms.changes.clone();
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
    State(rooms): State<Arc<Rooms>>,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Answer {
    let file = open_recording(Arc::clone(&rooms.library), id.clone()).await?;
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
    State(rooms): State<Arc<Rooms>>,
    Path(id): Path<String>,
    Query(After { after }): Query<After>,
    headers: HeaderMap,
) -> Answer {
    let last = headers.get("last-event-id");
    let last = last.and_then(|last| last.to_str().ok()?.parse().ok());
    let after = last.unwrap_or(after);
    let permit = rooms.stream_permit()?;
    let live = rooms.live.clone();
    let tail = if live.recording(&id).is_some() {
        Tail::growing(live, &id, after, permit)?
    } else {
        let kept = open_recording(Arc::clone(&rooms.library), id.clone()).await;
        let kept = kept.map_err(|_| Refusal::unknown(format!("there is no run {id:?}")))?;
        Tail::kept(live, &id, kept, after, permit)
    };
    Ok(tail.into_response())
}

async fn begin_run(
    State(rooms): State<Arc<Rooms>>,
    order: Result<Json<StartOrder>, JsonRejection>,
) -> Answer {
    let Json(order) = order.map_err(unreadable)?;
    let shipped: Vec<String> = rooms.scenarios.iter().map(|one| one.name.clone()).collect();
    let id = rooms.runs.begin(&order, &shipped).await?;
    Ok((StatusCode::CREATED, Json(json!({ "run": id }))).into_response())
}

async fn stop_run(State(rooms): State<Arc<Rooms>>, Path(id): Path<String>) -> Answer {
    rooms.runs.stop(&id)?;
    Ok((StatusCode::ACCEPTED, Json(json!({ "stopping": id }))).into_response())
}

async fn clear_run(State(rooms): State<Arc<Rooms>>, Path(id): Path<String>) -> Answer {
    if rooms.live.clear(&id).map_err(Refusal::failed)? {
        return Ok(Json(json!({ "cleared": id })).into_response());
    }
    let why = format!("there is no run {id:?} that has ended");
    Err(Refusal::new(StatusCode::CONFLICT, why))
}

async fn ask(
    State(rooms): State<Arc<Rooms>>,
    question: Result<Json<Question>, JsonRejection>,
) -> Answer {
    let Json(question) = question.map_err(unreadable)?;
    Ok(Json(rooms.questions.ask(question).await?).into_response())
}

async fn words() -> Answer {
    Ok(Json(vocabulary()).into_response())
}

fn unreadable(rejection: JsonRejection) -> Refusal {
    Refusal::new(rejection.status(), rejection.body_text())
}
