"""Messages of ROS 2 packages in the IDL of Cyclone DDS, with the fields of the interface files of Humble and Jazzy.

They are written here anew, and not taken from wisch-ros2, so that a wrong layout in one of them is found.
"""

from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import array, float32, float64, int8, int32, int64, sequence, uint8, uint16, uint32, uint64


def struct(kind, fields):
    """Makes a class for a type such as `std_msgs/msg/Header`."""
    package, group, name = kind.split("/")
    return final(make_idl_struct(name, f"{package}.{group}.dds_.{name}_", fields))


Time = struct("builtin_interfaces/msg/Time", {"sec": int32, "nanosec": uint32})
Duration = struct("builtin_interfaces/msg/Duration", {"sec": int32, "nanosec": uint32})
Header = struct("std_msgs/msg/Header", {"stamp": Time, "frame_id": str})
Float64 = struct("std_msgs/msg/Float64", {"data": float64})
Bool = struct("std_msgs/msg/Bool", {"data": bool})
SafetyMode = struct("ur_dashboard_msgs/msg/SafetyMode", {"mode": uint8})

Vector3 = struct("geometry_msgs/msg/Vector3", {"x": float64, "y": float64, "z": float64})
Point = struct("geometry_msgs/msg/Point", {"x": float64, "y": float64, "z": float64})
Quaternion = struct("geometry_msgs/msg/Quaternion", {"x": float64, "y": float64, "z": float64, "w": float64})
Pose = struct("geometry_msgs/msg/Pose", {"position": Point, "orientation": Quaternion})
PoseStamped = struct("geometry_msgs/msg/PoseStamped", {"header": Header, "pose": Pose})
Transform = struct("geometry_msgs/msg/Transform", {"translation": Vector3, "rotation": Quaternion})
Twist = struct("geometry_msgs/msg/Twist", {"linear": Vector3, "angular": Vector3})
Wrench = struct("geometry_msgs/msg/Wrench", {"force": Vector3, "torque": Vector3})
WrenchStamped = struct("geometry_msgs/msg/WrenchStamped", {"header": Header, "wrench": Wrench})

JointState = struct(
    "sensor_msgs/msg/JointState",
    {
        "header": Header,
        "name": sequence[str],
        "position": sequence[float64],
        "velocity": sequence[float64],
        "effort": sequence[float64],
    },
)
JointTrajectoryPoint = struct(
    "trajectory_msgs/msg/JointTrajectoryPoint",
    {
        "positions": sequence[float64],
        "velocities": sequence[float64],
        "accelerations": sequence[float64],
        "effort": sequence[float64],
        "time_from_start": Duration,
    },
)
JointTrajectory = struct(
    "trajectory_msgs/msg/JointTrajectory",
    {"header": Header, "joint_names": sequence[str], "points": sequence[JointTrajectoryPoint]},
)
MultiDOFJointTrajectoryPoint = struct(
    "trajectory_msgs/msg/MultiDOFJointTrajectoryPoint",
    {
        "transforms": sequence[Transform],
        "velocities": sequence[Twist],
        "accelerations": sequence[Twist],
        "time_from_start": Duration,
    },
)
MultiDOFJointTrajectory = struct(
    "trajectory_msgs/msg/MultiDOFJointTrajectory",
    {"header": Header, "joint_names": sequence[str], "points": sequence[MultiDOFJointTrajectoryPoint]},
)
JointTolerance = struct(
    "control_msgs/msg/JointTolerance",
    {"name": str, "position": float64, "velocity": float64, "acceleration": float64},
)
JointComponentTolerance = struct(
    "control_msgs/msg/JointComponentTolerance",
    {"joint_name": str, "component": uint16, "position": float64, "velocity": float64, "acceleration": float64},
)
JointTrajectoryControllerState = struct(
    "control_msgs/msg/JointTrajectoryControllerState",
    {
        "header": Header,
        "joint_names": sequence[str],
        "reference": JointTrajectoryPoint,
        "feedback": JointTrajectoryPoint,
        "error": JointTrajectoryPoint,
        "output": JointTrajectoryPoint,
        "multi_dof_joint_names": sequence[str],
        "multi_dof_reference": MultiDOFJointTrajectoryPoint,
        "multi_dof_feedback": MultiDOFJointTrajectoryPoint,
        "multi_dof_error": MultiDOFJointTrajectoryPoint,
        "multi_dof_output": MultiDOFJointTrajectoryPoint,
        "speed_scaling_factor": float64,
    },
)

