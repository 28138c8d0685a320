//! Words of a shell, for the commands that messages and pages suggest.

/// Writes a text as one word of a POSIX shell: in single quotes, if it has other characters than those of plain file names.
///
/// ```
/// use wisch_io::shell_word;
/// assert_eq!(shell_word("a/b-1.toml"), "a/b-1.toml");
/// assert_eq!(shell_word("it's mine.toml"), r"'it'\''s mine.toml'");
/// ```
pub fn shell_word(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-./+:@%,=".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}
