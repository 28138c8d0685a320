"""Shared fixtures: a small board, an arm bolted beside it, and executors that follow the plan exactly."""

import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest

import wisch


class Exact:
    """A robot whose tool follows the plan exactly, and measures the press force."""

    def __init__(self, reaction):
        self.reaction = reaction

    def sample(self, motion, k):
        return {
            "time_s": motion.time_s[k],
            "world_from_tool": motion.world_from_tool[k],
            "force_n": self.reaction * (motion.stroke[k] >= 0),
            "positions": motion.positions[k],
        }

    def execute(self, motion, sink):
        for k in range(len(motion.time_s)):
            if not sink(self.sample(motion, k)):
                return


class AllAtOnce(Exact):
    """The same robot, which passes all samples at once."""

    def execute(self, motion, sink):
        touches = (motion.stroke >= 0)[:, None]
        sink.many(
            time_s=motion.time_s,
            world_from_tool=motion.world_from_tool,
            force_n=touches * self.reaction,
            positions=motion.positions,
        )


@pytest.fixture(scope="session")
def task():
    return wisch.load_task("arm-board", set={"perception.senses": ["touch"]})


@pytest.fixture(scope="session")
def robot(task):
    return task.robot()


@pytest.fixture
def exact(task):
    return AllAtOnce(task.surface_reaction)


@pytest.fixture(scope="session")
def program():
    """Return the command of the program in the wheel."""
    script = Path(sysconfig.get_path("scripts")) / "wisch"
    return [str(script)] if script.is_file() else [sys.executable, "-m", "wisch"]


@pytest.fixture(scope="session")
def motion(task, robot):
    return task.session(robot, rounds=1).follow()
