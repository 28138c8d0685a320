//! Goals that look facts up: classes, statements, times, wholes and telemetry.

use super::{Compiler, atoms};
use crate::ask::intervals::Relation;
use crate::ask::join::expression::Comparison;
use crate::ask::join::goal::{Goal, GoalSource, Side};
use crate::ask::term::Term;

/// Inverse properties, which are left to the engine.
const WITH_INVERSE: [&str; 4] = [
    "dul:isConstituentOf",
    "dul:isParticipantIn",
    "dul:isExecutedIn",
    "dul:classifies",
];

impl Compiler<'_> {
    /// Compiles a goal that looks facts up; `None` if it is left to the engine.
    pub(super) fn compile_lookup(&mut self, name: &str, arguments: &[Term]) -> Option<Goal> {
        Some(match (name, arguments) {
            ("instance_of", [thing, class]) => self.compile_named_class(thing, class)?,
            ("is_a" | "of_class", [thing, Term::Atom(class)]) => self.class(thing, class)?,
            ("triple", [subject, property, object]) => {
                self.compile_triple(subject, property, object)?
            }
            ("stated", [subject, Term::Atom(property), object]) => {
                self.compile_statement(subject, property, object)?
            }
            ("has_data_value", [thing, condition]) => self.has_data_value(thing, condition)?,
            ("value", [thing, Term::Atom(property), value]) => {
                self.compile_value(thing, property, value)?
            }
            ("relation", [subject, Term::Atom(property), object]) => Goal::Statement {
                subject: self.thing(subject)?,
                object: self.thing(object)?,
                sources: self.without_assertions(GoalSource::Relations(property.clone()))?,
            },
            ("part", [whole, part]) => Goal::Statement {
                subject: self.thing(whole)?,
                object: self.thing(part)?,
                sources: vec![GoalSource::Parts],
            },
            ("part_below", [whole, part, Term::Atom(class)]) => Goal::PartBelow {
                whole: self.require_bound_thing(whole)?,
                part: self.thing(part)?,
                classes: self.classes(class),
            },
            ("above", [part, whole, Term::Atom(class)]) => Goal::Above {
                part: self.require_bound_thing(part)?,
                whole: self.thing(whole)?,
                classes: self.classes(class),
            },
            ("timed", [event, start, end]) => Goal::Timed {
                event: self.thing(event)?,
                start: self.pattern(start)?,
                end: self.pattern(end)?,
            },
            ("related", [Term::Atom(relation), first, second]) => Goal::Related {
                relation: Relation::from_name(relation)?,
                first: self.side(first)?,
                second: self.side(second)?,
            },
            ("last_episode", [episode, time]) => Goal::LastEpisode {
                episode: self.thing(episode)?,
                time: self.pattern(time)?,
            },
            ("telemetry_in", [episode, channel, when, statistic, value]) => Goal::Telemetry {
                episode: self.thing(episode)?,
                channel: self.require_bound_pattern(channel)?,
                when: self.require_bound_pattern(when)?,
                statistic: self.require_bound_pattern(statistic)?,
                value: self.pattern(value)?,
            },
            _ => return None,
        })
    }

    /// Compiles `triple/3`, unless the property is unknown or asks for classes.
    fn compile_triple(&mut self, subject: &Term, property: &Term, object: &Term) -> Option<Goal> {
        let property = self.known.names.resolve("property", property).ok()?;
        match (property.as_str(), object) {
            ("rdf:type", Term::Variable(_)) | ("rdfs:subClassOf", _) => None,
            ("rdf:type", class) => self.compile_named_class(subject, class),
            _ => self.compile_statement(subject, &property, object),
        }
    }

    /// Compiles that a thing is of the class that a term names.
    fn compile_named_class(&mut self, thing: &Term, class: &Term) -> Option<Goal> {
        let class = self.known.names.resolve("class", class).ok()?;
        self.class(thing, &class)
    }

    /// Compiles `value/3`, which compares numbers exactly.
    fn compile_value(&mut self, thing: &Term, property: &str, value: &Term) -> Option<Goal> {
        let source = GoalSource::Values {
            property: property.to_owned(),
            is_lenient: false,
        };
        Some(Goal::Statement {
            subject: self.thing(thing)?,
            object: self.pattern(value)?,
            sources: self.without_assertions(source)?,
        })
    }

    pub(super) fn class(&mut self, thing: &Term, class: &str) -> Option<Goal> {
        Some(Goal::Class {
            thing: self.thing(thing)?,
            classes: self.classes(class),
        })
    }

    fn classes(&self, class: &str) -> Vec<String> {
        atoms(self.known.names.subclasses(class))
    }

    fn compile_statement(&mut self, subject: &Term, property: &str, object: &Term) -> Option<Goal> {
        if WITH_INVERSE.contains(&property) {
            return None;
        }
        let mut sources = Vec::new();
        for exact in atoms(self.known.names.subproperties(property)) {
            if exact == "dul:hasConstituent" {
                sources.push(GoalSource::Parts);
                continue;
            }
            sources.extend(self.without_assertions(GoalSource::Relations(exact.clone()))?);
            sources.push(GoalSource::Values {
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

    /// Returns the source as a list; `None` if users have added statements to it, which the catalogue does not hold.
    fn without_assertions(&self, source: GoalSource) -> Option<Vec<GoalSource>> {
        let of = match &source {
            GoalSource::Parts => return Some(vec![source]),
            GoalSource::Relations(property) | GoalSource::Values { property, .. } => property,
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
                let source = |property| GoalSource::Values {
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
                comparison: Comparison::from_name(operator)?,
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
                // The engine refuses times that end before they begin.
                if let (Some(start), Some(end)) = (start.as_number(), end.as_number())
                    && start > end
                {
                    return None;
                }
                let start = self.require_bound_pattern(start)?;
                Side::Times(start, self.require_bound_pattern(end)?)
            }
            other => Side::Event(self.thing(other)?),
        })
    }
}
