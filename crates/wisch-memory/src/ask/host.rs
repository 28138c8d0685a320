//! What the engine asks for, answered from the catalogue and the ontology.

use super::intervals::{IntervalIndex, Relation};
use super::names::Names;
use super::senses::Senses;
use super::term::Term;
use super::told::Told;
use super::{AskError, Fault};
use crate::catalogue::{Catalogue, IndividualId, Node, entries};
use crate::ontology::Ontology;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Rows of the first chunk of a stream, and of the largest; each is four times the one before.
const CHUNK: [usize; 2] = [64, 512];
/// Facts that are sent at once; an engine takes the longer for each the more come together.
const FACTS_AT_ONCE: usize = 512;
/// Individuals of a class that come together: those beside the one that is asked for, mostly of its episode.
const INDIVIDUALS_AT_ONCE: usize = 8;
/// Values of a property that come together.
const VALUES_AT_ONCE: usize = 64;
/// Most individuals that a filter finds and the engine keeps; more are told again each time.
const FILTERED_FACTS: usize = 20_000;

/// Most members of a class that the engine keeps, with times and parents; more are named one after the other.
const MOST_MEMBERS: usize = 30_000;

/// Rows that are made when they are asked for.
type Rows = Box<dyn Iterator<Item = Term> + Send>;

/// Answers the needs of one engine; knows what that engine already has.
pub struct Host {
    catalogue: Arc<Catalogue>,
    ontology: &'static Ontology,
    names: Names,
    intervals: Option<Arc<IntervalIndex>>,
    senses: Senses,
    told: Told,
    sent: Sent,
    cursors: HashMap<i64, Cursor>,
    next_cursor: i64,
}

/// What an engine has been sent: facts are kept there once.
#[derive(Debug, Default)]
struct Sent {
    individuals: HashSet<IndividualId>,
    parts: HashSet<String>,
    values: HashMap<String, HashSet<IndividualId>>,
    statements: HashSet<IndividualId>,
    told: HashSet<String>,
}

pub(super) struct Cursor {
    rows: std::iter::Peekable<Rows>,
    size: usize,
}

impl Host {
    /// A host for a new engine.
    pub fn new(catalogue: Arc<Catalogue>, senses: Senses, told: Told) -> Self {
        let ontology = Ontology::shipped();
        Self {
            names: Names::new(Arc::clone(&catalogue), ontology),
            catalogue,
            ontology,
            intervals: None,
            senses,
            told,
            sent: Sent::default(),
            cursors: HashMap::new(),
            next_cursor: 0,
        }
    }

    /// The same for an engine that knows nothing yet.
    pub fn forget(&mut self) {
        self.sent = Sent::default();
        self.cursors.clear();
    }

    /// Drops streams that nobody will read on.
    pub fn end_query(&mut self) {
        self.cursors.clear();
    }

    /// What is to be sent in answer to a request.
    ///
    /// # Errors
    /// The program failed; what a query did wrong is an answer.
    pub fn answer(&mut self, request: &Term, reply: &mut String) -> Result<(), AskError> {
        match self.rows(request) {
            Ok(Reply::Facts(facts)) if facts.len() <= FACTS_AT_ONCE => {
                Term::compound("rows", [Term::List(facts)]).write_quoted(reply);
            }
            Ok(Reply::Facts(facts)) => {
                let rows: Rows = Box::new(facts.into_iter());
                let cursor = Cursor {
                    rows: rows.peekable(),
                    size: FACTS_AT_ONCE,
                };
                self.next_chunk(cursor, reply);
            }
            Ok(Reply::Stream(rows)) => {
                let cursor = Cursor {
                    rows: rows.peekable(),
                    size: CHUNK[0],
                };
                self.next_chunk(cursor, reply);
            }
            Ok(Reply::More(cursor)) => self.next_chunk(cursor, reply),
            Err(Refusal::Fault(fault)) => {
                Term::compound("fault", [fault.to_term()]).write_quoted(reply);
            }
            Err(Refusal::Error(error)) => return Err(error),
        }
        Ok(())
    }

