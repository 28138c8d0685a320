//! What the engine says is to be looked at, as it is meant.

use super::ViewError;
use super::colour::Colour;
use super::plot::Plot;
use crate::ask::Term;

/// What is to be looked at.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewSubject {
    /// A thing where it is, by its name such as `semco:sponge`.
    Thing(String),
    /// The way of a thing.
    Trajectory(String),
    /// What lies on a surface, by any name of the scene.
    Particles(String),
}

/// When it is to be looked at; times in seconds since 1970.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// At the end of the latest episode.
    Latest,
    /// At a time.
    At(f64),
    /// From a time to another, as often as seems fit.
    During([f64; 2]),
    /// From a time to another, every so many seconds.
    Every([f64; 2], f64),
}

/// How it is to be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Emphasis {
    /// As it is.
    Plain,
    /// So that it stands out.
    Strong,
}

/// One thing to be looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Wish {
    /// What.
    pub subject: ViewSubject,
    /// When.
    pub when: When,
    /// How.
    pub emphasis: Emphasis,
    /// In which colour, if the query says so.
    pub colour: Option<Colour>,
}

/// A command of a query.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewCommand {
    /// To look at these.
    Look(Vec<Wish>),
    /// To draw this.
    Plot(Plot),
}

impl ViewCommand {
    /// From what a query's `show`, `highlight` or `data_vis` came to.
    ///
    /// # Errors
    /// What is no such command, or not complete.
    ///
    /// ```
    /// use wisch_memory::ask::Term;
    /// use wisch_memory::view::{ViewCommand, ViewSubject, When};
    ///
    /// let term = Term::parse("show(trajectory('semco:sponge'),interval(10,12,dt(0.5)))")?;
    /// let ViewCommand::Look(wishes) = ViewCommand::of(&term)? else { panic!() };
    /// assert_eq!(wishes[0].subject, ViewSubject::Trajectory("semco:sponge".to_owned()));
    /// assert_eq!(wishes[0].when, When::Every([10.0, 12.0], 0.5));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(term: &Term) -> Result<Self, ViewError> {
        let plain = Emphasis::Plain;
        let strong = Emphasis::Strong;
        match term.parts() {
            // The page always shows what there is: to be told so adds nothing.
            Some(("show", [])) => Ok(Self::Look(Vec::new())),
            Some(("show", [what])) => look(what, When::Latest, plain, None),
            Some(("show", [what, how])) => look(what, when(how)?, plain, None),
            Some(("show", [what, how, style])) => {
                look(what, when(how)?, plain, Some(Colour::of(style)?))
            }
            Some(("highlight", [what])) => look(what, When::Latest, strong, None),
            Some(("highlight", [what, style])) => {
                look(what, When::Latest, strong, Some(Colour::of(style)?))
            }
            Some(("highlight", [what, how, style])) => {
                look(what, when(how)?, strong, Some(Colour::of(style)?))
            }
            Some(("data_vis", [diagram, properties])) => {
                Ok(Self::Plot(Plot::of(diagram, properties)?))
            }
            _ => Err(ViewError::ViewCommand {
                found: term.to_string(),
            }),
        }
    }
}

fn look(
    what: &Term,
    when: When,
    emphasis: Emphasis,
    colour: Option<Colour>,
) -> Result<ViewCommand, ViewError> {
    let subjects = subjects(what)?.into_iter();
    let wishes = subjects.map(|subject| Wish {
        subject,
        when,
        emphasis,
        colour,
    });
    Ok(ViewCommand::Look(wishes.collect()))
}

fn subjects(what: &Term) -> Result<Vec<ViewSubject>, ViewError> {
    let refused = || ViewError::ViewSubject {
        found: what.to_string(),
    };
    match what {
        Term::List(items) => {
            let nested: Result<Vec<_>, _> = items.iter().map(subjects).collect();
            Ok(nested?.into_iter().flatten().collect())
        }
        Term::Atom(name) => Ok(vec![ViewSubject::Thing(name.clone())]),
        Term::Compound(kind, parts) => {
            let [of] = parts.as_slice() else {
                return Err(refused());
            };
            let subject = match kind.as_str() {
                "trajectory" => ViewSubject::Trajectory,
                "particles" => ViewSubject::Particles,
                _ => return Err(refused()),
            };
            let named = subjects(of)?.into_iter().map(|inner| match inner {
                ViewSubject::Thing(name) => Ok(subject(name)),
                _ => Err(refused()),
            });
            named.collect()
        }
        _ => Err(refused()),
    }
}

fn when(how: &Term) -> Result<When, ViewError> {
    let refused = || ViewError::When {
        found: how.to_string(),
    };
    let time = |term: &Term| term.as_number().filter(|time| time.is_finite());
    let span = |from: &Term, to: &Term| match (time(from), time(to)) {
        (Some(from), Some(to)) if from <= to => Ok([from, to]),
        _ => Err(refused()),
    };
    if let Term::List(ends) = how {
        return match ends.as_slice() {
            [from, to] => Ok(When::During(span(from, to)?)),
            _ => Err(refused()),
        };
    }
    match how.parts() {
        Some(("interval", [from, to])) => Ok(When::During(span(from, to)?)),
        Some(("interval", [from, to, step])) => match step.parts() {
            Some(("dt", [period])) => match time(period) {
                Some(period) if period > 0.0 => Ok(When::Every(span(from, to)?, period)),
                _ => Err(refused()),
            },
            _ => Err(refused()),
        },
        _ => time(how).map(When::At).ok_or_else(refused),
    }
}
