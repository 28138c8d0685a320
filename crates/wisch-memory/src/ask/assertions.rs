//! Statements that people added to a memory, kept beside its episodes.

use super::error::AskError;
use super::term::Term;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::PathBuf;

/// The file that they are kept in.
const FILE: &str = "told.jsonl";

/// One statement: subject, property, and a name or a value.
type Statement = (String, String, serde_json::Value);

/// What people added.
#[derive(Debug, Clone, Default)]
pub struct Assertions {
    file: Option<PathBuf>,
    statements: Vec<Statement>,
}

impl Assertions {
    /// What people added to the memory in this folder.
    ///
    /// # Errors
    /// If its file cannot be read, or holds something else.
    pub fn read(memory: &std::path::Path) -> Result<Self, AskError> {
        let file = memory.join(FILE);
        let failed = |what: String| AskError::Assertions {
            file: file.display().to_string(),
            what,
        };
        let text = match fs::read_to_string(&file) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(failed(error.to_string())),
        };
        let statements = text.lines().enumerate().map(|(number, line)| {
            serde_json::from_str(line)
                .map_err(|error| failed(format!("line {}: {error}", number + 1)))
        });
        Ok(Self {
            statements: statements.collect::<Result<_, _>>()?,
            file: Some(file),
        })
    }

    /// Keeps a statement, and gives it as a fact.
    pub fn add(&mut self, subject: &str, property: &str, object: &Term) -> Result<Term, AskError> {
        let value = match object {
            Term::Atom(name) => serde_json::Value::from(name.as_str()),
            other => other
                .as_number()
                .map_or(serde_json::Value::Null, Into::into),
        };
        let statement = (subject.to_owned(), property.to_owned(), value);
        if let Some(file) = &self.file {
            let failed = |error: std::io::Error| AskError::Assertions {
                file: file.display().to_string(),
                what: error.to_string(),
            };
            let line = serde_json::to_string(&statement).unwrap_or_default() + "\n";
            let mut open = OpenOptions::new()
                .create(true)
                .append(true)
                .open(file)
                .map_err(failed)?;
            open.write_all(line.as_bytes()).map_err(failed)?;
        }
        let fact = fact(&statement);
        self.statements.push(statement);
        Ok(fact)
    }

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.statements.is_empty()
    }

    /// What was added of a thing, as facts.
    pub fn about(&self, name: &str) -> Vec<Term> {
        let about = self
            .statements
            .iter()
            .filter(|(subject, ..)| subject == name);
        about.map(fact).collect()
    }

    /// Values of a property, each with its thing.
    pub fn values(&self, property: &str) -> Vec<Term> {
        let added = self.statements.iter().filter(|(_, of, _)| of == property);
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

    /// Relations, of one property or of all.
    pub fn relations(&self, property: Option<&str>) -> Vec<Term> {
        let added = self.statements.iter();
        let added = added.filter(|(_, of, _)| property.is_none_or(|property| of == property));
        added.map(fact).filter(is_relation).collect()
    }

    /// Relations that lead to a thing.
    pub fn related_to(&self, object: &str) -> Vec<Term> {
        let added = self.statements.iter();
        let added = added.filter(|(_, _, to)| to.as_str() == Some(object));
        added.map(fact).filter(is_relation).collect()
    }
}

fn is_relation(fact: &Term) -> bool {
    matches!(fact, Term::Compound(name, _) if name == "r")
}

/// A statement as a fact: names with a prefix are things, others are texts.
fn fact((subject, property, object): &Statement) -> Term {
    let (kind, object) = match object {
        serde_json::Value::String(name) if name.contains(':') => ("r", Term::atom(name)),
        serde_json::Value::String(text) => ("v", Term::atom(text)),
        other => ("v", Term::Float(other.as_f64().unwrap_or(f64::NAN))),
    };
    Term::compound(kind, [Term::atom(subject), Term::atom(property), object])
}
