//! Goals of several parts: the order of the wiping steps, and the tools that are fetched for them.

use std::collections::BTreeSet;
use std::fmt;

use super::domain::Schema;
use super::form::{self, Source};
use super::search::{self, Fact, Problem, StepCosts};
use super::{
    Domain, GOAL_TEXT_NAME, GoalError, GoalLiteral, owned, syntax, wiping_step,
    with_declared_predicate,
};
use crate::represent::{Action, KnowledgeBase, MediumKind};

/// A conjunction of facts, each of which is to hold or not to hold, such as
/// `(and (collected breadcrumbs chopping_board) (not (wet table)))`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompoundGoal {
    /// Whether each fact is to hold, and the fact.
    parts: Vec<(bool, GoalLiteral)>,
}

impl CompoundGoal {
    /// Reads a goal: one fact, a negated fact, or an `(and ...)` of these. PDDL ignores case, so names are converted to
    /// lower case, and a part that is repeated counts once.
    ///
    /// # Errors
    ///
    /// [`GoalError::Text`], with line and column, for anything else, and for a goal without parts.
    ///
    /// ```
    /// use wisch::goal::CompoundGoal;
    /// let goal = CompoundGoal::parse("(and (absorbed water table) (not (wet table)))")?;
    /// let parts: Vec<(bool, String)> =
    ///     goal.parts().map(|(holds, fact)| (holds, fact.to_string())).collect();
    /// assert_eq!(parts, [(true, "(absorbed water table)".to_owned()), (false, "(wet table)".to_owned())]);
    /// # Ok::<(), wisch::goal::GoalError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, GoalError> {
        let source = Source {
            name: GOAL_TEXT_NAME,
            text,
        };
        let form = form::read(source)?;
        let mut parts: Vec<(bool, GoalLiteral)> = Vec::new();
        for literal in syntax::read_literals(source, &form)? {
            if !literal.variables.is_empty() {
                return Err(source.not_supported(form.at, "`forall` in a goal"));
            }
            if !literal.conditions.is_empty() {
                return Err(source.not_supported(form.at, "`when` in a goal"));
            }
            let atom = literal.atom;
            if let Some(variable) = atom.words.iter().find(|word| word.starts_with('?')) {
                return Err(source.expected_at(atom.at, "names only", &format!("`{variable}`")));
            }
            let part = (literal.holds, GoalLiteral { words: atom.words });
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        if parts.is_empty() {
            return Err(source.expected("a fact", &form));
        }
        Ok(Self { parts })
    }

    /// Iterates over the parts in their order: whether a fact is to hold, and the fact.
    pub fn parts(&self) -> impl Iterator<Item = (bool, &GoalLiteral)> {
        self.parts.iter().map(|(holds, fact)| (*holds, fact))
    }
}

impl fmt::Display for CompoundGoal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.parts[..] {
            [part] => f.write_str(&describe_part(part)),
            parts => {
                let parts: Vec<String> = parts.iter().map(describe_part).collect();
                write!(f, "(and {})", parts.join(" "))
            }
        }
    }
}

fn describe_part((holds, fact): &(bool, GoalLiteral)) -> String {
    if *holds {
        fact.to_string()
    } else {
        format!("(not {fact})")
    }
}

/// A wiping action with its tool, medium and surface.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Wiping {
    /// The wiping action.
    pub action: Action,
    /// Name of the tool.
    pub tool: String,
    /// Name of the medium.
    pub medium: String,
    /// Name of the surface.
    pub surface: String,
}

impl fmt::Display for Wiping {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            action,
            tool,
            medium,
            surface,
        } = self;
        write!(f, "{action} {medium} on {surface} with {tool}")
    }
}

