//! PDDL domains: types, predicates and actions, with every name checked.

use std::collections::HashMap;

use super::GoalError;
use super::form::{Form, Source, read};
use super::syntax::{
    Listed, Literal, OBJECT, Typed, read_literals, read_predicate, read_typed_list,
};

/// Largest number of types, constants, predicates or actions, because they are searched linearly.
const MAX_NAMES: usize = 1000;
/// Largest number of parameters of an action; each multiplies the number of groundings.
const MAX_PARAMETERS: usize = 12;
/// Largest number of variables of `forall`; each multiplies the number of atoms.
const MAX_VARIABLES: usize = 3;

const SECTIONS: [&str; 5] = [
    ":requirements",
    ":types",
    ":constants",
    ":predicates",
    ":action",
];
/// Sections of PDDL beyond typed STRIPS.
const UNSUPPORTED_SECTIONS: [&str; 6] = [
    ":functions",
    ":durative-action",
    ":derived",
    ":constraints",
    ":process",
    ":event",
];

/// A planning domain in typed STRIPS with negation: types, constants, predicates and actions.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Each type but [`OBJECT`] with its parent.
    types: Vec<Typed>,
    pub(super) constants: Vec<Typed>,
    pub(super) predicates: Vec<Predicate>,
    pub(super) schemas: Vec<Schema>,
}

#[derive(Debug, Clone)]
pub(super) struct Predicate {
    pub(super) name: String,
    pub(super) parameters: Vec<Typed>,
}

/// An action with unbound parameters.
#[derive(Debug, Clone)]
pub(super) struct Schema {
    pub(super) name: String,
    pub(super) parameters: Vec<Typed>,
    pub(super) preconditions: Vec<Literal>,
    pub(super) effects: Vec<Literal>,
}

impl Schema {
    /// Returns the atoms that the action makes true.
    pub(super) fn added(&self) -> impl Iterator<Item = &Literal> {
        self.effects.iter().filter(|effect| effect.holds)
    }
}

impl Domain {
    /// Reads a PDDL domain; `name` identifies the text in errors.
    ///
    /// The language is typed STRIPS with negation: `:types`, `:constants`, `:predicates`, and `:action`s. Preconditions
    /// are atoms that hold or do `not` hold, effects are atoms that are added or (`not`) deleted, and both may stand in
    /// `forall`. An effect may also stand in `when`, whose condition consists of atoms that no action changes. PDDL ignores
    /// case, so all names are converted to lower case.
    ///
    /// # Errors
    ///
    /// [`GoalError::Text`], with file, line and column, for an unexpected or unsupported construct or an unknown name;
    /// it gives the nearest known name. [`GoalError::TooLarge`] for a text of more than 1 MiB or nested deeper than 64.
    ///
    /// ```
    /// use wisch::goal::Domain;
    /// let text = "(define (domain lamp) (:predicates (lit)) (:action switch :effect (lit)))";
    /// Domain::parse("lamp.pddl", text)?;
    /// let error = Domain::parse("lamp.pddl", &text.replace("(lit)))", "(lot)))")).unwrap_err();
    /// assert_eq!(error.to_string(), r#"lamp.pddl:1:67: unknown predicate "lot"; nearest: lit"#);
    /// # Ok::<(), wisch::goal::GoalError>(())
    /// ```
    pub fn parse(name: &str, text: &str) -> Result<Self, GoalError> {
        let source = Source { name, text };
        let form = read(source)?;
        let (_, forms) = read_definition(source, &form)?;
        let sections = group_sections(source, forms)?;
        let only = |keyword| sections.get(keyword).map_or(&[][..], |same| same[0].1);
        check_requirements(source, only(":requirements"))?;

        let mut domain = Self {
            types: Vec::new(),
            constants: Vec::new(),
            predicates: Vec::new(),
            schemas: Vec::new(),
        };
        domain.read_types(source, only(":types"))?;
        domain.constants = domain.typed(source, "constant", only(":constants"), Listed::Names)?;
        let mut predicates = Vec::new();
        for form in only(":predicates") {
            if form.list().is_none_or(<[Form]>::is_empty) {
                return Err(source.expected("a predicate `(name ?parameter - type ...)`", form));
            }
            let (name, parameters) = read_predicate(source, form)?;
            let parameters = read_typed_list(source, parameters, Listed::Variables)?;
            domain.check_types(source, &parameters)?;
            predicates.push((name, form.at));
            domain.predicates.push(Predicate {
                name: name.to_owned(),
                parameters,
            });
        }
        define_once(source, "predicate", predicates)?;
        let mut actions = Vec::new();
        for &(form, _) in sections.get(":action").into_iter().flatten() {
            let schema = domain.read_action(source, form)?;
            domain.schemas.push(schema);
            actions.push(form.at);
        }
        let names = domain.schemas.iter().map(|schema| schema.name.as_str());
        define_once(source, "action", names.zip(actions))?;
        domain.check_conditions(source)?;
        Ok(domain)
    }

