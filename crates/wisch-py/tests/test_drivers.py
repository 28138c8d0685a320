"""The drivers for real arms, with fakes that speak the interfaces of ``ur_rtde`` and ``franky``, in simulated time.

They need no robot, neither package, and not the compiled part of wisch. From the source alone::

    python3 -m pytest --noconftest crates/wisch-py/tests/test_drivers.py
"""

import io
import json
import sys
import types
from datetime import timedelta
from pathlib import Path

import numpy as np
import pytest

try:
    import wisch
except ImportError:  # the source, without the compiled part
    wisch = types.ModuleType("wisch")
    wisch.__path__ = [str(Path(__file__).parents[1] / "python" / "wisch")]
    sys.modules["wisch"] = wisch

from wisch import executor
from wisch._errors import WischError
from wisch.drivers import Franky, UrRtde, _poses
from wisch.drivers._trajectory import Trajectory

#: Height of the believed surface, and of a lifted tool [m].
SURFACE_Z, LIFTED_Z = 0.2, 0.25
#: Period of the loops [s].
PERIOD_S = 0.008
UR_JOINTS = [f"left_{name}" for name in UrRtde.JOINTS]
FRANKA_JOINTS = [f"fr3_joint{number}" for number in range(1, 8)]


class FakeMotion:
    """A motion of a gantry: the first three joints are the position of the tool [m], the others keep still.

    It lowers the tool twice, and wipes two strokes of 0.1 m along x. It is at rest wherever a phase begins.
    """

    def __init__(self, joints, press_force_n=10.0):
        self.joints, self.press_force_n, self.stiffness_n_per_m = list(joints), press_force_n, 500.0
        self.gap_m, self.damping_ratio, self.round, self.seed = None, 0.7, 1, 1
        self.world_from_surface = np.array([0.0, 0.0, SURFACE_Z, 0.0, 0.0, 0.0, 1.0])
        self.world_from_root = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
        self.phases = []
        rows = [self._row([0.0, 0.1, 0.3])]
        time = 0.0
        for phase, end, duration in [
            ("transfer", [0.0, 0.1, LIFTED_Z], 0.4),
            ("lower", [0.0, 0.1, SURFACE_Z], 0.5),
            ("wipe", [0.1, 0.1, SURFACE_Z], 0.6),
            ("lift", [0.1, 0.1, LIFTED_Z], 0.5),
            ("lifted", [0.1, 0.2, LIFTED_Z], 0.6),
            ("lower", [0.1, 0.2, SURFACE_Z], 0.5),
            ("wipe", [0.0, 0.2, SURFACE_Z], 0.6),
            ("lift", [0.0, 0.2, LIFTED_Z], 0.5),
            ("transfer", [0.0, 0.1, 0.3], 0.6),
        ]:
            rows += self._rows(rows[-1][0][:3], end, duration)
            self.phases.append({"phase": phase, "start_s": time, "end_s": time + duration})
            time += duration
        self.time_s = 0.01 * np.arange(len(rows))
        self.duration_s = self.time_s[-1]
        self.positions, self.velocities, self.accelerations = (np.array(column) for column in zip(*rows))
        upright = np.tile([0.0, 0.0, 0.0, 1.0], (len(rows), 1))
        self.world_from_tool = np.hstack([self.positions[:, :3], upright])

    def _row(self, position, velocity=(0, 0, 0), acceleration=(0, 0, 0)):
        rest = [0.0] * (len(self.joints) - 3)
        return [*position, *rest], [*velocity, *rest], [*acceleration, *rest]

    def _rows(self, start, end, duration):
        """Points every 10 ms of a motion from rest to rest, without the first."""
        start, way = np.array(start), np.array(end) - np.array(start)
        for s in np.arange(1, round(duration / 0.01) + 1) / round(duration / 0.01):
            share = 10 * s**3 - 15 * s**4 + 6 * s**5
            rate = (30 * s**2 - 60 * s**3 + 30 * s**4) / duration
            bend = (60 * s - 180 * s**2 + 120 * s**3) / duration**2
            yield self._row(start + share * way, rate * way, bend * way)


class Clock:
    def __init__(self):
        self.now = 0.0

    def __call__(self):
        return self.now

    def sleep(self, seconds):
        self.now += max(seconds, 1e-4)


