//! The episode of a run: the telemetry of a round is taken from its bag, the rest is written at the end.

use crate::bag::Seen;
use crate::bag_copy::BagCopy;
use crate::clock::{RunClock, clock_change_remark, future_episode_remark, unix_time};
use crate::error::{RecordError, internal};
use crate::results::FinishedRound;
use crate::sink::{RunSink, SinkError};
use crate::words::json;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;
use wisch::represent::Observation;
use wisch::run::{PlannedRound, RunEvent};
use wisch_io::{
    LoadedTask, PARTICLES_BEFORE_FILE, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE,
    PlanRecord, RobotFiles, Unfinished, UnfinishedPath, particles_to_csv,
};
use wisch_memory::{
    EpisodeHeader, EpisodeRecord, EpisodeRound, EpisodeWriter, Memory, MemoryError, Origin,
    RECORDING_FILE, RobotText, RoundLog, RoundObservations, RoundScene, TelemetryWriter, Value,
    episode_id, remember,
};

/// Tolerance of an executor's duration above this machine's clock, as a share [1] and a constant [s].
const EXECUTOR_SLACK: [f64; 2] = [0.05, 2.0];
/// Maximum number of names that are tried.
const NAMES_TRIED: u16 = 100;

/// The memory and the executor of an episode.
#[derive(Debug, Clone, Default)]
pub struct EpisodeTarget {
    /// Folder of the memory; it is created if missing.
    pub memory: PathBuf,
    /// Name of the executor's program; `None` for a simulated world, whose time differs from the clock.
    pub executor: Option<String>,
    /// File with the names of the run's episodes, one per line. A resumed run replaces these episodes by its own.
    pub names: Option<PathBuf>,
    /// When the run began; `None` for a run that begins with its episode.
    pub clock: Option<RunClock>,
}

/// A sink that keeps a run as an episode. It writes telemetry during execution, or in a [`RunRecord`](crate::RunRecord)
/// with bags at the end of each round, from the bag; [`Self::commit`] writes the rest.
///
/// If telemetry cannot be written, for example on a full disk, the run continues and the episode states what is missing.
pub struct EpisodeSink {
    place: PathBuf,
    memory: Memory,
    executor: Option<String>,
    /// Whether events arrive at the time at which they happen.
    is_live: bool,
    /// Start of the run by this machine's clocks.
    clock: RunClock,
    /// Start of the current round's execution, and durations of executed rounds by the clock [s].
    executing: Option<Instant>,
    executed: BTreeMap<usize, f64>,
    /// Remarks on the clock.
    clock_remarks: Vec<String>,
    /// File with the names of the run's episodes, and the names that a killed run has written there.
    names: Option<PathBuf>,
    earlier: Vec<String>,
    writer: EpisodeWriter,
    unfinished: Unfinished,
    telemetry: Option<TelemetryWriter>,
    /// Whether the telemetry of a round is taken from its bag, and that of the current round.
    has_bags: bool,
    copy: Option<BagCopy>,
    /// By number of the round.
    logs: BTreeMap<usize, RoundLog>,
    round: usize,
    /// Rounds whose telemetry could not be written, with the errors.
    lost: Vec<(usize, String)>,
}

/// An episode that is stored in the memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptEpisode {
    /// Its name.
    pub id: String,
    /// Its folder.
    pub place: PathBuf,
    /// Descriptions of missing parts.
    pub without: Vec<String>,
    /// Remarks on its times.
    pub remarks: Vec<String>,
}

/// The options of a run beside its task file.
#[derive(Serialize)]
struct Options<'a> {
    task_file: String,
    settings: &'a [(String, String)],
    strategy: String,
    action: &'static str,
    seed: u64,
}

