"""Reads the trajectories that wisch writes as a ROS 2 program does, with PyYAML, and checks them.

    pip install -r peers/requirements.txt
    wisch run scenarios/chopping-board.toml --out out/board
    python peers/trajectory.py out/board

The file must hold the same moveit_msgs/msg/RobotTrajectory as YAML and as JSON: exactly the fields of its messages, each
of its type (YAML 1.1 reads 6e-6 as a text), as many values as joints, increasing times, and unit
quaternions. First, the script checks that each rule finds a trajectory that breaks it.
"""

import copy
import json
import math
import pathlib
import sys

import yaml

# trajectory_msgs, geometry_msgs, std_msgs and builtin_interfaces: field -> type; [type] is a sequence.
XYZ = {"x": float, "y": float, "z": float}
TIME = {"sec": int, "nanosec": int}
HEADER = {"stamp": TIME, "frame_id": str}
TRANSFORM = {"translation": XYZ, "rotation": XYZ | {"w": float}}
TWIST = {"linear": XYZ, "angular": XYZ}
JOINT_POINT = {
    "positions": [float],
    "velocities": [float],
    "accelerations": [float],
    "effort": [float],
    "time_from_start": TIME,
}
MULTI_DOF_POINT = {
    "transforms": [TRANSFORM],
    "velocities": [TWIST],
    "accelerations": [TWIST],
    "time_from_start": TIME,
}
ROBOT_TRAJECTORY = {
    "joint_trajectory": {"header": HEADER, "joint_names": [str], "points": [JOINT_POINT]},
    "multi_dof_joint_trajectory": {"header": HEADER, "joint_names": [str], "points": [MULTI_DOF_POINT]},
}


def type_faults(value, expected, at=""):
    """Where a value is not what the message says."""
    if isinstance(expected, dict):
        if not isinstance(value, dict) or set(value) != set(expected):
            return [f"{at}: fields {list(value) if isinstance(value, dict) else value}, expected {list(expected)}"]
        return [f for key in expected for f in type_faults(value[key], expected[key], f"{at}.{key}")]
    if isinstance(expected, list):
        if not isinstance(value, list):
            return [f"{at}: {value!r} is no sequence"]
        return [f for i, item in enumerate(value) for f in type_faults(item, expected[0], f"{at}[{i}]")]
    if type(value) is not expected:
        return [f"{at}: {value!r} is no {expected.__name__}"]
    return [f"{at}: {value} is not finite"] if expected is float and not math.isfinite(value) else []


def meaning_faults(message):
    """Lengths, times and quaternions; only for a message of the right types."""
    faults = []
    for name, trajectory in message.items():
        joints = len(trajectory["joint_names"])
        optional = {"effort"}
        before = -1
        for i, point in enumerate(trajectory["points"]):
            at = f"{name}.points[{i}]"
            for key, values in point.items():
                if key != "time_from_start" and len(values) != joints and not (key in optional and not values):
                    faults.append(f"{at}.{key}: {len(values)} values for {joints} joints")
            time = point["time_from_start"]
            nanoseconds = time["sec"] * 10**9 + time["nanosec"]
            if not 0 <= time["nanosec"] < 10**9:
                faults.append(f"{at}: {time['nanosec']} ns are no part of a second")
            if nanoseconds <= before:
                faults.append(f"{at}: time does not grow")
            before = nanoseconds
            for transform in point.get("transforms", []):
                norm = math.hypot(*transform["rotation"].values())
                if abs(norm - 1.0) > 1e-5:
                    faults.append(f"{at}: the norm of the quaternion is {norm}")
    joint, base = message["joint_trajectory"], message["multi_dof_joint_trajectory"]
    times = [[p["time_from_start"] for p in t["points"]] for t in (joint, base)]
    if base["joint_names"] and times[0] != times[1]:
        faults.append("arm and base are not given at the same times")
    if not base["joint_names"] and base["points"]:
        faults.append("points of a base that has no name")
    return faults


def faults_of(from_yaml, from_json):
    faults = type_faults(from_yaml, ROBOT_TRAJECTORY) or meaning_faults(from_yaml)
    return faults + ([] if from_yaml == from_json else ["YAML and JSON differ"])


def check_the_checker(sound):
    """Each rule fails where it should."""

    def broken(change):
        message = copy.deepcopy(sound)
        change(message["joint_trajectory"])
        return message

    def rename(t):
        t["points"][0]["efforts"] = t["points"][0].pop("effort")

    def text(t):
        t["points"][0]["positions"][0] = "6e-6"

    def shorten(t):
        t["points"][0]["velocities"].pop()

    def stand_still(t):
        t["points"][1]["time_from_start"] = t["points"][0]["time_from_start"]

    for change in (rename, text, shorten, stand_still):
        message = broken(change)
        assert faults_of(message, message), change.__name__
    assert faults_of(sound, broken(text)) == ["YAML and JSON differ"]


def main(folder):
    path = pathlib.Path(folder) / "trajectories" / "trajectory.json"
    from_yaml = yaml.safe_load(path.read_text())
    from_json = json.loads(path.read_text())
    faults = faults_of(from_yaml, from_json)
    for fault in faults[:20]:
        print(f"{folder}: {fault}")
    if faults:
        sys.exit(f"{folder}: {len(faults)} faults")
    if len(from_json["joint_trajectory"]["points"]) > 1:
        check_the_checker(from_json)
    for name, trajectory in from_json.items():
        print(f"{folder}: {name}: {len(trajectory['joint_names'])} names, {len(trajectory['points'])} points")


if __name__ == "__main__":
    for argument in sys.argv[1:]:
        main(argument)
