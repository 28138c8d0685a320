//! Compiler from terms to goals, which resolves all names once. Unsupported terms are left to the engine.

mod lookup;

use super::expression::{Binary, Comparison, Expression, Unary};
use super::goal::{Aggregate, Block, Goal};
use super::order::order_goals;
use super::value::{JoinValue, Pattern};
use crate::ask::streams::Knowledge;
use crate::ask::term::Term;
use std::collections::{HashMap, HashSet};

/// Largest number of goals, including nested ones; longer queries are left to the engine.
const MOST_GOALS: usize = 256;

/// A compiler of goals to a block that the solver runs.
pub struct Compiler<'a> {
    known: &'a Knowledge,
    numbers: HashMap<String, usize>,
    /// Whether each variable is certainly bound at this point.
    bound: Vec<bool>,
    goals: usize,
    /// Whether a variable may become an alias of another.
    may_alias: bool,
    /// Variables of the goals after the block that is being compiled.
    later: HashSet<String>,
}

impl<'a> Compiler<'a> {
    /// Creates a compiler of goals about these episodes.
    pub fn new(known: &'a Knowledge) -> Self {
        Self {
            known,
            numbers: HashMap::new(),
            bound: Vec::new(),
            goals: 0,
            may_alias: true,
            later: HashSet::new(),
        }
    }

    /// Number of variables that the goals share.
    pub fn len(&self) -> usize {
        self.bound.len()
    }

    /// Compiles a list of goals to a block; `None` if any goal is left to the engine.
    pub fn block(&mut self, goals: &Term) -> Option<Block> {
        let Term::List(terms) = goals else {
            return None;
        };
        self.goals += terms.len();
        if self.goals > MOST_GOALS {
            return None;
        }
        let before = self.bound.clone();
        let mut goals = Vec::with_capacity(terms.len());
        let outer = self.later.clone();
        for (place, term) in terms.iter().enumerate() {
            self.later.clone_from(&outer);
            for after in &terms[place + 1..] {
                names_in(after, &mut self.later);
            }
            // The engine reports which variable must be bound.
            (!self.depends_on_order(term)).then_some(())?;
            if let Some(goal) = self.goal(term)? {
                for variable in binds(&goal) {
                    self.bound[variable] = true;
                }
                goals.push(goal);
            }
        }
        self.later = outer;
        let is_bound = |variable: usize| before.get(variable).copied().unwrap_or_default();
        Some(order_goals(goals, is_bound, &self.known.catalogue))
    }

    /// Whether the answers of a goal would change if a variable were bound that only a later goal binds.
    fn depends_on_order(&self, term: &Term) -> bool {
        let (mut of, mut own) = (HashSet::new(), HashSet::new());
        match term.parts() {
            Some(("\\+" | "number", [of_goal])) => names_in(of_goal, &mut of),
            Some(("forall", [one, other])) => {
                names_in(one, &mut of);
                names_in(other, &mut of);
            }
            Some(("findall" | "aggregate_all", [template, goals, _])) => {
                names_in(goals, &mut of);
                names_in(template, &mut own);
            }
            _ => return false,
        }
        let is_open = |name: &String| {
            let number = self.numbers.get(name);
            number.is_none_or(|number| !self.bound[*number])
        };
        (of.difference(&own)).any(|name| self.later.contains(name) && is_open(name))
    }

    /// Compiles a block that leaves no variable bound.
    fn inner(&mut self, goals: &Term) -> Option<Block> {
        let (numbers, bound) = (self.numbers.clone(), self.bound.clone());
        let block = self.block(goals)?;
        self.leave(numbers, &bound);
        Some(block)
    }

    /// Restores the bindings and names of variables to an earlier state.
    fn leave(&mut self, numbers: HashMap<String, usize>, bound: &[bool]) {
        self.numbers = numbers;
        for (place, now) in self.bound.iter_mut().enumerate() {
            *now = bound.get(place).copied().unwrap_or_default();
        }
    }

    fn variable(&mut self, name: &str) -> usize {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = self.bound.len();
        self.bound.push(false);
        self.numbers.insert(name.to_owned(), number);
        number
    }

