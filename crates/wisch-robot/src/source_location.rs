//! Places in texts, and errors about unknown names.

use std::borrow::Cow;
use std::fmt;

/// A place in a text, printed as `file:line:column`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Name of the text.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

impl Place {
    /// Returns the place of the byte at `offset`, or the end of the text if `offset` is beyond it.
    ///
    /// ```
    /// use wisch_robot::source_location::Place;
    /// let place = Place::at_offset("tools.toml", "schema = 1\nname = 3\n", 18);
    /// assert_eq!(place.to_string(), "tools.toml:2:8");
    /// ```
    pub fn at_offset(file: &str, text: &str, offset: usize) -> Self {
        let before = &text[..text.floor_char_boundary(offset)];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Self {
            file: file.to_owned(),
            line: 1 + before.matches('\n').count(),
            column: 1 + before[line_start..].chars().count(),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// Returns a text whose control characters, and those that change the writing direction, are written as `\u` and four
/// hexadecimal digits, except for line breaks and tabs. A file from a stranger can then neither move the cursor nor
/// hide text. JSON keeps its value.
///
/// ```
/// use wisch_robot::source_location::visible;
/// assert_eq!(visible("a cup\n"), "a cup\n");
/// assert_eq!(visible("\u{1b}[2Jcup"), "\\u001b[2Jcup");
/// ```
pub fn visible(text: &str) -> Cow<'_, str> {
    let is_plain = |c: char| {
        let turns = matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}');
        matches!(c, '\n' | '\t') || !(c.is_control() || turns)
    };
    if text.chars().all(is_plain) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_plain(c) {
            shown.push(c);
        } else {
            shown += &format!("\\u{:04x}", u32::from(c));
        }
    }
    Cow::Owned(shown)
}

/// An unknown name, with the nearest known ones.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} {name:?}{}", self.known_names())]
pub struct UnknownName {
    /// Kind of the named thing, such as "tool".
    pub kind: &'static str,
    /// The unknown name.
    pub name: String,
    /// Every known name of that kind, the nearest first.
    pub known: Vec<String>,
}

/// Number of known names that a message lists.
const NAMES_SHOWN: usize = 12;

impl UnknownName {
    /// Sorts the known names by their edit distance to the given one, then alphabetically.
    pub fn new<'a>(
        kind: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let mut known: Vec<(usize, &str)> = known
            .into_iter()
            .map(|candidate| (strsim::levenshtein(name, candidate), candidate))
            .collect();
        known.sort_unstable();
        Self {
            kind,
            name: name.to_owned(),
            known: known.into_iter().map(|(_, name)| name.to_owned()).collect(),
        }
    }

    /// The known name nearest to the given one; `None` if no name of the kind is known.
    pub fn nearest(&self) -> Option<&str> {
        self.known.first().map(String::as_str)
    }

    fn known_names(&self) -> String {
        let Some(nearest) = self.nearest() else {
            return format!("; no {} is known", self.kind);
        };
        let mut message = format!("; nearest: {nearest}");
        if self.known.len() > 1 {
            message += "; known: ";
            message += &self.known[..self.known.len().min(NAMES_SHOWN)].join(", ");
        }
        if self.known.len() > NAMES_SHOWN {
            message += &format!(" and {} more", self.known.len() - NAMES_SHOWN);
        }
        message
    }
}