class Rig:
    """A fake arm, the faults that happen to it, and the commands that it receives."""

    def __init__(self, motion):
        self.clock, self.motion = Clock(), motion
        self.q, self.target = motion.positions[0].copy(), motion.positions[0].copy()
        self.velocities = np.zeros(len(self.q))
        #: Height of the true surface, stiffness of the tool on it [N/m], and offset of the force sensor [N].
        self.true_z, self.contact_n_per_m = SURFACE_Z, 2000.0
        self.sensor_n = np.array([3.0, -2.0, 6.0])
        self.press_n = 0.0
        self.commands, self.events, self.samples = [], [], []
        self.is_frozen = False

    def log(self, name, *arguments):
        self.commands.append((name, arguments, self.clock()))
        return True

    def named(self, name):
        return [command for command in self.commands if command[0] == name]

    def at(self, time, event):
        """Let an event happen at a time of the clock [s]."""
        self.events.append((time, event))

    def step(self):
        """Let a period pass: the arm follows its target."""
        self.clock.now += PERIOD_S
        before = self.q.copy()
        self.q = self.target.copy()
        if self.press_n:  # force mode or impedance control, which reach the surface
            self.q[2] = self.true_z
        self.velocities = (self.q - before) / PERIOD_S
        due = [event for time, event in self.events if self.clock() >= time]
        self.events = [(time, event) for time, event in self.events if self.clock() < time]
        for event in due:
            event()

    def reaction(self):
        """Force of the surface on the tool, in the axes of the world [N]."""
        depth = max(0.0, self.true_z - self.q[2])
        return np.array([0.0, 0.0, self.press_n or self.contact_n_per_m * depth])

    def sink(self, sample):
        self.samples.append(sample)
        return True

    def run(self, driver, sink=None):
        return driver.execute(self.motion, sink or self.sink)

    def kind(self, result):
        """Kind of the stop that ended a motion."""
        return result["ending"]["stop"]["kind"]


class UrRig(Rig):
    """An arm behind the interfaces of ``ur_rtde``. Its base frame is turned by half a turn about z."""

    HOLDS = ("servoStop", "forceModeStop", "stopScript", "disconnect")
    name = "ur"

    def __init__(self):
        super().__init__(FakeMotion(UR_JOINTS))
        self.safety_mode, self.robot_mode, self.scaling, self.runs, self.is_connected = 1, 7, 1.0, True, True
        self.zero_n, self.raises = np.zeros(3), None
        self.reupload = True
        self.force_mode = None
        rig = self

        class Control:
            def __getattr__(self, name):
                return lambda *arguments: rig.control(name, *arguments)

            def initPeriod(self):
                return timedelta(seconds=rig.clock())

            def waitPeriod(self, begun):
                assert isinstance(begun, timedelta)
                rig.step()

        class Receive:
            getActualQ = staticmethod(lambda: rig.q.tolist())
            getActualQd = staticmethod(lambda: rig.velocities.tolist())
            getActualTCPPose = staticmethod(lambda: [-rig.q[0], -rig.q[1], rig.q[2], 0.0, 0.0, np.pi])
            getActualTCPForce = staticmethod(lambda: [*rig.force_in_base(), 0.0, 0.0, 0.0])
            getTimestamp = staticmethod(lambda: rig.timestamp())
            getSafetyMode = staticmethod(lambda: rig.safety_mode)
            getRobotMode = staticmethod(lambda: rig.robot_mode)
            getSpeedScalingCombined = staticmethod(lambda: rig.scaling)
            isConnected = staticmethod(lambda: rig.is_connected)
            isProtectiveStopped = staticmethod(lambda: rig.safety_mode == 3)
            isEmergencyStopped = staticmethod(lambda: rig.safety_mode in (6, 7))
            disconnect = staticmethod(lambda: rig.log("disconnect receive"))

        self.interfaces = Control(), Receive()

    def driver(self, **parameters):
        control, receive = self.interfaces
        given = {"clock": self.clock, "sleep": self.clock.sleep, "tool_speed_m_s": 0.5, **parameters}
        return UrRtde(control=control, receive=receive, **given)

    def timestamp(self):
        if not self.is_frozen:
            self.stamp = self.clock()
        return self.stamp

    def force_in_base(self):
        return (self.reaction() * [-1, -1, 1] + self.sensor_n - self.zero_n).tolist()

    def control(self, name, *arguments):
        if name == "isProgramRunning":
            return self.runs
        if self.raises and name == "servoJ":
            raise self.raises
        self.log(name, *arguments)
        if name == "reuploadScript":
            self.runs = self.reupload
            return self.runs
        if name == "servoJ":
            assert len(arguments) == 6 and 0.03 <= arguments[4] <= 0.2 and 100 <= arguments[5] <= 2000
            self.target = np.array(arguments[0])
        elif name == "zeroFtSensor":
            self.zero_n = self.sensor_n + self.reaction()
        elif name == "forceMode":
            self.force_mode, self.press_n = arguments, -arguments[2][2]
        elif name == "forceModeStop":
            self.force_mode, self.press_n = None, 0.0
        elif name == "servoStop":
            self.target = self.q.copy()
        elif name == "stopScript":
            self.runs = False
        return name in self.KNOWN or pytest.fail(f"the interface has no {name}")

    KNOWN = (
        "servoJ servoStop forceMode forceModeStop zeroFtSensor setPayload setWatchdog kickWatchdog stopScript disconnect"
    ).split()

    def set(self, **values):
        self.__dict__.update(values)

    # The same faults on both arms.
    def protective_stop(self):
        self.safety_mode = 3

    def emergency_stop(self):
        self.safety_mode = 7

    def fail(self):
        self.raises = OSError("the socket is closed")

    def pressing_commands(self):
        return [time for name, _, time in self.commands if name == "forceMode"]