    /// Returns the pattern of a term.
    pub fn pattern(&mut self, term: &Term) -> Option<Pattern> {
        Some(match term {
            Term::Variable(name) => Pattern::Variable(self.variable(name)),
            Term::List(items) if !is_ground(term) => {
                let items = items.iter().map(|item| self.pattern(item));
                Pattern::List(items.collect::<Option<_>>()?)
            }
            Term::Compound(name, items) if !is_ground(term) => {
                let items = items.iter().map(|item| self.pattern(item));
                Pattern::Compound(name.clone(), items.collect::<Option<_>>()?)
            }
            ground => Pattern::JoinValue(JoinValue::from_term(ground.clone())),
        })
    }

    fn is_bound(&self, pattern: &Pattern) -> bool {
        let mut variables = Vec::new();
        pattern.variables(&mut variables);
        variables.into_iter().all(|variable| self.bound[variable])
    }

    /// Returns the pattern of a variable, or of the thing with this name.
    fn thing(&mut self, term: &Term) -> Option<Pattern> {
        match term {
            Term::Variable(name) => Some(Pattern::Variable(self.variable(name))),
            ground if is_ground(ground) => Some(Pattern::JoinValue(thing_of(self.known, ground)?)),
            _ => None,
        }
    }

    /// Returns the pattern of a variable, thing or value.
    fn object(&mut self, term: &Term) -> Option<Pattern> {
        match term {
            Term::Variable(_) => self.thing(term),
            ground if is_ground(ground) => Some(Pattern::JoinValue(object_of(self.known, ground))),
            _ => None,
        }
    }

    /// Compiles a thing; `None` for a variable that may be unbound.
    fn require_bound_thing(&mut self, term: &Term) -> Option<Pattern> {
        let thing = self.thing(term)?;
        self.is_bound(&thing).then_some(thing)
    }

    /// Compiles a pattern; `None` if a variable in it may be unbound.
    fn require_bound_pattern(&mut self, term: &Term) -> Option<Pattern> {
        let pattern = self.pattern(term)?;
        self.is_bound(&pattern).then_some(pattern)
    }

    /// Compiles a term to a goal; the inner `None` stands for a goal that always holds.
    fn goal(&mut self, term: &Term) -> Option<Option<Goal>> {
        let (name, arguments) = term.parts()?;
        match (name, arguments) {
            ("true", []) => Some(None),
            ("episode", [episode, name]) => self.name_episode(episode, name),
            ("thing", [thing, name]) => {
                let thing = self.thing(thing)?;
                self.alias(thing, name)
            }
            ("known", [Term::Atom(kind), thing, name]) if kind == "thing" => {
                let thing = self.require_bound_thing(thing)?;
                self.alias(thing, name)
            }
            ("=", [left @ Term::Variable(_), right @ Term::Variable(_)]) => {
                let left = self.pattern(left)?;
                self.alias(left, right)
            }
            _ => self.compile_condition(name, arguments).map(Some),
        }
    }

    /// Compiles a goal that calculates, compares or iterates over solutions; other goals look facts up.
    fn compile_condition(&mut self, name: &str, arguments: &[Term]) -> Option<Goal> {
        Some(match (name, arguments) {
            ("=", [left, right]) => Goal::Same(self.pattern(left)?, self.pattern(right)?),
            ("is", [result, expression]) => {
                let expression = self.expression(expression)?;
                Goal::Is(self.pattern(result)?, expression)
            }
            (_, [left, right]) if Comparison::from_name(name).is_some() => Goal::Comparison(
                Comparison::from_name(name)?,
                self.expression(left)?,
                self.expression(right)?,
            ),
            ("number", [value]) => Goal::Number(self.pattern(value)?),
            ("length", [list, len]) => {
                Goal::Length(self.require_bound_pattern(list)?, self.pattern(len)?)
            }
            ("\\+", [goals]) => Goal::Not(self.inner(goals)?),
            ("forall", [Term::List(goals), then]) => {
                let not = Term::compound("\\+", [then.clone()]);
                let all = goals.iter().cloned().chain([not]).collect();
                Goal::Not(self.inner(&Term::List(all))?)
            }
            ("either", [Term::List(branches)]) => self.either(branches)?,
            ("once", [goals]) => {
                let may_alias = std::mem::replace(&mut self.may_alias, false);
                let block = self.block(goals);
                self.may_alias = may_alias;
                Goal::Once(block?)
            }
            ("findall", [template, goals, result]) => {
                self.over(&Term::compound("bag", [template.clone()]), goals, result)?
            }
            ("aggregate_all", [kind, goals, result]) => self.over(kind, goals, result)?,
            ("mean_by", [key, number, goals, of, mean, count]) => {
                self.compile_means([key, number], goals, [of, mean, count])?
            }
            _ => self.compile_lookup(name, arguments)?,
        })
    }

