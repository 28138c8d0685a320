//! The control loop allocates nothing once it runs: a robot must not wait for an allocator. The
//! engine of the simulated world does allocate, so the parts of the loop are tested alone.

use crate::ALLOCATOR;
use nalgebra::{Matrix6xX, Vector6};
use stats_alloc::Region as Watched;
use wisch::control::{
    ControlConfig, DesiredPosture, DesiredToolState, ImpedanceController, MeasuredJointState,
    MomentumObserver, Wrench,
};
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::represent::{Surface, SurfaceShape};
use wisch::robot::{Articulation, RobotModel};
use wisch_testkit::{interaction, surface};

const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

pub fn a_period_of_control_allocates_nothing() {
    let text = include_str!("../../../../robots/humanoid.urdf");
    let robot = RobotModel::from_urdf("humanoid", text, &mut |_| Err(String::new())).unwrap();
    let count = robot.dof();
    let mut q: Vec<f64> = (0..count).map(|i| 0.02 * i as f64).collect();
    // Beyond the end of the range, so that the joint stops act.
    let last = robot.variable(count - 1).limits.position;
    q[count - 1] = last.map_or(0.0, |range| range.upper + 0.01);
    let qd = vec![0.1; count];
    let all: Vec<usize> = (0..count).collect();
    let moving = Articulation::new(&robot, &Pose::identity(), &q, &vec![true; count], &[]).unwrap();
    let (carrier, _) = moving.carrier(robot.link("right_tcp").unwrap());
    let carrier = carrier.unwrap();
    let config = ControlConfig::default();
    let ranges = all.iter().map(|&i| robot.variable(i).limits.position);
    // On a cylinder the axes of the stiffness turn too.
    let bent = Surface {
        shape: SurfaceShape::Cylinder {
            radius: 1.0,
            axis: 0.0,
        },
        ..surface([1.0, 1.0])
    };
    let mut controller = ImpedanceController::new(
        all.clone(),
        ranges.collect(),
        &interaction(),
        &bent,
        &config,
    );
    let mut observer = MomentumObserver::new(&all, count, config.observer_gain);
    let mut state = moving.state();
    let mut jacobian = Matrix6xX::zeros(count);
    let mut period = || {
        moving.evaluate(&mut state, &q, &qd, GRAVITY);
        let world_from_tool = state.pose(carrier);
        let tool = Point3::from(world_from_tool.translation.vector);
        moving.jacobian(&state, carrier, tool, &mut jacobian);
        let external = observer.update(&state, &qd, controller.efforts(), config.period);
        let measured = MeasuredJointState {
            q: &q,
            qd: &qd,
            world_from_tool,
            jacobian: &jacobian,
        };
        let desired = DesiredToolState {
            world_from_tool: Pose::translation(0.5, 0.0, 0.7),
            velocity: Vector6::zeros(),
        };
        let posture = DesiredPosture {
            q: &q,
            qd: &qd,
            qdd: &qd,
        };
        let command = controller.command(&state, &measured, &desired, &posture);
        assert!(command.is_some());
        let felt: Wrench = controller.external_wrench(external);
        assert!(felt.force.norm().is_finite());
        moving.inverse_dynamics(&mut state, &qd, &qd, GRAVITY);
    };
    period();

    let watched = Watched::new(ALLOCATOR);
    let before = watched.change().allocations;
    // The damping is designed anew every ten periods.
    for _ in 0..25 {
        period();
    }
    assert_eq!(watched.change().allocations, before);

    // The counter detects an allocation.
    let grown: Vec<u8> = Vec::with_capacity(std::hint::black_box(64));
    assert_eq!(watched.change().allocations, before + 1);
    drop(grown);
}
