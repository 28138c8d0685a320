//! Frames on demand, compared with closed forms.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use wisch::follow::Phase;
use wisch::geometry::Pose;
use wisch::robot::RobotModel;
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_memory::{
    Frames, LOG_COLUMNS, Mark, RoundScene, Sampling, StoredPose, Telemetry, TelemetryHead,
    TelemetryWriter,
};

/// A platform that slides along x, with an arm of 1 m on it that turns about z.
const ROBOT: &str = r#"<robot name="justin">
  <link name="floor"/><link name="platform"/><link name="arm"/>
  <joint name="slide" type="prismatic"><parent link="floor"/><child link="platform"/>
    <axis xyz="1 0 0"/><limit lower="-9" upper="9" effort="1" velocity="1"/></joint>
  <joint name="turn" type="revolute"><parent link="platform"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit lower="-9" upper="9" effort="1" velocity="1"/></joint>
</robot>"#;

fn robot() -> RobotModel {
    let mut none = |name: &str| Err(name.to_owned());
    RobotModel::from_urdf("justin.urdf", ROBOT, &mut none).expect("a robot")
}

/// Returns the scene: the platform at a height of 1 m, the tool at the end of the arm.
fn scene() -> RoundScene {
    RoundScene {
        world_from_root: StoredPose::from(&Pose::translation(0.0, 0.0, 1.0)),
        base: Some("platform".to_owned()),
        tip_from_tool: StoredPose::from(&Pose::translation(1.0, 0.0, 0.0)),
        world_from_surface: StoredPose::from(&Pose::translation(3.0, 2.0, 1.0)),
        ..RoundScene::with_upright_tool("justin", "arm", "sponge", "board")
    }
}

/// Writes two seconds at 100 Hz: the platform slides at 1 m/s, and the arm turns by 90° per second.
fn telemetry(path: &Path, head: TelemetryHead) -> Telemetry {
    let mut writer = TelemetryWriter::create(path, head).expect("a file");
    for step in 0..=200 {
        let time = f64::from(step) / 100.0;
        let sample = TelemetrySample {
            time,
            positions: &[time, FRAC_PI_2 * time],
            velocities: &[1.0, FRAC_PI_2],
            efforts: &[0.0, 0.0],
            world_from_commanded: Pose::identity(),
            world_from_tool: Pose::identity(),
            controller: Wrench::default(),
            external: Wrench::default(),
            motion: 0,
            phase: Phase::FreeMotion,
            status: SampleStatus::default(),
        };
        writer.write(&sample).expect("a sample");
    }
    writer.finish().expect("a file");
    Telemetry::open(path).expect("telemetry")
}

fn joints(names: [&str; 2]) -> Vec<String> {
    names.map(str::to_owned).to_vec()
}

#[test]
fn links_tool_robot_and_surface_follow_the_joints() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("round-1.parquet");
    let head = scene().head(joints(["slide", "turn"]));
    let (robot, telemetry) = (robot(), telemetry(&path, head));
    let frames = Frames::new(&robot, &telemetry).expect("frames");
    for (name, time, expected) in [
        ("floor", 1.0, [0.0, 0.0, 1.0]),
        ("platform", 1.0, [1.0, 0.0, 1.0]),
        ("robot", 1.0, [1.0, 0.0, 1.0]),
        ("justin", 2.0, [2.0, 0.0, 1.0]),
        ("base", 0.5, [0.5, 0.0, 1.0]),
        ("sponge", 0.0, [1.0, 0.0, 1.0]),
        ("tool", 1.0, [1.0, 1.0, 1.0]),
        ("tcp", 2.0, [1.0, 0.0, 1.0]),
        ("board", 1.3, [3.0, 2.0, 1.0]),
        ("surface", 0.0, [3.0, 2.0, 1.0]),
        ("world", 0.0, [0.0, 0.0, 0.0]),
    ] {
        let pose = frames.pose(name, time).expect("a pose");
        let position: [f64; 3] = pose.world_from_frame.translation.vector.into();
        for (found, expected) in position.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-6,
                "{name} at {time}: {position:?}"
            );
        }
        assert!(frames.names().contains(&name));
    }
    let turned = frames.pose("sponge", 1.0).expect("a pose").world_from_frame;
    assert!((turned.rotation.angle() - FRAC_PI_2).abs() < 1e-6);
}

