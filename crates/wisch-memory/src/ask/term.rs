//! Prolog terms: a parser of the engines' canonical notation, and writers for people and for engines.

use std::fmt;

/// A Prolog term: atom, number, variable, list or compound.
#[derive(Debug, Clone, PartialEq)]
pub enum Term {
    /// An unbound variable, by the engine's name.
    Variable(String),
    /// An atom.
    Atom(String),
    /// An integer.
    Integer(i64),
    /// A floating-point number.
    Float(f64),
    /// A compound term: a name with arguments.
    Compound(String, Vec<Term>),
    /// A list.
    List(Vec<Term>),
}

/// Largest nesting of terms that is accepted.
const MAX_DEPTH: usize = 1000;

impl Term {
    /// Returns the atom with a name.
    pub fn atom(name: impl Into<String>) -> Self {
        Self::Atom(name.into())
    }

    /// Returns a compound term with a name and arguments.
    pub fn compound(name: impl Into<String>, arguments: impl Into<Vec<Self>>) -> Self {
        Self::Compound(name.into(), arguments.into())
    }

    /// Returns the term as JSON: numbers, lists and names as such, unbound variables as null, other terms as text.
    ///
    /// ```
    /// use wisch_memory::ask::Term;
    /// let list = Term::List(vec![Term::Integer(2), Term::atom("sponge")]);
    /// assert_eq!(list.to_json().to_string(), r#"[2,"sponge"]"#);
    /// ```
    pub fn to_json(&self) -> serde_json::Value {
        match self {
            Self::Variable(_) => serde_json::Value::Null,
            Self::Integer(number) => (*number).into(),
            Self::Float(number) => (*number).into(),
            Self::Atom(name) => name.as_str().into(),
            Self::List(items) => items.iter().map(Self::to_json).collect(),
            Self::Compound(..) => self.to_string().into(),
        }
    }

    /// Returns the name of an atom; `None` for any other term.
    pub fn as_atom(&self) -> Option<&str> {
        match self {
            Self::Atom(name) => Some(name),
            _ => None,
        }
    }

    /// Returns the value of a number; `None` for any other term.
    pub fn as_number(&self) -> Option<f64> {
        match self {
            #[allow(
                clippy::cast_precision_loss,
                reason = "times and counts are far below 2^53"
            )]
            Self::Integer(value) => Some(*value as f64),
            Self::Float(value) => Some(*value),
            _ => None,
        }
    }

    /// Name and arguments; an atom has none.
    pub fn parts(&self) -> Option<(&str, &[Self])> {
        match self {
            Self::Atom(name) => Some((name, &[])),
            Self::Compound(name, arguments) => Some((name, arguments)),
            _ => None,
        }
    }

    /// Whether `...` replaces a part of the term.
    pub(super) fn is_cut_short(&self) -> bool {
        match self {
            Self::Atom(name) => name == "...",
            Self::Compound(_, parts) | Self::List(parts) => parts.iter().any(Self::is_cut_short),
            Self::Variable(_) | Self::Integer(_) | Self::Float(_) => false,
        }
    }

    /// Parses a term in canonical notation, with or without the final full stop.
    ///
    /// # Errors
    /// What was expected, and where.
    pub fn parse(text: &str) -> Result<Self, TermError> {
        let mut reader = Reader { text, at: 0 };
        let term = reader.term(0)?;
        reader.space();
        match reader.rest() {
            "" | "." => Ok(term),
            _ => Err(reader.expected("the end")),
        }
    }

    /// Writes the term for engines: every atom is quoted.
    pub fn write_quoted(&self, out: &mut String) {
        use fmt::Write as _;
        match self {
            Self::Variable(_) => out.push('_'),
            Self::Atom(name) => quote(name, out),
            Self::Integer(value) => {
                let _ = write!(out, "{value}");
            }
            Self::Float(value) => out.push_str(&float(*value)),
            Self::Compound(name, arguments) => {
                quote(name, out);
                out.push('(');
                write_separated(arguments, out, |term, out| term.write_quoted(out));
                out.push(')');
            }
            Self::List(items) => {
                out.push('[');
                write_separated(items, out, |term, out| term.write_quoted(out));
                out.push(']');
            }
        }
    }
}

