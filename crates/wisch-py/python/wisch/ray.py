"""Evaluations on a Ray cluster: each part is a task of its own, so that a worker that dies loses only its part.

    python -m wisch.ray --shards 64 --out out/published -- calibration --first-seed 1000 --worlds 1000

The parts return to this machine, into one folder, where the same command as for one machine combines them: the results
are the same, byte for byte. Every node needs this wheel, in the same version.
Needs the extra ``ray``: ``pip install "./crates/wisch-py[ray]"``.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import ray

#: Options that :func:`evaluate` sets itself.
_OURS = ("--out", "--shard", "--resume", "--json", "--threads")


def evaluate(
    arguments: Sequence[str],
    *,
    out: str | os.PathLike,
    shards: int,
    program: Sequence[str] = (),
    retries: int = 3,
) -> int:
    """Evaluate in parts on the cluster that Ray is connected to, or on a new one on this machine.

    ``arguments`` are those of ``wisch eval``, such as ``["calibration", "--first-seed", "1000", "--worlds", "81"]``; each
    of the ``shards`` parts takes one core. An unfinished evaluation in ``out`` is resumed. A part whose worker
    dies is restarted on another worker, up to ``retries`` times. ``program`` replaces this wheel's program on every node.

    Returns the exit code of combining the parts: 0 if all was evaluated, 1 if something could not be.

    Raises ``ValueError`` for arguments that this function sets itself, and ``RuntimeError`` with the program's message if
    it rejects the evaluation.
    """
    for argument in arguments:
        if argument.split("=")[0] in _OURS:
            raise ValueError(f"{argument} may not be given, because wisch.ray.evaluate sets it")
    if shards < 1:
        raise ValueError(f"shards: {shards} is not at least 1")
    program = list(program) or [sys.executable, "-m", "wisch"]
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    begin = ray.remote(num_cpus=1, max_retries=retries, retry_exceptions=False)(_part)
    open_parts = []
    for index in range(1, shards + 1):
        known = {path.name: path.read_bytes() for path in folder.glob(f"*-{index}-of-{shards}.jsonl")}
        open_parts.append(begin.remote(program, list(arguments), index, shards, known))
    while open_parts:
        done, open_parts = ray.wait(open_parts)
        try:
            files = ray.get(done[0])
        except ray.exceptions.RayTaskError as error:
            for part in open_parts:
                ray.cancel(part)
            raise RuntimeError(str(error.cause)) from None
        for name, content in files.items():
            _write(folder / name, content)
    command = [*program, "eval", *arguments, "--out", str(folder), "--resume"]
    return subprocess.run(command, check=False).returncode


def _part(program: list, arguments: list, index: int, count: int, known: dict) -> dict:
    """Evaluate a part, and return its files by name."""
    with tempfile.TemporaryDirectory(prefix="wisch-") as name:
        folder = Path(name)
        for file, content in known.items():
            (folder / file).write_bytes(content)
        command = [*program, "eval", *arguments, "--shard", f"{index}/{count}", "--threads", "1"]
        command += ["--quiet", "--resume", "--out", str(folder)]
        run = subprocess.run(command, capture_output=True, text=True, check=False, preexec_fn=_end_with_worker)
        # 1 means that some of it could not be evaluated, which is reported when the parts are combined.
        if run.returncode not in (0, 1):
            raise RuntimeError(f"part {index} of {count}: exit code {run.returncode}: {run.stderr.strip()}")
        return {path.name: path.read_bytes() for path in folder.glob("*.jsonl")}


def _end_with_worker() -> None:
    """End this process together with its worker (on Linux), because nobody would wait for it."""
    if sys.platform == "linux":
        import ctypes

        set_parent_death_signal = 1
        ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)


def _write(path: Path, content: bytes) -> None:
    """Write a file completely or not at all."""
    new = path.with_name(f".{path.name}.new")
    new.write_bytes(content)
    new.replace(path)


def main() -> int:
    """Run from the command line, and return the exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m wisch.ray",
        description="Evaluate in parts on a Ray cluster, as wisch eval does on one machine.",
        epilog="Example: python -m wisch.ray --shards 64 --out out/rows -- calibration --first-seed 1000 --worlds 1000",
    )
    parser.add_argument("--address", help="address of the cluster, such as auto; by default a new cluster on this machine")
    parser.add_argument("--shards", type=int, required=True, help="number of parts, each of which takes one core")
    parser.add_argument("--out", required=True, help="folder for the results")
    parser.add_argument("--retries", type=int, default=3, help="number of restarts of a part (default: 3)")
    parser.add_argument("arguments", nargs="+", help="the arguments of wisch eval, after --")
    options = parser.parse_args()
    ray.init(address=options.address, log_to_driver=False)
    try:
        return evaluate(options.arguments, out=options.out, shards=options.shards, retries=options.retries)
    except (ValueError, RuntimeError, ray.exceptions.RayError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
