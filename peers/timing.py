"""Compares the timing of joint paths in wisch with toppra on the same paths and limits.

    pip install -r peers/requirements.txt
    python peers/timing.py                      # paths made here
    python peers/timing.py PATH.csv LIMITS.csv  # a recorded one, files as for the example `timing`

toppra gets the path twice. First it gets the same polyline with the same parabolic corners (computed here
again), where durations must agree. Then it gets the cubic spline through all waypoints, its usual input, which
takes another path between the waypoints. The last columns show by how much each answer of toppra, by finite
differences of its own samples, exceeds the acceleration limits.
"""

import logging
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
import scipy.interpolate
import toppra
import toppra.algorithm
import toppra.constraint
from toppra.interpolator import AbstractGeometricPath

from wisch_examples import example

BLEND_TOLERANCE = 2e-3
# wisch keeps a tenth for passing over near waypoints; the paths here have none.
BLEND_SHARE = 0.9
# Enough for toppra's evenly spaced grid to resolve speeding up and braking on long pieces.
GRID_INTERVALS = 8000
SAMPLE_PERIOD = 1e-3


class RoundedPolyline(AbstractGeometricPath):
    """Straight pieces and parabolas; the parameter is time at the fastest joint's velocity limit."""

    def __init__(self, waypoints, velocities):
        steps = numpy.diff(waypoints, axis=0)
        lengths = numpy.max(numpy.abs(steps) / velocities, axis=1)
        directions = steps / lengths[:, None]
        turns = numpy.max(numpy.abs(numpy.diff(directions, axis=0)), axis=1)
        room = 0.5 * numpy.minimum(lengths[:-1], lengths[1:])
        with numpy.errstate(divide="ignore"):
            reaches = numpy.minimum(room, 4 * BLEND_SHARE * BLEND_TOLERANCE / turns)
        reaches = numpy.concatenate([[0], reaches, [0]])
        corners = numpy.concatenate([[0], numpy.cumsum(lengths)])
        breaks, terms = [0.0], []
        for i, (length, direction) in enumerate(zip(lengths, directions)):
            if length - reaches[i] - reaches[i + 1] > 1e-9 * length:
                terms.append([0 * direction, direction, waypoints[i] + reaches[i] * direction])
                breaks.append(corners[i + 1] - reaches[i + 1])
            if i + 1 < len(lengths):
                reach, turn = reaches[i + 1], directions[i + 1] - direction
                terms.append([turn / (4 * reach), direction, waypoints[i + 1] - reach * direction])
                breaks.append(corners[i + 1] + reach)
        breaks[-1] = corners[-1]
        self.breaks = numpy.array(breaks)
        self.q = scipy.interpolate.PPoly(numpy.array(terms).transpose(1, 0, 2), self.breaks)

    def __call__(self, position, order=0):
        return self.q(position, order)

    @property
    def dof(self):
        return self.q.c.shape[2]

    @property
    def path_interval(self):
        return self.breaks[[0, -1]]

    def grid(self):
        return even_grid(self.breaks)


