"""A Gymnasium environment for learning to wipe: ``wisch/Wiping-v0``, on the effect model.

Importing this module registers it; ``gymnasium.make("wisch.gym:wisch/Wiping-v0")`` also imports the module.

An episode begins with particles distributed uniformly over a surface. Each step is a straight stroke of the tool in contact;
the reward is the gain in the task's performance, minus a cost of its path. The episode ends when the target is reached
(terminated) or after ``max_strokes`` strokes (truncated).

**Action**, ``Box(-1, 1, (5,), float32)``: start x and y and end x and y of the stroke, in the bounding box of the surface
enlarged by the radius of the tool on each side (so that it can wipe over an edge); and the tool's yaw, in half turns: at this
yaw, its broad side is perpendicular to a motion in that direction.

**Observation**, ``Dict``: ``density``, ``Box(0, 1, (rows, columns), float32)``, the share of the particles in each
cell of the surface, rows along y from the smallest; ``tool``, ``Box(-1, 1, (4,), float32)``, the end of the last stroke, x and y
in the box of the actions, and cosine and sine of its yaw.

**Reward**: performance after minus performance before (0 to 1), minus ``cost_per_m`` for each metre of path, in contact or not.

>>> import gymnasium
>>> import wisch.gym
>>> env = gymnasium.make("wisch/Wiping-v0")
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
"""

from __future__ import annotations

import math
import os
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from . import _wisch
from ._task import Task, build_task, load_task

__all__ = ["AdaptivePolicy", "RandomPolicy", "WipingEnv", "WipingVectorEnv"]

#: Length of an action: start x, y, end x, y, yaw.
_ACTION = 5


def _default_task() -> Task:
    return build_task(
        name="wiping",
        action="collect",
        tool="sponge",
        medium="breadcrumbs",
        surface={"name": "chopping_board", "size_m": [0.40, 0.28]},
        collect={"goal_m": [0.13, -0.08]},
        particles={"source": "uniform", "count": 100},
    )


def _task(task) -> Task:
    if task is None:
        return _default_task()
    if isinstance(task, (str, os.PathLike)):
        return load_task(task)
    return task


def _worlds(task, count, particles, grid, max_strokes, target, cost_per_m):
    rows, columns = grid
    worlds = _wisch.WipingWorlds(
        task,
        count,
        particles=particles,
        rows=rows,
        columns=columns,
        max_strokes=max_strokes,
        target=task.target_performance if target is None else target,
        cost_per_m=cost_per_m,
    )
    observation = spaces.Dict(
        {
            "density": spaces.Box(0.0, 1.0, (rows, columns), np.float32),
            "tool": spaces.Box(-1.0, 1.0, (4,), np.float32),
        }
    )
    return worlds, observation, spaces.Box(-1.0, 1.0, (_ACTION,), np.float32)


class WipingEnv(gymnasium.Env):
    """One world; see the module for its spaces and its reward.

    ``task`` is a ``wisch.Task``, a path or the name of a shipped scenario (default: collecting crumbs on a board);
    ``particles`` the number of particles; ``grid`` rows and columns of the density; ``max_strokes`` the largest number of
    strokes in an episode; ``target`` the performance at which it ends, 0 to 1 (default: the task's); ``cost_per_m`` the cost of
    a metre of path.
    """

    metadata = {"render_modes": []}

    def __init__(
        self,
        task: Task | str | os.PathLike | None = None,
        *,
        particles: int = 100,
        grid: tuple[int, int] = (14, 20),
        max_strokes: int = 30,
        target: float | None = None,
        cost_per_m: float = 0.02,
        render_mode: str | None = None,
    ) -> None:
        self.task = _task(task)
        self.worlds, self.observation_space, self.action_space = _worlds(
            self.task, 1, particles, grid, max_strokes, target, cost_per_m
        )
        self.render_mode = render_mode
        self._is_seeded = False

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None):
        """Begin an episode; ``seed`` determines its particles, and those of later episodes."""
        super().reset(seed=seed)
        if seed is None and not self._is_seeded:
            seed = int(self.np_random.integers(1 << 62))
        self._is_seeded = True
        density, tool = self.worlds.reset([seed])
        return {"density": density[0], "tool": tool[0]}, self._info()

    def step(self, action):
        """Execute a stroke."""
        action = np.asarray(action, dtype=np.float64).reshape(1, _ACTION)
        density, tool, reward, terminated, truncated, _ = self.worlds.step(action)
        observation = {"density": density[0], "tool": tool[0]}
        return observation, float(reward[0]), bool(terminated[0]), bool(truncated[0]), self._info()

    def _info(self) -> dict[str, Any]:
        return {"performance": float(self.worlds.performance[0])}

    def particles(self) -> np.ndarray:
        """Positions of the particles on the surface, (k, 2) in its frame [m]: ground truth, not for policies."""
        return self.worlds.particles(0)


