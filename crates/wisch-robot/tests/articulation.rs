//! The dynamics of control loops against those of the robot model, which share no code with them.

use nalgebra::{DVector, Matrix3, Matrix6xX, UnitQuaternion};
use proptest::prelude::*;
use wisch_robot::geometry::{Point3, Pose, Vector3};
use wisch_robot::{Articulation, Body, RobotModel};

const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);
/// Relative to the greatest entry, but at least 1.
const TOLERANCE: f64 = 1e-9;

fn robots() -> [RobotModel; 3] {
    let read = |name: &str, text: &str| {
        RobotModel::from_urdf(name, text, &mut |_| Err(String::new())).unwrap()
    };
    [
        read("arm6", include_str!("../../../robots/arm6.urdf")),
        read("arm7", include_str!("../../../robots/arm7.urdf")),
        // One joint of its torso follows two others.
        read("humanoid", include_str!("../../../robots/humanoid.urdf")),
    ]
}

fn tip(robot: &RobotModel) -> wisch_robot::LinkId {
    ["tcp", "right_tcp"]
        .iter()
        .find_map(|name| robot.link(name).ok())
        .unwrap()
}

/// Returns the first entries of an infinite sequence.
fn first(count: usize, supply: &[f64]) -> Vec<f64> {
    supply.iter().copied().cycle().take(count).collect()
}

fn supply(size: f64) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-size..size, 32)
}

fn pose() -> impl Strategy<Value = Pose> {
    (
        prop::array::uniform3(-1.0..1.0),
        prop::array::uniform3(-2.0..2.0),
    )
        .prop_map(|(at, turn)| {
            Pose::from_parts(
                Vector3::from(at).into(),
                UnitQuaternion::from_scaled_axis(Vector3::from(turn)),
            )
        })
}

/// The greatest difference between two lists, over their greatest entry.
fn difference<'a>(
    found: impl Iterator<Item = &'a f64>,
    expected: impl Iterator<Item = &'a f64>,
) -> f64 {
    let (mut worst, mut scale) = (0.0_f64, 1.0_f64);
    for (a, b) in found.zip(expected) {
        worst = worst.max((a - b).abs());
        scale = scale.max(b.abs());
    }
    worst / scale
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn mass_matrix_bias_and_inverse_dynamics_are_those_of_the_model(
        q in supply(2.0), qd in supply(1.5), qdd in supply(3.0), world_from_root in pose()
    ) {
        for robot in robots() {
            let count = robot.dof();
            let (q, qd, qdd) = (first(count, &q), first(count, &qd), first(count, &qdd));
            let all = vec![true; count];
            let moving = Articulation::new(&robot, &world_from_root, &q, &all, &[]).unwrap();
            let mut state = moving.state();
            moving.evaluate(&mut state, &q, &qd, GRAVITY);
            let dynamics = robot.dynamics().unwrap();
            let mass = dynamics.mass_matrix(&q).unwrap();
            prop_assert!(difference(state.mass_matrix().iter(), mass.iter()) < TOLERANCE);
            let fall = world_from_root.rotation.inverse() * GRAVITY;
            let bias = dynamics.bias(&q, &qd, fall).unwrap();
            prop_assert!(difference(state.bias().iter(), bias.iter()) < TOLERANCE);

            moving.inverse_dynamics(&mut state, &qd, &qdd, GRAVITY);
            let mut efforts = vec![0.0; count];
            for (joint, effort) in moving.joints().iter().zip(state.joint_efforts()) {
                for &(variable, factor) in &joint.terms {
                    efforts[variable] += factor * effort;
                }
            }
            let expected = dynamics.inverse_dynamics(&q, &qd, &qdd, fall).unwrap();
            prop_assert!(difference(efforts.iter(), expected.iter()) < TOLERANCE);
        }
    }

    #[test]
    fn what_holds_still_is_carried_along(
        q in supply(2.0), qd in supply(1.5), frozen in prop::collection::vec(any::<bool>(), 32)
    ) {
        for robot in robots() {
            let count = robot.dof();
            let q = first(count, &q);
            let moves: Vec<bool> = frozen.iter().map(|f| !f).take(count).collect();
            let moving = Articulation::new(&robot, &Pose::identity(), &q, &moves, &[]).unwrap();
            let own = moving.variables();
            prop_assert!(own.iter().all(|&i| moves[i]));
            let mut all_qd = first(count, &qd);
            for (i, rate) in all_qd.iter_mut().enumerate() {
                if !moves[i] {
                    *rate = 0.0;
                }
            }
            let pick = |values: &[f64]| -> Vec<f64> { own.iter().map(|&i| values[i]).collect() };
            let mut state = moving.state();
            moving.evaluate(&mut state, &pick(&q), &pick(&all_qd), GRAVITY);
            let dynamics = robot.dynamics().unwrap();
            let mass = dynamics.mass_matrix(&q).unwrap();
            let mass = mass.select_rows(own).select_columns(own);
            prop_assert!(difference(state.mass_matrix().iter(), mass.iter()) < TOLERANCE);
            let bias = dynamics.bias(&q, &all_qd, GRAVITY).unwrap();
            let bias = pick(bias.as_slice());
            prop_assert!(difference(state.bias().iter(), bias.iter()) < TOLERANCE);
        }
    }

    #[test]
    fn a_load_adds_the_energy_of_its_motion(q in supply(2.0), qd in supply(1.5), held in pose()) {
        for robot in robots() {
            let count = robot.dof();
            let (q, qd) = (first(count, &q), first(count, &qd));
            let load = Body {
                mass: 1.5,
                center_in_link: held.translation.vector.into(),
                inertia_about_center: Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.04)),
            };
            let tip = tip(&robot);
            let all = vec![true; count];
            let energy = |loads: &[(wisch_robot::LinkId, Body)]| {
                let moving =
                    Articulation::new(&robot, &Pose::identity(), &q, &all, loads).unwrap();
                let mut state = moving.state();
                moving.evaluate(&mut state, &q, &qd, GRAVITY);
                let rates = DVector::from_column_slice(&qd);
                let energy = 0.5 * rates.dot(&(state.mass_matrix() * &rates));
                let (carrier, joint_from_tip) = moving.carrier(tip);
                let world_from_tip = state.pose(carrier.unwrap()) * joint_from_tip;
                let center: Point3 = world_from_tip * load.center_in_link;
                let mut jacobian = Matrix6xX::zeros(count);
                moving.jacobian(&state, carrier.unwrap(), center, &mut jacobian);
                (energy, world_from_tip, jacobian * rates)
            };
            let (without, world_from_tip, velocity) = energy(&[]);
            let (with, ..) = energy(&[(tip, load)]);
            let linear: Vector3 = velocity.fixed_rows::<3>(0).into();
            let angular: Vector3 = velocity.fixed_rows::<3>(3).into();
            let spin = world_from_tip.rotation.inverse() * angular;
            let expected = 0.5 * load.mass * linear.norm_squared()
                + 0.5 * spin.dot(&(load.inertia_about_center * spin));
            prop_assert!((with - without - expected).abs() < TOLERANCE * with.max(1.0));
        }
    }

    #[test]
    fn the_jacobian_is_how_the_tip_moves(q in supply(2.0), world_from_root in pose()) {
        /// Step of central differences [rad or m].
        const STEP: f64 = 1e-6;
        for robot in robots() {
            let count = robot.dof();
            let q = first(count, &q);
            let all = vec![true; count];
            let moving = Articulation::new(&robot, &world_from_root, &q, &all, &[]).unwrap();
            let (carrier, joint_from_tip) = moving.carrier(tip(&robot));
            let carrier = carrier.unwrap();
            let mut state = moving.state();
            let mut place = |q: &[f64]| {
                moving.locate(&mut state, q);
                state.pose(carrier) * joint_from_tip
            };
            let here = place(&q);
            let mut jacobian = Matrix6xX::zeros(count);
            let mut moved = q.clone();
            let mut columns = Vec::new();
            for i in 0..count {
                moved[i] = q[i] + STEP;
                let ahead = place(&moved);
                moved[i] = q[i] - STEP;
                let behind = place(&moved);
                moved[i] = q[i];
                let linear = (ahead.translation.vector - behind.translation.vector) / (2.0 * STEP);
                let turn = (ahead.rotation * behind.rotation.inverse()).scaled_axis();
                columns.push((linear, turn / (2.0 * STEP)));
            }
            moving.locate(&mut state, &q);
            moving.jacobian(&state, carrier, here.translation.vector.into(), &mut jacobian);
            for (column, (linear, angular)) in jacobian.column_iter().zip(&columns) {
                let error = (column.fixed_rows::<3>(0) - linear).norm()
                    + (column.fixed_rows::<3>(3) - angular).norm();
                prop_assert!(error < 1e-7, "{error}");
            }
        }
    }
}

