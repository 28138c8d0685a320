//! Domains: types, predicates and actions, with every name resolved.

use std::collections::HashMap;

use super::GoalError;
use super::form::{Form, Source, read};
use super::syntax::{Atom, Listed, Literal, Typed, atom, atoms, literals, typed_list};

/// Most types a domain may have; checking ancestry walks up through them.
const MAX_TYPES: usize = 1000;
/// Most parameters an action may have; each multiplies the ways to ground it.
const MAX_PARAMETERS: usize = 12;
/// The root of all types.
const OBJECT: TypeId = 0;

pub(super) type TypeId = usize;
pub(super) type PredicateId = usize;

/// A planning domain in typed STRIPS: types, constants, predicates and actions.
#[derive(Debug, Clone)]
pub struct Domain {
    name: String,
    types: Vec<TypeNode>,
    pub(super) constants: Vec<Constant>,
    pub(super) predicates: Vec<Predicate>,
    pub(super) schemas: Vec<Schema>,
}

#[derive(Debug, Clone)]
struct TypeNode {
    name: String,
    parent: TypeId,
}

#[derive(Debug, Clone)]
pub(super) struct Constant {
    pub(super) name: String,
    pub(super) type_id: TypeId,
}

#[derive(Debug, Clone)]
pub(super) struct Predicate {
    pub(super) name: String,
    pub(super) parameters: Vec<TypeId>,
}

/// An action with its parameters still open.
#[derive(Debug, Clone)]
pub(super) struct Schema {
    pub(super) name: String,
    pub(super) parameters: Vec<Parameter>,
    pub(super) preconditions: Vec<Pattern>,
    pub(super) add: Vec<Pattern>,
    pub(super) delete: Vec<Pattern>,
}

#[derive(Debug, Clone)]
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) type_id: TypeId,
}

/// An atom whose arguments may be parameters of an action.
#[derive(Debug, Clone)]
pub(super) struct Pattern {
    pub(super) predicate: PredicateId,
    pub(super) arguments: Vec<Term>,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Term {
    /// The parameter of that index.
    Parameter(usize),
    /// The domain's constant of that index.
    Constant(usize),
}

impl Domain {
    /// Reads a PDDL domain; `name` is what errors call the text.
    ///
    /// Typed STRIPS is understood: `:types`, `:constants`, `:predicates`, and `:action`s with
    /// positive preconditions and effects that add or (`not`) delete atoms. PDDL tells no case, so
    /// all names come out in small letters.
    ///
    /// # Errors
    ///
    /// Anything else, with file, line and column: [`GoalError::Syntax`] says what was expected,
    /// [`GoalError::NotSupported`] names the construct, [`GoalError::Unknown`] the nearest name.
    /// Texts beyond 1 MiB or nested deeper than 64 are [`GoalError::TooLarge`].
    ///
    /// ```
    /// use wisch::plan::Domain;
    /// let text = "(define (domain lamp) (:predicates (lit)) (:action switch :effect (lit)))";
    /// assert_eq!(Domain::parse("lamp.pddl", text)?.name(), "lamp");
    /// # Ok::<(), wisch::plan::GoalError>(())
    /// ```
    pub fn parse(name: &str, text: &str) -> Result<Self, GoalError> {
        let source = Source { name, text };
        let form = read(source)?;
        let (name, sections) = definition(source, &form, "domain")?;
        let sections = Sections::sort(source, sections, &DOMAIN_SECTIONS)?;
        sections.requirements(source)?;

        let mut domain = Self {
            name: name.to_owned(),
            types: vec![TypeNode {
                name: "object".to_owned(),
                parent: OBJECT,
            }],
            constants: Vec::new(),
            predicates: Vec::new(),
            schemas: Vec::new(),
        };
        domain.read_types(source, &sections)?;
        let constants = typed_list(source, sections.only(":constants"), Listed::Names)?;
        define_once(
            source,
            "constant",
            constants.iter().map(|c| (c.name.as_str(), c.at)),
        )?;
        for constant in constants {
            let type_id = domain.type_named(source, &constant)?;
            domain.constants.push(Constant {
                name: constant.name,
                type_id,
            });
        }
        domain.read_predicates(source, sections.only(":predicates"))?;
        domain.read_actions(source, &sections)?;
        Ok(domain)
    }

