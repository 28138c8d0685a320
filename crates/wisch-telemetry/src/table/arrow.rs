//! Recognises Arrow files and streams by their first bytes; builds that do not read them name the format.

/// What a file begins and ends with.
pub(super) const MAGIC: &[u8] = b"ARROW1";

/// What a file of Feather's first version begins with, which is another format.
pub(super) const FEATHER_1: &[u8] = b"FEA1";

/// What each message of a stream begins with.
pub(super) const CONTINUATION: [u8; 4] = [0xff; 4];

/// Whether a table is one of Arrow's.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || bytes.starts_with(FEATHER_1) || bytes.starts_with(&CONTINUATION)
}
