//! Bags of other robots and other libraries.

use super::{in_folder, named, refused, surface};
use mcap::WriteOptions;
use mcap::records::MessageHeader;
use nalgebra::UnitQuaternion;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::robot::joint_transforms;
use wisch_telemetry::{
    Axes, AxesChoice, AxesSource, Clock, Log, LogOptions, TopicChoice, WrenchSign, read,
};

/// A bag of some other robot, topic by topic.
struct Foreign {
    bag: mcap::Writer<std::io::BufWriter<fs::File>>,
}

#[derive(Serialize)]
struct Stamped<T> {
    stamp: [u32; 2],
    frame: &'static str,
    data: T,
}

const HEADER_PARTS: &str = "===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n===\n\
                            MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const POSE_PARTS: &str = "===\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation\n===\n\
                          MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n===\n\
                          MSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n";
const WRENCH_PARTS: &str = "===\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n===\n\
                            MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";

impl Foreign {
    fn create(path: &Path) -> Self {
        let file = std::io::BufWriter::new(fs::File::create(path).unwrap());
        let options = WriteOptions::new().profile("ros2").compression(None);
        Self {
            bag: options.create(file).unwrap(),
        }
    }

    fn topic(&mut self, name: &str, kind: &str, definition: &str) -> u16 {
        let schema = self
            .bag
            .add_schema(kind, "ros2msg", definition.as_bytes())
            .unwrap();
        self.bag
            .add_channel(schema, name, "cdr", &BTreeMap::new())
            .unwrap()
    }

    fn poses(&mut self, name: &str) -> u16 {
        let definition =
            format!("# where it is\nstd_msgs/Header header\nPose pose\n{HEADER_PARTS}{POSE_PARTS}");
        self.topic(name, "geometry_msgs/msg/PoseStamped", &definition)
    }

    fn wrenches(&mut self, name: &str) -> u16 {
        let definition =
            format!("std_msgs/Header header\nWrench wrench\n{HEADER_PARTS}{WRENCH_PARTS}");
        self.topic(name, "geometry_msgs/msg/WrenchStamped", &definition)
    }

    /// The stamp may be zero where the log's time is not.
    fn put<T: Serialize>(
        &mut self,
        channel: u16,
        time_ms: u64,
        stamp_ms: u64,
        frame: &'static str,
        data: T,
    ) {
        let stamp = [
            (stamp_ms / 1000) as u32,
            (stamp_ms % 1000) as u32 * 1_000_000,
        ];
        let message = Stamped { stamp, frame, data };
        let data = cdr::serialize::<_, _, cdr::CdrLe>(&message, cdr::Infinite).unwrap();
        let log_time = time_ms * 1_000_000;
        let header = MessageHeader {
            channel_id: channel,
            sequence: 0,
            log_time,
            publish_time: log_time,
        };
        self.bag.write_to_known_channel(&header, &data).unwrap();
    }

    fn finish(mut self) {
        self.bag.finish().unwrap();
    }
}

/// Turned by a quarter about x: what is up in the log lies along y of the tool.
const QUARTER: [f64; 4] = [
    std::f64::consts::FRAC_1_SQRT_2,
    0.0,
    0.0,
    std::f64::consts::FRAC_1_SQRT_2,
];

/// A transform: stamp, frame, child frame, where the child is and how it is turned.
type Transform = ([u32; 2], &'static str, &'static str, [f64; 3], [f64; 4]);

const UPRIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

impl Foreign {
    fn transforms(&mut self, name: &str) -> u16 {
        let definition = format!(
            "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\n\
             std_msgs/Header header\nstring child_frame_id\nTransform transform\n===\n\
             MSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation\n===\n\
             MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n===\n\
             MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n{HEADER_PARTS}"
        );
        self.topic(name, "tf2_msgs/msg/TFMessage", &definition)
    }

