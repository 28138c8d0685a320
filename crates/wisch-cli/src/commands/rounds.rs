//! The closed loop of `wisch run`: rounds of planning, wiping and interpreting, with a bag of each.

use super::episode::EpisodeRecorder;
use super::follow::Following;
use super::prepare::Prepared;
use super::results::{internal, json};
use super::run::{Job, Results};
use super::words::{counted, percent};
use crate::args::LoopArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use wisch::geometry::Point3;
use wisch::interpret::EventKind;
use wisch::plan::Plan;
use wisch::represent::{ParticleDistribution, ParticleError, Task};
use wisch::run::{
    Ending, Executor, PlannedRound, Recording, Round, RunEvent, Stage, TelemetrySample,
};
use wisch_io::{
    EventRecorder, OutputFolder, PlanRecord, ProcessExecutor, Robot, RoundSummary, RoundTimes,
};
use wisch_report::{EffectFrames, RoundView, RoundsInput};
use wisch_sim::{Checkpoints, GroundTruth, KeptRound, World};
use wisch_telemetry::{BagHead, BagWriter, WriteError};

/// Between two updates of the progress [samples].
const SAY_EVERY: usize = 200;

/// A round with how long its parts took.
pub struct Done {
    /// The round.
    pub round: Round,
    /// How long its parts took.
    pub times: RoundTimes,
    /// Where the dirt really lies after it; `None` where none was simulated.
    pub truth: Option<ParticleDistribution>,
    /// The true performance [1]; `None` where no dirt was simulated.
    pub true_performance: Option<f64>,
    /// When somebody pushed [s].
    pub pushes: Vec<[f64; 2]>,
}

/// What a round's bag is called.
pub fn bag_name(number: usize) -> String {
    format!("round-{number}.mcap")
}

