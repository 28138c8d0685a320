"""Count strokes per second of the environment, 100 particles in each world: in all, and per second of processor time.

Ten episodes of 30 random strokes; steps that begin an episode take their time but are not counted.
"""

import time

import numpy as np
import wisch.gym

for worlds in (256, 1024):
    env = wisch.gym.WipingVectorEnv(worlds, particles=100, max_strokes=30)
    env.action_space.seed(1)
    env.reset(seed=1)
    actions = [env.action_space.sample() for _ in range(8)]
    strokes, over = 0, np.zeros(worlds, bool)
    begin, begin_processor = time.perf_counter(), time.process_time()
    for k in range(310):
        strokes += int((~over).sum())
        _, _, terminated, truncated, _ = env.step(actions[k % 8])
        over = terminated | truncated
    wall, processor = time.perf_counter() - begin, time.process_time() - begin_processor
    print(f"{worlds} worlds: {strokes / wall:.0f} strokes/s, {strokes / processor:.0f} per second of processor time")