    fn put_transforms(&mut self, channel: u16, time_ms: u64, transforms: &[Transform]) {
        let data = cdr::serialize::<_, _, cdr::CdrLe>(&transforms.to_vec(), cdr::Infinite).unwrap();
        let log_time = time_ms * 1_000_000;
        let header = MessageHeader {
            channel_id: channel,
            sequence: 0,
            log_time,
            publish_time: log_time,
        };
        self.bag.write_to_known_channel(&header, &data).unwrap();
    }
}

/// A robot whose base stands off the world, with a force sensor at its flange that is turned by a quarter about x. The
/// flange goes 0.1 m along x of the base; where `is_moving`, its transforms are told, too.
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
            // The flange is taken for what the pose is of.
            (Axes::Tool, AxesSource::Assumed)
        };
        assert_eq!((log.axes, log.axes_source), expected);
        assert_eq!(log.frames_used.len(), 2, "{:?}", log.frames_used);
        for (index, sample) in log.samples.iter().enumerate() {
            // The base is turned by half a turn about z: x of the base runs along -x of the world.
            let at = Vector3::new(1.0 - 1e-3 * index as f64, 0.0, 0.8);
            assert!((sample.world_from_tool.translation.vector - at).norm() < 1e-9);
            // y of the sensor is z of the flange.
            assert!((sample.force - Vector3::new(0.0, 0.0, 10.0)).norm() < 1e-9);
        }
    }
}

/// A lift that carries a turning column with a camera: its mast follows the lift at half its way.
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
        // What is measured every 20 ms is interpolated.
        if time.is_multiple_of(20) {
            let measured = state([share, 0.4 * share, 2.0 * share]);
            bag.put(joints, time, time, "", measured);
        }
        bag.put(commands, time, time, "", state([0.0; 3]));
        // The tool stands still in the base, so it moves in the camera.
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
        log.frames_used,
        [
            "poses in \"camera\" are brought into \"robot_base\" by the log's transforms and the robot's joints",
            "forces in \"ft_sensor\" are turned into \"camera\" by the log's transforms and the robot's joints",
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
    // Without the robot nothing leads from frame to frame.
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(log.frames_used, [] as [String; 0]);
}

#[test]
fn static_transforms_are_no_poses_of_a_tool() {
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

#[test]
fn a_sensor_is_turned_by_a_urdf_or_by_hand() {
    let (_folder, path) = in_folder();
    foreign(&path, "sensor", 0);
    let urdf = r#"<robot name="arm"><link name="flange"/><link name="sensor"/>
        <joint name="bolts" type="fixed"><parent link="flange"/><child link="sensor"/>
        <origin rpy="0 0 1.5707963267948966"/></joint></robot>"#;
    let by_urdf = LogOptions {
        joints: joint_transforms("arm.urdf", urdf).unwrap(),
        ..in_millimetres()
    };
    let by_hand = LogOptions {
        logged_from_sensor: Some(UnitQuaternion::from_euler_angles(
            0.0,
            0.0,
            std::f64::consts::FRAC_PI_2,
        )),
        ..in_millimetres()
    };
    for (options, source) in [(by_urdf, AxesSource::Assumed), (by_hand, AxesSource::Given)] {
        let log = read(&path, &options).unwrap();
        assert_eq!((log.axes, log.axes_source), (Axes::Tool, source));
        // -y of the sensor is x of the flange, which is x of the log.
        assert!((log.samples[0].force - Vector3::new(2.0, 0.0, 0.0)).norm() < 1e-9);
    }
}

#[test]
fn what_is_no_number_is_left_out_and_counted_and_gaps_are_told() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let (pose, wrench) = (bag.poses("/p"), bag.wrenches("/w"));
    for time in (0..=100).chain(300..=400).map(|tick| 10 * tick) {
        let x = if time == 500 { f64::NAN } else { 0.0 };
        bag.put(pose, time, 1 + time, "base", ([x, 0.0, 0.0], QUARTER));
        bag.put(wrench, time, 1 + time, "base", ([0.0; 3], [0.0; 3]));
    }
    bag.finish();
    let log = read(&path, &LogOptions::default()).unwrap();
    let [skipped] = &log.skipped[..] else {
        panic!("{:?}", log.skipped);
    };
    assert_eq!(skipped.count, 1);
    assert_eq!(
        skipped.first,
        "topic /p, message 51: x is NaN, which is not finite"
    );
    assert_eq!(log.samples.len(), 202, "between its neighbours it is known");
    let [[start, end]] = log.gaps[..] else {
        panic!("{:?}", log.gaps);
    };
    assert!((start - 1.0).abs() < 1e-9 && (end - 3.0).abs() < 1e-9);
}

