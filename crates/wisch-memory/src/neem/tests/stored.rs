//! Export of stored episodes.

use super::super::collection_file;
use super::super::{NeemConfig, NeemError, NeemWriter, PoseSource, import, observations};
use super::{documents, meta, pushed_episode};
use crate::observations::tests::example_observations;
use crate::store::Memory;
use crate::telemetry::{Mark, TelemetryHead};
use bson::{DateTime, RawDocumentBuf};
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::robot::RobotModel;

/// A memory with [`pushed_episode`] in it: one second at 1 kHz of an arm that turns about its first joint.
fn write_stored_episode(folder: &std::path::Path, robot: &RobotModel) -> Memory {
    let memory = Memory::create(&folder.join("episodes")).unwrap();
    let writer = memory.begin(&pushed_episode().id).unwrap();
    let joints: Vec<String> = (0..robot.dof())
        .map(|variable| robot.variable(variable).name.clone())
        .collect();
    let origin =
        serde_json::json!({"position": [0.0, 0.0, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0]});
    let mut tool = origin.clone();
    tool["position"] = serde_json::json!([0.0, 0.0, 0.25]);
    let tip = &robot.links().last().unwrap().name;
    let scene = serde_json::json!({
        "schema": 1, "robot": "arm7", "world_from_root": origin, "tip": tip, "tip_from_tool": tool,
        "tool": "sponge", "surface": "chopping_board", "world_from_surface": origin,
    });
    let mut columns: Vec<String> = joints
        .iter()
        .map(|joint| format!("position/{joint}"))
        .collect();
    columns.extend(["x", "y", "z", "qx", "qy", "qz", "qw"].map(|part| format!("measured/{part}")));
    columns.extend(["fx", "fy", "fz", "mx", "my", "mz"].map(|part| format!("external/{part}")));
    let head = TelemetryHead {
        joints: joints.clone(),
        notes: [("scene".to_owned(), scene.to_string())].into(),
    };
    let mut log = writer.telemetry_with_columns(1, head, &columns).unwrap();
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for step in 0..1000 {
        let time = 1e-3 * f64::from(step);
        let mut row = vec![0.0; columns.len()];
        row[0] = time;
        row[joints.len()..].copy_from_slice(&[
            0.5, 0.25, time, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -8.0, 0.0, 0.0, 0.0,
        ]);
        log.push(time, mark, row).unwrap();
    }
    log.finish().unwrap();
    writer.observations(1, &example_observations()).unwrap();
    writer.commit(&pushed_episode()).unwrap();
    memory
}

fn arm() -> RobotModel {
    let urdf = include_str!("../../../../../robots/arm7.urdf");
    RobotModel::from_urdf("arm7.urdf", urdf, &mut |mesh| Err(mesh.to_owned())).unwrap()
}

#[test]
fn a_stored_episode_is_exported_with_poses_and_wrenches() {
    let folder = tempfile::tempdir().unwrap();
    let robot = arm();
    let memory = write_stored_episode(folder.path(), &robot);
    let episode = memory.episode(&pushed_episode().id).unwrap();
    let export = |name, poses| {
        let neem = folder.path().join(name);
        let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
        writer.write_stored_episode(&episode, poses).unwrap();
        (writer.finish().unwrap(), neem)
    };
    let (report, by_tool) = export("tool", PoseSource::Tool);
    assert_eq!((report.poses, report.wrenches), (10, 1000));
    assert_eq!(report.observations, 2);
    let (report, by_robot) = export("robot", PoseSource::Robot(&robot));
    let frames = robot.links().len() as u64 + 3;
    assert_eq!((report.poses, report.wrenches), (10 * frames, 1000));
    for neem in [&by_tool, &by_robot] {
        assert_eq!(import(neem).unwrap(), [pushed_episode()]);
        let rounds = [(1, example_observations())].into();
        let expected = [(pushed_episode().id, rounds)].into();
        assert_eq!(observations(neem).unwrap(), expected);
        let documents = documents(neem, "observation");
        let headers = documents.iter().map(|seen| {
            let header = seen.get_document("header").unwrap();
            (
                header.get_f64("time").unwrap(),
                header.get_str("frame_id").unwrap(),
            )
        });
        let [start, end] = pushed_episode().interval;
        let expected = [(start, "chopping_board"), (end, "chopping_board")];
        assert_eq!(headers.collect::<Vec<_>>(), expected);
    }
    let sponge = |neem| -> Vec<RawDocumentBuf> {
        let mut poses = documents(neem, "tf");
        poses.retain(|pose| pose.get_str("child_frame_id").ok() == Some("sponge"));
        poses
    };
    let position = |pose: &RawDocumentBuf| {
        let transform = pose.get_document("transform").unwrap();
        let translation = transform.get_document("translation").unwrap();
        ["x", "y", "z"].map(|axis| translation.get_f64(axis).unwrap())
    };
    let stamp = |pose: &RawDocumentBuf| {
        let header = pose.get_document("header").unwrap();
        header.get_datetime("stamp").unwrap()
    };
    for (number, pose) in sponge(&by_tool).iter().enumerate() {
        let [x, y, z] = position(pose);
        assert_eq!([x, y], [0.5, 0.25]);
        // Telemetry stores poses in single precision.
        assert!((z - 0.1 * number as f64).abs() < 1e-6, "{z}");
    }
    for (number, pose) in sponge(&by_robot).iter().enumerate() {
        let mut q = vec![0.0; robot.dof()];
        q[0] = f64::from(0.1_f32 * number as f32);
        let kinematics = robot.forward_kinematics(&q).unwrap();
        let tip = robot.link(&robot.links().last().unwrap().name).unwrap();
        let expected = kinematics.world_from_link(tip) * Pose::translation(0.0, 0.0, 0.25);
        let error = Vector3::from(position(pose)) - expected.translation.vector;
        assert!(error.norm() < 1e-6, "{error}");
        let milliseconds = 1_767_225_600_000 + 100 * number as i64;
        assert_eq!(stamp(pose), DateTime::from_millis(milliseconds));
    }
}