    /// Rejects a condition of `when` that an action changes, because the search evaluates it once.
    fn check_conditions(&self, source: Source<'_>) -> Result<(), GoalError> {
        let effects = || self.schemas.iter().flat_map(|schema| &schema.effects);
        let changed = |name: &String| effects().any(|effect| effect.atom.words[0] == *name);
        let mut conditions = effects().flat_map(|effect| &effect.conditions);
        match conditions.find(|condition| changed(&condition.words[0])) {
            Some(condition) => {
                let what = "a condition of `when` that an action changes";
                Err(source.not_supported(condition.at, what))
            }
            None => Ok(()),
        }
    }

    fn read_types(&mut self, source: Source<'_>, forms: &[Form]) -> Result<(), GoalError> {
        self.types = read_typed_list(source, forms, Listed::Names)?;
        self.types.retain(|declared| declared.name != OBJECT);
        define_once(source, "type", names(&self.types))?;
        self.check_types(source, &self.types)?;
        for declared in &self.types {
            let mut ancestors = self.lineage(&declared.name).take(self.types.len() + 1);
            if !ancestors.any(|name| name == OBJECT) {
                let fault = format!("type {} is its own ancestor", declared.name);
                return Err(source.fault(declared.at, fault));
            }
        }
        Ok(())
    }

    /// Reads distinct names of one kind, with their types.
    fn typed(
        &self,
        source: Source<'_>,
        kind: &str,
        forms: &[Form],
        listed: Listed,
    ) -> Result<Vec<Typed>, GoalError> {
        let list = read_typed_list(source, forms, listed)?;
        define_once(source, kind, names(&list))?;
        self.check_types(source, &list)?;
        Ok(list)
    }

    fn read_action(&self, source: Source<'_>, form: &Form) -> Result<Schema, GoalError> {
        let (name, mut rest) = match form.list() {
            Some([_, name, rest @ ..]) if name.name().is_some() => {
                (name.name().unwrap_or_default(), rest)
            }
            _ => return Err(source.expected("`(:action name ...)`", form)),
        };
        let mut parts: HashMap<&str, &Form> = HashMap::new();
        while let [key, following @ ..] = rest {
            let word = key.word().unwrap_or_default();
            if ![":parameters", ":precondition", ":effect"].contains(&word) {
                let expected = "`:parameters`, `:precondition` or `:effect`";
                return Err(source.expected(expected, key));
            }
            let [value, following @ ..] = following else {
                let expected = format!("a list after `{word}`");
                return Err(source.expected_at(key.at, &expected, "nothing"));
            };
            if let Some(first) = parts.insert(word, value) {
                let what = format!("{word} of action {name}");
                return Err(duplicate_fault(source, &what, first.at, value.at));
            }
            rest = following;
        }
        let parameters = match parts.get(":parameters") {
            None => &[],
            Some(form) => {
                let list = form.list();
                list.ok_or_else(|| source.expected("a list of parameters", form))?
            }
        };
        let parameters = self.typed(source, "parameter", parameters, Listed::Variables)?;
        source.check_size("parameters of an action", parameters.len(), MAX_PARAMETERS)?;
        let preconditions = match parts.get(":precondition") {
            None => Vec::new(),
            Some(form) => read_literals(source, form)?,
        };
        let Some(effect) = parts.get(":effect") else {
            return Err(source.expected_at(form.at, "`:effect` in the action", "none"));
        };
        let effects = read_literals(source, effect)?;
        for literal in preconditions.iter().chain(&effects) {
            self.check_variables(source, &parameters, literal)?;
            let known = || {
                let own = literal.variables.iter().chain(&parameters);
                own.chain(&self.constants).map(Typed::as_pair)
            };
            for atom in literal.conditions.iter().chain([&literal.atom]) {
                self.check(source, atom.at, &atom.fact(), "constant", known)?;
            }
        }
        let conditional = preconditions.iter().find_map(|one| one.conditions.first());
        if let Some(condition) = conditional {
            return Err(source.not_supported(condition.at, "`when` in a precondition"));
        }
        Ok(Schema {
            name: name.to_owned(),
            parameters,
            preconditions,
            effects,
        })
    }

