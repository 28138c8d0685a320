//! A connected robot: topics, services and the action, and what forbids to move it.

use crate::controllers::{ControllerManager, controller_faults};
use crate::frames::Frames;
use crate::goals::{GoalSender, TrajectoryAction};
use crate::link::{Link, service_qos};
use crate::messages::{EmptyRequest, ForceModeRequest, ForceModeResponse, TriggerResponse};
use crate::protocol::Kind;
use crate::readings::{Readings, SharedReadings};
use crate::robot_file::{ForceKind, RobotFile};
use crate::service::{Service, wait_for_match};
use ros2_client::action::ActionClientQosPolicies;
use ros2_client::qos::Durability;
use ros2_client::{ActionTypeName, Name};
use std::time::{Duration, Instant};

/// Time over which rates are measured.
pub(crate) const SURVEY: Duration = Duration::from_millis(600);
/// Accepted range of the rate of the robot's clock, divided by that of this computer's clock [1].
const CLOCK_RATIO: [f64; 2] = [0.8, 1.25];
/// The safety mode in which a robot of Universal Robots may move.
const NORMAL: u8 = 1;

/// Longest silence of the speed scaling: without it, a pause would not be noticed.
const SCALING_AGE: Duration = Duration::from_millis(500);

/// Services of force mode.
pub(crate) struct ForceMode {
    pub start: Service<ForceModeRequest, ForceModeResponse>,
    pub stop: Service<EmptyRequest, TriggerResponse>,
}

/// A connected robot.
pub(crate) struct Connection {
    pub file: RobotFile,
    pub frames: Frames,
    /// Names of the joints, in the order of the URDF.
    pub names: Vec<String>,
    pub link: Link,
    pub readings: SharedReadings,
    pub manager: ControllerManager,
    pub action: TrajectoryAction,
    pub goals: GoalSender,
    pub tare: Option<Service<EmptyRequest, TriggerResponse>>,
    pub force: Option<ForceMode>,
}

/// Rates that were measured over a short time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Survey {
    /// Rate of joint states and wrenches [Hz].
    pub rates: [f64; 2],
    /// Rate of the robot's clock, divided by that of this computer's clock [1]; `None` without two joint states.
    pub clock_ratio: Option<f64>,
}

impl Connection {
    /// Connects to the robot of a file. `node`: name of this program's node.
    ///
    /// # Errors
    /// If the URDF cannot be read, or a service or the action is not found.
    pub fn open(file: RobotFile, node: &str) -> Result<Self, String> {
        let frames = Frames::read(&file.path, &file.urdf, file.base_frame.as_deref())?;
        let names = frames.joint_names();
        let text = |error: crate::link::LinkError| error.to_string();
        let mut link = Link::open(&file.link, node).map_err(text)?;
        let readings = SharedReadings::subscribe(&mut link, &file, names.clone()).map_err(text)?;
        let deadline = Instant::now() + Duration::from_secs_f64(file.link.discovery_s);
        let choice = file.link.service_mapping;
        let (action, goals) = connect_action(&mut link, &file, deadline)?;
        let manager = ControllerManager::connect(&mut link, &file, deadline).map_err(text)?;
        let trigger = ["std_srvs", "Trigger"];
        let tare = (file.force.tare.as_ref())
            .map(|name| Service::connect(&mut link, name, trigger, choice, deadline))
            .transpose()
            .map_err(text)?;
        let force = if file.force.kind == ForceKind::UrForceMode {
            let start = ["ur_msgs", "SetForceMode"];
            let (begin, end) = (&file.force.start, &file.force.stop);
            Some(ForceMode {
                start: Service::connect(&mut link, begin, start, choice, deadline).map_err(text)?,
                stop: Service::connect(&mut link, end, trigger, choice, deadline).map_err(text)?,
            })
        } else {
            None
        };
        let connection = Self {
            frames,
            names,
            link,
            readings,
            manager,
            action,
            goals,
            tare,
            force,
            file,
        };
        connection.wait_for_readings(deadline);
        Ok(connection)
    }

    /// Waits until every topic has sent a value, at most until `deadline`.
    fn wait_for_readings(&self, deadline: Instant) {
        let file = &self.file;
        loop {
            let readings = self.readings.wait(Duration::from_millis(20));
            let is_complete = readings.joints.is_some()
                && (file.force.topic.is_none() || readings.wrench.is_some())
                && (file.motion.scaling.is_none() || readings.scaling.is_some())
                && (file.stop.safety.is_none() || readings.safety_mode.is_some())
                && (file.stop.program.is_none() || readings.program_runs.is_some());
            if is_complete || Instant::now() >= deadline {
                return;
            }
        }
    }

