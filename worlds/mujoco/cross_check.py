#!/usr/bin/env python3
"""Executes one motion in two physics engines, Rapier and MuJoCo, with the same crumbs: `python worlds/mujoco/cross_check.py`.

The program `wisch` plans, executes in Rapier, and writes a bag. It is the program that WISCH names, one that was built in this
checkout, or one on the path. The wheel plans the same motion, which MuJoCo executes. The output compares joint torques, contact
force, tool path, and the final positions of the crumbs. Exit code 0 if the two motions are the same, else 2.
"""

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
except ImportError as error:
    sys.exit(f"{error}: pip install -r worlds/mujoco/requirements.txt ./crates/wisch-py")

TOPICS = {"/tcp/measured", "/tcp/commanded", "/wrench/external", "/joint_states"}


def program():
    """Returns the path of the program `wisch`."""
    built = Path(__file__).resolve().parents[2] / "target" / "release" / "wisch"
    found = os.environ.get("WISCH") or (str(built) if built.exists() else shutil.which("wisch"))
    if found is None:
        sys.exit("the program wisch is needed: cargo build --release -p wisch-cli, or WISCH=/path/to/wisch")
    return found


def in_rapier(scenario, settings, folder):
    """Returns the telemetry of the round in Rapier, with the columns of the wheel, and the final crumbs."""
    command = [program(), "run", scenario, "--rounds", "1", "--out", str(folder), "--quiet", "--no-memory"]
    for key, value in settings.items():
        command += ["--set", f"{key}={toml(value)}"]
    ran = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    if ran.returncode not in (0, 1):
        sys.exit(f"wisch run ended with {ran.returncode}: {ran.stderr.strip()}")
    with (folder / "particles" / "particles-true.csv").open() as file:
        rows = list(csv.DictReader(file))
    places = np.array([[float(row["x_m"]), float(row["y_m"])] for row in rows])
    fates = [row["fate"] for row in rows]
    return bag(folder / "telemetry" / "round-1.mcap"), places, fates


