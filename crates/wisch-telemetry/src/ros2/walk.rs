//! Decoder of CDR messages by their schema.

use super::schema::{Field, Kind, Schema, Shape};

/// Length of the header that states the encoding of the rest [bytes].
const ENCAPSULATION_LEN: usize = 4;

/// Largest nesting of messages: each level takes its share of the stack.
const MAX_DEPTH: usize = 64;

/// Largest number of kept numbers or texts in a list, more than a robot has joints.
const MAX_KEPT: usize = 1000;

/// A reason why a message cannot be decoded.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MessageError {
    /// The message ends too early.
    #[error("byte {byte}: {needed} more bytes are needed, but {left} are left")]
    TooShort {
        /// Position in the message.
        byte: usize,
        /// Number of bytes that are needed.
        needed: usize,
        /// Number of bytes that are left.
        left: usize,
    },
    /// The encoding is not supported.
    #[error(
        "its encoding 0x{0:04x} is not plain CDR, which is 0x0000 (big-endian) or 0x0001 (little-endian)"
    )]
    Encapsulation(u16),
    /// A text is not UTF-8.
    #[error("byte {byte}: text is not UTF-8")]
    Text {
        /// Position at which it begins.
        byte: usize,
    },
    /// A text of wide characters, whose layout differs between vendors.
    #[error("field {field:?} is a wstring, which is not read")]
    WideText {
        /// Name of the field.
        field: String,
    },
    /// Messages are nested too deep.
    #[error("messages are nested deeper than the limit of {MAX_DEPTH}")]
    TooDeep,
}

/// A value of a message.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// A number or a boolean; integers beyond 2⁵³ are rounded.
    Number(f64),
    Text(String),
    /// One value for each field, in order.
    Message(Vec<Value>),
    /// A list of messages.
    List(Vec<Value>),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// A list of texts.
    Texts(Vec<String>),
    /// A long list of numbers or texts, for example an image, which is never needed.
    Skipped,
}

impl Value {
    /// Returns the value at a path of [`Schema::find`].
    pub fn field(&self, path: &[usize]) -> Option<&Self> {
        path.iter().try_fold(self, |value, &index| match value {
            Self::Message(values) => values.get(index),
            _ => None,
        })
    }

    /// Returns the number, if the value is a number.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }
}

/// Decodes a message.
pub(crate) fn decode(schema: &Schema, bytes: &[u8]) -> Result<Value, MessageError> {
    let Some((header, payload)) = bytes.split_at_checked(ENCAPSULATION_LEN) else {
        return Err(MessageError::TooShort {
            byte: 0,
            needed: ENCAPSULATION_LEN,
            left: bytes.len(),
        });
    };
    let little = match u16::from_be_bytes([header[0], header[1]]) {
        0 => false,
        1 => true,
        other => return Err(MessageError::Encapsulation(other)),
    };
    let mut walker = Walker {
        schema,
        payload,
        at: 0,
        little,
    };
    walker.message(schema.root(), 0)
}

struct Walker<'a> {
    schema: &'a Schema,
    /// The bytes after the encapsulation; alignment counts from here.
    payload: &'a [u8],
    at: usize,
    little: bool,
}

impl<'a> Walker<'a> {
    fn message(&mut self, fields: &'a [Field], depth: usize) -> Result<Value, MessageError> {
        if depth > MAX_DEPTH {
            return Err(MessageError::TooDeep);
        }
        if fields.is_empty() {
            // A message without fields is sent with one byte in it.
            self.take(1)?;
        }
        let values = fields.iter().map(|field| self.field(field, depth));
        Ok(Value::Message(values.collect::<Result<_, _>>()?))
    }

