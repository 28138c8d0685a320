//! Reading of ontologies: the part of OWL in RDF/XML that states which term lies below which.

use super::{OntologyTerm, TermKind, compact};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::BTreeMap;

const RDF: &str = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
const RDFS: &str = "http://www.w3.org/2000/01/rdf-schema#";
const OWL: &str = "http://www.w3.org/2002/07/owl#";

/// What is wrong with an ontology.
#[derive(Debug, thiserror::Error)]
pub enum OntologyError {
    /// Not XML.
    #[error("{file}: {error}")]
    Xml {
        /// In which file.
        file: String,
        /// What the parser says.
        error: roxmltree::Error,
    },
    /// An IRI outside of the namespaces that have a prefix.
    #[error("{file}: {iri:?} lies in none of the namespaces that have a prefix")]
    Iri {
        /// In which file.
        file: String,
        /// The IRI; empty where one is missing.
        iri: String,
    },
    /// A name that stands for two things.
    #[error("{file}: {name} is a {found}, but was a {before}")]
    Kind {
        /// In which file.
        file: String,
        /// The name.
        name: String,
        /// What it is here.
        found: &'static str,
        /// What it was before.
        before: &'static str,
    },
    /// A parent that is not known, or of another kind.
    #[error("{name} lies below {parent}, which is no {kind}")]
    Parent {
        /// Of which term.
        name: String,
        /// The parent.
        parent: String,
        /// What it should be.
        kind: &'static str,
    },
    /// A term above itself.
    #[error("{name} lies below itself")]
    Circle {
        /// Which.
        name: String,
    },
}

/// Reads the terms of one file into the others; a term may stand in several files.
pub(super) fn read_file(
    file: &str,
    text: &str,
    terms: &mut BTreeMap<String, OntologyTerm>,
) -> Result<(), OntologyError> {
    let options = ParsingOptions {
        // Namespaces are written as entities.
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document =
        Document::parse_with_options(text, options).map_err(|error| OntologyError::Xml {
            file: file.to_owned(),
            error,
        })?;
    for node in document.root_element().children() {
        let Some(kind) = kind(&node) else { continue };
        let name = name(file, node.attribute((RDF, "about")))?;
        let term = terms.entry(name.clone()).or_insert_with(|| OntologyTerm {
            kind,
            parents: Vec::new(),
            domain: None,
            range: None,
            same_as: None,
            label: String::new(),
            comment: String::new(),
        });
        if term.kind != kind {
            return Err(OntologyError::Kind {
                file: file.to_owned(),
                name,
                found: kind.word(),
                before: term.kind.word(),
            });
        }
        for said in node.children().filter(Node::is_element) {
            read_statement(file, term, &said)?;
        }
    }
    Ok(())
}

fn kind(node: &Node) -> Option<TermKind> {
    let tag = node.tag_name();
    if tag.namespace() != Some(OWL) {
        return None;
    }
    match tag.name() {
        "Class" => Some(TermKind::Class),
        "ObjectProperty" => Some(TermKind::ObjectProperty),
        "DatatypeProperty" => Some(TermKind::DataProperty),
        "NamedIndividual" => Some(TermKind::Individual),
        _ => None,
    }
}

fn read_statement(file: &str, term: &mut OntologyTerm, said: &Node) -> Result<(), OntologyError> {
    let tag = said.tag_name();
    let resource = || name(file, said.attribute((RDF, "resource")));
    let text = || said.text().unwrap_or_default().trim().to_owned();
    match (tag.namespace().unwrap_or_default(), tag.name()) {
        (RDFS, "subClassOf" | "subPropertyOf") => term.parents.push(resource()?),
        (RDF, "type") if term.kind == TermKind::Individual => term.parents.push(resource()?),
        (RDFS, "domain") => term.domain = Some(resource()?),
        (RDFS, "range") => term.range = Some(resource()?),
        (OWL, "sameAs") => term.same_as = Some(resource()?),
        (RDFS, "label") => term.label = text(),
        (RDFS, "comment") => term.comment = text(),
        _ => {}
    }
    Ok(())
}

fn name(file: &str, iri: Option<&str>) -> Result<String, OntologyError> {
    let iri = iri.unwrap_or_default();
    compact(iri).ok_or_else(|| OntologyError::Iri {
        file: file.to_owned(),
        iri: iri.to_owned(),
    })
}
