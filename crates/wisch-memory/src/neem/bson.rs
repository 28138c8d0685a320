//! As much of BSON as a memory needs: documents of texts, numbers, dates and documents, written and read one by
//! one.

use std::io::{self, Read, Write};

/// Longest document that is read [byte]: the limit of MongoDB.
const MAX_DOCUMENT: usize = 16 << 20;

/// Deepest nesting that is read.
const MAX_DEPTH: usize = 32;

/// A value of a document.
#[derive(Debug, Clone, PartialEq)]
pub enum Bson {
    /// A number.
    Double(f64),
    /// A text.
    Text(String),
    /// A document in a document.
    Document(Document),
    /// A list.
    Array(Vec<Bson>),
    /// A document's name.
    ObjectId([u8; 12]),
    /// Yes or no.
    Bool(bool),
    /// A time [ms since 1970].
    Date(i64),
    /// Nothing.
    Null,
    /// A whole number.
    Int(i64),
}

/// Fields with their values, in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document(pub Vec<(String, Bson)>);

/// What is wrong with a document.
#[derive(Debug, thiserror::Error)]
pub enum BsonError {
    /// It cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// It ends too early or lengths contradict each other.
    #[error("document {number}: byte {offset} is none of {what}")]
    Malformed {
        /// Which document, from 0.
        number: u64,
        /// Where in it.
        offset: usize,
        /// What was expected there.
        what: &'static str,
    },
    /// It is longer than the limit.
    #[error("document {number}: {bytes} bytes are beyond the limit of {MAX_DOCUMENT}")]
    Long {
        /// Which document, from 0.
        number: u64,
        /// How long it says it is.
        bytes: i64,
    },
}

impl Document {
    /// The document with one more field.
    pub fn with(mut self, field: &str, value: impl Into<Bson>) -> Self {
        self.0.push((field.to_owned(), value.into()));
        self
    }

    /// The value of the first field of this name.
    pub fn get(&self, field: &str) -> Option<&Bson> {
        self.0
            .iter()
            .find(|(name, _)| name == field)
            .map(|(_, value)| value)
    }

    /// The text of a field, if it is one.
    pub fn text(&self, field: &str) -> Option<&str> {
        match self.get(field) {
            Some(Bson::Text(text)) => Some(text),
            _ => None,
        }
    }

    /// The number of a field, if it is one.
    pub fn number(&self, field: &str) -> Option<f64> {
        match self.get(field) {
            Some(Bson::Double(number)) => Some(*number),
            Some(Bson::Int(number)) => Some(*number as f64),
            _ => None,
        }
    }

    /// The document in a field, if it is one.
    pub fn document(&self, field: &str) -> Option<&Self> {
        match self.get(field) {
            Some(Bson::Document(document)) => Some(document),
            _ => None,
        }
    }

    /// Its bytes.
    ///
    /// # Errors
    /// A field's name has a zero byte, or it is beyond the limit of 16 MiB.
    pub fn to_bytes(&self) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        write_document(&mut bytes, self.0.iter().map(|(name, value)| (name, value)))?;
        if bytes.len() > MAX_DOCUMENT {
            let message = format!("a document of {} bytes is too long", bytes.len());
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        Ok(bytes)
    }

    /// Writes it.
    ///
    /// # Errors
    /// As [`Self::to_bytes`], and if writing fails.
    pub fn write(&self, to: &mut impl Write) -> io::Result<()> {
        to.write_all(&self.to_bytes()?)
    }
}

impl From<f64> for Bson {
    fn from(number: f64) -> Self {
        Self::Double(number)
    }
}

