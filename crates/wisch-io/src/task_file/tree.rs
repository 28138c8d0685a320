//! The TOML tree of a task file and its settings, in which every value has its location.

use super::TaskError;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};
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

    /// Parses the text, without the settings.
    pub(super) fn parse(&self) -> Result<Spanned<DeValue<'a>>, TaskError> {
        let table = DeTable::parse(self.text).map_err(|error| TaskError::Syntax {
            at: self.place(error.span().map_or(0, |span| span.start)),
            message: error.message().to_owned(),
        })?;
        Ok(Spanned::new(0..0, DeValue::Table(table.into_inner())))
    }

    /// Applies the settings whose keys are chosen.
    pub(super) fn apply(
        &self,
        root: &mut Spanned<DeValue<'a>>,
        is_chosen: impl Fn(&str) -> bool,
    ) -> Result<(), TaskError> {
        let mut start = self.text.len() + 1;
        for (key, text) in self.settings {
            if is_chosen(key) {
                let value = DeValue::parse(text)
                    .unwrap_or_else(|_| Spanned::new(0..0, DeValue::String(text.into())));
                set(root, key, start, shifted(value, start))?;
            }
            start += text.len() + 1;
        }
        Ok(())
    }
}

/// Adds `start` to the offsets of a value and of all values in it.
fn shifted(value: Spanned<DeValue<'_>>, start: usize) -> Spanned<DeValue<'_>> {
    let moved = |span: Range<usize>| span.start + start..span.end + start;
    let span = moved(value.span());
    let value = match value.into_inner() {
        DeValue::Array(items) => {
            DeValue::Array(items.into_iter().map(|item| shifted(item, start)).collect())
        }
        DeValue::Table(entries) => DeValue::Table(
            (entries.into_iter())
                .map(|(key, value)| {
                    let span = moved(key.span());
                    (Spanned::new(span, key.into_inner()), shifted(value, start))
                })
                .collect(),
        ),
        other => other,
    };
    Spanned::new(span, value)
}

/// Returns the value of an integer; `None` if it is too large.
pub(super) fn integer(number: &DeInteger<'_>) -> Option<i128> {
    i128::from_str_radix(number.as_str(), number.radix()).ok()
}

/// Returns the value of a number with a fraction or an exponent; `None` if it is malformed.
pub(super) fn float(number: &DeFloat<'_>) -> Option<f64> {
    number.as_str().parse().ok()
}

/// Describes a value for messages.
pub(super) fn description(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => format!("the string {text:?}"),
        DeValue::Integer(number) => integer(number)
            .map_or("a number that is too large".to_owned(), |number| {
                number.to_string()
            }),
        DeValue::Float(number) => {
            float(number).map_or("a malformed number".to_owned(), |number| number.to_string())
        }
        DeValue::Array(items) => format!("an array of length {}", items.len()),
        DeValue::Table(_) => "a table".to_owned(),
        DeValue::Boolean(_) => "a boolean".to_owned(),
        other => format!("a {}", other.type_str()),
    }
}

/// Sets `value` at a dotted key; a number in the key is an index from 0 into an array.
fn set<'a>(
    root: &mut Spanned<DeValue<'a>>,
    path: &'a str,
    offset: usize,
    value: Spanned<DeValue<'a>>,
) -> Result<(), TaskError> {
    let fault = |problem: String| TaskError::Setting {
        key: path.to_owned(),
        problem,
    };
    let mut here = root;
    let mut segments = path.split('.').peekable();
    let mut value = Some(value);
    while let Some(segment) = segments.next() {
        let is_last = segments.peek().is_none();
        here = match here.get_mut() {
            DeValue::Table(entries) => {
                if segment.is_empty() {
                    return Err(fault("the key has an empty part".to_owned()));
                }
                if is_last {
                    let excluded = ALTERNATIVES.iter().find(|group| group.contains(&segment));
                    for other in excluded.into_iter().flat_map(|group| group.iter()) {
                        if *other != segment {
                            entries.remove(*other);
                        }
                    }
                }
                let key = Spanned::new(offset..offset, segment.into());
                let empty = || Spanned::new(offset..offset, DeValue::Table(DeTable::new()));
                entries.entry(key).or_insert_with(empty)
            }
            DeValue::Array(items) => {
                let count = items.len();
                let item = segment.parse().ok().and_then(|i: usize| items.get_mut(i));
                item.ok_or_else(|| {
                    fault(format!(
                        "{segment:?} is not an index into an array of length {count}"
                    ))
                })?
            }
            other => {
                let found = description(other);
                return Err(fault(format!("{segment:?} is not a key of {found}")));
            }
        };
        if is_last && let Some(value) = value.take() {
            *here = value;
        }
    }
    Ok(())
}
