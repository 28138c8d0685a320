"""Run the whole loop with your own executor: a robot whose tool follows the plan exactly."""

import wisch


class Exact:
    def execute(self, motion, sink):
        for k, time in enumerate(motion.time_s):
            force = task.surface_reaction * (motion.stroke[k] >= 0)
            pose, positions = motion.world_from_tool[k], motion.positions[k]
            if not sink(time_s=time, world_from_tool=pose, force_n=force, positions=positions):
                return


task = wisch.load_task("arm-board")
session = task.session(task.robot())
for round in session.run(Exact()):
    print(f"round {round.number}: {100 * round.performance:.0f} % by touch, {round.verdict}")