/// A robot that logs its flange at 10 Hz in millimetres and the force on it at 100 Hz.
fn foreign(path: &Path, wrench_frame: &'static str, stamp_offset_ms: u64) {
    let mut bag = Foreign::create(path);
    let (pose, wrench) = (bag.poses("/arm/pose"), bag.wrenches("/arm/wrench"));
    for time in (0..=1000).step_by(10) {
        let stamp = match stamp_offset_ms {
            0 => 0,
            offset => offset + time,
        };
        if time % 100 == 0 {
            bag.put(
                pose,
                60_000 + time,
                stamp,
                "base",
                ([time as f64, 0.0, 50.0], QUARTER),
            );
        }
        bag.put(
            wrench,
            60_000 + time,
            stamp,
            wrench_frame,
            ([0.0, -2.0, 0.0], [0.0; 3]),
        );
    }
    bag.finish();
}

fn in_millimetres() -> LogOptions {
    LogOptions {
        length_unit: Some(1e-3),
        ..LogOptions::default()
    }
}

#[test]
fn a_foreign_bag_is_understood() {
    let (_folder, path) = in_folder();
    for stamp_offset in [0, 7_000] {
        foreign(&path, "sensor", stamp_offset);
        let log = read(&path, &in_millimetres()).unwrap();
        assert_eq!(log.samples.len(), 101, "the force sets the pace");
        assert_eq!(
            (log.axes, log.axes_source),
            (Axes::Tool, AxesSource::Assumed)
        );
        let start = if stamp_offset == 0 { 60 } else { 7 };
        assert_eq!(log.start, start * 1_000_000_000);
        for (index, sample) in log.samples.iter().enumerate() {
            let time = index as f64 / 100.0;
            assert!((sample.time - time).abs() < 1e-9);
            // One metre per second, in millimetres.
            assert!((sample.world_from_tool.translation.x - time).abs() < 1e-9);
            assert!((sample.force - Vector3::new(0.0, 0.0, -2.0)).norm() < 1e-9);
        }
    }
}

#[test]
fn frames_signs_units_and_offsets_are_applied() {
    let (_folder, path) = in_folder();
    foreign(&path, "base", 0);
    let first = |options: LogOptions| {
        let log: Log = read(&path, &options).unwrap();
        (log.axes, log.axes_source, log.samples[0])
    };
    let (axes, source, sample) = first(in_millimetres());
    assert_eq!(
        (axes, source),
        (Axes::Log, AxesSource::Logged),
        "both are said to be in base"
    );
    assert_eq!(sample.force, Vector3::new(0.0, -2.0, 0.0));

    let world_from_log = Pose::new(
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::z() * std::f64::consts::FRAC_PI_2,
    );
    let base = LogOptions {
        world_from_log: Some(world_from_log),
        world_from_surface: surface(),
        ..in_millimetres()
    };
    let force_in = |axes| {
        first(LogOptions {
            axes: AxesChoice::Given(axes),
            ..base.clone()
        })
        .2
        .force
    };
    let close = |a: Vector3, b: Vector3| assert!((a - b).norm() < 1e-9, "{a} {b}");
    close(force_in(Axes::World), Vector3::new(0.0, -2.0, 0.0));
    close(force_in(Axes::Log), Vector3::new(2.0, 0.0, 0.0));
    close(force_in(Axes::Tool), Vector3::new(0.0, 0.0, -2.0));
    close(
        force_in(Axes::Surface),
        surface().rotation * Vector3::new(0.0, -2.0, 0.0),
    );

    let by_tool = LogOptions {
        sign: Some(WrenchSign::ByTool),
        force_unit: Some(9.81),
        ..in_millimetres()
    };
    close(first(by_tool).2.force, Vector3::new(0.0, 2.0 * 9.81, 0.0));

    // The tool sticks out of the flange by 0.2 m along the flange's z, which is −y of the log.
    let logged_from_tool = Pose::translation(0.0, 0.0, 0.2);
    let (.., sample) = first(LogOptions {
        logged_from_tool,
        ..base.clone()
    });
    let tip = sample.world_from_tool.translation.vector;
    close(
        tip,
        world_from_log
            .transform_point(&Point3::new(0.0, -0.2, 0.05))
            .coords,
    );
}