class FrankaRig(Rig):
    """An arm behind ``franky``."""

    HOLDS = ("TorqueStopMotion", "join_motion", "stop")
    name = "franka"

    def __init__(self):
        super().__init__(FakeMotion(FRANKA_JOINTS))
        self.mode, self.errors, self.controls, self.raises = "Idle", [], False, None
        self.stamp = 0.0
        rig = self

        class Affine:
            def __init__(self, translation, quaternion):
                self.translation, self.quaternion = np.array(translation), np.array(quaternion)

        class Tracker:
            def __init__(self, robot, **settings):
                assert robot is rig.robot
                rig.controls, rig.mode, rig.tracker = True, "Move", self
                self.settings = settings
                rig.press_n = 0.0
                rig.log(type(self).__name__, settings)

        class JointImpedanceTracker(Tracker):
            def set_target(self, q, dq=None, tau_ff=None):
                rig.command(self)
                rig.log("set_target", q, dq)
                rig.target = np.array(q)

        class CartesianImpedanceTracker(Tracker):
            def set_target(self, pose, twist=None, acceleration=None):
                rig.command(self)
                rig.log("set_target", pose, twist)
                rig.target[:3] = pose.translation
                rig.target[2] = max(rig.target[2], rig.true_z)
                stiffness, clip = self.settings["gains"].stiffness[2, 2], self.settings["translational_error_clip"][2]
                rig.press_n = stiffness * min(max(rig.true_z - pose.translation[2], 0.0), clip)

        self.module = types.SimpleNamespace(
            Affine=Affine,
            Twist=lambda linear_velocity: np.array(linear_velocity),
            CartesianImpedanceGains=types.SimpleNamespace,
            PostureTask=lambda target, stiffness: (np.array(target), stiffness),
            JointImpedanceTracker=JointImpedanceTracker,
            CartesianImpedanceTracker=CartesianImpedanceTracker,
            TorqueStopMotion=lambda: "TorqueStopMotion",
        )

        class Robot:
            @property
            def state(self):
                errors = types.SimpleNamespace(**{name: True for name in rig.errors}, power_limit_violation=False)
                if not rig.is_frozen:
                    rig.stamp = rig.clock()
                stamp = rig.stamp
                return types.SimpleNamespace(
                    q=rig.q.copy(),
                    dq=rig.velocities.copy(),
                    O_T_EE=Affine(rig.q[:3], [0.0, 0.0, 0.0, 1.0]),
                    O_F_ext_hat_K=np.append(-(rig.reaction() + rig.sensor_n), np.zeros(3)),
                    robot_mode=types.SimpleNamespace(name=rig.mode),
                    current_errors=errors,
                    time=types.SimpleNamespace(to_sec=lambda: stamp),
                )

            has_errors = property(lambda self: bool(rig.errors))
            is_in_control = property(lambda self: rig.controls)

            def poll_motion(self):
                if rig.raises:
                    rig.controls = False
                    raise rig.raises
                return rig.controls

            def move(self, motion, asynchronous=False):
                assert motion == "TorqueStopMotion" and asynchronous
                rig.stop()
                return rig.log(motion)

            def join_motion(self, timeout=None):
                return rig.log("join_motion")

            def stop(self):
                rig.stop()
                rig.log("stop")

            def set_load(self, mass, centre, inertia):
                rig.log("set_load", mass, centre, inertia)

            def recover_from_errors(self):
                rig.mode, rig.errors = "Idle", []
                return rig.log("recover_from_errors")

        self.robot = Robot()

    def driver(self, **parameters):
        def sleep(seconds):
            self.step() if self.controls else self.clock.sleep(seconds)

        given = {"clock": self.clock, "sleep": sleep, "tool_speed_m_s": 0.5, **parameters}
        return Franky(robot=self.robot, franky=self.module, **given)

    def command(self, tracker):
        assert tracker is self.tracker, "the tracker has been replaced"
        assert self.controls, "nothing is in control"

    def stop(self):
        self.controls, self.press_n, self.target = False, 0.0, self.q.copy()
        self.mode = "Idle" if self.mode == "Move" else self.mode

    def protective_stop(self):
        self.mode, self.errors, self.controls = "Reflex", ["cartesian_reflex"], False

    def emergency_stop(self):
        self.mode, self.controls = "Other", False

    def fail(self):
        self.raises = RuntimeError("communication_constraints_violation")

    def pressing_commands(self):
        return [time for name, _, time in self.commands if name == "CartesianImpedanceTracker"]


