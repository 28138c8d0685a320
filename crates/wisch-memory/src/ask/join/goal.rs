//! Goals that the program joins itself.

use super::expression::{Comparison, Expression};
use super::value::Pattern;
use crate::ask::intervals::Relation;

/// A goal. Each field states what the goal requires of it.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// A thing is an instance of one of these classes.
    Class {
        /// The thing.
        thing: Pattern,
        /// The classes, each without subclasses, in the order in which they are searched.
        classes: Vec<String>,
    },
    /// A subject has a relation or value.
    Statement {
        /// The subject.
        subject: Pattern,
        /// The object.
        object: Pattern,
        /// Sources of the statement, in the order in which they are searched.
        sources: Vec<GoalSource>,
    },
    /// A number of a thing meets a comparison.
    Compared {
        /// The thing.
        thing: Pattern,
        /// The properties, each without subproperties.
        properties: Vec<String>,
        /// The comparison.
        comparison: Comparison,
        /// The bound of the comparison.
        bound: Expression,
    },
    /// An event has this begin and end.
    Timed {
        /// The event.
        event: Pattern,
        /// Its begin [s since 1970].
        start: Pattern,
        /// Its end [s since 1970].
        end: Pattern,
    },
    /// Two intervals have a relation of time.
    Related {
        /// The relation.
        relation: Relation,
        /// The first interval.
        first: Side,
        /// The second interval.
        second: Side,
    },
    /// A part of a known whole, at any depth.
    PartBelow {
        /// The whole.
        whole: Pattern,
        /// The part.
        part: Pattern,
        /// The classes of the part, each without subclasses.
        classes: Vec<String>,
    },
    /// The nearest whole of some classes above a known part.
    Above {
        /// The part.
        part: Pattern,
        /// The whole.
        whole: Pattern,
        /// The classes of the whole, each without subclasses.
        classes: Vec<String>,
    },
    /// The latest episode, and its end [s since 1970].
    LastEpisode {
        /// The episode.
        episode: Pattern,
        /// Its end.
        time: Pattern,
    },
    /// A statistic of telemetry in a known interval, by episode.
    Telemetry {
        /// The episode.
        episode: Pattern,
        /// The channel.
        channel: Pattern,
        /// The interval: an event, or a list of begin and end.
        when: Pattern,
        /// The statistic.
        statistic: Pattern,
        /// Its value.
        value: Pattern,
    },
    /// A pattern equals the value of an expression.
    Is(Pattern, Expression),
    /// Two expressions meet a comparison.
    Comparison(Comparison, Expression, Expression),
    /// Two patterns are equal.
    Same(Pattern, Pattern),
    /// A pattern is a number.
    Number(Pattern),
    /// A list has this length.
    Length(Pattern, Pattern),
    /// The block has no solution.
    Not(Block),
    /// At least one of these blocks has a solution.
    Either(Vec<Block>),
    /// The first solution of a block only.
    Once(Block),
    /// An aggregate over all solutions of a block.
    Over {
        /// The block.
        block: Block,
        /// The aggregate.
        aggregate: Aggregate,
        /// The result.
        result: Pattern,
    },
    /// Means by key, as in `mean_by_key`.
    MeanByKey {
        /// The block.
        block: Block,
        /// The key of a solution.
        key: Pattern,
        /// The number of a solution.
        number: Pattern,
        /// `Key`, `Mean` and `Count` of a group.
        result: [Pattern; 3],
    },
}

/// Aggregate over the solutions of a block.
#[derive(Debug, Clone, PartialEq)]
pub enum Aggregate {
    /// A list of instances of a pattern.
    All(Pattern),
    /// A list of instances of a pattern, sorted and without repetitions.
    Set(Pattern),
    /// The number of solutions.
    Count,
    /// The sum of an expression.
    Sum(Expression),
    /// The mean of an expression.
    Mean(Expression),
    /// The largest (`is_max`) or smallest value of an expression, and, as in `max(E, W)`, the pattern's value there.
    Extreme {
        /// Whether the largest value is wanted.
        is_max: bool,
        /// The expression.
        of: Expression,
        /// The pattern that is reported with it.
        witness: Option<Pattern>,
    },
}

