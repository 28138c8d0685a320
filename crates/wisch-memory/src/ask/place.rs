//! Position of an error in a query: engines report an error, but not its position.

mod tokens;

use super::error::QueryFault;
use tokens::{Token, TokenKind, tokens};

/// A part of a query's text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ErrorPlace {
    /// Offset from the text's begin, in UTF-16 units, as browsers count.
    pub offset: usize,
    /// Length in UTF-16 units.
    pub length: usize,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

/// Returns the position of a fault in the text of its query, if it can be determined.
///
/// ```
/// use wisch_memory::ask::{QueryFault, locate_fault};
///
/// let fault = QueryFault::Syntax { what: "operator expected".to_owned() };
/// let place = locate_fault(&fault, "low_performance(A P)").expect("a place");
/// assert_eq!((place.line, place.column), (1, 19));
/// ```
pub fn locate_fault(fault: &QueryFault, query: &str) -> Option<ErrorPlace> {
    let tokens = tokens(query);
    let (start, end) = match fault {
        QueryFault::Unknown { kind, name, .. } if kind == "predicate" => {
            let (name, arity) = name.rsplit_once('/')?;
            call(&tokens, query, name, arity.parse().unwrap_or(0))?
        }
        QueryFault::Unknown { name, .. } => find_name(&tokens, query, name)?,
        QueryFault::NoName { term } => {
            let start = query.find(term.as_str())?;
            (start, start + term.len())
        }
        QueryFault::Syntax { .. } => syntax(&tokens, query),
        QueryFault::AfterStop { .. } => {
            let stop = tokens
                .iter()
                .position(|token| token.kind == TokenKind::Stop)?;
            (tokens.get(stop + 1)?.start, query.trim_end().len())
        }
        _ => return None,
    };
    Some(ErrorPlace::of(query, start, end))
}

impl ErrorPlace {
    /// Converts a range of bytes.
    fn of(query: &str, start: usize, end: usize) -> Self {
        let before = &query[..start];
        let units = |text: &str| text.encode_utf16().count();
        let last_line = before.rsplit('\n').next().unwrap_or_default();
        Self {
            offset: units(before),
            length: units(&query[start..end]),
            line: before.matches('\n').count() + 1,
            column: last_line.chars().count() + 1,
        }
    }
}

/// Finds the call of a predicate, preferably one with this arity.
fn call(tokens: &[Token], query: &str, name: &str, arity: usize) -> Option<(usize, usize)> {
    let calls = tokens.iter().enumerate().filter(|(_, token)| {
        matches!(token.kind, TokenKind::Name | TokenKind::Symbol) && token.value(query) == name
    });
    let calls: Vec<(usize, &Token)> = calls.collect();
    let fits = calls
        .iter()
        .find(|(place, _)| arguments(&tokens[place + 1..]) == arity);
    let (_, token) = fits.or_else(|| calls.first())?;
    Some((token.start, token.end))
}

/// Counts the arguments in the brackets that open here.
fn arguments(tokens: &[Token]) -> usize {
    if tokens.first().map(|token| token.kind) != Some(TokenKind::Call) {
        return 0;
    }
    let (mut depth, mut commas) = (0, 0);
    for token in tokens {
        match token.kind {
            TokenKind::Call | TokenKind::Open => depth += 1,
            TokenKind::Close if depth == 1 => return commas + 1,
            TokenKind::Close => depth -= 1,
            TokenKind::Comma if depth == 1 => commas += 1,
            _ => {}
        }
    }
    commas + 1
}

/// Finds a name, for example `semco:'Colision'`.
fn find_name(tokens: &[Token], query: &str, name: &str) -> Option<(usize, usize)> {
    let bare = |text: &str| text.trim_matches('\'').replace("\\'", "'");
    let (prefix, local) = match name.split_once(':') {
        Some((prefix, local)) => (Some(prefix), bare(local)),
        None => (None, bare(name)),
    };
    let is = |token: &Token, wanted: &str| {
        matches!(token.kind, TokenKind::Name | TokenKind::Number) && token.value(query) == wanted
    };
    let mut found = None;
    for (place, token) in tokens.iter().enumerate() {
        if !is(token, &local) {
            continue;
        }
        let before = place.checked_sub(2).map(|place| &tokens[place]);
        match (prefix, before) {
            (Some(prefix), Some(first))
                if is(first, prefix) && tokens[place - 1].value(query) == ":" =>
            {
                return Some((first.start, token.end));
            }
            _ => found = found.or(Some((token.start, token.end))),
        }
    }
    // A name that is quoted as a whole.
    let whole = || tokens.iter().find(|token| is(token, &bare(name)));
    found.or_else(|| whole().map(|token| (token.start, token.end)))
}

