"""Poses as arrays of seven numbers: x, y, z [m] and a unit quaternion x, y, z, w. MuJoCo has w first."""

import mujoco
import numpy as np


def rotation(pose):
    """Its rotation matrix (3, 3)."""
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, wxyz(pose))
    return matrix.reshape(3, 3)


def wxyz(pose):
    """Its quaternion as MuJoCo has it (4)."""
    return np.array([pose[6], pose[3], pose[4], pose[5]], dtype=float)


def pose_of(position, quaternion_wxyz):
    """A pose of MuJoCo's position (3) and quaternion (4)."""
    w, x, y, z = quaternion_wxyz
    return np.array([*position, x, y, z, w], dtype=float)


def times(a_from_b, b_from_c):
    """The pose a_from_c."""
    quaternion = np.zeros(4)
    mujoco.mju_mulQuat(quaternion, wxyz(a_from_b), wxyz(b_from_c))
    return pose_of(np.asarray(a_from_b[:3]) + rotation(a_from_b) @ np.asarray(b_from_c[:3]), quaternion)


def inverse(pose):
    """The pose the other way round."""
    quaternion = np.zeros(4)
    mujoco.mju_negQuat(quaternion, wxyz(pose))
    return pose_of(-rotation(pose).T @ np.asarray(pose[:3]), quaternion)


def turned(axis, angle):
    """A pose that only turns about an axis."""
    quaternion = np.zeros(4)
    mujoco.mju_axisAngle2Quat(quaternion, np.asarray(axis, dtype=float), angle)
    return pose_of(np.zeros(3), quaternion)


def into(pose, points):
    """Points (n, 3) of the frame that the pose leads to, in the frame that it leads from."""
    return np.asarray(points) @ rotation(pose).T + np.asarray(pose[:3])
