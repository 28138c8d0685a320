"""The loop that follows one motion: setpoints, supervision, taring, and the force along the surface's normal."""

from __future__ import annotations

import numpy as np

from ._poses import compose, rotate
from ._reading import STALE_S, Reading, Stop
from ._trajectory import REST_RAD_S, Trajectory

#: How long the robot must rest before the force is tared and before a motion is complete, and the longest wait for it [s].
SETTLE_S, SETTLE_TIMEOUT_S = 0.3, 3.0
#: Greatest force right after taring [N].
TARED_N = 3.0
#: Least force along the normal that counts as contact while the tool is lowered [N].
TOUCH_N = 3.0
#: Time on the trajectory over which an offset from it fades [s].
FADE_S = 0.5
#: Time in which the robot stops for a pause, and reaches its speed again after it [s].
PAUSE_RAMP_S = 0.5


class Run:
    """One motion on one arm. ``follow`` returns how it ended."""

    def __init__(self, arm, path: Trajectory, sink) -> None:
        self.arm, self.path, self.sink = arm, path, sink
        #: Time of the last sample since the motion began [s], and its reading.
        self.elapsed_s, self.reading = 0.0, None
        #: Time of the present setpoint on the trajectory [s].
        self.time_s = 0.0
        self._tare_s = path.tare_time()
        self._is_zeroed = False
        self._waits_since: float | None = None
        self._forces: list[np.ndarray] = []
        self._offset, self._offset_s = np.zeros(len(path.joints)), 0.0
        self._presses = False
        self._clock_s, self._heard = None, 0.0
        #: Whether the present reading is that of the sample before, and whether the motion is paused.
        self._is_stale, self._is_paused = False, False
        arm.pace = 1.0

    def follow(self):
        """Follow the trajectory to its end. Return "complete", or "stopped" if the sink asks for it; raise Stop on a fault."""
        begin = then = self._heard = self.arm._clock()
        self._offset = self._measure(begin).positions - self.path.positions[0]
        while True:
            period = self.arm._begin_period()
            now = self.arm._clock()
            before, self.reading = self.reading, self._measure(now)
            self._is_stale = before is not None and before.clock_s == self.reading.clock_s
            self.elapsed_s = now - begin
            if not self.sink(self._sample()):
                return "stopped"
            self._supervise()
            self._heed_pause(min(now - then, 2 * self.arm.period_s))
            if self._advance(now, min(now - then, 2 * self.arm.period_s)):
                return "complete"
            then = now
            with self.arm.guard():
                self._command()
                self.arm._end_period(period)

    def _measure(self, now: float) -> Reading:
        """Return the present state of the robot; raise Stop on a fault of it, or if the state is stale."""
        with self.arm.guard():
            if fault := self.arm._fault(moving=True):
                raise Stop(*fault)
            reading = self.arm._read()
        if reading.clock_s != self._clock_s:
            self._clock_s, self._heard = reading.clock_s, now
        elif now - self._heard > STALE_S:
            raise Stop("link_lost", f"the robot has sent no new state for {now - self._heard:.2f} s, more than {STALE_S} s")
        return reading

    def _sample(self) -> dict:
        """Return the present state as a sample of the executor protocol."""
        world_from_base = self.path.world_from_base
        return {
            "time_s": self.elapsed_s,
            "trajectory_time_s": self.time_s,
            "world_from_tool": compose(world_from_base, self.reading.base_from_tool),
            "force_n": rotate(world_from_base[3:], self.reading.force_n),
            "wrench_axes": "world",
            "positions": self.reading.positions,
            "velocities": self.reading.velocities,
            "wrench_quality": "stale" if self._is_stale else "ok" if self.arm.is_tared else "untared",
            "stamp_ns": round(self.reading.clock_s * 1e9),
        }

    def _heed_pause(self, step: float) -> None:
        """Slow the motion down while the operator wants a pause, and let it continue; ``step`` is the period that passed [s].

        A paused tool that wipes keeps pressing. Raise Stop if somebody has moved the paused robot.
        """
        wants = bool(getattr(self.sink, "wants_pause", False))
        if self._is_paused:
            off = float(np.abs(self.reading.positions - self._paused_at).max())
            if not off <= self.arm.start_rad:
                limit = f"more than start_rad = {self.arm.start_rad:g} rad"
                raise Stop("operator", f"the paused robot has moved by {off:.3f} rad, {limit}")
            if not wants:
                self._is_paused = False
                self.sink.resume(self.elapsed_s)
        self.arm.pace = float(np.clip(self.arm.pace + (-step if wants else step) / PAUSE_RAMP_S, 0.0, 1.0))
        if wants and not self._is_paused and self.arm.pace == 0 and np.abs(self.reading.velocities).max() <= REST_RAD_S:
            self._is_paused, self._paused_at, self._waits_since = True, self.reading.positions, None
            self.sink.pause(self.elapsed_s, "the operator")

    def _supervise(self) -> None:
        """Raise Stop if the force or the deviation from the trajectory exceeds its limit. A value that is not a number does."""
        force = float(np.linalg.norm(self.reading.force_n))
        limit = self.arm.force_limit_n
        if self.arm.is_tared and not force <= limit:
            raise Stop("overload", f"the force on the tool is {force:.1f} N, more than force_limit_n = {limit:g} N")
        tool = compose(self.path.world_from_base, self.reading.base_from_tool)
        error = tool[:3] - self.path.tool(self.time_s)[:3]
        if not np.linalg.norm(error) <= self.arm.lag_m:
            limit = f"more than lag_m = {self.arm.lag_m:g} m"
            raise Stop("tolerance", f"the tool is {np.linalg.norm(error):.3f} m from its setpoint, {limit}")
        height = float(error @ self.path.normal_in_world)
        if self._presses and not abs(height) <= self.arm.depth_m:
            limit = f"more than depth_m = {self.arm.depth_m:g} m"
            raise Stop("tolerance", f"the wiping tool is {height:+.3f} m from the believed surface, {limit}")

    def _advance(self, now: float, step: float) -> bool:
        """Move the setpoint on by a step of the clock [s]; return whether the motion is complete.

        The setpoint waits twice, until the robot is at rest: where the force is tared, and at the end.
        """
        with self.arm.guard():
            scaling = self.arm._scaling()
        gate_s = self.path.end_s if self._tare_s is None else self._tare_s
        self.time_s = min(self.time_s + step * self.arm.speed * self.arm.pace * scaling, gate_s)
        if self._is_paused:
            return False
        if self._touches_early():
            self.time_s = self.path.phase(self.time_s)["end_s"]
        if self.time_s < gate_s or not self._is_settled(now):
            return False
        if self._tare_s is None:
            return True
        self._tare()
        return False

    def _touches_early(self) -> bool:
        """Return whether the tool, while it is lowered, already touches: then its stroke begins."""
        if not self.arm.is_tared or self._tare_s is not None or self.path.press_force_n == 0:
            return False
        if self.path.phase(self.time_s)["phase"] != "lower":
            return False
        return self.reading.force_n @ self.path.normal_in_base >= max(TOUCH_N, 0.5 * self.path.press_force_n)

    def _is_settled(self, now: float) -> bool:
        """Return whether the robot has rested at its setpoint for ``SETTLE_S``; raise Stop if it never does."""
        if self._waits_since is None:
            self._waits_since, self._forces = now, []
        waited = now - self._waits_since
        if waited > SETTLE_TIMEOUT_S:
            raise Stop("tolerance", f"the robot has not come to rest at its setpoint for {waited:.1f} s")
        self._forces.append(self.reading.force_n)
        error = np.abs(self.reading.positions - self._setpoint()[0]).max()
        rests = np.abs(self.reading.velocities).max() <= REST_RAD_S and error <= self.arm.start_rad
        return bool(rests and waited >= SETTLE_S)

    def _tare(self) -> None:
        """Tare the force, or check it once it has been tared."""
        self._waits_since = None
        if not self._is_zeroed:
            with self.arm.guard():
                self.arm._tare(np.mean(self._forces, axis=0))
            self._is_zeroed = True
            return
        force = float(np.linalg.norm(np.mean(self._forces, axis=0)))
        if not force <= TARED_N:
            raise Stop("tolerance", f"the force is {force:.1f} N right after taring, more than {TARED_N:g} N")
        self.arm.is_tared, self._tare_s = True, None

    def _command(self) -> None:
        """Send the present setpoint, and switch the force along the normal on and off with the strokes."""
        presses = self.path.presses(self.time_s)
        if presses and not self._presses:
            self.arm._start_pressing(self.path, self.reading.positions)
        elif self._presses and not presses:
            self.arm._stop_pressing(self.path)
            # The force has moved the robot off the trajectory: it goes back smoothly.
            self._offset = self._measure(self.arm._clock()).positions - self.path.setpoint(self.time_s)[0]
            self._offset_s = self.time_s
        self._presses = presses
        self.arm._command(self.path, self.time_s, *self._setpoint())

    def _setpoint(self):
        """Return the present setpoint: joint positions [rad] and velocities [rad/s], with the offset that has not faded."""
        positions, velocities = self.path.setpoint(self.time_s)
        left = max(0.0, 1.0 - (self.time_s - self._offset_s) / FADE_S)
        return positions + left * left * (3 - 2 * left) * self._offset, velocities
