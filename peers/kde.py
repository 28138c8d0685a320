"""Compares wisch's density map with scikit-learn's KernelDensity at the same places.

    pip install -r peers/requirements.txt
    python peers/kde.py

scikit-learn's Gaussian divides by 2 s^2 where the paper's kernel (2) divides by h^2, so s = h / sqrt(2),
and is normalised, so it is scaled by 2 pi s^2. Errors are relative, where the density is above a
hundredth of its peak.
"""

import math
import pathlib
import subprocess
import tempfile
import time

import numpy
from sklearn.neighbors import KernelDensity

from wisch_examples import example

BANDWIDTH = 0.05


def wisch(path):
    run = subprocess.run(
        [example("density"), str(path), str(BANDWIDTH)],
        capture_output=True, text=True, check=True)
    samples = numpy.array([[float(v) for v in line.split(",")] for line in run.stdout.splitlines()])
    return samples, float(run.stderr.splitlines()[-1]) * 1e-3


def scikit(points, places):
    sigma = BANDWIDTH / math.sqrt(2)
    begin = time.perf_counter()
    estimate = KernelDensity(kernel="gaussian", bandwidth=sigma, rtol=1e-4).fit(points)
    density = numpy.exp(estimate.score_samples(places)) * 2 * math.pi * sigma**2
    return density, time.perf_counter() - begin


def compared():
    """Particles, samples of the map, our time and theirs [s], and the largest relative difference."""
    generator = numpy.random.default_rng(7)
    with tempfile.TemporaryDirectory() as folder:
        for count in (100, 1_000, 10_000, 100_000):
            half = count // 2
            points = numpy.vstack([
                generator.uniform([-0.2, -0.14], [0.2, 0.14], (count - half, 2)),
                generator.normal([0.05, 0.02], 0.03, (half, 2))])
            path = pathlib.Path(folder) / "points.csv"
            numpy.savetxt(path, points, delimiter=",", fmt="%.17g")
            samples, our_time = wisch(path)
            theirs, their_time = scikit(points, samples[:, :2])
            matters = theirs > theirs.max() / 100
            error = numpy.abs(samples[matters, 2] / theirs[matters] - 1).max()
            yield count, len(samples), our_time, their_time, error


def main():
    print(f"{'particles':>10} {'samples':>8} {'wisch [ms]':>11} {'sklearn [ms]':>13} {'ratio':>8} {'rel. error':>11}")
    for count, samples, our_time, their_time, error in compared():
        print(f"{count:>10} {samples:>8} {our_time * 1e3:>11.2f} {their_time * 1e3:>13.1f} "
              f"{their_time / our_time:>8.0f} {error:>11.1e}", flush=True)


if __name__ == "__main__":
    main()
