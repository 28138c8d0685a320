//! The latest values that a robot has sent, with the time of their arrival.

use crate::link::{Link, LinkError};
use crate::messages::{
    Bool, ControllerProgress, Float64, JointStateMessage, SafetyMode, WrenchStamped,
};
use crate::robot_file::RobotFile;
use ros2_client::Gid;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Time for which a publisher counts after its last message.
const PUBLISHER_MEMORY: Duration = Duration::from_secs(2);

/// A measured state of all joints, in the order of the URDF.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JointReading {
    pub arrival: Instant,
    /// The robot's stamp [s].
    pub stamp: f64,
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    /// Empty if the robot sends none.
    pub efforts: Vec<f64>,
    /// Number of states since the beginning.
    pub number: u64,
}

/// A measured wrench.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WrenchReading {
    pub arrival: Instant,
    /// Arrival of the first message with this stamp: a driver may repeat a measurement.
    pub measured: Instant,
    /// The robot's stamp [s]; 0 if it states none.
    pub stamp: f64,
    pub frame: String,
    /// Force in the axes of the frame, as sent [N].
    pub force: [f64; 3],
}

/// A time on a controller's trajectory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ProgressReading {
    pub arrival: Instant,
    /// The robot's stamp [s].
    pub stamp: f64,
    /// Time on the trajectory [s].
    pub time: f64,
}

/// The latest values.
#[derive(Debug, Default)]
pub(crate) struct Readings {
    pub joints: Option<JointReading>,
    pub wrench: Option<WrenchReading>,
    /// The controller's latest time on its trajectory.
    pub progress: Option<ProgressReading>,
    /// Share of the commanded speed (0 to 1), with its arrival.
    pub scaling: Option<(Instant, f64)>,
    pub safety_mode: Option<u8>,
    pub program_runs: Option<bool>,
    /// Publishers of states of these joints, with their last message.
    publishers: Vec<(Gid, Instant)>,
    /// A joint that a state with some of the robot's joints lacks.
    pub missing_joint: Option<String>,
    /// Numbers of messages: joint states and wrenches.
    pub counts: [u64; 2],
    /// Whether a joint state held a number that is not finite.
    pub is_not_finite: bool,
}

impl Readings {
    /// Number of publishers that send states of the robot's joints.
    pub fn publisher_count(&self) -> usize {
        let recent = self.publishers.iter();
        recent
            .filter(|(_, last)| last.elapsed() < PUBLISHER_MEMORY)
            .count()
    }

    /// Takes a state. Joints may come in any order, and other joints may be among them.
    fn take_joints(&mut self, names: &[String], message: &JointStateMessage, from: Gid) {
        let index = |name: &String| message.name.iter().position(|given| given == name);
        let order: Option<Vec<usize>> = names.iter().map(index).collect();
        let Some(order) = order else {
            if names.iter().any(|name| index(name).is_some()) {
                self.missing_joint = names.iter().find(|name| index(name).is_none()).cloned();
            }
            return;
        };
        let arrival = Instant::now();
        match self.publishers.iter_mut().find(|(gid, _)| *gid == from) {
            Some((_, last)) => *last = arrival,
            None => self.publishers.push((from, arrival)),
        }
        let pick = |values: &[f64]| -> Vec<f64> {
            let picked = order.iter().map(|i| values.get(*i).copied());
            picked.collect::<Option<_>>().unwrap_or_default()
        };
        let positions = pick(&message.position);
        let velocities = pick(&message.velocity);
        let all = positions.iter().chain(&velocities);
        if positions.is_empty() || all.clone().any(|value| !value.is_finite()) {
            self.is_not_finite = true;
            return;
        }
        self.is_not_finite = false;
        self.counts[0] += 1;
        let efforts = pick(&message.effort);
        self.joints = Some(JointReading {
            arrival,
            stamp: message.header.stamp.seconds(),
            positions,
            velocities,
            efforts: if efforts.iter().all(|effort| effort.is_finite()) {
                efforts
            } else {
                Vec::new()
            },
            number: self.counts[0],
        });
    }

    fn take_wrench(&mut self, message: WrenchStamped) {
        let force = message.wrench.linear;
        let force = [force.x, force.y, force.z];
        if force.iter().all(|value| value.is_finite()) {
            self.counts[1] += 1;
            let (arrival, stamp) = (Instant::now(), message.header.stamp.seconds());
            let repeated = self.wrench.as_ref();
            let repeated = repeated.filter(|before| stamp > 0.0 && before.stamp == stamp);
            self.wrench = Some(WrenchReading {
                arrival,
                measured: repeated.map_or(arrival, |before| before.measured),
                stamp,
                frame: message.header.frame_id,
                force,
            });
        }
    }
}

/// Readings that the threads of subscriptions write, and a condition variable that each joint state notifies.
#[derive(Debug, Clone, Default)]
pub(crate) struct SharedReadings(Arc<(Mutex<Readings>, Condvar)>);

