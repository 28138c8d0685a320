//! Dumps of MongoDB: a sequence of BSON documents.

use bson::RawDocumentBuf;
use std::io::{self, Read};

/// Largest document [bytes]: the limit of MongoDB.
pub(super) const MAX_DOCUMENT: usize = 16 << 20;

/// A fault of a document in a database dump.
#[derive(Debug, thiserror::Error)]
pub enum DumpError {
    /// The file cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The document is not BSON, or ends too early.
    #[error("document {number}: {error}")]
    Malformed {
        /// Index of the document, from 0.
        number: u64,
        /// Error of the BSON parser.
        error: bson::error::Error,
    },
    /// The document is longer than the limit.
    #[error("document {number}: {bytes} bytes exceed the limit of {MAX_DOCUMENT}")]
    Long {
        /// Index of the document, from 0.
        number: u64,
        /// The length that it states [bytes].
        bytes: i64,
    },
}

/// Iterator over the documents of a dump, up to the first that cannot be read. Contents of a document are checked only
/// where they are used.
#[derive(Debug)]
pub(super) struct Documents<R> {
    from: R,
    number: u64,
    failed: bool,
}

impl<R: Read> Documents<R> {
    /// Returns an iterator over the documents in `from`.
    pub fn new(from: R) -> Self {
        Self {
            from,
            number: 0,
            failed: false,
        }
    }

    fn read(&mut self) -> Result<Option<RawDocumentBuf>, DumpError> {
        let number = self.number;
        let mut bytes = Vec::new();
        self.from.by_ref().take(4).read_to_end(&mut bytes)?;
        if bytes.is_empty() {
            return Ok(None);
        }
        if let Ok(length) = <[u8; 4]>::try_from(bytes.as_slice()) {
            let length = i32::from_le_bytes(length);
            let whole = usize::try_from(length).unwrap_or(usize::MAX);
            if whole > MAX_DOCUMENT {
                let bytes = length.into();
                return Err(DumpError::Long { number, bytes });
            }
            // Not reserved beforehand, because the stated length may be wrong.
            let rest = whole.saturating_sub(4) as u64;
            self.from.by_ref().take(rest).read_to_end(&mut bytes)?;
        }
        let document = RawDocumentBuf::from_bytes(bytes);
        let document = document.map_err(|error| DumpError::Malformed { number, error })?;
        Ok(Some(document))
    }
}

impl<R: Read> Iterator for Documents<R> {
    type Item = Result<RawDocumentBuf, DumpError>;

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

#[cfg(test)]
mod tests {
    use super::super::document::triple;
    use super::*;
    use bson::rawdoc;
    use proptest::prelude::*;

    fn read(bytes: &[u8]) -> Result<Vec<RawDocumentBuf>, DumpError> {
        Documents::new(bytes).collect()
    }

    fn documents() -> impl Strategy<Value = Vec<RawDocumentBuf>> {
        let document = (".{0,8}", any::<f64>(), any::<i64>()).prop_map(|(text, since, until)| {
            rawdoc! {
                "s": text,
                "p": "p",
                "o": until,
                "p*": ["p"],
                "scope": { "time": { "since": since, "until": until } },
            }
        });
        prop::collection::vec(document, 0..4)
    }

    fn bytes_of(documents: &[RawDocumentBuf]) -> Vec<u8> {
        let bytes = documents.iter().flat_map(|document| document.as_bytes());
        bytes.copied().collect()
    }

    proptest! {
        #[test]
        fn written_documents_are_read_back(documents in documents()) {
            prop_assert_eq!(read(&bytes_of(&documents)).unwrap(), documents);
        }

        #[test]
        fn a_cut_file_is_an_error(documents in documents(), cut in 1_usize..8) {
            let bytes = bytes_of(&documents);
            if !bytes.is_empty() {
                prop_assert!(read(&bytes[..bytes.len() - cut]).is_err());
            }
        }

        #[test]
        fn arbitrary_bytes_cause_no_panic(mut bytes in prop::collection::vec(any::<u8>(), 0..64), length in 0_u8..64) {
            if let Some(first) = bytes.first_mut() {
                *first = length;
            }
            for document in read(&bytes).unwrap_or_default() {
                let _ = triple(&document);
            }
        }

        #[test]
        fn a_flipped_byte_causes_no_panic(documents in documents(), at: prop::sample::Index, to: u8) {
            let mut bytes = bytes_of(&documents);
            if !bytes.is_empty() {
                let at = at.index(bytes.len());
                bytes[at] = to;
                for document in read(&bytes).unwrap_or_default() {
                    let _ = triple(&document);
                }
            }
        }
    }

    #[test]
    fn a_false_length_is_an_error() {
        let long = i32::MAX.to_le_bytes();
        assert!(matches!(read(&long), Err(DumpError::Long { .. })));
        let mut bytes = rawdoc! { "a": "b" }.into_bytes();
        bytes[0] += 1;
        assert!(matches!(read(&bytes), Err(DumpError::Malformed { .. })));
    }

    #[test]
    fn deeply_nested_documents_are_read_lazily() {
        let mut nested = rawdoc! { "time": "" };
        for _ in 0..10_000 {
            nested = rawdoc! { "scope": nested };
        }
        let read = read(nested.as_bytes()).unwrap();
        assert!(triple(&read[0]).is_err());
    }
}
