"""What is computed in Rust. Use it by way of ``wisch``, which hands it on.

Units are SI and radians. A pose (7) is x, y, z [m] and a unit quaternion x, y, z, w in the frame of the world; n is the number
of the robot's joints, T that of times or samples.
"""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, Protocol, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Path = str | PathLike[str]
Event = dict[str, Any]
OnEvent = Callable[[Event], bool | None]

class SceneObject(TypedDict):
    name: str
    role: Literal["obstacle", "carrier", "robot", "tool"]
    vertices: Floats
    triangles: NDArray[np.uint32]
    world_from_object: Floats

class Phase(TypedDict, total=False):
    phase: Literal["drive", "transfer", "lifted", "lower", "wipe", "lift"]
    stroke: int
    start_s: float
    end_s: float

class JointLimits(TypedDict):
    unit: Literal["rad", "m"]
    lower: float | None
    upper: float | None
    velocity: float | None
    acceleration: float | None
    effort: float | None

class Setpoints(TypedDict):
    time_s: Floats
    positions: Floats
    velocities: Floats
    world_from_tool: Floats
    stroke: NDArray[np.int64]

class WipingEvent(TypedDict):
    kind: str
    start_s: float
    end_s: float
    peak_force_n: float

class Effect(TypedDict):
    absorbed: int
    pushed: int
    off_surface: int
    treated: int

class Executor(Protocol):
    """What executes motions; see ``wisch.executor.Executor``."""
    def execute(self, motion: Motion, sink: Sink) -> Mapping[str, Any] | None: ...

