//! `wisch learn`: fits the knowledge base's interaction laws to rounds with camera observations before and after.

mod record;
mod rounds;

use super::interpret::MAX_OFFSET_M;
use super::prepare;
use super::words::format_count;
use crate::args::{GlobalArgs, LearnArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json, remark};
use record::{FORMAT, LearnRecord, SCHEMA, exponentiate_interval, in_words, law_record};
use rounds::{KnownRounds, RecordedRound, Recording, list_recordings, no_law_failure};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use wisch::geometry::Point2;
use wisch::interpret::{Exposure, InterpretConfig, Interpreter};
use wisch::learn::{
    GUESSES, LawObservations, LearnConfig, LearnedLaw, ObservedRound, learn as fitted,
};
use wisch::represent::{Interaction, KnowledgeBase, SurfaceScope, Task};
use wisch_io::{
    InteractionRevision, KeptFiles, KnowledgeSource, LoadedTask, OutputFile, RevisedFile,
    shipped_scenarios,
};
use wisch_memory::Episode;

/// First line of a file that `wisch learn` has written and may overwrite.
const HEADER: &str = "# Interactions fitted by `wisch learn`";
/// The same in versions up to 0.2.0.
const EARLIER_HEADER: &str = "# Interactions as `wisch learn` has them";

/// The observed rounds of one law.
struct Evidence {
    interaction: Interaction,
    collision_radius: f64,
    rounds: Vec<ObservedRound>,
    /// Digests of the rounds.
    digests: Vec<String>,
    /// Folders of the runs and episodes that contain the rounds.
    runs: Vec<PathBuf>,
    /// Bags that do not state their press force.
    undeclared: Vec<PathBuf>,
}

/// Reads bags and episodes, fits their interaction laws, and writes entries for the knowledge base.
pub fn learn(args: &LearnArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the tasks");
    let source = KnowledgeSource::new(args.knowledge.as_deref());
    let knowledge = source.base()?;
    let mut tasks = Tasks::read(args)?;
    let (recordings, left_out) = list_recordings(args, &mut tasks, &progress)?;
    let file = if args.diff {
        None
    } else {
        // The file comes before the long computation, so that a missing permission is reported at once.
        check_overwritable(&args.out)?;
        Some(OutputFile::begin(&args.out)?)
    };
    let learned = source.list_learned_rounds()?;
    let (lessons, known) =
        collect_evidence(&recordings, &mut tasks, (&knowledge, &learned), &progress)?;
    if lessons.is_empty() && known > 0 {
        return Err(known_rounds_failure(known));
    }
    if lessons.is_empty() {
        return Err(no_law_failure(recordings.len() + left_out));
    }
    if known > 0 {
        let known = format_count(known, "round");
        progress.aside(|| {
            remark(&format!(
                "left out: {known} from which an entry of the knowledge base has been learned already; each round counts once"
            ));
        });
    }
    progress.say(format!("fitting {}", format_count(lessons.len(), "law")));
    let given: Vec<LawObservations<'_>> = (lessons.iter())
        .map(|evidence| LawObservations {
            interaction: &evidence.interaction,
            collision_radius_m: evidence.collision_radius,
            rounds: &evidence.rounds,
        })
        .collect();
    let laws = fitted(&given, &LearnConfig::default()).map_err(|error| {
        Failure::new(error).with_help(
            "record more rounds with camera observations; each round of a run with sight is in its bag and its episode",
        )
    })?;
    let revisions: Vec<InteractionRevision> = (lessons.iter().zip(&laws))
        .map(|(evidence, law)| InteractionRevision {
            interaction: law.apply_to(&evidence.interaction),
            source: source_in_words(evidence, law),
            rounds: evidence.digests.clone(),
        })
        .collect();
    let revised = source.revise_knowledge(&revisions)?;
    if let Some(file) = file {
        file.finish(format_entries(&revised).as_bytes())?;
    }
    drop(progress);

    let diff: String = revised.iter().map(RevisedFile::diff).collect();
    let record = LearnRecord {
        format: FORMAT,
        schema: SCHEMA,
        out: (!args.diff).then(|| args.out.display().to_string()),
        diff: args.diff.then(|| diff.clone()),
        laws: (lessons.iter().zip(&laws))
            .map(|(evidence, law)| law_record(evidence, law))
            .collect(),
    };
    if args.json {
        print_json(&record)?;
    } else if args.diff {
        print(&diff)?;
    } else if !global.quiet {
        print(&in_words(&record))?;
    }
    Ok(Outcome::Done)
}

