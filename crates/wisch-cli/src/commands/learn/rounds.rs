//! Where rounds are recorded that teach: in bags, and in episodes of a memory.

use super::super::memory::{broken, open};
use super::super::words::counted;
use super::Tasks;
use crate::args::{DEFAULT_MEMORY, LearnArgs, MemoryArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use wisch::geometry::Pose;
use wisch::interpret::TouchSample;
use wisch::represent::Observation;
use wisch_memory::{Episode, MemoryError};
use wisch_telemetry::{LogOptions, read};

/// The rounds of a run.
pub(super) struct Recording {
    /// Where they are recorded: the folder of the bags, or the episode.
    pub folder: PathBuf,
    /// The rounds.
    pub sources: Vec<Source>,
}

/// Where a round is recorded.
pub(super) enum Source {
    /// In a bag.
    Bag(PathBuf),
    /// In an episode.
    Episode {
        episode: Episode,
        /// Name of the task that was wiped.
        task: String,
        /// The round in it, from 1.
        number: usize,
    },
}

/// A round as it was recorded.
pub(super) struct RecordedRound {
    /// The file that tells of it.
    pub place: PathBuf,
    /// Name of the task that was wiped, if it is said.
    pub task: Option<String>,
    /// Which round of its run it was, from 1, if it is said.
    pub number: Option<usize>,
    /// Where the tool was and what force it felt.
    pub samples: Vec<TouchSample>,
    /// Where the surface was believed to be, if it is said.
    pub world_from_surface: Option<Pose>,
    /// What was seen before and after, in the frame of that surface.
    observations: [Option<Observation>; 2],
    /// What is missing where nothing was seen before or after.
    unseen: [&'static str; 2],
}

impl Source {
    /// What it is.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Bag(_) => "bag",
            Self::Episode { .. } => "episode",
        }
    }

    /// The file that tells of the round, for people.
    pub fn place(&self) -> PathBuf {
        match self {
            Self::Bag(path) => path.clone(),
            Self::Episode {
                episode, number, ..
            } => place(episode, *number),
        }
    }

    /// Reads it.
    pub fn read(&self) -> Result<RecordedRound, Failure> {
        match self {
            Self::Bag(path) => {
                let log = read(path, &LogOptions::default()).map_err(Failure::new)?;
                Ok(RecordedRound {
                    place: path.clone(),
                    task: log.task,
                    number: log.round,
                    samples: log.samples,
                    world_from_surface: log.world_from_surface,
                    observations: log.observations,
                    unseen: [
                        "topic /wisch/dirt_before is missing: ",
                        "topic /wisch/dirt_after is missing: ",
                    ],
                })
            }
            Self::Episode {
                episode,
                task,
                number,
            } => {
                let seen = episode.observations(*number).map_err(broken)?;
                let telemetry = episode.telemetry(*number).map_err(broken)?;
                let samples = telemetry.touch_samples();
                let samples = samples.map_err(|error| broken(MemoryError::from(error)))?;
                let place = place(episode, *number);
                if samples.is_empty() {
                    return Err(Failure::new("the round has no sample").within(&place));
                }
                let (round, world_from_surface, observations) = match seen {
                    Some(seen) => (seen.round, Some(seen.world_from_surface), seen.observations),
                    None => (None, None, [None, None]),
                };
                Ok(RecordedRound {
                    place,
                    task: Some(task.clone()),
                    number: Some(round.unwrap_or(*number)),
                    samples,
                    world_from_surface,
                    observations,
                    unseen: [""; 2],
                })
            }
        }
    }
}

impl RecordedRound {
    /// What was seen before and after.
    pub fn looks(&self) -> Result<[Observation; 2], Failure> {
        let missing = (self.observations.iter().zip(&self.unseen).zip(WHEN))
            .find_map(|((look, said), when)| look.is_none().then_some((said, when)));
        match (&self.observations, missing) {
            ([Some(before), Some(after)], _) => Ok([before.clone(), after.clone()]),
            (_, missing) => {
                let (said, when) = missing.unwrap_or((&"", WHEN[0]));
                Err(unseen(&self.place, said, when))
            }
        }
    }
}

const WHEN: [&str; 2] = ["before", "after"];

fn unseen(place: &Path, said: &str, when: &str) -> Failure {
    Failure::new(format!(
        "{said}nothing was seen of the dirt {when} this round"
    ))
    .within(place)
    .with_help("a robot looks whose task says perception.senses = [\"touch\", \"sight\"]")
}

