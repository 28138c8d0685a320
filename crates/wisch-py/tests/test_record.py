"""Stored results of a session: report, bags, and an episode."""

import json

import numpy as np
import pytest

import wisch


class Stumbles:
    """A robot that fails during its second motion."""

    def __init__(self, exact):
        self.exact = exact
        self.motions = 0

    def execute(self, motion, sink):
        self.motions += 1
        if self.motions == 2:
            raise RuntimeError("the arm is unplugged")
        self.exact.execute(motion, sink)


def test_a_session_writes_a_report_bags_and_an_episode(task, robot, exact, tmp_path):
    out, memory = tmp_path / "out", tmp_path / "episodes"
    session = task.session(robot, rounds=2, out=out, memory=memory)
    assert session.episode is None
    rounds = session.run(exact)
    assert {"report.html", "plan.json", "rounds.json", "recording.jsonl.gz"} <= {path.name for path in out.iterdir()}
    assert len(json.loads((out / "rounds.json").read_text())) == len(rounds)
    for number, round in enumerate(rounds, 1):
        log = wisch.read_log(out / "telemetry" / f"round-{number}.mcap")
        np.testing.assert_allclose(log.force_n, round.telemetry.force_n, atol=1e-12)
    kept = wisch.Memory(memory)
    assert kept.episodes == [session.episode]
    record = json.loads((memory / session.episode / "episode.json").read_text())
    assert record["origin"] == {"executor": "AllAtOnce"}
    assert (memory / session.episode / "recording.jsonl.gz").is_file()
    columns = kept.telemetry(session.episode, 1)
    np.testing.assert_allclose(columns["external/fz"], rounds[0].telemetry.force_n[:, 2], atol=1e-12)


def test_a_session_compares_its_motion_with_its_memory(task, robot, exact, tmp_path):
    memory = tmp_path / "episodes"
    for comparable in range(2):
        session = task.session(robot, rounds=1, memory=memory)
        session.run(exact)
        note = "no warnings while wiping: 1 comparable episode, 49 are needed"
        assert session.remarks.count(note) == comparable


def test_a_session_that_fails_keeps_its_finished_rounds(task, robot, exact, tmp_path):
    out = tmp_path / "out"
    session = task.session(robot, rounds=3, target=1.0, out=out, memory=tmp_path / "episodes")
    with pytest.raises(RuntimeError, match="unplugged"):
        session.run(Stumbles(exact))
    assert (out / "report.html").is_file()
    assert (out / "telemetry" / "round-1.mcap").is_file()
    assert wisch.Memory(tmp_path / "episodes").episodes == [session.episode]


def test_the_with_block_writes_an_unfinished_session(task, robot, exact, tmp_path):
    with task.session(robot, rounds=3, out=tmp_path / "out") as session:
        session.run_round(exact)
        assert not (tmp_path / "out").exists()
    assert (tmp_path / "out" / "telemetry" / "round-1.mcap").is_file()
    with task.session(robot, out=tmp_path / "nothing"):
        pass
    assert not (tmp_path / "nothing").exists(), "a session that has not begun writes no files"


def test_an_unwritable_folder_is_refused_before_the_first_motion(task, robot, tmp_path):
    (tmp_path / "file").write_text("not a folder")
    for place in [{"out": tmp_path / "file"}, {"memory": tmp_path / "file" / "episodes"}]:
        with pytest.raises(wisch.WischError):
            task.session(robot, **place)