const GIVE_TASKS: &str = "give the file of every executed task with --task FILE";

/// The executed tasks, by name; those that episodes keep, by the folder of the episode.
struct Tasks {
    known: BTreeMap<String, LoadedTask>,
    /// Whether `--task` gave them; otherwise they are the shipped scenarios that bags and episodes name.
    are_given: bool,
    knowledge: Option<PathBuf>,
}

impl Tasks {
    fn read(args: &LearnArgs) -> Result<Self, Failure> {
        let mut tasks = Self {
            known: BTreeMap::new(),
            are_given: !args.tasks.is_empty(),
            knowledge: args.knowledge.clone(),
        };
        for path in &args.tasks {
            let prepared = tasks.prepare_query(path)?;
            let name = prepared.task.name.clone();
            if tasks.known.insert(name.clone(), prepared).is_some() {
                return Err(Failure::new(format!(
                    "{}: two files of --task have the task name {name:?}",
                    path.display()
                )));
            }
        }
        Ok(tasks)
    }

    fn prepare_query(&self, path: &Path) -> Result<LoadedTask, Failure> {
        prepare::read(&TaskArgs {
            task: path.to_owned(),
            strategy: None,
            budget: None,
            action: None,
            seed: None,
            settings: Vec::new(),
            knowledge: self.knowledge.clone(),
        })
    }

    /// Returns the key in `known` of an episode's task. Without `--task`, it is the task that the episode keeps.
    ///
    /// # Errors
    /// If `--task` does not name the task, or names other files than those with which the episode was recorded.
    fn of_episode(&mut self, episode: &Episode, named: &str) -> Result<String, Failure> {
        let folder = episode.folder();
        if !self.are_given && folder.join("task.toml").is_file() {
            let key = folder.display().to_string();
            let own = prepare::load_kept(episode, self.knowledge.clone())
                .map_err(|failure| failure.with_help(GIVE_TASKS))?;
            self.known.insert(key.clone(), own);
            return Ok(key);
        }
        let key = self.of("episode", folder, Some(named))?;
        let kept = KeptFiles::read_from(folder)?;
        let own = &self.known[&key].files;
        let read = &mut |path: &str| own.get(path).map(<[u8]>::to_vec).ok_or_else(String::new);
        let changed = (kept.find_changes(read).into_iter())
            .find_map(|changed| Some((changed.path, changed.kept, changed.found.ok()?)));
        if let Some((path, kept, found)) = changed {
            let problem = format!(
                "the episode was recorded with another file {path:?}: its digest was {kept}, and that of the file of --task is {found}"
            );
            return Err(Failure::new(problem)
                .within(folder)
                .with_help("leave out --task to take the files that the episode keeps"));
        }
        Ok(key)
    }

    /// Returns the key in `known` of the task of a bag or episode. `named`: the task's name there, if it is stated.
    fn of(&mut self, kind: &str, place: &Path, named: Option<&str>) -> Result<String, Failure> {
        let fault = |problem: String| Failure::new(problem).within(place);
        let help = GIVE_TASKS;
        let name = match named {
            Some(name) => name.to_owned(),
            None if self.are_given && self.known.len() == 1 => {
                self.known.keys().next().cloned().unwrap_or_default()
            }
            None => {
                let problem = format!("the {kind} does not state its task");
                return Err(fault(problem).with_help(help));
            }
        };
        let is_shipped = shipped_scenarios().any(|(known, _)| known == name);
        if !self.are_given && is_shipped && !self.known.contains_key(&name) {
            let prepared = self.prepare_query(Path::new(&name))?;
            self.known.insert(name.clone(), prepared);
        }
        let known: Vec<&String> = self.known.keys().collect();
        let problem = if self.are_given {
            format!("the {kind} has the task {name:?}, but --task names {known:?}")
        } else {
            format!("the {kind} has the task {name:?}, which is not a shipped scenario")
        };
        if self.known.contains_key(&name) {
            Ok(name)
        } else {
            Err(fault(problem).with_help(help))
        }
    }
}

/// The error that the knowledge base has been learned from all rounds already.
fn known_rounds_failure(known: usize) -> Failure {
    let known = format_count(known, "given round");
    Failure::new(format!(
        "the knowledge base has been learned from all of the {known} already, and each round counts once"
    ))
    .with_help("give new rounds, or the knowledge base before that revision with --knowledge DIR")
}