fn write_separated<T>(items: &[T], out: &mut String, mut write: impl FnMut(&T, &mut String)) {
    for (place, item) in items.iter().enumerate() {
        if place > 0 {
            out.push(',');
        }
        write(item, out);
    }
}

/// Writes a number that Prolog reads as a floating-point number.
pub(super) fn float(value: f64) -> String {
    let text = format!("{value:?}");
    // Prolog requires a fraction before an exponent.
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => text,
    }
}

/// Writes a quoted atom.
pub(super) fn quote(name: &str, out: &mut String) {
    out.push('\'');
    for c in name.chars() {
        match c {
            '\'' => out.push_str("\\'"),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => {
                use fmt::Write as _;
                let _ = write!(out, "\\x{:x}\\", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('\'');
}

fn is_plain(name: &str) -> bool {
    let mut chars = name.chars();
    let alphanumeric = |c: char| c.is_ascii_alphanumeric() || c == '_';
    matches!(name, "[]" | "{}" | "!" | ";")
        || chars.next().is_some_and(|c| c.is_ascii_lowercase()) && chars.all(alphanumeric)
        || !name.is_empty() && name.chars().all(is_symbol)
}

fn is_symbol(c: char) -> bool {
    "+-*/\\^<>=~:.?@#&$".contains(c)
}

/// Whether a character is a symbol beyond ASCII, such as an arrow: part of names in Scryer Prolog, of symbols in
/// SWI-Prolog.
fn is_sign(c: char) -> bool {
    !(c.is_ascii() || c.is_alphanumeric() || c.is_whitespace() || c.is_control())
}

/// Writes the term for people: `semco:'Collision_1'`, lists in brackets, common operators between their arguments.
impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Variable(_) => f.write_str("_"),
            Self::Atom(name) => write_name(name, f),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Float(value) => f.write_str(&float(*value)),
            Self::List(items) => {
                f.write_str("[")?;
                for (place, item) in items.iter().enumerate() {
                    if place > 0 {
                        f.write_str(", ")?;
                    }
                    write!(f, "{item}")?;
                }
                f.write_str("]")
            }
            Self::Compound(name, arguments) => match (name.as_str(), arguments.as_slice()) {
                ("-" | ":" | "=", [left, right]) => write!(f, "{left}{name}{right}"),
                _ => {
                    write_name(name, f)?;
                    f.write_str("(")?;
                    for (place, argument) in arguments.iter().enumerate() {
                        if place > 0 {
                            f.write_str(", ")?;
                        }
                        write!(f, "{argument}")?;
                    }
                    f.write_str(")")
                }
            },
        }
    }
}

/// Writes an atom; a name of the memory has its prefix before the quotes.
fn write_name(name: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut text = String::new();
    match name.split_once(':') {
        Some((prefix, local)) if is_plain(prefix) && !local.is_empty() && !local.contains('/') => {
            text.push_str(prefix);
            text.push(':');
            if is_plain(local) {
                text.push_str(local);
            } else {
                quote(local, &mut text);
            }
        }
        _ if is_plain(name) => text.push_str(name),
        _ => quote(name, &mut text),
    }
    f.write_str(&text)
}

/// A text is not a term.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("byte {at} of the engine's answer: expected {expected}, found {found:?}")]
pub struct TermError {
    /// Position [bytes].
    pub at: usize,
    /// What was expected.
    pub expected: &'static str,
    /// The text at this position.
    pub found: String,
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn expected(&self, expected: &'static str) -> TermError {
        TermError {
            at: self.at,
            expected,
            found: self.rest().chars().take(20).collect(),
        }
    }

    fn space(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    fn take(&mut self, token: char) -> bool {
        self.space();
        let found = self.peek() == Some(token);
        if found {
            self.at += token.len_utf8();
        }
        found
    }

    fn run(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let end = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn term(&mut self, depth: usize) -> Result<Term, TermError> {
        if depth > MAX_DEPTH {
            return Err(self.expected("a term of less depth"));
        }
        self.space();
        let word = |c: char| c.is_alphanumeric() || c == '_' || is_sign(c);
        let symbol = |c: char| is_symbol(c) || is_sign(c);
        match self.peek() {
            None => Err(self.expected("a term")),
            Some(c) if c.is_ascii_digit() => self.number(false),
            Some('-') if self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) => {
                self.at += 1;
                self.number(true)
            }
            Some('-')
                if self.rest()[1..].starts_with(" ")
                    && self.rest()[1..]
                        .trim_start()
                        .starts_with(|c: char| c.is_ascii_digit()) =>
            {
                self.at += 1;
                self.space();
                self.number(true)
            }
            Some('_' | 'A'..='Z') => Ok(Term::Variable(self.run(word).to_owned())),
            Some('[') => self.list(depth),
            Some('"') => {
                let text = self.parse_quoted('"')?;
                Ok(Term::Atom(text))
            }
            Some('\'') => {
                let name = self.parse_quoted('\'')?;
                self.compound(name, depth)
            }
            Some('{') if self.rest().starts_with("{}") => {
                self.at += 2;
                self.compound("{}".to_owned(), depth)
            }
            // SWI-Prolog's form of {}(a).
            Some('{') => {
                self.at += 1;
                let inner = self.term(depth + 1)?;
                if !self.take('}') {
                    return Err(self.expected("}"));
                }
                Ok(Term::Compound("{}".to_owned(), vec![inner]))
            }
            Some(c @ ('!' | ';' | ',')) => {
                self.at += 1;
                self.compound(c.to_string(), depth)
            }
            Some(c) if is_sign(c) => {
                let name = self.run(|c| word(c) || symbol(c)).to_owned();
                self.compound(name, depth)
            }
            Some(c) if is_symbol(c) => {
                let name = self.run(symbol).to_owned();
                self.compound(name, depth)
            }
            Some(c) if word(c) => {
                let name = self.run(word).to_owned();
                self.compound(name, depth)
            }
            Some(_) => Err(self.expected("a term")),
        }
    }

    fn number(&mut self, negative: bool) -> Result<Term, TermError> {
        let start = self.at;
        self.run(|c| c.is_ascii_digit());
        let rest = self.rest();
        let mut is_float = false;
        if rest.starts_with('.') && rest[1..].starts_with(|c: char| c.is_ascii_digit()) {
            is_float = true;
            self.at += 1;
            self.run(|c| c.is_ascii_digit());
        }
        let rest = self.rest();
        if is_float && rest.starts_with(['e', 'E']) {
            self.at += 1;
            self.run(|c| c.is_ascii_digit() || c == '-' || c == '+');
        }
        let digits = &self.text[start..self.at];
        let sign = if negative { -1.0 } else { 1.0 };
        for (name, value) in [("Inf", f64::INFINITY), ("NaN", f64::NAN)] {
            if is_float && self.rest().starts_with(name) {
                self.at += name.len();
                return Ok(Term::Float(sign * value));
            }
        }
        let signed = || format!("{}{digits}", if negative { "-" } else { "" });
        if !is_float && let Ok(value) = signed().parse() {
            return self.parse_ratio(Term::Integer(value));
        }
        let value: f64 = digits.parse().map_err(|_| self.expected("a number"))?;
        if value.is_infinite() {
            // An integer of hundreds of digits, which can still be printed.
            return Ok(Term::Atom(signed()));
        }
        self.parse_ratio(Term::Float(sign * value))
    }

    /// Parses a number, or a ratio in SWI-Prolog's form 1r3.
    fn parse_ratio(&mut self, numerator: Term) -> Result<Term, TermError> {
        let by = |rest: &str| rest[1..].starts_with(|c: char| c.is_ascii_digit());
        if !self.rest().starts_with('r') || !by(self.rest()) {
            return Ok(numerator);
        }
        self.at += 1;
        let ratio = (numerator.as_number())
            .zip(self.number(false)?.as_number())
            .map(|(above, below)| above / below);
        ratio
            .map(Term::Float)
            .ok_or_else(|| self.expected("a ratio of numbers"))
    }

    fn parse_quoted(&mut self, mark: char) -> Result<String, TermError> {
        self.at += 1;
        let mut text = String::new();
        loop {
            let Some(c) = self.peek() else {
                return Err(self.expected("a closing quote"));
            };
            self.at += c.len_utf8();
            if c == mark {
                if self.peek() != Some(mark) {
                    return Ok(text);
                }
                self.at += 1;
                text.push(mark);
            } else if c == '\\' {
                text.push(self.parse_escape()?);
            } else {
                text.push(c);
            }
        }
    }

    fn parse_escape(&mut self) -> Result<char, TermError> {
        let Some(c) = self.peek() else {
            return Err(self.expected("an escape sequence"));
        };
        self.at += c.len_utf8();
        Ok(match c {
            'n' => '\n',
            't' => '\t',
            'r' => '\r',
            'a' => '\u{7}',
            'b' => '\u{8}',
            'f' => '\u{c}',
            'v' => '\u{b}',
            '0'..='7' | 'x' => {
                if c != 'x' {
                    self.at -= 1;
                }
                let digits = self.run(|c| c.is_ascii_hexdigit());
                let radix = if c == 'x' { 16 } else { 8 };
                let code = u32::from_str_radix(digits, radix).ok();
                if self.peek() == Some('\\') {
                    self.at += 1;
                }
                code.and_then(char::from_u32)
                    .ok_or_else(|| self.expected("a character's code"))?
            }
            c => c,
        })
    }

    fn compound(&mut self, name: String, depth: usize) -> Result<Term, TermError> {
        if !self.rest().starts_with('(') {
            return Ok(if name == "[]" {
                Term::List(Vec::new())
            } else {
                Term::Atom(name)
            });
        }
        if name == "." {
            return self.pairs(depth);
        }
        self.at += 1;
        if self.take(')') {
            // Only SWI-Prolog has these escapes.
            return Ok(Term::Compound(name, Vec::new()));
        }
        let mut arguments = vec![self.term(depth + 1)?];
        while self.take(',') {
            arguments.push(self.term(depth + 1)?);
        }
        if !self.take(')') {
            return Err(self.expected(")"));
        }
        Ok(Term::Compound(name, arguments))
    }

    /// Parses a list as pairs of head and tail with the given name, iteratively, because long lists must not overflow
    /// the stack. A term with that name and another number of arguments is an ordinary term.
    fn pairs(&mut self, depth: usize) -> Result<Term, TermError> {
        self.at += 1;
        let mut items = Vec::new();
        let mut tail = loop {
            if self.take(')') {
                break Term::Compound(".".to_owned(), Vec::new());
            }
            let item = self.term(depth + 1)?;
            if !self.take(',') {
                if !self.take(')') {
                    return Err(self.expected(","));
                }
                break Term::Compound(".".to_owned(), vec![item]);
            }
            items.push(item);
            self.space();
            let rest = self.rest();
            let pair = ["'.'(", ".("].iter().find(|pair| rest.starts_with(**pair));
            match pair {
                Some(pair) => self.at += pair.len(),
                None => break self.term(depth + 1)?,
            }
        };
        // From the innermost pair outwards.
        let mut inner = Vec::new();
        while let Some(item) = items.pop() {
            if self.take(')') {
                inner.push(item);
                continue;
            }
            inner.reverse();
            let mut arguments = vec![item, close_list(std::mem::take(&mut inner), tail)];
            while self.take(',') {
                arguments.push(self.term(depth + 1)?);
            }
            if !self.take(')') {
                return Err(self.expected(")"));
            }
            tail = Term::Compound(".".to_owned(), arguments);
        }
        inner.reverse();
        Ok(close_list(inner, tail))
    }

    fn list(&mut self, depth: usize) -> Result<Term, TermError> {
        self.at += 1;
        if self.take(']') {
            return Ok(Term::List(Vec::new()));
        }
        let mut items = vec![self.term(depth + 1)?];
        while self.take(',') {
            items.push(self.term(depth + 1)?);
        }
        let tail = if self.take('|') {
            self.term(depth + 1)?
        } else {
            Term::List(Vec::new())
        };
        if !self.take(']') {
            return Err(self.expected("]"));
        }
        Ok(close_list(items, tail))
    }
}

/// Returns a list of these items before a tail; a partial list stays in pairs.
fn close_list(mut items: Vec<Term>, tail: Term) -> Term {
    match tail {
        Term::List(more) => {
            items.extend(more);
            Term::List(items)
        }
        tail => items.into_iter().rev().fold(tail, |tail, item| {
            Term::Compound("'[|]'".trim_matches('\'').to_owned(), vec![item, tail])
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        Term::parse(text).unwrap().to_string()
    }

    #[test]
    fn the_notations_of_both_engines_give_the_same_term() {
        let scryer = "row('.'(a,'.'(1,'.'(-2.5,[]))),:(semco,'Collision'),_12,-(1,2),{}(x)).";
        let swi = "row([a,1,-2.5],:(semco,'Collision'),_G12,-(1,2),{}(x)).";
        let [a, b] = [scryer, swi].map(shown);
        assert_eq!(a, b);
        assert_eq!(a, "row([a, 1, -2.5], semco:'Collision', _, 1-2, {}(x))");
    }

    #[test]
    fn a_term_with_the_name_of_pairs_and_another_arity_is_ordinary() {
        let dot = |arguments: &[i64]| {
            let arguments = arguments.iter().copied().map(Term::Integer);
            Term::compound(".", arguments.collect::<Vec<_>>())
        };
        assert_eq!(Term::parse("'.'(1)").unwrap(), dot(&[1]));
        assert_eq!(Term::parse("'.'(1,2,3)").unwrap(), dot(&[1, 2, 3]));
        assert_eq!(Term::parse("'.'()").unwrap(), dot(&[]));
        // A compound with the name of the list functor, but another arity, as the tail of a list.
        let list = Term::parse("'.'(0,'.'(5,'.'(1,2,3)))").unwrap();
        let open = close_list(vec![Term::Integer(0), Term::Integer(5)], dot(&[1, 2, 3]));
        assert_eq!(list, open);
        assert!(Term::parse("'.'(1,'.'(2)").is_err());
    }

    #[test]
    fn names_may_contain_any_symbol() {
        let names = ["fla☋tten", "→", "=→", "→="];
        for name in names {
            let read = Term::parse(&format!("fault({name},/({name},2))")).unwrap();
            let atom = Term::atom(name);
            let indicator = Term::compound("/", [atom.clone(), Term::Integer(2)]);
            assert_eq!(read, Term::compound("fault", [atom, indicator]), "{name}");
        }
    }

    #[test]
    fn a_term_in_braces_has_their_name() {
        assert_eq!(shown("row({','(a,b)},{})"), "row({}(','(a, b)), {})");
    }

    #[test]
    fn a_term_may_be_without_arguments() {
        assert_eq!(shown("row(goal_met(),[f()])"), "row(goal_met(), [f()])");
    }

    #[test]
    fn names_of_the_memory_show_their_prefix() {
        assert_eq!(
            shown("'semco:Collision_2026-1'"),
            "semco:'Collision_2026-1'"
        );
        assert_eq!(shown("'semco:sponge'"), "semco:sponge");
        assert_eq!(shown("'it\\'s'"), "'it\\'s'");
        assert_eq!(shown("'a\\x41\\b'"), "aAb");
    }

    #[test]
    fn numbers_of_every_kind_are_read() {
        for (text, shown_as) in [
            ("1.0Inf", "inf"),
            ("-1.0Inf", "-inf"),
            ("1r4", "0.25"),
            ("-3r2", "-1.5"),
            ("99999999999999999999", "1.0e20"),
        ] {
            assert_eq!(shown(text), shown_as, "{text}");
        }
        let digits = "9".repeat(400);
        assert_eq!(Term::parse(&digits).unwrap(), Term::atom(digits));
    }

    #[test]
    fn written_terms_are_read_back() {
        let term = Term::compound(
            "f x",
            [
                Term::Float(1.7e9),
                Term::Float(1e300),
                Term::Float(-0.1),
                Term::Integer(-3),
                Term::List(vec![Term::atom("it's\n"), Term::List(Vec::new())]),
            ],
        );
        let mut text = String::new();
        term.write_quoted(&mut text);
        assert_eq!(Term::parse(&text).unwrap(), term);
    }

    #[test]
    fn a_long_list_of_pairs_does_not_overflow_the_stack() {
        let n = 100_000;
        let text = format!("{}[]{}", "'.'(1,".repeat(n), ")".repeat(n));
        let Term::List(items) = Term::parse(&text).unwrap() else {
            panic!("not a list");
        };
        assert_eq!(items.len(), n);
    }

    #[test]
    fn invalid_terms_are_errors() {
        for text in ["f(", "f(a", "'a", "[a|", ")", "", "f(a) b", "1Inf"] {
            assert!(Term::parse(text).is_err(), "{text}");
        }
        let deep = format!("{}a{}", "f(".repeat(5000), ")".repeat(5000));
        assert!(Term::parse(&deep).is_err());
    }
}
