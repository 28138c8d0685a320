//! Typed access to the tree of a task file; every refusal says where, which key, and what would do.

use super::TaskError;
use super::tree::{Entry, Node, Source, Value};
use std::ops::RangeInclusive;
use wisch::geometry::Point2;
use wisch::source_location::{Place, UnknownName};

/// Coordinates of places [m].
pub(super) const POSITION_M: RangeInclusive<f64> = -100.0..=100.0;

/// A table whose keys are all known.
#[derive(Clone, Copy)]
pub(super) struct Section<'a> {
    source: &'a Source<'a>,
    path: &'a str,
    offset: usize,
    entries: &'a [Entry],
    known: &'a [&'static str],
}

/// A value under its full key, such as `scene[1].position_m`.
#[derive(Clone)]
pub(super) struct Field<'a> {
    source: &'a Source<'a>,
    path: String,
    value: &'a Value,
}

impl<'a> Field<'a> {
    /// The whole file.
    pub(super) fn root(source: &'a Source<'a>, tree: &'a Value) -> Self {
        Self {
            source,
            path: String::new(),
            value: tree,
        }
    }

    pub(super) fn place(&self) -> Place {
        self.source.place(self.value.offset)
    }

    pub(super) fn is_string(&self) -> bool {
        matches!(self.value.node, Node::String(_))
    }

    fn expected(&self, expected: impl Into<String>) -> TaskError {
        TaskError::WrongType {
            at: self.place(),
            key: self.path.clone(),
            expected: expected.into(),
            found: self.value.node.description(),
        }
    }

    pub(super) fn inconsistent(&self, problem: impl Into<String>) -> TaskError {
        TaskError::Inconsistent {
            at: self.place(),
            key: self.path.clone(),
            problem: problem.into(),
        }
    }

    /// A table with no other keys than those known.
    pub(super) fn section(&'a self, known: &'a [&'static str]) -> Result<Section<'a>, TaskError> {
        let Node::Table(entries) = &self.value.node else {
            return Err(self.expected("a table"));
        };
        let section = Section {
            source: self.source,
            path: &self.path,
            offset: self.value.offset,
            entries,
            known,
        };
        section.refuse_unknown(known)?;
        Ok(section)
    }

    pub(super) fn string(&self) -> Result<&'a str, TaskError> {
        match &self.value.node {
            Node::String(text) => Ok(text),
            _ => Err(self.expected("a string")),
        }
    }

    /// A string that is not empty.
    pub(super) fn name(&self) -> Result<String, TaskError> {
        let name = self.string()?;
        if name.trim().is_empty() {
            return Err(self.expected("a string that is not empty"));
        }
        Ok(name.to_owned())
    }

    pub(super) fn names(&self) -> Result<Vec<String>, TaskError> {
        self.items("an array of strings")?
            .iter()
            .map(Field::name)
            .collect()
    }

    pub(super) fn integer(&self, limits: RangeInclusive<u64>) -> Result<u64, TaskError> {
        let Node::Integer(number) = self.value.node else {
            return Err(self.expected("a whole number"));
        };
        u64::try_from(number)
            .ok()
            .filter(|number| limits.contains(number))
            .ok_or_else(|| self.out_of_range(number.to_string(), limits.start(), limits.end()))
    }

    pub(super) fn number(&self, limits: &RangeInclusive<f64>) -> Result<f64, TaskError> {
        let number = match self.value.node {
            Node::Integer(number) => number as f64,
            Node::Float(number) => number,
            _ => return Err(self.expected("a number")),
        };
        // NaN lies in no range.
        if limits.contains(&number) {
            Ok(number)
        } else {
            Err(self.out_of_range(number.to_string(), limits.start(), limits.end()))
        }
    }

    fn out_of_range(
        &self,
        value: String,
        min: &impl std::fmt::Display,
        max: &impl std::fmt::Display,
    ) -> TaskError {
        TaskError::OutOfRange {
            at: self.place(),
            key: self.path.clone(),
            value,
            limits: format!("at least {min} and at most {max}"),
        }
    }

    pub(super) fn numbers<const N: usize>(
        &self,
        limits: &RangeInclusive<f64>,
    ) -> Result<[f64; N], TaskError> {
        let expected = || format!("an array of {N} numbers");
        let items = self.items(&expected())?;
        if items.len() != N {
            return Err(self.expected(expected()));
        }
        let mut numbers = [0.0; N];
        for (number, item) in numbers.iter_mut().zip(&items) {
            *number = item.number(limits)?;
        }
        Ok(numbers)
    }

    pub(super) fn point(&self, limits: &RangeInclusive<f64>) -> Result<Point2, TaskError> {
        Ok(Point2::from(self.numbers::<2>(limits)?))
    }

    /// The items of an array, each with its index in its key.
    pub(super) fn items(&self, expected: &str) -> Result<Vec<Field<'a>>, TaskError> {
        let Node::Array(items) = &self.value.node else {
            return Err(self.expected(expected));
        };
        let field = |(index, value)| Field {
            source: self.source,
            path: format!("{}[{index}]", self.path),
            value,
        };
        Ok(items.iter().enumerate().map(field).collect())
    }
}

