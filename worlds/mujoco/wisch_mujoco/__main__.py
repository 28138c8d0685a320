"""A MuJoCo world as the executor of a program: `wisch run TASK --executor "python3 -m wisch_mujoco TASK"`.

Give the same `--set KEY=VALUE`, `--seed` and `--action` as to `wisch run`, because the world is drawn from the same task.
"""

import argparse
import ast

import wisch

from . import World


def value(text):
    """Returns a value of `--set` as a Python value: TOML and Python write numbers, texts and lists alike."""
    try:
        return ast.literal_eval({"true": "True", "false": "False"}.get(text, text))
    except (ValueError, SyntaxError):
        return text


def main():
    parser = argparse.ArgumentParser(prog="python3 -m wisch_mujoco", description=__doc__)
    parser.add_argument("task", help="a task file or a shipped scenario")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--seed", type=int)
    parser.add_argument("--action")
    arguments = parser.parse_args()
    settings = {key: value(text) for key, _, text in (pair.partition("=") for pair in arguments.set)}
    task = wisch.load_task(arguments.task, set=settings, seed=arguments.seed, action=arguments.action)
    try:
        from wisch.executor import serve
    except ImportError:
        parser.error("this wheel of wisch has no wisch.executor: pip install ./crates/wisch-py")
    serve(World(task, set=settings))


if __name__ == "__main__":
    main()
