"""Faults of executors: the error is clear, the samples before it are kept, and no process is left."""

import json
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import AllAtOnce, Exact

import wisch

#: Number of samples before the fault, which is during the first stroke.
GOOD = 200


class Spoiled(Exact):
    """Passes good samples, and then a changed one, which the sink must refuse."""

    def __init__(self, reaction, change):
        super().__init__(reaction)
        self.change = change

    def execute(self, motion, sink):
        for k in range(GOOD):
            sink(self.sample(motion, k))
        sink({**self.sample(motion, GOOD), **self.change})
        pytest.fail("the sink took the changed sample")


WRONG = [
    ({"force_n": [0.0, float("nan"), 0.0]}, "at 2 s force_n[1] is NaN"),
    ({"positions": np.full(7, np.inf)}, "at 2 s positions[0] is inf"),
    ({"time_s": 1.5}, "the sample at 1.5 s follows the sample at 1.99 s"),
    ({"time_s": 1.99}, "the sample at 1.99 s follows the sample at 1.99 s"),
    ({"time_s": float("nan")}, "time_s = NaN of the sample after 1.99 s"),
    ({"time_s": "now"}, "time_s: expected a number, found str"),
    ({"positions": np.zeros(6)}, "at 2 s positions has 6 numbers, but the robot has 7 joints"),
    ({"velocities": [0.0] * 8}, "at 2 s velocities has 8 numbers, but the robot has 7 joints"),
    ({"positions": {"joint_1": 0.0, "elbow": 1.0}}, 'positions: unknown joint "elbow"; known: '),
    ({"positions": {"joint_1": 0.0}}, 'positions: joint "joint_2" is missing'),
    ({"world_from_tool": [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0]}, "at 2 s a quaternion has norm 2"),
    ({"world_from_tool": [0.0, 0.0, 1.0]}, "at 2 s world_from_tool has 3 numbers, not 7"),
    ({"force": [0.0, 0.0, 1.0]}, 'unknown key "force"; nearest: force_n'),
]


@pytest.mark.parametrize(("change", "message"), WRONG, ids=[message[:30] for _, message in WRONG])
def test_a_wrong_sample_is_named_and_the_samples_before_it_are_kept(task, robot, change, message):
    session = task.session(robot)
    with pytest.raises(wisch.WischError) as caught:
        session.run(Spoiled(task.surface_reaction, change))
    assert message in str(caught.value)
    [kept] = session.rounds
    assert (kept.ending, len(kept.telemetry)) == ("stopped", GOOD)
    assert kept.interpretation.contact_share > 0
    assert session.stage == "ended"


def test_an_executors_exception_is_raised_with_round_and_time(task, robot):
    class Throws(Exact):
        def execute(self, motion, sink):
            for k in range(GOOD):
                sink(self.sample(motion, k))
            raise ConnectionError("the arm is locked")

    session = task.session(robot)
    with pytest.raises(ConnectionError, match="the arm is locked") as caught:
        session.run(Throws(task.surface_reaction))
    if sys.version_info >= (3, 11):
        assert caught.value.__notes__ == ["in round 1, after the sample of 1.99 s"]
    assert len(session.rounds) == 1

    class ThrowsAtOnce:
        def execute(self, motion, sink):
            return 1 / 0

    session = task.session(robot)
    with pytest.raises(ZeroDivisionError):
        session.run(ThrowsAtOnce())
    assert session.rounds == [] and len(session.telemetry[0]) == 0


def test_a_fault_that_the_executor_catches_is_still_raised(task, robot):
    class Swallows(Exact):
        def execute(self, motion, sink):
            for k in range(len(motion.time_s)):
                sample = self.sample(motion, k)
                try:
                    sink({**sample, "force_n": [np.nan] * 3} if k == GOOD else sample)
                except wisch.WischError:
                    pass

    with pytest.raises(wisch.WischError, match=r"at 2 s force_n\[0\] is NaN"):
        task.session(robot).run(Swallows(task.surface_reaction))


def test_too_few_samples_are_noticed(task, robot):
    class Lazy(Exact):
        def execute(self, motion, sink):
            for k in range(3):
                sink(self.sample(motion, k))

    class Idle:
        def execute(self, motion, sink):
            pass

    with pytest.raises(wisch.WischError, match=r"is reported complete, but the last sample is at 0.02 s"):
        task.session(robot).run(Lazy(task.surface_reaction))
    with pytest.raises(wisch.WischError, match="is reported complete, but there is no sample"):
        task.session(robot).run(Idle())


