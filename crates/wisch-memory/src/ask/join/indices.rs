//! Indices that find facts by their objects; built on first use.

use crate::ask::intervals::IntervalIndex;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId};
use std::collections::HashMap;
use std::sync::Arc;

/// Relations of a property by their objects: positions in the column.
pub type ByObject = HashMap<CatalogueNode, Vec<u32>>;

/// Intervals in the order of their starts.
#[derive(Debug)]
pub struct Timeline {
    /// The intervals.
    pub intervals: Arc<IntervalIndex>,
    /// Position of each individual among them.
    places: Vec<u32>,
}

impl Timeline {
    /// Returns the position of an individual with a time.
    pub fn place(&self, id: IndividualId) -> u32 {
        self.places[id as usize]
    }
}

/// The direct parts of each individual.
#[derive(Debug)]
pub struct Children {
    /// Start of each individual's parts in the list of all parts, with a final end.
    begins: Vec<u32>,
    all: Vec<IndividualId>,
}

impl Children {
    fn of_all(catalogue: &Catalogue) -> Self {
        let ids = 0..u32::try_from(catalogue.len()).unwrap_or(u32::MAX);
        let parents = ids.filter_map(|id| Some((catalogue.parent(id)?, id)));
        let mut pairs: Vec<(IndividualId, IndividualId)> = parents.collect();
        pairs.sort_unstable();
        let mut begins = vec![0; catalogue.len() + 1];
        for (parent, _) in &pairs {
            begins[*parent as usize + 1] += 1;
        }
        for place in 1..begins.len() {
            begins[place] += begins[place - 1];
        }
        let all = pairs.into_iter().map(|(_, id)| id).collect();
        Self { begins, all }
    }

    /// Returns the direct parts of an individual.
    pub fn parts(&self, whole: IndividualId) -> &[IndividualId] {
        let [from, to] = [whole, whole + 1].map(|place| self.begins[place as usize] as usize);
        &self.all[from..to]
    }
}

/// Indices of a catalogue that are built on demand.
#[derive(Debug, Default)]
pub struct Indices {
    timeline: Option<Arc<Timeline>>,
    by_object: HashMap<String, Arc<ByObject>>,
    children: Option<Arc<Children>>,
}

impl Indices {
    /// Returns the intervals of all individuals with a time.
    pub fn timeline(&mut self, catalogue: &Catalogue) -> Arc<Timeline> {
        let timeline = self.timeline.get_or_insert_with(|| {
            let intervals = Arc::new(IntervalIndex::from_catalogue(catalogue));
            let mut places = vec![u32::MAX; catalogue.len()];
            for place in 0..intervals.len() {
                let (_, id) = intervals.entry(place);
                places[id as usize] = u32::try_from(place).unwrap_or(u32::MAX);
            }
            Arc::new(Timeline { intervals, places })
        });
        Arc::clone(timeline)
    }

    /// Returns the parts of all individuals.
    pub fn children(&mut self, catalogue: &Catalogue) -> Arc<Children> {
        let children = &mut self.children;
        Arc::clone(children.get_or_insert_with(|| Arc::new(Children::of_all(catalogue))))
    }

    /// Returns the relations of a property by their objects.
    pub fn relations_by_object(&mut self, catalogue: &Catalogue, property: &str) -> Arc<ByObject> {
        if let Some(found) = self.by_object.get(property) {
            return Arc::clone(found);
        }
        let mut index = ByObject::new();
        for (place, (_, node)) in (0..).zip(catalogue.relations(property)) {
            index.entry(*node).or_default().push(place);
        }
        let index = Arc::new(index);
        self.by_object
            .insert(property.to_owned(), Arc::clone(&index));
        index
    }
}
