"""Plans, predictions, motions and audits; plans and motions equal those of the program, byte for byte."""

import subprocess

import numpy as np
import pytest

import wisch


@pytest.mark.parametrize(("scenario", "strategy", "seed"), [("arm-board", "kde", 3), ("arm-board", "adaptive", 4), ("table", "grid", 1)])
def test_a_plan_equals_that_of_the_program_byte_for_byte(program, tmp_path, scenario, strategy, seed):
    settings = {"plan.evaluations": 3000}
    out = tmp_path / "out"
    command = ["plan", scenario, "--strategy", strategy, "--seed", str(seed), "--set", "plan.evaluations=3000"]
    subprocess.run([*program, *command, "--out", str(out), "--quiet"], check=True)
    task = wisch.load_task(scenario, set=settings, strategy=strategy, seed=seed)
    text = task.session().plan().to_json()
    assert text == (out / "plan.json").read_text()
    assert task.plan_of_json(text).to_json() == text
    other = wisch.load_task(scenario, set=settings, strategy=strategy, seed=seed + 1)
    assert other.session().plan().to_json() != text


def test_the_length_of_the_strokes_is_that_of_the_plan(task):
    plan = task.session().plan()
    assert all(stroke.shape[1] == 3 for stroke in plan.strokes)
    way = sum(np.linalg.norm(np.diff(stroke[:, :2], axis=0), axis=1).sum() for stroke in plan.strokes)
    assert way == pytest.approx(plan.contact_distance_m)
    assert plan.total_distance_m > plan.contact_distance_m
    assert plan.tcp_path.shape[1] == 4


def test_a_prediction_counts_its_own_particles(task):
    plan = task.session().plan()
    prediction = plan.predict()
    away = np.linalg.norm(prediction.particles - plan.collect_goal, axis=1)
    there = (away <= task.collision_radius_m) & (prediction.fates == 0)
    assert there.sum() == prediction.achieved
    assert (prediction.fates == 2).sum() == prediction.lost
    assert prediction.performance == prediction.achieved / 60
    single = plan.predict(plan.collect_goal[None, :])
    assert (single.initial, single.achieved) == (1, 1)


def test_a_motion_is_within_limits_and_on_the_surface(task, robot, motion):
    limits = [robot.limits[joint] for joint in motion.joints]
    assert (motion.positions >= [limit["lower"] for limit in limits]).all()
    assert (motion.positions <= [limit["upper"] for limit in limits]).all()
    assert (np.abs(motion.velocities) <= [limit["velocity"] for limit in limits]).all()
    wiping = motion.stroke >= 0
    np.testing.assert_allclose(motion.world_from_tool[wiping, 2], task.world_from_surface[2], atol=1e-3)
    fine = motion.setpoints(0.001)
    assert len(fine["time_s"]) == pytest.approx(10 * len(motion.time_s), abs=20)
    assert motion.phases[-1]["end_s"] == pytest.approx(motion.duration_s)
    assert task.session(robot).audit().faults == []


def test_a_missing_or_unknown_robot_is_refused(task):
    with pytest.raises(wisch.WischError, match="has no robot"):
        task.session().follow()
    with pytest.raises(wisch.WischError) as caught:
        task.session("arm8")
    assert caught.value.value == "arm8" and "arm7" in caught.value.limit
    with pytest.raises(wisch.WischError, match="robot: expected a wisch.Robot"):
        task.session(3)


def test_kinematics_and_dynamics_agree(robot):
    random = np.random.default_rng(1)
    q, qd, qdd = random.normal(size=(3, robot.dof))
    mass, bias = robot.mass_matrix(q), robot.bias(q, qd)
    np.testing.assert_allclose(robot.inverse_dynamics(q, qd, qdd), mass @ qdd + bias, atol=1e-9)
    np.testing.assert_allclose(mass, mass.T, atol=1e-12)
    step = 1e-6
    moved = (robot.pose(q + step * qd, "tcp") - robot.pose(q - step * qd, "tcp"))[:3] / (2 * step)
    np.testing.assert_allclose(robot.jacobian(q, "tcp")[:3] @ qd, moved, atol=1e-6)
    with pytest.raises(wisch.WischError, match="q: expected 7, one per joint, found 6 numbers"):
        robot.gravity(q[:6])
    with pytest.raises(wisch.WischError, match=r"q\[2\]: expected a finite number, found NaN"):
        robot.gravity([0, 0, np.nan, 0, 0, 0, 0])


def test_pictures_are_svg(task):
    plan = task.session().plan()
    for svg in [plan._repr_svg_(), plan.predict()._repr_svg_(), plan.picture("density")]:
        assert svg.startswith("<svg")
    with pytest.raises(wisch.WischError, match="nearest: graph"):
        plan.picture("grph")


def lawnmower(task):
    """Return strokes along x over the whole surface."""
    outline = np.asarray(task.surface_outline)
    (left, low), (right, high) = outline.min(0), outline.max(0)
    rows = int(np.ceil((high - low) / task.area_of_effect_m[1]))
    middles = low + (np.arange(rows) + 0.5) * (high - low) / rows
    return [np.array([[left, y, 0.0], [right, y, 0.0]]) for y in middles]


def test_a_session_takes_given_strokes():
    task = wisch.load_task("chopping-board", action="absorb", seed=1)
    strokes = lawnmower(task)
    plan = task.plan_of_strokes(strokes)
    assert plan.strategy == "own"
    assert all(np.array_equal(given, kept) for given, kept in zip(strokes, plan.strokes, strict=True))
    assert plan.predict().performance == 1.0
    assert task.plan_of_json(plan.to_json()).to_json() == plan.to_json()
    seen = []

    def strategy(of_round):
        seen.append(of_round.particles)
        return lawnmower(of_round)

    for given in (plan, strokes, strategy):
        assert task.session(plan=given).plan().to_json() == plan.to_json()
    assert len(seen) == 1 and seen[0].shape == task.particles.shape


def test_strokes_through_an_object_or_off_the_surface_are_refused():
    task = wisch.load_task("table", action="absorb", strategy="grid", seed=1)
    with pytest.raises(wisch.WischError, match=r"strokes\[\d+\] leads the tool through"):
        task.plan_of_strokes(lawnmower(task))
    with pytest.raises(wisch.WischError, match=r"strokes\[0\] leaves the surface by"):
        task.plan_of_strokes([np.array([[5.0, 0.0, 0.0]])])

    def fails(of_round):
        raise ValueError("no idea")

    with pytest.raises(wisch.WischError, match="own strategy: ValueError: no idea"):
        task.session(plan=fails).plan()


def test_a_plan_for_known_dirt_is_shorter_than_one_for_the_belief():
    task = wisch.load_task("table", action="absorb", strategy="adaptive", seed=1)
    known, believed = task.plan_known_dirt(), task.session().plan()
    assert known.contact_distance_m < believed.contact_distance_m
    assert known.predict().performance >= believed.predict().performance
