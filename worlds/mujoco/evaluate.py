#!/usr/bin/env python3
"""Compares estimates with ground truth in MuJoCo worlds: `python worlds/mujoco/evaluate.py --worlds 100 --first-seed 10100
--action collect`.

A seed determines a world. Nine consecutive seeds have each combination of dirt and disturbance once. The dirt is spread evenly,
in heaps or in a band, and is drawn independently of the belief. The disturbances are: none; a displaced surface, another friction
and a biased and noisy force; the same and a person who pushes. Prints a table, and writes a line of JSON for each world. Exit code
0 if the targets are reached, else 1.
"""

import argparse
import json
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

try:
    import numpy as np
except ImportError as error:
    sys.exit(f"{error}: pip install -r worlds/mujoco/requirements.txt ./crates/wisch-py")

DIRT = ("uniform", "clusters", "stripe")
DISTURBANCES = ("undisturbed", "surface elsewhere", "pushed")
TARGETS = {"holds": 0.83, "false": 0, "reached": 0.85}
REACHED = 0.9
"""True performance from which on a world counts as wiped [1]."""
FALSE_BY = 0.1
"""A claim is false if the true performance is further below the target than this [1]."""
ROBOTS = {
    "arm7": {"robot.name": "arm7", "robot.position_m": [0.0, -0.45, 0.75], "tool.mount.on": "hand"},
    "humanoid": {},
}


