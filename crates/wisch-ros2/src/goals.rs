//! Goals to the server of an action.
//!
//! rustdds 0.15.1 writes one byte too many in each fragment of a message with inline QoS, and ros2-client 0.12.1 adds inline QoS
//! to requests in the mapping of Cyclone DDS. On a network, every goal is longer than one packet. So in that mapping, goals are
//! sent here, without inline QoS; their answers name them by the header alone.

use crate::link::{Link, service_qos};
use crate::messages::{TrajectoryFeedback, TrajectoryGoal, TrajectoryResult};
use ros2_client::action::{ActionClient, SendGoalResponse};
use ros2_client::action_msgs::GoalId;
use ros2_client::unique_identifier_msgs::UUID;
use ros2_client::{RmwRequestId, ServiceMapping};
use rustdds::{QosPolicies, TopicKind, no_key};
use serde::Serialize;

/// Client of `control_msgs/FollowJointTrajectory`.
pub(crate) type TrajectoryAction =
    ActionClient<TrajectoryGoal, TrajectoryResult, TrajectoryFeedback>;

/// DDS type of the request.
const REQUEST: &str = "control_msgs::action::dds_::FollowJointTrajectory_SendGoal_Request_";

/// The request to accept a goal, after the header of rmw_cyclonedds.
#[derive(Debug, Clone, Serialize)]
struct HeadedGoal {
    /// Names the client; here, each goal has a name of its own.
    client: [u8; 8],
    number: i64,
    goal_id: GoalId,
    goal: TrajectoryGoal,
}

/// Names a request to accept a goal.
#[derive(Debug, Clone, Copy)]
pub(crate) enum GoalRequest {
    Sent(RmwRequestId),
    Headed([u8; 8]),
}

/// Sends goals.
pub(crate) struct GoalSender {
    /// Only in the mapping of Cyclone DDS.
    headed: Option<no_key::DataWriterCdr<HeadedGoal>>,
}

impl GoalSender {
    /// Prepares to send goals of an action in a mapping.
    ///
    /// # Errors
    /// If DDS refuses.
    pub fn open(link: &Link, action: &str, mapping: ServiceMapping) -> Result<Self, String> {
        if mapping != ServiceMapping::Cyclone {
            return Ok(Self { headed: None });
        }
        let failed = |error: String| format!("action {action}: {error}");
        let qos = QosPolicies::from(&service_qos());
        let participant = link.participant();
        let name = format!("rq{action}/_action/send_goalRequest");
        let topic = participant.create_topic(name, REQUEST.to_owned(), &qos, TopicKind::NoKey);
        let topic = topic.map_err(|error| failed(error.to_string()))?;
        let publisher = participant.create_publisher(&qos);
        let publisher = publisher.map_err(|error| failed(error.to_string()))?;
        let writer = publisher.create_datawriter_no_key_cdr(&topic, Some(qos));
        let writer = writer.map_err(|error| failed(error.to_string()))?;
        Ok(Self {
            headed: Some(writer),
        })
    }

    /// Sends a goal.
    ///
    /// # Errors
    /// If DDS refuses.
    pub fn send(
        &self,
        action: &TrajectoryAction,
        goal: TrajectoryGoal,
    ) -> Result<(GoalRequest, GoalId), String> {
        let Some(writer) = &self.headed else {
            let (request, id) = action.send_goal(goal).map_err(|error| error.to_string())?;
            return Ok((GoalRequest::Sent(request), id));
        };
        let [client, goal_id] = [UUID::new_random(), UUID::new_random()];
        let mut name = [0; 8];
        name.copy_from_slice(&client.uuid.as_bytes()[..8]);
        let request = HeadedGoal {
            client: name,
            number: 1,
            goal_id,
            goal,
        };
        let written = writer.write(request, None);
        written.map_err(|error| error.to_string())?;
        Ok((GoalRequest::Headed(name), goal_id))
    }

    /// The answer to a request, if it has arrived.
    pub fn answer(action: &TrajectoryAction, request: GoalRequest) -> Option<SendGoalResponse> {
        let name = match request {
            GoalRequest::Sent(request) => {
                return action.receive_goal_response(request).ok().flatten();
            }
            GoalRequest::Headed(name) => name,
        };
        loop {
            let (request, answer) = action.goal_client().receive_response().ok().flatten()?;
            if request.writer_gid.to_bytes16()[8..] == name {
                return Some(answer);
            }
        }
    }
}