/// Collects the observed rounds of each law, and counts those from which the knowledge base has been learned already
/// (`learned`: their digests), which are left out. An episode that the command line does not name is left out with a note if its law
/// cannot be learned.
fn collect_evidence(
    recordings: &[Recording],
    tasks: &mut Tasks,
    (knowledge, learned): (&KnowledgeBase, &BTreeSet<String>),
    progress: &Progress,
) -> Result<(Vec<Evidence>, usize), Failure> {
    let mut reader = EvidenceReader {
        tasks,
        knowledge,
        learned,
        already_learned: 0,
        progress,
        count: recordings.iter().map(|run| run.sources.len()).sum(),
        done: 0,
        known: KnownRounds::default(),
    };
    let mut laws: BTreeMap<[String; 3], Evidence> = BTreeMap::new();
    for run in recordings {
        let found = match reader.read(run) {
            Err(why) if run.is_optional => {
                progress.aside(|| remark(&format!("left out: {why}")));
                continue;
            }
            found => found?,
        };
        for one in found {
            let Interaction {
                tool,
                medium,
                surface,
                ..
            } = &one.interaction;
            let key = [tool.clone(), medium.clone(), surface.to_string()];
            match laws.get_mut(&key) {
                Some(evidence) => {
                    evidence.rounds.extend(one.rounds);
                    evidence.digests.extend(one.digests);
                    evidence.runs.extend(one.runs);
                    evidence.undeclared.extend(one.undeclared);
                }
                None => {
                    laws.insert(key, one);
                }
            }
        }
    }
    for evidence in laws.values().filter(|law| !law.undeclared.is_empty()) {
        let force = evidence.interaction.press_force_n;
        let bags = evidence
            .undeclared
            .iter()
            .map(|bag| bag.display().to_string());
        let bags = bags.collect::<Vec<_>>().join(", ");
        progress.aside(|| {
            remark(&format!(
                "the press force of the task, {force} N, is assumed for bags of an earlier version, which do not state it: {bags}"
            ));
        });
    }
    Ok((laws.into_values().collect(), reader.already_learned))
}

/// Reads the observed rounds of runs.
struct EvidenceReader<'a, 'b> {
    tasks: &'a mut Tasks,
    knowledge: &'a KnowledgeBase,
    /// Digests of the rounds from which the knowledge base has been learned, and the number of those that were given again.
    learned: &'a BTreeSet<String>,
    already_learned: usize,
    progress: &'a Progress,
    /// Number of rounds, and of those that were read.
    count: usize,
    done: usize,
    known: KnownRounds<'b>,
}

impl<'b> EvidenceReader<'_, 'b> {
    /// Reads the rounds of a run, by task. After an error, none of its rounds counts as read.
    fn read(&mut self, run: &'b Recording) -> Result<Vec<Evidence>, Failure> {
        let known = self.known.count();
        let found = self.read_new(run);
        if found.is_err() {
            self.known.truncate(known);
        }
        found
    }

    fn read_new(&mut self, run: &'b Recording) -> Result<Vec<Evidence>, Failure> {
        let mut rounds: BTreeMap<String, Vec<RecordedRound>> = BTreeMap::new();
        for source in &run.sources {
            self.done += 1;
            let place = source.place();
            self.progress.say(format!(
                "reading round {} of {}: {}",
                self.done,
                self.count,
                place.display()
            ));
            let Some(round) = source.read()? else {
                continue;
            };
            round.observations_of_both()?;
            if let Some(earlier) = self.known.find(source, &round)? {
                self.progress.aside(|| {
                    remark(&format!(
                        "counted once: {} holds the same round as {}",
                        place.display(),
                        earlier.place().display()
                    ));
                });
                continue;
            }
            let key = match source.task() {
                Some(key) => key.to_owned(),
                None => self.tasks.of("bag", &place, round.task.as_deref())?,
            };
            rounds.entry(key).or_default().push(round);
        }
        let mut found = Vec::new();
        for (key, mut rounds) in rounds {
            let prepared = &self.tasks.known[&key];
            rounds.sort_by_key(|round| round.number);
            let mut digests: Vec<String> =
                rounds.iter().map(RecordedRound::compute_digest).collect();
            let is_new: Vec<bool> = digests
                .iter()
                .map(|digest| !self.learned.contains(digest))
                .collect();
            digests.retain(|digest| !self.learned.contains(digest));
            self.already_learned += rounds.len() - digests.len();
            if digests.is_empty() {
                continue;
            }
            let interaction = find_interaction(prepared, self.knowledge, &rounds[0].place)?;
            for round in &rounds {
                check_force(prepared, round)?;
            }
            let is_undeclared =
                |round: &&RecordedRound| round.task.is_some() && round.press_force_n.is_none();
            found.push(Evidence {
                interaction,
                collision_radius: prepared.task.tool.collision_radius(),
                undeclared: (rounds.iter().filter(is_undeclared))
                    .map(|round| round.place.clone())
                    .collect(),
                rounds: read_observed_rounds(prepared, (rounds, &is_new), self.progress)?,
                digests,
                runs: vec![run.folder.clone()],
            });
        }
        Ok(found)
    }
}

