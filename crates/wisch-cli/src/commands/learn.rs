//! `wisch learn`: what rounds that were looked at before and after say of the laws in the knowledge base.

use super::prepare::Prepared;
use super::words::{counted, internal, percent};
use crate::args::{GlobalArgs, LearnArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use wisch::geometry::{Point2, Point3};
use wisch::interpret::{Exposure, InterpretConfig, Interpreter};
use wisch::learn::{GUESSES, LearnConfig, LearnedLaw, Lesson, SeenRound, Summary, learn as fitted};
use wisch::represent::{Interaction, KnowledgeBase, Task};
use wisch_io::{InteractionRevision, KnowledgeSource, OutputFile, RevisedFile, shipped_scenarios};
use wisch_telemetry::{Log, LogOptions, read};

/// What the object of `--json` is.
const FORMAT: &str = "wisch-learned";
const SCHEMA: u32 = 1;
/// How a file begins that is written here, and may be written over.
const HEADER: &str = "# Interactions as `wisch learn` has them";

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
struct LearnRecord {
    format: &'static str,
    schema: u32,
    /// The file that was written, or nothing.
    out: Option<String>,
    /// What changes, if that was asked for.
    diff: Option<String>,
    laws: Vec<LawRecord>,
}

/// A law before and after.
#[derive(Debug, Serialize)]
struct LawRecord {
    tool: String,
    medium: String,
    surface: String,
    rounds: usize,
    runs: usize,
    particles: usize,
    mu: ParameterRecord,
    sigma: ParameterRecord,
    redraw_length_m: ParameterRecord,
    kept_share: f64,
}

/// A parameter; `spread` is that of its logarithm, but for μ.
#[derive(Debug, Serialize)]
struct ParameterRecord {
    before: f64,
    mean: f64,
    spread: f64,
    low: f64,
    high: f64,
}

/// Everything that was seen of a law.
struct Evidence {
    interaction: Interaction,
    collision_radius: f64,
    rounds: Vec<SeenRound>,
    /// Folders that the rounds come from.
    runs: Vec<PathBuf>,
}

/// Reads bags, fits the laws that they tell of, and writes what the knowledge base may take over.
pub fn learn(args: &LearnArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the tasks");
    let source = KnowledgeSource::new(args.knowledge.as_deref());
    let knowledge = source.base()?;
    let mut tasks = Tasks::read(args)?;
    let bags = bags(&args.bags)?;
    let file = if args.diff {
        None
    } else {
        // Before the long part: nobody likes to wait for "permission denied".
        check_is_ours(&args.out)?;
        Some(OutputFile::begin(&args.out)?)
    };
    let lessons = evidence(&bags, &mut tasks, &knowledge, &progress)?;
    progress.say(format!("fitting {}", counted(lessons.len(), "law")));
    let given: Vec<Lesson<'_>> = (lessons.iter())
        .map(|evidence| Lesson {
            interaction: &evidence.interaction,
            collision_radius_m: evidence.collision_radius,
            rounds: &evidence.rounds,
        })
        .collect();
    let laws = fitted(&given, &LearnConfig::default()).map_err(|error| {
        Failure::new(error)
            .with_help("wipe and look more often: each round of a run with sight is a bag")
    })?;
    let revisions: Vec<InteractionRevision> = (lessons.iter().zip(&laws))
        .map(|(evidence, law)| InteractionRevision {
            interaction: law.applied_to(&evidence.interaction),
            source: source_in_words(evidence, law),
        })
        .collect();
    let revised = source.revised(&revisions)?;
    if let Some(file) = file {
        file.finish(entries(&revised).as_bytes())?;
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
        let line = serde_json::to_string(&record).map_err(internal)?;
        print(&(line + "\n"))?;
    } else if args.diff {
        print(&diff)?;
    } else if !global.quiet {
        print(&in_words(&record))?;
    }
    Ok(Outcome::Done)
}

/// The tasks that bags are of, by name.
struct Tasks {
    known: BTreeMap<String, Prepared>,
    /// Whether they were given, and not found by the names in bags.
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
            let prepared = tasks.prepared(path)?;
            let name = prepared.task.name.clone();
            if tasks.known.insert(name.clone(), prepared).is_some() {
                return Err(Failure::new(format!(
                    "{}: the task is named {name:?}, as another one of --task is",
                    path.display()
                )));
            }
        }
        Ok(tasks)
    }

    fn prepared(&self, path: &Path) -> Result<Prepared, Failure> {
        Prepared::read(&TaskArgs {
            task: path.to_owned(),
            strategy: None,
            action: None,
            seed: None,
            settings: Vec::new(),
            knowledge: self.knowledge.clone(),
        })
    }

    /// The task that a bag is of.
    fn of(&mut self, bag: &Path, log: &Log) -> Result<&Prepared, Failure> {
        let fault = |problem: String| Failure::new(problem).within(bag);
        let help = "--task FILE names the task that was wiped, once for each task";
        let name = match &log.task {
            Some(name) => name.clone(),
            None if self.known.len() == 1 => self.known.keys().next().cloned().unwrap_or_default(),
            None => {
                let problem = "the bag does not say which task was wiped".to_owned();
                return Err(fault(problem).with_help(help));
            }
        };
        let is_shipped = shipped_scenarios().any(|(known, _)| known == name);
        if !self.are_given && is_shipped && !self.known.contains_key(&name) {
            let prepared = self.prepared(Path::new(&name))?;
            self.known.insert(name.clone(), prepared);
        }
        let known: Vec<&String> = self.known.keys().collect();
        let problem = if self.are_given {
            format!("the bag is of the task {name:?}, and --task names {known:?}")
        } else {
            format!("the bag is of the task {name:?}, which is none of the shipped scenarios")
        };
        (self.known.get(&name)).ok_or_else(|| fault(problem).with_help(help))
    }
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

