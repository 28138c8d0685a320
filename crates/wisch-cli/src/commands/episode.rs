//! A run kept as an episode: telemetry while it is executed, the rest when it is over.

use super::job::Done;
use super::prepare::Prepared;
use super::watch::Seen;
use super::words::{internal, json};
use crate::args::{KeepArgs, TaskArgs};
use crate::failure::Failure;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};
use wisch::represent::Observation;
use wisch::run::{PlannedRound, RunEvent};
use wisch_io::{PARTICLES_BEFORE_FILE, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE};
use wisch_io::{PlanRecord, RobotFiles, particles_to_csv};
use wisch_memory::{
    EpisodeHeader, EpisodeRound, EpisodeWriter, Memory, MemoryError, Origin, RECORDING_FILE,
    RobotText, RoundLog, RoundObservations, RoundScene, TelemetryWriter, episode_id, remember,
};

/// What wrote an episode.
pub(super) const PROGRAM: &str = concat!("wisch ", env!("CARGO_PKG_VERSION"));
/// Least time between the episodes of a memory [s].
const PAUSE: f64 = 1.0;
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
    start: f64,
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
}

/// How a run was asked for, beside its task file.
#[derive(Serialize)]
struct Options<'a> {
    task_file: String,
    settings: &'a [(String, String)],
    strategy: String,
    seed: u64,
}

/// When the last episode of a memory is over [s since 1970]: simulations are faster than the time that they simulate,
/// and one robot does one thing at a time.
fn after_the_last(memory: &Memory) -> f64 {
    let names = memory.episodes().unwrap_or_default();
    let last = names.iter().max().map(|name| memory.episode(name));
    // One that cannot be read does not keep others from being written.
    let record = last.and_then(Result::ok).map(|last| last.record());
    record
        .and_then(Result::ok)
        .map_or(0.0, |record| record.interval[1] + PAUSE)
}

impl EpisodeRecorder {
    /// Begins an episode, unless none is wanted.
    ///
    /// `executor`: the program that executes, where that is not the simulated world.
    pub fn begin(args: &KeepArgs, executor: Option<String>) -> Result<Self, Failure> {
        if args.no_memory {
            return Ok(Self {
                kept: None,
                executor,
            });
        }
        let memory = Memory::create(&args.memory).map_err(|error| cannot_keep(&error))?;
        let start = now().max(after_the_last(&memory));
        let writer = begin(&memory, start).map_err(|error| cannot_keep(&error))?;
        let kept = Kept {
            place: args.memory.join(writer.id()),
            start,
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
        let Some(kept) = self.kept else {
            return Ok(None);
        };
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
            start: kept.start,
            target: prepared.file.target_performance(),
            seed: prepared.config.seed,
            program: PROGRAM.to_owned(),
        };
        // A round that was taken over from a killed run was not seen.
        let unseen = RoundLog::default();
        let rounds: Vec<_> = done
            .iter()
            .map(|done| {
                let round = &done.round;
                EpisodeRound {
                    motion: &round.motion,
                    log: kept.logs.get(&round.motion.number).unwrap_or(&unseen),
                    duration: round.execution.duration,
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
        (kept.writer.commit(&record)).map_err(|error| cannot_keep(&error))?;
        let lost = kept.lost.iter();
        let without = lost.map(|(round, error)| format!("the telemetry of round {round}: {error}"));
        Ok(Some(KeptEpisode {
            place: kept.place,
            without: without.collect(),
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
        self.telemetry = Some(self.writer.telemetry(motion.number, head)?);
        Ok(())
    }
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
pub(super) fn begin(memory: &Memory, start: f64) -> Result<EpisodeWriter, MemoryError> {
    // Programs that begin in the same second seldom share the process number's last digits as well.
    let first = std::process::id() as u16;
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
