"""Episodes of sessions, and queries about them."""

import os
import shutil
from pathlib import Path

import numpy as np
import pytest

import wisch

#: Prolog engines, with the way to install each.
ENGINES = {
    "wisch-prolog": "cargo install --path crates/wisch-prolog --locked",
    "swipl": "install SWI-Prolog",
}


@pytest.fixture(scope="module")
def remembered(task, robot, tmp_path_factory):
    from conftest import AllAtOnce

    memory = wisch.Memory(tmp_path_factory.mktemp("memory") / "episodes")
    session = task.session(robot, rounds=2)
    rounds = session.run(AllAtOnce(task.surface_reaction))
    return memory, memory.remember(session), rounds


def test_an_episode_contains_the_telemetry_of_its_session(remembered):
    memory, episode, rounds = remembered
    assert memory.episodes == [episode]
    columns = memory.telemetry(episode, 2)
    log = rounds[1].telemetry
    # The memory stores times in nanoseconds.
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


def restrict_path(monkeypatch, engine):
    """Set PATH so that only this Prolog engine is found, or none."""
    folders = os.environ["PATH"].split(os.pathsep)
    found = shutil.which(engine) if engine else None
    if engine and found is None:
        pytest.skip(f"{engine} is not in PATH: {ENGINES[engine]}")
    others = ENGINES.keys() - {engine}
    free = [folder for folder in folders if not any((Path(folder) / other).is_file() for other in others)]
    if engine and str(Path(found).parent) not in free:
        pytest.skip(f"{engine} lies in one folder with another engine")
    monkeypatch.setenv("PATH", os.pathsep.join(free))


@pytest.mark.parametrize("engine", ENGINES)
def test_the_memory_answers(remembered, engine, monkeypatch):
    restrict_path(monkeypatch, engine)
    folder, episode, rounds = remembered[0].folder, *remembered[1:]
    memory = wisch.Memory(folder)  # a memory without an engine yet
    answers = memory.ask("member(X, [1, 2.5, a, f(b)])")
    assert [answer["X"] for answer in answers] == [1, 2.5, "a", ("f", ["b"])]

    # The expected answers come from the rounds.
    by_round = memory.ask("performance_by_round(Action, Number, Performance)")
    wiped = sorted((answer["Number"], answer["Performance"]) for answer in by_round)
    assert [number for number, _ in wiped] == [1, 2]
    assert [performance for _, performance in wiped] == pytest.approx([r.performance for r in rounds])
    low = memory.ask("low_performance_round(Round, Performance)")
    assert [answer["Performance"] for answer in low] == pytest.approx([r.performance for r in rounds if r.performance <= 0.8])
    [final] = memory.ask("final_performance(Episode, Performance)")
    assert final["Performance"] == pytest.approx(rounds[-1].performance)
    pressed = [memory.telemetry(episode, n, columns=["external/fz"])["external/fz"].max() for n in (1, 2)]
    peaks = memory.ask("prediction_error(Round, _), telemetry('external/fz', Round, max, Force)")
    assert sorted(peak["Force"] for peak in peaks) == pytest.approx(sorted(pressed))

    with pytest.raises(wisch.WischError, match="no_such_thing"):
        memory.ask("no_such_thing(X)")
    assert memory.ask("fail") == [], "a query is possible after a wrong one"


def test_a_missing_engine_is_named(remembered, monkeypatch):
    restrict_path(monkeypatch, None)
    with pytest.raises(wisch.WischError, match="no Prolog engine") as caught:
        wisch.Memory(remembered[0].folder).ask("true")
    assert "SWI-Prolog" in caught.value.help


def test_a_session_without_a_round_is_refused(task, robot, tmp_path):
    with pytest.raises(wisch.WischError, match="no finished round"):
        wisch.Memory(tmp_path / "m").remember(task.session(robot))
