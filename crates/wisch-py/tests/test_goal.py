"""Goals of several parts."""

import pytest

import wisch
from wisch._goal import _toml

BOARD = """
schema = 1
name = "board"
seed = 1
goal = "(and (collected breadcrumbs chopping_board) (absorbed water chopping_board))"
strategy = "kde"
target_performance = 0.85
[tool]
rack = [{ name = "sponge", position_m = [0.3, -0.2, 0.8] }]
[surface]
name = "chopping_board"
size_m = [0.28, 0.20]
position_m = [0.0, 0.0, 0.77]
[[medium]]
name = "water"
particles = { source = "clusters", count = 40, clusters = [{ center_m = [-0.08, 0.04], sigma_m = 0.02 }] }
[[medium]]
name = "breadcrumbs"
particles = { source = "uniform", count = 40 }
collect = { goal_m = [0.06, -0.03] }
[robot]
name = "arm7"
position_m = [0.0, -0.45, 0.75]
rpy_rad = [0.0, 0.0, 1.5707963267948966]
"""


@pytest.fixture
def board(tmp_path):
    path = tmp_path / "board.toml"
    path.write_text(BOARD)
    return wisch.GoalFile(path)


def test_a_goal_file_states_parts_surfaces_and_tools(board):
    assert board.name == "board"
    assert board.parts == ["(collected breadcrumbs chopping_board)", "(absorbed water chopping_board)"]
    assert board.surfaces == ["chopping_board"]
    assert sorted(board.media) == [("breadcrumbs", "chopping_board"), ("water", "chopping_board")]
    assert board.tools == {"sponge": [0.3, -0.2, 0.8]}
    assert board.tool_in_hand is None


def test_the_steps_are_planned_and_carried_out(board, tmp_path):
    planned = board.plan()
    words = [step["words"] for step in planned["steps"]]
    assert words[0] == "fetch sponge"
    assert len(words) == 3
    assert planned["expected_s"] == pytest.approx(sum(step["expected_s"] for step in planned["steps"]))
    assert not planned["is_executed"]
    done = board.run(out=tmp_path / "out", touch_only=True)
    assert done["is_executed"]
    assert [part["part"] for part in done["parts"]] == board.parts
    assert (tmp_path / "out" / "steps.json").is_file()


def test_wrong_goal_files_say_what_is_wrong(tmp_path):
    with pytest.raises(wisch.WischError, match="single part"):
        wisch.GoalFile("arm-board").parts
    path = tmp_path / "board.toml"
    path.write_text(BOARD.replace('name = "water"', 'name = "water"\non = "tabel"'))
    with pytest.raises(wisch.WischError, match='unknown surface "tabel"'):
        wisch.GoalFile(path).parts


def test_settings_are_written_as_toml():
    assert _toml("a", {"b": [1, 2.5, True, "c"]}) == '{ "b" = [1, 2.5, true, "c"] }'
    with pytest.raises(wisch.WischError, match="no value of a task file"):
        _toml("a", object())