/// The place at which a step is carried out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepPlace<'a> {
    /// Where the robot stands before the first step.
    Start,
    /// At a surface, by its name.
    Surface(&'a str),
    /// At the place in the rack where a tool is fetched, put back and emptied, by the tool's name.
    Rack(&'a str),
}

/// The expected times of steps \[s\]. All are finite and not negative.
pub trait StepTimes {
    /// Expected time until the wiping has reached its goal; `None` if it cannot.
    fn wiping(&self, wiping: &Wiping) -> Option<f64>;
    /// Time of any other step, such as `grasp`, by its name.
    fn handling(&self, name: &str) -> f64;
    /// Time of the way between two places.
    fn moving(&self, from: StepPlace<'_>, to: StepPlace<'_>) -> f64;
}

/// A step of a sequence: an action with its objects and its expected time.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Name of the action, then its objects.
    words: Vec<String>,
    /// The wiping action; `None` for a step such as `(grasp sponge)`.
    pub wiping: Option<Wiping>,
    /// Expected time, with the way to its place \[s\].
    pub time: f64,
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&search::format_fact(&self.words))
    }
}

impl Step {
    /// Name of the action, such as `grasp`.
    pub fn name(&self) -> &str {
        &self.words[0]
    }

    /// Names of the step's objects, in the order of the action's parameters.
    pub fn objects(&self) -> &[String] {
        &self.words[1..]
    }
}

/// A sequence of steps for a goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Sequence {
    /// The steps, in the order of their execution. Their total time is the least of all sequences.
    pub steps: Vec<Step>,
    /// Parts of the goal that no sequence reaches, each with the reason.
    pub left_out: Vec<(String, String)>,
}

impl Sequence {
    /// Expected time of all steps \[s\].
    pub fn time(&self) -> f64 {
        self.steps.iter().fold(0.0, |time, step| time + step.time)
    }
}

/// A medium that lies on a surface, or treats it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MediumOnSurface {
    /// Name of the medium.
    pub medium: String,
    /// Name of the surface.
    pub surface: String,
}

/// The symbolic state: the objects, and the facts that hold.
#[derive(Debug, Clone)]
pub struct Situation<'a> {
    domain: &'a Domain,
    /// Names with their types.
    objects: Vec<(String, &'static str)>,
    facts: BTreeSet<Vec<String>>,
    on_surfaces: Vec<MediumOnSurface>,
    /// Liquids, each on a surface, which is wet while the liquid is on it.
    liquids: Vec<MediumOnSurface>,
}

impl<'a> Situation<'a> {
    /// Creates the state before the first step.
    ///
    /// - `domain`: the actions and predicates. Facts without a predicate in the domain are left out.
    /// - `knowledge`: kinds of media, and the tools that can perform an action on a medium and a surface.
    /// - `goal`: its parts decide which media are treatments.
    /// - `media`: the media on the surfaces, and those of treatments, which the tool brings along.
    /// - `tool_in_hand`, `tools`: the tool in the hand, and those that the robot can fetch.
    ///
    /// The facts:
    ///
    /// - `(holding t)` or `(hand-empty)`.
    /// - `(on m s)` for every medium m that lies on a surface s, and `(wet s)` while a liquid lies on s.
    /// - `(in-way d m s)` where d is loose dirt and m a liquid, or d is polish and m a coat.
    /// - `(under d m s)` where d is dirt and m the medium of a treatment, under which no heap may lie.
    /// - `(can-ACTION t m s)` if the tool t can perform the action, by the knowledge base.
    ///
    /// # Errors
    ///
    /// [`GoalError::Knowledge`] for a name that is not in the knowledge base.
    pub fn new(
        domain: &'a Domain,
        knowledge: &KnowledgeBase,
        goal: &CompoundGoal,
        media: &[MediumOnSurface],
        tool_in_hand: Option<&str>,
        tools: &[&str],
    ) -> Result<Self, GoalError> {
        let mut situation = Self {
            domain,
            objects: Vec::new(),
            facts: BTreeSet::new(),
            on_surfaces: media.to_vec(),
            liquids: Vec::new(),
        };
        match tool_in_hand {
            Some(tool) => situation.add(["holding", tool]),
            None => situation.add(["hand-empty"]),
        }
        for &tool in tool_in_hand.iter().chain(tools) {
            knowledge.tool(tool)?;
            situation.add_object(tool, "tool");
        }
        for on in media {
            let MediumOnSurface { medium, surface } = on;
            knowledge.surface(surface)?;
            situation.add_object(medium, "medium");
            situation.add_object(surface, "surface");
            let rank = rank_medium(knowledge, goal, medium, surface)?;
            if rank < TREATMENT {
                situation.add(["on", medium, surface]);
            }
            if rank == LIQUID {
                situation.liquids.push(on.clone());
            }
            for other in media.iter().filter(|other| other.surface == *surface) {
                let later = rank_medium(knowledge, goal, &other.medium, surface)?;
                // A heap would lie under what treats the whole surface.
                let is_under = later >= TREATMENT && rank < TREATMENT;
                let fact = if is_under && situation.has_predicate(UNDER) {
                    UNDER
                } else {
                    IN_WAY
                };
                if rank < later {
                    situation.add([fact, medium, &other.medium, surface]);
                }
            }
            for action in Action::ALL {
                for capable in knowledge.tools_for(medium, surface, action)? {
                    let tool = capable.tool.name.as_str();
                    if situation.objects.contains(&(tool.to_owned(), "tool")) {
                        situation.add([&format!("can-{action}"), tool, medium, surface]);
                    }
                }
            }
        }
        situation.derive_wet();
        Ok(situation)
    }

