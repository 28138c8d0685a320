//! From terms to goals: what names mean is looked up here, once. What is beyond joins is left to the engine.

use super::expression::{Binary, Comparison, Expression, Unary};
use super::goal::{Aggregate, Block, Goal, Side, Source};
use super::order::ordered;
use super::value::{Pattern, Value};
use crate::ask::intervals::Relation;
use crate::ask::streams::Knowledge;
use crate::ask::term::Term;
use std::collections::{HashMap, HashSet};

/// Properties that hold the other way round of others, where one side is known: left to the engine.
const WITH_INVERSE: [&str; 4] = [
    "dul:isConstituentOf",
    "dul:isParticipantIn",
    "dul:isExecutedIn",
    "dul:classifies",
];
/// Most goals, nested ones counted: more are no question that a person asks.
const MOST_GOALS: usize = 256;

/// Makes goals of terms.
pub struct Compiler<'a> {
    known: &'a Knowledge,
    numbers: HashMap<String, usize>,
    /// Whether each variable surely holds something at this place.
    bound: Vec<bool>,
    goals: usize,
    /// Whether a variable may become another name of a second.
    may_alias: bool,
    /// Variables of the goals that follow the block being compiled.
    later: HashSet<String>,
}

impl<'a> Compiler<'a> {
    /// A compiler of goals about these episodes.
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

    /// How many variables there are.
    pub fn len(&self) -> usize {
        self.bound.len()
    }