    fn next_chunk(&mut self, mut cursor: Cursor, reply: &mut String) {
        let rows: Vec<Term> = cursor.rows.by_ref().take(cursor.size).collect();
        if cursor.rows.peek().is_none() {
            Term::compound("rows", [Term::List(rows)]).write_quoted(reply);
            return;
        }
        cursor.size = (cursor.size * 4).min(CHUNK[1]);
        let number = self.next_cursor;
        self.next_cursor += 1;
        self.cursors.insert(number, cursor);
        Term::compound("chunk", [Term::Integer(number), Term::List(rows)]).write_quoted(reply);
    }

    #[allow(clippy::too_many_lines, reason = "a table of requests")]
    fn rows(&mut self, request: &Term) -> Result<Reply, Refusal> {
        let malformed = || {
            Refusal::Error(AskError::Protocol {
                line: request.to_string(),
            })
        };
        let (name, arguments) = request.parts().ok_or_else(malformed)?;
        let facts = |facts: Vec<Term>| Ok(Reply::Facts(facts));
        match (name, arguments) {
            ("more", [Term::Integer(cursor)]) => {
                let rows = self.cursors.remove(cursor).ok_or_else(malformed)?;
                Ok(Reply::More(rows))
            }
            ("resolve", [kind, term]) => {
                let kind = kind.as_atom().ok_or_else(malformed)?;
                let name = self.names.resolve(kind, term).map_err(Refusal::Fault)?;
                facts(vec![Term::Atom(name)])
            }
            ("subclasses", [Term::Atom(name)]) => facts(self.names.subclasses(name)),
            ("superclasses", [Term::Atom(name)]) => facts(self.names.superclasses(name)),
            ("subproperties", [Term::Atom(name)]) => facts(self.names.subproperties(name)),
            ("superproperties", [Term::Atom(name)]) => facts(self.names.superproperties(name)),
            ("classes", []) => facts(self.ontology.classes().map(Term::atom).collect()),
            ("members", [Term::Atom(class)]) => facts(self.members(class)),
            ("named_members", [Term::Atom(class)]) => {
                let shared = self.names.shared_of(class).into_iter().map(Term::Atom);
                let members = self.named(self.catalogue.of_class(class).to_vec());
                Ok(Reply::Stream(Box::new(members.chain(shared))))
            }
            ("size", [Term::Compound(members, of)]) if members == "members" => {
                let [Term::Atom(class)] = of.as_slice() else {
                    return Err(malformed());
                };
                let count = self.catalogue.of_class(class).len();
                let size = if count > MOST_MEMBERS { "many" } else { "few" };
                facts(vec![Term::atom(size)])
            }
            ("individual", [Term::Atom(name)]) => facts(self.individual(name)),
            ("parts", [Term::Atom(name)]) => facts(self.parts(name)),
            ("statements", [Term::Atom(name)]) => facts(self.statements(name)),
            ("values_of", [Term::Atom(name), Term::Atom(property)]) => {
                facts(self.values_of(name, property))
            }
            ("individuals", []) => Ok(Reply::Stream(self.individuals())),
            ("values", []) => Ok(Reply::Stream(self.all_values())),
            ("values", [Term::Atom(property)]) => Ok(Reply::Stream(self.column(property))),
            ("filter", [Term::Atom(property), Term::Atom(operator), bound]) => {
                let bound = bound.as_number().ok_or_else(malformed)?;
                let found = self.filter(property, operator, bound)?;
                if found.len() > FILTERED_FACTS {
                    return Ok(Reply::Stream(self.named(found)));
                }
                facts(
                    found
                        .chunks(FACTS_AT_ONCE)
                        .map(|ids| {
                            let names = ids
                                .iter()
                                .map(|&id| Term::Atom(full_name(&self.catalogue, id)));
                            Term::compound("f", [request.clone(), Term::List(names.collect())])
                        })
                        .collect(),
                )
            }
            ("size", [Term::Compound(filter, of)]) if filter == "filter" => {
                let [Term::Atom(property), Term::Atom(operator), bound] = of.as_slice() else {
                    return Err(malformed());
                };
                let bound = bound.as_number().ok_or_else(malformed)?;
                let found = self.filter(property, operator, bound)?;
                let size = if found.len() > FILTERED_FACTS {
                    "many"
                } else {
                    "few"
                };
                facts(vec![Term::atom(size)])
            }
            ("relations", []) => Ok(Reply::Stream(self.relations(None))),
            ("relations", [Term::Atom(property)]) => {
                Ok(Reply::Stream(self.relations(Some(property))))
            }
            ("related_to", [Term::Atom(object)]) => Ok(Reply::Stream(self.related_to(object))),
            ("at", [start, end]) => {
                let times = times(start, end).ok_or_else(malformed)?;
                let found = self.intervals().related(Relation::Equals, times);
                Ok(Reply::Stream(self.named(found)))
            }
            ("relation", [Term::Atom(relation), start, end]) => {
                let times = times(start, end).ok_or_else(malformed)?;
                let relation = Relation::named(relation).ok_or_else(malformed)?;
                let found = self.intervals().related(relation, times);
                Ok(Reply::Stream(self.timed(found)))
            }
            ("pairs", [Term::Atom(relation)]) => {
                let relation = Relation::named(relation).ok_or_else(malformed)?;
                Ok(Reply::Stream(self.pairs(relation)))
            }
            ("first_rounds", [Term::Atom(property)]) => {
                Ok(Reply::Stream(self.first_rounds(property)))
            }
            ("last_episode", []) => facts(self.last_episode()),
            ("tell", [subject, Term::Atom(property), object]) => {
                let subject = subject.as_atom().ok_or_else(malformed)?;
                let fact = self.told.tell(subject, property, object)?;
                facts(vec![fact])
            }
            _ => self.senses.rows(&self.catalogue, name, arguments),
        }
    }