/// Where an episode tells of a round, for people: what was seen, and the telemetry beside.
fn place(episode: &Episode, number: usize) -> PathBuf {
    episode.folder().join(format!("round-{number}"))
}

/// All that is to be learned from, run by run.
pub(super) fn recordings(
    args: &LearnArgs,
    tasks: &mut Tasks,
    progress: &Progress,
) -> Result<Vec<Recording>, Failure> {
    let bags = bags(&args.bags)?.into_iter();
    let mut recordings: Vec<Recording> = bags
        .map(|(folder, bags)| Recording {
            folder,
            sources: bags.into_iter().map(Source::Bag).collect(),
        })
        .collect();
    if args.memory.is_none() && args.episodes.is_empty() {
        return Ok(recordings);
    }
    let folder = args.memory.clone();
    let folder = folder.unwrap_or_else(|| PathBuf::from(DEFAULT_MEMORY));
    let memory = open(&MemoryArgs {
        memory: folder.clone(),
    })?;
    let named: BTreeSet<&String> = args.episodes.iter().collect();
    for &id in &named {
        let episode = memory.episode(id).map_err(broken)?;
        recordings.push(recording(episode, tasks)??);
    }
    if named.is_empty() {
        let ids = memory.episodes().map_err(broken)?;
        for id in &ids {
            let episode = memory.episode(id).map_err(broken)?;
            match recording(episode, tasks)? {
                Ok(recording) => recordings.push(recording),
                Err(why) => progress.aside(|| remark(&format!("left out: {why}"))),
            }
        }
        if recordings.is_empty() {
            let count = counted(ids.len(), "episode");
            let problem = format!("{count}, and none that teaches");
            return Err(Failure::new(problem).within(&folder).with_help(
                "--task FILE names the task that was wiped; wisch run keeps what its robot sees if the task says perception.senses = [\"touch\", \"sight\"]",
            ));
        }
    }
    Ok(recordings)
}

/// The rounds of an episode, or why they do not teach.
///
/// # Errors
/// An episode that cannot be read.
fn recording(episode: Episode, tasks: &mut Tasks) -> Result<Result<Recording, Failure>, Failure> {
    let record = episode.record().map_err(broken)?;
    let folder = episode.folder().to_owned();
    if let Err(why) = tasks.of("episode", &folder, Some(&record.task)) {
        return Ok(Err(why));
    }
    let mut sources = Vec::new();
    for number in 1..=record.rounds.len() {
        let seen = episode.observations(number).map_err(broken)?;
        let seen = seen.map_or([None, None], |seen| seen.observations);
        if let Some((_, when)) = seen.iter().zip(WHEN).find(|(look, _)| look.is_none()) {
            return Ok(Err(unseen(&place(&episode, number), "", when)));
        }
        // On a full disk an episode is kept without.
        if !episode.has_telemetry(number).map_err(broken)? {
            let problem = "the telemetry of this round was not kept";
            return Ok(Err(Failure::new(problem).within(&place(&episode, number))));
        }
        sources.push(Source::Episode {
            episode: episode.clone(),
            task: record.task.clone(),
            number,
        });
    }
    if sources.is_empty() {
        return Ok(Err(Failure::new("it has no round").within(&folder)));
    }
    Ok(Ok(Recording { folder, sources }))
}

/// The bags that are meant, by the folder in which they lie, each once.
fn bags(paths: &[PathBuf]) -> Result<BTreeMap<PathBuf, Vec<PathBuf>>, Failure> {
    let mut bags: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    for path in paths {
        let found = if path.is_dir() {
            let telemetry = path.join("telemetry");
            let found = in_folder(if telemetry.is_dir() { &telemetry } else { path })?;
            if found.is_empty() {
                return Err(Failure::new(format!(
                    "{}: there is no bag in this folder, neither NAME.mcap nor telemetry/NAME.mcap",
                    path.display()
                )));
            }
            found
        } else {
            vec![path.clone()]
        };
        for bag in found {
            let place = bag
                .canonicalize()
                .map_err(|error| Failure::new(error).within(&bag))?;
            let folder = place.parent().unwrap_or(Path::new("/")).to_owned();
            let others = bags.entry(folder).or_default();
            if others
                .iter()
                .all(|other| other.canonicalize().ok() != Some(place.clone()))
            {
                others.push(bag);
            }
        }
    }
    Ok(bags)
}

fn in_folder(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error: std::io::Error| Failure::new(error).within(folder);
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "mcap") {
            found.push(path);
        }
    }
    found.sort_by_key(|path| (path.as_os_str().len(), path.clone()));
    Ok(found)
}