    /// Rejects more than [`MAX_VARIABLES`] variables of `forall`, and variables of an unknown type or named like a parameter.
    fn check_variables(
        &self,
        source: Source<'_>,
        parameters: &[Typed],
        literal: &Literal,
    ) -> Result<(), GoalError> {
        let variables = &literal.variables;
        source.check_size("variables of `forall`", variables.len(), MAX_VARIABLES)?;
        define_once(
            source,
            "variable",
            names(parameters).chain(names(variables)),
        )?;
        self.check_types(source, variables)
    }

    /// Rejects an atom whose predicate is not declared or does not take its arguments.
    ///
    /// - `at`: offset of the atom in the text [bytes].
    /// - `words`: the predicate, then its arguments.
    /// - `noun`: kind of an unknown name in the error, such as `constant`, if the name is no parameter.
    /// - `known`: the declared names with their types.
    pub(super) fn check<'n, I: Iterator<Item = (&'n str, &'n str)>>(
        &self,
        source: Source<'_>,
        at: usize,
        words: &[&str],
        noun: &'static str,
        known: impl Fn() -> I,
    ) -> Result<(), GoalError> {
        let parameters = self.parameters(source, at, words)?;
        for (&argument, parameter) in words[1..].iter().zip(parameters) {
            let mut types = known().filter(|(name, _)| *name == argument).peekable();
            let Some(&(_, found)) = types.peek() else {
                let is_parameter = |name: &str| name.starts_with('?');
                let alike = known().map(|(name, _)| name);
                let alike = alike.filter(|name| is_parameter(name) == is_parameter(argument));
                let kind = if is_parameter(argument) {
                    "parameter"
                } else {
                    noun
                };
                return Err(source.unknown(at, kind, argument, alike));
            };
            let expected = &parameter.type_name;
            if !types.any(|(_, found)| self.is_a(found, expected)) {
                let fault = format!("{argument} is of type {found}, not of {expected}");
                return Err(source.fault(at, fault));
            }
        }
        Ok(())
    }

    /// Returns the parameters of an atom's predicate. Rejects an unknown predicate and a wrong number of arguments.
    pub(super) fn parameters(
        &self,
        source: Source<'_>,
        at: usize,
        words: &[&str],
    ) -> Result<&[Typed], GoalError> {
        let (name, found) = (words[0], words.len() - 1);
        let Some(predicate) = self.predicates.iter().find(|p| p.name == name) else {
            let known = self.predicates.iter().map(|p| p.name.as_str());
            return Err(source.unknown(at, "predicate", name, known));
        };
        let expected = predicate.parameters.len();
        if found != expected {
            let fault = format!("predicate {name} takes {expected} arguments, found {found}");
            return Err(source.fault(at, fault));
        }
        Ok(&predicate.parameters)
    }

    /// Rejects undeclared types.
    fn check_types(&self, source: Source<'_>, list: &[Typed]) -> Result<(), GoalError> {
        let mut unknown = list.iter().filter(|typed| !self.has_type(&typed.type_name));
        unknown.next().map_or(Ok(()), |typed| {
            let known = self.types.iter().map(|t| t.name.as_str()).chain([OBJECT]);
            Err(source.unknown(typed.type_at, "type", &typed.type_name, known))
        })
    }

    fn has_type(&self, name: &str) -> bool {
        name == OBJECT || self.types.iter().any(|t| t.name == name)
    }

    /// Iterates over a type, its parent, and so on.
    fn lineage<'n>(&'n self, name: &'n str) -> impl Iterator<Item = &'n str> {
        std::iter::successors(Some(name), |&name| {
            let declared = self.types.iter().find(|t| t.name == name);
            declared.map(|t| t.type_name.as_str())
        })
    }

    /// Whether a type is `ancestor` or descends from it.
    pub(super) fn is_a(&self, name: &str, ancestor: &str) -> bool {
        self.lineage(name).any(|name| name == ancestor)
    }
}

