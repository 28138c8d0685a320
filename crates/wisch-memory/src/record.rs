//! An episode's record as it is written to disk: a graph of individuals under a schema version.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of [`EpisodeRecord`].
pub const EPISODE_SCHEMA: u32 = 1;

/// Property of a round of which no telemetry was kept: why.
pub(crate) const TELEMETRY_LOST: &str = "semco:telemetryLost";

/// Where an episode comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// Run by this program in its simulated world.
    Simulated,
    /// Executed by a program of this name, which is no world that this program simulates: a robot, or another simulator.
    Executor(String),
    /// Read from a log of this name.
    Imported(String),
}

/// A value of a property.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number, in the property's unit.
    Number(f64),
    /// A text.
    Text(String),
}

/// One thing of an episode: an action, an event, a state.
///
/// Its name is `Class_episode-number`, with one `_` in it, where the number is its place in the record.
/// Names of classes and properties carry their prefix, such as `semco:WipingRound` and `semco:performance`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Individual {
    /// Its class, such as `semco:Collision`.
    pub class: String,
    /// From when to when [s since 1970], if it has a time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interval: Option<[f64; 2]>,
    /// Place in the record of the action that it is part of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
    /// What it is related to, by property: names of individuals, of shared things such as `semco:sponge`, or
    /// places in the record as `#3`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub relations: BTreeMap<String, Vec<String>>,
    /// Its values, by property.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, Value>,
}

/// One episode: what happened, who took part, and with what result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EpisodeRecord {
    /// [`EPISODE_SCHEMA`].
    pub schema: u32,
    /// Its name: letters, digits and `-`.
    pub id: String,
    /// The task's name.
    pub task: String,
    /// From when to when [s since 1970].
    pub interval: [f64; 2],
    /// Where it comes from.
    pub origin: Origin,
    /// Program and version that wrote it.
    pub program: String,
    /// Seed of the run.
    pub seed: u64,
    /// When each round began [s since 1970], in their order; the times in its telemetry count from here.
    pub rounds: Vec<f64>,
    /// What happened; the first is the episode itself.
    pub individuals: Vec<Individual>,
}

/// What is wrong with a record.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RecordFault {
    /// Another schema.
    #[error("schema: {found} is not supported, this program reads {EPISODE_SCHEMA}")]
    Schema {
        /// What it has.
        found: u32,
    },
    /// Not a name.
    #[error("id: {id:?} is not made of letters, digits and -")]
    Id {
        /// What it has.
        id: String,
    },
    /// An interval that ends before it begins, or is not finite.
    #[error("{place}: the interval {start} to {end} is none")]
    Interval {
        /// Where.
        place: String,
        /// Its start [s].
        start: f64,
        /// Its end [s].
        end: f64,
    },
    /// No such individual.
    #[error("{place}: {reference} is none of the {count} individuals")]
    Reference {
        /// Where.
        place: String,
        /// What is named.
        reference: String,
        /// How many there are.
        count: usize,
    },
    /// A number that is none.
    #[error("{place}: {property} is {value}, which is not finite")]
    Number {
        /// Where.
        place: String,
        /// Of which property.
        property: String,
        /// The number.
        value: f64,
    },
    /// A name without a prefix.
    #[error("{place}: {name:?} has no prefix")]
    Prefix {
        /// Where.
        place: String,
        /// The name.
        name: String,
    },
}

impl EpisodeRecord {
    /// The name of an individual, without prefix: its class, `_`, the episode and its place.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn name(&self, place: usize) -> String {
        individual_name(&self.individuals[place].class, &self.id, place)
    }

    /// Why no telemetry of a round, from 1, was kept; `None` where the record does not say.
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

    /// Says why no telemetry of a round, from 1, was kept.
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

    /// What is wrong with it; nothing, if it can be stored.
    ///
    /// # Errors
    /// The first fault.
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
        // Parents stand before their parts, so there are no circles.
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

/// The name of an individual, without prefix.
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
