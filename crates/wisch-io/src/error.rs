//! Errors of reading and writing files.

use crate::knowledge::KnowledgeFileError;
use crate::task_file::TaskError;
use std::path::{Path, PathBuf};
use wisch::goal::GoalError;
use wisch::represent::Action;
use wisch::robot::{MapError, RobotError};
use wisch::source_location::UnknownName;

/// An error of a file, or of a file that it names.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A missing file.
    #[error("{}: there is no such file", path.display())]
    NoSuchFile {
        /// Its path.
        path: PathBuf,
        /// Most similar name in the same folder or of a shipped scenario, if one is similar.
        nearest: Option<String>,
    },
    /// A file or folder that cannot be read.
    #[error("{}: {problem}", path.display())]
    Unusable {
        /// Its path.
        path: PathBuf,
        /// The problem.
        problem: String,
    },
    /// A text file that is not UTF-8.
    #[error("{}:{line}: byte {byte} is not UTF-8 text", path.display())]
    NotText {
        /// Its path.
        path: PathBuf,
        /// Line, counted from 1.
        line: usize,
        /// Index of the first invalid byte.
        byte: usize,
    },
    /// A knowledge folder without files.
    #[error("{}: the folder holds no .toml file", folder.display())]
    NoKnowledge {
        /// The folder.
        folder: PathBuf,
    },
    /// A file of the knowledge folder that cannot be read.
    #[error("{0}")]
    Asset(String),
    /// An invalid knowledge file.
    #[error(transparent)]
    Knowledge(Box<KnowledgeFileError>),
    /// An invalid PDDL domain.
    #[error(transparent)]
    Domain(Box<GoalError>),
    /// An invalid task file.
    #[error(transparent)]
    Task(Box<TaskError>),
    /// A goal that no action reaches.
    #[error("{file}: goal {literal:?}: {error}")]
    Goal {
        /// The task file.
        file: String,
        /// The goal as typed.
        literal: String,
        /// The cause.
        #[source]
        error: Box<GoalError>,
    },
    /// An action of the command line that does not reach the goal.
    #[error(
        "{file}: --action {asked} contradicts the goal {literal}, which needs the action {needed}"
    )]
    Contradiction {
        /// The task file.
        file: String,
        /// The action of the command line.
        asked: Action,
        /// The goal as typed.
        literal: String,
        /// The action that reaches it.
        needed: Action,
    },
    /// An unknown strategy.
    #[error("{file}: {unknown}")]
    Strategy {
        /// The task file.
        file: String,
        /// Its name and similar names.
        unknown: UnknownName,
    },
    /// An unknown name of a shipped robot.
    #[error("{0}")]
    UnknownRobot(UnknownName),
    /// An invalid URDF of the user.
    #[error("{error}")]
    Urdf {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        error: Box<RobotError>,
    },
    /// An invalid shipped robot or SRDF.
    #[error(transparent)]
    Robot(Box<RobotError>),
    /// An invalid capability map.
    #[error(transparent)]
    Map(Box<MapError>),
    /// Results cannot be written at a location.
    #[error("{}: {problem}", path.display())]
    Output {
        /// The location.
        path: PathBuf,
        /// The problem.
        problem: String,
        /// Advice.
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

    /// Returns advice, if there is any.
    pub fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoSuchFile { path, nearest } => match nearest {
                Some(nearest) => format!("did you mean {nearest}?"),
                None if path.extension().is_none() => {
                    "wisch scenarios lists the names of the shipped scenarios".to_owned()
                }
                None => return None,
            },
            Self::NotText { .. } => "check the file name, or save the file as UTF-8".to_owned(),
            Self::NoKnowledge { .. } => {
                "a knowledge base has tools.toml, media.toml, surfaces.toml and interactions.toml"
                    .to_owned()
            }
            Self::Contradiction { .. } => {
                "leave out --action, or replace the file's goal by an action".to_owned()
            }
            Self::UnknownRobot(unknown) if unknown.name.contains(['.', '/', '\\']) => {
                format!(
                    "a path is no name: in [robot], write urdf = {:?} instead of name",
                    unknown.name
                )
            }
            Self::UnknownRobot(_) => {
                "for your own robot, give a path that ends in .urdf".to_owned()
            }
            Self::Urdf { file, .. } => format!("see all findings with wisch robot check {file}"),
            Self::Output { help, .. } => (*help).to_owned(),
            Self::Map(_) => "rebuild the map for this robot with wisch robot map".to_owned(),
            _ => return None,
        })
    }
}
