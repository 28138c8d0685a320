//! Search for a plan of least cost, on grounded actions.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap, HashMap};

use super::GoalError;
use super::domain::{Domain, Schema};
use super::form::Source;
use super::syntax::{Atom, Literal};

/// Name in errors of the planning problem.
const DERIVED: &str = "problem derived from the goal";
/// Largest number of search steps for binding actions, and for a search without costs: objects tried, facts checked and actions
/// tried. Each of the two takes about a second.
const MAX_WORK: usize = 5_000_000;
/// Largest number of search steps on numbered facts with costs, which are faster.
const MAX_COSTED_WORK: usize = 100_000_000;

/// A predicate or an action with its arguments, all of which are objects.
pub(super) type Fact<'a> = Vec<&'a str>;

/// An action with the bindings of its parameters.
type Bound<'a> = (&'a Schema, Vec<&'a str>);

/// Formats a fact as PDDL does: `(name argument ...)`.
pub(super) fn format_fact(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    format!("({})", words.join(" "))
}

/// The costs of steps, which may depend on where the step before it ended.
pub(super) trait StepCosts {
    /// Cost of a step that begins at a place, at least that of [`Self::least`], and the place at which it ends.
    fn cost(&self, step: &[&str], place: usize) -> (f64, usize);
    /// Least cost of a step at any place; `None` if the step is impossible.
    fn least(&self, step: &[&str]) -> Option<f64>;
    /// Whether every step costs the same.
    fn is_unit(&self) -> bool {
        false
    }
}

/// Equal costs of all steps, with a lower bound of 0: the search is breadth-first.
struct UnitCosts;

impl StepCosts for UnitCosts {
    fn cost(&self, _: &[&str], place: usize) -> (f64, usize) {
        (1.0, place)
    }

    fn least(&self, _: &[&str]) -> Option<f64> {
        Some(0.0)
    }

    fn is_unit(&self) -> bool {
        true
    }
}

/// Objects, initial facts and goal of a planning problem.
pub(super) struct Problem<'a> {
    pub(super) domain: &'a Domain,
    /// Names with their types, the domain's constants among them.
    pub(super) objects: Vec<(&'a str, &'a str)>,
    pub(super) init: BTreeSet<Fact<'a>>,
    /// Facts, and whether each is to hold.
    pub(super) goal: Vec<(bool, Fact<'a>)>,
}

/// An action without parameters, on numbered facts.
struct GroundAction<'a> {
    step: Fact<'a>,
    needs: Vec<usize>,
    excludes: Vec<usize>,
    adds: Vec<usize>,
    deletes: Vec<usize>,
    /// Least cost at any place.
    least: f64,
}

/// A set of numbered facts.
type Facts = Box<[u64]>;

/// A reached state.
struct Node {
    facts: Facts,
    place: usize,
    cost: f64,
    /// The node before it, and the action between them; `None` at the start.
    came_by: Option<(usize, usize)>,
}

/// A problem with numbered facts and actions without parameters.
struct GroundProblem<'a> {
    actions: Vec<GroundAction<'a>>,
    start: Facts,
    /// Facts of the goal, whether each is to hold, and a lower bound of the cost of reaching it. An action that reaches several of
    /// them shares its cost among them.
    goal: Vec<(usize, bool, f64)>,
    /// Whether no action changes a fact of the goal that does not have the wanted value.
    is_out_of_reach: bool,
}

impl<'a> Problem<'a> {
    /// Rejects facts that do not fit the domain's predicates.
    pub(super) fn check(&self) -> Result<(), GoalError> {
        let goal = self.goal.iter().map(|(_, fact)| fact);
        for fact in self.init.iter().chain(goal) {
            let source = Source {
                name: DERIVED,
                text: &format_fact(fact),
            };
            let known = || self.objects.iter().copied();
            self.domain.check(source, 0, fact, "object", known)?;
        }
        Ok(())
    }