def test_what_an_executor_returns_is_checked(task, robot):
    class Returns(Exact):
        def __init__(self, reaction, returned):
            super().__init__(reaction)
            self.returned = returned

        def execute(self, motion, sink):
            super().execute(motion, sink)
            return self.returned

    for returned, message in [
        ("done", "expected nothing, or a dict"),
        ({"ending": "exploded"}, 'unknown ending "exploded"'),
        ({"duration": 3.0}, 'unknown key "duration"; nearest: duration_s'),
        ({"duration_s": float("inf")}, "at the end duration_s is inf s"),
        ({"positions": [0.0, 1.0]}, "reported 2 joint positions at the end, expected 7"),
    ]:
        with pytest.raises(wisch.WischError) as caught:
            task.session(robot, rounds=1).run(Returns(task.surface_reaction, returned))
        assert message in str(caught.value)


def measure_failure(run, thread):
    """Return the exception of a run on the main or on another thread, and the duration of the run [s]."""
    results = []

    def timed():
        begin = time.monotonic()
        try:
            run()
        except BaseException as error:
            results.append((error, time.monotonic() - begin))

    if thread == "main":
        timed()
    else:
        other = threading.Thread(target=timed)
        other.start()
        other.join()
    [(error, seconds)] = results
    return error, seconds


@pytest.mark.parametrize("how", ["sleeps", "spins", "swallows"])
@pytest.mark.parametrize("thread", ["main", "other"])
def test_an_executor_that_hangs_is_interrupted(task, robot, how, thread):
    class Hangs(Exact):
        def execute(self, motion, sink):
            for k in range(GOOD):
                sink(self.sample(motion, k))
            end = time.monotonic() + 60
            while time.monotonic() < end:
                try:
                    time.sleep(0.05 if thread == "other" else 60) if how == "sleeps" else sum(range(1000))
                except KeyboardInterrupt:
                    if how != "swallows":
                        raise
                    how_often.append(1)
                    if len(how_often) == 2:
                        return

    how_often = []
    session = task.session(robot)

    error, seconds = measure_failure(lambda: session.run(Hangs(task.surface_reaction), timeout=0.4), thread)
    assert isinstance(error, wisch.WischError) and "no sample for 0.4 s" in str(error), repr(error)
    assert seconds < 30
    assert len(session.rounds[0].telemetry) == GOOD
    time.sleep(0.1)  # time for a late interrupt


def test_an_executor_states_its_own_longest_silence(task, robot):
    class Hangs(Exact):
        max_silence_s = 0.3

        def execute(self, motion, sink):
            for k in range(GOOD):
                sink(self.sample(motion, k))
            time.sleep(60)

    session = task.session(robot)
    error, seconds = measure_failure(lambda: session.run(Hangs(task.surface_reaction), timeout=20), "main")
    assert isinstance(error, wisch.WischError) and "no sample for 0.3 s" in str(error), repr(error)
    assert seconds < 15
    assert len(session.rounds[0].telemetry) == GOOD
    time.sleep(0.1)  # time for a late interrupt

    hangs = Hangs(task.surface_reaction)
    hangs.max_silence_s = 0
    with pytest.raises(wisch.WischError, match="max_silence_s: expected a time of 0.02 to 60 s, found 0"):
        task.session(robot).run(hangs)


@pytest.mark.parametrize("looks", [1, 2], ids=["before the first plan", "after a motion"])
@pytest.mark.parametrize("thread", ["main", "other"])
def test_an_observation_without_end_is_interrupted(robot, looks, thread):
    class Stares(AllAtOnce):
        def observe(self):
            seen.append(1)
            end = time.monotonic() + 60
            while len(seen) == looks and time.monotonic() < end:
                time.sleep(0.05 if thread == "other" else 60)
            return seeing.particles

    seen = []
    seeing = wisch.load_task("arm-board")
    session = seeing.session(robot)

    error, seconds = measure_failure(lambda: session.run(Stares(seeing.surface_reaction), timeout=0.4), thread)
    assert isinstance(error, wisch.WischError) and "returned no observation for 0.4 s" in str(error), repr(error)
    assert len(seen) == looks and seconds < 30
    time.sleep(0.1)  # time for a late interrupt


