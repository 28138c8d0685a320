"""Motions that arrive over the executor protocol, and the controller for them.

The protocol sends points of the joints and of the tool, but not the plan, from which the wheel makes its controller (equation 8
of the paper). This module has the same law with the wheel's dynamics: a Cartesian spring that is pressed into the surface, and
saturates at the task's force.
"""

import mujoco
import numpy as np
import wisch

from . import poses

LATERAL_STIFFNESS = 2000.0
"""Stiffness along the surface [N/m]."""
TURNING_STIFFNESS = 60.0
"""Rotational stiffness [Nm/rad]."""
MOMENT_LIMIT = 8.0
"""Largest moment [Nm]."""
PRESS_MARGIN = 1.1
"""Ratio of the spring's force on the surface to its saturation [1]."""
APPROACH_HEIGHT = 0.012
"""Height above the surface below which the spring is commanded into it [m]."""
POSTURE_STIFFNESS = 20.0
"""Null-space stiffness of the joints towards their planned positions [Nm/rad]."""
OBSERVER_GAIN = 150.0
"""Bandwidth of the observer of external torques [1/s]."""


class Frames:
    """What a motion of the protocol does not state and no round changes: the tool in the hand, and the robot's root."""

    def __init__(self, task):
        self.robot = task.robot()
        if self.robot is None:
            raise ValueError(f"{task.name}: the task names no robot")
        planned = task.session(robot=self.robot).follow()
        self.tip, self.tip_from_tool = planned.tip, np.asarray(planned.tip_from_tool)
        self.world_from_root = np.asarray(planned.world_from_root)
        self.compliant = np.array(wisch.ImpedanceController(planned).compliant)


class WireMotion:
    """A motion of the protocol, with the frames that it does not state."""

    def __init__(self, motion, frames):
        self._motion, self._frames = motion, frames

    def __getattr__(self, name):
        of_frames = name in ("tip", "tip_from_tool", "world_from_root")
        return getattr(self._frames if of_frames else self._motion, name)

    def setpoints(self, _period):
        """Returns the points of the motion."""
        return {"positions": self._motion.positions}

    def controller(self, period_s, tool_mass_kg):
        """Returns the controller for the motion."""
        return Controller(self, self._frames, period_s, tool_mass_kg)