/// Reads the names of a killed run's episodes.
fn read_names(names: &Path) -> Vec<String> {
    let text = fs::read_to_string(names).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

impl EpisodeSink {
    /// Begins an episode, whose name states the time by the clock.
    ///
    /// # Errors
    /// If the folder cannot be written or is not a memory.
    pub fn begin(target: EpisodeTarget) -> Result<Self, RecordError> {
        let EpisodeTarget {
            memory: folder,
            executor,
            names,
            clock,
        } = target;
        let memory = Memory::create(&folder)?;
        let clock = clock.unwrap_or_else(RunClock::start);
        let earlier = names.as_deref().map(read_names).unwrap_or_default();
        // Programs that start in the same second rarely share the last digits of their process ids.
        let (writer, unfinished) =
            begin_episode(&memory, clock.begin(), std::process::id() as u16)?;
        Ok(Self {
            place: folder.join(writer.id()),
            clock,
            executor,
            is_live: true,
            executing: None,
            executed: BTreeMap::new(),
            clock_remarks: future_episode_remark(&memory, clock.begin())
                .into_iter()
                .collect(),
            names,
            earlier,
            memory,
            writer,
            unfinished,
            telemetry: None,
            has_bags: false,
            copy: None,
            logs: BTreeMap::new(),
            round: 0,
            lost: Vec::new(),
        })
    }

    /// Returns the sink for a finished run, whose events are replayed, so that this machine's clock does not apply to them.
    #[must_use]
    pub fn with_replayed_events(self) -> Self {
        Self {
            is_live: false,
            ..self
        }
    }

    /// Takes the telemetry of rounds from their bags, by [`copy_bag`](Self::copy_bag).
    pub(crate) fn take_from_bags(&mut self) {
        self.has_bags = true;
    }

    /// Takes the telemetry of the current round from its finished bag.
    pub(crate) fn copy_bag(&mut self, bag: &Path) {
        if let Some(Err(error)) = self.copy.take().map(|copy| copy.finish(bag)) {
            self.lose(error);
        }
    }

    /// Writes telemetry during execution from now on, because bags cannot be written. `bag`: the unfinished bag of the
    /// current round.
    pub(crate) fn leave_bags(&mut self, bag: &Path) {
        self.has_bags = false;
        let recovered = self.copy.take().map(|copy| copy.recover(bag));
        match recovered {
            Some(Ok(telemetry)) if self.executing.is_some() => self.telemetry = Some(telemetry),
            Some(Ok(telemetry)) => {
                if let Err(error) = telemetry.finish() {
                    self.lose(error.to_string());
                }
            }
            Some(Err(error)) => self.lose(error),
            None => {}
        }
    }

    /// Sets the name of the executor's program, if it becomes known after the beginning.
    pub fn set_executor(&mut self, name: String) {
        self.executor = Some(name);
    }

    /// Keeps the episodes of a killed run, because this run resumes none of its rounds.
    pub fn keep_interrupted_episodes(&mut self) {
        self.earlier.clear();
    }

    /// Path of the folder of the memory.
    pub fn memory_folder(&self) -> &Path {
        self.memory.folder()
    }

    /// Name of the episode in its memory.
    pub fn id(&self) -> &str {
        self.writer.id()
    }

    /// Stores the episode in the memory.
    ///
    /// # Parameters
    /// - `finished`: the finished rounds.
    /// - `first_observation`: observation before the first round, if there is one.
    /// - `robot`: files of the robot; `None` if they are unknown.
    /// - `recording`: compressed recording; `None` leaves the page out.
    /// - `program`: name and version of the program that writes it, such as "wisch 0.2.0".
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn commit(
        mut self,
        finished: &[FinishedRound],
        first_observation: Option<Observation>,
        loaded: &LoadedTask,
        robot: Option<&RobotFiles>,
        recording: Option<&[u8]>,
        program: &str,
    ) -> Result<KeptEpisode, RecordError> {
        // The episode leaves out a round that broke off before its interpretation.
        if let Some(telemetry) = self.telemetry.take() {
            telemetry.abandon();
        }
        if let Some(copy) = self.copy.take() {
            copy.abandon();
        }
        let durations = self.durations(finished);
        self.check_clock();
        attach_task(&self.writer, loaded)?;
        if let Some(recording) = recording {
            self.writer.attach(RECORDING_FILE, recording)?;
        }
        if let Some(robot) = robot {
            let robot = RobotText {
                urdf: robot.urdf.clone(),
                srdf: robot.srdf.clone(),
                meshes: robot.meshes.clone(),
            };
            robot.attach_to(&self.writer)?;
        }
        let mut seen = first_observation.map(|observation| Seen {
            world_from_surface: loaded.task.surface.world_from_surface,
            observation,
        });
        for finished in finished {
            attach_round(&self.writer, finished)?;
            let observed = observations(finished, seen.as_ref());
            let number = finished.round.motion.number;
            self.writer.observations(number, &observed)?;
            let [_, after] = observed.observations;
            seen = after.map(|observation| Seen {
                world_from_surface: observed.world_from_surface,
                observation,
            });
        }
        let header = EpisodeHeader {
            id: self.writer.id().to_owned(),
            task: loaded.task.name.clone(),
            start: self.clock.begin(),
            target: loaded.run.target,
            seed: loaded.run.plan.seed,
            program: program.to_owned(),
        };
        // This process has no log of the rounds of a killed run.
        let unseen = RoundLog::default();
        let rounds: Vec<_> = (finished.iter().zip(durations))
            .map(|(finished, duration)| {
                let round = &finished.round;
                EpisodeRound {
                    motion: &round.motion,
                    log: self.logs.get(&round.motion.number).unwrap_or(&unseen),
                    duration,
                    ending: &round.execution.ending,
                    interpretation: &round.interpretation,
                    warnings: &round.warnings,
                    verdict: round.verdict,
                    simulated_performance: finished
                        .truth
                        .as_ref()
                        .and_then(|known| known.performance),
                }
            })
            .collect();
        let mut record = remember(&header, &rounds);
        self.annotate(&mut record);
        self.note_name();
        if let Some(program) = self.executor {
            record.origin = Origin::Executor(program);
        }
        let writer = self.writer;
        self.unfinished.place(|| writer.commit(&record))?;
        for id in &self.earlier {
            // The killed run's episode holds no more rounds than this one, which replaces it.
            match self.memory.forget(id) {
                Ok(()) | Err(MemoryError::Unknown { .. }) => {}
                Err(error) => return Err(error.into()),
            }
        }
        let lost = self.lost.iter();
        let without = lost.map(|(round, error)| format!("the telemetry of round {round}: {error}"));
        Ok(KeptEpisode {
            id: header.id,
            place: self.place,
            without: without.collect(),
            remarks: self.clock_remarks,
        })
    }

    fn write(&mut self, event: &RunEvent<'_>) -> Result<(), MemoryError> {
        match event {
            RunEvent::Executing(motion) => self.execute(motion),
            RunEvent::Sample(sample) => {
                self.logs.entry(self.round).or_default().push(sample);
                if let Some(copy) = &mut self.copy {
                    copy.watch(sample);
                }
                let writing = self.telemetry.as_mut();
                Ok(writing.map_or(Ok(()), |telemetry| telemetry.write(sample))?)
            }
            RunEvent::Interpreting { .. } => {
                if let Some(since) = self.executing.take() {
                    self.executed
                        .insert(self.round, since.elapsed().as_secs_f64());
                }
                let written = self.telemetry.take();
                Ok(written.map_or(Ok(()), TelemetryWriter::finish)?)
            }
            _ => Ok(()),
        }
    }

    fn execute(&mut self, motion: &PlannedRound) -> Result<(), MemoryError> {
        self.round = motion.number;
        self.executing = Some(Instant::now());
        let robot = motion.cell.robot();
        let joints = (0..robot.dof()).map(|i| robot.variable(i).name.clone());
        let head = RoundScene::from_motion(motion).head(joints.collect());
        let telemetry = self.writer.telemetry(motion.number, head)?;
        if self.has_bags {
            self.copy = Some(BagCopy::new(telemetry));
        } else {
            self.telemetry = Some(telemetry);
        }
        Ok(())
    }

    /// Notes that the telemetry of the current round is missing.
    fn lose(&mut self, error: String) {
        if let Some(telemetry) = self.telemetry.take() {
            telemetry.abandon();
        }
        self.lost.push((self.round, error));
    }

    /// Returns the duration of each round in the time of its samples [s], and adds a remark if the clock disagrees, as it
    /// does for a simulator that is faster than real time.
    fn durations(&mut self, finished: &[FinishedRound]) -> Vec<f64> {
        let mut durations = Vec::with_capacity(finished.len());
        for finished in finished {
            let reported = finished.round.execution.duration;
            let number = finished.round.motion.number;
            let clock =
                (self.executed.get(&number)).filter(|_| self.is_live && self.executor.is_some());
            let [share, slack] = EXECUTOR_SLACK;
            durations.push(match clock {
                Some(&clock) if !(0.0..=clock * (1.0 + share) + slack).contains(&reported) => {
                    self.clock_remarks.push(format!(
                        "round {number} lasted {reported:.1} s by its executor but {clock:.1} s by this machine's clock; the episode \
                         keeps the executor's time; check that the executor reports seconds"
                    ));
                    // The events of the round use the time of its samples.
                    if reported.is_finite() { reported } else { clock }
                }
                _ => reported,
            });
        }
        durations
    }

    /// Adds a remark if this machine's clock was set during the run.
    fn check_clock(&mut self) {
        let set_by = unix_time() - self.clock.begin() - self.clock.duration();
        self.clock_remarks.extend(clock_change_remark(set_by));
    }

    /// Adds the clock's times and the missing telemetry to the record.
    fn annotate(&self, record: &mut EpisodeRecord) {
        let values = &mut record.individuals[0].values;
        let [begin, duration] = [self.clock.begin(), self.clock.duration()].map(Value::Number);
        values.insert("semco:clockBegin".into(), begin);
        values.insert("semco:clockDuration".into(), duration);
        if !self.clock_remarks.is_empty() {
            let remarks = self.clock_remarks.join("; ");
            values.insert("semco:clockRemark".into(), Value::Text(remarks));
        }
        for (round, error) in &self.lost {
            record.set_telemetry_lost(*round, error);
        }
    }

    /// Writes the episode's name into the file that a resumed run reads.
    ///
    /// If the process is killed before the commit, no episode has this name, which does no harm. A failure, for example on
    /// a full disk, is ignored: such a run cannot be resumed either.
    fn note_name(&self) {
        let Some(names) = &self.names else {
            return;
        };
        let mut options = OpenOptions::new();
        let file = options.create(true).append(true).open(names);
        let _ = file.and_then(|mut file| {
            file.write_all(format!("{}\n", self.writer.id()).as_bytes())?;
            file.sync_all()
        });
    }
}

impl RunSink for EpisodeSink {
    /// Receives one event. It never fails: the episode states which telemetry is missing.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        if let Err(error) = self.write(event) {
            self.lose(error.to_string());
        }
        Ok(())
    }
}