/// Wipes until the goal is met, or no more can be done; says where the episode is kept, if it is.
pub fn execute(
    job: &Job<'_>,
    args: &LoopArgs,
    given: Option<Plan>,
) -> Result<(Results, Option<PathBuf>), Failure> {
    let Job {
        task_args,
        prepared,
        folder,
        progress,
        ..
    } = *job;
    let (_, robot) = job.robot.ok_or_else(|| internal("there is no robot"))?;
    let mut episode = EpisodeRecorder::begin(&args.memory)?;
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
    if args.resume && folder.found().is_taken_over {
        let rounds = counted(kept.len(), "round");
        progress.aside(|| remark(&format!("{rounds} of the killed run taken over")));
    }
    let executed_s: Vec<f64> = kept.iter().map(|round| round.executing_s).collect();
    let (recorded, truth) = kept.into_iter().map(|r| (r.recorded, r.truth)).unzip();
    let mut executor = match &args.executor {
        Some(command) => Executing::Process(start(command)?),
        None => {
            let world = World::new(&prepared.task, prepared.reality.clone()).after(truth);
            Executing::World(Box::new(Recording::new(recorded, world)))
        }
    };
    let mut events = args.events.as_deref().map(EventLog::begin).transpose()?;

    let mut watch = Watch::new(job);
    let mut recorder = Recorder {
        folder,
        progress,
        checkpoints,
        taken_over: executed_s.len(),
        is_realtime: args.realtime,
        bag: None,
        samples: 0,
        round: 0,
        begin: Instant::now(),
        duration: 0.0,
    };
    let mut session = job.session(config, given);
    let result = loop {
        let finished = session.rounds().len();
        let stage = session.step(executor.as_dyn(), &mut |event| {
            watch.see(event)?;
            if let Some(events) = &mut events {
                let written = events.see(event);
                watch.flow(written)?;
            }
            recorder.round_of(event);
            if recorder.is_taken_over() {
                return ControlFlow::Continue(());
            }
            episode.see(event)?;
            let seen = recorder.see(event);
            watch.flow(seen.map_err(cannot_write))
        });
        if let [.., round] = &session.rounds()[finished..] {
            let number = round.motion.number;
            if let Some(seconds) = executed_s.get(finished) {
                watch.times_mut(number).executing_s = *seconds;
            } else if let (None, Some(truth)) = (&watch.failure, executor.truth().last()) {
                let seconds = watch.times(number).executing_s;
                (recorder.checkpoints.keep(round, truth, seconds)).map_err(|error| {
                    let place = folder.state();
                    Failure::new(format!("{}: cannot write there: {error}", place.display()))
                        .with_help("choose another folder with --out")
                })?;
            }
        }
        match stage {
            Ok(Stage::Ended) => break Ok(()),
            Ok(_) => {}
            Err(error) => break Err(error),
        }
    };
    episode.check()?;
    if let Some(failure) = watch.failure {
        return Err(failure);
    }
    result.map_err(|error| job.failed(error))?;
    let following = Following::of(&session, watch.times(1).following_s);
    let (planned, _) = (session.first()).ok_or_else(|| internal("no round was planned"))?;
    let (plan, prediction) = (planned.plan.clone(), planned.prediction.clone());
    let planning_s = watch.times(1).planning_s;
    let predicted = Some((prediction, watch.take_frames()?));
    let done = (session.into_rounds().into_iter())
        .enumerate()
        .map(|(i, round)| {
            let times = *watch.times_mut(round.motion.number);
            Done::new(round, executor.truth().get(i), times, prepared)
                .map_err(|error| prepared.failure(task_args, error))
        });
    let rounds: Vec<Done> = done.collect::<Result<_, Failure>>()?;
    let kept = episode.commit(&rounds, prepared, task_args, &robot.files)?;
    let results = Results {
        plan,
        planning_time_s: (!is_given).then_some(planning_s),
        following,
        predicted,
        rounds,
    };
    Ok((results, kept))
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
fn start(command: &str) -> Result<ProcessExecutor, Failure> {
    let words = shlex::split(command).unwrap_or_default();
    let [program, arguments @ ..] = words.as_slice() else {
        return Err(Failure::new(format!(
            "--executor {command:?}: that is no command"
        )));
    };
    ProcessExecutor::start(program, arguments).map_err(|error| {
        Failure::new(error).with_help("docs/executor-protocol.md says what an executor has to say")
    })
}

fn cannot_write(error: WriteError) -> Failure {
    Failure::new(error).with_help("choose another folder with --out")
}

/// What happens, as JSON lines.
struct EventLog {
    place: String,
    output: Box<dyn Write>,
    recorder: EventRecorder,
}

impl EventLog {
    fn begin(path: &Path) -> Result<Self, Failure> {
        let place = path.display().to_string();
        let output: Box<dyn Write> = if place == "-" {
            Box::new(std::io::stdout())
        } else {
            let file = File::create(path)
                .map_err(|error| Failure::new(format!("{place}: cannot write there: {error}")))?;
            Box::new(BufWriter::new(file))
        };
        Ok(Self {
            place,
            output,
            recorder: EventRecorder::default(),
        })
    }

    fn see(&mut self, event: &RunEvent<'_>) -> Result<(), Failure> {
        let Some(record) = self.recorder.record(event) else {
            return Ok(());
        };
        let mut line = serde_json::to_vec(&record).map_err(internal)?;
        line.push(b'\n');
        (self
            .output
            .write_all(&line)
            .and_then(|()| self.output.flush()))
        .map_err(|error| Failure::new(format!("{}: cannot write there: {error}", self.place)))
    }
}

impl Done {
    fn new(
        round: Round,
        truth: Option<&GroundTruth>,
        times: RoundTimes,
        prepared: &Prepared,
    ) -> Result<Self, ParticleError> {
        let PlannedRound {
            number, task, plan, ..
        } = &round.motion;
        let pushes = prepared.reality.pushes.iter();
        // Only the simulated world knows who pushed.
        let pushes = pushes.filter(|push| truth.is_some() && push.round == *number);
        let performance = |truth: &GroundTruth| truth.performance(&plan.graph.goal, &task.surface);
        Ok(Self {
            truth: (truth.map(GroundTruth::particles).transpose()?).flatten(),
            true_performance: (truth.map(performance).transpose()?).flatten(),
            pushes: pushes
                .map(|push| [push.start, push.start + push.duration])
                .collect(),
            round,
            times,
        })
    }
}

/// Looks on while a session goes on: says where it is, takes the time, and keeps the first round's predicted effect.
pub struct Watch<'a> {
    task: &'a Task,
    progress: &'a Progress,
    failure: Option<Failure>,
    frames: Option<EffectFrames>,
    times: Vec<RoundTimes>,
    since: Instant,
}

