//! Depth of a statement, from its text: the planner traverses the statement's tree by recursion.

/// Words that join parts of a statement or of an expression, one below the other.
const WORDS: [&str; 27] = [
    "AND",
    "AT",
    "BETWEEN",
    "CASE",
    "COLLATE",
    "DIV",
    "ESCAPE",
    "EXCEPT",
    "FILTER",
    "ILIKE",
    "IN",
    "INTERSECT",
    "INTERVAL",
    "IS",
    "JOIN",
    "LIKE",
    "NOT",
    "OR",
    "OVER",
    "OVERLAPS",
    "REGEXP",
    "RLIKE",
    "SELECT",
    "SIMILAR",
    "UNION",
    "WHEN",
    "XOR",
];
/// Words that end the list of tables after FROM.
const AFTER_TABLES: [&str; 10] = [
    "EXCEPT",
    "GROUP",
    "HAVING",
    "INTERSECT",
    "LIMIT",
    "ORDER",
    "QUALIFY",
    "SELECT",
    "UNION",
    "WHERE",
];

/// Returns an upper bound of the depth of a statement's tree: operators, brackets, joined tables and nesting words
/// count. Siblings, such as columns and the members of `IN (…)`, do not.
pub(super) fn depth(sql: &str) -> usize {
    let mut depth = 0;
    // For each open bracket, whether a comma there joins two tables.
    let mut joins = vec![false];
    let mut rest = sql;
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '\'' | '"' | '`' => quoted_length(rest, first),
            '-' if rest.starts_with("--") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => comment_length(rest),
            c if c.is_alphabetic() || c == '_' => {
                let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '$';
                let word = &rest[..rest.find(|c| !is_part(c)).unwrap_or(rest.len())];
                let upper = word.to_uppercase();
                depth += usize::from(WORDS.contains(&upper.as_str()));
                if let Some(joins) = joins.last_mut() {
                    *joins = (*joins || upper == "FROM") && !AFTER_TABLES.contains(&upper.as_str());
                }
                word.len()
            }
            _ => {
                match first {
                    '(' | '[' | '{' => joins.push(false),
                    ')' | ']' | '}' if joins.len() > 1 => drop(joins.pop()),
                    _ => {}
                }
                let is_join = first == ',' && joins.last() == Some(&true);
                depth += usize::from(is_join || "+-*/%|&^#~<>=!:@?([{".contains(first));
                first.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    depth
}

/// Returns the length of a quoted text. A doubled quote ends one text and begins the next.
fn quoted_length(text: &str, quote: char) -> usize {
    let end = text[1..].find(quote);
    end.map_or(text.len(), |end| end + 2)
}

/// Returns the length of a comment, which may be nested.
fn comment_length(text: &str) -> usize {
    let (mut open, mut at) = (0_usize, 0);
    while let Some(found) = text[at..].find(['/', '*']) {
        at += found;
        let step = match &text.as_bytes()[at..] {
            [b'/', b'*', ..] => {
                open += 1;
                2
            }
            [b'*', b'/', ..] => {
                open -= 1;
                2
            }
            _ => 1,
        };
        at += step;
        if open == 0 {
            return at;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nested_parts_are_counted() {
        for (sql, expected) in [
            ("", 0),
            ("SELECT a, b, c FROM t WHERE d", 1),
            ("SELECT 1 + 2 - 3", 3),
            ("select not not a", 3),
            ("SELECT ((a))", 3),
            ("SELECT a IN (1, 2, 3, 4)", 3),
            ("SELECT a FROM t, u, v WHERE b", 3),
            ("SELECT f(a, b), c FROM t ORDER BY a, b", 2),
            ("SELECT a UNION ALL SELECT b", 3),
            ("SELECT x::int", 3),
        ] {
            assert_eq!(depth(sql), expected, "{sql}");
        }
    }

    #[test]
    fn texts_names_and_comments_are_not_counted() {
        for sql in [
            "SELECT '((( + ''AND'' )))'",
            "SELECT \"a + b\" -- ((( + AND\n",
            "SELECT /* (( /* ++ */ AND */ a",
            "SELECT 'äöü'",
            "SELECT standard, android, notes",
        ] {
            assert_eq!(depth(sql), 1, "{sql}");
        }
        // Unterminated text counts up to the end.
        for sql in [
            "SELECT '(((",
            "SELECT /* ((",
            "SELECT -- ((",
            "SELECT \"ä((",
        ] {
            assert_eq!(depth(sql), 1, "{sql}");
        }
    }

    #[test]
    fn long_chains_are_deep() {
        assert_eq!(depth(&format!("SELECT 1{}", "+1".repeat(100_000))), 100_001);
        assert_eq!(
            depth(&format!("SELECT a{} FROM t", " OR b".repeat(5000))),
            5001
        );
        assert_eq!(
            depth(&format!("SELECT 1 FROM t{}", ", t".repeat(5000))),
            5001
        );
        assert_eq!(depth(&format!("SELECT a IN (1{})", ", 1".repeat(5000))), 3);
    }
}
