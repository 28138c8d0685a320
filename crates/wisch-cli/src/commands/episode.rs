//! A run kept as an episode: telemetry while it is executed, the rest when it is over.

use super::job::Done;
use super::prepare::Prepared;
use super::watch::Seen;
use super::words::{internal, json};
use crate::args::{LoopArgs, TaskArgs};
use crate::failure::Failure;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime, UNIX_EPOCH};
use wisch::represent::Observation;
use wisch::run::{PlannedRound, RunEvent};
use wisch_io::{PARTICLES_BEFORE_FILE, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE};
use wisch_io::{PlanRecord, RobotFiles, particles_to_csv};
use wisch_memory::{
    EpisodeHeader, EpisodeRecord, EpisodeRound, EpisodeWriter, Memory, MemoryError, Origin,
    RECORDING_FILE, RobotText, RoundLog, RoundObservations, RoundScene, TelemetryWriter, Value,
    episode_id, local_date_and_time, remember,
};

/// What wrote an episode.
pub(super) const PROGRAM: &str = concat!("wisch ", env!("CARGO_PKG_VERSION"));
/// How far clocks may be apart before that is told [s].
const CLOCKS_APART: f64 = 60.0;
/// How much longer than this machine's clock says an executor may have been busy, as a share and in [s].
const EXECUTOR_SLACK: [f64; 2] = [0.05, 2.0];
/// In the state of a run: the names of its episodes, one a line.
const EPISODES_FILE: &str = "episodes";
/// How often another name is tried where one is taken.
const NAMES_TRIED: u16 = 100;

/// Adds a file to an episode: its name and contents.
pub(super) type Attach<'a> = dyn Fn(&str, &[u8]) -> Result<(), Failure> + 'a;

/// An episode that is being written, or none.
pub struct EpisodeRecorder {
    kept: Option<Kept>,
    /// The program that executes, where that is not the simulated world.
    executor: Option<String>,
}

