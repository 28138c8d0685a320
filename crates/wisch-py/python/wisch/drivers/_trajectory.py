"""A motion as a continuous trajectory: setpoints at any time, its phases, and where it may pause."""

from __future__ import annotations

import numpy as np

from .._errors import WischError
from ._poses import compose, invert, rotate

#: Joint speed below which a robot or a trajectory is at rest [rad/s]; the limit of the executor protocol.
REST_RAD_S = 0.02


class Trajectory:
    """The trajectory of a motion.

    ``world_from_base`` (7) is the pose of the frame in which the robot's controller states poses.
    """

    def __init__(self, motion, root_from_base) -> None:
        # A property of a motion may copy its array, so each is read once.
        self.joints = list(motion.joints)
        self.time_s = np.asarray(motion.time_s, float)
        self.positions = np.asarray(motion.positions, float)
        self.velocities = np.asarray(motion.velocities, float)
        self.accelerations = np.asarray(motion.accelerations, float)
        self.world_from_tool = np.asarray(motion.world_from_tool, float)
        self.phases = list(motion.phases)
        self.stiffness_n_per_m = float(motion.stiffness_n_per_m)
        self.press_force_n = float(motion.press_force_n) if motion.gap_m is None else 0.0
        if len(self.time_s) < 2 or not (np.diff(self.time_s) > 0).all():
            raise WischError("the times of the motion's points do not increase")
        self.end_s = float(self.time_s[-1])
        self.world_from_base = compose(motion.world_from_root, root_from_base)
        self.base_from_surface = compose(invert(self.world_from_base), motion.world_from_surface)
        self.normal_in_world = rotate(np.asarray(motion.world_from_surface, float)[3:], np.array([0.0, 0.0, 1.0]))
        self.normal_in_base = rotate(self.base_from_surface[3:], np.array([0.0, 0.0, 1.0]))

    def setpoint(self, time_s: float):
        """Return joint positions and velocities at a time [s], by the polynomial of fifth degree between two points."""
        k, step, s = self._locate(time_s)
        p, v, a = self.positions[k : k + 2], self.velocities[k : k + 2] * step, self.accelerations[k : k + 2] * step**2
        way = p[1] - p[0]
        c3 = 10 * way - 6 * v[0] - 4 * v[1] + (a[1] - 3 * a[0]) / 2
        c4 = -15 * way + 8 * v[0] + 7 * v[1] + 1.5 * a[0] - a[1]
        c5 = 6 * way - 3 * (v[0] + v[1]) + (a[1] - a[0]) / 2
        positions = p[0] + s * (v[0] + s * (a[0] / 2 + s * (c3 + s * (c4 + s * c5))))
        velocities = (v[0] + s * (a[0] + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / step
        return positions, velocities

    def tool(self, time_s: float):
        """Return the pose of the tool in the world at a time [s] (7)."""
        k, _, s = self._locate(time_s)
        before, after = self.world_from_tool[k], self.world_from_tool[k + 1].copy()
        after[3:] *= 1.0 if before[3:] @ after[3:] >= 0 else -1.0
        pose = (1 - s) * before + s * after
        pose[3:] /= np.linalg.norm(pose[3:])
        return pose

    def tool_velocity_in_base(self, time_s: float):
        """Return the linear velocity of the tool at a time [s], in the axes of the controller's base frame [m/s] (3)."""
        k, step, _ = self._locate(time_s)
        way = self.world_from_tool[k + 1, :3] - self.world_from_tool[k, :3]
        return rotate(invert(self.world_from_base)[3:], way / step)

    def phase(self, time_s: float):
        """Return the phase at a time [s]: a dict of ``phase``, ``start_s``, ``end_s``."""
        starts = [phase["start_s"] for phase in self.phases]
        return self.phases[max(0, int(np.searchsorted(starts, time_s, side="right")) - 1)]

    def presses(self, time_s: float) -> bool:
        """Return whether the tool is pressed on at a time [s]: while it wipes, unless it hovers."""
        return self.press_force_n > 0 and self.phase(time_s)["phase"] == "wipe"

    def tare_time(self) -> float | None:
        """Return when the force may be tared [s]: at rest above the surface, before the tool is lowered first.

        None if the motion does not lower the tool, or begins in contact.
        """
        lowers = [phase["start_s"] for phase in self.phases if phase["phase"] == "lower"]
        if not lowers or self.phase(0.0)["phase"] in ("wipe", "lift"):
            return None
        return lowers[0] if np.abs(self.setpoint(lowers[0])[1]).max() <= REST_RAD_S else 0.0

    def greatest_tool_speed(self) -> float:
        """Return the greatest speed of the tool along the trajectory [m/s]."""
        ways = np.linalg.norm(np.diff(self.world_from_tool[:, :3], axis=0), axis=1)
        return float((ways / np.diff(self.time_s)).max())

    def _locate(self, time_s: float):
        """Return the index of the point before a time, the time between points [s], and the share of it that passed."""
        k = int(np.clip(np.searchsorted(self.time_s, time_s, side="right") - 1, 0, len(self.time_s) - 2))
        step = self.time_s[k + 1] - self.time_s[k]
        return k, step, float(np.clip((time_s - self.time_s[k]) / step, 0.0, 1.0))
