"""Classes and functions in Rust, which ``wisch`` re-exports.

Units are SI and radians. A pose (7) is x, y, z [m] and a unit quaternion x, y, z, w in the frame of the world; n is the number
of the robot's joints, T the number of times or samples.
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
    accelerations: Floats
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
    """Executor of motions; see ``wisch.executor.Executor``."""
    def execute(self, motion: Motion, sink: Sink) -> Mapping[str, Any] | None: ...

class Task:
    """A wiping task: surface, dirt, tool, action and goal."""
    @property
    def name(self) -> str:
        """Name of the task."""
    @property
    def path(self) -> PathLike[str]:
        """Path of its file."""
    @property
    def toml(self) -> str:
        """Text of its file."""
    @property
    def assumptions(self) -> list[str]:
        """Assumptions about a tool, medium or interaction that the file defines, a sentence each."""
    @property
    def action(self) -> Literal["absorb", "collect", "skim", "polish", "dispense"]:
        """The wiping action."""
    @property
    def medium(self) -> str:
        """Name of the medium."""
    @property
    def seed(self) -> int:
        """Random seed."""
    @property
    def strategy(self) -> str:
        """Name of its planning strategy."""
    @property
    def target_performance(self) -> float:
        """Performance at which its goal is met, 0 to 1."""
    @property
    def tool(self) -> str:
        """Name of the tool."""
    @property
    def tool_footprint(self) -> list[Floats]:
        """Footprint of the tool: outer rings (corners, 2) in its own frame [m]."""
    @property
    def tool_mesh(self) -> tuple[Floats, NDArray[np.uint32]]:
        """Vertices (V, 3) in the tool's frame [m], whose origin is in the contact plane with z out of the surface; triangles (T, 3)."""
    @property
    def area_of_effect_m(self) -> list[float]:
        """Depth along and width across the tool's motion [m]."""
    @property
    def collision_radius_m(self) -> float:
        """Radius of the collision sphere around the tool."""
    @property
    def surface(self) -> str:
        """Name of the surface."""
    @property
    def surface_outline(self) -> Floats:
        """Outline of the surface, (corners, 2) in its frame [m]."""
    @property
    def world_from_surface(self) -> Floats:
        """Believed pose of the surface, (7)."""
    @property
    def surface_shape(self) -> dict[str, Any] | None:
        """Shape of a curved surface; None for a plane. ``kind`` "cylinder" has ``radius_m`` and ``axis_rad``; ``kind`` "cone"
        has ``half_angle_rad`` too; ``kind`` "mesh" has ``points_m`` (n x 3, surface frame), ``places_m`` (n, 2; chart) and
        ``triangles`` (m x 3)."""
    @property
    def particles(self) -> Floats:
        """Believed positions of the dirt, (N, 2) in the frame of the surface [m]."""
    @property
    def collect_goal(self) -> Floats | None:
        """Goal of a collect, (2) in the frame of the surface [m]; None if the planner chooses it."""
    @property
    def tool_start(self) -> Floats:
        """Start of the tool, (2) in the frame of the surface [m]."""
    @property
    def press_force_n(self) -> float:
        """Force with which the tool is to press; 0 for a tool that hovers."""
    @property
    def stiffness_n_per_m(self) -> float:
        """Stiffness of the controller along the surface's normal."""
    @property
    def damping_ratio(self) -> float:
        """Damping ratio of the controller."""
    @property
    def compression_depth_m(self) -> float:
        """Compression of the tool under the press force."""
    @property
    def contact_speed_m_per_s(self) -> float:
        """Largest speed of the tool in contact."""
    @property
    def surface_reaction(self) -> Floats:
        """Force of the surface on a tool with the nominal press force, (3) in the axes of the world [N]; of a curved
        surface, at the origin of its chart."""
    @property
    def scene(self) -> list[SceneObject]:
        """Objects around the surface: vertices (V, 3) in the object's own frame [m], triangles (T, 3), pose (7)."""
    def robot(self) -> Robot | None:
        """Load the robot that the task names, with its SRDF and capability map; None if the task names no robot."""
    def with_particles(
        self,
        particles: ArrayLike,
        *,
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
        action: str | None = None,
        strategy: str | None = None,
    ) -> Task:
        """Return the same task with dirt at positions (N, 2) in the frame of the surface [m]; options as in ``load_task``."""
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
        """Create a session, which has not planned yet. It plans for the whole belief about the dirt; ``plan_known_dirt`` plans
        for the single draw ``particles``, with a shorter path and a better prediction for that draw.

        ``robot`` executes the plans: a Robot, the name of a shipped robot, or a URDF; ``task.robot()`` returns the robot that
        the task names. ``world_from_robot`` (7) is its pose, ``group`` the group of joints that wipes, ``rounds`` the largest
        number of rounds, ``target`` the performance at which the goal is met, 0 to 1. Each defaults to the value of the task.

        ``plan`` replaces the task's strategy. A Plan, or strokes as for ``plan_of_strokes``, replaces it in the first round. A
        function replaces it in every round; it receives a Task whose particles are at their present estimate, and returns
        strokes.

        ``out`` is a folder for the results of ``wisch run``: report, figures, plans, trajectories, and a bag (MCAP) of each
        round, written during its execution. ``memory`` is a folder of a memory that stores the session as an episode. Both are
        complete when the session has ended, when ``close()`` is called, or at the end of a ``with`` block.
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
        """Interpret poses and forces: a log, or arrays of times (T) [s], poses (T, 7), and forces (T, 3) of the surroundings
        on the tool in the axes of the world [N].

        The belief about the dirt before is that of the task. If ``certain``, the dirt lies exactly at the task's particles.
        """
    def plan_known_dirt(self) -> Plan:
        """Plan for ``particles`` as if their positions were certain, as ``wisch eval table1`` does.

        ``session().plan()`` plans for the whole belief about the dirt instead. On the table, that path is about twice as long,
        with a lower prediction for this single draw.
        """
    def plan_of_strokes(self, strokes: Sequence[ArrayLike]) -> Plan:
        """Return the plan of given strokes, each (k, 3): x, y [m] and yaw [rad] of the tool in the frame of the surface,
        between which it moves straight. Its ``strategy`` is "own".

        Raises WischError if a stroke moves the tool through an object of the scene, over a hole or off the surface.
        """
    def plan_of_json(self, json: str) -> Plan:
        """Return the plan of the text of a ``plan.json``; its strokes are checked as in ``plan_of_strokes``."""

class Plan:
    """Strokes in the order of their execution. A notebook shows a plan as a picture."""
    @property
    def strategy(self) -> str:
        """Name of the strategy that planned it."""
    @property
    def strokes(self) -> list[Floats]:
        """Strokes, each (k, 3): x, y [m] and yaw [rad] of the tool in the frame of the surface, between which it moves straight."""
    @property
    def nodes(self) -> Floats:
        """Positions of the nodes, (nodes, 2) in the frame of the surface [m]."""
    @property
    def edges(self) -> list[tuple[int, int]]:
        """Directed edges between nodes, as pairs of their numbers from 0."""
    @property
    def contact_distance_m(self) -> float:
        """Length of the path in contact."""
    @property
    def total_distance_m(self) -> float:
        """Length of the whole path, including free motions."""
    @property
    def unreachable_share(self) -> float:
        """Share of the particles that no allowed pose of the tool covers, 0 to 1."""
    @property
    def collect_goal(self) -> Floats | None:
        """Goal of the collected dirt, (2) in the frame of the surface [m]."""
    @property
    def tcp_path(self) -> Floats:
        """Corners of the tool's whole path, (k, 4): x, y [m], yaw [rad], height [m]."""
    def predict(self, particles: ArrayLike | None = None) -> Prediction:
        """Predict the plan's effect on the task's particles, or on given ones (N, 2) [m]."""
    def to_json(self) -> str:
        """Return the text of the file ``plan.json``."""
    def picture(self, name: Literal["graph", "before-after", "density", "effect-over-time"] = "graph") -> str:
        """Return a picture as SVG."""
    def _repr_svg_(self) -> str: ...

