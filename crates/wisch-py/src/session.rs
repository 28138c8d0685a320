//! Sessions: a task from its first plan to its last verdict, stage by stage.
//!
//! Long computations run on a thread of their own, without Python's lock. Meanwhile the caller's thread serves Python:
//! it calls `on_event` and `observe()`, and checks for Ctrl-C. Motions are executed on the caller's thread, so that an
//! executor may use objects of that thread, such as a window.

use crate::arrays::{self, Matrix};
use crate::error::{of_record, of_run, plain, refused};
use crate::executor::{PreparedExecutor, PyExecutor, finish_prepared};
use crate::motion::PyMotion;
use crate::mutex::lock;
use crate::pictures;
use crate::plan::PyPlan;
use crate::round::{PyAudit, PyRound};
use crate::telemetry::{Columns, PyTelemetry};
use crate::warnings::watch_memory;
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError, PyRuntimeWarning};
use pyo3::prelude::*;
use self_cell::self_cell;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, TryLockError};
use std::time::Duration;
use wisch::plan::Plan;
use wisch::recover::Verdict;
use wisch::represent::{Observation, Task};
use wisch::run::{
    Execution, Executor, ExecutorError, MotionOrder, NoExecutor, OwnStrategy, Round, RunConfig,
    RunError, RunEvent, SampleSink, Session, Stage,
};
use wisch_io::{EventWriter, ExecutedBy, LoadedTask, Robot, RobotFiles};
use wisch_record::{RecordError, RunClock, RunRecord};

/// Program name in results and episodes.
pub const PROGRAM: &str = concat!("wisch-py ", env!("CARGO_PKG_VERSION"));
/// Interval of the checks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

self_cell!(
    struct Wiping {
        owner: Option<Arc<Robot>>,
        #[covariant]
        dependent: Session,
    }
);

type Events = EventWriter<std::io::Sink>;

/// Replacement of the task's strategy.
pub enum Given {
    Nothing,
    /// Strokes for the first round.
    Plan(Plan),
    /// Function for every round.
    Strategy(OwnStrategy<'static>),
}

/// A wiping task from its first plan to its last verdict.
#[pyclass(name = "Session", module = "wisch", frozen)]
pub struct PySession {
    pub task: Arc<LoadedTask>,
    robot: Option<Arc<Robot>>,
    wiping: Arc<Mutex<Wiping>>,
    stage: Arc<Mutex<Option<Stage>>>,
    verdict: Arc<Mutex<Option<Verdict>>>,
    is_running: AtomicBool,
    telemetry: Mutex<Vec<Py<PyTelemetry>>>,
    rounds: Mutex<Vec<Py<PyRound>>>,
    /// Recorder of the session, until its results are written.
    record: Arc<Mutex<Option<RunRecord>>>,
    kept: Mutex<Option<StoredResults>>,
    /// Class of the last executor.
    executor: Arc<Mutex<Option<String>>>,
    /// Notes of the watch that compares the run with its memory.
    notes: Arc<Mutex<Vec<String>>>,
    /// The executor that is prepared for motions.
    prepared: PreparedExecutor,
    /// When the session began.
    clock: RunClock,
}

/// Stored results of a session.
#[derive(Debug, Clone, Default)]
struct StoredResults {
    episode: Option<String>,
    remarks: Vec<String>,
}

/// Passes an event to the recorder.
fn keep(record: &Mutex<Option<RunRecord>>, event: &RunEvent<'_>) -> ControlFlow<()> {
    let mut record = lock(record);
    let flow = record.as_mut().map(|record| record.on_event(event));
    flow.unwrap_or(ControlFlow::Continue(()))
}

/// Marks a session as running until it is dropped.
struct Running<'a>(&'a AtomicBool);

impl Drop for Running<'_> {
    fn drop(&mut self) {
        self.0.store(false, Ordering::SeqCst);
    }
}

/// Request of a stage's thread to the caller's thread.
enum Request {
    Event(String),
    Observe,
    Finish,
    Done(Result<Stage, RunError>),
}

/// Reply to a request.
enum Reply {
    Flow(ControlFlow<()>),
    Observation(Result<Option<Observation>, ExecutorError>),
    Finished(Result<(), ExecutorError>),
}

