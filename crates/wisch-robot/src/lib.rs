//! Robots from URDF and SRDF: kinematics, dynamics, inverse kinematics, collisions, reach and path
//! timing. This crate contains nothing that is specific to wiping.
//!
//! A [`RobotModel`] is constant. Quantities that depend on the joint positions are values that
//! functions return: [`RobotModel::forward_kinematics`] gives [`Kinematics`], which has the
//! Jacobian; [`RobotModel::dynamics`] gives [`Dynamics`], which has the mass matrix. [`Chain`]
//! gives the same from one link to another without any allocation, for control loops.
//!
//! | question | begin with |
//! |---|---|
//! | Where is each link, and how does it move? | [`RobotModel::forward_kinematics`], [`Chain`] |
//! | Which joint positions reach a pose? | [`IkSolver`] |
//! | What touches what, and how near are two bodies? | [`CollisionModel`] |
//! | Which poses does an arm reach from where? | [`CapabilityMap`] |
//! | How fast can a joint path be followed? | [`timing::time_path`] |
//! | Which groups, states and allowed contacts has the robot? | [`Srdf`] |
//! | What is wrong with a URDF? | [`check`](check()) |
//! | Does the surface of a mesh unroll into a chart? | [`geometry::Sheet`] |
//! | Which SRDF suits a URDF that has none? | [`setup`] |
//!
//! A robot has n variables, one for each joint that moves by itself. Arrays of positions, velocities and efforts have n
//! entries in the order of [`RobotModel::variables`]: along the tree, siblings in the order of the file. A joint that
//! follows another (`<mimic>`, or a sum of several) is no variable. Units are \[m\], \[rad\], \[N\] and \[Nm\]; spatial quantities
//! have the linear part first; the world is the frame of the root link.
//!
//! ```
//! use wisch_robot::RobotModel;
//!
//! # let urdf = include_str!("../../../robots/arm7.urdf");
//! let mut meshes = |uri: &str| std::fs::read(uri).map_err(|error| error.to_string());
//! let robot = RobotModel::from_urdf("arm7.urdf", urdf, &mut meshes)?;
//! let kinematics = robot.forward_kinematics(&vec![0.0; robot.dof()])?;
//! let tip = robot.link(&robot.links().last().ok_or("no links")?.name)?;
//! let height = kinematics.world_from_link(tip).translation.z; // [m]
//! assert!(height > 0.5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod articulation;
mod assumed_masses;
mod capability;
mod chain;
mod clearance;
mod description;
mod dynamics;
mod error;
mod fnv;
mod frame;
pub mod geometry;
mod ik;
mod kinematics;
mod model;
pub mod setup;
pub mod source_location;
#[cfg(test)]
mod tests;
pub mod timing;

pub use articulation::{ArticulatedJoint, Articulation, ArticulationState};
pub use assumed_masses::ASSUMED_DENSITY;
pub use capability::{
    CapabilityMap, MAX_MAP_BYTES, MapConfig, MapError, MapOrigin, MapRequest, MapStage, RobotHash,
};
pub use chain::{Chain, ChainJacobian, ChainKinematics, MAX_CHAIN};
pub use clearance::{
    AllowedReason, BodyId, Clearance, CollisionModel, Contact, Margins, SEGMENT_RESOLUTION,
};
pub use description::{
    ASSUMED_BASE_LIMITS, Appearance, Collision, Diagnostic, DiagnosticKind, DisabledPair, Group,
    GroupState, HOME_STATE, IgnoredElement, JointMimic, JointMotion, JointTransform, LinkAxis,
    MAX_DEPTH, MAX_LINKS, MAX_MESH_EXTENT, MAX_SHAPES, MAX_URDF_BYTES, READY_STATE, Severity,
    Shape, Srdf, SrdfComments, Subject, ToolHolder, VirtualJoint, Visual, check, joint_transforms,
    show_collision_shapes, urdf_on_base,
};
pub use dynamics::{Dynamics, MIN_INERTIA};
pub use error::RobotError;
pub use frame::rotation_from_z;
pub use ik::{IkConfig, IkOutcome, IkSolver, JointPositions, MAX_TARGET_DISTANCE, RotationGoal};
pub use kinematics::Kinematics;
pub use model::{
    ASSUMED_SLIDE_RATES, ASSUMED_TURN_RATES, Body, Drive, Joint, JointId, JointKind, LimitFault,
    Link, LinkId, Range, RobotModel, SingleJointLimits,
};
