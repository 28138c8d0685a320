//! Goals in PDDL, and which wiping action with which tool reaches them (§3.2, S_g of equation 3).

mod domain;
mod error;
mod form;
#[cfg(test)]
mod planning_tests;
mod problem;
mod search;
mod syntax;

use std::fmt;
use std::fmt::Write as _;

pub use domain::Domain;
pub use error::GoalError;
pub use problem::{Problem, solve};
pub use search::Step;

use crate::represent::{Action, KnowledgeBase, RankedTool};
use domain::Lookup;
use form::Source;
use syntax::Atom;

/// What errors call a goal that was handed in without a name.
const GOAL_TEXT_NAME: &str = "goal";
/// What errors call the problem that is derived from a goal and the knowledge base.
const DERIVED_TEXT_NAME: &str = "problem derived from the goal";

/// A single fact that is to become true, such as `(collected breadcrumbs chopping_board)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GoalLiteral {
    predicate: String,
    arguments: Vec<String>,
}

impl GoalLiteral {
    /// Reads a goal. PDDL tells no case, so names come out in small letters.
    ///
    /// # Errors
    ///
    /// [`GoalError::Syntax`] with line and column if it is not one list of names, and
    /// [`GoalError::NotSupported`] for anything but a single positive atom.
    ///
    /// ```
    /// use wisch::plan::GoalLiteral;
    /// let goal = GoalLiteral::parse("(collected breadcrumbs chopping_board)")?;
    /// assert_eq!(goal.predicate(), "collected");
    /// assert_eq!(goal.arguments(), ["breadcrumbs", "chopping_board"]);
    /// # Ok::<(), wisch::plan::GoalError>(())
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
        let atom = syntax::atom(source, &form)?;
        if let Some(variable) = atom.arguments.iter().find(|a| a.starts_with('?')) {
            return Err(source.expected_at(form.at, "names only", &format!("`{variable}`")));
        }
        Ok(Self {
            predicate: atom.predicate,
            arguments: atom.arguments,
        })
    }

    /// The predicate.
    pub fn predicate(&self) -> &str {
        &self.predicate
    }

    /// The objects that it is said of.
    pub fn arguments(&self) -> &[String] {
        &self.arguments
    }
}

impl fmt::Display for GoalLiteral {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let arguments = self.arguments.iter().map(String::as_str);
        search::write_atom(f, &self.predicate, arguments)
    }
}

/// The wiping action that reaches a goal, with the plan that it is the last wiping step of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResolvedGoal {
    /// The action.
    pub action: Action,
    /// The tool that it takes.
    pub tool: String,
    /// The medium that it moves.
    pub medium: String,
    /// The surface that it is done on.
    pub surface: String,
    /// The whole plan, such as `(grasp sponge)`, `(collect sponge breadcrumbs chopping_board)`.
    pub steps: Vec<String>,
}

