//! Bags as they are written and read: whole, cut off, damaged, and of other writers.

#[path = "../examples/demo_bag/wiping.rs"]
mod wiping;

use mcap::records::MessageHeader;
use mcap::{Compression, WriteOptions};
use proptest::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use wiping::Wiping;
use wisch::execute::{TelemetrySample, Wrench};
use wisch::follow::Phase;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch_telemetry::{
    Axes, AxesChoice, AxesSource, BagHead, BagWriter, Log, LogOptions, TopicChoice, WrenchSign,
    active_path, read,
};

fn surface() -> Pose {
    Pose::new(Vector3::new(0.6, 0.1, 0.75), Vector3::new(0.0, 0.3, 0.0))
}

fn wipe(rate: f64) -> Wiping {
    Wiping {
        world_from_surface: surface(),
        extent: [0.2, 0.1],
        rows: 2,
        speed: 0.1,
        press: 10.0,
        rate,
    }
}

fn head(start: u64) -> BagHead {
    BagHead {
        joints: wiping::JOINTS.map(str::to_owned).to_vec(),
        world_from_surface: surface(),
        start,
        notes: BTreeMap::new(),
    }
}

/// Writes the made-up log; how many samples it has.
fn write_bag(path: &Path, rate: f64, start: u64) -> usize {
    let mut bag = BagWriter::create(path, head(start)).unwrap();
    bag.write_particles(0.0, &[Point3::origin()]).unwrap();
    let count = wipe(rate).write(&mut bag).unwrap();
    bag.finish().unwrap();
    count
}

fn in_folder() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wipe.mcap");
    (folder, path)
}

fn refused(path: &Path, options: &LogOptions) -> String {
    let shown = read(path, options).map(|log| log.samples.len());
    let shown = shown.expect_err("the log should be refused").to_string();
    let start = path.display().to_string();
    assert!(shown.starts_with(&start), "{shown} names the file {start}");
    shown[start.len()..].to_owned()
}

fn named(pose: &str, wrench: &str) -> LogOptions {
    LogOptions {
        pose_topic: TopicChoice::Named(pose.to_owned()),
        wrench_topic: TopicChoice::Named(wrench.to_owned()),
        ..LogOptions::default()
    }
}

#[test]
fn what_is_written_is_read() {
    let (_folder, path) = in_folder();
    let count = write_bag(&path, 200.0, 5_000_000_000);
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(log.samples.len(), count);
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/tcp/measured", "/wrench/external")
    );
    assert_eq!(
        (log.axes, log.axes_source),
        (Axes::World, AxesSource::Logged)
    );
    assert_eq!(
        (log.start, log.repeated, log.unpaired),
        (5_000_000_000, 0, 0)
    );
    assert!(!log.is_unfinished && !active_path(&path).exists());
    let wiped: Vec<_> = log
        .samples
        .iter()
        .filter(|s| s.force.norm() > 0.0)
        .collect();
    for (index, sample) in log.samples.iter().enumerate() {
        assert!((sample.time - index as f64 / 200.0).abs() < 1e-9);
        assert!(
            sample
                .world_from_tool
                .rotation
                .angle_to(&surface().rotation)
                < 1e-9
        );
    }
    for sample in &wiped {
        let tip_in_surface = surface().inverse() * sample.world_from_tool;
        assert!(tip_in_surface.translation.z.abs() < 1e-9);
        assert!(((surface().rotation.inverse() * sample.force).z - 10.0).abs() < 1e-9);
    }
    assert!(wiped.len() > count / 4);
}

#[test]
fn the_same_samples_give_the_same_bytes() {
    let (_folder, path) = in_folder();
    write_bag(&path, 100.0, 0);
    let first = fs::read(&path).unwrap();
    write_bag(&path, 100.0, 0);
    assert_eq!(first, fs::read(&path).unwrap());
}

#[test]
fn samples_that_do_not_fit_are_refused() {
    let (_folder, path) = in_folder();
    let mut bag = BagWriter::create(&path, head(0)).unwrap();
    let sample = |time, joints: &'static [f64]| TelemetrySample {
        time,
        positions: joints,
        velocities: &[0.0; 3],
        efforts: &[0.0; 3],
        world_from_commanded: Pose::identity(),
        world_from_tool: Pose::identity(),
        controller: Wrench::default(),
        external: Wrench::default(),
        motion: 0,
        phase: Phase::Drive,
    };
    let three = &[0.0; 3];
    bag.write(&sample(0.5, three)).unwrap();
    let mut refused = |sample: TelemetrySample<'_>| bag.write(&sample).unwrap_err().to_string();
    assert_eq!(
        refused(sample(0.5, three)),
        "a sample's time of 0.5 s is not after that of the sample before, 0.5 s"
    );
    assert_eq!(
        refused(sample(f64::NAN, three)),
        "a sample's time of NaN s is not within 0 to 1000000000 s"
    );
    assert_eq!(
        refused(sample(0.6, &[0.0])),
        "a sample has 1 positions, but the bag has 3 joints"
    );
}

