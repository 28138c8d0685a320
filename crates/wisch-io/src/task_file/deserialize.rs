//! A serde deserializer over the tree of a task file, whose errors state location and key.

use super::TaskError;
use super::tree::{Source, description, float, integer};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::value::{StrDeserializer, U64Deserializer};
use serde::de::{
    self, DeserializeSeed, Deserializer, EnumAccess, Expected, IntoDeserializer, MapAccess,
    SeqAccess, Unexpected, VariantAccess, Visitor,
};
use serde::{Deserialize, forward_to_deserialize_any};
use std::borrow::Cow;
use std::fmt;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};
use wisch::source_location::{Place, UnknownName};

/// The earlier name of the action dispense and of its table, which is read, but not advised.
const EARLIER_NAME: &str = "emit";

/// Name of the newtype with which [`At`] requests the location of its value.
const AT: &str = "At";

/// Reads a record; its type defines the keys, which are required, and their limits.
pub(super) fn record<'de, T: Deserialize<'de>>(
    source: &'de Source<'de>,
    tree: &'de Spanned<DeValue<'de>>,
) -> Result<T, TaskError> {
    let root = Field {
        source,
        path: String::new(),
        value: tree,
    };
    T::deserialize(root).map_err(|fault| match fault {
        Fault::Placed(error) => *error,
        // Every value is read by a field, which adds the location to its errors.
        Fault::Unplaced(problem) => TaskError::Inconsistent {
            at: source.place(0),
            key: String::new(),
            problem: format!("{problem:?}"),
        },
    })
}

/// A value with its location, for checks that involve other values.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct At<T> {
    pub(super) place: Place,
    /// The full key, such as `scene[1].position_m`; empty at the top level.
    pub(super) path: String,
    pub(super) value: T,
}

impl<T> At<T> {
    pub(super) fn inconsistent(&self, problem: impl Into<String>) -> TaskError {
        TaskError::Inconsistent {
            at: self.place.clone(),
            key: self.path.clone(),
            problem: problem.into(),
        }
    }

    /// Returns the location without the value.
    pub(super) fn without_value(&self) -> At<()> {
        At {
            place: self.place.clone(),
            path: self.path.clone(),
            value: (),
        }
    }

    /// Makes the error of a missing key of this table.
    pub(super) fn missing(&self, key: &'static str) -> TaskError {
        TaskError::Missing {
            at: self.place.clone(),
            table: self.path.clone(),
            key,
        }
    }

    /// Checks that exactly one of these keys of this table is given. `keys`: names and locations.
    pub(super) fn exactly_one(&self, keys: &[(&str, Option<&Place>)]) -> Result<(), TaskError> {
        let names: Vec<&str> = keys.iter().map(|(name, _)| *name).collect();
        let found: Vec<(&str, &Place)> = (keys.iter())
            .filter_map(|(name, place)| Some((*name, (*place)?)))
            .collect();
        let (at, found) = match &found[..] {
            [_] => return Ok(()),
            [] => (&self.place, "none is given".to_owned()),
            [(one, _), (other, second), ..] => (*second, format!("{one} and {other} are given")),
        };
        Err(TaskError::Inconsistent {
            at: at.clone(),
            key: self.path.clone(),
            problem: format!(
                "exactly one of {} is required, but {found}",
                names.join(", ")
            ),
        })
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for At<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Parts<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Parts<T> {
            type Value = At<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value with its place")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut parts: A) -> Result<At<T>, A::Error> {
                let lacks = |index| de::Error::invalid_length(index, &"place, path and value");
                Ok(At {
                    place: Place {
                        file: parts.next_element()?.ok_or_else(|| lacks(0))?,
                        line: parts.next_element::<u64>()?.ok_or_else(|| lacks(1))? as usize,
                        column: parts.next_element::<u64>()?.ok_or_else(|| lacks(2))? as usize,
                    },
                    path: parts.next_element()?.ok_or_else(|| lacks(3))?,
                    value: parts.next_element()?.ok_or_else(|| lacks(4))?,
                })
            }
        }
        deserializer.deserialize_newtype_struct(AT, Parts(std::marker::PhantomData))
    }
}

impl<T: JsonSchema> JsonSchema for At<T> {
    fn inline_schema() -> bool {
        T::inline_schema()
    }
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        T::json_schema(generator)
    }
}

/// The error of a value, without or with its location.
#[derive(Debug)]
enum Fault {
    Placed(Box<TaskError>),
    Unplaced(Problem),
}

