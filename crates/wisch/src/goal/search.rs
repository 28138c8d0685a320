//! Breadth-first forward search.

use std::collections::{BTreeSet, HashSet, VecDeque};
use std::rc::Rc;

use super::GoalError;
use super::domain::{Domain, Schema};
use super::form::Source;
use super::syntax::Atom;

/// Name in errors of the planning problem.
const DERIVED: &str = "problem derived from the goal";
/// Largest work of a search: number of objects tried, facts checked and facts copied; about a
/// second.
const MAX_WORK: usize = 5_000_000;

/// A predicate or an action with its arguments, all of which are objects.
pub(super) type Fact<'a> = Vec<&'a str>;

/// An action with the bindings of its parameters.
type Bound<'a> = (&'a Schema, Vec<&'a str>);

/// Formats a fact as PDDL does: `(name argument ...)`.
pub(super) fn text(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    format!("({})", words.join(" "))
}

/// Objects, initial facts and goal of a planning problem.
pub(super) struct Problem<'a> {
    pub(super) domain: &'a Domain,
    /// Names with their types, the domain's constants among them.
    pub(super) objects: Vec<(&'a str, &'a str)>,
    pub(super) init: BTreeSet<Fact<'a>>,
    pub(super) goal: Vec<Fact<'a>>,
}

impl<'a> Problem<'a> {
    /// Rejects facts that do not fit the domain's predicates.
    pub(super) fn check(&self) -> Result<(), GoalError> {
        for fact in self.init.iter().chain(&self.goal) {
            let source = Source {
                name: DERIVED,
                text: &text(fact),
            };
            let known = || self.objects.iter().copied();
            self.domain.check(source, 0, fact, "object", known)?;
        }
        Ok(())
    }

    /// Returns the actions of a shortest plan; `None` if there is none. Of several shortest plans,
    /// it is the first in the order of the domain's actions and the problem's objects.
    pub(super) fn shortest_plan(&self) -> Result<Option<Vec<Fact<'a>>>, GoalError> {
        let mut work = 0;
        let reached =
            |state: &BTreeSet<Fact<'a>>| self.goal.iter().all(|fact| state.contains(fact));
        if !reached(&self.reachable(&mut work)?) {
            return Ok(None);
        }
        let first = Rc::new(self.init.clone());
        if reached(&first) {
            return Ok(Some(Vec::new()));
        }
        // Each state with its predecessor and the action between them.
        let mut came_by: Vec<(usize, Fact<'a>)> = vec![(0, Vec::new())];
        let mut seen = HashSet::from([first.clone()]);
        let mut queue = VecDeque::from([(0, first)]);
        while let Some((before, state)) = queue.pop_front() {
            for (schema, binding) in self.applicable(&state, &mut work)? {
                spend(&mut work, state.len())?;
                let mut next = BTreeSet::clone(&state);
                for delete in &schema.delete {
                    next.remove(&ground(delete, schema, &binding));
                }
                next.extend(schema.add.iter().map(|add| ground(add, schema, &binding)));
                if seen.contains(&next) {
                    continue;
                }
                let name = schema.name.as_str();
                came_by.push((before, std::iter::once(name).chain(binding).collect()));
                let node = came_by.len() - 1;
                if reached(&next) {
                    let nodes = std::iter::successors(Some(node), |&node| Some(came_by[node].0));
                    let back = nodes.take_while(|&node| node != 0);
                    let mut steps: Vec<_> = back.map(|node| came_by[node].1.clone()).collect();
                    steps.reverse();
                    return Ok(Some(steps));
                }
                let next = Rc::new(next);
                seen.insert(next.clone());
                queue.push_back((node, next));
            }
        }
        Ok(None)
    }

