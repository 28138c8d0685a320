//! Messages of ROS 2 packages, with the fields in the order in which they are sent.
//!
//! Layouts are those of the interface files of ROS 2 Humble and Jazzy. Names of fields are not sent.

use ros2_client::Message;
use ros2_client::action_msgs::GoalId;
use serde::{Deserialize, Serialize};

/// `builtin_interfaces/Time` and `builtin_interfaces/Duration`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Stamp {
    pub sec: i32,
    pub nanosec: u32,
}

impl Stamp {
    /// Returns the stamp of a time [s], which is not negative.
    pub fn from_seconds(seconds: f64) -> Self {
        let whole = seconds.floor();
        Self {
            sec: whole as i32,
            nanosec: (((seconds - whole) * 1e9).round() as u32).min(999_999_999),
        }
    }

    /// The time [s].
    pub fn seconds(self) -> f64 {
        f64::from(self.sec) + 1e-9 * f64::from(self.nanosec)
    }
}

/// `std_msgs/Header`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Header {
    pub stamp: Stamp,
    pub frame_id: String,
}

/// `geometry_msgs/Vector3` and `geometry_msgs/Point`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Vector {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// `geometry_msgs/Quaternion`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct QuaternionMessage {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub w: f64,
}

/// `geometry_msgs/PoseStamped`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PoseStamped {
    pub header: Header,
    pub position: Vector,
    pub orientation: QuaternionMessage,
}

/// `geometry_msgs/Wrench` and `geometry_msgs/Twist`: two vectors.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct VectorPair {
    pub linear: Vector,
    pub angular: Vector,
}

/// `geometry_msgs/WrenchStamped`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct WrenchStamped {
    pub header: Header,
    pub wrench: VectorPair,
}
impl Message for WrenchStamped {}

/// `sensor_msgs/JointState`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct JointStateMessage {
    pub header: Header,
    pub name: Vec<String>,
    pub position: Vec<f64>,
    pub velocity: Vec<f64>,
    pub effort: Vec<f64>,
}
impl Message for JointStateMessage {}

/// `std_msgs/Float64`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Float64 {
    pub data: f64,
}
impl Message for Float64 {}

/// `std_msgs/Bool`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Bool {
    pub data: bool,
}
impl Message for Bool {}

/// `ur_dashboard_msgs/SafetyMode`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct SafetyMode {
    pub mode: u8,
}
impl Message for SafetyMode {}

/// `trajectory_msgs/JointTrajectoryPoint`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct PointMessage {
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    pub accelerations: Vec<f64>,
    pub effort: Vec<f64>,
    pub time_from_start: Stamp,
}

/// `trajectory_msgs/JointTrajectory`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TrajectoryMessage {
    pub header: Header,
    pub joint_names: Vec<String>,
    pub points: Vec<PointMessage>,
}

/// `trajectory_msgs/MultiDOFJointTrajectoryPoint`, which is always empty here.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct MultiPointMessage {
    pub transforms: Vec<[f64; 7]>,
    pub velocities: Vec<[f64; 6]>,
    pub accelerations: Vec<[f64; 6]>,
    pub time_from_start: Stamp,
}

/// `trajectory_msgs/MultiDOFJointTrajectory`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct MultiTrajectoryMessage {
    pub header: Header,
    pub joint_names: Vec<String>,
    pub points: Vec<MultiPointMessage>,
}

/// `control_msgs/JointTolerance`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct JointTolerance {
    pub name: String,
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

/// `control_msgs/JointComponentTolerance`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ComponentTolerance {
    pub joint_name: String,
    pub component: u16,
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

/// The goal of `control_msgs/FollowJointTrajectory`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TrajectoryGoal {
    pub trajectory: TrajectoryMessage,
    pub multi_dof_trajectory: MultiTrajectoryMessage,
    pub path_tolerance: Vec<JointTolerance>,
    pub component_path_tolerance: Vec<ComponentTolerance>,
    pub goal_tolerance: Vec<JointTolerance>,
    pub component_goal_tolerance: Vec<ComponentTolerance>,
    pub goal_time_tolerance: Stamp,
}
impl Message for TrajectoryGoal {}

/// The result of `control_msgs/FollowJointTrajectory`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TrajectoryResult {
    pub error_code: i32,
    pub error_string: String,
}
impl Message for TrajectoryResult {}

/// The beginning of the feedback of `control_msgs/FollowJointTrajectory`; the rest is not read.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TrajectoryFeedback {
    pub header: Header,
    pub joint_names: Vec<String>,
    pub desired: PointMessage,
}
impl Message for TrajectoryFeedback {}

