//! Poses along transforms and joints of a log.

use super::foreign_bag::{Foreign, HEADER_PARTS, QUARTER, UPRIGHT, assert_ramp};
use super::{in_folder, refused};
use nalgebra::UnitQuaternion;
use std::path::Path;
use wisch::geometry::{Pose, Vector3};
use wisch::robot::joint_transforms;
use wisch_telemetry::{Axes, AxesSource, LogOptions, TopicChoice, read};

/// Writes the log of a robot whose base is not at the world's origin, with a force sensor at its flange that is rotated by
/// 90° about x. The flange moves by 0.1 m along x of the base. `is_moving`: publish its transforms, too.
fn with_transforms(path: &Path, is_moving: bool) {
    let mut bag = Foreign::create(path);
    let [fixed, moving] = ["/tf_static", "/tf"].map(|name| bag.transforms(name));
    let (pose, wrench) = (bag.poses("/arm/pose"), bag.wrenches("/arm/wrench"));
    let never = [0, 0];
    bag.put_transforms(
        fixed,
        1000,
        &[
            (
                never,
                "world",
                "robot_base",
                [1.0, 0.0, 0.5],
                [0.0, 0.0, 1.0, 0.0],
            ),
            (never, "flange", "ft_sensor", [0.0; 3], QUARTER),
        ],
    );
    for time in (1000..=2000).step_by(10) {
        let stamp = [(time / 1000) as u32, (time % 1000) as u32 * 1_000_000];
        let at = [0.1 * (time - 1000) as f64 / 1000.0, 0.0, 0.3];
        if is_moving {
            let down = (stamp, "robot_base", "flange", at, UPRIGHT);
            bag.put_transforms(moving, time, &[down]);
        }
        bag.put(pose, time, time, "robot_base", (at, UPRIGHT));
        bag.put(
            wrench,
            time,
            time,
            "ft_sensor",
            ([0.0, 10.0, 0.0], [0.0; 3]),
        );
    }
    bag.finish();
}

#[test]
fn frames_are_resolved_by_the_transforms_of_the_log() {
    let (_folder, path) = in_folder();
    for is_moving in [true, false] {
        with_transforms(&path, is_moving);
        let log = read(&path, &LogOptions::default()).unwrap();
        assert_eq!(log.pose_name, "/arm/pose");
        assert_eq!((log.samples.len(), log.unpaired), (101, 0));
        let expected = if is_moving {
            (Axes::Named, AxesSource::Logged)
        } else {
            // The reader assumes that the pose is that of the flange.
            (Axes::Tool, AxesSource::Assumed)
        };
        assert_eq!((log.axes, log.axes_source), expected);
        assert_eq!(log.conventions.len(), 2, "{:?}", log.conventions);
        for (index, sample) in log.samples.iter().enumerate() {
            // The base is rotated by 180° about z: x of the base is -x of the world.
            let at = Vector3::new(1.0 - 1e-3 * index as f64, 0.0, 0.8);
            assert!((sample.world_from_tool.translation.vector - at).norm() < 1e-9);
            // y of the sensor is z of the flange.
            assert!((sample.force - Vector3::new(0.0, 0.0, 10.0)).norm() < 1e-9);
        }
    }
}

/// A lift that carries a rotating column with a camera; its mast moves by half the stroke of the lift.
const LIFT: &str = r#"<robot name="lift"><link name="robot_base"/><link name="mast"/><link name="table"/>
    <link name="column"/><link name="camera"/><link name="flange"/><link name="ft_sensor"/>
    <joint name="lift_half" type="prismatic"><parent link="robot_base"/><child link="mast"/><axis xyz="0 0 1"/>
        <mimic joint="lift" multiplier="0.5" offset="0.1"/><limit lower="0" upper="1" velocity="1" effort="1"/></joint>
    <joint name="lift" type="prismatic"><parent link="mast"/><child link="table"/><axis xyz="0 0 2"/>
        <limit lower="0" upper="1" velocity="1" effort="1"/></joint>
    <joint name="turn" type="continuous"><parent link="table"/><child link="column"/><axis xyz="0 0 1"/></joint>
    <joint name="eye" type="fixed"><parent link="column"/><child link="camera"/><origin xyz="0 0 0.5"/></joint>
    <joint name="wrist" type="revolute"><parent link="robot_base"/><child link="flange"/><axis xyz="1 0 0"/>
        <limit lower="-4" upper="4" velocity="1" effort="1"/></joint>
    <joint name="bolts" type="fixed"><parent link="flange"/><child link="ft_sensor"/></joint></robot>"#;

