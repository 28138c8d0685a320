//! The result of the timing: the position of every joint at every time.

use super::JointPath;
use super::blends::BlendedPath;

/// Period of a common joint controller \[s\].
pub const SAMPLE_PERIOD: f64 = 1e-3;

/// State of all d joints at one time; units per joint as in its [`JointLimit`](super::JointLimit).
#[derive(Debug, Clone, PartialEq)]
pub struct TrajectorySample {
    /// Time since the start \[s\].
    pub time: f64,
    /// Positions [rad or m].
    pub q: Vec<f64>,
    /// Velocities [rad/s or m/s].
    pub qd: Vec<f64>,
    /// Accelerations [rad/s² or m/s²]; at a jump, the value after it.
    pub qdd: Vec<f64>,
}

impl TrajectorySample {
    /// Returns the state at rest at these positions, at time 0.
    pub fn from_positions(q: &[f64]) -> Self {
        Self {
            time: 0.0,
            q: q.to_vec(),
            qd: vec![0.0; q.len()],
            qdd: vec![0.0; q.len()],
        }
    }
}

/// A part of the trajectory with constant path acceleration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// Start time [s].
    pub time: f64,
    /// Index of the piece of the path.
    pub piece: usize,
    /// σ from the piece's start [s].
    pub offset: f64,
    /// σ̇ at the start [1].
    pub speed: f64,
    /// σ̈ throughout [1/s].
    pub acceleration: f64,
}

/// The part of a trajectory that contains a time, before accelerations are ramped.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// At rest before the start.
    Start,
    /// In a stretch, and the time since its start [s].
    Stretch { index: usize, since: f64 },
    /// At rest after the end, and the time since then [s].
    End { since: f64 },
}

/// The state of a joint at one time, before accelerations are ramped.
#[derive(Debug, Clone, Copy)]
struct JointState {
    /// Integral over time of the displacement since the start [rad s or m s].
    integral: f64,
    q: f64,
    qd: f64,
    qdd: f64,
}

/// A timed path, exact at every time. Between switches of the path acceleration, positions are polynomials in
/// time, of degree 2 (straight pieces) or 4 (blends). [`Trajectory::sample`] evaluates these and their
/// derivatives, or, with an acceleration ramp, their moving average.
#[derive(Debug, Clone)]
pub struct Trajectory {
    path: BlendedPath,
    stretches: Vec<Stretch>,
    /// Duration without the ramp [s].
    duration: f64,
    start: Vec<f64>,
    end: Vec<f64>,
    /// Smallest and largest position of each joint, which an average may leave by rounding.
    ranges: Vec<[f64; 2]>,
    /// Time over which a change of the acceleration is spread [s]; 0 for no ramp.
    ramp: f64,
    /// [`JointState::integral`] per stretch and at the end, for each joint; empty without a ramp.
    integrals: Vec<f64>,
}

impl Trajectory {
    /// Returns the trajectory along this path with rounded corners, in these stretches, from rest to rest.
    pub(super) fn new(
        path: &JointPath,
        rounded: BlendedPath,
        stretches: Vec<Stretch>,
        duration: f64,
    ) -> Self {
        let waypoint = |index| path.waypoint(index);
        let start = waypoint(0);
        let mut ranges: Vec<[f64; 2]> = start.iter().map(|&q| [q, q]).collect();
        for row in (1..path.waypoint_count()).map(waypoint) {
            for ([least, greatest], &q) in ranges.iter_mut().zip(row) {
                *least = least.min(q);
                *greatest = greatest.max(q);
            }
        }
        Self {
            path: rounded,
            stretches,
            duration,
            start: start.to_vec(),
            end: waypoint(path.waypoint_count() - 1).to_vec(),
            ranges,
            ramp: 0.0,
            integrals: Vec::new(),
        }
    }

    /// Duration from rest to rest \[s\]; 0 if all waypoints are the same.
    pub fn duration(&self) -> f64 {
        if self.stretches.is_empty() {
            0.0
        } else {
            self.duration + self.ramp
        }
    }

    /// Number of joints d, the length of every array in its samples.
    pub fn joint_count(&self) -> usize {
        self.end.len()
    }

