"""Tests of the robosuite comparison: `pytest worlds/robosuite` in an environment with its requirements."""

import shutil

import numpy as np
import pytest

pytest.importorskip("robosuite", reason="pip install -r worlds/robosuite/requirements.txt")

import planning
from follower import Follower, FollowerConfig, Reference, rotation_error, wrapped
from peers import zigzag
from wipe_environment import LEVER, WipeEnvironment, _damped_solve


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


def mobility_of(masses, seed):
    """Returns a mobility with these masses in random directions."""
    directions, _ = np.linalg.qr(np.random.default_rng(seed).standard_normal((6, 6)))
    scale = np.array([1.0, 1.0, 1.0, LEVER, LEVER, LEVER])
    return (directions / masses) @ directions.T / np.outer(scale, scale)


@pytest.mark.parametrize("seed", range(5))
def test_what_is_light_enough_is_solved_exactly(seed):
    mobility = mobility_of(np.array([2.0, 5.0, 9.0, 40.0, 300.0, 900.0]), seed)
    wanted = np.random.default_rng([seed, 1]).standard_normal(6)
    for heaviest in (1000.0, np.inf):
        assert mobility @ _damped_solve(mobility, wanted, heaviest) == pytest.approx(wanted, abs=1e-8)


@pytest.mark.parametrize("mass", [1e3, 1e5, 1e9, np.inf])
def test_near_a_singular_posture_the_wrench_has_a_bound_and_the_other_directions_their_acceleration(mass):
    heaviest = 500.0
    mobility = mobility_of(np.array([2.0, 5.0, 9.0, 40.0, 300.0, mass]), seed=1)
    scale = np.array([1.0, 1.0, 1.0, LEVER, LEVER, LEVER])
    wanted = np.random.default_rng(2).standard_normal(6)
    wrench = _damped_solve(mobility, wanted, heaviest)
    assert np.linalg.norm(wrench / scale) <= heaviest * np.linalg.norm(scale * wanted)
    _, directions = np.linalg.eigh(mobility * np.outer(scale, scale))
    missing = directions.T @ (scale * (mobility @ wrench - wanted))
    assert missing[1:] == pytest.approx(np.zeros(5), abs=1e-8)
    lost = directions[:, 0] @ (wrench / scale)
    assert abs(lost) <= heaviest**2 / mass * np.linalg.norm(scale * wanted) + 1e-6, "it goes to zero with the mobility"


class Heavy:
    """A stand-in whose command grows with the allowed effective mass."""

    def __init__(self, by_mass):
        self.by_mass, self.asked = by_mass, []

    def errors_for(self, acceleration, wrench, heaviest=np.inf):
        self.asked.append(heaviest)
        return np.concatenate([acceleration[:3] + [0.0, 0.0, self.by_mass(heaviest)], np.zeros(3)])


@pytest.mark.parametrize(
    ("by_mass", "given_up"),
    [(lambda _: 0.0, []), (lambda _: 0.2, []), (lambda mass: min(mass, 1e5) * 1e-4, [3000.0, 1000.0, 300.0])],
    ids=["fits", "is cut off a little", "is singular"],
)
def test_nothing_is_given_up_but_near_a_singular_posture(panda, by_mass, given_up):
    follower = Follower(panda)
    follower.world = Heavy(by_mass)
    errors = follower._errors(np.array([0.01, 0.0, 0.0, 0.0, 0.0, 0.0]), np.zeros(6))
    asked = sorted({mass for mass in follower.world.asked if mass < np.inf}, reverse=True)
    assert asked == given_up
    assert errors[2] == by_mass(given_up[-1] if given_up else np.inf)


def test_what_is_given_up_stays_so_until_a_whole_command_fits(panda):
    follower, size = Follower(panda), 0.0
    follower.world = Heavy(lambda mass: size if mass == np.inf else 0.01)
    given_up = []
    for size in (0.2, 0.4, 0.2, 0.06, 0.0, 0.2):
        follower.world.asked.clear()
        follower._errors(np.zeros(6), np.zeros(6))
        given_up.append(min(follower.world.asked) < np.inf)
    assert given_up == [False, True, True, True, False, False]


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


def last_joint_along(world, path, yaw):
    """Returns the angle of the last joint of an arm that points down, for each pose of a path."""
    angle, low, high, sign = world.last_joint()
    here = world.bearing(world.position()[:2])
    swings = np.array([wrapped(world.bearing(pose[:2]) - here) for pose in path])
    return angle + sign * (path[:, 2] - yaw - swings), low, high


def test_turns_stay_within_what_the_wrist_can_take(panda):
    follower = Follower(panda)
    path = follower._with_turns([[0.0, 0.0, 1.2 * k] for k in range(30)])
    angles, low, high = last_joint_along(panda, path, follower.yaw)
    assert (angles >= low + 0.3).all() and (angles <= high - 0.3).all()
    assert np.allclose([wrapped(a - 1.2 * k) for k, a in enumerate(path[:, 2])], 0.0, atol=1e-9)


def test_a_stroke_that_would_end_beyond_the_wrist_begins_half_a_turn_away(panda):
    # Of seed 1003: on its way the arm swings to one side while the tool turns to the other.
    follower = Follower(panda)
    path = follower._with_turns([[0.168, 0.04, 3.238], [0.259, -0.003, 3.342], [0.182, 0.227, 3.088]])
    angles, low, high = last_joint_along(panda, path, follower.yaw)
    assert (angles > low + 0.3).all() and (angles < high - 0.3).all()
    assert np.abs(np.diff(path[:, 2])).max() < 0.5, "no half turn during the stroke"


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
