//! Numbers and records as text.

use crate::failure::Failure;

/// Formats a count with its noun; the plural takes an s.
pub fn counted(count: usize, noun: &str) -> String {
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

/// Writes a text as one word of a shell: in single quotes, if it has other characters than those of plain file names.
pub(super) fn shell_word(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-./+:@%,=".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::shell_word;

    #[test]
    fn names_with_spaces_are_quoted() {
        assert_eq!(shell_word("a/b-1.toml"), "a/b-1.toml");
        assert_eq!(shell_word("ü b.toml"), "'ü b.toml'");
        assert_eq!(shell_word("it's.toml"), "'it'\\''s.toml'");
    }
}
