//! Bags of other robots and other libraries.

use super::foreign_bag::{
    Foreign, HEADER_PARTS, POSE_PARTS, QUARTER, UPRIGHT, WRENCH_PARTS, assert_ramp,
};
use super::{in_folder, named, refused, surface};
use nalgebra::UnitQuaternion;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::robot::joint_transforms;
use wisch_telemetry::{
    Axes, AxesChoice, AxesSource, Log, LogOptions, TopicChoice, WrenchSign, read,
};

#[test]
fn a_urdf_or_an_option_states_the_rotation_of_the_sensor() {
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
fn invalid_numbers_are_dropped_and_counted_and_gaps_are_reported() {
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
    assert_eq!(
        log.samples.len(),
        202,
        "the pose is interpolated between its neighbours"
    );
    let [[start, end]] = log.gaps[..] else {
        panic!("{:?}", log.gaps);
    };
    assert!((start - 1.0).abs() < 1e-9 && (end - 3.0).abs() < 1e-9);
}

/// Writes the bag of a robot that logs its flange at 10 Hz in millimetres and the force on it at 100 Hz.
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
fn a_topic_of_two_sensors_is_refused() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let (pose, wrench) = (bag.poses("/arm/pose"), bag.wrenches("/arm/wrench"));
    for time in (0..=1000).step_by(10) {
        let frame = if time % 20 == 0 {
            "left_ft"
        } else {
            "right_ft"
        };
        let force = [0.0, 0.0, if time % 20 == 0 { 10.0 } else { 0.0 }];
        bag.put(pose, time, time, "base", ([time as f64, 0.0, 0.0], UPRIGHT));
        bag.put(wrench, time, time, frame, (force, [0.0; 3]));
    }
    bag.finish();
    let error = read(&path, &LogOptions::default()).unwrap_err().to_string();
    assert!(
        error.contains("/arm/wrench: its messages are in the frames \"left_ft\" and \"right_ft\""),
        "{error}"
    );
}

#[test]
fn a_foreign_bag_is_read() {
    let (_folder, path) = in_folder();
    for stamp_offset in [0, 7_000] {
        foreign(&path, "sensor", stamp_offset);
        let log = read(&path, &in_millimetres()).unwrap();
        assert_eq!(
            log.samples.len(),
            101,
            "the force is the more frequent track"
        );
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
        "both topics state the frame base"
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

    // The tool extends from the flange by 0.2 m along the flange's z, which is −y of the log.
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
fn ambiguous_and_missing_topics_are_reported() {
    let (_folder, path) = in_folder();
    let mut bag = Foreign::create(&path);
    let (left, right) = (bag.poses("/left"), bag.poses("/right"));
    bag.put(left, 0, 0, "base", ([0.0; 3], QUARTER));
    bag.put(right, 0, 0, "base", ([0.0; 3], QUARTER));
    bag.finish();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": 2 topics hold a pose; choose one of: /left, /right"
    );
    let options = LogOptions {
        pose_topic: TopicChoice::Named("/left".to_owned()),
        ..LogOptions::default()
    };
    assert_eq!(
        refused(&path, &options),
        ": no topic holds a wrench; the topics are: /left (geometry_msgs/msg/PoseStamped), /right (geometry_msgs/msg/PoseStamped)"
    );
}

#[test]
fn invalid_values_are_refused_with_their_message() {
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
            ": topic /p, message 2: its time of 1 s is 8 s earlier than the latest earlier time, 9 s; the limit is 5 s",
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
fn unsupported_encodings_and_schemas_are_reported() {
    let (_folder, path) = in_folder();
    let cases = [
        (
            ["ros1msg", "ros1", ""],
            ": topic /p: its message encoding is \"ros1\", but only \"cdr\" is read",
        ),
        (
            ["ros2idl", "cdr", ""],
            ": topic /p: its schema encoding is \"ros2idl\", but only \"ros2msg\" is read",
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
fn other_formats_are_recognised_by_their_first_bytes() {
    let (_folder, path) = in_folder();
    fs::write(&path, b"#ROSBAG V2.0\n").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is a bag of ROS 1, but only MCAP files are read; convert it to MCAP first"
    );
    fs::write(&path, b"SQLite format 3\0...").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is a bag of ROS 2 in a SQLite database (.db3), but only MCAP files are read; convert it to MCAP first"
    );
    let workbook = [&b"PK\x03\x04"[..], &[0; 26], b"[Content_Types].xml"].concat();
    for (begin, kind) in [
        (&b"[{\"t\": 0.0, \"x\": 1.0}]"[..], "JSON"),
        (&b"{\n  \"t\": [0.0]}"[..], "JSON"),
        (&b"\x1f\x8b\x08"[..], "compressed by gzip"),
        (&b"\xff\xfet\0,\0"[..], "text in UTF-16"),
        (&b"\x89HDF\r\n\x1a\n"[..], "an HDF5 file"),
        (&workbook[..], "a workbook of a spreadsheet program"),
    ] {
        fs::write(&path, begin).unwrap();
        assert_eq!(
            refused(&path, &LogOptions::default()),
            format!(
                ": this is {kind}, but only bags (MCAP) and tables (CSV, Parquet, npz) are read"
            )
        );
    }
    // Names of columns may begin with a bracket.
    fs::write(&path, b"[s],[m]\n").unwrap();
    let error = refused(&path, &LogOptions::default());
    assert!(!error.contains("JSON"), "{error}");
    fs::write(&path, b"PK\x03\x04 what?").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": this is not a bag: it begins with bytes 50 4b 03 04 20 77 68 61, but an MCAP file begins with 89 4d 43 41 50 30 0d 0a"
    );
    fs::write(&path, b"").unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        ": the bag ends at byte 0 in the middle of a record, before its first message: it holds no complete message"
    );
    let message = refused(Path::new("/no/such/place.mcap"), &LogOptions::default());
    assert!(message.starts_with(": there is no such file"), "{message}");
}

/// The Python libraries of MCAP wrote this bag; see peers/bag.py.
#[test]
fn a_bag_of_another_library_is_read() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/foreign.mcap");
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/arm/flange", "/arm/ft")
    );
    assert_eq!((log.axes, log.axes_source), (Axes::Log, AxesSource::Logged));
    assert_eq!(
        log.start, 1_699_999_999_995_000_000,
        "the time is the stamp, not the time of recording"
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
fn pose_and_force_may_be_in_one_message() {
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
fn unreadable_topics_are_reported_with_the_reason() {
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
        ": no topic holds a pose; the topics are: /ft (geometry_msgs/msg/WrenchStamped). Not readable: topic /tcp_pose: \
         its message encoding is \"json\", but only \"cdr\" is read"
    );
}

#[cfg(unix)]
#[test]
fn a_pipe_is_refused_at_once() {
    let (_folder, path) = in_folder();
    let made = std::process::Command::new("mkfifo").arg(&path).status();
    assert!(made.unwrap().success());
    let expected = ": this is a pipe, but only files and folders are read";
    assert_eq!(refused(&path, &LogOptions::default()), expected);
}