    /// Derives the facts `(wet s)` from the liquids on the surfaces.
    fn derive_wet(&mut self) {
        self.facts.retain(|fact| fact[0] != WET);
        let liquids = self.liquids.clone();
        let wet = liquids.iter().filter(|liquid| {
            let on = owned(&["on", &liquid.medium, &liquid.surface]);
            self.facts.contains(&on)
        });
        let wet: Vec<&str> = wet.map(|liquid| liquid.surface.as_str()).collect();
        for surface in wet {
            self.add([WET, surface]);
        }
    }

    /// Returns the facts that a part of a goal states, each with whether it is to hold. That a surface is not wet means that no
    /// liquid lies on it.
    fn list_facts_of_part(&self, holds: bool, part: &GoalLiteral) -> Vec<(bool, Vec<String>)> {
        let part = with_declared_predicate(part, self.domain);
        match part.arguments() {
            [surface] if part.predicate() == WET && !holds => {
                let liquids = self.liquids.iter().filter(|on| on.surface == *surface);
                let facts = liquids.map(|on| (false, owned(&["on", &on.medium, surface])));
                facts.collect()
            }
            _ => vec![(holds, part.words)],
        }
    }

    fn has_predicate(&self, name: &str) -> bool {
        self.domain.predicates.iter().any(|p| p.name == name)
    }

    /// Adds a fact, if the domain has its predicate.
    fn add<const N: usize>(&mut self, words: [&str; N]) {
        if self.has_predicate(words[0]) {
            self.facts.insert(owned(&words));
        }
    }

    fn add_object(&mut self, name: &str, type_name: &'static str) {
        let object = (name.to_owned(), type_name);
        if !self.objects.contains(&object) {
            self.objects.push(object);
        }
    }

    /// Whether a fact holds.
    pub fn holds(&self, fact: &GoalLiteral) -> bool {
        self.facts
            .contains(&with_declared_predicate(fact, self.domain).words)
    }

    /// Applies the effects of a step that was carried out and reached its goal.
    pub fn apply(&mut self, step: &Step) {
        self.apply_where(step, |_| true);
    }

    /// Applies the effects of a step that was carried out, but missed its goal: the effects on tools, such as a loaded sponge, and
    /// on the remaining media of the surface.
    pub fn apply_missed(&mut self, step: &Step) {
        let medium = step.wiping.as_ref().map(|wiping| wiping.medium.clone());
        self.apply_where(step, |fact| {
            medium.as_ref().is_none_or(|name| !fact.contains(name))
        });
    }

