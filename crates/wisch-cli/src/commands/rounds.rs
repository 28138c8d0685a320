//! The closed loop of `wisch run`: rounds of planning, wiping and interpreting, with their records.

use super::PROGRAM;
use super::interrupt::{UnfinishedRun, delay_signals, pause_on_signal, say_how_to_resume};
use super::job::{Job, RoundStart, add_kept_times, list_truths};
use super::prepare::stage_failure;
use super::replaceable::check_events;
use super::ros2::OperatedRobot;
use super::warnings::watch_for_warnings;
use super::watch::Watch;
use super::words::{format_count, internal, json};
use crate::args::{GlobalArgs, LoopArgs, options_for};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, MutexGuard};
use std::time::Duration;
use wisch::follow::{Workcell, WorkcellConfig};
use wisch::plan::Plan;
use wisch::run::{
    Ending, Executor, NoExecutor, Recording, Round, RunError, RunEvent, Session, Stage,
};
use wisch_io::{
    DriverRobotRecord, ExecutedBy, LoadedTask, OutputFolder, PlanRecord, ProcessExecutor,
    ProcessOptions, Robot,
};
use wisch_record::{
    EpisodeTarget, EventSink, KeptEpisode, RecordError, RecordOptions, RunRecord, RunResults,
    bag_name,
};
use wisch_report::CommandOptions;
use wisch_sim::{CheckpointRound, Checkpoints, GroundTruth, WorkSurface, World};
use wisch_telemetry::read_samples;

/// File in a run's state folder with the names of its episodes.
const EPISODES_FILE: &str = "episodes";

/// The kept episode, `None` with `--no-memory`, or the reason why it was not kept.
pub type Kept = Result<Option<KeptEpisode>, Failure>;

/// The results of an executed run.
pub struct Executed {
    /// The results of the rounds.
    pub results: RunResults,
    /// The kept episode.
    pub kept: Kept,
    /// The failure that ended the run early, if there was one; the results hold the rounds until then.
    pub broken: Option<Failure>,
}

