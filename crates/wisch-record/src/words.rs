//! Numbers and records as text.

use crate::error::{RecordError, internal};

/// Formats a share [1] in percent.
pub(crate) fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// Formats a record as indented JSON for a file.
pub(crate) fn json(record: &impl serde::Serialize) -> Result<String, RecordError> {
    let mut text = serde_json::to_string_pretty(record).map_err(internal)?;
    text.push('\n');
    Ok(text)
}
