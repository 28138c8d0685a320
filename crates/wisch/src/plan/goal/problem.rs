//! Problems: objects, what holds at first, and the goal.

use super::domain::{Allowed, Sections, define_once, definition};
use super::form::{Source, read};
use super::syntax::{Atom, Listed, Typed, atoms, typed_list};
use super::{Domain, GoalError, Step, search};

/// A planning problem as it is written: whether its names fit a domain shows when it is solved.
#[derive(Debug, Clone)]
pub struct Problem {
    text_name: String,
    text: String,
    name: String,
    pub(super) domain: String,
    pub(super) domain_at: usize,
    pub(super) objects: Vec<Typed>,
    pub(super) init: Vec<Atom>,
    pub(super) goal: Vec<Atom>,
}

const PROBLEM_SECTIONS: [(&str, Allowed); 7] = [
    (":domain", Allowed::Once),
    (":requirements", Allowed::Once),
    (":objects", Allowed::Once),
    (":init", Allowed::Once),
    (":goal", Allowed::Once),
    (":metric", Allowed::Never),
    (":constraints", Allowed::Never),
];

impl Problem {
    /// Reads a PDDL problem: `:domain`, `:objects`, `:init` and a `:goal` of positive atoms.
    /// `name` is what errors call the text.
    ///
    /// # Errors
    ///
    /// As of [`Domain::parse`].
    ///
    /// ```
    /// use wisch::plan::Problem;
    /// let text = "(define (problem evening) (:domain lamp) (:init) (:goal (lit)))";
    /// assert_eq!(Problem::parse("evening.pddl", text)?.name(), "evening");
    /// # Ok::<(), wisch::plan::GoalError>(())
    /// ```
    pub fn parse(name: &str, text: &str) -> Result<Self, GoalError> {
        let source = Source { name, text };
        let form = read(source)?;
        let (title, sections) = definition(source, &form, "problem")?;
        let sections = Sections::sort(source, sections, &PROBLEM_SECTIONS)?;
        sections.requirements(source)?;

        let [domain] = sections.only(":domain") else {
            return Err(source.expected_at(form.at, "one `(:domain name)`", "none"));
        };
        let [goal] = sections.only(":goal") else {
            return Err(source.expected_at(form.at, "one `(:goal condition)`", "none"));
        };
        let mut init = Vec::new();
        for fact in sections.only(":init") {
            init.extend(atoms(source, fact, "`:init`")?);
        }
        let objects = typed_list(source, sections.only(":objects"), Listed::Names)?;
        define_once(
            source,
            "object",
            objects.iter().map(|o| (o.name.as_str(), o.at)),
        )?;
        Ok(Self {
            text_name: name.to_owned(),
            text: text.to_owned(),
            name: title.to_owned(),
            domain: (domain.name())
                .ok_or_else(|| source.expected("the name of a domain", domain))?
                .to_owned(),
            domain_at: domain.at,
            objects,
            init,
            goal: atoms(source, goal, "a goal")?,
        })
    }

    /// The name that the problem gives itself.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn source(&self) -> Source<'_> {
        Source {
            name: &self.text_name,
            text: &self.text,
        }
    }
}

/// Finds a shortest plan, breadth first; `None` if there is none. Of several shortest plans it is
/// the first when actions come in the order of the domain and objects in the order of the problem.
///
/// # Errors
///
/// A problem that does not fit the domain: an unknown name, a wrong number of arguments or a wrong
/// type, with file, line and column. [`GoalError::TooLarge`] beyond 100 000 states, 10 000
/// grounded actions, 20 000 facts, or a few seconds of work.
///
/// ```
/// use wisch::plan::{Domain, Problem, solve};
/// let domain = "(define (domain lamp) (:types lamp) (:predicates (lit ?l - lamp))
///   (:action switch :parameters (?l - lamp) :effect (lit ?l)))";
/// let problem = "(define (problem evening) (:domain lamp) (:objects desk door - lamp)
///   (:init (lit desk)) (:goal (and (lit desk) (lit door))))";
/// let domain = Domain::parse("lamp.pddl", domain)?;
/// let plan = solve(&domain, &Problem::parse("evening.pddl", problem)?)?.unwrap();
/// assert_eq!(plan[0].to_string(), "(switch door)");
/// assert_eq!(plan.len(), 1);
/// # Ok::<(), wisch::plan::GoalError>(())
/// ```
pub fn solve(domain: &Domain, problem: &Problem) -> Result<Option<Vec<Step>>, GoalError> {
    search::Grounded::new(domain, problem)?.shortest_plan()
}
