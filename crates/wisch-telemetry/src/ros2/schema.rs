//! Message layouts, parsed from the text of a `ros2msg` schema.

use super::definitions::is_separator;
use std::collections::HashMap;
use std::num::NonZero;

/// Largest number of lines in a schema: far above any message that robots exchange.
const MAX_LINES: usize = 100_000;

/// A reason why a schema cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SchemaError {
    /// The schema is not text.
    #[error("the schema is not UTF-8 text from byte {byte} on")]
    NotText {
        /// Position of the first invalid byte.
        byte: usize,
    },
    /// The schema is too long.
    #[error("the schema has {lines} lines; the limit is {MAX_LINES}")]
    TooLong {
        /// Number of its lines.
        lines: usize,
    },
    /// A line is neither a field nor a constant.
    #[error("line {line} of the schema is neither a field nor a constant: {text:?}")]
    Field {
        /// Counted from 1.
        line: usize,
        /// The line.
        text: String,
    },
    /// A type is not defined.
    #[error("line {line} of the schema: type {name:?} is not defined")]
    Undefined {
        /// Counted from 1.
        line: usize,
        /// Name of the type.
        name: String,
    },
    /// A type contains itself.
    #[error("type {name:?} of the schema contains itself")]
    Endless {
        /// Name of the type.
        name: String,
    },
}

/// Type of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Bool,
    Unsigned {
        len: usize,
    },
    Signed {
        len: usize,
    },
    Float32,
    Float64,
    Text,
    WideText,
    /// Index of its definition.
    Message(usize),
}

/// Number of values in a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    One,
    Array(usize),
    Sequence,
}

/// A field of a message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Field {
    pub name: String,
    pub kind: Kind,
    pub shape: Shape,
}

/// The fields of a type, in order.
type Fields = Vec<Field>;

/// Layout of a message: its fields, and those of every nested message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Schema {
    /// Definitions of all types; the first is the message's own.
    definitions: Vec<Fields>,
}

/// A part of the text: a type's name, and its lines with their numbers.
struct Part<'a> {
    name: String,
    lines: Vec<(usize, &'a str)>,
}

impl Schema {
    /// Parses the definition of a type, `package/msg/Name`, and of its nested types.
    pub fn parse(name: &str, text: &[u8]) -> Result<Self, SchemaError> {
        let text = std::str::from_utf8(text).map_err(|error| SchemaError::NotText {
            byte: error.valid_up_to(),
        })?;
        let parts = parts(name, text)?;
        let mut numbers = HashMap::new();
        for (number, part) in parts.iter().enumerate() {
            numbers.entry(part.name.as_str()).or_insert(number);
        }
        let mut definitions = Vec::with_capacity(parts.len());
        for part in &parts {
            let mut fields = Fields::new();
            for &(line, text) in &part.lines {
                fields.extend(field(line, text, &part.name, &numbers)?);
            }
            definitions.push(fields);
        }
        check_finite(&definitions, &parts)?;
        Ok(Self { definitions })
    }

    /// The message's own fields.
    pub fn root(&self) -> &[Field] {
        self.fields(0)
    }

    /// The fields of a nested message, by the index in [`Kind::Message`].
    pub fn fields(&self, definition: usize) -> &[Field] {
        &self.definitions[definition]
    }

    /// Finds a field by its path below some message's fields. Returns the indices along the path, and the field. Dots
    /// separate the names of the path; a field on the path must hold one value only.
    pub fn find<'a>(
        &'a self,
        mut fields: &'a [Field],
        path: &str,
    ) -> Option<(Vec<usize>, &'a Field)> {
        let mut indices = Vec::new();
        let mut names = path.split('.').peekable();
        while let Some(name) = names.next() {
            let index = fields.iter().position(|field| field.name == name)?;
            indices.push(index);
            let field = &fields[index];
            if names.peek().is_none() {
                return Some((indices, field));
            }
            match (field.kind, field.shape) {
                (Kind::Message(definition), Shape::One) => fields = self.fields(definition),
                _ => return None,
            }
        }
        None
    }
}

