//! Telemetry files: reading by column and time, and errors of damaged files.

use proptest::prelude::*;
use std::path::Path;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::WrenchQuality;
use wisch::run::{SampleStatus, Stamp, StampClock, TelemetrySample, Wrench};
use wisch_memory::telemetry::PHASES;
use wisch_memory::{Mark, Telemetry, TelemetryError, TelemetryHead, TelemetryWriter};

const MARK: Mark = Mark {
    motion: 3,
    phase: Phase::Wipe(7),
};

fn head(joints: &[&str]) -> TelemetryHead {
    TelemetryHead {
        joints: joints.iter().map(|&joint| joint.to_owned()).collect(),
        notes: [("task".to_owned(), "board".to_owned())].into(),
    }
}

/// Writes a file with the column `v`, which holds ten times the time.
fn ramp(path: &Path, times: &[f64]) -> Telemetry {
    let columns = ["v".to_owned()];
    let mut writer = TelemetryWriter::with_columns(path, head(&[]), &columns).unwrap();
    for &time in times {
        writer.push(time, MARK, [10.0 * time]).unwrap();
    }
    writer.finish().unwrap();
    Telemetry::open(path).unwrap()
}

#[test]
fn a_sample_is_read_back_part_by_part() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("round-1.parquet");
    let mut writer = TelemetryWriter::create(&path, head(&["base", "elbow"])).unwrap();
    let wrench = |f: f64| Wrench {
        force: Vector3::new(f, f + 1.0, f + 2.0),
        moment: Vector3::new(f + 3.0, f + 4.0, f + 5.0),
    };
    writer
        .write(&TelemetrySample {
            time: 0.001,
            positions: &[1.0, 2.0],
            velocities: &[3.0, 4.0],
            efforts: &[5.0, 6.0],
            world_from_commanded: Pose::translation(7.0, 8.0, 9.0),
            world_from_tool: Pose::translation(10.0, 11.0, 12.0),
            controller: wrench(13.0),
            external: wrench(19.0),
            motion: 3,
            phase: Phase::Wipe(7),
            status: SampleStatus::default(),
        })
        .unwrap();
    assert!(!path.exists(), "it bears its name before it is whole");
    writer.finish().unwrap();
    let telemetry = Telemetry::open(&path).unwrap();
    assert_eq!(telemetry.joints(), ["base", "elbow"]);
    assert_eq!(telemetry.notes()["task"], "board");
    assert_eq!(telemetry.interval(), Some([0.001, 0.001]));
    let one = |column: &str| telemetry.row(&[column], 0).unwrap()[0];
    let expected = [
        ("position/base", 1.0),
        ("position/elbow", 2.0),
        ("velocity/base", 3.0),
        ("velocity/elbow", 4.0),
        ("effort/base", 5.0),
        ("effort/elbow", 6.0),
        ("commanded/x", 7.0),
        ("commanded/z", 9.0),
        ("commanded/qw", 1.0),
        ("measured/x", 10.0),
        ("measured/qx", 0.0),
        ("controller/fx", 13.0),
        ("controller/mz", 18.0),
        ("external/fz", 21.0),
        ("external/mx", 22.0),
        ("time", 0.001),
        ("motion", 3.0),
        ("stroke", 7.0),
    ];
    for (column, value) in expected {
        assert_eq!(one(column), value, "{column}");
    }
    assert_eq!(PHASES[one("phase") as usize], "wipe");
    telemetry.verify().unwrap();
}

#[test]
fn what_the_driver_states_about_samples_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("round-1.parquet");
    let statuses: Vec<SampleStatus> = (0..)
        .zip(WrenchQuality::ALL)
        .map(|(k, wrench)| SampleStatus {
            stamp: (k != 1).then_some(Stamp {
                nanoseconds: 1_764_150_000_123_456_789 + k,
                clock: StampClock::Device,
            }),
            wrench,
            is_paused: k == 2,
        })
        .collect();
    let mut writer = TelemetryWriter::create(&path, head(&[])).unwrap();
    for (time, status) in (0..).zip(&statuses) {
        let sample = TelemetrySample {
            time: f64::from(time),
            positions: &[],
            velocities: &[],
            efforts: &[],
            world_from_commanded: Pose::identity(),
            world_from_tool: Pose::identity(),
            controller: Wrench::default(),
            external: Wrench::default(),
            motion: 0,
            phase: Phase::Wipe(0),
            status: *status,
        };
        writer.write(&sample).unwrap();
    }
    writer.finish().unwrap();
    let telemetry = Telemetry::open(&path).unwrap();
    let qualities = telemetry.wrench_qualities(0..4).unwrap();
    assert_eq!(qualities, WrenchQuality::ALL);
    let stamps: Vec<_> = statuses.iter().map(|status| status.stamp).collect();
    assert_eq!(telemetry.stamps().unwrap(), stamps);
    assert_eq!(telemetry.stamp_clock(), Some(StampClock::Device));
    let paused = telemetry.values("paused", 0..4).unwrap();
    assert_eq!(paused, [0.0, 0.0, 1.0, 0.0]);
    let seconds = telemetry.values("stamp", 0..4).unwrap();
    assert!((seconds[0] - 1_764_150_000.123_457).abs() < 1e-6);
    assert!(seconds[1].is_nan());
    let (usable, unusable) = telemetry.touch_samples().unwrap();
    assert_eq!((usable.len(), unusable.count()), (1, 3));
    telemetry.verify().unwrap();

    let earlier = ramp(&folder.path().join("earlier.parquet"), &[0.0, 1.0]);
    let qualities = earlier.wrench_qualities(0..2).unwrap();
    assert_eq!(qualities, [WrenchQuality::Ok; 2]);
    assert_eq!(earlier.stamps().unwrap(), [None; 2]);
}