    fn intervals(&mut self) -> Arc<IntervalIndex> {
        let catalogue = &self.catalogue;
        let index = self
            .intervals
            .get_or_insert_with(|| Arc::new(IntervalIndex::of(catalogue)));
        Arc::clone(index)
    }

    fn members(&mut self, class: &str) -> Vec<Term> {
        let catalogue = Arc::clone(&self.catalogue);
        let mut facts = Vec::new();
        let members = catalogue.of_class(class);
        let mut names: Vec<Term> = Vec::with_capacity(members.len());
        for &id in members {
            self.send_individual(id, &mut facts);
            names.push(Term::Atom(full_name(&catalogue, id)));
        }
        for name in self.names.shared_of(class) {
            if self.sent.parts.insert(format!("i {name}")) {
                facts.push(shared_row(&name, class));
            }
            names.push(Term::Atom(name));
        }
        for names in names.chunks(FACTS_AT_ONCE) {
            let names = Term::List(names.to_vec());
            facts.push(Term::compound("c", [Term::atom(class), names]));
        }
        facts
    }

    fn send_individual(&mut self, id: IndividualId, facts: &mut Vec<Term>) {
        if self.sent.individuals.insert(id) {
            facts.push(row(&self.catalogue, id));
        }
    }

    /// The facts of an individual, and of its neighbours of the same class: whoever asks for one mostly asks for more.
    fn individual(&mut self, name: &str) -> Vec<Term> {
        let mut facts = Vec::new();
        if let Some(id) = self.names.individual(name) {
            let catalogue = Arc::clone(&self.catalogue);
            let alike = catalogue.of_class(catalogue.class(id));
            let place = alike.partition_point(|other| *other < id) / INDIVIDUALS_AT_ONCE;
            for &other in alike
                .iter()
                .skip(place * INDIVIDUALS_AT_ONCE)
                .take(INDIVIDUALS_AT_ONCE)
            {
                self.send_individual(other, &mut facts);
            }
        } else if let Some(class) = self.names.class_of_shared(name)
            && self.sent.parts.insert(format!("i {name}"))
        {
            facts.push(shared_row(name, &class));
        }
        facts
    }

