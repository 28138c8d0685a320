//! Services and action of the fake robot.

use super::arm::FakeArm;
use super::log;
use crate::link::{Link, LinkError, service_qos};
use crate::messages::{
    ControllerList, ControllerOfJazzy, EmptyRequest, ForceModeRequest, ForceModeResponse,
    SwitchOfJazzy, SwitchedOfJazzy, TrajectoryFeedback, TrajectoryGoal, TrajectoryResult,
    TriggerResponse,
};
use crate::robot_file::{ForceKind, RobotFile};
use ros2_client::action::{
    ActionServerQosPolicies, CancelGoalResponse, GetResultResponse, SendGoalRequest,
    SendGoalResponse,
};
use ros2_client::action_msgs::{CancelGoalResponseEnum, GoalId, GoalStatusEnum};
use ros2_client::builtin_interfaces::Time;
use ros2_client::qos::Durability;
use ros2_client::{
    ActionServer, ActionTypeName, Message, Name, RmwRequestId, Server, ServiceMapping,
    ServiceTypeName,
};

use std::collections::VecDeque;
use std::time::{Duration, Instant};

type Trigger = Server<EmptyRequest, TriggerResponse>;

/// The servers.
pub(super) struct Servers {
    action: ActionServer<TrajectoryGoal, TrajectoryResult, TrajectoryFeedback>,
    list: Server<EmptyRequest, ControllerList<ControllerOfJazzy>>,
    switch: Server<SwitchOfJazzy, SwitchedOfJazzy>,
    tare: Option<Trigger>,
    force: Option<(Server<ForceModeRequest, ForceModeResponse>, Trigger)>,
    /// Names of the controllers, and whether they are active.
    controllers: Vec<(String, bool)>,
    goal: Option<GoalId>,
    /// Goals on their way, with the time at which they arrive.
    arriving: VecDeque<(Instant, RmwRequestId, SendGoalRequest<TrajectoryGoal>)>,
    /// Time that a goal is on its way.
    pub delay: Duration,
    /// Whether force mode is not ended on request.
    pub refuses_release: bool,
    /// Ended goals with their results.
    ended: Vec<(GoalId, GoalStatusEnum, TrajectoryResult)>,
    /// Requests of results of goals that have not ended.
    waiting: Vec<(RmwRequestId, GoalId)>,
}

fn server<Q, A>(link: &mut Link, name: &str, kind: [&str; 2]) -> Result<Server<Q, A>, LinkError>
where
    Q: Message + Clone + 'static,
    A: Message + 'static,
{
    let failed = |error: String| LinkError(format!("service {name}: {error}"));
    let full = Name::parse(name).map_err(|error| failed(error.to_string()))?;
    let server = link.node_mut().create_server(
        ServiceMapping::Enhanced,
        &full,
        &ServiceTypeName::new(kind[0], kind[1]),
        service_qos(),
        service_qos(),
    );
    server.map_err(|error| failed(error.to_string()))
}

impl Servers {
    /// Opens the services and the action of a robot file.
    ///
    /// # Errors
    /// If DDS refuses.
    pub fn open(link: &mut Link, file: &RobotFile) -> Result<Self, LinkError> {
        let action = &file.motion.action;
        let failed = |error: String| LinkError(format!("action {action}: {error}"));
        let name = Name::parse(action).map_err(|error| failed(error.to_string()))?;
        let qos = ActionServerQosPolicies {
            goal_service: service_qos(),
            result_service: service_qos(),
            cancel_service: service_qos(),
            feedback_publisher: service_qos(),
            status_publisher: service_qos().durability(Durability::TransientLocal),
        };
        let kind = ActionTypeName::new("control_msgs", "FollowJointTrajectory");
        let made =
            (link.node_mut()).create_action_server(ServiceMapping::Enhanced, &name, &kind, qos);
        let made = made.map_err(|error| failed(error.to_string()))?;
        let manager = |service: &str| format!("{}/{service}", file.motion.controller_manager);
        let of_manager = "controller_manager_msgs";
        let trigger = ["std_srvs", "Trigger"];
        let force = if file.force.kind == ForceKind::UrForceMode {
            let start = server(link, &file.force.start, ["ur_msgs", "SetForceMode"])?;
            Some((start, server(link, &file.force.stop, trigger)?))
        } else {
            None
        };
        let tare = (file.force.tare.as_ref())
            .map(|name| server(link, name, trigger))
            .transpose()?;
        Ok(Self {
            action: made,
            list: server(
                link,
                &manager("list_controllers"),
                [of_manager, "ListControllers"],
            )?,
            switch: server(
                link,
                &manager("switch_controller"),
                [of_manager, "SwitchController"],
            )?,
            tare,
            force,
            controllers: (file.motion.controllers.iter())
                .map(|name| (name.clone(), false))
                .collect(),
            goal: None,
            arriving: VecDeque::new(),
            delay: Duration::ZERO,
            refuses_release: false,
            ended: Vec::new(),
            waiting: Vec::new(),
        })
    }

    /// Answers all requests that have arrived. Returns whether the sensor was tared.
    pub fn serve(&mut self, arm: &mut FakeArm) -> bool {
        self.serve_controllers(arm);
        self.serve_goals(arm);
        self.serve_force(arm);
        let mut is_tared = false;
        if let Some(tare) = &self.tare {
            while let Ok(Some((id, _))) = tare.receive_request() {
                is_tared = true;
                let _ = tare.send_response(id, done());
            }
        }
        is_tared
    }

