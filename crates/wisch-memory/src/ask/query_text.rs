//! Preparation of a query's text: its end, and syntax that differs between engines.

use super::error::QueryFault;
use std::iter::Peekable;
use std::str::CharIndices;

/// Returns a query without comments and final full stop, with numbers in the syntax of every engine: `1e9` becomes
/// `1.0e9`.
///
/// # Errors
/// If text follows the full stop, or a number is too large.
pub fn prepare_query(query: &str) -> Result<String, QueryFault> {
    let mut reader = Reader {
        query,
        chars: query.char_indices().peekable(),
        out: String::with_capacity(query.len() + 8),
    };
    while let Some((at, c)) = reader.chars.next() {
        if reader.copy_token(at, c)? {
            let rest = query[at + 1..].trim();
            return match after_comments(rest) {
                "" => Ok(reader.out),
                rest => Err(QueryFault::AfterStop {
                    begin: rest.chars().take(20).collect(),
                }),
            };
        }
    }
    Ok(reader.out)
}

/// Returns the text after leading comments; an unterminated comment is not skipped.
fn after_comments(mut text: &str) -> &str {
    loop {
        text = text.trim_start();
        if text.starts_with('%') {
            text = text.split_once('\n').map_or("", |(_, rest)| rest);
        } else if let Some((_, rest)) = text.strip_prefix("/*").and_then(|t| t.split_once("*/")) {
            text = rest;
        } else {
            return text;
        }
    }
}

struct Reader<'a> {
    query: &'a str,
    chars: Peekable<CharIndices<'a>>,
    out: String,
}

impl Reader<'_> {
    /// Copies the token that begins with this character. Returns whether it is the full stop.
    fn copy_token(&mut self, at: usize, c: char) -> Result<bool, QueryFault> {
        match c {
            '%' => {
                self.skip(|c| c != '\n');
                self.out.push(' ');
            }
            '/' if self.next_is('*') => match self.query[at + 2..].find("*/") {
                Some(len) => {
                    let end = at + 2 + len + 2;
                    while self.chars.next_if(|(place, _)| *place < end).is_some() {}
                    self.out.push(' ');
                }
                None => self.out.push(c),
            },
            '\'' | '"' | '`' => self.copy_quoted(c),
            '0'..='9' => self.number(at)?,
            c if c.is_alphanumeric() || c == '_' => {
                self.out.push(c);
                self.copy(|c| c.is_alphanumeric() || c == '_');
            }
            c if is_symbol(c) => {
                let len = self.query[at..]
                    .find(|c| !is_symbol(c))
                    .unwrap_or(self.query.len() - at);
                let symbol = &self.query[at..at + len];
                let next = self.query[at + len..].chars().next();
                if symbol == "." && next.is_none_or(|c| c.is_whitespace() || c == '%') {
                    return Ok(true);
                }
                self.out.push(c);
                // A comment may begin within the symbol.
                self.copy_before(at + symbol.find("/*").filter(|at| *at > 0).unwrap_or(len));
            }
            c => self.out.push(c),
        }
        Ok(false)
    }

    fn next_is(&mut self, c: char) -> bool {
        self.chars.peek().is_some_and(|(_, next)| *next == c)
    }

    fn skip(&mut self, belongs: impl Fn(char) -> bool) {
        while self.chars.next_if(|(_, c)| belongs(*c)).is_some() {}
    }

    fn copy(&mut self, belongs: impl Fn(char) -> bool) {
        while let Some((_, c)) = self.chars.next_if(|(_, c)| belongs(*c)) {
            self.out.push(c);
        }
    }

    fn copy_before(&mut self, end: usize) {
        while let Some((_, c)) = self.chars.next_if(|(at, _)| *at < end) {
            self.out.push(c);
        }
    }

    /// Copies up to the closing quote; a doubled quote continues.
    fn copy_quoted(&mut self, mark: char) {
        self.out.push(mark);
        while let Some((_, c)) = self.chars.next() {
            self.out.push(c);
            if c == mark {
                return;
            }
            if c == '\\'
                && let Some((_, escaped)) = self.chars.next()
            {
                self.out.push(escaped);
            }
        }
    }

    fn number(&mut self, at: usize) -> Result<(), QueryFault> {
        let rest = &self.query[at..];
        if let Some(character) = rest.strip_prefix("0'") {
            // In a character code, the next character does not open a quote. A quote itself is written twice.
            let len = match character.as_bytes() {
                [b'\\', ..] => 1 + character.chars().nth(1).map_or(0, char::len_utf8),
                [b'\'', b'\'', ..] => 2,
                _ => character.chars().next().map_or(0, char::len_utf8),
            };
            self.out.push('0');
            self.copy_before(at + 2 + len);
            return Ok(());
        }
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let whole = digits(rest);
        let mut end = whole;
        let fraction = rest[end..].strip_prefix('.').map_or(0, digits);
        if fraction > 0 {
            end += 1 + fraction;
        }
        let exponent = match rest[end..].strip_prefix(['e', 'E']) {
            Some(power) => {
                let sign = usize::from(power.starts_with(['+', '-']));
                match digits(&power[sign..]) {
                    0 => 0,
                    len => 1 + sign + len,
                }
            }
            None => 0,
        };
        let mantissa = &rest[..end];
        end += exponent;
        let text = &rest[..end];
        if fraction > 0 || exponent > 0 {
            let is_finite = text.parse::<f64>().is_ok_and(f64::is_finite);
            if !is_finite {
                return Err(QueryFault::Prolog {
                    what: format!("{text} is more than the largest number, {:e}", f64::MAX),
                });
            }
        }
        self.out.push_str(mantissa);
        if fraction == 0 && exponent > 0 {
            self.out.push_str(".0");
        }
        self.out.push_str(&rest[mantissa.len()..end]);
        while self.chars.next_if(|(place, _)| *place < at + end).is_some() {}
        // As in 0x1f, which stays as it is.
        self.copy(|c| c.is_alphanumeric() || c == '_');
        Ok(())
    }
}

