"""The controller (8) along a motion, against the robot's own dynamics."""

import numpy as np
import pytest

import wisch


def test_in_free_motion_the_efforts_are_those_of_the_inverse_dynamics(robot, motion):
    controller = wisch.ImpedanceController(motion, tool_mass_kg=0.0)
    assert controller.joints == motion.joints
    time = 0.5 * motion.phases[0]["end_s"]
    controller.command(time, motion.positions[0], np.zeros(7))
    q, qd, qdd = controller.planned
    assert np.abs(qd).max() > 0.05
    efforts = controller.command(time, q, qd)
    # A tool without mass still has a little inertia.
    np.testing.assert_allclose(efforts, robot.inverse_dynamics(q, qd, qdd), atol=1e-4)
    np.testing.assert_allclose(controller.controller_wrench, 0, atol=1e-4)


def test_on_the_surface_the_controller_presses_with_the_press_force(task, motion):
    controller = wisch.ImpedanceController(motion)
    k = int(np.flatnonzero(motion.stroke >= 0)[0])
    controller.command(motion.time_s[k], motion.positions[k], np.zeros(7))
    q, _, _ = controller.planned
    controller.command(motion.time_s[k], q, np.zeros(7))
    force = controller.controller_wrench[:3]
    assert np.linalg.norm(force) == pytest.approx(task.press_force_n, rel=0.1)
    assert force[2] < 0
    deep = (controller.world_from_tool - controller.world_from_commanded)[2]
    assert deep == pytest.approx(1.1 * task.press_force_n / task.stiffness_n_per_m, rel=1e-3)


def test_the_observer_estimates_the_force_that_holds_the_arm(robot, motion):
    """The efforts do not hold the arm's weight, and a hand holds the arm still."""
    controller = wisch.ImpedanceController(motion, tool_mass_kg=0.0, observer_gain_per_s=150.0)
    q, still = motion.positions[0], np.zeros(7)
    for k in range(200):
        efforts = controller.command(0.0, q + 0.001, still)
    jacobian = robot.jacobian(q + 0.001, motion.tip, motion.tip_from_tool[:3])
    turned = np.kron(np.eye(2), _rotation(motion.world_from_root))
    missing = robot.gravity(q + 0.001) - efforts
    mass = robot.mass_matrix(q + 0.001)
    world = turned @ jacobian
    mobility = world @ np.linalg.solve(mass, world.T)
    expected = np.linalg.solve(mobility, world @ np.linalg.solve(mass, missing))
    np.testing.assert_allclose(controller.external_wrench, expected, rtol=0.05, atol=0.05)


def _rotation(pose):
    x, y, z, w = pose[3:]
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def test_wrong_settings_and_states_are_refused(motion):
    with pytest.raises(wisch.WischError, match="period_s: expected a finite number from 0 up, found -1"):
        wisch.ImpedanceController(motion, period_s=-1.0)
    controller = wisch.ImpedanceController(motion)
    with pytest.raises(wisch.WischError, match="has not been commanded"):
        controller.external_wrench
    with pytest.raises(wisch.WischError, match="qd: expected 7"):
        controller.command(0.0, np.zeros(7), np.zeros(3))