/// The executor for a stage's thread.
struct Proxy<'a> {
    ask: &'a Sender<Request>,
    answers: &'a Receiver<Reply>,
}

impl Executor for Proxy<'_> {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        NoExecutor.execute(order, sink)
    }

    fn observe(&mut self, _: &Task) -> Result<Option<Observation>, ExecutorError> {
        let asked = self.ask.send(Request::Observe).is_ok();
        match self.answers.recv() {
            Ok(Reply::Observation(observation)) if asked => observation,
            _ => Err(ExecutorError::new("interrupted")),
        }
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        let asked = self.ask.send(Request::Finish).is_ok();
        match self.answers.recv() {
            Ok(Reply::Finished(finished)) if asked => finished,
            // An interrupted call has let its executor finish itself.
            _ => Ok(()),
        }
    }
}

/// Arguments of a call to a session.
struct Call<'py> {
    executor: Option<PyExecutor<'py>>,
    on_event: Option<Bound<'py, PyAny>>,
}

impl Call<'_> {
    /// Passes an event to the callback, whose `False` stops the session.
    fn call_back(&self, event: &str) -> PyResult<ControlFlow<()>> {
        let Some(on_event) = &self.on_event else {
            return Ok(ControlFlow::Continue(()));
        };
        let json = on_event.py().import("json")?;
        let event = json.call_method1("loads", (event,))?;
        let answer = on_event.call1((event,))?;
        let goes_on = answer.is_none() || answer.is_truthy()?;
        Ok(if goes_on {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        })
    }
}

/// Returns the event as JSON, if it is published.
fn to_json(events: &mut Events, event: &RunEvent<'_>) -> Option<String> {
    serde_json::to_string(&events.record(event)?).ok()
}

impl PySession {
    /// Creates a session that has not planned yet.
    pub fn new(
        loaded: Arc<LoadedTask>,
        robot: Option<Arc<Robot>>,
        config: RunConfig,
        given: Given,
        record: Option<RunRecord>,
        memory: Option<PathBuf>,
    ) -> Self {
        let belief = loaded.belief();
        let (executor, notes) = (Arc::default(), Arc::default());
        let warnings = memory.and_then(|memory| {
            watch_memory(
                &loaded.task,
                robot.as_deref()?,
                &config,
                memory,
                &executor,
                &notes,
            )
        });
        let wiping = Wiping::new(robot.clone(), |robot| {
            let session = Session::new(&loaded.task, config).with_belief(belief);
            let session = match given {
                Given::Nothing => session,
                Given::Plan(plan) => session.with_plan(Some(plan)),
                Given::Strategy(own) => session.with_strategy(own),
            };
            let session = match warnings {
                Some(watch) => session.with_warnings(watch),
                None => session,
            };
            match robot {
                Some(robot) => session.with_robot(robot.robot_setup()),
                None => session,
            }
        });
        Self {
            task: loaded,
            robot,
            wiping: Arc::new(Mutex::new(wiping)),
            stage: Arc::default(),
            verdict: Arc::default(),
            is_running: AtomicBool::new(false),
            telemetry: Mutex::default(),
            rounds: Mutex::default(),
            record: Arc::new(Mutex::new(record)),
            kept: Mutex::default(),
            executor,
            notes,
            prepared: Arc::default(),
            clock: RunClock::start(),
        }
    }

    /// When the session began, by this machine's clocks.
    pub const fn clock(&self) -> RunClock {
        self.clock
    }

    /// Returns the files of the robot that wipes.
    pub fn robot_files(&self) -> Option<&RobotFiles> {
        self.robot.as_ref().map(|robot| &robot.files)
    }