    /// Measures rates for a short time.
    pub fn survey(&self) -> Survey {
        let take = || {
            let readings = self.readings.lock();
            let joints = readings.joints.as_ref();
            (readings.counts, joints.map(|j| (j.stamp, j.arrival)))
        };
        let (before, first) = take();
        std::thread::sleep(SURVEY);
        let (after, last) = take();
        let rate = |k: usize| (after[k] - before[k]) as f64 / SURVEY.as_secs_f64();
        let clock_ratio = first.zip(last).and_then(|((s0, a0), (s1, a1))| {
            let elapsed = a1.saturating_duration_since(a0).as_secs_f64();
            (elapsed > 0.1).then(|| (s1 - s0) / elapsed)
        });
        Survey {
            rates: [rate(0), rate(1)],
            clock_ratio,
        }
    }

    /// Returns everything that forbids a motion, each with its number.
    pub fn faults(&self, survey: &Survey) -> Vec<String> {
        let mut faults = Vec::new();
        let clocks = self.link.publishers("/clock").len();
        if clocks > 0 {
            faults.push(format!(
                "/clock has {clocks} publishers: the robot runs on simulation time"
            ));
        }
        if let Some(ratio) = survey.clock_ratio
            && !(CLOCK_RATIO[0]..=CLOCK_RATIO[1]).contains(&ratio)
        {
            faults.push(format!(
                "the stamps of joint states advance by {ratio:.2} s per second; expected {} to {}",
                CLOCK_RATIO[0], CLOCK_RATIO[1]
            ));
        }
        let topic = self.trajectory_topic();
        let writers = self.link.publishers(&topic).len();
        if writers > 0 {
            faults.push(format!(
                "{topic} has {writers} publishers that may command the robot; expected 0"
            ));
        }
        match self.manager.list() {
            Ok(listed) => {
                let needed = &self.file.motion.controllers;
                faults.extend(controller_faults(&listed, needed, &self.names));
            }
            Err(error) => faults.push(error.to_string()),
        }
        faults.extend(self.reading_faults(&self.readings.lock()));
        faults
    }

    /// The topic by which a trajectory controller also takes commands.
    pub fn trajectory_topic(&self) -> String {
        let action = &self.file.motion.action;
        let controller = action.rfind('/').map_or("", |at| &action[..at]);
        format!("{controller}/joint_trajectory")
    }

    /// Returns what the latest readings forbid.
    fn reading_faults(&self, readings: &Readings) -> Vec<String> {
        let mut faults = Vec::new();
        let topic = &self.file.motion.joint_states;
        match (&readings.joints, &readings.missing_joint) {
            (None, Some(joint)) => faults.push(format!(
                "{topic} lacks joint {joint:?} of the URDF; expected {}",
                self.names.join(", ")
            )),
            (None, None) => faults.push(format!("{topic} has sent no state of the robot's joints")),
            (Some(joints), _) if joints.velocities.is_empty() => faults.push(format!(
                "{topic} has no velocities, so a robot at rest cannot be recognised"
            )),
            (Some(_), _) => {}
        }
        let publishers = readings.publisher_count();
        if publishers > 1 {
            faults.push(format!(
                "{publishers} publishers send states of these joints on {topic}; expected 1. \
                 If these are several robots, set link.domain or link.interfaces"
            ));
        }
        if let (Some(topic), Some(wrench)) = (&self.file.force.topic, &readings.wrench) {
            let frame = self.file.force.link.as_ref().unwrap_or(&wrench.frame);
            if self.frames.link(frame).is_none() {
                faults.push(format!(
                    "{topic} has frame {frame:?}, which is no link of the URDF; set force.link"
                ));
            }
        }
        faults.extend(self.stop_reason(readings).map(|(_, reason)| reason));
        faults
    }

