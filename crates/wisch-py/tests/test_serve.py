"""``wisch.executor.serve`` over streams, without the program.

They need not the compiled part of wisch. From the source alone::

    python3 -m pytest --noconftest crates/wisch-py/tests/test_serve.py
"""

import io
import json
import sys
import time
import types
from pathlib import Path

import pytest

try:
    import wisch
except ImportError:  # the source, without the compiled part
    wisch = types.ModuleType("wisch")
    wisch.__path__ = [str(Path(__file__).parents[1] / "python" / "wisch")]
    sys.modules["wisch"] = wisch

from wisch import executor

ROBOT = {
    "name": "arm7",
    "joints": ["joint_1", "joint_2"],
    "arm_joints": ["joint_2"],
    "tip": "flange",
    "tool": "sponge",
    "tip_from_tool": [0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0],
    "urdf": "<robot/>",
}
HELLO = json.dumps({"hello": {"protocol": "wisch-executor", "version": 1, "versions": [1, 2], "robot": ROBOT}})


class Noting(executor.Executor):
    """Notes its calls, and fails in the call of this name."""

    def __init__(self, fails_in=None):
        self.calls, self.fails_in, self.robot = [], fails_in, None

    def note(self, name):
        self.calls.append(name)
        if name == self.fails_in:
            raise RuntimeError(f"{name} does not work")

    def prepare(self, robot):
        self.robot = robot
        self.note("prepare")

    def state(self):
        self.note("state")

    def finish(self):
        self.note("finish")


@pytest.fixture
def serve(monkeypatch):
    """Let an executor answer messages; returns its answers and its exit code."""

    def serve(served, *messages):
        answers = io.StringIO()
        monkeypatch.setattr(sys, "stdin", io.StringIO("\n".join(messages) + "\n"))
        monkeypatch.setattr(sys, "stdout", answers)
        code = 0
        try:
            executor.serve(served)
        except SystemExit as ended:
            code = ended.code
        return [json.loads(line) for line in answers.getvalue().splitlines()], code

    return serve


def test_an_executor_gets_the_robot_prepares_and_finishes(serve):
    noting = Noting()
    answers, code = serve(noting, HELLO, '"prepare"', '"state"', '"finish"')
    ready, prepared, _, finished = answers
    assert ready["ready"]["prepares"] is True
    assert (prepared, finished, code) == ("prepared", "finished", 0)
    assert noting.calls == ["prepare", "state", "finish"], "finish is called once"
    assert (noting.robot.tip, noting.robot.joints, noting.robot.srdf) == ("flange", ["joint_1", "joint_2"], None)
    assert noting.robot.tip_from_tool[2] == 0.1


def test_an_executor_without_these_methods_does_not_state_them(serve):
    class Plain(executor.Executor):
        pass

    (ready,), _ = serve(Plain(), HELLO)
    assert "prepares" not in ready["ready"]


def test_a_failed_prepare_is_an_error_and_is_not_finished(serve):
    noting = Noting("prepare")
    answers, code = serve(noting, HELLO, '"prepare"', '"finish"')
    assert answers[1:] == [{"error": "RuntimeError: prepare does not work"}]
    assert (noting.calls, code) == (["prepare"], 1)


@pytest.mark.parametrize("end", [['"stop"', '"finish"'], []])
def test_an_executor_finishes_once_after_an_error_asked_or_not(serve, end):
    noting = Noting("state")
    answers, code = serve(noting, HELLO, '"prepare"', '"state"', *end)
    assert answers[2:] == [{"error": "RuntimeError: state does not work"}, "finished"]
    assert (noting.calls, code) == (["prepare", "state", "finish"], 1)


def test_an_executor_finishes_if_wisch_has_gone(serve):
    noting = Noting()
    serve(noting, HELLO, '"prepare"')
    assert noting.calls == ["prepare", "finish"]


def test_a_failed_finish_is_named(serve):
    noting = Noting("finish")
    answers, code = serve(noting, HELLO, '"prepare"', '"finish"')
    assert answers[-1] == {"error": "RuntimeError: finish does not work"}
    assert (noting.calls, code) == (["prepare", "finish"], 1)


MOTION = {
    "execute": {
        "joints": ROBOT["joints"],
        "world_from_surface": [0, 0, 0, 0, 0, 0, 1],
        "phases": [{"phase": "wipe", "stroke": 0, "start_s": 0, "end_s": 1, "force_n": [10, 10], "force_ramp_s": 0}],
        "points": 1,
    }
}
POINT = {"point": {"time_s": 0, "positions": [0, 0], "velocities": [0, 0], "accelerations": [0, 0], "world_from_tool": [0, 0, 0, 0, 0, 0, 1]}}


def test_an_executor_pauses_and_states_stamps_and_qualities(serve):
    class Live(executor.Executor):
        can_pause, is_real_time, stamp_clock = True, True, "epoch"

        def execute(self, motion, sink):
            assert motion.phases[0]["force_n"] == [10, 10]
            while not sink.wants_pause:
                time.sleep(0.001)
            sink(time_s=0.0, force_n=[0, 0, 0], positions=[0, 0], stamp_ns=1764150000123456789, wrench_quality="stale")
            sink.pause(0.5, "the pendant")
            sink.resume(2)

    answers, _ = serve(Live(), HELLO, json.dumps(MOTION), json.dumps(POINT), '"pause"')
    ready, sample, paused, resumed, done = answers
    assert ready["ready"].items() >= {"pauses": True, "real_time": True, "stamp_clock": "epoch"}.items()
    assert sample["sample"]["stamp_ns"] == 1764150000123456789, "no digit is lost"
    assert sample["sample"]["wrench_quality"] == "stale"
    assert paused == {"paused": {"time_s": 0.5, "reason": "the pendant"}}
    assert resumed == {"resumed": {"time_s": 2.0}}
    assert done["done"]["duration_s"] == 0.0
