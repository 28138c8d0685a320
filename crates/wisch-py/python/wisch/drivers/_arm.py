"""What the drivers share: their parameters, the checks before a motion, and how a motion ends."""

from __future__ import annotations

import importlib
import time
from contextlib import contextmanager

import numpy as np

from .._errors import WischError
from ..executor import Executor
from ._poses import compose, turn_between
from ._reading import STALE_S, Reading, Stop
from ._run import Run
from ._trajectory import REST_RAD_S, Trajectory

#: Greatest deviation, where a motion starts, between the controller's pose of the tool and that of the motion [m], [rad].
FRAME_M, FRAME_RAD = 0.03, 0.1
#: Longest time until the robot is at rest and no longer controlled when a run finishes [s]; wisch waits for 2 s.
HAND_BACK_S = 1.5
#: Speeds between sampled points may exceed a limit of the planner by this factor, by rounding [1].
SPEED_ROUNDING = 1.01


class Arm(Executor):
    """An executor of motions on a real arm. A driver defines the methods that raise ``NotImplementedError``.

    ``speed`` scales the speed along every trajectory (above 0, at most 1). ``rate_hz`` is the rate of setpoints and samples.

    A motion is refused if it presses with more than ``force_limit_n`` [N], if its tool is faster than ``tool_speed_m_s``
    [m/s], or if a joint is farther than ``start_rad`` [rad] from its start. A motion is stopped if the force on the tool
    exceeds ``force_limit_n``, if the tool is farther than ``lag_m`` [m] from its setpoint, or if, while it wipes, it is more
    than ``depth_m`` [m] above or below the believed surface.

    ``root_from_base`` (7) is the pose of the controller's base frame in the robot's root link. ``joints`` are the ends of the
    names of the joints, in the order of the controller. ``clock`` and ``sleep`` are those of ``time``, or of a test.
    """

    #: Ends of the names of the joints, in the order of the controller.
    JOINTS: tuple[str, ...] = ()

    #: Longest silence during a motion that wisch permits a driver [s]: longer than any hold takes.
    max_silence_s = 5.0
    #: wisch never keeps the loop of setpoints waiting, pauses it on request, and learns the time of the robot's clock.
    is_real_time, can_pause, stamp_clock = True, True, "device"

    def __init__(
        self,
        *,
        speed: float = 1.0,
        rate_hz: float = 125.0,
        tool_speed_m_s: float = 0.25,
        force_limit_n: float = 30.0,
        start_rad: float = 0.02,
        lag_m: float = 0.05,
        depth_m: float = 0.02,
        root_from_base=(0, 0, 0, 0, 0, 0, 1),
        joints=None,
        clock=time.monotonic,
        sleep=time.sleep,
    ) -> None:
        if not 0 < speed <= 1:
            raise WischError(f"speed = {speed} is outside its limits: above 0 and at most 1")
        self.speed, self.period_s = speed, 1.0 / rate_hz
        self.tool_speed_m_s, self.force_limit_n, self.start_rad = tool_speed_m_s, force_limit_n, start_rad
        self.lag_m, self.depth_m = lag_m, depth_m
        self.root_from_base = np.asarray(root_from_base, float)
        self.joints = tuple(joints or self.JOINTS)
        #: Whether the force has been tared since the driver began.
        self.is_tared = False
        #: Share of its speed at which the present motion runs: below 1 where it pauses [1].
        self.pace = 1.0
        self._clock, self._sleep = clock, sleep

    def prepare(self, robot) -> None:
        """Raise WischError if the robot is not one that this driver moves, or is not ready. Nothing moves."""
        if robot is not None:
            self._refuse_joints(robot.joints)
        if fault := self._fault():
            raise WischError(f"the robot is not ready: {fault[1]}")

    def finish(self) -> None:
        """Hold and end the control of the robot; raise WischError if that is not confirmed within ``HAND_BACK_S``."""
        self._hold()
        begin = self._clock()
        while left := self._left():
            if self._clock() - begin > HAND_BACK_S:
                raise WischError(f"the robot is not handed back: {left} after {HAND_BACK_S} s")
            self._sleep(self.period_s)

    def _left(self) -> str:
        """Return what still keeps the robot from being handed back; nothing if it is at rest and no command controls it."""
        speed = float(np.abs(self._read().velocities).max())
        return self._describe_control() or ("" if speed <= REST_RAD_S else f"it moves at {speed:.3f} rad/s")

    def state(self):
        """Return the joint positions [rad] and velocities [rad/s]."""
        reading = self._read()
        return {"positions": reading.positions, "velocities": reading.velocities}

    def read_force(self):
        """Return the force of the surroundings on the tool, in the axes of the controller's base frame [N] (3)."""
        return self._read().force_n

    def execute(self, motion, sink):
        """Check motion and robot, follow the motion, and hold. ``Executor.execute`` documents arguments and result.

        Raises WischError, before anything moves, if a check fails.
        """
        path = Trajectory(motion, self.root_from_base)
        self._refuse_motion(path)
        self._refuse_state(path)
        run = Run(self, path, sink)
        try:
            self._begin(path)
            ending = run.follow()
        except Stop as stop:
            ending = {"stop": {"kind": stop.kind, "time_s": run.elapsed_s, "reason": stop.reason}}
        finally:
            self._hold()
        return {"ending": ending, "duration_s": run.elapsed_s, "positions": self._positions_after(run)}

    def close(self) -> None:
        """Hold, and hand the robot back."""
        self._hold()

    def _refuse_motion(self, path: Trajectory) -> None:
        """Raise WischError unless the motion is one for this robot, within its limits."""
        self._refuse_joints(path.joints)
        if path.press_force_n > self.force_limit_n:
            limit = f"more than force_limit_n = {self.force_limit_n:g} N"
            raise WischError(f"the motion presses with {path.press_force_n:g} N, {limit}")
        speed = self.speed * path.greatest_tool_speed()
        if speed > SPEED_ROUNDING * self.tool_speed_m_s:
            limit = f"faster than tool_speed_m_s = {self.tool_speed_m_s:g} m/s"
            help = "lower plan.free_speed_m_per_s of the task, or speed of the driver"
            raise WischError(f"the tool moves at {speed:.2f} m/s, {limit}", help=help)

    def _refuse_joints(self, names) -> None:
        """Raise WischError unless these are the joints of this robot, in its order."""
        matches = len(names) == len(self.joints)
        if not matches or not all(name.endswith(end) for name, end in zip(names, self.joints)):
            given, expected = ", ".join(names), ", ".join(self.joints)
            raise WischError(f"the motion moves {given}; expected joints whose names end in {expected}, in this order")

    def _refuse_state(self, path: Trajectory) -> None:
        """Raise WischError unless the robot is ready, and at rest where the motion starts."""
        if fault := self._fault():
            raise WischError(f"the robot is not ready: {fault[1]}")
        reading = self._read_fresh()
        speed = float(np.abs(reading.velocities).max())
        if not speed <= REST_RAD_S:
            raise WischError(f"the robot moves at {speed:.3f} rad/s; a motion begins at rest, below {REST_RAD_S} rad/s")
        distances = np.abs(reading.positions - path.positions[0])
        worst = int(distances.argmax())
        if not distances[worst] <= self.start_rad:
            limit = f"more than start_rad = {self.start_rad:g} rad"
            raise WischError(f"{path.joints[worst]} is {distances[worst]:.3f} rad from the start of the motion, {limit}")
        tool = compose(path.world_from_base, reading.base_from_tool)
        way = float(np.linalg.norm(tool[:3] - path.world_from_tool[0, :3]))
        turn = turn_between(tool[3:], path.world_from_tool[0, 3:])
        if not (way <= FRAME_M and turn <= FRAME_RAD):
            limit = f"more than {FRAME_M} m or {FRAME_RAD} rad"
            help = "give the controller the tool frame of the task, and check root_from_base"
            raise WischError(f"the controller's tool is {way:.3f} m and {turn:.2f} rad from the motion's, {limit}", help=help)

    def _read_fresh(self) -> Reading:
        """Return a state that is newer than the call; raise WischError if none arrives."""
        old, begin = self._read(), self._clock()
        while (reading := self._read()).clock_s == old.clock_s:
            if self._clock() - begin > STALE_S:
                raise WischError(f"the robot has sent no new state for {STALE_S} s")
            self._sleep(self.period_s)
        return reading

    def _positions_after(self, run):
        """Return the joint positions after a motion, or the last known ones [rad]."""
        try:
            return self._read().positions
        except Exception:  # the link may be lost, and the hold has been commanded
            return run.reading.positions if run.reading else []

    @contextmanager
    def guard(self):
        """Turn an exception of the robot's package into a stop: of the robot's fault, else ``link_lost``."""
        try:
            yield
        except (Stop, WischError):
            raise
        except Exception as error:
            try:
                fault = self._fault(moving=True)
            except Exception:  # the link is lost, so the first error is what to report
                fault = None
            raise Stop(*(fault or ("link_lost", f"{type(error).__name__}: {error}"))) from error

    def _read(self) -> Reading:
        """Return the present state of the robot."""
        raise NotImplementedError

    def _fault(self, moving: bool = False) -> tuple[str, str] | None:
        """Return what forbids to move, as kind of stop and reason; None if nothing does."""
        raise NotImplementedError

    def _describe_control(self) -> str:
        """Return what of this driver controls the robot, as a text; nothing if nothing does."""
        raise NotImplementedError

    def _scaling(self) -> float:
        """Return the share of the commanded speed at which the controller runs (0 to 1)."""
        return 1.0

    def _begin(self, path: Trajectory) -> None:
        """Prepare the controller for a motion."""
        raise NotImplementedError

    def _tare(self, force_n) -> None:
        """Make the present force zero; ``force_n`` (3) is its mean over the last moments [N]."""
        raise NotImplementedError

    def _start_pressing(self, path: Trajectory, positions) -> None:
        """Switch force along the surface's normal on."""
        raise NotImplementedError

    def _stop_pressing(self, path: Trajectory) -> None:
        """Switch force along the surface's normal off."""
        raise NotImplementedError

    def _command(self, path: Trajectory, time_s: float, positions, velocities) -> None:
        """Send the setpoint of a time on the trajectory [s]."""
        raise NotImplementedError

    def _begin_period(self):
        """Begin a period of the loop; return what ``_end_period`` needs."""
        return self._clock()

    def _end_period(self, begun) -> None:
        """Wait for the end of a period of the loop."""
        self._sleep(max(0.0, begun + self.period_s - self._clock()))

    def _hold(self) -> None:
        """Bring the robot to rest and end every command. Raises nothing, and may be called at any time."""
        raise NotImplementedError


def import_driver_package(module: str, package: str, extra: str):
    """Return an imported module; raise ImportError with the name of its package if it is missing."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(f"{error}; install {package}: pip install {package}, or pip install wisch[{extra}]") from error