def toml(value):
    """Returns a value as TOML text."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(v)}" for key, v in value.items()) + "}"
    return json.dumps(value)


def bag(path):
    """Returns the columns of a bag."""
    try:
        from mcap.reader import make_reader
        from mcap_ros2.decoder import DecoderFactory
    except ImportError as error:
        sys.exit(f"bags are read with mcap and mcap-ros2-support ({error}): pip install -r worlds/mujoco/requirements.txt")
    columns = {"time_s": [], "world_from_tool": [], "world_from_commanded": [], "force_n": [], "efforts": [], "joints": None}
    with path.open("rb") as file:
        for _, channel, _, message in make_reader(file, decoder_factories=[DecoderFactory()]).iter_decoded_messages(topics=TOPICS):
            if channel.topic == "/joint_states":
                columns["time_s"].append(message.header.stamp.sec + 1e-9 * message.header.stamp.nanosec)
                columns["efforts"].append(list(message.effort))
                columns["joints"] = list(message.name)
            elif channel.topic == "/wrench/external":
                force = message.wrench.force
                columns["force_n"].append([force.x, force.y, force.z])
            else:
                key = "world_from_tool" if channel.topic == "/tcp/measured" else "world_from_commanded"
                place = message.pose.position
                columns[key].append([place.x, place.y, place.z])
    result = {key: np.array(column) for key, column in columns.items() if key != "joints"}
    result["time_s"] -= result["time_s"][0]
    return result | {"joints": columns["joints"]}


def in_mujoco(task, settings):
    """Returns the same round, executed in MuJoCo."""
    from wisch_mujoco import World

    world = World(task, set=settings)
    (round_,) = task.session(robot=task.robot(), rounds=1).run(world)
    telemetry = round_.telemetry
    columns = {
        "time_s": np.asarray(telemetry.time_s),
        "world_from_tool": np.asarray(telemetry.world_from_tool)[:, :3],
        "world_from_commanded": np.asarray(telemetry.world_from_commanded)[:, :3],
        "force_n": np.asarray(telemetry.force_n),
        "efforts": np.asarray(telemetry.efforts),
        "joints": list(round_.motion.joints),
    }
    return columns, world, round_


def quantiles(values, scale=1.0):
    """Returns the median and the range of 90 % of the values, as text."""
    low, middle, high = scale * np.percentile(values, [5, 50, 95])
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenario", default="arm-board")
    parser.add_argument("--action", choices=("collect", "absorb"), default="collect")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    import wisch

    settings = {
        "strategy": "best",
        "action": arguments.action,
        "seed": arguments.seed,
        # By touch alone, with the dirt at its believed locations: the plan depends on neither world.
        "perception.senses": ["touch"],
        "execution.dirt": {"source": "as_believed"},
        "execution.force_noise_n": 0.0,
    }
    with tempfile.TemporaryDirectory() as folder:
        rapier, ends, fates = in_rapier(arguments.scenario, settings, Path(folder))
    task = wisch.load_task(arguments.scenario, set=settings)
    mujoco, world, round_ = in_mujoco(task, settings)

    count = min(len(rapier["time_s"]), len(mujoco["time_s"]))
    for engine in (rapier, mujoco):
        for key in ("world_from_tool", "world_from_commanded", "force_n", "efforts"):
            engine[key] = engine[key][:count]
    apart = np.linalg.norm(rapier["world_from_commanded"] - mujoco["world_from_commanded"], axis=1)
    print(f"{arguments.scenario}, {arguments.action}, seed {arguments.seed}: {count} samples of 1 ms in both")
    print(f"the commanded paths are {1e3 * apart.max():.4f} mm apart at most\n")

    stroke = np.asarray(round_.telemetry.stroke)[:count]
    wipes, free = stroke >= 0, stroke < 0
    surface = round_.motion.world_from_surface
    up = surface_normal(surface)
    print("| | Rapier | MuJoCo |\n|---|---|---|")
    for name, mask in (("while wiping", wipes), ("in free motion", free)):
        row = [quantiles(engine["force_n"][mask] @ up) for engine in (rapier, mujoco)]
        print(f"| normal force {name} [N] | {row[0]} | {row[1]} |")
    sideways = [engine["force_n"][wipes] - np.outer(engine["force_n"][wipes] @ up, up) for engine in (rapier, mujoco)]
    row = [quantiles(np.linalg.norm(force, axis=1)) for force in sideways]
    print(f"| force along the surface while wiping [N] | {row[0]} | {row[1]} |")
    errors = [engine["world_from_commanded"][wipes] - engine["world_from_tool"][wipes] for engine in (rapier, mujoco)]
    row = [quantiles(np.linalg.norm(e - np.outer(e @ up, up), axis=1), 1e3) for e in errors]
    print(f"| tool behind its line while wiping [mm] | {row[0]} | {row[1]} |")
    row = [quantiles((engine["world_from_tool"][wipes] - surface[:3]) @ up, 1e3) for engine in (rapier, mujoco)]
    print(f"| height over the surface while wiping [mm] | {row[0]} | {row[1]} |")

    between = rapier["world_from_tool"] - mujoco["world_from_tool"]
    print("\n| difference between the two engines | median | 95th percentile | largest |\n|---|---|---|---|")
    for name, mask in (("while wiping", wipes), ("in free motion", free)):
        far = 1e3 * np.linalg.norm(between[mask], axis=1)
        print(f"| tool path {name} [mm] | {np.median(far):.2f} | {np.percentile(far, 95):.2f} | {far.max():.2f} |")

    print("\n| joint | effort, rms [Nm] | difference while wiping, rms | in free motion, rms |\n|---|---|---|---|")
    for index, joint in enumerate(mujoco["joints"]):
        own = rapier["joints"].index(joint)
        one, other = rapier["efforts"][:, own], mujoco["efforts"][:, index]
        rms = [np.sqrt(np.mean((one - other)[mask] ** 2)) for mask in (wipes, free)]
        print(f"| {joint} | {np.sqrt(np.mean(one**2)):.2f} | {rms[0]:.2f} | {rms[1]:.2f} |")

    crumbs = world.crumbs
    goal = round_.plan.collect_goal
    taken = [sum(fate == "absorbed" for fate in fates), int((crumbs.fates == 1).sum())]
    lying = [np.array([fate == "on_surface" for fate in fates]), crumbs.on_surface(world.outline)]
    print("\n| crumbs | Rapier | MuJoCo |\n|---|---|---|")
    print(f"| taken up | {taken[0]} | {taken[1]} |")
    print(f"| over an edge | {len(fates) - taken[0] - lying[0].sum()} | {len(crumbs) - taken[1] - lying[1].sum()} |")
    if goal is not None:
        radius = task.collision_radius_m
        far = [1e3 * np.linalg.norm(p[on] - goal, axis=1) for p, on in zip((ends, crumbs.places[:, :2]), lying)]
        met = [int((distances <= 1e3 * radius).sum()) for distances in far]
        print(f"| at the goal, of {len(crumbs)} | {met[0]} | {met[1]} |")
        print(f"| distance of the crumbs from the goal [mm] | {quantiles(far[0])} | {quantiles(far[1])} |")
        both = lying[0] & lying[1]
        if both.any():
            moved = 1e3 * np.linalg.norm(ends[both] - crumbs.places[both, :2], axis=1)
            print(f"\nthe same crumb ends {quantiles(moved)} mm apart in the two")
    return 0 if apart.max() < 1e-3 else 2


def surface_normal(pose):
    """Returns the z axis of a pose (7)."""
    x, y, z, w = pose[3:]
    return np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])


if __name__ == "__main__":
    sys.exit(main())
