"""The world as a model of MuJoCo: robot, tool, surface, scene and crumbs.

The tool is a bed of blocks, each on a separate spring along the tool's axis. A block stands on the surface with a small foot,
and touches crumbs with its whole body: the sides of the blocks push crumbs ahead of the tool, and their undersides press
down crumbs under it.
"""

import warnings
from dataclasses import dataclass

import mujoco
import numpy as np

from . import poses

# Which bodies collide: `contype` against `conaffinity`.
STANDS, CRUMB, FOOT, BLOCK, WIPED = 1, 2, 4, 8, 16

FIRM_MASS = 0.1
"""Mass of the rigid part of the tool [kg]."""
FOAM_MASS = 0.05
"""Mass of all blocks together [kg]."""
CELL = 0.016
"""Approximate length and width of a block [m]."""
BLOCK_HEIGHT = 0.012
"""Height of a block [m]."""
FOOT_RADIUS = 0.04
"""Radius of the foot of a block [m]: foam that hangs over the border then slides back onto the surface."""
HARD_SOLREF, HARD_SOLIMP = [0.004, 2.0], [0.9995, 0.9999, 0.0003, 0.5, 2.0]
"""Contact parameters of a crumb: under half a newton on 20 mg, the contact gives way by a tenth of a millimetre; damping keeps
a pinched crumb from shooting away."""
FOAM_DAMPING = 0.7
"""Damping ratio of a block on its spring [1]."""
CRUMB_FRICTION = 0.35
"""Friction of a crumb on the surface [1]."""
FOAM_FRICTION = 0.6
"""Friction of a crumb on the foam [1]."""
ROLLING = 0.0004
"""Rolling friction of an angular crumb: distance of its support from its centre [m]."""


FOLLOWERS = {"torso_4": (("torso_2", -1.0), ("torso_3", -1.0))}
"""Joints that follow other joints, with their factors: the humanoid's rods keep its chest upright."""


@dataclass
class Scene:
    """A MuJoCo model with the indices that a simulation needs."""

    model: mujoco.MjModel
    qpos: np.ndarray
    """Addresses of the robot's joints in qpos, in the robot's order (n)."""
    dof: np.ndarray
    """Addresses of the robot's joints in qvel (n)."""
    followers: dict
    """Addresses in qpos and in qvel of joints that follow other joints, by name."""
    tool: int
    """Index of the tool's body."""
    blocks: np.ndarray
    """Addresses of the blocks' slides in qpos (b)."""
    block_geoms: dict
    """Index of the block for each geom."""
    crumbs: np.ndarray
    """Addresses of the crumbs' free joints in qpos (c)."""
    crumb_dofs: np.ndarray
    """Addresses of the crumbs' free joints in qvel (c)."""
    crumb_geoms: dict
    """Index of the crumb for each geom."""
    nominal: float
    """Compression of a block at the nominal pressure [m]."""


def build(task, motion, settings, crumbs, world_from_real, period=1e-3):
    """Builds the model for one motion, with the crumbs at their current positions in the frame of the true surface."""
    spec = mujoco.MjSpec()
    spec.modelname = "wisch"
    option = spec.option
    option.timestep = period
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    option.impratio = 3.0
    # Crumbs without contact sleep, and cost no time.
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    option.gravity = [0.0, 0.0, -9.81]
    spec.visual.global_.offwidth, spec.visual.global_.offheight = 1280, 960
    spec.worldbody.add_light(pos=[0.5, -0.5, 3.0], dir=[0, 0.2, -1.0])

    _add_robot(spec, task.robot().urdf, motion)
    _add_scene(spec, task, settings, world_from_real)
    nominal, columns, rows = _add_tool(spec, task, motion, settings)
    _add_crumbs(spec, crumbs, world_from_real)

    with warnings.catch_warnings():
        # Names need no prefix: robots have no body "wisch_tool", "block_..." or "crumb_...".
        warnings.simplefilter("ignore")
        model = spec.compile()
    names = motion.joints
    joint = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in names]
    blocks = [f"block_{i}_{j}" for i in range(columns) for j in range(rows)]
    block_joints = [model.joint(name) for name in blocks]
    crumb_joints = [model.joint(f"crumb_{k}") for k in range(len(crumbs))]
    return Scene(
        model=model,
        qpos=model.jnt_qposadr[joint].copy(),
        dof=model.jnt_dofadr[joint].copy(),
        followers={
            name: (int(model.joint(name).qposadr[0]), int(model.joint(name).dofadr[0]))
            for name in FOLLOWERS
            if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) >= 0
        },
        tool=model.body("wisch_tool").id,
        blocks=np.array([j.qposadr[0] for j in block_joints]),
        block_geoms={model.geom(f"{name}_body").id: k for k, name in enumerate(blocks)},
        crumbs=np.array([j.qposadr[0] for j in crumb_joints], dtype=int),
        crumb_dofs=np.array([j.dofadr[0] for j in crumb_joints], dtype=int),
        crumb_geoms={model.geom(f"crumb_{k}_body").id: k for k in range(len(crumbs))},
        nominal=nominal,
    )


