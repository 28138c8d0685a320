"""Driver for arms of Universal Robots with a force sensor, through the package ``ur_rtde``."""

from __future__ import annotations

import sys

import numpy as np

from .._errors import WischError
from ._arm import Arm, Reading, import_driver_package
from ._poses import from_rotation_vector, to_rotation_vector

#: Robot mode and safety mode in which the arm may move.
RUNNING, NORMAL = 7, 1
#: Safety modes other than NORMAL, with the kind of stop that each is.
SAFETY_MODES = {
    2: ("operator", "REDUCED"),
    3: ("protective_stop", "PROTECTIVE_STOP"),
    4: ("operator", "RECOVERY"),
    5: ("operator", "SAFEGUARD_STOP"),
    6: ("emergency_stop", "SYSTEM_EMERGENCY_STOP"),
    7: ("emergency_stop", "ROBOT_EMERGENCY_STOP"),
    8: ("emergency_stop", "VIOLATION"),
    9: ("emergency_stop", "FAULT"),
    15: ("emergency_stop", "IMMI_EMERGENCY_STOP"),
    20: ("emergency_stop", "PROFISAFE_EMERGENCY_STOP"),
}
#: The robot stops its program if it hears less than this from the driver during a motion [Hz].
WATCHDOG_HZ = 2.0
#: How long the robot's program may take to run [s].
READY_TIMEOUT_S = 3.0
#: Lookahead [s] and gain of servoJ, and deceleration of servoStop [rad/s²].
LOOKAHEAD_S, GAIN, DECELERATION = 0.05, 300.0, 10.0
#: Force mode: the frame is used as given, and is compliant along its z axis only.
FRAME_AS_GIVEN, ALONG_NORMAL = 2, [0, 0, 1, 0, 0, 0]
#: Greatest deviation from the path that force mode permits across the normal [m], [rad].
DEVIATION_M, DEVIATION_RAD = 0.05, 0.3