    fn parts(&mut self, name: &str) -> Vec<Term> {
        let Some(id) = self.names.individual(name) else {
            return Vec::new();
        };
        let catalogue = Arc::clone(&self.catalogue);
        let episode = catalogue.episode_of(id);
        if !self.sent.parts.insert(episode.id.clone()) {
            return Vec::new();
        }
        let mut facts = Vec::new();
        for id in episode.first..episode.first + episode.len {
            self.send_individual(id, &mut facts);
            let name = Term::Atom(full_name(&catalogue, id));
            if let Some(parent) = catalogue.parent(id) {
                let parent = Term::Atom(full_name(&catalogue, parent));
                facts.push(Term::compound("k", [parent, name.clone()]));
            }
            let request = Term::compound("parts", [name]);
            facts.push(Term::compound("loaded", [request]));
        }
        facts
    }

    /// Values and relations of one thing.
    fn statements(&mut self, name: &str) -> Vec<Term> {
        let mut facts = self.told_once(name);
        let Some(id) = self.names.individual(name) else {
            return facts;
        };
        if !self.sent.statements.insert(id) {
            return facts;
        }
        let catalogue = Arc::clone(&self.catalogue);
        for property in catalogue.properties() {
            for (_, node) in entries(catalogue.relations(property), id) {
                let object = Term::Atom(node_name(&catalogue, *node));
                facts.push(Term::compound(
                    "r",
                    [Term::atom(name), Term::atom(property), object],
                ));
            }
            if !self.is_new_value(property, id) {
                continue;
            }
            for (_, value) in entries(catalogue.numbers(property), id) {
                facts.push(value_row(name, property, Term::Float(*value)));
            }
            for (_, text) in entries(catalogue.texts(property), id) {
                facts.push(value_row(name, property, Term::atom(text)));
            }
        }
        facts
    }

    fn told_once(&mut self, name: &str) -> Vec<Term> {
        if self.told.is_empty() || !self.sent.told.insert(name.to_owned()) {
            return Vec::new();
        }
        self.told.about(name)
    }

    fn is_new_value(&mut self, property: &str, id: IndividualId) -> bool {
        if let Some(sent) = self.sent.values.get_mut(property) {
            return sent.insert(id);
        }
        let sent = HashSet::from([id]);
        self.sent.values.insert(property.to_owned(), sent);
        true
    }

    /// Values of one property, of this thing and of its neighbours of the same class.
    fn values_of(&mut self, name: &str, property: &str) -> Vec<Term> {
        let mut facts = self.told_once(name);
        let Some(id) = self.names.individual(name) else {
            return facts;
        };
        let catalogue = Arc::clone(&self.catalogue);
        let alike = catalogue.of_class(catalogue.class(id));
        let place = alike.partition_point(|other| *other < id) / VALUES_AT_ONCE;
        for &other in alike
            .iter()
            .skip(place * VALUES_AT_ONCE)
            .take(VALUES_AT_ONCE)
        {
            let numbers = entries(catalogue.numbers(property), other);
            let texts = entries(catalogue.texts(property), other);
            if numbers.is_empty() && texts.is_empty() || !self.is_new_value(property, other) {
                continue;
            }
            let name = full_name(&catalogue, other);
            let numbers = numbers.iter().map(|(_, value)| Term::Float(*value));
            let texts = texts.iter().map(|(_, text)| Term::atom(text));
            facts.extend(
                numbers
                    .chain(texts)
                    .map(|value| value_row(&name, property, value)),
            );
        }
        facts
    }

    fn individuals(&self) -> Rows {
        let catalogue = Arc::clone(&self.catalogue);
        let ids = 0..count(&catalogue);
        Box::new(ids.map(move |id| row(&catalogue, id)))
    }

