"""Task files whose goal has several parts."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

from ._errors import WischError

__all__ = ["GoalFile"]


class GoalFile:
    """A task file, or a shipped scenario by its name, whose goal has several parts.

    ``set`` overrides values of the file by dotted keys, as in :func:`load_task`. ``seed``, ``strategy`` and ``knowledge`` are
    as on the command line. The program of this wheel does the work in a process of its own; ``program`` replaces it.
    """

    def __init__(
        self,
        path: str | os.PathLike,
        *,
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
        strategy: str | None = None,
        knowledge: str | os.PathLike | None = None,
        program: Sequence[str] = (),
    ) -> None:
        self.path = os.fspath(path)
        self._options: list[str] = []
        for key, value in (set or {}).items():
            self._options += ["--set", f"{key}={value if isinstance(value, str) else _toml(key, value)}"]
        for name, value in (("seed", seed), ("strategy", strategy), ("knowledge", knowledge)):
            if value is not None:
                self._options += [f"--{name}", os.fspath(value) if name == "knowledge" else str(value)]
        self._program = list(program) or [sys.executable, "-m", "wisch"]

    def __repr__(self) -> str:
        return f"GoalFile({self.path!r})"

    @cached_property
    def check(self) -> dict[str, Any]:
        """The object that ``wisch check --json`` prints: parts, surfaces, media, tools, and the check of each wiping step.

        The first access checks the file, and plans each step once; the object is then kept.

        Raises WischError if the file cannot be read or is invalid, or if its goal has a single part.
        """
        found = self._call("check")
        if found.get("format") != "wisch-goal-check":
            raise WischError(f"{self.path}: the goal has a single part", help="read it with wisch.load_task")
        return found

    @property
    def name(self) -> str:
        """Name of the task."""
        return self.check["task"]

    @property
    def goal(self) -> str:
        """The goal in PDDL."""
        return self.check["goal"]

    @property
    def parts(self) -> list[str]:
        """The parts of the goal in PDDL, in its order."""
        return [part["part"] for part in self.check["parts"]]

    @property
    def surfaces(self) -> list[str]:
        """Names of the surfaces."""
        return self.check["surfaces"]

    @property
    def media(self) -> list[tuple[str, str]]:
        """Each medium with its surface."""
        return [(on["medium"], on["surface"]) for on in self.check["media"]]

    @property
    def tools(self) -> dict[str, list[float] | None]:
        """The tools in the rack, each with its position in the world [m]; None if the file states no position."""
        return {tool["tool"]: tool["position_m"] for tool in self.check["tools"]}

    @property
    def tool_in_hand(self) -> str | None:
        """The tool in the hand before the first step; None without one."""
        return self.check["tool_in_hand"]

    def plan(self, *, out: str | os.PathLike | None = None) -> dict[str, Any]:
        """Plan the sequence of least expected time, and predict each wiping step on the robot, without execution.

        Returns the object of ``wisch follow --json``. ``steps`` holds the steps with their times [s], ``expected_s`` the expected
        time of all, ``expected_actions`` the time, rounds and predicted performance of every wiping action that may serve the
        goal, and ``parts`` whether each part is predicted to hold. ``out`` is the folder of results; without it, none is kept.

        Raises WischError if the file is invalid, or names no robot.
        """
        return self._call_with_results("follow", out, [])

    def run(
        self,
        *,
        out: str | os.PathLike | None = None,
        memory: str | os.PathLike | None = None,
        touch_only: bool = False,
    ) -> dict[str, Any]:
        """Execute the steps in the simulated world, and plan anew after a step that misses its goal.

        Returns the object of ``wisch run --json``. ``parts`` states for each part whether it ``holds`` as estimated, or else
        why it is ``left_out``; ``steps`` holds the steps with their times [s], and for each wiping step the estimate of its
        performance with its 90 % interval. ``out`` is the folder of results; without it, none is kept. ``memory`` is the folder
        for episodes; without it, none is kept. ``touch_only`` leaves out the camera.

        Raises WischError if the file is invalid.
        """
        options = ["--touch-only"] if touch_only else []
        options += ["--no-memory"] if memory is None else ["--memory", os.fspath(memory)]
        return self._call_with_results("run", out, options)

    def _call_with_results(self, command: str, out: str | os.PathLike | None, options: list[str]) -> dict[str, Any]:
        if out is not None:
            return self._call(command, [*options, "--out", os.fspath(out)])
        with tempfile.TemporaryDirectory(prefix="wisch-") as folder:
            return self._call(command, [*options, "--out", str(Path(folder) / "results")])

    def _call(self, command: str, options: Sequence[str] = ()) -> dict[str, Any]:
        """Run a command of the program, and return the object that it prints."""
        words = [*self._program, command, "--json", "--quiet", *self._options, *options, "--", self.path]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        try:
            found = json.loads(done.stdout)
        except ValueError:
            found = {"error": done.stderr.strip() or f"the program ended with exit code {done.returncode}"}
        if "error" in found:
            raise WischError(found["error"], file=self.path, help=found.get("help"))
        return found


def _toml(key: str, value: Any) -> str:
    """Write a value as TOML."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(name), ensure_ascii=False)} = {_toml(key, one)}" for name, one in value.items()) + " }"
    if isinstance(value, Sequence):
        return "[" + ", ".join(_toml(key, one) for one in value) + "]"
    if isinstance(value, (int, float)):
        return repr(value)
    raise WischError(f"{key}: {value!r} is no value of a task file", value=repr(value))
