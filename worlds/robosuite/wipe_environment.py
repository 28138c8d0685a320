"""robosuite's Wipe task, unmodified: created without a display, observed, and stepped through its own controller.

Lengths in metres, forces in newtons, angles in radians; positions in the frame of the world unless said otherwise.
"""

import logging
import os
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

os.environ.setdefault("MUJOCO_GL", "disable")
logging.disable(logging.WARNING)  # robosuite reports missing optional packages at import

import numpy as np

try:
    import robosuite
    from robosuite.utils.observables import Observable, sensor
except ImportError as error:
    sys.exit(f"robosuite is needed ({error}): pip install -r worlds/robosuite/requirements.txt")

ROBOTS = ("Panda", "UR5e", "IIWA", "Sawyer")

BASE_TOUCHES = {"Sawyer": ("robot0_right_arm_base_link", "robot0_right_l0")}
"""Arms whose first link and base touch by a rounding error (-1.7e-16 m), which robosuite 1.5.2 counts as a collision that ends
every episode at its first step. These two bodies are excluded from collisions."""


@dataclass(frozen=True)
class Tool:
    """The contact area: the rectangle between the four corners of the wiping gripper."""

    length: float
    """Length of the narrow side, along the motion [m]."""
    width: float
    """Length of the broad side, across the motion [m]."""


def _kept_apart(xml, one, other):
    """Returns a model in which two bodies do not collide."""
    root = ElementTree.fromstring(xml)
    contact = root.find("contact")
    if contact is None:
        contact = ElementTree.SubElement(root, "contact")
    ElementTree.SubElement(contact, "exclude", body1=one, body2=other)
    return ElementTree.tostring(root, encoding="unicode")


LEVER = 0.1
"""Length that converts rotations to displacements [m]."""


def _damped_solve(mobility, acceleration, heaviest):
    """Returns the wrench (6) that gives a tool with a mobility (6, 6) an acceleration (6).

    It is exact in all directions in which the effective mass is at most `heaviest` [kg]. In the other directions, which the arm is
    about to lose in a singular posture, the wrench goes to zero with the mobility.
    """
    scale = np.array([1.0, 1.0, 1.0, LEVER, LEVER, LEVER])
    values, directions = np.linalg.eigh(mobility * np.outer(scale, scale))
    masses = np.where(values * heaviest > 1.0, 1.0 / np.maximum(values, 1e-12), values * heaviest**2)
    return scale * (directions @ (masses * (directions.T @ (scale * acceleration))))


