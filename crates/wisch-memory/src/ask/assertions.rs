//! Statements that people added to a memory, kept beside its episodes.

use super::error::{AskError, QueryFault};
use super::term::Term;
use crate::catalogue::Catalogue;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The file that they are kept in.
const FILE: &str = "told.jsonl";

/// One statement: subject, property, and a name or a value.
type Statement = (String, String, serde_json::Value);

/// What people added. What a query adds is known at once, and committed when the query has ended well.
#[derive(Debug, Clone, Default)]
pub struct Assertions {
    file: Option<PathBuf>,
    statements: Vec<Statement>,
    /// How many of them are committed; those after them were added by the query that is being answered.
    committed: usize,
}

impl Assertions {
    /// What people added to the memory in this folder.
    ///
    /// # Errors
    /// If its file cannot be read, or holds something else.
    pub fn read(memory: &Path) -> Result<Self, AskError> {
        let file = memory.join(FILE);
        let text = match fs::read_to_string(&file) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(failed(&file, error)),
        };
        let statements = text[..whole_lines(text.as_bytes())]
            .lines()
            .enumerate()
            .map(|(number, line)| {
                parse(line).map_err(|what| failed(&file, format!("line {}: {what}", number + 1)))
            });
        let statements: Vec<Statement> = statements.collect::<Result<_, _>>()?;
        Ok(Self {
            committed: statements.len(),
            statements,
            file: Some(file),
        })
    }

    /// Drops what was said of individuals of episodes that are no more.
    pub(super) fn retain_known(&mut self, catalogue: &Catalogue) {
        let is_known = |name: &str| match individual_of(name) {
            Some(local) => {
                catalogue.find(local).is_some() || catalogue.shared().iter().any(|s| s == name)
            }
            None => true,
        };
        self.statements.retain(|(subject, _, object)| {
            is_known(subject) && object.as_str().is_none_or(is_known)
        });
        self.committed = self.statements.len();
    }

    /// Adds a statement for the query that is being answered, and gives it as a fact.
    ///
    /// # Errors
    /// If the query has added as many as it may.
    pub fn add(
        &mut self,
        subject: &str,
        property: &str,
        object: &Term,
        most: usize,
    ) -> Result<Term, QueryFault> {
        if self.statements.len() - self.committed >= most {
            return Err(QueryFault::TooMuch {
                what: "statements told",
                limit: most,
            });
        }
        let value = match object {
            // As engines write numbers that are not finite.
            Term::Atom(name) if is_not_finite(name) => return Err(not_finite(name)),
            Term::Atom(name) => serde_json::Value::from(name.as_str()),
            other => match other.as_number() {
                Some(number) if number.is_finite() => number.into(),
                Some(number) => return Err(not_finite(number)),
                None => return Err(QueryFault::no_name(other)),
            },
        };
        let statement = (subject.to_owned(), property.to_owned(), value);
        let fact = fact(&statement);
        self.statements.push(statement);
        Ok(fact)
    }

    /// Keeps what the query has added: all of it, or, on an error, nothing.
    ///
    /// # Errors
    /// If its file cannot be written.
    pub fn commit(&mut self) -> Result<(), AskError> {
        let new = &self.statements[self.committed..];
        if let (Some(file), false) = (&self.file, new.is_empty()) {
            let lines = new.iter().map(|statement| {
                // Texts and finite numbers always have a form in JSON.
                serde_json::to_string(statement).unwrap_or_default() + "\n"
            });
            let lines: String = lines.collect();
            append(file, &lines).map_err(|error| failed(file, error))?;
        }
        self.committed = self.statements.len();
        Ok(())
    }

    /// Takes back what the query has added, if anything.
    pub fn roll_back(&mut self) -> bool {
        let has_new = self.statements.len() > self.committed;
        self.statements.truncate(self.committed);
        has_new
    }

    /// What was added of a thing, as facts.
    pub fn about(&self, name: &str) -> Vec<Term> {
        let about = self
            .statements
            .iter()
            .filter(|(subject, ..)| subject == name);
        about.map(fact).collect()
    }

    /// Whether anything was added with this property.
    pub fn has(&self, property: &str) -> bool {
        self.statements.iter().any(|(_, of, _)| of == property)
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

/// Removes what was told of an episode from its memory; the file in which that is done stands aside.
///
/// # Errors
/// What the system says; then nothing is removed.
pub(crate) fn forget_episode(memory: &Path, id: &str, aside: &Path) -> io::Result<()> {
    let path = memory.join(FILE);
    if !path.exists() {
        return Ok(());
    }
    let held = locked(&path)?;
    let text = fs::read_to_string(&path)?;
    let is_of_it = |name: &str| {
        let episode = individual_of(name).and_then(|local| {
            let (_, rest) = local.split_once('_')?;
            Some(rest.rsplit_once('-')?.0)
        });
        episode == Some(id)
    };
    let whole = &text[..whole_lines(text.as_bytes())];
    let stays = |line: &&str| match parse(line) {
        Ok((subject, _, object)) => !is_of_it(&subject) && !object.as_str().is_some_and(is_of_it),
        // What cannot be read is told when it is read.
        Err(_) => true,
    };
    let left: String = whole
        .lines()
        .filter(stays)
        .map(|line| format!("{line}\n"))
        .collect();
    if left.len() == whole.len() {
        return Ok(());
    }
    // The new file takes the place of the old one at once; who waits for the old one's lock opens the new one.
    let mut new = File::create(aside)?;
    new.write_all(left.as_bytes())?;
    new.set_permissions(held.metadata()?.permissions())?;
    new.sync_all()?;
    fs::rename(aside, &path)
}

/// The local name of what may be an individual of an episode: `Class_episode-place`.
fn individual_of(name: &str) -> Option<&str> {
    let local = name.strip_prefix("semco:")?;
    let (class, rest) = local.split_once('_')?;
    let (episode, place) = rest.rsplit_once('-')?;
    let is_one = class.starts_with(|c: char| c.is_ascii_uppercase())
        && !episode.is_empty()
        && !place.is_empty()
        && place.chars().all(|c| c.is_ascii_digit());
    is_one.then_some(local)
}

fn parse(line: &str) -> Result<Statement, String> {
    let statement: Statement = serde_json::from_str(line).map_err(|error| error.to_string())?;
    let (subject, property, object) = &statement;
    match object {
        serde_json::Value::String(_) | serde_json::Value::Number(_) => Ok(statement),
        other => Err(format!(
            "{property} of {subject} is {other}; expected a name, a text or a finite number"
        )),
    }
}

/// Whether a text is how a number that is not finite is written, as `inf`, `nan` or `1.5NaN`.
fn is_not_finite(text: &str) -> bool {
    let plain = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let plain = plain.to_ascii_lowercase();
    ["inf", "infinite", "infinity", "nan"].contains(&plain.as_str())
}

fn not_finite(number: impl std::fmt::Display) -> QueryFault {
    QueryFault::Prolog {
        what: format!("{number} cannot be told: a number that is told must be finite"),
    }
}

fn failed(file: &Path, what: impl ToString) -> AskError {
    AskError::Assertions {
        file: file.display().to_string(),
        what: what.to_string(),
    }
}

/// The length of the lines that end [bytes]: a program that was killed may have left part of one behind.
fn whole_lines(text: &[u8]) -> usize {
    text.iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |place| place + 1)
}

