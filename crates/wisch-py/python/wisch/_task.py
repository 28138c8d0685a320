"""Tasks from Python objects."""

from __future__ import annotations

from collections.abc import Mapping

from . import _wisch
from ._wisch import Task, load_task

__all__ = ["Task", "build_task", "load_task"]

#: Tables of a task file that may be given by a name alone.
_NAMED = ("tool", "medium", "surface", "robot")


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
    """Build a task from Python objects, with the same checks as for a file.

    ``keys`` are those of a task file (``wisch new`` writes one with every key explained): ``tool``, ``medium``, ``surface``,
    ``robot``, ``scene``, ``collect``, ``plan``, ``execution``, ``perception``, ... as dicts and lists. A name alone stands for
    ``{"name": ...}``. ``particles`` is an array (N, 2) of positions in the frame of the surface [m], or a dict as in a file.
    A mesh in memory may stand for a mesh file: an object with ``vertices`` and ``faces``, such as one of trimesh, or a pair of
    arrays (V, 3) [m] and (T, 3).
    Paths are relative to the working directory, or to the folder of ``path``, which errors name as the task's file.

    >>> import numpy as np
    >>> task = build_task(
    ...     action="absorb", tool="sponge", medium="breadcrumbs",
    ...     surface={"name": "chopping_board", "size_m": [0.4, 0.28]},
    ...     particles=np.array([[0.1, 0.0], [0.0, 0.05]]),
    ... )
    >>> len(task.particles)
    2

    Raises WischError as for a file; its lines are those of the text ``Task.toml``.
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
    return _wisch.task_of_keys(
        table,
        given,
        path=path,
        set=set,
        knowledge=knowledge,
    )
