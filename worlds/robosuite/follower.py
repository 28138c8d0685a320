"""Follows a path of planar tool poses on the table through robosuite's OSC controller.

Plans of wisch, zigzags and tours are all followed at the same speed and with the same force.
"""

from dataclasses import dataclass

import numpy as np

SUBSTEPS = 10
"""Steps of the reference in one period of the controller."""
SHARES = (1.0, 0.75, 0.375, 0.09375, 0.0)
"""Shares of the acceleration along the table, tried in turn until the controller accepts the command."""
TAKEN = 0.05
"""Largest position error that the controller accepts in a direction; it cuts off more [m]."""


@dataclass(frozen=True)
class FollowerConfig:
    """Constants of the follower, chosen on seeds from 1000 on."""

    speed: float = 0.1
    """Speed of the tool along its path in contact [m/s]: at higher speeds the table lifts the tool, and markers are left."""
    free_speed: float = 0.22
    """Speed of the tool above the table [m/s]."""
    acceleration: float = 1.0
    """Acceleration at corners [m/s²]."""
    lookahead: float = 0.008
    """Distance on the path at which the reference looks ahead; it cuts corners by as much [m]."""
    turn_speed: float = 2.0
    """Speed of the yaw [rad/s]."""
    force: float = 25.0
    """Normal force while wiping [N]."""
    force_gain: float = 0.2
    """Share of the force error that is corrected in one period [1]."""
    tilt_gain: float = 0.15
    """Share of the tilt error that is corrected in one period [1]."""
    turn_margin: float = 0.4
    """Distance of the last joint from its limits [rad]."""
    turn_stiffness: float = 400.0
    """Gain on the tool's rotation [1/s²]."""
    lean: float = 0.003
    """Angle by which the tool leans forward at full speed [rad], so that its leading side presses first."""
    landing_speed: float = 0.035
    """Speed at which the tool meets the table [m/s]."""
    braking: float = 0.6
    """Acceleration of the tool as it comes down [m/s²]."""
    singular: float = 0.3
    """Position error above which the arm counts as near a singular posture [m]: in other postures it is at most 0.29."""
    heaviest: tuple = (3000.0, 1000.0, 300.0, 100.0, 30.0)
    """Limits of the effective mass at the tool, tried in turn: near a singular posture, directions above it are dropped [kg]."""


def wrapped(angle):
    """Returns an angle of a tool with symmetry under half a turn, within ±π/2 [rad]."""
    return (angle + np.pi / 2) % np.pi - np.pi / 2


def rotation_error(rotation, yaw):
    """Returns axis times angle, in the world, that turns the tool flat onto the table with its broad side at `yaw` [rad]."""
    x_axis = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    if x_axis @ rotation[:, 0] < 0.0:
        x_axis = -x_axis
    desired = np.column_stack([x_axis, np.cross([0.0, 0.0, 1.0], x_axis), [0.0, 0.0, 1.0]])
    error = desired @ rotation.T
    axis = np.array([error[2, 1] - error[1, 2], error[0, 2] - error[2, 0], error[1, 0] - error[0, 1]]) / 2.0
    sine, cosine = np.linalg.norm(axis), (np.trace(error) - 1.0) / 2.0
    return axis if sine < 1e-9 else axis / sine * np.arctan2(sine, cosine)


