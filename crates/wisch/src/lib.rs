//! wisch lets a robot understand wiping: dirt as particles, tools as what they do to them.
//!
//! The data walks one way, and every stage imports only the stages before it:
//!
//! ```text
//! geometry → represent → plan → follow
//!     └────► robot ───────────────┘
//! ```
//!
//! Nothing here reads a clock, a file or the network. Files reach the library as bytes through
//! [`represent::ReadFile`]; randomness comes in as a seed.
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
pub mod recover;
pub mod represent;
pub mod robot;
pub mod run;
pub mod text;

/// The README's example runs.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