/// Wipes until the goal is met, the termination policy ends the run, or `stop` is set; then keeps the episode.
pub fn execute(
    job: &Job<'_>,
    args: &LoopArgs,
    start: RoundStart<'_>,
    stop: Option<&Arc<AtomicBool>>,
    global: &GlobalArgs,
) -> Result<Executed, Failure> {
    let (chosen, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
    let identity = digest_run(job.prepared, robot, args, start.given.as_ref())?;
    let checkpoints = Checkpoints::new(&job.folder.checkpoint_folder(), identity);
    let killed = rounds_of_killed_run(job, &checkpoints)?;
    let taken_over: Vec<f64> = killed.iter().map(|round| round.executing_s).collect();
    let workcell = super::follow::workcell_config(chosen, job.prepared);
    let options = record_options(job, args, taken_over.len(), workcell);
    let memory = options.episode.clone();
    let mut record = RunRecord::begin(job.prepared, Some(robot), options)?;
    let warnings = memory.and_then(|memory| watch_for_warnings(job, &memory, taken_over.len()));
    record.remarks().iter().for_each(|text| remark(text));
    if let (true, Some(episode)) = (killed.is_empty(), record.episode_mut()) {
        episode.keep_interrupted_episodes();
    }
    if args.resume && job.folder.leftovers().is_taken_over {
        let rounds = format_count(killed.len(), "round");
        let text = format!("resuming after {rounds} of the killed run");
        job.progress.aside(|| remark(&text));
    }
    // A run with a stop flag ends cleanly and is not resumed; neither is a run of an external executor.
    if stop.is_none() {
        say_how_to_resume(job.progress, killed.len());
    }
    if let Some(path) = &args.events {
        record.add(Box::new(event_sink(path)?));
    }
    if stop.is_none() {
        job.prepared
            .files
            .write_to(&job.folder.checkpoint_folder())?;
    }
    let mut executor = start_executing(job, args, killed, stop, global)?;
    let mut sinks = Sinks {
        watch: Watch::new(job, checkpoints, taken_over.len(), args.realtime),
        record,
        folder: job.folder,
        stop,
        deciding: None,
        is_moving: false,
    };
    let (is_given, kept_times) = (start.given.is_some(), start.kept_times());
    let mut session = job.session(job.config(Some(args)), start);
    if let Some(warnings) = warnings {
        session = session.with_warnings(warnings);
    }
    let run = sinks.run(&mut session, &mut executor, &taken_over);
    sinks.record.end_bags();
    add_kept_times(sinks.record.stages_mut(), &session, kept_times);
    if let Some(error) = session.finish_failure() {
        let text = format!("the robot is not handed back, because finish failed: {error}");
        job.progress.aside(|| remark(&text));
    }
    // The executor's process ends before the results are written.
    executor.end();
    let run = run.err().map(|error| job.failed(error));
    let finished = session.rounds().len();
    let broken = match sinks.record.take_failure().map(Failure::from).or(run) {
        Some(failure) if finished == 0 => return Err(failure),
        broken => broken,
    };
    sinks.say_if_interrupted(session.rounds(), job.progress)?;
    let first_observation = session.first_observation().cloned();
    let Sinks { mut record, .. } = sinks;
    let mut results = results(job, args, session, executor.truth(), &mut record)?;
    if is_given {
        results.planning_time_s = None;
    }
    let kept = record.keep(job.prepared, Some(robot), results, first_observation)?;
    let episode = kept.episode.map_err(Failure::from);
    if let Some(error) = kept.no_bag {
        remark_episode_folder(&episode);
        return Err(error.into());
    }
    Ok(Executed {
        results: kept.results,
        kept: episode,
        broken,
    })
}

/// Options of the run's record: bags, episode and live page.
fn record_options(
    job: &Job<'_>,
    args: &LoopArgs,
    taken_over: usize,
    workcell: WorkcellConfig,
) -> RecordOptions {
    let bags = job.folder.file_path(&bag_name(1));
    let on_robot = args.on.is_some().then(|| "wisch-ros2".to_owned());
    let episode = (!args.memory.no_memory && args.air.is_none()).then(|| EpisodeTarget {
        memory: args.memory.memory.clone(),
        executor: args.executor.as_deref().map(find_program_name).or(on_robot),
        names: Some(job.folder.checkpoint_folder().join(EPISODES_FILE)),
        clock: Some(job.clock),
    });
    RecordOptions {
        program: PROGRAM.to_owned(),
        bags: bags.parent().map(Path::to_path_buf),
        taken_over,
        episode,
        is_live: args.live,
        workcell: Some(workcell),
        options: Some(command_options(args)),
        ..RecordOptions::default()
    }
}

/// Returns the options with which the page suggests commands. The recording knows task, settings, senses and seed.
fn command_options(args: &LoopArgs) -> CommandOptions {
    let known = ["set", "seed", "touch-only", "live"];
    CommandOptions {
        run: options_for("run", &known),
        rounds: (args.rounds).map_or_else(String::new, |rounds| format!("--rounds {rounds}")),
        check: options_for("check", &known),
        plan: options_for("plan", &known),
    }
}

/// Reads the completed rounds of a killed run; only their bags stay in the folder. Those of another run are an error, and stay
/// as they are.
fn rounds_of_killed_run(
    job: &Job<'_>,
    checkpoints: &Checkpoints,
) -> Result<Vec<CheckpointRound>, Failure> {
    let folder = job.folder;
    if !folder.leftovers().is_taken_over {
        return Ok(Vec::new());
    }
    let others = checkpoints.count_rounds_of_another_run();
    if others > 0 {
        let (place, rounds) = (folder.target().display(), format_count(others, "round"));
        return Err(Failure::new(format!(
            "{place}: the killed run, which completed {rounds}, had another task, seed, setting or version of wisch"
        ))
        .with_help("repeat its command with --resume; without --resume, what it left is removed"));
    }
    let samples = |number| {
        let mut samples = Vec::new();
        let bag = folder.file_path(&bag_name(number));
        read_samples(&bag, |sample| samples.push(sample)).ok()?;
        Some(samples)
    };
    let kept: Vec<CheckpointRound> = checkpoints.read(samples).collect();
    let bags: Vec<String> = (1..=kept.len()).map(bag_name).collect();
    folder.keep_only(&bags)?;
    Ok(kept)
}

/// Starts the executor: the program of `--executor`, the robot of `--on`, or a simulated world in its state after a killed
/// run's rounds.
fn start_executing(
    job: &Job<'_>,
    args: &LoopArgs,
    kept: Vec<CheckpointRound>,
    stop: Option<&Arc<AtomicBool>>,
    global: &GlobalArgs,
) -> Result<Executing, Failure> {
    if args.on.is_some() {
        let robot = OperatedRobot::start(args, global, process_options(job, args, stop)?)?;
        return Ok(Executing::Process(Box::new(robot)));
    }
    if let Some(command) = &args.executor {
        let process = start(command, process_options(job, args, stop)?)?;
        return Ok(Executing::Process(Box::new(process)));
    }
    let prepared = job.prepared;
    let first_observation = kept
        .first()
        .and_then(|round| round.first_observation.clone());
    let (recorded, truth) = kept.into_iter().map(|r| (r.recorded, r.truth)).unzip();
    let (task, reality) = (&prepared.task, prepared.simulation.clone());
    if let Some(count) = reality.count_over_limit() {
        let limit = reality.max_bodies;
        let text = format!(
            "{count} particles exceed the simulator's limit of {limit} (execution.max_bodies): it simulates no dirt, and the camera is off"
        );
        job.progress.aside(|| remark(&text));
    }
    let world = World::new(&WorkSurface::from_task(task), reality, task.seed)
        .map_err(|error| stage_failure(job.task_args, error))?
        .with_history(truth);
    let recording = Recording::new(first_observation, recorded, world);
    Ok(Executing::World(Box::new(recording)))
}

/// Collects the results of the rounds.
fn results(
    job: &Job<'_>,
    args: &LoopArgs,
    session: Session<'_>,
    truth: &[GroundTruth],
    record: &mut RunRecord,
) -> Result<RunResults, Failure> {
    let prepared = job.prepared;
    let mut results = record.results(&session)?;
    let executed_by = if args.has_executor() {
        ExecutedBy::Executor
    } else {
        ExecutedBy::SimulatedWorld
    };
    let rounds = session.into_rounds();
    let truths = list_truths(prepared, &rounds, truth)
        .map_err(|error| stage_failure(job.task_args, error))?;
    let later = prepared.simulation.pushes.iter().map(|push| push.round);
    let later = later.filter(|_| !args.has_executor());
    for round in later.filter(|round| *round > rounds.len()) {
        let count = format_count(rounds.len(), "round");
        let text = format!(
            "the task's push in round {round} did not happen, because the run ended after {count}"
        );
        job.progress.aside(|| remark(&text));
    }
    results.add_rounds(rounds, record.stages_mut(), executed_by, truths);
    Ok(results)
}

/// The receivers of the loop's events.
struct Sinks<'a> {
    watch: Watch<'a>,
    record: RunRecord,
    folder: &'a OutputFolder,
    /// Set by signals to end the run cleanly.
    stop: Option<&'a Arc<AtomicBool>>,
    /// Delays other signals while a round is decided and has no checkpoint yet.
    deciding: Option<MutexGuard<'static, Option<UnfinishedRun>>>,
    /// Whether a motion has begun that has no verdict yet.
    is_moving: bool,
}