    fn begin(&self) -> PyResult<Running<'_>> {
        if self.is_running.swap(true, Ordering::SeqCst) {
            return Err(PyRuntimeError::new_err(
                "the session is running; its events show the progress, its results are available afterwards",
            ));
        }
        Ok(Running(&self.is_running))
    }

    /// Returns the session, after an interrupted stage has finished.
    fn lock(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, Wiping>> {
        loop {
            match self.wiping.try_lock() {
                Ok(guard) => return Ok(guard),
                Err(TryLockError::Poisoned(poisoned)) => return Ok(poisoned.into_inner()),
                Err(TryLockError::WouldBlock) => {}
            }
            py.detach(|| std::thread::sleep(LOOK));
            py.check_signals()?;
        }
    }

    /// Returns the completed stage, after an interrupted stage has finished.
    fn wait_for_stage(&self, py: Python<'_>) -> PyResult<Option<Stage>> {
        drop(self.lock(py)?);
        Ok(*lock(&self.stage))
    }

    /// Returns the completed stage of a session that is not running.
    fn idle_stage(&self, py: Python<'_>) -> PyResult<Option<Stage>> {
        let _running = self.begin()?;
        self.wait_for_stage(py)
    }

    /// Reads the session while it is not running.
    fn read<T>(
        &self,
        py: Python<'_>,
        read: impl FnOnce(&Session<'_>) -> PyResult<T>,
    ) -> PyResult<T> {
        let _running = self.begin()?;
        let wiping = self.lock(py)?;
        read(wiping.borrow_dependent())
    }

    /// Class of the last executor.
    pub fn executor(&self) -> Option<String> {
        lock(&self.executor).clone()
    }

    /// Observation before the first round; `None` without a camera.
    pub fn read_first_observation(&self, py: Python<'_>) -> PyResult<Option<Observation>> {
        self.read(py, |session| Ok(session.first_observation().cloned()))
    }

    fn run_until(&self, py: Python<'_>, until: Stage, mut call: Call<'_>) -> PyResult<()> {
        let _running = self.begin()?;
        if let Some(executor) = &mut call.executor {
            let tool = self.task.task.tool.name.clone();
            executor.robot = self.robot.clone().map(|robot| (robot, tool));
            executor.prepared = Arc::clone(&self.prepared);
            let held = lock(&self.prepared);
            let is_other = held
                .as_ref()
                .is_some_and(|(object, _)| !executor.object.is(object));
            drop(held);
            if is_other {
                self.finish_held(py)?;
            }
        }
        if lock(&self.prepared).is_none() {
            // After an interruption the executor has finished, which the session does not know.
            let mut wiping = self.lock(py)?;
            wiping.with_dependent_mut(|_, session| session.finish_executor(&mut NoExecutor));
        }
        let run = self.run_stages(py, until, &mut call);
        let warned = self.finish_executor(py, run.is_err());
        // An interrupted stage may still be running on its thread; nobody waits for it here.
        if *lock(&self.stage) != Some(Stage::Ended) {
            return run.and(warned);
        }
        let kept = self.finish_record(py);
        if let (Err(_), Err(lost)) = (&run, &kept) {
            // The run's own error is raised; what could not be stored is a remark.
            let text = format!("some results could not be stored: {}", lost.value(py));
            let mut kept = lock(&self.kept);
            kept.get_or_insert_default().remarks.push(text);
        }
        run.and(kept).and(warned)
    }

    /// Writes the session's results so far, once.
    fn finish_record(&self, py: Python<'_>) -> PyResult<()> {
        let wiping = self.lock(py)?;
        let Some(mut record) = lock(&self.record).take() else {
            return Ok(());
        };
        if let (Some(name), Some(episode)) = (self.executor(), record.episode_mut()) {
            episode.set_executor(name);
        }
        let session = wiping.borrow_dependent();
        let mut results = match record.results(session) {
            // A session that has not begun has no results.
            Err(RecordError::Nothing) => return Ok(()),
            results => results.map_err(of_record)?,
        };
        let rounds = session.rounds().to_vec();
        results.add_rounds(
            rounds,
            record.stages_mut(),
            ExecutedBy::Executor,
            Vec::new(),
        );
        let first_observation = session.first_observation().cloned();
        let robot = self.robot.as_deref();
        let kept = py.detach(|| record.finish_with(&self.task, robot, results, first_observation));
        let kept = kept.map_err(of_record)?;
        let (episode, lost) = match kept.episode {
            Ok(episode) => (episode, None),
            Err(error) => (None, Some(error)),
        };
        // The stored results are stated even if a part is missing.
        *lock(&self.kept) = Some(StoredResults {
            episode: episode.as_ref().map(|kept| kept.id.clone()),
            remarks: episode.map_or_else(Vec::new, |mut kept| {
                let without = kept
                    .without
                    .iter()
                    .map(|what| format!("the episode was stored without {what}"));
                kept.remarks.extend(without);
                kept.remarks.append(&mut lock(&self.notes));
                kept.remarks
            }),
        });
        let lost = lost.or(kept.results_error).or(kept.no_bag).or(kept.failure);
        lost.map_or(Ok(()), |error| Err(of_record(error)))
    }

    /// Lets the executor of an interrupted session finish, and warns if an executor could not.
    fn finish_executor(&self, py: Python<'_>, is_interrupted: bool) -> PyResult<()> {
        let mut failure = None;
        if is_interrupted {
            let finished = finish_prepared(py, &self.prepared);
            failure = finished.err().map(|error| error.to_string());
        }
        if *lock(&self.stage) == Some(Stage::Ended) {
            let wiping = self.lock(py)?;
            let of_session = wiping.borrow_dependent().finish_failure();
            failure = failure.or(of_session.map(ToString::to_string));
        }
        failure.map_or(Ok(()), |failure| warn_unfinished(py, &failure))
    }

    /// Lets the prepared executor finish although the session may go on, and warns if it could not.
    fn finish_held(&self, py: Python<'_>) -> PyResult<()> {
        let finished = finish_prepared(py, &self.prepared);
        finished.or_else(|error| warn_unfinished(py, &error.to_string()))
    }

    fn run_stages(&self, py: Python<'_>, until: Stage, call: &mut Call<'_>) -> PyResult<()> {
        if let Some(executor) = &call.executor {
            let class = executor.object.get_type().name()?;
            *lock(&self.executor) = Some(class.to_string());
        }
        loop {
            let before = self.wait_for_stage(py)?;
            let reached = if before == Some(Stage::Audited) && call.executor.is_some() {
                self.execute(py, call)
            } else {
                self.advance(py, call)
            };
            let reached = reached?;
            if reached == until || reached == Stage::Ended {
                return Ok(());
            }
            py.check_signals()?;
        }
    }

    /// Returns the exception of an error, or the executor's own exception.
    fn failed(&self, error: &RunError, executor: Option<&mut PyExecutor<'_>>) -> PyErr {
        let raised = executor.and_then(|executor| executor.raised.take());
        raised.unwrap_or_else(|| of_run(&self.task.path.display().to_string(), error))
    }

    /// Runs a stage that executes nothing, on a thread of its own.
    fn advance(&self, py: Python<'_>, call: &mut Call<'_>) -> PyResult<Stage> {
        drop(self.lock(py)?);
        let (ask, asked) = channel();
        let (answer, answers) = channel();
        let (wiping, verdict) = (Arc::clone(&self.wiping), Arc::clone(&self.verdict));
        let stage = Arc::clone(&self.stage);
        let tells = call.on_event.is_some();
        let record = Arc::clone(&self.record);
        std::thread::spawn(move || {
            let mut wiping = lock(&wiping);
            let mut events = EventWriter::new(std::io::sink());
            let mut proxy = Proxy {
                ask: &ask,
                answers: &answers,
            };
            let done = wiping.with_dependent_mut(|_, session| {
                session.step(&mut proxy, &mut |event| {
                    if let RunEvent::Ended(end) = event {
                        *lock(&verdict) = *end;
                    }
                    let flow = keep(&record, event);
                    let json = tells.then(|| to_json(&mut events, event)).flatten();
                    let Some(json) = json else {
                        return flow;
                    };
                    if ask.send(Request::Event(json)).is_err() {
                        return flow;
                    }
                    match answers.recv() {
                        Ok(Reply::Flow(answered)) if answered.is_break() => answered,
                        _ => flow,
                    }
                })
            });
            // The receiver may be gone.
            *lock(&stage) = Some(*done.as_ref().unwrap_or(&Stage::Ended));
            drop(wiping);
            let _ = ask.send(Request::Done(done));
        });
        let mut asked = Some(asked);
        loop {
            let receiver = asked.take();
            let (request, receiver) = py.detach(move || {
                let request = receiver
                    .as_ref()
                    .map(|receiver| receiver.recv_timeout(LOOK));
                (request, receiver)
            });
            asked = receiver;
            match request {
                Some(Err(RecvTimeoutError::Timeout)) => py.check_signals()?,
                Some(Err(RecvTimeoutError::Disconnected)) | None => {
                    return Err(PyRuntimeError::new_err(
                        "internal error: a stage of the session panicked; please report it",
                    ));
                }
                Some(Ok(Request::Event(event))) => {
                    let flow = call.call_back(&event)?;
                    let _ = answer.send(Reply::Flow(flow));
                }
                Some(Ok(Request::Observe)) => {
                    let observation = match &call.executor {
                        Some(executor) => executor.call_observe()?,
                        None => None,
                    };
                    let _ = answer.send(Reply::Observation(Ok(observation)));
                }
                Some(Ok(Request::Finish)) => {
                    let finished = match &mut call.executor {
                        Some(executor) => executor.finish(),
                        None => finish_prepared(py, &self.prepared).map_err(ExecutorError::new),
                    };
                    let _ = answer.send(Reply::Finished(finished));
                }
                Some(Ok(Request::Done(Ok(stage)))) => return Ok(stage),
                Some(Ok(Request::Done(Err(error)))) => {
                    return Err(self.failed(&error, call.executor.as_mut()));
                }
            }
        }
    }

    /// Executes the current motion.
    fn execute(&self, py: Python<'_>, call: &mut Call<'_>) -> PyResult<Stage> {
        let mut wiping = self.lock(py)?;
        let mut executor = call.executor.take();
        let mut columns = Columns::default();
        let mut number = None;
        let mut events = EventWriter::new(std::io::sink());
        let mut refused: Option<PyErr> = None;
        let mut no_executor = NoExecutor;
        let done = wiping.with_dependent_mut(|_, session| {
            let world: &mut dyn Executor = match &mut executor {
                Some(executor) => executor,
                None => &mut no_executor,
            };
            session.step(world, &mut |event| {
                match event {
                    RunEvent::Executing(planned) => number = Some(planned.number),
                    RunEvent::Sample(sample) => columns.push(sample),
                    _ => {}
                }
                let flow = keep(&self.record, event);
                if call.on_event.is_none() {
                    return flow;
                }
                let Some(json) = to_json(&mut events, event) else {
                    return flow;
                };
                let answered = call.call_back(&json).unwrap_or_else(|error| {
                    refused.get_or_insert(error);
                    ControlFlow::Break(())
                });
                answered?;
                flow
            })
        });
        drop(wiping);
        call.executor = executor;
        // Telemetry is stored whether or not the execution succeeds.
        if let Some(number) = number {
            let telemetry = PyTelemetry::from_columns(py, number, columns)?;
            lock(&self.telemetry).push(telemetry);
        }
        let interrupted = call.executor.as_mut().and_then(|executor| {
            let is_interrupted =
                |error: &mut PyErr| error.is_instance_of::<PyKeyboardInterrupt>(py);
            executor.raised.take_if(is_interrupted)
        });
        *lock(&self.stage) = Some(*done.as_ref().unwrap_or(&Stage::Ended));
        if let Some(error) = refused.or(interrupted) {
            return Err(error);
        }
        done.map_err(|error| self.failed(&error, call.executor.as_mut()))
    }

    fn planned_plan(&self, session: &Session<'_>) -> PyResult<PyPlan> {
        let plan = session.plan();
        let plan = plan.ok_or_else(|| plain("there is no plan: the session has ended"))?;
        let task = session
            .planned_round()
            .map_or(&self.task.task, |planned| &planned.task);
        Ok(PyPlan::new(task, plan.clone()))
    }
}

fn seconds(timeout: Option<f64>) -> PyResult<Option<Duration>> {
    let Some(seconds) = timeout else {
        return Ok(None);
    };
    let duration = Duration::try_from_secs_f64(seconds).ok();
    let duration = duration.filter(|duration| !duration.is_zero());
    duration
        .map(Some)
        .ok_or_else(|| refused("timeout", seconds, "a time above 0 s"))
}

fn call<'py>(
    executor: Option<Bound<'py, PyAny>>,
    on_event: Option<Bound<'py, PyAny>>,
    timeout: Option<f64>,
) -> PyResult<Call<'py>> {
    let timeout = seconds(timeout)?;
    if let Some(executor) = &executor
        && !executor.hasattr("execute")?
    {
        let found = crate::arrays::kind_of(executor);
        let wanted = "an object with execute(motion, sink)";
        return Err(refused("executor", found, wanted));
    }
    Ok(Call {
        executor: executor.map(|object| PyExecutor {
            object,
            timeout,
            raised: None,
            robot: None,
            prepared: Arc::default(),
        }),
        on_event,
    })
}