#[test]
fn two_topics_that_might_be_meant_are_told_and_none_as_well() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let (left, right) = (bag.poses("/left"), bag.poses("/right"));
    bag.put(left, 0, 0, "base", ([0.0; 3], QUARTER));
    bag.put(right, 0, 0, "base", ([0.0; 3], QUARTER));
    bag.finish();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": 2 topics hold a pose, and one has to be chosen: /left, /right"
    );
    let options = LogOptions {
        pose_topic: TopicChoice::Named("/left".to_owned()),
        ..LogOptions::default()
    };
    assert_eq!(
        refused(&path, &options),
        ": no topic holds a wrench; there are: /left (geometry_msgs/msg/PoseStamped), /right (geometry_msgs/msg/PoseStamped)"
    );
}

#[test]
fn values_that_cannot_be_are_refused_with_their_message() {
    let (_folder, path) = in_folder();
    type Poses = [(u64, f64, [f64; 4])];
    let cases: [(&Poses, &str); 3] = [
        (
            &[(0, f64::NAN, QUARTER), (5, f64::NAN, QUARTER)],
            ": topic /p, message 1: x is NaN, which is not finite",
        ),
        (
            &[(0, 0.0, [0.0; 4])],
            ": topic /p, message 1: the quaternion has a length of 0, which is not within 0.01 of 1",
        ),
        (
            &[(9_000, 0.0, QUARTER), (1_000, 0.0, QUARTER)],
            ": topic /p, message 2: its time of 1 s is 8 s before the latest one before it, 9 s; the limit is 5 s",
        ),
    ];
    for (poses, expected) in cases {
        let mut bag = Foreign::create(&path);
        let (pose, wrench) = (bag.poses("/p"), bag.wrenches("/w"));
        for (time, x, q) in poses {
            bag.put(pose, *time, *time, "base", ([*x, 0.0, 0.0], *q));
        }
        bag.put(wrench, 0, 0, "base", ([0.0; 3], [0.0; 3]));
        bag.finish();
        assert_eq!(refused(&path, &LogOptions::default()), expected);
    }
}

#[test]
fn encodings_and_schemas_that_are_not_read_are_told() {
    let (_folder, path) = in_folder();
    let cases = [
        (
            ["ros1msg", "ros1", ""],
            ": topic /p: its message encoding is \"ros1\", and only \"cdr\" is read",
        ),
        (
            ["ros2idl", "cdr", ""],
            ": topic /p: its schema encoding is \"ros2idl\", and only \"ros2msg\" is read",
        ),
        (
            ["ros2msg", "cdr", "Pose pose\n"],
            ": topic /p: line 1 of the schema: type \"Pose\" is not defined",
        ),
    ];
    for ([schema_encoding, message_encoding, definition], expected) in cases {
        let mut bag = Foreign::create(&path);
        let schema = bag.bag.add_schema(
            "geometry_msgs/msg/PoseStamped",
            schema_encoding,
            definition.as_bytes(),
        );
        let channel = bag
            .bag
            .add_channel(schema.unwrap(), "/p", message_encoding, &BTreeMap::new())
            .unwrap();
        bag.put(channel, 0, 0, "base", 0_u8);
        bag.finish();
        assert_eq!(refused(&path, &named("/p", "/w")), expected);
    }
}

