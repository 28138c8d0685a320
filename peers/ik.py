"""Compares the inverse kinematics of wisch with Pinocchio and OptIK on the same poses.

    pip install -r peers/requirements.txt
    python peers/ik.py [COUNT]

wisch's example `ik` draws COUNT poses (default 300) that the shipped robots reach and writes them;
all start in the middle of the joint limits. A pose is solved if position and rotation are within 1e-6 m and
1e-6 rad and all limits hold, as Pinocchio's forward kinematics sees it.

Pinocchio has no solver; its documentation gives a damped loop (CLIK), which is used here in two forms: as
documented (step 0.1, no limits, one start), and with whole steps, more damping, positions clamped to the
limits, and as many random restarts as wisch has. Both loops are Python around the compiled code of Pinocchio
and NumPy, so compare iterations rather than times. OptIK is compiled, and runs here with one thread. It does
not support mimic joints, so it solves the arms only.
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy
import optik
import pinocchio

from wisch_examples import REPOSITORY, example

POSITION_TOLERANCE = 1e-6
ROTATION_TOLERANCE = 1e-6
RESTARTS = 100
BASE_REACH = 1.0

TORSO_AND_ARM = [f"torso_{i}" for i in range(1, 4)] + [f"right_arm_{i}" for i in range(1, 8)]
CHAINS = {
    "humanoid-10": ("humanoid.urdf", "platform", "right_tcp", TORSO_AND_ARM),
    "humanoid-13": ("humanoid.urdf", "world", "right_tcp", ["base_x", "base_y", "base_yaw"] + TORSO_AND_ARM),
    "arm7": ("arm7.urdf", "link_0", "tcp", [f"joint_{i}" for i in range(1, 8)]),
    "arm6": ("arm6.urdf", "link_0", "tcp", [f"joint_{i}" for i in range(1, 7)]),
}
FOLLOWS = {"torso_4": {"torso_2": -1.0, "torso_3": -1.0}}


class Chain:
    """Some joints of a robot in Pinocchio; the others stand still at zero."""

    def __init__(self, file, base, tip, variables):
        self.model = pinocchio.buildModelFromUrdf(str(REPOSITORY / "robots" / file))
        self.data = self.model.createData()
        self.frame = self.model.getFrameId(tip)
        names = list(self.model.names)[1:]
        joints = {name: self.model.joints[self.model.getJointId(name)] for name in names}
        self.gather = numpy.zeros((self.model.nv, len(variables)))
        for i, name in enumerate(variables):
            self.gather[joints[name].idx_v, i] = 1.0
        for follower, terms in FOLLOWS.items():
            for name, factor in terms.items():
                if follower in joints:
                    self.gather[joints[follower].idx_v, variables.index(name)] = factor
        limited = [joint for joint in joints.values() if joint.nq == 1]
        self.rows = [joint.idx_v for joint in limited]
        self.lower = numpy.array([self.model.lowerPositionLimit[joint.idx_q] for joint in limited])
        self.upper = numpy.array([self.model.upperPositionLimit[joint.idx_q] for joint in limited])

        # Limits of the variables; random starts are within them, and the base within its reach.
        self.low = numpy.full(len(variables), -numpy.inf)
        self.high = numpy.full(len(variables), numpy.inf)
        reach = numpy.full(len(variables), numpy.pi)
        for i, name in enumerate(variables):
            if joints[name].nq == 1:
                self.low[i] = self.model.lowerPositionLimit[joints[name].idx_q]
                self.high[i] = self.model.upperPositionLimit[joints[name].idx_q]
            if name in ("base_x", "base_y"):
                reach[i] = BASE_REACH
        self.sample_low, self.sample_high = numpy.maximum(self.low, -reach), numpy.minimum(self.high, reach)
        self.start = 0.5 * (self.sample_low + self.sample_high)

        pinocchio.framesForwardKinematics(self.model, self.data, pinocchio.neutral(self.model))
        self.world_from_base = self.data.oMf[self.model.getFrameId(base)].copy()

    def configuration(self, q):
        return pinocchio.integrate(self.model, pinocchio.neutral(self.model), self.gather @ q)

    def error(self, q, world_from_target):
        """Twist from the tool to its target in the tool's axes, linear first; Jacobian of it."""
        all_q = self.configuration(q)
        pinocchio.framesForwardKinematics(self.model, self.data, all_q)
        jacobian = pinocchio.computeFrameJacobian(self.model, self.data, all_q, self.frame)
        tool_from_target = self.data.oMf[self.frame].actInv(world_from_target)
        error = pinocchio.log(tool_from_target).vector
        return error, -pinocchio.Jlog6(tool_from_target.inverse()) @ jacobian @ self.gather

    def solved(self, q, world_from_target):
        pinocchio.framesForwardKinematics(self.model, self.data, self.configuration(q))
        tool_from_target = self.data.oMf[self.frame].actInv(world_from_target)
        position = numpy.linalg.norm(tool_from_target.translation)
        rotation = numpy.linalg.norm(pinocchio.log3(tool_from_target.rotation))
        all_q = (self.gather @ q)[self.rows]
        inside = numpy.all(all_q >= self.lower - 1e-12) and numpy.all(all_q <= self.upper + 1e-12)
        return inside and position <= POSITION_TOLERANCE and rotation <= ROTATION_TOLERANCE