impl Sinks<'_> {
    /// Runs the session to its end and writes a checkpoint after each round, from which a killed run can be resumed.
    fn run(
        &mut self,
        session: &mut Session<'_>,
        executor: &mut Executing,
        taken_over: &[f64],
    ) -> Result<(), RunError> {
        loop {
            let finished = session.rounds().len();
            let stage = session.step(executor.as_dyn(), &mut |event| self.on_event(event));
            // A round that ended with an error is no checkpoint.
            if stage.is_ok()
                && let [.., round] = &session.rounds()[finished..]
            {
                let number = round.motion.number;
                if let Some(seconds) = taken_over.get(finished) {
                    self.record.stages_mut().round(number).executing_s = *seconds;
                } else if let Some(truth) = executor.truth().last()
                    && self.keep_checkpoint(session, round, truth)
                    && let Some(run) = self.deciding.as_mut().and_then(|run| run.as_mut())
                {
                    run.kept = number;
                    self.folder.keep_if_interrupted();
                }
            }
            self.deciding = None;
            match stage {
                Ok(Stage::Ended) => return Ok(()),
                Ok(_) => {}
                // An executor that waits between two motions answers a stop with an error.
                Err(RunError::Execute(error))
                    if error.is_interruption() && !self.is_moving && finished > 0 =>
                {
                    let _ = self.record.on_event(&RunEvent::Ended(None));
                    return Ok(());
                }
                Err(error) => return Err(error),
            }
        }
    }

    fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::SeqCst))
    }

    /// Prints a note that a signal ended the run, with the number of kept `rounds`. Zero rounds are an error.
    fn say_if_interrupted(&self, rounds: &[Round], progress: &Progress) -> Result<(), Failure> {
        if !self.is_stopped() {
            return Ok(());
        }
        let Some(last) = rounds.last() else {
            return Err(Failure::new(
                "interrupted before the first motion; nothing is kept",
            ));
        };
        let part = match last.execution.ending {
            Ending::Complete => "",
            _ => "; the last round holds its executed part",
        };
        let count = format_count(rounds.len(), "round");
        progress.aside(|| remark(&format!("interrupted: {count} kept{part}")));
        Ok(())
    }

    /// Passes an event to the record and the progress; `Break` ends the loop.
    fn on_event(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        let flow = self.record.on_event(event);
        if let RunEvent::Warned(warning) = event {
            self.watch.say(&format!("warning: {warning}"));
        }
        self.watch.on_event(event);
        match event {
            RunEvent::Executing(_) => self.is_moving = true,
            RunEvent::Decided(_) => self.is_moving = false,
            _ => {}
        }
        if self.stop.is_none() && matches!(event, RunEvent::Decided(_)) {
            self.deciding = Some(delay_signals());
        }
        // The record and the progress have received the event, so the loop can end here.
        if self.is_stopped() {
            return ControlFlow::Break(());
        }
        flow
    }

    /// Writes the checkpoint of a round; returns whether that succeeded.
    fn keep_checkpoint(
        &mut self,
        session: &Session<'_>,
        round: &Round,
        truth: &GroundTruth,
    ) -> bool {
        if self.record.has_failed() {
            return false;
        }
        let stages = self.record.stages_mut().round(round.motion.number);
        let seconds = stages.executing_s;
        let first_observation = session.first_observation();
        let kept = self
            .watch
            .checkpoints
            .keep(round, first_observation, truth, seconds);
        let kept = kept.map_err(|error| RecordError::State {
            place: self.watch.state.clone(),
            error,
        });
        kept.map_err(|error| self.record.abandon_bags(error))
            .is_ok()
    }
}

