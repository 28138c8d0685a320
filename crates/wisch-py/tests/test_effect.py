"""The effect model on arrays, compared with closed forms."""

import numpy as np
import pytest

import wisch

BOARD = [[-0.2, -0.14], [0.2, -0.14], [0.2, 0.14], [-0.2, 0.14]]
SPONGE = [[-0.035, -0.055], [0.035, -0.055], [0.035, 0.055], [-0.035, 0.055]]


def test_a_crumb_moves_with_the_leading_edge():
    field = wisch.EffectField([[0.05, 0.0], [0.05, 0.1]], BOARD, SPONGE)
    assert field.apply([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0]])["pushed"] == 1
    np.testing.assert_allclose(field.particles, [[0.135, 0.0], [0.05, 0.1]], atol=1e-8)
    assert field.apply([[0.1, 0.0, 0.0], [0.2, 0.0, 0.0]])["off_surface"] == 1
    assert field.fates.tolist() == [2, 0]


def test_a_touch_absorbs_the_particles_under_the_tool():
    field = wisch.EffectField([[0.01, 0.0], [0.05, 0.1]], BOARD, SPONGE, "absorb")
    assert field.apply([[0.0, 0.0, 0.0]])["absorbed"] == 1
    assert field.fates.tolist() == [1, 0]


def test_the_field_of_a_task_agrees_with_the_prediction_of_the_plan(task):
    plan = task.session().plan()
    field = wisch.EffectField.of_task(task)
    for stroke in plan.strokes:
        field.apply(stroke)
    prediction = plan.predict()
    np.testing.assert_array_equal(field.particles, prediction.particles)
    np.testing.assert_array_equal(field.fates, prediction.fates)


def test_wrong_arrays_are_refused():
    with pytest.raises(wisch.WischError, match="outline: expected three finite corners or more, found 2 corners"):
        wisch.EffectField([[0.0, 0.0]], BOARD[:2], SPONGE)
    with pytest.raises(wisch.WischError, match="effect: expected"):
        wisch.EffectField([[0.0, 0.0]], BOARD, SPONGE, "shove")
    field = wisch.EffectField([[0.0, 0.0]], BOARD, SPONGE)
    with pytest.raises(wisch.WischError, match=r"poses\[1\]"):
        field.apply([[0.0, 0.0, 0.0], [np.nan, 0.0, 0.0]])