/// Returns names with their offsets in the text [bytes].
fn names(list: &[Typed]) -> impl Iterator<Item = (&str, usize)> {
    list.iter().map(|typed| (typed.name.as_str(), typed.at))
}

/// Rejects duplicate names, and more than [`MAX_NAMES`] of them.
fn define_once<'a>(
    source: Source<'_>,
    kind: &str,
    names: impl IntoIterator<Item = (&'a str, usize)>,
) -> Result<(), GoalError> {
    let mut seen = HashMap::new();
    for (name, at) in names {
        if let Some(first) = seen.insert(name, at) {
            return Err(duplicate_fault(
                source,
                &format!("{kind} {name}"),
                first,
                at,
            ));
        }
    }
    source.check_size(&format!("number of {kind}s"), seen.len(), MAX_NAMES)
}

fn duplicate_fault(source: Source<'_>, what: &str, first: usize, at: usize) -> GoalError {
    let first = source.place(first);
    source.fault(at, format!("{what} is already defined at {first}"))
}

/// Returns name and sections of `(define (domain name) section ...)`.
fn read_definition<'f>(
    source: Source<'_>,
    form: &'f Form,
) -> Result<(&'f str, &'f [Form]), GoalError> {
    let Some(("define", [title, sections @ ..])) = form.head() else {
        return Err(source.expected("`(define (domain name) ...)`", form));
    };
    match title.head() {
        Some(("domain", [name])) if name.name().is_some() => {
            Ok((name.name().unwrap_or_default(), sections))
        }
        _ => Err(source.expected("`(domain name)`", title)),
    }
}

/// The sections of a definition with their contents, by keyword.
type Sections<'f> = HashMap<&'f str, Vec<(&'f Form, &'f [Form])>>;

/// Groups the sections of a definition by keyword. Rejects unknown, unsupported and repeated sections.
fn group_sections<'f>(source: Source<'_>, forms: &'f [Form]) -> Result<Sections<'f>, GoalError> {
    let mut sections = Sections::new();
    for form in forms {
        let Some((keyword, content)) = form.head() else {
            return Err(source.expected("a section `(:keyword ...)`", form));
        };
        if UNSUPPORTED_SECTIONS.contains(&keyword) {
            return Err(source.not_supported(form.at, &format!("`{keyword}`")));
        }
        if !SECTIONS.contains(&keyword) {
            return Err(source.unknown(form.at, "section", keyword, SECTIONS));
        }
        let same = sections.entry(keyword).or_default();
        same.push((form, content));
        if keyword != ":action" && same.len() > 1 {
            let what = format!("section {keyword}");
            return Err(duplicate_fault(source, &what, same[0].0.at, form.at));
        }
    }
    Ok(sections)
}

/// Rejects requirements that are not supported.
fn check_requirements(source: Source<'_>, forms: &[Form]) -> Result<(), GoalError> {
    for form in forms {
        match form.word() {
            Some(
                ":strips"
                | ":typing"
                | ":negative-preconditions"
                | ":universal-preconditions"
                | ":conditional-effects",
            ) => {}
            Some(other) if other.starts_with(':') => {
                return Err(source.not_supported(form.at, &format!("`{other}`")));
            }
            _ => return Err(source.expected("a requirement such as `:typing`", form)),
        }
    }
    Ok(())
}
