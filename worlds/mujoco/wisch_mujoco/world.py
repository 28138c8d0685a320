"""The world of a session, as an executor in Python."""

from copy import deepcopy
from dataclasses import dataclass, field

import mujoco
import numpy as np
import wisch

from . import dirt, poses, scene
from .settings import Settings
from .wire import Frames, WireMotion

PERIOD = 1e-3
"""Period of control, physics and telemetry [s]."""
HOLD_STIFFNESS, HOLD_DAMPING = 4000.0, 200.0
"""Gains of the drives that hold rigid joints, divided by the inertia [1/s², 1/s]."""
FARAWAY = -5.0
"""Height at which crumbs are kept that were taken up: below the floor [m]."""
MAX_ASTRAY = 0.5
"""Distance from the commanded position at which the robot stops [m]."""
SETTLING = 0.3
"""Time after the begin of a stroke from which the tool's force counts [s]."""


@dataclass
class Truth:
    """The ground truth of a round, which no robot has."""

    crumbs: dirt.Crumbs
    contact_force: list = field(default_factory=list)
    """Force of the surface on the sliding tool, along the surface's normal [N]."""
    pushed: list = field(default_factory=list)
    """Begin and end of each push [s]."""
    missed: list = field(default_factory=list)
    """Descriptions of pushes that would have begun after the motion."""


class World:
    """A MuJoCo world for a task of the wheel; pass it to `Session.run`.

    Its dirt, surface and people are those of the ground truth, and stay over the rounds of a session. `set`: values that overrode
    the task's file when it was loaded; alternatively, `settings` state everything.
    """

    def __init__(self, task, seed=None, settings=None, set=None):
        self.task = task
        self.settings = settings or Settings.of(task, seed, set)
        tilt_x, tilt_y = (poses.turned(axis, angle) for axis, angle in zip(([1, 0, 0], [0, 1, 0]), self.settings.tilt))
        believed_from_real = poses.times(tilt_x, tilt_y)
        believed_from_real[:3] = self.settings.shift
        self.world_from_real = poses.times(task.world_from_surface, believed_from_real)
        self.outline = np.asarray(task.surface_outline, dtype=float)
        self.crumbs = dirt.draw(self.settings, self.outline, np.asarray(task.particles))
        self.truth = []
        self.believed = np.asarray(task.world_from_surface, dtype=float)
        self.looks = 0
        self.frames = None
        self.watch = None
        """Called as `watch(simulation, time)` after each step, for pictures and logs."""

    # The interface of an executor.

    def execute(self, motion, sink):
        """Executes a motion on the dirt that the motion before left."""
        if not isinstance(motion, wisch.Motion):
            self.frames = self.frames or Frames(self.task)
            motion = WireMotion(motion, self.frames)
        self.believed = np.asarray(motion.world_from_surface, dtype=float)
        simulation = Simulation(self, motion)
        self.truth.append(simulation.truth)
        done = simulation.run(sink)
        self.crumbs = simulation.truth.crumbs
        return done

    def observe(self):
        """Returns the camera's detections in the frame of the believed surface; None without a camera."""
        settings, crumbs = self.settings, self.crumbs
        if not settings.sees:
            return None
        self.looks += 1
        random = np.random.default_rng([settings.seed, 0x6C6F6F6B, self.looks])
        there = crumbs.on_surface(self.outline)
        # A crumb as small as `half_size` is detected with half the probability.
        size = 2.0 * crumbs.radii
        seen = there & (random.random(len(crumbs)) < settings.detection * size**4 / (size**4 + settings.half_size**4))
        in_world = poses.into(self.world_from_real, crumbs.places[seen])
        places = poses.into(poses.inverse(self.believed), in_world)[:, :2]
        places = places + settings.position_error * random.standard_normal(places.shape)
        low, high = self.outline.min(axis=0), self.outline.max(axis=0)
        false = random.uniform(low, high, (random.poisson(settings.false_alarms * np.prod(high - low)), 2))
        places = np.vstack([places, false])
        return {"detections": places[dirt.inside(self.outline, places)]}

    # The ground truth.

    def performance(self, goal=None, round=None):
        """Returns the share of the crumbs that meet the task's goal [1], now or after a round (from 1). `goal` (2): goal of a
        collect, `Plan.collect_goal`."""
        crumbs = self.crumbs if round is None else self.truth[round - 1].crumbs
        return float(np.mean(crumbs.meeting(self.task.action, goal, self.task.collision_radius_m, self.outline)))


