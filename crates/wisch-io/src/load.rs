//! Loads a task file with all its data into a task that can be planned.

use crate::assets::{KnowledgeSource, read_beside, read_task_text};
use crate::digest::InputDigest;
use crate::error::Error;
use crate::gravity::{gravity_remark, let_slide};
use crate::kept_files::KeptFiles;
use crate::particles::{ParticleSource, read_observed_image, read_observed_list};
use crate::robots::Robot;
use crate::task_file::{Intent, TaskFile, task_remarks};
use crate::up_axis::up_axis_remark;
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use wisch::goal::{GoalLiteral, resolve_goal};
use wisch::interpret::{Belief, DirtPrior, member_count};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, PlanError, Strategy, plan};
use wisch::represent::{
    Action, DirtArea, KnowledgeBase, Observation, SensorModel, Sight, SteepSurface, Task,
};
use wisch::run::{RunConfig, Session};
use wisch::source_location::UnknownName;
use wisch_sim::SimulationSettings;

/// Default strategy: the simplest one of the paper, which covers every free cell of a grid.
const DEFAULT_STRATEGY: Strategy = Strategy::Coverage(CoverageStrategy::Grid);

/// Values that override those of a task file.
///
/// ```
/// use wisch_io::{LoadOptions, load_task};
/// # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/chopping-board.toml").as_ref();
/// let options = LoadOptions {
///     settings: vec![("particles.count".to_owned(), "20".to_owned())],
///     seed: Some(3),
///     ..LoadOptions::default()
/// };
/// let task = load_task(path, &options)?.task;
/// assert_eq!((task.seed, task.particles.len()), (3, 20));
/// # Ok::<(), wisch_io::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct LoadOptions {
    /// Settings that override the file's values, see [`TaskFile::parse`].
    pub settings: Vec<(String, String)>,
    /// Folder of the knowledge base; `None` takes the shipped one.
    pub knowledge: Option<PathBuf>,
    /// Action; `None` takes the file's.
    pub action: Option<Action>,
    /// Strategy; `None` takes the file's.
    pub strategy: Option<Strategy>,
    /// Seed of all random numbers; `None` takes the file's.
    pub seed: Option<u64>,
}

/// A task with its file, planner settings, knowledge and assumptions.
#[derive(Debug, Clone)]
pub struct LoadedTask {
    /// Path of the file.
    pub path: PathBuf,
    /// The text of the file.
    pub text: String,
    /// The task file.
    pub file: TaskFile,
    /// Settings that override the file's values.
    pub settings: Vec<(String, String)>,
    /// Assumptions about tools, media and interactions, and remarks on probable wrong units, one sentence each.
    pub assumptions: Vec<String>,
    /// The task.
    pub task: Task,
    /// Settings of all stages, and the conditions under which a session ends.
    pub run: RunConfig,
    /// The derivation of the action, if the file states a goal.
    pub derived: Option<Derivation>,
    /// The knowledge base.
    pub knowledge: KnowledgeBase,
    /// Ground truth of the simulated world, which neither planner nor interpreter reads.
    pub simulation: SimulationSettings,
    /// The slope of the surface, if it is too steep for the medium, so that the task's particles have already slid down.
    pub steep: Option<SteepSurface>,
    /// The files that the task file names, apart from those of the robot.
    pub files: KeptFiles,
    /// Digest of all read files and of the options.
    pub inputs: InputDigest,
}

