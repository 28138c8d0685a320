//! Grounds a problem and searches it breadth first.

use std::collections::{HashMap, HashSet, VecDeque};
use std::fmt;
use std::rc::Rc;

use super::domain::{Lookup, Pattern, PredicateId, Schema, Term, TypeId};
use super::form::Source;
use super::syntax::Atom;
use super::{Domain, GoalError, Problem};

/// Most states a search visits.
pub(super) const MAX_STATES: usize = 100_000;
/// Most work of a search: facts checked, changed and copied, 64 at a time. A few seconds.
pub(super) const MAX_WORK: usize = 1_000_000_000;
/// Most actions with all parameters bound.
pub(super) const MAX_ACTIONS: usize = 10_000;
/// Most facts that actions can change; a state holds one bit for each.
pub(super) const MAX_FACTS: usize = 20_000;
/// Most steps spent on binding parameters [tried objects and bound atoms].
pub(super) const MAX_BINDINGS: usize = 2_000_000;

/// An action of a plan with its arguments, printed as `(name argument ...)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The action's name in the domain.
    pub action: String,
    /// The objects that it is applied to, in the order of its parameters.
    pub arguments: Vec<String>,
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_atom(f, &self.action, self.arguments.iter().map(String::as_str))
    }
}

/// Prints `(name argument ...)`.
pub(super) fn write_atom<'a>(
    f: &mut impl fmt::Write,
    name: &str,
    arguments: impl Iterator<Item = &'a str>,
) -> fmt::Result {
    write!(f, "({name}")?;
    for argument in arguments {
        write!(f, " {argument}")?;
    }
    f.write_char(')')
}

type ObjectId = usize;
type FactId = usize;

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Fact {
    predicate: PredicateId,
    arguments: Vec<ObjectId>,
}

/// An action with its parameters bound. Facts that no action changes are checked once, on binding.
struct GroundAction {
    schema: usize,
    binding: Vec<ObjectId>,
    preconditions: Vec<FactId>,
    add: Vec<FactId>,
    delete: Vec<FactId>,
}

/// The facts that hold, one bit each.
type State = Rc<[u64]>;

fn holds(state: &[u64], fact: FactId) -> bool {
    state[fact / 64] >> (fact % 64) & 1 == 1
}

/// A problem with all names resolved and all actions bound that could ever be applied.
pub(super) struct Grounded<'a> {
    domain: &'a Domain,
    source: Source<'a>,
    /// The domain's constants, then the problem's objects.
    objects: Vec<(&'a str, TypeId)>,
    goal: Vec<Fact>,
    init: HashSet<Fact>,
    /// For each predicate, whether some action changes it.
    changing: Vec<bool>,
    /// The facts that actions can change.
    facts: HashMap<Fact, FactId>,
    actions: Vec<GroundAction>,
    /// For each of `facts`, whether it can become true if deleting is left out.
    reachable: Vec<bool>,
}

impl<'a> Grounded<'a> {
    pub(super) fn new(domain: &'a Domain, problem: &'a Problem) -> Result<Self, GoalError> {
        let source = problem.source();
        if problem.domain != domain.name() {
            return Err(GoalError::OtherDomain {
                at: source.place(problem.domain_at),
                found: problem.domain.clone(),
                expected: domain.name().to_owned(),
            });
        }
        let mut changing = vec![false; domain.predicates.len()];
        for pattern in (domain.schemas.iter()).flat_map(|s| s.add.iter().chain(&s.delete)) {
            changing[pattern.predicate] = true;
        }
        let mut grounded = Self {
            domain,
            source,
            objects: (domain.constants.iter())
                .map(|constant| (constant.name.as_str(), constant.type_id))
                .collect(),
            goal: Vec::new(),
            init: HashSet::new(),
            changing,
            facts: HashMap::new(),
            actions: Vec::new(),
            reachable: Vec::new(),
        };
        grounded.resolve(problem)?;
        grounded.bind_actions()?;
        grounded.drop_unreachable_actions();
        Ok(grounded)
    }