@pytest.fixture(params=[UrRig, FrankaRig], ids=lambda rig: rig.name)
def rig(request):
    return request.param()


def holds(rig):
    """Return whether the last setpoint is followed by commands that bring the arm to rest, and by nothing else."""
    names = [name for name, _, _ in rig.commands]
    last = max(k for k, name in enumerate(names) if name not in rig.HOLDS)
    return last + 1 < len(names) and not np.any(rig.target - rig.q) and not getattr(rig, "controls", False)


def test_a_motion_is_followed_to_its_end(rig):
    driver = rig.driver()
    result = rig.run(driver)
    assert result["ending"] == "complete", result
    np.testing.assert_allclose(result["positions"], rig.motion.positions[-1], atol=1e-6)
    times = np.array([sample["time_s"] for sample in rig.samples])
    on_path = np.array([sample["trajectory_time_s"] for sample in rig.samples])
    assert (np.diff(times) > 0).all() and (np.diff(on_path) >= 0).all()
    assert on_path[-1] == pytest.approx(rig.motion.duration_s) and result["duration_s"] == times[-1]
    path = Trajectory(rig.motion, driver.root_from_base)
    for sample in rig.samples:
        np.testing.assert_allclose(sample["world_from_tool"][:3], path.tool(sample["trajectory_time_s"])[:3], atol=1e-3)
        assert sample["wrench_axes"] == "world"
    assert holds(rig)


def test_force_is_on_in_wipe_phases_only(rig):
    rig.run(rig.driver())
    assert len(rig.pressing_commands()) == 2, "one switch for each stroke"
    path = Trajectory(rig.motion, np.array([0, 0, 0, 0, 0, 0, 1.0]))
    in_contact = {"wipe": [], "other": []}
    for sample in rig.samples:
        # A switch shows in the sample after it.
        if any(abs(sample["trajectory_time_s"] - phase[end]) < 0.02 for phase in rig.motion.phases for end in ("start_s", "end_s")):
            continue
        is_wipe = path.phase(sample["trajectory_time_s"])["phase"] == "wipe"
        in_contact["wipe" if is_wipe else "other"].append((sample["trajectory_time_s"], sample["force_n"]))
    np.testing.assert_allclose([force for _, force in in_contact["wipe"]], [[0, 0, 10.0]] * len(in_contact["wipe"]), atol=1e-6)
    after_tare = [force for time, force in in_contact["other"] if time > 0.45]
    np.testing.assert_allclose(after_tare, np.zeros((len(after_tare), 3)), atol=1e-6)


def test_the_force_is_tared_once_lifted_and_at_rest(rig):
    driver = rig.driver()
    taking = {}

    def tare(force_n):
        taking.update(z=rig.q[2], speed=np.abs(rig.velocities).max(), presses=len(rig.pressing_commands()))
        type(driver)._tare(driver, force_n)

    driver._tare = tare
    rig.run(driver)
    assert taking == {"z": pytest.approx(LIFTED_Z), "speed": pytest.approx(0.0), "presses": 0}
    assert driver.is_tared


def test_a_motion_that_begins_in_contact_is_not_tared(rig):
    rig.motion.phases = [{"phase": "lift", "start_s": 0.0, "end_s": rig.motion.duration_s}]
    driver = rig.driver()
    assert rig.run(driver)["ending"] == "complete"
    assert not driver.is_tared and not rig.named("zeroFtSensor") and not rig.pressing_commands()


def test_a_force_that_taring_does_not_remove_ends_the_motion(rig):
    driver = rig.driver()
    driver._tare = lambda force_n: None
    result = rig.run(driver)
    assert rig.kind(result) == "tolerance" and "7.0 N right after taring, more than 3 N" in result["ending"]["stop"]["reason"]
    assert holds(rig)


def test_the_sink_stops_the_motion_within_a_period(rig):
    stopped_at = []

    def sink(sample):
        rig.sink(sample)
        if len(rig.samples) == 50:
            stopped_at.append((rig.clock(), len(rig.commands)))
        return len(rig.samples) < 50

    result = rig.run(rig.driver(), sink)
    assert result["ending"] == "stopped" and len(rig.samples) == 50
    [(time, count)] = stopped_at
    assert {name for name, _, _ in rig.commands[count:]} <= set(rig.HOLDS)
    assert all(when - time <= PERIOD_S for _, _, when in rig.commands[count:])
    assert holds(rig)