impl<'a> Watch<'a> {
    pub fn new(job: &Job<'a>) -> Self {
        Self {
            task: &job.prepared.task,
            progress: job.progress,
            failure: None,
            frames: None,
            times: Vec::new(),
            since: Instant::now(),
        }
    }

    /// How long the stages of a round took.
    pub fn times(&self, round: usize) -> RoundTimes {
        self.times.get(round - 1).copied().unwrap_or_default()
    }

    fn times_mut(&mut self, round: usize) -> &mut RoundTimes {
        self.times
            .resize(self.times.len().max(round), RoundTimes::default());
        &mut self.times[round - 1]
    }

    /// What the first round was predicted to do, over time.
    pub fn take_frames(&mut self) -> Result<EffectFrames, Failure> {
        let frames = self.frames.take();
        frames.ok_or_else(|| internal("no effect was predicted"))
    }

    pub fn see(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        match event {
            RunEvent::Planning { round } => {
                self.progress.say(format!("round {round}: planning"));
                self.since = Instant::now();
            }
            RunEvent::Planned { round, .. } => {
                self.take(*round, |times| &mut times.planning_s);
            }
            RunEvent::Following {
                round,
                passed,
                nodes,
            } => self.progress.say(format!(
                "round {round}: following, {passed} of {nodes} nodes"
            )),
            RunEvent::Predicting {
                round: 1,
                wiped,
                progress,
            } => {
                let frames = self.frames.take();
                let mut frames = frames.unwrap_or_else(|| EffectFrames::new(self.task, wiped));
                frames.watch(progress);
                self.frames = Some(frames);
            }
            RunEvent::Audited { round, .. } => {
                self.take(*round, |times| &mut times.following_s);
            }
            RunEvent::Interpreting { round } => {
                self.take(*round, |times| &mut times.executing_s);
                self.progress.say(format!("round {round}: interpreting"));
            }
            RunEvent::Judged(round) => {
                self.take(round.motion.number, |times| &mut times.interpreting_s);
            }
            RunEvent::Predicting { .. }
            | RunEvent::Executing(_)
            | RunEvent::Sample(_)
            | RunEvent::Ended(_) => {}
        }
        ControlFlow::Continue(())
    }

    /// Books the time since the last booking.
    fn take(&mut self, round: usize, part: impl Fn(&mut RoundTimes) -> &mut f64) {
        let seconds = self.since.elapsed().as_secs_f64();
        *part(self.times_mut(round)) += seconds;
        self.since = Instant::now();
    }

    fn flow(&mut self, result: Result<(), Failure>) -> ControlFlow<()> {
        match result {
            Ok(()) => ControlFlow::Continue(()),
            Err(failure) => {
                self.failure.get_or_insert(failure);
                ControlFlow::Break(())
            }
        }
    }
}

/// Writes what is measured: a bag of each round, and what a killed run can be resumed with.
struct Recorder<'a> {
    folder: &'a OutputFolder,
    progress: &'a Progress,
    checkpoints: Checkpoints,
    /// Rounds that an earlier run executed and recorded.
    taken_over: usize,
    is_realtime: bool,
    bag: Option<BagWriter>,
    samples: usize,
    round: usize,
    begin: Instant,
    /// How long the round's motion takes [s].
    duration: f64,
}