class Controller:
    """A controller with the interface of `wisch.ImpedanceController` that `Simulation` uses."""

    def __init__(self, motion, frames, period, tool_mass):
        self.motion, self.robot, self.period = motion, frames.robot, period
        self.compliant = frames.compliant
        self.frames = frames
        self.turn = poses.rotation(frames.world_from_root)
        self.weight = tool_mass * np.array([0.0, 0.0, -9.81])
        limits = [self.robot.limits[motion.joints[i]]["effort"] for i in self.compliant]
        self.limits = np.array([limit or np.inf for limit in limits])
        self.surface = poses.rotation(motion.world_from_surface)
        axes = np.array([LATERAL_STIFFNESS, LATERAL_STIFFNESS, motion.stiffness_n_per_m])
        self.stiffness = self.surface @ np.diag(axes) @ self.surface.T
        self.depth = PRESS_MARGIN * motion.press_force_n / motion.stiffness_n_per_m
        self.last = np.zeros(len(self.compliant))
        self.mass = None
        self.begun = self.sum = self.residual = np.zeros(len(self.compliant))

    def _between(self, column, time):
        """Interpolates a column of the points at a time; returns value and rate."""
        times = self.motion.time_s
        k = int(np.clip(np.searchsorted(times, time, side="right") - 1, 0, len(times) - 2))
        step = times[k + 1] - times[k]
        share = np.clip((time - times[k]) / step, 0.0, 1.0)
        change = column[k + 1] - column[k]
        return column[k] + share * change, change / step

    def command(self, time, q, qd):
        """Returns the efforts of the compliant joints (k) at a time [s], from all positions and velocities (n)."""
        motion, frames, own = self.motion, self.frames, self.compliant
        planned_q, _ = self._between(motion.positions, time)
        planned_qd, planned_qdd = self._between(motion.velocities, time)
        place, rate = self._between(motion.world_from_tool, time)
        place[3:] /= np.linalg.norm(place[3:])
        tool = poses.times(frames.world_from_root, poses.times(self.robot.pose(q, frames.tip), frames.tip_from_tool))
        self.planned = planned_q, planned_qd, planned_qdd
        self.world_from_tool = tool
        self.world_from_commanded = self._pressed_in(place, time)

        jacobian = np.asarray(self.robot.jacobian(q, frames.tip, frames.tip_from_tool[:3]))[:, own]
        jacobian = np.vstack([self.turn @ jacobian[:3], self.turn @ jacobian[3:]])
        mass = np.asarray(self.robot.mass_matrix(q))[np.ix_(own, own)]
        bias = np.asarray(self.robot.bias(q, qd))[own] - jacobian[:3].T @ self.weight
        twist = jacobian @ qd[own]
        inverse = np.linalg.inv(mass)
        mobility = jacobian @ inverse @ jacobian.T + 1e-6 * np.eye(6)

        error = self.world_from_commanded[:3] - tool[:3]
        turn = turned_by(tool, self.world_from_commanded)
        force = self.stiffness @ error + self._damping(self.stiffness, mobility[:3, :3]) @ (rate[:3] - twist[:3])
        spin = TURNING_STIFFNESS * np.eye(3)
        moment = TURNING_STIFFNESS * turn - self._damping(spin, mobility[3:, 3:]) @ twist[3:]
        force *= min(1.0, motion.press_force_n / max(np.linalg.norm(force), 1e-9))
        moment *= min(1.0, MOMENT_LIMIT / max(np.linalg.norm(moment), 1e-9))
        self.controller_wrench = np.concatenate([force, moment])
        posture = POSTURE_STIFFNESS * (planned_q[own] - q[own]) - 2.0 * np.sqrt(POSTURE_STIFFNESS) * 0.5 * (qd - planned_qd)[own]
        free = np.eye(len(own)) - jacobian.T @ np.linalg.solve(mobility, jacobian @ inverse)
        self._observe(mass, bias, qd[own], jacobian, inverse, mobility)
        # The planned acceleration and the weight are fed forward.
        bias = bias + mass @ planned_qdd[own]
        self.last = np.clip(bias + jacobian.T @ self.controller_wrench + free @ posture, -self.limits, self.limits)
        return self.last

    def _damping(self, stiffness, mobility):
        """Returns the damping of a spring on the mass that it moves: the task's ratio along each axis of the world."""
        masses = 1.0 / np.maximum(np.diag(mobility), 1e-3)
        root = np.sqrt(np.maximum(np.diag(stiffness), 1.0) * masses)
        return np.diag(2.0 * self.motion.damping_ratio * root)

    def _pressed_in(self, place, time):
        """Returns a point of the path, shifted into the believed surface where the tool presses."""
        up = self.surface[:, 2]
        height = up @ (place[:3] - self.motion.world_from_surface[:3])
        phase = next((p["phase"] for p in reversed(self.motion.phases) if p["start_s"] <= time), "transfer")
        share = np.clip(1.0 - height / APPROACH_HEIGHT, 0.0, 1.0) if phase in ("lower", "wipe", "lift") else 0.0
        return np.concatenate([place[:3] - share * self.depth * up, place[3:]])

    def _observe(self, mass, bias, qd, jacobian, inverse, mobility):
        """Estimates the external force on the tool from the robot's momentum."""
        momentum = mass @ qd
        if self.mass is None:
            self.begun = momentum
        else:
            drift = (mass - self.mass) @ qd / self.period
            self.sum = self.sum + (self.last - bias + drift + self.residual) * self.period
            self.residual = OBSERVER_GAIN * (momentum - self.sum - self.begun)
        self.mass = mass
        self.external_wrench = np.linalg.solve(mobility, jacobian @ inverse @ self.residual)


def turned_by(pose, other):
    """Returns axis times angle, in the world, from the rotation of one pose to that of another [rad]."""
    inverse, quaternion, vector = np.zeros(4), np.zeros(4), np.zeros(3)
    mujoco.mju_negQuat(inverse, poses.wxyz(pose))
    mujoco.mju_mulQuat(quaternion, poses.wxyz(other), inverse)
    mujoco.mju_quat2Vel(vector, quaternion, 1.0)
    return vector
