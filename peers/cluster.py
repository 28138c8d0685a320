#!/usr/bin/env python3
"""Measures large queries on a cluster with two executors and with one, each of one slot, on this machine and the same files.

    cargo run --release --features synthetic --bin synthetic_fleet -- --episodes 1000000 --out /tmp/fleet   # in crates/wisch-fleet
    cargo build --release --features cluster
    peers/cluster.py /tmp/fleet --program target/release/wisch-fleet

Two schedulers run, one with one executor and one with two. Times are those of the query alone, in a process that has started already.
A further column has the program without a cluster, which uses all cores. Runs alternate; the table shows medians.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys

QUESTIONS = [
    ("collisions overlapping strokes", "SELECT count(*) AS n, sum(overlap_s) AS s FROM collisions_in_strokes"),
    (
        "force by tool and surface over all strokes",
        "SELECT sum(n) AS n, sum(f) AS s FROM (SELECT tool, surface, count(*) AS n, avg(mean_normal_force_n) AS f FROM strokes GROUP BY tool, surface)",
    ),
    (
        "events by class and robot",
        "SELECT sum(n) AS n, sum(f) AS s FROM (SELECT class, robot, count(*) AS n, max(peak_force_n) AS f FROM events GROUP BY class, robot)",
    ),
    (
        "longest motion of each episode",
        "SELECT count(*) AS n, sum(s) AS s FROM (SELECT episode, max(end_s - start_s) AS s FROM motions GROUP BY episode)",
    ),
]


class Cluster:
    """A scheduler and its executors, until the end of a with-block."""

    def __init__(self, program, executors):
        self.program = program
        self.count = executors
        self.processes = []

    def begin(self, *args):
        """A process, and its first line: it says when it is ready."""
        process = subprocess.Popen([self.program, *args], stdout=subprocess.PIPE, text=True)
        self.processes.append(process)
        return process.stdout.readline().strip()

    def __enter__(self):
        self.url = self.begin("scheduler", "--bind", "127.0.0.1:0").rsplit(" ", 1)[-1]
        for _ in range(self.count):
            self.begin("executor", "--scheduler", self.url, "--slots", "1")
        return self

    def __exit__(self, *_):
        # The scheduler last: executors say good-bye to it.
        for process in reversed(self.processes):
            process.terminate()
            process.wait()


def ask(args, sql, *more):
    """The answer, and how long the second of two took that one process asked for [s]."""
    command = [args.program, "sql", f"{sql}; {sql}", "--fleet", args.fleet, "--json", "--timing", *more]
    out = subprocess.run(command, check=True, capture_output=True, text=True)
    answer = json.loads(out.stdout.splitlines()[0])
    return (answer["n"], answer.get("s") or 0.0), float(out.stderr.split()[2])


def close(one, other):
    """Sums are taken in another order."""
    return all(abs(a - b) <= 1e-6 * max(1.0, abs(a)) for a, b in zip(one, other))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("fleet")
    parser.add_argument("--program", default="target/release/wisch-fleet")
    parser.add_argument("--runs", type=int, default=7)
    args = parser.parse_args()
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}; medians of {args.runs} runs, seconds")
    print(f"{'question':<44} {'1 executor':>10} {'2 executors':>11} {'ratio':>6} {'no cluster':>10}")
    with Cluster(args.program, 1) as one, Cluster(args.program, 2) as two:
        for name, sql in QUESTIONS:
            times = ([], [], [])
            for _ in range(args.runs):
                answers = []
                for place, more in enumerate((("--cluster", one.url), ("--cluster", two.url), ())):
                    answer, seconds = ask(args, sql, *more)
                    answers.append(answer)
                    times[place].append(seconds)
                if not all(close(answers[2], answer) for answer in answers):
                    sys.exit(f"{name}: the answers are {answers}")
            single, double, here = (statistics.median(some) for some in times)
            print(f"{name:<44} {single:>10.3f} {double:>11.3f} {single / double:>6.2f} {here:>10.3f}")
    print(f"load {os.getloadavg()[0]:.1f} in the end")


if __name__ == "__main__":
    main()
