//! What a driver states about its samples, in bags: quality of the wrench, pauses and stamps.

use super::{head, in_folder};
use std::fs;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{TouchSample, UnusableWrenches, WrenchQuality};
use wisch::run::{SampleStatus, Stamp, StampClock, TelemetrySample};
use wisch_telemetry::{BagWriter, LogOptions, read, read_samples};

fn sample(k: u16, status: SampleStatus) -> TelemetrySample<'static> {
    let time = f64::from(k) * 0.01;
    let force = Vector3::new(0.0, 0.0, f64::from(k));
    let touch = TouchSample::new(time, Pose::translation(0.1 * time, 0.0, 0.0), force);
    TelemetrySample {
        status,
        ..TelemetrySample::from_touch(&touch, 0, Phase::Wipe(0))
    }
}

/// Stale from 1 s on, saturated from 1.5 s on, usable again from 2 s on.
fn quality(k: u16) -> WrenchQuality {
    match k {
        100..150 => WrenchQuality::Stale,
        150..200 => WrenchQuality::Saturated,
        _ => WrenchQuality::Ok,
    }
}

#[test]
fn samples_without_a_usable_wrench_are_left_out_and_counted() {
    let (_folder, path) = in_folder();
    let start = 1_700_000_000_000_000_000;
    let mut bag = BagWriter::create(&path, head(start)).unwrap();
    for k in 0..300 {
        let wrench = quality(k);
        let status = SampleStatus {
            wrench,
            ..SampleStatus::default()
        };
        bag.write(&sample(k, status)).unwrap();
    }
    bag.finish().unwrap();
    let log = read(&path, &LogOptions::default()).unwrap();
    let unusable = UnusableWrenches {
        stale: 50,
        saturated: 50,
        ..UnusableWrenches::default()
    };
    assert_eq!((log.unusable, log.unpaired), (unusable, 0));
    let forces: Vec<f64> = log.samples.iter().map(|sample| sample.force.z).collect();
    let expected: Vec<f64> = (0..300)
        .filter(|k| quality(*k).is_usable())
        .map(f64::from)
        .collect();
    assert_eq!(forces, expected);
    let mut count = 0;
    read_samples(&path, |_| count += 1).unwrap();
    assert_eq!(count, 300, "a run that resumes has every sample");
}

#[test]
fn a_log_without_any_usable_wrench_is_refused() {
    let (_folder, path) = in_folder();
    let mut bag = BagWriter::create(&path, head(0)).unwrap();
    for k in 0..30 {
        let status = SampleStatus {
            wrench: WrenchQuality::Untared,
            ..SampleStatus::default()
        };
        bag.write(&sample(k, status)).unwrap();
    }
    bag.finish().unwrap();
    let error = read(&path, &LogOptions::default()).unwrap_err().to_string();
    assert!(
        error
            .contains("all 30 samples have a stale, saturated or untared wrench, or a frozen pose"),
        "{error}"
    );
}

#[test]
fn topics_of_the_status_exist_only_if_a_driver_states_one() {
    let (_folder, path) = in_folder();
    let names = |status: SampleStatus| {
        let mut bag = BagWriter::create(&path, head(0)).unwrap();
        bag.write(&sample(0, status)).unwrap();
        bag.finish().unwrap();
        let bytes = fs::read(&path).unwrap();
        ["/wisch/sample_status", "/wisch/stamp"].map(|name| {
            let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
            summary
                .channels
                .values()
                .any(|channel| channel.topic == name)
        })
    };
    assert_eq!(names(SampleStatus::default()), [false, false]);
    let stamp = Some(Stamp {
        nanoseconds: 5,
        clock: StampClock::Epoch,
    });
    let stated = SampleStatus {
        stamp,
        wrench: WrenchQuality::Ok,
        is_paused: true,
    };
    assert_eq!(names(stated), [true, true]);
}
