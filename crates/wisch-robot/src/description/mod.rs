//! Descriptions of robots: URDF and SRDF as typed, their checks, collision shapes and visual geometry.

mod appearance;
pub(super) mod check;
mod collision;
mod diagnostics;
pub(super) mod elements;
mod link_axis;
mod planar;
mod repair;
mod shown_shapes;
mod srdf;
mod srdf_state;
mod srdf_writer;
mod transforms;
mod units;
pub(super) mod urdf;
mod virtual_joint;
mod xml;

pub use appearance::{Appearance, Visual};
pub use check::{MAX_DEPTH, check};
pub use collision::{Collision, MAX_MESH_EXTENT, Shape};
pub use diagnostics::{Diagnostic, DiagnosticKind, Severity, Subject};
pub use link_axis::LinkAxis;
pub use shown_shapes::show_collision_shapes;
pub use srdf::{
    DisabledPair, Group, GroupState, HOME_STATE, IgnoredElement, READY_STATE, Srdf, ToolHolder,
};
pub use srdf_writer::SrdfComments;
pub use transforms::{JointMimic, JointMotion, JointTransform, joint_transforms};
pub use urdf::{MAX_LINKS, MAX_SHAPES};
pub use virtual_joint::{ASSUMED_BASE_LIMITS, VirtualJoint, urdf_on_base};
pub use xml::MAX_URDF_BYTES;
