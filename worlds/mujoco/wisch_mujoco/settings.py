"""The ground truth of the world, from the table `[execution]` of a task file, which neither planner nor interpreter reads."""

import tomllib
from dataclasses import dataclass, field

import numpy as np

FRICTION = {"chopping_board": 0.45, "table": 0.35, "floor": 0.5, "windshield": 0.25, "solar_panel": 0.25}
"""Default friction between surface and tool, as in the knowledge base [1]."""
GRAINS = {"breadcrumbs": (0.0005, 0.002), "glass_chippings": (0.002, 0.006)}
"""Default grain diameters, as in the knowledge base [m]."""


class Unsupported(ValueError):
    """The task needs something that this world lacks."""


@dataclass(frozen=True)
class Push:
    """A person who pushes the tool."""

    force: np.ndarray
    """Force on a tool at rest, in the axes of the world [N]."""
    duration: float
    start_s: float | None = None
    start_share: float | None = None
    start_stroke: int | None = None
    round: int = 1
    hand_speed: float = 0.1
    """Speed of the tool at which the hand's force vanishes [m/s]."""

    def start(self, motion):
        """Returns when the push begins in a motion [s]; None if the motion ends earlier."""
        if self.start_s is not None:
            return self.start_s if self.start_s < motion.duration_s else None
        if self.start_share is not None:
            return self.start_share * motion.duration_s
        spans = [p for p in motion.phases if p["phase"] == "wipe" and p.get("stroke") == self.start_stroke - 1]
        return 0.5 * (spans[0]["start_s"] + spans[-1]["end_s"]) if spans else None


@dataclass(frozen=True)
class Settings:
    """The ground truth of a world."""

    friction: float = 0.45
    tilt: tuple = (0.0, 0.0)
    """Tilt of the true surface against the believed one, about its x and y [rad]."""
    shift: tuple = (0.0, 0.0, 0.0)
    """Shift of the true surface in the frame of the believed one [m]."""
    force_noise: float = 0.15
    force_bias: tuple = (0.0, 0.0, 0.0)
    encoder_noise: float = 0.0
    grasp_offset: tuple = (0.0, 0.0)
    """True offset of the tool in the hand, in the tool frame [m]."""
    grasp_turn: float = 0.0
    tool_stiffness: float = 1.0
    footprint: float = 1.0
    grains: tuple = (0.0005, 0.002)
    dirt: dict = field(default_factory=lambda: {"source": "uniform"})
    count: int | None = None
    mu: float = -1.05
    sigma: float = 0.25
    """Mean and spread of ln of the share of the nominal pressure at which an absorbing tool takes up a crumb."""
    pushes: tuple = ()
    detection: float = 0.98
    half_size: float = 0.0003
    false_alarms: float = 2.0
    position_error: float = 0.002
    sees: bool = False
    seed: int = 0

    @classmethod
    def of(cls, task, seed=None, set=None):
        """Reads the settings of a task. `set`: values that overrode the file when it was loaded; its text lacks them.

        Raises Unsupported: the task needs something that this world lacks.
        """
        table = tomllib.loads(task.toml)
        for key, value in (set or {}).items():
            *path, last = key.split(".")
            inner = table
            for name in path:
                inner = inner.setdefault(name, {})
            inner[last] = value
        real = table.get("execution", {})
        refused = {
            "waviness_m": "waves in the surface",
            "surface_radius_m": "curved surface",
            "backlash_rad": "play of the joints",
            "force_delay_s": "late forces",
            "friction_change": "changes of friction",
            "joint_friction_nm": "friction in the joints",
            "force_drift_n_per_s": "drift of the force",
            "grain_mass_kg": "masses of grains of its own choice",
        }
        for key, what in refused.items():
            if real.get(key):
                raise Unsupported(f"{table['name']}: execution.{key}: this world has no {what}")
        if real.get("grains_resist") is False:
            raise Unsupported(f"{table['name']}: execution.grains_resist: the grains of this world always resist the tool")
        if task.action not in ("absorb", "collect", "skim"):
            raise Unsupported(f"{table['name']}: action {task.action!r}: this world has crumbs to absorb, collect or skim")
        camera = {**table.get("perception", {}), **real.get("camera", {})}
        dirt = dict(real.get("dirt", {"source": "uniform"}))
        law = {**table.get("interaction", {}), **real}
        return cls(
            friction=real.get("friction", table["surface"].get("friction", FRICTION.get(task.surface, 0.4))),
            tilt=tuple(real.get("surface_tilt_rad", (0.0, 0.0))),
            shift=tuple(real.get("surface_shift_m", (0.0, 0.0, 0.0))),
            force_noise=real.get("force_noise_n", 0.15),
            force_bias=tuple(real.get("force_bias_n", (0.0, 0.0, 0.0))),
            encoder_noise=real.get("encoder_noise_rad", 0.0),
            grasp_offset=tuple(real.get("grasp_offset_m", (0.0, 0.0))),
            grasp_turn=real.get("grasp_turn_rad", 0.0),
            tool_stiffness=real.get("tool_stiffness", 1.0),
            footprint=real.get("footprint", 1.0),
            grains=tuple(real.get("grain_size_m", GRAINS.get(task.medium, (0.001, 0.002)))),
            dirt=dirt,
            count=dirt.get("count"),
            mu=law.get("mu", -1.05),
            sigma=law.get("sigma", 0.25),
            pushes=tuple(
                Push(
                    force=np.array(push["force_n"], dtype=float),
                    duration=push["duration_s"],
                    start_s=push.get("start_s"),
                    start_share=push.get("start_share"),
                    start_stroke=push.get("start_stroke"),
                    round=push.get("round", 1),
                    hand_speed=push.get("hand_speed_m_per_s", 0.1),
                )
                for push in real.get("push", ())
            ),
            detection=camera.get("detection", 0.98),
            half_size=camera.get("half_size_m", 0.0003),
            false_alarms=camera.get("false_alarms_per_m2", 2.0),
            position_error=camera.get("position_error_m", 0.002),
            sees="sight" in camera.get("senses", ["touch"]),
            seed=task.seed if seed is None else seed,
        )