#[test]
fn wrenches_are_in_the_frame_of_the_tool_and_usable() {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    let writer = memory.begin(&pushed_episode().id).unwrap();
    let pose = ["x", "y", "z", "qx", "qy", "qz", "qw"].map(|part| format!("measured/{part}"));
    let wrenches = ["controller", "external"]
        .iter()
        .flat_map(|what| ["fx", "fy", "fz", "mx", "my", "mz"].map(|part| format!("{what}/{part}")));
    let columns: Vec<String> = pose
        .into_iter()
        .chain(wrenches)
        .chain(["wrench_quality".to_owned()])
        .collect();
    let head = TelemetryHead::default();
    let mut log = writer.telemetry_with_columns(1, head, &columns).unwrap();
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    // A quarter turn about y: the tool's z points along the world's x, and its x against the world's z.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for (step, quality) in [(0_u8, 0.0), (1, 1.0)] {
        let row = [
            &[9.0, 0.0, 0.0, 0.0, half, 0.0, half][..],
            &[0.0; 6],
            &[7.0, 0.0, -2.0, 0.0, 0.0, 3.0],
            &[quality],
        ];
        log.push(0.01 * f64::from(step), mark, row.concat())
            .unwrap();
    }
    log.finish().unwrap();
    writer.commit(&pushed_episode()).unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    let episode = memory.episode(&pushed_episode().id).unwrap();
    writer
        .write_stored_episode(&episode, PoseSource::Tool)
        .unwrap();
    let report = writer.finish().unwrap();
    // The second sample is stale, and no controller stated a wrench.
    assert_eq!((report.wrenches, report.unusable_wrenches), (1, 1));
    let wrench = &documents(&neem, "wrench")[0];
    assert_eq!(wrench.get_str("__topic").ok(), Some("wrench/external"));
    assert_eq!(wrench.get_str("episode").ok(), Some(&*pushed_episode().id));
    let header = wrench.get_document("header").unwrap();
    let poses = documents(&neem, "tf");
    assert_eq!(
        header.get_str("frame_id").ok(),
        poses[0].get_str("child_frame_id").ok()
    );
    let part = |name| {
        let part = wrench.get_document("wrench").unwrap().get_document(name);
        ["x", "y", "z"].map(|axis| part.as_ref().unwrap().get_f64(axis).unwrap())
    };
    for (name, expected) in [("force", [2.0, 0.0, 7.0]), ("torque", [-3.0, 0.0, 0.0])] {
        let off = Vector3::from(part(name)) - Vector3::from(expected);
        assert!(off.norm() < 1e-5, "{name}: {:?}", part(name));
    }
}

#[test]
fn an_invalid_observation_is_reported_with_its_document() {
    let folder = tempfile::tempdir().unwrap();
    let memory = write_stored_episode(folder.path(), &arm());
    let episode = memory.episode(&pushed_episode().id).unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    writer
        .write_stored_episode(&episode, PoseSource::Tool)
        .unwrap();
    writer.finish().unwrap();
    let path = collection_file(&neem, "observation");
    let whole = std::fs::read(&path).unwrap();
    let refused = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        observations(&neem).unwrap_err().to_string()
    };
    let changed = |part: &[u8], other: &[u8]| {
        let mut bytes = whole.clone();
        let at = bytes.windows(part.len()).position(|bytes| bytes == part);
        let at = at.expect("such a part");
        bytes[at..at + part.len()].copy_from_slice(other);
        bytes
    };
    for (part, other, message) in [
        (
            &b"dirt_before"[..],
            &b"dirt_during"[..],
            "document 0 is not an observation: __topic",
        ),
        (b"dirt_before", b"dirt_after\0", "document 0"),
        (b"detections", b"Detections", "detections are not lists"),
        (b"episode", b"Episode", "it has no episode"),
    ] {
        let error = refused(&changed(part, other));
        assert!(
            error.contains("observation.bson: ") && error.contains(message),
            "{error}"
        );
    }
    let twice = [&whole[..], &whole].concat();
    let error = refused(&twice);
    assert!(
        error.contains("document 2") && error.contains("already has this observation"),
        "{error}"
    );
    assert!(refused(&whole[..whole.len() - 3]).contains("observation.bson"));
    // NEEMs from before observations lack this collection.
    std::fs::remove_file(&path).unwrap();
    assert!(observations(&neem).unwrap().is_empty());
}

#[test]
fn telemetry_of_another_robot_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let memory = write_stored_episode(folder.path(), &arm());
    let urdf = include_str!("../../../../../robots/arm6.urdf");
    let other = RobotModel::from_urdf("arm6.urdf", urdf, &mut |mesh| Err(mesh.to_owned())).unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    let episode = memory.episode(&pushed_episode().id).unwrap();
    let refused = writer.write_stored_episode(&episode, PoseSource::Robot(&other));
    assert!(matches!(refused, Err(NeemError::Frames(_))), "{refused:?}");
}