/// Checks that a round was recorded with the press force of its task. A law holds for one force, so rounds of several forces
/// are not pooled.
fn check_force(prepared: &LoadedTask, round: &RecordedRound) -> Result<(), Failure> {
    let nominal = prepared.task.interaction.press_force_n;
    match round.press_force_n {
        Some(force) if force != nominal => Err(Failure::new(format!(
            "the round was recorded with a press force of {force} N, but task {:?} has interaction.press_force_n = {nominal} N; a law holds for one force",
            prepared.task.name
        ))
        .within(&round.place)
        .with_help("learn from rounds of one force: the force of the task and of the knowledge base")),
        _ => Ok(()),
    }
}

/// Returns the knowledge base's interaction of a task's tool, medium and surface.
///
/// # Errors
/// If the task treats the surface, if the knowledge base has no such interaction, or if the task has used the tool with
/// another force, compression depth or gap.
fn find_interaction(
    prepared: &LoadedTask,
    knowledge: &KnowledgeBase,
    place: &Path,
) -> Result<Interaction, Failure> {
    let task = &prepared.task;
    if task.action.treats() {
        return Err(Failure::new(format!(
            "{}: task {:?} has the action {}, whose effect no camera observes; no law can be learned from it",
            place.display(),
            task.name,
            task.action
        )));
    }
    let used = &task.interaction;
    let (tool, medium) = (&task.tool.name, &task.medium);
    // A surface that only the task defines is wiped by an interaction for any surface.
    let is_for_any = |known: &&Interaction| {
        let names = [&known.tool, &known.medium];
        names == [tool, medium] && known.surface == SurfaceScope::Any
    };
    let known = match used.surface {
        SurfaceScope::Any if knowledge.surface(&task.surface.name).is_err() => {
            knowledge.interactions().find(is_for_any)
        }
        _ => None,
    };
    let known = known.map_or_else(
        || knowledge.interaction(tool, medium, &task.surface.name),
        Ok,
    );
    let known = known.map_err(|error| {
        Failure::new(error).within(place).with_help(
            "add the task's own definitions to a knowledge base and give it with --knowledge DIR",
        )
    })?;
    for (key, used, known) in [
        ("press_force_n", used.press_force_n, known.press_force_n),
        (
            "compression_depth_m",
            used.compression_depth_m,
            known.compression_depth_m,
        ),
        ("gap_m", used.gap_m, known.gap_m),
    ] {
        if used != known {
            return Err(Failure::new(format!(
                "{}: task {:?} has interaction.{key} = {used}, but the knowledge base has {known}; its law does not apply",
                place.display(),
                task.name
            )));
        }
    }
    Ok(known.clone())
}

