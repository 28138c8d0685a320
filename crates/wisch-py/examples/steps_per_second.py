"""Measure the environment in strokes per second of wall time and of processor time, with 100 particles in each world.

Each world runs ten episodes of 30 random strokes. The time includes the steps that begin an episode; their number does not.
If robosuite is installed, its Wipe task runs with 100 markers and random actions; its time excludes the beginning of episodes.
"""

import logging
import os
import time

import gymnasium
import numpy as np
import wisch.gym


class Clock:
    """Wall time and processor time of its ``with`` blocks [s]."""

    def __init__(self):
        self.wall = self.processor = 0.0

    def __enter__(self):
        self._began = time.perf_counter(), time.process_time()

    def __exit__(self, *_):
        self.wall += time.perf_counter() - self._began[0]
        self.processor += time.process_time() - self._began[1]


def measure_vector(worlds):
    """Return the number of strokes in parallel worlds, and their time."""
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


def measure_single(steps=3000):
    """Return the number of strokes in one world through Gymnasium, and their time."""
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


def measure_robosuite(steps=400):
    """Return the same for robosuite's Wipe with its defaults, but without pictures; None if robosuite is not installed."""
    os.environ.setdefault("MUJOCO_GL", "disable")
    logging.disable(logging.WARNING)  # the import warns of missing optional packages
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


def print_speed(name, steps, clock, other):
    """Print the speed, and its ratio to another speed."""
    line = f"{name}: {steps / clock.wall:.0f} steps/s, {steps / clock.processor:.0f} per second of processor time"
    if other:
        other_steps, other_clock = other
        wall = steps / clock.wall * other_clock.wall / other_steps
        processor = steps / clock.processor * other_clock.processor / other_steps
        line += f"; {wall:.0f} and {processor:.0f} times robosuite's"
    print(line)


robosuite_steps = measure_robosuite()
if robosuite_steps:
    print_speed("robosuite's Wipe", *robosuite_steps, None)
print_speed("one world", *measure_single(), robosuite_steps)
for worlds in (256, 1024):
    print_speed(f"{worlds} worlds", *measure_vector(worlds), robosuite_steps)
