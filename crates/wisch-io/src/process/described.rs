//! The robot's description for an executor in another process.

use super::child::MAX_LINE;
use crate::robots::Robot;
use serde::Serialize;
use wisch::follow::Workcell;
use wisch::geometry::flatten_pose;

/// Space for the rest of the message that holds a description [bytes].
const REST_OF_MESSAGE: usize = 1024;

/// A robot's description, with which a driver needs no kinematics of its own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DriverRobotRecord {
    /// Name of the robot.
    pub name: String,
    /// Names of its n variables, in the order of all arrays.
    pub joints: Vec<String>,
    /// Names of those that the planning group moves.
    pub arm_joints: Vec<String>,
    /// Name of the link that holds the tool.
    pub tip: String,
    /// Name of the tool.
    pub tool: String,
    /// Pose of the tool in the frame of the tip, as x, y, z \[m\] and a unit quaternion x, y, z, w.
    pub tip_from_tool: [f64; 7],
    /// Absolute path of the URDF file; `None` for a shipped robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub urdf_file: Option<String>,
    /// Text of the URDF, on the base that the SRDF declares; `None` if the message would be too long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub urdf: Option<String>,
    /// Text of the SRDF; `None` without one, or if the message would be too long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub srdf: Option<String>,
}

impl DriverRobotRecord {
    /// Describes a robot. `cell`: the robot with the tool in its hand.
    ///
    /// The description is at most 1 MiB long as JSON: a longer one leaves the text of the SRDF out, and if that is not
    /// enough, the text of the URDF.
    pub fn new(robot: &Robot, cell: &Workcell, tool: &str) -> Self {
        let model = cell.robot();
        let name = |variable: usize| model.variable(variable).name.clone();
        let file = robot.urdf_file().map(|path| {
            let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
            path.display().to_string()
        });
        let mut record = Self {
            name: model.name().to_owned(),
            joints: (0..model.dof()).map(name).collect(),
            arm_joints: cell.arm_variables().iter().copied().map(name).collect(),
            tip: model.links()[cell.tip().index()].name.clone(),
            tool: tool.to_owned(),
            tip_from_tool: flatten_pose(cell.tip_from_tool()),
            urdf_file: file,
            urdf: Some(robot.files.urdf.clone()),
            srdf: robot.files.srdf.clone(),
        };
        if !record.has_space() {
            record.srdf = None;
        }
        if !record.has_space() {
            record.urdf = None;
        }
        record
    }

    /// Whether a message with this description keeps within the limit of a line.
    pub(super) fn has_space(&self) -> bool {
        let length = serde_json::to_vec(self).map_or(usize::MAX, |text| text.len());
        length <= MAX_LINE as usize - REST_OF_MESSAGE
    }
}
