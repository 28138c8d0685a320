//! Limits within which XML is parsed, and text of its attributes.

use roxmltree::ParsingOptions;
use std::fmt::Write;

/// Length of the longest text \[bytes\].
pub const MAX_URDF_BYTES: usize = 8 << 20;
/// Largest number of nodes (elements, texts, comments) of the XML; it limits the memory that a
/// small file can demand.
const MAX_NODES: u32 = 500_000;

/// Returns the limits within which XML is parsed.
pub(super) fn parsing_options<'a>() -> ParsingOptions<'a> {
    ParsingOptions {
        nodes_limit: MAX_NODES,
        ..ParsingOptions::default()
    }
}

/// Returns a text as the value of an attribute in double quotes.
pub(super) fn escape(value: &str) -> String {
    let mut escaped = String::with_capacity(value.len());
    for c in value.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\n' | '\r' | '\t' => {
                let _ = write!(escaped, "&#{};", u32::from(c));
            }
            _ => escaped.push(c),
        }
    }
    escaped
}