#[pymethods]
impl PySession {
    /// Plans the current round.
    #[pyo3(signature = (executor = None, *, on_event = None))]
    fn plan(
        &self,
        py: Python<'_>,
        executor: Option<Bound<'_, PyAny>>,
        on_event: Option<Bound<'_, PyAny>>,
    ) -> PyResult<PyPlan> {
        if self.idle_stage(py)?.is_none() {
            self.run_until(py, Stage::Planned, call(executor, on_event, None)?)?;
        }
        self.read(py, |session| self.planned_plan(session))
    }

    /// Continues to the joint motion of the plan.
    #[pyo3(signature = (executor = None, *, on_event = None))]
    fn follow(
        &self,
        py: Python<'_>,
        executor: Option<Bound<'_, PyAny>>,
        on_event: Option<Bound<'_, PyAny>>,
    ) -> PyResult<PyMotion> {
        if matches!(self.idle_stage(py)?, None | Some(Stage::Planned)) {
            self.run_until(py, Stage::Followed, call(executor, on_event, None)?)?;
        }
        self.read(py, |session| {
            let planned = session.planned_round().map(PyMotion::from_round);
            planned.ok_or_else(|| plain("there is no motion: the session has ended"))
        })
    }

    /// Continues to the check of the motion.
    #[pyo3(signature = (executor = None, *, on_event = None))]
    fn audit(
        &self,
        py: Python<'_>,
        executor: Option<Bound<'_, PyAny>>,
        on_event: Option<Bound<'_, PyAny>>,
    ) -> PyResult<PyAudit> {
        let stage = self.idle_stage(py)?;
        if matches!(stage, None | Some(Stage::Planned | Stage::Followed)) {
            self.run_until(py, Stage::Audited, call(executor, on_event, None)?)?;
        }
        self.read(py, |session| {
            let audit = session.audit().map(PyAudit::new);
            audit.ok_or_else(|| plain("there is no motion: the session has ended"))
        })
    }

