//! How fast a goal moves along its trajectory.

/// Time in which a goal reaches its speed if it begins where its trajectory moves [s], and steps in that time.
const RAMP_TIME: f64 = 0.5;
const RAMP_STEPS: usize = 10;

/// The time on the trajectory at each time of a goal.
///
/// A goal that continues after a pause begins at rest in the middle of its trajectory. Its speed then rises from 0 by the
/// polynomial 10 x³ − 15 x⁴ + 6 x⁵, so that positions, velocities and accelerations are continuous.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GoalPace {
    /// Time on the trajectory at which the goal begins, as planned [s].
    pub from: f64,
    /// Share of the planned speed, after the ramp.
    pub speed: f64,
    /// Time in which the speed is reached [s].
    pub ramp: f64,
}

impl GoalPace {
    /// The pace of a goal that begins where its trajectory rests.
    pub const fn from_rest(from: f64, speed: f64) -> Self {
        let ramp = 0.0;
        Self { from, speed, ramp }
    }

    /// The pace of a goal that continues within its trajectory, up to its `end` [s]. It takes at least as long as its ramp:
    /// near the end it is slower than `speed`.
    pub fn resume(from: f64, end: f64, speed: f64) -> Self {
        let most = (end - from).max(0.0) / (RAMP_TIME / 2.0);
        Self {
            from,
            speed: speed.min(most),
            ramp: RAMP_TIME,
        }
    }

    /// Time on the trajectory [s], its first derivative, and its second one [1/s], at a time since the goal began [s].
    pub fn evaluate(&self, since: f64) -> [f64; 3] {
        let Self { from, speed, ramp } = *self;
        if since >= ramp {
            return [from + (since - ramp / 2.0) * speed, speed, 0.0];
        }
        let x = since.max(0.0) / ramp;
        let share = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
        let rate = 30.0 * x * x * (1.0 - x) * (1.0 - x);
        let way = x * x * x * x * (2.5 - 3.0 * x + x * x);
        [
            from + speed * ramp * way,
            speed * share,
            speed * rate / ramp,
        ]
    }

    /// Time since the goal began [s] at which it is at a time on the trajectory after the ramp [s].
    pub fn since(&self, time: f64) -> f64 {
        (time - self.from) / self.speed + self.ramp / 2.0
    }

    /// Times since the goal began [s] at which points follow the ramp closely; none without a ramp.
    pub fn ramp_times(&self) -> Vec<f64> {
        let steps = 1..=RAMP_STEPS;
        let times = steps.map(|step| self.ramp * step as f64 / RAMP_STEPS as f64);
        times.filter(|time| *time > 0.0).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_derivatives_of_a_ramp_are_those_of_its_time_and_the_speed_rises_from_0() {
        let pace = GoalPace::resume(3.0, 9.0, 0.8);
        assert_eq!(pace.evaluate(0.0), [3.0, 0.0, 0.0]);
        let step = 1e-5;
        for since in [0.05, 0.2, 0.37, 0.499, 0.6, 2.0] {
            let [before, now, after] =
                [since - step, since, since + step].map(|t| pace.evaluate(t));
            let rate = (after[0] - before[0]) / (2.0 * step);
            let curve = (after[1] - before[1]) / (2.0 * step);
            assert!((rate - now[1]).abs() < 1e-6, "{since}: {rate}, {now:?}");
            assert!((curve - now[2]).abs() < 1e-3, "{since}: {curve}, {now:?}");
            assert!(now[1] <= 0.8 + 1e-12);
        }
        let late = pace.since(7.0);
        assert!((pace.evaluate(late)[0] - 7.0).abs() < 1e-12);
    }

    #[test]
    fn a_goal_that_continues_near_its_end_takes_as_long_as_its_ramp() {
        for left in [0.0, 1e-6, 0.1] {
            let pace = GoalPace::resume(3.0, 3.0 + left, 1.0);
            assert!((pace.evaluate(RAMP_TIME)[0] - 3.0 - left).abs() < 1e-12);
        }
        let far = GoalPace::resume(3.0, 4.0, 1.0);
        assert_eq!((far.speed, far.since(4.0)), (1.0, 1.25));
    }
}