#: A time on the clock in the first stroke, after the wait for the tare [s].
IN_STROKE_S = 1.9

FAULTS = [
    ("protective_stop", lambda rig: rig.protective_stop(), "protective_stop"),
    ("emergency_stop", lambda rig: rig.emergency_stop(), "emergency_stop"),
    ("exception", lambda rig: rig.fail(), "link_lost"),
    ("stale", lambda rig: setattr(rig, "is_frozen", True), "link_lost"),
    ("overload", lambda rig: setattr(rig, "sensor_n", rig.sensor_n + [40.0, 0.0, 0.0]), "overload"),
    ("not a number", lambda rig: setattr(rig, "sensor_n", rig.sensor_n * np.nan), "overload"),
    ("no surface", lambda rig: setattr(rig, "true_z", SURFACE_Z - 0.03), "tolerance"),
]


@pytest.mark.parametrize("time", [1.3, IN_STROKE_S], ids=["lowering", "wiping"])
@pytest.mark.parametrize(("name", "fault", "kind"), FAULTS, ids=[name for name, _, _ in FAULTS])
def test_a_fault_holds_within_a_tenth_of_a_second_and_is_named(rig, name, fault, kind, time):
    happened = []
    rig.at(time, lambda: (fault(rig), happened.append(rig.clock())))
    result = rig.run(rig.driver())
    stop = result["ending"]["stop"]
    assert stop["kind"] == kind, stop
    assert stop["reason"] and stop["time_s"] == rig.samples[-1]["time_s"] == result["duration_s"]
    moves = [when for command, _, when in rig.commands if command in ("servoJ", "set_target")]
    if name != "no surface":
        assert max(moves) <= happened[0] + 0.1 + 2 * PERIOD_S
    assert holds(rig)


def test_an_exception_of_the_sink_holds_and_is_raised(rig):
    def sink(sample):
        rig.sink(sample)
        if len(rig.samples) == 50:
            raise BrokenPipeError("wisch has ended")
        return True

    with pytest.raises(BrokenPipeError):
        rig.run(rig.driver(), sink)
    assert holds(rig)


def test_no_command_follows_a_stop_until_the_next_motion(rig):
    rig.at(IN_STROKE_S, rig.protective_stop)
    driver = rig.driver()
    rig.run(driver)
    count = len(rig.commands)
    for _ in range(100):
        rig.step()
    driver.state()
    assert len(rig.commands) == count
    with pytest.raises(WischError, match="the robot is not ready: .*(protective-stopped|reflex)"):
        rig.run(driver)
    assert len(rig.commands) == count, "a refusal commands nothing"


REFUSALS = [
    (lambda rig: rig.q.__setitem__(1, 0.15), {}, r"(shoulder_lift_joint|joint2) is 0.050 rad from the start .* start_rad = 0.02 rad"),
    (lambda rig: rig.velocities.__setitem__(0, 0.05), {}, "moves at 0.050 rad/s; a motion begins at rest, below 0.02"),
    (lambda rig: rig.motion.time_s.__setitem__(5, rig.motion.time_s[4]), {}, "the times of the motion's points do not increase"),
    (lambda rig: None, {"force_limit_n": 8.0}, r"presses with 10 N, more than force_limit_n = 8 N"),
    (lambda rig: None, {"tool_speed_m_s": 0.1}, r"moves at 0.35 m/s, faster than tool_speed_m_s = 0.1 m/s"),
    (lambda rig: rig.motion.joints.pop(), {}, "the motion moves .*; expected joints whose names end in .*, in this order"),
    (lambda rig: rig.motion.joints.reverse(), {}, "the motion moves .*; expected joints whose names end in"),
    (lambda rig: rig.protective_stop(), {}, "the robot is not ready"),
    (lambda rig: rig.emergency_stop(), {}, "the robot is not ready"),
    (lambda rig: setattr(rig.motion, "world_from_root", np.array([0, 0, 0.5, 0, 0, 0, 1.0])), {}, "tool is 0.500 m and 0.00 rad"),
    (lambda rig: (rig.interfaces[1].getTimestamp() if rig.name == "ur" else 0, setattr(rig, "is_frozen", True)), {}, "no new state"),
]


@pytest.mark.parametrize(("change", "parameters", "message"), REFUSALS, ids=[message[:24] for _, _, message in REFUSALS])
def test_what_is_refused_before_a_motion_commands_nothing(rig, change, parameters, message):
    driver = rig.driver(**parameters)
    change(rig)
    with pytest.raises(WischError, match=message):
        rig.run(driver)
    assert rig.commands == [] and rig.samples == []