    /// Applies the effects of a step whose facts a condition accepts.
    fn apply_where(&mut self, step: &Step, accepts: impl Fn(&[String]) -> bool) {
        let Some(schema) = self.schema(step.name()) else {
            return;
        };
        let objects: Vec<&str> = step.objects().iter().map(String::as_str).collect();
        let problem = self.build_problem(Vec::new());
        let mut facts = self.facts.clone();
        for holds in [false, true] {
            let effects = schema.effects.iter().filter(|effect| effect.holds == holds);
            for fact in effects.flat_map(|effect| problem.list_instances(effect, schema, &objects))
            {
                let fact = owned(&fact);
                match holds {
                    _ if !accepts(&fact) => {}
                    true => drop(facts.insert(fact)),
                    false => drop(facts.remove(&fact)),
                }
            }
        }
        self.facts = facts;
        self.derive_wet();
    }

    /// Rules a wiping action out from now on: removes the fact that the tool can perform it.
    pub fn rule_out(&mut self, wiping: &Wiping) {
        let Wiping {
            action,
            tool,
            medium,
            surface,
        } = wiping;
        self.facts
            .remove(&owned(&[&format!("can-{action}"), tool, medium, surface]));
    }

    /// Notes that the strokes of a wiping action pass over the collected dirt of another medium on the same surface.
    ///
    /// `collected`: name of that medium.
    pub fn note_sweep(&mut self, wiping: &Wiping, collected: &str) {
        let Wiping {
            tool,
            medium,
            surface,
            ..
        } = wiping;
        self.add(["sweeps", tool, medium, collected, surface]);
    }

    /// Notes that the collected dirt of a medium was wiped over, so that it no longer counts as collected.
    ///
    /// `collected`: name of the medium; `surface`: name of the surface.
    pub fn note_spoiled(&mut self, collected: &str, surface: &str) {
        self.facts
            .remove(&owned(&["collected", collected, surface]));
        self.add(["spoiled", collected, surface]);
    }

