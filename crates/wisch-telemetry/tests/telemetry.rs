//! Tests of writing and reading bags: complete, cut off, damaged, and from other writers.

mod columns;
mod damage;
mod forces;
mod foreign;
mod foreign_bag;
mod order;
mod saturation;
#[path = "../examples/demo_bag/shown.rs"]
mod shown;
mod status;
mod tables;
mod transforms;
#[path = "../examples/demo_bag/wiping.rs"]
mod wiping;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use wiping::Wiping;
use wisch::follow::Phase;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_telemetry::{
    Axes, AxesSource, BagHead, BagWriter, LogOptions, TopicChoice, active_path, read,
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

/// Writes the synthetic log with data for viewers.
fn write_shown(path: &Path, rate: f64) -> usize {
    let mut bag = BagWriter::create(path, head(0)).unwrap();
    bag.write_particles(0.0, &[Point3::origin()]).unwrap();
    shown::write(&mut bag, &wipe(rate)).unwrap();
    let count = wipe(rate).write(&mut bag).unwrap();
    bag.finish().unwrap();
    count
}

/// Writes the synthetic log; returns its number of samples.
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
fn a_written_bag_is_read_back() {
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
fn invalid_samples_are_refused() {
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
        status: SampleStatus::default(),
    };
    let three = &[0.0; 3];
    bag.write(&sample(0.5, three)).unwrap();
    let mut refused = |sample: TelemetrySample<'_>| bag.write(&sample).unwrap_err().to_string();
    assert_eq!(
        refused(sample(0.5, three)),
        "a sample's time is 0.5 s; it must be later than the previous sample's, 0.5 s"
    );
    assert_eq!(
        refused(sample(f64::NAN, three)),
        "a sample's time is NaN s; it must be within 0 to 1000000000 s"
    );
    assert_eq!(
        refused(sample(0.6, &[0.0])),
        "a sample has 1 positions, but the bag has 3 joints"
    );
}

#[test]
fn topics_are_selected_by_name_and_unknown_names_are_refused() {
    let (_folder, path) = in_folder();
    write_bag(&path, 20.0, 0);
    let log = read(&path, &named("/tf:tool", "/wrench/controller")).unwrap();
    assert_eq!(
        (log.pose_name.as_str(), log.wrench_name.as_str()),
        ("/tf:tool", "/wrench/controller")
    );
    // The surface does not move.
    let moving = read(&path, &named("/tf", "/wrench/controller")).unwrap();
    assert_eq!(moving.pose_name, "/tf:tool");
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
            "/tf:tol",
            "/wrench/external",
            ": unknown frame \"tol\"; nearest: tool; known: tool, world, surface",
        ),
        (
            "/phase",
            "/wrench/external",
            ": topic /phase of type std_msgs/msg/String: there is no pose in it",
        ),
        (
            "/tcp/measured:pos",
            "/wrench/external",
            ": topic /tcp/measured of type geometry_msgs/msg/PoseStamped: there is no pose in \"pos\"; the whole message is one: name no field",
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

/// Returns the times of each topic's messages [ns].
fn times(path: &Path) -> BTreeMap<String, Vec<u64>> {
    let bytes = fs::read(path).unwrap();
    let mut times = BTreeMap::<_, Vec<u64>>::new();
    for message in mcap::MessageStream::new(&bytes).unwrap() {
        let message = message.unwrap();
        let topic = message.channel.topic.clone();
        times.entry(topic).or_default().push(message.log_time);
    }
    times
}

#[test]
fn data_for_viewers_does_not_change_the_log() {
    let (_folder, path) = in_folder();
    write_bag(&path, 200.0, 0);
    let bare = read(&path, &LogOptions::default()).unwrap();
    write_shown(&path, 200.0);
    let shown = read(&path, &LogOptions::default()).unwrap();
    assert_eq!(bare.samples, shown.samples);
    assert_eq!(bare.world_from_surface, shown.world_from_surface);
    assert_eq!(
        (bare.pose_name, bare.wrench_name, bare.axes, bare.start),
        (shown.pose_name, shown.wrench_name, shown.axes, shown.start)
    );
    assert_eq!((bare.gaps, bare.conventions), (shown.gaps, vec![]));
}

#[test]
fn static_data_is_written_once_and_moving_data_at_25_hz() {
    let (_folder, path) = in_folder();
    let count = write_shown(&path, 200.0);
    let times = times(&path);
    for topic in [
        "/robot_description",
        "/tf_static",
        "/scene",
        "/plan/strokes",
        "/tool",
    ] {
        assert_eq!(times[topic], [0], "{topic}");
    }
    let period = 40_000_000;
    let force = &times["/force"];
    assert!(force.windows(2).all(|pair| pair[1] - pair[0] >= period));
    // The arrow is drawn while the tool wipes, and deleted once when it leaves.
    let log = read(&path, &LogOptions::default()).unwrap();
    let pressed = log.samples.iter().filter(|s| s.force.norm() > 1.0).count();
    let expected = pressed as f64 / 200.0 * 25.0;
    assert!((force.len() as f64 - expected).abs() < 4.0, "{expected}");
    assert!(pressed < count, "the tool leaves the surface");
    let last_pressed = log.samples.iter().rfind(|s| s.force.norm() > 1.0).unwrap();
    let last_said = *force.last().unwrap() as f64 * 1e-9;
    assert!(last_said > last_pressed.time, "the arrow is not deleted");
    // The tool's frame at 50 Hz, the robot's links at half of that.
    let both = count.div_ceil(4) + count.div_ceil(8);
    assert_eq!(times["/tf"].len(), both);
}

#[test]
fn links_follow_their_joints() {
    let (_folder, path) = in_folder();
    write_shown(&path, 200.0);
    let model =
        wisch::robot::RobotModel::from_urdf("arm", shown::URDF, &mut |_| Err(String::new()));
    let model = model.unwrap();
    let [upper, forearm] = ["upper_arm", "forearm"].map(|name| model.link(name).unwrap());
    let [x, y, z] = shown::WORLD_FROM_ROOT;
    let world = LogOptions {
        world_frame: "world".into(),
        ..named("/tf:forearm", "/wrench/external")
    };
    let in_world = read(&path, &world).unwrap();
    let remark = "the pose of \"forearm\" in \"world\" comes from a chain of transforms";
    assert_eq!(in_world.remarks, [remark]);
    for sample in in_world.samples.iter().filter(|s| has_links_at(s.time)) {
        let wave = (0.5 * sample.time).sin();
        let kinematics = model
            .forward_kinematics(&[wave, 0.5 * wave, -wave])
            .unwrap();
        let expected = Pose::translation(x, y, z) * kinematics.world_from_link(forearm);
        let difference = expected.to_matrix() - sample.world_from_tool.to_matrix();
        assert!(
            difference.norm() < 1e-6,
            "{} {}",
            sample.time,
            difference.norm()
        );
        assert_ne!(kinematics.world_from_link(upper), expected);
    }
}

/// Whether the bag has messages with the robot's links at a time.
fn has_links_at(time: f64) -> bool {
    let steps = time * 25.0;
    (steps - steps.round()).abs() < 1e-6
}

#[test]
fn a_robot_with_other_joints_is_refused() {
    let (_folder, path) = in_folder();
    let head = BagHead::from_surface_pose(surface());
    let mut bag = BagWriter::create(&path, head).unwrap();
    let refused = shown::write(&mut bag, &wipe(100.0)).unwrap_err();
    let expected = "robot \"demo_arm\" has 3 variables, but the bag has 0 joints";
    assert_eq!(refused.to_string(), expected);
}