impl LoadedTask {
    /// Makes a new session without a robot. It plans for all positions that the dirt may have; compare
    /// [`Self::plan_for_known_dirt`].
    pub fn session(&self) -> Session<'static> {
        Session::new(&self.task, self.run.clone()).with_belief(self.belief())
    }

    /// Plans for the task's particles as if their positions were known exactly. [`Self::session`] plans for all positions of
    /// the belief, which gives a longer path and a lower predicted performance for this one draw.
    ///
    /// # Errors
    /// Those of [`wisch::plan::plan`].
    pub fn plan_for_known_dirt(&self) -> Result<Plan, PlanError> {
        plan(&self.task, &self.run.plan)
    }

    /// Returns the belief about the dirt before any measurement.
    pub fn belief(&self) -> Belief {
        self.dirt_prior()
            .belief(&self.task, member_count(&self.task))
    }

    /// Returns the prior of the dirt locations from the source of the particles.
    pub fn dirt_prior(&self) -> DirtPrior {
        let slides_unknown = self.steep.is_some() && self.task.dirt_slide().is_none();
        if self.task.action.treats() || slides_unknown {
            // Points of the surface are known exactly, and sliding dirt ends below its start, wherever that was.
            return DirtPrior::Known;
        }
        match &self.file.particles {
            ParticleSource::Uniform { count } => DirtPrior::Anywhere { count: *count },
            ParticleSource::Clusters { count, clusters } => DirtPrior::Heaps {
                count: *count,
                heaps: clusters.clone(),
            },
            ParticleSource::Csv { .. } | ParticleSource::Surface { .. } => DirtPrior::Known,
            ParticleSource::Image(_) => {
                let sensor = self.file.camera.unwrap_or_default();
                DirtPrior::Seen(self.sight(sensor))
            }
        }
    }

    /// Reads an observation of the dirt after wiping from a file: a list of dirt locations, or, if the task's particles come
    /// from an image, a later image of the same camera.
    ///
    /// # Errors
    /// If the file cannot be read or is invalid, or is an image although the task has none.
    pub fn observation(&self, path: &Path) -> Result<Observation, Error> {
        let shown = path.display().to_string();
        let refused = |problem: String| Error::Unusable {
            path: path.to_owned(),
            problem,
        };
        let bytes = std::fs::read(path).map_err(|error| refused(error.to_string()))?;
        let area = DirtArea {
            outline: &self.task.surface.outline,
            occupied: &self.task.occupied_area(),
        };
        let is_list = path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
        let seen = match &self.file.particles {
            _ if is_list => read_observed_list(&shown, &bytes),
            ParticleSource::Image(mask) => {
                let before = self.files.get(&mask.file).unwrap_or_default();
                read_observed_image(mask, before, &shown, &bytes, area, self.task.seed)
            }
            _ => {
                let problem = "the position of the surface in this image is unknown, because the task's particles do not come from an image";
                return Err(refused(problem.to_owned()));
            }
        };
        seen.map_err(|error| Error::Asset(error.to_string()))
    }

    /// Returns what the camera `sensor` detects of the task's medium, given its grain sizes.
    pub fn sight(&self, sensor: SensorModel) -> Sight {
        sight(sensor, &self.task, &self.knowledge)
    }

    /// Reads the robot of the file, if it has one.
    ///
    /// # Errors
    /// If the name is unknown, or a file cannot be read or is invalid.
    pub fn robot(&self) -> Result<Option<Robot>, Error> {
        let named = self.file.robot.as_ref();
        named
            .map(|robot| Robot::read(&robot.description, &self.path, None, &[]))
            .transpose()
    }
}

/// The derivation of an action from a goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Derivation {
    /// The goal.
    pub goal: String,
    /// The symbolic plan.
    pub steps: Vec<String>,
}

/// Action, tool and medium.
struct Chosen {
    action: Action,
    tool: String,
    medium: String,
    derived: Option<Derivation>,
}

/// Reads a task file, or a shipped scenario by its name, with its knowledge, meshes and particles. Paths are relative to
/// the file's folder.
///
/// # Errors
/// If a file cannot be read or is invalid, no action reaches the goal, or a name is unknown.
///
/// ```
/// use wisch_io::{LoadOptions, load_task};
/// # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/chopping-board.toml").as_ref();
/// let loaded = load_task(path, &LoadOptions { seed: Some(3), ..LoadOptions::default() })?;
/// assert_eq!(loaded.task.surface.name, "chopping_board");
/// let plan = wisch::plan::plan(&loaded.task, &loaded.run.plan).unwrap();
/// assert!(plan.contact_distance() > 0.5); // metres
/// # Ok::<(), wisch_io::Error>(())
/// ```
pub fn load_task(path: &Path, options: &LoadOptions) -> Result<LoadedTask, Error> {
    load_task_with(path, &KeptFiles::default(), options)
}

