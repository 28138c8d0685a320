//! wisch lets a robot understand wiping: dirt as particles, tools as what they do to them.
//!
//! # From a task file to a question
//!
//! Each step is a program of at most 25 lines: `crates/wisch/examples/01_load.rs` and so on; `docs/tutorial.md` shows them
//! all.
//!
//! 1. **Load a task.** `wisch_io::load_task` makes of a task file a [`Task`](represent::Task): what is to be wiped, where
//!    and with what, with the dirt as particles.
//! 2. **Plan and predict.** A [`Session`](run::Session) goes on stage by stage; up to [`Stage::Planned`](run::Stage) it needs
//!    neither robot nor world. [`predict`](plan::predict) says what a [`Plan`](plan::Plan) does to the dirt.
//! 3. **Follow.** `wisch_io::Robot::load` reads a URDF; with it the session makes joint motion of the plan
//!    ([`Followed`](follow::Followed)), and an independent [`Audit`](follow::Audit) of that.
//! 4. **Execute.** Whatever implements [`Executor`](run::Executor) is given the motion and hands on what is measured: a
//!    driver, the simulator `wisch_sim::World`, or another process by `wisch_io::ProcessExecutor`. The session goes on until
//!    there is a [`Verdict`](recover::Verdict).
//! 5. **Interpret.** [`interpret`](interpret::interpret()) takes poses and forces, from any bag that `wisch_telemetry::read`
//!    reads, and says where there was contact, where the surface is and what was wiped;
//!    [`next_task`](recover::next_task) is what is left to do.
//! 6. **Ask.** `wisch_memory` keeps runs as episodes and answers queries in Prolog.
//!
//! ```
//! use wisch::run::{NoExecutor, Stage, unobserved};
//! use wisch_io::{LoadOptions, load_task};
//!
//! # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/arm-board.toml");
//! let loaded = load_task(path.as_ref(), &LoadOptions::default())?;
//! let mut session = loaded.session();
//! session.run_until(Stage::Planned, &mut NoExecutor, &mut unobserved)?;
//! let plan = session.plan().ok_or("there is no plan")?;
//! assert!(plan.contact_distance() > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The crates
//!
//! | crate | what it holds |
//! |---|---|
//! | `wisch` | the method: dirt, plans, motions, control, interpretation, the loop |
//! | [`wisch_io`](../wisch_io/index.html) | task files, knowledge, robots, plans, trajectories, executors in other processes |
//! | [`wisch_sim`](../wisch_sim/index.html) | a physics world to wipe in |
//! | [`wisch_telemetry`](../wisch_telemetry/index.html) | bags (MCAP, ROS 2 messages) and tables of poses and forces |
//! | [`wisch_report`](../wisch_report/index.html) | pictures and pages |
//! | [`wisch_memory`](../wisch_memory/index.html) | episodes, and queries to them; the engine is the program `wisch-prolog` |
//! | `wisch-cli` | the program `wisch` |
//!
//! # The house
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
//! | [`learn`](mod@learn) | what rounds that were looked at before and after say of the laws | [`learn::learn()`] |
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
pub mod goal;
pub mod interpret;
pub mod learn;
pub mod plan;
pub mod random;
pub mod recover;
pub mod represent;
pub mod run;

pub use wisch_robot::{self as robot, geometry, source_location};

/// The README's example runs.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