    fn schema(&self, name: &str) -> Option<&'a Schema> {
        self.domain
            .schemas
            .iter()
            .find(|schema| schema.name == name)
    }

    /// Returns the fact that a wiping action brings about, such as `(absorbed water table)`: the first of its effects.
    /// `None` if the domain has no such action or effect.
    pub fn find_effect_of(&self, wiping: &Wiping) -> Option<GoalLiteral> {
        let schema = self.schema(wiping.action.as_str())?;
        let objects = bind(schema, wiping)?;
        let effect = schema.added().find(|effect| effect.variables.is_empty())?;
        let facts = self
            .build_problem(Vec::new())
            .list_instances(effect, schema, &objects);
        let words = owned(facts.first()?);
        Some(GoalLiteral { words })
    }

    /// Returns the wiping actions that may serve a goal: those that bring its parts about, and those that remove a medium
    /// which is in their way. Sorted by surface and medium in the order of the situation, then by action and tool.
    pub fn list_possible_wipings(&self, goal: &CompoundGoal) -> Vec<Wiping> {
        let mut all = Vec::new();
        for on in &self.on_surfaces {
            let of_medium = self.list_capable_wipings(on);
            let serving = of_medium.iter().filter(|wiping| self.serves(wiping, goal));
            let serving: Vec<Wiping> = serving.cloned().collect();
            let is = |name: &str| {
                let start = [name.to_owned(), on.medium.clone()];
                let mut facts = self.facts.iter();
                facts.any(|fact| fact.starts_with(&start) && fact.last() == Some(&on.surface))
            };
            let is_removed = is(UNDER);
            if !serving.is_empty() {
                all.extend(serving.iter().cloned());
            } else if is(IN_WAY) && !is_removed {
                all.extend(of_medium.iter().cloned());
            }
            if is_removed {
                let others = of_medium
                    .into_iter()
                    .filter(|wiping| !serving.contains(wiping));
                all.extend(others.filter(|wiping| wiping.action != Action::Collect));
            }
        }
        all
    }

    /// Returns the wiping actions that a tool of the situation can perform on a medium and its surface.
    fn list_capable_wipings(&self, on: &MediumOnSurface) -> Vec<Wiping> {
        let mut found = Vec::new();
        for action in Action::ALL {
            for (tool, _) in self.objects.iter().filter(|(_, kind)| *kind == "tool") {
                let fact = owned(&[&format!("can-{action}"), tool, &on.medium, &on.surface]);
                if self.facts.contains(&fact) {
                    found.push(Wiping {
                        action,
                        tool: tool.clone(),
                        medium: on.medium.clone(),
                        surface: on.surface.clone(),
                    });
                }
            }
        }
        found
    }

    /// Whether a wiping action brings a part of the goal about.
    fn serves(&self, wiping: &Wiping, goal: &CompoundGoal) -> bool {
        !self.find_reached_parts(wiping, goal).is_empty()
    }

    /// Returns the indices of the parts of a goal that a wiping action brings about, in the order of [`CompoundGoal::parts`].
    pub fn find_reached_parts(&self, wiping: &Wiping, goal: &CompoundGoal) -> Vec<usize> {
        let Some(schema) = self.schema(wiping.action.as_str()) else {
            return Vec::new();
        };
        let problem = self.build_problem(Vec::new());
        let Some(objects) = bind(schema, wiping) else {
            return Vec::new();
        };
        let is_effect = |(holds, words): (bool, Vec<String>)| {
            let effects = schema.effects.iter().filter(|effect| effect.holds == holds);
            let mut facts =
                effects.flat_map(|effect| problem.list_instances(effect, schema, &objects));
            facts.any(|fact| words == owned(&fact))
        };
        let parts = goal.parts.iter().enumerate().filter(|(_, (holds, part))| {
            let wanted = self.list_facts_of_part(*holds, part);
            wanted.into_iter().any(&is_effect)
        });
        parts.map(|(place, _)| place).collect()
    }

    /// Returns the indices of the parts of a goal that a wiping action serves, in the order of [`CompoundGoal::parts`]: the
    /// parts that it brings about, or else those that need a medium wiped in whose way its own medium lies.
    ///
    /// Call it for the state before the first step, in which all dirt lies in the way.
    pub fn find_served_parts(&self, wiping: &Wiping, goal: &CompoundGoal) -> Vec<usize> {
        let own = self.find_reached_parts(wiping, goal);
        if !own.is_empty() {
            return own;
        }
        let Wiping {
            medium, surface, ..
        } = wiping;
        let cleared = self.on_surfaces.iter().filter(|on| {
            let facts = [IN_WAY, UNDER].map(|name| owned(&[name, medium, &on.medium, surface]));
            on.surface == *surface && facts.iter().any(|fact| self.facts.contains(fact))
        });
        let behind = cleared.flat_map(|on| self.list_capable_wipings(on));
        let served: BTreeSet<usize> = behind
            .flat_map(|wiping| self.find_reached_parts(&wiping, goal))
            .collect();
        served.into_iter().collect()
    }

    /// Returns the planning problem of some parts of a goal.
    fn build_problem<'p>(&'p self, goal: Vec<(bool, Fact<'p>)>) -> Problem<'p> {
        let constants = self.domain.constants.iter().map(syntax::Typed::as_pair);
        let mut objects: Vec<(&str, &str)> = constants.collect();
        for (name, type_name) in &self.objects {
            // A constant of the domain is an object already.
            if self.domain.constants.iter().all(|c| c.name != *name) {
                objects.push((name, type_name));
            }
        }
        let facts = self.facts.iter();
        Problem {
            domain: self.domain,
            objects,
            init: facts.map(|fact| as_fact(fact)).collect(),
            goal,
        }
    }

    /// Plans the sequence of least expected time. Parts of the goal that no sequence reaches,
    /// alone or together with the parts before them, are left out, with reasons.
    ///
    /// `place`: where the robot is; `times`: the expected times of the steps.
    ///
    /// # Errors
    ///
    /// [`GoalError::Text`] for a predicate that is not in the domain or an object that is not in the situation, and
    /// [`GoalError::TooLarge`] if the search exceeds its limit of search steps.
    pub fn plan(
        &self,
        goal: &CompoundGoal,
        place: StepPlace<'_>,
        times: &dyn StepTimes,
    ) -> Result<Sequence, GoalError> {
        let facts_of_parts: Vec<Vec<(bool, Vec<String>)>> = (goal.parts.iter())
            .map(|(holds, part)| self.list_facts_of_part(*holds, part))
            .collect();
        let costs = Times {
            situation: self,
            places: self.places(place),
            possible: self.list_possible_wipings(goal).into_iter().collect(),
            times,
        };
        let (mut reached, mut left_out) = (Vec::new(), Vec::new());
        for (facts, part) in facts_of_parts.iter().zip(&goal.parts) {
            let wanted = facts.iter().map(|(holds, words)| (*holds, as_fact(words)));
            let problem = self.build_problem(wanted.clone().collect());
            self.check(&part.1)?;
            if problem.cheapest_plan(&costs, 0)?.is_some() {
                reached.push((part, wanted.collect::<Vec<_>>()));
            } else {
                let mut reasons = problem.unmet_preconditions()?;
                if reasons.is_empty() {
                    reasons = problem.list_obstacles(&costs)?;
                }
                let reason = if reasons.is_empty() {
                    "no wiping action that serves it can be carried out".to_owned()
                } else {
                    reasons.join("; ")
                };
                left_out.push((describe_part(part), reason));
            }
        }
        let mut steps = self
            .build_problem(collect_facts(&reached))
            .cheapest_plan(&costs, 0)?;
        if steps.is_none() {
            // As many parts as are reached together, in their order.
            let mut together = Vec::new();
            for one in reached {
                together.push(one);
                if let Some(found) = self
                    .build_problem(collect_facts(&together))
                    .cheapest_plan(&costs, 0)?
                {
                    steps = Some(found);
                } else if let Some((part, _)) = together.pop() {
                    left_out.push((describe_part(part), self.explain_conflict(part)));
                }
            }
        }
        let steps = steps.unwrap_or_default();
        let mut place = 0;
        let steps = steps.iter().map(|words| {
            let (time, next) = costs.cost(words, place);
            place = next;
            Step {
                words: owned(words),
                wiping: costs.wiping(words),
                time,
            }
        });
        Ok(Sequence {
            steps: steps.collect(),
            left_out,
        })
    }

    /// Explains why a part is not reached together with those before it.
    fn explain_conflict(&self, (_, part): &(bool, GoalLiteral)) -> String {
        let mut sweeps = self.facts.iter().filter(|fact| fact[0] == "sweeps");
        let on_surface = |fact: &&Vec<String>| part.arguments().contains(&fact[fact.len() - 1]);
        match sweeps.find(on_surface).map(Vec::as_slice) {
            Some([_, _, medium, collected, surface]) => format!(
                "wiping {medium} on {surface} would pass over the heap of {collected} there"
            ),
            _ => "no sequence of steps reaches it together with the parts before it".to_owned(),
        }
    }

    /// Rejects a part of a goal that does not fit the domain or names an object that is not in the situation.
    fn check(&self, part: &GoalLiteral) -> Result<(), GoalError> {
        let part = with_declared_predicate(part, self.domain);
        self.build_problem(vec![(true, as_fact(&part.words))])
            .check()
    }

    /// Returns the places of steps: the present one, then all surfaces and racks.
    fn places<'p>(&'p self, present: StepPlace<'p>) -> Vec<StepPlace<'p>> {
        let places = self.objects.iter().filter_map(|(name, kind)| match *kind {
            "tool" => Some(StepPlace::Rack(name)),
            "surface" => Some(StepPlace::Surface(name)),
            _ => None,
        });
        std::iter::once(present).chain(places).collect()
    }
}

