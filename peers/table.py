"""Prints one table of the times of wisch and its peers for the same computations, from one run.

    pip install -r peers/requirements.txt
    python peers/table.py

Times are medians; for planes they are the fastest of 20 runs, and for densities, tours and timings of one run. They depend on the
other work of the machine, so compare ratios, not times. The script of each pair says what the two programs share, and where they differ.
"""

import logging
import platform
import subprocess

import effect
import ik
import kde
import ransac
import timing
import tours


def rows():
    """Computation, our time [s], the peer, its time [s], and how the answers compare."""
    for count, ours, theirs, apart in effect.compared():
        yield f"push stroke of 0.4 m, {count:,} particles", ours, "NumPy, vectorised", theirs, f"{apart:.0e} m apart"
    for count, _, ours, theirs, error in kde.compared():
        yield f"density of {count:,} particles", ours, "scikit-learn", theirs, f"{error:.0e} apart, relative"
    for count, outliers, ours, theirs, our_error, their_error in ransac.compared():
        quality = f"off by {1e3 * our_error:.3f} and {1e3 * their_error:.3f} mm"
        yield f"plane through {count:,} points, {outliers:.0%} wrong", ours, "scikit-learn", theirs, quality
    for chain, solver, solved, _, median, _ in ik.compared(300):
        if solver == "wisch":
            ours, our_share = 1e-6 * median, solved
        else:
            quality = f"{our_share:.1f} and {solved:.1f} % solved"
            yield f"inverse kinematics, {chain}", ours, solver, 1e-6 * median, quality
    for path, (ours, same, spline) in timing.compared():
        for peer, (duration, milliseconds, _) in (("toppra, same corners", same), ("toppra, spline", spline)):
            quality = f"{ours[0]:.3f} and {duration:.3f} s long"
            yield f"timing, {path.replace(' x ', ' × ')} joints", 1e-3 * ours[2], peer, 1e-3 * milliseconds, quality
    for count, best, ours, theirs in tours.compared():
        for peer, (length, seconds) in (("LKH", best), ("OR-tools", theirs)):
            quality = f"{ours[0] / length:.3f} times as long"
            yield f"tour of {count} nodes", ours[1], peer, seconds, quality


def in_words(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            break
    return f"{seconds / size:.3g} {unit}"


def ratio(value):
    return f"{value:,.0f}" if value >= 10 else f"{value:.2g}"


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def main():
    logging.disable(logging.WARNING)
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True).stdout.strip()
    print(f"{processor()}; {rustc}; Python {platform.python_version()}\n")
    print("| computation | wisch | peer | takes | times as long | answers (wisch first) |")
    print("|---|--:|---|--:|--:|---|", flush=True)
    for what, ours, peer, theirs, quality in rows():
        print(f"| {what} | {in_words(ours)} | {peer} | {in_words(theirs)} | {ratio(theirs / ours)} | {quality} |", flush=True)


if __name__ == "__main__":
    main()
