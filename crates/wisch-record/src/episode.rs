//! A run kept as an episode: telemetry while it is executed, the rest when it is over.

use crate::bag::Seen;
use crate::clock::{clock_was_set, dated_ahead, now};
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
    PlanRecord, RobotFiles, particles_to_csv,
};
use wisch_memory::{
    EpisodeHeader, EpisodeRecord, EpisodeRound, EpisodeWriter, Memory, MemoryError, Origin,
    RECORDING_FILE, RobotText, RoundLog, RoundObservations, RoundScene, TelemetryWriter, Value,
    episode_id, remember,
};

/// How much longer than this machine's clock says an executor may have been busy, as a share and in [s].
const EXECUTOR_SLACK: [f64; 2] = [0.05, 2.0];
/// How often another name is tried where one is taken.
const NAMES_TRIED: u16 = 100;

/// Where an episode is kept, and of whom.
#[derive(Debug, Clone, Default)]
pub struct EpisodeTarget {
    /// The folder of the memory, which is made where there is none.
    pub memory: PathBuf,
    /// The name of the program that executes; `None` is a simulated world, whose time is not the clock's.
    pub executor: Option<String>,
    /// A file that notes the names of the run's episodes, one a line: a run that is resumed keeps one of them.
    pub names: Option<PathBuf>,
}

/// Keeps a run as an episode: what is measured as columns while it is executed, the rest by [`Self::commit`]. Telemetry that
/// cannot be written, as on a full disk, is left out and said: a run does not depend on its memory.
pub struct EpisodeSink {
    place: PathBuf,
    memory: Memory,
    executor: Option<String>,
    /// Whether the events come as they happen.
    is_live: bool,
    /// When the run began, by this machine's clock [s since 1970], and by one that nobody sets.
    clock_begin: f64,
    since: Instant,
    /// When the execution of each round began, and how long it took by the clock [s].
    executing: Option<Instant>,
    executed: BTreeMap<usize, f64>,
    /// What is odd about the clock.
    clock_remarks: Vec<String>,
    /// Where the names of the run's episodes are noted, and those of the killed run that is resumed.
    names: Option<PathBuf>,
    earlier: Vec<String>,
    writer: EpisodeWriter,
    telemetry: Option<TelemetryWriter>,
    /// By number of the round.
    logs: BTreeMap<usize, RoundLog>,
    round: usize,
    /// Rounds of which the telemetry could not be written, and why.
    lost: Vec<(usize, MemoryError)>,
}

/// An episode that is in the memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptEpisode {
    /// Its name.
    pub id: String,
    /// Its folder.
    pub place: PathBuf,
    /// What it is without, in words.
    pub without: Vec<String>,
    /// What is odd about its times.
    pub remarks: Vec<String>,
}

/// How a run was asked for, beside its task file.
#[derive(Serialize)]
struct Options<'a> {
    task_file: String,
    settings: &'a [(String, String)],
    strategy: String,
    seed: u64,
}

