"""Tests of the MuJoCo world: `pytest worlds/mujoco` in an environment with its requirements and the wheel of wisch."""

import numpy as np
import pytest

mujoco = pytest.importorskip("mujoco", reason="pip install -r worlds/mujoco/requirements.txt")
wisch = pytest.importorskip("wisch", reason="pip install ./crates/wisch-py")

import evaluate
from wisch_mujoco import Push, Settings, Unsupported, World, dirt, poses, scene
from wisch_mujoco.__main__ import value
from wisch_mujoco.world import Simulation

BOARD = {"strategy": "best"}


@pytest.fixture(scope="module")
def task():
    return wisch.load_task("arm-board", set=BOARD)


@pytest.fixture(scope="module")
def motion(task):
    return task.session(robot=task.robot()).follow(World(task))


def test_poses_invert_and_chain():
    a = np.array([0.1, -0.2, 0.3, *np.array([0.1, 0.2, 0.3, 0.9]) / np.linalg.norm([0.1, 0.2, 0.3, 0.9])])
    b = np.array([1.0, 2.0, 3.0, 0.0, 0.0, np.sin(0.4), np.cos(0.4)])
    points = np.array([[0.3, 0.1, -0.7]])
    assert np.allclose(poses.into(poses.times(a, b), points), poses.into(a, poses.into(b, points)))
    assert np.allclose(poses.into(poses.inverse(a), poses.into(a, points)), points)


def test_crumbs_are_drawn_apart_from_the_belief(task):
    crumbs, again = World(task, seed=5).crumbs, World(task, seed=5).crumbs
    assert np.array_equal(crumbs.places, again.places)
    assert not np.array_equal(crumbs.places, World(task, seed=6).crumbs.places)
    assert dirt.inside(np.asarray(task.surface_outline), crumbs.places[:, :2]).all()
    nearest = np.linalg.norm(crumbs.places[:, None, :2] - np.asarray(task.particles)[None], axis=2).min(axis=1)
    assert nearest.max() > 0.005


def test_what_is_laid_over_a_task_holds_in_the_world_too(task):
    keys, _, disturbance = evaluate.world_of(10007 - 10007 % 9 + 8)
    assert disturbance == "pushed"
    settings = Settings.of(task, set=keys)
    assert settings.pushes and settings.tilt != (0.0, 0.0) and settings.dirt["source"] == "stripe"
    assert Settings.of(task).pushes == ()


def test_what_the_world_does_not_have_is_refused_by_its_key(task):
    with pytest.raises(Unsupported, match="execution.waviness_m"):
        Settings.of(task, set={"execution.waviness_m": 0.001})
    with pytest.raises(Unsupported, match="edge"):
        World(task, set={"execution.dirt": {"source": "edge"}})


def test_a_push_amid_a_stroke_begins_in_its_middle(motion):
    span = next(p for p in motion.phases if p["phase"] == "wipe" and p["stroke"] == 1)
    start = Push(force=np.ones(3), duration=1.0, start_stroke=2).start(motion)
    assert span["start_s"] < start < span["end_s"]
    assert Push(force=np.ones(3), duration=1.0, start_stroke=99).start(motion) is None
    assert Push(force=np.ones(3), duration=1.0, start_s=1e4).start(motion) is None


def test_the_robot_weighs_what_the_library_says(task, motion):
    world = World(task)
    model = scene.build(task, motion, world.settings, world.crumbs, world.world_from_real)
    data = mujoco.MjData(model.model)
    robot = task.robot()
    random = np.random.default_rng(1)
    for _ in range(5):
        q = np.asarray(motion.positions[0]) + random.uniform(-0.3, 0.3, robot.dof)
        data.qpos[model.qpos] = q
        mujoco.mj_forward(model.model, data)
        tool = np.zeros(model.model.nv)
        for body in (model.tool, *(model.model.geom_bodyid[geom] for geom in model.block_geoms)):
            jacobian = np.zeros((3, model.model.nv))
            mujoco.mj_jacBodyCom(model.model, data, jacobian, None, body)
            tool += 9.81 * model.model.body_mass[body] * jacobian[2]
        efforts = (data.qfrc_bias - data.qfrc_gravcomp)[model.dof]
        assert efforts == pytest.approx(np.asarray(robot.gravity(q)) + tool[model.dof], abs=1e-3)
    foam = sum(model.model.body_mass[model.model.geom_bodyid[geom]] for geom in model.block_geoms)
    assert foam == pytest.approx(scene.FOAM_MASS, rel=1e-3)


def test_the_tool_presses_as_asked_and_follows_its_line(task, motion):
    simulation = Simulation(World(task), motion)
    end = next(p["end_s"] for p in motion.phases if p["phase"] == "wipe")
    begin = next(p["start_s"] for p in motion.phases if p["phase"] == "wipe")
    forces, errors = [], []
    for k in range(int(end / 1e-3)):
        sample = simulation._period(k * 1e-3)
        if k * 1e-3 > begin:
            forces.append(simulation.contact_force())
            error = sample["world_from_commanded"][:3] - sample["world_from_tool"][:3]
            errors.append(np.linalg.norm(error[:2]))
    assert 6.0 < np.median(forces) < 12.0
    assert np.median(errors) < 0.005


def test_a_camera_sees_what_lies_and_nothing_that_is_gone(task):
    world = World(task, set={"perception.senses": ["touch", "sight"]})
    seen = world.observe()["detections"]
    assert 0.8 * len(world.crumbs) < len(seen) <= len(world.crumbs) + 2
    world.crumbs.fates[:] = dirt.TAKEN_UP
    assert len(world.observe()["detections"]) <= 2
    blind = World(task, set={"perception.senses": ["touch"]})
    assert blind.observe() is None


def test_values_of_the_command_line():
    assert value("true") is True
    assert value("[0.1, 2]") == [0.1, 2]
    assert value("best") == "best"


def test_a_sponge_takes_the_crumbs_up():
    task = wisch.load_task("arm-board", set=BOARD, action="absorb", seed=3)
    world = World(task)
    rounds = task.session(robot=task.robot(), rounds=1).run(world)
    assert world.performance() > 0.9
    assert abs(rounds[0].performance - world.performance()) < 0.1
    # Each round keeps the crumbs at its end.
    assert world.performance(round=1) == world.performance()


def test_a_humanoid_stands_where_it_is_planned_and_its_chest_upright():
    task = wisch.load_task("chopping-board", seed=1)
    world = World(task)
    motion = task.session(robot=task.robot()).follow(world)
    simulation = Simulation(world, motion)
    for k in range(300):
        simulation._period(k * 1e-3)
    planned, *_ = simulation.controller.planned
    q = simulation.data.qpos[simulation.scene.qpos]
    assert q[simulation.held] == pytest.approx(np.asarray(planned)[simulation.held], abs=0.01)
    (address, _), torso = simulation.scene.followers["torso_4"], [motion.joints.index(f"torso_{k}") for k in (2, 3)]
    assert simulation.data.qpos[address] == pytest.approx(-q[torso].sum(), abs=0.01)
