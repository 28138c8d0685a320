"""Driver for arms of Franka Robotics, through the package ``franky-control``."""

from __future__ import annotations

import sys

import numpy as np

from ._arm import Arm, Reading, import_driver_package
from ._poses import compose, invert

#: Joint stiffness in free motion [Nm/rad].
JOINT_STIFFNESS = (600.0, 600.0, 600.0, 600.0, 250.0, 150.0, 50.0)
#: Stiffness of the wiping tool along the surface [N/m], and of its orientation [Nm/rad].
LATERAL_STIFFNESS, ROTATIONAL_STIFFNESS = 1500.0, 50.0
#: Stiffness that keeps the posture while the tool wipes [Nm/rad].
POSTURE_STIFFNESS = 20.0
#: Force of the unsaturated spring along the normal over the press force [1]: the tool is commanded this much deeper.
SATURATION = 1.1
#: Robot modes that end a motion, with the kind of stop that each is.
ROBOT_MODES = {
    "Reflex": ("protective_stop", "the robot has stopped by a reflex"),
    "UserStopped": ("operator", "the robot is stopped by the user"),
    "Guiding": ("operator", "the robot is guided by hand"),
    "AutomaticErrorRecovery": ("operator", "the robot recovers from an error"),
    "Other": ("emergency_stop", "the brakes are closed, or the robot is emergency-stopped"),
}
#: Longest wait for the end of a stop [s].
STOP_TIMEOUT_S = 3.0


