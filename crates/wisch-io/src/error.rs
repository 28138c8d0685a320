//! Why files are refused.

use crate::knowledge::KnowledgeFileError;
use crate::task_file::TaskError;
use std::path::{Path, PathBuf};
use wisch::goal::GoalError;
use wisch::represent::Action;
use wisch::robot::{MapError, RobotError};
use wisch::source_location::UnknownName;

/// Why a file, or what it refers to, cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that is not there.
    #[error("{}: there is no such file", path.display())]
    NoSuchFile {
        /// Its path.
        path: PathBuf,
        /// The name in the same folder, or of a shipped scenario, that is nearest to it, if one is near.
        nearest: Option<String>,
    },
    /// A file or folder that cannot be read.
    #[error("{}: {problem}", path.display())]
    Unusable {
        /// Its path.
        path: PathBuf,
        /// Why.
        problem: String,
    },
    /// A file that is to be text and is not.
    #[error("{}:{line}: byte {byte} is not UTF-8 text", path.display())]
    NotText {
        /// Its path.
        path: PathBuf,
        /// Line, counted from 1.
        line: usize,
        /// Index of the first byte that is no text.
        byte: usize,
    },
    /// A knowledge folder without knowledge.
    #[error("{}: the folder holds no .toml file", folder.display())]
    NoKnowledge {
        /// The folder.
        folder: PathBuf,
    },
    /// A file of the knowledge folder that cannot be had.
    #[error("{0}")]
    Asset(String),
    /// A knowledge file that is refused.
    #[error(transparent)]
    Knowledge(Box<KnowledgeFileError>),
    /// A PDDL domain that is refused.
    #[error(transparent)]
    Domain(Box<GoalError>),
    /// A task file that is refused.
    #[error(transparent)]
    Task(Box<TaskError>),
    /// A goal that leads to no action.
    #[error("{file}: goal {literal:?}: {error}")]
    Goal {
        /// The task file.
        file: String,
        /// The goal as typed.
        literal: String,
        /// Why.
        #[source]
        error: Box<GoalError>,
    },
    /// An action that was asked for and does not reach the goal.
    #[error("{file}: --action {asked} contradicts the goal {literal}, which takes {needed}")]
    Contradiction {
        /// The task file.
        file: String,
        /// The action that was asked for.
        asked: Action,
        /// The goal as typed.
        literal: String,
        /// The action that reaches it.
        needed: Action,
    },
    /// A coverage strategy that does not exist.
    #[error("{file}: {unknown}")]
    Strategy {
        /// The task file.
        file: String,
        /// Its name and those near it.
        unknown: UnknownName,
    },
    /// A robot that is not shipped.
    #[error("{0}")]
    UnknownRobot(UnknownName),
    /// A URDF of the user's that is refused.
    #[error("{error}")]
    Urdf {
        /// The file.
        file: String,
        /// Why.
        #[source]
        error: Box<RobotError>,
    },
    /// A shipped robot or an SRDF that is refused.
    #[error(transparent)]
    Robot(Box<RobotError>),
    /// A capability map that is refused.
    #[error(transparent)]
    Map(Box<MapError>),
    /// A place where results cannot be written.
    #[error("{}: {problem}", path.display())]
    Output {
        /// The place.
        path: PathBuf,
        /// Why.
        problem: String,
        /// What can be done about it.
        help: &'static str,
    },
}

macro_rules! boxed {
    ($($variant:ident($error:ty)),*) => {
        $(impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Self::$variant(Box::new(error))
            }
        })*
    };
}

boxed!(
    Knowledge(KnowledgeFileError),
    Domain(GoalError),
    Task(TaskError),
    Robot(RobotError),
    Map(MapError)
);

impl Error {
    pub(crate) fn unusable(path: &Path, problem: impl ToString) -> Self {
        Self::Unusable {
            path: path.to_owned(),
            problem: problem.to_string(),
        }
    }

    /// What can be done about it, where that is known.
    pub fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoSuchFile { path, nearest } => match nearest {
                Some(nearest) => format!("did you mean {nearest}?"),
                None if path.extension().is_none() => {
                    "wisch scenarios lists the names of those that are shipped".to_owned()
                }
                None => return None,
            },
            Self::NotText { .. } => "save the file as UTF-8; is it the right file?".to_owned(),
            Self::NoKnowledge { .. } => {
                "knowledge is tools.toml, media.toml, surfaces.toml and interactions.toml"
                    .to_owned()
            }
            Self::Contradiction { .. } => {
                "leave --action out, or state an action in the file in place of the goal".to_owned()
            }
            Self::UnknownRobot(_) => {
                "a robot of your own is a file: a path that ends in .urdf".to_owned()
            }
            Self::Urdf { file, .. } => format!("wisch robot check {file}"),
            Self::Output { help, .. } => (*help).to_owned(),
            Self::Map(_) => "wisch robot map builds it anew, for this very robot".to_owned(),
            _ => return None,
        })
    }
}