#[test]
fn a_bag_that_is_cut_off_anywhere_is_read_up_to_its_last_whole_second() {
    let (folder, path) = in_folder();
    write_bag(&path, 200.0, 0);
    let bytes = fs::read(&path).unwrap();
    let whole = read(&path, &LogOptions::default()).unwrap().samples;
    let cut = folder.path().join("cut.mcap");
    let mut most = 0;
    for share in [0.2, 0.4, 0.6, 0.8] {
        let cut_bytes = &bytes[..(bytes.len() as f64 * share) as usize];
        fs::write(active_path(&cut), cut_bytes).unwrap();
        // By its own name or by the one that it is to have.
        for name in [active_path(&cut), cut.clone()] {
            let Ok(log) = read(&name, &LogOptions::default()) else {
                assert!(share < 0.4);
                continue;
            };
            assert!(log.is_unfinished);
            assert_eq!(log.samples, whole[..log.samples.len()]);
            assert_eq!(log.samples.len() % 200, 0, "whole seconds");
            assert!(log.samples.len() >= most);
            most = log.samples.len();
        }
        fs::write(folder.path().join("finished.mcap"), cut_bytes).unwrap();
        let shown = refused(&folder.path().join("finished.mcap"), &LogOptions::default());
        let expected = format!(
            ": the bag ends at byte {} in the middle of a record, as one that is being written does",
            cut_bytes.len()
        );
        assert_eq!(shown, expected);
    }
    assert!(most >= whole.len() / 2, "{most} of {}", whole.len());
}

/// Not a test of its own: what the next one starts and kills.
#[test]
fn a_writer_that_does_not_end_by_itself() {
    let Some(path) = std::env::var_os("WISCH_TEST_ENDLESS_BAG") else {
        return;
    };
    let mut bag = BagWriter::create(Path::new(&path), head(0)).unwrap();
    // Long enough to be killed, short enough not to fill a disk where it is not.
    let endless = Wiping {
        rows: 4000,
        ..wipe(1000.0)
    };
    endless.write(&mut bag).unwrap();
    std::thread::sleep(Duration::from_secs(60));
}

#[test]
fn what_a_killed_writer_leaves_is_read() {
    let (_folder, path) = in_folder();
    let mut writer = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "a_writer_that_does_not_end_by_itself"])
        .env("WISCH_TEST_ENDLESS_BAG", &path)
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let patience = Instant::now() + Duration::from_secs(60);
    let enough = 500_000;
    while fs::metadata(active_path(&path)).map_or(0, |file| file.len()) < enough {
        assert!(Instant::now() < patience, "nothing is written");
        std::thread::sleep(Duration::from_millis(5));
    }
    writer.kill().unwrap();
    writer.wait().unwrap();
    assert!(!path.exists());
    let log = read(&path, &LogOptions::default()).unwrap();
    assert!(
        log.is_unfinished && log.samples.len() >= 1000,
        "{}",
        log.samples.len()
    );
    let last = log.samples[log.samples.len() - 1].time;
    assert!((last - (log.samples.len() - 1) as f64 / 1000.0).abs() < 1e-9);
}

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

