//! Tests of the studio's server over real connections.

mod asking;
mod client;
mod episodes;
mod gate;
mod place;
#[cfg(target_os = "linux")]
mod program;
mod runs;
mod streams;