/// The beginning of `control_msgs/JointTrajectoryControllerState`, which Humble and Jazzy share; the rest is not read.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ControllerProgress {
    pub header: Header,
    pub joint_names: Vec<String>,
    pub reference: PointMessage,
}
impl Message for ControllerProgress {}

/// `control_msgs/JointTrajectoryControllerState` of Jazzy.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TrajectoryControllerState {
    pub header: Header,
    pub joint_names: Vec<String>,
    pub reference: PointMessage,
    pub feedback: PointMessage,
    pub error: PointMessage,
    pub output: PointMessage,
    pub multi_dof_joint_names: Vec<String>,
    pub multi_dof: [MultiPointMessage; 4],
    pub speed_scaling_factor: f64,
}
impl Message for TrajectoryControllerState {}

/// A request without fields, as of `std_srvs/Trigger` and `controller_manager_msgs/ListControllers`. ROS 2 sends one byte.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct EmptyRequest {
    pub structure_needs_at_least_one_member: u8,
}
impl Message for EmptyRequest {}

/// The response of `std_srvs/Trigger`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TriggerResponse {
    pub success: bool,
    pub message: String,
}
impl Message for TriggerResponse {}

/// The request of `ur_msgs/SetForceMode`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ForceModeRequest {
    pub task_frame: PoseStamped,
    pub selection: [bool; 6],
    pub wrench: VectorPair,
    pub frame_type: u8,
    pub speed_limits: VectorPair,
    pub deviation_limits: [f32; 6],
    pub damping_factor: f32,
    pub gain_scaling: f32,
}
impl Message for ForceModeRequest {}

/// The response of `ur_msgs/SetForceMode`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ForceModeResponse {
    pub success: bool,
}
impl Message for ForceModeResponse {}

/// `controller_manager_msgs/ChainConnection`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ChainConnection {
    pub name: String,
    pub reference_interfaces: Vec<String>,
}

/// `controller_manager_msgs/ControllerState` of Humble.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ControllerOfHumble {
    pub name: String,
    pub state: String,
    pub kind: String,
    pub claimed_interfaces: Vec<String>,
    pub required_command_interfaces: Vec<String>,
    pub required_state_interfaces: Vec<String>,
    pub is_chainable: bool,
    pub is_chained: bool,
    pub reference_interfaces: Vec<String>,
    pub chain_connections: Vec<ChainConnection>,
}

/// `controller_manager_msgs/ControllerState` of Jazzy.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ControllerOfJazzy {
    pub name: String,
    pub state: String,
    pub kind: String,
    pub is_async: bool,
    pub update_rate: u16,
    pub claimed_interfaces: Vec<String>,
    pub required_command_interfaces: Vec<String>,
    pub required_state_interfaces: Vec<String>,
    pub is_chainable: bool,
    pub is_chained: bool,
    pub exported_state_interfaces: Vec<String>,
    pub reference_interfaces: Vec<String>,
    pub chain_connections: Vec<ChainConnection>,
}

/// The response of `controller_manager_msgs/ListControllers`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ControllerList<C> {
    pub controller: Vec<C>,
}
impl Message for ControllerList<ControllerOfHumble> {}
impl Message for ControllerList<ControllerOfJazzy> {}

/// The request of `controller_manager_msgs/SwitchController` of Jazzy.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SwitchOfJazzy {
    pub activate_controllers: Vec<String>,
    pub deactivate_controllers: Vec<String>,
    pub strictness: i32,
    pub activate_asap: bool,
    pub timeout: Stamp,
}
impl Message for SwitchOfJazzy {}

/// The response of `controller_manager_msgs/SwitchController` of Jazzy.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SwitchedOfJazzy {
    pub ok: bool,
    pub message: String,
}
impl Message for SwitchedOfJazzy {}

/// The request of `controller_manager_msgs/SwitchController` of Humble.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SwitchOfHumble {
    pub activate_controllers: Vec<String>,
    pub deactivate_controllers: Vec<String>,
    pub start_controllers: Vec<String>,
    pub stop_controllers: Vec<String>,
    pub strictness: i32,
    pub start_asap: bool,
    pub activate_asap: bool,
    pub timeout: Stamp,
}
impl Message for SwitchOfHumble {}

/// The response of `controller_manager_msgs/SwitchController` of Humble.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SwitchedOfHumble {
    pub ok: bool,
}
impl Message for SwitchedOfHumble {}

/// The request of `action_msgs/CancelGoal`, whose fields the library hides.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct CancelRequest {
    pub goal_id: GoalId,
    pub stamp: Stamp,
}
impl Message for CancelRequest {}

impl CancelRequest {
    /// The request to cancel all goals of an action.
    pub const ALL: Self = Self {
        goal_id: GoalId::ZERO,
        stamp: Stamp { sec: 0, nanosec: 0 },
    };
}

#[cfg(test)]
mod tests;