/// Reads the names of the episodes that a killed run has noted.
fn noted(names: &Path) -> Vec<String> {
    let text = fs::read_to_string(names).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

impl EpisodeSink {
    /// Begins an episode, which has its name from the time by the clock.
    ///
    /// # Errors
    /// A folder that cannot be written, or is no memory.
    pub fn begin(target: EpisodeTarget) -> Result<Self, RecordError> {
        let EpisodeTarget {
            memory: folder,
            executor,
            names,
        } = target;
        let memory = Memory::create(&folder)?;
        let clock_begin = now();
        let earlier = names.as_deref().map(noted).unwrap_or_default();
        // Programs that begin in the same second seldom share the process number's last digits as well.
        let writer = begin_episode(&memory, clock_begin, std::process::id() as u16)?;
        Ok(Self {
            place: folder.join(writer.id()),
            clock_begin,
            since: Instant::now(),
            executor,
            is_live: true,
            executing: None,
            executed: BTreeMap::new(),
            clock_remarks: dated_ahead(&memory, clock_begin).into_iter().collect(),
            names,
            earlier,
            memory,
            writer,
            telemetry: None,
            logs: BTreeMap::new(),
            round: 0,
            lost: Vec::new(),
        })
    }

    /// The same, of a run that is over: its events are told afterwards, so that this machine's clock says nothing of them.
    #[must_use]
    pub fn of_past_run(self) -> Self {
        Self {
            is_live: false,
            ..self
        }
    }

    /// Says which program executes, where that is known only now.
    pub fn set_executor(&mut self, name: String) {
        self.executor = Some(name);
    }

    /// The run goes on with no round of a killed one: the episodes of that one stay.
    pub fn resume_nothing(&mut self) {
        self.earlier.clear();
    }

    /// The folder of the memory.
    pub fn memory_folder(&self) -> &Path {
        self.memory.folder()
    }

    /// Its name.
    pub fn id(&self) -> &str {
        self.writer.id()
    }

    /// Puts the episode into the memory.
    ///
    /// # Parameters
    /// - `finished`: the rounds that are over.
    /// - `first_look`: what was seen before the first round, if anything looked.
    /// - `robot`: the files of the robot; `None` where nobody knows them.
    /// - `recording`: the recording, packed; `None` leaves the page out.
    /// - `program`: what writes it, such as "wisch 0.2.0".
    ///
    /// # Errors
    /// What the system says.
    pub fn commit(
        mut self,
        finished: &[FinishedRound],
        first_look: Option<Observation>,
        loaded: &LoadedTask,
        robot: Option<&RobotFiles>,
        recording: Option<&[u8]>,
        program: &str,
    ) -> Result<KeptEpisode, RecordError> {
        let durations = self.durations(finished);
        let start = self.start(durations.iter().sum());
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
        let mut seen = first_look.map(|observation| Seen {
            world_from_surface: loaded.task.surface.world_from_surface,
            observation,
        });
        for finished in finished {
            attach_round(&self.writer, finished)?;
            let looks = observations(finished, seen.as_ref());
            let number = finished.round.motion.number;
            self.writer.observations(number, &looks)?;
            let [_, after] = looks.observations;
            seen = after.map(|observation| Seen {
                world_from_surface: looks.world_from_surface,
                observation,
            });
        }
        let header = EpisodeHeader {
            id: self.writer.id().to_owned(),
            start,
            target: loaded.file.target_performance(),
            seed: loaded.config.seed,
            program: program.to_owned(),
        };
        // A round that was taken over from a killed run was not seen.
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
        self.writer.commit(&record)?;
        for id in &self.earlier {
            // The killed run had come as far as this; its episode holds less, or the same.
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
        let robot = motion.cell.robot();
        let joints = (0..robot.dof()).map(|i| robot.variable(i).name.clone());
        let head = RoundScene::of(motion).head(joints.collect());
        self.round = motion.number;
        self.executing = Some(Instant::now());
        self.telemetry = Some(self.writer.telemetry(motion.number, head)?);
        Ok(())
    }

    /// How long each round lasted, in the time of its samples [s]; says where that is not what the clock says, as of a
    /// simulator that is faster than it.
    fn durations(&mut self, finished: &[FinishedRound]) -> Vec<f64> {
        let mut durations = Vec::with_capacity(finished.len());
        for finished in finished {
            let said = finished.round.execution.duration;
            let number = finished.round.motion.number;
            let clock =
                (self.executed.get(&number)).filter(|_| self.is_live && self.executor.is_some());
            let [share, slack] = EXECUTOR_SLACK;
            durations.push(match clock {
                Some(&clock) if !(0.0..=clock * (1.0 + share) + slack).contains(&said) => {
                    self.clock_remarks.push(format!(
                        "round {number} lasted {said} s by its executor and {clock:.1} s by this machine's clock; \
                         the episode keeps the executor's time: is it in seconds?"
                    ));
                    // What happened in the round has the time of its samples.
                    if said.is_finite() { said } else { clock }
                }
                _ => said,
            });
        }
        durations
    }

    /// When the episode began [s since 1970], so that it is over by now: a simulated world is faster than the clock.
    fn start(&mut self, duration: f64) -> f64 {
        let clock_duration = self.since.elapsed().as_secs_f64();
        let set_by = now() - self.clock_begin - clock_duration;
        self.clock_remarks.extend(clock_was_set(set_by));
        self.clock_begin + (clock_duration - duration).min(0.0)
    }

    /// Adds what the record of the rounds does not know: the clock, and what was lost.
    fn annotate(&self, record: &mut EpisodeRecord) {
        let values = &mut record.individuals[0].values;
        let clock_duration = self.since.elapsed().as_secs_f64();
        values.insert("semco:clockBegin".into(), Value::Number(self.clock_begin));
        values.insert("semco:clockDuration".into(), Value::Number(clock_duration));
        if !self.clock_remarks.is_empty() {
            let remarks = self.clock_remarks.join("; ");
            values.insert("semco:clockRemark".into(), Value::Text(remarks));
        }
        for (round, error) in &self.lost {
            record.set_telemetry_lost(*round, &error.to_string());
        }
    }

    /// Notes the episode's name where a resumed run finds it. Killed after this and before the commit, there is no episode of
    /// this name, which is no harm. An episode does not depend on where the results go: where the name cannot be written, as
    /// on a full disk, there is nothing to resume from either.
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
    /// Takes in one event. It never fails: what cannot be written is left out of the episode, which says so.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        if let Err(error) = self.write(event) {
            if let Some(telemetry) = self.telemetry.take() {
                telemetry.abandon();
            }
            self.lost.push((self.round, error));
        }
        Ok(())
    }
}

/// Attaches the task file, and what was asked for beside it.
///
/// # Errors
/// What the system says.
pub fn attach_task(writer: &EpisodeWriter, loaded: &LoadedTask) -> Result<(), RecordError> {
    writer.attach("task.toml", &loaded.text)?;
    let options = Options {
        task_file: loaded.path.display().to_string(),
        settings: &loaded.settings,
        strategy: loaded.config.strategy.to_string(),
        seed: loaded.config.seed,
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

/// What was seen before and after a round, in the frame of the surface as it was believed to be in it; `before` is what was
/// last seen.
fn observations(finished: &FinishedRound, before: Option<&Seen>) -> RoundObservations {
    let round = &finished.round;
    let world_from_surface = round.motion.task.surface.world_from_surface;
    RoundObservations {
        round: Some(round.motion.number),
        world_from_surface,
        observations: [
            before.map(|seen| seen.of_surface(&world_from_surface)),
            round.interpretation.observation.clone(),
        ],
    }
}

/// Begins an episode under the first name that is free.
///
/// # Parameters
/// - `start`: when it began [s since 1970]; its name says so.
/// - `first`: the last digits of its name, counted up where an episode has them.
///
/// # Errors
/// What the system says.
pub fn begin_episode(
    memory: &Memory,
    start: f64,
    first: u16,
) -> Result<EpisodeWriter, MemoryError> {
    for salt in 0..NAMES_TRIED {
        match memory.begin(&episode_id(start, first.wrapping_add(salt))) {
            Err(MemoryError::Exists { .. }) => {}
            begun => return begun,
        }
    }
    memory.begin(&episode_id(start, first))
}
