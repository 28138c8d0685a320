//! Statements that people added to a memory, stored beside its episodes.

use super::error::{AskError, QueryFault};
use super::term::Term;
use crate::catalogue::Catalogue;
use crate::ontology::{Ontology, TermKind};
use crate::statements::{FILE, Statement, append, complete_length, individual_of, parse};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Annotations by people, with their meanings. Their values are texts.
pub const ANNOTATIONS: [(&str, &str); 2] = [
    ("rdfs:label", "name that a person gave to something"),
    (
        "rdfs:comment",
        "note by a person on something, such as an event",
    ),
];
/// Property of the statements that add individuals.
pub(super) const TYPE: &str = "rdf:type";
/// Largest number of characters of a text by `tell`.
const LONGEST_TEXT: usize = 2000;

/// Statements by people. A query's statements hold at once, and are committed when the query has succeeded.
#[derive(Debug, Clone, Default)]
pub struct Assertions {
    file: Option<PathBuf>,
    statements: Vec<Statement>,
    /// Number of committed statements; later ones belong to the current query.
    committed: usize,
}

impl Assertions {
    /// Reads the statements of the memory in a folder.
    ///
    /// # Errors
    /// If the file cannot be read, or a line is not a statement.
    pub fn read(memory: &Path) -> Result<Self, AskError> {
        let file = memory.join(FILE);
        let text = match fs::read_to_string(&file) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(failed(&file, error)),
        };
        let statements = text[..complete_length(text.as_bytes())]
            .lines()
            .enumerate()
            .map(|(number, line)| {
                parse(line).map_err(|what| {
                    let number = number + 1;
                    failed(
                        &file,
                        format!("line {number} is no statement ({what}); delete this line"),
                    )
                })
            });
        let statements: Vec<Statement> = statements.collect::<Result<_, _>>()?;
        for (place, (subject, property, class)) in statements.iter().enumerate() {
            let kind = class.as_str().and_then(|name| Ontology::load().kind(name));
            if property == TYPE && kind != Some(TermKind::Class) {
                let number = place + 1;
                let what = format!(
                    "line {number} makes {subject} a {class}, which is no class; delete this line"
                );
                return Err(failed(&file, what));
            }
        }
        Ok(Self {
            committed: statements.len(),
            statements,
            file: Some(file),
        })
    }

    /// Removes statements about individuals of deleted episodes.
    pub(super) fn retain_known(&mut self, catalogue: &Catalogue) {
        let is_known = |name: &str| match individual_of(name) {
            Some(local) => {
                catalogue.find(local).is_some()
                    || catalogue.shared_individuals().iter().any(|s| s == name)
            }
            None => true,
        };
        self.statements.retain(|(subject, _, object)| {
            is_known(subject) && object.as_str().is_none_or(is_known)
        });
        self.committed = self.statements.len();
    }

    /// Adds a statement of the current query, and returns it as a fact.
    ///
    /// # Errors
    /// If the query has added the allowed number of statements.
    pub fn add(
        &mut self,
        subject: &str,
        property: &str,
        object: &Term,
        most: usize,
    ) -> Result<Term, QueryFault> {
        let value = match object {
            // Engines write numbers that are not finite as atoms.
            Term::Atom(name) if is_not_finite(name) && !has_texts(property) => {
                return Err(not_finite(name));
            }
            Term::Atom(name) => serde_json::Value::from(name.as_str()),
            other => match other.as_number() {
                Some(number) if number.is_finite() => number.into(),
                Some(number) => return Err(not_finite(number)),
                None => return Err(QueryFault::no_name(other)),
            },
        };
        let range = Ontology::load()
            .term(property)
            .and_then(|term| term.range.as_deref());
        if let (Some("xsd:double" | "xsd:integer"), false) = (range, value.is_number()) {
            let what = format!("{property} is a number, not {object}: tell stored nothing");
            return Err(QueryFault::Prolog { what });
        }
        let length = value.as_str().map_or(0, |text| text.chars().count());
        if length > LONGEST_TEXT {
            let what = format!(
                "the text has {length} characters, but tell stores at most {LONGEST_TEXT}; shorten it"
            );
            return Err(QueryFault::Prolog { what });
        }
        let statement = (subject.to_owned(), property.to_owned(), value);
        let fact = fact(&statement);
        self.push(statement, most)?;
        Ok(fact)
    }

    /// Adds an individual of a class, by a statement of the current query.
    ///
    /// # Errors
    /// If the query has added the allowed number of statements.
    pub(super) fn add_individual(
        &mut self,
        name: &str,
        class: &str,
        most: usize,
    ) -> Result<(), QueryFault> {
        self.push((name.to_owned(), TYPE.to_owned(), class.into()), most)
    }

    fn push(&mut self, statement: Statement, most: usize) -> Result<(), QueryFault> {
        if self.statements.len() - self.committed >= most {
            return Err(QueryFault::TooMuch {
                what: "statements by tell",
                limit: most,
            });
        }
        self.statements.push(statement);
        Ok(())
    }

    /// Returns the added individuals, each with its class.
    pub(super) fn individuals(&self) -> impl Iterator<Item = (&str, &str)> {
        let added = self.statements.iter();
        added.filter_map(|(name, property, class)| {
            let class = class.as_str().filter(|_| property == TYPE)?;
            Some((name.as_str(), class))
        })
    }

    /// Returns the statements about things, without those that add individuals.
    fn described(&self) -> impl Iterator<Item = &Statement> {
        let added = self.statements.iter();
        added.filter(|(_, property, _)| property != TYPE)
    }

    /// Commits the query's statements: all of them, or none on an error.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn commit(&mut self) -> Result<(), AskError> {
        let new = &self.statements[self.committed..];
        if let (Some(file), false) = (&self.file, new.is_empty()) {
            let lines = new.iter().map(|statement| {
                // Texts and finite numbers always serialise to JSON.
                serde_json::to_string(statement).unwrap_or_default() + "\n"
            });
            let lines: String = lines.collect();
            append(file, &lines).map_err(|error| failed(file, error))?;
        }
        self.committed = self.statements.len();
        Ok(())
    }

    /// Discards the query's statements, and returns them.
    pub fn roll_back(&mut self) -> Vec<Statement> {
        self.statements.split_off(self.committed)
    }

    /// Returns the statements about a thing, as facts.
    pub fn statements_about(&self, name: &str) -> Vec<Term> {
        let about = self.described().filter(|(subject, ..)| subject == name);
        about.map(fact).collect()
    }

    /// Returns the properties of the statements about a thing.
    pub fn properties_of(&self, name: &str) -> impl Iterator<Item = &str> {
        let about = self
            .described()
            .filter(move |(subject, ..)| subject == name);
        about.map(|(_, property, _)| property.as_str())
    }

    /// Number of the statements.
    pub fn count(&self) -> usize {
        self.statements.len()
    }

    /// Returns all statements.
    pub(super) fn all(&self) -> &[Statement] {
        &self.statements
    }

    /// Whether any statement has this property.
    pub fn has(&self, property: &str) -> bool {
        self.described().any(|(_, of, _)| of == property)
    }

    /// Returns the values of a property, each with its thing.
    pub fn values(&self, property: &str) -> Vec<Term> {
        let added = self.described().filter(|(_, of, _)| of == property);
        let values = added.map(|statement| (statement, fact(statement)));
        let pairs = values.filter_map(|((subject, ..), fact)| match fact {
            Term::Compound(name, parts) if name == "v" => {
                let value = parts.into_iter().nth(2)?;
                Some(Term::compound("-", [value, Term::atom(subject)]))
            }
            _ => None,
        });
        pairs.collect()
    }

    /// Returns relations, of one property or of all.
    pub fn relations(&self, property: Option<&str>) -> Vec<Term> {
        let added = self.described();
        let added = added.filter(|(_, of, _)| property.is_none_or(|property| of == property));
        added.map(fact).filter(is_relation).collect()
    }

    /// Returns relations whose object is a thing.
    pub fn related_to(&self, object: &str) -> Vec<Term> {
        let added = self.described();
        let added = added.filter(|(_, _, to)| to.as_str() == Some(object));
        added.map(fact).filter(is_relation).collect()
    }
}