#[derive(Debug)]
enum Problem {
    /// Wrong type; the expected type.
    Expected(String),
    /// Outside limits; the limits.
    Limits(String),
    MissingKey(&'static str),
    UnknownKey(String, &'static [&'static str]),
    UnknownName(String, &'static [&'static str]),
    Other(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Placed(error) => error.fmt(f),
            Self::Unplaced(problem) => write!(f, "{problem:?}"),
        }
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::Unplaced(Problem::Other(message.to_string()))
    }
    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::Unplaced(Problem::Expected(expected.to_string()))
    }
    fn invalid_value(_: Unexpected<'_>, limits: &dyn Expected) -> Self {
        Self::Unplaced(Problem::Limits(limits.to_string()))
    }
    fn missing_field(key: &'static str) -> Self {
        Self::Unplaced(Problem::MissingKey(key))
    }
    fn unknown_field(key: &str, known: &'static [&'static str]) -> Self {
        Self::Unplaced(Problem::UnknownKey(key.to_owned(), known))
    }
    fn unknown_variant(name: &str, known: &'static [&'static str]) -> Self {
        Self::Unplaced(Problem::UnknownName(name.to_owned(), known))
    }
}

/// Iterates over the names of this version, without those that only files of earlier versions have.
fn current(known: &[&'static str]) -> impl Iterator<Item = &'static str> {
    known.iter().copied().filter(|name| *name != EARLIER_NAME)
}

/// A value with its full key.
#[derive(Clone)]
struct Field<'de> {
    source: &'de Source<'de>,
    path: String,
    value: &'de Spanned<DeValue<'de>>,
}

impl<'de> Field<'de> {
    fn node(&self) -> &'de DeValue<'de> {
        self.value.get_ref()
    }

    fn place(&self) -> Place {
        self.source.place(self.value.span().start)
    }

    /// Makes the located error of this value. `kind`: the kind of things that a name in it denotes.
    fn placed(&self, fault: Fault, kind: &'static str) -> Fault {
        let Fault::Unplaced(problem) = fault else {
            return fault;
        };
        let at = self.place();
        let key = self.path.clone();
        Fault::Placed(Box::new(match problem {
            Problem::Expected(expected) => TaskError::WrongType {
                at,
                key,
                expected,
                found: description(self.node()),
            },
            Problem::Limits(limits) => TaskError::OutOfRange {
                at,
                key,
                value: description(self.node()),
                limits,
            },
            Problem::MissingKey(missing) => TaskError::Missing {
                at,
                table: key,
                key: missing,
            },
            Problem::UnknownKey(unknown, known) => TaskError::UnknownKey {
                at,
                table: key,
                unknown: Box::new(UnknownName::new("key", &unknown, current(known))),
            },
            Problem::UnknownName(unknown, known) => TaskError::UnknownReference {
                at,
                unknown: Box::new(UnknownName::new(kind, &unknown, current(known))),
            },
            Problem::Other(problem) => TaskError::Inconsistent { at, key, problem },
        }))
    }

    fn expected<T>(&self, expected: impl Into<String>) -> Result<T, Fault> {
        Err(self.placed(Fault::Unplaced(Problem::Expected(expected.into())), ""))
    }

    fn visit<V: Visitor<'de>>(self, visitor: V, kind: &'static str) -> Result<V::Value, Fault> {
        let unusable = || de::Error::invalid_type(Unexpected::Unit, &visitor);
        let result = match self.node() {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Integer(number) => match integer(number) {
                Some(number) => match u64::try_from(number) {
                    Ok(number) => visitor.visit_u64(number),
                    Err(_) => visitor.visit_i128(number),
                },
                None => Err(unusable()),
            },
            DeValue::Float(number) => match float(number) {
                Some(number) => visitor.visit_f64(number),
                None => Err(unusable()),
            },
            DeValue::Array(items) => visitor.visit_seq(Items {
                array: &self,
                items: items.iter().enumerate(),
            }),
            DeValue::Table(entries) => visitor.visit_map(Entries::new(&self, entries, "")),
            DeValue::Boolean(is_on) => visitor.visit_bool(*is_on),
            // Dates, which no key of a task accepts.
            DeValue::Datetime(_) => Err(unusable()),
        };
        result.map_err(|fault| self.placed(fault, kind))
    }
}

impl<'de> Deserializer<'de> for Field<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.visit(visitor, "name")
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if name == AT {
            visitor.visit_seq(Parts {
                place: self.place(),
                field: self,
                next: 0,
            })
        } else {
            visitor.visit_newtype_struct(self)
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node() {
            DeValue::Array(_) => self.visit(visitor, ""),
            _ => self.expected("an array"),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Fault> {
        match self.node() {
            DeValue::Array(items) if items.len() == len => self.visit(visitor, ""),
            _ => self.expected(format!("an array of length {len}")),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.node() {
            DeValue::Table(_) => self.visit(visitor, ""),
            _ => self.expected("a table"),
        }
    }

    /// An enum without data is a string. An enum with data is a table, whose tag key has the enum's name.
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.node() {
            DeValue::String(text) => {
                let variant: StrDeserializer<'_, Fault> = text.as_ref().into_deserializer();
                (visitor.visit_enum(variant)).map_err(|fault| self.placed(fault, name))
            }
            DeValue::Table(entries) => {
                let Some(tag) = entries.get(name) else {
                    return Err(self.placed(Fault::Unplaced(Problem::MissingKey(name)), name));
                };
                let tag = self.entry(name, tag);
                let DeValue::String(variant) = tag.node() else {
                    return tag.expected("a string");
                };
                if !variants.contains(&variant.as_ref()) {
                    let unknown = Problem::UnknownName(variant.to_string(), variants);
                    return Err(tag.placed(Fault::Unplaced(unknown), name));
                }
                let tagged = Tagged {
                    table: &self,
                    variant,
                    entries,
                    tag: name,
                };
                (visitor.visit_enum(tagged)).map_err(|fault| self.placed(fault, name))
            }
            DeValue::Integer(number)
                if let Some(Ok(number)) = integer(number).map(u64::try_from) =>
            {
                (visitor.visit_u64(number)).map_err(|fault| self.placed(fault, name))
            }
            _ => self.expected("a string"),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct tuple_struct map identifier ignored_any
    }
}

impl<'de> Field<'de> {
    fn entry(&self, key: &str, value: &'de Spanned<DeValue<'de>>) -> Field<'de> {
        Field {
            source: self.source,
            path: match self.path.as_str() {
                "" => key.to_owned(),
                path => format!("{path}.{key}"),
            },
            value,
        }
    }
}

/// Place, path and value, for [`At`].
struct Parts<'de> {
    field: Field<'de>,
    place: Place,
    next: usize,
}

