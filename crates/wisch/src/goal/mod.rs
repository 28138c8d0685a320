//! Resolves a PDDL goal into a wiping action and a tool (§3.2, S_g of equation 3).
//!
//! A goal is one fact, such as `(collected breadcrumbs chopping_board)`. A [`Domain`] in typed STRIPS defines which
//! actions bring facts about. The knowledge base defines which tools can perform them on which surfaces.
//! [`resolve_goal`] searches for the shortest plan.

mod domain;
mod error;
mod form;
#[cfg(test)]
mod planning_tests;
mod search;
mod sequence;
mod syntax;

use std::collections::HashSet;
use std::fmt;

pub use domain::Domain;
pub use error::GoalError;
pub use sequence::{
    CompoundGoal, MediumOnSurface, Sequence, Situation, Step, StepPlace, StepTimes, Wiping,
};

use crate::represent::{Action, KnowledgeBase, RankedTool};
use form::Source;
use search::{Fact, Problem};

/// Name, in errors, of the text of a goal.
const GOAL_TEXT_NAME: &str = "goal";

/// A single fact to be made true, such as `(collected breadcrumbs chopping_board)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GoalLiteral {
    /// The predicate, then its arguments.
    words: Vec<String>,
}

impl GoalLiteral {
    /// Reads a goal. PDDL ignores case, so names are converted to lower case.
    ///
    /// # Errors
    ///
    /// [`GoalError::Text`], with line and column, for anything but a list of names that is a single positive atom.
    ///
    /// ```
    /// use wisch::goal::GoalLiteral;
    /// let goal = GoalLiteral::parse("(collected breadcrumbs chopping_board)")?;
    /// assert_eq!(goal.predicate(), "collected");
    /// assert_eq!(goal.arguments(), ["breadcrumbs", "chopping_board"]);
    /// # Ok::<(), wisch::goal::GoalError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, GoalError> {
        let source = Source {
            name: GOAL_TEXT_NAME,
            text,
        };
        let form = form::read(source)?;
        if let Some((head @ ("and" | "not"), _)) = form.head() {
            return Err(source.not_supported(form.at, &format!("`{head}` in a single goal")));
        }
        let atom = syntax::read_atom(source, &form)?;
        if let Some(variable) = atom.words.iter().find(|word| word.starts_with('?')) {
            return Err(source.expected_at(form.at, "names only", &format!("`{variable}`")));
        }
        Ok(Self { words: atom.words })
    }

    /// Name of the predicate, such as `collected`.
    pub fn predicate(&self) -> &str {
        &self.words[0]
    }

    /// Arguments of the predicate, in order: the names of objects.
    pub fn arguments(&self) -> &[String] {
        &self.words[1..]
    }
}

impl fmt::Display for GoalLiteral {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&search::format_fact(&self.words))
    }
}

/// The wiping action that reaches a goal, with the plan of which it is the last wiping step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResolvedGoal {
    /// Wiping action.
    pub action: Action,
    /// Tool of the action.
    pub tool: String,
    /// Medium of the action.
    pub medium: String,
    /// Surface of the action.
    pub surface: String,
    /// All steps of the plan, such as `(grasp sponge)`, `(collect sponge breadcrumbs chopping_board)`.
    pub steps: Vec<String>,
}

/// Finds the action and the tool that reach a goal.
///
/// Initially the goal's medium lies on its surface, and the hand holds `tool_in_hand` or nothing. The knowledge base
/// provides facts `(can-<action> tool medium surface)` for the domain's actions that are named like an [`Action`]. The
/// plan is a shortest one; among plans of equal length it uses the tool with the highest probability of success at
/// nominal force. `available_tools` need not repeat the tool in hand.
///
/// # Errors
///
/// [`GoalError::Text`] for a predicate that is not in the domain, and [`GoalError::Knowledge`] for a medium, surface or
/// tool that is not in the knowledge base; both give the nearest name. [`GoalError::NoCapableTool`],
/// [`GoalError::CapableToolNotAvailable`], [`GoalError::ToolNotAvailable`] or [`GoalError::NoPlan`] if the goal cannot be
/// reached, and [`GoalError::NoWiping`] if no wiping is needed. [`GoalError::TooLarge`] if the search would take more
/// than about a second.
///
/// ```
/// use wisch::goal::{GoalLiteral, resolve_goal};
/// use wisch::represent::Action;
/// use wisch_io::KnowledgeSource;
/// let domain = KnowledgeSource::BuiltIn.domain().unwrap();
/// let knowledge = KnowledgeSource::BuiltIn.base().unwrap();
///
/// let goal = GoalLiteral::parse("(collected breadcrumbs chopping_board)")?;
/// let resolved = resolve_goal(&goal, &domain, &knowledge, None, &["brush", "sponge"])?;
/// assert_eq!(resolved.action, Action::Collect);
/// assert_eq!(resolved.steps, ["(grasp sponge)", "(collect sponge breadcrumbs chopping_board)"]);
/// # Ok::<(), wisch::goal::GoalError>(())
/// ```
pub fn resolve_goal(
    literal: &GoalLiteral,
    domain: &Domain,
    knowledge: &KnowledgeBase,
    tool_in_hand: Option<&str>,
    available_tools: &[&str],
) -> Result<ResolvedGoal, GoalError> {
    let literal = &with_declared_predicate(literal, domain);
    let target = Target::of(literal, domain, knowledge)?;
    let mut at_hand: Vec<&str> = Vec::new();
    for &tool in tool_in_hand.iter().chain(available_tools) {
        knowledge.tool(tool)?;
        if !at_hand.contains(&tool) {
            at_hand.push(tool);
        }
    }
    if let Some(tool) = target.tools.iter().find(|tool| !at_hand.contains(tool)) {
        return Err(GoalError::ToolNotAvailable {
            goal: literal.to_string(),
            tool: (*tool).to_owned(),
            available: owned(&at_hand),
        });
    }
    let tools = target.ranked_tools(&at_hand)?;
    let problem = target.build_problem(literal, tool_in_hand, &tools)?;
    let Some(plan) = problem.shortest_plan()? else {
        return Err(GoalError::NoPlan {
            goal: literal.to_string(),
            unmet: problem.unmet_preconditions()?,
        });
    };
    let wiping = plan.iter().rev().find_map(|step| wiping_step(step, domain));
    let (action, [tool, medium, surface]) = wiping.ok_or_else(|| GoalError::NoWiping {
        goal: literal.to_string(),
        wiping_goals: wiping_goals(domain),
    })?;
    Ok(ResolvedGoal {
        action,
        tool,
        medium,
        surface,
        steps: plan.iter().map(|step| search::format_fact(step)).collect(),
    })
}