impl Recorder<'_> {
    fn round_of(&mut self, event: &RunEvent<'_>) {
        if let RunEvent::Executing(planned) = event {
            self.round = planned.number;
        }
    }

    const fn is_taken_over(&self) -> bool {
        self.round <= self.taken_over
    }

    fn see(&mut self, event: &RunEvent<'_>) -> Result<(), WriteError> {
        match event {
            RunEvent::Executing(planned) => self.begin(planned),
            RunEvent::Sample(sample) => self.sample(sample),
            RunEvent::Interpreting { .. } => self.bag.take().map_or(Ok(()), BagWriter::finish),
            _ => Ok(()),
        }
    }

    fn begin(&mut self, planned: &PlannedRound) -> Result<(), WriteError> {
        let robot = planned.cell.robot();
        self.duration = planned.followed.duration();
        self.samples = 0;
        self.begin = Instant::now();
        self.checkpoints.begin();
        let task = &planned.task;
        let head = BagHead {
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            world_from_surface: task.surface.world_from_surface,
            start: 0,
            notes: [
                ("task", task.name.clone()),
                ("round", planned.number.to_string()),
                ("seed", task.seed.to_string()),
            ]
            .map(|(key, value)| (key.to_owned(), value))
            .into(),
        };
        let path = self.folder.place(&bag_name(planned.number));
        let mut bag = BagWriter::create(&path, head)?;
        bag.write_particles(0.0, &in_world(task))?;
        self.bag = Some(bag);
        Ok(())
    }

    fn sample(&mut self, sample: &TelemetrySample<'_>) -> Result<(), WriteError> {
        if self.samples.is_multiple_of(SAY_EVERY) {
            self.progress.say(format!(
                "round {}: wiping, {:.1} of {:.1} s",
                self.round, sample.time, self.duration
            ));
        }
        self.samples += 1;
        self.checkpoints.sample(sample);
        if self.is_realtime {
            let ahead = Duration::try_from_secs_f64(sample.time).unwrap_or_default();
            std::thread::sleep(ahead.saturating_sub(self.begin.elapsed()));
        }
        self.bag.as_mut().map_or(Ok(()), |bag| bag.write(sample))
    }
}

/// Where a task's particles are believed to lie in the world.
fn in_world(task: &Task) -> Vec<Point3> {
    let remaining = task.particles.remaining();
    remaining
        .map(|p| task.surface.world_from_surface * Point3::new(p.x, p.y, 0.0))
        .collect()
}

/// What `--json` says of a round.
pub fn summary(done: &Done) -> RoundSummary {
    RoundSummary::new(&done.round, &done.times, done.true_performance)
}

/// What the report shows of the rounds.
pub fn views(done: &[Done]) -> Vec<RoundView<'_>> {
    done.iter()
        .map(|done| RoundView {
            number: done.round.motion.number,
            plan: &done.round.motion.plan,
            believed: &done.round.motion.task.particles,
            predicted: done.round.motion.prediction.performance.ratio(),
            interpretation: &done.round.interpretation,
            truth: done.truth.as_ref().zip(done.true_performance),
            pushes: &done.pushes,
        })
        .collect()
}

/// The report's part about rounds.
pub fn input<'a>(
    done: &'a [Done],
    views: &'a [RoundView<'a>],
    prepared: &'a Prepared,
) -> Option<RoundsInput<'a>> {
    let first = done.first()?;
    Some(RoundsInput {
        task: &prepared.task,
        goal: &first.round.motion.plan.graph.goal,
        target: prepared.file.target_performance(),
        rounds: views,
    })
}

/// The rounds, one line each, for people.
pub fn rounds_in_words(done: &[Done]) -> Vec<(&'static str, String)> {
    done.iter()
        .map(|done| {
            let round = &done.round;
            let told = &round.interpretation;
            let estimate = &told.performance;
            let mut text = format!(
                "estimated {} ({} to {})",
                percent(estimate.mean),
                percent(estimate.low),
                percent(estimate.high)
            );
            if let Some(truth) = done.true_performance {
                text += &format!(", true {}", percent(truth));
            }
            let collisions = (told.events.iter())
                .filter(|event| event.kind == EventKind::Collision)
                .count();
            if collisions > 0 {
                text += &format!(", {}", counted(collisions, "collision"));
            }
            if let wisch::interpret::Diagnosis::Relocalize { .. } = told.diagnosis
                && let Some(plane) = &told.plane
            {
                text += &format!(
                    ", surface found tilted by {:.1}° and {:.1} mm off",
                    plane.tilt.to_degrees(),
                    1e3 * plane.offset
                );
            }
            if let Ending::ProtectiveStop { time, cause } = &round.execution.ending {
                text += &format!(", stopped at {time:.1} s: {cause}");
            }
            text += &format!(": {}", round.verdict.as_str());
            let number = round.motion.number;
            (
                if number == 1 { "rounds" } else { "" },
                format!("{number}: {text}"),
            )
        })
        .collect()
}