def descend(chain, target, start, step, damping, most, low, high):
    """The loop of Pinocchio's documentation; positions and iterations."""
    q = start.copy()
    for iteration in range(most):
        error, jacobian = chain.error(q, target)
        if numpy.linalg.norm(error) < min(POSITION_TOLERANCE, ROTATION_TOLERANCE):
            return q, iteration
        v = -jacobian.T @ numpy.linalg.solve(jacobian @ jacobian.T + damping * numpy.eye(6), error)
        q = numpy.clip(q + step * v, low, high)
    return q, most


def documented(chain, target, _random):
    infinite = numpy.full(len(chain.start), numpy.inf)
    return descend(chain, target, chain.start, 0.1, 1e-12, 1000, -infinite, infinite)


def with_restarts(chain, target, random):
    start, iterations = chain.start, 0
    for _ in range(1 + RESTARTS):
        q, more = descend(chain, target, start, 1.0, 1e-4, 50, chain.low, chain.high)
        iterations += more
        if chain.solved(q, target):
            break
        start = random.uniform(chain.sample_low, chain.sample_high)
    return q, iterations


def optik_solver(file, base, tip):
    robot = optik.Robot.from_urdf_file(str(REPOSITORY / "robots" / file), base, tip)
    robot.set_parallelism(1)
    config = optik.SolverConfig(max_time=0.0, max_restarts=RESTARTS, tol_f=1e-13, tol_df=-1.0, tol_dx=-1.0)

    def solve(chain, target, _random):
        in_base = chain.world_from_base.actInv(target).homogeneous
        found = robot.ik(config, in_base, chain.start)
        return (chain.start if found is None else numpy.array(found[0])), None
    return solve


def compared(count):
    """Chain, solver, share solved [%], iterations, median and mean time [us]; wisch comes first in each chain."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([example("ik"), str(count), folder], cwd=REPOSITORY,
                             capture_output=True, text=True, check=True)
        poses = {name: numpy.loadtxt(pathlib.Path(folder, f"{name}.csv"), delimiter=",", ndmin=2)
                 for name in CHAINS}
    ours = {}
    for line in run.stdout.splitlines()[1:]:
        name, goal, solved, median, mean, *_ = line.split(",")
        if goal == "Full":
            ours[name] = float(solved), float(median), float(mean)

    for name, (file, base, tip, variables) in CHAINS.items():
        solved, median, mean = ours[name]
        yield name, "wisch", solved, "", median, mean
        chain = Chain(file, base, tip, variables)
        solvers = {"Pinocchio, documented": documented, "Pinocchio, restarts": with_restarts}
        if name.startswith("arm"):
            solvers["OptIK"] = optik_solver(file, base, tip)
        for solver, solve in solvers.items():
            random = numpy.random.default_rng(114)
            times, iterations, solved = [], [], 0
            for pose in poses[name]:
                target = chain.world_from_base * pinocchio.XYZQUATToSE3(pose)
                begin = time.perf_counter()
                q, steps = solve(chain, target, random)
                times.append(1e6 * (time.perf_counter() - begin))
                iterations.append(steps)
                solved += chain.solved(q, target)
            loops = "" if None in iterations else f"{statistics.median(iterations):.0f}"
            yield name, solver, 100 * solved / len(times), loops, statistics.median(times), statistics.mean(times)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    header = f"{'chain':12} {'solver':24} {'solved [%]':>10} {'iterations':>10}"
    print(f"{header} {'median [us]':>12} {'mean [us]':>12} {'median / wisch':>15}")
    for name, solver, solved, loops, median, mean in compared(count):
        ours = median if solver == "wisch" else ours
        print(f"{name:12} {solver:24} {solved:10.2f} {loops:>10} {median:12.1f} {mean:12.1f} {median / ours:15.1f}",
              flush=True)


if __name__ == "__main__":
    main()