    /// The name that the domain gives itself.
    pub fn name(&self) -> &str {
        &self.name
    }

    fn read_types(&mut self, source: Source<'_>, sections: &Sections<'_>) -> Result<(), GoalError> {
        let declared: Vec<Typed> = typed_list(source, sections.only(":types"), Listed::Names)?
            .into_iter()
            .filter(|declared| declared.name != "object")
            .collect();
        source.check_size("number of types", declared.len(), MAX_TYPES)?;
        define_once(
            source,
            "type",
            declared.iter().map(|t| (t.name.as_str(), t.at)),
        )?;
        for declared in &declared {
            self.types.push(TypeNode {
                name: declared.name.clone(),
                parent: OBJECT,
            });
        }
        for (i, declared) in declared.iter().enumerate() {
            self.types[i + 1].parent = self.type_named(source, declared)?;
        }
        for (i, declared) in declared.iter().enumerate() {
            let ancestors = std::iter::successors(Some(i + 1), |&id| Some(self.types[id].parent));
            if !ancestors.take(self.types.len() + 1).any(|id| id == OBJECT) {
                return Err(GoalError::CyclicType {
                    at: source.place(declared.at),
                    name: declared.name.clone(),
                });
            }
        }
        Ok(())
    }

    fn read_predicates(&mut self, source: Source<'_>, forms: &[Form]) -> Result<(), GoalError> {
        let mut names = Vec::new();
        for form in forms {
            // An atom with an empty list of arguments checks the name alone.
            let Some([head, parameters @ ..]) = form.list() else {
                return Err(source.expected("a predicate `(name ?parameter - type ...)`", form));
            };
            let bare = Form {
                at: form.at,
                content: super::form::Content::List(vec![head.clone()]),
            };
            let name = atom(source, &bare)?.predicate;
            let parameters = typed_list(source, parameters, Listed::Variables)?;
            let parameters = (parameters.iter())
                .map(|parameter| self.type_named(source, parameter))
                .collect::<Result<_, _>>()?;
            names.push((name.clone(), form.at));
            self.predicates.push(Predicate { name, parameters });
        }
        define_once(
            source,
            "predicate",
            names.iter().map(|(name, at)| (name.as_str(), *at)),
        )
    }

    fn read_actions(
        &mut self,
        source: Source<'_>,
        sections: &Sections<'_>,
    ) -> Result<(), GoalError> {
        let lookup = Lookup::new(self);
        let mut schemas = Vec::new();
        let mut names = Vec::new();
        for form in sections.all(":action") {
            let schema = self.read_action(source, form, &lookup)?;
            names.push((schema.name.clone(), form.at));
            schemas.push(schema);
        }
        define_once(
            source,
            "action",
            names.iter().map(|(name, at)| (name.as_str(), *at)),
        )?;
        self.schemas = schemas;
        Ok(())
    }

    fn read_action(
        &self,
        source: Source<'_>,
        form: &Form,
        lookup: &Lookup,
    ) -> Result<Schema, GoalError> {
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
                return Err(GoalError::Duplicate {
                    at: source.place(value.at),
                    first: source.place(first.at),
                    what: format!("{word} of action {name}"),
                });
            }
            rest = following;
        }

