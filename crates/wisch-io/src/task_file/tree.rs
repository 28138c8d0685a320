//! The tree of a task file and its settings, in which every value has its location.

use super::TaskError;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use wisch::source_location::Place;

/// Groups of mutually exclusive keys. A setting of one key removes the others from the file.
const ALTERNATIVES: [&[&str]; 4] = [
    &["footprint_m", "mesh"],
    &["action", "goal"],
    &["size_m", "outline_m"],
    &["rpy_rad", "quaternion_xyzw"],
];

/// The text of a task file and its settings, which converts byte offsets to locations.
#[derive(Debug)]
pub(super) struct Source<'a> {
    name: &'a str,
    text: &'a str,
    /// Offsets of its lines [byte], because a large scene needs many locations.
    lines: Vec<usize>,
    settings: &'a [(String, String)],
}

impl<'a> Source<'a> {
    pub(super) fn new(name: &'a str, text: &'a str, settings: &'a [(String, String)]) -> Self {
        let breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Self {
            name,
            text,
            lines: std::iter::once(0).chain(breaks).collect(),
            settings,
        }
    }

    /// Returns the location of a byte; offsets count through the file, then through the settings' values.
    pub(super) fn place(&self, offset: usize) -> Place {
        let mut start = self.text.len() + 1;
        if offset < start {
            let before = self.lines.partition_point(|&line| line <= offset) - 1;
            let line = &self.text[self.lines[before]..];
            let mut place = Place::from_offset(self.name, line, offset - self.lines[before]);
            place.line += before;
            return place;
        }
        for (key, value) in self.settings {
            if offset < start + value.len() + 1 {
                return Place::from_offset(&format!("setting {key}"), value, offset - start);
            }
            start += value.len() + 1;
        }
        Place::from_offset(self.name, self.text, self.text.len())
    }

    /// Parses the text and applies the settings.
    pub(super) fn tree(&self) -> Result<Value, TaskError> {
        let table = DeTable::parse(self.text).map_err(|error| TaskError::Syntax {
            at: self.place(error.span().map_or(0, |span| span.start)),
            message: error.message().to_owned(),
        })?;
        let mut root = Value {
            offset: 0,
            node: table_node(table.get_ref(), 0),
        };
        let mut start = self.text.len() + 1;
        for (key, text) in self.settings {
            let value = match DeValue::parse(text) {
                Ok(value) => converted(&value, start),
                Err(_) => Value {
                    offset: start,
                    node: Node::String(text.clone()),
                },
            };
            set(&mut root, key, start, value)?;
            start += text.len() + 1;
        }
        Ok(root)
    }
}

/// A value with its start offset.
#[derive(Debug)]
pub(super) struct Value {
    pub(super) offset: usize,
    pub(super) node: Node,
}

/// The content of a value.
#[derive(Debug)]
pub(super) enum Node {
    String(String),
    Integer(i128),
    Float(f64),
    Array(Vec<Value>),
    Table(Vec<Entry>),
    Boolean(bool),
    /// Dates, which no key of a task accepts.
    Other(&'static str),
}

/// A key with its start offset and value.
#[derive(Debug)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) offset: usize,
    pub(super) value: Value,
}

impl Node {
    /// Describes the value for messages.
    pub(super) fn description(&self) -> String {
        match self {
            Self::String(text) => format!("the string {text:?}"),
            Self::Integer(number) => number.to_string(),
            Self::Float(number) => number.to_string(),
            Self::Array(items) => format!("an array of length {}", items.len()),
            Self::Table(_) => "a table".to_owned(),
            Self::Boolean(_) => "a boolean".to_owned(),
            Self::Other(what) => format!("a {what}"),
        }
    }
}

fn table_node(table: &DeTable<'_>, start: usize) -> Node {
    let mut entries: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            offset: start + key.span().start,
            value: converted(value, start),
        })
        .collect();
    // In the order of the text, so that the first of several errors is reported.
    entries.sort_by_key(|entry| entry.offset);
    Node::Table(entries)
}

fn converted(value: &Spanned<DeValue<'_>>, start: usize) -> Value {
    let node = match value.get_ref() {
        DeValue::String(text) => Node::String(text.to_string()),
        DeValue::Integer(number) => i128::from_str_radix(number.as_str(), number.radix())
            .map_or(Node::Other("number that is too large"), Node::Integer),
        DeValue::Float(number) => number
            .as_str()
            .parse()
            .map_or(Node::Other("malformed number"), Node::Float),
        DeValue::Array(items) => {
            Node::Array(items.iter().map(|item| converted(item, start)).collect())
        }
        DeValue::Table(table) => table_node(table, start),
        DeValue::Boolean(is_on) => Node::Boolean(*is_on),
        other => Node::Other(other.type_str()),
    };
    Value {
        offset: start + value.span().start,
        node,
    }
}

/// Sets `value` at a dotted key; a number in the key is an index from 0 into an array.
fn set(root: &mut Value, path: &str, offset: usize, value: Value) -> Result<(), TaskError> {
    let fault = |problem: String| TaskError::Setting {
        key: path.to_owned(),
        problem,
    };
    let mut here = root;
    let mut segments = path.split('.').peekable();
    let mut value = Some(value);
    while let Some(segment) = segments.next() {
        let is_last = segments.peek().is_none();
        here = match &mut here.node {
            Node::Table(entries) => {
                if segment.is_empty() {
                    return Err(fault("the key has an empty part".to_owned()));
                }
                if is_last {
                    let excluded = ALTERNATIVES.iter().find(|group| group.contains(&segment));
                    entries.retain(|entry| {
                        entry.key == segment
                            || !excluded.is_some_and(|group| group.contains(&entry.key.as_str()))
                    });
                }
                let index = entries.iter().position(|entry| entry.key == segment);
                let index = index.unwrap_or_else(|| {
                    entries.push(Entry {
                        key: segment.to_owned(),
                        offset,
                        value: Value {
                            offset,
                            node: Node::Table(Vec::new()),
                        },
                    });
                    entries.len() - 1
                });
                &mut entries[index].value
            }
            Node::Array(items) => {
                let count = items.len();
                let item = segment.parse().ok().and_then(|i: usize| items.get_mut(i));
                item.ok_or_else(|| {
                    fault(format!(
                        "{segment:?} is not an index into an array of length {count}"
                    ))
                })?
            }
            other => {
                let found = other.description();
                return Err(fault(format!("{segment:?} is not a key of {found}")));
            }
        };
        if is_last && let Some(value) = value.take() {
            *here = value;
        }
    }
    Ok(())
}
