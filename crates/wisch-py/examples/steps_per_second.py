"""Count strokes per second of the environment, 100 particles in each world: in all, and per second of processor time.

Ten episodes of 30 random strokes; steps that begin an episode take their time but are not counted. Where robosuite is installed, the
steps of its Wipe task are counted beside them, 100 markers, with random actions; beginning an episode takes none of their time.
"""

import logging
import os
import time

import gymnasium
import numpy as np
import wisch.gym


class Clock:
    """Wall and processor time while something runs."""

    def __init__(self):
        self.wall = self.processor = 0.0

    def __enter__(self):
        self._began = time.perf_counter(), time.process_time()

    def __exit__(self, *_):
        self.wall += time.perf_counter() - self._began[0]
        self.processor += time.process_time() - self._began[1]


def many(worlds):
    """Steps and the time they took, of worlds side by side."""
    env = wisch.gym.WipingVectorEnv(worlds, particles=100, max_strokes=30)
    env.action_space.seed(1)
    env.reset(seed=1)
    actions = [env.action_space.sample() for _ in range(8)]
    strokes, over, clock = 0, np.zeros(worlds, bool), Clock()
    with clock:
        for k in range(310):
            strokes += int((~over).sum())
            _, _, terminated, truncated, _ = env.step(actions[k % 8])
            over = terminated | truncated
    return strokes, clock


def single(steps=3000):
    """The same of one world, by Gymnasium's interface."""
    env = gymnasium.make("wisch/Wiping-v0", particles=100, max_strokes=30)
    env.action_space.seed(1)
    env.reset(seed=1)
    clock = Clock()
    with clock:
        for _ in range(steps):
            _, _, terminated, truncated, _ = env.step(env.action_space.sample())
            if terminated or truncated:
                env.reset()
    return steps, clock


def of_robosuite(steps=400):
    """The same of robosuite's Wipe, as it is made by default but for pictures; nothing where it is not installed."""
    os.environ.setdefault("MUJOCO_GL", "disable")
    logging.disable(logging.WARNING)  # it tells of optional packages at import
    try:
        import robosuite
    except ImportError:
        return None
    env = robosuite.make("Wipe", robots="Panda", has_renderer=False, has_offscreen_renderer=False, use_camera_obs=False, seed=1)
    env.reset()
    random = np.random.default_rng(1)
    low, high = env.action_spec
    clock = Clock()
    for _ in range(steps):
        action = random.uniform(low, high)
        with clock:
            _, _, done, _ = env.step(action)
        if done:
            env.reset()
    return steps, clock


def told(name, steps, clock, beside):
    """Prints how fast it is, and how many times as fast as what is beside it."""
    line = f"{name}: {steps / clock.wall:.0f} steps/s, {steps / clock.processor:.0f} per second of processor time"
    if beside:
        other_steps, other = beside
        wall = steps / clock.wall * other.wall / other_steps
        processor = steps / clock.processor * other.processor / other_steps
        line += f"; {wall:.0f} and {processor:.0f} times robosuite's"
    print(line)


beside = of_robosuite()
if beside:
    told("robosuite's Wipe", *beside, None)
told("one world", *single(), beside)
for worlds in (256, 1024):
    told(f"{worlds} worlds", *many(worlds), beside)