#[test]
fn frames_are_resolved_by_the_joints_of_a_robot() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let definition = format!(
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n{HEADER_PARTS}"
    );
    let [joints, commands] = ["/joint_states", "/joint_commands"]
        .map(|name| bag.topic(name, "sensor_msgs/msg/JointState", &definition));
    let (pose, wrench) = (bag.poses("/camera/tool"), bag.wrenches("/ft"));
    for time in (1000..=2000_u64).step_by(10) {
        let share = (time - 1000) as f64 / 1000.0;
        let state = |positions: [f64; 3]| {
            let (names, empty) = (vec!["turn", "lift", "wrist"], Vec::<f64>::new());
            (names, positions.to_vec(), empty.clone(), empty)
        };
        // Joint positions are measured every 20 ms and interpolated.
        if time.is_multiple_of(20) {
            let measured = state([share, 0.4 * share, 2.0 * share]);
            bag.put(joints, time, time, "", measured);
        }
        bag.put(commands, time, time, "", state([0.0; 3]));
        // The tool is fixed in the base, so it moves in the camera's frame.
        let base_from_camera = Pose::new(
            Vector3::new(0.0, 0.0, 0.1 + 0.2 * share + 0.4 * share + 0.5),
            Vector3::z() * share,
        );
        let camera_from_tool = base_from_camera.inverse() * Pose::translation(0.6, 0.1, 0.2);
        let at: [f64; 3] = camera_from_tool.translation.vector.into();
        let turn: [f64; 4] = camera_from_tool.rotation.coords.into();
        bag.put(pose, time, time, "camera", (at, turn));
        let base_from_sensor = UnitQuaternion::from_scaled_axis(Vector3::x() * 2.0 * share);
        let force: [f64; 3] = (base_from_sensor.inverse() * Vector3::new(0.0, 3.0, 9.0)).into();
        bag.put(wrench, time, time, "ft_sensor", (force, [0.0; 3]));
    }
    bag.finish();
    let options = LogOptions {
        joints: joint_transforms("lift.urdf", LIFT).unwrap(),
        world_frame: "robot_base".to_owned(),
        ..LogOptions::default()
    };
    let log = read(&path, &options).unwrap();
    assert_eq!((log.samples.len(), log.unpaired), (101, 0));
    assert_eq!(
        (log.axes, log.axes_source),
        (Axes::Named, AxesSource::Logged)
    );
    assert_eq!(
        log.conventions,
        [
            "poses in \"camera\" are transformed into \"robot_base\" by the log's transforms and the robot's joints",
            "forces in \"ft_sensor\" are rotated into \"camera\" by the log's transforms and the robot's joints",
        ]
    );
    for sample in &log.samples {
        let at = sample.world_from_tool.translation.vector;
        assert!((at - Vector3::new(0.6, 0.1, 0.2)).norm() < 1e-9, "{at}");
        assert!(sample.world_from_tool.rotation.angle() < 1e-9);
        assert!(
            (sample.force - Vector3::new(0.0, 3.0, 9.0)).norm() < 1e-9,
            "{}",
            sample.force
        );
    }
    // Without the robot, no transforms connect the frames.
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(
        log.conventions,
        [
            "poses in \"camera\" are read as if this frame were \"world\", as no transform of the log connects them; --world-from-log states their pose"
        ]
    );
}

#[test]
fn static_transforms_are_not_poses_of_a_tool() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let [fixed, moving] = ["/tf_static", "/tf"].map(|name| bag.transforms(name));
    let wrench = bag.wrenches("/arm/wrench");
    let never = [0, 0];
    bag.put_transforms(fixed, 1000, &[(never, "tool", "camera", [0.0; 3], UPRIGHT)]);
    for time in (1000..=1100_u64).step_by(10) {
        let stamp = [1, (time - 1000) as u32 * 1_000_000];
        let at = [0.01 * time as f64, 0.0, 0.0];
        let shelf = (stamp, "world", "shelf", [0.0; 3], UPRIGHT);
        bag.put_transforms(
            moving,
            time,
            &[(stamp, "world", "tool", at, UPRIGHT), shelf],
        );
        bag.put(wrench, time, time, "tool", ([0.0, 0.0, 1.0], [0.0; 3]));
    }
    bag.finish();
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(log.pose_name, "/tf:tool");
    assert_eq!(
        (log.axes, log.axes_source),
        (Axes::Tool, AxesSource::Logged)
    );
}

