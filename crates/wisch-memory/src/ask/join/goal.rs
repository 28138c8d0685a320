//! The goals that the program joins by itself.

use super::expression::{Comparison, Expression};
use super::value::Pattern;
use crate::ask::intervals::Relation;

/// A goal. What it says of a variable is told beside it.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// A thing is of one of these classes.
    Class {
        /// The thing.
        thing: Pattern,
        /// The classes, each exactly, in the order in which they are gone through.
        classes: Vec<String>,
    },
    /// A subject stands in a relation to an object, or has it for a value.
    Statement {
        /// The subject.
        subject: Pattern,
        /// The object.
        object: Pattern,
        /// Where such statements are, in the order in which they are gone through.
        sources: Vec<GoalSource>,
    },
    /// A number of a thing meets a condition.
    Compared {
        /// The thing.
        thing: Pattern,
        /// The properties, each exactly.
        properties: Vec<String>,
        /// The condition.
        comparison: Comparison,
        /// What the number is compared with.
        bound: Expression,
    },
    /// An event lasts from a start to an end.
    Timed {
        /// The event.
        event: Pattern,
        /// Its start [s since 1970].
        start: Pattern,
        /// Its end [s since 1970].
        end: Pattern,
    },
    /// How two intervals lie to each other.
    Related {
        /// How.
        relation: Relation,
        /// The first.
        first: Side,
        /// The second.
        second: Side,
    },
    /// A part of a known whole, at any depth.
    PartBelow {
        /// The whole.
        whole: Pattern,
        /// The part.
        part: Pattern,
        /// The classes of the part, each exactly.
        classes: Vec<String>,
    },
    /// The next whole of this kind above a known part.
    Above {
        /// The part.
        part: Pattern,
        /// The whole.
        whole: Pattern,
        /// The classes of the whole, each exactly.
        classes: Vec<String>,
    },
    /// The latest episode, and its end [s since 1970].
    LastEpisode {
        /// The episode.
        episode: Pattern,
        /// Its end.
        time: Pattern,
    },
    /// A statistic of telemetry during a known time, by episode.
    Telemetry {
        /// The episode.
        episode: Pattern,
        /// Of what.
        channel: Pattern,
        /// When: an event, or a list of start and end.
        when: Pattern,
        /// Which statistic.
        statistic: Pattern,
        /// Its value.
        value: Pattern,
    },
    /// A pattern is the value of an expression.
    Is(Pattern, Expression),
    /// Two expressions compare so.
    Comparison(Comparison, Expression, Expression),
    /// Two patterns are the same.
    Same(Pattern, Pattern),
    /// It is a number.
    Number(Pattern),
    /// A list has so many elements.
    Length(Pattern, Pattern),
    /// None of it holds.
    Not(Block),
    /// Any of these.
    Either(Vec<Block>),
    /// The first solution only.
    Once(Block),
    /// A result over all solutions.
    Over {
        /// What is gone through.
        block: Block,
        /// What is made of them.
        aggregate: Aggregate,
        /// The result.
        result: Pattern,
    },
    /// Means by key, as `mean_by_key` has them.
    MeanByKey {
        /// What is gone through.
        block: Block,
        /// The key of a solution.
        key: Pattern,
        /// Its number.
        number: Pattern,
        /// `Key`, `Mean` and `Count` of a group.
        result: [Pattern; 3],
    },
}

/// What is made of the solutions of a block.
#[derive(Debug, Clone, PartialEq)]
pub enum Aggregate {
    /// A list of instances of a pattern.
    All(Pattern),
    /// The same, sorted and without repetitions.
    Set(Pattern),
    /// How many there are.
    Count,
    /// The sum of an expression.
    Sum(Expression),
    /// The mean of an expression.
    Mean(Expression),
    /// The largest (`is_max`) or smallest value of an expression, and, as in `max(E, W)`, a pattern where it is.
    Extreme {
        /// Whether the largest is meant.
        is_max: bool,
        /// Of what.
        of: Expression,
        /// What is told with it.
        witness: Option<Pattern>,
    },
}

/// One side of a relation of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Side {
    /// An event.
    Event(Pattern),
    /// From when to when [s since 1970].
    Times(Pattern, Pattern),
}

/// Where statements are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GoalSource {
    /// The object is a part of the subject.
    Parts,
    /// Relations of exactly this property.
    Relations(String),
    /// Values of exactly this property; where `is_lenient`, 1 finds 1.0.
    Values {
        /// The property.
        property: String,
        /// Whether numbers are compared by value.
        is_lenient: bool,
    },
}

/// Goals that hold together, in the order in which they are solved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Block {
    /// The goals.
    pub goals: Vec<Goal>,
    /// Where each of them stood before they were put into this order; empty where they stand as they stood.
    pub stood: Vec<usize>,
    /// The variables that they bind.
    pub binds: Vec<usize>,
}

impl Goal {
    /// Whether it looks something up, and may so be moved among its like.
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

    /// All variables in it.
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
    /// The variables in it.
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