    /// The block of a list of goals; `None` if any of them is left to the engine.
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
            // The engine says which variable has to be bound.
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
        Some(ordered(goals, is_bound, &self.known.catalogue))
    }

    /// Whether the answers of a goal would be others if a variable were bound that only a later goal binds.
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

    /// A block of which nothing is bound afterwards.
    fn inner(&mut self, goals: &Term) -> Option<Block> {
        let (numbers, bound) = (self.numbers.clone(), self.bound.clone());
        let block = self.block(goals)?;
        self.leave(numbers, &bound);
        Some(block)
    }

    /// Forgets what was bound, and the names of variables, since.
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

    /// What a term stands for.
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
            ground => Pattern::Value(Value::of(ground.clone())),
        })
    }

    fn is_bound(&self, pattern: &Pattern) -> bool {
        let mut variables = Vec::new();
        pattern.variables(&mut variables);
        variables.into_iter().all(|variable| self.bound[variable])
    }

    /// A variable, or the thing of this name.
    fn thing(&mut self, term: &Term) -> Option<Pattern> {
        match term {
            Term::Variable(name) => Some(Pattern::Variable(self.variable(name))),
            ground if is_ground(ground) => Some(Pattern::Value(thing_of(self.known, ground)?)),
            _ => None,
        }
    }

    /// The same; what is no thing is a value.
    fn object(&mut self, term: &Term) -> Option<Pattern> {
        match term {
            Term::Variable(_) => self.thing(term),
            ground if is_ground(ground) => Some(Pattern::Value(object_of(self.known, ground))),
            _ => None,
        }
    }

    /// The goal of a term; inside, `None` of one that always holds.
    #[allow(
        clippy::too_many_lines,
        reason = "one line or two for each kind of goal"
    )]
    fn goal(&mut self, term: &Term) -> Option<Option<Goal>> {
        let (name, arguments) = term.parts()?;
        let names = &self.known.names;
        Some(Some(match (name, arguments) {
            ("true", []) => return Some(None),
            ("instance_of", [thing, class]) => {
                let class = is_ground(class).then_some(class)?;
                let class = names.resolve("class", class).ok()?;
                self.class(thing, &class)?
            }
            ("is_a" | "of_class", [thing, Term::Atom(class)]) => self.class(thing, class)?,
            ("triple", [subject, property, object]) => {
                let is_plain = matches!(property, Term::Atom(_))
                    || matches!(property, Term::Compound(colon, _) if colon == ":");
                let property = (is_plain && is_ground(property)).then_some(property)?;
                let property = names.resolve("property", property).ok()?;
                match (property.as_str(), object) {
                    ("rdf:type", Term::Variable(_)) | ("rdfs:subClassOf", _) => return None,
                    ("rdf:type", class) => {
                        let class = names.resolve("class", class).ok()?;
                        self.class(subject, &class)?
                    }
                    _ => self.stated(subject, &property, object)?,
                }
            }
            ("stated", [subject, Term::Atom(property), object]) => {
                self.stated(subject, property, object)?
            }
            ("has_data_value", [thing, condition]) => self.has_data_value(thing, condition)?,
            ("value", [thing, Term::Atom(property), value]) => Goal::Statement {
                subject: self.thing(thing)?,
                object: self.pattern(value)?,
                sources: self.without_assertions(Source::Values {
                    property: property.clone(),
                    is_lenient: false,
                })?,
            },
            ("relation", [subject, Term::Atom(property), object]) => Goal::Statement {
                subject: self.thing(subject)?,
                object: self.thing(object)?,
                sources: self.without_assertions(Source::Relations(property.clone()))?,
            },
            ("part", [whole, part]) => Goal::Statement {
                subject: self.thing(whole)?,
                object: self.thing(part)?,
                sources: vec![Source::Parts],
            },
            ("timed", [event, start, end]) => Goal::Timed {
                event: self.thing(event)?,
                start: self.pattern(start)?,
                end: self.pattern(end)?,
            },
            ("related", [Term::Atom(relation), first, second]) => Goal::Related {
                relation: Relation::named(relation)?,
                first: self.side(first)?,
                second: self.side(second)?,
            },
            ("part_below", [whole, part, Term::Atom(class)]) => {
                let whole = self.thing(whole)?;
                let whole = self.is_bound(&whole).then_some(whole)?;
                let (part, classes) = (self.thing(part)?, self.classes(class));
                Goal::PartBelow {
                    whole,
                    part,
                    classes,
                }
            }
            ("above", [part, whole, Term::Atom(class)]) => {
                let part = self.thing(part)?;
                let part = self.is_bound(&part).then_some(part)?;
                let (whole, classes) = (self.thing(whole)?, self.classes(class));
                Goal::Above {
                    part,
                    whole,
                    classes,
                }
            }
            ("last_episode", [episode, time]) => Goal::LastEpisode {
                episode: self.thing(episode)?,
                time: self.pattern(time)?,
            },
            ("telemetry_in", [episode, channel, when, statistic, value]) => {
                let known = [channel, when, statistic].map(|term| self.pattern(term));
                let [channel, when, statistic] = known;
                let (channel, when, statistic) = (channel?, when?, statistic?);
                let are_bound = [&channel, &when, &statistic];
                are_bound
                    .into_iter()
                    .all(|p| self.is_bound(p))
                    .then_some(())?;
                Goal::Telemetry {
                    episode: self.thing(episode)?,
                    channel,
                    when,
                    statistic,
                    value: self.pattern(value)?,
                }
            }
            ("episode", [episode, name]) => {
                let episode_of = self.thing(episode)?;
                let is_bound = self.is_bound(&episode_of);
                let same = self.alias(episode_of.clone(), name)?;
                match (is_bound, same) {
                    (true, same) => return Some(same),
                    (false, None) => self.class(episode, "semco:WipingEpisode")?,
                    (false, Some(_)) => return None,
                }
            }
            ("thing", [thing, name]) => {
                let thing = self.thing(thing)?;
                return self.alias(thing, name);
            }
            ("known", [Term::Atom(kind), thing, name]) if kind == "thing" => {
                let thing = self.thing(thing)?;
                let thing = self.is_bound(&thing).then_some(thing)?;
                return self.alias(thing, name);
            }
            ("=", [left, right]) => {
                let left_pattern = self.pattern(left)?;
                match (&left_pattern, right) {
                    (Pattern::Variable(_), Term::Variable(_)) => {
                        return self.alias(left_pattern, right);
                    }
                    _ => Goal::Same(left_pattern, self.pattern(right)?),
                }
            }
            ("is", [result, expression]) => {
                let expression = self.expression(expression)?;
                Goal::Is(self.pattern(result)?, expression)
            }
            (_, [left, right]) if Comparison::named(name).is_some() => Goal::Comparison(
                Comparison::named(name)?,
                self.expression(left)?,
                self.expression(right)?,
            ),
            ("number", [value]) => Goal::Number(self.pattern(value)?),
            ("length", [list, len]) => {
                let list = self.pattern(list)?;
                let list = self.is_bound(&list).then_some(list)?;
                Goal::Length(list, self.pattern(len)?)
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
                let (numbers, bound) = (self.numbers.clone(), self.bound.clone());
                // What is known of the key narrows the goals down.
                let block = self.block(goals)?;
                let (key, number) = (self.pattern(key)?, self.pattern(number)?);
                self.leave(numbers, &bound);
                let result = [of, mean, count].map(|term| self.pattern(term));
                let [of, mean, count] = result;
                let result = [of?, mean?, count?];
                Goal::MeanByKey {
                    block,
                    key,
                    number,
                    result,
                }
            }
            _ => return None,
        }))
    }

    fn class(&mut self, thing: &Term, class: &str) -> Option<Goal> {
        Some(Goal::Class {
            thing: self.thing(thing)?,
            classes: self.classes(class),
        })
    }

    fn classes(&self, class: &str) -> Vec<String> {
        atoms(self.known.names.subclasses(class))
    }

    fn stated(&mut self, subject: &Term, property: &str, object: &Term) -> Option<Goal> {
        if WITH_INVERSE.contains(&property) {
            return None;
        }
        let mut sources = Vec::new();
        for exact in atoms(self.known.names.subproperties(property)) {
            if exact == "dul:hasConstituent" {
                sources.push(Source::Parts);
                continue;
            }
            sources.extend(self.without_assertions(Source::Relations(exact.clone()))?);
            sources.push(Source::Values {
                property: exact,
                is_lenient: true,
            });
        }
        Some(Goal::Statement {
            subject: self.thing(subject)?,
            object: self.object(object)?,
            sources,
        })
    }

    /// A source in a list of its own, unless people have added statements to it, which the catalogue does not hold.
    fn without_assertions(&self, source: Source) -> Option<Vec<Source>> {
        let of = match &source {
            Source::Parts => return Some(vec![source]),
            Source::Relations(property) | Source::Values { property, .. } => property,
        };
        (!self.known.assertions.has(of)).then(|| vec![source])
    }

    fn has_data_value(&mut self, thing: &Term, condition: &Term) -> Option<Goal> {
        let Term::Compound(operator, arguments) = condition else {
            return None;
        };
        let (property, operator, bound) = match arguments.as_slice() {
            [property, bound] => (property.clone(), operator.as_str(), bound),
            [bound] => (Term::atom(operator), "=", bound),
            _ => return None,
        };
        let property = is_ground(&property).then_some(property)?;
        let property = self.known.names.resolve("property", &property).ok()?;
        let properties = atoms(self.known.names.subproperties(&property));
        if properties
            .iter()
            .any(|exact| self.known.assertions.has(exact))
        {
            return None;
        }
        let subject = self.thing(thing)?;
        Some(match operator {
            "=" => {
                let object = self.pattern(bound)?;
                let source = |property| Source::Values {
                    property,
                    is_lenient: true,
                };
                let sources = properties.into_iter().map(source).collect();
                Goal::Statement {
                    subject,
                    object,
                    sources,
                }
            }
            "=\\=" => return None,
            _ => Goal::Compared {
                thing: subject,
                properties,
                comparison: Comparison::named(operator)?,
                bound: self.expression(bound)?,
            },
        })
    }

    fn side(&mut self, term: &Term) -> Option<Side> {
        Some(match term {
            Term::List(times) => {
                let [start, end] = times.as_slice() else {
                    return None;
                };
                let (start, end) = (self.pattern(start)?, self.pattern(end)?);
                (self.is_bound(&start) && self.is_bound(&end)).then_some(())?;
                Side::Times(start, end)
            }
            other => Side::Event(self.thing(other)?),
        })
    }

    /// A second name of a pattern; inside, a goal that they are the same, where it has a meaning already.
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

    /// Alternatives. What is bound in one is the same variable in another, and bound afterwards if it is in all.
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

