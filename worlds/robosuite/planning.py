"""Plans of wisch for the Wipe task: task, tool and surface from the environment, strokes from `wisch plan`."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

LEADING = 0.03
"""Length with which a tool that leans forward wipes [m]."""

TASK = """\
schema = 1
name = "robosuite-wipe"
seed = {seed}
action = "absorb"
strategy = "{strategy}"
target_performance = 1.0

[tool]
name = "wiping_gripper"
footprint_m = [{length:.6f}, {width:.6f}]
start_m = [{start[0]:.6f}, {start[1]:.6f}]
compression_depth_m = 0.001

[medium]
name = "markers"
kind = "solid"

[surface]
name = "wipe_table"
friction = 0.03
size_m = [{sizes[0]:.6f}, {sizes[1]:.6f}]
position_m = [{middle[0]:.6f}, {middle[1]:.6f}, {middle[2]:.6f}]

[interaction]
press_force_n = 25.0
stiffness_n_per_m = 500.0

[plan]
margin_m = {margin}
contact_speed_m_per_s = {speed}

[particles]
source = "csv"
file = "markers.csv"
"""


def program():
    """Returns the program `wisch`: the one that WISCH names, one that was built in this checkout, or one on the path."""
    named = os.environ.get("WISCH")
    built = Path(__file__).resolve().parents[2] / "target" / "release" / "wisch"
    found = named or (str(built) if built.exists() else shutil.which("wisch"))
    if found is None:
        sys.exit("the program wisch is needed: cargo build --release -p wisch-cli, or WISCH=/path/to/wisch")
    return found


def task_of(world, markers, start, margin, speed, seed=1, strategy="best"):
    """Returns the text of a task file and the CSV of its particles, in the frame of the table's centre."""
    middle, sizes = world.table()
    tool = world.tool()
    text = TASK.format(
        seed=seed,
        strategy=strategy,
        length=min(tool.length, LEADING),
        width=tool.width,
        start=start - middle[:2],
        sizes=sizes,
        middle=middle,
        margin=margin,
        speed=speed,
    )
    rows = "".join(f"{x:.6f},{y:.6f}\n" for x, y in markers - middle[:2])
    return text, "x,y\n" + rows


def strokes(world, markers, start, margin, speed):
    """Returns the strokes of wisch's best plan to absorb the markers: a list of (n, 3), x, y and the broad side's angle."""
    text, particles = task_of(world, markers, start, margin, speed)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "task.toml").write_text(text)
        (folder / "markers.csv").write_text(particles)
        command = [program(), "plan", str(folder / "task.toml"), "--out", str(folder / "plan"), "--quiet"]
        ran = subprocess.run(command, capture_output=True, text=True)
        if ran.returncode != 0:
            raise RuntimeError(f"wisch plan ended with {ran.returncode}: {ran.stderr.strip()}")
        plan = json.loads((folder / "plan" / "plan.json").read_text())
    middle, _ = world.table()
    found = []
    for stroke in plan["strokes"]:
        poses = np.array([[p["x_m"], p["y_m"], p["heading_rad"] + np.pi / 2] for p in stroke["surface_from_tool"]])
        poses[:, :2] += middle[:2]
        found.append(poses)
    return found


def wipe(world, follower, margin=0.004, looks=6):
    """Plans for the observed markers, and follows the plan stroke by stroke without lifting the tool. After the last stroke it
    observes and plans again, as long as markers are left."""
    for _ in range(looks):
        markers = world.visible_markers()
        if world.done or len(markers) == 0:
            return
        for stroke in strokes(world, markers, follower.pose()[:2], margin, follower.config.speed):
            follower.follow(stroke)
