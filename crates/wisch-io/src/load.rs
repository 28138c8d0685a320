//! From a task file to a task that can be planned.

use crate::assets::{KnowledgeSource, beside, read_task_text};
use crate::digest::InputDigest;
use crate::error::Error;
use crate::particles::{ParticleSource, observed_in_image, observed_in_list};
use crate::robots::Robot;
use crate::task_file::{Intent, TaskFile, unit_remarks};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use wisch::follow::FollowConfig;
use wisch::geometry::Mesh;
use wisch::geometry::Point2;
use wisch::goal::{GoalLiteral, resolve_goal};
use wisch::interpret::{Belief, DirtPrior, members};
use wisch::plan::{
    CoverageStrategy, HeadingRule, Plan, PlanConfig, PlanError, SearchConfig, Strategy, plan,
};
use wisch::represent::{
    Action, DirtArea, KnowledgeBase, Observation, OccupiedArea, SensorModel, Sight, SteepSurface,
    Task, dirt_friction, slide_down,
};
use wisch::run::{RunConfig, Session};
use wisch::source_location::UnknownName;

/// What a task gets that asks for none: the paper's plainest, which never leaves a free cell out.
const DEFAULT_STRATEGY: Strategy = Strategy::Coverage(CoverageStrategy::Grid);

/// What is to be different from what a task file says.
#[derive(Debug, Clone, Default)]
pub struct LoadOptions {
    /// Values laid over the file's, see [`TaskFile::parse`].
    pub settings: Vec<(String, String)>,
    /// The folder with tools, media, surfaces, interactions and the domain; `None` takes those shipped.
    pub knowledge: Option<PathBuf>,
    /// What to do; `None` leaves it to the file.
    pub action: Option<Action>,
    /// How to place the nodes; `None` leaves it to the file.
    pub strategy: Option<Strategy>,
    /// Seed of everything random; `None` leaves it to the file.
    pub seed: Option<u64>,
}

/// A task with all that its file says about it.
#[derive(Debug, Clone)]
pub struct LoadedTask {
    /// Where the file is.
    pub path: PathBuf,
    /// The text of the file.
    pub text: String,
    /// The task file.
    pub file: TaskFile,
    /// Values laid over the file's.
    pub settings: Vec<(String, String)>,
    /// What had to be assumed of a tool, medium or interaction that the file defines, and what is most likely in other units: a
    /// sentence each.
    pub assumptions: Vec<String>,
    /// The task.
    pub task: Task,
    /// How to plan it.
    pub config: PlanConfig,
    /// The goal and the steps that reach it, where the file states a goal and not an action.
    pub derived: Option<Derivation>,
    /// What is known of tools, media and surfaces.
    pub knowledge: KnowledgeBase,
    /// Where the dirt of a simulated world really lies, in the frame of the real surface [m], where `[execution]` names a
    /// file that lists it.
    pub real_places: Option<Vec<Point2>>,
    /// Where the surface is too steep for the medium, so that the task's particles have slid down already.
    pub steep: Option<SteepSurface>,
    /// Of all that was read for it, and of the options.
    pub inputs: InputDigest,
}

impl LoadedTask {
    /// How the stages work for this task, and when to stop.
    pub fn run_config(&self) -> RunConfig {
        let robot = self.file.robot();
        RunConfig {
            plan: self.config.clone(),
            variants: self.file.plan_variants(),
            workcell: robot
                .map_or_else(Default::default, |robot| robot.workcell_config(&self.task)),
            target: self.file.target_performance(),
            min_score: self.file.min_score(),
            max_rounds: self.file.max_rounds(),
            end_strokes_early: self.file.end_strokes_early(),
            pace: self.file.pace(),
            after_stop: self.file.after_stop(),
            start_tolerance: self.file.start_rad(),
            sight: self
                .file
                .perception()
                .sight
                .map(|sensor| self.sight(sensor)),
            follow: self.follow_config(),
        }
    }

    /// How a robot is to follow the plans of the task.
    pub fn follow_config(&self) -> FollowConfig {
        FollowConfig {
            contact_speed: self.file.contact_speed_m_per_s(),
            // A rule that the user chose is kept to.
            free_yaw: self.file.heading() == HeadingRule::Best,
            ..FollowConfig::default()
        }
    }

