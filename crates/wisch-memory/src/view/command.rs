//! Commands of a query that show something.

use super::ViewError;
use super::colour::Colour;
use super::plot::Plot;
use crate::ask::Term;

/// The thing that a query wants to show.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewSubject {
    /// A thing at its pose, by its name, for example `semco:sponge`.
    Thing(String),
    /// The trajectory of a thing.
    Trajectory(String),
    /// The particles on a surface, by any name of the scene.
    Particles(String),
}

/// Time of a view [s since 1970].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ViewTime {
    /// The end of the latest episode.
    Latest,
    /// At a time.
    At(f64),
    /// Over an interval, at a default number of times.
    During([f64; 2]),
    /// Over an interval, with a period \[s\].
    Every([f64; 2], f64),
}

/// How strongly a thing stands out in a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Emphasis {
    /// Normal.
    Plain,
    /// Highlighted.
    Strong,
}

/// A subject with its time and style.
#[derive(Debug, Clone, PartialEq)]
pub struct ViewRequest {
    /// Subject.
    pub subject: ViewSubject,
    /// Time.
    pub when: ViewTime,
    /// Emphasis.
    pub emphasis: Emphasis,
    /// Colour, if the query states one.
    pub colour: Option<Colour>,
}

/// A command by which a query shows things or plots data.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewCommand {
    /// Shows these subjects.
    Show(Vec<ViewRequest>),
    /// Draws this diagram.
    Plot(Plot),
}

impl ViewCommand {
    /// Parses the term that a query's `show`, `highlight` or `data_vis` produced.
    ///
    /// # Errors
    /// If the term is not a complete command.
    ///
    /// ```
    /// use wisch_memory::ask::Term;
    /// use wisch_memory::view::{ViewCommand, ViewSubject, ViewTime};
    ///
    /// let term = Term::parse("show(trajectory('semco:sponge'),interval(10,12,dt(0.5)))")?;
    /// let ViewCommand::Show(wishes) = ViewCommand::from_term(&term)? else { panic!() };
    /// assert_eq!(wishes[0].subject, ViewSubject::Trajectory("semco:sponge".to_owned()));
    /// assert_eq!(wishes[0].when, ViewTime::Every([10.0, 12.0], 0.5));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_term(term: &Term) -> Result<Self, ViewError> {
        let plain = Emphasis::Plain;
        let strong = Emphasis::Strong;
        match term.parts() {
            // The page always shows the scene, so this command adds nothing.
            Some(("show", [])) => Ok(Self::Show(Vec::new())),
            Some(("show", [what])) => parse_shown(what, ViewTime::Latest, plain, None),
            Some(("show", [what, how])) => parse_shown(what, when(how)?, plain, None),
            Some(("show", [what, how, style])) => {
                parse_shown(what, when(how)?, plain, Some(Colour::from_term(style)?))
            }
            Some(("highlight", [what])) => parse_shown(what, ViewTime::Latest, strong, None),
            Some(("highlight", [what, style])) => parse_shown(
                what,
                ViewTime::Latest,
                strong,
                Some(Colour::from_term(style)?),
            ),
            Some(("highlight", [what, how, style])) => {
                parse_shown(what, when(how)?, strong, Some(Colour::from_term(style)?))
            }
            Some(("data_vis", [diagram, properties])) => {
                Ok(Self::Plot(Plot::from_terms(diagram, properties)?))
            }
            _ => Err(ViewError::ViewCommand {
                found: term.to_string(),
            }),
        }
    }
}

fn parse_shown(
    what: &Term,
    when: ViewTime,
    emphasis: Emphasis,
    colour: Option<Colour>,
) -> Result<ViewCommand, ViewError> {
    let subjects = subjects(what)?.into_iter();
    let wishes = subjects.map(|subject| ViewRequest {
        subject,
        when,
        emphasis,
        colour,
    });
    Ok(ViewCommand::Show(wishes.collect()))
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

fn when(how: &Term) -> Result<ViewTime, ViewError> {
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
            [from, to] => Ok(ViewTime::During(span(from, to)?)),
            _ => Err(refused()),
        };
    }
    match how.parts() {
        Some(("interval", [from, to])) => Ok(ViewTime::During(span(from, to)?)),
        Some(("interval", [from, to, step])) => match step.parts() {
            Some(("dt", [period])) => match time(period) {
                Some(period) if period > 0.0 => Ok(ViewTime::Every(span(from, to)?, period)),
                _ => Err(refused()),
            },
            _ => Err(refused()),
        },
        _ => time(how).map(ViewTime::At).ok_or_else(refused),
    }
}