/// Prints a note with the folder of a kept episode, after the results failed.
pub fn remark_episode_folder(kept: &Kept) {
    if let Ok(Some(kept)) = kept {
        let place = kept.place.display();
        remark(&format!("the episode was kept in {place}"));
    }
}

/// Returns a digest of all inputs that change a run. The maximum number of rounds is not part of it.
fn digest_run(
    prepared: &LoadedTask,
    robot: &Robot,
    args: &LoopArgs,
    given: Option<&Plan>,
) -> Result<u64, Failure> {
    let mut inputs = prepared.inputs.clone();
    robot.files.add_to(&mut inputs);
    inputs.add("pace", if args.greedy { "greedy" } else { "whole" });
    if let Some(plan) = given {
        let record = PlanRecord::new(&prepared.task, plan, prepared.run.plan.seed);
        inputs.add("plan", json(&record)?);
    }
    Ok(inputs.value())
}

/// The executor of the motions.
enum Executing {
    World(Box<Recording<World>>),
    /// A program of `--executor`, or the robot of `--on`.
    Process(Box<dyn Executor>),
    /// A process that has ended.
    Ended(NoExecutor),
}

impl Executing {
    fn as_dyn(&mut self) -> &mut dyn Executor {
        match self {
            Self::World(world) => world.as_mut(),
            Self::Process(process) => process.as_mut(),
            Self::Ended(nothing) => nothing,
        }
    }