# The action control_msgs/FollowJointTrajectory.
ACTION = "control_msgs/action/FollowJointTrajectory"
GoalId = array[uint8, 16]
GoalInfo = struct("action_msgs/msg/GoalInfo", {"goal_id": GoalId, "stamp": Time})
GoalStatus = struct("action_msgs/msg/GoalStatus", {"goal_info": GoalInfo, "status": int8})
GoalStatusArray = struct("action_msgs/msg/GoalStatusArray", {"status_list": sequence[GoalStatus]})
Goal = struct(
    ACTION + "_Goal",
    {
        "trajectory": JointTrajectory,
        "multi_dof_trajectory": MultiDOFJointTrajectory,
        "path_tolerance": sequence[JointTolerance],
        "component_path_tolerance": sequence[JointComponentTolerance],
        "goal_tolerance": sequence[JointTolerance],
        "component_goal_tolerance": sequence[JointComponentTolerance],
        "goal_time_tolerance": Duration,
    },
)
Feedback = struct(
    ACTION + "_Feedback",
    {
        "header": Header,
        "joint_names": sequence[str],
        "desired": JointTrajectoryPoint,
        "actual": JointTrajectoryPoint,
        "error": JointTrajectoryPoint,
        "multi_dof_joint_names": sequence[str],
        "multi_dof_desired": MultiDOFJointTrajectoryPoint,
        "multi_dof_actual": MultiDOFJointTrajectoryPoint,
        "multi_dof_error": MultiDOFJointTrajectoryPoint,
    },
)
FeedbackMessage = struct(ACTION + "_FeedbackMessage", {"goal_id": GoalId, "feedback": Feedback})
Result = struct(ACTION + "_Result", {"error_code": int32, "error_string": str})

# ur_msgs/SetForceMode, controller_manager_msgs, std_srvs/Trigger.
ChainConnection = struct(
    "controller_manager_msgs/msg/ChainConnection", {"name": str, "reference_interfaces": sequence[str]}
)
CONTROLLER_STATE = "controller_manager_msgs/msg/ControllerState"
ControllerOfHumble = struct(
    CONTROLLER_STATE,
    {
        "name": str,
        "state": str,
        "type": str,
        "claimed_interfaces": sequence[str],
        "required_command_interfaces": sequence[str],
        "required_state_interfaces": sequence[str],
        "is_chainable": bool,
        "is_chained": bool,
        "reference_interfaces": sequence[str],
        "chain_connections": sequence[ChainConnection],
    },
)
ControllerOfJazzy = struct(
    CONTROLLER_STATE,
    {
        "name": str,
        "state": str,
        "type": str,
        "is_async": bool,
        "update_rate": uint16,
        "claimed_interfaces": sequence[str],
        "required_command_interfaces": sequence[str],
        "required_state_interfaces": sequence[str],
        "is_chainable": bool,
        "is_chained": bool,
        "exported_state_interfaces": sequence[str],
        "reference_interfaces": sequence[str],
        "chain_connections": sequence[ChainConnection],
    },
)
EMPTY = {"structure_needs_at_least_one_member": uint8}
SWITCH_OF_HUMBLE = {
    "activate_controllers": sequence[str],
    "deactivate_controllers": sequence[str],
    "start_controllers": sequence[str],
    "stop_controllers": sequence[str],
    "strictness": int32,
    "start_asap": bool,
    "activate_asap": bool,
    "timeout": Duration,
}
SWITCH_OF_JAZZY = {
    "activate_controllers": sequence[str],
    "deactivate_controllers": sequence[str],
    "strictness": int32,
    "activate_asap": bool,
    "timeout": Duration,
}
# Type of each service, and the fields of its request and response, by distribution where they differ.
SERVICES = {
    "send_goal": (ACTION + "_SendGoal", {"goal_id": GoalId, "goal": Goal}, {"accepted": bool, "stamp": Time}),
    "get_result": (ACTION + "_GetResult", {"goal_id": GoalId}, {"status": int8, "result": Result}),
    "cancel_goal": (
        "action_msgs/srv/CancelGoal",
        {"goal_info": GoalInfo},
        {"return_code": int8, "goals_canceling": sequence[GoalInfo]},
    ),
    "trigger": ("std_srvs/srv/Trigger", EMPTY, {"success": bool, "message": str}),
    "force_mode": (
        "ur_msgs/srv/SetForceMode",
        {
            "task_frame": PoseStamped,
            "selection_vector_x": bool,
            "selection_vector_y": bool,
            "selection_vector_z": bool,
            "selection_vector_rx": bool,
            "selection_vector_ry": bool,
            "selection_vector_rz": bool,
            "wrench": Wrench,
            "type": uint8,
            "speed_limits": Twist,
            "deviation_limits": array[float32, 6],
            "damping_factor": float32,
            "gain_scaling": float32,
        },
        {"success": bool},
    ),
    ("list", "jazzy"): (
        "controller_manager_msgs/srv/ListControllers",
        EMPTY,
        {"controller": sequence[ControllerOfJazzy]},
    ),
    ("list", "humble"): (
        "controller_manager_msgs/srv/ListControllers",
        EMPTY,
        {"controller": sequence[ControllerOfHumble]},
    ),
    ("switch", "jazzy"): (
        "controller_manager_msgs/srv/SwitchController",
        SWITCH_OF_JAZZY,
        {"ok": bool, "message": str},
    ),
    ("switch", "humble"): ("controller_manager_msgs/srv/SwitchController", SWITCH_OF_HUMBLE, {"ok": bool}),
}


def service_types(key, with_header):
    """Classes of request and response. `with_header`: as rmw_cyclonedds sends them, after the client's id and a number."""
    kind, request, response = SERVICES[key]
    header = {"client": uint64, "number": int64} if with_header else {}
    return struct(kind + "_Request", {**header, **request}), struct(kind + "_Response", {**header, **response})


def point(positions=(), velocities=(), time=0.0):
    return JointTrajectoryPoint(list(positions), list(velocities), [], [], Duration(int(time), int(time % 1 * 1e9)))


def no_multi():
    return MultiDOFJointTrajectoryPoint([], [], [], Duration(0, 0))
