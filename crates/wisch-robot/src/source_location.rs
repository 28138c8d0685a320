//! Where a text says something, and what to answer when it names something unknown.

use std::borrow::Cow;
use std::fmt;

/// A place in a text that was handed in, printed as `file:line:column`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The name under which the text was handed in.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

impl Place {
    /// The place of the byte at `offset`; beyond the end of the text it is the end.
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

/// A text with its control characters, and those that turn the direction of writing, as `\u` and four hexadecimal digits, but for
/// line breaks and tabs: what a stranger's file holds moves no cursor and hides nothing. JSON stays the same value.
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

/// A name that nothing known bears, with the nearest that is known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} {name:?}{}", self.known_names())]
pub struct UnknownName {
    /// What the name should have named, such as "tool".
    pub kind: &'static str,
    /// The name as given.
    pub name: String,
    /// Every known name of that kind, nearest first.
    pub known: Vec<String>,
}

/// How many known names a message lists.
const NAMES_SHOWN: usize = 12;

impl UnknownName {
    /// Ranks the known names by their edit distance to the given one, ties by alphabet.
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

    /// The known name nearest to the one given; `None` if nothing of the kind is known.
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