    /// Compiles `episode/2`: an alias of a known thing, or any wiping episode under both names.
    fn name_episode(&mut self, episode: &Term, name: &Term) -> Option<Option<Goal>> {
        let thing = self.thing(episode)?;
        let is_bound = self.is_bound(&thing);
        match self.alias(thing, name)? {
            same if is_bound => Some(same),
            None => self.class(episode, "semco:WipingEpisode").map(Some),
            Some(_) => None,
        }
    }

    /// Makes a variable an alias of a pattern. If it is bound already, returns the goal that both are equal.
    fn alias(&mut self, pattern: Pattern, name: &Term) -> Option<Option<Goal>> {
        match (&pattern, name) {
            (Pattern::Variable(number), Term::Variable(name))
                if self.may_alias && !self.numbers.contains_key(name) =>
            {
                self.numbers.insert(name.clone(), *number);
                Some(None)
            }
            _ => {
                let other = self.pattern(name)?;
                if pattern == other {
                    return Some(None);
                }
                let are_known = self.is_bound(&pattern) || self.is_bound(&other);
                are_known.then_some(Some(Goal::Same(pattern, other)))
            }
        }
    }

    /// Compiles alternatives. A variable is bound afterwards if every alternative binds it.
    fn either(&mut self, branches: &[Term]) -> Option<Goal> {
        let may_alias = std::mem::replace(&mut self.may_alias, false);
        let before = self.bound.clone();
        let was_bound = |place: usize| before.get(place).copied().unwrap_or_default();
        let (mut blocks, mut bound) = (Vec::new(), Vec::new());
        for branch in branches {
            blocks.push(self.block(branch)?);
            bound.push(self.bound.clone());
            for (place, now) in self.bound.iter_mut().enumerate() {
                *now = was_bound(place);
            }
        }
        for (place, now) in self.bound.iter_mut().enumerate() {
            *now |= bound.iter().all(|branch| branch.get(place) == Some(&true));
        }
        self.may_alias = may_alias;
        Some(Goal::Either(blocks))
    }

    fn over(&mut self, kind: &Term, goals: &Term, result: &Term) -> Option<Goal> {
        let (numbers, bound) = (self.numbers.clone(), self.bound.clone());
        let block = self.block(goals)?;
        let aggregate = match kind.parts()? {
            ("count", []) => Aggregate::Count,
            ("bag", [of]) => Aggregate::All(self.pattern(of)?),
            ("set", [of]) => Aggregate::Set(self.pattern(of)?),
            ("sum", [of]) => Aggregate::Sum(self.expression(of)?),
            ("mean", [of]) => Aggregate::Mean(self.expression(of)?),
            (extreme @ ("max" | "min"), [of]) => Aggregate::Extreme {
                is_max: extreme == "max",
                of: self.expression(of)?,
                witness: None,
            },
            (extreme @ ("max" | "min"), [of, witness]) => Aggregate::Extreme {
                is_max: extreme == "max",
                of: self.expression(of)?,
                witness: Some(self.pattern(witness)?),
            },
            _ => return None,
        };
        self.leave(numbers, &bound);
        let result = self.pattern(result)?;
        Some(Goal::Over {
            block,
            aggregate,
            result,
        })
    }

