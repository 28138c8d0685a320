//! Reader of ontologies: the part of OWL in RDF/XML that states which term is below which.

use super::{OntologyTerm, TermKind, compact};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::BTreeMap;

const RDF: &str = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
const RDFS: &str = "http://www.w3.org/2000/01/rdf-schema#";
const OWL: &str = "http://www.w3.org/2002/07/owl#";

/// A fault in the text of an ontology.
#[derive(Debug, thiserror::Error)]
pub enum OntologyError {
    /// The file is not XML.
    #[error("{file}: {error}")]
    Xml {
        /// Name of the file.
        file: String,
        /// Error of the parser.
        error: roxmltree::Error,
    },
    /// The namespace of an IRI has no prefix.
    #[error("{file}: {iri:?}: its namespace has no prefix")]
    Iri {
        /// Name of the file.
        file: String,
        /// The IRI; empty if it is missing.
        iri: String,
    },
    /// A name stands for two kinds of terms.
    #[error("{file}: {name} is a {found}, but was declared a {before} before")]
    Kind {
        /// Name of the file.
        file: String,
        /// The name.
        name: String,
        /// Its kind here.
        found: &'static str,
        /// Its earlier kind.
        before: &'static str,
    },
    /// A parent is unknown or of another kind.
    #[error("{name} lies below {parent}, which is not a {kind}")]
    Parent {
        /// The term.
        name: String,
        /// The parent.
        parent: String,
        /// The kind that it should have.
        kind: &'static str,
    },
    /// A term is above itself.
    #[error("{name} lies below itself")]
    Circle {
        /// The term.
        name: String,
    },
}

/// Adds the terms of a file; several files may declare the same term.
pub(super) fn read_file(
    file: &str,
    text: &str,
    terms: &mut BTreeMap<String, OntologyTerm>,
) -> Result<(), OntologyError> {
    let options = ParsingOptions {
        // Namespaces are written as XML entities.
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
        for statement in node.children().filter(Node::is_element) {
            read_statement(file, term, &statement)?;
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

fn read_statement(
    file: &str,
    term: &mut OntologyTerm,
    statement: &Node,
) -> Result<(), OntologyError> {
    let tag = statement.tag_name();
    let resource = || name(file, statement.attribute((RDF, "resource")));
    let text = || statement.text().unwrap_or_default().trim().to_owned();
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
