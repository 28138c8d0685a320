//! wisch lets a robot understand wiping: dirt as particles, tools as what they do to them.
//!
//! The data walks one way, and every stage imports only the stages before it:
//!
//! | stage | what it does | begin with |
//! |---|---|---|
//! | [`geometry`] | poses, polygons, meshes and what they leave on a surface | [`geometry::footprint()`] |
//! | [`represent`] | surface, tool and dirt, and the one model of what wiping does to it | [`represent::Task`], [`represent::EffectModel`] |
//! | [`goal`] | from a goal in PDDL to an action and a tool | [`goal::resolve_goal`] |
//! | [`plan`](mod@plan) | from a task to strokes, and their predicted effect | [`plan::plan()`], [`plan::predict()`] |
//! | [`robot`] | a URDF as kinematics, dynamics, collisions, reach; knows nothing of wiping | [`robot::RobotModel`] |
//! | [`follow`](mod@follow) | from strokes to joint motion, and an audit of it | [`follow::follow()`], [`follow::audit()`] |
//! | [`control`] | the compliant controller (8) and the observer of external forces | [`control::ImpedanceController`] |
//! | [`interpret`] | from poses and forces to contact, plane, events and what was wiped | [`interpret::Interpreter`] |
//! | [`recover`] | what follows from that: the next task, or the end | [`recover::next_task()`] |
//! | [`run`] | the loop of all these, with whatever executes motions | [`run::Session`], [`run::Executor`] |
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
pub mod goal;
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