/// Binds the parameters of a wiping action; `None` if a parameter is neither a tool, a medium nor a surface.
fn bind<'p>(schema: &Schema, wiping: &'p Wiping) -> Option<Vec<&'p str>> {
    let objects = schema
        .parameters
        .iter()
        .map(|parameter| match parameter.type_name.as_str() {
            "tool" => Some(wiping.tool.as_str()),
            "medium" => Some(wiping.medium.as_str()),
            "surface" => Some(wiping.surface.as_str()),
            _ => None,
        });
    objects.collect()
}

/// A part of a goal with the facts that it states.
type Reached<'a> = (&'a (bool, GoalLiteral), Vec<(bool, Fact<'a>)>);

/// Returns the facts of all parts.
fn collect_facts<'a>(parts: &[Reached<'a>]) -> Vec<(bool, Fact<'a>)> {
    let facts = parts.iter().flat_map(|(_, facts)| facts.clone());
    facts.collect()
}

fn as_fact(words: &[String]) -> Fact<'_> {
    words.iter().map(String::as_str).collect()
}

/// The times of steps as costs of the search.
struct Times<'a> {
    situation: &'a Situation<'a>,
    /// All places; the search names them by their index.
    places: Vec<StepPlace<'a>>,
    /// Wiping actions that may serve the goal; others only make the search longer.
    possible: BTreeSet<Wiping>,
    times: &'a dyn StepTimes,
}