/// Adds lines to a file, all or none.
fn append(file: &Path, lines: &str) -> io::Result<()> {
    let mut open = locked(file)?;
    let mut before = Vec::new();
    open.read_to_end(&mut before)?;
    let whole = whole_lines(&before) as u64;
    open.set_len(whole)?;
    open.seek(SeekFrom::Start(whole))?;
    let written = open
        .write_all(lines.as_bytes())
        .and_then(|()| open.sync_all());
    written.inspect_err(|_| {
        // A part of a line would be passed over by the next who reads; part of the lines would not.
        let _ = open.set_len(whole);
    })
}

/// The file, made if it is not there, under a lock that ends with it: others may tell something to the same memory.
fn locked(file: &Path) -> io::Result<File> {
    loop {
        let mut options = OpenOptions::new();
        let open: File = options
            .create(true)
            .truncate(false)
            .read(true)
            .write(true)
            .open(file)?;
        open.lock()?;
        // Another file may have taken its place meanwhile.
        if is_still(&open, file)? {
            return Ok(open);
        }
    }
}

#[cfg(unix)]
fn is_still(open: &File, file: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let identity = |meta: &fs::Metadata| (meta.dev(), meta.ino());
    match fs::metadata(file) {
        Ok(now) => Ok(identity(&now) == identity(&open.metadata()?)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(not(unix))]
fn is_still(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
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