/// A round of a run, read.
struct ReadRound {
    bag: PathBuf,
    log: Log,
}

fn evidence(
    bags: &BTreeMap<PathBuf, Vec<PathBuf>>,
    tasks: &mut Tasks,
    knowledge: &KnowledgeBase,
    progress: &Progress,
) -> Result<Vec<Evidence>, Failure> {
    let count: usize = bags.values().map(Vec::len).sum();
    let mut done = 0;
    let mut laws: BTreeMap<[String; 3], Evidence> = BTreeMap::new();
    for (run, bags) in bags {
        let mut rounds: BTreeMap<String, Vec<ReadRound>> = BTreeMap::new();
        for bag in bags {
            done += 1;
            progress.say(format!("reading bag {done} of {count}: {}", bag.display()));
            let log = read(bag, &LogOptions::default()).map_err(Failure::new)?;
            let prepared = tasks.of(bag, &log)?;
            let read = ReadRound {
                bag: bag.clone(),
                log,
            };
            rounds
                .entry(prepared.task.name.clone())
                .or_default()
                .push(read);
        }
        for (name, mut rounds) in rounds {
            let prepared = &tasks.known[&name];
            rounds.sort_by_key(|round| round.log.round);
            let interaction = known_interaction(prepared, knowledge, &rounds[0].bag)?;
            let key = [
                interaction.tool.clone(),
                interaction.medium.clone(),
                interaction.surface.to_string(),
            ];
            let evidence = laws.entry(key).or_insert_with(|| Evidence {
                interaction,
                collision_radius: prepared.task.tool.collision_radius(),
                rounds: Vec::new(),
                runs: Vec::new(),
            });
            evidence
                .rounds
                .extend(seen_rounds(prepared, rounds, progress)?);
            evidence.runs.push(run.clone());
        }
    }
    Ok(laws.into_values().collect())
}

/// What the knowledge base has of a task's tool, medium and surface, if the task did not use them otherwise.
fn known_interaction(
    prepared: &Prepared,
    knowledge: &KnowledgeBase,
    bag: &Path,
) -> Result<Interaction, Failure> {
    let task = &prepared.task;
    let known = knowledge
        .interaction(&task.tool.name, &task.medium, &task.surface.name)
        .map_err(|error| {
            Failure::new(error)
                .within(bag)
                .with_help("what a task defines itself can be learned once it is in the knowledge base (--knowledge DIR)")
        })?;
    let used = &task.interaction;
    for (key, used, known) in [
        ("press_force_n", used.press_force_n, known.press_force_n),
        (
            "compression_depth_m",
            used.compression_depth_m,
            known.compression_depth_m,
        ),
    ] {
        if used != known {
            return Err(Failure::new(format!(
                "{}: task {:?} has interaction.{key} = {used}, and the knowledge base {known}: its law is that of another use",
                bag.display(),
                task.name
            )));
        }
    }
    Ok(known.clone())
}