impl Times<'_> {
    fn wiping(&self, words: &[&str]) -> Option<Wiping> {
        let step = words.to_vec();
        let (action, [tool, medium, surface]) = wiping_step(&step, self.situation.domain)?;
        Some(Wiping {
            action,
            tool,
            medium,
            surface,
        })
    }

    /// Returns the time of a step without the way to its place [s], and the index of its place. `present`: index of the place of
    /// the step before, which applies to a step without a place.
    fn at_place(&self, words: &[&str], present: usize) -> (Option<f64>, usize) {
        if let Some(wiping) = self.wiping(words) {
            let place = StepPlace::Surface(&wiping.surface);
            let index = self.places.iter().position(|other| *other == place);
            let time = (self.possible.contains(&wiping)).then(|| self.times.wiping(&wiping));
            return (time.flatten(), index.unwrap_or(present));
        }
        let racks = words[1..].iter().filter_map(|word| {
            let place = StepPlace::Rack(word);
            self.places.iter().position(|other| *other == place)
        });
        let index = racks.into_iter().next().unwrap_or(present);
        (Some(self.times.handling(words[0])), index)
    }
}

impl StepCosts for Times<'_> {
    fn cost(&self, step: &[&str], place: usize) -> (f64, usize) {
        let (time, next) = self.at_place(step, place);
        let way = if next == place {
            0.0
        } else {
            self.times.moving(self.places[place], self.places[next])
        };
        (way + time.unwrap_or(f64::INFINITY), next)
    }

    fn least(&self, step: &[&str]) -> Option<f64> {
        self.at_place(step, 0).0
    }
}

/// Predicate of a surface on which a liquid lies; no action has it as an effect.
const WET: &str = "wet";
/// Predicate of a medium that has to be wiped before another one.
const IN_WAY: &str = "in-way";
/// Predicate of a medium that has to be off the surface before a treatment.
const UNDER: &str = "under";
/// Ranks of media, in the order of wiping: loose dirt, liquids, polish, and coats.
const LOOSE: u8 = 0;
const LIQUID: u8 = 1;
const TREATMENT: u8 = 2;
const COAT: u8 = 3;

/// Returns the rank of a medium on a surface. The goal decides whether it is a treatment.
fn rank_medium(
    knowledge: &KnowledgeBase,
    goal: &CompoundGoal,
    medium: &str,
    surface: &str,
) -> Result<u8, GoalError> {
    let is_to_be = |predicates: &[&str]| {
        goal.parts().any(|(holds, fact)| {
            holds && predicates.contains(&fact.predicate()) && fact.arguments() == [medium, surface]
        })
    };
    Ok(match knowledge.medium(medium)?.kind {
        _ if is_to_be(&["dispensed", "emitted"]) => COAT,
        _ if is_to_be(&["polished"]) => TREATMENT,
        MediumKind::Liquid => LIQUID,
        _ => LOOSE,
    })
}