    /// Replaces the problem's names by what they name.
    fn resolve(&mut self, problem: &'a Problem) -> Result<(), GoalError> {
        let lookup = Lookup::new(self.domain);
        for object in &problem.objects {
            if lookup.constants.contains_key(&object.name) {
                let expected = "an object that is no constant of the domain";
                let found = format!("`{}`", object.name);
                return Err(self.source.expected_at(object.at, expected, &found));
            }
            let type_id = self.domain.type_named(self.source, object)?;
            self.objects.push((&object.name, type_id));
        }
        let by_name: HashMap<&str, ObjectId> = (self.objects.iter().map(|(name, _)| *name))
            .zip(0..)
            .collect();
        for atom in &problem.init {
            let fact = self.fact(atom, &lookup, &by_name)?;
            if self.changing[fact.predicate] {
                self.fact_id(fact.clone())?;
            }
            self.init.insert(fact);
        }
        for atom in &problem.goal {
            let fact = self.fact(atom, &lookup, &by_name)?;
            if self.changing[fact.predicate] {
                self.fact_id(fact.clone())?;
            }
            self.goal.push(fact);
        }
        Ok(())
    }

    fn fact(
        &self,
        atom: &Atom,
        lookup: &Lookup,
        by_name: &HashMap<&str, ObjectId>,
    ) -> Result<Fact, GoalError> {
        let predicate = self.domain.predicate_of(self.source, atom, lookup)?;
        let mut arguments = Vec::with_capacity(atom.arguments.len());
        let expected = &self.domain.predicates[predicate].parameters;
        for (argument, &expected) in atom.arguments.iter().zip(expected) {
            let &object = by_name.get(argument.as_str()).ok_or_else(|| {
                let known = self.objects.iter().map(|(name, _)| *name);
                self.source.unknown(atom.at, "object", argument, known)
            })?;
            let found = self.objects[object].1;
            self.domain
                .check_type(self.source, atom.at, argument, found, expected)?;
            arguments.push(object);
        }
        Ok(Fact {
            predicate,
            arguments,
        })
    }

    fn fact_id(&mut self, fact: Fact) -> Result<FactId, GoalError> {
        let next = self.facts.len();
        let id = *self.facts.entry(fact).or_insert(next);
        self.source
            .check_size("number of facts", self.facts.len(), MAX_FACTS)?;
        Ok(id)
    }

    fn bind_actions(&mut self) -> Result<(), GoalError> {
        let mut spent = 0;
        for schema in 0..self.domain.schemas.len() {
            self.bind(schema, &mut Vec::new(), &mut spent)?;
        }
        Ok(())
    }

    /// Binds the parameters of an action one after the other, turning back as soon as a
    /// precondition that no action can change does not hold.
    fn bind(
        &mut self,
        schema_id: usize,
        binding: &mut Vec<ObjectId>,
        spent: &mut usize,
    ) -> Result<(), GoalError> {
        let domain = self.domain;
        let schema = &domain.schemas[schema_id];
        *spent += 1 + schema.preconditions.len();
        self.source
            .check_size("steps to bind all actions", *spent, MAX_BINDINGS)?;
        let possible = (schema.preconditions.iter())
            .filter(|p| !self.changing[p.predicate] && bound_at(p) == binding.len())
            .all(|p| self.init.contains(&ground(p, binding)));
        if !possible {
            return Ok(());
        }
        if let Some(parameter) = schema.parameters.get(binding.len()) {
            for object in 0..self.objects.len() {
                *spent += 1;
                if domain.is_a(self.objects[object].1, parameter.type_id) {
                    binding.push(object);
                    self.bind(schema_id, binding, spent)?;
                    binding.pop();
                }
            }
            return Ok(());
        }
        *spent += schema.add.len() + schema.delete.len();
        let action = GroundAction {
            schema: schema_id,
            binding: binding.clone(),
            preconditions: self.fact_ids(&schema.preconditions, binding)?,
            add: self.fact_ids(&schema.add, binding)?,
            delete: self.fact_ids(&schema.delete, binding)?,
        };
        self.actions.push(action);
        self.source.check_size(
            "number of grounded actions",
            self.actions.len(),
            MAX_ACTIONS,
        )
    }

    fn fact_ids(
        &mut self,
        patterns: &[Pattern],
        binding: &[ObjectId],
    ) -> Result<Vec<FactId>, GoalError> {
        let mut ids = Vec::new();
        for pattern in patterns {
            if self.changing[pattern.predicate] {
                ids.push(self.fact_id(ground(pattern, binding))?);
            }
        }
        Ok(ids)
    }

