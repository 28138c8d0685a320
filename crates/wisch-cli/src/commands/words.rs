//! Numbers as people read them.

use crate::failure::Failure;

/// A count with its noun, which takes an s.
pub fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

/// A share of 1 in percent.
pub fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// A record as text for a file.
pub(super) fn json(record: &impl serde::Serialize) -> Result<String, Failure> {
    let mut text = serde_json::to_string_pretty(record).map_err(internal)?;
    text.push('\n');
    Ok(text)
}

/// A failure that no input should bring about.
pub(super) fn internal(error: impl std::fmt::Display) -> Failure {
    Failure::new(format!("internal error: {error}"))
        .with_help("this is a fault of wisch, not of your files; please report it")
}
