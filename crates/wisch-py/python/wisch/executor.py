"""Executors: any object with ``execute(motion, sink)``; with a camera, ``observe()``; and optionally ``state()``, ``prepare(robot)``
and ``finish()``.

``Executor`` is a base class that documents the methods; inheritance is not required. ``serve`` turns an executor into a program for
``wisch run TASK --executor "python3 my_robot.py"``::

    import wisch.executor

    class MyRobot(wisch.executor.Executor):
        def execute(self, motion, sink):
            for k, time in enumerate(motion.time_s):
                pose, force = ...
                if not sink(time_s=time, world_from_tool=pose, force_n=force, positions=motion.positions[k]):
                    return  # the motion must stop

    if __name__ == "__main__":
        wisch.executor.serve(MyRobot())
"""

from __future__ import annotations

import json
import queue
import sys
import threading
import traceback
from typing import Any

import numpy as np

__all__ = ["Executor", "serve"]

#: Name and version of the protocol in docs/executor-protocol.md.
PROTOCOL, VERSION = "wisch-executor", 2


class Executor:
    """Executor of motions: a robot, a simulator, or a stand-in."""

    def prepare(self, robot) -> None:
        """Prepare the robot for motions, before the first of a run: switch controllers, tare. It must not move the robot.

        ``robot`` has ``name``, ``joints`` and ``arm_joints`` (their names, in the order of all arrays, and those that move), ``tip`` (the
        link that holds the tool), ``tip_from_tool`` (7), ``tool``, ``urdf`` and ``srdf`` (texts), and ``urdf_file``. What is not known is
        None, and so is ``robot`` itself if wisch does not describe it. If this raises an exception, nothing moves."""

    def finish(self) -> None:
        """Undo what ``prepare`` did, after the last motion of a run; also after a stop or an error. It is called once.

        If this raises an exception, the run warns of it, and keeps its results."""

    def execute(self, motion, sink) -> dict[str, Any] | None:
        """Execute a motion, and pass its telemetry to the sink, sample by sample in the order of time.

        ``motion`` has ``time_s`` (T), ``positions``, ``velocities`` and ``accelerations`` (T, n), ``world_from_tool`` (T, 7), ``stroke`` (T; -1
        where the tool does not touch), ``phases``, ``joints``, ``press_force_n``, ``stiffness_n_per_m``, ``damping_ratio``,
        ``world_from_surface`` (7), ``duration_s``, ``round`` and ``seed``. The tool's path lies on the believed surface:
        the executor must press. Motions over a curved surface are given only to executors with ``accepts_curved = True``;
        it presses along the z axis of ``world_from_tool``, or along the normal of ``surface_shape`` with a tool that can tilt.

        ``sink(sample)`` takes a dict with ``time_s`` [s], ``world_from_tool`` (7), ``force_n`` (3; of the surroundings on the
        tool [N], in the axes of the world, or of ``wrench_axes``: "world", "tool" or "tip", the link that holds the tool) and,
        if measured, ``positions``, ``velocities``, ``efforts`` (n; arrays, or dicts
        by joint), ``moment_nm`` (3, about the tool centre point), ``world_from_commanded`` (7), ``controller_force_n`` (3), ``controller_moment_nm`` (3); or
        these as arguments. Without ``world_from_tool`` the pose is computed from ``positions``. A robot that may run slower than planned adds ``trajectory_time_s``, the time of its controller's
        present setpoint. ``wrench_quality`` ("ok", "stale", "saturated" or "untared") marks a wrench that is no touch, and ``stamp_ns`` is
        the absolute time of the measurement on the clock that the attribute ``stamp_clock`` names, "epoch" or "device". ``sink.many`` takes the same with a row per sample. Both return False if the motion must
        stop.

        If the robot pauses, call ``sink.pause(time_s, reason)`` and, when it continues, ``sink.resume(time_s)``: the time between is no
        silence. An executor with ``can_pause = True`` pauses while ``sink.wants_pause`` is true.

        ``motion.phases`` state the force where the tool touches: ``force_n`` at start and end, the time ``force_ramp_s`` over which it
        changes, and the largest speed along the normal in that time, ``approach_speed_m_s``.

        Returns None when the motion is complete or was stopped; or a dict with any of ``ending`` ("complete", "stopped", or
        ``{"stop": {"kind": ..., "time_s": ..., "reason": ...}}`` with a kind of "push", "overload", "joint_limit", "tolerance",
        "protective_stop", "emergency_stop", "operator" or "link_lost"), ``duration_s`` and ``positions`` (n, at the end).
        """
        raise NotImplementedError

    def state(self):
        """Return the joint positions (n), or a dict of ``positions`` and ``velocities``, before each motion; None if unknown.

        A motion begins only where the robot is, and at rest."""
        return None

    def observe(self):
        """Return the camera's detections of dirt: positions (k, 2) in the chart of the believed surface [m], of a
        plane in its frame, or a dict of
        ``detections`` and ``hidden``, polygons that the camera cannot see; None without a camera."""
        return None


