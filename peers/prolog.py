"""Compares both Prolog engines on the same memory: duration and number of answers of each query.

    cargo build --release --workspace --bins --examples
    target/release/examples/synthetic --episodes 10000 --out /tmp/memory
    python3 peers/prolog.py /tmp/memory

Needs swipl (SWI-Prolog). `cargo test --workspace ask::` compares the answers themselves.
"""

import re
import subprocess
import sys

ASK = "target/release/examples/ask"
QUERIES = [
    "has_data_value(A, performance =< 0.8)",
    "low_performance_round(R, P)",
    "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])",
    "peak_force_per_collision(C, F)",
    "last_episode(Episode, _), human_collision_in(Episode, M, C, I)",
    "findall(B, (has_data_value(B, peakForce > 30), has_type(B, 'Collision')), L), length(L, N)",
    "contact_force_drift(Surface, Slope, First, Last)",
    "has_type(C, 'Collision'), has_type(S, 'Stroke'), interval_during(C, S)",
]


def times(memory, flags):
    """Lines of the table: cold, warm [ms], answers, by query."""
    text = subprocess.run([ASK, *flags, memory, *QUERIES], capture_output=True, text=True, check=True).stdout
    found = {}
    for line in text.splitlines():
        match = re.match(r"\s*([\d.]+) ms\s+([\d.]+) ms\s+(\d+)  (.*)", line)
        if match:
            found[match[4]] = (float(match[1]), float(match[2]), int(match[3]))
        elif ":" in line and "episodes" not in line:
            sys.exit(line)
    return found


def main():
    memory = sys.argv[1]
    ours, theirs = times(memory, []), times(memory, ["--swi"])
    print(f"{'Scryer: cold, warm':>24} {'SWI: cold, warm [ms]':>24} {'answers':>8}")
    wrong = 0
    for query in QUERIES:
        a, b = ours[query], theirs[query]
        print(f"{a[0]:14.1f} {a[1]:9.1f} {b[0]:14.1f} {b[1]:9.1f} {a[2]:8d}  {query}")
        wrong += a[2] != b[2]
    if wrong:
        sys.exit(f"{wrong} queries have other numbers of answers")


main()