class Prediction:
    """Predicted effect of a plan. A notebook shows it as a picture."""
    @property
    def performance(self) -> float:
        """Share of the particles that meet the goal, 0 to 1."""
    @property
    def initial(self) -> int:
        """Number of particles."""
    @property
    def achieved(self) -> int:
        """Number of particles that meet the goal."""
    @property
    def lost(self) -> int:
        """Number of particles that left the surface over a wrong edge, or whose coat is too thick."""
    @property
    def particles(self) -> Floats:
        """Positions of the particles, or where they left the surface, (N, 2) in the frame of the surface [m]."""
    @property
    def fates(self) -> NDArray[np.int8]:
        """0 on the surface, 1 absorbed, 2 off the surface, (N)."""
    def _repr_svg_(self) -> str: ...

class Robot:
    """A robot: a URDF, with the SRDF and the capability map beside it.

    Its methods are for inspection and planning; for a control loop, use ``ImpedanceController``.
    """
    @staticmethod
    def load(urdf: Robot | Path) -> Robot:
        """Read a shipped robot by its name (humanoid, arm7, arm6), or a URDF by its path."""
    @property
    def name(self) -> str:
        """Name of the robot."""
    @property
    def dof(self) -> int:
        """Number of independent joints, n."""
    @property
    def joints(self) -> list[str]:
        """Names of the independent joints, in the order of every array of positions."""
    @property
    def links(self) -> list[str]:
        """Names of the links."""
    @property
    def urdf(self) -> str:
        """Text of the URDF."""
    @property
    def srdf(self) -> str | None:
        """Text of the SRDF; None without one."""
    @property
    def limits(self) -> dict[str, JointLimits]:
        """Limits by joint; None where there is none [rad or m, per s, per s², Nm or N]."""
    def pose(self, q: ArrayLike, link: str) -> Floats:
        """Pose of a link in the frame of the root link (7) at positions q (n) [rad or m]."""
    def jacobian(self, q: ArrayLike, link: str, point_in_link: ArrayLike | None = None) -> Floats:
        """Jacobian of a point (3) [m] of a link, (6, n): linear [m/s] then angular [rad/s], in the axes of the root link."""
    def mass_matrix(self, q: ArrayLike) -> Floats:
        """Joint-space mass matrix, (n, n) [kg m², kg m or kg]."""
    def gravity(self, q: ArrayLike) -> Floats:
        """Efforts that hold the robot against gravity, (n) [Nm or N]."""
    def bias(self, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Efforts at no acceleration: Coriolis, centrifugal, weight, (n) [Nm or N]."""
    def inverse_dynamics(self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Floats:
        """Efforts for accelerations qdd (n) [rad/s² or m/s²], (n) [Nm or N]."""

class Motion:
    """A joint motion for an executor, sampled every 10 ms and linear in between.

    The tool's path lies on the believed surface: the executor must press, with at most ``press_force_n``.
    """
    @property
    def round(self) -> int:
        """Number of the round, from 1."""
    @property
    def seed(self) -> int:
        """Seed of a simulated world."""
    @property
    def robot(self) -> str:
        """Name of the robot."""
    @property
    def joints(self) -> list[str]:
        """Names of the robot's joints, in the order of all positions."""
    @property
    def tool(self) -> str:
        """Name of the tool."""
    @property
    def world_from_surface(self) -> Floats:
        """Believed pose, (7)."""
    @property
    def surface_shape(self) -> dict[str, Any] | None:
        """Shape of a curved surface; None for a plane. ``kind`` "cylinder" has ``radius_m`` and ``axis_rad``; ``kind`` "cone"
        has ``half_angle_rad`` too; ``kind`` "mesh" has ``points_m`` (n x 3, surface frame), ``places_m`` (n, 2; chart) and
        ``triangles`` (m x 3)."""
    @property
    def world_from_root(self) -> Floats:
        """Pose of the robot's root link, (7)."""
    @property
    def tip(self) -> str:
        """Name of the link that holds the tool."""
    @property
    def tip_from_tool(self) -> Floats:
        """Pose of the tool in the frame of the link ``tip``, (7)."""
    @property
    def press_force_n(self) -> float:
        """Force with which the tool is to press, and which the controller does not exceed; 0 for a tool that hovers."""
    @property
    def stiffness_n_per_m(self) -> float:
        """Stiffness along the surface's normal."""
    @property
    def damping_ratio(self) -> float:
        """Damping ratio of the controller."""
    @property
    def compression_depth_m(self) -> float:
        """Compression of the tool under the press force."""
    @property
    def gap_m(self) -> float | None:
        """Height at which a tool hovers over the surface; None for a tool that touches."""
    @property
    def duration_s(self) -> float:
        """Duration of the motion."""
    @property
    def contact_time_s(self) -> float:
        """Time during which the tool is to touch the surface."""
    @property
    def abandoned(self) -> list[int]:
        """Nodes of the plan that the robot cannot reach."""
    @property
    def strokes(self) -> list[Floats]:
        """Strokes that the robot executes, each (k, 3) as in ``Plan.strokes``."""
    @property
    def particles(self) -> Floats:
        """Believed positions of the dirt, (N, 2) in the frame of the surface [m]."""
    @property
    def phases(self) -> list[Phase]:
        """Phases of the motion."""
    @property
    def time_s(self) -> Floats:
        """Times of the setpoints, (T)."""
    @property
    def positions(self) -> Floats:
        """Joint positions, (T, n) [rad or m]."""
    @property
    def velocities(self) -> Floats:
        """Joint velocities, (T, n) [rad/s or m/s]."""
    @property
    def accelerations(self) -> Floats:
        """Joint accelerations, (T, n) [rad/s² or m/s²]."""
    @property
    def world_from_tool(self) -> Floats:
        """Poses of the tool, (T, 7)."""
    @property
    def stroke(self) -> NDArray[np.int64]:
        """Number of the stroke, -1 where the tool does not touch, (T)."""
    def setpoints(self, period_s: float) -> Setpoints:
        """Return the motion sampled at another period [s]."""

class Sink:
    """Receives samples during the execution of a motion; returns False if the motion must stop."""
    def __call__(self, sample: Mapping[str, Any] | None = None, /, **keys: Any) -> bool:
        """Pass a sample: ``time_s`` [s], ``world_from_tool`` (7), ``force_n`` (3) and, where measured, ``positions``,
        ``velocities``, ``efforts`` (n), ``moment_nm`` (3), ``world_from_commanded`` (7), ``controller_force_n`` (3),
        ``controller_moment_nm`` (3), ``trajectory_time_s`` [s] (time of the controller's present setpoint), and
        ``wrench_axes`` ("world", "tool" or "tip"). Without ``world_from_tool`` the pose is computed from ``positions``. Raises WischError with the time of the sample and the faulty value."""
    def many(self, samples: Mapping[str, ArrayLike] | None = None, /, **keys: ArrayLike) -> bool:
        """Pass many samples: the same keys, with a row per sample."""
    @property
    def wants_pause(self) -> bool:
        """Whether the operator wants the motion to pause; never in a session of this package."""
    def pause(self, time_s: float, reason: str = "") -> None:
        """State that the motion pauses from a time [s] on."""
    def resume(self, time_s: float) -> None:
        """State that the motion continues from a time [s] on."""

class Session:
    """A task from its first plan to its last verdict, stage by stage. A notebook shows its rounds as a table.

    Long computations run without Python's lock. Ctrl-C is raised in every stage; the stage itself runs to its end, and the
    session can continue from there. ``on_event`` is called with every event as a dict, as ``wisch run --events`` writes it; if
    it returns False, the session stops. An executor is called on the caller's thread; if it passes no sample, or its
    ``observe`` does not return, within ``timeout`` [s], the session stops waiting and raises WischError. An executor's own
    ``max_silence_s`` limits the time between samples too.
    """
    def plan(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Plan:
        """Plan the current round, unless it is planned. Before the first plan, ``observe`` of an executor with a camera is called."""
    def follow(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Motion:
        """Continue to the joint motion of the plan."""
    def audit(self, executor: Executor | None = None, *, on_event: OnEvent | None = None) -> Audit:
        """Continue to the check of the motion."""
    def run(self, executor: Executor, *, on_event: OnEvent | None = None, timeout: float | None = None) -> list[Round]:
        """Continue to the end, and return the rounds. An executor's exception is raised after its samples are interpreted."""
    def run_round(self, executor: Executor, *, on_event: OnEvent | None = None, timeout: float | None = None) -> list[Round]:
        """Continue until the next verdict or the end, and return the rounds so far."""
    @property
    def rounds(self) -> list[Round]:
        """Finished rounds, including one that was stopped."""
    @property
    def telemetry(self) -> list[Telemetry]:
        """Telemetry of every motion, including one that failed."""
    @property
    def stage(self) -> Literal["planned", "followed", "audited", "executed", "interpreted", "decided", "ended"] | None:
        """The completed stage; None before the first."""
    @property
    def verdict(self) -> str | None:
        """Why the session has ended; None before its end, or if it was stopped."""
    @property
    def first_observation(self) -> Floats | None:
        """Detections before the first round, (k, 2) in the frame of the surface [m]."""
    @property
    def episode(self) -> str | None:
        """Name of the session's episode; None without ``memory``, and before the session has ended."""
    @property
    def remarks(self) -> list[str]:
        """Remarks on the stored results, a sentence each."""
    def close(self) -> None:
        """Write the results of a session that has not ended; does nothing without ``out`` and ``memory``."""
    def __enter__(self) -> Session: ...
    def __exit__(self, *error: object) -> None: ...
    def _repr_html_(self) -> str: ...

class Audit:
    """Result of an independent check of a motion; true if the motion has no faults."""
    @property
    def faults(self) -> list[str]:
        """Descriptions of the faults."""
    @property
    def min_clearance_m(self) -> float:
        """Smallest distance between bodies that must not touch, at most 0.5 m."""
    @property
    def line_deviation_m(self) -> float:
        """Largest deviation of the tool from its lines."""
    @property
    def line_deviation_rad(self) -> float:
        """Largest rotation of the tool away from its lines."""
    def __bool__(self) -> bool: ...

class Round:
    """A finished round."""
    @property
    def number(self) -> int:
        """Number of the round, from 1."""
    @property
    def plan(self) -> Plan:
        """Plan of the round."""
    @property
    def prediction(self) -> Prediction:
        """Predicted effect of the motion."""
    @property
    def motion(self) -> Motion:
        """Planned motion."""
    @property
    def audit(self) -> Audit:
        """Result of the independent check of the motion."""
    @property
    def telemetry(self) -> Telemetry | None:
        """Telemetry of the motion; None if it was not recorded."""
    @property
    def interpretation(self) -> Interpretation:
        """Interpretation of the measurements."""
    @property
    def performance(self) -> float:
        """Expected performance, 0 to 1."""
    @property
    def interval(self) -> tuple[float, float]:
        """90 % interval of the performance; wider if the log may lack a part of the wiping."""
    @property
    def duration_s(self) -> float:
        """Duration of the executed motion."""
    @property
    def ending(self) -> Literal["complete", "stopped", "ended early", "protective stop"]:
        """How the motion ended."""
    @property
    def ending_cause(self) -> str | None:
        """Reason of an early end or a protective stop."""
    @property
    def pauses(self) -> list[dict[str, Any]]:
        """Pauses of the motion: start_s, end_s (None if the motion ended in it), phase, reason."""
    @property
    def verdict(self) -> str:
        """Verdict after the round."""
    def _repr_svg_(self) -> str: ...

class Telemetry:
    """Telemetry, an array per quantity; the arrays own the data recorded in Rust, without a copy."""
    @property
    def round(self) -> int:
        """Number of the round, from 1; 0 for a log that does not state it."""
    @property
    def time_s(self) -> Floats:
        """Times of the samples since the start of the motion or log, (T)."""
    @property
    def stroke(self) -> NDArray[np.int64]:
        """Number of the stroke, -1 outside strokes, (T)."""
    @property
    def wrench_quality(self) -> NDArray[np.uint8]:
        """Quality of force and moment: 0 ok, 1 stale, 2 saturated, 3 untared, (T)."""
    @property
    def world_from_tool(self) -> Floats:
        """Poses of the tool, (T, 7)."""
    @property
    def world_from_commanded(self) -> Floats:
        """Commanded poses of the tool, (T, 7)."""
    @property
    def force_n(self) -> Floats:
        """Force of the surroundings on the tool, in the axes of the world, (T, 3)."""
    @property
    def moment_nm(self) -> Floats:
        """Moment about the tool centre point, (T, 3)."""
    @property
    def controller_force_n(self) -> Floats:
        """Force that the controller commanded, (T, 3)."""
    @property
    def controller_moment_nm(self) -> Floats:
        """Moment that the controller commanded, about the tool centre point, (T, 3)."""
    @property
    def positions(self) -> Floats:
        """Joint positions, (T, n), or (T, 0) if not measured [rad or m]."""
    @property
    def velocities(self) -> Floats:
        """Joint velocities, (T, n), or (T, 0) [rad/s or m/s]."""
    @property
    def efforts(self) -> Floats:
        """Joint efforts, (T, n), or (T, 0) [Nm or N]."""
    @property
    def remarks(self) -> list[str]:
        """How a log was read: assumptions, transforms, samples that were left out, gaps; a sentence each."""
    @property
    def left_out(self) -> list[int]:
        """Numbers of samples of a log that were left out because their wrench is stale, saturated or untared, or their pose frozen or missing."""
    @property
    def poses_alone(self) -> list[tuple[float, list[float]]]:
        """Times [s] and poses of the tool in the world before the first force and after the last, x, y, z [m] and quaternion x, y, z, w."""
    def __len__(self) -> int: ...

class Interpretation:
    """Estimates of contact, surface and dirt from poses and forces."""
    @property
    def performance(self) -> float:
        """Expected performance, 0 to 1."""
    @property
    def interval(self) -> tuple[float, float]:
        """90 % interval of the performance; wider if the log may lack a part of the wiping."""
    @property
    def performance_by_touch(self) -> float:
        """Expected performance by touch alone, without camera observations, 0 to 1."""
    @property
    def diagnosis(self) -> Literal["localized", "relocalize", "no contact", "unfitted", "hovering"]:
        """How the contacts fit the believed surface."""
    @property
    def world_from_surface(self) -> Floats:
        """Estimated pose of the surface, (7): by touch, if that differs from the believed pose."""
    @property
    def contact_share(self) -> float | None:
        """Time in contact over time on or near the surface, 0 to 1."""
    @property
    def doubts(self) -> list[str]:
        """Reasons why the log may not show wiping of this surface, a sentence each."""
    @property
    def events(self) -> list[WipingEvent]:
        """Detected events."""
    @property
    def weights(self) -> Floats:
        """Probability of each member of the belief, (members)."""
    def particles(self, seed: int = 0) -> Floats:
        """Draw the present positions of the dirt from the belief, (N, 2) in the frame of the surface [m]."""
    def next_plan(self) -> Plan:
        """Plan for the remaining dirt."""

class ImpedanceController:
    """The whole-body impedance controller (8) along a motion, with the observer of the external force; for a loop of 1 kHz.

    ``motion`` is from a session in this process, ``period_s`` the period of the loop, ``tool_mass_kg`` the mass of the tool.
    Joints that the controller does not drive, such as those of a mobile base, must be held at the planned positions.
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

        The observer assumes that the efforts of the previous call were applied for one period.
        """
    @property
    def planned(self) -> tuple[Floats, Floats, Floats]:
        """Planned state of all n joints at the last command: positions, velocities, accelerations."""
    @property
    def world_from_tool(self) -> Floats:
        """Pose of the tool by forward kinematics, (7)."""
    @property
    def world_from_commanded(self) -> Floats:
        """Commanded pose of the tool, including the press into the surface, (7)."""
    @property
    def controller_wrench(self) -> Floats:
        """Commanded wrench on the tool: force [N] and moment [Nm] in the axes of the world, (6)."""
    @property
    def external_wrench(self) -> Floats:
        """Observed wrench of the surroundings on the tool, (6)."""

class EffectField:
    """Particles on a surface, with the effect model of a tool.

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
        """Create the field of a task's particles, surface, tool and action."""
    def apply(self, poses: ArrayLike) -> Effect:
        """Move the tool in contact through poses (k, 3): x, y [m] and yaw [rad]. Returns the numbers of affected particles."""
    @property
    def particles(self) -> Floats:
        """Positions of the particles, or where they left the surface, (N, 2) [m]."""
    @property
    def fates(self) -> NDArray[np.int8]:
        """0 on the surface, 1 absorbed, 2 off the surface, (N)."""

class Memory:
    """Memory of episodes in a folder, created if necessary."""
    def __init__(self, folder: Path = "episodes") -> None: ...
    @property
    def folder(self) -> PathLike[str]:
        """Folder of the memory."""
    @property
    def episodes(self) -> list[str]:
        """Names of the episodes."""
    def ask(self, query: str) -> list[dict[str, Any]]:
        """Answer a query in Prolog, such as ``low_performance(Action, P)``: returns a dict per answer, from the names of
        its variables to values. ``wisch ask --list`` lists the predicates. Needs SWI-Prolog or wisch-prolog."""
    def remember(self, session: Session) -> str:
        """Store the finished rounds of a session as an episode, which begins when the session began, and return its name."""
    def telemetry(self, episode: str, round: int = 1, columns: Sequence[str] | None = None) -> dict[str, Floats]:
        """Return columns of an episode's telemetry by name: ``time_s`` and all columns, or the given ones, (T) each."""

class WipingWorlds:
    """Parallel worlds for ``wisch.gym``."""
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
    def reset(self, seeds: Sequence[int | None]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Begin new episodes in all worlds, and return density (n, rows, columns) and tool (n, 4). A seed starts a new sequence
        of episodes; None continues the old one."""
    def step(
        self, actions: ArrayLike
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], Floats, NDArray[np.bool_], NDArray[np.bool_], Floats]:
        """Execute a stroke in each world, actions (n, 5), and return density, tool, rewards, terminated, truncated and
        performance. A world whose episode is over begins its next one instead."""
    def particles(self, world: int) -> Floats:
        """Return the positions of the particles on the surface of a world, (k, 2) [m]."""
    @property
    def performance(self) -> Floats:
        """Performance of each world, (n), 0 to 1."""
    @property
    def reach(self) -> Floats:
        """Box of the strokes' starts and ends: smallest and largest x, y [m], (2, 2)."""

def load_task(
    path: Path,
    *,
    set: Mapping[str, Any] | None = None,
    seed: int | None = None,
    action: str | None = None,
    strategy: str | None = None,
    knowledge: Path | None = None,
) -> Task:
    """Read a task file, or a shipped scenario by its name, with all files that it refers to.

    ``set`` overrides values of the file by dotted keys such as ``{"particles.count": 80, "tool.name": "brush"}``, including lists
    and dicts. ``action``, ``strategy`` and ``seed`` are as on the command line; ``knowledge`` is a folder with tools, media,
    surfaces and interactions that replaces the shipped one.

    Raises WischError with line, column, value and limit if a file cannot be read or is invalid.
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
