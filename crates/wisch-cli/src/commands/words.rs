//! Numbers and records as text.

use crate::failure::Failure;

/// Formats a count with its noun; the plural takes an s.
pub fn format_count(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

/// Formats a share [1] in percent.
pub fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// Formats a record as indented JSON for a file.
pub(super) fn json(record: &impl serde::Serialize) -> Result<String, Failure> {
    let mut text = serde_json::to_string_pretty(record).map_err(internal)?;
    text.push('\n');
    Ok(text)
}

/// Makes a failure for an error that no input should cause.
pub(super) fn internal(error: impl std::fmt::Display) -> Failure {
    Failure::new(format!("internal error: {error}"))
        .with_help("this is an error in wisch, not in your files; please report it")
}
