"""A state of a robot, and a stop of its motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: Age from which a state is stale [s].
STALE_S = 0.1


class Stop(Exception):
    """A stop of a motion: its kind, as in the executor protocol, and the reason."""

    def __init__(self, kind: str, reason: str) -> None:
        super().__init__(reason)
        self.kind, self.reason = kind, reason


@dataclass
class Reading:
    """A state of a robot: joint positions [rad] and velocities [rad/s], pose of the tool in the base frame (7), force of the
    surroundings on the tool in the axes of the base [N] (3), and the time of the robot's clock [s]."""

    positions: np.ndarray
    velocities: np.ndarray
    base_from_tool: np.ndarray
    force_n: np.ndarray
    clock_s: float
