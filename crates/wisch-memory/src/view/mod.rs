//! What a query wants to be looked at, as plain data for whatever draws it.
//!
//! [`ViewCommand`]s are what the query says; a [`View`] is what the memory has to show for them.

mod colour;
mod command;
mod gather;
mod plot;
mod posed;
#[cfg(test)]
mod tests;

pub use colour::Colour;
pub use command::{Emphasis, ViewCommand, ViewSubject, When, Wish};
pub use gather::{MAX_POSES, Surroundings, gather};
pub use plot::{Diagram, Plot, PlotData};

use crate::ask::Term;
use crate::frames::FrameError;
use crate::store::MemoryError;
use wisch::geometry::{Mesh, Point2, Point3, Polygon, Pose};
use wisch::robot::Shape;

/// Why something cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum ViewError {
    /// No command to show anything.
    #[error("{found} cannot be drawn")]
    ViewCommand {
        /// What stands there.
        found: String,
    },
    /// Nothing that can be shown.
    #[error("{found} is no thing, trajectory(Thing), particles(Thing) or list of these")]
    ViewSubject {
        /// What stands there.
        found: String,
    },
    /// No time.
    #[error("{found} is no time, interval(Start, End) or interval(Start, End, dt(Seconds))")]
    When {
        /// What stands there.
        found: String,
    },
    /// No colour.
    #[error("{found} is no color{hint}")]
    Colour {
        /// What stands there.
        found: String,
        /// What to write instead.
        hint: String,
    },
    /// A diagram without data.
    #[error("{diagram}: data is missing: data: [Xs, Ys]")]
    NoData {
        /// Its kind.
        diagram: &'static str,
    },
    /// Lists that do not belong together.
    #[error("{diagram}: data has {xs} Xs, but {ys} Ys")]
    Lengths {
        /// The diagram's kind.
        diagram: &'static str,
        /// Length of the first.
        xs: usize,
        /// Length of the second.
        ys: usize,
    },
    /// Data of the wrong kind.
    #[error("{diagram}: {place}: {found} is not {expected}")]
    Data {
        /// The diagram's kind.
        diagram: &'static str,
        /// Where.
        place: String,
        /// What stands there.
        found: String,
        /// What should.
        expected: &'static str,
    },
    /// More than can be looked at.
    #[error("{diagram}: {count} entries are more than the limit of {limit}")]
    TooMany {
        /// The diagram's kind.
        diagram: &'static str,
        /// How many.
        count: usize,
        /// How many may be.
        limit: usize,
    },
    /// More poses than can be looked at.
    #[error("{thing}: {count} poses are more than the limit of {limit}: ask for fewer times")]
    TooManyPoses {
        /// Of what.
        thing: String,
        /// How many.
        count: usize,
        /// How many may be.
        limit: usize,
    },
    /// Nothing was recorded then.
    #[error("{thing}: nothing was recorded between {from} and {to} s")]
    NoRecord {
        /// Of what.
        thing: String,
        /// From when [s since 1970].
        from: f64,
        /// To when [s since 1970].
        to: f64,
    },
    /// Particles that cannot be read.
    #[error("{file}: {what}")]
    Particles {
        /// The file.
        file: String,
        /// What is wrong.
        what: String,
    },
    /// What the frames say.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// What the memory says.
    #[error(transparent)]
    Memory(#[from] MemoryError),
}

/// What is to be seen.
#[derive(Debug, Clone, Default)]
pub struct View {
    /// The episodes that it is about, in the order in which they came up.
    pub episodes: Vec<ShownEpisode>,
    /// Their rounds of which something is shown in space.
    pub rounds: Vec<ShownRound>,
    /// Things at certain times.
    pub bodies: Vec<ShownBody>,
    /// Ways.
    pub tracks: Vec<Track>,
    /// Particles.
    pub particles: Vec<ShownDirt>,
    /// Diagrams.
    pub plots: Vec<Plot>,
    /// How many of the things that were to be shown are not, because there are too many of them.
    pub left_out: usize,
    /// What was to be shown and is not, because the memory does not have it.
    pub remarks: Vec<String>,
}