    /// Returns all facts that can become true if no action deletes any (delete relaxation).
    fn reachable(&self, work: &mut usize) -> Result<BTreeSet<Fact<'a>>, GoalError> {
        let mut facts = self.init.clone();
        loop {
            let before = facts.len();
            for (schema, binding) in self.applicable(&facts, work)? {
                facts.extend(schema.add.iter().map(|add| ground(add, schema, &binding)));
            }
            if facts.len() == before {
                return Ok(facts);
            }
        }
    }

    /// Returns the actions whose preconditions hold.
    fn applicable(
        &self,
        facts: &BTreeSet<Fact<'a>>,
        work: &mut usize,
    ) -> Result<Vec<Bound<'a>>, GoalError> {
        let mut bound = Vec::new();
        for schema in &self.domain.schemas {
            self.bind((schema, open(schema)), 0, facts, work, &mut bound)?;
        }
        Ok(bound)
    }

    /// Binds the parameters of an action from `next` on, and backtracks at the first precondition that does not hold.
    fn bind(
        &self,
        (schema, mut binding): Bound<'a>,
        next: usize,
        facts: &BTreeSet<Fact<'a>>,
        work: &mut usize,
        bound: &mut Vec<Bound<'a>>,
    ) -> Result<(), GoalError> {
        spend(work, 1 + schema.preconditions.len())?;
        let mut needed = (schema.preconditions.iter()).map(|p| ground(p, schema, &binding));
        if !needed.all(|fact| fact.iter().any(|word| is_open(word)) || facts.contains(&fact)) {
            return Ok(());
        }
        let Some(parameter) = schema.parameters.get(next) else {
            spend(work, schema.add.len() + schema.delete.len())?;
            bound.push((schema, binding));
            return Ok(());
        };
        spend(work, self.objects.len())?;
        for &(object, type_name) in &self.objects {
            if self.domain.is_a(type_name, &parameter.type_name) {
                binding[next] = object;
                self.bind((schema, binding.clone()), next + 1, facts, work, bound)?;
            }
        }
        Ok(())
    }

    /// Returns, for each unreachable part of the goal, the unmet preconditions of the actions that lead to it.
    pub(super) fn unmet_preconditions(&self) -> Result<Vec<String>, GoalError> {
        let facts = self.reachable(&mut 0)?;
        let mut unmet = BTreeSet::new();
        for goal in self.goal.iter().filter(|&fact| !facts.contains(fact)) {
            let schemas = self.domain.schemas.iter();
            let effects =
                schemas.flat_map(|schema| schema.add.iter().map(move |add| (schema, add)));
            let ways = effects.filter_map(|(schema, add)| self.unify(schema, add, goal));
            let ways: Vec<Bound<'_>> = ways.collect();
            if ways.is_empty() {
                unmet.insert(format!("no action brings about {}", text(goal)));
            }
            for (schema, binding) in ways {
                for precondition in &schema.preconditions {
                    let wanted = ground(precondition, schema, &binding);
                    if !facts.iter().any(|fact| is_instance(fact, &wanted)) {
                        unmet.insert(format!("{} needs {}", schema.name, text(&wanted)));
                    }
                }
            }
        }
        Ok(unmet.into_iter().collect())
    }

    /// Binds parameters so that an effect equals the goal; the remaining parameters stay unbound.
    fn unify(&self, schema: &'a Schema, effect: &'a Atom, goal: &Fact<'a>) -> Option<Bound<'a>> {
        let mut binding = open(schema);
        for (word, &object) in effect.words.iter().zip(goal) {
            if let Some(i) = schema.parameters.iter().position(|p| p.name == *word) {
                let type_name = &schema.parameters[i].type_name;
                let mut named = self.objects.iter().filter(|(name, _)| *name == object);
                named.find(|(_, found)| self.domain.is_a(found, type_name))?;
                binding[i] = object;
            }
        }
        (ground(effect, schema, &binding) == *goal).then_some((schema, binding))
    }
}

fn spend(work: &mut usize, more: usize) -> Result<(), GoalError> {
    *work += more;
    let source = Source {
        name: DERIVED,
        text: "",
    };
    source.check_size("steps of the search", *work, MAX_WORK)
}

/// Returns a binding in which every parameter has its own name.
fn open(schema: &Schema) -> Vec<&str> {
    schema.parameters.iter().map(|p| p.name.as_str()).collect()
}

/// Whether a word is an unbound parameter.
fn is_open(word: &str) -> bool {
    word.starts_with('?')
}

/// Whether a fact is an instance of a pattern with unbound parameters.
fn is_instance(fact: &[&str], pattern: &[&str]) -> bool {
    let mut pairs = fact.iter().zip(pattern);
    fact.len() == pattern.len() && pairs.all(|(found, wanted)| is_open(wanted) || found == wanted)
}

/// Returns an action's atom with its parameters replaced by their bindings.
fn ground<'a>(atom: &'a Atom, schema: &Schema, binding: &[&'a str]) -> Fact<'a> {
    let words = atom.words.iter().map(|word| {
        let parameter = schema.parameters.iter().position(|p| p.name == *word);
        parameter.map_or(word.as_str(), |i| binding[i])
    });
    words.collect()
}