def test_a_slow_executor_is_not_interrupted(task, robot):
    class Slow(Exact):
        def execute(self, motion, sink):
            for k in range(0, len(motion.time_s), 200):
                time.sleep(0.05)
                sink(self.sample(motion, k))
            sink(self.sample(motion, len(motion.time_s) - 1))

    [first] = task.session(robot, rounds=1).run(Slow(task.surface_reaction), timeout=5.0)
    assert first.ending == "complete"
    with pytest.raises(wisch.WischError, match="timeout: expected a time above 0 s"):
        task.session(robot).run(Slow(task.surface_reaction), timeout=-1)


def test_a_sink_takes_samples_of_its_own_motion_only(task, robot):
    kept = []

    class Keeps(Exact):
        def execute(self, motion, sink):
            kept.append((sink, self.sample(motion, 0)))
            super().execute(motion, sink)

    task.session(robot, rounds=1).run(Keeps(task.surface_reaction))
    sink, sample = kept[0]
    with pytest.raises(wisch.WischError, match="a motion that has ended"):
        sink(sample)


def test_an_object_without_execute_is_refused(task, robot):
    with pytest.raises(wisch.WischError, match=r"executor: expected an object with execute\(motion, sink\), found dict"):
        task.session(robot).run({})


#: A program that serves an executor. ``then`` runs after the good samples.
SERVED = """
import sys, time
import numpy as np
import wisch.executor

class Robot(wisch.executor.Executor):
    def execute(self, motion, sink):
        print("executing", motion.joints, motion.world_from_surface.shape)
        up = np.array([0.0, 0.0, motion.press_force_n])
        for k in range(len(motion.time_s)):
            if k == {good}:
                {then}
            go_on = sink(
                time_s=motion.time_s[k], world_from_tool=motion.world_from_tool[k],
                force_n=up * (motion.stroke[k] >= 0), positions=dict(zip(motion.joints, motion.positions[k])),
            )
            if not go_on:
                return

wisch.executor.serve(Robot())
"""


def run_served(program, tmp_path, then, *more):
    script = tmp_path / "robot.py"
    script.write_text(SERVED.format(good=GOOD, then=then))
    command = [*program, "run", "arm-board", "--rounds", "1", "--out", "out", "--memory", "memory", "--set", "target_performance=0.2"]
    command += ["--set", "perception.senses=[\"touch\"]", "--executor", f"{sys.executable} {script}", *more]
    return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)


def test_a_served_executor_has_the_results_of_a_direct_one(program, tmp_path, task, robot):
    ended = run_served(program, tmp_path, "pass")
    assert ended.returncode in (0, 1), ended.stderr
    assert "executing ['joint_1'" in ended.stderr, "output of the executor goes to standard error"
    assert len(wisch.Memory(tmp_path / "memory").episodes) == 1
    [by_program] = json.loads((tmp_path / "out" / "rounds.json").read_text())
    [here] = task.session(robot, rounds=1, target=0.2).run(Exact(task.surface_reaction))
    assert (by_program["estimated"], by_program["verdict"]) == (here.performance, here.verdict), "exactly equal"
    assert ended.returncode == (0 if here.verdict == "goal met" else 1)


@pytest.mark.parametrize(
    ("then", "message"),
    [
        ("raise RuntimeError('the arm is locked')", "RuntimeError: the arm is locked"),
        ("time.sleep(3600)", "no message for 1.5 s"),
        ("motion.time_s[k] = 0.5", "the sample at 0.5 s follows the sample at 1.99 s"),
        ("up[0] = float('nan')", "force_n of a sample holds [nan"),
        ("motion.joints[0] = 'elbow'", "positions: joint 'joint_1' is missing"),
        ("return", "is reported complete, but the last sample is at 1.99 s"),
        ("sys.exit(3)", "it ended while wisch waited for a message"),
    ],
)
def test_a_fault_of_a_served_executor_ends_the_run_and_keeps_the_episode(program, tmp_path, then, message):
    ended = run_served(program, tmp_path, then, "--timeout", "1.5")
    assert ended.returncode == 2
    assert message in ended.stderr, ended.stderr
    assert "the episode was kept in" in ended.stderr
    memory = wisch.Memory(tmp_path / "memory")
    [episode] = memory.episodes
    assert len(memory.telemetry(episode, 1)["time_s"]) == GOOD
    script = str(tmp_path / "robot.py")
    listed = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout
    assert script not in listed, "no process is left"