    fn field(&mut self, field: &'a Field, depth: usize) -> Result<Value, MessageError> {
        let count = match field.shape {
            Shape::One => return self.value(field, depth),
            Shape::Array(count) => count,
            Shape::Sequence => self.unsigned(4)? as usize,
        };
        match field.kind {
            Kind::Message(_) => {
                // Every message takes at least one byte, so a false count ends with the bytes.
                let values = (0..count).map(|_| self.value(field, depth));
                Ok(Value::List(values.collect::<Result<_, _>>()?))
            }
            Kind::Float64 if count <= MAX_KEPT => {
                let bits = (0..count).map(|_| Ok(f64::from_bits(self.unsigned(8)?)));
                Ok(Value::Numbers(bits.collect::<Result<_, _>>()?))
            }
            Kind::Text if count <= MAX_KEPT => {
                let texts = (0..count).map(|_| self.text());
                Ok(Value::Texts(texts.collect::<Result<_, _>>()?))
            }
            Kind::Text | Kind::WideText => {
                for _ in 0..count {
                    self.value(field, depth)?;
                }
                Ok(Value::Skipped)
            }
            Kind::Bool => self.skip(count, 1),
            Kind::Unsigned { len } | Kind::Signed { len } => self.skip(count, len),
            Kind::Float32 => self.skip(count, 4),
            Kind::Float64 => self.skip(count, 8),
        }
    }

    fn value(&mut self, field: &'a Field, depth: usize) -> Result<Value, MessageError> {
        Ok(match field.kind {
            Kind::Bool => Value::Number(self.unsigned(1)? as f64),
            Kind::Unsigned { len } => Value::Number(self.unsigned(len)? as f64),
            Kind::Signed { len } => {
                let bits = 8 * len as u32;
                // Sign extension: the shift to the top and back copies the sign bit.
                let signed = (self.unsigned(len)? << (64 - bits)) as i64 >> (64 - bits);
                Value::Number(signed as f64)
            }
            Kind::Float32 => Value::Number(f32::from_bits(self.unsigned(4)? as u32).into()),
            Kind::Float64 => Value::Number(f64::from_bits(self.unsigned(8)?)),
            Kind::Text => Value::Text(self.text()?),
            Kind::WideText => {
                return Err(MessageError::WideText {
                    field: field.name.clone(),
                });
            }
            Kind::Message(definition) => self.message(self.schema.fields(definition), depth + 1)?,
        })
    }

    /// Reads a text, which is stored with its length and a final zero.
    fn text(&mut self) -> Result<String, MessageError> {
        let len = self.unsigned(4)? as usize;
        let byte = ENCAPSULATION_LEN + self.at;
        let bytes = self.take(len)?;
        let bytes = bytes.strip_suffix(&[0]).unwrap_or(bytes);
        let text = std::str::from_utf8(bytes).map_err(|_| MessageError::Text { byte })?;
        Ok(text.to_owned())
    }

    fn skip(&mut self, count: usize, len: usize) -> Result<Value, MessageError> {
        if count > 0 {
            self.align(len);
            self.take(count.saturating_mul(len))?;
        }
        Ok(Value::Skipped)
    }

    fn unsigned(&mut self, len: usize) -> Result<u64, MessageError> {
        self.align(len);
        let little = self.little;
        let bytes = self.take(len)?;
        let join = |number: u64, byte: &u8| (number << 8) | u64::from(*byte);
        Ok(if little {
            bytes.iter().rev().fold(0, join)
        } else {
            bytes.iter().fold(0, join)
        })
    }

    fn align(&mut self, len: usize) {
        self.at = self.at.next_multiple_of(len);
    }

    fn take(&mut self, len: usize) -> Result<&'a [u8], MessageError> {
        let left = self.payload.len().saturating_sub(self.at);
        if len > left {
            return Err(MessageError::TooShort {
                byte: ENCAPSULATION_LEN + self.at,
                needed: len,
                left,
            });
        }
        let bytes = &self.payload[self.at..self.at + len];
        self.at += len;
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::super::definitions::full_definition;
    use super::*;
    use cdr::{CdrBe, CdrLe, Infinite};
    use proptest::prelude::*;
    use serde::Serialize;

    #[derive(Serialize)]
    struct Mixed {
        on: bool,
        near: i16,
        words: Vec<String>,
        far: i64,
        small: f32,
        bytes: Vec<u8>,
        parts: Vec<(u8, f64)>,
        three: [f64; 3],
        last: u32,
    }