class _Robot:
    """The description of a robot in ``hello``."""

    def __init__(self, described: dict[str, Any]) -> None:
        self.urdf = self.srdf = self.urdf_file = None
        self.__dict__.update(described)
        self.tip_from_tool = np.array(described["tip_from_tool"])


class _Motion:
    """A motion received over the wire, with the attributes of ``wisch.Motion``."""

    def __init__(self, head: dict[str, Any], points: list[dict[str, Any]]) -> None:
        self.__dict__.update(head)
        self.world_from_surface = np.array(head["world_from_surface"])
        self.gap_m = head.get("gap_m")
        self.surface_shape = head.get("surface_shape")
        self.time_s = np.array([point["time_s"] for point in points])
        self.positions = np.array([point["positions"] for point in points])
        self.velocities = np.array([point["velocities"] for point in points])
        self.accelerations = np.array([point["accelerations"] for point in points])
        self.world_from_tool = np.array([point["world_from_tool"] for point in points])
        starts = [phase["start_s"] for phase in self.phases]
        at = np.clip(np.searchsorted(starts, self.time_s, side="right") - 1, 0, None)
        self.stroke = np.array([self.phases[i].get("stroke", -1) for i in at])


class _Wire:
    """Connection to wisch. A thread of its own receives messages, so that a "stop" takes effect at once."""

    def __init__(self, source, target) -> None:
        self._target = target
        self._messages: queue.SimpleQueue = queue.SimpleQueue()
        self.is_stopped = threading.Event()
        self.wants_pause = threading.Event()
        threading.Thread(target=self._listen, args=(source,), daemon=True).start()

    def _listen(self, source) -> None:
        for line in source:
            message = json.loads(line)
            if message == "stop":
                self.is_stopped.set()
            elif message == "pause":
                self.wants_pause.set()
            elif message == "resume":
                self.wants_pause.clear()
            else:
                if "execute" in message:
                    # What follows is meant for this motion.
                    self.is_stopped.clear()
                    self.wants_pause.clear()
                self._messages.put(message)
        self.is_stopped.set()
        self._messages.put(None)

    def receive(self):
        return self._messages.get()

    def send(self, **message) -> None:
        self.say(message)

    def say(self, message) -> None:
        self._target.write(json.dumps(message, default=_to_list, allow_nan=False) + "\n")
        self._target.flush()


def _to_list(value):
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a message cannot hold a {type(value).__name__}")


class _Sink:
    """Sends samples over the wire."""

    def __init__(self, wire: _Wire, joints: list[str]) -> None:
        self._wire = wire
        self._joints = list(joints)
        self.last: dict[str, Any] = {}

    def __call__(self, sample=None, /, **keys) -> bool:
        sample = dict(keys if sample is None else sample)
        for key in ("positions", "velocities", "efforts"):
            if isinstance(sample.get(key), dict):
                sample[key] = self._sort_by_joint(key, sample[key])
        sample.setdefault("positions", [])
        sample = {key: _check_finite(key, value) for key, value in sample.items()}
        self._wire.send(sample=sample)
        self.last = sample
        return not self._wire.is_stopped.is_set()

    @property
    def wants_pause(self) -> bool:
        """Whether the operator wants the motion to pause."""
        return self._wire.wants_pause.is_set()

    def pause(self, time_s: float, reason: str = "") -> None:
        """Tell that the motion is paused since a time [s]."""
        self._wire.send(paused={"time_s": float(time_s), "reason": reason})

    def resume(self, time_s: float) -> None:
        """Tell that the motion continues since a time [s]."""
        self._wire.send(resumed={"time_s": float(time_s)})

    def _sort_by_joint(self, key: str, by_name: dict[str, float]) -> list[float]:
        for joint in self._joints:
            if joint not in by_name:
                raise ValueError(f"{key}: joint {joint!r} is missing; given: {', '.join(by_name)}")
        if unknown := by_name.keys() - set(self._joints):
            raise ValueError(f"{key}: unknown joint {min(unknown)!r}; known: {', '.join(self._joints)}")
        return [by_name[joint] for joint in self._joints]

    def many(self, samples=None, /, **keys) -> bool:
        columns = {key: np.asarray(value) for key, value in (keys if samples is None else samples).items()}
        for k in range(len(columns["time_s"])):
            if not self({key: column[k] for key, column in columns.items()}):
                return False
        return True


