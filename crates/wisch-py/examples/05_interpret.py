"""Interpret poses and forces, and plan the next round from the estimate."""

import numpy as np
import wisch

task = wisch.load_task("arm-board")
time = np.arange(2000) * 1e-3
pose = np.tile(task.world_from_surface, (2000, 1))
pose[:, 0] += 0.1 * time - 0.1
pose[:, 1] -= 0.06
force = np.tile(task.surface_reaction, (2000, 1))

# wisch.read_log(path) reads a bag or a table; pass its result to task.interpret. Its `remarks` state what was assumed.
estimate = task.interpret(time_s=time, world_from_tool=pose, force_n=force, certain=True)
print(f"{100 * estimate.performance:.0f} % are at the goal")
print(f"the next round wipes {estimate.next_plan().contact_distance_m:.2f} m")
