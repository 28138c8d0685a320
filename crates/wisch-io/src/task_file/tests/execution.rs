//! The tables `[perception]` and `[execution]`.

use super::*;
use crate::KnowledgeSource;
use wisch::geometry::{Pose, Vector3};
use wisch::represent::{GrainSize, LogNormal, SensorModel};
use wisch_sim::{Camera, GrainCount, RealTool, Sensing, SimulationSettings, TrueDirt, Waviness};

/// The task of these settings and its world, over the shipped knowledge.
fn world(settings: &[(&str, &str)]) -> (Task, SimulationSettings) {
    let file = set(SMALL, settings).unwrap();
    let task = resolved(&file).unwrap();
    let knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    let no_files = &mut |path: &str| Err(format!("{path}: there are no files here"));
    let world = file.simulation(&task, &knowledge, no_files).unwrap();
    (task, world)
}

#[test]
fn a_world_is_as_believed_except_for_its_dirt_unless_set() {
    let (task, found) = world(&[]);
    let knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    let believed = SimulationSettings::as_believed(&task, &knowledge, None).unwrap();
    assert_eq!(found, believed);
    assert_eq!(found.dirt, TrueDirt::Uniform);
    assert_eq!(found.count, GrainCount::About(10));
    assert_eq!((found.tool.stiffness, found.tool.footprint), (1.0, 1.0));
    assert_eq!(
        (found.tool.grasp_offset, found.tool.grasp_turn),
        (Vector2::zeros(), 0.0)
    );
    let sensing = found.sensing;
    assert_eq!((sensing.encoder_noise, sensing.backlash), (0.0, 0.0));
    assert_eq!(
        (sensing.force_delay, sensing.force_drift),
        (0.0, Vector3::zeros())
    );
    assert_eq!((found.joint_friction, found.waviness.height), (0.0, 0.0));
    let crumbs = knowledge.medium("breadcrumbs").unwrap().grain_size.unwrap();
    assert_eq!(
        (found.grain_size.max_m, found.grain_mass),
        (crumbs.max_m, None)
    );
    assert_eq!(found.camera, None);
    assert_eq!((found.force_noise, found.max_bodies), (0.15, 400));
}

#[test]
fn every_key_of_the_worlds_body_is_read() {
    let (_, found) = world(&[
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
        ("execution.force_noise_n", "0.3"),
        ("execution.force_bias_n", "[1, 2, 3]"),
        ("execution.surface_shift_m", "[0.01, 0, 0]"),
        ("execution.friction", "0.6"),
        ("execution.mu", "-2"),
        ("execution.sigma", "0.4"),
        ("execution.max_bodies", "7"),
        (
            "execution.dirt",
            "{ source = \"edge\", within_m = 0.02, count = 9 }",
        ),
    ]);
    let (_, believed) = world(&[]);
    let expected = SimulationSettings {
        believed_from_real: Pose::translation(0.01, 0.0, 0.0),
        friction: 0.6,
        force_noise: 0.3,
        force_bias: Vector3::new(1.0, 2.0, 3.0),
        likelihood: LogNormal {
            mu: -2.0,
            sigma: 0.4,
        },
        max_bodies: 7,
        dirt: TrueDirt::Edge(0.02),
        count: GrainCount::Exactly(9),
        grain_size: GrainSize {
            min_m: 0.001,
            max_m: 0.002,
        },
        grain_mass: Some(0.003),
        grains_resist: false,
        tool: RealTool {
            stiffness: 0.7,
            footprint: 0.9,
            grasp_offset: Vector2::new(0.01, -0.02),
            grasp_turn: 0.1,
        },
        sensing: Sensing {
            encoder_noise: 0.0001,
            backlash: 0.002,
            force_delay: 0.02,
            force_drift: Vector3::new(0.0, 0.0, 0.01),
        },
        joint_friction: 0.5,
        waviness: Waviness {
            height: 0.001,
            length: 0.3,
        },
        ..believed
    };
    assert_eq!(found, expected);
}

#[test]
fn touch_is_the_default_and_sight_has_a_sensor() {
    let camera = |settings: &[(&str, &str)]| set(SMALL, settings).unwrap().camera;
    assert_eq!(camera(&[]), None);
    assert_eq!(camera(&[("perception.senses", "[\"touch\"]")]), None);
    let both = ("perception.senses", "[\"touch\", \"sight\"]");
    assert_eq!(camera(&[both]), Some(SensorModel::default()));
    let detection = 0.8;
    let worse = SensorModel {
        detection,
        ..SensorModel::default()
    };
    let detects_less = ("perception.detection", "0.8");
    assert_eq!(camera(&[both, detects_less]), Some(worse));
    // The real camera is the believed one, except for the values that the task sets.
    let real = "{ half_size_m = 0.001, arm_hides = true }";
    let (_, found) = world(&[both, detects_less, ("execution.camera", real)]);
    let half_size_m = 0.001;
    let expected = Camera {
        sensor: SensorModel {
            half_size_m,
            ..worse
        },
        arm_hides: true,
    };
    assert_eq!(found.camera, Some(expected));
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
