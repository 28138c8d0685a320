//! A triple as a document, as readers of such memories look for it: with the closures of its property and
//! class.

use super::NeemError;
use super::bson::{Bson, Document};
use super::triples::{Object, TYPE, Triple, iri};
use crate::ontology::{Ontology, TermKind};
use std::collections::HashMap;

/// The graph to which the triples belong. Readers wipe a graph called `user` when they start.
pub const GRAPH: &str = "wiping";

/// Says of a document whether its object is a thing or a literal, where the property does not tell.
const OBJECT_IS: &str = "o_is";

/// Closures of classes and properties, as IRIs.
#[derive(Debug, Default)]
pub(super) struct Closures {
    known: HashMap<String, Vec<String>>,
}

impl Closures {
    /// The IRI of a class or property and those of all above it; only itself, if the ontology knows nothing of
    /// it.
    fn of(&mut self, term: &str) -> Result<&[String], NeemError> {
        if !self.known.contains_key(term) {
            let ontology = Ontology::shipped();
            let name = ontology.compact(term).unwrap_or_default();
            let above = match ontology.kind(&name) {
                Some(TermKind::Class) => ontology.superclasses(&name)?,
                Some(TermKind::ObjectProperty | TermKind::DataProperty) => {
                    ontology.superproperties(&name)?
                }
                Some(TermKind::Individual) | None => Vec::new(),
            };
            let mut closure = vec![term.to_owned()];
            for name in above.into_iter().skip(1) {
                closure.push(iri(name)?);
            }
            self.known.insert(term.to_owned(), closure);
        }
        Ok(&self.known[term])
    }

    fn array(&mut self, term: &str) -> Result<Bson, NeemError> {
        let closure = self.of(term)?.iter();
        Ok(Bson::Array(
            closure.map(|iri| iri.as_str().into()).collect(),
        ))
    }

    /// The document of a triple.
    pub(super) fn document(
        &mut self,
        id: [u8; 12],
        triple: &Triple,
    ) -> Result<Document, NeemError> {
        let object = match &triple.object {
            Object::Iri(object) => Bson::from(object.as_str()),
            Object::Number(number) => Bson::Double(*number),
            Object::Text(text) => Bson::from(text.as_str()),
        };
        let mut document = Document::default()
            .with("_id", Bson::ObjectId(id))
            .with("graph", GRAPH)
            .with("s", triple.subject.as_str())
            .with("p", triple.predicate.as_str())
            .with("o", object)
            .with("p*", self.array(&triple.predicate)?);
        if let Object::Iri(object) = &triple.object
            && names_a_term(&triple.predicate)
        {
            document = document.with("o*", self.array(object)?);
        }
        match (&triple.object, literal_by_property(&triple.predicate)) {
            (Object::Text(_), false) => document = document.with(OBJECT_IS, "literal"),
            (Object::Iri(_), true) => document = document.with(OBJECT_IS, "iri"),
            _ => {}
        }
        let time = Document::default()
            .with("since", triple.since)
            .with("until", triple.until);
        Ok(document.with("scope", Document::default().with("time", time)))
    }
}

/// Whether the object of a property is a class or property.
fn names_a_term(predicate: &str) -> bool {
    let name = Ontology::shipped().compact(predicate);
    let name = name.unwrap_or_default();
    name == TYPE || name == "rdfs:subClassOf" || name == "rdfs:subPropertyOf"
}

/// Whether the ontology says that the objects of a property are literals.
fn literal_by_property(predicate: &str) -> bool {
    let ontology = Ontology::shipped();
    let name = ontology.compact(predicate).unwrap_or_default();
    ontology.kind(&name) == Some(TermKind::DataProperty) || name == "rdfs:label"
}

/// The triple of a document.
pub(super) fn triple(document: &Document) -> Result<Triple, &'static str> {
    let text = |field, what| document.text(field).map(str::to_owned).ok_or(what);
    let predicate = text("p", "p is no text")?;
    let literal = match document.text(OBJECT_IS) {
        Some(is) => is == "literal",
        None => literal_by_property(&predicate),
    };
    let object = match document.get("o") {
        Some(Bson::Text(text)) if literal => Object::Text(text.clone()),
        Some(Bson::Text(iri)) => Object::Iri(iri.clone()),
        Some(_) => Object::Number(document.number("o").ok_or("o is no number or text")?),
        None => return Err("it has no o"),
    };
    let time = document
        .document("scope")
        .and_then(|scope| scope.document("time"));
    let time = time.ok_or("it has no scope.time")?;
    Ok(Triple {
        subject: text("s", "s is no text")?,
        predicate,
        object,
        since: time
            .number("since")
            .ok_or("scope.time.since is no number")?,
        until: time
            .number("until")
            .ok_or("scope.time.until is no number")?,
    })
}
