//! A simulated arm follows setpoints that another program gives.

use std::ops::ControlFlow;
use wisch::control::ControlConfig;
use wisch::follow::{Followed, TrajectorySample, Workcell};
use wisch::run::MotionOrder;
use wisch_io::{LoadOptions, load_task};
use wisch_sim::{Dirt, LiveArm};

/// Joint whose setpoint moves, and its velocity [rad/s].
const JOINT: usize = 0;
const VELOCITY: f64 = 0.2;

/// Moves the setpoint of one joint for 300 periods. Returns the positions at the end, and the setpoint.
fn follow_setpoints() -> (Vec<f64>, Vec<f64>) {
    let loaded = load_task("arm-board".as_ref(), &LoadOptions::default()).unwrap();
    let robot = loaded.robot().unwrap().unwrap();
    let record = loaded.file.robot.as_ref().unwrap();
    let config = record.workcell_config(&loaded.task);
    let cell = Workcell::new(robot.model, robot.srdf.as_ref(), &loaded.task, &config).unwrap();
    let settings = loaded.simulation.clone();
    let control = ControlConfig::default();
    let at_rest = Followed::new(*cell.tip_from_tool());
    let order = MotionOrder {
        round: 1,
        seed: 1,
        task: &loaded.task,
        cell: &cell,
        followed: &at_rest,
    };
    let mut arm = LiveArm::new(&order, &settings, &Dirt::default(), &control).unwrap();
    let mut setpoint = TrajectorySample::from_positions(cell.ready_posture());
    setpoint.qd[JOINT] = VELOCITY;
    let mut positions = Vec::new();
    for _ in 0..300 {
        setpoint.q[JOINT] += VELOCITY * control.period;
        let stopped = arm.step(&setpoint, 0.0, &mut |sample| {
            positions = sample.positions.to_vec();
            ControlFlow::Continue(())
        });
        assert_eq!(stopped.unwrap(), None);
    }
    (positions, setpoint.q)
}

#[test]
fn an_arm_follows_its_setpoints_and_the_same_setpoints_give_the_same_bits() {
    let (positions, setpoint) = follow_setpoints();
    for (i, (measured, wanted)) in positions.iter().zip(&setpoint).enumerate() {
        assert!(
            (measured - wanted).abs() < 0.01,
            "joint {i}: {measured} and {wanted}"
        );
    }
    assert_eq!(follow_setpoints().0, positions);
}