def _add_robot(spec, urdf, motion):
    robot = mujoco.MjSpec.from_string(urdf)
    robot.compiler.fusestatic = False
    robot.compiler.balanceinertia = True
    # Links without mass, as between the joints of a mobile base, get a tiny mass.
    robot.compiler.boundmass, robot.compiler.boundinertia = 1e-4, 1e-6
    for geom in robot.geoms:
        geom.contype, geom.conaffinity = 0, 0
        geom.rgba = [0.75, 0.77, 0.8, 1.0]
        geom.mass = 0.0
    root = motion.world_from_root
    frame = spec.worldbody.add_frame(pos=root[:3], quat=poses.wxyz(root))
    spec.attach(robot, frame=frame, prefix="")


def _add_scene(spec, task, settings, world_from_real):
    real_from_believed = poses.inverse(task.world_from_surface)
    moved = poses.times(world_from_real, real_from_believed)
    for index, thing in enumerate(task.scene):
        if thing["role"] in ("robot", "tool"):
            continue
        # The object that carries the surface moves with the true surface.
        pose = thing["world_from_object"]
        if thing["role"] == "carrier":
            pose = poses.times(moved, pose)
        name = f"scene_{index}"
        vertices = np.asarray(thing["vertices"], dtype=float)
        middle, half = (vertices.max(axis=0) + vertices.min(axis=0)) / 2, (vertices.max(axis=0) - vertices.min(axis=0)) / 2
        is_box = len(vertices) == 8 and np.allclose(np.abs(vertices - middle), half)
        common = dict(
            name=name,
            contype=STANDS | (WIPED if thing["role"] == "carrier" else 0),
            conaffinity=0,
            condim=3,
            friction=[CRUMB_FRICTION, 0.005, 0.0001],
            solref=HARD_SOLREF,
            solimp=HARD_SOLIMP,
            rgba=[0.82, 0.68, 0.47, 1.0] if thing["role"] == "carrier" else [0.6, 0.6, 0.62, 1.0],
        )
        if is_box:
            at = poses.into(pose, [middle])[0]
            spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=half, pos=at, quat=poses.wxyz(pose), **common)
        else:
            spec.add_mesh(name=name, uservert=vertices.ravel(), userface=np.asarray(thing["triangles"], dtype=int).ravel())
            spec.worldbody.add_geom(
                type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, pos=pose[:3], quat=poses.wxyz(pose), **common
            )
    if not any(thing["role"] == "carrier" for thing in task.scene):
        outline = task.surface_outline
        half = (outline.max(axis=0) - outline.min(axis=0)) / 2
        at = poses.into(world_from_real, [[*(outline.max(axis=0) + outline.min(axis=0)) / 2, -0.01]])[0]
        spec.worldbody.add_geom(
            name="surface",
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[*half, 0.01],
            pos=at,
            quat=poses.wxyz(world_from_real),
            contype=STANDS | WIPED,
            conaffinity=0,
            friction=[CRUMB_FRICTION, 0.005, 0.0001],
        )


