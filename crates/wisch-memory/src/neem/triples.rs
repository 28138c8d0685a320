//! An episode as triples: assertions about its individuals, derived triples, and the record itself.

use super::NeemError;
use crate::ontology::{Ontology, TermKind};
use crate::record::{EpisodeRecord, Individual, Origin, Value};

/// The object of a triple: a name or a literal.
#[derive(Debug, Clone, PartialEq)]
pub enum Object {
    /// A thing, by its IRI.
    Iri(String),
    /// A number, in the property's unit.
    Number(f64),
    /// A text.
    Text(String),
}

/// A statement that holds over an interval of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Triple {
    /// IRI of the subject.
    pub subject: String,
    /// IRI of the property.
    pub predicate: String,
    /// Value of the property.
    pub object: Object,
    /// Start of its validity [s since 1970]; 0 for always.
    pub since: f64,
    /// End of its validity [s since 1970]; infinite for ever.
    pub until: f64,
}

pub(super) const TYPE: &str = "rdf:type";
pub(super) const NAMED: &str = "owl:NamedIndividual";
pub(super) const STEP_OF: &str = "semco:isStepOf";
pub(super) const HAS_INTERVAL: &str = "dul:hasTimeInterval";
pub(super) const BEGIN: &str = "soma:hasIntervalBegin";
pub(super) const END: &str = "soma:hasIntervalEnd";
pub(super) const RECORD: &str = "semco:EpisodeRecord";

/// Forces of an event: its value, the relation to the force as a region, and the ending of the region's name.
const FORCES: [(&str, &str, &str); 2] = [
    ("semco:meanNormalForce", "semco:hasMeanForce", "mean"),
    ("semco:peakForce", "semco:hasPeakForce", "peak"),
];

/// Name with prefix of an episode's individual.
pub(super) fn individual(record: &EpisodeRecord, place: usize) -> String {
    format!("semco:{}", record.name(place))
}

/// Name with prefix of something that belongs to an individual. It ends with a letter, unlike an individual's name.
fn belonging(class: &str, record: &EpisodeRecord, place: usize, end: &str) -> String {
    format!("semco:{class}_{}-{place}{end}", record.id)
}

/// Name with prefix of an episode's record.
pub(super) fn record_name(id: &str) -> String {
    format!("{RECORD}_{id}-record")
}

/// Builder of triples about one subject over one interval, in names with prefix.
pub(super) struct About<'a> {
    ontology: &'a Ontology,
    subject: String,
    since: f64,
}

impl<'a> About<'a> {
    pub(super) fn new(subject: &str, since: f64) -> Result<Self, NeemError> {
        Ok(Self {
            ontology: Ontology::load(),
            subject: iri(subject)?,
            since,
        })
    }

    pub(super) fn says(&self, predicate: &str, object: Object) -> Result<Triple, NeemError> {
        Ok(Triple {
            subject: self.subject.clone(),
            predicate: iri(predicate)?,
            object,
            since: self.since,
            until: f64::INFINITY,
        })
    }

    pub(super) fn relates(&self, predicate: &str, object: &str) -> Result<Triple, NeemError> {
        self.says(predicate, Object::Iri(iri(object)?))
    }

    fn is_below(&self, class: &str, upper: &str) -> bool {
        self.ontology
            .superclasses(class)
            .is_ok_and(|above| above.contains(&upper))
    }
}

/// Returns the IRI of a name with prefix.
pub(super) fn iri(name: &str) -> Result<String, NeemError> {
    let iri = Ontology::load().expand(name)?;
    let forbidden = |c: char| c.is_whitespace() || c.is_control() || "<>\"{}|^`\\".contains(c);
    if iri.contains(forbidden) {
        return Err(NeemError::Name {
            name: name.to_owned(),
        });
    }
    Ok(iri)
}

/// Returns all triples of an episode. The first triple of each individual is its class.
///
/// # Errors
/// If the record is faulty, or a name has an unknown prefix or a character that IRIs do not allow.
pub fn triples(record: &EpisodeRecord) -> Result<Vec<Triple>, NeemError> {
    record.check().map_err(|fault| NeemError::Record {
        episode: record.id.clone(),
        fault,
    })?;
    let mut all = of_record(record)?;
    for place in 0..record.individuals.len() {
        all.extend(asserted_triples(record, place)?);
        all.extend(derived_triples(record, place)?);
    }
    Ok(all)
}

/// Returns the triples about the record itself.
fn of_record(record: &EpisodeRecord) -> Result<Vec<Triple>, NeemError> {
    let about = About::new(&record_name(&record.id), 0.0)?;
    let text = |property, text: &str| about.says(property, Object::Text(text.to_owned()));
    let number = |property, number| about.says(property, Object::Number(number));
    let mut all = vec![
        about.relates(TYPE, RECORD)?,
        about.relates(TYPE, NAMED)?,
        number("semco:recordSchema", record.schema.into())?,
        text("semco:recordProgram", &record.program)?,
        text("semco:recordSeed", &record.seed.to_string())?,
        text("semco:recordTask", &record.task)?,
        number("semco:recordBegin", record.interval[0])?,
        number("semco:recordEnd", record.interval[1])?,
    ];
    match &record.origin {
        Origin::Simulated => {}
        Origin::Executor(program) => all.push(text("semco:recordExecutor", program)?),
        Origin::Imported(log) => all.push(text("semco:recordLog", log)?),
    }
    for &start in &record.rounds {
        all.push(number("semco:recordRoundStart", start)?);
    }
    if !record.individuals.is_empty() {
        all.push(about.relates("dul:isAbout", &individual(record, 0))?);
    }
    Ok(all)
}

