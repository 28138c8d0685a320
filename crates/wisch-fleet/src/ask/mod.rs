//! SQL over one or many sources of episodes.

mod output;
pub(crate) mod provider;
mod session;
pub mod views;

pub use output::{Form, write};
pub use session::{Session, Source};