#[test]
fn what_is_no_bag_is_told_by_its_first_bytes() {
    let (_folder, path) = in_folder();
    fs::write(&path, b"#ROSBAG V2.0\n").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is a bag of ROS 1, and only MCAP files are read"
    );
    fs::write(&path, b"SQLite format 3\0...").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is a bag of ROS 2 in a SQLite database (.db3), and only MCAP files are read"
    );
    fs::write(&path, b"PK\x03\x04 what?").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is no bag: it begins with bytes 50 4b 03 04 20 77 68 61, and an MCAP file with 89 4d 43 41 50 30 0d 0a"
    );
    fs::write(&path, b"").unwrap();
    assert!(refused(&path, &LogOptions::default()).starts_with(": this is no bag"));
    let shown = refused(Path::new("/no/such/place.mcap"), &LogOptions::default());
    assert!(shown.starts_with(": No such file"), "{shown}");
}

/// The bag is written by the Python libraries of MCAP, see peers/bag.py.
#[test]
fn a_bag_of_another_library_is_understood() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/foreign.mcap");
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/arm/flange", "/arm/ft")
    );
    assert_eq!((log.axes, log.axes_source), (Axes::Log, AxesSource::Logged));
    assert_eq!(
        log.start, 1_699_999_999_995_000_000,
        "the stamp counts, not the recording"
    );
    assert_eq!((log.samples.len(), log.unpaired, log.repeated), (201, 0, 0));
    for (tick, sample) in log.samples.iter().enumerate() {
        let x = tick as f64 * 0.001;
        assert!((sample.time - tick as f64 * 0.01).abs() < 1e-12);
        assert!(
            (sample.world_from_tool.translation.vector - Vector3::new(x, 0.0, 0.5)).norm() < 1e-12
        );
        assert!((sample.force - Vector3::new(0.0, x, 5.0)).norm() < 1e-12);
    }
}

#[test]
fn a_folder_of_parts_is_one_log() {
    let (folder, _) = in_folder();
    for (part, name) in ["a_2.mcap", "a_10.mcap"].into_iter().enumerate() {
        let mut bag = Foreign::create(&folder.path().join(name));
        let (pose, wrench) = (bag.poses("/p"), bag.wrenches("/w"));
        for time in [0, 10] {
            let time = 1000 + 20 * part as u64 + time;
            bag.put(pose, time, time, "base", ([0.0; 3], QUARTER));
            bag.put(wrench, time, time, "base", ([0.0; 3], [0.0; 3]));
        }
        bag.finish();
    }
    assert_eq!(
        read(folder.path(), &LogOptions::default())
            .unwrap()
            .samples
            .len(),
        4
    );
    let empty = tempfile::tempdir().unwrap();
    assert_eq!(
        refused(empty.path(), &LogOptions::default()),
        ": the folder holds no .mcap file"
    );
}

/// A tool that goes 0.1 m/s along x and is pressed with 1 N per second, every 10 ms; who writes it may say each message's
/// time of recording and stamps of pose and force [ms].
fn ramp(path: &Path, times: impl IntoIterator<Item = [u64; 4]>) {
    let mut bag = Foreign::create(path);
    let (pose, wrench) = (bag.poses("/tool/pose"), bag.wrenches("/ft"));
    for [true_time, log_time, pose_stamp, wrench_stamp] in times {
        let seconds = true_time as f64 / 1000.0;
        let at = [0.1 * seconds, 0.0, 0.0];
        bag.put(pose, log_time, pose_stamp, "base", (at, UPRIGHT));
        let force = [0.0, 0.0, seconds];
        bag.put(wrench, log_time, wrench_stamp, "base", (force, [0.0; 3]));
    }
    bag.finish();
}