class Task:
    """What is to be wiped, where, with what, and to what end."""
    @property
    def name(self) -> str: ...
    @property
    def path(self) -> PathLike[str]:
        """Where its file is."""
    @property
    def toml(self) -> str:
        """The text of its file."""
    @property
    def assumptions(self) -> list[str]:
        """What had to be assumed of a tool, medium or interaction that the file defines, a sentence each."""
    @property
    def action(self) -> Literal["absorb", "collect", "skim", "polish", "emit"]: ...
    @property
    def medium(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def strategy(self) -> str:
        """How its strokes are found."""
    @property
    def target_performance(self) -> float:
        """Performance at which its goal is met, 0 to 1."""
    @property
    def tool(self) -> str: ...
    @property
    def tool_footprint(self) -> list[Floats]:
        """Where the tool touches, outer rings (corners, 2) in its own frame [m]."""
    @property
    def tool_mesh(self) -> tuple[Floats, NDArray[np.uint32]]:
        """Vertices (V, 3) in the tool's frame [m], whose origin is in the contact plane with z out of the surface; triangles (T, 3)."""
    @property
    def area_of_effect_m(self) -> list[float]:
        """Depth along and width across its motion [m]."""
    @property
    def collision_radius_m(self) -> float: ...
    @property
    def surface(self) -> str: ...
    @property
    def surface_outline(self) -> Floats:
        """(corners, 2) in the frame of the surface [m]."""
    @property
    def world_from_surface(self) -> Floats:
        """Where the surface is believed to be, (7)."""
    @property
    def particles(self) -> Floats:
        """Where the dirt is believed to lie, (N, 2) in the frame of the surface [m]."""
    @property
    def collect_goal(self) -> Floats | None:
        """Where a collect is to push it, (2) in the frame of the surface [m]; None where that is left to the planner."""
    @property
    def tool_start(self) -> Floats:
        """Where the tool starts, (2) in the frame of the surface [m]."""
    @property
    def press_force_n(self) -> float: ...
    @property
    def stiffness_n_per_m(self) -> float:
        """Of the controller along the surface's normal."""
    @property
    def damping_ratio(self) -> float: ...
    @property
    def compression_depth_m(self) -> float:
        """How deep the tool gives way under the press force."""
    @property
    def contact_speed_m_per_s(self) -> float:
        """Fastest that the tool moves in contact."""
    @property
    def surface_reaction(self) -> Floats:
        """Force of the surface on a tool that is pressed as the task asks, (3) in the axes of the world [N]."""
    @property
    def scene(self) -> list[SceneObject]:
        """What stands round the surface: vertices (V, 3) in the object's own frame [m], triangles (T, 3), pose (7)."""
    def robot(self) -> Robot | None:
        """The robot that the task names, read with what lies beside it; None where it names none."""
    def with_particles(
        self,
        particles: ArrayLike,
        *,
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
        action: str | None = None,
        strategy: str | None = None,
    ) -> Task:
        """The same task with dirt at places (N, 2) in the frame of the surface [m]; options as of ``load_task``."""
    def session(
        self,
        robot: Robot | Path | None = None,
        *,
        world_from_robot: ArrayLike | None = None,
        group: str | None = None,
        rounds: int | None = None,
        target: float | None = None,
        pace: Literal["whole", "greedy"] | None = None,
        end_strokes_early: bool | None = None,
        plan: Plan | Sequence[ArrayLike] | Callable[[Task], Sequence[ArrayLike]] | None = None,
        out: Path | None = None,
        memory: Path | None = None,
    ) -> Session:
        """A session that has not planned yet. It plans for all places where the dirt may lie; ``plan_known_dirt`` plans for the
        one draw of ``particles``, which takes a shorter way and is predicted to do more for that draw.

        ``robot`` follows its plans: a Robot, the name of a shipped one, or a URDF; ``task.robot()`` is the one that the task
        names. ``world_from_robot`` (7) is where it stands, ``group`` its group of joints that wipes, ``rounds`` how many there
        may be, ``target`` the performance at which the goal is met, 0 to 1; each as the task says unless given.

        ``plan`` takes the place of the task's strategy: a Plan or one's own strokes, as for ``plan_of_strokes``, for the first
        round; or a function for every round, which is given a Task whose particles lie where they are estimated to lie by then,
        and returns strokes.

        ``out`` is a folder for what ``wisch run`` leaves: report, figures, plans, trajectories, and a bag (MCAP) of each round,
        written while it is executed. ``memory`` is a folder in which the session is kept as an episode. Both are complete when
        the session has ended, or when ``close()`` is called or a ``with`` block is left.
        """
    def interpret(
        self,
        log: Telemetry | None = None,
        *,
        time_s: ArrayLike | None = None,
        world_from_tool: ArrayLike | None = None,
        force_n: ArrayLike | None = None,
        certain: bool = False,
    ) -> Interpretation:
        """What poses and forces tell: of a log, or of arrays of times (T) [s], poses (T, 7), and forces (T, 3) of the
        surroundings on the tool in the axes of the world [N].

        Of the dirt before, what the task says is believed; ``certain``: that it lies just as the task says.
        """
    def plan_known_dirt(self) -> Plan:
        """A plan for ``particles`` as if they were known to lie just there, as ``wisch eval table1`` makes it.

        ``session().plan()`` plans for all places where the dirt may lie instead: on the table that is a way about twice as long, of
        which less is predicted for this one draw.
        """
    def plan_of_strokes(self, strokes: Sequence[ArrayLike]) -> Plan:
        """The plan that consists of one's own strokes, each (k, 3): x, y [m] and heading [rad] of the tool in the frame of the
        surface, between which it moves straight. Its ``strategy`` is "own".

        Raises WischError where a stroke leads the tool through an object of the scene, over a hole or off the surface.
        """
    def plan_of_json(self, json: str) -> Plan:
        """The plan of the text of a ``plan.json``; its strokes are checked as those of ``plan_of_strokes``."""

class Plan:
    """Strokes in the order in which they are wiped. A notebook shows it as a picture."""
    @property
    def strategy(self) -> str: ...
    @property
    def strokes(self) -> list[Floats]:
        """Each (k, 3): x, y [m] and heading [rad] of the tool in the frame of the surface, between which it moves straight."""
    @property
    def nodes(self) -> Floats:
        """(nodes, 2) in the frame of the surface [m]."""
    @property
    def edges(self) -> list[tuple[int, int]]: ...
    @property
    def contact_distance_m(self) -> float: ...
    @property
    def total_distance_m(self) -> float:
        """Lifted moves included."""
    @property
    def unreachable_share(self) -> float:
        """Share of the particles that no allowed pose of the tool covers, 0 to 1."""
    @property
    def collect_goal(self) -> Floats | None:
        """Where dirt is collected, (2) in the frame of the surface [m]."""
    @property
    def tcp_path(self) -> Floats:
        """Corners of the tool's whole way, (k, 4): x, y [m], heading [rad], height [m]."""
    def predict(self, particles: ArrayLike | None = None) -> Prediction:
        """What it does to the task's particles, or to these (N, 2) [m]."""
    def to_json(self) -> str:
        """The text that the program writes to ``plan.json``."""
    def picture(self, name: Literal["graph", "before-after", "density", "effect-over-time"] = "graph") -> str:
        """A picture of it as SVG."""
    def _repr_svg_(self) -> str: ...

class Prediction:
    """What a plan is predicted to do. A notebook shows it as a picture."""
    @property
    def performance(self) -> float:
        """Share of the particles that meets the goal, 0 to 1."""
    @property
    def initial(self) -> int: ...
    @property
    def achieved(self) -> int: ...
    @property
    def lost(self) -> int:
        """Particles that are over a wrong edge."""
    @property
    def particles(self) -> Floats:
        """Where they are, or went, (N, 2) in the frame of the surface [m]."""
    @property
    def fates(self) -> NDArray[np.int8]:
        """0 on the surface, 1 absorbed, 2 off the surface, (N)."""
    def _repr_svg_(self) -> str: ...

class Robot:
    """A robot: a URDF with the SRDF and the capability map that lie beside it.

    Its methods are for looking and planning; for a loop of control, use ``ImpedanceController``.
    """
    @staticmethod
    def load(urdf: Robot | Path) -> Robot:
        """Read a shipped robot by its name (humanoid, arm7, arm6), or a URDF by its path."""
    @property
    def name(self) -> str: ...
    @property
    def dof(self) -> int:
        """n, the number of joints that move by themselves."""
    @property
    def joints(self) -> list[str]:
        """Their names, in the order of every array of positions."""
    @property
    def links(self) -> list[str]: ...
    @property
    def urdf(self) -> str: ...
    @property
    def srdf(self) -> str | None: ...
    @property
    def limits(self) -> dict[str, JointLimits]:
        """By joint; None where there is no limit [rad or m, per s, per s², Nm or N]."""
    def pose(self, q: ArrayLike, link: str) -> Floats:
        """Pose of a link in the frame of the root link (7) at positions q (n) [rad or m]."""
    def jacobian(self, q: ArrayLike, link: str, point_in_link: ArrayLike | None = None) -> Floats:
        """How a point (3) [m] of a link moves, (6, n): linear [m/s] then angular [rad/s], in the axes of the root link."""
    def mass_matrix(self, q: ArrayLike) -> Floats:
        """(n, n) [kg m², kg m or kg]."""
    def gravity(self, q: ArrayLike) -> Floats:
        """Efforts that hold it still, (n) [Nm or N]."""
    def bias(self, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Efforts at no acceleration: Coriolis, centrifugal, weight, (n) [Nm or N]."""
    def inverse_dynamics(self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Floats:
        """Efforts for accelerations qdd (n) [rad/s² or m/s²], (n) [Nm or N]."""

class Motion:
    """A motion that is to be executed, laid out every 10 ms, between which it may be taken as linear.

    The tool's path lies on the believed surface: pressing is the executor's part, with no more than ``press_force_n``.
    """
    @property
    def round(self) -> int:
        """From 1."""
    @property
    def seed(self) -> int:
        """For what is random in a simulated world."""
    @property
    def robot(self) -> str: ...
    @property
    def joints(self) -> list[str]: ...
    @property
    def tool(self) -> str: ...
    @property
    def world_from_surface(self) -> Floats:
        """As believed, (7)."""
    @property
    def world_from_root(self) -> Floats:
        """Where the robot's root link stands, (7)."""
    @property
    def tip(self) -> str:
        """Name of the link that holds the tool."""
    @property
    def tip_from_tool(self) -> Floats:
        """(7)."""
    @property
    def press_force_n(self) -> float:
        """At which the controller's force is to be saturated."""
    @property
    def stiffness_n_per_m(self) -> float:
        """Along the surface's normal."""
    @property
    def damping_ratio(self) -> float: ...
    @property
    def compression_depth_m(self) -> float: ...
    @property
    def gap_m(self) -> float | None:
        """How high a tool hovers instead of touching; None for one that touches."""
    @property
    def duration_s(self) -> float: ...
    @property
    def contact_time_s(self) -> float: ...
    @property
    def abandoned(self) -> list[int]:
        """Nodes of the plan that no way leads to."""
    @property
    def strokes(self) -> list[Floats]:
        """The strokes as the robot wipes them, each (k, 3) as of ``Plan.strokes``."""
    @property
    def particles(self) -> Floats:
        """Where the dirt is believed to lie, (N, 2) in the frame of the surface [m]."""
    @property
    def phases(self) -> list[Phase]: ...
    @property
    def time_s(self) -> Floats:
        """(T)."""
    @property
    def positions(self) -> Floats:
        """(T, n) [rad or m]."""
    @property
    def velocities(self) -> Floats:
        """(T, n) [rad/s or m/s]."""
    @property
    def world_from_tool(self) -> Floats:
        """(T, 7)."""
    @property
    def stroke(self) -> NDArray[np.int64]:
        """The stroke that is wiped, -1 where the tool does not touch, (T)."""
    def setpoints(self, period_s: float) -> Setpoints:
        """The same columns at another period [s]."""

class Sink:
    """Takes samples in while a motion is executed; False says that the motion is to be broken off."""
    def __call__(self, sample: Mapping[str, Any] | None = None, /, **keys: Any) -> bool:
        """Hand one sample on: ``time_s`` [s], ``world_from_tool`` (7), ``force_n`` (3) and, where measured, ``positions``,
        ``velocities``, ``efforts`` (n), ``moment_nm`` (3), ``world_from_commanded`` (7), ``controller_force_n`` (3),
        ``controller_moment_nm`` (3), ``trajectory_time_s`` [s] (of the setpoint that the controller is at). Raises WischError that names the sample and the value."""
    def many(self, samples: Mapping[str, ArrayLike] | None = None, /, **keys: ArrayLike) -> bool:
        """Hand many on: the same keys, with a row per sample."""

class Session:
    """A task from its first plan to its last verdict, stage by stage. A notebook shows its rounds as a table.

    What takes long runs without Python's lock. Ctrl-C is heard in every stage; the stage goes on by itself to its end, and the
    session can go on from there. ``on_event`` is called with what happens as a dict, as ``wisch run --events`` writes it; if it
    returns False, the session stops. An executor is called on the caller's thread; ``timeout`` [s] gives it up when there is
    no sample, or ``observe`` does not return, for so long.
    """
    def plan(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Plan:
        """Plan the round at hand, if it is not planned; an executor that can look is asked before the first."""
    def follow(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Motion:
        """Go on to the joint motion of the plan."""
    def audit(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Audit:
        """Go on to the check of the motion."""
    def run(self, executor: Executor, *, on_event: OnEvent | None = None, timeout: float | None = None) -> list[Round]:
        """Go on to the end; the rounds. What an executor raises comes out, when what was felt until then is interpreted."""
    def run_round(self, executor: Executor, *, on_event: OnEvent | None = None, timeout: float | None = None) -> list[Round]:
        """Go on until one more round is judged, or to the end; the rounds so far."""
    @property
    def rounds(self) -> list[Round]:
        """Those that are over, one that was broken off included."""
    @property
    def telemetry(self) -> list[Telemetry]:
        """What was measured, motion by motion, that of one which went wrong included."""
    @property
    def stage(self) -> Literal["planned", "followed", "audited", "executed", "interpreted", "judged", "ended"] | None: ...
    @property
    def verdict(self) -> str | None:
        """Why the session has ended; None before, and if it was stopped."""
    @property
    def first_look(self) -> Floats | None:
        """What was seen before the first round, (k, 2) in the frame of the surface [m]."""
    @property
    def episode(self) -> str | None:
        """The name of the episode in which the session is kept; None without ``memory``, and before the session has ended."""
    @property
    def remarks(self) -> list[str]:
        """What is odd about what was kept, a sentence each."""
    def close(self) -> None:
        """Write what is kept of a session that has not ended; one without ``out`` and ``memory`` has nothing to write."""
    def __enter__(self) -> Session: ...
    def __exit__(self, *error: object) -> None: ...
    def _repr_html_(self) -> str: ...

class Audit:
    """What an independent check says of a motion; true if that is sound."""
    @property
    def faults(self) -> list[str]:
        """What is wrong, in words."""
    @property
    def min_clearance_m(self) -> float:
        """Smallest distance of bodies that must not touch, at most 0.5 m."""
    @property
    def line_deviation_m(self) -> float:
        """How far the tool leaves its lines at most."""
    @property
    def line_deviation_rad(self) -> float: ...
    def __bool__(self) -> bool: ...

class Round:
    """One round that is over."""
    @property
    def number(self) -> int:
        """From 1."""
    @property
    def plan(self) -> Plan: ...
    @property
    def prediction(self) -> Prediction: ...
    @property
    def motion(self) -> Motion: ...
    @property
    def audit(self) -> Audit: ...
    @property
    def telemetry(self) -> Telemetry | None: ...
    @property
    def interpretation(self) -> Interpretation: ...
    @property
    def performance(self) -> float:
        """Expected, 0 to 1."""
    @property
    def interval(self) -> tuple[float, float]:
        """Its 90 % interval."""
    @property
    def duration_s(self) -> float: ...
    @property
    def ending(self) -> Literal["complete", "stopped", "ended early", "protective stop"]: ...
    @property
    def verdict(self) -> str: ...
    def _repr_svg_(self) -> str: ...

class Telemetry:
    """What was measured, one array per quantity; the arrays own what Rust recorded, nothing is copied."""
    @property
    def round(self) -> int:
        """From 1; 0 of a log that does not say."""
    @property
    def time_s(self) -> Floats:
        """(T)."""
    @property
    def stroke(self) -> NDArray[np.int64]:
        """The stroke that was wiped, -1 where none was, (T)."""
    @property
    def world_from_tool(self) -> Floats:
        """(T, 7)."""
    @property
    def world_from_commanded(self) -> Floats:
        """(T, 7)."""
    @property
    def force_n(self) -> Floats:
        """Of the surroundings on the tool, in the axes of the world, (T, 3)."""
    @property
    def moment_nm(self) -> Floats:
        """About the tool centre point, (T, 3)."""
    @property
    def controller_force_n(self) -> Floats:
        """What the controller asked of the tool, (T, 3)."""
    @property
    def controller_moment_nm(self) -> Floats:
        """(T, 3)."""
    @property
    def positions(self) -> Floats:
        """(T, n), or (T, 0) where they were not measured [rad or m]."""
    @property
    def velocities(self) -> Floats:
        """(T, n), or (T, 0) [rad/s or m/s]."""
    @property
    def efforts(self) -> Floats:
        """(T, n), or (T, 0) [Nm or N]."""
    def __len__(self) -> int: ...

class Interpretation:
    """What a log of poses and forces says of contact, surface and dirt."""
    @property
    def performance(self) -> float:
        """Expected, 0 to 1."""
    @property
    def interval(self) -> tuple[float, float]:
        """Its 90 % interval."""
    @property
    def performance_by_touch(self) -> float:
        """By touch alone, before anything was seen."""
    @property
    def diagnosis(self) -> Literal["localized", "relocalize", "no contact", "hovering"]: ...
    @property
    def world_from_surface(self) -> Floats:
        """Where the surface is, (7): where it was felt, if that is elsewhere than believed."""
    @property
    def contact_share(self) -> float:
        """Time in contact over time on or near the surface, 0 to 1."""
    @property
    def doubts(self) -> list[str]:
        """Why the log does not look like wiping of this surface, in words."""
    @property
    def events(self) -> list[WipingEvent]: ...
    @property
    def weights(self) -> Floats:
        """How probable each member of the belief is, (members)."""
    def particles(self, seed: int = 0) -> Floats:
        """Where the dirt may lie now: one draw from what is believed, (N, 2) in the frame of the surface [m]."""
    def next_plan(self) -> Plan:
        """A plan for what is left to do."""

class ImpedanceController:
    """The whole-body impedance controller (8) along a motion, with the observer of the external force; for a loop of 1 kHz.

    ``motion`` is one that a session made in this process. ``period_s`` is that of the loop, ``tool_mass_kg`` what the tool
    weighs. Joints that the controller does not drive, such as those of a mobile base, are to be held at the planned positions.
    """
    def __init__(
        self,
        motion: Motion,
        *,
        period_s: float = 1e-3,
        tool_mass_kg: float = 0.15,
        lateral_stiffness_n_per_m: float | None = None,
        rotational_stiffness_nm_per_rad: float | None = None,
        moment_limit_nm: float | None = None,
        press_margin: float | None = None,
        observer_gain_per_s: float | None = None,
    ) -> None: ...
    @property
    def joints(self) -> list[str]:
        """Names of the joints that it drives, in the order of its efforts."""
    @property
    def compliant(self) -> list[int]:
        """Their indices among the robot's joints."""
    def command(self, time_s: float, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Efforts (k) [Nm or N], within their limits, at a time of the motion, from all n measured positions and velocities.

        The observer takes it that the efforts of the call before were given for one period since.
        """
    @property
    def planned(self) -> tuple[Floats, Floats, Floats]:
        """All n joints as planned for the last command: positions, velocities, accelerations."""
    @property
    def world_from_tool(self) -> Floats:
        """By forward kinematics, (7)."""
    @property
    def world_from_commanded(self) -> Floats:
        """The press into the surface included, (7)."""
    @property
    def controller_wrench(self) -> Floats:
        """What it asks of the tool: force [N] and moment [Nm] in the axes of the world, (6)."""
    @property
    def external_wrench(self) -> Floats:
        """What the surroundings do to the tool, as observed, (6)."""

class EffectField:
    """Particles on a surface, and the one model of what a tool does to them.

    ``particles`` (N, 2), ``outline`` (corners, 2) of the surface, and ``footprint`` (corners, 2) of the tool in its own frame [m].
    """
    def __init__(
        self,
        particles: ArrayLike,
        outline: ArrayLike,
        footprint: ArrayLike,
        effect: Literal["push", "absorb", "treat"] = "push",
    ) -> None: ...
    @staticmethod
    def of_task(task: Task) -> EffectField:
        """The particles, surface, tool and action of a task."""
    def apply(self, poses: ArrayLike) -> Effect:
        """Move the tool in contact through poses (k, 3): x, y [m] and heading [rad]; how many particles it met how."""
    @property
    def particles(self) -> Floats:
        """Where they are, or went, (N, 2) [m]."""
    @property
    def fates(self) -> NDArray[np.int8]:
        """0 on the surface, 1 absorbed, 2 off the surface, (N)."""

class Memory:
    """The episodes of a folder, which is made where there is none."""
    def __init__(self, folder: Path = "episodes") -> None: ...
    @property
    def folder(self) -> PathLike[str]: ...
    @property
    def episodes(self) -> list[str]: ...
    def ask(self, query: str) -> list[dict[str, Any]]:
        """The answers to a query in Prolog, such as ``low_performance(Action, P)``: a dict for each, from the names of its
        variables to values. ``wisch ask --list`` lists what queries may call. Needs SWI-Prolog or wisch-prolog."""
    def remember(self, session: Session) -> str:
        """Keep the rounds of a session that are over as an episode; its name."""
    def telemetry(self, episode: str, round: int = 1, columns: Sequence[str] | None = None) -> dict[str, Floats]:
        """Columns of an episode's telemetry by name, ``time_s`` and all others or these, (T) each."""

class WipingWorlds:
    """What ``wisch.gym`` is made of."""
    def __init__(
        self,
        task: Task,
        count: int,
        *,
        particles: int,
        rows: int,
        columns: int,
        max_strokes: int,
        target: float,
        cost_per_m: float,
    ) -> None: ...
    def reset(self, seeds: Sequence[int | None]) -> tuple[NDArray[np.float32], NDArray[np.float32]]: ...
    def step(
        self, actions: ArrayLike
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], Floats, NDArray[np.bool_], NDArray[np.bool_], Floats]: ...
    def particles(self, world: int) -> Floats: ...
    @property
    def performance(self) -> Floats: ...
    @property
    def reach(self) -> Floats: ...

def load_task(
    path: Path,
    *,
    set: Mapping[str, Any] | None = None,
    seed: int | None = None,
    action: str | None = None,
    strategy: str | None = None,
    knowledge: Path | None = None,
) -> Task:
    """Read a task file, or a shipped scenario by its name, with all that it refers to.

    ``set`` lays values over the file's: dotted keys such as ``{"particles.count": 80, "tool.name": "brush"}``, lists and dicts
    included. ``action``, ``strategy`` and ``seed`` are those of the command line; ``knowledge`` is a folder with tools, media,
    surfaces and interactions in place of what is shipped.

    Raises WischError: a file that cannot be read or is refused, with line, column, value and limit.
    """

def read_log(
    path: Path,
    *,
    pose_topic: str | None = None,
    wrench_topic: str | None = None,
    columns: Mapping[str, str] | None = None,
    wrench_frame: Literal["world", "log", "tool", "surface"] | None = None,
    wrench_sign: Literal["on-tool", "by-tool"] | None = None,
    force_bias_n: Sequence[float] | None = None,
    force_scale: float | None = None,
    payload_mass_kg: float | None = None,
    payload_centre_m: Sequence[float] | None = None,
    orientation: Literal["quaternion", "rotation-vector", "rpy", "abc", "matrix"] | None = None,
    rate_hz: float | None = None,
    force_unit_n: float | None = None,
    length_unit_m: float | None = None,
    time_unit_s: float | None = None,
    pose_frame: str | None = None,
    world_from_log: ArrayLike | None = None,
    world_from_surface: ArrayLike | None = None,
    pose_offset: ArrayLike | None = None,
    max_gap_s: float = 0.1,
) -> Telemetry:
    """Read a log: a ROS 2 bag (MCAP), a folder with the parts of one, or a table: text with a line of names, Parquet,
    Arrow or npz.

    Options are those of ``wisch interpret``; poses are (7).
    """

def task_of_keys(
    keys: Mapping[str, Any],
    particles: ArrayLike | None = None,
    *,
    path: Path | None = None,
    set: Mapping[str, Any] | None = None,
    seed: int | None = None,
    action: str | None = None,
    strategy: str | None = None,
    knowledge: Path | None = None,
) -> Task: ...
def run_program(args: Sequence[str]) -> int: ...