/// Returns a builder of triples about an individual, valid from its begin.
fn about(record: &EpisodeRecord, place: usize) -> Result<About<'static>, NeemError> {
    let interval = record.individuals[place].interval;
    About::new(
        &individual(record, place),
        interval.map_or(0.0, |[start, _]| start),
    )
}

/// Returns the triples that the record asserts about an individual.
fn asserted_triples(record: &EpisodeRecord, place: usize) -> Result<Vec<Triple>, NeemError> {
    let subject = &record.individuals[place];
    let about = about(record, place)?;
    if subject.class == NAMED {
        return Err(NeemError::Reserved {
            name: subject.class.clone(),
        });
    }
    let mut all = vec![about.relates(TYPE, &subject.class)?];
    if let Some(interval) = subject.interval {
        let name = belonging("TimeInterval", record, place, "time");
        all.push(about.relates(HAS_INTERVAL, &name)?);
        all.extend(of_interval(&name, interval)?);
    }
    if let Some(parent) = subject.parent {
        all.push(about.relates(STEP_OF, &individual(record, parent))?);
    }
    for (property, objects) in &subject.relations {
        if property == STEP_OF || property == HAS_INTERVAL {
            return Err(NeemError::Reserved {
                name: property.clone(),
            });
        }
        for object in objects {
            let place = object
                .strip_prefix('#')
                .and_then(|place| place.parse().ok());
            all.push(match place {
                Some(place) => about.relates(property, &individual(record, place))?,
                None => about.relates(property, object)?,
            });
        }
    }
    for (property, value) in &subject.values {
        all.push(about.says(property, value.into())?);
    }
    Ok(all)
}

fn of_interval(name: &str, [start, end]: [f64; 2]) -> Result<[Triple; 4], NeemError> {
    let about = About::new(name, start)?;
    Ok([
        about.relates(TYPE, "dul:TimeInterval")?,
        about.relates(TYPE, NAMED)?,
        about.says(BEGIN, Object::Number(start))?,
        about.says(END, Object::Number(end))?,
    ])
}

/// Returns derived triples that readers expect: an individual has a name, its whole has it as a part, and its forces
/// are regions.
///
/// The import calls this function to recognise and drop these triples.
pub(super) fn derived_triples(
    record: &EpisodeRecord,
    place: usize,
) -> Result<Vec<Triple>, NeemError> {
    let subject = &record.individuals[place];
    let about = about(record, place)?;
    let mut all = vec![about.relates(TYPE, NAMED)?];
    if let Some(parent) = subject.parent {
        let has = has_part(&about, &record.individuals[parent], subject);
        let mut part = About::new(&individual(record, parent), 0.0)?;
        part.since = about.since;
        all.push(part.relates(has, &individual(record, place))?);
    }
    for (value, relation, end) in FORCES {
        if let Some(Value::Number(force)) = subject.values.get(value) {
            let name = belonging("NetForce", record, place, end);
            let region = About::new(&name, about.since)?;
            all.push(about.relates(relation, &name)?);
            all.push(region.relates(TYPE, "soma:NetForce")?);
            all.push(region.relates(TYPE, NAMED)?);
            all.push(region.says("soma:hasForceValue", Object::Number(*force))?);
        }
    }
    Ok(all)
}

/// Returns the property that relates a whole to its part. An episode is a situation, which includes events.
fn has_part(about: &About, whole: &Individual, part: &Individual) -> &'static str {
    if !about.is_below(&whole.class, "dul:Situation") {
        "dul:hasConstituent"
    } else if about.is_below(&part.class, "dul:Action") {
        "dul:includesAction"
    } else if about.is_below(&part.class, "dul:Event") {
        "dul:includesEvent"
    } else {
        "dul:isSettingFor"
    }
}

/// Returns the ontology of wiping as triples, for readers that do not have the ontology: classes and properties with
/// their parents, shared things with their classes.
///
/// # Errors
/// None with the shipped ontology.
pub fn ontology_triples() -> Result<Vec<Triple>, NeemError> {
    let ontology = Ontology::load();
    let mut all = Vec::new();
    let own = |name: &str| name.starts_with("semco:") || name.starts_with("justin:");
    for (name, term) in ontology.terms().filter(|(name, _)| own(name)) {
        let about = About::new(name, 0.0)?;
        let (class, above) = match term.kind {
            TermKind::Class => ("owl:Class", "rdfs:subClassOf"),
            TermKind::ObjectProperty => ("owl:ObjectProperty", "rdfs:subPropertyOf"),
            TermKind::DataProperty => ("owl:DatatypeProperty", "rdfs:subPropertyOf"),
            TermKind::Individual => (NAMED, TYPE),
        };
        all.push(about.relates(TYPE, class)?);
        for parent in &term.parents {
            all.push(about.relates(above, parent)?);
        }
        if let Some(other) = &term.same_as {
            all.push(about.relates("owl:sameAs", other)?);
        }
        all.push(about.says("rdfs:label", Object::Text(term.label.clone()))?);
    }
    Ok(all)
}

impl From<&Value> for Object {
    fn from(value: &Value) -> Self {
        match value {
            Value::Number(number) => Self::Number(*number),
            Value::Text(text) => Self::Text(text.clone()),
        }
    }
}