    fn column(&self, property: &str) -> Rows {
        let catalogue = Arc::clone(&self.catalogue);
        let property = property.to_owned();
        let told = self.told.values(&property);
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
            Term::compound("-", [value, Term::Atom(full_name(&catalogue, id))])
        });
        Box::new(rows.chain(told))
    }

    fn all_values(&self) -> Rows {
        let properties = self.catalogue.properties().to_vec();
        let columns: Vec<Rows> = properties.iter().map(|p| self.column(p)).collect();
        Box::new(
            properties
                .into_iter()
                .zip(columns)
                .flat_map(|(property, column)| {
                    column.filter_map(move |pair| match pair {
                        Term::Compound(_, parts) => {
                            let [value, name] = <[Term; 2]>::try_from(parts).ok()?;
                            Some(Term::compound("v", [name, Term::atom(&property), value]))
                        }
                        _ => None,
                    })
                }),
        )
    }

    fn filter(
        &self,
        property: &str,
        operator: &str,
        bound: f64,
    ) -> Result<Vec<IndividualId>, Refusal> {
        #[allow(clippy::float_cmp, reason = "what is asked for")]
        let matches: fn(f64, f64) -> bool = match operator {
            "=<" => |value, bound| value <= bound,
            ">=" => |value, bound| value >= bound,
            "<" => |value, bound| value < bound,
            ">" => |value, bound| value > bound,
            "=:=" => |value, bound| value == bound,
            _ => {
                return Err(Refusal::Error(AskError::Protocol {
                    line: format!("filter with {operator}"),
                }));
            }
        };
        let numbers = self.catalogue.numbers(property).iter();
        let matching = numbers.filter(|(_, value)| matches(*value, bound));
        Ok(matching.map(|(id, _)| *id).collect())
    }

    fn relations(&self, property: Option<&str>) -> Rows {
        let properties = match property {
            Some(property) => vec![property.to_owned()],
            None => self.catalogue.properties().to_vec(),
        };
        let told = self.told.relations(property);
        let catalogue = Arc::clone(&self.catalogue);
        let rows = properties.into_iter().flat_map(move |property| {
            let catalogue = Arc::clone(&catalogue);
            let len = catalogue.relations(&property).len();
            (0..len).map(move |place| {
                let (id, node) = catalogue.relations(&property)[place];
                relation_row(&catalogue, id, &property, node)
            })
        });
        Box::new(rows.chain(told))
    }

    fn related_to(&self, object: &str) -> Rows {
        let told = self.told.related_to(object);
        let Some(wanted) = self.names.node(object) else {
            return Box::new(told.into_iter());
        };
        let properties = self.catalogue.properties().to_vec();
        let catalogue = Arc::clone(&self.catalogue);
        let rows = properties.into_iter().flat_map(move |property| {
            let catalogue = Arc::clone(&catalogue);
            let len = catalogue.relations(&property).len();
            (0..len).filter_map(move |place| {
                let (id, node) = catalogue.relations(&property)[place];
                (node == wanted).then(|| relation_row(&catalogue, id, &property, node))
            })
        });
        Box::new(rows.chain(told))
    }

    fn named(&self, found: Vec<IndividualId>) -> Rows {
        let catalogue = Arc::clone(&self.catalogue);
        Box::new((found.into_iter()).map(move |id| Term::Atom(full_name(&catalogue, id))))
    }

    fn timed(&self, found: Vec<IndividualId>) -> Rows {
        let catalogue = Arc::clone(&self.catalogue);
        Box::new(found.into_iter().map(move |id| {
            let [start, end] = catalogue.interval(id).unwrap_or_default();
            let name = Term::Atom(full_name(&catalogue, id));
            Term::compound("j", [name, Term::Float(start), Term::Float(end)])
        }))
    }

    fn pairs(&mut self, relation: Relation) -> Rows {
        let index = self.intervals();
        let catalogue = Arc::clone(&self.catalogue);
        Box::new((0..index.len()).flat_map(move |place| {
            let (to, second) = index.entry(place);
            let firsts = index.related(relation, to).into_iter();
            let catalogue = Arc::clone(&catalogue);
            let others = firsts.filter(move |first| *first != second);
            others.map(move |first| {
                let name = |id| Term::Atom(full_name(&catalogue, id));
                Term::compound("-", [name(first), name(second)])
            })
        }))
    }

    /// Of the first round of each wiping: surface, start and a value.
    fn first_rounds(&self, property: &str) -> Rows {
        let catalogue = Arc::clone(&self.catalogue);
        let property = property.to_owned();
        let len = catalogue.numbers(&property).len();
        Box::new((0..len).filter_map(move |place| {
            let (id, value) = catalogue.numbers(&property)[place];
            let round = entries(catalogue.numbers("semco:round"), id).first()?;
            let [start, _] = catalogue.interval(id)?;
            let surface = entries(catalogue.relations("semco:actsOnSurface"), id).first()?;
            let surface = Term::Atom(node_name(&catalogue, surface.1));
            let is_first = round.1 < 1.5;
            is_first.then(|| Term::compound("x", [surface, Term::Float(start), Term::Float(value)]))
        }))
    }

    fn last_episode(&self) -> Vec<Term> {
        let episodes = self.catalogue.episodes().iter();
        let last = episodes.max_by(|a, b| a.interval[1].total_cmp(&b.interval[1]));
        let row = last.map(|episode| {
            let name = Term::Atom(full_name(&self.catalogue, episode.first));
            Term::compound("-", [name, Term::Float(episode.interval[1])])
        });
        row.into_iter().collect()
    }
}

