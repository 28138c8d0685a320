//! Reads a text as one nested list of words, within limits that hold for any text.

use super::GoalError;
use crate::represent::{Place, UnknownName};

/// Length of the longest text [bytes].
pub(super) const MAX_TEXT_LEN: usize = 1 << 20;
/// Deepest nesting of parentheses; PDDL domains rarely go beyond 10.
pub(super) const MAX_DEPTH: usize = 64;
/// Length of the longest word [bytes].
pub(super) const MAX_WORD_LEN: usize = 128;

/// A text with its name in errors.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) name: &'a str,
    pub(super) text: &'a str,
}

impl Source<'_> {
    pub(super) fn place(self, offset: usize) -> Place {
        Place::from_offset(self.name, self.text, offset)
    }

    pub(super) fn expected(self, expected: &str, form: &Form) -> GoalError {
        self.expected_at(form.at, expected, &form.to_string())
    }

    pub(super) fn expected_at(self, at: usize, expected: &str, found: &str) -> GoalError {
        self.fault(at, format!("expected {expected}, found {found}"))
    }

    pub(super) fn not_supported(self, at: usize, construct: &str) -> GoalError {
        let what = "is not supported; expected typed STRIPS with negation";
        self.fault(at, format!("{construct} {what}"))
    }

    pub(super) fn unknown<'n>(
        self,
        at: usize,
        kind: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'n str>,
    ) -> GoalError {
        self.fault(at, UnknownName::new(kind, name, known).to_string())
    }

    pub(super) fn fault(self, at: usize, fault: String) -> GoalError {
        GoalError::Text {
            at: self.place(at),
            fault,
        }
    }

    pub(super) fn check_size(
        self,
        what: &str,
        value: usize,
        limit: usize,
    ) -> Result<(), GoalError> {
        if value <= limit {
            return Ok(());
        }
        Err(GoalError::TooLarge {
            text: self.name.to_owned(),
            what: what.to_owned(),
            value,
            limit,
        })
    }
}

/// A word or a list, with the offset of its first byte in the text.
#[derive(Debug, Clone)]
pub(super) struct Form {
    pub(super) at: usize,
    pub(super) content: Content,
}

#[derive(Debug, Clone)]
pub(super) enum Content {
    /// A word, in lower case as PDDL ignores case.
    Word(String),
    List(Vec<Form>),
}

impl Form {
    pub(super) fn word(&self) -> Option<&str> {
        match &self.content {
            Content::Word(word) => Some(word),
            Content::List(_) => None,
        }
    }

    pub(super) fn list(&self) -> Option<&[Form]> {
        match &self.content {
            Content::Word(_) => None,
            Content::List(forms) => Some(forms),
        }
    }

    /// Returns the word if it is a valid name.
    pub(super) fn name(&self) -> Option<&str> {
        self.word().filter(|word| is_name(word))
    }

    /// Returns the first word of a list, and the remainder of the list.
    pub(super) fn head(&self) -> Option<(&str, &[Form])> {
        let (first, rest) = self.list()?.split_first()?;
        Some((first.word()?, rest))
    }
}

/// In short: a word as it is, a list by its first word.
impl std::fmt::Display for Form {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (&self.content, self.head()) {
            (Content::Word(word), _) => write!(f, "`{word}`"),
            (Content::List(forms), _) if forms.is_empty() => f.write_str("`()`"),
            (Content::List(_), Some((head, _))) => write!(f, "`({head} ...)`"),
            (Content::List(_), None) => f.write_str("`((...) ...)`"),
        }
    }
}

/// Whether a word is a letter followed by letters, digits, `_` and `-`.
pub(super) fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word
            .bytes()
            .all(|c| c.is_ascii_alphanumeric() || b"_-".contains(&c))
}

/// Reads the single list of a text.
pub(super) fn read(source: Source<'_>) -> Result<Form, GoalError> {
    source.check_size("length in bytes", source.text.len(), MAX_TEXT_LEN)?;
    let text = source.text;
    let mut open: Vec<(usize, Vec<Form>)> = Vec::new();
    let mut whole = None;
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let end = at + c.len_utf8();
        if c.is_ascii_whitespace() {
            at = end;
            continue;
        }
        if c == ';' {
            at = text[at..]
                .find('\n')
                .map_or(text.len(), |length| at + length);
            continue;
        }
        if whole.is_some() {
            let found = format!("`{c}`");
            return Err(source.expected_at(at, "the end of the text", &found));
        }
        let form = match c {
            '(' => {
                source.check_size("nesting of parentheses", open.len() + 1, MAX_DEPTH)?;
                open.push((at, Vec::new()));
                at = end;
                continue;
            }
            ')' => {
                let Some((start, forms)) = open.pop() else {
                    return Err(source.expected_at(at, "`(`", "`)`"));
                };
                at = end;
                Form {
                    at: start,
                    content: Content::List(forms),
                }
            }
            _ => {
                let length = text[at..].find(|c| !is_word_character(c));
                let end = length.map_or(text.len(), |length| at + length);
                let word = &text[at..end];
                if word.is_empty() {
                    let found = format!("{c:?}");
                    return Err(source.expected_at(at, "a word or a parenthesis", &found));
                }
                source.check_size("length of a word in bytes", word.len(), MAX_WORD_LEN)?;
                let form = Form {
                    at,
                    content: Content::Word(word.to_ascii_lowercase()),
                };
                at = end;
                form
            }
        };
        match open.last_mut() {
            Some((_, forms)) => forms.push(form),
            None if form.list().is_some() => whole = Some(form),
            None => return Err(source.expected("`(`", &form)),
        }
    }
    if let Some(&(start, _)) = open.last() {
        let expected = "`)` for this parenthesis";
        return Err(source.expected_at(start, expected, "the end of the text"));
    }
    whole.ok_or_else(|| source.expected_at(text.len(), "`(`", "the end of the text"))
}

fn is_word_character(c: char) -> bool {
    c.is_ascii_alphanumeric() || "_-?:=<>+*/.#!".contains(c)
}
