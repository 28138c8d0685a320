"""Evaluations in parts: on a local Ray cluster with two workers, and as an array of jobs."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

#: Runs the program. Once, during part 2, it kills its worker.
KILLER = """
import os, signal, subprocess, sys
from pathlib import Path
mark = Path({mark!r})
if "2/3" in sys.argv and not mark.exists():
    mark.write_text("killed")
    os.kill(os.getppid(), signal.SIGKILL)
sys.exit(subprocess.run([*{program!r}, *sys.argv[1:]]).returncode)
"""

EVALUATION = ["sweep", "chopping-board", "--set", "strategy=grid,kde", "--seeds", "3", "--first-seed", "1000"]
ARRAY = Path(__file__).resolve().parents[3] / "docs" / "cluster" / "evaluate.slurm"


def program():
    """Return the command of the program: the wheel's, or the value of WISCH."""
    return [os.environ["WISCH"]] if "WISCH" in os.environ else [sys.executable, "-m", "wisch"]


def read_results(folder):
    """Return all results except their durations, which differ between runs."""
    rows = [line.rsplit(",", 1)[0] for line in (folder / "runs.csv").read_text().splitlines()]
    assert len(rows) == 1 + 6
    return rows


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Return the results of an evaluation without parts."""
    folder = tmp_path_factory.mktemp("whole") / "out"
    subprocess.run([*program(), "eval", *EVALUATION, "--out", folder, "--quiet"], check=True)
    return read_results(folder)


def test_only_the_part_of_a_killed_worker_is_repeated(tmp_path, whole):
    ray = pytest.importorskip("ray")
    from wisch.ray import evaluate

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        mark, killer = tmp_path / "killed", tmp_path / "killer.py"
        killer.write_text(KILLER.format(mark=str(mark), program=program()))
        out = tmp_path / "parts"
        code = evaluate(EVALUATION, out=out, shards=3, program=[sys.executable, str(killer)])
        assert code == 0
        assert mark.exists(), "no worker was killed"
        assert read_results(out) == whole
        names = sorted(path.name for path in out.glob("*.jsonl"))
        assert [name for name in names if "-of-3" in name] == [f"runs-{i}-of-3.jsonl" for i in (1, 2, 3)]
        lines = [json.loads(line) for i in (1, 2, 3) for line in (out / f"runs-{i}-of-3.jsonl").open()]
        assert len(lines) == 6, "each run once"
    finally:
        ray.shutdown()


def test_invalid_evaluations_are_refused(tmp_path):
    ray = pytest.importorskip("ray")
    from wisch.ray import evaluate

    with pytest.raises(ValueError, match="--shard"):
        evaluate([*EVALUATION, "--shard", "1/2"], out=tmp_path, shards=2)
    with pytest.raises(ValueError, match="0 is not at least 1"):
        evaluate(EVALUATION, out=tmp_path, shards=0)
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        with pytest.raises(RuntimeError, match="part . of 2: exit code 2: error: no-such-task"):
            evaluate(["sweep", "no-such-task", "--set", "strategy=grid,kde"], out=tmp_path, shards=2, program=program())
    finally:
        ray.shutdown()


def test_the_parts_of_an_array_of_jobs_are_combined(tmp_path, whole):
    if not ARRAY.exists():
        pytest.skip("the script is not shipped with the wheel")
    words = " ".join(program())
    names = {"WISCH": words, "OUT": str(tmp_path / "out"), "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "1"}
    environment = {**os.environ, **names}
    for index in ("2", "1"):
        job = {**environment, "SLURM_ARRAY_TASK_ID": index}
        subprocess.run(["bash", ARRAY, *EVALUATION], check=True, env=job, cwd=tmp_path)
    subprocess.run(["bash", ARRAY, "--merge", *EVALUATION], check=True, env=environment, cwd=tmp_path)
    assert read_results(tmp_path / "out") == whole
