//! From a plan to whole-body motion: where the base stands, how the arm follows the tool's line, and the time
//! of every joint position, within the limits; paper §3.3, §3.4.
//!
//! [`follow`] turns the strokes of a [`Plan`](crate::plan::Plan) into joint motion of a [`Workcell`], a robot
//! with a tool in its hand before a scene. [`audit`] checks a motion independently: it shares the robot model
//! and the collision model with the follower, and no other code.

mod audit;
mod config;
mod error;
mod follower;
mod motion;
mod path;
mod pending_stroke;
mod placement;
mod retreat;
mod schedule;
mod workcell;

pub use audit::{
    Audit, MotionEnd, MotionFault, RateKind, TrajectoryCheckConfig, TrajectoryFault, audit,
    trajectory_faults,
};
pub use config::{FollowConfig, SearchScope};
pub use error::FollowError;
pub use follower::follow;
pub use motion::{
    AbandonedNode, Attempt, Followed, GripDeviation, LineDeviation, Motion, Obstruction, Phase,
    Placement, RatedBasePose, ToolPose,
};
pub use retreat::retreat;
pub use wisch_robot::timing::{
    FollowerLimit, JointLimit, JointLimits, JointPath, MAX_GRID_INTERVALS, MAX_WAYPOINTS,
    MIN_BLEND_TOLERANCE, SAMPLE_PERIOD, TimingConfig, TimingError, Trajectory, TrajectorySample,
    time_path,
};
pub use workcell::{
    AllowedContact, GRIP_TOLERANCE, HeldTool, HolderCylinder, LEAN_TOLERANCE, MountSource,
    PlanarBase, PlanningGroup, SecondArm, StartAssumption, Workcell, WorkcellConfig,
};