struct Kept {
    place: PathBuf,
    memory: Memory,
    /// When the run began, by this machine's clock [s since 1970], and by one that nobody sets.
    clock_begin: f64,
    since: Instant,
    /// Whether the motions are executed in a simulated world, whose time is not the clock's.
    is_simulated: bool,
    /// When the execution of each round began, and how long it took by the clock [s].
    executing: Option<Instant>,
    executed: BTreeMap<usize, f64>,
    /// What is odd about the clock.
    clock_remarks: Vec<String>,
    /// Where the names of the run's episodes are noted, and those of the killed run that is resumed.
    names: PathBuf,
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
pub struct KeptEpisode {
    /// Where.
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

/// Says that an episode of a memory is dated after now [s since 1970]: this machine's clock was ahead then, or is behind now.
fn dated_ahead(memory: &Memory, now: f64) -> Option<String> {
    let names = memory.episodes().unwrap_or_default();
    // Names begin with the date. An episode that cannot be read does not keep others from being written.
    let last = names.iter().max()?;
    let record = memory.episode(last).ok()?.record().ok()?;
    let ahead = record.interval[0] - now;
    (ahead > CLOCKS_APART).then(|| {
        format!(
            "episode {last} is dated {}, {} after this machine's clock, which says {}: the clock was ahead then or is \
             behind now; the new episode is dated by the clock",
            local_date_and_time(record.interval[0]),
            lasting(ahead),
            local_date_and_time(now),
        )
    })
}

/// Says that this machine's clock was set during the run, by so many seconds.
fn clock_was_set(by: f64) -> Option<String> {
    let way = if by > 0.0 { "forward" } else { "back" };
    (by.abs() > CLOCKS_APART).then(|| {
        format!(
            "this machine's clock was set {way} by {} during the run; the episode is dated by the clock as it was at the \
             beginning",
            lasting(by)
        )
    })
}

/// A length of time for people.
fn lasting(seconds: f64) -> String {
    match seconds.abs() {
        s if s >= 172_800.0 => format!("{:.0} days", s / 86_400.0),
        s if s >= 7_200.0 => format!("{:.1} h", s / 3_600.0),
        s => format!("{s:.0} s"),
    }
}

/// Reads the names of the episodes that a killed run has noted.
fn noted(names: &Path) -> Vec<String> {
    let text = fs::read_to_string(names).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

impl EpisodeRecorder {
    /// Begins an episode, unless none is wanted. Its name, which is the time by the clock, is noted in the run's state:
    /// a run that is resumed keeps one episode.
    pub fn begin(args: &LoopArgs, state: &Path) -> Result<Self, Failure> {
        let executor = args.executor.as_deref().map(program_of);
        if args.memory.no_memory {
            return Ok(Self {
                kept: None,
                executor,
            });
        }
        let folder = &args.memory.memory;
        let memory = Memory::create(folder).map_err(|error| cannot_keep(&error))?;
        let clock_begin = now();
        let names = state.join(EPISODES_FILE);
        let earlier = noted(&names);
        let writer = begin(&memory, clock_begin).map_err(|error| cannot_keep(&error))?;
        let kept = Kept {
            place: folder.join(writer.id()),
            clock_begin,
            since: Instant::now(),
            is_simulated: args.executor.is_none(),
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
        };
        Ok(Self {
            kept: Some(kept),
            executor,
        })
    }

    /// The run goes on with no round of a killed one: the episodes of that one stay.
    pub fn resume_nothing(&mut self) {
        if let Some(kept) = &mut self.kept {
            kept.earlier.clear();
        }
    }

    /// Its name, if there is one.
    pub fn id(&self) -> Option<&str> {
        Some(self.kept.as_ref()?.writer.id())
    }

    /// Whether there is one.
    pub fn is_kept(&self) -> bool {
        self.kept.is_some()
    }

    /// Looks on while the loop runs. A round whose telemetry cannot be written, as on a full disk, is kept without: the
    /// results of a run do not depend on its memory.
    pub fn see(&mut self, event: &RunEvent<'_>) {
        let Some(kept) = &mut self.kept else {
            return;
        };
        if let Err(error) = kept.see(event) {
            if let Some(telemetry) = kept.telemetry.take() {
                telemetry.abandon();
            }
            kept.lost.push((kept.round, error));
        }
    }

    /// Puts the episode into the memory; `first_look` is what was seen before the first round, if anything looked.
    pub fn commit(
        self,
        done: &[Done],
        first_look: Option<Observation>,
        prepared: &Prepared,
        task_args: &TaskArgs,
        robot: &RobotFiles,
        recording: &[u8],
    ) -> Result<Option<KeptEpisode>, Failure> {
        let Some(mut kept) = self.kept else {
            return Ok(None);
        };
        let durations = kept.durations(done);
        let start = kept.start(durations.iter().sum());
        let attach = |name: &str, contents: &[u8]| {
            let attached = kept.writer.attach(name, contents);
            attached.map_err(|error| cannot_keep(&error))
        };
        attach_task(task_args, prepared, &attach)?;
        attach(RECORDING_FILE, recording)?;
        let robot = RobotText {
            urdf: robot.urdf.clone(),
            srdf: robot.srdf.clone(),
            meshes: robot.meshes.clone(),
        };
        (robot.attach_to(&kept.writer)).map_err(|error| cannot_keep(&error))?;
        let mut seen = first_look.map(|observation| Seen {
            world_from_surface: prepared.task.surface.world_from_surface,
            observation,
        });
        for done in done {
            attach_round(done, &attach)?;
            let looks = observations(done, seen.as_ref());
            let number = done.round.motion.number;
            (kept.writer.observations(number, &looks)).map_err(|error| cannot_keep(&error))?;
            let [_, after] = looks.observations;
            seen = after.map(|observation| Seen {
                world_from_surface: looks.world_from_surface,
                observation,
            });
        }
        let header = EpisodeHeader {
            id: kept.writer.id().to_owned(),
            start,
            target: prepared.file.target_performance(),
            seed: prepared.config.seed,
            program: PROGRAM.to_owned(),
        };
        // A round that was taken over from a killed run was not seen.
        let unseen = RoundLog::default();
        let rounds: Vec<_> = (done.iter().zip(durations))
            .map(|(done, duration)| {
                let round = &done.round;
                EpisodeRound {
                    motion: &round.motion,
                    log: kept.logs.get(&round.motion.number).unwrap_or(&unseen),
                    duration,
                    ending: &round.execution.ending,
                    interpretation: &round.interpretation,
                    verdict: round.verdict,
                    simulated_performance: done.true_performance,
                }
            })
            .collect();
        let mut record = remember(&header, &rounds);
        if let Some(program) = self.executor {
            record.origin = Origin::Executor(program);
        }
        kept.annotate(&mut record);
        kept.note_name();
        (kept.writer.commit(&record)).map_err(|error| cannot_keep(&error))?;
        for id in &kept.earlier {
            // The killed run had come as far as this; its episode holds less, or the same.
            match kept.memory.forget(id) {
                Ok(()) | Err(MemoryError::Unknown { .. }) => {}
                Err(error) => return Err(cannot_keep(&error)),
            }
        }
        let lost = kept.lost.iter();
        let without = lost.map(|(round, error)| format!("the telemetry of round {round}: {error}"));
        Ok(Some(KeptEpisode {
            place: kept.place,
            without: without.collect(),
            remarks: kept.clock_remarks,
        }))
    }
}

impl Kept {
    fn see(&mut self, event: &RunEvent<'_>) -> Result<(), MemoryError> {
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
}

impl Kept {
    /// How long each round lasted, in the time of its samples [s]; says where that is not what the clock says, as of a
    /// simulator that is faster than it.
    fn durations(&mut self, done: &[Done]) -> Vec<f64> {
        let mut durations = Vec::with_capacity(done.len());
        for done in done {
            let said = done.round.execution.duration;
            let number = done.round.motion.number;
            let clock = (self.executed.get(&number)).filter(|_| !self.is_simulated);
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
        let mut options = OpenOptions::new();
        let file = options.create(true).append(true).open(&self.names);
        let _ = file.and_then(|mut file| {
            file.write_all(format!("{}\n", self.writer.id()).as_bytes())?;
            file.sync_all()
        });
    }
}

/// The name of the program of `--executor`, without its folder.
fn program_of(command: &str) -> String {
    let program = shlex::split(command).and_then(|words| words.into_iter().next());
    let name = program.as_deref().map(Path::new).and_then(Path::file_name);
    name.map_or_else(
        || "executor".to_owned(),
        |name| name.to_string_lossy().into_owned(),
    )
}

/// Attaches the task file, and what the command line said of it.
pub(super) fn attach_task(
    args: &TaskArgs,
    prepared: &Prepared,
    attach: &Attach<'_>,
) -> Result<(), Failure> {
    attach("task.toml", prepared.text.as_bytes())?;
    let options = Options {
        task_file: args.task.display().to_string(),
        settings: &args.settings,
        strategy: prepared.strategy().to_string(),
        seed: prepared.config.seed,
    };
    attach("options.json", json(&options)?.as_bytes())
}

fn attach_round(done: &Done, attach: &Attach<'_>) -> Result<(), Failure> {
    let round = &done.round;
    let motion = &round.motion;
    let name = |file: &str| format!("round-{}/{file}", motion.number);
    let plan = PlanRecord::new(&motion.task, &motion.plan, motion.task.seed);
    attach(&name(PLAN_FILE), json(&plan)?.as_bytes())?;
    let before = particles_to_csv(&motion.task.particles);
    attach(&name(PARTICLES_BEFORE_FILE), before.as_bytes())?;
    let belief = &round.interpretation.belief;
    let estimated = belief.sample(motion.task.seed).map_err(internal)?;
    attach(
        &name(PARTICLES_ESTIMATED_FILE),
        particles_to_csv(&estimated).as_bytes(),
    )?;
    if let Some(truth) = &done.truth {
        attach(
            &name(PARTICLES_TRUE_FILE),
            particles_to_csv(truth).as_bytes(),
        )?;
    }
    Ok(())
}

/// What was seen before and after a round, in the frame of the surface as it was believed to be in it; `before` is what was
/// last seen.
fn observations(done: &Done, before: Option<&Seen>) -> RoundObservations {
    let round = &done.round;
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
fn begin(memory: &Memory, start: f64) -> Result<EpisodeWriter, MemoryError> {
    // Programs that begin in the same second seldom share the process number's last digits as well.
    begin_from(memory, start, std::process::id() as u16)
}

/// The same, from these last digits on.
pub(super) fn begin_from(
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

/// Seconds since 1970.
pub(super) fn now() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_secs_f64()
}

pub(super) fn cannot_keep(error: &MemoryError) -> Failure {
    Failure::new(error).with_help("--memory DIR keeps the episode elsewhere, --no-memory nowhere")
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch_memory::{EPISODE_SCHEMA, Origin};

    const YEAR: f64 = 31_557_600.0;

    #[test]
    fn a_clock_that_is_set_by_a_year_either_way_is_told() {
        for (by, way) in [(YEAR, "forward by 365 days"), (-YEAR, "back by 365 days")] {
            let told = clock_was_set(by).expect("it is told");
            assert!(told.contains(way), "{told}");
        }
        for by in [0.0, 0.4, -30.0] {
            assert_eq!(clock_was_set(by), None);
        }
    }

    #[test]
    fn an_episode_that_is_dated_ahead_is_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let memory = Memory::create(folder.path()).expect("a memory");
        assert_eq!(dated_ahead(&memory, 2e9), None);
        let id = episode_id(2e9, 1);
        let record = EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id: id.clone(),
            task: "board".to_owned(),
            // Whatever its duration is, it dates no other episode.
            interval: [2e9, 9e9],
            origin: Origin::Simulated,
            program: "by hand".to_owned(),
            seed: 1,
            rounds: Vec::new(),
            individuals: Vec::new(),
        };
        let writer = memory.begin(&id).expect("a writer");
        writer.commit(&record).expect("an episode");
        let told = dated_ahead(&memory, 2e9 - YEAR).expect("it is told");
        assert!(told.contains(&id) && told.contains("365 days"), "{told}");
        assert_eq!(dated_ahead(&memory, 2e9 + YEAR), None);
    }
}