/// Attaches the task file, copies of the files that it names, and the run's options.
///
/// # Errors
/// If a file cannot be written.
pub fn attach_task(writer: &EpisodeWriter, loaded: &LoadedTask) -> Result<(), RecordError> {
    writer.attach("task.toml", &loaded.text)?;
    for (name, contents) in loaded.files.to_files() {
        writer.attach(&name, contents)?;
    }
    let options = Options {
        task_file: loaded.path.display().to_string(),
        settings: &loaded.settings,
        strategy: loaded.run.plan.strategy.to_string(),
        action: loaded.task.action.as_str(),
        seed: loaded.run.plan.seed,
    };
    Ok(writer.attach("options.json", json(&options)?)?)
}

fn attach_round(writer: &EpisodeWriter, finished: &FinishedRound) -> Result<(), RecordError> {
    let round = &finished.round;
    let motion = &round.motion;
    let name = |file: &str| format!("round-{}/{file}", motion.number);
    let plan = PlanRecord::new(&motion.task, &motion.plan, motion.task.seed);
    writer.attach(&name(PLAN_FILE), json(&plan)?)?;
    let before = particles_to_csv(&motion.task.particles);
    writer.attach(&name(PARTICLES_BEFORE_FILE), before)?;
    let belief = &round.interpretation.belief;
    let estimated = belief.sample(motion.task.seed).map_err(internal)?;
    let estimated = particles_to_csv(&estimated);
    writer.attach(&name(PARTICLES_ESTIMATED_FILE), estimated)?;
    if let Some(truth) = (finished.truth.as_ref()).and_then(|known| known.particles.as_ref()) {
        writer.attach(&name(PARTICLES_TRUE_FILE), particles_to_csv(truth))?;
    }
    Ok(())
}

