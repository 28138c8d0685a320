//! Typed lists, atoms and literals of PDDL.
//!
//! `pddl-parser` reads them, a few words at a time. What it stumbles over is kept from it: it says
//! of most errors neither where nor what, takes everyday names such as `at`, `start` or `problem`
//! for keywords, skips `(in-package ...)` wherever it stands, and reads quantifiers as atoms. So
//! [`form::read`](super::form::read) checks the words, and every name goes in behind a
//! [`MARK`].

use pddl_parser::domain::expression::Expression;
use pddl_parser::domain::typed_parameter::TypedParameter;
use pddl_parser::domain::typing::Type;
use pddl_parser::lexer::TokenStream;

use super::GoalError;
use super::form::{Form, Source, is_name};

/// Put before names on their way to the parser: no keyword begins with it in any case, and no name
/// has it in it, names being in small letters.
const MARK: char = 'X';

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

/// What a typed list gives types to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Listed {
    /// Types, constants or objects.
    Names,
    /// Parameters, `?x`.
    Variables,
}

/// Reads `a b - t c`, in which what has no type is an `object`.
pub(super) fn typed_list(
    source: Source<'_>,
    forms: &[Form],
    listed: Listed,
) -> Result<Vec<Typed>, GoalError> {
    let expected = match listed {
        Listed::Names => "a name, or `-` and a type",
        Listed::Variables => "a parameter `?name`, or `-` and a type",
    };
    let mut text = String::new();
    let mut names: Vec<&Form> = Vec::new();
    let mut types: Vec<&Form> = Vec::new();
    let mut after_dash = false;
    for form in forms {
        if form.head().is_some_and(|(head, _)| head == "either") {
            return Err(source.not_supported(form.at, "`either`"));
        }
        let word = form.word().ok_or_else(|| source.expected(expected, form))?;
        if word == "-" {
            text += " -";
        } else if after_dash {
            let name = form.name().ok_or_else(|| source.expected("a type", form))?;
            text += &format!(" {MARK}{name}");
            // One type for all names since the last one.
            types.resize(names.len(), form);
        } else {
            let name = match listed {
                Listed::Names => form.name(),
                Listed::Variables => variable(word),
            };
            let name = name.ok_or_else(|| source.expected(expected, form))?;
            text += &format!(" ?{MARK}{name}");
            names.push(form);
        }
        after_dash = word == "-";
    }
    let parsed = TypedParameter::parse_typed_parameters(TokenStream::new(&text));
    let parameters = match parsed {
        Ok((rest, parameters)) if rest.is_empty() && parameters.len() == names.len() => parameters,
        _ => {
            let expected = "a name before and a type after every `-`";
            let at = forms.last().map_or(0, |form| form.at);
            return Err(source.expected_at(at, expected, "a list without"));
        }
    };
    let typed = names.iter().enumerate().zip(parameters);
    let typed = typed.map(|((i, form), parameter)| Typed {
        name: form.word().unwrap_or_default().to_owned(),
        at: form.at,
        type_name: match parameter.type_ {
            Type::Simple(name) => name.replacen(MARK, "", 1),
            Type::Either(names) => names.concat(),
        },
        type_at: types.get(i).map_or(form.at, |form| form.at),
    });
    Ok(typed.collect())
}

fn variable(word: &str) -> Option<&str> {
    word.strip_prefix('?').filter(|name| is_name(name))
}

/// The predicate that an atom begins with, and what follows.
pub(super) fn predicate<'f>(
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
pub(super) fn atom(source: Source<'_>, form: &Form) -> Result<Atom, GoalError> {
    let (head, arguments) = predicate(source, form)?;
    let mut text = format!("({MARK}{head}");
    for argument in arguments {
        let word = argument.word().unwrap_or_default();
        match variable(word) {
            Some(name) => text += &format!(" ?{MARK}{name}"),
            None if is_name(word) => text += &format!(" {MARK}{word}"),
            None => return Err(source.expected("a name or a `?variable`", argument)),
        }
    }
    text.push(')');
    match Expression::parse_expression(TokenStream::new(&text)) {
        Ok((rest, Expression::Atom { name, parameters })) if rest.is_empty() => {
            let arguments = parameters.iter().map(ToString::to_string);
            let words = std::iter::once(name).chain(arguments);
            Ok(Atom {
                at: form.at,
                words: words.map(|word| word.replacen(MARK, "", 1)).collect(),
            })
        }
        _ => Err(source.expected("an atom", form)),
    }
}

/// Reads an atom, `(not atom)`, or an `(and ...)` of these; `()` is nothing. Each comes with whether
/// it is to be true.
pub(super) fn literals(source: Source<'_>, form: &Form) -> Result<Vec<(bool, Atom)>, GoalError> {
    match form.head() {
        None if form.list().is_some_and(<[Form]>::is_empty) => Ok(Vec::new()),
        Some(("and", forms)) => {
            let parts = forms.iter().map(|form| literals(source, form));
            Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
        }
        Some(("not", [form])) if form.head().is_some_and(|(head, _)| head == "not") => {
            Err(source.not_supported(form.at, "`(not (not ...))`"))
        }
        Some(("not", [form])) => Ok(vec![(false, atom(source, form)?)]),
        Some(("not", _)) => Err(source.expected("`(not atom)`", form)),
        _ => Ok(vec![(true, atom(source, form)?)]),
    }
}

/// The same where nothing may be negated.
pub(super) fn atoms(source: Source<'_>, form: &Form, role: &str) -> Result<Vec<Atom>, GoalError> {
    let literals = literals(source, form)?.into_iter();
    let atoms = literals.map(|(holds, atom)| {
        let refused = || source.not_supported(atom.at, &format!("`not` in {role}"));
        if holds { Ok(atom) } else { Err(refused()) }
    });
    atoms.collect()
}
