//! Jumps of the measured joint state that no motion of the robot explains.

use crate::readings::JointReading;

/// Time by which the difference of two stamps may be too short [s]: a computer under load sends states late, and then quickly.
const STAMP_JITTER_S: f64 = 0.03;
/// Time before a jump in which the greatest force is stated [s].
const PUSH_S: f64 = 1.0;

/// Watches the joint states of one motion.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JumpWatch {
    /// Largest velocity of each joint by the URDF [rad/s or m/s]; a joint without one is not watched.
    limits: Vec<Option<f64>>,
    /// Unit of the positions of each joint: "rad" or "m".
    units: Vec<&'static str>,
    count: usize,
    /// Greatest force on the tool in the last second [N], and its stamp [s].
    push: [f64; 2],
}

impl JumpWatch {
    /// Begins to watch. `limits`: largest velocity of each joint [rad/s or m/s]; `units`: unit of its positions, "rad" or "m".
    pub const fn new(limits: Vec<Option<f64>>, units: Vec<&'static str>) -> Self {
        Self {
            limits,
            units,
            count: 0,
            push: [0.0; 2],
        }
    }

    /// Compares a state with the one before, and returns a remark on the first jump of a motion.
    ///
    /// - `force`: force on the tool at the time of `now` [N]; `None` without a tare.
    /// - `began`: stamp at which the motion began [s].
    pub fn check(
        &mut self,
        names: &[String],
        [before, now]: [&JointReading; 2],
        force: Option<f64>,
        began: f64,
    ) -> Option<String> {
        let force = force.unwrap_or(0.0);
        if force >= self.push[0] || now.stamp - self.push[1] > PUSH_S {
            self.push = [force, now.stamp];
        }
        let elapsed = (now.stamp - before.stamp).max(0.0);
        let joints = before.positions.iter().zip(&now.positions);
        let joints = joints.map(|(before, now)| (now - before).abs());
        let units = &self.units;
        let joints = names.iter().zip(units).zip(&self.limits).zip(joints);
        let jumped = joints.filter_map(|((joint, limit), way)| {
            let limit = (*limit)?;
            let most = limit * (elapsed + STAMP_JITTER_S);
            (way > most).then_some((joint, limit, way, most))
        });
        let (joint, limit, way, most) =
            jumped.max_by(|a, b| (a.2 / a.3).total_cmp(&(b.2 / b.3)))?;
        let (name, unit) = joint;
        self.count += 1;
        if self.count > 1 {
            return None;
        }
        let push = match self.push[0] {
            0.0 => String::new(),
            force => format!(" In the second before, the force on the tool reached {force:.1} N."),
        };
        Some(format!(
            "at {:.2} s joint {name:?} jumped by {way:.3} {unit} within {:.0} ms; its limit of {limit} {unit}/s in the URDF \
             explains {most:.3} {unit}.{push} Check whether joint states get lost, and whether they are measured",
            now.stamp - began,
            1e3 * elapsed
        ))
    }

    /// Returns a remark on further jumps, if there were any.
    pub fn remark_on_further_jumps(&self) -> Option<String> {
        let further = self.count.checked_sub(1).filter(|further| *further > 0)?;
        Some(format!(
            "the joint state jumped {further} more times in this motion"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    fn state(stamp: f64, positions: [f64; 2]) -> JointReading {
        JointReading {
            arrival: Instant::now(),
            stamp,
            positions: positions.to_vec(),
            velocities: vec![0.0; 2],
            efforts: Vec::new(),
            number: 0,
        }
    }

    #[test]
    fn a_state_that_the_velocity_limit_does_not_explain_is_remarked_once() {
        let names = ["a", "b"].map(str::to_owned);
        let mut watch = JumpWatch::new(vec![Some(2.0), None], vec!["rad", "m"]);
        let mut check = |from: (f64, [f64; 2]), to: (f64, [f64; 2]), force| {
            let states = [state(from.0, from.1), state(to.0, to.1)];
            watch.check(&names, [&states[0], &states[1]], force, 100.0)
        };
        // 2 rad/s explain 0.068 rad in 4 ms, with the allowance for stamps; joint b has no limit.
        let begin = (101.0, [0.0, 0.0]);
        assert_eq!(check(begin, (101.004, [0.067, 3.0]), Some(24.5)), None);
        // A lost message explains more.
        assert_eq!(check(begin, (101.1, [0.2, 0.0]), Some(1.0)), None);
        let remark = check(begin, (101.004, [-0.07, 0.0]), Some(2.0)).unwrap();
        assert!(
            remark.starts_with(
                "at 1.00 s joint \"a\" jumped by 0.070 rad within 4 ms; its limit of 2 rad/s"
            ),
            "{remark}"
        );
        assert!(
            remark.contains("explains 0.068 rad. In the second before"),
            "{remark}"
        );
        assert!(remark.contains("24.5 N"), "{remark}");
        assert_eq!(check(begin, (101.004, [1.0, 0.0]), None), None);
        let further = watch.remark_on_further_jumps().unwrap();
        assert!(further.contains("1 more times"), "{further}");
    }

    #[test]
    fn a_force_that_is_long_past_is_not_stated() {
        let names = ["a".to_owned(), "b".to_owned()];
        let mut watch = JumpWatch::new(vec![Some(2.0); 2], vec!["m"; 2]);
        let [early, late, later] = [0.0, 2.0, 2.004].map(|stamp| state(stamp, [0.0; 2]));
        let jumped = state(2.006, [1.0, 0.0]);
        assert_eq!(watch.check(&names, [&early, &early], Some(40.0), 0.0), None);
        assert_eq!(watch.check(&names, [&early, &late], None, 0.0), None);
        let remark = watch.check(&names, [&later, &jumped], None, 0.0).unwrap();
        assert!(
            !remark.contains("second before") && remark.contains("by 1.000 m within"),
            "{remark}"
        );
        assert_eq!(watch.remark_on_further_jumps(), None);
    }
}