impl<'a> Section<'a> {
    /// The same table where fewer keys make sense, such as those of one kind of particle source.
    pub(super) fn narrowed(self, known: &'a [&'static str]) -> Result<Section<'a>, TaskError> {
        self.refuse_unknown(known)?;
        Ok(Section { known, ..self })
    }

    fn refuse_unknown(&self, known: &[&'static str]) -> Result<(), TaskError> {
        let unknown = (self.entries.iter()).find(|entry| !known.contains(&entry.key.as_str()));
        match unknown {
            None => Ok(()),
            Some(entry) => Err(TaskError::UnknownKey {
                at: self.source.place(entry.offset),
                table: self.path.to_owned(),
                unknown: Box::new(UnknownName::new("key", &entry.key, known.iter().copied())),
            }),
        }
    }

    pub(super) fn place(&self) -> Place {
        self.source.place(self.offset)
    }

    pub(super) fn inconsistent(&self, problem: impl Into<String>) -> TaskError {
        TaskError::Inconsistent {
            at: self.place(),
            key: self.path.to_owned(),
            problem: problem.into(),
        }
    }

    pub(super) fn get(&self, key: &'static str) -> Option<Field<'a>> {
        debug_assert!(
            self.known.contains(&key),
            "{key} is missing from the known keys"
        );
        let entry = self.entries.iter().find(|entry| entry.key == key)?;
        Some(Field {
            source: self.source,
            path: match self.path {
                "" => key.to_owned(),
                path => format!("{path}.{key}"),
            },
            value: &entry.value,
        })
    }

    pub(super) fn require(&self, key: &'static str) -> Result<Field<'a>, TaskError> {
        self.get(key).ok_or_else(|| TaskError::Missing {
            at: self.place(),
            table: self.path.to_owned(),
            key,
        })
    }

    /// The one of these keys that is there.
    pub(super) fn exactly_one(
        &self,
        keys: &[&'static str],
    ) -> Result<(&'static str, Field<'a>), TaskError> {
        let found: Vec<_> = keys
            .iter()
            .filter_map(|&key| Some((key, self.get(key)?)))
            .collect();
        match <[_; 1]>::try_from(found) {
            Ok([one]) => Ok(one),
            Err(found) => {
                let problem = match &found[..] {
                    [] => format!(
                        "exactly one of {} is needed, none is there",
                        keys.join(", ")
                    ),
                    [(one, _), (other, _), ..] => format!(
                        "exactly one of {} is needed, {one} and {other} are there",
                        keys.join(", ")
                    ),
                    [_] => unreachable!("one was taken above"),
                };
                Err(match found.into_iter().nth(1) {
                    Some((_, second)) => TaskError::Inconsistent {
                        at: second.place(),
                        key: self.path.to_owned(),
                        problem,
                    },
                    None => self.inconsistent(problem),
                })
            }
        }
    }

    pub(super) fn number_or(
        &self,
        key: &'static str,
        limits: &RangeInclusive<f64>,
        default: f64,
    ) -> Result<f64, TaskError> {
        self.get(key)
            .map_or(Ok(default), |field| field.number(limits))
    }
}