/// A side of a relation of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Side {
    /// An event.
    Event(Pattern),
    /// Begin and end [s since 1970].
    Times(Pattern, Pattern),
}

/// The source of the statements that a goal looks up.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GoalSource {
    /// The object is a part of the subject.
    Parts,
    /// Relations of exactly this property.
    Relations(String),
    /// Values of exactly this property; if `is_lenient`, 1 matches 1.0.
    Values {
        /// The property.
        property: String,
        /// Whether numbers are compared by value.
        is_lenient: bool,
    },
}

/// A conjunction of goals, in the order in which they are solved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Block {
    /// The goals.
    pub goals: Vec<Goal>,
    /// Original position of each goal; empty if the goals were not moved.
    pub stood: Vec<usize>,
    /// The variables that they bind.
    pub binds: Vec<usize>,
}

impl Goal {
    /// Whether the goal looks facts up, and may therefore be moved.
    pub fn is_fact(&self) -> bool {
        matches!(
            self,
            Self::Class { .. }
                | Self::Statement { .. }
                | Self::Compared { .. }
                | Self::Timed { .. }
                | Self::Related { .. }
        )
    }

    /// Returns all variables of the goal.
    pub fn variables(&self) -> Vec<usize> {
        let mut found = Vec::new();
        self.collect(&mut found);
        found.sort_unstable();
        found.dedup();
        found
    }

    fn collect(&self, found: &mut Vec<usize>) {
        match self {
            Self::Class { thing, .. } => thing.variables(found),
            Self::Statement {
                subject, object, ..
            } => {
                subject.variables(found);
                object.variables(found);
            }
            Self::Compared { thing, bound, .. } => {
                thing.variables(found);
                bound.variables(found);
            }
            Self::Timed { event, start, end } => {
                for pattern in [event, start, end] {
                    pattern.variables(found);
                }
            }
            Self::Related { first, second, .. } => {
                for side in [first, second] {
                    side.variables(found);
                }
            }
            Self::PartBelow { whole, part, .. } | Self::Above { part, whole, .. } => {
                whole.variables(found);
                part.variables(found);
            }
            Self::LastEpisode { episode, time } => {
                episode.variables(found);
                time.variables(found);
            }
            Self::Telemetry {
                episode,
                channel,
                when,
                statistic,
                value,
            } => {
                for pattern in [episode, channel, when, statistic, value] {
                    pattern.variables(found);
                }
            }
            Self::Is(pattern, expression) => {
                pattern.variables(found);
                expression.variables(found);
            }
            Self::Comparison(_, left, right) => {
                left.variables(found);
                right.variables(found);
            }
            Self::Same(left, right) | Self::Length(left, right) => {
                left.variables(found);
                right.variables(found);
            }
            Self::Number(pattern) => pattern.variables(found),
            Self::Not(block) | Self::Once(block) => block.collect(found),
            Self::Either(blocks) => {
                for block in blocks {
                    block.collect(found);
                }
            }
            Self::Over {
                block,
                aggregate,
                result,
            } => {
                block.collect(found);
                aggregate.collect(found);
                result.variables(found);
            }
            Self::MeanByKey {
                block,
                key,
                number,
                result,
            } => {
                block.collect(found);
                for pattern in [key, number].into_iter().chain(result) {
                    pattern.variables(found);
                }
            }
        }
    }
}

impl Block {
    fn collect(&self, found: &mut Vec<usize>) {
        for goal in &self.goals {
            goal.collect(found);
        }
    }
}

impl Side {
    /// Appends the variables of the side to `found`.
    pub fn variables(&self, found: &mut Vec<usize>) {
        match self {
            Self::Event(event) => event.variables(found),
            Self::Times(start, end) => {
                start.variables(found);
                end.variables(found);
            }
        }
    }
}

impl Aggregate {
    fn collect(&self, found: &mut Vec<usize>) {
        match self {
            Self::All(pattern) | Self::Set(pattern) => pattern.variables(found),
            Self::Count => {}
            Self::Sum(of) | Self::Mean(of) => of.variables(found),
            Self::Extreme { of, witness, .. } => {
                of.variables(found);
                if let Some(witness) = witness {
                    witness.variables(found);
                }
            }
        }
    }
}
