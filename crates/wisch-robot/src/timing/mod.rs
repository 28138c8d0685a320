//! From waypoints in joint space to a motion that obeys velocity and acceleration limits.
//!
//! Corners are rounded by parabolas within a tolerance (`blends.rs`). Reachability analysis finds the fastest
//! speed along that fixed path (`profile.rs`). The result is exact at every time (`trajectory.rs`).

mod blends;
mod check;
mod error;
mod input;
mod profile;
mod trajectory;

use blends::BlendedPath;
pub use check::{MotionEnd, RateKind, TrajectoryCheckConfig, TrajectoryFault, trajectory_faults};
pub use error::TimingError;
pub use input::{FollowerLimit, JointLimit, JointLimits, JointPath};
use trajectory::Stretch;
pub use trajectory::{SAMPLE_PERIOD, Trajectory, TrajectorySample};

/// Largest number of waypoints of a [`JointPath`].
pub const MAX_WAYPOINTS: usize = 1_000_000;

/// Approximately the largest number of grid intervals of a whole path. Very long paths get a coarser grid,
/// which costs time and never breaks a limit.
pub const MAX_GRID_INTERVALS: usize = 4_000_000;

/// The smallest blend tolerance [rad or m]: nearly a stop in every corner.
pub const MIN_BLEND_TOLERANCE: f64 = 1e-6;

/// Tolerance with which [`time_path`] rounds corners, and resolution of its search for speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct TimingConfig {
    /// Largest deviation of any joint from the straight segments, and from a waypoint when passing it [rad or
    /// m]; at least [`MIN_BLEND_TOLERANCE`]. A larger value gives a faster motion around corners.
    pub blend_tolerance: f64,
    /// Number of grid intervals per blend, and on straight pieces per distance needed to reach full speed; at
    /// least 2. More intervals lower the duration by ever less.
    pub grid_intervals: usize,
}

impl Default for TimingConfig {
    /// 2 mrad, which is 2 mm at the end of a 1 m arm; 24 intervals, within 1 % of far finer grids.
    fn default() -> Self {
        Self {
            blend_tolerance: 2e-3,
            grid_intervals: 24,
        }
    }
}

/// Returns the fastest motion from rest to rest along a path with rounded corners, within the limits of every
/// joint at every time, mimic joints included (paper §3.4; time-optimal path parametrisation after Pham and
/// Pham, 2018).
///
/// The motion starts and ends exactly at the first and last waypoint and passes all others in order. Waypoints
/// nearer to the last one than a tenth of the tolerance are skipped, repeated ones too; their shortest times
/// are kept. If all waypoints are the same, the duration is 0. The same input gives the same
/// result, bit by bit.
///
/// ```
/// use wisch_robot::timing::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
/// let path = JointPath::new(&[[0.0, 0.0], [0.8, 0.0], [0.8, 0.5]])?;
/// let limits = JointLimits::new(vec![
///     JointLimit::arm("shoulder", -1.5, 1.5),
///     JointLimit::arm("elbow", -2.0, 2.0),
/// ])?;
/// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
/// // Stopping in the corner would take (0.8 / 1 + 1 / 10) + (0.5 / 1 + 1 / 10) s.
/// assert!(trajectory.duration() < 1.5);
/// # Ok::<(), wisch_robot::timing::TimingError>(())
/// ```
///
/// # Errors
///
/// [`TimingError::PositionOutOfRange`] for a waypoint outside a joint's range, [`TimingError::UnequalJoints`]
/// if limits and path disagree, and [`TimingError::BlendToleranceOutOfRange`] or
/// [`TimingError::GridOutOfRange`] for the configuration.
pub fn time_path(
    path: &JointPath,
    limits: &JointLimits,
    config: &TimingConfig,
) -> Result<Trajectory, TimingError> {
    let tolerance = config.blend_tolerance;
    if !(tolerance.is_finite() && tolerance >= MIN_BLEND_TOLERANCE) {
        return Err(TimingError::BlendToleranceOutOfRange { value: tolerance });
    }
    if !(2..=MAX_GRID_INTERVALS).contains(&config.grid_intervals) {
        return Err(TimingError::GridOutOfRange {
            value: config.grid_intervals,
        });
    }
    limits.admit(path)?;

    let (limits, with_followers) = &limits.with_columns_of_followers(path);
    let blended = BlendedPath::new(with_followers, limits, tolerance);
    let grid = profile::grid(&blended, limits, config.grid_intervals);
    let squares = if grid.is_empty() {
        Vec::new()
    } else {
        profile::fastest(&blended, limits, &grid)
    };

    let mut time = 0.0;
    let mut stretches = Vec::with_capacity(grid.len());
    for (interval, ends) in grid.iter().zip(squares.windows(2)) {
        let speed = ends[0].sqrt();
        stretches.push(Stretch {
            time,
            piece: interval.piece,
            offset: interval.offset,
            speed,
            acceleration: 0.5 * (ends[1] - ends[0]) / interval.step,
        });
        time += 2.0 * interval.step / (speed + ends[1].sqrt());
    }
    Ok(Trajectory::new(path, blended, stretches, time))
}