def test_a_lower_speed_slows_the_trajectory(rig):
    result = rig.run(rig.driver(speed=0.5))
    assert result["ending"] == "complete"
    assert result["duration_s"] > 2 * rig.motion.duration_s
    for speed in (0, 1.5):
        with pytest.raises(WischError, match=rf"speed = {speed} is outside its limits: above 0 and at most 1"):
            rig.driver(speed=speed)


def test_an_early_touch_ends_the_lowering(rig):
    rig.true_z = SURFACE_Z + 0.01
    result = rig.run(rig.driver(force_limit_n=15.0))
    assert result["ending"] == "complete", result
    assert max(np.linalg.norm(sample["force_n"]) for sample in rig.samples if sample["trajectory_time_s"] > 0.5) < 15.0


def test_a_start_within_its_tolerance_does_not_jump(rig):
    rig.q[1] += 0.015
    rig.target = rig.q.copy()
    assert rig.run(rig.driver())["ending"] == "complete"
    ways = np.diff([sample["positions"][1] for sample in rig.samples[:100]])
    assert np.abs(ways).max() < 0.001


def test_a_hovering_tool_is_not_pressed(rig):
    rig.motion.gap_m, rig.true_z = 0.01, SURFACE_Z - 0.01
    assert rig.run(rig.driver(force_limit_n=5.0))["ending"] == "complete"
    assert rig.pressing_commands() == []


def test_a_missing_package_is_named(rig, monkeypatch):
    for module in ("rtde_receive", "franky"):
        monkeypatch.setitem(sys.modules, module, None)
    driver, package, extra = (UrRtde, "ur_rtde", "ur") if rig.name == "ur" else (Franky, "franky-control", "franka")
    with pytest.raises(ImportError, match=rf"pip install {package}, or pip install wisch\[{extra}\]"):
        driver("192.168.1.10")


def test_at_30_percent_the_trajectory_time_is_scaled():
    rig = UrRig()
    rig.scaling = 0.3
    assert rig.run(rig.driver())["ending"] == "complete"
    first, last = rig.samples[0], rig.samples[100]
    assert last["trajectory_time_s"] / (last["time_s"] - first["time_s"]) == pytest.approx(0.3, rel=0.05)


def test_a_speed_scaling_of_0_is_refused_and_ends_a_motion():
    rig = UrRig()
    rig.scaling = 0.0
    with pytest.raises(WischError, match="speed scaling is 0"):
        rig.run(rig.driver())
    assert not rig.named("servoJ")
    rig = UrRig()
    rig.at(IN_STROKE_S, lambda: rig.set(scaling=0.0))
    rig.at(IN_STROKE_S + 1.0, lambda: rig.set(scaling=1.0))
    result = rig.run(rig.driver())
    assert rig.kind(result) == "operator" and holds(rig)
    assert max(time for _, _, time in rig.named("servoJ")) < IN_STROKE_S + 2 * PERIOD_S, "nothing resumes"


@pytest.mark.parametrize(
    ("values", "kind"),
    [
        ({"safety_mode": 2}, "operator"),
        ({"safety_mode": 5}, "operator"),
        ({"safety_mode": 8}, "emergency_stop"),
        ({"safety_mode": 12}, "operator"),
        ({"robot_mode": 5}, "operator"),
        ({"runs": False}, "operator"),
        ({"is_connected": False}, "link_lost"),
    ],
)
def test_modes_of_the_ur_controller_end_a_motion(values, kind):
    rig = UrRig()
    rig.at(IN_STROKE_S, lambda: rig.set(**values))
    assert rig.kind(rig.run(rig.driver())) == kind
    assert holds(rig)


def test_force_mode_of_the_ur_pushes_along_the_normal():
    rig = UrRig()
    rig.run(rig.driver(tool_mass_kg=0.4, tool_centre_m=(0, 0, 0.05)))
    frame, selection, wrench, kind, limits = rig.named("forceMode")[0][1]
    np.testing.assert_allclose(np.abs(frame), [0, 0, SURFACE_Z, 0, 0, np.pi], atol=1e-9)
    assert (selection, wrench, kind) == ([0, 0, 1, 0, 0, 0], [0, 0, -10.0, 0, 0, 0], 2)
    assert limits[2] == 0.03 and len(limits) == 6
    assert rig.named("setPayload")[0][1] == (0.4, [0, 0, 0.05])
    names = [name for name, _, _ in rig.commands if name not in ("servoJ", "kickWatchdog")]
    stroke = ["forceMode", "servoStop", "forceModeStop"]
    assert names == ["setPayload", "setWatchdog", "zeroFtSensor", *stroke, *stroke, "servoStop", "stopScript"]


