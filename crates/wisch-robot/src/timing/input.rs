//! The input of the timing: waypoints and the limits of the joints.

use super::{MAX_WAYPOINTS, TimingError};
use crate::{ASSUMED_SLIDE_RATES, ASSUMED_TURN_RATES, Drive};

/// Waypoints in joint space, joined by straight segments, for a motion from rest to rest.
#[derive(Debug, Clone, PartialEq)]
pub struct JointPath {
    joint_count: usize,
    /// n × d, row-major [rad or m].
    positions: Vec<f64>,
    /// n − 1 shortest times [s].
    segment_times: Vec<f64>,
}

impl JointPath {
    /// Returns a path through n waypoints of d joint positions each [rad or m].
    ///
    /// ```
    /// use wisch_robot::timing::JointPath;
    /// let path = JointPath::new(&[[0.0, 0.2], [0.5, 0.1], [0.9, 0.0]])?;
    /// assert_eq!((path.waypoint_count(), path.joint_count()), (3, 2));
    /// assert_eq!(path.waypoint(1), [0.5, 0.1]);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If there are fewer than 2 or more than [`MAX_WAYPOINTS`] waypoints, if they have unequal numbers
    /// of joints or none, or if a position is not finite.
    pub fn new(waypoints: &[impl AsRef<[f64]>]) -> Result<Self, TimingError> {
        let count = waypoints.len();
        if count < 2 {
            return Err(TimingError::TooFewWaypoints { count });
        }
        if count > MAX_WAYPOINTS {
            return Err(TimingError::TooManyWaypoints { count });
        }
        let joint_count = waypoints[0].as_ref().len();
        if joint_count == 0 {
            return Err(TimingError::NoJoints);
        }
        let mut positions = Vec::with_capacity(count * joint_count);
        for (waypoint, row) in waypoints.iter().enumerate() {
            let row = row.as_ref();
            if row.len() != joint_count {
                return Err(TimingError::UnequalWaypoints {
                    waypoint,
                    count: row.len(),
                    expected: joint_count,
                });
            }
            if let Some(joint) = row.iter().position(|q| !q.is_finite()) {
                return Err(TimingError::PositionNotFinite {
                    waypoint,
                    joint,
                    value: row[joint],
                });
            }
            positions.extend_from_slice(row);
        }
        Ok(Self {
            joint_count,
            positions,
            segment_times: vec![0.0; count - 1],
        })
    }

    /// Sets shortest times. Along segment i the speed never exceeds the speed that takes `times[i]` seconds for
    /// the whole segment; 0 leaves the speed to the joint limits.
    ///
    /// For a tool that wipes at a given speed, the time is the tool's path length along the segment over that
    /// speed. Around a corner, the slower of both speeds holds. Where waypoints are skipped
    /// ([`time_path`](super::time_path)), their segments' times add up.
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
    /// let (tool_way_m, wiping_speed_m_per_s) = (0.3, 0.1);
    /// let path = JointPath::new(&[[0.0], [0.5]])?
    ///     .with_segment_times(vec![tool_way_m / wiping_speed_m_per_s])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// assert!(time_path(&path, &limits, &TimingConfig::default())?.duration() > 3.0);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If there is not one time per segment, or one is negative or not finite.
    pub fn with_segment_times(mut self, times: Vec<f64>) -> Result<Self, TimingError> {
        if times.len() != self.segment_times.len() {
            return Err(TimingError::UnequalSegments {
                times: times.len(),
                segments: self.segment_times.len(),
            });
        }
        if let Some(segment) = times.iter().position(|t| !(t.is_finite() && *t >= 0.0)) {
            return Err(TimingError::SegmentTimeOutOfRange {
                segment,
                value: times[segment],
            });
        }
        self.segment_times = times;
        Ok(self)
    }

    /// Number of waypoints, at least 2.
    pub fn waypoint_count(&self) -> usize {
        self.segment_times.len() + 1
    }

    /// Number of joints, at least 1.
    pub fn joint_count(&self) -> usize {
        self.joint_count
    }

    /// Joint positions of a waypoint [rad or m].
    ///
    /// # Panics
    ///
    /// If the waypoint does not exist.
    pub fn waypoint(&self, index: usize) -> &[f64] {
        &self.positions[index * self.joint_count..][..self.joint_count]
    }

    /// The shortest time of each segment \[s\]; 0 where only the joints limit it.
    pub fn segment_times(&self) -> &[f64] {
        &self.segment_times
    }
}