        let parameters = match parts.get(":parameters") {
            None => Vec::new(),
            Some(form) => {
                let list = form.list();
                let list = list.ok_or_else(|| source.expected("a list of parameters", form))?;
                typed_list(source, list, Listed::Variables)?
            }
        };
        source.check_size("parameters of an action", parameters.len(), MAX_PARAMETERS)?;
        define_once(
            source,
            "parameter",
            parameters.iter().map(|p| (p.name.as_str(), p.at)),
        )?;
        let mut schema = Schema {
            name: name.to_owned(),
            parameters: (parameters.into_iter())
                .map(|parameter| {
                    Ok(Parameter {
                        type_id: self.type_named(source, &parameter)?,
                        name: parameter.name,
                    })
                })
                .collect::<Result<_, GoalError>>()?,
            preconditions: Vec::new(),
            add: Vec::new(),
            delete: Vec::new(),
        };
        if let Some(form) = parts.get(":precondition") {
            for atom in atoms(source, form, "a precondition")? {
                let pattern = self.pattern(source, &atom, &schema.parameters, lookup)?;
                schema.preconditions.push(pattern);
            }
        }
        let Some(effect) = parts.get(":effect") else {
            return Err(source.expected_at(form.at, "`:effect` in the action", "none"));
        };
        for literal in literals(source, effect)? {
            let (atom, patterns) = match &literal {
                Literal::Holds(atom) => (atom, &mut schema.add),
                Literal::HoldsNot(atom) => (atom, &mut schema.delete),
            };
            patterns.push(self.pattern(source, atom, &schema.parameters, lookup)?);
        }
        Ok(schema)
    }

    fn pattern(
        &self,
        source: Source<'_>,
        atom: &Atom,
        parameters: &[Parameter],
        lookup: &Lookup,
    ) -> Result<Pattern, GoalError> {
        let predicate = self.predicate_of(source, atom, lookup)?;
        let mut arguments = Vec::with_capacity(atom.arguments.len());
        for (argument, &expected) in
            (atom.arguments.iter()).zip(&self.predicates[predicate].parameters)
        {
            let (term, found) = if argument.starts_with('?') {
                let position = parameters.iter().position(|p| p.name == *argument);
                let position = position.ok_or_else(|| {
                    let known = parameters.iter().map(|p| p.name.as_str());
                    source.unknown(atom.at, "parameter", argument, known)
                })?;
                (Term::Parameter(position), parameters[position].type_id)
            } else {
                let &position = lookup.constants.get(argument).ok_or_else(|| {
                    let known = self.constants.iter().map(|c| c.name.as_str());
                    source.unknown(atom.at, "constant", argument, known)
                })?;
                (Term::Constant(position), self.constants[position].type_id)
            };
            self.check_type(source, atom.at, argument, found, expected)?;
            arguments.push(term);
        }
        Ok(Pattern {
            predicate,
            arguments,
        })
    }

    /// The predicate that an atom names, taking as many arguments as the atom has.
    pub(super) fn predicate_of(
        &self,
        source: Source<'_>,
        atom: &Atom,
        lookup: &Lookup,
    ) -> Result<PredicateId, GoalError> {
        let &id = lookup.predicates.get(&atom.predicate).ok_or_else(|| {
            let known = self.predicates.iter().map(|p| p.name.as_str());
            source.unknown(atom.at, "predicate", &atom.predicate, known)
        })?;
        let expected = self.predicates[id].parameters.len();
        if atom.arguments.len() != expected {
            return Err(GoalError::Arity {
                at: source.place(atom.at),
                predicate: atom.predicate.clone(),
                expected,
                found: atom.arguments.len(),
            });
        }
        Ok(id)
    }

    pub(super) fn check_type(
        &self,
        source: Source<'_>,
        at: usize,
        argument: &str,
        found: TypeId,
        expected: TypeId,
    ) -> Result<(), GoalError> {
        if self.is_a(found, expected) {
            return Ok(());
        }
        Err(GoalError::TypeMismatch {
            at: source.place(at),
            argument: argument.to_owned(),
            found: self.type_name(found).to_owned(),
            expected: self.type_name(expected).to_owned(),
        })
    }

    pub(super) fn type_named(
        &self,
        source: Source<'_>,
        typed: &Typed,
    ) -> Result<TypeId, GoalError> {
        let position = self.types.iter().position(|t| t.name == typed.type_name);
        position.ok_or_else(|| {
            let known = self.types.iter().map(|t| t.name.as_str());
            source.unknown(typed.type_at, "type", &typed.type_name, known)
        })
    }

    pub(super) fn type_name(&self, id: TypeId) -> &str {
        &self.types[id].name
    }

    /// Whether a type is another or descends from it.
    pub(super) fn is_a(&self, mut id: TypeId, ancestor: TypeId) -> bool {
        while id != ancestor {
            if id == OBJECT {
                return false;
            }
            id = self.types[id].parent;
        }
        true
    }
}

/// Predicates and constants by name.
pub(super) struct Lookup {
    pub(super) predicates: HashMap<String, PredicateId>,
    pub(super) constants: HashMap<String, usize>,
}

impl Lookup {
    pub(super) fn new(domain: &Domain) -> Self {
        let predicates = domain.predicates.iter().map(|p| p.name.clone());
        let constants = domain.constants.iter().map(|c| c.name.clone());
        Self {
            predicates: predicates.zip(0..).collect(),
            constants: constants.zip(0..).collect(),
        }
    }
}