#[test]
fn wrong_lengths_and_numbers_are_refused() {
    let [robot, ..] = robots();
    let count = robot.dof();
    let new = |posture: &[f64], moving: &[bool]| {
        Articulation::new(&robot, &Pose::identity(), posture, moving, &[]).map(|_| ())
    };
    let (zeros, all) = (vec![0.0; count], vec![true; count]);
    assert_eq!(new(&zeros, &all), Ok(()));
    assert!(new(&zeros[1..], &all).is_err());
    let error = new(&zeros, &all[1..]).unwrap_err().to_string();
    assert!(error.contains("moving variables"), "{error}");
    let mut bad = zeros.clone();
    bad[0] = f64::NAN;
    assert!(new(&bad, &all).is_err());
}

/// Both stages of a telescopic lift move by the same distance.
#[test]
fn a_joint_that_follows_with_the_factor_1_is_no_variable() {
    let stage = |name: &str, parent: &str, child: &str, mimic: &str| {
        format!(
            r#"<link name="{child}"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
            <joint name="{name}" type="prismatic"><parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>
            <limit lower="0" upper="1" velocity="1" effort="500"/>{mimic}</joint>"#
        )
    };
    let urdf = format!(
        r#"<robot name="lift"><link name="base"/>{}{}</robot>"#,
        stage("first", "base", "a", ""),
        stage("second", "a", "b", r#"<mimic joint="first"/>"#)
    );
    let robot = RobotModel::from_urdf("lift", &urdf, &mut |_| Err(String::new())).unwrap();
    let lift = Articulation::new(&robot, &Pose::identity(), &[0.2], &[true], &[]).unwrap();
    let are_variables: Vec<bool> = lift
        .joints()
        .iter()
        .map(|joint| joint.is_variable)
        .collect();
    assert_eq!(are_variables, [true, false]);
    // The upper stage moves by twice the distance.
    let mut state = lift.state();
    lift.evaluate(&mut state, &[0.2], &[0.0], GRAVITY);
    assert!((state.mass_matrix()[(0, 0)] - (2.0 + 2.0 * 4.0)).abs() < TOLERANCE);
}