/// Finds the first token that is not allowed at its position.
fn syntax(tokens: &[Token], query: &str) -> (usize, usize) {
    let end = query.trim_end().len();
    // Open brackets, with their positions.
    let mut open: Vec<(&str, (usize, usize))> = Vec::new();
    // Whether a term must begin here.
    let mut begins = true;
    for (number, token) in tokens.iter().enumerate() {
        let place = (token.start, token.end);
        let text = &query[token.start..token.end];
        match token.kind {
            TokenKind::Unfinished => return place,
            TokenKind::Stop => break,
            TokenKind::Name | TokenKind::Number | TokenKind::Text | TokenKind::Variable => {
                let is_infix = tokens::is_word_operator(text);
                let is_prefix = text == "\\+" || text == "dynamic";
                match (begins, is_infix) {
                    (false, false) => return place,
                    (false, true) => begins = true,
                    (true, _) => begins = is_prefix,
                }
            }
            // A sign before a term, or between two terms; a name if nothing follows.
            TokenKind::Symbol => {
                let next = tokens.get(number + 1).map(|next| next.kind);
                let follows = !matches!(
                    next,
                    None | Some(
                        TokenKind::Comma | TokenKind::Close | TokenKind::Bar | TokenKind::Stop
                    )
                );
                if !begins && !follows {
                    return place;
                }
                begins = follows;
                if next == Some(TokenKind::Call) {
                    begins = false;
                }
            }
            TokenKind::Comma | TokenKind::Bar => {
                if begins {
                    return place;
                }
                begins = true;
            }
            TokenKind::Call | TokenKind::Open => {
                if token.kind == TokenKind::Open && !begins {
                    return place;
                }
                open.push((text, place));
                begins = true;
            }
            TokenKind::Close => {
                let fits = match open.pop() {
                    Some(("(", _)) => text == ")",
                    Some(("[", _)) => text == "]",
                    Some(("{", _)) => text == "}",
                    _ => false,
                };
                let opened_just_now = number > 0
                    && matches!(tokens[number - 1].kind, TokenKind::Open)
                    && matches!(text, "]" | "}");
                if !fits || (begins && !opened_just_now) {
                    return place;
                }
                begins = false;
            }
        }
    }
    match open.pop() {
        Some((_, place)) => place,
        None => (end, end),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(fault: &QueryFault, query: &str) -> Option<String> {
        let place = locate_fault(fault, query)?;
        let units: Vec<u16> = query.encode_utf16().collect();
        let part = &units[place.offset..place.offset + place.length];
        Some(String::from_utf16_lossy(part))
    }

    fn unknown(kind: &str, name: &str) -> QueryFault {
        QueryFault::Unknown {
            kind: kind.to_owned(),
            name: name.to_owned(),
            nearest: None,
        }
    }

    #[test]
    fn an_unknown_name_is_located() {
        let query = "owl_individual_of(C, semco:'Colision'),\n  occur(C, [S, E])";
        let class = unknown("class", "semco:'Colision'");
        assert_eq!(part(&class, query).as_deref(), Some("semco:'Colision'"));
        let predicate = unknown("predicate", "occur/2");
        assert_eq!(part(&predicate, query).as_deref(), Some("occur"));
        let place = locate_fault(&predicate, query).unwrap();
        assert_eq!((place.line, place.column), (2, 3));
        let missing = unknown("predicate", "nothing/0");
        assert_eq!(part(&missing, query), None);
    }

    #[test]
    fn the_call_with_the_right_arity_is_located() {
        let query = "f(a), f(b, [c, d])";
        let place = locate_fault(&unknown("predicate", "f/2"), query).unwrap();
        assert_eq!(place.offset, 6);
    }

    #[test]
    fn positions_count_utf_16_units() {
        let query = "X = '𝄞', foo(X)";
        let place = locate_fault(&unknown("predicate", "foo/1"), query).unwrap();
        assert_eq!((place.offset, place.column), (10, 10));
    }

    #[test]
    fn a_syntax_error_is_at_the_first_invalid_token() {
        let fault = QueryFault::Syntax {
            what: "incomplete reduction".to_owned(),
        };
        for (query, at) in [
            ("foo(A, B", "("),
            ("foo(A,, B)", ","),
            ("foo(A B)", "B"),
            ("foo(A)) , bar", ")"),
            ("foo(A), 'open", "'open"),
            ("foo(A] , b", "]"),
            ("foo(A), ", ""),
            ("X is 2 *", "*"),
            ("foo [a]", "["),
            ("a, | b", "|"),
            ("low_performance(A P), occurs(A, [S, E])", "P"),
        ] {
            assert_eq!(part(&fault, query).as_deref(), Some(at), "{query}");
        }
    }

    #[test]
    fn a_valid_query_has_no_error_before_its_end() {
        for query in [
            "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), M is 0.5*(S+E)",
            "has_data_value(A, performance =< 0.8), \\+ goal_met(A)",
            "findall(N-P, performance_by_round(A, N, P), L), L = [_|T], X = -1, Y = - X",
            "(goal_met(A) ; goal_missed(A, P)), S = \"text\", C = 0'a",
            "is_at(robot, P) during [1, 2.5e3], X = {}, Y = [], Z = f",
            "(a -> b ; c), X == Y, X =.. [f | Args], maplist(=(1), L)",
        ] {
            let place = syntax(&tokens(query), query);
            assert_eq!(place, (query.len(), query.len()), "{query}");
        }
    }
}