/// Loads a task as [`load_task`], with kept copies in place of the files that the task file names.
///
/// # Errors
/// Those of [`load_task`].
pub fn load_task_with(
    path: &Path,
    kept: &KeptFiles,
    options: &LoadOptions,
) -> Result<LoadedTask, Error> {
    let mut beside = read_beside(path);
    let mut files = |named: &str| match kept.get(named) {
        Some(contents) => Ok(contents.to_vec()),
        None => beside(named),
    };
    parse_task(path, read_task_text(path)?, &mut files, options)
}

/// Reads the name of a task from its file, but not the files that it names. `settings` override the
/// file's values, see [`TaskFile::parse`].
///
/// # Errors
/// If the file cannot be read or is invalid.
pub fn read_task_name(path: &Path, settings: &[(String, String)]) -> Result<String, Error> {
    let shown = path.display().to_string();
    Ok(TaskFile::parse(&shown, &read_task_text(path)?, settings)?.name)
}

/// Returns whether a task file asks for all patches of a divided mesh; the files that it names are
/// not read. `settings` override the file's values. A named pipe is not read either, because its
/// text can be read only once: its task is refused when it is loaded, if it asks for all patches.
///
/// # Errors
/// If the file cannot be read or is invalid.
pub fn wipes_all_patches(path: &Path, settings: &[(String, String)]) -> Result<bool, Error> {
    if std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Ok(false);
    }
    let shown = path.display().to_string();
    Ok(TaskFile::parse(&shown, &read_task_text(path)?, settings)?.wipes_all_patches())
}

/// Loads a task from the text of a task file.
///
/// - `path`: nominal path of the file, for error messages; the robot's files are relative to it.
/// - `files`: reads all other files, by the paths in the text.
///
/// # Errors
/// Those of [`load_task`].
///
/// ```
/// use wisch_io::{LoadOptions, TaskFile, parse_task};
/// let mut no_files = |path: &str| Err(format!("{path}: there are no files here"));
/// let text = TaskFile::TEMPLATE.to_owned();
/// let loaded = parse_task("made.toml".as_ref(), text, &mut no_files, &LoadOptions::default())?;
/// assert_eq!(loaded.task.particles.len(), 80);
/// # Ok::<(), wisch_io::Error>(())
/// ```
pub fn parse_task(
    path: &Path,
    text: String,
    files: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    options: &LoadOptions,
) -> Result<LoadedTask, Error> {
    let shown = path.display().to_string();
    let file = TaskFile::parse(&shown, &text, &options.settings)?;
    let source = KnowledgeSource::new(options.knowledge.as_deref());
    let mut knowledge = source.base()?;
    let mut assumptions = file.remarks.clone();
    assumptions.extend(file.extend(&mut knowledge)?);
    let chosen = choose(&file, &shown, options.action, &knowledge, &source)?;
    let seed = options.seed.unwrap_or(file.run.plan.seed);
    let mut inputs = InputDigest::default();
    inputs.add("program", env!("CARGO_PKG_VERSION"));
    inputs.add("task", &text);
    for (key, value) in &options.settings {
        inputs.add(key, value);
    }
    source.add_to(&mut inputs)?;
    let inputs = RefCell::new(inputs);
    let up_axes = RefCell::new(Vec::new());
    let mut kept = KeptFiles::default();
    let mut files = |path: &str| {
        let contents = files(path)?;
        kept.add(path, &contents);
        Ok(contents)
    };
    let taken_in = |path: &str, bytes: Result<Vec<u8>, String>| {
        let bytes = bytes?;
        inputs.borrow_mut().add(path, &bytes);
        up_axes.borrow_mut().extend(up_axis_remark(path, &bytes));
        Ok(bytes)
    };
    let mut task = file.resolve(
        chosen.action,
        &chosen.tool,
        &chosen.medium,
        seed,
        &knowledge,
        &mut |path| taken_in(path, files(path)),
        &mut |path| taken_in(path, source.asset(path)),
    )?;
    let steep = let_slide(&mut task, &knowledge);
    assumptions.extend(match steep {
        Some(steep) => Some(steep.to_string()),
        None => gravity_remark(&task, &knowledge),
    });
    assumptions.extend(task_remarks(&task));
    let simulation = file.simulation(&task, &knowledge, &mut |path| taken_in(path, files(path)))?;
    let mut up_axes = up_axes.into_inner();
    up_axes.sort();
    up_axes.dedup();
    assumptions.extend(up_axes);
    let mut inputs = inputs.into_inner();
    inputs.add("action", chosen.action.as_str());
    inputs.add("seed", seed.to_le_bytes());
    let strategy = match (options.strategy, &file.strategy) {
        (Some(strategy), _) => strategy,
        (None, Some(name)) => strategy_named(name, &shown)?,
        (None, None) if task.action.treats() => Strategy::Lanes,
        (None, None) => DEFAULT_STRATEGY,
    };
    inputs.add("strategy", strategy.as_str());
    let robot = file.robot.as_ref();
    let run = RunConfig {
        plan: PlanConfig {
            strategy,
            seed,
            ..file.run.plan.clone()
        },
        workcell: robot.map_or_else(Default::default, |robot| robot.workcell_config(&task)),
        sight: file.camera.map(|sensor| sight(sensor, &task, &knowledge)),
        ..file.run.clone()
    };
    Ok(LoadedTask {
        path: path.to_owned(),
        text,
        settings: options.settings.clone(),
        assumptions,
        file,
        task,
        run,
        files: kept,
        inputs,
        simulation,
        steep,
        derived: chosen.derived,
        knowledge,
    })
}