/// Splits the text into parts at its separators.
fn parts<'a>(name: &str, text: &'a str) -> Result<Vec<Part<'a>>, SchemaError> {
    let lines = text.lines().count();
    if lines > MAX_LINES {
        return Err(SchemaError::TooLong { lines });
    }
    let mut parts = vec![Part {
        name: short(name),
        lines: Vec::new(),
    }];
    let mut begins = false;
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if is_separator(line) {
            begins = true;
        } else if let (true, Some(name)) = (begins, line.strip_prefix("MSG:")) {
            begins = false;
            parts.push(Part {
                name: short(name.trim()),
                lines: Vec::new(),
            });
        } else if let Some(part) = parts.last_mut() {
            let line = without_comment(line);
            if !line.is_empty() {
                part.lines.push((index + 1, line));
            }
        }
    }
    Ok(parts)
}

/// Returns `package/Name` for `package/msg/Name`.
fn short(name: &str) -> String {
    name.replacen("/msg/", "/", 1)
}

/// Returns the line up to its comment; a hash in quotes does not begin a comment.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    for (at, c) in line.char_indices() {
        match (quote, c) {
            (None, '#') => return line[..at].trim_end(),
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            _ => {}
        }
    }
    line
}

/// Parses the field that a line states; `None` for a constant.
fn field(
    line: usize,
    text: &str,
    within: &str,
    numbers: &HashMap<&str, usize>,
) -> Result<Option<Field>, SchemaError> {
    let bad = || SchemaError::Field {
        line,
        text: text.to_owned(),
    };
    let (kind, rest) = text.split_once(char::is_whitespace).ok_or_else(bad)?;
    let rest = rest.trim_start();
    let end = rest
        .find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
        .unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    if name.is_empty() {
        return Err(bad());
    }
    // "int32 POINTS=8" is a constant, "int32 count 8" a field with a default.
    if after.trim_start().starts_with('=') {
        return Ok(None);
    }
    let (kind, shape) = match kind.split_once('[') {
        None => (kind, Shape::One),
        Some((kind, "]")) => (kind, Shape::Sequence),
        Some((kind, size)) => {
            let size = size.strip_suffix(']').ok_or_else(bad)?;
            match size.strip_prefix("<=") {
                Some(bound) => {
                    bound.parse::<u32>().map_err(|_| bad())?;
                    (kind, Shape::Sequence)
                }
                None => {
                    // A message in an array of length 0 would take no bytes, so that a list of such messages would have
                    // no end.
                    let count = size.parse::<NonZero<u32>>().map_err(|_| bad())?;
                    (kind, Shape::Array(count.get() as usize))
                }
            }
        }
    };
    let kind = primitive(kind)
        .or_else(|| message(kind, within, numbers))
        .ok_or_else(|| SchemaError::Undefined {
            line,
            name: kind.to_owned(),
        })?;
    Ok(Some(Field {
        name: name.to_owned(),
        kind,
        shape,
    }))
}

fn primitive(name: &str) -> Option<Kind> {
    // A bound on a text's length does not change its layout.
    let name = name.split_once("<=").map_or(name, |(name, _)| name);
    Some(match name {
        "bool" => Kind::Bool,
        "byte" | "char" | "uint8" => Kind::Unsigned { len: 1 },
        "uint16" => Kind::Unsigned { len: 2 },
        "uint32" => Kind::Unsigned { len: 4 },
        "uint64" => Kind::Unsigned { len: 8 },
        "int8" => Kind::Signed { len: 1 },
        "int16" => Kind::Signed { len: 2 },
        "int32" => Kind::Signed { len: 4 },
        "int64" => Kind::Signed { len: 8 },
        "float32" => Kind::Float32,
        "float64" => Kind::Float64,
        "string" => Kind::Text,
        "wstring" => Kind::WideText,
        _ => return None,
    })
}

/// Resolves a message by its name, which may omit the package if it is that of the type around it.
fn message(name: &str, within: &str, numbers: &HashMap<&str, usize>) -> Option<Kind> {
    let name = short(name);
    let package = within.split('/').next().unwrap_or_default();
    let candidates = [
        name.clone(),
        format!("{package}/{name}"),
        format!("std_msgs/{name}"),
    ];
    candidates
        .iter()
        .find_map(|name| numbers.get(name.as_str()))
        .map(|&number| Kind::Message(number))
}

/// State of the check of a definition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Checked {
    Unseen,
    Open,
    Done,
}

