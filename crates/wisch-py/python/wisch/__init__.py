"""wisch: represent, plan, predict, execute and interpret robotic wiping.

>>> import wisch
>>> task = wisch.load_task("arm-board")
>>> plan = task.session().plan()
>>> plan.predict().performance > 0.9
True

Units are SI and radians. Poses are arrays of seven numbers: x, y, z [m] and a unit quaternion x, y, z, w, in the frame of the
world. Points on a surface are x, y [m] in its frame, whose z axis points outward; a tool's pose there is x, y [m] and its
yaw [rad].
"""

from ._errors import WischError
from ._goal import GoalFile
from ._task import Task, build_task, load_task
from ._wisch import (
    Audit,
    EffectField,
    ImpedanceController,
    Interpretation,
    Memory,
    Motion,
    Plan,
    Prediction,
    Robot,
    Round,
    Session,
    Sink,
    Telemetry,
    read_log,
)

__all__ = [
    "Audit",
    "EffectField",
    "GoalFile",
    "ImpedanceController",
    "Interpretation",
    "Memory",
    "Motion",
    "Plan",
    "Prediction",
    "Robot",
    "Round",
    "Session",
    "Sink",
    "Task",
    "Telemetry",
    "WischError",
    "build_task",
    "load_task",
    "read_log",
]
