//! Import of a NEEM: its triples one by one, and the episodes that they describe.

use super::document::triple;
use super::dump::Documents;
use super::triples::{
    BEGIN, END, HAS_INTERVAL, NAMED, Object, RECORD, STEP_OF, TYPE, Triple, derived_triples,
    individual, iri,
};
use super::{NeemError, at, collection_file};
use crate::ontology::Ontology;
use crate::record::{EpisodeRecord, Individual, Origin, Value};
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// Iterator over the triples of a NEEM, up to the first that cannot be read.
#[derive(Debug)]
pub struct Triples {
    path: PathBuf,
    documents: Documents<BufReader<File>>,
    number: u64,
    failed: bool,
}

impl Triples {
    /// Opens the triples of the NEEM in a folder.
    ///
    /// # Errors
    /// If the file of triples cannot be opened.
    pub fn open(neem: &Path) -> Result<Self, NeemError> {
        let path = collection_file(neem, "triples");
        let file = File::open(&path).map_err(at(&path))?;
        Ok(Self {
            documents: Documents::new(BufReader::new(file)),
            number: 0,
            failed: false,
            path,
        })
    }
}

impl Iterator for Triples {
    type Item = Result<Triple, NeemError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        let document = self.documents.next()?;
        let number = self.number;
        self.number += 1;
        let triple = match document {
            Ok(document) => triple(&document).map_err(|what| NeemError::Triple {
                path: self.path.clone(),
                number,
                what,
            }),
            Err(error) => Err(NeemError::Dump {
                path: self.path.clone(),
                error,
            }),
        };
        self.failed = triple.is_err();
        Some(triple)
    }
}

/// Returns the episodes of the NEEM in a folder, sorted by name.
///
/// # Errors
/// If the NEEM cannot be read, or an episode in it is incomplete.
pub fn import(neem: &Path) -> Result<Vec<EpisodeRecord>, NeemError> {
    let mut parts = BTreeMap::new();
    for triple in Triples::open(neem)? {
        sort_in(&mut parts, triple?);
    }
    whole(parts)
}

/// Returns the episodes that triples describe, sorted by name. Other triples are ignored.
///
/// This is the inverse of [`super::triples`], with two exceptions: empty lists of relations are lost, and a relation to
/// an individual by its name returns as `#` and index.
///
/// # Errors
/// If an episode is incomplete.
pub fn records(triples: impl IntoIterator<Item = Triple>) -> Result<Vec<EpisodeRecord>, NeemError> {
    let mut parts = BTreeMap::new();
    for triple in triples {
        sort_in(&mut parts, triple);
    }
    whole(parts)
}

/// Predicate, with prefix if it has one, and object.
type Statements = Vec<(String, Object)>;

/// Triples about the parts of an episode.
#[derive(Debug, Default)]
struct Parts {
    record: Statements,
    individuals: BTreeMap<usize, Statements>,
    intervals: HashMap<usize, Statements>,
}

/// Role of a subject in its episode.
enum Part {
    Record,
    Individual(usize),
    Interval(usize),
}

/// Returns the episode and part that a name with prefix refers to.
fn part(name: &str) -> Option<(&str, Part)> {
    let (class, rest) = name.strip_prefix("semco:")?.split_once('_')?;
    let (episode, end) = rest.rsplit_once('-')?;
    let place = |text: &str| {
        let place: usize = text.parse().ok()?;
        (place.to_string() == text).then_some(place)
    };
    let part = if end == "record" && format!("semco:{class}") == RECORD {
        Part::Record
    } else if let Some(interval) = end.strip_suffix("time") {
        Part::Interval(place(interval)?)
    } else {
        Part::Individual(place(end)?)
    };
    Some((episode, part))
}

fn sort_in(parts: &mut BTreeMap<String, Parts>, triple: Triple) {
    let ontology = Ontology::load();
    let name = ontology.compact(&triple.subject).unwrap_or_default();
    let Some((episode, part)) = part(&name) else {
        return;
    };
    let predicate = ontology.compact(&triple.predicate);
    let statement = (predicate.unwrap_or(triple.predicate), triple.object);
    let episode = parts.entry(episode.to_owned()).or_default();
    match part {
        Part::Record => episode.record.push(statement),
        Part::Individual(place) => episode
            .individuals
            .entry(place)
            .or_default()
            .push(statement),
        Part::Interval(place) => episode.intervals.entry(place).or_default().push(statement),
    }
}

fn whole(parts: BTreeMap<String, Parts>) -> Result<Vec<EpisodeRecord>, NeemError> {
    parts
        .into_iter()
        .filter(|(_, parts)| !parts.record.is_empty())
        .map(|(id, parts)| record(id, parts))
        .collect()
}

fn record(id: String, mut parts: Parts) -> Result<EpisodeRecord, NeemError> {
    let incomplete = |what: String| NeemError::Incomplete {
        episode: id.clone(),
        what,
    };
    let mut record = header(&id, &parts.record).map_err(incomplete)?;
    let mut left = Vec::new();
    for (place, (number, statements)) in std::mem::take(&mut parts.individuals)
        .into_iter()
        .enumerate()
    {
        if number != place {
            return Err(incomplete(format!("individual {place} is missing")));
        }
        let (individual, rest) =
            skeleton(place, statements, &parts.intervals).map_err(incomplete)?;
        record.individuals.push(individual);
        left.push(rest);
    }
    // Checked before anything is derived from it: parents precede their parts.
    let fault = |fault| NeemError::Record {
        episode: id.clone(),
        fault,
    };
    record.check().map_err(fault)?;
    relate(&mut record, left)?;
    record.check().map_err(fault)?;
    Ok(record)
}

