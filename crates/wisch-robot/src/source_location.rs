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
    /// let place = Place::from_offset("tools.toml", "schema = 1\nname = 3\n", 18);
    /// assert_eq!(place.to_string(), "tools.toml:2:8");
    /// ```
    pub fn from_offset(file: &str, text: &str, offset: usize) -> Self {
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
/// use wisch_robot::source_location::escape_controls;
/// assert_eq!(escape_controls("a cup\n"), "a cup\n");
/// assert_eq!(escape_controls("\u{1b}[2Jcup"), "\\u001b[2Jcup");
/// ```
pub fn escape_controls(text: &str) -> Cow<'_, str> {
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

/// An unknown name, with the known ones.
///
/// The message suggests the nearest known name only if the two are alike: `fx` does not suggest `qx`.
///
/// ```
/// use wisch_robot::source_location::UnknownName;
/// let unknown = UnknownName::new("tool", "spunge", ["sponge", "brush"]);
/// assert_eq!(
///     unknown.to_string(),
///     r#"unknown tool "spunge"; nearest: sponge; known: sponge, brush"#
/// );
/// let unknown = UnknownName::new("column", "fx", ["qx", "qy"]);
/// assert_eq!(unknown.to_string(), r#"unknown column "fx"; known: qx, qy"#);
/// ```
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
/// Length over edit distance from which on two names are alike [1].
const LENGTH_PER_EDIT: usize = 3;
/// Shortest name that is alike to a longer one that contains it [characters].
const MIN_CONTAINED: usize = 3;

impl UnknownName {
    /// Sorts the known names by their edit distance to the given one (with swaps of neighbours), then alphabetically.
    pub fn new<'a>(
        kind: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let mut known: Vec<(usize, &str)> = known
            .into_iter()
            .map(|candidate| (strsim::osa_distance(name, candidate), candidate))
            .collect();
        known.sort_unstable();
        Self {
            kind,
            name: name.to_owned(),
            known: known.into_iter().map(|(_, name)| name.to_owned()).collect(),
        }
    }

    /// The known name nearest to the given one; `None` if no known name is like it.
    ///
    /// Two names are alike if at most a third of the longer one differs, or if one contains the other.
    pub fn nearest(&self) -> Option<&str> {
        let nearest = self.known.first()?;
        are_alike(&self.name, nearest).then_some(nearest)
    }

    fn known_names(&self) -> String {
        if self.known.is_empty() {
            return format!("; no {} is known", self.kind);
        }
        let nearest = self.nearest();
        let mut message =
            nearest.map_or_else(String::new, |nearest| format!("; nearest: {nearest}"));
        if self.known.len() > 1 || nearest.is_none() {
            message += "; known: ";
            message += &self.known[..self.known.len().min(NAMES_SHOWN)].join(", ");
        }
        if self.known.len() > NAMES_SHOWN {
            message += &format!(" and {} more", self.known.len() - NAMES_SHOWN);
        }
        message
    }
}

/// Whether one of two names is probably meant by the other.
fn are_alike(a: &str, b: &str) -> bool {
    let [shorter, longer] = match [a.chars().count(), b.chars().count()] {
        [of_a, of_b] if of_a <= of_b => [of_a, of_b],
        [of_a, of_b] => [of_b, of_a],
    };
    let contains = shorter >= MIN_CONTAINED && (a.contains(b) || b.contains(a));
    contains || LENGTH_PER_EDIT * strsim::osa_distance(a, b) <= longer
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_like_name_is_suggested() {
        for (name, known, nearest) in [
            ("tabel", "table", Some("table")),
            ("positon_m", "position_m", Some("position_m")),
            ("broomstick", "broom", Some("broom")),
            ("tpc", "tcp", Some("tcp")),
            ("fx", "qx", None),
            ("fx", "x", None),
            ("manipulator", "arm", None),
        ] {
            let unknown = UnknownName::new("name", name, [known]);
            assert_eq!(unknown.nearest(), nearest, "{name}");
        }
    }
}
