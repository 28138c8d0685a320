//! Predicates that are defined by a single conjunction, found in the Prolog texts.

use std::collections::HashMap;

/// Returns `defined(Head, Body).` for each predicate with a single clause that has a body.
pub fn definitions(texts: &[&str]) -> String {
    let clauses: Vec<(&str, &str)> = texts.iter().flat_map(|text| clauses(text)).collect();
    let mut counts: HashMap<(&str, usize), usize> = HashMap::new();
    for (head, _) in &clauses {
        *counts.entry(signature(head)).or_default() += 1;
    }
    let alone = clauses.into_iter();
    let alone = alone.filter(|(head, body)| !body.is_empty() && counts[&signature(head)] == 1);
    let facts = alone.map(|(head, body)| format!("defined({head}, ({body})).\n"));
    facts.collect()
}

/// Returns heads and bodies. A clause begins at the margin and ends with a full stop at the end of a line.
fn clauses(text: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    let mut begin = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let is_text = |c: char| c.is_alphanumeric() || c == '_';
        if begin.is_none() && line.starts_with(is_text) {
            begin = Some(at);
        }
        at += line.len();
        if let Some(from) = begin
            && line.trim_end().ends_with('.')
            && !line.trim_start().starts_with('%')
        {
            let clause = text[from..at].trim_end().trim_end_matches('.');
            let (head, body) = clause.split_once(":-").unwrap_or((clause, ""));
            found.push((head.trim(), body.trim()));
            begin = None;
        }
    }
    found
}

/// Returns name and arity of a head.
fn signature(head: &str) -> (&str, usize) {
    let Some((name, arguments)) = head.split_once('(') else {
        return (head, 0);
    };
    let (mut depth, mut is_quoted, mut count) = (0, false, 1);
    for c in arguments.chars() {
        match c {
            '\'' => is_quoted = !is_quoted,
            _ if is_quoted => {}
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => count += 1,
            _ => {}
        }
    }
    (name, count)
}

#[cfg(test)]
mod tests {
    use super::definitions;

    #[test]
    fn predicates_with_one_clause_are_defined() {
        let text = "% About: nothing.\n\na(X, [Y, Z]) :-\n    b(X, 'p,q'),\n    % So it is.\n    c(Y, Z).\n\
                    b(X, Y) :- c(X, Y).\nb(X) :- c(X, X).\nc(1, 2).\nd(X) :- c(X, 1).\nd(X) :- c(X, 2).\n:- op(700, xfx, e).\n";
        assert_eq!(
            definitions(&[text]),
            "defined(a(X, [Y, Z]), (b(X, 'p,q'),\n    % So it is.\n    c(Y, Z))).\n\
             defined(b(X, Y), (c(X, Y))).\ndefined(b(X), (c(X, X))).\n"
        );
    }
}