    /// Finds what can become true if nothing is ever deleted, and keeps the actions that then apply.
    fn drop_unreachable_actions(&mut self) {
        let mut waiting_for: Vec<Vec<usize>> = vec![Vec::new(); self.facts.len()];
        let mut missing: Vec<usize> = Vec::with_capacity(self.actions.len());
        for (i, action) in self.actions.iter().enumerate() {
            missing.push(action.preconditions.len());
            for &fact in &action.preconditions {
                waiting_for[fact].push(i);
            }
        }
        self.reachable = vec![false; self.facts.len()];
        let first = self
            .init
            .iter()
            .filter_map(|fact| self.facts.get(fact).copied());
        let without_condition = (self.actions.iter())
            .filter(|action| action.preconditions.is_empty())
            .flat_map(|action| action.add.iter().copied());
        let mut new_facts: Vec<FactId> = first.chain(without_condition).collect();
        while let Some(fact) = new_facts.pop() {
            if std::mem::replace(&mut self.reachable[fact], true) {
                continue;
            }
            for &action in &waiting_for[fact] {
                missing[action] -= 1;
                if missing[action] == 0 {
                    new_facts.extend(&self.actions[action].add);
                }
            }
        }
        let mut missing = missing.into_iter();
        self.actions.retain(|_| missing.next() == Some(0));
    }

    fn is_reachable(&self, fact: &Fact) -> bool {
        self.init.contains(fact) || self.facts.get(fact).is_some_and(|&id| self.reachable[id])
    }

    pub(super) fn shortest_plan(&self) -> Result<Option<Vec<Step>>, GoalError> {
        if !self.goal.iter().all(|fact| self.is_reachable(fact)) {
            return Ok(None);
        }
        // What is left of the goal: facts that change.
        let goal: Vec<FactId> = (self.goal.iter())
            .filter_map(|fact| self.facts.get(fact).copied())
            .collect();
        let reached = |state: &State| goal.iter().all(|&fact| holds(state, fact));

        let mut first = vec![0_u64; self.facts.len().div_ceil(64)];
        for id in self.init.iter().filter_map(|fact| self.facts.get(fact)) {
            first[id / 64] |= 1 << (id % 64);
        }
        let first: State = first.into();
        if reached(&first) {
            return Ok(Some(Vec::new()));
        }
        // Every state but the first with the one before it and the action between them.
        let mut came_by: Vec<(usize, usize)> = vec![(0, 0)];
        let mut seen = HashSet::from([first.clone()]);
        let mut queue = VecDeque::from([(0, first)]);
        let work_per_state: usize = (self.actions.iter())
            .map(|action| 1 + action.preconditions.len())
            .sum();
        let mut work = 0;
        while let Some((node, state)) = queue.pop_front() {
            work += work_per_state;
            (self.source).check_size("steps of the search", work, MAX_WORK)?;
            for (i, action) in self.actions.iter().enumerate() {
                if !action.preconditions.iter().all(|&fact| holds(&state, fact)) {
                    continue;
                }
                work += state.len() + action.add.len() + action.delete.len();
                let next = apply(action, &state);
                if seen.contains(&next) {
                    continue;
                }
                came_by.push((node, i));
                if reached(&next) {
                    return Ok(Some(self.steps(&came_by)));
                }
                self.source
                    .check_size("number of states", came_by.len(), MAX_STATES)?;
                seen.insert(next.clone());
                queue.push_back((came_by.len() - 1, next));
            }
        }
        Ok(None)
    }

    /// The actions that led to the last state.
    fn steps(&self, came_by: &[(usize, usize)]) -> Vec<Step> {
        let mut steps = Vec::new();
        let mut node = came_by.len() - 1;
        while node != 0 {
            let (before, action) = came_by[node];
            let action = &self.actions[action];
            steps.push(Step {
                action: self.domain.schemas[action.schema].name.clone(),
                arguments: (action.binding.iter())
                    .map(|&object| self.objects[object].0.to_owned())
                    .collect(),
            });
            node = before;
        }
        steps.reverse();
        steps
    }