class Reference:
    """A point that moves along a polyline of poses (n, 3) as fast as speed and acceleration allow, and cuts corners a little."""

    def __init__(self, path, velocity, config):
        path = np.asarray(path, dtype=float)
        steps = np.linalg.norm(np.diff(path[:, :2], axis=0), axis=1)
        self.path = path[np.concatenate([[True], steps > 1e-6])]
        steps = steps[steps > 1e-6]
        self.stations = np.concatenate([[0.0], np.cumsum(steps)])
        self.end = path[-1]
        self.config = config
        self.position, self.velocity = path[0, :2].copy(), np.array(velocity, dtype=float)
        self.acceleration = np.zeros(2)
        self.yaw = path[0, 2]
        self.station = 0.0

    @property
    def arrived(self):
        """Whether the end is reached."""
        far = np.linalg.norm(self.end[:2] - self.position)
        return far < 0.002 and abs(self.end[2] - self.yaw) < 0.02

    def _pose_at(self, station):
        if len(self.stations) == 1 or station >= self.stations[-1]:
            return self.end
        index = int(np.searchsorted(self.stations, station, side="right")) - 1
        share = (station - self.stations[index]) / (self.stations[index + 1] - self.stations[index])
        begin, end = self.path[index], self.path[index + 1]
        return begin + share * (end - begin)

    def advance(self, period, most):
        """Advances by one period of the controller, at most at a given speed [m/s]."""
        config, step = self.config, period / SUBSTEPS
        before = self.velocity.copy()
        for _ in range(SUBSTEPS):
            # The target point runs ahead on the path, and waits if the point is late.
            while self.station < self.stations[-1]:
                carrot = self._pose_at(self.station)
                if np.linalg.norm(carrot[:2] - self.position) >= config.lookahead:
                    break
                self.station = min(self.stations[-1], self.station + 0.001)
            carrot = self._pose_at(self.station)
            way = carrot[:2] - self.position
            far = np.linalg.norm(way)
            left = far + self.stations[-1] - self.station
            speed = min(most, np.sqrt(2.0 * 0.7 * config.acceleration * left), left / 0.05)
            turn = carrot[2] - self.yaw
            wanted = way / far * speed if far > 1e-9 else np.zeros(2)
            change = (wanted - self.velocity) / 0.03
            size = np.linalg.norm(change)
            change *= min(1.0, config.acceleration / max(size, 1e-9))
            self.velocity = self.velocity + change * step
            self.position = self.position + self.velocity * step
            self.yaw += np.clip(turn, -config.turn_speed * step, config.turn_speed * step)
        self.acceleration = (self.velocity - before) / period


