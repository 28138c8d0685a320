//! The record of an episode on disk: a graph of individuals with a schema version.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the schema of [`EpisodeRecord`].
pub const EPISODE_SCHEMA: u32 = 1;

/// Class of the episode of a run for a goal of several parts.
pub(crate) const GOAL_EPISODE: &str = "semco:GoalEpisode";

/// Property of a round without telemetry: the reason.
pub(crate) const TELEMETRY_LOST: &str = "semco:telemetryLost";

/// How an episode came into the memory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// A run of this program in its simulated world.
    Simulated,
    /// An execution by a program of this name: a robot, or another simulator.
    Executor(String),
    /// A log of this name.
    Imported(String),
}

/// The value of a property: a number or a text.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number, in the property's unit.
    Number(f64),
    /// A text.
    Text(String),
}

/// An individual of an episode: an action, an event or a state.
///
/// Its name is `Class_episode-number` with a single `_`; the number is its index in the record. Names of classes and
/// properties have a prefix, for example `semco:WipingRound` and `semco:performance`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Individual {
    /// Its class, for example `semco:Collision`.
    pub class: String,
    /// Begin and end [s since 1970], if it has a time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interval: Option<[f64; 2]>,
    /// Index of the action that it is part of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
    /// Relations by property: names of individuals, of shared things such as `semco:sponge`, or indices in the record
    /// as `#3`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub relations: BTreeMap<String, Vec<String>>,
    /// Values by property.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, Value>,
}

/// The property of an estimated performance.
pub(crate) const PERFORMANCE: &str = "semco:performance";
/// Verdicts, also of earlier versions, that call the performance unknown.
const UNKNOWN_VERDICTS: [&str; 2] = ["performance unknown", "cannot be told"];

impl Individual {
    /// Returns the estimated performance \[1\] of a round or an action.
    ///
    /// It is `None` if the verdict calls the performance unknown, also where the record states a number: episodes of
    /// earlier versions state the lower bound of a log that lacks a part of the wiping.
    pub fn performance(&self) -> Option<f64> {
        let is_unknown = match self.values.get("semco:verdict") {
            Some(Value::Text(verdict)) => UNKNOWN_VERDICTS.contains(&verdict.as_str()),
            _ => false,
        };
        match self.values.get(PERFORMANCE) {
            Some(Value::Number(performance)) if !is_unknown => Some(*performance),
            _ => None,
        }
    }
}

/// The record of an episode: its individuals, participants and result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EpisodeRecord {
    /// Version of the schema: [`EPISODE_SCHEMA`].
    pub schema: u32,
    /// Its name: letters, digits and `-`.
    pub id: String,
    /// Name of the task.
    pub task: String,
    /// Begin and end [s since 1970].
    pub interval: [f64; 2],
    /// Source of the episode.
    pub origin: Origin,
    /// Program and version that wrote it.
    pub program: String,
    /// Seed of the run.
    pub seed: u64,
    /// Start of each round [s since 1970], in order; times in the round's telemetry count from here.
    pub rounds: Vec<f64>,
    /// Individuals; the first is the episode itself.
    pub individuals: Vec<Individual>,
}

/// A fault that keeps a record from being stored.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RecordFault {
    /// The schema is not supported.
    #[error("schema: {found} is not supported; this program reads {EPISODE_SCHEMA}")]
    Schema {
        /// The record's schema.
        found: u32,
    },
    /// The name of the episode is invalid.
    #[error("id: {id:?} may contain only letters, digits and -")]
    Id {
        /// The name.
        id: String,
    },
    /// An interval ends before it begins, or is not finite.
    #[error(
        "{place}: the interval from {start} to {end} s is invalid; its end must be finite and not before its start"
    )]
    Interval {
        /// Path of the faulty entry.
        place: String,
        /// Its start \[s\].
        start: f64,
        /// Its end \[s\].
        end: f64,
    },
    /// A relation or parent refers to an individual that does not exist.
    #[error("{place}: {reference} does not exist; the record has {count} individuals")]
    Reference {
        /// Path of the faulty entry.
        place: String,
        /// The reference.
        reference: String,
        /// Number of individuals.
        count: usize,
    },
    /// A number is not finite.
    #[error("{place}: {property} is {value}, which is not finite")]
    Number {
        /// Path of the faulty entry.
        place: String,
        /// The property.
        property: String,
        /// The number.
        value: f64,
    },
    /// A name has no prefix.
    #[error("{place}: {name:?} has no prefix, for example semco:")]
    Prefix {
        /// Path of the faulty entry.
        place: String,
        /// The name.
        name: String,
    },
}