class WipeEnvironment:
    """Episodes of the Wipe task with one arm.

    The task has robosuite's defaults: controller (OSC_POSE, deltas), 20 Hz, table, 100 markers, and conditions for the end of an
    episode. One sensor is added through robosuite's interface for observables: the force at the wrist at every step of the
    physics.
    """

    def __init__(self, robot, seed, horizon=2000, renders=False):
        apart = robot in BASE_TOUCHES
        self.env = robosuite.make(
            "Wipe",
            robots=robot,
            has_renderer=False,
            has_offscreen_renderer=renders,
            use_camera_obs=False,
            horizon=horizon,
            hard_reset=apart,
            seed=seed,
        )
        if apart:
            self.env.set_xml_processor(lambda xml: _kept_apart(xml, *BASE_TOUCHES[robot]))
        self.env.reset()
        self.robot = self.env.robots[0]
        self.arm = self.robot.arms[0]
        self.controller = self.robot.part_controllers[self.arm]
        self.forces = []
        self._add_force_sensor()
        self.done = False
        corners = self.robot.gripper[self.arm].important_geoms["corners"]
        self._corners = [self.env.sim.model.geom_name2id(name) for name in corners]

    def _add_force_sensor(self):
        @sensor(modality="wrist")
        def wrist_force(_cache):
            force = float(self.robot.ee_force[self.arm][2])
            self.forces.append(force)
            return force

        rate = 1.0 / self.env.model_timestep
        self.env.add_observable(Observable(name="wrist_force", sensor=wrist_force, sampling_rate=rate))
        self.forces.clear()

    # What a camera would observe.

    def visible_markers(self):
        """Returns the locations of the markers that are left, as from a photo: (n, 2)."""
        data, model = self.env.sim.data, self.env.sim.model
        wiped = {marker.name for marker in self.env.wiped_markers}
        places = [
            data.body_xpos[model.body_name2id(marker.root_body)][:2]
            for marker in self.env.model.mujoco_arena.markers
            if marker.name not in wiped
        ]
        return np.array(places, dtype=float).reshape(-1, 2)

    def table(self):
        """Returns the rectangle of the table: its centre (3) and its sizes along x and y (2)."""
        return np.array(self.env.table_offset, dtype=float), np.array(self.env.table_full_size[:2], dtype=float)

    def dirt_area(self):
        """Returns the rectangle in which markers may lie: its centre (2) and its sizes along x and y (2)."""
        middle, sizes = self.table()
        return middle[:2], sizes * self.env.coverage_factor - self.env.line_width

    def tool(self):
        """Returns the footprint of the wiping gripper, from its contact geometry."""
        one, two, _, four = self.corners()
        return Tool(length=float(np.linalg.norm(four - two)), width=float(np.linalg.norm(one - two)))

    # What the robot measures.

    def corners(self):
        """Returns the positions of the tool's four corners: (4, 3)."""
        return np.array(self.env.sim.data.geom_xpos[self._corners])

    def position(self):
        """Returns the tool centre point (3)."""
        return np.array(self.controller.ref_pos)

    def velocity(self):
        """Returns the velocity of the tool centre point (3)."""
        return np.array(self.controller.ref_pos_vel)

    def rotation(self):
        """Returns the axes of the tool in the world (3, 3): x along its broad side, z out of its face."""
        one, two, _, four = self.corners()
        broad = (one - two) / np.linalg.norm(one - two)
        narrow = (four - two) / np.linalg.norm(four - two)
        return np.column_stack([broad, narrow, np.cross(broad, narrow)])

    def force(self):
        """Returns the last measured normal force, positive when the tool presses."""
        return self.forces[-1] if self.forces else 0.0

    def turning(self):
        """Returns the angular velocity of the tool (3)."""
        return np.array(self.controller.ref_ori_vel)

    def errors_for(self, acceleration, wrench, heaviest=np.inf):
        """Returns the errors of position and rotation (6) for which the controller accelerates the tool (6) while the tool presses
        on its surroundings with a wrench (6).

        The controller treats position and rotation separately. This method compensates their coupling in the arm, except in
        directions in which the effective mass exceeds `heaviest` [kg].
        """
        controller = self.controller
        mass, jacobian = np.array(controller.mass_matrix), np.array(controller.J_full)
        mobility = jacobian @ np.linalg.solve(mass, jacobian.T)
        wanted = _damped_solve(mobility, acceleration, heaviest) + wrench
        twist = np.concatenate([self.velocity(), self.turning()])
        error = np.concatenate([mobility[:3, :3] @ wanted[:3], mobility[3:, 3:] @ wanted[3:]])
        return (error + np.array(controller.kd) * twist) / np.array(controller.kp)

    def last_joint(self):
        """Returns for the last joint of the arm: its angle, its limits [rad], and its signed rotation per radian of the tool about
        the table's normal."""
        simulation, joint = self.env.sim, self.robot.robot_model.joints[-1]
        low, high = simulation.model.jnt_range[simulation.model.joint_name2id(joint)]
        return simulation.data.get_joint_qpos(joint), low, high, np.sign(self.controller.J_full[5, -1])

    def bearing(self, place):
        """Returns the direction of a location (2) from the arm's first joint [rad]."""
        first = self.env.sim.model.joint_name2id(self.robot.robot_model.joints[0])
        way = np.asarray(place) - self.env.sim.data.xanchor[first][:2]
        return np.arctan2(way[1], way[0])

    # Time.

    @property
    def time(self):
        """Returns the simulated seconds since the reset."""
        return self.env.cur_time

    @property
    def period(self):
        """Returns the simulated seconds between commands."""
        return self.env.control_timestep

    def step(self, errors):
        """Commands a pose by its errors (6), each limited to what the controller accepts, and simulates one period."""
        limits = np.array(self.controller.output_max)
        _, _, done, _ = self.env.step(np.clip(errors / limits, -1.0, 1.0))
        self.done = self.done or bool(done)
        return self.done

    def ending(self):
        """Returns the state of the episode: "complete", "joint limit", "collision", "time" or "unfinished"."""
        if self.env._check_success():
            return "complete"
        if self.robot.check_q_limits():
            return "joint limit"
        if self.env.check_contact(self.robot.robot_model):
            return "collision"
        return "time" if self.done else "unfinished"

    def close(self):
        """Frees the simulation."""
        self.env.close()