def test_a_second_motion_of_the_ur_uploads_the_program_again():
    rig = UrRig()
    driver = rig.driver()
    assert rig.run(driver)["ending"] == rig.run(driver)["ending"] == "complete"
    assert len(rig.named("reuploadScript")) == 1 and len(rig.named("zeroFtSensor")) == 2
    rig.reupload = False
    with pytest.raises(WischError, match="is it in remote control"):
        rig.run(driver)
    driver.close()
    assert [name for name, _, _ in rig.commands][-2:] == ["disconnect", "disconnect receive"]


def test_a_command_that_the_ur_refuses_ends_the_motion():
    rig = UrRig()
    refused = rig.control
    rig.control = lambda name, *rest: name != "forceMode" and refused(name, *rest)
    result = rig.run(rig.driver())
    assert rig.kind(result) == "link_lost" and "refused forceMode" in result["ending"]["stop"]["reason"]
    assert [name for name, _, _ in rig.commands][-3:] == ["servoStop", "forceModeStop", "stopScript"]


def test_the_impedance_setpoint_of_the_franka_lies_in_the_surface():
    rig = FrankaRig()
    rig.run(rig.driver(tool_mass_kg=0.4))
    settings = rig.named("CartesianImpedanceTracker")[0][1][0]
    np.testing.assert_allclose(settings["gains"].stiffness, np.diag([1500.0, 1500.0, 500.0, 50.0, 50.0, 50.0]))
    np.testing.assert_allclose(settings["translational_error_clip"], 30.0 / 500.0)
    poses = [pose for _, (pose, _), _ in rig.named("set_target") if hasattr(pose, "translation")]
    np.testing.assert_allclose([pose.translation[2] for pose in poses], SURFACE_Z - 10.0 / 500.0, atol=1e-6)
    assert rig.named("set_load")[0][1] == (0.4, [0, 0, 0], [0.0] * 9)


@pytest.mark.parametrize("height_m", [-0.005, 0.0, 0.012])
def test_the_franka_presses_with_the_press_force_on_a_surface_that_is_not_where_believed(height_m):
    rig = FrankaRig()
    rig.true_z = SURFACE_Z + height_m
    assert rig.run(rig.driver())["ending"] == "complete"
    path = Trajectory(rig.motion, np.array([0, 0, 0, 0, 0, 0, 1.0]))
    wiping = [s["force_n"][2] for s in rig.samples if 0.1 < s["trajectory_time_s"] - path.phases[2]["start_s"] < 0.5]
    # The setpoint reaches 22 mm below the believed surface: on a lower one, the spring is shorter.
    np.testing.assert_allclose(wiping, min(10.0, 500.0 * (0.022 + height_m)), atol=1e-6)


def test_the_reflex_of_the_franka_is_named_and_cleared_by_the_operator_only():
    rig = FrankaRig()
    rig.at(IN_STROKE_S, rig.protective_stop)
    driver = rig.driver()
    assert "cartesian_reflex" in rig.run(driver)["ending"]["stop"]["reason"]
    assert not rig.named("recover_from_errors")
    assert driver.recover() and driver.state()["positions"].shape == (7,)


def test_a_served_driver_limits_its_silence_and_reports_its_state(rig, monkeypatch):
    streams = io.StringIO('{"hello": {}}\n"state"\n'), io.StringIO()
    monkeypatch.setattr(sys, "stdin", streams[0])
    monkeypatch.setattr(sys, "stdout", streams[1])
    executor.serve(rig.driver())
    ready, state = (json.loads(line) for line in streams[1].getvalue().splitlines())
    able = {"reports_state": True, "prepares": True, "pauses": True, "real_time": True, "stamp_clock": "device"}
    assert ready == {"ready": {"version": 2, "max_silence_s": 5.0, **able}}
    assert state["state"]["positions"] == rig.q.tolist() and len(state["state"]["velocities"]) == len(rig.q)


class PausingSink:
    """A sink whose operator wants a pause in an interval of the clock."""

    def __init__(self, rig, start, end):
        self.rig, self.start, self.end, self.told = rig, start, end, []

    def __call__(self, sample):
        return self.rig.sink(sample)

    @property
    def wants_pause(self):
        return self.start <= self.rig.clock() < self.end

    def pause(self, time_s, reason):
        self.told.append(("pause", time_s, reason))

    def resume(self, time_s):
        self.told.append(("resume", time_s))


def test_an_operator_pauses_a_motion_smoothly_and_lets_it_continue(rig):
    sink = PausingSink(rig, 0.2, 2.2)
    assert rig.run(rig.driver(), sink)["ending"] == "complete"
    (pause, begin, reason), (resume, end) = sink.told
    assert (pause, reason, resume) == ("pause", "the operator", "resume")
    assert 0.2 < begin < 0.9 and end == pytest.approx(2.2, abs=3 * PERIOD_S)
    paused = [s for s in rig.samples if begin < s["time_s"] < end]
    assert len({s["trajectory_time_s"] for s in paused}) == 1 and len(paused) > 100
    speeds = np.array([np.abs(s["velocities"]).max() for s in rig.samples if s["time_s"] < 3])
    assert np.abs(np.diff(speeds)).max() < 0.05, "it does not jerk"