    /// The simulated world's ground truth of each round; empty for another process.
    fn truth(&self) -> &[GroundTruth] {
        match self {
            Self::World(world) => world.inner().truth(),
            Self::Process(_) | Self::Ended(_) => &[],
        }
    }

    /// Ends the process; a simulated world keeps its ground truth.
    fn end(&mut self) {
        if matches!(self, Self::Process(_)) {
            *self = Self::Ended(NoExecutor);
        }
    }
}

/// Returns the settings of an executor in another process.
fn process_options(
    job: &Job<'_>,
    args: &LoopArgs,
    stop: Option<&Arc<AtomicBool>>,
) -> Result<ProcessOptions, Failure> {
    let (chosen, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
    let task = &job.prepared.task;
    let config = super::follow::workcell_config(chosen, job.prepared);
    let cell = Workcell::new(robot.model.clone(), robot.srdf.as_ref(), task, &config)
        .map_err(|error| job.failed(error.into()))?;
    Ok(ProcessOptions {
        silence: Duration::from_secs_f64(args.timeout),
        stop: stop.cloned().unwrap_or_default(),
        pause: pause_on_signal()?,
        robot: Some(DriverRobotRecord::new(robot, &cell, &task.tool.name)),
    })
}

/// Starts the program of `--executor`.
fn start(command: &str, options: ProcessOptions) -> Result<ProcessExecutor, Failure> {
    let words = shlex::split(command).unwrap_or_default();
    let [program, arguments @ ..] = words.as_slice() else {
        return Err(Failure::new(format!(
            "--executor {command:?}: not a command; expected a program and its arguments"
        )));
    };
    ProcessExecutor::start_with(program, arguments, options).map_err(|error| {
        Failure::new(error)
            .with_help("docs/executor-protocol.md describes the messages of an executor")
    })
}

/// The name of the program of `--executor`, without its folder.
fn find_program_name(command: &str) -> String {
    let program = shlex::split(command).and_then(|words| words.into_iter().next());
    let name = program.as_deref().map(Path::new).and_then(Path::file_name);
    name.map_or_else(
        || "executor".to_owned(),
        |name| name.to_string_lossy().into_owned(),
    )
}

/// Opens the file or stream of `--events`.
fn event_sink(path: &Path) -> Result<EventSink<Box<dyn Write + Send>>, Failure> {
    let place = path.display().to_string();
    let output: Box<dyn Write + Send> = if path == Path::new("-") {
        Box::new(std::io::stdout())
    } else {
        check_events(path)?;
        let file = File::create(path).map_err(|error| {
            Failure::new(format!("{place}: cannot write there: {error}"))
                .with_help("choose another file with --events")
        })?;
        Box::new(BufWriter::new(file))
    };
    Ok(EventSink::new(place, output))
}