    /// Compiles `mean_by/6`.
    fn compile_means(
        &mut self,
        [key, number]: [&Term; 2],
        goals: &Term,
        [of, mean, count]: [&Term; 3],
    ) -> Option<Goal> {
        let (numbers, bound) = (self.numbers.clone(), self.bound.clone());
        // Values that are known for the key restrict the goals.
        let block = self.block(goals)?;
        let (key, number) = (self.pattern(key)?, self.pattern(number)?);
        self.leave(numbers, &bound);
        Some(Goal::MeanByKey {
            block,
            key,
            number,
            result: [self.pattern(of)?, self.pattern(mean)?, self.pattern(count)?],
        })
    }

    fn expression(&mut self, term: &Term) -> Option<Expression> {
        let binary = |name: &str| {
            Some(match name {
                "+" => Binary::Plus,
                "-" => Binary::Minus,
                "*" => Binary::Times,
                "/" => Binary::Over,
                _ => return None,
            })
        };
        let unary = |name: &str| {
            Some(match name {
                "-" => Unary::Minus,
                "abs" => Unary::Absolute,
                "truncate" => Unary::Truncate,
                _ => return None,
            })
        };
        Some(match term {
            Term::Variable(_) | Term::Integer(_) | Term::Float(_) => {
                Expression::Pattern(self.pattern(term)?)
            }
            Term::Compound(name, arguments) => match arguments.as_slice() {
                [of] => Expression::Unary(unary(name)?, Box::new(self.expression(of)?)),
                [left, right] => {
                    let left = Box::new(self.expression(left)?);
                    Expression::Binary(binary(name)?, left, Box::new(self.expression(right)?))
                }
                _ => return None,
            },
            _ => return None,
        })
    }
}

/// Returns the variables that a goal binds.
fn binds(goal: &Goal) -> Vec<usize> {
    let mut found = Vec::new();
    match goal {
        Goal::Not(_) | Goal::Either(_) => {}
        Goal::Over { result, .. } => result.variables(&mut found),
        Goal::MeanByKey { result, .. } => {
            for pattern in result {
                pattern.variables(&mut found);
            }
        }
        Goal::Once(block) => found.clone_from(&block.binds),
        other => found = other.variables(),
    }
    found
}

/// Collects the names of a term's variables.
fn names_in(term: &Term, found: &mut HashSet<String>) {
    match term {
        Term::Variable(name) => {
            found.insert(name.clone());
        }
        Term::Compound(_, items) | Term::List(items) => {
            items.iter().for_each(|item| names_in(item, found));
        }
        Term::Atom(_) | Term::Integer(_) | Term::Float(_) => {}
    }
}

/// Whether a term has no variable.
pub fn is_ground(term: &Term) -> bool {
    match term {
        Term::Variable(_) => false,
        Term::Compound(_, items) | Term::List(items) => items.iter().all(is_ground),
        Term::Atom(_) | Term::Integer(_) | Term::Float(_) => true,
    }
}

/// Returns the thing with a name, if there is one.
pub fn thing_of(known: &Knowledge, name: &Term) -> Option<JoinValue> {
    let name = known.names.resolve("thing", name).ok()?;
    Some(find_thing(known, name))
}

/// Returns the thing with this full name.
pub fn find_thing(known: &Knowledge, name: String) -> JoinValue {
    match known.names.node(&name) {
        Some(crate::catalogue::CatalogueNode::Individual(id)) => JoinValue::Individual(id),
        Some(crate::catalogue::CatalogueNode::Shared(number)) => JoinValue::Shared(number),
        None => JoinValue::Term(Term::Atom(name)),
    }
}

/// Returns the pattern of an object: a thing if the name is a thing's, otherwise a value.
pub fn object_of(known: &Knowledge, term: &Term) -> JoinValue {
    match term {
        Term::Integer(_) | Term::Float(_) => JoinValue::from_term(term.clone()),
        other => thing_of(known, other).unwrap_or_else(|| JoinValue::Term(other.clone())),
    }
}

fn atoms(terms: Vec<Term>) -> Vec<String> {
    let names = terms.into_iter();
    let names = names.filter_map(|term| match term {
        Term::Atom(name) => Some(name),
        _ => None,
    });
    names.collect()
}