def _check_finite(key: str, value):
    if isinstance(value, str) or key == "stamp_ns":
        return value if isinstance(value, str) else int(value)
    array = np.asarray(value, dtype=float)
    if not np.isfinite(array).all():
        raise ValueError(f"{key} of a sample holds {array}")
    return array.tolist()


def _execute(executor, wire: _Wire, head: dict[str, Any]) -> None:
    points = [wire.receive()["point"] for _ in range(head.pop("points"))]
    motion = _Motion(head, points)
    sink = _Sink(wire, head["joints"])
    done = executor.execute(motion, sink) or {}
    ending = "stopped" if wire.is_stopped.is_set() else "complete"
    time = sink.last.get("time_s", 0.0)
    positions = sink.last.get("positions", [])
    wire.send(done={"duration_s": time, "ending": ending, "positions": positions, **done})


def _defines(executor, name: str) -> bool:
    """Return whether an executor has a method of its own, other than the one of the base class that does nothing."""
    method = getattr(executor, name, None)
    return method is not None and getattr(method, "__func__", None) is not getattr(Executor, name)


def _ready(executor) -> dict[str, Any]:
    ready = {"version": VERSION, "reports_state": hasattr(executor, "state")}
    for key, attribute in [("accepts_curved", "accepts_curved"), ("pauses", "can_pause"), ("real_time", "is_real_time")]:
        if getattr(executor, attribute, False):
            ready[key] = True
    if stamp_clock := getattr(executor, "stamp_clock", None):
        ready["stamp_clock"] = stamp_clock
    if _defines(executor, "prepare") or _defines(executor, "finish"):
        ready["prepares"] = True
    max_silence_s = getattr(executor, "max_silence_s", None)
    return ready if max_silence_s is None else {**ready, "max_silence_s": max_silence_s}


def _observe(executor):
    observe = getattr(executor, "observe", None)
    observation = observe() if observe else None
    if observation is None or isinstance(observation, dict):
        return observation
    return {"detections": observation}


def serve(executor) -> None:
    """Serve ``wisch run --executor`` over the standard streams until they close.

    If the executor has ``max_silence_s`` [s], wisch stops a motion in which it passes on no sample for longer. With ``is_real_time = True``,
    wisch drops samples and counts them where it cannot keep up; otherwise the sink waits.
    Output of the executor goes to standard error. Its exceptions are reported to wisch, and end this program with exit code 1.
    """
    wire = _Wire(sys.stdin, sys.stdout)
    sys.stdout = sys.stderr
    server = _Server(executor, wire)
    while (message := wire.receive()) is not None:
        try:
            server.answer(message)
        except Exception as error:
            traceback.print_exc()
            wire.send(error=f"{type(error).__name__}: {error}")
            server.finish_after_error()
            sys.exit(1)
    server.finish()


class _Server:
    """Answers the messages of wisch."""

    def __init__(self, executor, wire: _Wire) -> None:
        self._executor = executor
        self._wire = wire
        self._robot: _Robot | None = None
        self._is_prepared = False

    def answer(self, message) -> None:
        executor, wire = self._executor, self._wire
        if message == "state":
            state = executor.state()
            if not isinstance(state, dict):
                state = {"positions": [] if state is None else state}
            wire.send(state=state)
        elif message == "prepare":
            if prepare := getattr(executor, "prepare", None):
                prepare(self._robot)
            self._is_prepared = True
            wire.say("prepared")
        elif message == "finish":
            self.finish()
            wire.say("finished")
        elif "hello" in message:
            described = message["hello"].get("robot")
            self._robot = described and _Robot(described)
            wire.send(ready=_ready(executor))
        elif "execute" in message:
            _execute(executor, wire, message["execute"])
        elif "observe" in message:
            wire.send(observation=_observe(executor))

    def finish(self) -> None:
        """Let a prepared executor finish, once; also if wisch has ended without asking for it."""
        is_prepared, self._is_prepared = self._is_prepared, False
        if is_prepared and (finish := getattr(self._executor, "finish", None)):
            finish()

    def finish_after_error(self) -> None:
        """Finish when wisch asks for it or closes its end, and ignore what else it sends."""
        if not self._is_prepared:
            return
        while self._wire.receive() not in (None, "finish"):
            pass
        try:
            self.finish()
        except Exception as error:
            traceback.print_exc()
            self._wire.send(error=f"{type(error).__name__}: {error}")
        else:
            self._wire.say("finished")