    const MIXED: &str = "bool on\nint16 near\nstring[] words\nint64 far\nfloat32 small\nuint8[] bytes\nPart[] parts\n\
                         float64[3] three\nuint32 last\n===\nMSG: a/Part\nuint8 id\nfloat64 x\n";

    fn schema() -> Schema {
        Schema::parse("a/Mixed", MIXED.as_bytes()).unwrap()
    }

    fn expected(mixed: &Mixed) -> Value {
        let part = |(id, x): &(u8, f64)| {
            Value::Message(vec![Value::Number(f64::from(*id)), Value::Number(*x)])
        };
        Value::Message(vec![
            Value::Number(f64::from(u8::from(mixed.on))),
            Value::Number(f64::from(mixed.near)),
            Value::Texts(mixed.words.clone()),
            Value::Number(mixed.far as f64),
            Value::Number(f64::from(mixed.small)),
            Value::Skipped,
            Value::List(mixed.parts.iter().map(part).collect()),
            Value::Numbers(mixed.three.to_vec()),
            Value::Number(f64::from(mixed.last)),
        ])
    }

    proptest! {
        #[test]
        fn messages_of_another_library_are_decoded(
            on: bool, near: i16, words in prop::collection::vec("[a-zé]{0,9}", 0..4), far in -(1_i64 << 53)..(1 << 53),
            small in -1e6_f32..1e6, bytes in prop::collection::vec(any::<u8>(), 0..9),
            parts in prop::collection::vec((any::<u8>(), -1e9..1e9), 0..4), three: [i32; 3], last: u32, big_endian: bool,
        ) {
            let three = three.map(f64::from);
            let mixed = Mixed { on, near, words, far, small, bytes, parts, three, last };
            let message = if big_endian {
                cdr::serialize::<_, _, CdrBe>(&mixed, Infinite)
            } else {
                cdr::serialize::<_, _, CdrLe>(&mixed, Infinite)
            };
            let message = message.unwrap();
            prop_assert_eq!(decode(&schema(), &message), Ok(expected(&mixed)));
            // The last field ends the message, so every shorter message is incomplete.
            let shorter = decode(&schema(), &message[..message.len() - 1]);
            let is_too_short = matches!(shorter, Err(MessageError::TooShort { .. }));
            prop_assert!(is_too_short);
        }

        #[test]
        fn arbitrary_bytes_cause_no_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), plain: bool) {
            let mut bytes = bytes;
            if plain && bytes.len() > 4 {
                bytes[..4].copy_from_slice(&[0, 1, 0, 0]);
            }
            let marker = full_definition("visualization_msgs/Marker");
            let marker = Schema::parse("visualization_msgs/msg/Marker", marker.as_bytes()).unwrap();
            let _ = (decode(&schema(), &bytes), decode(&marker, &bytes));
        }
    }

    #[test]
    fn a_false_count_costs_no_memory() {
        let text = "Part[] parts\n===\nMSG: a/Part\nuint8 id\n";
        let schema = Schema::parse("a/Many", text.as_bytes()).unwrap();
        let message = [0, 1, 0, 0, 0xff, 0xff, 0xff, 0xff, 7];
        let refused = decode(&schema, &message).unwrap_err();
        let shown = "byte 9: 1 more bytes are needed, but 0 are left";
        assert_eq!(refused.to_string(), shown);
    }

    #[test]
    fn other_encodings_than_plain_cdr_are_refused() {
        let refused = decode(&schema(), &[0, 3, 0, 0]).unwrap_err();
        assert_eq!(refused, MessageError::Encapsulation(3));
        assert!(decode(&schema(), &[0]).is_err());
    }

    #[test]
    fn the_depth_of_messages_is_limited() {
        let mut text = "M0 m\n".to_owned();
        for level in 0..MAX_DEPTH + 1 {
            text += &format!("===\nMSG: a/M{level}\nM{} m\n", level + 1);
        }
        text += &format!("===\nMSG: a/M{}\nuint8 x\n", MAX_DEPTH + 1);
        let schema = Schema::parse("a/Deep", text.as_bytes()).unwrap();
        let refused = decode(&schema, &[0, 1, 0, 0, 1]).unwrap_err();
        assert_eq!(refused, MessageError::TooDeep);
    }
}
