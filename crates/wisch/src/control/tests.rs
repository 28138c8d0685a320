//! Tests of the controller and the observer against their equations.

use super::impedance::{
    DesiredPosture, DesiredToolState, ImpedanceController, MeasuredJointState, distance_beyond,
    end_stop_effort, rotation_vector_between, saturate,
};
use super::{ControlConfig, MomentumObserver};
use crate::geometry::{Polygon, Pose, Vector2, Vector3};
use crate::represent::{
    Action, Interaction, LogNormal, LogNormalSpread, Redraw, Surface, SurfaceScope,
};
use crate::robot::{Articulation, ArticulationState, Range, RobotModel};
use nalgebra::{DMatrix, DVector, Matrix6xX, UnitQuaternion, Vector6};
use proptest::prelude::*;

const PERIOD: f64 = 1e-3;
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// A mass of 3 kg on a rail along the world's z, which stands across a level surface.
const RAIL: &str = r#"<robot name="rail"><link name="wall"/>
  <link name="slider"><inertial><mass value="3"/>
    <inertia ixx="0.01" iyy="0.01" izz="0.01"/></inertial></link>
  <joint name="slide" type="prismatic"><parent link="wall"/><child link="slider"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="1" effort="100"/></joint>
</robot>"#;

fn interaction(damping_ratio: f64) -> Interaction {
    Interaction {
        tool: "sponge".into(),
        medium: "breadcrumbs".into(),
        surface: SurfaceScope::Any,
        actions: Action::ALL.into_iter().collect(),
        press_force_n: 10.0,
        stiffness_n_per_m: 500.0,
        damping_ratio,
        nullspace_posture_weight: 0.1,
        compression_depth_m: 0.005,
        gap_m: 0.0,
        likelihood: LogNormal {
            mu: -1.0,
            sigma: 0.25,
        },
        likelihood_spread: LogNormalSpread::NONE,
        redraw: Redraw::default(),
    }
}

/// A simulated robot without surroundings: its equations of motion, integrated.
struct Machine {
    moving: Articulation,
    state: ArticulationState,
    q: Vec<f64>,
    qd: Vec<f64>,
    carrier: usize,
    jacobian: Matrix6xX<f64>,
    controller: ImpedanceController,
}

impl Machine {
    fn new(urdf: &str, tip: &str, q: &[f64], damping_ratio: f64) -> Self {
        let robot = RobotModel::from_urdf("test", urdf, &mut |_| Err(String::new())).unwrap();
        let all = vec![true; robot.dof()];
        let moving = Articulation::new(&robot, &Pose::identity(), q, &all, &[]).unwrap();
        let tip = robot.link(tip).unwrap();
        let ranges = (0..robot.dof()).map(|i| robot.variable(i).limits.position);
        Self {
            controller: ImpedanceController::new(
                (0..robot.dof()).collect(),
                ranges.collect(),
                &interaction(damping_ratio),
                &Surface::new(
                    "level",
                    Polygon::rectangle(Vector2::new(1.0, 1.0)),
                    Pose::identity(),
                ),
                &ControlConfig::default(),
            ),
            carrier: moving.carrier(tip).0.unwrap(),
            state: moving.state(),
            jacobian: Matrix6xX::zeros(robot.dof()),
            q: q.to_vec(),
            qd: vec![0.0; robot.dof()],
            moving,
        }
    }

    fn world_from_tool(&self) -> Pose {
        self.state.pose(self.carrier)
    }

    /// Computes the state of the articulation from the current positions and velocities.
    fn measure(&mut self) {
        self.moving
            .evaluate(&mut self.state, &self.q, &self.qd, GRAVITY);
        let tool = self.world_from_tool().translation.vector.into();
        let (state, carrier) = (&self.state, self.carrier);
        self.moving
            .jacobian(state, carrier, tool, &mut self.jacobian);
    }

    /// Computes the controller's force when the tool is to stand still at a pose.
    fn command(&mut self, world_from_tool: Pose, posture: &[f64]) -> Vector3 {
        let still = vec![0.0; posture.len()];
        let measured = MeasuredJointState {
            q: &self.q,
            qd: &self.qd,
            world_from_tool: self.state.pose(self.carrier),
            jacobian: &self.jacobian,
        };
        let desired = DesiredToolState {
            world_from_tool,
            velocity: Vector6::zeros(),
        };
        let posture = DesiredPosture {
            q: posture,
            qd: &still,
            qdd: &still,
        };
        let wrench = self
            .controller
            .command(&self.state, &measured, &desired, &posture);
        wrench.unwrap().force
    }

