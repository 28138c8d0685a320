//! The closed loop of `wisch run`: rounds of planning, wiping and interpreting, with a bag of each.

use super::episode::{EpisodeRecorder, KeptEpisode};
use super::follow::Following;
use super::interrupt::say_how_to_resume;
use super::job::{Done, Job, Results};
use super::packed::packed;
use super::prepare::Prepared;
use super::recording::RunRecording;
use super::watch::{Recorder, Watch, bag_name};
use super::words::{counted, internal, json};
use crate::args::LoopArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use wisch::plan::Plan;
use wisch::represent::Observation;
use wisch::run::{Executor, NoExecutor, Recording, Round, RunEvent, Session, Stage};
use wisch_io::{EventWriter, ExecutedBy, PlanRecord, ProcessExecutor, Robot};
use wisch_sim::{Checkpoints, GroundTruth, KeptRound, Site, World};
use wisch_telemetry::WriteError;

/// An episode that is kept, if one is wanted, or why it is not.
pub type Kept = Result<Option<KeptEpisode>, Failure>;

/// What came of a run.
pub struct Executed {
    pub results: Results,
    pub kept: Kept,
    /// Why it ended before its end, if something failed: what was done until then is in the results.
    pub broken: Option<Failure>,
}

/// Wipes until the goal is met, or no more can be done, or `stop` asks for an end in order, and keeps the episode.
pub fn execute(
    job: &Job<'_>,
    args: &LoopArgs,
    given: Option<Plan>,
    stop: Option<&Arc<AtomicBool>>,
) -> Result<Executed, Failure> {
    let Job {
        prepared,
        folder,
        progress,
        ..
    } = *job;
    let (_, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
    let mut episode = EpisodeRecorder::begin(args, &folder.state())?;
    let recording = match (args.live, episode.id()) {
        (true, Some(id)) => RunRecording::begin_live(job, &args.memory.memory, id)?,
        _ => RunRecording::begin(job)?,
    };
    let identity = identity(prepared, robot, args, given.as_ref())?;
    let checkpoints = Checkpoints::new(&folder.state(), identity);
    let kept = rounds_of_killed_run(job, &checkpoints)?;
    if kept.is_empty() {
        episode.resume_nothing();
    }
    if args.resume && folder.found().is_taken_over {
        let rounds = counted(kept.len(), "round");
        progress.aside(|| remark(&format!("{rounds} of the killed run taken over")));
    }
    // Where a run ends in order it is not resumed, and of what another program executes nothing is kept to go on with.
    let kept_count = match stop {
        None => Some(say_how_to_resume(progress, kept.len())?),
        Some(_) => None,
    };
    let executed_s: Vec<f64> = kept.iter().map(|round| round.executing_s).collect();
    let mut executor = executing(job, args, kept, stop)?;
    let events = (args.events.as_deref())
        .map(|path| Ok::<_, Failure>((path, event_writer(path)?)))
        .transpose()?;
    let mut sinks = Sinks {
        watch: Watch::new(job),
        recorder: Recorder::new(job, checkpoints, executed_s.len(), args.realtime),
        recording,
        episode,
        events,
        no_bag: None,
        is_ended: false,
        stop,
    };
    let is_given = given.is_some();
    let mut session = job.session(job.config(Some(args)), given);
    let result = loop {
        let finished = session.rounds().len();
        let stage = session.step(executor.as_dyn(), &mut |event| sinks.see(event));
        // One that broke off is no round to go on from.
        if stage.is_ok()
            && let [.., round] = &session.rounds()[finished..]
        {
            let number = round.motion.number;
            if let Some(seconds) = executed_s.get(finished) {
                sinks.watch.round(number).times.executing_s = *seconds;
            } else if let Some(truth) = executor.truth().last()
                && sinks.checkpoint(round, session.first_observation(), truth)?
                && let Some(count) = &kept_count
            {
                count.store(number, Ordering::SeqCst);
            }
        }
        match stage {
            Ok(Stage::Ended) => break Ok(()),
            Ok(_) => {}
            Err(error) => break Err(error),
        }
    };
    if let Err(failure) = sinks.recorder.end().map_err(cannot_write) {
        sinks.no_bag.get_or_insert(failure);
    }
    // The child that was told to stop is gone before the results are written.
    executor.end();
    let failed = result.err().map(|error| job.failed(error));
    let finished = session.rounds().len();
    let broken = match sinks.watch.failure.take().or(failed) {
        Some(failure) if finished == 0 => return Err(failure),
        broken => broken,
    };
    sinks.say_if_interrupted(finished, progress)?;
    let first_look = session.first_observation().cloned();
    let mut results = results(job, args, session, executor.truth(), &mut sinks.watch)?;
    if is_given {
        results.planning_time_s = None;
    }
    sinks.end(job, first_look, broken, results)
}

/// The rounds of a killed run that are whole; their bags stay in the folder.
fn rounds_of_killed_run(
    job: &Job<'_>,
    checkpoints: &Checkpoints,
) -> Result<Vec<KeptRound>, Failure> {
    let folder = job.folder;
    if !folder.found().is_taken_over {
        return Ok(Vec::new());
    }
    let rounds = (1..).zip(checkpoints.read());
    let whole = rounds.take_while(|(number, _)| folder.place(&bag_name(*number)).is_file());
    let kept: Vec<KeptRound> = whole.map(|(_, kept)| kept).collect();
    let bags: Vec<String> = (1..=kept.len()).map(bag_name).collect();
    folder.keep_only(&bags)?;
    Ok(kept)
}

/// What executes the motions: the program of `--executor`, or a simulated world after the rounds of a killed run.
fn executing(
    job: &Job<'_>,
    args: &LoopArgs,
    kept: Vec<KeptRound>,
    stop: Option<&Arc<AtomicBool>>,
) -> Result<Executing, Failure> {
    if let Some(command) = &args.executor {
        return Ok(Executing::Process(start(command, args.timeout, stop)?));
    }
    let prepared = job.prepared;
    let first_look = kept.first().and_then(|round| round.first_look.clone());
    let (recorded, truth) = kept.into_iter().map(|r| (r.recorded, r.truth)).unzip();
    let (task, reality) = (&prepared.task, prepared.reality.clone());
    let world = World::new(&Site::of(task), reality, task.seed)
        .map_err(|error| prepared.failure(job.task_args, error))?
        .after(truth);
    let recording = Recording::new(first_look, recorded, world);
    Ok(Executing::World(Box::new(recording)))
}

/// What came of the rounds.
fn results(
    job: &Job<'_>,
    args: &LoopArgs,
    session: Session<'_>,
    truth: &[GroundTruth],
    watch: &mut Watch<'_>,
) -> Result<Results, Failure> {
    let prepared = job.prepared;
    let following = Following::of(&session, watch.round(1).times.following_s);
    let (planned, _) = (session.first()).ok_or_else(|| internal("no round was planned"))?;
    let (plan, prediction) = (planned.plan.clone(), planned.prediction.clone());
    let task = planned.task.clone();
    let planning_s = watch.round(1).times.planning_s;
    let predicted = Some((prediction, watch.round(1).effect(&task, &planned.wiped())));
    let executed_by = match &args.executor {
        Some(_) => ExecutedBy::Executor,
        None => ExecutedBy::SimulatedWorld,
    };
    let done = session.into_rounds().into_iter().enumerate();
    let done = done.map(|(i, round)| {
        let watched = std::mem::take(watch.round(round.motion.number));
        Done::new(round, truth.get(i), watched, executed_by, prepared)
            .map_err(|error| prepared.failure(job.task_args, error))
    });
    let rounds: Vec<Done> = done.collect::<Result<_, Failure>>()?;
    let later = prepared.reality.pushes.iter().map(|push| push.round);
    let later = later.filter(|_| args.executor.is_none());
    for round in later.filter(|round| *round > rounds.len()) {
        let count = counted(rounds.len(), "round");
        let text = format!("the push of round {round} did not happen: the run ended after {count}");
        job.progress.aside(|| remark(&text));
    }
    Ok(Results {
        task,
        plan,
        planning_time_s: Some(planning_s),
        following,
        predicted,
        considered: None,
        rounds,
        recording: Vec::new(),
    })
}

/// What looks on while the loop runs, and keeps something of it.
struct Sinks<'a> {
    watch: Watch<'a>,
    recorder: Recorder<'a>,
    recording: RunRecording,
    episode: EpisodeRecorder,
    events: Option<(&'a Path, EventWriter<Box<dyn Write>>)>,
    /// Why the results go without bags, if they do.
    no_bag: Option<Failure>,
    /// Whether a reader of the events that has gone asks for an end in order.
    is_ended: bool,
    /// Whether somebody asks for one.
    stop: Option<&'a Arc<AtomicBool>>,
}

impl Sinks<'_> {
    fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::SeqCst))
    }

    /// Says that somebody ended the run after so many rounds; that there is none is an error.
    fn say_if_interrupted(&self, rounds: usize, progress: &Progress) -> Result<(), Failure> {
        if !self.is_stopped() {
            return Ok(());
        }
        if rounds == 0 {
            return Err(Failure::new(
                "ended before the first round was over, so nothing is kept",
            ));
        }
        let count = counted(rounds, "round");
        progress.aside(|| remark(&format!("interrupted: {count} kept, as far as executed")));
        Ok(())
    }

    /// Shows an event to all of them; whether the loop goes on.
    fn see(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        self.watch.see(event)?;
        self.watch.flow(self.recording.see(event))?;
        if let Some((path, writer)) = &mut self.events
            && let Err(error) = writer.write(event)
        {
            // Whoever read them has gone: the round is ended in order, and kept.
            let gone = self.watch.flow(Err(no_event(path, &error)));
            self.events = None;
            self.is_ended |= gone.is_break();
        }
        self.recorder.round_of(event);
        self.episode.see(event);
        if !self.recorder.is_taken_over()
            && let Err(failure) = self.recorder.see(event).map_err(cannot_write)
            && let Err(failure) = self.go_on_without_bag(failure)
        {
            return self.watch.flow(Err(failure));
        }
        // What was begun is ended in order, and all have seen it by now.
        if self.is_ended || self.is_stopped() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    /// An episode does not depend on the results, nor on where they go: with one the loop goes on.
    fn go_on_without_bag(&mut self, failure: Failure) -> Result<(), Failure> {
        if !self.episode.is_kept() {
            return Err(failure);
        }
        self.recorder.give_up();
        self.no_bag.get_or_insert(failure);
        Ok(())
    }

    /// Keeps what a killed run can be resumed with after a round; whether there is such a thing now.
    fn checkpoint(
        &mut self,
        round: &Round,
        first_look: Option<&Observation>,
        truth: &GroundTruth,
    ) -> Result<bool, Failure> {
        if self.watch.failure.is_some() || self.no_bag.is_some() {
            return Ok(false);
        }
        let seconds = self.watch.round(round.motion.number).times.executing_s;
        let checkpoints = &mut self.recorder.checkpoints;
        let Err(error) = checkpoints.keep(round, first_look, truth, seconds) else {
            return Ok(true);
        };
        let place = self.recorder.folder.state();
        let failure = Failure::new(format!("{}: cannot write there: {error}", place.display()))
            .with_help("choose another folder with --out");
        self.go_on_without_bag(failure)?;
        Ok(false)
    }

    /// Ends the recording with what came of the run, and puts the episode into the memory.
    fn end(
        self,
        job: &Job<'_>,
        first_look: Option<Observation>,
        broken: Option<Failure>,
        mut results: Results,
    ) -> Result<Executed, Failure> {
        let (_, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
        let (prepared, mut recording) = (job.prepared, self.recording);
        results.recording = recording.end(prepared, &results)?;
        let kept = self.episode.commit(
            &results.rounds,
            first_look,
            prepared,
            job.task_args,
            &robot.files,
            &packed(&results.recording)?,
        );
        let kept_in = kept.as_ref().ok().and_then(Option::as_ref);
        let name = kept_in.and_then(|kept| kept.place.file_name()?.to_str());
        recording.leave(prepared, &results, name);
        if let Some(failure) = self.no_bag {
            say_where(&kept);
            return Err(failure);
        }
        Ok(Executed {
            results,
            kept,
            broken,
        })
    }
}

/// Says where an episode is kept whose results are not.
pub fn say_where(kept: &Kept) {
    if let Ok(Some(kept)) = kept {
        let place = kept.place.display();
        remark(&format!("the episode is kept all the same, in {place}"));
    }
}

/// What tells this run from others. More or fewer rounds are no other run.
fn identity(
    prepared: &Prepared,
    robot: &Robot,
    args: &LoopArgs,
    given: Option<&Plan>,
) -> Result<u64, Failure> {
    let mut inputs = prepared.inputs.clone();
    robot.files.add_to(&mut inputs);
    inputs.add("pace", if args.greedy { "greedy" } else { "whole" });
    if let Some(plan) = given {
        let record = PlanRecord::new(&prepared.task, plan, prepared.config.seed);
        inputs.add("plan", json(&record)?);
    }
    Ok(inputs.value())
}

/// What executes the motions.
enum Executing {
    World(Box<Recording<World>>),
    Process(ProcessExecutor),
    /// Another program that is not asked anything more.
    Ended(NoExecutor),
}

impl Executing {
    fn as_dyn(&mut self) -> &mut dyn Executor {
        match self {
            Self::World(world) => world.as_mut(),
            Self::Process(process) => process,
            Self::Ended(nothing) => nothing,
        }
    }

    /// What the simulated world knows of each round; nothing is known of another one.
    fn truth(&self) -> &[GroundTruth] {
        match self {
            Self::World(world) => world.inner().truth(),
            Self::Process(_) | Self::Ended(_) => &[],
        }
    }

    /// Ends another program; what a simulated world knows stays.
    fn end(&mut self) {
        if matches!(self, Self::Process(_)) {
            *self = Self::Ended(NoExecutor);
        }
    }
}

/// Starts the program of `--executor`.
fn start(
    command: &str,
    timeout_s: f64,
    stop: Option<&Arc<AtomicBool>>,
) -> Result<ProcessExecutor, Failure> {
    let words = shlex::split(command).unwrap_or_default();
    let [program, arguments @ ..] = words.as_slice() else {
        return Err(Failure::new(format!(
            "--executor {command:?}: that is no command"
        )));
    };
    let silence = Duration::from_secs_f64(timeout_s);
    let stop = stop.cloned().unwrap_or_default();
    ProcessExecutor::start_stoppable(program, arguments, silence, stop).map_err(|error| {
        Failure::new(error).with_help("docs/executor-protocol.md says what an executor has to say")
    })
}

fn cannot_write(error: WriteError) -> Failure {
    Failure::new(error).with_help("choose another folder with --out")
}

/// Where `--events` go.
fn event_writer(path: &Path) -> Result<EventWriter<Box<dyn Write>>, Failure> {
    let output: Box<dyn Write> = if path == Path::new("-") {
        Box::new(std::io::stdout())
    } else {
        let file = File::create(path).map_err(|error| no_event(path, &error))?;
        Box::new(BufWriter::new(file))
    };
    Ok(EventWriter::new(output))
}

fn no_event(path: &Path, error: &std::io::Error) -> Failure {
    let place = path.display();
    Failure::new(format!("{place}: cannot write there: {error}"))
        .with_help("choose another file with --events")
}
