//! Views: what a query shows, as plain data for any renderer.
//!
//! A [`ViewCommand`] is a request by a query; a [`View`] holds the data that the memory has for it.

mod colour;
mod command;
mod gather;
mod json;
mod plot;
mod posed;
#[cfg(test)]
mod tests;
mod titles;

pub use colour::Colour;
pub use command::{Emphasis, ViewCommand, ViewRequest, ViewSubject, ViewTime};
pub use gather::{MAX_POSES, gather};
pub use json::answers_json;
pub use plot::{Diagram, Plot, PlotData};

use crate::ask::Term;
use crate::frames::FrameError;
use crate::store::MemoryError;
use wisch::geometry::{Point2, Point3, Pose};

/// The reason why a query's view cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum ViewError {
    /// The term is not a command.
    #[error("{found} cannot be drawn")]
    ViewCommand {
        /// The term.
        found: String,
    },
    /// The term is not a subject.
    #[error("{found} is not a thing, trajectory(Thing), particles(Thing) or list of these")]
    ViewSubject {
        /// The term.
        found: String,
    },
    /// The term is not a time.
    #[error("{found} is not a time, interval(Start, End) or interval(Start, End, dt(Seconds))")]
    When {
        /// The term.
        found: String,
    },
    /// The term is not a colour.
    #[error("{found} is not a color{hint}")]
    Colour {
        /// The term.
        found: String,
        /// A correction.
        hint: String,
    },
    /// A diagram has no data.
    #[error("{diagram}: data is missing; expected data: [Xs, Ys]")]
    NoData {
        /// Kind of the diagram.
        diagram: &'static str,
    },
    /// The lists of a diagram have different lengths.
    #[error("{diagram}: data has {xs} Xs, but {ys} Ys")]
    Lengths {
        /// Kind of the diagram.
        diagram: &'static str,
        /// Length of the first list.
        xs: usize,
        /// Length of the second list.
        ys: usize,
    },
    /// An entry of a diagram has the wrong type.
    #[error("{diagram}: {place}: {found} is not {expected}")]
    Data {
        /// Kind of the diagram.
        diagram: &'static str,
        /// Position of the entry.
        place: String,
        /// The term.
        found: String,
        /// The expected type.
        expected: &'static str,
    },
    /// A diagram has too many entries.
    #[error("{diagram}: {count} entries exceed the limit of {limit}")]
    TooMany {
        /// Kind of the diagram.
        diagram: &'static str,
        /// Number of entries.
        count: usize,
        /// Largest number of entries.
        limit: usize,
    },
    /// A view has too many poses.
    #[error("{thing}: {count} poses exceed the limit of {limit}; ask for fewer times")]
    TooManyPoses {
        /// Name of the thing.
        thing: String,
        /// Number of poses.
        count: usize,
        /// Largest number of poses.
        limit: usize,
    },
    /// Nothing was recorded in this interval.
    #[error("{thing}: nothing was recorded between {from} and {to} s")]
    NoRecord {
        /// Name of the thing.
        thing: String,
        /// Start of the interval [s since 1970].
        from: f64,
        /// End of the interval [s since 1970].
        to: f64,
    },
    /// Particles cannot be read.
    #[error("{file}: {what}")]
    Particles {
        /// Name of the file.
        file: String,
        /// Description of the fault.
        what: String,
    },
    /// Error of the frames.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// Error of the memory.
    #[error(transparent)]
    Memory(#[from] MemoryError),
}

/// The data of a view: episodes, bodies, tracks, particles and diagrams.
#[derive(Debug, Clone, Default)]
pub struct View {
    /// Its episodes, in the order of their first mention.
    pub episodes: Vec<ShownEpisode>,
    /// Rounds that are shown in space.
    pub rounds: Vec<ShownRound>,
    /// Things at times.
    pub bodies: Vec<ShownBody>,
    /// Trajectories.
    pub tracks: Vec<Track>,
    /// Particles.
    pub particles: Vec<ShownDirt>,
    /// Diagrams.
    pub plots: Vec<Plot>,
    /// Number of things that are left out because of the limits.
    pub left_out: usize,
    /// Remarks on what cannot be shown because the memory lacks it.
    pub remarks: Vec<String>,
}

/// An episode of which a view shows parts.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownEpisode {
    /// Name of the episode.
    pub id: String,
    /// Name of the task.
    pub task: String,
    /// Begin and end [s since 1970].
    pub interval: [f64; 2],
    /// Individuals with a time, in the order of the record.
    pub occurrences: Vec<Occurrence>,
    /// Intervals that the view shows [s since 1970].
    pub shown: Vec<[f64; 2]>,
}

/// An action or event of an episode.
#[derive(Debug, Clone, PartialEq)]
pub struct Occurrence {
    /// Its name, without prefix.
    pub name: String,
    /// Its class, without prefix.
    pub class: String,
    /// Whether something collided with the robot.
    pub is_collision: bool,
    /// Begin and end [s since 1970].
    pub interval: [f64; 2],
}

/// A round of which a view shows parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShownRound {
    /// Index of its episode in [`View::episodes`].
    pub episode: usize,
    /// Its number, from 1.
    pub number: usize,
}

/// A thing with its pose at one time.
#[derive(Debug, Clone)]
pub struct ShownBody {
    /// Its name.
    pub thing: String,
    /// Kind of the thing.
    pub figure: Figure,
    /// Pose of its frame in the world.
    pub world_from_frame: Pose,
    /// Index of its round in [`View::rounds`].
    pub round: usize,
    /// Time [s since 1970].
    pub time: f64,
    /// Emphasis.
    pub emphasis: Emphasis,
    /// Colour, if the query states one.
    pub colour: Option<Colour>,
}

/// The kind of a thing in a view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// A whole robot, with its tool.
    Robot,
    /// The tool.
    Tool,
    /// The surface.
    Surface,
    /// A frame without a known shape.
    Frame,
}

/// The trajectory of a thing over an interval.
#[derive(Debug, Clone)]
pub struct Track {
    /// Its name.
    pub thing: String,
    /// Index of its round in [`View::rounds`].
    pub round: usize,
    /// Begin and end [s since 1970].
    pub interval: [f64; 2],
    /// Path in the world \[m\].
    pub path: Vec<Point3>,
    /// Times [s since 1970] and points that the query asked for; otherwise empty.
    pub samples: Vec<(f64, Point3)>,
    /// Emphasis.
    pub emphasis: Emphasis,
    /// Colour, if the query states one.
    pub colour: Option<Colour>,
}

/// The believed particles on a surface at one time.
#[derive(Debug, Clone)]
pub struct ShownDirt {
    /// Index of its round in [`View::rounds`].
    pub round: usize,
    /// Whether before or after the round.
    pub state: DirtState,
    /// Positions in the surface frame \[m\].
    pub positions: Vec<Point2>,
    /// Colour, if the query states one.
    pub colour: Option<Colour>,
}

/// The time to which a particle distribution belongs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DirtState {
    /// Before the round.
    Before,
    /// After the round, as estimated.
    Estimated,
}

/// Returns a term as text: names without quotes, lists of characters as words.
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
