"""Tasks from files, and from Python objects."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

from . import _wisch
from ._errors import WischError
from ._wisch import Task

__all__ = ["Task", "build_task", "load_task"]

#: Tables of a task file that a name alone stands for.
_NAMED = ("tool", "medium", "surface", "robot")


def load_task(path, *, set=None, seed=None, action=None, strategy=None, knowledge=None) -> Task:
    """Read a task file, or a shipped scenario by its name, with all that it refers to.

    ``set`` lays values over the file's: dotted keys such as ``{"particles.count": 80, "tool.name": "brush"}``, lists and
    dicts included. ``action``, ``strategy`` and ``seed`` are those of the command line; ``knowledge`` is a folder with tools,
    media, surfaces and interactions in place of what is shipped.

    Raises WischError: a file that cannot be read or is refused, with line, column, value and limit.
    """
    return _wisch.load_task(
        os.fspath(path),
        set=_settings(set),
        seed=seed,
        action=action,
        strategy=strategy,
        knowledge=knowledge,
    )


def build_task(
    *,
    particles=None,
    path=None,
    set=None,
    seed=None,
    action=None,
    strategy=None,
    knowledge=None,
    **keys,
) -> Task:
    """Make a task of Python objects; it goes through the same checks as a file.

    ``keys`` are those of a task file (``wisch new`` writes one with every key explained): ``tool``, ``medium``, ``surface``,
    ``robot``, ``scene``, ``collect``, ``plan``, ``execution``, ``perception``, ... as dicts and lists. A name alone stands for
    ``{"name": ...}``. ``particles`` is an array (N, 2) of places in the frame of the surface [m], or a dict as in a file.
    Paths are relative to the working directory, or to the folder of ``path``, under which errors speak of the task.

    >>> import numpy as np
    >>> task = build_task(
    ...     action="absorb", tool="sponge", medium="breadcrumbs",
    ...     surface={"name": "chopping_board", "size_m": [0.4, 0.28]},
    ...     particles=np.array([[0.1, 0.0], [0.0, 0.05]]),
    ... )
    >>> len(task.particles)
    2

    Raises WischError as for a file; the text that it counts lines in is ``WischError.file``'s, see ``Task.toml``.
    """
    table = {"schema": 1, "name": "task", **keys}
    for key, value in (("seed", seed), ("action", action), ("strategy", strategy)):
        if value is not None:
            table[key] = value
    for key in _NAMED:
        if isinstance(table.get(key), str):
            table[key] = {"name": table[key]}
    given = None
    if isinstance(particles, Mapping):
        table["particles"] = particles
    elif particles is not None:
        given = particles
    return _wisch.task_of_json(
        json.dumps(table, default=_plain, allow_nan=True),
        given,
        path=path,
        set=_settings(set),
        knowledge=knowledge,
    )


def _plain(value):
    """What JSON does not know: arrays, NumPy's numbers, paths."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return dict(value)
    raise WischError(f"a task cannot hold a {type(value).__name__}: {value!r}", value=repr(value))


def _settings(settings) -> dict[str, str]:
    """Values as TOML, which the command line takes too."""
    return {key: _toml(value) for key, value in (settings or {}).items()}


def _toml(value) -> str:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(k)} = {_toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value))
    return str(value)
