//! wisch lets a robot understand wiping: dirt as particles, tools as what they do to them.
//!
//! The data walks one way, and every stage imports only the stages before it:
//!
//! ```text
//! geometry → represent → plan → follow
//!     └────► robot ───────────────┘
//! ```
//!
//! Nothing here reads a clock, a file or the network: task files, knowledge and robots are read by the crate
//! `wisch-io`; randomness comes in as a seed.
//!
//! Method: Leidner, Bartels, Bejjani, Albu-Schäffer, Beetz, *Cognition-enabled robotic wiping*,
//! Robotics and Autonomous Systems 114 (2019). `PAPER.md` maps its sections and equations to items.
//!
//! Units are SI and radians; frames are named in the identifiers (`surface_from_tool`).

pub mod control;
pub mod follow;
pub mod geometry;
pub mod interpret;
pub mod plan;
pub mod random;
pub mod recover;
pub mod represent;
pub mod robot;
pub mod run;
pub mod source_location;

/// The README's example runs.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
