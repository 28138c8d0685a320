//! From a plan to whole-body motion: where the base stands, how the arm follows the tool's line, and when
//! each joint is where, within its limits; paper §3.3, §3.4.
//!
//! [`follow`] turns the strokes of a [`Plan`](crate::plan::Plan) into joint motion of a [`Workcell`], a
//! robot with a tool in its hand before a scene. [`audit`] proves that a motion keeps what it should; it
//! shares no code with what found it.

mod arm;
mod audit;
mod checker;
mod config;
mod drive;
mod edge;
mod error;
mod follower;
mod freedom;
mod global;
mod group;
mod hold;
mod motion;
mod placement;
mod schedule;
mod second_arm;
mod stroke_run;
mod timing;
mod transfer;
mod workcell;

pub use audit::{Audit, LineDeviation, MotionFault, audit};
pub use checker::{CheckConfig, End, Fault, trajectory_faults};
pub use config::{Effort, FollowConfig};
pub use error::FollowError;
pub use follower::follow;
pub use group::{Group, PlanarBase};
pub use motion::{
    AbandonedNode, Attempt, Followed, Motion, Obstruction, Phase, Placement, RatedPlace, ToolPose,
};
pub use second_arm::{GRIP_TOLERANCE, GripDeviation, LEAN_TOLERANCE, SecondArm};
pub use timing::{
    JointLimit, JointLimits, JointPath, MAX_GRID_INTERVALS, MAX_WAYPOINTS, MIN_BLEND_TOLERANCE,
    SAMPLE_PERIOD, TimingConfig, TimingError, Trajectory, TrajectorySample, time_path,
};
pub use workcell::{Touch, Workcell, WorkcellConfig};