/// Returns the goal with the domain's name of its predicate, if it uses the name that an earlier version had.
fn with_declared_predicate(literal: &GoalLiteral, domain: &Domain) -> GoalLiteral {
    let is_declared = |name: &str| domain.predicates.iter().any(|p| p.name == name);
    let mut literal = literal.clone();
    if let Some(predicate) = literal.words.first_mut()
        && predicate == "emitted"
        && !is_declared(predicate)
        && is_declared("dispensed")
    {
        "dispensed".clone_into(predicate);
    }
    literal
}

fn owned(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

/// Medium, surface and tool of a goal literal.
struct Target<'a> {
    domain: &'a Domain,
    knowledge: &'a KnowledgeBase,
    media: Vec<&'a str>,
    surfaces: Vec<&'a str>,
    tools: Vec<&'a str>,
    /// Wiping actions that bring the goal's predicate about.
    actions: Vec<Action>,
}

impl<'a> Target<'a> {
    /// Looks up the literal's arguments by the types of its predicate's parameters.
    fn of(
        literal: &'a GoalLiteral,
        domain: &'a Domain,
        knowledge: &'a KnowledgeBase,
    ) -> Result<Self, GoalError> {
        let mut target = Self {
            domain,
            knowledge,
            media: Vec::new(),
            surfaces: Vec::new(),
            tools: Vec::new(),
            actions: Vec::new(),
        };
        let words: Fact<'a> = literal.words.iter().map(String::as_str).collect();
        let text = literal.to_string();
        let source = Source {
            name: GOAL_TEXT_NAME,
            text: &text,
        };
        let parameters = domain.parameters(source, 0, &words)?;
        for (&argument, parameter) in words[1..].iter().zip(parameters) {
            let known_as = match parameter.type_name.as_str() {
                "medium" => knowledge.medium(argument).map(|_| &mut target.media),
                "surface" => knowledge.surface(argument).map(|_| &mut target.surfaces),
                "tool" => knowledge.tool(argument).map(|_| &mut target.tools),
                // The domain checks the remaining arguments, which may be its constants.
                _ => continue,
            }?;
            if !known_as.contains(&argument) {
                known_as.push(argument);
            }
        }
        let reaches = |effect: &syntax::Literal| effect.atom.words[0] == words[0];
        let schemas = domain
            .schemas
            .iter()
            .filter(|schema| schema.added().any(reaches));
        target.actions = schemas
            .filter_map(|schema| schema.name.parse().ok())
            .collect();
        Ok(target)
    }

