//! The robot: links, joints and limits from a URDF, with kinematics and dynamics. This module does not depend on
//! wiping.
//!
//! A [`RobotModel`] is constant. Configuration-dependent quantities are values that functions return:
//! [`RobotModel::forward_kinematics`] returns [`Kinematics`], which has the Jacobian, and [`RobotModel::dynamics`]
//! returns [`Dynamics`], which has the mass matrix. [`Chain`] computes the same between two links without allocation,
//! for inner loops.
//!
//! A robot has n variables, one per joint that moves by itself. Arrays of positions, velocities and efforts have n
//! entries in the order of [`RobotModel::variables`]: along the tree, siblings in the order of the file. Joints that
//! follow others (`<mimic>`, or a sum of several) are not variables. Units are [m], [rad], [N] and [Nm]; spatial
//! quantities are linear first; the world is the frame of the root link.

mod articulation;
mod capability;
mod chain;
mod clearance;
mod description;
mod dynamics;
mod error;
mod frame;
mod ik;
mod kinematics;
mod model;
#[cfg(test)]
mod tests;

pub use articulation::{ArticulatedJoint, Articulation, ArticulationState};
pub use capability::{
    CapabilityMap, MAX_MAP_BYTES, MapConfig, MapError, MapOrigin, MapStage, MapTool, RobotHash,
};
pub use chain::{Chain, ChainJacobian, ChainKinematics, MAX_CHAIN};
pub use clearance::{
    BodyId, Clearance, CollisionModel, Contact, Margins, Reason, SEGMENT_RESOLUTION,
};
pub use description::{
    Appearance, Collision, Diagnostic, DiagnosticKind, DisabledPair, Group, GroupState, Ignored,
    JointMimic, JointMotion, JointTransform, MAX_DEPTH, MAX_LINKS, MAX_MESH_EXTENT, MAX_SHAPES,
    MAX_URDF_BYTES, READY_STATE, Severity, Shape, Srdf, Subject, Visual, check, joint_transforms,
};
pub use dynamics::{Dynamics, MIN_INERTIA};
pub use error::RobotError;
pub(crate) use frame::z_to;
pub use ik::{IkConfig, IkOutcome, IkSolver, JointPositions, MAX_TARGET_DISTANCE, RotationGoal};
pub use kinematics::Kinematics;
pub use model::{
    ASSUMED_SLIDE_RATES, ASSUMED_TURN_RATES, Body, Drive, Joint, JointId, JointKind, LimitFault,
    Link, LinkId, Range, RobotModel, SingleJointLimits,
};
