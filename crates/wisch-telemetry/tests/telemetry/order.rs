//! Bags in parts, out of order, packed, and with several clocks.

use super::foreign_bag::{Foreign, QUARTER, UPRIGHT, assert_ramp};
use super::{in_folder, refused};
use std::fs;
use std::path::Path;
use wisch_telemetry::{Clock, LogOptions, read};

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

/// Writes a bag of a tool that moves at 0.1 m/s along x with a force that grows by 1 N/s, sampled every 10 ms. The callback
/// gives each message's time of recording, and the stamps of pose and force [ms].
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

#[test]
fn messages_are_sorted_by_their_stamps() {
    let (_folder, path) = in_folder();
    let mut times: Vec<u64> = (1000..=2000).step_by(10).collect();
    times.swap(20, 50);
    ramp(&path, times.iter().map(|&time| [time; 4]));
    let log = read(&path, &LogOptions::default()).unwrap();
    assert_ramp(&log, 101);
    assert!(
        log.remarks[0]
            .ends_with("of /tool/pose came up to 0.300 s late and were sorted by time (limit 5 s)"),
        "{:?}",
        log.remarks
    );
    // Beyond a shorter window, the same delay is an error.
    let narrow = LogOptions {
        reorder_window: 0.1,
        ..LogOptions::default()
    };
    let message = refused(&path, &narrow);
    assert!(message.contains("its time of 1.21 s is"), "{message}");
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
    assert_eq!(log.repeated, 40, "both parts hold twenty poses and forces");
}

#[test]
fn missing_stamps_are_replaced_by_times_of_recording() {
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
            .any(|remark| remark.starts_with("21 of 101 messages of /tool/pose have no stamp")),
        "{:?}",
        log.remarks
    );
}

#[test]
fn a_sensor_with_its_own_clock_is_aligned() {
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
fn stamps_of_another_date_than_their_recording_are_stated() {
    let (_folder, path) = in_folder();
    // Recorded on 2026-06-21; the clock of the robot was 20 years slow.
    let recorded = 1_782_000_000_000;
    let slow = recorded - 630_720_000_000;
    let times = |stamps: u64| {
        (1000..=2000)
            .step_by(10)
            .map(move |time| [time, recorded + time, stamps + time, stamps + time])
    };
    ramp(&path, times(slow));
    let log = read(&path, &LogOptions::default()).unwrap();
    let said = "the stamps of /tool/pose begin at 2006-06-26 00:00:01 UTC, but were recorded at 2026-06-21 00:00:01 UTC";
    assert!(log.remarks[0].starts_with(said), "{:?}", log.remarks);
    // Neither a right clock nor one that counts from 0 is a wrong date.
    for stamps in [recorded, 0] {
        ramp(&path, times(stamps));
        let log = read(&path, &LogOptions::default()).unwrap();
        let is_said = log
            .remarks
            .iter()
            .any(|remark| remark.contains("were recorded"));
        assert!(!is_said, "{:?}", log.remarks);
    }
}

#[test]
fn bags_packed_by_file_or_by_message_are_read() {
    let (folder, path) = in_folder();
    ramp(&path, (1000..=2000).step_by(10).map(|time| [time; 4]));
    let plain = fs::read(&path).unwrap();
    let packed = zstd::encode_all(plain.as_slice(), 1).unwrap();
    fs::remove_file(&path).unwrap();
    let name = folder.path().join("bag_0.mcap.zstd");
    fs::write(&name, packed).unwrap();
    for path in [&name, folder.path()] {
        assert_ramp(&read(path, &LogOptions::default()).unwrap(), 101);
    }
    let mut bag = Foreign::create(&path);
    for message in mcap::MessageStream::new(&plain).unwrap() {
        let mut message = message.unwrap();
        let packed = zstd::encode_all(&*message.data, 1).unwrap();
        message.data = packed.into();
        bag.bag.write(&message).unwrap();
    }
    bag.finish();
    assert_ramp(&read(&path, &LogOptions::default()).unwrap(), 101);
}
