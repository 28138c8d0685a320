//! Errors as the exception `wisch.WischError`, with file, place, value, limit and help.

use pyo3::prelude::*;
use std::fmt::Display;
use wisch::represent::KnowledgeError;
use wisch::robot::RobotError;
use wisch::run::RunError;
use wisch::source_location::Place;
use wisch_io::{Error, TaskError};
use wisch_record::RecordError;

pyo3::import_exception!(wisch._errors, WischError);

/// Details of an error, beside its message.
#[derive(Debug, Default)]
pub struct Details {
    /// Path of the file.
    pub file: Option<String>,
    /// Line and column in it, from 1.
    pub place: Option<(usize, usize)>,
    /// The given value.
    pub value: Option<String>,
    /// The allowed values.
    pub limit: Option<String>,
    /// A remedy.
    pub help: Option<String>,
}

/// Returns the exception with a message and details.
pub fn failed(sentence: impl Display, details: Details) -> PyErr {
    let Details {
        file,
        place,
        value,
        limit,
        help,
    } = details;
    WischError::new_err((sentence.to_string(), file, place, value, limit, help))
}

/// Returns the exception with a message only.
pub fn plain(sentence: impl Display) -> PyErr {
    failed(sentence, Details::default())
}

/// Returns the exception for an invalid argument.
pub fn refused(name: &str, value: impl Display, limit: impl Display) -> PyErr {
    let details = Details {
        value: Some(value.to_string()),
        limit: Some(limit.to_string()),
        ..Details::default()
    };
    failed(format!("{name}: expected {limit}, found {value}"), details)
}

/// Returns the exception for an invalid file.
pub fn of_file(error: Error) -> PyErr {
    let help = error.help();
    let mut details = match &error {
        Error::Task(error) => of_task(error),
        Error::NoSuchFile { path, .. }
        | Error::Unusable { path, .. }
        | Error::NotText { path, .. }
        | Error::Output { path, .. } => file(path.display()),
        Error::NoKnowledge { folder } => file(folder.display()),
        Error::Goal { file: path, .. } | Error::Contradiction { file: path, .. } => file(path),
        Error::Strategy {
            file: path,
            unknown,
        } => Details {
            value: Some(unknown.name.clone()),
            limit: Some(unknown.known.join(", ")),
            ..file(path)
        },
        Error::UnknownRobot(unknown) => Details {
            value: Some(unknown.name.clone()),
            limit: Some(unknown.known.join(", ")),
            ..Details::default()
        },
        Error::Urdf { file: path, .. } => file(path),
        _ => Details::default(),
    };
    if let Error::NotText { line, byte, .. } = &error {
        details.place = Some((*line, *byte));
    }
    details.help = details.help.or(help);
    failed(error, details)
}

/// Returns the exception for a run that cannot be stored.
pub fn of_record(error: RecordError) -> PyErr {
    match error {
        RecordError::Results(error) => of_file(error),
        error => plain(error),
    }
}

fn file(path: impl Display) -> Details {
    Details {
        file: Some(path.to_string()),
        ..Details::default()
    }
}

fn of_task(error: &TaskError) -> Details {
    let at = |place: &Place| Details {
        place: Some((place.line, place.column)),
        ..file(&place.file)
    };
    match error {
        TaskError::WrongType {
            at: place,
            expected,
            found,
            ..
        } => Details {
            value: Some(found.clone()),
            limit: Some(expected.clone()),
            ..at(place)
        },
        TaskError::OutOfRange {
            at: place,
            value,
            limits,
            ..
        } => Details {
            value: Some(value.clone()),
            limit: Some(limits.clone()),
            ..at(place)
        },
        TaskError::UnknownKey {
            at: place, unknown, ..
        }
        | TaskError::UnknownReference { at: place, unknown } => Details {
            value: Some(unknown.name.clone()),
            limit: Some(unknown.known.join(", ")),
            ..at(place)
        },
        TaskError::Knowledge { at: place, error } => match error.as_ref() {
            KnowledgeError::Unknown(unknown) => Details {
                value: Some(unknown.name.clone()),
                limit: Some(unknown.known.join(", ")),
                ..at(place)
            },
            KnowledgeError::NoInteraction { tool, capable, .. } => Details {
                value: Some(tool.clone()),
                limit: Some(capable.join(", ")),
                ..at(place)
            },
            _ => at(place),
        },
        TaskError::MeshScale {
            at: place,
            extent,
            limits: [least, most],
            ..
        } => Details {
            value: Some(extent.to_string()),
            limit: Some(format!("{least} to {most}")),
            ..at(place)
        },
        TaskError::Schema { at: place, found } => Details {
            value: Some(found.clone()),
            ..at(place)
        },
        TaskError::Syntax { at: place, .. }
        | TaskError::Missing { at: place, .. }
        | TaskError::Inconsistent { at: place, .. }
        | TaskError::File { at: place, .. }
        | TaskError::Mesh { at: place, .. }
        | TaskError::Footprint { at: place, .. }
        | TaskError::Particles { at: place, .. } => at(place),
        _ => Details::default(),
    }
}

/// Returns the exception for an invalid request to a robot's model.
pub fn of_robot(error: RobotError) -> PyErr {
    plain(error)
}

/// Returns the exception for a session that cannot continue.
pub fn of_run(task: &str, error: &RunError) -> PyErr {
    failed(format!("{task}: {error}"), file(task))
}