impl EpisodeRecord {
    /// Returns the name of an individual, without prefix: its class, `_`, the episode and its index.
    ///
    /// # Panics
    /// If no individual has this index.
    pub fn name(&self, place: usize) -> String {
        individual_name(&self.individuals[place].class, &self.id, place)
    }

    /// Whether it is the record of a run for a goal of several parts, whose wiping steps have episodes of their own.
    pub fn is_of_goal(&self) -> bool {
        (self.individuals.first()).is_some_and(|episode| episode.class == GOAL_EPISODE)
    }

    /// Returns why a round, counted from 1, has no telemetry; `None` if the record states no reason.
    pub fn telemetry_lost(&self, round: usize) -> Option<String> {
        let is_round = |individual: &&Individual| {
            let number = individual.values.get("semco:round");
            let is_numbered = matches!(number, Some(Value::Number(n)) if *n == round as f64);
            individual.class == "semco:WipingRound" && is_numbered
        };
        let individual = self.individuals.iter().find(is_round)?;
        match individual.values.get(TELEMETRY_LOST) {
            Some(Value::Text(why)) => Some(why.clone()),
            _ => None,
        }
    }

    /// Records why a round, counted from 1, has no telemetry.
    pub fn set_telemetry_lost(&mut self, round: usize, why: &str) {
        for individual in &mut self.individuals {
            let number = individual.values.get("semco:round");
            if individual.class == "semco:WipingRound"
                && matches!(number, Some(Value::Number(n)) if *n == round as f64)
            {
                let why = Value::Text(why.to_owned());
                individual.values.insert(TELEMETRY_LOST.to_owned(), why);
            }
        }
    }

    /// Checks that the record can be stored.
    ///
    /// # Errors
    /// The first fault that was found.
    pub fn check(&self) -> Result<(), RecordFault> {
        if self.schema != EPISODE_SCHEMA {
            return Err(RecordFault::Schema { found: self.schema });
        }
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
        if self.id.is_empty() || !self.id.chars().all(plain) {
            return Err(RecordFault::Id {
                id: self.id.clone(),
            });
        }
        check_interval("interval", self.interval)?;
        for (place, individual) in self.individuals.iter().enumerate() {
            self.check_individual(&format!("individuals[{place}]"), place, individual)?;
        }
        Ok(())
    }

    fn check_individual(
        &self,
        place: &str,
        index: usize,
        individual: &Individual,
    ) -> Result<(), RecordFault> {
        let count = self.individuals.len();
        let prefixed = |name: &str| match name.split_once(':') {
            Some((prefix, local)) if !prefix.is_empty() && !local.is_empty() => Ok(()),
            _ => Err(RecordFault::Prefix {
                place: place.to_owned(),
                name: name.to_owned(),
            }),
        };
        prefixed(&individual.class)?;
        if let Some(interval) = individual.interval {
            check_interval(&format!("{place}.interval"), interval)?;
        }
        // Parents precede their parts, so there are no cycles.
        if let Some(parent) = individual.parent
            && parent >= index
        {
            return Err(RecordFault::Reference {
                place: format!("{place}.parent"),
                reference: parent.to_string(),
                count: index,
            });
        }
        for (property, objects) in &individual.relations {
            prefixed(property)?;
            for object in objects {
                match object.strip_prefix('#') {
                    Some(number) if number.parse::<usize>().is_ok_and(|n| n < count) => {}
                    Some(_) => {
                        return Err(RecordFault::Reference {
                            place: format!("{place}.relations.{property}"),
                            reference: object.clone(),
                            count,
                        });
                    }
                    None => prefixed(object)?,
                }
            }
        }
        for (property, value) in &individual.values {
            prefixed(property)?;
            if let Value::Number(value) = value
                && !value.is_finite()
            {
                return Err(RecordFault::Number {
                    place: place.to_owned(),
                    property: property.clone(),
                    value: *value,
                });
            }
        }
        Ok(())
    }
}

/// Returns the name of an individual, without prefix.
pub(crate) fn individual_name(class: &str, episode: &str, place: usize) -> String {
    let local = class.split_once(':').map_or(class, |(_, local)| local);
    format!("{}_{episode}-{place}", local.replace('_', ""))
}

fn check_interval(place: &str, [start, end]: [f64; 2]) -> Result<(), RecordFault> {
    if start.is_finite() && end.is_finite() && start <= end {
        return Ok(());
    }
    Err(RecordFault::Interval {
        place: place.to_owned(),
        start,
        end,
    })
}
