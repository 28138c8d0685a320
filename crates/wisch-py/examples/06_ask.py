"""Store a session as an episode, and query the memory in Prolog."""

import tempfile

import numpy as np
import wisch


class Exact:
    def execute(self, motion, sink):
        touches = (motion.stroke >= 0)[:, None]
        poses, positions = motion.world_from_tool, motion.positions
        sink.many(time_s=motion.time_s, world_from_tool=poses, force_n=touches * task.surface_reaction, positions=positions)


task = wisch.load_task("arm-board")
session = task.session(task.robot(), rounds=1)
session.run(Exact())
memory = wisch.Memory(tempfile.mkdtemp())
episode = memory.remember(session)
print(f"it pressed with {memory.telemetry(episode)['external/fz'].max():.1f} N")
try:
    for answer in memory.ask("low_performance_round(Round, Performance)"):
        print(f"{answer['Performance']:.2f} of round {answer['Round']}")
except wisch.WischError as error:
    print(error)  # there is no Prolog engine, and how to get one
