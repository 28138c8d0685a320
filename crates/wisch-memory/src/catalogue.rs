//! The catalogue: the graphs of all episodes in columns, which answer queries without opening an episode.

pub(crate) mod cache;

use crate::id::is_date;
use crate::record::{EpisodeRecord, PERFORMANCE, Value, individual_name};
use std::collections::HashMap;

/// Index of an individual in a [`Catalogue`].
pub type IndividualId = u32;

/// Joins the first few items, and states how many more there are.
pub(crate) fn list_some(items: &[String], separator: &str) -> String {
    let mut text = items[..items.len().min(MOST_NAMED)].join(separator);
    if items.len() > MOST_NAMED {
        text += &format!("{separator}{} more", items.len() - MOST_NAMED);
    }
    text
}

/// The object of a relation between individuals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CatalogueNode {
    /// An individual of an episode.
    Individual(IndividualId),
    /// Something that episodes share, for example a tool: its index in [`Catalogue::shared_individuals`].
    Shared(u32),
}

/// The graphs of all episodes, in columns.
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    episodes: Vec<EpisodeRow>,
    by_id: HashMap<String, u32>,
    names: Names,
    classes: Vec<u16>,
    starts: Vec<f64>,
    ends: Vec<f64>,
    parents: Vec<u32>,
    of_class: Vec<Vec<IndividualId>>,
    values: Vec<Column>,
    texts: Vec<Vec<(IndividualId, String)>>,
    relations: Vec<Vec<(IndividualId, CatalogueNode)>>,
    left_out: Vec<String>,
}

/// The entry of an episode in the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub struct EpisodeRow {
    /// Its name.
    pub id: String,
    /// Name of the task.
    pub task: String,
    /// Begin and end [s since 1970].
    pub interval: [f64; 2],
    /// Start of each round [s since 1970].
    pub rounds: Vec<f64>,
    /// Index of its first individual; its other individuals follow.
    pub first: IndividualId,
    /// Number of its individuals.
    pub len: u32,
}

/// Numbers of one property, by individual.
#[derive(Debug, Clone, Default)]
struct Column(Vec<(IndividualId, f64)>);

/// Index of names.
#[derive(Debug, Clone, Default)]
struct Names {
    classes: Interned,
    properties: Interned,
    shared: Interned,
}

#[derive(Debug, Clone, Default)]
struct Interned {
    names: Vec<String>,
    numbers: HashMap<String, u32>,
}

impl Interned {
    fn number(&mut self, name: &str) -> u32 {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = u32::try_from(self.names.len()).unwrap_or(u32::MAX);
        self.names.push(name.to_owned());
        self.numbers.insert(name.to_owned(), number);
        number
    }

    fn find(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).map(|&number| number as usize)
    }
}

/// Largest number of episodes or values that a remark names.
const MOST_NAMED: usize = 3;
/// Stands for an individual without a parent.
const NONE: u32 = u32::MAX;

