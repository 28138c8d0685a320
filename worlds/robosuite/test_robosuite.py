"""Tests of the robosuite comparison: `pytest worlds/robosuite` in an environment with its requirements."""

import shutil

import numpy as np
import pytest

pytest.importorskip("robosuite", reason="pip install -r worlds/robosuite/requirements.txt")

import planning
from follower import Follower, FollowerConfig, Reference, rotation_error, wrapped
from peers import zigzag
from wipe_environment import WipeEnvironment


@pytest.fixture(scope="module")
def panda():
    world = WipeEnvironment("Panda", seed=1)
    yield world
    world.close()


def test_what_is_seen_lies_where_dirt_may_lie(panda):
    markers = panda.visible_markers()
    middle, sizes = panda.dirt_area()
    assert markers.shape == (100, 2)
    assert (np.abs(markers - middle) <= sizes / 2 + 1e-9).all()


def test_the_tool_is_what_its_contact_geometry_says(panda):
    tool = panda.tool()
    assert tool.length == pytest.approx(0.05, abs=1e-6)
    assert tool.width == pytest.approx(0.12, abs=1e-6)


def test_a_task_has_the_table_the_tool_and_the_markers(panda):
    markers = panda.visible_markers()
    text, particles = planning.task_of(panda, markers, panda.position()[:2], margin=0.004, speed=0.1)
    assert "size_m = [0.500000, 0.800000]" in text
    assert "footprint_m = [0.030000, 0.120000]" in text
    rows = np.array([[float(x) for x in row.split(",")] for row in particles.splitlines()[1:]])
    middle, _ = panda.table()
    assert np.allclose(rows + middle[:2], markers, atol=1e-6)


def test_force_is_measured_at_every_step_of_the_physics():
    world = WipeEnvironment("Panda", seed=1)
    world.step(np.zeros(6))
    assert len(world.forces) == round(world.period / world.env.model_timestep) == 25
    world.close()


def test_what_couples_position_and_rotation_is_made_up_for():
    world = WipeEnvironment("Panda", seed=1)
    wanted = np.array([0.5, 0.0, 0.0, 0.0, 0.0, 0.0])
    for _ in range(3):
        before = world.velocity(), world.turning()
        world.step(world.errors_for(wanted, np.zeros(6)))
    gained = (world.velocity() - before[0]) / world.period
    turned = (world.turning() - before[1]) / world.period
    assert gained == pytest.approx([0.5, 0.0, 0.0], abs=0.3)
    assert np.abs(turned).max() < 1.0
    world.close()


def test_a_tool_that_looks_the_same_after_half_a_turn():
    assert wrapped(np.pi) == pytest.approx(0.0)
    assert wrapped(0.6 * np.pi) == pytest.approx(-0.4 * np.pi)
    turn = rotation_error(np.eye(3), np.pi - 0.1)
    assert turn == pytest.approx([0.0, 0.0, -0.1], abs=1e-9)


def test_a_reference_keeps_its_speed_and_arrives():
    config = FollowerConfig()
    reference = Reference([[0.0, 0.0, 0.0], [0.1, 0.0, 0.3], [0.1, 0.1, 0.3]], np.zeros(2), config)
    fastest, nearest = 0.0, np.inf
    for _ in range(200):
        reference.advance(0.05, config.speed)
        fastest = max(fastest, np.linalg.norm(reference.velocity))
        nearest = min(nearest, np.linalg.norm(reference.position - [0.1, 0.0]))
    assert reference.arrived
    assert fastest <= config.speed * 1.05
    assert nearest < config.lookahead


def test_turns_stay_within_what_the_wrist_can_take(panda):
    follower = Follower(panda)
    path = follower._with_turns([[0.0, 0.0, 1.2 * k] for k in range(30)])
    assert (np.abs(path[:, 2] - follower.first_yaw) <= follower.config.turn_range + 1e-9).all()
    assert np.allclose([wrapped(a - 1.2 * k) for k, a in enumerate(path[:, 2])], 0.0, atol=1e-9)


def test_lanes_of_a_zigzag_are_no_further_apart_than_asked():
    points = zigzag(np.array([1.0, 2.0]), np.array([0.26, 0.44]), 0.03, along=1)
    lanes = np.unique(points[:, 0].round(9))
    assert np.diff(lanes).max() <= 0.03 + 1e-9
    assert lanes[0] == pytest.approx(0.87) and lanes[-1] == pytest.approx(1.13)


@pytest.mark.skipif(
    not (planning.os.environ.get("WISCH") or shutil.which("wisch")), reason="needs the program: WISCH=/path/to/wisch"
)
def test_an_episode_is_wiped_to_its_end():
    world = WipeEnvironment("Panda", seed=2)
    follower = Follower(world)
    planning.wipe(world, follower)
    assert world.ending() == "complete"
    assert 20.0 < np.median(follower.pressed) < 30.0
    world.close()