class UrRtde(Arm):
    """Executor of motions on an arm of Universal Robots (e-Series or later), with servoJ and force mode.

    ``host`` is the address of the robot. ``control`` and ``receive`` replace the interfaces of ``ur_rtde``, for a test or
    for one that is connected already. ``tool_mass_kg`` [kg] and ``tool_centre_m`` [m] (3, in the frame of the flange) set the
    payload. ``press_speed_m_s`` [m/s] limits the speed along the normal in force mode. ``Arm`` documents the other parameters.

    The controller's frame ``base`` is turned by half a turn about z against the root link of ``ur_description``, which is the
    default of ``root_from_base``. The controller's TCP must be the tool frame of the task. Forces are those of the robot's
    sensor, in the axes of ``base``; samples state them in the axes of the world.
    """

    JOINTS = ("shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint")

    def __init__(
        self,
        host: str = "",
        *,
        control=None,
        receive=None,
        tool_mass_kg: float | None = None,
        tool_centre_m=(0.0, 0.0, 0.0),
        press_speed_m_s: float = 0.03,
        root_from_base=(0, 0, 0, 0, 0, 1, 0),
        **parameters,
    ) -> None:
        super().__init__(root_from_base=root_from_base, **parameters)
        self.tool_mass_kg, self.tool_centre_m = tool_mass_kg, [float(x) for x in tool_centre_m]
        self.press_speed_m_s = press_speed_m_s
        self._receive = receive or self._connect("rtde_receive", "RTDEReceiveInterface", host)
        self._control = control or self._connect("rtde_control", "RTDEControlInterface", host, 1.0 / self.period_s)
        self._is_force_mode = False

    @staticmethod
    def _connect(module: str, interface: str, *arguments):
        """Return an interface of ``ur_rtde``, connected to the robot."""
        return getattr(import_driver_package(module, "ur_rtde", "ur"), interface)(*arguments)

    def close(self) -> None:
        """Hold, end the driver's program on the robot, and disconnect."""
        self._hold()
        self._control.disconnect()
        self._receive.disconnect()

    def _read(self) -> Reading:
        return Reading(
            positions=np.array(self._receive.getActualQ()),
            velocities=np.array(self._receive.getActualQd()),
            base_from_tool=from_rotation_vector(self._receive.getActualTCPPose()),
            force_n=np.array(self._receive.getActualTCPForce()[:3]),
            clock_s=self._receive.getTimestamp(),
        )

    def _fault(self, moving: bool = False) -> tuple[str, str] | None:
        receive = self._receive
        if not receive.isConnected():
            return "link_lost", "the connection to the robot is lost"
        if receive.isEmergencyStopped():
            return "emergency_stop", "the robot is emergency-stopped"
        if receive.isProtectiveStopped():
            return "protective_stop", "the robot is protective-stopped"
        if (safety := receive.getSafetyMode()) != NORMAL:
            kind, name = SAFETY_MODES.get(safety, ("operator", f"number {safety}"))
            return kind, f"the safety mode is {name}, not NORMAL"
        if (mode := receive.getRobotMode()) != RUNNING:
            return "operator", f"the robot mode is {mode}, not {RUNNING} (RUNNING)"
        return self._fault_of_program() if moving else None

    def _fault_of_program(self) -> tuple[str, str] | None:
        """Return what ended or paused the driver's program on the robot; None if it runs."""
        if not self._control.isProgramRunning():
            return "operator", "the driver's program on the robot has ended"
        if not self._scaling() > 0:
            return "operator", "the speed scaling is 0: the program is paused, or the speed slider is at 0"
        return None

    def _describe_control(self) -> str:
        return "the driver's program on the robot runs" if self._control.isProgramRunning() else ""

    def _scaling(self) -> float:
        return self._receive.getSpeedScalingCombined()

    def _begin(self, path) -> None:
        control = self._control
        if not control.isProgramRunning() and not control.reuploadScript():
            raise WischError("the robot does not take the driver's program; is it in remote control?")
        begin = self._clock()
        while fault := self._fault_of_program():
            if self._clock() - begin > READY_TIMEOUT_S:
                raise WischError(f"the robot is not ready: {fault[1]}")
            self._sleep(self.period_s)
        if self.tool_mass_kg is not None:
            self._demand("setPayload", self.tool_mass_kg, self.tool_centre_m)
        self._demand("setWatchdog", WATCHDOG_HZ)

    def _tare(self, force_n) -> None:
        self._demand("zeroFtSensor")

    def _start_pressing(self, path, positions) -> None:
        frame = to_rotation_vector(path.base_from_surface).tolist()
        wrench = [0.0, 0.0, -path.press_force_n, 0.0, 0.0, 0.0]
        limits = [DEVIATION_M, DEVIATION_M, self.press_speed_m_s, DEVIATION_RAD, DEVIATION_RAD, DEVIATION_RAD]
        self._is_force_mode = True
        self._demand("forceMode", frame, ALONG_NORMAL, wrench, FRAME_AS_GIVEN, limits)

    def _stop_pressing(self, path) -> None:
        # Servoing ends first: two threads of the robot's program must not move it at once.
        self._demand("servoStop", DECELERATION)
        self._demand("forceModeStop")
        self._is_force_mode = False

    def _command(self, path, time_s, positions, velocities) -> None:
        # Speed and acceleration are arguments that servoJ does not use.
        self._demand("servoJ", positions.tolist(), 0.0, 0.0, self.period_s, LOOKAHEAD_S, GAIN)
        self._demand("kickWatchdog")

    def _demand(self, name: str, *arguments) -> None:
        """Call a method of the control interface; raise RuntimeError if the robot refuses it."""
        if not getattr(self._control, name)(*arguments):
            raise RuntimeError(f"the robot has refused {name}")

    def _begin_period(self):
        return self._control.initPeriod()

    def _end_period(self, begun) -> None:
        self._control.waitPeriod(begun)

    def _hold(self) -> None:
        holds = [lambda: self._control.servoStop(DECELERATION)]
        if self._is_force_mode:
            holds.append(self._control.forceModeStop)
        for hold in (*holds, self._control.stopScript):
            try:
                hold()
            except Exception as error:  # every other hold is still tried
                print(f"{type(error).__name__} while holding: {error}", file=sys.stderr)
        self._is_force_mode = False
