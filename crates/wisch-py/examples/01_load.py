"""Load a task, and print its main values."""

import wisch

task = wisch.load_task("arm-board")
print(f"{task.name}: {task.action} {task.medium} on {task.surface} with a {task.tool}")
print(f"{len(task.particles)} particles are on it")
print(f"press with {task.press_force_n} N")
print(f"target {100 * task.target_performance:.0f} %")