/// Samples of such a tool agree with one another wherever they begin.
fn assert_ramp(log: &Log, count: usize) {
    assert_eq!(log.samples.len(), count, "{:?}", log.remarks);
    let start = log.samples[0].world_from_tool.translation.x / 0.1;
    for sample in &log.samples {
        let x = sample.world_from_tool.translation.x;
        assert!(
            (x - 0.1 * (sample.time + start)).abs() < 1e-6,
            "{x} at {}",
            sample.time
        );
        assert!(
            (sample.force.z - 10.0 * x).abs() < 1e-6,
            "{} at {x}",
            sample.force.z
        );
    }
}

#[test]
fn messages_are_put_into_the_order_of_their_stamps() {
    let (_folder, path) = in_folder();
    let mut times: Vec<u64> = (1000..=2000).step_by(10).collect();
    times.swap(20, 50);
    ramp(&path, times.iter().map(|&time| [time; 4]));
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_ramp(&log, 101);
    assert!(
        log.remarks[0].ends_with(
            "of /tool/pose came up to 0.300 s late and were put into the order of time (limit 5 s)"
        ),
        "{:?}",
        log.remarks
    );
    // Within a shorter window that is a clock that went back.
    let narrow = LogOptions {
        reorder_window: 0.1,
        ..LogOptions::default()
    };
    let shown = refused(&path, &narrow);
    assert!(shown.contains("its time of 1.21 s is"), "{shown}");
}

#[test]
fn parts_of_a_bag_may_overlap() {
    let (folder, _) = in_folder();
    // The later part begins before the earlier one ends, by more than the window.
    let parts = [(0..60), (40..101)];
    for (index, part) in parts.into_iter().enumerate() {
        let name = format!("split_{index}.mcap");
        let times = part.map(|tick| [100_000 + 1000 * tick; 4]);
        ramp(&folder.path().join(name), times);
    }
    let log = read(folder.path(), &LogOptions::default()).unwrap();
    assert_ramp(&log, 101);
    assert_eq!(log.repeated, 40, "twenty poses and forces stand in both");
}

#[test]
fn stamps_that_are_missing_are_taken_from_the_recording() {
    let (_folder, path) = in_folder();
    let stamp = |time: u64| {
        if time.is_multiple_of(50) {
            0
        } else {
            time + 300
        }
    };
    let times = (1000..=2000).step_by(10);
    ramp(
        &path,
        times.map(|time| [time, time, stamp(time), time + 300]),
    );
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_ramp(&log, 101);
    assert!(
        log.remarks
            .iter()
            .any(|said| said.starts_with("21 of 101 messages of /tool/pose bear no stamp")),
        "{:?}",
        log.remarks
    );
}

#[test]
fn a_sensor_with_a_clock_of_its_own_is_aligned() {
    let (_folder, path) = in_folder();
    let times = || (1000..=2000).step_by(10);
    ramp(
        &path,
        times().map(|time| [time, time, time, time + 7_000_300]),
    );
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_ramp(&log, 101);
    assert!(
        log.remarks[0].starts_with("the clock of /ft is +7000.300 s off that of the poses"),
        "{:?}",
        log.remarks
    );
    // The times of recording alone need no alignment, whatever the stamps say.
    let recorded = LogOptions {
        clock: Clock::Log,
        ..LogOptions::default()
    };
    ramp(&path, times().map(|time| [time, time, 3 * time, 5]));
    let log = read(&path, &recorded).unwrap();
    assert_ramp(&log, 101);
    assert_eq!(log.remarks, [] as [String; 0]);
}