    /// For each part of the goal that can't be reached: the preconditions of the actions leading
    /// there that nothing meets.
    pub(super) fn unmet_preconditions(&self) -> Vec<String> {
        let mut unmet = Vec::new();
        for goal in self.goal.iter().filter(|fact| !self.is_reachable(fact)) {
            let mut achievable = false;
            for schema in &self.domain.schemas {
                for binding in (schema.add.iter()).filter_map(|add| self.unify(schema, add, goal)) {
                    achievable = true;
                    unmet.extend(self.unmet_by(schema, &binding));
                }
            }
            if !achievable {
                let arguments = goal.arguments.iter().map(|&object| self.objects[object].0);
                let goal = atom_text(&self.domain.predicates[goal.predicate].name, arguments);
                unmet.push(format!("no action brings about {goal}"));
            }
        }
        unmet.sort();
        unmet.dedup();
        unmet
    }

    /// Binds parameters so that an effect becomes the goal.
    fn unify(
        &self,
        schema: &Schema,
        effect: &Pattern,
        goal: &Fact,
    ) -> Option<Vec<Option<ObjectId>>> {
        if effect.predicate != goal.predicate {
            return None;
        }
        let mut binding = vec![None; schema.parameters.len()];
        for (&term, &object) in effect.arguments.iter().zip(&goal.arguments) {
            match term {
                Term::Constant(constant) if constant == object => {}
                Term::Constant(_) => return None,
                Term::Parameter(i) => {
                    let type_id = schema.parameters[i].type_id;
                    let fits = self.domain.is_a(self.objects[object].1, type_id);
                    if !fits || binding[i].is_some_and(|bound| bound != object) {
                        return None;
                    }
                    binding[i] = Some(object);
                }
            }
        }
        Some(binding)
    }

    fn unmet_by(&self, schema: &Schema, binding: &[Option<ObjectId>]) -> Vec<String> {
        let object = |term: Term| match term {
            Term::Constant(constant) => Some(constant),
            Term::Parameter(i) => binding[i],
        };
        let met = |pattern: &Pattern| {
            let candidates = self.init.iter().chain(self.facts.keys());
            candidates
                .filter(|fact| fact.predicate == pattern.predicate && self.is_reachable(fact))
                .any(|fact| {
                    let mut pairs = pattern.arguments.iter().zip(&fact.arguments);
                    pairs.all(|(&term, &found)| object(term).is_none_or(|wanted| wanted == found))
                })
        };
        (schema.preconditions.iter())
            .filter(|pattern| !met(pattern))
            .map(|pattern| {
                let arguments = pattern
                    .arguments
                    .iter()
                    .map(|&term| match (object(term), term) {
                        (Some(object), _) => self.objects[object].0,
                        (None, Term::Parameter(i)) => &schema.parameters[i].name,
                        (None, Term::Constant(_)) => "?",
                    });
                let name = &self.domain.predicates[pattern.predicate].name;
                format!("{} needs {}", schema.name, atom_text(name, arguments))
            })
            .collect()
    }
}

fn atom_text<'a>(name: &str, arguments: impl Iterator<Item = &'a str>) -> String {
    let mut text = String::new();
    write_atom(&mut text, name, arguments).expect("a String takes whatever is written");
    text
}

fn apply(action: &GroundAction, state: &State) -> State {
    let mut next = state.to_vec();
    for &fact in &action.delete {
        next[fact / 64] &= !(1 << (fact % 64));
    }
    for &fact in &action.add {
        next[fact / 64] |= 1 << (fact % 64);
    }
    next.into()
}

/// How many parameters must be bound before the pattern is ground.
fn bound_at(pattern: &Pattern) -> usize {
    let parameters = pattern.arguments.iter().map(|term| match term {
        Term::Parameter(i) => i + 1,
        Term::Constant(_) => 0,
    });
    parameters.max().unwrap_or(0)
}

fn ground(pattern: &Pattern, binding: &[ObjectId]) -> Fact {
    let arguments = pattern.arguments.iter().map(|&term| match term {
        Term::Parameter(i) => binding[i],
        Term::Constant(constant) => constant,
    });
    Fact {
        predicate: pattern.predicate,
        arguments: arguments.collect(),
    }
}
