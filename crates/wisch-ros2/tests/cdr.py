#!/usr/bin/env python3
"""Writes cdr.txt: messages as another library encodes them, `rosbags` from PyPI (0.11.9), for the unit tests of src/messages.rs.

    python3 tests/cdr.py > tests/cdr.txt

Definitions are those of the interface files of ROS 2 Humble and Jazzy, without comments. Each line is a name and the bytes in
hexadecimal, without the four bytes of the encapsulation.
"""

import numpy as np
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

POINT = "trajectory_msgs/JointTrajectoryPoint"
MULTI = "trajectory_msgs/MultiDOFJointTrajectoryPoint"
SHARED = {
    "control_msgs/msg/JointTolerance": "string name\nfloat64 position\nfloat64 velocity\nfloat64 acceleration",
    "control_msgs/msg/JointComponentTolerance": "string joint_name\nuint16 component\nfloat64 position\nfloat64 velocity\n"
    "float64 acceleration",
    "control_msgs/msg/Goal": "trajectory_msgs/JointTrajectory trajectory\n"
    "trajectory_msgs/MultiDOFJointTrajectory multi_dof_trajectory\nJointTolerance[] path_tolerance\n"
    "JointComponentTolerance[] component_path_tolerance\nJointTolerance[] goal_tolerance\n"
    "JointComponentTolerance[] component_goal_tolerance\nbuiltin_interfaces/Duration goal_time_tolerance",
    "control_msgs/msg/State": "std_msgs/Header header\nstring[] joint_names\n"
    + "".join(f"{POINT} {name}\n" for name in ("reference", "feedback", "error", "output"))
    + "string[] multi_dof_joint_names\n"
    + "".join(f"{MULTI} {name}\n" for name in ("mr", "mf", "me", "mo"))
    + "float64 speed_scaling_factor",
    "controller_manager_msgs/msg/ChainConnection": "string name\nstring[] reference_interfaces",
    "ur_msgs/msg/Force": "geometry_msgs/PoseStamped task_frame\n"
    + "".join(f"bool selection_vector_{axis}\n" for axis in ("x", "y", "z", "rx", "ry", "rz"))
    + "geometry_msgs/Wrench wrench\nuint8 type\ngeometry_msgs/Twist speed_limits\nfloat32[6] deviation_limits\n"
    "float32 damping_factor\nfloat32 gain_scaling",
}
CONTROLLER = "string name\nstring state\nstring type\n{extra}string[] claimed_interfaces\nstring[] required_command_interfaces\n" \
    "string[] required_state_interfaces\nbool is_chainable\nbool is_chained\n{exported}string[] reference_interfaces\n" \
    "ChainConnection[] chain_connections"
BY_DISTRO = {
    "humble": (
        Stores.ROS2_HUMBLE,
        CONTROLLER.format(extra="", exported=""),
        "string[] activate\nstring[] deactivate\nstring[] start\nstring[] stop\nint32 strictness\nbool start_asap\n"
        "bool activate_asap\nbuiltin_interfaces/Duration timeout",
    ),
    "jazzy": (
        Stores.ROS2_JAZZY,
        CONTROLLER.format(extra="bool is_async\nuint16 update_rate\n", exported="string[] exported_state_interfaces\n"),
        "string[] activate\nstring[] deactivate\nint32 strictness\nbool activate_asap\nbuiltin_interfaces/Duration timeout",
    ),
}


def store(distro):
    base, controller, switch = BY_DISTRO[distro]
    types = get_typestore(base)
    texts = SHARED | {
        "controller_manager_msgs/msg/ControllerState": controller,
        "controller_manager_msgs/msg/List": "ControllerState[] controller",
        "controller_manager_msgs/msg/Switch": switch,
    }
    found = {}
    for name, text in texts.items():
        found |= get_types_from_msg(text, name)
    types.register(found)
    return types


def main():
    for distro in BY_DISTRO:
        types = store(distro)

        def new(name, *values):
            return types.types[name](*values)

        def show(label, name, message):
            print(f"{label}.{distro}", bytes(types.serialize_cdr(message, name))[4:].hex())

        def array(*values):
            return np.array(values, dtype=np.float64)

        time = new("builtin_interfaces/msg/Time", 3, 500_000_000)
        duration = new("builtin_interfaces/msg/Duration", 1, 250_000_000)
        header = new("std_msgs/msg/Header", time, "base")
        vector = lambda *v: new("geometry_msgs/msg/Vector3", *v)
        point = new("trajectory_msgs/msg/JointTrajectoryPoint", array(1, 2), array(0.5, -0.5), array(0, 3), array(), duration)
        empty = new("trajectory_msgs/msg/JointTrajectoryPoint", array(), array(), array(), array(), duration)
        names = ["a", "elbow"]
        show("joint_state", "sensor_msgs/msg/JointState",
             new("sensor_msgs/msg/JointState", header, names, array(1, 2), array(0.5, -0.5), array()))
        wrench = new("geometry_msgs/msg/Wrench", vector(1.0, 2.0, 3.0), vector(4.0, 5.0, 6.0))
        show("wrench", "geometry_msgs/msg/WrenchStamped", new("geometry_msgs/msg/WrenchStamped", header, wrench))
        trajectory = new("trajectory_msgs/msg/JointTrajectory", header, names, [point])
        no_time = new("builtin_interfaces/msg/Time", 0, 0)
        nothing = new("trajectory_msgs/msg/MultiDOFJointTrajectory", new("std_msgs/msg/Header", no_time, ""), [], [])
        tolerance = new("control_msgs/msg/JointTolerance", "elbow", 0.05, 0.0, 0.0)
        show("goal", "control_msgs/msg/Goal",
             new("control_msgs/msg/Goal", trajectory, nothing, [tolerance], [], [], [], duration))
        multi = new("trajectory_msgs/msg/MultiDOFJointTrajectoryPoint", [], [], [], duration)
        if distro == "jazzy":
            states = [point, empty, empty, empty]
            show("state", "control_msgs/msg/State",
                 new("control_msgs/msg/State", header, names, *states, [], multi, multi, multi, multi, 0.75))
        pose = new("geometry_msgs/msg/Pose", new("geometry_msgs/msg/Point", 0.1, 0.2, 0.3),
                   new("geometry_msgs/msg/Quaternion", 0.0, 0.6, 0.0, 0.8))
        frame = new("geometry_msgs/msg/PoseStamped", header, pose)
        twist = new("geometry_msgs/msg/Twist", vector(0.0, 0.0, 0.03), vector(0.0, 0.0, 0.0))
        limits = np.array([0.05, 0.05, 0.05, 0.3, 0.3, 0.3], dtype=np.float32)
        show("force", "ur_msgs/msg/Force",
             new("ur_msgs/msg/Force", frame, False, False, True, False, False, False, wrench, 2, twist, limits, 0.025, 0.5))
        chain = new("controller_manager_msgs/msg/ChainConnection", "next", ["r"])
        extra = [True, 500] if distro == "jazzy" else []
        exported = [["x"]] if distro == "jazzy" else []
        controller = new("controller_manager_msgs/msg/ControllerState", "jtc", "active", "T", *extra, ["elbow/position"],
                         ["c"], [], True, False, *exported, ["r"], [chain])
        show("controllers", "controller_manager_msgs/msg/List", new("controller_manager_msgs/msg/List", [controller]))
        lists = [["jtc"], [], [], []] if distro == "humble" else [["jtc"], []]
        flags = [False, True] if distro == "humble" else [True]
        show("switch", "controller_manager_msgs/msg/Switch",
             new("controller_manager_msgs/msg/Switch", *lists, 2, *flags, duration))


main()