    /// Returns the same motion, slower by `factor`: velocities are divided by the factor, accelerations by its
    /// square.
    pub fn slow_down(mut self, factor: f64) -> Self {
        for stretch in &mut self.stretches {
            stretch.time *= factor;
            stretch.speed /= factor;
            stretch.acceleration /= factor * factor;
        }
        self.duration *= factor;
        let ramp = self.ramp;
        self.with_acceleration_ramp(ramp)
    }

    /// Returns the moving average of the motion over the time `ramp` \[s\]. Accelerations no longer jump; a
    /// change is spread over that time, and the motion takes that much longer. The jerk is at most twice the
    /// largest acceleration over `ramp`.
    ///
    /// As averages, positions, velocities and accelerations keep their limits; start and end stay the same. A
    /// joint leaves its path by at most its acceleration times the square of the ramp over 24 (Biagiotti and
    /// Melchiorri 2012: trajectories by moving-average filters).
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
    /// let path = JointPath::new(&[[0.0], [1.0]])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let abrupt = time_path(&path, &limits, &TimingConfig::default())?;
    /// let gentle = abrupt.clone().with_acceleration_ramp(0.04);
    /// assert!((abrupt.sample(0.0).qdd[0] - 10.0).abs() < 1e-6);
    /// assert!((gentle.sample(0.02).qdd[0] - 5.0).abs() < 1e-6);
    /// assert!((gentle.duration() - abrupt.duration() - 0.04).abs() < 1e-12);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If `ramp` is negative or not finite.
    #[must_use]
    pub fn with_acceleration_ramp(mut self, ramp: f64) -> Self {
        assert!(
            ramp >= 0.0 && ramp.is_finite(),
            "acceleration ramp {ramp} s is not a finite time of at least 0"
        );
        self.ramp = ramp;
        self.integrals.clear();
        if ramp == 0.0 {
            return self;
        }
        let joints = self.joint_count();
        // At its start no part of a stretch is integrated.
        self.integrals.resize(joints, 0.0);
        for index in 0..self.stretches.len() {
            let next = self.stretches.get(index + 1);
            let end = next.map_or(self.duration, |stretch| stretch.time);
            let since = end - self.stretches[index].time;
            for joint in 0..joints {
                let state = self.joint(Place::Stretch { index, since }, joint);
                self.integrals.push(state.integral);
            }
        }
        self
    }

    /// Times at which the path acceleration changes or a blend begins or ends \[s\]; the first is 0, the last the
    /// duration. With an acceleration ramp, first the starts of these ramps, then their ends.
    pub fn switch_times(&self) -> impl Iterator<Item = f64> {
        let begins = (self.stretches.iter())
            .map(|stretch| stretch.time)
            .chain([self.duration]);
        let is_ramped = self.ramp > 0.0;
        let ends = (begins.clone())
            .filter(move |_| is_ramped)
            .map(|begin| begin + self.ramp);
        begins.chain(ends)
    }

