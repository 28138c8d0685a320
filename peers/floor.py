"""Compares wisch with the planner arm_coverage, on a floor of targets that its authors publish, with the arm Panda.

    git clone https://github.com/uwgraphics/arm_coverage
    python peers/floor.py PANDA.urdf arm_coverage/surfaces/panda_20240825_154124_floor.csv

PANDA.urdf is any URDF of the Panda with its hand, with links named panda_link0 to panda_link7 and panda_hand. Its meshes are not
needed: the capsules below replace them, so that the arm is checked against the floor and against itself.

arm_coverage (Wang and Gleicher, ICRA 2025) puts the frame of the hand on each target, pointing down, with a fixed yaw. It checks no
collisions. It does not count the joint movement of a reconfiguration, in which the tool leaves the floor.

In wisch the hand holds a pad. The floor lies lower by the height of the pad, so the hand passes through the same positions, and the
yaw is free. Every motion is checked for collisions and audited, and joints stay 0.02 rad inside their limits.

The joint movement of wisch is the length of the path in joint space, sampled every 10 ms, from the ready posture and back, and the
part of it in contact. That of arm_coverage is summed up from target to target.
"""

import argparse
import math
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Height of the hand's frame, which is on the targets, above the floor [m]: the pad reaches this far beyond the frame.
HAND_HEIGHT = 0.1

# About as thick as the links: radius, and ends of the axis in the link's frame [m].
CAPSULES = {
    "panda_link0": [(0.09, (-0.06, 0, 0.05), (0.0, 0, 0.05))],
    "panda_link1": [(0.07, (0, 0, -0.25), (0, 0, -0.03)), (0.07, (0, -0.07, 0), (0, 0.0, 0))],
    "panda_link2": [(0.07, (0, 0, 0.0), (0, 0, 0.07)), (0.07, (0, -0.16, 0), (0, 0.0, 0))],
    "panda_link3": [(0.07, (0, 0, -0.16), (0, 0, -0.06)), (0.06, (0.0, 0, 0), (0.08, 0.06, 0))],
    "panda_link4": [(0.065, (0, 0, 0.0), (0, 0, 0.06)), (0.065, (-0.08, 0.1, 0), (-0.08, 0.04, 0))],
    "panda_link5": [
        (0.06, (0, 0, -0.26), (0, 0, -0.2)),
        (0.04, (0, 0.08, -0.19), (0, 0.08, -0.03)),
        (0.055, (0, 0.02, 0), (0, 0.07, 0)),
    ],
    "panda_link6": [(0.055, (0, 0, -0.02), (0, 0, 0.02)), (0.055, (0.08, 0.0, 0), (0.08, 0.04, 0))],
    "panda_link7": [(0.05, (0, 0, 0.03), (0, 0, 0.08))],
    "panda_hand": [(0.035, (0, -0.08, 0.03), (0, 0.08, 0.03))],
}

# Joint movement [rad], reconfigurations, computing [s]: arm_coverage at commit 5157c74 on two shared cores.
PEER = [
    ("arm_coverage, H-Joint-GTSP, 100 samples", 122.5, 1, 535),
    ("arm_coverage, H-Joint-GTSP, 60 samples", 123.5, 1, 163),
    ("arm_coverage, Cartesian TSP, 100 samples", 166.8, 2, 350),
]

# What is the robot's to choose, as the example calls it. The nodes of the narrow pad are the targets themselves: the centre of each
# is passed.
OURS = [("free-yaw", "wisch, the yaw is the robot's"), ("free-order", "wisch, yaw and order are the robot's")]
PAD = ["--pad", "0.0175", "--strategy", "kde", "--bandwidth", "0.01"]


def with_capsules(urdf):
    """The URDF with capsules for the meshes of its collision elements."""

    def link(found):
        head, name, body = found.group(1), found.group(2), found.group(3)
        if name in CAPSULES:
            body = re.sub(r"<collision>.*?</collision>", "", body, flags=re.DOTALL)
            body += "".join(capsule(*of) for of in CAPSULES[name])
        return f"{head}{body}</link>"

    return re.sub(r'(<link name="([^"/]+)">)(.*?)</link>', link, urdf, flags=re.DOTALL)


def capsule(radius, begin, end):
    x, y, z = (b - a for a, b in zip(begin, end))
    pitch, yaw = math.atan2(math.hypot(x, y), z), math.atan2(y, x)
    middle = " ".join(str((a + b) / 2) for a, b in zip(begin, end))
    return (
        f'<collision><origin xyz="{middle}" rpy="0 {pitch} {yaw}"/>'
        f'<geometry><capsule radius="{radius}" length="{math.dist(begin, end)}"/></geometry></collision>'
    )


def followed(urdf, targets, tool):
    """What the example prints of one row, by the first words of its columns."""
    command = ["cargo", "run", "--quiet", "--release", "--package", "wisch", "--example", "floor", "--"]
    command += ["--urdf", urdf, "--tip", "panda_hand", "--hand-height", str(HAND_HEIGHT), "--targets", targets]
    out = subprocess.run([*command, *PAD, "--tool", tool], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    names = "plan tool contact all lifts abandoned covered passed faults motion computing".split()
    return dict(zip(names, out.stdout.splitlines()[2].split()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", help="the Panda's URDF")
    parser.add_argument("targets", help="the floor's CSV")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        urdf = pathlib.Path(folder) / "panda.urdf"
        urdf.write_text(with_capsules(pathlib.Path(arguments.urdf).read_text()))
        targets = str(pathlib.Path(arguments.targets).resolve())
        row = "{:44} {:>12} {:>11} {:>8} {:>8} {:>7} {:>7} {:>14}".format
        print(row("", "joints [rad]", "in contact", "reconf.", "strokes", "passed", "faults", "computing [s]"))
        for name, movement, reconfigurations, seconds in PEER:
            print(row(name, movement, "", reconfigurations, "", "100%", "-", seconds))
        for tool, name in OURS:
            got = followed(str(urdf), targets, tool)
            reconfigurations = int(got["lifts"]) - 1
            numbers = got["all"], got["contact"], reconfigurations, got["lifts"], got["passed"], got["faults"]
            print(row(name, *numbers, got["computing"]))


if __name__ == "__main__":
    main()
