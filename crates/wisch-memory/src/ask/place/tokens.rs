//! Tokens of a Prolog query.

/// A token of a query, with its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    pub kind: TokenKind,
    /// Begin and end [bytes].
    pub start: usize,
    pub end: usize,
}

/// Kind of a token, as Prolog distinguishes them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TokenKind {
    /// An atom of letters or in quotes.
    Name,
    Variable,
    Number,
    /// A text in double or back quotes.
    Text,
    /// An atom of symbol characters.
    Symbol,
    Comma,
    Bar,
    /// An opening bracket right after a name.
    Call,
    /// Any other opening bracket.
    Open,
    Close,
    /// The full stop.
    Stop,
    /// Unterminated quotes.
    Unfinished,
}

impl Token {
    /// Returns its value: an atom without quotes.
    pub fn value<'a>(&self, query: &'a str) -> std::borrow::Cow<'a, str> {
        let text = &query[self.start..self.end];
        match text
            .strip_prefix('\'')
            .and_then(|rest| rest.strip_suffix('\''))
        {
            Some(inner) => inner.replace("\\'", "'").replace("''", "'").into(),
            None => text.into(),
        }
    }
}

/// Whether a word is an operator.
pub fn is_word_operator(text: &str) -> bool {
    matches!(
        text,
        "is" | "mod" | "rem" | "div" | "rdiv" | "xor" | "during" | "since" | "until"
    )
}

/// Returns all tokens of a query, without its comments.
pub fn tokens(query: &str) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(c) = query[at..].chars().next() {
        let rest = &query[at..];
        let (kind, len) = match c {
            '%' => (None, rest.find('\n').unwrap_or(rest.len())),
            '/' if rest.starts_with("/*") => {
                (None, rest.find("*/").map_or(rest.len(), |end| end + 2))
            }
            c if c.is_whitespace() => (None, c.len_utf8()),
            '\'' | '"' | '`' => read_quoted(rest, c),
            '0'..='9' => (Some(TokenKind::Number), number(rest)),
            c if c.is_alphabetic() || c == '_' => {
                let word = |c: char| c.is_alphanumeric() || c == '_';
                let kind = if c.is_uppercase() || c == '_' {
                    TokenKind::Variable
                } else {
                    TokenKind::Name
                };
                (Some(kind), rest.find(|c| !word(c)).unwrap_or(rest.len()))
            }
            ',' => (Some(TokenKind::Comma), 1),
            '|' if !rest.starts_with("||") => (Some(TokenKind::Bar), 1),
            '(' if follows_a_name(found.last(), at) => (Some(TokenKind::Call), 1),
            '(' | '[' | '{' => (Some(TokenKind::Open), 1),
            ')' | ']' | '}' => (Some(TokenKind::Close), 1),
            '!' => (Some(TokenKind::Name), 1),
            c if is_sign(c) => {
                let len = rest.find(|c| !is_sign(c)).unwrap_or(rest.len());
                let after = rest[len..].chars().next();
                let is_stop = &rest[..len] == "." && after.is_none_or(char::is_whitespace);
                (
                    Some(if is_stop {
                        TokenKind::Stop
                    } else {
                        TokenKind::Symbol
                    }),
                    len,
                )
            }
            c => (Some(TokenKind::Symbol), c.len_utf8()),
        };
        if let Some(kind) = kind {
            found.push(Token {
                kind,
                start: at,
                end: at + len,
            });
        }
        at += len;
    }
    found
}

fn follows_a_name(last: Option<&Token>, at: usize) -> bool {
    last.is_some_and(|token| {
        token.end == at
            && matches!(
                token.kind,
                TokenKind::Name | TokenKind::Symbol | TokenKind::Variable
            )
    })
}

/// Returns kind and length of the text that begins with this quote.
fn read_quoted(text: &str, mark: char) -> (Option<TokenKind>, usize) {
    let mut chars = text.char_indices().skip(1).peekable();
    while let Some((at, c)) = chars.next() {
        if c == '\\' {
            chars.next();
        } else if c == mark {
            if chars.next_if(|(_, next)| *next == mark).is_some() {
                continue;
            }
            let kind = if mark == '\'' {
                TokenKind::Name
            } else {
                TokenKind::Text
            };
            return (Some(kind), at + 1);
        }
    }
    (Some(TokenKind::Unfinished), text.trim_end().len())
}

fn number(text: &str) -> usize {
    if let Some(rest) = text.strip_prefix("0'") {
        let escaped = rest.starts_with('\\') || rest.starts_with("''");
        let chars = rest.chars().take(if escaped { 2 } else { 1 });
        return 2 + chars.map(char::len_utf8).sum::<usize>();
    }
    let word = |text: &str| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        text.find(|c| !is_part(c)).unwrap_or(text.len())
    };
    let mut len = word(text);
    let fraction = text[len..].strip_prefix('.');
    if fraction.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
        len += 1 + word(&text[len + 1..]);
    }
    let is_exponent = text[..len].ends_with(['e', 'E']);
    if is_exponent && text[len..].starts_with(['+', '-']) {
        len += 1 + word(&text[len + 1..]);
    }
    len
}

fn is_sign(c: char) -> bool {
    "+-*/\\^<>=~:.?@#&$;".contains(c)
}
