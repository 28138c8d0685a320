#!/usr/bin/env python3
"""Compares ways to wipe in robosuite's Wipe task: `python worlds/robosuite/compare.py --seeds 10000:10050 --robot Panda`.

Prints a table, and writes a CSV with a row for each episode. Exit code 0 if every episode of wisch is complete, else 1.
"""

import argparse
import csv
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

try:
    import numpy as np

    from follower import Follower
    from peers import oracle_tour, zigzag_area, zigzag_box
    from planning import wipe
    from wipe_environment import ROBOTS, WipeEnvironment
except ImportError as error:
    sys.exit(f"{error}: pip install -r worlds/robosuite/requirements.txt")

WAYS = {"wisch": wipe, "oracle": oracle_tour, "zigzag 9 cm": zigzag_box, "zigzag 3 cm": zigzag_area}
COLUMNS = ["robot", "way", "seed", "ending", "markers", "wiped", "time_s", "force_median_n", "force_p99_n", "force_max_n"]


def episode(robot, way, seed):
    """Runs one episode; returns its row of the CSV."""
    world = WipeEnvironment(robot, seed)
    follower = Follower(world)
    total = len(world.visible_markers())
    WAYS[way](world, follower)
    forces = np.array(follower.pressed or [0.0])
    row = {
        "robot": robot,
        "way": way,
        "seed": seed,
        "ending": world.ending(),
        "markers": total,
        "wiped": total - len(world.visible_markers()),
        "time_s": round(world.time, 3),
        "force_median_n": round(float(np.median(forces)), 2),
        "force_p99_n": round(float(np.percentile(forces, 99)), 2),
        "force_max_n": round(float(forces.max()), 2),
    }
    world.close()
    return row, forces


def summary(way, rows, forces):
    """Returns a line of the table."""
    times = [row["time_s"] for row in rows]
    complete = [row["time_s"] for row in rows if row["ending"] == "complete"]
    stopped = sum(row["ending"] in ("joint limit", "collision") for row in rows)
    share = 100.0 * sum(row["wiped"] for row in rows) / sum(row["markers"] for row in rows)
    forces = np.concatenate(forces)
    return (
        f"| {way} | {share:.1f} % | {len(complete)} of {len(rows)} | {np.median(times):.2f} s | "
        f"{max(times):.2f} s | {np.median(forces):.1f} N | {np.percentile(forces, 99):.1f} N | {stopped} |"
    )


def seeds_of(text):
    """Reads a range of seeds: 10000:10050 is 10000 to 10049, and a single number is itself."""
    first, _, last = text.partition(":")
    return range(int(first), int(last) if last else int(first) + 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=seeds_of, default=seeds_of("1000:1005"), help="FIRST:END, END left out")
    parser.add_argument("--robot", choices=ROBOTS, default="Panda")
    parser.add_argument("--ways", default=",".join(WAYS), help="which of: " + ", ".join(WAYS))
    parser.add_argument("--jobs", type=int, default=1, help="episodes at a time")
    parser.add_argument("--out", type=Path, default=Path("out/robosuite"), help="folder of the CSV")
    arguments = parser.parse_args()
    ways = [way.strip() for way in arguments.ways.split(",")]
    if unknown := [way for way in ways if way not in WAYS]:
        parser.error(f"unknown way {unknown[0]!r}; known: " + ", ".join(WAYS))

    jobs = [(arguments.robot, way, seed) for seed in arguments.seeds for way in ways]
    results = {way: ([], []) for way in ways}
    with ProcessPoolExecutor(arguments.jobs) as pool:
        for row, forces in pool.map(episode, *zip(*jobs)):
            results[row["way"]][0].append(row)
            results[row["way"]][1].append(forces)
            print("{robot} {seed} {way}: {ending}, {wiped} of {markers}, {time_s} s".format(**row), file=sys.stderr, flush=True)

    arguments.out.mkdir(parents=True, exist_ok=True)
    path = arguments.out / f"{arguments.robot}-{arguments.seeds.start}-{arguments.seeds.stop}.csv"
    unfinished = path.with_suffix(".csv.part")
    with unfinished.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for way in ways:
            writer.writerows(results[way][0])
    unfinished.replace(path)

    print(f"{arguments.robot}, seeds {arguments.seeds.start} to {arguments.seeds.stop - 1}, robosuite's Wipe\n")
    print("| way | markers | complete | time, median | longest | force, median | 99th percentile | joint limits, collisions |")
    print("|---|---|---|---|---|---|---|---|")
    for way in ways:
        print(summary(way, *results[way]))
    print(f"\nwrote {path}")
    ours = results.get("wisch", ([], []))[0]
    return 0 if all(row["ending"] == "complete" for row in ours) else 1


if __name__ == "__main__":
    sys.exit(main())