#[test]
fn a_trajectory_is_sampled_by_period_and_by_number() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("round-1.parquet");
    let head = scene().head(joints(["slide", "turn"]));
    let (robot, telemetry) = (robot(), telemetry(&path, head));
    let frames = Frames::new(&robot, &telemetry).expect("frames");
    let times = |interval, sampling| -> Result<Vec<f64>, String> {
        let poses = frames.trajectory("sponge", interval, sampling);
        let poses = poses.map_err(|error| error.to_string())?;
        Ok(poses.iter().map(|pose| pose.time).collect())
    };
    let every = |dt| times([0.2, 1.7], Sampling::Every(dt));
    assert_eq!(every(0.5), Ok(vec![0.2, 0.7, 1.2, 1.7]));
    assert_eq!(every(0.6), Ok(vec![0.2, 0.8, 1.4]));
    assert_eq!(every(9.0), Ok(vec![0.2]));
    // With a period finer than the telemetry, each sample occurs once.
    assert_eq!(
        times([0.0, 2.0], Sampling::Every(1e-4)).map(|t| t.len()),
        Ok(201)
    );
    assert_eq!(
        times([0.0, 2.0], Sampling::Count(3)),
        Ok(vec![0.0, 1.0, 2.0])
    );
    assert_eq!(times([0.5, 2.0], Sampling::Count(1)), Ok(vec![0.5]));
    for (sampling, expected) in [
        (
            Sampling::Every(0.0),
            "dt: 0 does not give 1 to 4000000 samples",
        ),
        (
            Sampling::Every(f64::NAN),
            "dt: NaN does not give 1 to 4000000 samples",
        ),
        (
            Sampling::Every(-1.0),
            "dt: -1 does not give 1 to 4000000 samples",
        ),
        (
            Sampling::Count(0),
            "n: 0 does not give 1 to 4000000 samples",
        ),
    ] {
        assert_eq!(times([0.0, 1.0], sampling), Err(expected.to_owned()));
    }
    let late = times([1.0, 3.0], Sampling::Count(2));
    assert_eq!(late, Err("time: 3 s is not between 0 and 2 s".to_owned()));
}

#[test]
fn telemetry_of_another_robot_or_without_a_scene_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let robot = robot();
    let refused = |name: &str, head: TelemetryHead| {
        let telemetry = telemetry(&folder.path().join(name), head);
        let error = Frames::new(&robot, &telemetry).expect_err("it is refused");
        error.to_string()
    };
    let swapped = refused("a.parquet", scene().head(joints(["turn", "slide"])));
    let expected = "a.parquet: joint 0 is \"turn\", but the robot's is \"slide\"";
    assert!(swapped.ends_with(expected), "{swapped}");
    let bare = TelemetryHead {
        joints: joints(["slide", "turn"]),
        ..TelemetryHead::default()
    };
    assert!(refused("b.parquet", bare).ends_with("b.parquet: scene: it is missing"));
    let elsewhere = RoundScene {
        tip: "hand".to_owned(),
        ..scene()
    };
    let message = refused("c.parquet", elsewhere.head(joints(["slide", "turn"])));
    assert!(message.contains("hand"), "{message}");
}

/// Writes a log of a tool that is at rest, with samples at the given times \[s\].
fn logged(path: &Path, times: impl IntoIterator<Item = f64>) -> Telemetry {
    let head = RoundScene::from_log("sponge", "board", &Pose::identity()).head(Vec::new());
    let columns = LOG_COLUMNS.map(str::to_owned);
    let mut writer = TelemetryWriter::with_columns(path, head, &columns).expect("a file");
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for time in times {
        let row = [0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 10.0];
        writer.push(time, mark, row).expect("a sample");
    }
    writer.finish().expect("a file");
    Telemetry::open(path).expect("telemetry")
}

#[test]
fn no_pose_is_known_within_a_gap_however_long_the_gaps_are() {
    let folder = tempfile::tempdir().expect("a folder");
    // Three parts of 2 s at 100 Hz, one a day: a mean period of some minutes.
    let daily = (0..3)
        .flat_map(|day| (0..200).map(move |k| 86_400.0 * f64::from(day) + 0.01 * f64::from(k)));
    let telemetry = logged(&folder.path().join("daily.parquet"), daily);
    let frames = Frames::from_log(&telemetry, "sponge").expect("frames");
    for time in [0.0, 1.99, 2.4, 86_399.6, 86_401.0] {
        assert!(frames.pose("sponge", time).is_ok(), "{time}");
    }
    for time in [2.6, 40.0, 86_399.0] {
        let error = frames.pose("sponge", time).expect_err("a gap");
        let said = "nothing was recorded within 0.5 s of";
        assert!(error.to_string().contains(said), "{error}");
    }
    let poses = frames.trajectory("sponge", [0.0, 90.0], Sampling::Every(10.0));
    assert_eq!(poses.expect("a pose").len(), 1);
    // A slow log has a period of more than half a second.
    let slow = logged(
        &folder.path().join("slow.parquet"),
        (0..9).map(|k| 2.0 * f64::from(k)),
    );
    let frames = Frames::from_log(&slow, "sponge").expect("frames");
    assert!(frames.pose("sponge", 5.0).is_ok());
}
