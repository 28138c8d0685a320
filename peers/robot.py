"""Records what Pinocchio computes for the shipped robots, as the reference of wisch's tests.

    pip install -r peers/requirements.txt
    python peers/robot.py

Writes crates/wisch/tests/data/pinocchio-*.csv: for 20 random states of each robot the positions q,
velocities qd, accelerations qdd, the pose of the TCP in the world (the first three rows of its
matrix), the Jacobian at the TCP (6 x n, linear first, axes of the world), mass matrix, bias, gravity
and inverse dynamics, all row by row.

For the humanoid, the file has the 13 variables of base, torso and right arm. The left arm and the head stay
at zero, so these are rows and columns of the quantities of the full robot. For Pinocchio, torso_4 is an
independent joint: it is put at -(q2 + q3), and quantities are projected by the constant matrix
G = d(all joints) / d(variables), M = G' H G and so on.
"""

import pathlib

import numpy
import pinocchio

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAMPLES = 20
GRAVITY = numpy.array([0.0, 0.0, -9.81])

ARM6 = [f"joint_{i}" for i in range(1, 7)]
ARM7 = [f"joint_{i}" for i in range(1, 8)]
HUMANOID = (
    ["base_x", "base_y", "base_yaw", "torso_1", "torso_2", "torso_3"]
    + [f"right_arm_{i}" for i in range(1, 8)]
)
FOLLOWS = {"torso_4": {"torso_2": -1.0, "torso_3": -1.0}}


def record(file, robot, variables, tcp, random):
    model = pinocchio.buildModelFromUrdf(str(ROOT / "robots" / robot))
    model.gravity.linear = GRAVITY
    data = model.createData()
    frame = model.getFrameId(tcp)
    joints = {name: model.joints[model.getJointId(name)] for name in model.names[1:]}

    gather = numpy.zeros((model.nv, len(variables)))
    for i, name in enumerate(variables):
        gather[joints[name].idx_v, i] = 1.0
    for follower, terms in FOLLOWS.items():
        if follower in joints:
            for name, factor in terms.items():
                gather[joints[follower].idx_v, variables.index(name)] = factor

    lines = [f"# Pinocchio {pinocchio.__version__} on {robot}: {' '.join(variables)}; see peers/robot.py"]

    def row(name, values):
        lines.append(",".join([name, *(repr(float(v)) for v in numpy.asarray(values).ravel())]))

    for _ in range(SAMPLES):
        q = numpy.zeros(len(variables))
        for i, name in enumerate(variables):
            joint = joints[name]
            lower, upper = -numpy.pi, numpy.pi
            if joint.nq == 1:
                lower = max(-2 * numpy.pi, model.lowerPositionLimit[joint.idx_q])
                upper = min(2 * numpy.pi, model.upperPositionLimit[joint.idx_q])
            q[i] = random.uniform(lower, upper)
        qd = random.uniform(-2.0, 2.0, len(variables))
        qdd = random.uniform(-5.0, 5.0, len(variables))

        all_positions = gather @ q
        all_q = pinocchio.neutral(model)
        for joint in joints.values():
            angle = all_positions[joint.idx_v]
            if joint.nq == 2:
                all_q[joint.idx_q:joint.idx_q + 2] = numpy.cos(angle), numpy.sin(angle)
            else:
                all_q[joint.idx_q] = angle
        all_qd, all_qdd = gather @ qd, gather @ qdd

        jacobian = pinocchio.computeFrameJacobian(
            model, data, all_q, frame, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        pinocchio.framesForwardKinematics(model, data, all_q)
        pose = data.oMf[frame].homogeneous[:3].copy()
        mass = numpy.triu(pinocchio.crba(model, data, all_q).copy())
        mass = mass + numpy.triu(mass, 1).T
        row("q", q)
        row("qd", qd)
        row("qdd", qdd)
        row("world_from_tcp", pose)
        row("jacobian", jacobian @ gather)
        row("mass_matrix", gather.T @ mass @ gather)
        row("bias", gather.T @ pinocchio.nonLinearEffects(model, data, all_q, all_qd))
        row("gravity", gather.T @ pinocchio.computeGeneralizedGravity(model, data, all_q))
        row("inverse_dynamics", gather.T @ pinocchio.rnea(model, data, all_q, all_qd, all_qdd))
    path = ROOT / "crates/wisch/tests/data" / file
    path.write_text("\n".join(lines) + "\n")
    print(path.relative_to(ROOT), len(lines), "lines")


def main():
    random = numpy.random.default_rng(114)
    record("pinocchio-arm6.csv", "arm6.urdf", ARM6, "tcp", random)
    record("pinocchio-arm7.csv", "arm7.urdf", ARM7, "tcp", random)
    record("pinocchio-humanoid.csv", "humanoid.urdf", HUMANOID, "right_tcp", random)


if __name__ == "__main__":
    main()