class Franky(Arm):
    """Executor of motions on an arm of Franka Robotics (FR3 or Panda), with impedance control at 1 kHz by ``franky``.

    ``host`` is the address of the robot. ``robot`` and ``franky`` replace the connection and the module, for a test or for a
    robot that is connected already. ``tool_mass_kg`` [kg] and ``tool_centre_m`` [m] (3, in the frame of the flange) set the
    load. ``joint_stiffness`` [Nm/rad] (7) applies in free motion. ``Arm`` documents the other parameters.

    In free motion, joint impedance control follows the joints. While the tool wipes, Cartesian impedance control has the
    task's stiffness, its setpoint lies in the surface, and its force along the normal saturates at the press force.

    The controller's end effector frame EE must be the tool frame of the task. Forces are the controller's estimate
    ``O_F_ext_hat_K`` with its sign changed, less the tare, in the axes of its base; samples state them in those of the world.
    """

    JOINTS = tuple(f"joint{number}" for number in range(1, 8))

    def __init__(
        self,
        host: str = "",
        *,
        robot=None,
        franky=None,
        tool_mass_kg: float | None = None,
        tool_centre_m=(0.0, 0.0, 0.0),
        joint_stiffness=JOINT_STIFFNESS,
        **parameters,
    ) -> None:
        super().__init__(**parameters)
        self._franky = franky or import_driver_package("franky", "franky-control", "franka")
        self._robot = robot or self._franky.Robot(host)
        self.joint_stiffness = np.asarray(joint_stiffness, float)
        self._tracker = None
        #: Force that taring subtracts [N], and the last measured position of the tool in the base frame [m].
        self._tare_n, self._measured_m = np.zeros(3), np.zeros(3)
        if tool_mass_kg is not None:
            self._robot.set_load(tool_mass_kg, [float(x) for x in tool_centre_m], [0.0] * 9)

    def recover(self) -> bool:
        """Clear the robot's error; return whether that succeeded. Only an operator who has inspected the robot may call this."""
        return self._robot.recover_from_errors()

    def _read(self) -> Reading:
        state = self._robot.state
        pose = state.O_T_EE
        self._measured_m = np.ravel(pose.translation)
        return Reading(
            positions=np.array(state.q, float),
            velocities=np.array(state.dq, float),
            base_from_tool=np.concatenate([self._measured_m, np.ravel(pose.quaternion)]),
            # The controller states the force that the robot exerts.
            force_n=-np.array(state.O_F_ext_hat_K, float)[:3] - self._tare_n,
            clock_s=state.time.to_sec(),
        )

    def _fault(self, moving: bool = False) -> tuple[str, str] | None:
        mode = self._robot.state.robot_mode.name
        if mode in ROBOT_MODES:
            kind, reason = ROBOT_MODES[mode]
            return kind, f"{reason} (mode {mode}){self._errors()}"
        if self._robot.has_errors:
            return "protective_stop", f"the robot has an error{self._errors()}"
        if moving and self._tracker is not None:
            self._robot.poll_motion()  # raises what ended the control loop
            if not self._robot.is_in_control:
                return "link_lost", "the control loop has ended"
        if not moving and mode != "Idle":
            return "operator", f"the robot mode is {mode}, not Idle"
        return None

    def _describe_control(self) -> str:
        return "the driver's control loop runs" if self._robot.is_in_control else ""

    def _errors(self) -> str:
        """Return the names of the robot's present errors, after a colon, or nothing."""
        errors = self._robot.state.current_errors
        names = [name for name in dir(errors) if not name.startswith("_") and getattr(errors, name) is True]
        return f": {', '.join(names)}" if names else ""

    def _begin(self, path) -> None:
        self._track_joints()

    def _track_joints(self) -> None:
        """Let joint impedance control take over, at the present posture."""
        self._tracker = self._franky.JointImpedanceTracker(self._robot, stiffness=self.joint_stiffness)

    def _tare(self, force_n) -> None:
        self._tare_n = self._tare_n + force_n

    def _start_pressing(self, path, positions) -> None:
        posture = self._franky.PostureTask(positions, POSTURE_STIFFNESS)
        # _command saturates the force along the normal; this bounds the spring if no setpoint follows.
        clip = np.full(3, self.force_limit_n / path.stiffness_n_per_m)
        gains = self._franky.CartesianImpedanceGains()
        gains.stiffness = self._stiffness(path)
        self._tracker = self._franky.CartesianImpedanceTracker(
            self._robot, gains=gains, translational_error_clip=clip, posture_task=posture
        )

    def _stiffness(self, path):
        """Return the stiffness of the wiping tool in the axes of the base (6, 6): the task's along the normal."""
        along_normal = np.outer(path.normal_in_base, path.normal_in_base)
        stiffness = ROTATIONAL_STIFFNESS * np.eye(6)
        stiffness[:3, :3] = path.stiffness_n_per_m * along_normal + LATERAL_STIFFNESS * (np.eye(3) - along_normal)
        return stiffness

    def _stop_pressing(self, path) -> None:
        self._track_joints()

    def _command(self, path, time_s, positions, velocities) -> None:
        if isinstance(self._tracker, self._franky.JointImpedanceTracker):
            self._tracker.set_target(positions, velocities * self.speed * self.pace)
            return
        normal, target = path.normal_in_base, compose(invert(path.world_from_base), path.tool(time_s))
        # The spring along the normal is saturated: it ends at most press force / stiffness below the measured tool.
        depth = path.press_force_n / path.stiffness_n_per_m
        height = float((self._measured_m - target[:3]) @ normal)
        target[:3] += max(-SATURATION * depth, height - depth) * normal
        twist = self._franky.Twist(self.speed * self.pace * path.tool_velocity_in_base(time_s))
        self._tracker.set_target(self._franky.Affine(target[:3], target[3:]), twist)

    def _hold(self) -> None:
        tracker, self._tracker = self._tracker, None
        try:
            if tracker is not None and self._robot.is_in_control:
                self._robot.move(self._franky.TorqueStopMotion(), asynchronous=True)
                if self._robot.join_motion(STOP_TIMEOUT_S):
                    return
        except Exception as error:  # the robot is stopped all the same
            print(f"{type(error).__name__} while holding: {error}", file=sys.stderr)
        try:
            self._robot.stop()
        except Exception as error:  # nothing more can be commanded
            print(f"{type(error).__name__} while stopping: {error}", file=sys.stderr)