/// Interprets the rounds of a run and pairs their camera observations with the measured exposure of each particle. Rounds that
/// are not new only expose the dirt of later ones.
fn read_observed_rounds(
    prepared: &LoadedTask,
    (rounds, is_new): (Vec<RecordedRound>, &[bool]),
    progress: &Progress,
) -> Result<Vec<ObservedRound>, Failure> {
    let sensor = prepared.file.camera.unwrap_or_default();
    let sight = prepared.sight(sensor);
    let effect = prepared.task.action.effect();
    let mut interpreted: Vec<(Task, Interpreter)> = Vec::new();
    let mut seen = Vec::new();
    for (round, is_new) in rounds.into_iter().zip(is_new) {
        let fault = |problem: &dyn std::fmt::Display| Failure::new(problem).within(&round.place);
        prepare::check_mesh(round.surface_mesh.as_deref(), &prepared.task)
            .map_err(|failure| failure.within(&round.place))?;
        let [before, after] = round.observations_of_both()?;
        let mut task = prepared.task.clone();
        if let Some(logged) = round.world_from_surface {
            let apart = logged.inverse() * task.surface.world_from_surface;
            let distance = apart.translation.vector.norm();
            if distance > MAX_OFFSET_M {
                return Err(fault(&format!(
                    "the log's surface is {distance:.3} m away from the surface of task {:?}, limit {MAX_OFFSET_M} m: is --task the task of this log?",
                    task.name
                )));
            }
            // The surface pose of the round's plan, which touch may have corrected.
            task.surface.world_from_surface = logged;
        }
        if let Some(number) = round
            .number
            .filter(|number| *number > interpreted.len() + 1)
        {
            progress.aside(|| {
                remark(&format!(
                    "{}: only {} of {} before it are given; the exposure of the dirt in the missing rounds is unknown",
                    round.place.display(),
                    interpreted.len(),
                    format_count(number - 1, "round")
                ));
            });
        }
        let config = InterpretConfig {
            has_one_clock: true,
            ..InterpretConfig::from_task(&task)
        };
        let mut interpreter = Interpreter::new(&task, &config).map_err(|error| fault(&error))?;
        if let count @ 1.. = round.unusable.count() {
            progress.aside(|| {
                remark(&format!(
                    "{}: the wrench of {} is not usable by its quality, and is left out",
                    round.place.display(),
                    format_count(count, "sample")
                ));
            });
        }
        for sample in &round.samples {
            interpreter.push(sample).map_err(|error| fault(&error))?;
        }
        if !is_new {
            interpreted.push((task, interpreter));
            continue;
        }
        let exposures = |interpreter: &Interpreter, places: &[Point2]| {
            let error = sensor.position_error_m;
            interpreter.exposures(places, effect, error, GUESSES)
        };
        let mut earlier: Vec<Vec<f64>> = Vec::new();
        for (then, interpreter_then) in &interpreted {
            let then_from_now =
                then.surface.world_from_surface.inverse() * task.surface.world_from_surface;
            let places = before
                .transform(&then_from_now, &task.surface.shape)
                .detections;
            let exposed = exposures(interpreter_then, &places).map_err(|error| fault(&error))?;
            let most = exposed
                .iter()
                .map(|guesses| guesses.iter().map(Exposure::max_share));
            let most: Vec<Vec<f64>> = most.map(Iterator::collect).collect();
            if earlier.is_empty() {
                earlier = most;
                continue;
            }
            for (known, most) in earlier.iter_mut().flatten().zip(most.into_iter().flatten()) {
                *known = known.max(most);
            }
        }
        seen.push(ObservedRound {
            exposures: exposures(&interpreter, &before.detections)
                .map_err(|error| fault(&error))?,
            before,
            after,
            sight,
            area_m2: task.surface.outline.area(),
            earlier,
        });
        interpreted.push((task, interpreter));
    }
    Ok(seen)
}

/// Refuses to overwrite a file that `wisch learn` has not written, such as a file of the knowledge base.
fn check_overwritable(out: &Path) -> Result<(), Failure> {
    match std::fs::read(out) {
        Ok(bytes)
            if ![HEADER, EARLIER_HEADER]
                .iter()
                .any(|header| bytes.starts_with(header.as_bytes())) =>
        {
            Err(Failure::new(format!(
                "{}: the file exists and was not written by `wisch learn`",
                out.display()
            ))
            .with_help(
                "choose another file with --out; --diff shows what changes in the knowledge base",
            ))
        }
        _ => Ok(()),
    }
}

/// Formats the learned interactions as a file.
fn format_entries(revised: &[RevisedFile]) -> String {
    let mut text = format!(
        "{HEADER}; each replaces its entry in the knowledge base.\n# `wisch learn --diff` prints the changes; `patch -p1` in the folder applies them.\nschema = 1\n"
    );
    for entry in revised.iter().flat_map(RevisedFile::entries) {
        text += "\n";
        text += entry;
    }
    text
}

/// Describes the data from which a law was learned, as comment lines.
fn source_in_words(evidence: &Evidence, law: &LearnedLaw) -> Vec<String> {
    let [mu_low, mu_high] = law.mu.interval;
    let [sigma_low, sigma_high] = exponentiate_interval(&law.ln_sigma);
    let [length_low, length_high] = exponentiate_interval(&law.ln_redraw_length);
    let before = &evidence.interaction.likelihood;
    vec![
        format!(
            "from {} of {} with {} that were wiped and observed",
            format_count(law.rounds, "round"),
            format_count(evidence.runs.len(), "run"),
            format_count(law.particles, "particle")
        ),
        format!(
            "with 90 % probability mu is {mu_low:.3} to {mu_high:.3}, sigma {sigma_low:.3} to {sigma_high:.3}, redraw_length_m {length_low:.3} to {length_high:.3}"
        ),
        format!("before: mu = {}, sigma = {}", before.mu, before.sigma),
    ]
}
