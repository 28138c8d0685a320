"""Compares one push stroke of 0.4 m in wisch with the same in vectorised NumPy.

    pip install -r peers/requirements.txt
    python peers/effect.py

Both push uniformly distributed particles on one square metre with a sponge of 0.07 x 0.11 m. The table shows
the median time of a stroke, the ratio, and the largest distance between the two answers.
"""

import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy

from wisch_examples import example

DEPTH, WIDTH = 0.07, 0.11
START, LENGTH = -0.2, 0.4


def push(points):
    """The same stroke over all particles at once."""
    x, y = points[:, 0].copy(), points[:, 1]
    ahead = x - START
    met = (numpy.abs(y) < WIDTH / 2) & (ahead > -DEPTH / 2) & (ahead < DEPTH / 2 + LENGTH)
    x[met] = START + DEPTH / 2 + LENGTH
    return numpy.column_stack([x, y])


def timed(function, argument, repeats):
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        result = function(argument)
        times.append(time.perf_counter() - begin)
    return result, statistics.median(times)


def wisch(path, repeats):
    run = subprocess.run(
        [example("stroke"), str(path), str(repeats)],
        capture_output=True, text=True, check=True)
    after = numpy.array([[float(v) for v in line.split(",")] for line in run.stdout.splitlines()])
    return after, float(run.stderr.splitlines()[-1]) * 1e-6


def compared():
    """Particles, our time and theirs [s], and how far apart the answers are [m]."""
    with tempfile.TemporaryDirectory() as folder:
        for count in (400, 10_000, 100_000, 1_000_000):
            points = numpy.random.default_rng(count).uniform(-0.5, 0.5, (count, 2))
            path = pathlib.Path(folder) / "points.csv"
            numpy.savetxt(path, points, delimiter=",", fmt="%.17g")
            ours, our_time = wisch(path, 51)
            theirs, their_time = timed(push, points, 51)
            apart = numpy.abs(ours - theirs).max()
            yield count, our_time, their_time, apart


def main():
    print(f"{'particles':>10} {'wisch [us]':>12} {'NumPy [us]':>12} {'NumPy/wisch':>12} {'apart [m]':>10}")
    for count, our_time, their_time, apart in compared():
        print(f"{count:>10} {our_time * 1e6:>12.1f} {their_time * 1e6:>12.1f} "
              f"{their_time / our_time:>12.1f} {apart:>10.1e}", flush=True)


if __name__ == "__main__":
    main()