    /// Continues to the end, and returns the rounds.
    #[pyo3(signature = (executor, *, on_event = None, timeout = None))]
    fn run(
        &self,
        py: Python<'_>,
        executor: Bound<'_, PyAny>,
        on_event: Option<Bound<'_, PyAny>>,
        timeout: Option<f64>,
    ) -> PyResult<Vec<Py<PyRound>>> {
        let call = call(Some(executor), on_event, timeout)?;
        self.run_until(py, Stage::Ended, call)?;
        self.rounds(py)
    }

    /// Continues until the next verdict or the end of the session, and returns the rounds so far.
    #[pyo3(signature = (executor, *, on_event = None, timeout = None))]
    fn run_round(
        &self,
        py: Python<'_>,
        executor: Bound<'_, PyAny>,
        on_event: Option<Bound<'_, PyAny>>,
        timeout: Option<f64>,
    ) -> PyResult<Vec<Py<PyRound>>> {
        let call = call(Some(executor), on_event, timeout)?;
        self.run_until(py, Stage::Decided, call)?;
        self.rounds(py)
    }

    /// Finished rounds.
    #[getter]
    pub fn rounds(&self, py: Python<'_>) -> PyResult<Vec<Py<PyRound>>> {
        self.read(py, |session| {
            let mut kept = lock(&self.rounds);
            let all = session.rounds();
            for round in &all[kept.len().min(all.len())..] {
                let telemetry = lock(&self.telemetry);
                let of_round = telemetry
                    .iter()
                    .rfind(|t| t.get().is_of(round.motion.number));
                let telemetry = of_round.map(|telemetry| telemetry.clone_ref(py));
                let round = PyRound::new(round, telemetry, &self.task.run.plan);
                kept.push(Py::new(py, round)?);
            }
            // The last verdict is given at the end of the session.
            if let (Some(round), Some(last)) = (all.last(), kept.last_mut())
                && last.get().round.verdict != round.verdict
            {
                let telemetry = last.get().telemetry.as_ref().map(|t| t.clone_ref(py));
                let renewed = PyRound::new(round, telemetry, &self.task.run.plan);
                *last = Py::new(py, renewed)?;
            }
            Ok(kept.iter().map(|round| round.clone_ref(py)).collect())
        })
    }

