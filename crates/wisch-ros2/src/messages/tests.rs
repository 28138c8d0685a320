//! Messages are encoded as another library encodes them: `tests/cdr.py` writes the expected bytes.

use super::*;
use rustdds::RepresentationIdentifier;
use rustdds::serialization::{deserialize_from_cdr_with_rep_id, to_writer_with_rep_id};
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// The bytes of a message in `cdr.txt`.
fn expected(name: &str) -> Vec<u8> {
    let lines = include_str!("../../tests/cdr.txt").lines();
    let mut found = lines.filter_map(|line| line.split_once(' '));
    let (_, digits) = found.find(|(label, _)| *label == name).expect(name);
    let byte = |i: usize| u8::from_str_radix(&digits[i..i + 2], 16).unwrap();
    (0..digits.len()).step_by(2).map(byte).collect()
}

/// Checks a message in both directions.
fn check<M: Serialize + DeserializeOwned + PartialEq + Debug>(name: &str, message: &M) {
    let bytes = expected(name);
    let mut written = Vec::new();
    let encoding = RepresentationIdentifier::CDR_LE;
    to_writer_with_rep_id(&mut written, message, encoding).unwrap();
    // Some encoders fill the last word.
    assert_eq!(written, bytes[..written.len()], "{name}");
    assert!(bytes.len() - written.len() < 4, "{name}");
    let (read, _) = deserialize_from_cdr_with_rep_id::<M>(&bytes, encoding).unwrap();
    assert_eq!(read, *message, "{name}");
}

fn header() -> Header {
    Header {
        stamp: Stamp {
            sec: 3,
            nanosec: 500_000_000,
        },
        frame_id: "base".to_owned(),
    }
}

fn duration() -> Stamp {
    Stamp {
        sec: 1,
        nanosec: 250_000_000,
    }
}

fn names() -> Vec<String> {
    strings(&["a", "elbow"])
}

fn strings(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| (*text).to_owned()).collect()
}

fn point() -> PointMessage {
    PointMessage {
        positions: vec![1.0, 2.0],
        velocities: vec![0.5, -0.5],
        accelerations: vec![0.0, 3.0],
        effort: Vec::new(),
        time_from_start: duration(),
    }
}

fn vector(x: f64, y: f64, z: f64) -> Vector {
    Vector { x, y, z }
}

fn wrench() -> VectorPair {
    VectorPair {
        linear: vector(1.0, 2.0, 3.0),
        angular: vector(4.0, 5.0, 6.0),
    }
}

#[test]
fn states_and_wrenches_have_the_bytes_of_another_library() {
    for distro in ["humble", "jazzy"] {
        let state = JointStateMessage {
            header: header(),
            name: names(),
            position: vec![1.0, 2.0],
            velocity: vec![0.5, -0.5],
            effort: Vec::new(),
        };
        check(&format!("joint_state.{distro}"), &state);
        let stamped = WrenchStamped {
            header: header(),
            wrench: wrench(),
        };
        check(&format!("wrench.{distro}"), &stamped);
    }
}

#[test]
fn goals_and_the_controllers_state_have_the_bytes_of_another_library() {
    let goal = TrajectoryGoal {
        trajectory: TrajectoryMessage {
            header: header(),
            joint_names: names(),
            points: vec![point()],
        },
        path_tolerance: vec![JointTolerance {
            name: "elbow".to_owned(),
            position: 0.05,
            ..JointTolerance::default()
        }],
        goal_time_tolerance: duration(),
        ..TrajectoryGoal::default()
    };
    check("goal.humble", &goal);
    check("goal.jazzy", &goal);
    let empty = PointMessage {
        time_from_start: duration(),
        ..PointMessage::default()
    };
    let multi = MultiPointMessage {
        time_from_start: duration(),
        ..MultiPointMessage::default()
    };
    let state = TrajectoryControllerState {
        header: header(),
        joint_names: names(),
        reference: point(),
        feedback: empty.clone(),
        error: empty.clone(),
        output: empty,
        multi_dof_joint_names: Vec::new(),
        multi_dof: [(); 4].map(|()| multi.clone()),
        speed_scaling_factor: 0.75,
    };
    check("state.jazzy", &state);
    let encoding = RepresentationIdentifier::CDR_LE;
    let bytes = expected("state.jazzy");
    let (progress, _) =
        deserialize_from_cdr_with_rep_id::<ControllerProgress>(&bytes, encoding).unwrap();
    assert_eq!(progress.reference, point());
}

#[test]
fn force_mode_has_the_bytes_of_another_library() {
    let request = ForceModeRequest {
        task_frame: PoseStamped {
            header: header(),
            position: vector(0.1, 0.2, 0.3),
            orientation: QuaternionMessage {
                x: 0.0,
                y: 0.6,
                z: 0.0,
                w: 0.8,
            },
        },
        selection: [false, false, true, false, false, false],
        wrench: wrench(),
        frame_type: 2,
        speed_limits: VectorPair {
            linear: vector(0.0, 0.0, 0.03),
            ..VectorPair::default()
        },
        deviation_limits: [0.05, 0.05, 0.05, 0.3, 0.3, 0.3],
        damping_factor: 0.025,
        gain_scaling: 0.5,
    };
    check("force.humble", &request);
    check("force.jazzy", &request);
}

#[test]
fn the_controller_manager_of_each_distribution_has_the_bytes_of_another_library() {
    let chain = ChainConnection {
        name: "next".to_owned(),
        reference_interfaces: strings(&["r"]),
    };
    let humble = ControllerOfHumble {
        name: "jtc".to_owned(),
        state: "active".to_owned(),
        kind: "T".to_owned(),
        claimed_interfaces: strings(&["elbow/position"]),
        required_command_interfaces: strings(&["c"]),
        is_chainable: true,
        reference_interfaces: strings(&["r"]),
        chain_connections: vec![chain.clone()],
        ..ControllerOfHumble::default()
    };
    let list = ControllerList {
        controller: vec![humble],
    };
    check("controllers.humble", &list);
    let jazzy = ControllerOfJazzy {
        name: "jtc".to_owned(),
        state: "active".to_owned(),
        kind: "T".to_owned(),
        is_async: true,
        update_rate: 500,
        claimed_interfaces: strings(&["elbow/position"]),
        required_command_interfaces: strings(&["c"]),
        is_chainable: true,
        exported_state_interfaces: strings(&["x"]),
        reference_interfaces: strings(&["r"]),
        chain_connections: vec![chain],
        ..ControllerOfJazzy::default()
    };
    let list = ControllerList {
        controller: vec![jazzy],
    };
    check("controllers.jazzy", &list);
    let switch = SwitchOfHumble {
        activate_controllers: strings(&["jtc"]),
        strictness: 2,
        activate_asap: true,
        timeout: duration(),
        ..SwitchOfHumble::default()
    };
    check("switch.humble", &switch);
    let switch = SwitchOfJazzy {
        activate_controllers: strings(&["jtc"]),
        strictness: 2,
        activate_asap: true,
        timeout: duration(),
        ..SwitchOfJazzy::default()
    };
    check("switch.jazzy", &switch);
}