class Prepared(Exact):
    """Notes its calls, and fails in the call of this name."""

    def __init__(self, reaction, fails_in=None):
        super().__init__(reaction)
        self.calls, self.fails_in, self.robot = [], fails_in, None

    def note(self, name):
        self.calls.append(name)
        if name == self.fails_in:
            raise RuntimeError(f"{name} does not work")

    def prepare(self, robot):
        self.robot = robot
        self.note("prepare")

    def execute(self, motion, sink):
        self.note("execute")
        return super().execute(motion, sink)

    def finish(self):
        self.note("finish")


def test_an_executor_is_prepared_before_its_first_motion_and_finishes_after_its_last(task, robot):
    executor = Prepared(task.surface_reaction)
    task.session(robot, rounds=1).run(executor)
    assert executor.calls == ["prepare", "execute", "finish"]
    assert executor.robot.name == "arm7" and executor.robot.joints[0] == "joint_1"
    assert "<robot" in executor.robot.urdf and executor.robot.tip_from_tool.shape == (7,)


def test_what_fails_before_the_first_motion_and_after_the_last_is_told(task, robot):
    executor = Prepared(task.surface_reaction, "prepare")
    session = task.session(robot, rounds=1)
    with pytest.raises(RuntimeError, match="prepare does not work"):
        session.run(executor)
    assert (executor.calls, session.rounds) == (["prepare"], [])

    executor = Prepared(task.surface_reaction, "execute")
    with pytest.raises(RuntimeError, match="execute does not work"):
        task.session(robot, rounds=1).run(executor)
    assert executor.calls == ["prepare", "execute", "finish"]

    executor = Prepared(task.surface_reaction, "finish")
    session = task.session(robot, rounds=1)
    with pytest.warns(RuntimeWarning, match=r"the robot is not handed back, because finish\(\) failed: .*finish does not work"):
        session.run(executor)
    assert len(session.rounds) == 1


def test_an_executor_finishes_when_its_session_closes_or_another_one_follows(task, robot):
    first, second = Prepared(task.surface_reaction), Prepared(task.surface_reaction)
    with task.session(robot, rounds=2) as session:
        session.run_round(first)
        assert first.calls == ["prepare", "execute"]
        if session.verdict is None:
            session.run_round(second)
            assert first.calls == ["prepare", "execute", "finish"]
            assert second.calls[:2] == ["prepare", "execute"]
    last = second if second.calls else first
    assert last.calls.count("finish") == 1 and last.calls[-1] == "finish"


def test_an_interrupted_executor_finishes_once(task, robot):
    class Interrupted(Prepared):
        def execute(self, motion, sink):
            self.note("execute")
            sink(self.sample(motion, 0))
            sink.pause(motion.time_s[0], "a door is open")
            raise KeyboardInterrupt

    executor = Interrupted(task.surface_reaction)
    session = task.session(robot, rounds=2)
    with pytest.raises(KeyboardInterrupt):
        session.run(executor)
    assert executor.calls == ["prepare", "execute", "finish"]
    # The next call interprets what was measured. A stopped robot does not move again.
    session.run(executor)
    assert executor.calls == ["prepare", "execute", "finish"]
    [pause] = session.rounds[0].pauses
    assert (pause["end_s"], pause["reason"]) == (None, "a door is open")


def test_a_paused_executor_is_not_silent_and_unusable_wrenches_are_no_touch(task, robot):
    class Paused(Exact):
        stamp_clock = "device"

        def execute(self, motion, sink):
            for k in range(len(motion.time_s)):
                late = 60.0 * (k > GOOD)
                sample = {**self.sample(motion, k), "time_s": motion.time_s[k] + late, "stamp_ns": k}
                sink({**sample, "wrench_quality": "ok" if k % 10 else "saturated"})
                if k == GOOD:
                    sink.pause(motion.time_s[k], "a door is open")
                    time.sleep(1.5)
                    sink.resume(motion.time_s[k] + 60.0)

    session = task.session(robot, rounds=1)
    [round] = session.run(Paused(task.surface_reaction), timeout=1.0)
    assert (round.ending, round.ending_cause) == ("complete", None)
    [pause] = round.pauses
    assert pause["end_s"] - pause["start_s"] == pytest.approx(60.0)
    unusable = np.count_nonzero(round.telemetry.wrench_quality == 2)
    assert unusable == -(-len(round.telemetry) // 10)
    [doubt] = [doubt for doubt in round.interpretation.doubts if "not used as touch" in doubt]
    assert f"{unusable} saturated" in doubt
    again = task.interpret(round.telemetry)
    assert again.performance == pytest.approx(round.performance, abs=1e-3)