/// A robot that logs its flange at 10 Hz in millimetres and the force on it at 100 Hz.
fn foreign(path: &Path, wrench_frame: &'static str, stamp_offset_ms: u64) {
    let mut bag = Foreign::create(path);
    let (pose, wrench) = (bag.poses("/arm/pose"), bag.wrenches("/arm/wrench"));
    for time in (0..=1000).step_by(10) {
        let stamp = (stamp_offset_ms > 0)
            .then_some(stamp_offset_ms + time)
            .unwrap_or(0);
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
        length_unit: 1e-3,
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
        world_from_log,
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
        sign: WrenchSign::ByTool,
        force_unit: 9.81,
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
fn topics_are_chosen_by_name_and_refused_by_name() {
    let (_folder, path) = in_folder();
    write_bag(&path, 20.0, 0);
    let log = read(&path, &named("/tf:tool", "/wrench/controller")).unwrap();
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/tf:tool", "/wrench/controller")
    );
    let standing = read(&path, &named("/tf:surface", "/wrench/external")).unwrap();
    for sample in &standing.samples {
        assert!((sample.world_from_tool.to_matrix() - surface().to_matrix()).norm() < 1e-9);
    }
    let cases = [
        (
            "/tcp/mesured",
            "/wrench/external",
            ": unknown topic \"/tcp/mesured\"; nearest: /tcp/measured; known: ",
        ),
        (
            "/tf",
            "/wrench/external",
            ": 2 topics hold a pose, and one has to be chosen: /tf:tool, /tf:surface",
        ),
        (
            "/tf:tol",
            "/wrench/external",
            ": unknown child frame \"tol\"; nearest: tool; known: tool, surface",
        ),
        (
            "/phase",
            "/wrench/external",
            ": topic /phase of type std_msgs/msg/String: there is no pose in it",
        ),
        (
            "/tcp/measured:pos",
            "/wrench/external",
            ": topic /tcp/measured of type geometry_msgs/msg/PoseStamped: there is no pose in \"pos\"",
        ),
        (
            "/tcp/measured",
            "/tf",
            ": topic /tf of type tf2_msgs/msg/TFMessage: there is no wrench in it",
        ),
    ];
    for (pose, wrench, expected) in cases {
        let shown = refused(&path, &named(pose, wrench));
        assert!(shown.starts_with(expected), "{shown}");
    }
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
    let cases: [(&[(u64, f64, [f64; 4])], &str); 3] = [
        (
            &[(0, 0.0, QUARTER), (5, f64::NAN, QUARTER)],
            ": topic /p, message 2: x is NaN, which is not finite",
        ),
        (
            &[(0, 0.0, [0.0; 4])],
            ": topic /p, message 1: the quaternion has a length of 0, which is not within 0.01 of 1",
        ),
        (
            &[(9, 0.0, QUARTER), (5, 0.0, QUARTER)],
            ": topic /p, message 2: its time of 0.005 s is before that of the one before, 0.009 s",
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
        ": this is no bag: it begins with bytes 23 52 4f 53 42 41 47 20, and an MCAP file with 89 4d 43 41 50 30 0d 0a"
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

/// A small bag to damage.
static SMALL: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let (_folder, path) = in_folder();
    write_bag(&path, 10.0, 0);
    fs::read(&path).unwrap()
});

/// The same, its messages unpacked, so that damage reaches them.
static PLAIN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut plain = std::io::Cursor::new(Vec::new());
    let options = WriteOptions::new()
        .compression(None::<Compression>)
        .calculate_chunk_crcs(false);
    let mut bag = options.create(&mut plain).unwrap();
    for message in mcap::MessageStream::new(&SMALL).unwrap() {
        bag.write(&message.unwrap()).unwrap();
    }
    bag.finish().unwrap();
    drop(bag);
    plain.into_inner()
});

/// That of another library, packed with Zstandard.
static FOREIGN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/foreign.mcap");
    fs::read(path).unwrap()
});

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Any damage ends in a log or in an error that names the file, never in a panic.
    #[test]
    fn damaged_bags_are_no_panic(
        which in 0..3_usize, is_active: bool, damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        end in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = [&*SMALL, &*PLAIN, &*FOREIGN][which].clone();
        for (index, byte) in damage {
            let index = index.index(bytes.len());
            bytes[index] = byte;
        }
        if let Some(end) = end {
            bytes.truncate(end.index(bytes.len()));
        }
        let (_folder, path) = in_folder();
        let path = if is_active { active_path(&path) } else { path };
        fs::write(&path, bytes).unwrap();
        for options in [LogOptions::default(), named("/tf:tool", "/wrench/controller")] {
            match read(&path, &options) {
                Ok(log) => prop_assert!(!log.samples.is_empty()),
                Err(error) => {
                    let starts_with_file = error.to_string().starts_with(&path.display().to_string());
                    prop_assert!(starts_with_file);
                }
            }
        }
    }
}

#[test]
fn a_flipped_bit_in_a_chunk_is_found_out() {
    let (_folder, path) = in_folder();
    let mut bytes = SMALL.clone();
    let middle = bytes.len() / 4;
    bytes[middle] ^= 1;
    fs::write(&path, bytes).unwrap();
    assert!(refused(&path, &LogOptions::default()).contains("near byte"));
}