/// Checks that no type contains itself: decoding its messages would not end.
fn check_finite(definitions: &[Fields], parts: &[Part<'_>]) -> Result<(), SchemaError> {
    let mut checked = vec![Checked::Unseen; definitions.len()];
    // Depth-first search. Each entry holds a definition and the index of its next field. The stack is explicit, because
    // a schema may be nested arbitrarily deep.
    let mut stack = vec![(0, 0)];
    while let Some((definition, next)) = stack.pop() {
        checked[definition] = Checked::Open;
        let Some(field) = definitions[definition].get(next) else {
            checked[definition] = Checked::Done;
            continue;
        };
        stack.push((definition, next + 1));
        if let Kind::Message(inner) = field.kind {
            match checked[inner] {
                Checked::Open => {
                    return Err(SchemaError::Endless {
                        name: parts[inner].name.clone(),
                    });
                }
                Checked::Unseen => stack.push((inner, 0)),
                Checked::Done => {}
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::definitions::full_definition;
    use super::*;
    use proptest::prelude::*;

    fn parse(text: &str) -> Result<Schema, SchemaError> {
        Schema::parse("my_msgs/msg/Thing", text.as_bytes())
    }

    #[test]
    fn fields_arrays_bounds_defaults_constants_and_comments_are_parsed() {
        let schema = parse(
            "# about it\nint32 LIMIT=8\nstring NAME = 'a # b'\nfloat64[3] v # m\nstring<=5[<=2] words\n\
             uint8 level 3\nstring text \"x # y\"\nPart[] parts\n===\nMSG: my_msgs/Part\nbool on\n",
        )
        .unwrap();
        let shown: Vec<_> = schema
            .root()
            .iter()
            .map(|f| (f.name.as_str(), f.kind, f.shape))
            .collect();
        assert_eq!(
            shown,
            [
                ("v", Kind::Float64, Shape::Array(3)),
                ("words", Kind::Text, Shape::Sequence),
                ("level", Kind::Unsigned { len: 1 }, Shape::One),
                ("text", Kind::Text, Shape::One),
                ("parts", Kind::Message(1), Shape::Sequence),
            ]
        );
    }

    #[test]
    fn a_field_is_found_by_its_path_through_single_messages_only() {
        let text = full_definition("geometry_msgs/PoseStamped");
        let schema = Schema::parse("geometry_msgs/msg/PoseStamped", text.as_bytes()).unwrap();
        assert_eq!(
            schema.find(schema.root(), "pose.orientation.w").unwrap().0,
            [1, 1, 3]
        );
        assert_eq!(
            schema.find(schema.root(), "header.stamp").unwrap().0,
            [0, 0]
        );
        for path in ["", "pose.", "pose.place", "pose.position.x.y"] {
            assert!(schema.find(schema.root(), path).is_none(), "{path}");
        }
        let text = full_definition("tf2_msgs/TFMessage");
        let schema = Schema::parse("tf2_msgs/msg/TFMessage", text.as_bytes()).unwrap();
        assert!(schema.find(schema.root(), "transforms").is_some());
        assert!(schema.find(schema.root(), "transforms.transform").is_none());
    }

    #[test]
    fn invalid_schemas_are_refused_with_their_line() {
        let refused = |text: &str| parse(text).unwrap_err().to_string();
        assert_eq!(
            refused("int32 a\nnonsense\n"),
            "line 2 of the schema is neither a field nor a constant: \"nonsense\""
        );
        assert_eq!(
            refused("int32[x] a"),
            "line 1 of the schema is neither a field nor a constant: \"int32[x] a\""
        );
        assert_eq!(
            refused("int32[0] a"),
            "line 1 of the schema is neither a field nor a constant: \"int32[0] a\""
        );
        assert_eq!(
            refused("other_msgs/Part a"),
            "line 1 of the schema: type \"other_msgs/Part\" is not defined"
        );
        assert_eq!(
            refused("A a\n===\nMSG: my_msgs/A\nB[] b\n===\nMSG: my_msgs/B\nA[] a"),
            "type \"my_msgs/A\" of the schema contains itself"
        );
        assert_eq!(
            Schema::parse("a/B", b"int32 \xff"),
            Err(SchemaError::NotText { byte: 6 })
        );
    }

    proptest! {
        #[test]
        fn arbitrary_text_causes_no_panic(text in "[a-z0-9/\\[\\]<=# \n'\"=MSG:]{0,200}") {
            let _ = parse(&text);
        }
    }
}