    /// Telemetry of every motion, including one that failed.
    #[getter]
    fn telemetry(&self, py: Python<'_>) -> Vec<Py<PyTelemetry>> {
        let telemetry = lock(&self.telemetry);
        telemetry.iter().map(|one| one.clone_ref(py)).collect()
    }

    /// Completed stage: planned, followed, audited, executed, interpreted, decided or ended; `None` before the first.
    #[getter]
    fn stage(&self) -> Option<&'static str> {
        (*lock(&self.stage)).map(|stage| match stage {
            Stage::Planned => "planned",
            Stage::Followed => "followed",
            Stage::Audited => "audited",
            Stage::Executed => "executed",
            Stage::Interpreted => "interpreted",
            Stage::Decided => "decided",
            Stage::Ended => "ended",
        })
    }

    /// Why the session has ended; `None` before its end, or if it was stopped.
    #[getter]
    fn verdict(&self) -> Option<&'static str> {
        (*lock(&self.verdict)).map(Verdict::as_str)
    }

    /// Detections before the first round, (k, 2) in the frame of the surface [m]; `None` without a camera.
    #[getter]
    fn first_observation<'py>(&self, py: Python<'py>) -> PyResult<Option<Matrix<'py>>> {
        self.read(py, |session| {
            let observation = session.first_observation();
            Ok(observation.map(|it| arrays::points(py, it.detections.iter().copied())))
        })
    }

    /// Writes the session's results, unless they are written, and lets a prepared executor finish; the end of a session does
    /// both by itself.
    fn close(&self, py: Python<'_>) -> PyResult<()> {
        let _running = self.begin()?;
        let finished = self.finish_held(py);
        self.finish_record(py).and(finished)
    }

    fn __enter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __exit__(
        &self,
        py: Python<'_>,
        _class: Option<&Bound<'_, PyAny>>,
        _error: Option<&Bound<'_, PyAny>>,
        _trace: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        self.close(py)
    }

    /// Name of the session's episode, once it has ended; `None` without a memory.
    #[getter]
    fn episode(&self) -> Option<String> {
        lock(&self.kept).as_ref()?.episode.clone()
    }

    /// Remarks on the stored results, a sentence each.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        (lock(&self.kept).as_ref()).map_or_else(Vec::new, |kept| kept.remarks.clone())
    }

    /// Rounds as a table, for notebooks.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        let rounds = self.rounds(py)?;
        let rounds: Vec<&Round> = rounds.iter().map(|round| &*round.get().round).collect();
        Ok(pictures::table(
            &self.task.task.name,
            &rounds,
            self.verdict(),
        ))
    }

    fn __repr__(&self) -> String {
        let stage = self.stage().unwrap_or("new");
        format!("<wisch.Session of {:?}: {stage}>", self.task.task.name)
    }
}

/// Warns that an executor did not finish.
fn warn_unfinished(py: Python<'_>, failure: &str) -> PyResult<()> {
    let text = format!("the robot is not handed back, because finish() failed: {failure}");
    let category = py.get_type::<PyRuntimeWarning>();
    py.import("warnings")?
        .call_method1("warn", (text, category))?;
    Ok(())
}