/// Limits of one joint. Units of a revolute joint are rad, rad/s, rad/s²; of a prismatic joint m, m/s, m/s².
#[derive(Debug, Clone, PartialEq)]
pub struct JointLimit {
    /// Name, for messages.
    pub name: String,
    /// Lower end of the range [rad or m]; −∞ for a joint that turns without end.
    pub lower: f64,
    /// Upper end of the range [rad or m]; ∞ for a joint that turns without end.
    pub upper: f64,
    /// Largest velocity, either way [rad/s or m/s].
    pub velocity: f64,
    /// Largest acceleration, either way [rad/s² or m/s²].
    pub acceleration: f64,
}

impl JointLimit {
    /// Returns the limits of a revolute joint of the paper's robot (§3.4): 1 rad/s and 10 rad/s².
    ///
    /// ```
    /// let elbow = wisch_robot::timing::JointLimit::arm("elbow", -2.0, 2.0);
    /// assert_eq!((elbow.velocity, elbow.acceleration), (1.0, 10.0));
    /// ```
    pub fn arm(name: &str, lower: f64, upper: f64) -> Self {
        Self {
            name: name.into(),
            lower,
            upper,
            velocity: ASSUMED_TURN_RATES[0],
            acceleration: ASSUMED_TURN_RATES[1],
        }
    }

    /// Returns the limits of a translation of the paper's mobile base (§3.4): 0.5 m/s and 1 m/s², unlimited
    /// range.
    ///
    /// ```
    /// let forward = wisch_robot::timing::JointLimit::base("forward");
    /// assert_eq!((forward.velocity, forward.acceleration), (0.5, 1.0));
    /// ```
    pub fn base(name: &str) -> Self {
        Self {
            name: name.into(),
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            velocity: ASSUMED_SLIDE_RATES[0],
            acceleration: ASSUMED_SLIDE_RATES[1],
        }
    }
}

/// Limits of a mimic joint, for example of a joint that rods hold parallel, or of the second finger of a hand.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowerLimit {
    /// Its own limits.
    pub limit: JointLimit,
    /// Its position, as a function of the path's columns.
    pub drive: Drive,
}

/// Allowance for rounding by which the position of a mimic joint may leave its range [rad or m].
const FOLLOWER_ROUNDING: f64 = 1e-12;

/// The limits of all joints: those of a path's columns, in their order, and those of mimic joints.
#[derive(Debug, Clone, PartialEq)]
pub struct JointLimits {
    joints: Vec<JointLimit>,
    followers: Vec<FollowerLimit>,
}