#[test]
fn bags_that_are_packed_as_a_whole_or_by_message_are_read() {
    let (folder, path) = in_folder();
    ramp(&path, (1000..=2000).step_by(10).map(|time| [time; 4]));
    let plain = fs::read(&path).unwrap();
    let level = ruzstd::encoding::CompressionLevel::Fastest;
    let packed = ruzstd::encoding::compress_to_vec(plain.as_slice(), level);
    fs::remove_file(&path).unwrap();
    let name = folder.path().join("bag_0.mcap.zstd");
    fs::write(&name, packed).unwrap();
    for path in [&name, folder.path()] {
        assert_ramp(&read(path, &LogOptions::default()).unwrap(), 101);
    }
    let mut bag = Foreign::create(&path);
    for message in mcap::MessageStream::new(&plain).unwrap() {
        let mut message = message.unwrap();
        let packed = ruzstd::encoding::compress_to_vec(&*message.data, level);
        message.data = packed.into();
        bag.bag.write(&message).unwrap();
    }
    bag.finish();
    assert_ramp(&read(&path, &LogOptions::default()).unwrap(), 101);
}

/// An arm whose wrist turns below a lift, with a tool that is bolted to it; what is bolted stands among fixed transforms.
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
        // By a quarter about x: y of the wrist is z of the lift.
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
        // The wrist's quarter turns the force in y of the tool up.
        assert_ramp(&log, 101);
        assert!((log.samples[0].world_from_tool.translation.z - 0.7).abs() < 1e-9);
    }
    let named = |frame: &str| LogOptions {
        pose_topic: TopicChoice::Named(format!("/tf:{frame}")),
        ..LogOptions::default()
    };
    let camera = read(&path, &named("camera")).unwrap();
    assert!((camera.samples[0].world_from_tool.translation.y + 0.1).abs() < 1e-9);
    let shown = refused(&path, &named("tool1"));
    assert!(
        shown.starts_with(": unknown frame \"tool1\"; nearest: tool0"),
        "{shown}"
    );
    let in_tool = LogOptions {
        world_frame: "flange".to_owned(),
        ..named("tool0")
    };
    let shown = refused(&path, &in_tool);
    assert!(
        shown.starts_with(": frame \"tool0\" never moves in \"flange\""),
        "{shown}"
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

#[test]
fn pose_and_force_may_stand_in_one_message() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let definition = format!(
        "std_msgs/Header header\nint8 mode\ngeometry_msgs/Pose tool\ngeometry_msgs/Wrench load\n{HEADER_PARTS}{POSE_PARTS}{WRENCH_PARTS}"
    );
    let state = bag.topic("/arm/state", "arm_msgs/msg/State", &definition);
    for time in (1000..=2000_u64).step_by(10) {
        let seconds = time as f64 / 1000.0;
        let pose = ([0.1 * seconds, 0.0, 0.0], UPRIGHT);
        let load = ([0.0, 0.0, seconds], [0.0; 3]);
        bag.put(state, time, time, "base", (1_i8, pose, load));
    }
    bag.finish();
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/arm/state:tool", "/arm/state:load")
    );
    assert_ramp(&log, 101);
}

#[test]
fn topics_that_are_not_read_are_told_with_the_reason() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let json = bag
        .bag
        .add_schema("geometry_msgs/msg/PoseStamped", "jsonschema", b"{}")
        .unwrap();
    let pose = (bag.bag)
        .add_channel(json, "/tcp_pose", "json", &BTreeMap::new())
        .unwrap();
    let wrench = bag.wrenches("/ft");
    bag.put(pose, 0, 0, "base", 0_u8);
    bag.put(wrench, 0, 0, "base", ([0.0; 3], [0.0; 3]));
    bag.finish();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": no topic holds a pose; there are: /ft (geometry_msgs/msg/WrenchStamped). What is not read: topic /tcp_pose: \
         its message encoding is \"json\", and only \"cdr\" is read"
    );
}

#[cfg(unix)]
#[test]
fn a_pipe_is_refused_at_once() {
    let (_folder, path) = in_folder();
    let made = std::process::Command::new("mkfifo").arg(&path).status();
    assert!(made.unwrap().success());
    let expected = ": this is a pipe, and only files and folders are read";
    assert_eq!(refused(&path, &LogOptions::default()), expected);
}