/// Finds the action and the tool that reach a goal.
///
/// The goal's medium lies on its surface, the hand holds `tool_in_hand` or nothing, and what each
/// tool can do there is taken from the knowledge base as facts `(can-<action> tool medium surface)`
/// for the domain's actions that are named like an [`Action`]. The plan is a shortest one; among
/// those of the same length it takes the tool with the best prospects at nominal force.
/// `available_tools` need not repeat the tool in hand.
///
/// # Errors
///
/// A predicate that the domain does not have, a medium, surface or tool that the knowledge base does
/// not have: each with the nearest. [`GoalError::NoCapableTool`],
/// [`GoalError::CapableToolMissing`], [`GoalError::ToolNotAtHand`] or [`GoalError::NoPlan`] if the goal can't be reached, and [`GoalError::NoWiping`] if no wiping
/// is needed.
///
/// ```
/// use wisch::plan::{GoalLiteral, resolve_goal};
/// use wisch::represent::Action;
/// use wisch_io::KnowledgeSource;
/// let domain = KnowledgeSource::BuiltIn.domain().unwrap();
/// let knowledge = KnowledgeSource::BuiltIn.base().unwrap();
///
/// let goal = GoalLiteral::parse("(collected breadcrumbs chopping_board)")?;
/// let resolved = resolve_goal(&goal, &domain, &knowledge, None, &["brush", "sponge"])?;
/// assert_eq!(resolved.action, Action::Collect);
/// assert_eq!(resolved.steps, ["(grasp sponge)", "(collect sponge breadcrumbs chopping_board)"]);
/// # Ok::<(), wisch::plan::GoalError>(())
/// ```
pub fn resolve_goal(
    literal: &GoalLiteral,
    domain: &Domain,
    knowledge: &KnowledgeBase,
    tool_in_hand: Option<&str>,
    available_tools: &[&str],
) -> Result<ResolvedGoal, GoalError> {
    let target = Target::of(literal, domain, knowledge)?;
    let mut at_hand: Vec<&str> = Vec::new();
    for &tool in tool_in_hand.iter().chain(available_tools) {
        knowledge.tool(tool)?;
        if !at_hand.contains(&tool) {
            at_hand.push(tool);
        }
    }
    if let Some(tool) = target.tools.iter().find(|tool| !at_hand.contains(tool)) {
        return Err(GoalError::ToolNotAtHand {
            goal: literal.to_string(),
            tool: (*tool).to_owned(),
            available: at_hand.iter().map(|&tool| tool.to_owned()).collect(),
        });
    }
    let tools = target.ranked_tools(knowledge, &at_hand)?;
    let text = target.problem_text(literal, domain, knowledge, tool_in_hand, &tools)?;
    let problem = Problem::parse(DERIVED_TEXT_NAME, &text)?;
    let grounded = search::Grounded::new(domain, &problem)?;
    let plan = grounded.shortest_plan()?.ok_or_else(|| GoalError::NoPlan {
        goal: literal.to_string(),
        unmet: grounded.unmet_preconditions(),
    })?;
    let no_wiping = || GoalError::NoWiping {
        goal: literal.to_string(),
        wiping_goals: wiping_goals(domain),
    };
    let (action, [tool, medium, surface]) = (plan.iter().rev())
        .find_map(|step| wiping_step(step, domain))
        .ok_or_else(no_wiping)?;
    Ok(ResolvedGoal {
        action,
        tool,
        medium,
        surface,
        steps: plan.iter().map(Step::to_string).collect(),
    })
}

/// What a goal literal speaks of.
struct Target<'a> {
    media: Vec<&'a str>,
    surfaces: Vec<&'a str>,
    tools: Vec<&'a str>,
    /// The wiping actions that bring the goal's predicate about.
    actions: Vec<Action>,
}

impl<'a> Target<'a> {
    /// Looks the literal's arguments up by the types that its predicate takes.
    fn of(
        literal: &'a GoalLiteral,
        domain: &Domain,
        knowledge: &KnowledgeBase,
    ) -> Result<Self, GoalError> {
        let text = literal.to_string();
        let source = Source {
            name: GOAL_TEXT_NAME,
            text: &text,
        };
        let atom = Atom {
            at: 0,
            predicate: literal.predicate.clone(),
            arguments: literal.arguments.clone(),
        };
        let lookup = Lookup::new(domain);
        let predicate = domain.predicate_of(source, &atom, &lookup)?;
        let mut target = Self {
            media: Vec::new(),
            surfaces: Vec::new(),
            tools: Vec::new(),
            actions: Vec::new(),
        };
        let types = &domain.predicates[predicate].parameters;
        for (argument, &type_id) in literal.arguments.iter().zip(types) {
            let known_as = match domain.type_name(type_id) {
                "medium" => knowledge.medium(argument).map(|_| &mut target.media),
                "surface" => knowledge.surface(argument).map(|_| &mut target.surfaces),
                "tool" => knowledge.tool(argument).map(|_| &mut target.tools),
                // Left to the domain, whose constants it may name.
                _ => continue,
            }?;
            if !known_as.contains(&argument.as_str()) {
                known_as.push(argument);
            }
        }
        target.actions = (domain.schemas.iter())
            .filter(|schema| schema.add.iter().any(|add| add.predicate == predicate))
            .filter_map(|schema| schema.name.parse().ok())
            .collect();
        Ok(target)
    }