fn is_symbol(c: char) -> bool {
    "+-*/\\^<>=~:.?@#&$".contains(c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_full_stop_and_comments_are_removed() {
        for (query, body) in [
            ("true. ", "true"),
            ("true", "true"),
            ("true.", "true"),
            ("X = 'a. b'. % why", "X = 'a. b'"),
            ("X = \"a. b\", Y = 0'. .", "X = \"a. b\", Y = 0'. "),
            (
                "X = 'it''s. \\'. ', Y = 0'''.",
                "X = 'it''s. \\'. ', Y = 0'''",
            ),
            ("a % b. c\n, d", "a  \n, d"),
            ("a /* . b */, c. /* d */ % e", "a  , c"),
            ("X =.. Y.", "X =.. Y"),
            ("X = [1.5, a.b]", "X = [1.5, a.b]"),
            ("", ""),
            ("X = /*", "X = /*"),
            ("X = 'open", "X = 'open"),
        ] {
            assert_eq!(prepare_query(query).unwrap(), body, "{query}");
        }
    }

    #[test]
    fn text_after_the_full_stop_is_refused() {
        for query in ["true. foo", "true. true.", "a. 'b", "a.\n/* c */ b", "1. 2"] {
            assert!(prepare_query(query).is_err(), "{query}");
        }
    }

    #[test]
    fn numbers_are_rewritten_for_every_engine() {
        for (query, body) in [
            ("X is 1e308", "X is 1.0e308"),
            ("X is 2E-3 + 1.5e+2", "X is 2.0E-3 + 1.5e+2"),
            ("X = 1e, Y = 12ex, Z = a1e5", "X = 1e, Y = 12ex, Z = a1e5"),
            ("X = 0x1e5, Y = _1e5", "X = 0x1e5, Y = _1e5"),
            ("X = '1e5'", "X = '1e5'"),
        ] {
            assert_eq!(prepare_query(query).unwrap(), body, "{query}");
        }
        assert!(prepare_query("X is 1e309").is_err());
    }
}
