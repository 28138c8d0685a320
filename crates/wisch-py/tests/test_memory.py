"""Episodes of sessions, and what can be asked of them."""

import shutil

import numpy as np
import pytest

import wisch


@pytest.fixture(scope="module")
def remembered(task, robot, tmp_path_factory):
    from conftest import AllAtOnce

    memory = wisch.Memory(tmp_path_factory.mktemp("memory") / "episodes")
    session = task.session(robot, rounds=2)
    rounds = session.run(AllAtOnce(task.surface_reaction))
    return memory, memory.remember(session), rounds


def test_a_session_is_kept_with_its_telemetry(remembered):
    memory, episode, rounds = remembered
    assert memory.episodes == [episode]
    columns = memory.telemetry(episode, 2)
    log = rounds[1].telemetry
    # Times are kept in nanoseconds.
    np.testing.assert_allclose(columns["time_s"], log.time_s, atol=1e-9)
    for column, of_log in [
        ("measured/x", log.world_from_tool[:, 0]),
        ("external/fz", log.force_n[:, 2]),
        ("position/joint_7", log.positions[:, 6]),
        ("stroke", np.where(log.stroke < 0, columns["stroke"], log.stroke)),
    ]:
        np.testing.assert_allclose(columns[column], of_log, atol=1e-12)
    only = memory.telemetry(episode, 1, columns=[])
    assert list(only) == ["time_s"]
    with pytest.raises(wisch.WischError):
        memory.telemetry("20200101-000000-0000")


def test_the_memory_answers_or_says_what_is_missing(remembered):
    memory, _, rounds = remembered
    query = "low_performance_round(Round, Performance)"
    if not (shutil.which("wisch-prolog") or shutil.which("swipl")):
        with pytest.raises(wisch.WischError, match="no Prolog engine") as caught:
            memory.ask(query)
        assert "SWI-Prolog" in caught.value.help
        pytest.skip("there is no Prolog engine to ask")
    answers = memory.ask("member(X, [1, 2.5, a, f(b)])")
    assert [answer["X"] for answer in answers] == [1, 2.5, "a", ("f", ["b"])]
    low = [answer["Performance"] for answer in memory.ask(query)]
    assert low == pytest.approx([r.performance for r in rounds if r.performance < 0.85])
    with pytest.raises(wisch.WischError):
        memory.ask("no_such_thing(X)")


def test_a_session_without_a_round_is_not_kept(task, robot, tmp_path):
    with pytest.raises(wisch.WischError, match="no round that is over"):
        wisch.Memory(tmp_path / "m").remember(task.session(robot))
