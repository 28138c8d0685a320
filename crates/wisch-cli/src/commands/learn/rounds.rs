//! The recorded rounds to learn from, in bags and in episodes of a memory.

use super::super::log_advice::log_failure;
use super::super::memory::{memory_failure, open};
use super::super::words::format_count;
use super::Tasks;
use crate::args::{DEFAULT_MEMORY, LearnArgs, MemoryArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use wisch::geometry::Pose;
use wisch::interpret::{TouchSample, UnusableWrenches};
use wisch::represent::Observation;
use wisch_io::FileDigest;
use wisch_memory::{Episode, MemoryError, is_same_motion, may_be_same_observations};
use wisch_telemetry::{LogOptions, is_bag, read};

/// The rounds of a run.
pub(super) struct Recording {
    /// Folder of the bags, or of the episode.
    pub folder: PathBuf,
    /// The rounds.
    pub sources: Vec<Source>,
    /// Whether it is an episode that the command line does not name: it is left out if its law cannot be learned.
    pub is_optional: bool,
}

/// The recording of a round.
pub(super) enum Source {
    /// A bag.
    Bag(PathBuf),
    /// A round of an episode.
    Episode {
        episode: Episode,
        /// Key of the executed task.
        task: String,
        /// Number of the round in the episode, from 1.
        number: usize,
    },
}

/// A recorded round.
pub(super) struct RecordedRound {
    /// The file of the round.
    pub place: PathBuf,
    /// Name of the executed task, if a bag states it.
    pub task: Option<String>,
    /// Digest of the mesh of the surface, if a bag states it.
    pub surface_mesh: Option<String>,
    /// Nominal press force [N], if a bag states it.
    pub press_force_n: Option<f64>,
    /// Number of the round in its run, from 1, if the file states it.
    pub number: Option<usize>,
    /// Tool poses and measured forces.
    pub samples: Vec<TouchSample>,
    /// Numbers of further samples, whose wrench is not usable.
    pub unusable: UnusableWrenches,
    /// Believed pose of the surface, if the file states it.
    pub world_from_surface: Option<Pose>,
    /// Observations before and after the round, in the surface frame.
    observations: [Option<Observation>; 2],
    /// Prefixes of the error message for a missing observation before and after.
    unseen: [&'static str; 2],
}

impl Source {
    /// The key of the executed task; `None` for a bag, which states its name.
    pub fn task(&self) -> Option<&str> {
        match self {
            Self::Bag(_) => None,
            Self::Episode { task, .. } => Some(task),
        }
    }

    /// The file of the round, for messages.
    pub fn place(&self) -> PathBuf {
        match self {
            Self::Bag(path) => path.clone(),
            Self::Episode {
                episode, number, ..
            } => round_path(episode, *number),
        }
    }

    /// Reads the round. A round of an episode of which no wrench is usable is left out with a note.
    pub fn read(&self) -> Result<Option<RecordedRound>, Failure> {
        match self {
            Self::Bag(path) => {
                let log =
                    read(path, &LogOptions::default()).map_err(|error| log_failure(error, path))?;
                Ok(Some(RecordedRound {
                    place: path.clone(),
                    task: log.task,
                    surface_mesh: log.surface_mesh,
                    press_force_n: log.press_force_n,
                    number: log.round,
                    samples: log.samples,
                    world_from_surface: log.world_from_surface,
                    observations: log.observations,
                    unusable: log.unusable,
                    unseen: [
                        "topic /wisch/dirt_before is missing: ",
                        "topic /wisch/dirt_after is missing: ",
                    ],
                }))
            }
            Self::Episode {
                episode, number, ..
            } => {
                let seen = episode.observations(*number).map_err(memory_failure)?;
                let telemetry = episode.telemetry(*number).map_err(memory_failure)?;
                let touch = telemetry.touch_samples();
                let (samples, unusable) =
                    touch.map_err(|error| memory_failure(MemoryError::from(error)))?;
                let place = round_path(episode, *number);
                if samples.is_empty() {
                    let count = unusable.count();
                    if count == 0 {
                        return Err(Failure::new("the round has no sample").within(&place));
                    }
                    remark(&format!(
                        "left out: {}: the round has {count} samples, none with a usable wrench",
                        place.display()
                    ));
                    return Ok(None);
                }
                let (round, world_from_surface, observations) = match seen {
                    Some(seen) => (seen.round, Some(seen.world_from_surface), seen.observations),
                    None => (None, None, [None, None]),
                };
                Ok(Some(RecordedRound {
                    place,
                    task: None,
                    surface_mesh: None,
                    press_force_n: None,
                    number: Some(round.unwrap_or(*number)),
                    samples,
                    world_from_surface,
                    observations,
                    unusable,
                    unseen: [""; 2],
                }))
            }
        }
    }
}

impl RecordedRound {
    /// Returns a digest that the bag and the episode of a round share: of its duration, of its first and last tool position,
    /// and of its detections, in the single precision in which files keep them.
    pub fn compute_digest(&self) -> String {
        let mut digest = FileDigest::EMPTY;
        let ends = self.samples.first().zip(self.samples.last());
        if let Some((first, last)) = ends {
            let milliseconds = (1e3 * (last.time - first.time)).round() as i64;
            digest.add(&milliseconds.to_le_bytes());
        }
        let mut add = |number: f64| digest.add(&(number as f32).to_le_bytes());
        for sample in self.samples.first().into_iter().chain(self.samples.last()) {
            let place = sample.world_from_tool.translation.vector;
            place.iter().for_each(|number| add(*number));
        }
        for place in self
            .observations
            .iter()
            .flatten()
            .flat_map(|seen| &seen.detections)
        {
            add(place.x);
            add(place.y);
        }
        let text = digest.to_string();
        text.split(':').nth(1).unwrap_or(&text).to_owned()
    }

    /// Returns the observations before and after the round.
    ///
    /// # Errors
    /// If one of them is missing.
    pub fn observations_of_both(&self) -> Result<[Observation; 2], Failure> {
        let missing = (self.observations.iter().zip(&self.unseen).zip(WHEN))
            .find_map(|((observation, said), when)| observation.is_none().then_some((said, when)));
        match (&self.observations, missing) {
            ([Some(before), Some(after)], _) => Ok([before.clone(), after.clone()]),
            (_, missing) => {
                let (said, when) = missing.unwrap_or((&"", WHEN[0]));
                Err(no_observation_failure(&self.place, said, when))
            }
        }
    }
}

/// The rounds that were read so far, without their samples.
#[derive(Default)]
pub(super) struct KnownRounds<'a> {
    rounds: Vec<(&'a Source, [Option<Observation>; 2])>,
}

impl<'a> KnownRounds<'a> {
    /// Number of the rounds.
    pub const fn count(&self) -> usize {
        self.rounds.len()
    }

    /// Forgets all rounds but the first `count`.
    pub fn truncate(&mut self, count: usize) {
        self.rounds.truncate(count);
    }

    /// Returns the earlier source that holds the same round; `None` for a new round, which is remembered.
    ///
    /// # Errors
    /// If that source cannot be read again.
    pub fn find(
        &mut self,
        source: &'a Source,
        round: &RecordedRound,
    ) -> Result<Option<&'a Source>, Failure> {
        for (known, observations) in &self.rounds {
            if !may_be_same_observations(&round.observations, observations) {
                continue;
            }
            // Samples of all rounds would not fit the memory of the machine, so those of a likely one are read again.
            let known_round = known.read()?;
            if known_round.is_some_and(|known| is_same_motion(&round.samples, &known.samples)) {
                return Ok(Some(*known));
            }
        }
        self.rounds.push((source, round.observations.clone()));
        Ok(None)
    }
}

const WHEN: [&str; 2] = ["before", "after"];

fn no_observation_failure(place: &Path, said: &str, when: &str) -> Failure {
    Failure::new(format!(
        "{said}there is no camera observation of the dirt {when} this round"
    ))
    .within(place)
    .with_help("set perception.senses = [\"touch\", \"sight\"] in the task, so that the robot observes the dirt")
}

/// Returns the path of a round in its episode, for messages.
fn round_path(episode: &Episode, number: usize) -> PathBuf {
    episode.folder().join(format!("round-{number}"))
}

/// Lists all recorded rounds of the arguments, grouped by run, and counts the episodes that are left out.
pub(super) fn list_recordings(
    args: &LearnArgs,
    tasks: &mut Tasks,
    progress: &Progress,
) -> Result<(Vec<Recording>, usize), Failure> {
    let bags = list_bags(&args.bags)?.into_iter();
    let mut recordings: Vec<Recording> = bags
        .map(|(folder, bags)| Recording {
            folder,
            sources: bags.into_iter().map(Source::Bag).collect(),
            is_optional: false,
        })
        .collect();
    if args.memory.is_none() && args.episodes.is_empty() {
        return Ok((recordings, 0));
    }
    let mut left_out = 0;
    let folder = args.memory.clone();
    let folder = folder.unwrap_or_else(|| PathBuf::from(DEFAULT_MEMORY));
    let memory = open(&MemoryArgs {
        memory: folder.clone(),
    })?;
    let named: BTreeSet<&String> = args.episodes.iter().collect();
    for &id in &named {
        let episode = memory.episode(id).map_err(memory_failure)?;
        recordings.push(read_recording(episode, tasks)??);
    }
    if named.is_empty() {
        let mut episodes = 0;
        for id in memory.episodes().map_err(memory_failure)? {
            let episode = memory.episode(&id).map_err(memory_failure)?;
            if episode.record().map_err(memory_failure)?.is_of_goal() {
                continue;
            }
            episodes += 1;
            match read_recording(episode, tasks)? {
                Ok(recording) => recordings.push(Recording {
                    is_optional: true,
                    ..recording
                }),
                Err(why) => {
                    left_out += 1;
                    progress.aside(|| remark(&format!("left out: {why}")));
                }
            }
        }
        if recordings.is_empty() {
            return Err(no_law_failure(episodes).within(&folder));
        }
    }
    Ok((recordings, left_out))
}

/// The error that no law can be learned from some episodes.
pub(super) fn no_law_failure(episodes: usize) -> Failure {
    let count = format_count(episodes, "episode");
    Failure::new(format!("none of {count} can be learned from")).with_help(
        "give the executed task with --task FILE; camera observations need perception.senses = [\"touch\", \"sight\"] in the task",
    )
}

/// Lists the rounds of an episode, or returns the reason why they cannot be learned from.
///
/// # Errors
/// If the episode cannot be read.
fn read_recording(
    episode: Episode,
    tasks: &mut Tasks,
) -> Result<Result<Recording, Failure>, Failure> {
    let record = episode.record().map_err(memory_failure)?;
    let folder = episode.folder().to_owned();
    let task = match tasks.of_episode(&episode, &record.task) {
        Ok(task) => task,
        Err(why) => return Ok(Err(why)),
    };
    let mut sources = Vec::new();
    for number in 1..=record.rounds.len() {
        let seen = episode.observations(number).map_err(memory_failure)?;
        let seen = seen.map_or([None, None], |seen| seen.observations);
        if let Some((_, when)) = seen
            .iter()
            .zip(WHEN)
            .find(|(observation, _)| observation.is_none())
        {
            return Ok(Err(no_observation_failure(
                &round_path(&episode, number),
                "",
                when,
            )));
        }
        // If the disk was full, the episode was kept without telemetry.
        if !episode.has_telemetry(number).map_err(memory_failure)? {
            let problem = "the telemetry of this round is missing";
            return Ok(Err(
                Failure::new(problem).within(&round_path(&episode, number))
            ));
        }
        sources.push(Source::Episode {
            episode: episode.clone(),
            task: task.clone(),
            number,
        });
    }
    if sources.is_empty() {
        return Ok(Err(
            Failure::new("the episode has no rounds").within(&folder)
        ));
    }
    Ok(Ok(Recording {
        folder,
        sources,
        is_optional: false,
    }))
}

/// Lists the bags of the arguments without duplicates, grouped by folder.
fn list_bags(paths: &[PathBuf]) -> Result<BTreeMap<PathBuf, Vec<PathBuf>>, Failure> {
    let mut bags: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    for path in paths {
        let found = if path.is_dir() {
            let telemetry = path.join("telemetry");
            let found = in_folder(if telemetry.is_dir() { &telemetry } else { path })?;
            if found.is_empty() {
                return Err(Failure::new(format!(
                    "{}: the folder contains no bag, neither NAME.mcap nor telemetry/NAME.mcap",
                    path.display()
                )));
            }
            found
        } else {
            check_is_bag(path)?;
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

/// Refuses a table, which holds no camera observations. A file that cannot be read has its error later.
fn check_is_bag(path: &Path) -> Result<(), Failure> {
    if !path.exists() || is_bag(path).unwrap_or(true) {
        return Ok(());
    }
    let problem = format!(
        "{}: this is no bag, and only bags and episodes hold the camera observations before and after a round from which wisch learns",
        path.display()
    );
    Err(Failure::new(problem).with_help(
        "give bags (.mcap) or folders of runs whose task has senses = [\"touch\", \"sight\"] in [perception], or a memory with --memory DIR",
    ))
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