    /// Returns the actions of a shortest plan; `None` if there is none. Of several shortest plans,
    /// it is the first in the order of the domain's actions and the problem's objects.
    pub(super) fn shortest_plan(&self) -> Result<Option<Vec<Fact<'a>>>, GoalError> {
        self.cheapest_plan(&UnitCosts, 0)
    }

    /// Returns the actions of a plan of least cost that begins at `place`; `None` if there is none. Of several, it is the
    /// first that the search meets, which depends on the order of actions and objects only.
    pub(super) fn cheapest_plan(
        &self,
        costs: &dyn StepCosts,
        place: usize,
    ) -> Result<Option<Vec<Fact<'a>>>, GoalError> {
        let mut work = 0;
        let reachable = self.find_reachable_facts(Some(costs), &mut work)?;
        let is_reachable = |(holds, fact): &(bool, Fact<'a>)| !holds || reachable.contains(fact);
        if !self.goal.iter().all(is_reachable) {
            return Ok(None);
        }
        let ground = self.ground(&reachable, costs, &mut work)?;
        let found = ground.search(costs, place)?;
        Ok(found.map(|steps| {
            let steps = steps.into_iter();
            steps
                .map(|index| ground.actions[index].step.clone())
                .collect()
        }))
    }

    /// Numbers the facts that actions change, and binds the actions. `reachable`: the facts that can become true; `work`: number
    /// of search steps so far.
    fn ground(
        &self,
        reachable: &BTreeSet<Fact<'a>>,
        costs: &dyn StepCosts,
        work: &mut usize,
    ) -> Result<GroundProblem<'a>, GoalError> {
        let bound = self.list_applicable_actions(reachable, work)?;
        let of = |literals: &'a [Literal], holds, (schema, binding): &Bound<'a>| -> Vec<Fact<'a>> {
            let chosen = literals
                .iter()
                .filter(move |literal| literal.holds == holds);
            chosen
                .flat_map(|literal| self.list_instances(literal, schema, binding))
                .collect()
        };
        // Facts that no action changes need no number: they hold if they hold initially.
        let changed: BTreeSet<Fact<'a>> = (bound.iter())
            .flat_map(|action| [true, false].map(|holds| of(&action.0.effects, holds, action)))
            .flatten()
            .filter(|fact| reachable.contains(fact))
            .collect();
        let number: BTreeMap<&Fact<'a>, usize> = changed.iter().zip(0..).collect();
        let numbers = |facts: Vec<Fact<'a>>| -> Vec<usize> {
            let numbers = facts.iter().filter_map(|fact| number.get(fact).copied());
            numbers.collect()
        };
        let mut actions = Vec::new();
        for action in &bound {
            let (schema, binding) = action;
            let step: Fact<'a> = std::iter::once(schema.name.as_str())
                .chain(binding.iter().copied())
                .collect();
            let excluded = of(&schema.preconditions, false, action);
            let never = excluded
                .iter()
                .any(|fact| !changed.contains(fact) && self.init.contains(fact));
            let Some(least) = costs.least(&step).filter(|_| !never) else {
                continue;
            };
            actions.push(GroundAction {
                needs: numbers(of(&schema.preconditions, true, action)),
                excludes: numbers(excluded),
                adds: numbers(of(&schema.effects, true, action)),
                deletes: numbers(of(&schema.effects, false, action)),
                step,
                least,
            });
        }
        let mut start = vec![0; changed.len().div_ceil(64)].into_boxed_slice();
        numbers(self.init.iter().cloned().collect())
            .iter()
            .for_each(|&fact| set(&mut start, fact, true));
        // Other facts of the goal are as they should be, or the goal cannot be reached.
        let is_out_of_reach = (self.goal.iter())
            .any(|(holds, fact)| !changed.contains(fact) && self.init.contains(fact) != *holds);
        let goal: Vec<(usize, bool)> = (self.goal.iter())
            .filter_map(|(holds, fact)| Some((*number.get(fact)?, *holds)))
            .collect();
        let brings = |action: &GroundAction<'_>, (fact, holds): (usize, bool)| {
            let effects = if holds { &action.adds } else { &action.deletes };
            effects.contains(&fact)
        };
        let goal = (goal.iter())
            .map(|&(fact, holds)| {
                let ways = actions
                    .iter()
                    .filter(|action| brings(action, (fact, holds)));
                let shares = ways.map(|action| {
                    let all = goal.iter().filter(|&&other| brings(action, other)).count();
                    action.least / all as f64
                });
                (fact, holds, shares.fold(f64::INFINITY, f64::min))
            })
            .collect();
        Ok(GroundProblem {
            actions,
            start,
            goal,
            is_out_of_reach,
        })
    }

    /// Returns all facts that can become true if no action deletes any and every negative precondition holds (delete
    /// relaxation). Steps without costs are left out.
    fn find_reachable_facts(
        &self,
        costs: Option<&dyn StepCosts>,
        work: &mut usize,
    ) -> Result<BTreeSet<Fact<'a>>, GoalError> {
        let mut facts = self.init.clone();
        loop {
            let before = facts.len();
            for (schema, binding) in self.list_applicable_actions(&facts, work)? {
                let step: Fact<'a> = std::iter::once(schema.name.as_str())
                    .chain(binding.iter().copied())
                    .collect();
                if costs.is_some_and(|costs| costs.least(&step).is_none()) {
                    continue;
                }
                facts.extend(
                    schema
                        .added()
                        .flat_map(|add| self.list_instances(add, schema, &binding)),
                );
            }
            if facts.len() == before {
                return Ok(facts);
            }
        }
    }

    /// Returns the facts of a literal: one, or one for each binding of the variables of `forall`, as far as the conditions of
    /// `when` hold initially.
    pub(super) fn list_instances(
        &self,
        literal: &'a Literal,
        schema: &Schema,
        binding: &[&'a str],
    ) -> Vec<Fact<'a>> {
        // Each fact with its conditions, all of which have the same variables.
        let atoms = std::iter::once(&literal.atom).chain(&literal.conditions);
        let mut facts: Vec<Vec<Fact<'a>>> =
            vec![atoms.map(|atom| ground(atom, schema, binding)).collect()];
        for variable in &literal.variables {
            let objects: Vec<&'a str> = (self.objects.iter())
                .filter(|(_, type_name)| self.domain.is_a(type_name, &variable.type_name))
                .map(|(object, _)| *object)
                .collect();
            let replace = |fact: &Fact<'a>, object: &'a str| -> Fact<'a> {
                let words = fact.iter();
                words
                    .map(|&word| if word == variable.name { object } else { word })
                    .collect()
            };
            let bound = facts.iter().flat_map(|atoms| {
                let with = |&object| atoms.iter().map(|fact| replace(fact, object)).collect();
                objects.iter().map(with)
            });
            facts = bound.collect();
        }
        facts.retain(|atoms| {
            atoms[1..]
                .iter()
                .all(|condition| self.init.contains(condition))
        });
        let facts = facts.into_iter();
        facts.map(|mut atoms| atoms.swap_remove(0)).collect()
    }

    /// Returns the actions whose positive preconditions hold.
    fn list_applicable_actions(
        &self,
        facts: &BTreeSet<Fact<'a>>,
        work: &mut usize,
    ) -> Result<Vec<Bound<'a>>, GoalError> {
        let mut bound = Vec::new();
        for schema in &self.domain.schemas {
            self.bind((schema, list_unbound(schema)), 0, facts, work, &mut bound)?;
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
        let needed = schema.preconditions.iter().filter(|literal| literal.holds);
        for literal in needed {
            let instances = self.list_instances(literal, schema, &binding);
            spend(work, instances.len() - usize::from(!instances.is_empty()))?;
            let mut instances = instances.iter();
            if !instances.all(|fact| fact.iter().any(|word| is_open(word)) || facts.contains(fact))
            {
                return Ok(());
            }
        }
        let Some(parameter) = schema.parameters.get(next) else {
            spend(work, schema.effects.len())?;
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
        let facts = self.find_reachable_facts(None, &mut 0)?;
        let mut unmet = BTreeSet::new();
        let goals = self
            .goal
            .iter()
            .filter(|(holds, fact)| *holds && !facts.contains(fact));
        for (_, goal) in goals {
            let schemas = self.domain.schemas.iter();
            let effects =
                schemas.flat_map(|schema| schema.added().map(move |add| (schema, &add.atom)));
            let ways = effects.filter_map(|(schema, add)| self.unify(schema, add, goal));
            let ways: Vec<Bound<'_>> = ways.collect();
            if ways.is_empty() {
                unmet.insert(format!("no action brings about {}", format_fact(goal)));
            }
            for (schema, binding) in ways {
                let needed = schema.preconditions.iter().filter(|literal| literal.holds);
                for wanted in
                    needed.flat_map(|literal| self.list_instances(literal, schema, &binding))
                {
                    if !facts.iter().any(|fact| is_instance(fact, &wanted)) {
                        unmet.insert(format!("{} needs {}", schema.name, format_fact(&wanted)));
                    }
                }
            }
        }
        Ok(unmet.into_iter().collect())
    }

    /// Returns what keeps actions that lead to the goal from being carried out: facts that may not hold, and that no possible
    /// action removes.
    pub(super) fn list_obstacles(&self, costs: &dyn StepCosts) -> Result<Vec<String>, GoalError> {
        let mut work = 0;
        let reachable = self.find_reachable_facts(Some(costs), &mut work)?;
        let mut removed: BTreeSet<Fact<'a>> = BTreeSet::new();
        for (schema, binding) in self.list_applicable_actions(&reachable, &mut work)? {
            let step = std::iter::once(schema.name.as_str()).chain(binding.iter().copied());
            if costs.least(&step.collect::<Fact<'a>>()).is_some() {
                let deleted = schema.effects.iter().filter(|effect| !effect.holds);
                removed.extend(deleted.flat_map(|one| self.list_instances(one, schema, &binding)));
            }
        }
        let mut obstacles = BTreeSet::new();
        for (_, goal) in self.goal.iter().filter(|(holds, _)| *holds) {
            let schemas = self.domain.schemas.iter();
            let effects =
                schemas.flat_map(|schema| schema.added().map(move |add| (schema, &add.atom)));
            for (schema, binding) in
                effects.filter_map(|(schema, add)| self.unify(schema, add, goal))
            {
                let excluded = schema.preconditions.iter().filter(|literal| !literal.holds);
                let patterns =
                    excluded.flat_map(|literal| self.list_instances(literal, schema, &binding));
                for pattern in patterns {
                    let found = self
                        .init
                        .iter()
                        .filter(|fact| is_instance(fact, &pattern) && !removed.contains(*fact));
                    obstacles.extend(
                        found.map(|fact| {
                            format!("{} needs (not {})", schema.name, format_fact(fact))
                        }),
                    );
                }
            }
        }
        Ok(obstacles.into_iter().collect())
    }

    /// Binds parameters so that an effect equals the goal; the remaining parameters stay unbound.
    fn unify(&self, schema: &'a Schema, effect: &'a Atom, goal: &Fact<'a>) -> Option<Bound<'a>> {
        let mut binding = list_unbound(schema);
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

impl GroundProblem<'_> {
    /// Returns the numbers of the actions of a plan of least cost (A*). The least costs of the parts of the goal that are
    /// still open never exceed the cost of the remaining steps, because actions that bring about several share their cost.
    fn search(&self, costs: &dyn StepCosts, place: usize) -> Result<Option<Vec<usize>>, GoalError> {
        if self.is_out_of_reach {
            return Ok(None);
        }
        let mut work = 0;
        let limit = if costs.is_unit() {
            MAX_WORK
        } else {
            MAX_COSTED_WORK
        };
        let mut nodes = vec![Node {
            facts: self.start.clone(),
            place,
            cost: 0.0,
            came_by: None,
        }];
        let mut best = HashMap::from([((self.start.clone(), place), 0.0)]);
        let mut queue =
            BinaryHeap::from([Reverse((Cost(self.bound_remaining_cost(&self.start)), 0))]);
        while let Some(Reverse((_, index))) = queue.pop() {
            let Node {
                facts, place, cost, ..
            } = &nodes[index];
            let (facts, place, cost) = (facts.clone(), *place, *cost);
            if self
                .goal
                .iter()
                .all(|&(fact, holds, _)| has(&facts, fact) == holds)
            {
                let back =
                    std::iter::successors(nodes[index].came_by, |(node, _)| nodes[*node].came_by);
                let mut steps: Vec<usize> = back.map(|(_, action)| action).collect();
                steps.reverse();
                return Ok(Some(steps));
            }
            if best
                .get(&(facts.clone(), place))
                .is_some_and(|&least| least < cost)
            {
                continue;
            }
            spend_within(limit, &mut work, self.actions.len())?;
            for (action, number) in self.actions.iter().zip(0..) {
                if !action.applies(&facts) {
                    continue;
                }
                spend_within(limit, &mut work, facts.len() + 1)?;
                let next = action.apply(&facts);
                let (step, place) = costs.cost(&action.step, place);
                let cost = cost + step;
                let key = (next.clone(), place);
                if best.get(&key).is_some_and(|&least| least <= cost) {
                    continue;
                }
                best.insert(key, cost);
                let estimate = cost + self.bound_remaining_cost(&next);
                nodes.push(Node {
                    facts: next,
                    place,
                    cost,
                    came_by: Some((index, number)),
                });
                if estimate.is_finite() {
                    queue.push(Reverse((Cost(estimate), nodes.len() - 1)));
                }
            }
        }
        Ok(None)
    }

    /// Returns a lower bound of the cost from a state to the goal.
    fn bound_remaining_cost(&self, facts: &Facts) -> f64 {
        let open = self
            .goal
            .iter()
            .filter(|&&(fact, holds, _)| has(facts, fact) != holds);
        open.map(|(_, _, least)| least).sum()
    }
}

impl GroundAction<'_> {
    fn applies(&self, facts: &Facts) -> bool {
        self.needs.iter().all(|&fact| has(facts, fact))
            && !self.excludes.iter().any(|&fact| has(facts, fact))
    }

    fn apply(&self, facts: &Facts) -> Facts {
        let mut next = facts.clone();
        self.deletes
            .iter()
            .for_each(|&fact| set(&mut next, fact, false));
        self.adds
            .iter()
            .for_each(|&fact| set(&mut next, fact, true));
        next
    }
}

fn has(facts: &Facts, fact: usize) -> bool {
    facts[fact / 64] >> (fact % 64) & 1 == 1
}

fn set(facts: &mut Facts, fact: usize, holds: bool) {
    let bit = 1 << (fact % 64);
    if holds {
        facts[fact / 64] |= bit;
    } else {
        facts[fact / 64] &= !bit;
    }
}

/// A cost with a total order.
#[derive(Debug, Clone, Copy)]
struct Cost(f64);

impl PartialEq for Cost {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cost {}

impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

fn spend(work: &mut usize, more: usize) -> Result<(), GoalError> {
    spend_within(MAX_WORK, work, more)
}

fn spend_within(limit: usize, work: &mut usize, more: usize) -> Result<(), GoalError> {
    *work += more;
    let source = Source {
        name: DERIVED,
        text: "",
    };
    source.check_size("steps of the search", *work, limit)
}

/// Returns a binding in which every parameter has its own name.
fn list_unbound(schema: &Schema) -> Vec<&str> {
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