class Follower:
    """Drives the tool of one environment along paths."""

    def __init__(self, world, config=FollowerConfig()):
        self.world, self.config = world, config
        middle, _ = world.table()
        self.height = middle[2]
        self.stiffness, self.damping = float(world.controller.kp[0]), float(world.controller.kd[0])
        self.pressing = 0.5 * config.force
        self.tilt = np.zeros(3)
        self.velocity = np.zeros(2)
        self.pressed = []
        """Normal forces at every step of the physics while the tool wipes [N]."""
        self.track = []
        """Pose of the tool after each period of wiping: x, y, angle of the broad side [m, rad]."""
        self.landed = False
        self.is_singular = False
        """Whether the arm is near a singular posture; reset when the controller accepts a whole command again."""
        self.yaw = self.pose()[2]

    def pose(self):
        """Returns the pose of the tool: x, y, angle of its broad side."""
        position, rotation = self.world.position(), self.world.rotation()
        return np.array([position[0], position[1], np.arctan2(rotation[1, 0], rotation[0, 0])])

    def follow(self, path, until=lambda: False):
        """Wipes along a path (n, 3) from the current pose; ends with the episode, with the path, or when `until` returns true."""
        path = self._with_turns(path)
        if not self.landed:
            # The tool comes down at the begin of its path, not on the way there.
            self._run(path[:1], until, lambda: self.landed)
        self._run(path, until, lambda: False)

    def _with_turns(self, path):
        """Returns a path (n, 3) with angles that the wrist reaches. Half turns of the tool are equivalent; of the possible angles,
        the path has those that turn the tool least."""
        ways = [self._turned(path, self.yaw + turn) for turn in (0.0, np.pi, -np.pi)]
        return min(ways, key=lambda way: np.abs(np.diff(way[:, 2], prepend=self.yaw)).sum())

    def _turned(self, path, yaw):
        """Returns a path whose first angle is near `yaw`, and the others near the angle before, unless the last joint would reach
        its limit."""
        path = np.array(path, dtype=float)
        angle, low, high, sign = self.world.last_joint()
        here = self.world.bearing(self.pose()[:2])
        margin = self.config.turn_margin
        for pose in path:
            pose[2] = yaw + wrapped(pose[2] - yaw)
            # A first joint that swings the arm round turns the tool with it.
            swing = wrapped(self.world.bearing(pose[:2]) - here)
            then = angle + sign * (pose[2] - self.yaw - swing)
            if then > high - margin:
                pose[2] -= sign * np.pi
            elif then < low + margin:
                pose[2] += sign * np.pi
            yaw = pose[2]
        return path

    def _run(self, path, until, landed):
        start = np.append(self.world.position()[:2], self.yaw)
        reference = Reference(np.vstack([start, path]), self.velocity, self.config)
        late = 0
        while not (self.world.done or until() or landed()):
            if reference.arrived and self.landed:
                late += 1
                if late > 3:
                    break
            clearance = self.world.position()[2] - self.height
            in_air = not self.landed and clearance > 0.02
            reference.advance(self.world.period, self.config.free_speed if in_air else self.config.speed)
            left = np.linalg.norm(path[0, :2] - reference.position) - 0.004
            self._command(reference, np.clip(left, 0.0, 0.05))
        self.velocity, self.yaw = reference.velocity, reference.yaw

    def _lean(self, reference):
        """Returns axis times angle by which the tool leans towards its leading side."""
        broad, narrow, _ = self.world.rotation().T
        across, along = narrow[:2] @ reference.velocity, broad[:2] @ reference.velocity
        lean = self.config.lean / self.config.speed
        return -lean * across * broad if abs(across) >= abs(along) else lean * along * narrow

    def _command(self, reference, least_clearance):
        """Commands one period towards a reference; a tool that has not landed keeps a clearance from the table."""
        world, config = self.world, self.config
        position, moving, turning = world.position(), world.velocity(), world.turning()
        acceleration, wrench = np.zeros(6), np.zeros(6)
        acceleration[:2] = (
            reference.acceleration
            + self.damping * (reference.velocity - moving[:2])
            + self.stiffness * (reference.position - position[:2])
        )
        error = rotation_error(world.rotation(), reference.yaw) + self._lean(reference)
        if self.landed:
            self.tilt[:2] = np.clip(self.tilt[:2] + config.tilt_gain * error[:2], -0.05, 0.05)
            missing = config.force - world.force()
            self.pressing = np.clip(self.pressing + config.force_gain * missing, 0.0, 2.0 * config.force)
            wrench[2] = -self.pressing
            acceleration[2] = -self.damping * moving[2]
        else:
            # As fast as the remaining path allows for slowing down.
            above = position[2] - self.height - max(0.004, least_clearance)
            fall = min(config.free_speed, np.sqrt(2.0 * config.braking * max(0.0, above)))
            if least_clearance <= 0.0:
                fall = min(config.free_speed, fall + config.landing_speed)
            acceleration[2] = (-fall - moving[2]) * self.damping
            self.landed = world.force() > 2.0
        stiffness = config.turn_stiffness
        acceleration[3:] = stiffness * (error + self.tilt) - 2.0 * np.sqrt(stiffness) * turning
        errors = self._errors(acceleration, wrench)
        before = len(world.forces)
        world.step(errors)
        if self.landed:
            self.pressed.extend(world.forces[before:])
            self.track.append(self.pose())

    def _errors(self, acceleration, wrench):
        """Returns the errors of position and rotation (6) that make the controller accelerate the tool (6) and press with a wrench (6).

        If the controller would cut off the command, the acceleration along the table is reduced first. If the command is still far
        too large, the arm is near a singular posture, and the directions with too much effective mass are dropped.
        """
        for heaviest in (np.inf, *self.config.heaviest):
            for share in SHARES:
                taken = acceleration * np.array([share, share, 1.0, 1.0, 1.0, 1.0])
                errors = self.world.errors_for(taken, wrench, heaviest)
                far = np.abs(errors[:3]).max()
                if far <= TAKEN:
                    self.is_singular = self.is_singular and heaviest < np.inf
                    return errors
            self.is_singular = self.is_singular or far > self.config.singular
            if not self.is_singular:
                return errors
        return errors
