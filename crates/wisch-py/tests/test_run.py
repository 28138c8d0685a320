"""The loop with executors written in Python."""

import numpy as np
import pytest
from conftest import AllAtOnce, Exact

import wisch


def summarize(rounds):
    return [(r.number, r.performance, r.interval, r.verdict, r.ending) for r in rounds]


def test_single_samples_and_arrays_have_the_same_results(task, robot):
    by_one, at_once = (
        task.session(robot, rounds=2).run(kind(task.surface_reaction)) for kind in (Exact, AllAtOnce)
    )
    assert summarize(by_one) == summarize(at_once)
    assert len(by_one) == 2
    assert by_one[-1].performance > 0.8
    np.testing.assert_allclose(by_one[0].telemetry.world_from_tool, by_one[0].motion.world_from_tool, atol=1e-12)


def test_telemetry_is_not_copied(task, robot, exact):
    session = task.session(robot, rounds=1)
    [first] = session.run(exact)
    telemetry = first.telemetry
    assert telemetry is session.telemetry[0]
    assert telemetry.force_n is telemetry.force_n
    assert not telemetry.force_n.flags.owndata, "the array is a view of data in Rust"
    assert len(telemetry) == len(first.motion.time_s)
    assert telemetry.positions.shape == first.motion.positions.shape
    assert telemetry.velocities.shape == (len(telemetry), 0)
    assert telemetry.force_n[telemetry.stroke >= 0, 2].min() == pytest.approx(task.press_force_n)


def test_events_come_in_order_and_can_stop_the_session(task, robot, exact):
    events = []
    task.session(robot, rounds=1).run(exact, on_event=events.append)
    kinds = [event["event"] for event in events]
    order = [kind for kind, before in zip(kinds, [None, *kinds]) if kind != before]
    assert order == ["planning", "planned", "following", "audited", "executing", "sample", "interpreting", "decided", "ended"]
    assert events[-1]["verdict"] is not None

    session = task.session(robot)
    rounds = session.run(exact, on_event=lambda event: event["event"] != "executing")
    assert (rounds, session.stage, session.verdict) == ([], "ended", None)

    samples = []

    def a_few(event):
        if event["event"] == "sample":
            samples.append(event)
        return len(samples) < 3

    [stopped] = task.session(robot).run(Exact(task.surface_reaction), on_event=a_few)
    assert stopped.ending == "stopped"
    assert len(stopped.telemetry) == 101, "an event for every fiftieth sample"


def test_an_exception_of_a_callback_is_raised(task, robot, exact):
    def fails(event):
        if event["event"] == "following":
            raise KeyError("my own")

    with pytest.raises(KeyError, match="my own"):
        task.session(robot).run(exact, on_event=fails)

    session = task.session(robot)
    with pytest.raises(RuntimeError, match="the session is running"):
        session.run(exact, on_event=lambda event: session.rounds)


def test_observe_is_called_before_the_first_plan_and_after_a_motion(robot):
    task = wisch.load_task("arm-board")

    class Looks(AllAtOnce):
        looks = 0

        def observe(self):
            self.looks += 1
            return {"detections": task.particles[:40], "hidden": []} if self.looks == 1 else np.empty((0, 2))

    executor = Looks(task.surface_reaction)
    session = task.session(robot, rounds=1)
    [only] = session.run(executor)
    assert executor.looks == 2
    np.testing.assert_array_equal(session.first_observation, task.particles[:40])
    assert only.performance != only.interpretation.performance_by_touch

    class Wrong(AllAtOnce):
        def observe(self):
            return [[0.0, np.inf]]

    with pytest.raises(wisch.WischError, match=r"position \(0, inf\) m is not finite"):
        task.session(robot).run(Wrong(task.surface_reaction))


def test_the_returned_ending_is_that_of_the_round(task, robot):
    class Caught(Exact):
        def execute(self, motion, sink):
            for k in range(200):
                sink(self.sample(motion, k))
            return {"ending": {"protective_stop": {"time_s": 2.0, "reason": "a hand"}}, "duration_s": 2.0}

    first = task.session(robot, rounds=1).run(Caught(task.surface_reaction))[0]
    assert (first.ending, first.duration_s) == ("protective stop", 2.0)