def _add_tool(spec, task, motion, settings):
    """Adds the tool to the hand; returns its nominal compression [m], and the number of blocks along and across."""
    grasp = poses.turned([0.0, 0.0, 1.0], settings.grasp_turn)
    grasp[:2] = settings.grasp_offset
    tip_from_tool = poses.times(motion.tip_from_tool, grasp)
    tool = spec.body(motion.tip).add_body(
        name="wisch_tool",
        pos=tip_from_tool[:3],
        quat=poses.wxyz(tip_from_tool),
        mass=FIRM_MASS,
        ipos=[0.0, 0.0, 0.02],
        inertia=[1e-4, 1e-4, 1e-4],
    )
    corners = np.vstack(task.tool_footprint) * settings.footprint
    low, high = corners.min(axis=0), corners.max(axis=0)
    columns, rows = (int(n) for n in np.maximum(2, np.round((high - low) / CELL)))
    sizes = (high - low) / [columns, rows]
    depth = max(motion.compression_depth_m, 0.0005)
    count = columns * rows
    stiffness = settings.tool_stiffness * motion.press_force_n / depth / count
    mass = FOAM_MASS / count
    tool.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[*(high - low) / 2, 0.012],
        pos=[*(high + low) / 2, 0.028],
        contype=0,
        conaffinity=0,
        mass=0.0,
        rgba=[0.95, 0.8, 0.2, 1.0],
    )
    for i in range(columns):
        for j in range(rows):
            x, y = low + sizes * [i + 0.5, j + 0.5]
            # At rest, the foam hangs below the tool centre point by its compression under the nominal force.
            block = tool.add_body(
                name=f"block_{i}_{j}",
                pos=[x, y, -depth],
                mass=mass,
                ipos=[0.0, 0.0, BLOCK_HEIGHT / 2],
                inertia=[mass * 1e-4] * 3,
            )
            block.add_joint(
                name=f"block_{i}_{j}",
                type=mujoco.mjtJoint.mjJNT_SLIDE,
                axis=[0.0, 0.0, 1.0],
                stiffness=stiffness,
                springref=9.81 * mass / stiffness,
                damping=2.0 * FOAM_DAMPING * np.sqrt(stiffness * mass),
                range=[-0.001, 0.04],
                limited=True,
            )
            common = dict(condim=3, priority=1, mass=0.0)
            block.add_geom(
                name=f"block_{i}_{j}_foot",
                type=mujoco.mjtGeom.mjGEOM_SPHERE,
                size=[FOOT_RADIUS, 0, 0],
                pos=[0.0, 0.0, FOOT_RADIUS],
                contype=FOOT,
                conaffinity=WIPED,
                friction=[settings.friction, 0.005, 0.0001],
                solref=[0.005, 1.0],
                solimp=[0.9, 0.99, 0.001, 0.5, 2.0],
                group=4,
                **common,
            )
            block.add_geom(
                name=f"block_{i}_{j}_body",
                type=mujoco.mjtGeom.mjGEOM_BOX,
                size=[*sizes / 2, BLOCK_HEIGHT / 2],
                pos=[0.0, 0.0, BLOCK_HEIGHT / 2],
                contype=BLOCK,
                conaffinity=0,
                friction=[FOAM_FRICTION, 0.005, 0.0001],
                solref=HARD_SOLREF,
                solimp=HARD_SOLIMP,
                rgba=[0.95, 0.85, 0.3, 1.0],
                **common,
            )
    return depth / settings.tool_stiffness, columns, rows


def _add_crumbs(spec, crumbs, world_from_real):
    middles = poses.into(world_from_real, crumbs.places)
    for k in range(len(crumbs)):
        lies = crumbs.fates[k] == 0
        body = spec.worldbody.add_body(
            name=f"crumb_{k}",
            pos=middles[k],
            # A crumb that was taken up has no weight; MuJoCo applies this only to bodies that set it.
            gravcomp=1e-9 if lies else 1.0,
            quat=crumbs.quaternions[k],
        )
        body.add_freejoint(name=f"crumb_{k}")
        body.add_geom(
            name=f"crumb_{k}_body",
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=[crumbs.radii[k], 0, 0],
            mass=crumbs.masses[k],
            contype=CRUMB if lies else 0,
            conaffinity=STANDS | CRUMB | BLOCK if lies else 0,
            condim=6,
            friction=[CRUMB_FRICTION, 0.0005, ROLLING],
            solref=HARD_SOLREF,
            solimp=HARD_SOLIMP,
            priority=0,
            rgba=[0.55, 0.32, 0.12, 1.0],
        )
