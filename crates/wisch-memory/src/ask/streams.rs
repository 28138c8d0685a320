//! Answers that are computed while the engine reads them: joins and scans over large parts of the catalogue.

use super::assertions::Assertions;
use super::intervals::{IntervalIndex, Relation};
use super::names::Names;
use super::reply::AnswerRows;
use super::rows::{individual_row, name_of, relation_row, values};
use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, EpisodeRow, IndividualId, list_some};
use std::sync::Arc;

/// Sources of answers: episodes and people's statements.
pub struct Knowledge {
    /// The episodes.
    pub catalogue: Arc<Catalogue>,
    /// Resolver of names.
    pub names: Names,
    /// People's statements.
    pub assertions: Assertions,
}

impl Knowledge {
    /// States the values that people have added besides recorded ones, if any: queries find both.
    pub fn describe_additions(&self) -> Option<String> {
        let mut besides = Vec::new();
        for (subject, property, added) in self.assertions.all() {
            let Some(id) = self.names.individual(subject) else {
                continue;
            };
            if let Some(recorded) = values(&self.catalogue, property, id).next() {
                besides.push(format!(
                    "{property} of {subject} is {added}, recorded {recorded}"
                ));
            }
        }
        (!besides.is_empty()).then(|| {
            let some = list_some(&besides, "; ");
            format!("people added values besides recorded ones, and queries find both: {some}")
        })
    }

    /// Returns the facts about all individuals.
    pub fn individuals(&self) -> AnswerRows {
        let catalogue = Arc::clone(&self.catalogue);
        let ids = 0..u32::try_from(catalogue.len()).unwrap_or(u32::MAX);
        Box::new(ids.map(move |id| individual_row(&catalogue, id)))
    }

    /// Returns the values of a property, each with its thing.
    pub fn column(&self, property: &str) -> AnswerRows {
        let catalogue = Arc::clone(&self.catalogue);
        let property = property.to_owned();
        let asserted = self.assertions.values(&property);
        let (numbers, texts) = (
            catalogue.numbers(&property).len(),
            catalogue.texts(&property).len(),
        );
        let rows = (0..numbers + texts).map(move |place| {
            let (id, value) = if place < numbers {
                let (id, value) = catalogue.numbers(&property)[place];
                (id, Term::Float(value))
            } else {
                let (id, text) = &catalogue.texts(&property)[place - numbers];
                (*id, Term::atom(text))
            };
            Term::compound("-", [value, name_of(&catalogue, id)])
        });
        Box::new(rows.chain(asserted))
    }

    /// Returns the values of all individuals, by property.
    pub fn all_values(&self) -> AnswerRows {
        let mut properties = self.catalogue.properties().to_vec();
        // Properties that only people state.
        for (_, property, _) in self.assertions.all() {
            if !properties.contains(property) {
                properties.push(property.clone());
            }
        }
        let columns: Vec<AnswerRows> = properties.iter().map(|p| self.column(p)).collect();
        let columns = properties.into_iter().zip(columns);
        Box::new(columns.flat_map(|(property, column)| {
            column.filter_map(move |pair| match pair {
                Term::Compound(_, parts) => {
                    let [value, name] = <[Term; 2]>::try_from(parts).ok()?;
                    Some(Term::compound("v", [name, Term::atom(&property), value]))
                }
                _ => None,
            })
        }))
    }

    /// Returns relations, of one property or of all.
    pub fn relations(&self, property: Option<&str>) -> AnswerRows {
        let properties = match property {
            Some(property) => vec![property.to_owned()],
            None => self.catalogue.properties().to_vec(),
        };
        let asserted = self.assertions.relations(property);
        Box::new(self.relation_rows(properties, None).chain(asserted))
    }

    /// Returns relations whose object is a thing.
    pub fn related_to(&self, object: &str) -> AnswerRows {
        let asserted = self.assertions.related_to(object);
        let Some(wanted) = self.names.node(object) else {
            return Box::new(asserted.into_iter());
        };
        let properties = self.catalogue.properties().to_vec();
        Box::new(self.relation_rows(properties, Some(wanted)).chain(asserted))
    }

    /// Returns the catalogue's relations of some properties, optionally with the object `wanted`.
    fn relation_rows(
        &self,
        properties: Vec<String>,
        wanted: Option<CatalogueNode>,
    ) -> impl Iterator<Item = Term> + Send + use<> {
        let catalogue = Arc::clone(&self.catalogue);
        properties.into_iter().flat_map(move |property| {
            let catalogue = Arc::clone(&catalogue);
            let len = catalogue.relations(&property).len();
            (0..len).filter_map(move |place| {
                let (id, node) = catalogue.relations(&property)[place];
                let is_wanted = wanted.is_none_or(|wanted| node == wanted);
                is_wanted.then(|| relation_row(&catalogue, id, &property, node))
            })
        })
    }

    /// Returns the names of individuals, one per row.
    pub fn name_rows(&self, found: Vec<IndividualId>) -> AnswerRows {
        let catalogue = Arc::clone(&self.catalogue);
        Box::new((found.into_iter()).map(move |id| name_of(&catalogue, id)))
    }

    /// The names of individuals, with their times.
    pub fn interval_rows(&self, found: Vec<IndividualId>) -> AnswerRows {
        let catalogue = Arc::clone(&self.catalogue);
        Box::new(found.into_iter().map(move |id| {
            let [start, end] = catalogue.interval(id).unwrap_or_default().map(Term::Float);
            Term::compound("j", [name_of(&catalogue, id), start, end])
        }))
    }

    /// Returns pairs of individuals whose first has a relation of time to the second.
    pub fn pairs(&self, index: Arc<IntervalIndex>, relation: Relation) -> AnswerRows {
        let catalogue = Arc::clone(&self.catalogue);
        Box::new((0..index.len()).flat_map(move |place| {
            let (to, second) = index.entry(place);
            let firsts = index.find_related(relation, to).into_iter();
            let catalogue = Arc::clone(&catalogue);
            let others = firsts.filter(move |first| *first != second);
            others.map(move |first| {
                Term::compound("-", [first, second].map(|id| name_of(&catalogue, id)))
            })
        }))
    }

    /// Returns the episode that began last. Ends are not compared: an episode ends by the robot's
    /// time, and a simulation runs faster than that.
    pub fn last_episode(&self) -> Option<&EpisodeRow> {
        let episodes = self.catalogue.episodes().iter();
        episodes.max_by(|a, b| a.interval[0].total_cmp(&b.interval[0]))
    }
}