impl SharedReadings {
    pub fn lock(&self) -> MutexGuard<'_, Readings> {
        self.0.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until a joint state arrives, at most for `limit`, and returns the latest readings.
    pub fn wait(&self, limit: Duration) -> MutexGuard<'_, Readings> {
        let guard = self.lock();
        let waited = self.0.1.wait_timeout(guard, limit);
        waited.unwrap_or_else(PoisonError::into_inner).0
    }

    fn update(&self, change: impl FnOnce(&mut Readings)) {
        change(&mut self.lock());
        self.0.1.notify_all();
    }

    /// Subscribes all topics of the robot file. `names`: joints in the order of the URDF.
    ///
    /// # Errors
    /// If DDS refuses a subscription.
    pub fn subscribe(
        link: &mut Link,
        file: &RobotFile,
        names: Vec<String>,
    ) -> Result<Self, LinkError> {
        let shared = Self::default();
        let to = shared.clone();
        let joint_state = ["sensor_msgs", "JointState"];
        link.listen::<JointStateMessage>(
            &file.motion.joint_states,
            joint_state,
            false,
            move |message, info| {
                to.update(|readings| readings.take_joints(&names, &message, info.publisher_gid()));
            },
        )?;
        if let Some(topic) = &file.force.topic {
            let to = shared.clone();
            let kind = ["geometry_msgs", "WrenchStamped"];
            link.listen::<WrenchStamped>(topic, kind, false, move |message, _| {
                to.update(|readings| readings.take_wrench(message));
            })?;
        }
        if let Some(topic) = &file.motion.progress {
            let to = shared.clone();
            let kind = ["control_msgs", "JointTrajectoryControllerState"];
            link.listen::<ControllerProgress>(topic, kind, false, move |message, _| {
                let progress = ProgressReading {
                    arrival: Instant::now(),
                    stamp: message.header.stamp.seconds(),
                    time: message.reference.time_from_start.seconds(),
                };
                to.update(|readings| readings.progress = Some(progress));
            })?;
        }
        if let Some(topic) = &file.motion.scaling {
            let (to, full) = (shared.clone(), file.motion.full_scaling);
            link.listen::<Float64>(topic, ["std_msgs", "Float64"], false, move |message, _| {
                if message.data.is_finite() {
                    let share = message.data / full;
                    to.update(|readings| readings.scaling = Some((Instant::now(), share)));
                }
            })?;
        }
        if let Some(topic) = &file.stop.safety {
            let to = shared.clone();
            let kind = ["ur_dashboard_msgs", "SafetyMode"];
            link.listen::<SafetyMode>(topic, kind, true, move |message, _| {
                to.update(|readings| readings.safety_mode = Some(message.mode));
            })?;
        }
        if let Some(topic) = &file.stop.program {
            let to = shared.clone();
            link.listen::<Bool>(topic, ["std_msgs", "Bool"], true, move |message, _| {
                to.update(|readings| readings.program_runs = Some(message.data));
            })?;
        }
        Ok(shared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::Header;

    fn names() -> Vec<String> {
        ["a", "b"].map(str::to_owned).to_vec()
    }

    fn gid(byte: u8) -> Gid {
        Gid::from(rustdds::GUID::from_bytes([byte; 16]))
    }

    fn state(names: &[&str], position: &[f64]) -> JointStateMessage {
        JointStateMessage {
            header: Header::default(),
            name: names.iter().map(|name| (*name).to_owned()).collect(),
            position: position.to_vec(),
            velocity: vec![0.0; position.len()],
            effort: Vec::new(),
        }
    }

    #[test]
    fn joints_are_put_into_the_order_of_the_urdf() {
        let mut readings = Readings::default();
        let message = state(&["b", "gripper", "a"], &[2.0, 9.0, 1.0]);
        readings.take_joints(&names(), &message, gid(1));
        let joints = readings.joints.as_ref().unwrap();
        assert_eq!(joints.positions, [1.0, 2.0]);
        assert_eq!(joints.efforts, [0.0; 0]);
        assert_eq!(readings.publisher_count(), 1);
    }

    #[test]
    fn a_state_of_other_joints_is_ignored_and_one_that_lacks_a_joint_is_noted() {
        let mut readings = Readings::default();
        readings.take_joints(&names(), &state(&["gripper"], &[1.0]), gid(1));
        assert_eq!(
            (readings.joints.clone(), readings.missing_joint.clone()),
            (None, None)
        );
        readings.take_joints(&names(), &state(&["a"], &[1.0]), gid(1));
        assert_eq!(readings.missing_joint.as_deref(), Some("b"));
        assert_eq!(readings.publisher_count(), 0);
    }

    #[test]
    fn a_wrench_with_the_stamp_of_the_one_before_is_no_new_measurement() {
        let mut readings = Readings::default();
        let mut take = |stamp: f64| {
            let mut message = WrenchStamped::default();
            message.header.stamp = crate::messages::Stamp::from_seconds(stamp);
            std::thread::sleep(Duration::from_millis(1));
            readings.take_wrench(message);
            readings.wrench.clone().unwrap()
        };
        let [first, second, third] = [1.0, 1.0, 1.01].map(&mut take);
        assert_eq!(second.measured, first.measured);
        assert!(second.arrival > first.arrival);
        assert_eq!(third.measured, third.arrival);
        // A stamp of 0 says nothing.
        let [fourth, fifth] = [0.0, 0.0].map(take);
        assert!(fifth.measured > fourth.measured);
    }

    #[test]
    fn a_second_publisher_is_counted_and_a_number_that_is_not_finite_is_noted() {
        let mut readings = Readings::default();
        for from in [1, 2] {
            readings.take_joints(&names(), &state(&["a", "b"], &[1.0, 2.0]), gid(from));
        }
        assert_eq!(readings.publisher_count(), 2);
        readings.take_joints(&names(), &state(&["a", "b"], &[f64::NAN, 2.0]), gid(1));
        assert!(readings.is_not_finite);
        assert_eq!(readings.joints.unwrap().positions, [1.0, 2.0]);
    }
}
