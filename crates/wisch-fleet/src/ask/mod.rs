//! SQL over one or many sources of episodes.

mod limits;
mod output;
pub(crate) mod provider;
mod session;
mod statement;
pub mod views;

pub use limits::{LimitWatch, STACK, SqlLimits};
pub use output::{Form, write};
pub use session::{SqlSession, SqlSource};
