#!/usr/bin/env python3
"""Compares wisch-fleet with DuckDB: SQL over the same Parquet files and views, with the same answers.

    cargo run --release --features synthetic --bin synthetic_fleet -- --episodes 1000000 --out /tmp/fleet   # in crates/wisch-fleet
    peers/fleet.py /tmp/fleet --program target/release/wisch-fleet

Times are those of the query alone, repeated in a process that has listed the files already. A further column has the time of the whole
program from its start to the answer. Runs of the two programs alternate; the table shows medians.
"""

import argparse
import glob
import json
import os
import statistics
import subprocess
import sys
import time

import duckdb

VIEWS = os.path.join(os.path.dirname(__file__), "..", "crates", "wisch-fleet", "src", "views.sql")
QUESTIONS = [
    ("performance of 80 % or less", "SELECT count(*) AS n, sum(performance) AS s FROM low_performance"),
    ("collisions overlapping strokes", "SELECT count(*) AS n, sum(overlap_s) AS s FROM collisions_in_strokes"),
    (
        "peak force per collision, one robot-day",
        "SELECT count(*) AS n, sum(peak_force_n) AS s FROM peak_force_per_collision WHERE robot = '{robot}' AND day = DATE '{day}'",
    ),
]


def live_files(fleet):
    """The files that count, by table: what all commits come to."""
    files = {}
    for path in sorted(glob.glob(os.path.join(fleet, "log", "*.json"))):
        with open(path, encoding="utf-8") as text:
            commit = json.load(text)
        for gone in commit["remove"]:
            files.pop(gone, None)
        for entry in commit["add"]:
            files[entry["path"]] = entry
    tables = {}
    for entry in files.values():
        tables.setdefault(entry["table"], []).append(os.path.join(fleet, entry["path"]))
    return tables


def connect(fleet, threads):
    """DuckDB with the tables and the shipped views."""
    connection = duckdb.connect()
    connection.execute(f"SET threads = {threads}")
    for table, files in live_files(fleet).items():
        names = ", ".join("'" + name.replace("'", "''") + "'" for name in files)
        connection.execute(f"CREATE VIEW {table} AS SELECT * FROM read_parquet([{names}], hive_partitioning = false)")
    with open(VIEWS, encoding="utf-8") as text:
        connection.execute(text.read())
    return connection


def close(one, other):
    """Sums are taken in another order."""
    return all(abs(a - b) <= 1e-6 * max(1.0, abs(a)) for a, b in zip(one, other))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("fleet")
    parser.add_argument("--program", default="target/release/wisch-fleet")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--robot", default="robot-000")
    parser.add_argument("--day", default="2026-01-05")
    args = parser.parse_args()
    threads = os.cpu_count()
    print(f"{threads} cores, load {os.getloadavg()[0]:.1f}; DuckDB {duckdb.__version__}; medians of {args.runs} runs, seconds")
    print(f"{'question':<42} {'wisch-fleet':>11} {'DuckDB':>8} {'ratio':>6} {'whole program':>14}")
    connection = connect(args.fleet, threads)
    for name, sql in QUESTIONS:
        sql = sql.format(robot=args.robot, day=args.day)
        ours, theirs, whole = [], [], []
        for _ in range(args.runs):
            begun = time.perf_counter()
            out = ask(args, sql)
            whole.append(time.perf_counter() - begun)
            # The second answer of one process: it has begun, as the other has.
            out = ask(args, f"{sql}; {sql}")
            ours.append(float(out.stderr.split()[2]))
            begun = time.perf_counter()
            (their_row,) = connection.execute(sql).fetchall()
            theirs.append(time.perf_counter() - begun)
            answer = json.loads(out.stdout.splitlines()[0])
            our_row = (answer["n"], answer.get("s") or 0.0)
            if not close(our_row, (their_row[0], their_row[1] or 0.0)):
                sys.exit(f"{name}: wisch-fleet says {our_row}, DuckDB {their_row}")
        ours, theirs, whole = (statistics.median(times) for times in (ours, theirs, whole))
        print(f"{name:<42} {ours:>11.4f} {theirs:>8.4f} {ours / theirs:>6.2f} {whole:>14.3f}")


def ask(args, sql):
    """What the program says, and on standard error how long each statement took."""
    command = [args.program, "sql", sql, "--fleet", args.fleet, "--json", "--timing"]
    return subprocess.run(command, check=True, capture_output=True, text=True)


if __name__ == "__main__":
    main()
