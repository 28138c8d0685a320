//! SQL over one or many sources of episodes.

mod limits;
mod output;
pub(crate) mod provider;
mod session;
mod statement;
pub mod views;

pub use limits::{Limits, STACK, Watch};
pub use output::{Form, write};
pub use session::{Session, Source};
