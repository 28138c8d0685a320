//! Recognition of Arrow files and streams by their first bytes; builds without Arrow use it to name the format.

/// First and last bytes of a file.
pub(super) const MAGIC: &[u8] = b"ARROW1";

/// First bytes of a file of Feather version 1, which is another format.
pub(super) const FEATHER_1: &[u8] = b"FEA1";

/// First bytes of each message in a stream.
pub(super) const CONTINUATION: [u8; 4] = [0xff; 4];

/// Whether a table is in Arrow's format.
pub(super) fn is_arrow(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || bytes.starts_with(FEATHER_1) || bytes.starts_with(&CONTINUATION)
}
