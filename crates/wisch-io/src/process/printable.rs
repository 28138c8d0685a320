//! Text from other programs, made safe for terminals.

/// Escapes control characters, marks of the writing direction and invisible characters; tabs stay.
pub(super) fn printed(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        let is_unseen = matches!(
            c,
            '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}'
        );
        if c.is_control() && c != '\t' || is_unseen {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    shown
}

/// Cuts a text to at most `most` characters and escapes it.
pub(super) fn printable(text: &str, most: usize) -> String {
    let mut beginning: String = text.chars().take(most).collect();
    if beginning.len() < text.len() {
        beginning.push('…');
    }
    printed(&beginning)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_shown_and_do_nothing() {
        assert_eq!(
            printable("\u{feff}bad \u{1b}[31mthing\nµm \u{202e}x", 40),
            "\\u{feff}bad \\u{1b}[31mthing\\nµm \\u{202e}x"
        );
        assert_eq!(printable("abcdef", 3), "abc…");
    }
}