impl JointLimits {
    /// Returns the limits of d joints.
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits};
    /// let stuck = JointLimit { velocity: 0.0, ..JointLimit::arm("elbow", -2.0, 2.0) };
    /// assert_eq!(
    ///     JointLimits::new(vec![stuck]).unwrap_err().to_string(),
    ///     "joint \"elbow\": velocity limit 0 is not a positive, finite number",
    /// );
    /// ```
    ///
    /// # Errors
    ///
    /// A range is empty, or a velocity or acceleration is not positive and finite.
    pub fn new(joints: Vec<JointLimit>) -> Result<Self, TimingError> {
        joints.iter().try_for_each(JointLimit::check)?;
        let followers = Vec::new();
        Ok(Self { joints, followers })
    }

    /// Returns the same limits with all accelerations multiplied by `factor` \[1\], those of mimic joints as well.
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits};
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let gentle = limits.clone().with_accelerations_scaled(0.5);
    /// assert_eq!(gentle.joints()[0].acceleration, 0.5 * limits.joints()[0].acceleration);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If the factor is not positive and finite.
    #[must_use]
    pub fn with_accelerations_scaled(mut self, factor: f64) -> Self {
        assert!(
            factor > 0.0 && factor.is_finite(),
            "factor {factor} of the accelerations is not positive and finite"
        );
        let followers = self
            .followers
            .iter_mut()
            .map(|follower| &mut follower.limit);
        for limit in self.joints.iter_mut().chain(followers) {
            limit.acceleration *= factor;
        }
        self
    }

    /// Adds the limits of mimic joints of the path's columns: a motion then keeps these as well.
    ///
    /// ```
    /// use wisch_robot::timing::{FollowerLimit, JointLimit, JointLimits, JointPath, TimingConfig, time_path};
    /// use wisch_robot::Drive;
    /// let joints = ["hip", "knee"].map(|name| JointLimit::arm(name, -2.0, 2.0));
    /// let sum = FollowerLimit {
    ///     limit: JointLimit::arm("rod", -3.0, 3.0),
    ///     drive: Drive { offset: 0.0, terms: vec![(0, 1.0), (1, 1.0)] },
    /// };
    /// let limits = JointLimits::new(joints.to_vec())?.with_followers(vec![sum])?;
    /// let path = JointPath::new(&[[0.0, 0.0], [1.0, 1.0]])?;
    /// // Each turns by 1 rad, which takes 1.1 s; the rod turns by 2 rad.
    /// assert!(time_path(&path, &limits, &TimingConfig::default())?.duration() > 2.0);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`JointLimits::new`], or a mimic joint that refers to a column that does not exist.
    pub fn with_followers(mut self, followers: Vec<FollowerLimit>) -> Result<Self, TimingError> {
        for FollowerLimit { limit, drive } in &followers {
            limit.check()?;
            let columns = self.joints.len();
            if let Some(&(column, _)) = drive.terms.iter().find(|(i, _)| *i >= columns) {
                return Err(TimingError::NoSuchColumn {
                    joint: limit.name.clone(),
                    column,
                    columns,
                });
            }
        }
        self.followers = followers;
        Ok(self)
    }

    /// One limit per joint, in the order of the columns of a [`JointPath`].
    pub fn joints(&self) -> &[JointLimit] {
        &self.joints
    }

    /// The limits of the mimic joints.
    pub fn followers(&self) -> &[FollowerLimit] {
        &self.followers
    }

    /// Returns path and limits with a column for each mimic joint, after those of the path.
    ///
    /// A straight piece of the path is straight in these columns too, and a blend is the same parabola:
    /// properties of columns hold for mimic joints.
    pub(super) fn with_columns_of_followers(&self, path: &JointPath) -> (Self, JointPath) {
        let followed = self.followers.iter().map(|follower| &follower.limit);
        let limits = Self {
            joints: self.joints.iter().chain(followed).cloned().collect(),
            followers: Vec::new(),
        };
        let mut positions = Vec::new();
        for waypoint in 0..path.waypoint_count() {
            let q = path.waypoint(waypoint);
            positions.extend_from_slice(q);
            let followers = self.followers.iter();
            positions.extend(followers.map(|follower| follower.drive.position(q)));
        }
        let path = JointPath {
            joint_count: limits.joints.len(),
            positions,
            segment_times: path.segment_times.clone(),
        };
        (limits, path)
    }

    /// Checks that a path keeps within the ranges.
    pub(super) fn admit(&self, path: &JointPath) -> Result<(), TimingError> {
        if self.joints.len() != path.joint_count() {
            return Err(TimingError::UnequalJoints {
                limits: self.joints.len(),
                path: path.joint_count(),
            });
        }
        for waypoint in 0..path.waypoint_count() {
            let q = path.waypoint(waypoint);
            for (joint, &value) in self.joints.iter().zip(q) {
                joint.admit(waypoint, value, 0.0)?;
            }
            for FollowerLimit { limit, drive } in &self.followers {
                limit.admit(waypoint, drive.position(q), FOLLOWER_ROUNDING)?;
            }
        }
        Ok(())
    }
}

impl JointLimit {
    fn check(&self) -> Result<(), TimingError> {
        let ends_are_numbers = !(self.lower.is_nan() || self.upper.is_nan());
        if !ends_are_numbers || self.lower > self.upper {
            return Err(TimingError::EmptyRange {
                joint: self.name.clone(),
                lower: self.lower,
                upper: self.upper,
            });
        }
        for (quantity, value) in [
            ("velocity", self.velocity),
            ("acceleration", self.acceleration),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(TimingError::LimitNotPositive {
                    joint: self.name.clone(),
                    quantity,
                    value,
                });
            }
        }
        Ok(())
    }

    /// Checks that a waypoint's position is in the range, up to rounding.
    fn admit(&self, waypoint: usize, value: f64, rounding: f64) -> Result<(), TimingError> {
        if value < self.lower - rounding || value > self.upper + rounding {
            return Err(TimingError::PositionOutOfRange {
                waypoint,
                joint: self.name.clone(),
                value,
                lower: self.lower,
                upper: self.upper,
            });
        }
        Ok(())
    }
}
