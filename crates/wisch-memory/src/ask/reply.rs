//! What the engine is sent in answer to a request.

use super::error::{AskError, QueryFault};
use super::term::Term;
use std::iter::Peekable;

/// Rows that are made when they are asked for.
pub type AnswerRows = Box<dyn Iterator<Item = Term> + Send>;

/// What is sent in answer.
pub enum Reply {
    /// All at once.
    Facts(Vec<Term>),
    /// As they are asked for.
    Stream(AnswerRows),
    /// The rest of those.
    More(Cursor),
}

/// A stream of which not all is sent yet.
pub struct Cursor {
    /// What is left.
    pub rows: Peekable<AnswerRows>,
    /// How many rows are sent next.
    pub size: usize,
}

/// Why nothing is sent.
pub enum HostRefusal {
    /// What the query did wrong.
    Fault(QueryFault),
    /// What the program did wrong.
    Error(AskError),
}

impl From<QueryFault> for HostRefusal {
    fn from(fault: QueryFault) -> Self {
        Self::Fault(fault)
    }
}

impl From<AskError> for HostRefusal {
    fn from(error: AskError) -> Self {
        Self::Error(error)
    }
}
