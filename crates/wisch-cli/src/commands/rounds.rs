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
use crate::terminal::remark;
use signal_hook::consts::SIGTERM;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use wisch::plan::Plan;
use wisch::run::{Executor, Recording, Stage};
use wisch_io::{EventWriter, PlanRecord, ProcessExecutor, Robot};
use wisch_sim::{Checkpoints, GroundTruth, KeptRound, Site, World};
use wisch_telemetry::WriteError;

/// An episode that is kept, if one is wanted, or why it is not.
pub type Kept = Result<Option<KeptEpisode>, Failure>;

/// Wipes until the goal is met, or no more can be done, and keeps the episode.
pub fn execute(
    job: &Job<'_>,
    args: &LoopArgs,
    given: Option<Plan>,
) -> Result<(Results, Kept), Failure> {
    let Job {
        task_args,
        prepared,
        folder,
        progress,
        ..
    } = *job;
    let (_, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
    let mut episode = EpisodeRecorder::begin(args, &folder.state())?;
    let mut recording = match (args.live, episode.id()) {
        (true, Some(id)) => RunRecording::begin_live(job, &args.memory.memory, id)?,
        _ => RunRecording::begin(job)?,
    };
    let stop = args.live.then(stop_flag).transpose()?;
    let is_stopped = || {
        stop.as_ref()
            .is_some_and(|stop| stop.load(Ordering::SeqCst))
    };
    let config = job.config(Some(args));
    let is_given = given.is_some();
    let checkpoints = Checkpoints::new(
        &folder.state(),
        identity(prepared, robot, args, given.as_ref())?,
    );
    let kept: Vec<KeptRound> = if folder.found().is_taken_over {
        let rounds = (1..).zip(checkpoints.read());
        let whole = rounds.take_while(|(number, _)| folder.place(&bag_name(*number)).is_file());
        let kept: Vec<KeptRound> = whole.map(|(_, kept)| kept).collect();
        let bags: Vec<String> = (1..=kept.len()).map(bag_name).collect();
        folder.keep_only(&bags)?;
        kept
    } else {
        Vec::new()
    };
    if kept.is_empty() {
        episode.resume_nothing();
    }
    if args.resume && folder.found().is_taken_over {
        let rounds = counted(kept.len(), "round");
        progress.aside(|| remark(&format!("{rounds} of the killed run taken over")));
    }
    let kept_count = match args.executor {
        None => Some(say_how_to_resume(progress, kept.len())?),
        // Of what another program executes, nothing is kept to go on with.
        Some(_) => None,
    };
    let executed_s: Vec<f64> = kept.iter().map(|round| round.executing_s).collect();
    let first_look = kept.first().and_then(|round| round.first_look.clone());
    let (recorded, truth) = kept.into_iter().map(|r| (r.recorded, r.truth)).unzip();
    let mut executor = match &args.executor {
        Some(command) => Executing::Process(start(command, args.timeout)?),
        None => {
            let (task, reality) = (&prepared.task, prepared.reality.clone());
            let world = World::new(&Site::of(task), reality, task.seed)
                .map_err(|error| prepared.failure(task_args, error))?
                .after(truth);
            Executing::World(Box::new(Recording::new(first_look, recorded, world)))
        }
    };
    let mut events = (args.events.as_deref())
        .map(|path| Ok::<_, Failure>((path, event_writer(path)?)))
        .transpose()?;

    let mut watch = Watch::new(job);
    let mut recorder = Recorder::new(job, checkpoints, executed_s.len(), args.realtime);
    let mut session = job.session(config, given);
    let mut no_bag: Option<Failure> = None;
    let result = loop {
        let finished = session.rounds().len();
        let stage = session.step(executor.as_dyn(), &mut |event| {
            watch.see(event)?;
            watch.flow(recording.see(event))?;
            if let Some((path, events)) = &mut events {
                let written = events.write(event);
                watch.flow(written.map_err(|error| no_event(path, &error)))?;
            }
            recorder.round_of(event);
            episode.see(event);
            if !recorder.is_taken_over()
                && let Err(failure) = recorder.see(event).map_err(cannot_write)
            {
                // An episode does not depend on the results, nor on where they go.
                if !episode.is_kept() {
                    return watch.flow(Err(failure));
                }
                recorder.give_up();
                no_bag.get_or_insert(failure);
            }
            // What was begun is ended in order, and all have seen it by now.
            if is_stopped() {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        // One that broke off is no round to go on from.
        if stage.is_ok()
            && let [.., round] = &session.rounds()[finished..]
        {
            let number = round.motion.number;
            if let Some(seconds) = executed_s.get(finished) {
                watch.round(number).times.executing_s = *seconds;
            } else if let (None, None, Some(truth)) =
                (&watch.failure, &no_bag, executor.truth().last())
            {
                let seconds = watch.round(number).times.executing_s;
                let look = session.first_observation();
                if let Err(error) = recorder.checkpoints.keep(round, look, truth, seconds) {
                    let place = folder.state();
                    let failure =
                        Failure::new(format!("{}: cannot write there: {error}", place.display()))
                            .with_help("choose another folder with --out");
                    if !episode.is_kept() {
                        return Err(failure);
                    }
                    recorder.give_up();
                    no_bag = Some(failure);
                } else if let Some(count) = &kept_count {
                    count.store(number, Ordering::SeqCst);
                }
            }
        }
        match stage {
            Ok(Stage::Ended) => break Ok(()),
            Ok(_) if watch.failure.is_some() => break Ok(()),
            Ok(_) => {}
            Err(error) => break Err(error),
        }
    };
    if let Err(failure) = recorder.end().map_err(cannot_write) {
        no_bag.get_or_insert(failure);
    }
    if let Some(failure) = watch.failure {
        return Err(failure);
    }
    let broken = result.err().map(|error| job.failed(error));
    if session.rounds().is_empty()
        && let Some(failure) = broken
    {
        return Err(failure);
    }
    if is_stopped() && session.rounds().is_empty() {
        return Err(Failure::new(
            "ended before the first round was over, so nothing is kept",
        ));
    }
    let following = Following::of(&session, watch.round(1).times.following_s);
    let (planned, _) = (session.first()).ok_or_else(|| internal("no round was planned"))?;
    let (plan, prediction) = (planned.plan.clone(), planned.prediction.clone());
    let task = planned.task.clone();
    let planning_s = watch.round(1).times.planning_s;
    let predicted = Some((prediction, watch.round(1).effect(&task, &planned.wiped())));
    let first_look = session.first_observation().cloned();
    let done = (session.into_rounds().into_iter())
        .enumerate()
        .map(|(i, round)| {
            let watched = std::mem::take(watch.round(round.motion.number));
            Done::new(round, executor.truth().get(i), watched, prepared)
                .map_err(|error| prepared.failure(task_args, error))
        });
    let rounds: Vec<Done> = done.collect::<Result<_, Failure>>()?;
    let later = prepared.reality.pushes.iter().map(|push| push.round);
    let later = later.filter(|_| args.executor.is_none());
    for round in later.filter(|round| *round > rounds.len()) {
        let count = counted(rounds.len(), "round");
        let text = format!("the push of round {round} did not happen: the run ended after {count}");
        progress.aside(|| remark(&text));
    }
    let mut results = Results {
        task,
        plan,
        planning_time_s: (!is_given).then_some(planning_s),
        following,
        predicted,
        considered: None,
        rounds,
        recording: Vec::new(),
    };
    results.recording = recording.end(prepared, &results)?;
    let attached = packed(&results.recording)?;
    let rounds = &results.rounds;
    let kept = episode.commit(
        rounds,
        first_look,
        prepared,
        task_args,
        &robot.files,
        &attached,
    );
    let name = kept
        .as_ref()
        .ok()
        .and_then(|kept| kept.as_ref()?.place.file_name()?.to_str());
    recording.leave(prepared, &results, name);
    if let Some(failure) = broken.or(no_bag) {
        say_where(&kept);
        return Err(failure);
    }
    Ok((results, kept))
}

/// Whether somebody asked the run to end in order: what was begun is interpreted as far as it went, and kept.
fn stop_flag() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    (signal_hook::flag::register(SIGTERM, Arc::clone(&flag)))
        .map_err(|error| Failure::new(format!("SIGTERM: {error}")))?;
    Ok(flag)
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
}

impl Executing {
    fn as_dyn(&mut self) -> &mut dyn Executor {
        match self {
            Self::World(world) => world.as_mut(),
            Self::Process(process) => process,
        }
    }

    /// What the simulated world knows of each round; nothing is known of another one.
    fn truth(&self) -> &[GroundTruth] {
        match self {
            Self::World(world) => world.inner().truth(),
            Self::Process(_) => &[],
        }
    }
}

/// Starts the program of `--executor`.
fn start(command: &str, timeout_s: f64) -> Result<ProcessExecutor, Failure> {
    let words = shlex::split(command).unwrap_or_default();
    let [program, arguments @ ..] = words.as_slice() else {
        return Err(Failure::new(format!(
            "--executor {command:?}: that is no command"
        )));
    };
    let silence = Duration::from_secs_f64(timeout_s);
    ProcessExecutor::start_within(program, arguments, silence).map_err(|error| {
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
