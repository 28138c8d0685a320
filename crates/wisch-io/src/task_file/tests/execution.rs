//! The tables `[perception]` and `[execution]`.

use super::*;
use wisch::represent::{GrainSize, SensorModel};

fn execution(settings: &[(&str, &str)]) -> ExecutionRecord {
    set(SMALL, settings).unwrap().execution().clone()
}

#[test]
fn a_world_is_as_believed_but_for_its_dirt_unless_told() {
    let record = execution(&[]);
    assert_eq!(record.dirt, DirtRecord::default());
    assert_eq!(record.dirt.source, DirtSource::Stated(TrueDirt::Uniform));
    assert_eq!((record.tool_stiffness, record.footprint), (1.0, 1.0));
    assert_eq!(
        (record.grasp_offset, record.grasp_turn),
        (Vector2::zeros(), 0.0)
    );
    assert_eq!((record.encoder_noise, record.backlash), (0.0, 0.0));
    assert_eq!(
        (record.force_delay, record.force_drift),
        (0.0, Vector3::zeros())
    );
    assert_eq!((record.joint_friction, record.waviness), (0.0, 0.0));
    assert_eq!((record.grain_size, record.grain_mass), (None, None));
    assert_eq!(record.camera, CameraRecord::default());
}

#[test]
fn every_key_of_the_worlds_body_is_read() {
    let record = execution(&[
        ("execution.tool_stiffness", "0.7"),
        ("execution.footprint", "0.9"),
        ("execution.grasp_offset_m", "[0.01, -0.02]"),
        ("execution.grasp_turn_rad", "0.1"),
        ("execution.encoder_noise_rad", "0.0001"),
        ("execution.backlash_rad", "0.002"),
        ("execution.force_delay_s", "0.02"),
        ("execution.force_drift_n_per_s", "[0, 0, 0.01]"),
        ("execution.joint_friction_nm", "0.5"),
        ("execution.waviness_m", "0.001"),
        ("execution.waviness_length_m", "0.3"),
        ("execution.grain_size_m", "[0.001, 0.002]"),
        ("execution.grain_mass_kg", "0.003"),
        ("execution.grains_resist", "false"),
        (
            "execution.dirt",
            "{ source = \"edge\", within_m = 0.02, count = 9 }",
        ),
    ]);
    let (min_m, max_m) = (0.001, 0.002);
    assert_eq!(record.grain_size, Some(GrainSize { min_m, max_m }));
    let expected = ExecutionRecord {
        dirt: DirtRecord {
            source: DirtSource::Stated(TrueDirt::Edge(0.02)),
            count: Some(9),
        },
        grain_size: record.grain_size,
        grain_mass: Some(0.003),
        grains_resist: false,
        tool_stiffness: 0.7,
        footprint: 0.9,
        grasp_offset: Vector2::new(0.01, -0.02),
        grasp_turn: 0.1,
        encoder_noise: 0.0001,
        backlash: 0.002,
        force_delay: 0.02,
        force_drift: Vector3::new(0.0, 0.0, 0.01),
        joint_friction: 0.5,
        waviness: 0.001,
        waviness_length: 0.3,
        ..execution(&[])
    };
    assert_eq!(record, expected);
}

#[test]
fn touch_is_the_default_and_sight_has_a_sensor() {
    let sight = |settings: &[(&str, &str)]| set(SMALL, settings).unwrap().perception().sight;
    assert_eq!(sight(&[]), None);
    assert_eq!(sight(&[("perception.senses", "[\"touch\"]")]), None);
    let both = ("perception.senses", "[\"touch\", \"sight\"]");
    assert_eq!(sight(&[both]), Some(SensorModel::default()));
    let detection = 0.8;
    let worse = SensorModel {
        detection,
        ..SensorModel::default()
    };
    assert_eq!(sight(&[both, ("perception.detection", "0.8")]), Some(worse));
    // The real camera is the believed one but for what is told of it.
    let camera = execution(&[(
        "execution.camera",
        "{ half_size_m = 0.001, arm_hides = true }",
    )]);
    assert!(camera.camera.arm_hides);
    let real = camera.camera.complete(worse);
    assert_eq!((real.detection, real.half_size_m), (0.8, 0.001));
}

#[test]
fn a_fault_of_the_world_is_refused_with_its_place() {
    for (key, value, expected) in [
        (
            "perception.senses",
            "[\"sight\"]",
            "it is always one of the senses",
        ),
        (
            "perception.senses",
            "[\"touch\", \"touch\"]",
            "a sense is given twice",
        ),
        (
            "perception.senses",
            "[\"smell\"]",
            "unknown sense \"smell\"",
        ),
        (
            "perception.detection",
            "1.1",
            "perception.detection = 1.1 is outside",
        ),
        (
            "execution.dirt",
            "{ source = \"unifrom\" }",
            "nearest: uniform",
        ),
        (
            "execution.dirt",
            "{ source = \"edge\", with = 1 }",
            "unknown key \"with\"",
        ),
        (
            "execution.dirt",
            "{ source = \"clusters\", clusters = [] }",
            "0 clusters",
        ),
        (
            "execution.dirt",
            "{ source = \"as_believed\", count = 3 }",
            "unknown key \"count\"",
        ),
        (
            "execution.grain_size_m",
            "[0.002, 0.001]",
            "exceeds the largest",
        ),
        (
            "execution.tool_stiffness",
            "0.1",
            "at least 0.2 and at most 5",
        ),
        ("execution.footprint", "2", "at least 0.5 and at most 1.5"),
        (
            "execution.grasp_offset_m",
            "[0.1, 0]",
            "execution.grasp_offset_m[0] = 0.1",
        ),
        (
            "execution.waviness_m",
            "0.01",
            "at least 0 and at most 0.005",
        ),
        (
            "execution.camera",
            "{ detection = -1 }",
            "execution.camera.detection = -1",
        ),
    ] {
        let error = set(SMALL, &[(key, value)]).unwrap_err().to_string();
        assert!(error.contains(expected), "{key} = {value}: {error}");
    }
}