    /// A session that has not planned yet, and has no robot. It plans for all places where the dirt may lie, see
    /// [`Self::plan_for_known_dirt`].
    pub fn session(&self) -> Session<'static> {
        Session::new(&self.task, self.run_config()).with_belief(self.belief())
    }

    /// A plan for the task's particles as if they were known to lie just there; [`Self::session`] plans for all places where the
    /// belief holds that they may lie, which takes a longer way and is predicted to do less for this one draw.
    ///
    /// # Errors
    /// Those of [`wisch::plan::plan`].
    pub fn plan_for_known_dirt(&self) -> Result<Plan, PlanError> {
        plan(&self.task, &self.config)
    }

    /// What is believed of the dirt before anything is felt or seen.
    pub fn belief(&self) -> Belief {
        self.dirt_prior().belief(&self.task, members(&self.task))
    }

    /// What the source of the particles says of where dirt may lie.
    pub fn dirt_prior(&self) -> DirtPrior {
        if self.task.action.treats() || self.steep.is_some() {
            // Places of the surface are where they are, and what slides ends below wherever it lay.
            return DirtPrior::Known;
        }
        match self.file.particle_source() {
            ParticleSource::Uniform { count } => DirtPrior::Anywhere { count: *count },
            ParticleSource::Clusters { count, clusters } => DirtPrior::Heaps {
                count: *count,
                heaps: clusters.clone(),
            },
            ParticleSource::Csv { .. } | ParticleSource::Surface { .. } => DirtPrior::Known,
            ParticleSource::Image(_) => {
                let sensor = self.file.perception().sight.unwrap_or_default();
                DirtPrior::Seen(self.sight(sensor))
            }
        }
    }

    /// What a file says was seen of the dirt after wiping: a list of places, or, where the task's own particles come from an
    /// image, a later image of the same camera.
    ///
    /// # Errors
    /// A file that cannot be read or is refused, or an image where the task has none.
    pub fn observation(&self, path: &Path) -> Result<Observation, Error> {
        let shown = path.display().to_string();
        let refused = |problem: String| Error::Unusable {
            path: path.to_owned(),
            problem,
        };
        let bytes = std::fs::read(path).map_err(|error| refused(error.to_string()))?;
        let meshes: Vec<Mesh> = self.task.obstacles_in_surface().collect();
        let area = DirtArea {
            outline: &self.task.surface.outline,
            occupied: &OccupiedArea::of(&meshes),
        };
        let is_list = path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
        let seen = match self.file.particle_source() {
            _ if is_list => observed_in_list(&shown, &bytes, area),
            ParticleSource::Image(mask) => {
                let before = beside(&self.path)(&mask.file).map_err(refused)?;
                observed_in_image(mask, &before, &shown, &bytes, area, self.task.seed)
            }
            _ => {
                let problem = "the task's particles come from no image, so that it is not known where the surface is in this one";
                return Err(refused(problem.to_owned()));
            }
        };
        seen.map_err(|error| Error::Asset(error.to_string()))
    }

    /// How well this sensor sees the task's medium.
    pub fn sight(&self, sensor: SensorModel) -> Sight {
        let medium = self.knowledge.medium(&self.task.medium);
        let sizes = medium.ok().and_then(|medium| medium.grain_size);
        Sight {
            sensor,
            detection: sensor.mean_detection(sizes),
        }
    }

    /// Reads the robot that the file names, if it names one.
    ///
    /// # Errors
    /// An unknown name, a file that cannot be read, or one that is not what it should be.
    pub fn robot(&self) -> Result<Option<Robot>, Error> {
        let named = self.file.robot();
        named
            .map(|robot| Robot::read(&robot.description, &self.path, None, &[]))
            .transpose()
    }
}

/// How an action was derived from a goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Derivation {
    /// The goal.
    pub goal: String,
    /// The symbolic plan.
    pub steps: Vec<String>,
}

/// What is to be done with what.
struct Chosen {
    action: Action,
    tool: String,
    medium: String,
    derived: Option<Derivation>,
}