/// Whether a text is a number that is not finite, such as `inf`, `nan` or `1.5NaN`.
fn is_not_finite(text: &str) -> bool {
    let plain = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let plain = plain.to_ascii_lowercase();
    ["inf", "infinite", "infinity", "nan"].contains(&plain.as_str())
}

fn not_finite(number: impl std::fmt::Display) -> QueryFault {
    QueryFault::Prolog {
        what: format!("tell cannot store {number}: numbers must be finite"),
    }
}

fn failed(file: &Path, what: impl ToString) -> AskError {
    AskError::Assertions {
        file: file.display().to_string(),
        what: what.to_string(),
    }
}

fn is_relation(fact: &Term) -> bool {
    matches!(fact, Term::Compound(name, _) if name == "r")
}

/// Whether the values of a property are texts, which may hold a colon.
fn has_texts(property: &str) -> bool {
    let term = Ontology::load().term(property);
    ANNOTATIONS.iter().any(|(name, _)| *name == property)
        || term.is_some_and(|term| term.range.as_deref() == Some("xsd:string"))
}

/// Returns a statement as a fact: names with a prefix are things, unless the property has texts; other names are texts.
fn fact((subject, property, object): &Statement) -> Term {
    let (kind, object) = match object {
        serde_json::Value::String(name) if name.contains(':') && !has_texts(property) => {
            ("r", Term::atom(name))
        }
        serde_json::Value::String(text) => ("v", Term::atom(text)),
        other => ("v", Term::Float(other.as_f64().unwrap_or(f64::NAN))),
    };
    Term::compound(kind, [Term::atom(subject), Term::atom(property), object])
}