/// The rounds of a run with what was felt in them.
fn seen_rounds(
    prepared: &Prepared,
    rounds: Vec<ReadRound>,
    progress: &Progress,
) -> Result<Vec<SeenRound>, Failure> {
    let sensor = prepared.file.perception().sight.unwrap_or_default();
    let sight = prepared.sight(sensor);
    let effect = prepared.task.action.effect();
    let mut felt: Vec<(Task, Interpreter)> = Vec::new();
    let mut seen = Vec::new();
    for ReadRound { bag, log } in rounds {
        let fault = |problem: &dyn std::fmt::Display| Failure::new(problem).within(&bag);
        let missing = (log.observations.iter().zip(["before", "after"]))
            .find_map(|(look, when)| look.is_none().then_some(when));
        let [Some(before), Some(after)] = log.observations else {
            let when = missing.unwrap_or("before");
            return Err(fault(&format!(
                "topic /wisch/dirt_{when} is missing: nothing was seen of the dirt {when} this round"
            ))
            .with_help("a robot looks whose task says perception.senses = [\"touch\", \"sight\"]"));
        };
        let mut task = prepared.task.clone();
        if let Some(logged) = log.world_from_surface {
            let apart = logged.inverse() * task.surface.world_from_surface;
            let distance = apart.translation.vector.norm();
            if distance > ELSEWHERE_M {
                return Err(fault(&format!(
                    "its surface is {distance:.3} m from that of the task {:?}, more than {ELSEWHERE_M} m: is it another task's?",
                    task.name
                )));
            }
            // Where it was planned on, which touch may have corrected.
            task.surface.world_from_surface = logged;
        }
        if let Some(round) = log.round.filter(|round| *round > felt.len() + 1) {
            progress.aside(|| {
                remark(&format!(
                    "{}: of the {} before it, {} given; what their dirt withstood is not known",
                    bag.display(),
                    counted(round - 1, "round"),
                    felt.len()
                ));
            });
        }
        let mut interpreter =
            Interpreter::new(&task, &InterpretConfig::of(&task)).map_err(|error| fault(&error))?;
        for sample in &log.samples {
            interpreter.push(sample).map_err(|error| fault(&error))?;
        }
        let exposures = |interpreter: &Interpreter, places: &[Point2]| {
            let error = sensor.position_error_m;
            interpreter.exposures(places, effect, error, GUESSES)
        };
        let mut earlier: Vec<Vec<f64>> = Vec::new();
        for (then, felt) in &felt {
            let then_from_now =
                then.surface.world_from_surface.inverse() * task.surface.world_from_surface;
            let places: Vec<Point2> = (before.detections.iter())
                .map(|p| (then_from_now * Point3::new(p.x, p.y, 0.0)).xy())
                .collect();
            let felt = exposures(felt, &places).map_err(|error| fault(&error))?;
            let most = felt
                .iter()
                .map(|guesses| guesses.iter().map(Exposure::most));
            let most: Vec<Vec<f64>> = most.map(Iterator::collect).collect();
            if earlier.is_empty() {
                earlier = most;
                continue;
            }
            for (known, most) in earlier.iter_mut().flatten().zip(most.into_iter().flatten()) {
                *known = known.max(most);
            }
        }
        seen.push(SeenRound {
            exposures: exposures(&interpreter, &before.detections)
                .map_err(|error| fault(&error))?,
            before,
            after,
            sight,
            area_m2: task.surface.outline.area(),
            earlier,
        });
        felt.push((task, interpreter));
    }
    Ok(seen)
}

/// How far a log's surface may be from the task's to be the same [m].
const ELSEWHERE_M: f64 = 0.05;