    /// Simulates one period under the controller's efforts and external efforts.
    fn step(&mut self, external: &[f64]) {
        let count = self.q.len();
        let forces = DVector::from_fn(count, |i, _| {
            self.controller.efforts()[i] + external[i] - self.state.bias()[i]
        });
        let mass = self.state.mass_matrix().clone().cholesky().unwrap();
        let accelerations = mass.solve(&forces);
        for i in 0..count {
            self.qd[i] += PERIOD * accelerations[i];
            self.q[i] += PERIOD * self.qd[i];
        }
    }
}

/// Returns the largest overshoot past the goal over the distance to it, after a start 1 mm off, at which no
/// force is saturated.
fn overshoot(machine: &mut Machine) -> f64 {
    let start = 1e-3;
    machine.q[0] = start;
    let mut past: f64 = 0.0;
    for _ in 0..1000 {
        machine.measure();
        machine.command(Pose::identity(), &[0.0]);
        machine.step(&[0.0]);
        past = past.max(-machine.q[0] / start);
    }
    past
}

#[test]
fn the_damping_ratio_is_the_one_that_was_wanted() {
    for ratio in [0.3, 0.5, 0.7] {
        let mut rail = Machine::new(RAIL, "slider", &[0.0], ratio);
        let found = overshoot(&mut rail);
        // The overshoot of a linear oscillator.
        let expected = (-std::f64::consts::PI * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        assert!(
            (found - expected).abs() < 0.02,
            "{found} against {expected}"
        );
    }
}

#[test]
fn the_spring_has_the_stiffness_of_the_task_and_ends_at_its_force() {
    let mut rail = Machine::new(RAIL, "slider", &[0.0], 0.7);
    rail.measure();
    for (depth, expected) in [(0.004, -2.0), (0.02, -10.0), (0.5, -10.0)] {
        let force = rail.command(Pose::translation(0.0, 0.0, -depth), &[0.0]);
        assert!((force - Vector3::new(0.0, 0.0, expected)).norm() < 1e-9);
        // On the rail, the drive carries only the force and the weight.
        let effort = rail.controller.efforts()[0];
        assert!((effort - (expected + 3.0 * 9.81)).abs() < 1e-3, "{effort}");
    }
}

#[test]
fn an_observer_converges_to_an_unknown_effort() {
    let config = ControlConfig::default();
    let urdf = include_str!("../../../../robots/arm7.urdf");
    let start = [0.1, 0.5, -0.2, -1.2, 0.3, 0.9, 0.2];
    let external = [3.0, -2.0, 1.0, 4.0, -0.5, 0.6, 0.3];
    let mut arm = Machine::new(urdf, "tcp", &start, 0.7);
    let mut observer = MomentumObserver::new(
        &(0..start.len()).collect::<Vec<_>>(),
        start.len(),
        config.observer_gain,
    );
    arm.measure();
    let goal = arm.world_from_tool();
    let mut seen = Vec::new();
    // After fifteen time constants, the observer has settled.
    for _ in 0..100 {
        arm.measure();
        let efforts = arm.controller.efforts().to_vec();
        let residual = observer.update(&arm.state, &arm.qd, &efforts, PERIOD);
        seen.push(residual.to_vec());
        arm.command(goal, &start);
        arm.step(&external);
    }
    let constant = (1.0 / (config.observer_gain * PERIOD)) as usize;
    for (i, wanted) in external.iter().enumerate() {
        let share = seen[constant][i] / wanted;
        assert!(
            (share - 0.63).abs() < 0.06,
            "{share} after one time constant"
        );
        // The remaining error is the change of the mass matrix within a period.
        let error = seen.last().unwrap()[i] - wanted;
        assert!(
            error.abs() < 0.02 * wanted.abs() + 0.01,
            "{error} at joint {i}"
        );
    }
}

#[test]
fn the_wrench_that_efforts_come_from_is_found_again() {
    let urdf = include_str!("../../../../robots/arm7.urdf");
    let start = [0.1, 0.5, -0.2, -1.2, 0.3, 0.9, 0.2];
    let mut arm = Machine::new(urdf, "tcp", &start, 0.7);
    arm.measure();
    let goal = arm.world_from_tool();
    arm.command(goal, &start);
    let wrench = Vector6::new(3.0, -4.0, 10.0, 0.2, -0.3, 0.1);
    let efforts = arm.jacobian.transpose() * wrench;
    let found = arm.controller.external_wrench(efforts.as_slice());
    let force: Vector3 = wrench.fixed_rows::<3>(0).into();
    let moment: Vector3 = wrench.fixed_rows::<3>(3).into();
    assert!((found.force - force).norm() < 0.05);
    assert!((found.moment - moment).norm() < 0.05);
}

#[test]
fn a_joint_that_is_pushed_over_its_end_comes_to_rest_a_little_beyond() {
    let mut rail = Machine::new(RAIL, "slider", &[0.99], 0.7);
    let mut furthest: f64 = 0.0;
    for _ in 0..1500 {
        rail.measure();
        let here = rail.world_from_tool();
        rail.command(here, &[0.99]);
        rail.step(&[40.0]);
        furthest = furthest.max(rail.q[0]);
    }
    assert!(furthest > 1.0 && furthest < 1.01, "{furthest} m");
    assert!(rail.qd[0].abs() < 1e-3, "it still moves");
}

#[test]
fn within_its_range_a_joint_knows_of_no_end() {
    let range = Range {
        lower: -0.5,
        upper: 1.0,
    };
    for position in [-0.5, 0.0, 1.0] {
        assert_eq!(distance_beyond(&range, position), None);
    }
    assert_eq!(distance_beyond(&range, 1.25), Some(0.25));
    assert_eq!(distance_beyond(&range, -0.75), Some(-0.25));
    // The spring drives back; the damper brakes only what goes further.
    for side in [-1.0, 1.0] {
        let at_rest = end_stop_effort(0.01 * side, 0.0, 2.0);
        assert!(at_rest * side < 0.0);
        assert_eq!(end_stop_effort(0.01 * side, -side, 2.0), at_rest);
        assert!(end_stop_effort(0.01 * side, side, 2.0).abs() > at_rest.abs());
    }
}

#[test]
fn control_follows_the_turn_between_two_poses_on_the_short_way() {
    for angle in [1e-9, 0.3, 1.5, 3.1] {
        let axis = Vector3::new(0.6, 0.0, 0.8);
        let to = Pose::from_parts(
            Pose::identity().translation,
            UnitQuaternion::from_scaled_axis(axis * angle),
        );
        let turn = rotation_vector_between(&Pose::identity(), &to);
        assert!((turn - axis * angle).norm() < 1e-12, "{turn} for {angle}");
        // Both quaternions of a rotation are the same turn.
        let twin = UnitQuaternion::new_unchecked(-to.rotation.into_inner());
        let twin = Pose::from_parts(to.translation, twin);
        assert!((rotation_vector_between(&Pose::identity(), &twin) - turn).norm() < 1e-12);
    }
}

fn vectors() -> impl Strategy<Value = Vector3> {
    prop::array::uniform3(-1e3..1e3).prop_map(Vector3::from)
}

proptest! {
    #[test]
    fn a_saturated_force_keeps_its_direction_and_its_limit(force in vectors(), limit in 0.1..100.0) {
        let cut = saturate(force, limit);
        prop_assert!(cut.norm() <= limit * (1.0 + 1e-12));
        prop_assert!(cut.cross(&force).norm() <= 1e-9 * force.norm_squared());
        prop_assert!(cut.dot(&force) >= 0.0);
        if force.norm() <= limit {
            prop_assert_eq!(cut, force);
        } else {
            prop_assert!((cut.norm() - limit).abs() < 1e-9 * limit);
        }
    }
}

/// The posture task must not act at the tool: its efforts must not accelerate the tool.
#[test]
fn a_posture_that_is_pulled_to_does_not_move_the_tool() {
    let urdf = include_str!("../../../../robots/arm7.urdf");
    let start = [0.1, 0.5, -0.2, -1.2, 0.3, 0.9, 0.2];
    let pulled = [0.5, 0.1, 0.3, -0.9, -0.2, 1.1, 0.8];
    let mut arm = Machine::new(urdf, "tcp", &start, 0.7);
    arm.measure();
    let goal = arm.world_from_tool();
    let mut efforts = |posture: &[f64]| {
        arm.command(goal, posture);
        DVector::from_column_slice(arm.controller.efforts())
    };
    let difference = efforts(&pulled) - efforts(&start);
    assert!(difference.norm() > 0.5);
    let mass: DMatrix<f64> = arm.state.mass_matrix().clone();
    let moved = &arm.jacobian * mass.cholesky().unwrap().solve(&difference);
    assert!(moved.norm() < 1e-3 * difference.norm(), "{moved}");
}
