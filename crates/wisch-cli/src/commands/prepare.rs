//! From a path on the command line to a task that can be planned.

use crate::args::TaskArgs;
use crate::assets::{KnowledgeSource, beside, read_text};
use crate::failure::Failure;
use wisch::plan::{CoverageStrategy, GoalLiteral, PlanConfig, resolve_goal};
use wisch::represent::{Action, Intent, KnowledgeBase, Reality, Task, TaskFile, UnknownName};

/// What a task gets that asks for none: the paper's plainest, which never leaves a free cell out.
const DEFAULT_STRATEGY: CoverageStrategy = CoverageStrategy::Grid;

/// A task with what the command line says about it.
pub struct Prepared {
    /// The task file.
    pub file: TaskFile,
    /// The task.
    pub task: Task,
    /// How to plan it.
    pub config: PlanConfig,
    /// What a simulated execution takes for real.
    pub reality: Reality,
    /// The goal and the steps that reach it, where the file states a goal and not an action.
    pub derived: Option<Derived>,
}

/// How an action was derived from a goal.
pub struct Derived {
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
    derived: Option<Derived>,
}

impl Prepared {
    /// Reads the task file and everything that it refers to.
    pub fn read(args: &TaskArgs) -> Result<Self, Failure> {
        let shown = args.task.display().to_string();
        let text = read_text(&args.task)?;
        let file = TaskFile::parse(&shown, &text, &args.settings).map_err(Failure::new)?;
        let source = KnowledgeSource::new(args.knowledge.as_deref());
        let knowledge = source.base()?;
        let chosen = choose(&file, &shown, args.action, &knowledge, &source)?;
        let seed = args.seed.unwrap_or(file.seed());
        let task = file
            .resolve(
                chosen.action,
                &chosen.tool,
                &chosen.medium,
                seed,
                &knowledge,
                &mut beside(&args.task),
                &mut |path| source.asset(path),
            )
            .map_err(Failure::new)?;
        let config = PlanConfig {
            strategy: match (args.strategy, file.strategy()) {
                (Some(strategy), _) => strategy,
                (None, Some(name)) => strategy_named(name, &shown)?,
                (None, None) => DEFAULT_STRATEGY,
            },
            seed,
            bandwidth: file.bandwidth_m(),
            lift_height: file.lift_height_m(),
        };
        let reality = (file.reality(&task, &knowledge))
            .map_err(|error| Failure::new(format!("{shown}: {error}")))?;
        Ok(Self {
            reality,
            file,
            task,
            config,
            derived: chosen.derived,
        })
    }

    /// Most rounds.
    pub fn max_rounds(&self) -> usize {
        self.reality.max_rounds
    }

    /// How the nodes are placed.
    pub fn strategy(&self) -> CoverageStrategy {
        self.config.strategy
    }

    /// A failure of a later stage, with the name of the task file.
    pub fn failure(&self, args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", args.task.display()))
    }
}

fn strategy_named(name: &str, shown: &str) -> Result<CoverageStrategy, Failure> {
    name.parse().map_err(|_| {
        let known = CoverageStrategy::ALL.map(CoverageStrategy::as_str);
        Failure::new(format!(
            "{shown}: {}",
            UnknownName::new("strategy", name, known)
        ))
    })
}

fn choose(
    file: &TaskFile,
    shown: &str,
    action: Option<Action>,
    knowledge: &KnowledgeBase,
    source: &KnowledgeSource,
) -> Result<Chosen, Failure> {
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
            let in_file = |error: &dyn std::fmt::Display| {
                Failure::new(format!("{shown}: goal {literal:?}: {error}"))
            };
            let goal = GoalLiteral::parse(literal).map_err(|error| in_file(&error))?;
            let tools: Vec<&str> = available_tools.iter().map(String::as_str).collect();
            let resolved = resolve_goal(
                &goal,
                &source.domain()?,
                knowledge,
                tool_in_hand.as_deref(),
                &tools,
            )
            .map_err(|error| in_file(&error))?;
            if let Some(action) = action.filter(|action| *action != resolved.action) {
                return Err(Failure::new(format!(
                    "{shown}: --action {action} contradicts the goal {literal}, which takes {}",
                    resolved.action
                ))
                .with_help(
                    "leave --action out, or state an action in the file in place of the goal",
                ));
            }
            Ok(Chosen {
                action: resolved.action,
                tool: resolved.tool,
                medium: resolved.medium,
                derived: Some(Derived {
                    goal: goal.to_string(),
                    steps: resolved.steps,
                }),
            })
        }
    }
}