    /// Returns the joints' state at a time \[s\]; at rest at the start before 0, at the end after the duration.
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
    /// let path = JointPath::new(&[[0.0], [1.0]])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
    /// let middle = trajectory.sample(trajectory.duration() / 2.0);
    /// assert!((middle.q[0] - 0.5).abs() < 1e-9 && (middle.qd[0] - 1.0).abs() < 1e-6);
    /// assert_eq!(trajectory.sample(9.0).q, [1.0]);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    pub fn sample(&self, time: f64) -> TrajectorySample {
        let mut sample = TrajectorySample::from_positions(&self.end);
        self.sample_into(time, &mut sample);
        sample
    }

    /// Evaluates the state as [`Trajectory::sample`] into an existing sample of the same number of joints:
    /// without allocation, for control loops.
    ///
    /// # Panics
    ///
    /// If the sample has fewer joints.
    pub fn sample_into(&self, time: f64, sample: &mut TrajectorySample) {
        sample.time = time;
        let is_over = time >= self.duration();
        if is_over || self.stretches.is_empty() {
            sample.q.copy_from_slice(&self.end);
            sample.qd.fill(0.0);
            sample.qdd.fill(0.0);
            return;
        }
        let place = self.place(time);
        let before = (self.ramp > 0.0).then(|| self.place(time - self.ramp));
        for joint in 0..self.joint_count() {
            let now = self.joint(place, joint);
            let [q, qd, qdd] = match before {
                None => [now.q, now.qd, now.qdd],
                Some(before) => {
                    let before = self.joint(before, joint);
                    let way = (now.integral - before.integral) / self.ramp;
                    let [least, greatest] = self.ranges[joint];
                    [
                        (self.start[joint] + way).clamp(least, greatest),
                        (now.q - before.q) / self.ramp,
                        (now.qd - before.qd) / self.ramp,
                    ]
                }
            };
            sample.q[joint] = q;
            sample.qd[joint] = qd;
            sample.qdd[joint] = qdd;
        }
    }

    /// Returns the part of the trajectory that contains a time [s].
    fn place(&self, time: f64) -> Place {
        if time >= self.duration {
            let since = time - self.duration;
            return Place::End { since };
        }
        match self.stretches.partition_point(|s| s.time <= time) {
            0 => Place::Start,
            next => Place::Stretch {
                index: next - 1,
                since: time - self.stretches[next - 1].time,
            },
        }
    }

    /// Returns the state of a joint at a place.
    fn joint(&self, place: Place, joint: usize) -> JointState {
        let joints = self.joint_count();
        let begun = |stretch: usize| (self.integrals.get(stretch * joints + joint)).copied();
        let at_rest = |q: f64, integral: f64| JointState {
            integral,
            q,
            qd: 0.0,
            qdd: 0.0,
        };
        let start = self.start[joint];
        let (index, since) = match place {
            Place::Start => return at_rest(start, 0.0),
            Place::End { since } => {
                let end = self.end[joint];
                let integral = begun(self.stretches.len()).unwrap_or(0.0) + since * (end - start);
                return at_rest(end, integral);
            }
            Place::Stretch { index, since } => (index, since),
        };
        let Stretch {
            piece,
            offset,
            speed,
            acceleration,
            ..
        } = self.stretches[index];
        // The columns of mimic joints are behind those of the joints.
        let [q, d1, d2] = self.path.terms(piece)[joint];
        // σ(t) = σ₀ + σ̇₀ t + σ̈ t² / 2; q(σ) = q + σ q′ + σ² q″ / 2; q̇ = q′(σ) σ̇; q̈ = q′(σ) σ̈ + q″ σ̇².
        let along = offset + since * (speed + 0.5 * since * acceleration);
        let slope = d1 + along * d2;
        let speed_now = speed + since * acceleration;
        let integral = begun(index).map_or(0.0, |begun| {
            // Integrals of σ and of σ² over the time since the start of the stretch.
            let of_way = since * (offset + since * (speed / 2.0 + since * acceleration / 6.0));
            let cubic = (speed * speed + offset * acceleration) / 3.0;
            let quartic = speed * acceleration / 4.0;
            let quintic = acceleration * acceleration / 20.0;
            let of_square = since
                * (offset * offset
                    + since
                        * (offset * speed + since * (cubic + since * (quartic + since * quintic))));
            begun + since * (q - start) + d1 * of_way + 0.5 * d2 * of_square
        });
        JointState {
            integral,
            q: q + along * (d1 + 0.5 * along * d2),
            qd: slope * speed_now,
            qdd: slope * acceleration + d2 * speed_now * speed_now,
        }
    }

    /// Returns the states at 0, p, 2p, … for a period p > 0 \[s\], for example [`SAMPLE_PERIOD`]. The last state
    /// is the first at or after the duration, at rest at the end.
    ///
    /// ```
    /// use wisch_robot::timing::{JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, time_path};
    /// let path = JointPath::new(&[[0.0], [1.0]])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
    /// let samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
    /// assert_eq!(samples[1].time, 0.001);
    /// assert_eq!(samples.last().unwrap().q, [1.0]);
    /// # Ok::<(), wisch_robot::timing::TimingError>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If the period is not positive.
    pub fn samples(&self, period: f64) -> impl Iterator<Item = TrajectorySample> {
        assert!(period > 0.0, "sample period {period} s is not positive");
        let count = (self.duration() / period).ceil() as usize;
        (0..=count).map(move |k| {
            let time = k as f64 * period;
            // Rounding must not put the last sample an instant before the end.
            let state = self.sample(if k == count { self.duration() } else { time });
            TrajectorySample { time, ..state }
        })
    }
}