impl<'de> SeqAccess<'de> for Parts<'de> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let number =
            |number: usize| -> U64Deserializer<Fault> { (number as u64).into_deserializer() };
        self.next += 1;
        match self.next {
            1 => seed.deserialize(self.place.file.clone().into_deserializer()),
            2 => seed.deserialize(number(self.place.line)),
            3 => seed.deserialize(number(self.place.column)),
            4 => seed.deserialize(self.field.path.clone().into_deserializer()),
            5 => seed.deserialize(self.field.clone()),
            _ => return Ok(None),
        }
        .map(Some)
    }
}

struct Items<'a, 'de> {
    array: &'a Field<'de>,
    items: std::iter::Enumerate<std::slice::Iter<'de, Spanned<DeValue<'de>>>>,
}

impl<'de> SeqAccess<'de> for Items<'_, 'de> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let Some((index, value)) = self.items.next() else {
            return Ok(None);
        };
        let item = Field {
            source: self.array.source,
            path: format!("{}[{index}]", self.array.path),
            value,
        };
        seed.deserialize(item).map(Some)
    }
}

/// A key with its value.
type Entry<'de> = (&'de Spanned<DeString<'de>>, &'de Spanned<DeValue<'de>>);

struct Entries<'a, 'de> {
    table: &'a Field<'de>,
    entries: std::vec::IntoIter<Entry<'de>>,
    current: Option<Entry<'de>>,
}

impl<'a, 'de> Entries<'a, 'de> {
    /// `left_out`: the tag key, which names the table's variant.
    fn new(table: &'a Field<'de>, entries: &'de DeTable<'de>, left_out: &str) -> Self {
        let is_in = |(key, _): &Entry<'de>| key.get_ref() != left_out;
        let mut entries: Vec<_> = entries.iter().filter(is_in).collect();
        // In the order of the text, so that the first of several errors is reported.
        entries.sort_by_key(|(key, _)| key.span().start);
        Self {
            table,
            entries: entries.into_iter(),
            current: None,
        }
    }
}

impl<'de> MapAccess<'de> for Entries<'_, 'de> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Fault> {
        self.current = self.entries.next();
        let Some((key, _)) = self.current else {
            return Ok(None);
        };
        let name: StrDeserializer<'_, Fault> = key.get_ref().as_ref().into_deserializer();
        seed.deserialize(name).map(Some).map_err(|fault| {
            // The error is in the key, not in its value.
            match self.table.placed(fault, "key") {
                Fault::Placed(mut error) => {
                    if let TaskError::UnknownKey { at, .. } = &mut *error {
                        *at = self.table.source.place(key.span().start);
                    }
                    Fault::Placed(error)
                }
                unplaced => unplaced,
            }
        })
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        match self.current {
            Some((key, value)) => seed.deserialize(self.table.entry(key.get_ref(), value)),
            None => Err(de::Error::custom("a value without its key")),
        }
    }
}

/// A table whose variant is known from its tag.
struct Tagged<'a, 'de> {
    table: &'a Field<'de>,
    variant: &'de str,
    entries: &'de DeTable<'de>,
    tag: &'static str,
}

impl<'de> EnumAccess<'de> for Tagged<'_, 'de> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(
        self,
        seed: V,
    ) -> Result<(V::Value, Self::Variant), Fault> {
        let variant: StrDeserializer<'_, Fault> = self.variant.into_deserializer();
        Ok((seed.deserialize(variant)?, self))
    }
}

impl<'de> VariantAccess<'de> for Tagged<'_, 'de> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        self.table.expected("a string")
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, _: T) -> Result<T::Value, Fault> {
        self.table.expected("a string")
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, _: V) -> Result<V::Value, Fault> {
        self.table.expected("a string")
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_map(Entries::new(self.table, self.entries, self.tag))
    }
}
