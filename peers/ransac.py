"""Compares wisch's plane of contacts with scikit-learn's RANSACRegressor on the same points.

    pip install -r peers/requirements.txt
    python peers/ransac.py

The points lie on a plane with 0.3 mm of noise; a share of them lies anywhere within 5 cm of it. Both programs
get the same inlier distance of 1 mm and the same confidence. scikit-learn measures distances along z, wisch
perpendicular to the plane, which differs by less than a thousandth at these slopes. Both return a
least-squares fit of the inliers of the best sample. Errors are the largest difference from the true plane
over the board. Times are the fastest of 20 runs.
"""

import pathlib
import subprocess
import tempfile
import time

import numpy
from sklearn.linear_model import LinearRegression, RANSACRegressor

from wisch_examples import example

INLIER_DISTANCE = 1e-3
CONFIDENCE = 0.9999
RUNS = 20
HEIGHT, SLOPE = 0.004, numpy.array([0.03, -0.02])
CORNERS = numpy.array([[x, y] for x in (-0.2, 0.2) for y in (-0.14, 0.14)])


def points(count, outliers, seed):
    generator = numpy.random.default_rng(seed)
    place = generator.uniform([-0.2, -0.14], [0.2, 0.14], (count, 2))
    z = HEIGHT + place @ SLOPE + generator.normal(0, 3e-4, count)
    off = generator.random(count) < outliers
    z[off] += generator.uniform(-0.05, 0.05, off.sum())
    return numpy.column_stack([place, z])


def error(height, slope):
    return numpy.abs(height - HEIGHT + CORNERS @ (numpy.asarray(slope) - SLOPE)).max()


def wisch(cloud, folder):
    path = pathlib.Path(folder) / "points.csv"
    numpy.savetxt(path, cloud, delimiter=",", fmt="%.17g")
    run = subprocess.run([example("plane"), str(path), str(INLIER_DISTANCE)],
                         capture_output=True, text=True, check=True)
    height, *slope = (float(value) for value in run.stdout.split(",")[:3])
    return error(height, slope), float(run.stderr.splitlines()[-1]) * 1e-3


def scikit(cloud):
    best = float("inf")
    for _ in range(RUNS):
        model = RANSACRegressor(LinearRegression(), min_samples=3, residual_threshold=INLIER_DISTANCE,
                                stop_probability=CONFIDENCE, max_trials=1000, random_state=1)
        begin = time.perf_counter()
        model.fit(cloud[:, :2], cloud[:, 2])
        best = min(best, time.perf_counter() - begin)
    return error(model.estimator_.intercept_, model.estimator_.coef_), best


def compared():
    """Points, share of outliers, our time and theirs [s], and how far either is off the true plane [m]."""
    with tempfile.TemporaryDirectory() as folder:
        for count in (500, 5_000, 50_000):
            for outliers in (0.1, 0.3, 0.5):
                cloud = points(count, outliers, 7)
                our_error, our_time = wisch(cloud, folder)
                their_error, their_time = scikit(cloud)
                yield count, outliers, our_time, their_time, our_error, their_error


def main():
    print(f"{'points':>7} {'outliers':>9} {'wisch [ms]':>11} {'sklearn [ms]':>13} {'ratio':>6} "
          f"{'wisch off by [mm]':>18} {'sklearn off by [mm]':>20}")
    for count, outliers, our_time, their_time, our_error, their_error in compared():
        print(f"{count:>7} {outliers:>9.0%} {our_time * 1e3:>11.3f} {their_time * 1e3:>13.2f} "
              f"{their_time / our_time:>6.0f} {our_error * 1e3:>18.4f} {their_error * 1e3:>20.4f}", flush=True)


if __name__ == "__main__":
    main()
