//! Typed lists, atoms and literals of PDDL.

use super::GoalError;
use super::form::{Form, Source, is_name};

/// The root of all types.
pub(super) const OBJECT: &str = "object";

/// Words that begin something other than an atom, beyond `and` and `not`.
pub(super) const CONSTRUCTS: [&str; 20] = [
    "or",
    "imply",
    "exists",
    "forall",
    "when",
    "oneof",
    "preference",
    "assign",
    "increase",
    "decrease",
    "scale-up",
    "scale-down",
    "=",
    "<",
    ">",
    "<=",
    ">=",
    "+",
    "*",
    "/",
];

/// A name with its type.
#[derive(Debug, Clone)]
pub(super) struct Typed {
    pub(super) name: String,
    pub(super) at: usize,
    pub(super) type_name: String,
    pub(super) type_at: usize,
}

impl Typed {
    /// Name and type.
    pub(super) fn as_pair(&self) -> (&str, &str) {
        (&self.name, &self.type_name)
    }
}

/// A predicate with its arguments, names or `?variables`.
#[derive(Debug, Clone)]
pub(super) struct Atom {
    pub(super) at: usize,
    /// The predicate first.
    pub(super) words: Vec<String>,
}

impl Atom {
    pub(super) fn fact(&self) -> Vec<&str> {
        self.words.iter().map(String::as_str).collect()
    }
}

/// An atom that is to hold or not to hold, for all objects that its variables can stand for.
#[derive(Debug, Clone)]
pub(super) struct Literal {
    /// Variables of `forall`; empty without it.
    pub(super) variables: Vec<Typed>,
    /// Whether the atom is not negated.
    pub(super) holds: bool,
    pub(super) atom: Atom,
    /// Atoms of `when`, all of which have to hold initially; empty without it.
    pub(super) conditions: Vec<Atom>,
}

/// Kind of the entries of a typed list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Listed {
    /// Types, constants or objects.
    Names,
    /// Parameters, `?x`.
    Variables,
}

/// Reads a typed list `a b - t c`; names without a type are of type `object`.
pub(super) fn read_typed_list(
    source: Source<'_>,
    forms: &[Form],
    listed: Listed,
) -> Result<Vec<Typed>, GoalError> {
    let expected = match listed {
        Listed::Names => "a name, or `-` and a type",
        Listed::Variables => "a parameter `?name`, or `-` and a type",
    };
    let mut list: Vec<Typed> = Vec::new();
    // Number of names whose type is known.
    let mut typed = 0;
    let mut after_dash = false;
    let mut whole = true;
    for form in forms {
        if form.head().is_some_and(|(head, _)| head == "either") {
            return Err(source.not_supported(form.at, "`either`"));
        }
        let word = form.word().ok_or_else(|| source.expected(expected, form))?;
        if word == "-" {
            whole &= !after_dash && typed < list.len();
        } else if after_dash {
            let name = form.name().ok_or_else(|| source.expected("a type", form))?;
            // The type applies to all names since the last type.
            for entry in &mut list[typed..] {
                entry.type_name = name.to_owned();
                entry.type_at = form.at;
            }
            typed = list.len();
        } else {
            let name = match listed {
                Listed::Names => form.name(),
                Listed::Variables => variable(word),
            };
            name.ok_or_else(|| source.expected(expected, form))?;
            list.push(Typed {
                name: word.to_owned(),
                at: form.at,
                type_name: OBJECT.to_owned(),
                type_at: form.at,
            });
        }
        after_dash = word == "-";
    }
    if !whole || after_dash {
        let expected = "a name before and a type after every `-`";
        let at = forms.last().map_or(0, |form| form.at);
        return Err(source.expected_at(at, expected, "a list without"));
    }
    Ok(list)
}

fn variable(word: &str) -> Option<&str> {
    word.strip_prefix('?').filter(|name| is_name(name))
}

/// Returns the predicate of an atom, and its arguments.
pub(super) fn read_predicate<'f>(
    source: Source<'_>,
    form: &'f Form,
) -> Result<(&'f str, &'f [Form]), GoalError> {
    const EXPECTED: &str = "an atom `(predicate argument ...)`";
    let (head, rest) = form.head().ok_or_else(|| source.expected(EXPECTED, form))?;
    if CONSTRUCTS.contains(&head) {
        return Err(source.not_supported(form.at, &format!("`{head}`")));
    }
    if !is_name(head) || ["and", "not", "either"].contains(&head) {
        return Err(source.expected(EXPECTED, form));
    }
    Ok((head, rest))
}

/// Reads `(predicate argument ...)`.
pub(super) fn read_atom(source: Source<'_>, form: &Form) -> Result<Atom, GoalError> {
    let (head, arguments) = read_predicate(source, form)?;
    let mut words = vec![head.to_owned()];
    for argument in arguments {
        let word = argument.word().unwrap_or_default();
        if !is_name(word) && variable(word).is_none() {
            return Err(source.expected("a name or a `?variable`", argument));
        }
        words.push(word.to_owned());
    }
    Ok(Atom { at: form.at, words })
}

/// Reads an atom, `(not atom)`, `(forall (variables) ...)` or `(when (condition) ...)` of these, or an `(and ...)` of all of
/// them; `()` is empty.
pub(super) fn read_literals(source: Source<'_>, form: &Form) -> Result<Vec<Literal>, GoalError> {
    let single = |holds, atom| Literal {
        variables: Vec::new(),
        holds,
        atom,
        conditions: Vec::new(),
    };
    match form.head() {
        None if form.list().is_some_and(<[Form]>::is_empty) => Ok(Vec::new()),
        Some(("and", forms)) => {
            let parts = forms.iter().map(|form| read_literals(source, form));
            Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
        }
        Some(("forall", [variables, body])) => {
            let list = variables.list();
            let list = list.ok_or_else(|| source.expected("a list of variables", variables))?;
            let variables = read_typed_list(source, list, Listed::Variables)?;
            let mut literals = read_literals(source, body)?;
            for literal in &mut literals {
                if !literal.variables.is_empty() {
                    return Err(source.not_supported(form.at, "`forall` in `forall`"));
                }
                literal.variables.clone_from(&variables);
            }
            Ok(literals)
        }
        Some(("when", [condition, body])) => {
            let conditions = read_literals(source, condition)?;
            let is_plain =
                |one: &Literal| one.holds && one.variables.is_empty() && one.conditions.is_empty();
            if !conditions.iter().all(is_plain) {
                let what = "a condition of `when` that is no atom";
                return Err(source.not_supported(condition.at, what));
            }
            let conditions: Vec<Atom> = conditions.into_iter().map(|one| one.atom).collect();
            let mut literals = read_literals(source, body)?;
            if literals
                .iter()
                .any(|one| !one.variables.is_empty() || !one.conditions.is_empty())
            {
                return Err(source.not_supported(form.at, "`forall` or `when` in `when`"));
            }
            for literal in &mut literals {
                literal.conditions.clone_from(&conditions);
            }
            Ok(literals)
        }
        Some(("when", _)) => Err(source.expected("`(when (condition) ...)`", form)),
        Some(("forall", _)) => Err(source.expected("`(forall (variables) ...)`", form)),
        Some(("not", [form])) if form.head().is_some_and(|(head, _)| head == "not") => {
            Err(source.not_supported(form.at, "`(not (not ...))`"))
        }
        Some(("not", [form])) => Ok(vec![single(false, read_atom(source, form)?)]),
        Some(("not", _)) => Err(source.expected("`(not atom)`", form)),
        _ => Ok(vec![single(true, read_atom(source, form)?)]),
    }
}
