//! The server of `wisch studio`: a page that shows live runs and stored episodes, and answers queries about them.
//!
//! It answers only clients that know its token ([`Studio::url`]), at addresses of this machine. All paths begin with
//! `/TOKEN/`:
//!
//! | request | answer |
//! |---|---|
//! | `GET` nothing | the page |
//! | `GET api/overview?find=WORDS` | episodes, newest first; live runs; shipped tasks |
//! | `GET api/overview/events` | an event whenever the overview changes |
//! | `GET api/episodes/ID/recording` | a recording, compressed by gzip |
//! | `GET api/runs/ID/stream?after=N` | a growing recording, an event per line; `Last-Event-ID` as well |
//! | `POST api/runs` | starts a run of `{task, seed?, strategy?}` |
//! | `POST api/runs/ID/stop`, `…/clear` | stops a run; removes the files of a run that broke off |
//! | `POST api/ask` | the answers to `{query, limit?}` and the data to show, or an error and its place |
//! | `GET api/health` | the JSON of `wisch memory health` |
//! | `GET api/vocabulary` | names that queries may use |

mod arguments;
mod browser;
mod connections;
mod gate;
mod kept;
mod library;
mod live;
mod process;
mod questions;
mod refusal;
mod runs;
mod scenarios;
mod serve;
mod stream;
mod vocabulary;
mod watch;

pub use arguments::{Arguments, USAGE};
pub use serve::{Config, Studio, StudioError};
pub use vocabulary::EXAMPLES;
