"""Poses as arrays of seven numbers: x, y, z [m] and a unit quaternion x, y, z, w. MuJoCo has w first."""

import mujoco
import numpy as np


def rotation(pose):
    """Returns the rotation matrix (3, 3) of a pose."""
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, wxyz(pose))
    return matrix.reshape(3, 3)


def wxyz(pose):
    """Returns the quaternion of a pose in MuJoCo's order (4)."""
    return np.array([pose[6], pose[3], pose[4], pose[5]], dtype=float)


def pose_of(position, quaternion_wxyz):
    """Returns the pose of a position (3) and a quaternion in MuJoCo's order (4)."""
    w, x, y, z = quaternion_wxyz
    return np.array([*position, x, y, z, w], dtype=float)


def times(a_from_b, b_from_c):
    """Returns the composed pose a_from_c."""
    quaternion = np.zeros(4)
    mujoco.mju_mulQuat(quaternion, wxyz(a_from_b), wxyz(b_from_c))
    return pose_of(np.asarray(a_from_b[:3]) + rotation(a_from_b) @ np.asarray(b_from_c[:3]), quaternion)


def inverse(pose):
    """Returns the inverse of a pose."""
    quaternion = np.zeros(4)
    mujoco.mju_negQuat(quaternion, wxyz(pose))
    return pose_of(-rotation(pose).T @ np.asarray(pose[:3]), quaternion)


def turned(axis, angle):
    """Returns a pose that only rotates about an axis."""
    quaternion = np.zeros(4)
    mujoco.mju_axisAngle2Quat(quaternion, np.asarray(axis, dtype=float), angle)
    return pose_of(np.zeros(3), quaternion)


def into(pose, points):
    """Returns points (n, 3) of frame b in frame a, for a pose a_from_b."""
    return np.asarray(points) @ rotation(pose).T + np.asarray(pose[:3])