/// Refuses to write over a file of somebody else, such as one of the knowledge base.
fn check_is_ours(out: &Path) -> Result<(), Failure> {
    match std::fs::read(out) {
        Ok(bytes) if !bytes.starts_with(HEADER.as_bytes()) => Err(Failure::new(format!(
            "{}: this file is there already, and was not written by `wisch learn`",
            out.display()
        ))
        .with_help(
            "choose another file with --out; --diff shows what changes in the knowledge base",
        )),
        _ => Ok(()),
    }
}

/// The file that is written.
fn entries(revised: &[RevisedFile]) -> String {
    let mut text = format!(
        "{HEADER}, each in place of its entry in the knowledge base.\n# `wisch learn --diff` shows what that changes; `patch -p1` in the folder applies it.\nschema = 1\n"
    );
    for entry in revised.iter().flat_map(RevisedFile::entries) {
        text += "\n";
        text += entry;
    }
    text
}

fn exp(summary: &Summary) -> [f64; 2] {
    summary.interval.map(f64::exp)
}

/// Where a law comes from.
fn source_in_words(evidence: &Evidence, law: &LearnedLaw) -> Vec<String> {
    let [mu_low, mu_high] = law.mu.interval;
    let [sigma_low, sigma_high] = exp(&law.ln_sigma);
    let [length_low, length_high] = exp(&law.ln_redraw_length);
    let before = &evidence.interaction.likelihood;
    vec![
        format!(
            "from {} of {}, in which {} were touched and looked for",
            counted(law.rounds, "round"),
            counted(evidence.runs.len(), "run"),
            counted(law.particles, "particle")
        ),
        format!(
            "with 90 % probability mu is {mu_low:.3} to {mu_high:.3}, sigma {sigma_low:.3} to {sigma_high:.3}, redraw_length_m {length_low:.3} to {length_high:.3}"
        ),
        format!("before: mu = {}, sigma = {}", before.mu, before.sigma),
    ]
}

fn law_record(evidence: &Evidence, law: &LearnedLaw) -> LawRecord {
    let Interaction {
        tool,
        medium,
        surface,
        likelihood,
        redraw,
        ..
    } = &evidence.interaction;
    let of_log = |before: f64, summary: &Summary| {
        let [low, high] = exp(summary);
        ParameterRecord {
            before,
            mean: summary.mean.exp(),
            spread: summary.deviation,
            low,
            high,
        }
    };
    let [low, high] = law.mu.interval;
    LawRecord {
        tool: tool.clone(),
        medium: medium.clone(),
        surface: surface.to_string(),
        rounds: law.rounds,
        runs: evidence.runs.len(),
        particles: law.particles,
        mu: ParameterRecord {
            before: likelihood.mu,
            mean: law.mu.mean,
            spread: law.mu.deviation,
            low,
            high,
        },
        sigma: of_log(likelihood.sigma, &law.ln_sigma),
        redraw_length_m: of_log(
            redraw.length_m.unwrap_or(evidence.collision_radius),
            &law.ln_redraw_length,
        ),
        kept_share: law.kept_share,
    }
}

/// The summary for people.
fn in_words(record: &LearnRecord) -> String {
    let mut text = String::new();
    for law in &record.laws {
        text += &format!("{} on {} on {}\n", law.tool, law.medium, law.surface);
        let told = |parameter: &ParameterRecord| {
            let ParameterRecord {
                before,
                mean,
                low,
                high,
                ..
            } = parameter;
            format!("{mean:.3}, {low:.3} to {high:.3} with 90 % probability (before: {before:.3})")
        };
        for (name, value) in [
            ("mu", told(&law.mu)),
            ("sigma", told(&law.sigma)),
            ("redraw length [m]", told(&law.redraw_length_m)),
            (
                "thresholds",
                format!(
                    "kept for good with a probability of {}",
                    percent(law.kept_share)
                ),
            ),
            (
                "from",
                format!(
                    "{} of {}, {}",
                    counted(law.rounds, "round"),
                    counted(law.runs, "run"),
                    counted(law.particles, "particle")
                ),
            ),
        ] {
            text += &format!("  {name:<18} {value}\n");
        }
    }
    if let Some(out) = &record.out {
        text += &format!("  {:<18} {out}\n", "results");
    }
    text
}