    /// Returns the available tools, sorted by their probability of success.
    ///
    /// # Errors
    ///
    /// If the goal is to wipe a medium on a surface, and no tool can do that.
    fn ranked_tools(&self, at_hand: &[&'a str]) -> Result<Vec<&'a str>, GoalError> {
        let mut tools: Vec<&str> = Vec::new();
        if let (&[medium], &[surface], &[action, ..]) =
            (&self.media[..], &self.surfaces[..], &self.actions[..])
        {
            let mut capable: Vec<RankedTool<'_>> = Vec::new();
            for &action in &self.actions {
                capable.extend(self.knowledge.tools_for(medium, surface, action)?);
            }
            // A stable sort keeps tools of equal probability in the order of their names.
            capable.sort_by(|a, b| b.probability.total_cmp(&a.probability));
            let capable: Vec<&str> = capable.iter().map(|tool| tool.tool.name.as_str()).collect();
            let (medium, surface) = (medium.to_owned(), surface.to_owned());
            if capable.is_empty() {
                return Err(GoalError::NoCapableTool {
                    known: known_actions(self.knowledge, &medium, &surface)?,
                    action,
                    medium,
                    surface,
                });
            }
            tools.extend(capable.iter().filter(|tool| at_hand.contains(tool)));
            if tools.is_empty() {
                return Err(GoalError::CapableToolNotAvailable {
                    action,
                    medium,
                    surface,
                    available: owned(at_hand),
                    capable: owned(&capable),
                });
            }
        }
        tools.extend(at_hand);
        let mut seen = HashSet::new();
        tools.retain(|tool| seen.insert(*tool));
        Ok(tools)
    }

    /// Returns the planning problem: the goal with all known facts.
    fn build_problem(
        &self,
        literal: &'a GoalLiteral,
        tool_in_hand: Option<&'a str>,
        tools: &[&'a str],
    ) -> Result<Problem<'a>, GoalError> {
        let constants = self.domain.constants.iter().map(syntax::Typed::as_pair);
        let mut objects: Vec<(&str, &str)> = constants.collect();
        for (names, type_name) in [
            (tools, "tool"),
            (&self.media, "medium"),
            (&self.surfaces, "surface"),
        ] {
            // A constant of the domain is an object already.
            let is_new = |name: &&&str| self.domain.constants.iter().all(|c| c.name != **name);
            objects.extend(names.iter().filter(is_new).map(|&name| (name, type_name)));
        }
        let mut facts: Vec<(String, Fact<'a>)> = match tool_in_hand {
            Some(tool) => vec![("holding".to_owned(), vec![tool])],
            None => vec![("hand-empty".to_owned(), vec![])],
        };
        for &medium in &self.media {
            for &surface in &self.surfaces {
                facts.push(("on".to_owned(), vec![medium, surface]));
                for action in Action::ALL {
                    let known = self.knowledge.tools_for(medium, surface, action)?;
                    let capable = known.iter().map(|capable| capable.tool.name.as_str());
                    for tool in capable.filter(|tool| tools.contains(tool)) {
                        for name in [Some(action.as_str()), action.earlier_name()]
                            .iter()
                            .flatten()
                        {
                            facts.push((format!("can-{name}"), vec![tool, medium, surface]));
                        }
                    }
                }
            }
        }
        // The domain ignores facts without a predicate.
        let declared = facts.into_iter().filter_map(|(name, arguments)| {
            let predicate = self.domain.predicates.iter().find(|p| p.name == name)?;
            Some(
                std::iter::once(predicate.name.as_str())
                    .chain(arguments)
                    .collect(),
            )
        });
        let problem = Problem {
            domain: self.domain,
            objects,
            init: declared.collect(),
            goal: vec![(true, literal.words.iter().map(String::as_str).collect())],
        };
        problem.check()?;
        Ok(problem)
    }
}

/// Returns the known actions for a medium on a surface, such as "skim with window_wiper".
fn known_actions(
    knowledge: &KnowledgeBase,
    medium: &str,
    surface: &str,
) -> Result<Vec<String>, GoalError> {
    let mut known = Vec::new();
    for action in Action::ALL {
        let tools = knowledge.tools_for(medium, surface, action)?;
        known.extend(
            tools
                .iter()
                .map(|tool| format!("{action} with {}", tool.tool.name)),
        );
    }
    Ok(known)
}

/// Returns the predicates of surfaces that the domain's wiping actions bring about.
fn wiping_goals(domain: &Domain) -> Vec<String> {
    let is_of_surface = |predicate: &str| {
        let declared = domain.predicates.iter().find(|p| p.name == predicate);
        declared.is_some_and(|p| p.parameters.iter().any(|p| p.type_name == "surface"))
    };
    let mut goals: Vec<String> = (domain.schemas.iter())
        .filter(|schema| schema.name.parse::<Action>().is_ok())
        .flat_map(|schema| schema.added())
        // What happens only under a condition is a side effect.
        .filter(|effect| effect.conditions.is_empty())
        .filter(|add| is_of_surface(&add.atom.words[0]))
        .map(|add| add.atom.words[0].clone())
        .collect();
    goals.sort();
    goals.dedup();
    goals
}

/// Returns action, tool, medium and surface of a step, if it wipes.
fn wiping_step(step: &Fact<'_>, domain: &Domain) -> Option<(Action, [String; 3])> {
    let action = step[0].parse().ok()?;
    let schema = domain
        .schemas
        .iter()
        .find(|schema| schema.name == step[0])?;
    let argument_of = |type_name: &str| {
        let mut parameters = schema.parameters.iter();
        let parameter = parameters.position(|parameter| parameter.type_name == type_name)?;
        step.get(1 + parameter).map(|&name| name.to_owned())
    };
    let [tool, medium, surface] = ["tool", "medium", "surface"].map(argument_of);
    Some((action, [tool?, medium?, surface?]))
}
