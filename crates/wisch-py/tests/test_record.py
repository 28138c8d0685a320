"""What a session leaves: results, bags, and an episode."""

import json

import numpy as np
import pytest

import wisch


class Stumbles:
    """A robot that breaks off amid its second motion."""

    def __init__(self, exact):
        self.exact = exact
        self.motions = 0

    def execute(self, motion, sink):
        self.motions += 1
        if self.motions == 2:
            raise RuntimeError("the arm is unplugged")
        self.exact.execute(motion, sink)


def test_a_session_leaves_a_report_bags_and_an_episode(task, robot, exact, tmp_path):
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


def test_what_was_executed_is_kept_of_a_session_that_breaks_off(task, robot, exact, tmp_path):
    out = tmp_path / "out"
    session = task.session(robot, rounds=3, target=1.0, out=out, memory=tmp_path / "episodes")
    with pytest.raises(RuntimeError, match="unplugged"):
        session.run(Stumbles(exact))
    assert (out / "report.html").is_file()
    assert (out / "telemetry" / "round-1.mcap").is_file()
    assert wisch.Memory(tmp_path / "episodes").episodes == [session.episode]


def test_a_session_that_is_left_early_is_written_by_its_with_block(task, robot, exact, tmp_path):
    with task.session(robot, rounds=3, out=tmp_path / "out") as session:
        session.run_round(exact)
        assert not (tmp_path / "out").exists()
    assert (tmp_path / "out" / "telemetry" / "round-1.mcap").is_file()
    with task.session(robot, out=tmp_path / "nothing"):
        pass
    assert not (tmp_path / "nothing").exists(), "what has not begun leaves nothing"


def test_a_place_that_cannot_be_written_is_refused_before_anything_moves(task, robot, tmp_path):
    (tmp_path / "file").write_text("not a folder")
    for place in [{"out": tmp_path / "file"}, {"memory": tmp_path / "file" / "episodes"}]:
        with pytest.raises(wisch.WischError):
            task.session(robot, **place)
