//! From a joint path to joint motion: when each joint is where, within its limits; paper §3.3, §3.4.

mod checker;
mod timing;

pub use checker::{CheckConfig, End, Fault, trajectory_faults};
pub use timing::{
    JointLimit, JointLimits, JointPath, MAX_GRID_INTERVALS, MAX_WAYPOINTS, MIN_BLEND_TOLERANCE,
    SAMPLE_PERIOD, TimingConfig, TimingError, Trajectory, TrajectorySample, time_path,
};