    fn serve_controllers(&mut self, arm: &FakeArm) {
        while let Ok(Some((id, _))) = self.list.receive_request() {
            let controller = self.controllers.iter().map(|(name, is_active)| {
                // The first one is the trajectory controller, which claims the joints.
                let claims = *is_active && *name == self.controllers[0].0;
                let joints = arm.names().iter().filter(|_| claims);
                ControllerOfJazzy {
                    name: name.clone(),
                    state: if *is_active { "active" } else { "inactive" }.to_owned(),
                    kind: "fake".to_owned(),
                    claimed_interfaces: joints.map(|joint| format!("{joint}/position")).collect(),
                    ..ControllerOfJazzy::default()
                }
            });
            let answer = ControllerList {
                controller: controller.collect(),
            };
            let _ = self.list.send_response(id, answer);
        }
        while let Ok(Some((id, request))) = self.switch.receive_request() {
            for (what, names) in [
                ("activate", &request.activate_controllers),
                ("deactivate", &request.deactivate_controllers),
            ] {
                if !names.is_empty() {
                    log(&format!("{what} {}", names.join(" ")));
                }
            }
            for (name, is_active) in &mut self.controllers {
                *is_active |= request.activate_controllers.contains(name);
                *is_active &= !request.deactivate_controllers.contains(name);
            }
            let answer = SwitchedOfJazzy {
                ok: true,
                message: String::new(),
            };
            let _ = self.switch.send_response(id, answer);
        }
    }

    fn serve_force(&mut self, arm: &mut FakeArm) {
        let Some((start, stop)) = &self.force else {
            return;
        };
        while let Ok(Some((id, request))) = start.receive_request() {
            let force = -request.wrench.linear.z;
            log(&format!("force mode on, {force:.2} N"));
            arm.press_with(force);
            let _ = start.send_response(id, ForceModeResponse { success: true });
        }
        while let Ok(Some((id, _))) = stop.receive_request() {
            if self.refuses_release {
                log("force mode stays on");
                let refused = TriggerResponse {
                    success: false,
                    message: "refused".to_owned(),
                };
                let _ = stop.send_response(id, refused);
                continue;
            }
            log("force mode off");
            arm.press_with(0.0);
            let _ = stop.send_response(id, done());
        }
    }

    fn serve_goals(&mut self, arm: &mut FakeArm) {
        while let Ok(Some((id, request))) = self.action.receive_goal() {
            self.arriving
                .push_back((Instant::now() + self.delay, id, request));
        }
        while let Some((_, id, request)) = self
            .arriving
            .pop_front_if(|(due, ..)| *due <= Instant::now())
        {
            let begun = arm.begin(&request.goal);
            let points = request.goal.trajectory.points.len();
            match &begun {
                Ok(()) => {
                    log(&format!("goal with {points} points"));
                    self.goal = Some(request.goal_id);
                }
                Err(why) => log(&format!("goal rejected: {why}")),
            }
            let answer = SendGoalResponse {
                accepted: begun.is_ok(),
                stamp: Time::now(),
            };
            let _ = self.action.send_goal_response(id, answer);
        }
        while let Ok(Some((id, _))) = self.action.receive_cancel_request() {
            log("cancel");
            let is_busy = self.goal.is_some();
            self.end(arm, GoalStatusEnum::Canceled, TrajectoryResult::default());
            let answer = CancelGoalResponse {
                return_code: if is_busy {
                    CancelGoalResponseEnum::None
                } else {
                    CancelGoalResponseEnum::UnknownGoal
                },
                goals_canceling: Vec::new(),
            };
            let _ = self.action.send_cancel_response(id, answer);
        }
        if arm.take_completed() {
            self.end(arm, GoalStatusEnum::Succeeded, TrajectoryResult::default());
        }
        while let Ok(Some((id, request))) = self.action.receive_result_request() {
            self.waiting.push((id, request.goal_id));
        }
        let ended = &self.ended;
        let action = &self.action;
        self.waiting.retain(|(id, goal)| {
            let Some((_, status, result)) = ended.iter().find(|(known, ..)| known == goal) else {
                return true;
            };
            let answer = GetResultResponse {
                status: *status,
                result: result.clone(),
            };
            let _ = action.send_result(*id, answer);
            false
        });
    }

    /// Ends the present goal, as a robot does that stops itself.
    pub fn abort(&mut self, arm: &mut FakeArm, reason: &str) {
        let result = TrajectoryResult {
            error_code: -1,
            error_string: reason.to_owned(),
        };
        arm.press_with(0.0);
        self.end(arm, GoalStatusEnum::Aborted, result);
    }

    fn end(&mut self, arm: &mut FakeArm, status: GoalStatusEnum, result: TrajectoryResult) {
        arm.hold();
        if let Some(goal) = self.goal.take() {
            log(&format!("goal ended as {status:?}"));
            self.ended.push((goal, status, result));
        }
    }
}

fn done() -> TriggerResponse {
    TriggerResponse {
        success: true,
        message: String::new(),
    }
}