/// Refuses names that come twice.
pub(super) fn define_once<'a>(
    source: Source<'_>,
    kind: &str,
    names: impl Iterator<Item = (&'a str, usize)>,
) -> Result<(), GoalError> {
    let mut seen = HashMap::new();
    for (name, at) in names {
        if let Some(first) = seen.insert(name, at) {
            return Err(GoalError::Duplicate {
                at: source.place(at),
                first: source.place(first),
                what: format!("{kind} {name}"),
            });
        }
    }
    Ok(())
}

/// Takes `(define (kind name) section ...)` apart.
pub(super) fn definition<'f>(
    source: Source<'_>,
    form: &'f Form,
    kind: &str,
) -> Result<(&'f str, &'f [Form]), GoalError> {
    let expected = format!("`(define ({kind} name) ...)`");
    let Some(("define", [title, sections @ ..])) = form.head() else {
        return Err(source.expected(&expected, form));
    };
    match title.head() {
        Some((head, [name])) if head == kind && name.name().is_some() => {
            Ok((name.name().unwrap_or_default(), sections))
        }
        _ => Err(source.expected(&format!("`({kind} name)`"), title)),
    }
}

/// A kind of section: whether there may be several, or it is beyond what is supported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Allowed {
    Once,
    Often,
    Never,
}

const DOMAIN_SECTIONS: [(&str, Allowed); 11] = [
    (":requirements", Allowed::Once),
    (":types", Allowed::Once),
    (":constants", Allowed::Once),
    (":predicates", Allowed::Once),
    (":action", Allowed::Often),
    (":functions", Allowed::Never),
    (":durative-action", Allowed::Never),
    (":derived", Allowed::Never),
    (":constraints", Allowed::Never),
    (":process", Allowed::Never),
    (":event", Allowed::Never),
];

/// The sections of a definition by keyword, in the order of the text.
pub(super) struct Sections<'f>(HashMap<&'f str, Vec<&'f Form>>);

impl<'f> Sections<'f> {
    pub(super) fn sort(
        source: Source<'_>,
        forms: &'f [Form],
        allowed: &[(&str, Allowed)],
    ) -> Result<Self, GoalError> {
        let mut sections: HashMap<&str, Vec<&Form>> = HashMap::new();
        for form in forms {
            let Some((keyword, _)) = form.head() else {
                return Err(source.expected("a section `(:keyword ...)`", form));
            };
            let same = sections.entry(keyword).or_default();
            match allowed.iter().find(|(known, _)| *known == keyword) {
                None => {
                    let known = (allowed.iter())
                        .filter(|(_, allowed)| *allowed != Allowed::Never)
                        .map(|(known, _)| *known);
                    return Err(source.unknown(form.at, "section", keyword, known));
                }
                Some((_, Allowed::Never)) => {
                    return Err(source.not_supported(form.at, &format!("`{keyword}`")));
                }
                Some((_, Allowed::Once)) if !same.is_empty() => {
                    return Err(GoalError::Duplicate {
                        at: source.place(form.at),
                        first: source.place(same[0].at),
                        what: format!("section {keyword}"),
                    });
                }
                Some(_) => same.push(form),
            }
        }
        Ok(Self(sections))
    }

    /// All sections of that keyword.
    pub(super) fn all(&self, keyword: &str) -> &[&'f Form] {
        self.0.get(keyword).map_or(&[], Vec::as_slice)
    }

    /// What stands in the section of that keyword; nothing if there is no such section.
    pub(super) fn only(&self, keyword: &str) -> &'f [Form] {
        match self.all(keyword) {
            [form, ..] => form.head().map_or(&[], |(_, rest)| rest),
            [] => &[],
        }
    }

    /// Refuses requirements that would not be honoured.
    pub(super) fn requirements(&self, source: Source<'_>) -> Result<(), GoalError> {
        for form in self.only(":requirements") {
            match form.word() {
                Some(":strips" | ":typing") => {}
                Some(other) if other.starts_with(':') => {
                    return Err(source.not_supported(form.at, &format!("`{other}`")));
                }
                _ => return Err(source.expected("a requirement such as `:typing`", form)),
            }
        }
        Ok(())
    }
}
