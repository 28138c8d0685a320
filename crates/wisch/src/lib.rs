//! wisch plans, executes and interprets wiping by a robot: dirt is a set of particles, and a tool is its effect on them.
//!
//! # From a task file to a query
//!
//! Each step is a program of at most 25 lines: `crates/wisch/examples/01_load.rs` and so on; `docs/tutorial.md` shows all
//! of them.
//!
//! 1. **Load a task.** `wisch_io::load_task` reads a task file into a [`Task`](represent::Task): the surface, the tool, the
//!    action, and the dirt as particles.
//! 2. **Plan and predict.** A [`Session`](run::Session) advances stage by stage; up to [`Stage::Planned`](run::Stage) it
//!    needs neither robot nor world. [`predict`](plan::predict) returns the effect of a [`Plan`](plan::Plan) on the dirt.
//! 3. **Follow.** `wisch_io::Robot::load` reads a URDF. With this robot the session computes the joint motion of the plan
//!    ([`Followed`](follow::Followed)) and an independent [`Audit`](follow::Audit) of the motion.
//! 4. **Execute.** An [`Executor`](run::Executor) executes the motion and returns the measurements. It is a driver, the
//!    simulator `wisch_sim::World`, or another process by `wisch_io::ProcessExecutor`. The session continues until its
//!    [`Verdict`](recover::Verdict) ends it.
//! 5. **Interpret.** [`interpret`](interpret::interpret()) takes poses and forces, from any bag that `wisch_telemetry::read`
//!    reads. It estimates the contact, the plane of the surface, and the wiped dirt; [`next_task`](recover::next_task)
//!    returns the rest of the task.
//! 6. **Query.** `wisch_memory` stores runs as episodes and answers queries in Prolog.
//!
//! ```
//! use wisch::run::{NoExecutor, Stage, ignore_events};
//! use wisch_io::{LoadOptions, load_task};
//!
//! # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/arm-board.toml");
//! let loaded = load_task(path.as_ref(), &LoadOptions::default())?;
//! let mut session = loaded.session();
//! session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
//! let plan = session.plan().ok_or("there is no plan")?;
//! assert!(plan.contact_distance() > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The crates
//!
//! | crate | contents |
//! |---|---|
//! | `wisch` | the method: dirt, plans, motions, control, interpretation, the loop |
//! | [`wisch_io`](../wisch_io/index.html) | task files, knowledge base, robots, plans, trajectories, executors in other processes |
//! | [`wisch_sim`](../wisch_sim/index.html) | a physics simulator |
//! | [`wisch_telemetry`](../wisch_telemetry/index.html) | bags (MCAP, ROS 2 messages) and tables of poses and forces |
//! | [`wisch_report`](../wisch_report/index.html) | pictures and HTML reports |
//! | [`wisch_memory`](../wisch_memory/index.html) | episodes and their queries; the query engine is the companion program `wisch-prolog` |
//! | `wisch-cli` | the command line `wisch` |
//!
//! # The modules
//!
//! Data flows in one direction, and every stage imports only the stages before it:
//!
//! | stage | task | entry point |
//! |---|---|---|
//! | [`geometry`] | poses, polygons, meshes and their footprints on a surface | [`geometry::footprint()`] |
//! | [`represent`] | surface, tool and dirt, and the effect model of wiping | [`represent::Task`], [`represent::EffectModel`] |
//! | [`goal`] | from a goal in PDDL to an action and a tool | [`goal::resolve_goal`] |
//! | [`plan`](mod@plan) | from a task to strokes, and their predicted effect | [`plan::plan()`], [`plan::predict()`] |
//! | [`robot`] | a URDF as kinematics, dynamics, collisions and reach; independent of wiping | [`robot::RobotModel`] |
//! | [`follow`](mod@follow) | from strokes to joint motion, and the audit of that motion | [`follow::follow()`], [`follow::audit()`] |
//! | [`control`] | the compliant controller (8) and the observer of external forces | [`control::ImpedanceController`] |
//! | [`interpret`] | from poses and forces to contact, plane, events and wiped dirt | [`interpret::Interpreter`] |
//! | [`learn`](mod@learn) | estimates of the model's parameters from rounds with observations before and after | [`learn::learn()`] |
//! | [`recover`] | the next task, or the end of the session | [`recover::next_task()`] |
//! | [`run`] | the loop over all stages, with an executor of motions | [`run::Session`], [`run::Executor`] |
//!
//! This crate reads no clock, no file and no network: the crate `wisch-io` reads task files, knowledge and robots, and
//! random numbers come from a seed.
//!
//! Method: Leidner, Bartels, Bejjani, Albu-Schäffer, Beetz, *Cognition-enabled robotic wiping*,
//! Robotics and Autonomous Systems 114 (2019). `PAPER.md` maps its sections and equations to items.
//!
//! Units are SI and radians; frames are named in the identifiers (`surface_from_tool`).

pub mod control;
mod digits;
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

/// What most programs name: `use wisch::prelude::*;`.
pub mod prelude {
    pub use crate::follow::{Audit, Followed, Workcell};
    pub use crate::geometry::{Mesh, PlanarPose, Point2, Point3, Polygon, Pose, Vector2, Vector3};
    pub use crate::interpret::{Belief, Interpretation, TouchSample, interpret};
    pub use crate::plan::{Plan, PlanConfig, Planner, Strategy, plan, predict};
    pub use crate::recover::{Verdict, next_task};
    pub use crate::represent::{
        Action, Interaction, Observation, ParticleDistribution, SceneObject, ScenePart, Surface,
        Task, Tool,
    };
    pub use crate::robot::{IkSolver, RobotModel, Srdf};
    pub use crate::run::{
        Execution, Executor, ExecutorError, MotionOrder, Round, RunConfig, RunEvent, SampleSink,
        Session, Stage, ignore_events,
    };
}

/// The README's example runs.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