/// The variables that hold something after a goal.
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

/// Adds the names of the variables of a term.
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

/// Whether there is no variable in a term.
pub fn is_ground(term: &Term) -> bool {
    match term {
        Term::Variable(_) => false,
        Term::Compound(_, items) | Term::List(items) => items.iter().all(is_ground),
        Term::Atom(_) | Term::Integer(_) | Term::Float(_) => true,
    }
}

/// The thing of a name, if there is one.
pub fn thing_of(known: &Knowledge, name: &Term) -> Option<Value> {
    let name = known.names.resolve("thing", name).ok()?;
    Some(named(known, name))
}

/// The thing of this full name.
pub fn named(known: &Knowledge, name: String) -> Value {
    match known.names.node(&name) {
        Some(crate::catalogue::Node::Individual(id)) => Value::Individual(id),
        Some(crate::catalogue::Node::Shared(number)) => Value::Shared(number),
        None => Value::Term(Term::Atom(name)),
    }
}

/// What stands for an object: a thing where the name is one's, otherwise a value.
pub fn object_of(known: &Knowledge, term: &Term) -> Value {
    match term {
        Term::Integer(_) | Term::Float(_) => Value::of(term.clone()),
        other => thing_of(known, other).unwrap_or_else(|| Value::Term(other.clone())),
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