def even_grid(breaks):
    """The same number of intervals between any two breaks."""
    count = -(-GRID_INTERVALS // (len(breaks) - 1))
    inner = breaks[:-1, None] + numpy.diff(breaks)[:, None] * numpy.arange(count) / count
    return numpy.append(inner.ravel(), breaks[-1])


def limits_of(joints):
    """The paper's: a base of two translations before six or more joints."""
    base = 2 if joints > 7 else 0
    velocity = numpy.array([0.5] * base + [1.0] * (joints - base))
    acceleration = numpy.array([1.0] * base + [10.0] * (joints - base))
    return velocity, acceleration


def smooth(joints, count):
    along = numpy.arange(count)[:, None] * 0.02
    index = numpy.arange(joints)
    return numpy.sin(along * (1 + 0.1 * index) + index)


def cornered(joints, count):
    return numpy.random.default_rng(joints).uniform(-1, 1, (count, joints))


def wisch(waypoints, velocity, acceleration):
    with tempfile.TemporaryDirectory() as folder:
        path, limits = pathlib.Path(folder, "path.csv"), pathlib.Path(folder, "limits.csv")
        numpy.savetxt(path, waypoints, delimiter=",", fmt="%.17g")
        rows = [f"joint {j},-inf,inf,{v},{a}\n" for j, (v, a) in enumerate(zip(velocity, acceleration))]
        limits.write_text("".join(rows))
        run = subprocess.run([example("timing"), path, limits, str(BLEND_TOLERANCE)],
                             capture_output=True, text=True, check=True)
    duration, faults, milliseconds = run.stdout.strip().split(",")
    return float(duration), int(faults), float(milliseconds)


def toppra_time(path, grid, velocity, acceleration):
    constraints = [
        toppra.constraint.JointVelocityConstraint(numpy.column_stack([-velocity, velocity])),
        toppra.constraint.JointAccelerationConstraint(
            numpy.column_stack([-acceleration, acceleration]),
            discretization_scheme=toppra.constraint.DiscretizationType.Interpolation),
    ]
    begin = time.perf_counter()
    solver = toppra.algorithm.TOPPRA(constraints, path, gridpoints=grid,
                                     parametrizer="ParametrizeConstAccel")
    trajectory = solver.compute_trajectory(0, 0)
    milliseconds = 1e3 * (time.perf_counter() - begin)
    if trajectory is None:
        return float("nan"), milliseconds, float("nan")
    times = numpy.arange(0, trajectory.duration, SAMPLE_PERIOD)
    bends = numpy.diff(trajectory(times), 2, axis=0) / SAMPLE_PERIOD**2
    excess = numpy.max(numpy.abs(bends) / acceleration) - 1
    return trajectory.duration, milliseconds, max(excess, 0.0)


def compare(waypoints, velocity, acceleration):
    """Of wisch duration [s], faults and time [ms]; of toppra, with the same corners and by a cubic spline, duration,
    time [ms] and the share by which accelerations exceed their limits."""
    duration, faults, milliseconds = wisch(waypoints, velocity, acceleration)
    rounded = RoundedPolyline(waypoints, velocity)
    same = toppra_time(rounded, rounded.grid(), velocity, acceleration)
    steps = numpy.max(numpy.abs(numpy.diff(waypoints, axis=0)) / velocity, axis=1)
    knots = numpy.concatenate([[0], numpy.cumsum(steps)])
    spline = toppra.SplineInterpolator(knots, waypoints, bc_type="natural")
    other = toppra_time(spline, even_grid(knots), velocity, acceleration)
    return (duration, faults, milliseconds), same, other


def compared():
    """Paths made here: name, and what `compare` says of each."""
    for kind, count in ((smooth, 500), (cornered, 20)):
        for joints in (1, 6, 7, 13):
            yield f"{kind.__name__} {count} x {joints}", compare(kind(joints, count), *limits_of(joints))


def show(name, ours, same, other):
    duration, faults, milliseconds = ours
    print(f"{name:18} {duration:9.4f} {milliseconds:8.2f} {faults:7}"
          f" {same[0]:9.4f} {same[1]:8.1f} {100 * same[2]:7.2f}"
          f" {other[0]:9.4f} {other[1]:8.1f} {100 * other[2]:7.2f}", flush=True)


def main():
    logging.disable(logging.WARNING)
    print(f"{'':18} {'wisch':26} {'toppra, same corners':26} {'toppra, cubic spline'}")
    print(f"{'path':18} {'[s]':>9} {'[ms]':>8} {'faults':>7}" + f" {'[s]':>9} {'[ms]':>8} {'over [%]':>7}" * 2)
    if len(sys.argv) == 3:
        waypoints = numpy.loadtxt(sys.argv[1], delimiter=",", ndmin=2)
        limits = numpy.loadtxt(sys.argv[2], delimiter=",", ndmin=2, usecols=(3, 4))
        show(pathlib.Path(sys.argv[1]).stem, *compare(waypoints, limits[:, 0], limits[:, 1]))
        return
    for name, figures in compared():
        show(name, *figures)


if __name__ == "__main__":
    main()