/// What is sent in answer.
pub(super) enum Reply {
    /// All at once.
    Facts(Vec<Term>),
    /// As they are asked for.
    Stream(Rows),
    /// The rest of those.
    More(Cursor),
}

/// Why nothing is sent.
pub(super) enum Refusal {
    /// What the query did wrong.
    Fault(Fault),
    /// What the program did wrong.
    Error(AskError),
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl From<AskError> for Refusal {
    fn from(error: AskError) -> Self {
        Self::Error(error)
    }
}

fn count(catalogue: &Catalogue) -> u32 {
    u32::try_from(catalogue.len()).unwrap_or(u32::MAX)
}

fn times(start: &Term, end: &Term) -> Option<[f64; 2]> {
    Some([start.as_number()?, end.as_number()?])
}

/// An individual's name, with prefix.
pub(super) fn full_name(catalogue: &Catalogue, id: IndividualId) -> String {
    format!("semco:{}", catalogue.name(id))
}

fn node_name(catalogue: &Catalogue, node: Node) -> String {
    match node {
        Node::Individual(id) => full_name(catalogue, id),
        Node::Shared(number) => catalogue.shared()[number as usize].clone(),
    }
}

fn row(catalogue: &Catalogue, id: IndividualId) -> Term {
    let none = || Term::atom("none");
    let [start, end] = match catalogue.interval(id) {
        Some(interval) => interval.map(Term::Float),
        None => [none(), none()],
    };
    let parent = catalogue.parent(id);
    let parent = parent.map_or_else(none, |parent| Term::Atom(full_name(catalogue, parent)));
    let episode = Term::Atom(full_name(catalogue, catalogue.episode_of(id).first));
    let name = Term::Atom(full_name(catalogue, id));
    let class = Term::atom(catalogue.class(id));
    Term::compound("i", [name, class, start, end, parent, episode])
}

fn shared_row(name: &str, class: &str) -> Term {
    let none = || Term::atom("none");
    let [name, class] = [name, class].map(Term::atom);
    Term::compound("i", [name, class, none(), none(), none(), none()])
}

fn value_row(name: &str, property: &str, value: Term) -> Term {
    Term::compound("v", [Term::atom(name), Term::atom(property), value])
}

fn relation_row(catalogue: &Catalogue, id: IndividualId, property: &str, node: Node) -> Term {
    let name = Term::Atom(full_name(catalogue, id));
    let object = Term::Atom(node_name(catalogue, node));
    Term::compound("r", [name, Term::atom(property), object])
}
