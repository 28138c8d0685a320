//! Replies to the engine's requests.

use super::error::{AskError, QueryFault};
use super::term::Term;
use std::iter::Peekable;

/// Rows that are computed on demand.
pub type AnswerRows = Box<dyn Iterator<Item = Term> + Send>;

/// A reply of the host to a request.
pub enum Reply {
    /// All facts at once.
    Facts(Vec<Term>),
    /// A stream of rows.
    Stream(AnswerRows),
    /// The rest of a stream.
    More(Cursor),
}

/// A stream that is partly sent.
pub struct Cursor {
    /// Remaining rows.
    pub rows: Peekable<AnswerRows>,
    /// Number of rows in the next chunk.
    pub size: usize,
}

/// The reason why the host cannot reply to a request.
pub enum HostRefusal {
    /// A fault of the query.
    Fault(QueryFault),
    /// An error of this program.
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
