"""Builds the examples of the library once, and returns their paths."""

import functools
import pathlib
import subprocess

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent


@functools.cache
def example(name):
    """Path of a built example, such as "tour"."""
    subprocess.run(["cargo", "build", "--quiet", "--release", "--workspace", "--examples"],
                   cwd=REPOSITORY, check=True)
    return REPOSITORY / "target" / "release" / "examples" / name