fn header(id: &str, statements: &Statements) -> Result<EpisodeRecord, String> {
    let number = |property: &str| match find(statements, property) {
        Some(Object::Number(number)) => Ok(*number),
        _ => Err(format!("its record lacks the number {property}")),
    };
    let text = |property: &str| match find(statements, property) {
        Some(Object::Text(text)) => Ok(text.clone()),
        _ => Err(format!("its record lacks the text {property}")),
    };
    let rounds = statements
        .iter()
        .filter_map(|(property, object)| match object {
            Object::Number(start) if property == "semco:recordRoundStart" => Some(*start),
            _ => None,
        });
    let seed = text("semco:recordSeed")?;
    Ok(EpisodeRecord {
        schema: number("semco:recordSchema")? as u32,
        id: id.to_owned(),
        task: text("semco:recordTask")?,
        interval: [number("semco:recordBegin")?, number("semco:recordEnd")?],
        origin: (text("semco:recordLog").map(Origin::Imported))
            .or_else(|_| text("semco:recordExecutor").map(Origin::Executor))
            .unwrap_or(Origin::Simulated),
        program: text("semco:recordProgram")?,
        seed: seed
            .parse()
            .map_err(|_| format!("semco:recordSeed: {seed:?} is not a number of 64 bits"))?,
        rounds: rounds.collect(),
        individuals: Vec::new(),
    })
}

fn find<'a>(statements: &'a Statements, property: &str) -> Option<&'a Object> {
    statements
        .iter()
        .find(|(name, _)| name == property)
        .map(|(_, object)| object)
}

/// Builds an individual with class, interval, parent and values. Returns the remaining triples as well.
fn skeleton(
    place: usize,
    statements: Statements,
    intervals: &HashMap<usize, Statements>,
) -> Result<(Individual, Statements), String> {
    let mut individual = Individual {
        class: String::new(),
        interval: None,
        parent: None,
        relations: BTreeMap::new(),
        values: BTreeMap::new(),
    };
    let mut left = Statements::new();
    for (property, object) in statements {
        let object = match object {
            Object::Iri(iri) => iri,
            Object::Number(number) => {
                individual.values.insert(property, Value::Number(number));
                continue;
            }
            Object::Text(text) => {
                individual.values.insert(property, Value::Text(text));
                continue;
            }
        };
        // The first triple of each property belongs to the record itself; further ones are relations.
        match property.as_str() {
            TYPE if individual.class.is_empty() => {
                let class = Ontology::load().compact(&object);
                let class = class.ok_or_else(|| format!("{object:?} is not a class"))?;
                if class == NAMED {
                    left.push((property, Object::Iri(object)));
                } else {
                    individual.class = class;
                }
            }
            STEP_OF if individual.parent.is_none() => {
                let name = Ontology::load().compact(&object).unwrap_or_default();
                let Some((_, Part::Individual(parent))) = part(&name) else {
                    return Err(format!("individual {place} is part of {object:?}"));
                };
                individual.parent = Some(parent);
            }
            HAS_INTERVAL if individual.interval.is_none() => {
                let interval = intervals.get(&place).and_then(interval);
                let whole = interval
                    .ok_or_else(|| format!("the interval of {place} lacks its begin or end"));
                individual.interval = Some(whole?);
            }
            _ => left.push((property, Object::Iri(object))),
        }
    }
    if individual.class.is_empty() {
        return Err(format!("individual {place} has no class"));
    }
    Ok((individual, left))
}

fn interval(statements: &Statements) -> Option<[f64; 2]> {
    match [find(statements, BEGIN)?, find(statements, END)?] {
        [Object::Number(start), Object::Number(end)] => Some([*start, *end]),
        _ => None,
    }
}

/// Adds the remaining triples of each individual as relations, except those that the export derived.
fn relate(record: &mut EpisodeRecord, left: Vec<Statements>) -> Result<(), NeemError> {
    let ontology = Ontology::load();
    let mut places = HashMap::new();
    let mut repeated = HashMap::<[String; 3], usize>::new();
    for place in 0..record.individuals.len() {
        places.insert(iri(&individual(record, place))?, place);
        for triple in derived_triples(record, place)? {
            if let Object::Iri(object) = triple.object {
                *repeated
                    .entry([triple.subject, triple.predicate, object])
                    .or_default() += 1;
            }
        }
    }
    for (place, statements) in left.into_iter().enumerate() {
        let subject = iri(&individual(record, place))?;
        let mut kept = Vec::new();
        // Backwards, because derived triples follow those of the record.
        for (property, object) in statements.into_iter().rev() {
            let Object::Iri(object) = object else {
                continue;
            };
            let predicate = ontology.expand(&property)?;
            let key = [subject.clone(), predicate, object];
            if let Some(count) = repeated.get_mut(&key)
                && *count > 0
            {
                *count -= 1;
                continue;
            }
            let [_, _, object] = key;
            let object = match places.get(&object) {
                Some(place) => format!("#{place}"),
                None => ontology
                    .compact(&object)
                    .ok_or(NeemError::Iri { iri: object })?,
            };
            kept.push((property, object));
        }
        let relations = &mut record.individuals[place].relations;
        for (property, object) in kept.into_iter().rev() {
            relations.entry(property).or_default().push(object);
        }
    }
    Ok(())
}
