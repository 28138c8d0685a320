//! The controller manager: which controllers are active, and switching.

use crate::link::{Link, LinkError};
use crate::messages::{
    ControllerList, ControllerOfHumble, ControllerOfJazzy, EmptyRequest, Stamp, SwitchOfHumble,
    SwitchOfJazzy, SwitchedOfHumble, SwitchedOfJazzy,
};
use crate::robot_file::{Distro, RobotFile};
use crate::service::Service;
use std::time::{Duration, Instant};

/// Longest wait for an answer of the controller manager.
const ANSWER: Duration = Duration::from_secs(5);
/// Longest wait for a switch, by the controller manager [s].
const SWITCH_TIMEOUT_S: f64 = 3.0;
/// Strictness with which a switch that fails in part changes nothing.
const STRICT: i32 = 2;
/// Types of the services, in `controller_manager_msgs`.
const LIST: [&str; 2] = ["controller_manager_msgs", "ListControllers"];
const SWITCH: [&str; 2] = ["controller_manager_msgs", "SwitchController"];

/// A controller that the manager knows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ListedController {
    pub name: String,
    pub is_active: bool,
    pub kind: String,
    pub claimed: Vec<String>,
}

/// A client of the controller manager of one distribution.
pub(crate) enum ControllerManager {
    Humble(
        Service<EmptyRequest, ControllerList<ControllerOfHumble>>,
        Service<SwitchOfHumble, SwitchedOfHumble>,
    ),
    Jazzy(
        Service<EmptyRequest, ControllerList<ControllerOfJazzy>>,
        Service<SwitchOfJazzy, SwitchedOfJazzy>,
    ),
}

impl ControllerManager {
    /// Connects to the manager of a robot file, for which it waits until `deadline`.
    ///
    /// # Errors
    /// If a service is not found.
    pub fn connect(
        link: &mut Link,
        file: &RobotFile,
        deadline: Instant,
    ) -> Result<Self, LinkError> {
        let choice = file.link.service_mapping;
        let name = |service: &str| format!("{}/{service}", file.motion.controller_manager);
        let [list, switch] = [name("list_controllers"), name("switch_controller")];
        Ok(match file.link.ros_distro {
            Distro::Humble => Self::Humble(
                Service::connect(link, &list, LIST, choice, deadline)?,
                Service::connect(link, &switch, SWITCH, choice, deadline)?,
            ),
            Distro::Jazzy => Self::Jazzy(
                Service::connect(link, &list, LIST, choice, deadline)?,
                Service::connect(link, &switch, SWITCH, choice, deadline)?,
            ),
        })
    }

    /// Lists the controllers.
    ///
    /// # Errors
    /// If the manager does not answer.
    pub fn list(&self) -> Result<Vec<ListedController>, LinkError> {
        self.list_within(ANSWER)
    }

    /// Lists the controllers.
    ///
    /// # Errors
    /// If the manager does not answer within `limit`.
    pub fn list_within(&self, limit: Duration) -> Result<Vec<ListedController>, LinkError> {
        let listed = |name, state: &str, kind, claimed| ListedController {
            name,
            is_active: state == "active",
            kind,
            claimed,
        };
        Ok(match self {
            Self::Humble(list, _) => {
                let answer = list.call(EmptyRequest::default(), limit)?;
                let all = answer.controller.into_iter();
                all.map(|c| listed(c.name, &c.state, c.kind, c.claimed_interfaces))
                    .collect()
            }
            Self::Jazzy(list, _) => {
                let answer = list.call(EmptyRequest::default(), limit)?;
                let all = answer.controller.into_iter();
                all.map(|c| listed(c.name, &c.state, c.kind, c.claimed_interfaces))
                    .collect()
            }
        })
    }

    /// Activates controllers, all or none of them.
    ///
    /// # Errors
    /// If the manager does not answer or refuses.
    pub fn activate(&self, names: Vec<String>) -> Result<(), LinkError> {
        self.switch(names, Vec::new(), ANSWER)
    }