def world_of(seed):
    """Returns the world of a seed: `execution` keys of a task file, and the names of its dirt and disturbance."""
    random = np.random.default_rng([seed, 0x776F726C])
    source, disturbance = DIRT[seed % 3], DISTURBANCES[seed // 3 % 3]
    keys = {"execution.dirt": {"source": source}}
    if disturbance != "undisturbed":
        tilt = np.radians(3.0) * random.uniform(-1.0, 1.0, 2)
        keys |= {
            "execution.surface_tilt_rad": tilt.tolist(),
            "execution.surface_shift_m": [0.0, 0.0, float(random.uniform(-0.01, 0.01))],
            "execution.friction": float(random.uniform(0.2, 0.9)),
            "execution.force_noise_n": float(random.uniform(0.1, 0.5)),
            "execution.force_bias_n": random.uniform(-1.0, 1.0, 3).tolist(),
        }
    if disturbance == "pushed":
        pushes = []
        for _ in range(random.integers(1, 3)):
            direction = random.standard_normal(3)
            direction[2] = abs(direction[2])
            force = random.uniform(10.0, 40.0) * direction / np.linalg.norm(direction)
            share, length = random.uniform(0.2, 0.8), random.uniform(0.3, 1.5)
            pushes.append({"start_share": float(share), "duration_s": float(length), "force_n": force.tolist()})
        keys["execution.push"] = pushes
    return keys, source, disturbance


def wipe(seed, action, scenario, robot):
    """Wipes one world; returns its line of the results."""
    import wisch

    from wisch_mujoco import World

    began = time.monotonic()
    keys, source, disturbance = world_of(seed)
    task = wisch.load_task(scenario, set={**keys, **ROBOTS[robot]}, seed=seed, action=action, strategy="best")
    world = World(task, set=keys)
    session = task.session(robot=task.robot())
    rounds = session.run(world)
    goal = rounds[-1].plan.collect_goal
    return {
        "seed": seed,
        "action": action,
        "dirt": source,
        "disturbance": disturbance,
        "verdict": session.verdict,
        "target": task.target_performance,
        "crumbs": len(world.crumbs),
        "true": world.performance(goal),
        "lost": float(np.mean((world.crumbs.fates == 0) & ~world.crumbs.on_surface(world.outline))),
        "rounds": [
            {
                "predicted": round_.prediction.performance,
                "estimated": round_.performance,
                "interval": list(round_.interval),
                "true": world.performance(goal, round_.number),
                "duration_s": round_.duration_s,
                "ending": round_.ending,
                "force_n": float(np.median(world.truth[round_.number - 1].contact_force or [0.0])),
                "pushed": world.truth[round_.number - 1].pushed,
                "events": [event["kind"] for event in round_.interpretation.events],
            }
            for round_ in rounds
        ],
        "wall_s": round(time.monotonic() - began, 1),
    }


def holds(round_):
    """Whether the interval contains the true performance."""
    low, high = round_["interval"]
    return low - 1e-9 <= round_["true"] <= high + 1e-9


def is_claimed(world):
    return world["verdict"] == "goal met"


def is_false(world):
    return is_claimed(world) and world["true"] < world["target"] - FALSE_BY


def line(name, worlds):
    """Returns a row of the table."""
    rounds = [round_ for world in worlds for round_ in world["rounds"]]
    errors = [abs(round_["estimated"] - round_["true"]) for round_ in rounds]
    widths = [round_["interval"][1] - round_["interval"][0] for round_ in rounds]
    true = [world["true"] for world in worlds]
    return (
        f"| {name} | {len(worlds)} | {len(rounds)} | {100 * np.mean([holds(r) for r in rounds]):.1f} % | "
        f"{100 * np.mean(widths):.1f} | {100 * np.mean(errors):.1f} | {100 * np.median(true):.1f} % | "
        f"{100 * np.mean([t >= REACHED for t in true]):.0f} % | {100 * np.mean([w['lost'] for w in worlds]):.1f} % | "
        f"{sum(map(is_claimed, worlds))} | {sum(w['true'] >= w['target'] for w in worlds)} | {sum(map(is_false, worlds))} |"
    )


HEAD = (
    "| worlds | | rounds | 90 % holds | width | error | true at the end | end ≥ 90 % | lost | claimed | met | false |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|"
)


def table(worlds):
    """Returns the table of all worlds, in groups."""
    rows = [HEAD, line("all", worlds)]
    for key, names in (("dirt", DIRT), ("disturbance", DISTURBANCES)):
        for name in names:
            group = [world for world in worlds if world[key] == name]
            if group:
                rows.append(line(name, group))
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--worlds", type=int, default=9)
    parser.add_argument("--first-seed", type=int, default=1000)
    parser.add_argument("--action", choices=("collect", "absorb"), default="collect")
    parser.add_argument("--scenario", default="chopping-board", help="a shipped scenario or a task file")
    parser.add_argument("--robot", choices=tuple(ROBOTS), default="arm7")
    parser.add_argument("--jobs", type=int, default=1, help="worlds at a time")
    parser.add_argument("--resume", action="store_true", help="continue from the results in the folder")
    parser.add_argument("--out", type=Path, default=Path("out/mujoco"), help="folder of the results")
    arguments = parser.parse_args()

    arguments.out.mkdir(parents=True, exist_ok=True)
    name = f"{arguments.action}-{arguments.robot}-{arguments.first_seed}"
    path = arguments.out / f"{name}.jsonl"
    if path.exists() and not arguments.resume:
        parser.error(f"{path} exists already: --resume continues it, --out names another folder")
    worlds = [json.loads(text) for text in path.read_text().splitlines()] if path.exists() else []
    done = {world["seed"] for world in worlds}
    seeds = [s for s in range(arguments.first_seed, arguments.first_seed + arguments.worlds) if s not in done]
    with ProcessPoolExecutor(arguments.jobs) as pool, path.open("a") as file:
        todo = [pool.submit(wipe, seed, arguments.action, arguments.scenario, arguments.robot) for seed in seeds]
        for future in todo:
            world = future.result()
            worlds.append(world)
            file.write(json.dumps(world) + "\n")
            file.flush()
            print(
                f"{world['seed']} {world['dirt']}, {world['disturbance']}: {100 * world['true']:.1f} % after "
                f"{len(world['rounds'])} rounds, {world['verdict']}, {world['wall_s']} s",
                file=sys.stderr,
                flush=True,
            )
    last = arguments.first_seed + arguments.worlds - 1
    print(f"{arguments.action}, {arguments.scenario}, {arguments.robot}, seeds {arguments.first_seed} to {last}\n")
    print(table(worlds))
    rounds = [round_ for world in worlds for round_ in world["rounds"]]
    reached = (
        np.mean([holds(r) for r in rounds]) >= TARGETS["holds"]
        and sum(map(is_false, worlds)) <= TARGETS["false"]
        and np.mean([w["true"] >= REACHED for w in worlds]) >= TARGETS["reached"]
    )
    print(f"\nwrote {path}")
    return 0 if reached else 1


if __name__ == "__main__":
    sys.exit(main())