/// Returns the observations before and after a round, in the frame of the surface pose that was believed in the round.
/// `before`: the last observation.
fn observations(finished: &FinishedRound, before: Option<&Seen>) -> RoundObservations {
    let round = &finished.round;
    let surface = &round.motion.task.surface;
    RoundObservations {
        round: Some(round.motion.number),
        world_from_surface: surface.world_from_surface,
        observations: [
            before.map(|seen| seen.transform_to_surface(surface)),
            round.interpretation.observation.clone(),
        ],
    }
}

/// Begins an episode under the first free name, which an interruption removes until the returned guard is dropped.
///
/// # Parameters
/// - `start`: start of the episode [s since 1970], which its name states.
/// - `first`: last digits of its name; they are incremented until the name is free.
///
/// # Errors
/// If the episode cannot be written, or no name is free.
pub fn begin_episode(
    memory: &Memory,
    start: f64,
    first: u16,
) -> Result<(EpisodeWriter, Unfinished), MemoryError> {
    let begin = |salt| {
        let writer = memory.begin(&episode_id(start, first.wrapping_add(salt)))?;
        let paths = writer.unfinished_paths().map(UnfinishedPath::Whole).into();
        Ok::<_, MemoryError>((writer, paths))
    };
    for salt in 0..NAMES_TRIED {
        match Unfinished::create(|| begin(salt)) {
            Err(MemoryError::Exists { .. }) => {}
            begun => return begun,
        }
    }
    Unfinished::create(|| begin(0))
}
