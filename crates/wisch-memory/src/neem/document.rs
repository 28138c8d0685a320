//! Triples as documents in the form that NEEM readers expect: with the closures of property and class.

use super::NeemError;
use super::triples::{Object, TYPE, Triple, iri};
use crate::ontology::{Ontology, TermKind};
use bson::oid::ObjectId;
use bson::raw::{CStr, RawArrayBuf, RawBsonRef, RawDocument, RawDocumentBuf, cstr};
use bson::rawdoc;
use std::collections::HashMap;

/// Graph of the triples. Readers delete a graph called `user` when they start.
pub const GRAPH: &str = "wiping";

/// Field that states whether an object is a thing or a literal, where the property does not.
const OBJECT_IS: &CStr = cstr!("o_is");

/// Cache of the closures of classes and properties, as IRIs.
#[derive(Debug, Default)]
pub(super) struct Closures {
    known: HashMap<String, Vec<String>>,
}

impl Closures {
    /// Returns the IRIs of a class or property and of everything above it; for an unknown term, only its own IRI.
    fn of(&mut self, term: &str) -> Result<&[String], NeemError> {
        if !self.known.contains_key(term) {
            let ontology = Ontology::load();
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

    fn array(&mut self, term: &str) -> Result<RawArrayBuf, NeemError> {
        Ok(self.of(term)?.iter().map(String::as_str).collect())
    }

    /// Returns the document of a triple.
    pub(super) fn document(
        &mut self,
        id: ObjectId,
        triple: &Triple,
    ) -> Result<RawDocumentBuf, NeemError> {
        let object = match &triple.object {
            Object::Iri(object) | Object::Text(object) => RawBsonRef::String(object),
            Object::Number(number) => RawBsonRef::Double(*number),
        };
        let mut document = rawdoc! {
            "_id": id,
            "graph": GRAPH,
            "s": triple.subject.as_str(),
            "p": triple.predicate.as_str(),
            "o": object,
            "p*": self.array(&triple.predicate)?,
        };
        if let Object::Iri(object) = &triple.object
            && names_a_term(&triple.predicate)
        {
            document.append(cstr!("o*"), self.array(object)?);
        }
        match (&triple.object, literal_by_property(&triple.predicate)) {
            (Object::Text(_), false) => document.append(OBJECT_IS, "literal"),
            (Object::Iri(_), true) => document.append(OBJECT_IS, "iri"),
            _ => {}
        }
        let time = rawdoc! { "since": triple.since, "until": triple.until };
        document.append(cstr!("scope"), rawdoc! { "time": time });
        Ok(document)
    }
}

/// Whether the object of a property is a class or property.
fn names_a_term(predicate: &str) -> bool {
    let name = Ontology::load().compact(predicate);
    let name = name.unwrap_or_default();
    name == TYPE || name == "rdfs:subClassOf" || name == "rdfs:subPropertyOf"
}

/// Whether the ontology declares that the objects of a property are literals.
fn literal_by_property(predicate: &str) -> bool {
    let ontology = Ontology::load();
    let name = ontology.compact(predicate).unwrap_or_default();
    ontology.kind(&name) == Some(TermKind::DataProperty) || name == "rdfs:label"
}

/// Parses the triple in a document.
pub(super) fn triple(document: &RawDocument) -> Result<Triple, &'static str> {
    let text = |field, what| document.get_str(field).map(str::to_owned).map_err(|_| what);
    let predicate = text("p", "p is not a text")?;
    let literal = match document.get_str(OBJECT_IS.as_str()) {
        Ok(is) => is == "literal",
        Err(_) => literal_by_property(&predicate),
    };
    let object = match document.get("o") {
        Ok(Some(RawBsonRef::String(text))) if literal => Object::Text(text.to_owned()),
        Ok(Some(RawBsonRef::String(iri))) => Object::Iri(iri.to_owned()),
        Ok(Some(_)) => {
            Object::Number(number(document, "o").ok_or("o is neither a number nor a text")?)
        }
        Ok(None) => return Err("it has no o"),
        Err(_) => return Err("it is not BSON"),
    };
    let scope = document.get_document("scope");
    let time = scope.and_then(|scope| scope.get_document("time"));
    let time = time.map_err(|_| "it has no scope.time")?;
    Ok(Triple {
        subject: text("s", "s is not a text")?,
        predicate,
        object,
        since: number(time, "since").ok_or("scope.time.since is not a number")?,
        until: number(time, "until").ok_or("scope.time.until is not a number")?,
    })
}

/// Returns the number in a field, if it is a number.
pub(super) fn number(document: &RawDocument, field: &str) -> Option<f64> {
    match document.get(field).ok()?? {
        RawBsonRef::Double(number) => Some(number),
        RawBsonRef::Int32(number) => Some(number.into()),
        RawBsonRef::Int64(number) => Some(number as f64),
        _ => None,
    }
}