/// Writes the log of an arm whose wrist rotates below a lift, with a tool that is fixed to it by static transforms.
fn chain(path: &Path) {
    let mut bag = Foreign::create(path);
    let [fixed, moving] = ["/tf_static", "/tf"].map(|name| bag.transforms(name));
    let wrench = bag.wrenches("/ft");
    let never = [0, 0];
    bag.put_transforms(
        fixed,
        1000,
        &[
            (never, "wrist", "flange", [0.0; 3], UPRIGHT),
            (never, "flange", "tool0", [0.0, 0.2, 0.0], UPRIGHT),
            (never, "flange", "camera", [0.0, 0.0, 0.1], UPRIGHT),
        ],
    );
    for time in (1000..=2000_u64).step_by(10) {
        let stamp = [(time / 1000) as u32, (time % 1000) as u32 * 1_000_000];
        let seconds = time as f64 / 1000.0;
        let lift = (stamp, "world", "lift", [0.1 * seconds, 0.0, 0.5], UPRIGHT);
        // A rotation by 90° about x: y of the wrist is z of the lift.
        bag.put_transforms(
            moving,
            time,
            &[lift, (stamp, "lift", "wrist", [0.0; 3], QUARTER)],
        );
        bag.put(wrench, time, time, "tool0", ([0.0, seconds, 0.0], [0.0; 3]));
    }
    bag.finish();
}

#[test]
fn a_pose_is_found_along_moving_and_fixed_transforms() {
    let (_folder, path) = in_folder();
    chain(&path);
    for topic in [
        TopicChoice::Sole,
        TopicChoice::Named("/tf:tool0".to_owned()),
    ] {
        let options = LogOptions {
            pose_topic: topic,
            ..LogOptions::default()
        };
        let log = read(&path, &options).unwrap();
        assert_eq!(log.pose_name, "/tf:tool0");
        // The rotation of the wrist turns the force along y of the tool upwards.
        assert_ramp(&log, 101);
        assert!((log.samples[0].world_from_tool.translation.z - 0.7).abs() < 1e-9);
    }
    let named = |frame: &str| LogOptions {
        pose_topic: TopicChoice::Named(format!("/tf:{frame}")),
        ..LogOptions::default()
    };
    let camera = read(&path, &named("camera")).unwrap();
    assert!((camera.samples[0].world_from_tool.translation.y + 0.1).abs() < 1e-9);
    let message = refused(&path, &named("tool1"));
    assert!(
        message.starts_with(": unknown frame \"tool1\"; nearest: tool0"),
        "{message}"
    );
    let in_tool = LogOptions {
        world_frame: "flange".to_owned(),
        ..named("tool0")
    };
    let message = refused(&path, &in_tool);
    assert!(
        message.starts_with(": frame \"tool0\" never moves in \"flange\""),
        "{message}"
    );
}

#[test]
fn a_pose_is_found_by_positions_of_joints() {
    let (_folder, path) = in_folder();
    let definition = format!(
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n{HEADER_PARTS}"
    );
    let urdf = r#"<robot name="gantry"><link name="world"/><link name="x"/><link name="z"/><link name="tcp"/>
        <joint name="along" type="prismatic"><parent link="world"/><child link="x"/><axis xyz="1 0 0"/>
            <limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
        <joint name="up" type="prismatic"><parent link="x"/><child link="z"/><axis xyz="0 0 1"/>
            <limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
        <joint name="bolts" type="fixed"><parent link="z"/><child link="tcp"/><origin xyz="0 0 -0.1"/></joint></robot>"#;
    let mut bag = Foreign::create(&path);
    let joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState", &definition);
    let wrench = bag.wrenches("/ft");
    for time in (1000..=2000_u64).step_by(10) {
        let seconds = time as f64 / 1000.0;
        let empty = Vec::<f64>::new;
        let state = (
            vec!["along", "up"],
            vec![0.1 * seconds, 0.01 * seconds],
            empty(),
            empty(),
        );
        bag.put(joints, time, time, "", state);
        bag.put(wrench, time, time, "tcp", ([0.0, 0.0, seconds], [0.0; 3]));
    }
    bag.finish();
    let options = LogOptions {
        joints: joint_transforms("gantry.urdf", urdf).unwrap(),
        ..LogOptions::default()
    };
    let log = read(&path, &options).unwrap();
    assert_eq!(log.pose_name, "/joint_states:tcp");
    assert_ramp(&log, 101);
    assert!((log.samples[100].world_from_tool.translation.z + 0.08).abs() < 1e-9);
    assert!(
        log.remarks[0].starts_with("the pose is that of \"tcp\""),
        "{:?}",
        log.remarks
    );
}
