"""Compares wisch's closed tours with two other solvers on the same points.

    pip install -r peers/requirements.txt
    python peers/tours.py points    # writes the uniform random points that the tests read
    python peers/tours.py best      # best known lengths: LKH (elkai), ten runs per instance
    python peers/tours.py compare   # lengths and times of wisch and OR-tools, beside the best known lengths

LKH, which elkai wraps, is licensed for academic and non-commercial use; nothing here depends on it.
"""

import csv
import math
import pathlib
import random
import subprocess
import sys
import time

from wisch_examples import example

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
DATA = REPOSITORY / "crates" / "wisch" / "tests" / "data"
UNIFORM_COUNTS = (12, 50, 200, 500, 1000)
# Both solvers compute with whole numbers: one unit is a millionth of the square's side.
UNITS_PER_SIDE = 1_000_000


def data_file(count):
    return DATA / f"uniform{count}.csv"


def write_points():
    for count in UNIFORM_COUNTS:
        generator = random.Random(count)
        rows = [f"{generator.random():.6f},{generator.random():.6f}\n" for _ in range(count)]
        data_file(count).write_text("".join(rows))


def read_points(path):
    with open(path, newline="") as file:
        return [(float(x), float(y)) for x, y in csv.reader(file)]


def path_length(points, order):
    return sum(math.dist(points[a], points[b]) for a, b in zip(order, order[1:]))


def length(points, order):
    return path_length(points, [*order, order[0]])


def whole_distances(points):
    return [[round(math.dist(a, b) * UNITS_PER_SIDE) for b in points] for a in points]


def lkh(points, runs):
    import elkai

    begin = time.perf_counter()
    closed = elkai.DistanceMatrix(whole_distances(points)).solve_tsp(runs)
    return length(points, closed[:-1]), time.perf_counter() - begin


def lkh_open_path(points, runs):
    """Length of a path from the first point with a free end: every way back to it is free."""
    import elkai

    distances = [[0, *row[1:]] for row in whole_distances(points)]
    closed = elkai.DistanceMatrix(distances).solve_tsp(runs)
    return path_length(points, closed[:-1])


def ortools_routing(points, seconds):
    from ortools.constraint_solver import pywrapcp, routing_enums_pb2

    distances = whole_distances(points)
    begin = time.perf_counter()
    manager = pywrapcp.RoutingIndexManager(len(points), 1, 0)
    model = pywrapcp.RoutingModel(manager)
    model.SetArcCostEvaluatorOfAllVehicles(model.RegisterTransitMatrix(distances))
    parameters = pywrapcp.DefaultRoutingSearchParameters()
    parameters.first_solution_strategy = routing_enums_pb2.FirstSolutionStrategy.PATH_CHEAPEST_ARC
    parameters.local_search_metaheuristic = (
        routing_enums_pb2.LocalSearchMetaheuristic.GUIDED_LOCAL_SEARCH
    )
    parameters.time_limit.FromMilliseconds(round(1000 * seconds))
    solution = model.SolveWithParameters(parameters)
    order = []
    index = model.Start(0)
    while not model.IsEnd(index):
        order.append(manager.IndexToNode(index))
        index = solution.Value(model.NextVar(index))
    return length(points, order), time.perf_counter() - begin


def wisch(path):
    printed = subprocess.run([example("tour"), path], check=True, capture_output=True, text=True)
    tour_length, _, milliseconds = printed.stdout.strip().split(",")
    return float(tour_length), float(milliseconds) / 1000


def print_best():
    for count in UNIFORM_COUNTS:
        points = read_points(data_file(count))
        best, seconds = lkh(points, runs=10)
        print(f"uniform{count}: {best:.6f} ({seconds:.1f} s)", flush=True)
    path = lkh_open_path(read_points(data_file(200)), runs=10)
    print(f"uniform200, open from the first point: {path:.6f}")


def compared():
    """Nodes, then length and time [s] of LKH's tour, of wisch's, and of OR-tools' within the time of wisch's."""
    for count in UNIFORM_COUNTS:
        points = read_points(data_file(count))
        best, lkh_seconds = lkh(points, runs=1)
        ours, our_seconds = wisch(data_file(count))
        theirs, their_seconds = ortools_routing(points, seconds=max(0.1, our_seconds))
        yield count, (best, lkh_seconds), (ours, our_seconds), (theirs, their_seconds)


def compare():
    print("nodes   wisch/LKH length   time   OR-tools/LKH length   time   (time: share of LKH's)")
    for count, (best, lkh_seconds), (ours, our_seconds), (theirs, their_seconds) in compared():
        print(
            f"{count:5}   {ours / best:16.4f} {our_seconds / lkh_seconds:7.3f}"
            f"   {theirs / best:18.4f} {their_seconds / lkh_seconds:7.3f}",
            flush=True,
        )


if __name__ == "__main__":
    commands = {"points": write_points, "best": print_best, "compare": compare}
    if len(sys.argv) != 2 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    commands[sys.argv[1]]()