/// An episode that something is shown of.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownEpisode {
    /// Its name.
    pub id: String,
    /// Its task's.
    pub task: String,
    /// From when to when [s since 1970].
    pub interval: [f64; 2],
    /// What happened, in the order of its record.
    pub occurrences: Vec<Occurrence>,
    /// Times that are looked at [s since 1970].
    pub looked: Vec<[f64; 2]>,
}

/// Something that happened.
#[derive(Debug, Clone, PartialEq)]
pub struct Occurrence {
    /// Its name, without prefix.
    pub name: String,
    /// Its class, without prefix.
    pub class: String,
    /// Whether something struck the robot.
    pub is_collision: bool,
    /// From when to when [s since 1970].
    pub interval: [f64; 2],
}

/// A round that something is shown of.
#[derive(Debug, Clone)]
pub struct ShownRound {
    /// Place of its episode among those shown.
    pub episode: usize,
    /// Its number, from 1.
    pub number: usize,
    /// Where the surface was believed to be.
    pub world_from_surface: Pose,
    /// The tool centre point's way through all of it, in the world [m].
    pub tool_path: Vec<Point3>,
    /// Names of robot, tool and surface.
    pub names: [String; 3],
    /// The surface's outline, in its own frame, if the task is known.
    pub outline: Option<Polygon>,
    /// The tool's mesh, in its own frame, if the task is known.
    pub tool_mesh: Option<Mesh>,
    /// What else stands there: its pose in the world, and its mesh.
    pub objects: Vec<(Pose, Mesh)>,
}

/// A thing at a time.
#[derive(Debug, Clone)]
pub struct ShownBody {
    /// Its name.
    pub thing: String,
    /// What of it is to be seen.
    pub figure: Figure,
    /// Place of its round among those shown.
    pub round: usize,
    /// When [s since 1970].
    pub time: f64,
    /// How it is to be drawn.
    pub emphasis: Emphasis,
    /// In which colour, if the query says so.
    pub colour: Option<Colour>,
}

/// What of a thing is to be seen.
#[derive(Debug, Clone)]
pub enum Figure {
    /// All of a robot, with its tool.
    Robot {
        /// Its solids.
        parts: Vec<ShownPart>,
        /// Where it holds the tool.
        world_from_tool: Pose,
    },
    /// The tool.
    Tool(Pose),
    /// The surface.
    Surface(Pose),
    /// A frame of which no more is known than where it is.
    Frame(Pose),
}

/// A solid of a robot.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownPart {
    /// Its link.
    pub link: String,
    /// Where it is.
    pub world_from_shape: Pose,
    /// What it is.
    pub shape: Shape,
}

/// The way of a thing.
#[derive(Debug, Clone)]
pub struct Track {
    /// Its name.
    pub thing: String,
    /// Place of its round among those shown.
    pub round: usize,
    /// From when to when [s since 1970].
    pub interval: [f64; 2],
    /// The way, in the world [m].
    pub path: Vec<Point3>,
    /// When [s since 1970] and where it was sampled, as the query asked; empty if it did not.
    pub samples: Vec<(f64, Point3)>,
    /// How it is to be drawn.
    pub emphasis: Emphasis,
    /// In which colour, if the query says so.
    pub colour: Option<Colour>,
}

/// Particles on a surface, as they were believed to lie.
#[derive(Debug, Clone)]
pub struct ShownDirt {
    /// Place of its round among those shown.
    pub round: usize,
    /// Before or after that round.
    pub state: DirtState,
    /// Where, in the surface frame [m].
    pub positions: Vec<Point2>,
    /// In which colour, if the query says so.
    pub colour: Option<Colour>,
}

/// When particles lay so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DirtState {
    /// Before the round.
    Before,
    /// After it, as it was felt.
    Estimated,
}

/// A term as text: names without quotes, lists of characters as the word they make.
fn text_of(term: &Term) -> String {
    match term {
        Term::Atom(name) => name.clone(),
        Term::List(items) => {
            let letters = items.iter().map(|item| {
                let mut letters = item.as_atom()?.chars();
                letters.next().filter(|_| letters.next().is_none())
            });
            letters
                .collect::<Option<String>>()
                .unwrap_or_else(|| term.to_string())
        }
        Term::Compound(colon, parts) if colon == ":" && parts.len() == 2 => {
            format!("{}:{}", text_of(&parts[0]), text_of(&parts[1]))
        }
        other => other.to_string(),
    }
}
