//! The server of `wisch studio`: a page that shows runs while they happen and episodes of a memory, and asks about them.
//!
//! It answers only who knows its token ([`Studio::url`]), at addresses of this machine. Everything lies under `/TOKEN/`:
//!
//! | request | answer |
//! |---|---|
//! | `GET` nothing | the page |
//! | `GET api/overview?find=WORDS` | episodes, newest first; runs that go on; shipped tasks |
//! | `GET api/overview/events` | an event whenever that changes |
//! | `GET api/episodes/ID/recording` | a recording, packed by gzip |
//! | `GET api/runs/ID/stream?after=N` | a recording that grows, an event a line; `Last-Event-ID` as well |
//! | `POST api/runs` | begins a run of `{task, seed?, strategy?}` |
//! | `POST api/runs/ID/stop`, `…/clear` | ends it; removes what one left behind that broke off |
//! | `POST api/ask` | the answers to `{query, limit?}` and what they show, or what is wrong and where |
//! | `GET api/vocabulary` | what queries may name |

mod arguments;
mod browser;
mod connections;
mod gate;
mod kept;
mod library;
mod live;
mod place;
mod process;
mod questions;
mod refusal;
mod runs;
mod scenarios;
mod serve;
mod shown;
mod stream;
mod vocabulary;
mod watch;

pub use arguments::{Arguments, USAGE};
pub use serve::{Config, Studio, StudioError};
pub use vocabulary::EXAMPLES;