    /// Returns why a motion must stop at once: a stale or missing value, or a robot that may not move.
    pub fn stop_reason(&self, readings: &Readings) -> Option<(Kind, String)> {
        let (file, limits) = (&self.file, &self.file.limits);
        if let Some(topic) = &file.stop.safety {
            match readings.safety_mode {
                Some(NORMAL) => {}
                Some(mode) => {
                    let (kind, name) = name_safety_mode(mode);
                    return Some((kind, format!("the safety mode is {name}, not NORMAL")));
                }
                None => return Some((Kind::LinkLost, format!("{topic} has sent no safety mode"))),
            }
        }
        if let Some(topic) = &file.stop.program {
            match readings.program_runs {
                Some(true) => {}
                Some(false) => {
                    let reason = "the program on the robot does not run";
                    return Some((Kind::Operator, reason.to_owned()));
                }
                None => return Some((Kind::LinkLost, format!("{topic} has sent no value"))),
            }
        }
        let age = |arrival: Option<Instant>, topic: &str, limit: f64| {
            let age = arrival.map(|arrival| 1e3 * arrival.elapsed().as_secs_f64());
            match age {
                Some(age) if age <= limit => None,
                Some(age) => Some(format!(
                    "{topic} has been silent for {age:.0} ms; the limit is {limit} ms"
                )),
                None => Some(format!("{topic} has sent nothing")),
            }
        };
        if readings.is_not_finite {
            let reason = format!(
                "{} holds a number that is not finite",
                file.motion.joint_states
            );
            return Some((Kind::LinkLost, reason));
        }
        let joints = readings.joints.as_ref().map(|joints| joints.arrival);
        let mut stale = age(joints, &file.motion.joint_states, limits.state_age_ms);
        if let Some(topic) = &file.force.topic {
            let wrench = readings.wrench.as_ref().map(|wrench| wrench.arrival);
            stale = stale.or_else(|| age(wrench, topic, limits.wrench_age_ms));
        }
        if let Some(reason) = stale {
            return Some((Kind::LinkLost, reason));
        }
        if (readings.joints.as_ref()).is_some_and(|joints| joints.velocities.is_empty()) {
            let topic = &file.motion.joint_states;
            let reason = format!("{topic} has no velocities, so rest cannot be known");
            return Some((Kind::LinkLost, reason));
        }
        if let Some(topic) = &file.motion.scaling {
            match readings.scaling {
                Some((arrival, _)) if arrival.elapsed() > SCALING_AGE => {
                    let silent = arrival.elapsed().as_secs_f64();
                    let reason = format!("{topic} has been silent for {silent:.1} s");
                    return Some((Kind::LinkLost, reason));
                }
                Some((_, scaling)) if scaling > 0.0 => {}
                Some(_) => {
                    let reason = "the speed scaling is 0: the robot is paused";
                    return Some((Kind::Operator, reason.to_owned()));
                }
                None => {
                    return Some((Kind::LinkLost, format!("{topic} has sent no speed scaling")));
                }
            }
        }
        None
    }
}

/// Kind of the stop and name of a safety mode of Universal Robots.
pub(crate) fn name_safety_mode(mode: u8) -> (Kind, String) {
    let (kind, name) = match mode {
        2 => (Kind::Operator, "REDUCED"),
        3 => (Kind::ProtectiveStop, "PROTECTIVE_STOP"),
        4 => (Kind::Operator, "RECOVERY"),
        5 => (Kind::Operator, "SAFEGUARD_STOP"),
        6 => (Kind::EmergencyStop, "SYSTEM_EMERGENCY_STOP"),
        7 => (Kind::EmergencyStop, "ROBOT_EMERGENCY_STOP"),
        8 => (Kind::EmergencyStop, "VIOLATION"),
        9 => (Kind::EmergencyStop, "FAULT"),
        12 => (Kind::Operator, "AUTOMATIC_MODE_SAFEGUARD_STOP"),
        13 => (Kind::Operator, "SYSTEM_THREE_POSITION_ENABLING_STOP"),
        other => return (Kind::Operator, format!("number {other}")),
    };
    (kind, name.to_owned())
}

/// Connects to the action of a robot file.
fn connect_action(
    link: &mut Link,
    file: &RobotFile,
    deadline: Instant,
) -> Result<(TrajectoryAction, GoalSender), String> {
    let action = &file.motion.action;
    let failed = |error: String| format!("action {action}: {error}");
    let goal_service = format!("{action}/_action/send_goal");
    let mapping = link.mapping(&goal_service, file.link.service_mapping, deadline);
    let mapping = mapping.map_err(|error| failed(error.to_string()))?;
    let goals = GoalSender::open(link, action, mapping)?;
    let name = Name::parse(action).map_err(|error| failed(error.to_string()))?;
    let qos = ActionClientQosPolicies {
        goal_service: service_qos(),
        result_service: service_qos(),
        cancel_service: service_qos(),
        feedback_subscription: service_qos(),
        status_subscription: service_qos().durability(Durability::TransientLocal),
    };
    let kind = ActionTypeName::new("control_msgs", "FollowJointTrajectory");
    let client = link
        .node_mut()
        .create_action_client(mapping, &name, &kind, qos);
    let client: TrajectoryAction = client.map_err(|error| failed(error.to_string()))?;
    let node = link.node();
    let is_matched = wait_for_match(deadline, || client.goal_client().wait_for_service(node))
        && wait_for_match(deadline, || client.cancel_client().wait_for_service(node))
        && wait_for_match(deadline, || client.result_client().wait_for_service(node));
    match is_matched {
        true => Ok((client, goals)),
        false => Err(failed(
            "found, but it does not match control_msgs/action/FollowJointTrajectory".to_owned(),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn safety_modes_are_stops_of_their_kinds() {
        assert_eq!(name_safety_mode(3).0, Kind::ProtectiveStop);
        assert_eq!(name_safety_mode(7).0, Kind::EmergencyStop);
        assert_eq!(
            name_safety_mode(99),
            (Kind::Operator, "number 99".to_owned())
        );
    }
}