    /// The tools at hand, the likeliest to reach it first.
    ///
    /// # Errors
    ///
    /// If wiping one medium on one surface is the goal, and no tool can do that.
    fn ranked_tools(
        &self,
        knowledge: &'a KnowledgeBase,
        at_hand: &[&'a str],
    ) -> Result<Vec<&'a str>, GoalError> {
        let mut tools: Vec<&str> = Vec::new();
        if let (&[medium], &[surface], [action, ..]) =
            (&self.media[..], &self.surfaces[..], &self.actions[..])
        {
            let mut capable: Vec<RankedTool<'_>> = Vec::new();
            for &action in &self.actions {
                capable.extend(knowledge.tools_for(medium, surface, action)?);
            }
            // A stable sort: tools that are alike stay in the order of their names.
            capable.sort_by(|a, b| b.probability.total_cmp(&a.probability));
            let capable: Vec<&str> = capable.iter().map(|tool| tool.tool.name.as_str()).collect();
            if capable.is_empty() {
                return Err(GoalError::NoCapableTool {
                    action: *action,
                    medium: medium.to_owned(),
                    surface: surface.to_owned(),
                    known: known_actions(knowledge, medium, surface)?,
                });
            }
            tools.extend(capable.iter().filter(|tool| at_hand.contains(tool)));
            if tools.is_empty() {
                return Err(GoalError::CapableToolMissing {
                    action: *action,
                    medium: medium.to_owned(),
                    surface: surface.to_owned(),
                    available: at_hand.iter().map(|&tool| tool.to_owned()).collect(),
                    capable: capable.iter().map(|&tool| tool.to_owned()).collect(),
                });
            }
        }
        tools.extend(at_hand);
        let mut seen = std::collections::HashSet::new();
        tools.retain(|tool| seen.insert(*tool));
        Ok(tools)
    }

    /// Writes the goal with all that is known as a PDDL problem.
    fn problem_text(
        &self,
        literal: &GoalLiteral,
        domain: &Domain,
        knowledge: &KnowledgeBase,
        tool_in_hand: Option<&str>,
        tools: &[&str],
    ) -> Result<String, GoalError> {
        let declared = |name: &str| domain.predicates.iter().any(|p| p.name == name);
        let mut objects = String::new();
        for (names, type_name) in [
            (tools, "tool"),
            (&self.media, "medium"),
            (&self.surfaces, "surface"),
        ] {
            // What the domain knows as a constant is an object already.
            for name in
                (names.iter()).filter(|name| !domain.constants.iter().any(|c| c.name == **name))
            {
                writeln!(objects, "    {name} - {type_name}").expect(STRING);
            }
        }
        let mut facts = String::new();
        match tool_in_hand {
            Some(tool) if declared("holding") => {
                writeln!(facts, "    (holding {tool})").expect(STRING);
            }
            None if declared("hand-empty") => facts += "    (hand-empty)\n",
            _ => {}
        }
        for medium in &self.media {
            for surface in &self.surfaces {
                if declared("on") {
                    writeln!(facts, "    (on {medium} {surface})").expect(STRING);
                }
                for action in Action::ALL {
                    if !declared(&format!("can-{action}")) {
                        continue;
                    }
                    for capable in knowledge.tools_for(medium, surface, action)? {
                        let tool = capable.tool.name.as_str();
                        if tools.contains(&tool) {
                            writeln!(facts, "    (can-{action} {tool} {medium} {surface})")
                                .expect(STRING);
                        }
                    }
                }
            }
        }
        Ok(format!(
            "(define (problem derived)\n  (:domain {})\n  (:objects\n{objects})\n  \
             (:init\n{facts})\n  (:goal {literal}))\n",
            domain.name()
        ))
    }
}

/// Why writing to a `String` is no error.
const STRING: &str = "a String takes whatever is written";

/// What is known for a medium on a surface, such as "skim with window_wiper".
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

/// The predicates that the domain's wiping actions bring about.
fn wiping_goals(domain: &Domain) -> Vec<String> {
    let mut goals: Vec<String> = (domain.schemas.iter())
        .filter(|schema| schema.name.parse::<Action>().is_ok())
        .flat_map(|schema| &schema.add)
        .map(|add| domain.predicates[add.predicate].name.clone())
        .collect();
    goals.sort();
    goals.dedup();
    goals
}

/// Action, tool, medium and surface of a step, if it wipes.
fn wiping_step(step: &Step, domain: &Domain) -> Option<(Action, [String; 3])> {
    let action = step.action.parse().ok()?;
    let schema = domain.schemas.iter().find(|s| s.name == step.action)?;
    let argument_of = |type_name: &str| {
        let parameter = (schema.parameters.iter())
            .position(|parameter| domain.type_name(parameter.type_id) == type_name)?;
        step.arguments.get(parameter).cloned()
    };
    let arguments = [
        argument_of("tool")?,
        argument_of("medium")?,
        argument_of("surface")?,
    ];
    Some((action, arguments))
}
