//! The studio's server, over real connections.

mod asking;
mod client;
mod episodes;
mod gate;
mod place;
mod runs;
mod streams;