class Simulation:
    """The simulation of one motion."""

    def __init__(self, world, motion):
        settings = world.settings
        self.world, self.motion, self.settings = world, motion, settings
        self.crumbs = deepcopy(world.crumbs)
        self.scene = scene.build(world.task, motion, settings, self.crumbs, world.world_from_real, PERIOD)
        self.model, self.data = self.scene.model, mujoco.MjData(self.scene.model)
        tool_mass = scene.FIRM_MASS + scene.FOAM_MASS
        if isinstance(motion, WireMotion):
            self.controller = motion.controller(PERIOD, tool_mass)
        else:
            self.controller = wisch.ImpedanceController(motion, period_s=PERIOD, tool_mass_kg=tool_mass)
        self.compliant = np.array(self.controller.compliant)
        held = np.setdiff1d(np.arange(len(motion.joints)), self.compliant)
        self.held = held
        self.random = np.random.default_rng([settings.seed, 0x66656C74, motion.round])
        self.truth = Truth(crumbs=self.crumbs)
        self.phases = motion.phases
        self.phase = 0
        self.pushes = []
        for push in settings.pushes:
            if push.round == motion.round:
                start = push.start(motion)
                if start is None:
                    self.truth.missed.append(f"a push of {push.duration} s would begin after the end of round {motion.round}")
                else:
                    self.pushes.append((start, push))
        self.taking = world.task.action == "absorb"
        start = motion.setpoints(PERIOD * max(1.0, motion.duration_s / PERIOD / 100.0))
        self.data.qpos[self.scene.qpos] = start["positions"][0]
        self._follow_others(start["positions"][0])
        mujoco.mj_forward(self.model, self.data)
        self.held_inertia = [self._inertia([(self.scene.dof[i], 1.0)]) for i in held]
        self.rods = []
        """For each joint that follows other joints: terms (address in qpos, in qvel, factor) whose sum stays 0, and the inertia."""
        for name, (address, dof) in self.scene.followers.items():
            rods = [(address, dof, 1.0)]
            for joint, factor in scene.FOLLOWERS[name]:
                index = motion.joints.index(joint)
                rods.append((self.scene.qpos[index], self.scene.dof[index], -factor))
            self.rods.append((rods, self._inertia([(at, factor) for _, at, factor in rods])))
        self.sliding_since = None

    def _follow_others(self, positions):
        for name, (address, _) in self.scene.followers.items():
            terms = scene.FOLLOWERS[name]
            self.data.qpos[address] = sum(factor * positions[self.motion.joints.index(joint)] for joint, factor in terms)

    def run(self, sink):
        """Simulates to the end of the motion, or until the sink stops it; returns the ending."""
        ending, rows = "complete", []
        steps = int(np.ceil(self.motion.duration_s / PERIOD))
        for step in range(steps + 1):
            time = step * PERIOD
            rows.append(self._period(time))
            if len(rows) == 100 or step == steps:
                batch = {key: np.array([row[key] for row in rows]) for key in rows[0]}
                rows = []
                if not sink.many(batch):
                    ending = "stopped"
                    break
            if self.astray > MAX_ASTRAY:
                ending = {"protective_stop": {"time_s": time, "reason": f"the tool is {self.astray:.2f} m off its path"}}
                break
        if rows:
            sink.many({key: np.array([row[key] for row in rows]) for key in rows[0]})
        self._settle()
        return {"ending": ending, "duration_s": time, "positions": self.q}

    def _period(self, time):
        """Simulates one period: measures, commands, and steps; returns the measured sample."""
        model, data, settings, controller = self.model, self.data, self.settings, self.controller
        q, qd = data.qpos[self.scene.qpos], data.qvel[self.scene.dof]
        if settings.encoder_noise:
            q = q + settings.encoder_noise * self.random.standard_normal(len(q))
        self.q = q
        efforts = np.asarray(controller.command(time, q, qd))
        planned_q, planned_qd, planned_qdd = controller.planned

        data.qfrc_applied[:] = 0.0
        data.qfrc_applied[self.scene.dof[self.compliant]] = efforts
        self._hold(planned_q, planned_qd, planned_qdd)
        data.xfrc_applied[:] = 0.0
        self._push(time)
        mujoco.mj_step(model, data)
        if self.taking:
            self._take_up()
        self._note(time)
        if self.world.watch is not None:
            self.world.watch(self, time)

        wrench = np.asarray(controller.external_wrench)
        asked = np.asarray(controller.controller_wrench)
        commanded = np.asarray(controller.world_from_commanded)
        tool = np.asarray(controller.world_from_tool)
        self.astray = float(np.linalg.norm(commanded[:3] - tool[:3]))
        force = wrench[:3] + settings.force_bias + settings.force_noise * self.random.standard_normal(3)
        all_efforts = np.zeros(len(q))
        all_efforts[self.compliant] = efforts
        return {
            "time_s": time,
            "world_from_tool": tool,
            "force_n": force,
            "moment_nm": wrench[3:],
            "world_from_commanded": commanded,
            "controller_force_n": asked[:3],
            "controller_moment_nm": asked[3:],
            "positions": q.copy(),
            "velocities": qd.copy(),
            "efforts": all_efforts,
        }

    def _hold(self, q, qd, qdd):
        """Holds base and idle arms by separate drives, and joints that follow other joints by stiff rods."""
        data = self.data
        for rods, inertia in self.rods:
            error = -sum(factor * data.qpos[address] for address, _, factor in rods)
            slip = -sum(factor * data.qvel[dof] for _, dof, factor in rods)
            _, first, _ = rods[0]
            force = data.qfrc_bias[first] + inertia * (HOLD_STIFFNESS * error + HOLD_DAMPING * slip)
            for _, dof, factor in rods:
                data.qfrc_applied[dof] += factor * force
        for i, inertia in zip(self.held, self.held_inertia):
            address, dof = self.scene.qpos[i], self.scene.dof[i]
            change = qdd[i] + HOLD_STIFFNESS * (q[i] - data.qpos[address]) + HOLD_DAMPING * (qd[i] - data.qvel[dof])
            data.qfrc_applied[dof] = data.qfrc_bias[dof] + inertia * change

    def _inertia(self, terms):
        """Returns the inertia along a combination of joints while all other joints are free: terms are (address in qvel, factor)."""
        along, moved = np.zeros((1, self.model.nv)), np.zeros((1, self.model.nv))
        for dof, factor in terms:
            along[0, dof] = factor
        mujoco.mj_solveM(self.model, self.data, moved, along)
        return 1.0 / float(along[0] @ moved[0])

    def _push(self, time):
        data, body = self.data, self.scene.tool
        for start, push in self.pushes:
            if not start <= time < start + push.duration:
                continue
            size = np.linalg.norm(push.force)
            if size == 0.0:
                continue
            velocity = np.zeros(6)
            mujoco.mj_objectVelocity(self.model, data, mujoco.mjtObj.mjOBJ_XBODY, body, velocity, 0)
            share = np.clip(1.0 - velocity[3:] @ push.force / size / push.hand_speed, 0.0, 1.0)
            if share > 0.0:
                force = share * push.force
                data.xfrc_applied[body, :3] += force
                data.xfrc_applied[body, 3:] += np.cross(data.xpos[body] - data.xipos[body], force)
                if self.truth.pushed and time - self.truth.pushed[-1][1] < 0.35:
                    self.truth.pushed[-1][1] = time
                else:
                    self.truth.pushed.append([time, time])

    def _take_up(self):
        """Lets foam under sufficient pressure take up the crumbs that it touches."""
        data, scene_ = self.data, self.scene
        for contact in data.contact[: data.ncon]:
            for own, other in ((contact.geom1, contact.geom2), (contact.geom2, contact.geom1)):
                block, crumb = scene_.block_geoms.get(int(own)), scene_.crumb_geoms.get(int(other))
                if block is None or crumb is None or self.crumbs.fates[crumb] != dirt.LYING:
                    continue
                pressure = data.qpos[scene_.blocks[block]] / scene_.nominal
                if pressure >= self.crumbs.thresholds[crumb]:
                    self._remove(crumb)

    def _remove(self, crumb):
        self.crumbs.fates[crumb] = dirt.TAKEN_UP
        geom = self.model.geom(f"crumb_{crumb}_body").id
        body = self.model.geom_bodyid[geom]
        self.model.geom_contype[geom] = self.model.geom_conaffinity[geom] = 0
        self.model.body_gravcomp[body] = 1.0
        address, dof = self.scene.crumbs[crumb], self.scene.crumb_dofs[crumb]
        self.data.qpos[address : address + 3] = [0.01 * crumb, 0.0, FARAWAY]
        self.data.qvel[dof : dof + 6] = 0.0

    def _note(self, time):
        """Records the ground truth of this period."""
        while self.phase + 1 < len(self.phases) and self.phases[self.phase + 1]["start_s"] <= time:
            self.phase += 1
        wipes = self.phases[self.phase]["phase"] == "wipe"
        if not wipes:
            self.sliding_since = None
            return
        if self.sliding_since is None:
            self.sliding_since = time
        if time - self.sliding_since >= SETTLING:
            self.truth.contact_force.append(self.contact_force())

    def contact_force(self):
        """Returns the force of the surface on the tool, from the compression of its springs [N]."""
        pressed = np.maximum(0.0, self.data.qpos[self.scene.blocks])
        share = pressed / self.scene.nominal
        return float(self.motion.press_force_n * share.sum() / len(share))

    def _settle(self):
        """Returns the crumbs at the end of the motion."""
        real_from_world = poses.inverse(self.world.world_from_real)
        for crumb, address in enumerate(self.scene.crumbs):
            place = self.data.qpos[address : address + 3]
            self.crumbs.places[crumb] = poses.into(real_from_world, [place])[0]
            turn = self.data.qpos[address + 3 : address + 7]
            self.crumbs.quaternions[crumb] = turn / np.linalg.norm(turn)