impl From<&str> for Bson {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Bson {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<Document> for Bson {
    fn from(document: Document) -> Self {
        Self::Document(document)
    }
}

impl From<Vec<Bson>> for Bson {
    fn from(values: Vec<Bson>) -> Self {
        Self::Array(values)
    }
}

fn write_document<'a, N: AsRef<str>>(
    bytes: &mut Vec<u8>,
    fields: impl Iterator<Item = (N, &'a Bson)>,
) -> io::Result<()> {
    let start = bytes.len();
    bytes.extend([0; 4]);
    for (name, value) in fields {
        bytes.push(tag(value));
        let name = name.as_ref();
        if name.contains('\0') {
            let message = format!("the field {name:?} has a zero byte");
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        bytes.extend(name.as_bytes());
        bytes.push(0);
        write_value(bytes, value)?;
    }
    bytes.push(0);
    let length = i32::try_from(bytes.len() - start).map_err(io::Error::other)?;
    bytes[start..start + 4].copy_from_slice(&length.to_le_bytes());
    Ok(())
}

fn tag(value: &Bson) -> u8 {
    match value {
        Bson::Double(_) => 0x01,
        Bson::Text(_) => 0x02,
        Bson::Document(_) => 0x03,
        Bson::Array(_) => 0x04,
        Bson::ObjectId(_) => 0x07,
        Bson::Bool(_) => 0x08,
        Bson::Date(_) => 0x09,
        Bson::Null => 0x0a,
        Bson::Int(_) => 0x12,
    }
}

fn write_value(bytes: &mut Vec<u8>, value: &Bson) -> io::Result<()> {
    match value {
        Bson::Double(number) => bytes.extend(number.to_le_bytes()),
        Bson::Text(text) => {
            let length = i32::try_from(text.len() + 1).map_err(io::Error::other)?;
            bytes.extend(length.to_le_bytes());
            bytes.extend(text.as_bytes());
            bytes.push(0);
        }
        Bson::Document(document) => {
            write_document(bytes, document.0.iter().map(|(name, value)| (name, value)))?;
        }
        Bson::Array(values) => {
            let numbered = values.iter().enumerate();
            write_document(
                bytes,
                numbered.map(|(number, value)| (number.to_string(), value)),
            )?;
        }
        Bson::ObjectId(id) => bytes.extend(id),
        Bson::Bool(yes) => bytes.push(u8::from(*yes)),
        Bson::Date(number) | Bson::Int(number) => bytes.extend(number.to_le_bytes()),
        Bson::Null => {}
    }
    Ok(())
}

/// The documents of a file, one by one.
#[derive(Debug)]
pub struct Documents<R> {
    from: R,
    number: u64,
    failed: bool,
}

impl<R: Read> Documents<R> {
    /// The documents that come from here.
    pub fn new(from: R) -> Self {
        Self {
            from,
            number: 0,
            failed: false,
        }
    }

    fn read(&mut self) -> Result<Option<Document>, BsonError> {
        let number = self.number;
        let malformed = |offset, what| BsonError::Malformed {
            number,
            offset,
            what,
        };
        let mut head = Vec::new();
        self.from.by_ref().take(4).read_to_end(&mut head)?;
        if head.is_empty() {
            return Ok(None);
        }
        let length: [u8; 4] = head
            .try_into()
            .map_err(|_| malformed(0, "the bytes of a length"))?;
        let length = i32::from_le_bytes(length);
        let whole = usize::try_from(length).unwrap_or(usize::MAX);
        if whole > MAX_DOCUMENT {
            return Err(BsonError::Long {
                number,
                bytes: length.into(),
            });
        }
        let mut bytes = length.to_le_bytes().to_vec();
        let rest = whole.saturating_sub(4);
        // Not reserved beforehand: the length may be a lie.
        self.from
            .by_ref()
            .take(rest as u64)
            .read_to_end(&mut bytes)?;
        let mut cursor = Cursor {
            bytes: &bytes,
            at: 0,
        };
        let document = cursor.document(0);
        match document {
            Ok(document) if cursor.at == bytes.len() && whole == bytes.len() => Ok(Some(document)),
            Ok(_) => Err(malformed(cursor.at, "the end")),
            Err(what) => Err(malformed(cursor.at, what)),
        }
    }
}

impl<R: Read> Iterator for Documents<R> {
    type Item = Result<Document, BsonError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        let document = self.read().transpose();
        self.failed = matches!(document, Some(Err(_)));
        self.number += 1;
        document
    }
}

/// A place in the bytes of a document. Errors say what was expected there.
struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], &'static str> {
        let end = self.at.checked_add(count);
        let taken = end.and_then(|end| self.bytes.get(self.at..end));
        let taken = taken.ok_or("the bytes of a value")?;
        self.at += count;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], &'static str> {
        let taken = self.take(N)?;
        taken.try_into().map_err(|_| "the bytes of a value")
    }

    fn length(&mut self) -> Result<usize, &'static str> {
        let length = i32::from_le_bytes(self.array()?);
        usize::try_from(length).map_err(|_| "a length")
    }

    fn name(&mut self) -> Result<&'a str, &'static str> {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&byte| byte == 0);
        let end = end.ok_or("a name")?;
        let name = std::str::from_utf8(&rest[..end]).map_err(|_| "a name in UTF-8")?;
        self.at += end + 1;
        Ok(name)
    }

    fn document(&mut self, depth: usize) -> Result<Document, &'static str> {
        if depth > MAX_DEPTH {
            return Err("the nestings that are read");
        }
        let start = self.at;
        let end = start + self.length()?;
        let mut fields = Vec::new();
        loop {
            let [tag] = self.array()?;
            if tag == 0 {
                break;
            }
            let name = self.name()?.to_owned();
            fields.push((name, self.value(tag, depth)?));
        }
        if self.at != end {
            return Err("the end of a document");
        }
        Ok(Document(fields))
    }

    fn value(&mut self, tag: u8, depth: usize) -> Result<Bson, &'static str> {
        Ok(match tag {
            0x01 => Bson::Double(f64::from_le_bytes(self.array()?)),
            0x02 => {
                let length = self.length()?;
                let Some((0, text)) = self.take(length)?.split_last() else {
                    return Err("the end of a text");
                };
                let text = std::str::from_utf8(text).map_err(|_| "a text in UTF-8")?;
                Bson::Text(text.to_owned())
            }
            0x03 => Bson::Document(self.document(depth + 1)?),
            0x04 => {
                let fields = self.document(depth + 1)?.0;
                Bson::Array(fields.into_iter().map(|(_, value)| value).collect())
            }
            0x07 => Bson::ObjectId(self.array()?),
            0x08 => Bson::Bool(self.array::<1>()? != [0]),
            0x09 => Bson::Date(i64::from_le_bytes(self.array()?)),
            0x0a => Bson::Null,
            0x10 => Bson::Int(i32::from_le_bytes(self.array()?).into()),
            0x12 => Bson::Int(i64::from_le_bytes(self.array()?)),
            _ => return Err("the types that are read"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(bytes: &[u8]) -> Result<Vec<Document>, BsonError> {
        Documents::new(bytes).collect()
    }

    /// The example of the specification: `{"hello": "world"}`.
    #[test]
    fn bytes_are_as_specified() {
        let document = Document::default().with("hello", "world");
        let bytes = b"\x16\0\0\0\x02hello\0\x06\0\0\0world\0\0";
        assert_eq!(document.to_bytes().unwrap(), bytes);
        assert_eq!(read(bytes).unwrap(), [document]);
    }

    fn values() -> impl Strategy<Value = Bson> {
        let leaf = prop_oneof![
            any::<f64>()
                .prop_filter("comparable", |x| !x.is_nan())
                .prop_map(Bson::Double),
            ".{0,8}".prop_map(Bson::Text),
            any::<[u8; 12]>().prop_map(Bson::ObjectId),
            any::<bool>().prop_map(Bson::Bool),
            any::<i64>().prop_map(Bson::Date),
            any::<i64>().prop_map(Bson::Int),
            Just(Bson::Null),
        ];
        leaf.prop_recursive(4, 24, 4, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..4).prop_map(Bson::Array),
                prop::collection::vec(("[a-z*]{0,4}", inner), 0..4)
                    .prop_map(|fields| Bson::Document(Document(fields))),
            ]
        })
    }

    fn documents() -> impl Strategy<Value = Vec<Document>> {
        let document = prop::collection::vec(("[a-z*]{0,4}", values()), 0..4).prop_map(Document);
        prop::collection::vec(document, 0..4)
    }

    fn bytes_of(documents: &[Document]) -> Vec<u8> {
        let mut bytes = Vec::new();
        for document in documents {
            document.write(&mut bytes).unwrap();
        }
        bytes
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(documents in documents()) {
            prop_assert_eq!(read(&bytes_of(&documents)).unwrap(), documents);
        }

        #[test]
        fn a_cut_file_is_an_error_not_a_shorter_one(documents in documents(), cut in 1_usize..8) {
            let bytes = bytes_of(&documents);
            // Every document has at least five bytes, so a cut of up to four is in the last one.
            if cut < 5 && !bytes.is_empty() {
                prop_assert!(read(&bytes[..bytes.len() - cut]).is_err());
            }
        }

        #[test]
        fn no_bytes_make_it_panic(mut bytes in prop::collection::vec(any::<u8>(), 0..64), length in 0_u8..64) {
            if let Some(first) = bytes.first_mut() {
                *first = length;
            }
            let _ = read(&bytes);
        }

        #[test]
        fn a_flipped_byte_does_not_make_it_panic(documents in documents(), at: prop::sample::Index, to: u8) {
            let mut bytes = bytes_of(&documents);
            if !bytes.is_empty() {
                let at = at.index(bytes.len());
                bytes[at] = to;
                let _ = read(&bytes);
            }
        }
    }

    #[test]
    fn a_lie_about_the_length_is_found() {
        let long = i32::MAX.to_le_bytes();
        assert!(matches!(read(&long), Err(BsonError::Long { .. })));
        let mut bytes = Document::default().with("a", "b").to_bytes().unwrap();
        bytes[0] += 1;
        assert!(matches!(read(&bytes), Err(BsonError::Malformed { .. })));
    }

    #[test]
    fn nesting_ends_somewhere() {
        let mut nested = Document::default();
        for _ in 0..100 {
            nested = Document::default().with("a", nested);
        }
        let read = read(&nested.to_bytes().unwrap()).unwrap_err();
        assert!(read.to_string().contains("nestings"), "{read}");
    }
}