impl Catalogue {
    /// Returns the catalogue of the given episodes.
    pub fn from_records<'a>(records: impl IntoIterator<Item = &'a EpisodeRecord>) -> Self {
        let mut catalogue = Self::default();
        for record in records {
            catalogue.push(record);
        }
        catalogue
    }

    /// Adds an episode; an episode that is already in the catalogue stays as it is.
    pub fn push(&mut self, record: &EpisodeRecord) {
        if self.by_id.contains_key(&record.id) {
            return;
        }
        let first = u32::try_from(self.classes.len()).unwrap_or(NONE);
        let number = u32::try_from(self.episodes.len()).unwrap_or(NONE);
        self.by_id.insert(record.id.clone(), number);
        self.episodes.push(EpisodeRow {
            id: record.id.clone(),
            task: record.task.clone(),
            interval: record.interval,
            rounds: record.rounds.clone(),
            first,
            len: u32::try_from(record.individuals.len()).unwrap_or(NONE),
        });
        for (id, individual) in (first..).zip(&record.individuals) {
            let class = self.names.classes.number(&individual.class);
            self.classes.push(u16::try_from(class).unwrap_or(u16::MAX));
            at(&mut self.of_class, class).push(id);
            let [start, end] = individual.interval.unwrap_or([f64::NAN; 2]);
            self.starts.push(start);
            self.ends.push(end);
            let parent = individual
                .parent
                .and_then(|place| u32::try_from(place).ok());
            self.parents
                .push(parent.map_or(NONE, |place| first + place));
            for (property, value) in &individual.values {
                if property == PERFORMANCE && individual.performance().is_none() {
                    continue;
                }
                let property = self.names.properties.number(property);
                match value {
                    Value::Number(value) => at(&mut self.values, property).0.push((id, *value)),
                    Value::Text(text) => at(&mut self.texts, property).push((id, text.clone())),
                }
            }
            for (property, objects) in &individual.relations {
                let property = self.names.properties.number(property);
                for object in objects {
                    let node = match object.strip_prefix('#').map(str::parse::<u32>) {
                        Some(Ok(place)) => CatalogueNode::Individual(first + place),
                        _ => CatalogueNode::Shared(self.names.shared.number(object)),
                    };
                    at(&mut self.relations, property).push((id, node));
                }
            }
        }
    }

    /// Returns the catalogue of the episodes that `keep` accepts, in the same order.
    pub fn retain(&self, mut keep: impl FnMut(&EpisodeRow) -> bool) -> Self {
        let mut kept = Self {
            names: self.names.clone(),
            ..Self::default()
        };
        // New index of each individual.
        let mut moved = vec![NONE; self.classes.len()];
        for row in &self.episodes {
            if !keep(row) {
                continue;
            }
            let first = kept.classes.len() as u32;
            let number = kept.episodes.len() as u32;
            kept.by_id.insert(row.id.clone(), number);
            kept.episodes.push(EpisodeRow {
                first,
                ..row.clone()
            });
            for (new, old) in (first..).zip(row.first..row.first + row.len) {
                let place = old as usize;
                moved[place] = new;
                kept.classes.push(self.classes[place]);
                kept.starts.push(self.starts[place]);
                kept.ends.push(self.ends[place]);
                let parent = self.parents[place];
                kept.parents.push(match parent {
                    NONE => NONE,
                    parent => moved[parent as usize],
                });
                at(&mut kept.of_class, u32::from(self.classes[place])).push(new);
            }
        }
        let goes = |id: IndividualId| Some(moved[id as usize]).filter(|&new| new != NONE);
        kept.values = (self.values.iter())
            .map(|column| Column(move_entries(&column.0, goes, |value| Some(*value))))
            .collect();
        kept.texts = (self.texts.iter())
            .map(|column| move_entries(column, goes, |text| Some(text.clone())))
            .collect();
        kept.relations = (self.relations.iter())
            .map(|column| {
                move_entries(column, goes, |node| match *node {
                    CatalogueNode::Individual(id) => goes(id).map(CatalogueNode::Individual),
                    shared => Some(shared),
                })
            })
            .collect();
        kept
    }

    /// Episodes that the catalogue lacks because they cannot be read, each with the reason.
    pub fn omitted_episodes(&self) -> &[String] {
        &self.left_out
    }

    /// States which episodes have times that are no dates, if any: they compare with no time of another episode.
    pub(crate) fn describe_undated(&self) -> Option<String> {
        let undated = self.episodes.iter().filter(|row| !is_date(row.interval[0]));
        let ids: Vec<String> = undated.map(|row| row.id.clone()).collect();
        (!ids.is_empty()).then(|| {
            let some = list_some(&ids, ", ");
            format!("the dates of these episodes are unknown, their times count from the start of each log: {some}")
        })
    }

    /// States how many wiping actions have an interval of the performance only, if any: it is unknown, or at least the lower
    /// end of the interval.
    pub(crate) fn describe_unknown_performances(&self) -> Option<String> {
        let performances = self.numbers(PERFORMANCE);
        let actions = self.individuals_of_class("semco:WipingAction").iter();
        let unknown = actions.filter(|&&action| {
            !entries(self.numbers("semco:performanceLow"), action).is_empty()
                && entries(performances, action).is_empty()
        });
        let ids: Vec<String> = unknown.map(|&id| self.episode_of(id).id.clone()).collect();
        let episodes = match ids.len() {
            0 => return None,
            1 => "1 episode".to_owned(),
            count => format!("{count} episodes"),
        };
        let some = list_some(&ids, ", ");
        Some(format!(
            "{episodes} of the memory left out, whose performance is unknown or only known from below: {some}"
        ))
    }

    /// Records that an episode cannot be read.
    pub(crate) fn leave_out(&mut self, why: String) {
        self.left_out.push(why);
    }

    /// Returns the episodes that overlap an interval [s since 1970]. Episodes of simultaneous runs may overlap; if
    /// something in one of them has exactly this interval, only that episode is returned.
    pub fn episodes_during(&self, interval: [f64; 2]) -> Vec<&EpisodeRow> {
        let [from, to] = interval;
        let rows = self.episodes.iter();
        let during: Vec<&EpisodeRow> = rows
            .filter(|row| row.interval[0] <= to && row.interval[1] >= from)
            .collect();
        let is_meant = |row: &&&EpisodeRow| {
            let mut all = row.first..row.first + row.len;
            all.any(|id| self.interval(id) == Some(interval))
        };
        let meant: Vec<&EpisodeRow> = match during.len() {
            0 | 1 => Vec::new(),
            _ => during.iter().filter(is_meant).copied().collect(),
        };
        if meant.is_empty() { during } else { meant }
    }

    /// All episodes, in the order of their addition.
    pub fn episodes(&self) -> &[EpisodeRow] {
        &self.episodes
    }

    /// Returns the episode with this name.
    pub fn episode(&self, id: &str) -> Option<&EpisodeRow> {
        self.by_id
            .get(id)
            .map(|&number| &self.episodes[number as usize])
    }

    /// Number of individuals of all episodes.
    pub fn len(&self) -> usize {
        self.classes.len()
    }

    /// Whether the catalogue holds no individual.
    pub fn is_empty(&self) -> bool {
        self.classes.is_empty()
    }

    /// The classes that occur, with prefix.
    pub fn classes(&self) -> &[String] {
        &self.names.classes.names
    }

    /// The properties that occur, with prefix.
    pub fn properties(&self) -> &[String] {
        &self.names.properties.names
    }

    /// The things that episodes share, with prefix.
    pub fn shared_individuals(&self) -> &[String] {
        &self.names.shared.names
    }

    /// Returns the individuals of exactly this class, without subclasses.
    pub fn individuals_of_class(&self, class: &str) -> &[IndividualId] {
        let number = self.names.classes.find(class);
        number
            .and_then(|number| self.of_class.get(number))
            .map_or(&[], Vec::as_slice)
    }

    /// Returns the class of an individual, with prefix.
    ///
    /// # Panics
    /// This method and the methods below panic if the individual does not exist.
    pub fn class(&self, id: IndividualId) -> &str {
        &self.names.classes.names[usize::from(self.classes[id as usize])]
    }

    /// Begin and end of an individual [s since 1970], if it has a time.
    pub fn interval(&self, id: IndividualId) -> Option<[f64; 2]> {
        let interval = [self.starts[id as usize], self.ends[id as usize]];
        (!interval[0].is_nan()).then_some(interval)
    }

    /// The individual that this individual is part of.
    pub fn parent(&self, id: IndividualId) -> Option<IndividualId> {
        let parent = self.parents[id as usize];
        (parent != NONE).then_some(parent)
    }

    /// Returns the entry of an individual's episode.
    pub fn episode_of(&self, id: IndividualId) -> &EpisodeRow {
        let after = self.episodes.partition_point(|row| row.first <= id);
        &self.episodes[after.saturating_sub(1)]
    }

    /// The name of an individual, without prefix.
    pub fn name(&self, id: IndividualId) -> String {
        let episode = self.episode_of(id);
        individual_name(self.class(id), &episode.id, (id - episode.first) as usize)
    }

    /// Returns the individual with this name, without prefix.
    pub fn find(&self, name: &str) -> Option<IndividualId> {
        let (_, rest) = name.split_once('_')?;
        let (episode, place) = rest.rsplit_once('-')?;
        let row = self.episode(episode)?;
        let place: u32 = place.parse().ok()?;
        let id = row.first.checked_add(place).filter(|_| place < row.len)?;
        (self.name(id) == name).then_some(id)
    }

    /// All numbers of a property, by individual.
    pub fn numbers(&self, property: &str) -> &[(IndividualId, f64)] {
        let number = self.names.properties.find(property);
        number
            .and_then(|number| self.values.get(number))
            .map_or(&[], |column| &column.0)
    }

    /// All texts of a property, by individual.
    pub fn texts(&self, property: &str) -> &[(IndividualId, String)] {
        let number = self.names.properties.find(property);
        number
            .and_then(|number| self.texts.get(number))
            .map_or(&[], Vec::as_slice)
    }

    /// All relations of a property, by subject.
    pub fn relations(&self, property: &str) -> &[(IndividualId, CatalogueNode)] {
        let number = self.names.properties.find(property);
        number
            .and_then(|number| self.relations.get(number))
            .map_or(&[], Vec::as_slice)
    }
}

/// Returns the entries of a column whose subjects stay, with their new indices.
fn move_entries<T>(
    column: &[(IndividualId, T)],
    goes: impl Fn(IndividualId) -> Option<IndividualId>,
    object: impl Fn(&T) -> Option<T>,
) -> Vec<(IndividualId, T)> {
    let entries = column.iter();
    let entries = entries.filter_map(|(id, value)| Some((goes(*id)?, object(value)?)));
    entries.collect()
}

/// Returns the entry of a table, which grows if necessary.
fn at<T: Default>(table: &mut Vec<T>, number: u32) -> &mut T {
    let number = number as usize;
    if table.len() <= number {
        table.resize_with(number + 1, T::default);
    }
    &mut table[number]
}

/// Returns the entries of an individual in a column that is sorted by individual.
pub fn entries<T>(column: &[(IndividualId, T)], id: IndividualId) -> &[(IndividualId, T)] {
    let from = column.partition_point(|(subject, _)| *subject < id);
    let to = from + column[from..].partition_point(|(subject, _)| *subject == id);
    &column[from..to]
}