fn sight(sensor: SensorModel, task: &Task, knowledge: &KnowledgeBase) -> Sight {
    let medium = knowledge.medium(&task.medium);
    let sizes = medium.ok().and_then(|medium| medium.grain_size);
    Sight {
        sensor,
        detection: sensor.mean_detection(sizes),
    }
}

fn strategy_named(name: &str, shown: &str) -> Result<Strategy, Error> {
    name.parse().map_err(|_| {
        let known = Strategy::ALL.map(Strategy::as_str);
        Error::Strategy {
            file: shown.to_owned(),
            unknown: UnknownName::new("strategy", name, known),
        }
    })
}

fn choose(
    file: &TaskFile,
    shown: &str,
    action: Option<Action>,
    knowledge: &KnowledgeBase,
    source: &KnowledgeSource,
) -> Result<Chosen, Error> {
    match &file.intent {
        Intent::Action {
            action: stated,
            tool,
            medium,
        } => Ok(Chosen {
            action: action.unwrap_or(*stated),
            tool: tool.clone(),
            medium: medium.clone(),
            derived: None,
        }),
        Intent::Goal {
            literal,
            tool_in_hand,
            available_tools,
        } => {
            let in_file = |error| Error::Goal {
                file: shown.to_owned(),
                literal: literal.clone(),
                error: Box::new(error),
            };
            let goal = GoalLiteral::parse(literal).map_err(in_file)?;
            let tools: Vec<&str> = available_tools.iter().map(String::as_str).collect();
            let resolved = resolve_goal(
                &goal,
                &source.domain()?,
                knowledge,
                tool_in_hand.as_deref(),
                &tools,
            )
            .map_err(in_file)?;
            if let Some(asked) = action.filter(|action| *action != resolved.action) {
                return Err(Error::Contradiction {
                    file: shown.to_owned(),
                    asked,
                    literal: literal.clone(),
                    needed: resolved.action,
                });
            }
            Ok(Chosen {
                action: resolved.action,
                tool: resolved.tool,
                medium: resolved.medium,
                derived: Some(Derivation {
                    goal: goal.to_string(),
                    steps: resolved.steps,
                }),
            })
        }
    }
}
