"""A Gymnasium environment to learn wiping in: ``wisch/Wiping-v0``, on the effect model.

Importing this module makes it known; ``gymnasium.make("wisch.gym:wisch/Wiping-v0")`` imports it by itself.

An episode begins with particles spread evenly over a surface. Each step is a straight stroke of the tool in contact; the
reward is what it gains of the task's performance, less what its way costs. It ends when the target is reached (terminated) or
after so many strokes (truncated).

**Action**, ``Box(-1, 1, (5,), float32)``: where the stroke starts, x and y, and where it ends, x and y, in the bounding box of
the surface, which is larger by the radius of the tool on each side (so that it can wipe over an edge); and the tool's heading,
in half turns: its broad side lies across a motion in the direction of its heading.

**Observation**, ``Dict``: ``density``, ``Box(0, 1, (rows, columns), float32)``, the share of the particles that lies in each
cell of the surface, rows along y from the smallest; ``tool``, ``Box(-1, 1, (4,), float32)``, where the tool was lifted, x and y
in the box of the actions, and cosine and sine of its heading.

**Reward**: performance after less before (0 to 1), less ``cost_per_m`` for each metre of way, in contact or lifted.

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

#: Of an action: start x, y, end x, y, heading.
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

    ``task`` is a ``wisch.Task``, a path or the name of a shipped scenario (default: crumbs that are collected on a board);
    ``particles`` how many there are; ``grid`` rows and columns of the density; ``max_strokes`` after how many strokes an
    episode is cut off; ``target`` the performance at which it ends, 0 to 1 (default: the task's); ``cost_per_m`` what a metre
    of way costs.
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
        """Begin an episode; ``seed`` draws where its particles lie, and those of the episodes after it."""
        super().reset(seed=seed)
        if seed is None and not self._is_seeded:
            seed = int(self.np_random.integers(1 << 62))
        self._is_seeded = True
        density, tool = self.worlds.reset([seed])
        return {"density": density[0], "tool": tool[0]}, self._info()

    def step(self, action):
        """Wipe one stroke."""
        action = np.asarray(action, dtype=np.float64).reshape(1, _ACTION)
        density, tool, reward, terminated, truncated, _ = self.worlds.step(action)
        observation = {"density": density[0], "tool": tool[0]}
        return observation, float(reward[0]), bool(terminated[0]), bool(truncated[0]), self._info()

    def _info(self) -> dict[str, Any]:
        return {"performance": float(self.worlds.performance[0])}

    def particles(self) -> np.ndarray:
        """Where the particles lie that are still on the surface, (k, 2) in its frame [m]; no policy is meant to see them."""
        return self.worlds.particles(0)


class WipingVectorEnv(VectorEnv):
    """Many worlds side by side, computed in Rust on all cores; arguments as of ``WipingEnv``.

    An episode that is over begins anew with the next step, whose action is not looked at (``AutoresetMode.NEXT_STEP``).
    With the same seed, world i does what a ``WipingEnv`` does with that seed plus i.
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
        """Begin all episodes anew; world i gets the seed plus i, or the list's i-th."""
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
        """Wipe one stroke in each world, actions (num_envs, 5)."""
        density, tool, reward, terminated, truncated, performance = self.worlds.step(actions)
        return {"density": density, "tool": tool}, reward, terminated, truncated, {"performance": performance}

    def particles(self, world: int) -> np.ndarray:
        """Where the particles of one world lie that are still on the surface, (k, 2) in its frame [m]."""
        return self.worlds.particles(world)


class RandomPolicy:
    """Strokes anywhere, anyhow: what everything is to be better than."""

    def __init__(self, env: gymnasium.Env, seed: int | None = None) -> None:
        self._space = env.action_space
        self._space.seed(seed)

    def reset(self) -> None:
        """A new episode."""

    def __call__(self, observation) -> np.ndarray:
        """The next action."""
        return self._space.sample()


class AdaptivePolicy:
    """Plays the strokes of an adaptive plan for the particles as they lie, which a learner does not see.

    It plans when an episode begins, and again when its plan is played. The plan's strokes bend and turn; they are played as
    straight strokes, one per edge, with the heading halfway. ``evaluations`` is how many plans the search may try.
    """

    def __init__(self, env: gymnasium.Env, *, evaluations: int = 20_000) -> None:
        self._env = env.unwrapped
        self._evaluations = evaluations
        low, high = self._env.worlds.reach
        self._middle, self._half = (low + high) / 2, (high - low) / 2
        self._strokes: list[np.ndarray] = []

    def reset(self) -> None:
        """A new episode."""
        self._strokes = []

    def __call__(self, observation) -> np.ndarray:
        """The next action, (5,)."""
        if not self._strokes:
            self._strokes = self._planned()
        return self._strokes.pop(0)

    def _planned(self) -> list[np.ndarray]:
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