#[test]
fn every_phase_has_an_index() {
    let phases = [
        Phase::Drive,
        Phase::FreeMotion,
        Phase::Lifted,
        Phase::Lower,
        Phase::Wipe(0),
        Phase::Lift,
    ];
    assert_eq!(phases.map(Phase::as_str), PHASES);
}

#[test]
fn a_file_without_samples_is_valid() {
    let folder = tempfile::tempdir().unwrap();
    let telemetry = ramp(&folder.path().join("none.parquet"), &[]);
    assert_eq!((telemetry.rows(), telemetry.interval()), (0, None));
    assert_eq!(telemetry.nearest_row(1.0).unwrap(), None);
    assert!(telemetry.series("v", [0.0, 1.0]).unwrap().values.is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Comparison with a linear search; gaps give several row groups.
    #[test]
    fn ranges_and_nearest_rows_agree_with_a_linear_search(
        gaps in prop::collection::vec(prop_oneof![1_u32..2000, 5000_u32..15_000], 1..60),
        ask in -5.0..200.0_f64,
        length in 0.0..50.0_f64,
    ) {
        let mut milliseconds = 0;
        let times: Vec<f64> = gaps
            .iter()
            .map(|gap| {
                milliseconds += gap;
                f64::from(milliseconds) / 1e3
            })
            .collect();
        let folder = tempfile::tempdir().unwrap();
        let telemetry = ramp(&folder.path().join("ramp.parquet"), &times);
        prop_assert_eq!(telemetry.times(0..times.len()).unwrap(), times.clone());
        let series = telemetry.series("v", [ask, ask + length]).unwrap();
        let expected: Vec<f64> = times
            .iter()
            .copied()
            .filter(|time| (ask..=ask + length).contains(time))
            .collect();
        prop_assert_eq!(&series.times, &expected);
        for (time, value) in expected.iter().zip(&series.values) {
            prop_assert_eq!(*value, f64::from((10.0 * time) as f32));
        }
        let nearest = telemetry.nearest_row(ask).unwrap().unwrap();
        let distance = |row: usize| (times[row] - ask).abs();
        for row in 0..times.len() {
            // Times are stored in nanoseconds.
            prop_assert!(distance(nearest) <= distance(row) + 1e-9);
        }
    }
}

#[test]
fn invalid_samples_are_refused_and_leave_no_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.parquet");
    let columns = ["v".to_owned()];
    let mut writer = TelemetryWriter::with_columns(&path, head(&[]), &columns).unwrap();
    writer.push(1.0, MARK, [1.0]).unwrap();
    let mut refuse = |time, values: &[f64]| {
        let pushed = writer.push(time, MARK, values.iter().copied());
        pushed.unwrap_err().to_string()
    };
    assert_eq!(
        refuse(1.0, &[2.0]),
        "time: 1 s is not later than the previous sample's, 1 s"
    );
    assert_eq!(
        refuse(f64::NAN, &[2.0]),
        "time: NaN s is not between 0 and 1000000000 s"
    );
    assert_eq!(refuse(2.0, &[]), "row: 0 values; expected 1");
    assert_eq!(refuse(2.0, &[1.0, 2.0]), "row: 2 values; expected 1");
    writer.push(2.0, MARK, [3.0]).unwrap();
    writer.finish().unwrap();
    let telemetry = Telemetry::open(&path).unwrap();
    assert_eq!(telemetry.values("v", 0..2).unwrap(), [1.0, 3.0]);
    let twice = ["v".to_owned(), "v".to_owned()];
    let refused = TelemetryWriter::with_columns(&path, head(&[]), &twice);
    assert!(matches!(refused.err(), Some(TelemetryError::Twice { name, .. }) if name == "v"));
}

#[test]
fn an_unknown_column_is_reported_with_the_nearest_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("round-1.parquet");
    let writer = TelemetryWriter::create(&path, head(&["elbow"])).unwrap();
    writer.finish().unwrap();
    let telemetry = Telemetry::open(&path).unwrap();
    let message = telemetry.series("position/elbw", [0.0, 1.0]).unwrap_err();
    let expected = "there is no column \"position/elbw\"; the nearest is \"position/elbow\"";
    assert!(message.to_string().ends_with(expected), "{message}");
}

#[test]
fn a_cut_or_damaged_file_is_an_error_with_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.parquet");
    let times: Vec<f64> = (0..3000).map(|i| f64::from(i) * 0.01).collect();
    ramp(&path, &times).verify().unwrap();
    let whole = std::fs::read(&path).unwrap();
    let broken = folder.path().join("broken.parquet");
    let fault = |bytes: &[u8]| {
        std::fs::write(&broken, bytes).unwrap();
        Telemetry::open(&broken).and_then(|telemetry| telemetry.verify())
    };
    for length in (0..whole.len()).step_by(97) {
        let message = fault(&whole[..length]).unwrap_err().to_string();
        assert!(message.contains("broken.parquet"), "{message}");
    }
    // The check sums of the episode detect damage that leaves the file readable.
    for place in (4..whole.len()).step_by(53) {
        let mut bytes = whole.clone();
        bytes[place] ^= 0x55;
        if let Err(error) = fault(&bytes) {
            assert!(error.to_string().contains("broken.parquet"), "{error}");
        }
    }
}
