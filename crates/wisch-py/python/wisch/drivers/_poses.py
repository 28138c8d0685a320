"""Poses as arrays of seven numbers: x, y, z [m] and a unit quaternion x, y, z, w."""

from __future__ import annotations

import numpy as np


def cross(a, b):
    """Return the cross product of two vectors (3); for single vectors, ``numpy.cross`` is many times slower."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def rotate(quaternion, vector):
    """Return a vector (3), turned by a unit quaternion x, y, z, w."""
    axis, scalar = np.asarray(quaternion[:3]), quaternion[3]
    twice = 2.0 * cross(axis, vector)
    return vector + scalar * twice + cross(axis, twice)


def multiply(p, q):
    """Return the product of two quaternions."""
    vector = p[3] * q[:3] + q[3] * p[:3] + cross(p[:3], q[:3])
    return np.append(vector, p[3] * q[3] - p[:3] @ q[:3])


def compose(a_from_b, b_from_c):
    """Return the pose a_from_c (7)."""
    a_from_b, b_from_c = np.asarray(a_from_b, float), np.asarray(b_from_c, float)
    position = a_from_b[:3] + rotate(a_from_b[3:], b_from_c[:3])
    return np.append(position, multiply(a_from_b[3:], b_from_c[3:]))


def invert(a_from_b):
    """Return the pose b_from_a (7)."""
    quaternion = np.asarray(a_from_b[3:], float) * [-1, -1, -1, 1]
    return np.append(-rotate(quaternion, np.asarray(a_from_b[:3], float)), quaternion)


def turn_between(p, q):
    """Return the angle between two orientations, given as unit quaternions [rad]."""
    return 2.0 * np.arccos(min(1.0, abs(float(np.dot(p, q)))))


def to_rotation_vector(pose):
    """Return a pose as x, y, z [m] and a rotation vector [rad], as Universal Robots writes it (6)."""
    pose = np.asarray(pose, float)
    vector, scalar = (pose[3:6], pose[6]) if pose[6] >= 0 else (-pose[3:6], -pose[6])
    sine = np.linalg.norm(vector)
    scale = 2.0 * np.arctan2(sine, scalar) / sine if sine > 1e-12 else 2.0
    return np.append(pose[:3], scale * vector)


def from_rotation_vector(pose):
    """Return a pose (7) from x, y, z [m] and a rotation vector [rad]."""
    pose = np.asarray(pose, float)
    angle = np.linalg.norm(pose[3:])
    scale = np.sin(angle / 2) / angle if angle > 1e-12 else 0.5
    return np.concatenate([pose[:3], scale * pose[3:], [np.cos(angle / 2)]])