/// Reads a task file, or a shipped scenario by its name, and everything that it refers to: knowledge, meshes and
/// particles, as paths from the file's folder.
///
/// # Errors
/// A file that cannot be read or is refused, a goal that no action reaches, or an unknown name.
///
/// ```
/// use wisch_io::{LoadOptions, load_task};
/// # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/chopping-board.toml").as_ref();
/// let loaded = load_task(path, &LoadOptions { seed: Some(3), ..LoadOptions::default() })?;
/// assert_eq!(loaded.task.surface.name, "chopping_board");
/// let plan = wisch::plan::plan(&loaded.task, &loaded.config).unwrap();
/// assert!(plan.contact_distance() > 0.5); // metres
/// # Ok::<(), wisch_io::Error>(())
/// ```
pub fn load_task(path: &Path, options: &LoadOptions) -> Result<LoadedTask, Error> {
    task_of_text(path, read_task_text(path)?, &mut beside(path), options)
}

/// The same from the text of a task file that lies nowhere. `path` is where it would: errors call it by this name, and the
/// robot's files are looked for beside it; `files` reads what else it refers to, by the path that it gives.
///
/// # Errors
/// Those of [`load_task`].
///
/// ```
/// use wisch_io::{LoadOptions, TaskFile, task_of_text};
/// let mut no_files = |path: &str| Err(format!("{path}: there are no files here"));
/// let text = TaskFile::TEMPLATE.to_owned();
/// let loaded = task_of_text("made.toml".as_ref(), text, &mut no_files, &LoadOptions::default())?;
/// assert_eq!(loaded.task.particles.len(), 80);
/// # Ok::<(), wisch_io::Error>(())
/// ```
pub fn task_of_text(
    path: &Path,
    text: String,
    files: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    options: &LoadOptions,
) -> Result<LoadedTask, Error> {
    let shown = path.display().to_string();
    let file = TaskFile::parse(&shown, &text, &options.settings)?;
    let source = KnowledgeSource::new(options.knowledge.as_deref());
    let mut knowledge = source.base()?;
    let mut assumptions = file.extend(&mut knowledge)?;
    let chosen = choose(&file, &shown, options.action, &knowledge, &source)?;
    let seed = options.seed.unwrap_or(file.seed());
    let mut inputs = InputDigest::default();
    inputs.add("program", env!("CARGO_PKG_VERSION"));
    inputs.add("task", &text);
    for (key, value) in &options.settings {
        inputs.add(key, value);
    }
    source.add_to(&mut inputs)?;
    let inputs = RefCell::new(inputs);
    let taken_in = |path: &str, bytes: Result<Vec<u8>, String>| {
        let bytes = bytes?;
        inputs.borrow_mut().add(path, &bytes);
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
    assumptions.extend(steep.map(|steep| steep.to_string()));
    assumptions.extend(unit_remarks(&task));
    let real_places = file.real_places(&task, &mut |path| taken_in(path, files(path)))?;
    let mut inputs = inputs.into_inner();
    inputs.add("action", chosen.action.as_str());
    inputs.add("seed", seed.to_le_bytes());
    let config = PlanConfig {
        strategy: match (options.strategy, file.strategy()) {
            (Some(strategy), _) => strategy,
            (None, Some(name)) => strategy_named(name, &shown)?,
            (None, None) if task.action.treats() => Strategy::Lanes,
            (None, None) => DEFAULT_STRATEGY,
        },
        seed,
        bandwidth: file.bandwidth_m(),
        heading: file.heading(),
        lift_height: file.lift_height_m(),
        max_distance: file.max_distance_m(),
        search: SearchConfig {
            evaluations: file.evaluations(),
            margin_m: file.margin_m(),
        },
    };
    inputs.add("strategy", config.strategy.as_str());
    Ok(LoadedTask {
        path: path.to_owned(),
        text,
        settings: options.settings.clone(),
        assumptions,
        file,
        task,
        config,
        inputs,
        real_places,
        steep,
        derived: chosen.derived,
        knowledge,
    })
}

/// Lets the dirt slide that cannot rest on the surface's slope.
fn let_slide(task: &mut Task, knowledge: &KnowledgeBase) -> Option<SteepSurface> {
    let kind = knowledge.medium(&task.medium).ok()?.kind;
    if task.action.treats() {
        return None;
    }
    let of_surface = knowledge.surface(&task.surface.name).ok()?.friction;
    let friction = dirt_friction(kind, of_surface);
    let obstacles: Vec<Mesh> = task.obstacles_in_surface().collect();
    let (slid, steep) = slide_down(&task.particles, &task.surface, &obstacles, friction)?;
    task.particles = slid;
    Some(steep)
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
    match file.intent() {
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
