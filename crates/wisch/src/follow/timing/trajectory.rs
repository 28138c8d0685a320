//! The answer: where every joint is at every time.

use super::blends::BlendedPath;

/// Period of a usual joint controller [s].
pub const SAMPLE_PERIOD: f64 = 1e-3;

/// State of all d joints at one time; units per joint as in its [`JointLimit`](super::JointLimit).
#[derive(Debug, Clone, PartialEq)]
pub struct TrajectorySample {
    /// Time since the start [s].
    pub time: f64,
    /// Positions [rad or m].
    pub q: Vec<f64>,
    /// Velocities [rad/s or m/s].
    pub qd: Vec<f64>,
    /// Accelerations [rad/s² or m/s²]; where they jump, those that follow.
    pub qdd: Vec<f64>,
}

impl TrajectorySample {
    /// At rest at these positions, at time 0.
    pub fn at_rest(q: &[f64]) -> Self {
        Self {
            time: 0.0,
            q: q.to_vec(),
            qd: vec![0.0; q.len()],
            qdd: vec![0.0; q.len()],
        }
    }
}

/// A stretch of constant path acceleration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// When it begins [s].
    pub time: f64,
    /// The piece of the path it lies in.
    pub piece: usize,
    /// σ since the piece's begin [s].
    pub offset: f64,
    /// σ̇ at its begin [1].
    pub speed: f64,
    /// σ̈ throughout [1/s].
    pub acceleration: f64,
}

/// A timed path, exact at every time: between switches of the path acceleration, positions are polynomials
/// of degree 2 (straight pieces) or 4 (blends) in time, and [`Trajectory::sample`] evaluates these and
/// their derivatives.
#[derive(Debug, Clone)]
pub struct Trajectory {
    pub(super) path: BlendedPath,
    pub(super) stretches: Vec<Stretch>,
    pub(super) duration: f64,
    pub(super) start: Vec<f64>,
    pub(super) end: Vec<f64>,
}

impl Trajectory {
    /// Time from rest to rest [s]; 0 if all waypoints are the same.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Number of joints d, the length of every array in its samples.
    pub fn joint_count(&self) -> usize {
        self.end.len()
    }

    /// The same way, so many times slower at every place: velocities are divided by the factor, accelerations by its
    /// square.
    pub(in crate::follow) fn slowed(mut self, factor: f64) -> Self {
        for stretch in &mut self.stretches {
            stretch.time *= factor;
            stretch.speed /= factor;
            stretch.acceleration /= factor * factor;
        }
        self.duration *= factor;
        self
    }

    /// When the path acceleration changes or a blend begins or ends [s]; first 0, last the duration.
    pub fn switch_times(&self) -> impl Iterator<Item = f64> {
        let begins = self.stretches.iter().map(|stretch| stretch.time);
        begins.chain([self.duration])
    }

    /// The joints' state at a time [s]; at rest at the start before 0, at the end after the duration.
    ///
    /// ```
    /// use wisch::follow::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
    /// let path = JointPath::new(&[[0.0], [1.0]])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
    /// let middle = trajectory.sample(trajectory.duration() / 2.0);
    /// assert!((middle.q[0] - 0.5).abs() < 1e-9 && (middle.qd[0] - 1.0).abs() < 1e-6);
    /// assert_eq!(trajectory.sample(9.0).q, [1.0]);
    /// # Ok::<(), wisch::follow::TimingError>(())
    /// ```
    pub fn sample(&self, time: f64) -> TrajectorySample {
        let mut sample = TrajectorySample::at_rest(&self.end);
        self.sample_into(time, &mut sample);
        sample
    }

    /// As [`Trajectory::sample`], into a sample of as many joints that is there already: without allocation,
    /// for control loops.
    ///
    /// # Panics
    ///
    /// If the sample is of fewer joints.
    pub fn sample_into(&self, time: f64, sample: &mut TrajectorySample) {
        sample.time = time;
        let next = self.stretches.partition_point(|s| s.time <= time);
        if next == 0 || time >= self.duration {
            let is_before = next == 0 && time < self.duration;
            let q = if is_before { &self.start } else { &self.end };
            sample.q.copy_from_slice(q);
            sample.qd.fill(0.0);
            sample.qdd.fill(0.0);
            return;
        }
        let stretch = &self.stretches[next - 1];
        let since = time - stretch.time;
        let along = stretch.offset + since * (stretch.speed + 0.5 * since * stretch.acceleration);
        let speed = stretch.speed + since * stretch.acceleration;
        // Behind the joints' columns are those of joints that follow them.
        let columns = self
            .path
            .terms(stretch.piece)
            .iter()
            .take(self.joint_count());
        for (i, [q, d1, d2]) in columns.enumerate() {
            let slope = d1 + along * d2;
            sample.q[i] = q + along * (d1 + 0.5 * along * d2);
            sample.qd[i] = slope * speed;
            sample.qdd[i] = slope * stretch.acceleration + d2 * speed * speed;
        }
    }

    /// The states at 0, p, 2p, … for a period p > 0 [s], such as [`SAMPLE_PERIOD`]; the last one is the
    /// first at or after the duration, at rest at the end.
    ///
    /// ```
    /// use wisch::follow::{JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, time_path};
    /// let path = JointPath::new(&[[0.0], [1.0]])?;
    /// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
    /// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
    /// let samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
    /// assert_eq!(samples[1].time, 0.001);
    /// assert_eq!(samples.last().unwrap().q, [1.0]);
    /// # Ok::<(), wisch::follow::TimingError>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If the period is not positive.
    pub fn samples(&self, period: f64) -> impl Iterator<Item = TrajectorySample> {
        assert!(period > 0.0, "sample period {period} s is not positive");
        let count = (self.duration / period).ceil() as usize;
        (0..=count).map(move |k| {
            let time = k as f64 * period;
            // Rounding must not leave the last sample an instant before the end.
            let state = self.sample(if k == count { self.duration } else { time });
            TrajectorySample { time, ..state }
        })
    }
}