def test_stages_run_one_by_one(task, robot, exact):
    session = task.session(robot)
    assert session.stage is None
    plan = session.plan()
    assert session.plan().to_json() == plan.to_json()
    assert session.stage == "planned"
    session.follow()
    assert session.stage == "followed"
    assert session.audit()
    assert session.stage == "audited"
    [first] = session.run_round(exact)
    assert (first.number, first.plan.to_json(), session.stage) == (1, plan.to_json(), "decided")
    assert "<table>" in session._repr_html_() and first._repr_svg_().startswith("<svg")


def test_arrays_are_interpreted_as_in_the_session(task, robot, exact):
    [first] = task.session(robot, rounds=1).run(exact)
    log = first.telemetry
    interpretation = task.interpret(log)
    assert interpretation.performance == first.performance and interpretation.diagnosis == "localized"
    arrays = task.interpret(time_s=log.time_s, world_from_tool=log.world_from_tool, force_n=log.force_n)
    assert arrays.performance == interpretation.performance
    assert interpretation.next_plan().contact_distance_m < first.plan.contact_distance_m
    with pytest.raises(wisch.WischError, match="force_n: expected 5, one per time, found 4 rows"):
        task.interpret(time_s=log.time_s[:5], world_from_tool=log.world_from_tool[:5], force_n=log.force_n[:4])
    with pytest.raises(wisch.WischError):
        task.interpret(time_s=log.time_s[::-1], world_from_tool=log.world_from_tool, force_n=log.force_n)


def test_a_table_is_read_as_a_log(task, robot, exact, tmp_path):
    [first] = task.session(robot, rounds=1).run(exact)
    log = first.telemetry
    table = np.column_stack([log.time_s, log.world_from_tool, log.force_n])
    file = tmp_path / "log.csv"
    np.savetxt(file, table, delimiter=",", header="t,x,y,z,qx,qy,qz,qw,fx,fy,fz", comments="", fmt="%.17g")
    read = wisch.read_log(file, wrench_frame="world")
    np.testing.assert_allclose(read.force_n, log.force_n, atol=1e-12)
    assert task.interpret(read).performance == pytest.approx(first.performance, abs=0.02)
    assert all("no unit" in remark or "no frame" in remark for remark in read.remarks)
    assert len(read.remarks) == 2 and read.left_out == [0, 0, 0, 0]
    is_kept = (log.time_s < 3.0) | (log.time_s > 3.5)
    np.savetxt(file, table[is_kept], delimiter=",", header="t,x,y,z,qx,qy,qz,qw,fx,fy,fz", comments="", fmt="%.17g")
    remarks = "; ".join(wisch.read_log(file).remarks)
    assert "gaps in the log: 0.5" in remarks and "axes of the force are assumed to be those of the tool" in remarks
    with pytest.raises(wisch.WischError) as caught:
        wisch.read_log(tmp_path / "no.mcap")
    assert caught.value.file == str(tmp_path / "no.mcap")


class OnCurve:
    """A robot that presses along the tool's axis, wherever it points."""

    accepts_curved = True

    def __init__(self, force):
        self.force = force

    def execute(self, motion, sink):
        x, y, z, w = motion.world_from_tool[:, 3:].T
        axis = np.column_stack([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)])
        touches = (motion.stroke >= 0)[:, None]
        sink.many(
            time_s=motion.time_s,
            world_from_tool=motion.world_from_tool,
            force_n=touches * self.force * axis,
            positions=motion.positions,
        )


def test_an_executor_that_accepts_curved_surfaces_wipes_a_mesh():
    task = wisch.load_task("basin", set={"perception.senses": ["touch"]})
    robot = OnCurve(task.press_force_n)
    [first] = task.session(task.robot(), rounds=1).run(robot)
    assert first.motion.surface_shape["kind"] == "mesh"
    assert first.performance > 0.5, first
    robot.accepts_curved = False
    with pytest.raises(wisch.WischError, match="accepts_curved"):
        task.session(task.robot(), rounds=1).run(robot)