    /// Deactivates controllers, all or none of them.
    ///
    /// # Errors
    /// If the manager does not answer within `limit`, or refuses.
    pub fn deactivate(&self, names: Vec<String>, limit: Duration) -> Result<(), LinkError> {
        self.switch(Vec::new(), names, limit)
    }

    fn switch(
        &self,
        activated: Vec<String>,
        deactivated: Vec<String>,
        limit: Duration,
    ) -> Result<(), LinkError> {
        let shown = if deactivated.is_empty() {
            format!("activate {}", activated.join(", "))
        } else {
            format!("deactivate {}", deactivated.join(", "))
        };
        let timeout = Stamp::from_seconds(SWITCH_TIMEOUT_S.min(limit.as_secs_f64()));
        let (ok, why) = match self {
            Self::Humble(_, switch) => {
                let request = SwitchOfHumble {
                    activate_controllers: activated,
                    deactivate_controllers: deactivated,
                    strictness: STRICT,
                    timeout,
                    ..SwitchOfHumble::default()
                };
                (switch.call(request, limit)?.ok, String::new())
            }
            Self::Jazzy(_, switch) => {
                let request = SwitchOfJazzy {
                    activate_controllers: activated,
                    deactivate_controllers: deactivated,
                    strictness: STRICT,
                    timeout,
                    ..SwitchOfJazzy::default()
                };
                let answer = switch.call(request, limit)?;
                (answer.ok, format!(": {}", answer.message))
            }
        };
        if ok {
            Ok(())
        } else {
            Err(LinkError::new(format!(
                "the controller manager does not {shown}{why}"
            )))
        }
    }
}

/// What forbids a motion with these controllers: one that is not loaded, and one that claims a joint and is not among
/// `needed`. Inactive ones of `needed` are no fault, because they can be activated.
pub(crate) fn controller_faults(
    listed: &[ListedController],
    needed: &[String],
    joints: &[String],
) -> Vec<String> {
    let mut faults = Vec::new();
    for name in needed {
        if !listed.iter().any(|controller| controller.name == *name) {
            let known: Vec<&str> = listed.iter().map(|c| c.name.as_str()).collect();
            faults.push(format!(
                "controller {name:?} is not loaded; the controller manager has {}",
                known.join(", ")
            ));
        }
    }
    for controller in listed {
        if !controller.is_active || needed.contains(&controller.name) {
            continue;
        }
        let claimed = controller.claimed.iter().find(|interface| {
            joints.iter().any(|joint| {
                interface
                    .strip_prefix(joint.as_str())
                    .is_some_and(|rest| rest.starts_with('/'))
            })
        });
        if let Some(interface) = claimed {
            faults.push(format!(
                "controller {:?} is active and claims {interface}, and is not in motion.controllers; deactivate it",
                controller.name
            ));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn controller(name: &str, is_active: bool, claimed: &[&str]) -> ListedController {
        ListedController {
            name: name.to_owned(),
            is_active,
            kind: String::new(),
            claimed: claimed.iter().map(|c| (*c).to_owned()).collect(),
        }
    }

    #[test]
    fn a_controller_that_claims_a_joint_and_is_not_named_is_a_fault() {
        let joints = ["elbow".to_owned()];
        let needed = ["jtc".to_owned()];
        let jtc = controller("jtc", false, &[]);
        let faults = |other| controller_faults(&[jtc.clone(), other], &needed, &joints);
        let claims = ["elbow/position"];
        assert_eq!(faults(controller("other", true, &claims)).len(), 1);
        assert!(faults(controller("other", false, &claims)).is_empty());
        assert!(faults(controller("broadcaster", true, &["elbow_2/position"])).is_empty());
        let unknown = controller_faults(&[], &needed, &joints);
        assert!(unknown[0].contains("\"jtc\" is not loaded"), "{unknown:?}");
    }
}