def test_a_robot_that_is_moved_in_a_pause_does_not_continue(rig):
    sink = PausingSink(rig, 0.2, 2.2)

    def push():
        rig.q, rig.target = rig.q + 0.1, rig.target + 0.1
        rig.step = lambda: setattr(rig.clock, "now", rig.clock.now + PERIOD_S)

    rig.at(1.5, push)
    result = rig.run(rig.driver(lag_m=1.0), sink)
    assert rig.kind(result) == "operator" and "the paused robot has moved by 0.100 rad" in result["ending"]["stop"]["reason"]
    assert [told[0] for told in sink.told] == ["pause"]
    assert holds(rig)


def test_samples_state_the_clock_of_the_robot_and_whether_the_force_is_tared(rig):
    driver = rig.driver()
    rig.run(driver)
    qualities = [sample["wrench_quality"] for sample in rig.samples]
    assert qualities[0] == "untared" and qualities[-1] == "ok" and set(qualities) == {"untared", "ok"}
    stamps = np.array([sample["stamp_ns"] for sample in rig.samples])
    assert (np.diff(stamps) > 0).all() and driver.stamp_clock == "device"
    rig.samples.clear()
    rig.at(rig.clock() + 0.1, lambda: setattr(rig, "is_frozen", True))
    rig.run(driver)
    assert "stale" in [sample["wrench_quality"] for sample in rig.samples]


def test_a_robot_is_prepared_only_if_it_is_the_expected_one_and_ready(rig):
    driver = rig.driver()
    robot = types.SimpleNamespace(joints=rig.motion.joints)
    driver.prepare(robot)
    driver.prepare(None)
    with pytest.raises(WischError, match="expected joints whose names end in"):
        driver.prepare(types.SimpleNamespace(joints=rig.motion.joints[1:]))
    rig.protective_stop()
    with pytest.raises(WischError, match="the robot is not ready"):
        driver.prepare(robot)
    assert rig.commands == [], "nothing is commanded"


def test_a_robot_is_handed_back_or_what_keeps_it_is_named(rig):
    driver = rig.driver()
    rig.run(driver)
    driver.finish()
    begin = rig.clock()
    rig.velocities = rig.velocities + 0.5
    with pytest.raises(WischError, match="not handed back: it moves at 0.500 rad/s after 1.5 s"):
        driver.finish()
    rig.velocities = rig.velocities * 0
    driver._hold = lambda: None
    rig.runs, rig.controls = True, True
    with pytest.raises(WischError, match="not handed back: the driver's (program on the robot|control loop) runs"):
        driver.finish()
    assert rig.clock() - begin < 4, "wisch does not wait for long"


def test_poses_and_rotation_vectors_agree():
    rng = np.random.default_rng(1)
    for _ in range(50):
        a, b = (np.concatenate([rng.normal(size=3), q / np.linalg.norm(q)]) for q in rng.normal(size=(2, 4)))
        same = _poses.compose(_poses.invert(a), _poses.compose(a, b))
        np.testing.assert_allclose(same, b, atol=1e-12)
        back = _poses.from_rotation_vector(_poses.to_rotation_vector(a))
        np.testing.assert_allclose(back[:3], a[:3], atol=1e-9)
        np.testing.assert_allclose(back[3:], a[3:] * np.sign(a[6]), atol=1e-9)
        assert _poses.turn_between(a[3:], -a[3:]) == pytest.approx(0.0, abs=1e-6)
    np.testing.assert_allclose(_poses.rotate([0, 0, np.sqrt(0.5), np.sqrt(0.5)], np.array([1.0, 0, 0])), [0, 1, 0], atol=1e-12)


def test_setpoints_between_points_are_those_of_the_motion():
    path = Trajectory(FakeMotion(UR_JOINTS), np.array([0, 0, 0, 0, 0, 0, 1.0]))
    # Within a phase, the fake motion is itself a polynomial of fifth degree.
    for time in (0.123, 1.177, 3.456):
        early, late = path.setpoint(time - 1e-5)[0], path.setpoint(time + 1e-5)[0]
        np.testing.assert_allclose((late - early) / 2e-5, path.setpoint(time)[1], atol=1e-7)
    s, way = 0.123 / 0.4, -0.05
    assert path.setpoint(0.123)[0][2] == pytest.approx(0.3 + way * (10 * s**3 - 15 * s**4 + 6 * s**5), abs=1e-12)