class WipingVectorEnv(VectorEnv):
    """Many worlds side by side, computed in Rust on all cores; arguments as for ``WipingEnv``.

    After the end of an episode, the next step begins a new one and ignores its action (``AutoresetMode.NEXT_STEP``).
    World i with a seed equals a ``WipingEnv`` with that seed plus i.
    """

    metadata = {"render_modes": [], "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(
        self,
        num_envs: int = 1,
        task: Task | str | os.PathLike | None = None,
        *,
        particles: int = 100,
        grid: tuple[int, int] = (14, 20),
        max_strokes: int = 30,
        target: float | None = None,
        cost_per_m: float = 0.02,
        render_mode: str | None = None,
    ) -> None:
        self.task = _task(task)
        self.num_envs = num_envs
        self.worlds, self.single_observation_space, self.single_action_space = _worlds(
            self.task, num_envs, particles, grid, max_strokes, target, cost_per_m
        )
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.render_mode = render_mode
        self._is_seeded = False

    def reset(self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None):
        """Begin new episodes in all worlds; world i gets the seed plus i, or the i-th seed of a list."""
        super().reset(seed=seed if isinstance(seed, int) else None)
        if seed is None and not self._is_seeded:
            seed = [int(s) for s in self.np_random.integers(1 << 62, size=self.num_envs)]
        self._is_seeded = True
        if seed is None:
            seed = [None] * self.num_envs
        elif isinstance(seed, int):
            seed = [seed + i for i in range(self.num_envs)]
        density, tool = self.worlds.reset(list(seed))
        return {"density": density, "tool": tool}, {"performance": self.worlds.performance}

    def step(self, actions):
        """Execute a stroke in each world, actions (num_envs, 5)."""
        density, tool, reward, terminated, truncated, performance = self.worlds.step(actions)
        return {"density": density, "tool": tool}, reward, terminated, truncated, {"performance": performance}

    def particles(self, world: int) -> np.ndarray:
        """Positions of the particles on the surface of a world, (k, 2) in its frame [m]."""
        return self.worlds.particles(world)


class RandomPolicy:
    """Random strokes: a baseline."""

    def __init__(self, env: gymnasium.Env, seed: int | None = None) -> None:
        self._space = env.action_space
        self._space.seed(seed)

    def reset(self) -> None:
        """Begin a new episode."""

    def __call__(self, observation) -> np.ndarray:
        """Return the next action."""
        return self._space.sample()


class AdaptivePolicy:
    """Executes the strokes of an adaptive plan for the true particles, which a learner does not see.

    It plans at the beginning of an episode, and whenever its plan is finished. The plan's strokes bend and turn; they are executed
    as straight strokes, one per edge, with the mean yaw. ``evaluations`` is the number of plans that the search may evaluate.
    """

    def __init__(self, env: gymnasium.Env, *, evaluations: int = 20_000) -> None:
        self._env = env.unwrapped
        self._evaluations = evaluations
        low, high = self._env.worlds.reach
        self._middle, self._half = (low + high) / 2, (high - low) / 2
        self._strokes: list[np.ndarray] = []

    def reset(self) -> None:
        """Begin a new episode."""
        self._strokes = []

    def __call__(self, observation) -> np.ndarray:
        """Return the next action, (5,)."""
        if not self._strokes:
            self._strokes = self._plan()
        return self._strokes.pop(0)

    def _plan(self) -> list[np.ndarray]:
        here = self._env.particles()
        if len(here):
            task = self._env.task.with_particles(
                here, set={"plan.evaluations": self._evaluations}, strategy="adaptive"
            )
            plan = task.session().plan()
            edges = [edge for stroke in plan.strokes for edge in zip(stroke[:-1], stroke[1:])]
            actions = [self._action(before, after) for before, after in edges]
            if actions:
                return actions
        return [np.zeros(_ACTION, np.float32)]

    def _action(self, before: np.ndarray, after: np.ndarray) -> np.ndarray:
        start, end = ((pose[:2] - self._middle) / self._half for pose in (before, after))
        heading = math.remainder((before[2] + after[2]) / 2, 2 * math.pi) / math.pi
        return np.clip([*start, *end, heading], -1.0, 1.0).astype(np.float32)


gymnasium.register(
    "wisch/Wiping-v0",
    entry_point="wisch.gym:WipingEnv",
    vector_entry_point="wisch.gym:WipingVectorEnv",
)
