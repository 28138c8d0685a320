//! A sensor at the end of its range, in a table that states no quality of its wrenches.

use std::fmt::Write as _;
use std::fs;
use wisch_telemetry::{LogOptions, read};

/// Strokes at 200 Hz: 2 s in the air, then 2 s of contact with 10 N, and so on. Forces have noise, and end at ±`limit` [N].
fn table(limit: f64) -> String {
    let mut table = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
    for k in 0..2400_u32 {
        let time = f64::from(k) / 200.0;
        let pressed = f64::from(k / 400 % 2);
        let height = 0.08 * (1.0 - pressed);
        let noise = |row: f64| 0.1 * (f64::from(k) * (7.0 + row) * 1.7 + row).sin();
        let [fx, fy, fz] = [
            4.0 * pressed + noise(0.0),
            noise(1.0),
            10.0 * pressed + noise(2.0),
        ]
        .map(|force| force.clamp(-limit, limit));
        writeln!(
            table,
            "{time},{},0,{height},0,0,0,1,{fx},{fy},{fz}",
            0.01 * time
        )
        .unwrap();
    }
    table
}

#[test]
fn samples_of_a_saturated_sensor_are_left_out_and_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let said = |limit: f64| {
        fs::write(&path, table(limit)).unwrap();
        let log = read(&path, &LogOptions::default()).unwrap();
        let remarks = log
            .remarks
            .iter()
            .filter(|remark| remark.contains("saturated"));
        let remarks: Vec<String> = remarks.cloned().collect();
        (log.unusable, log.samples.len(), remarks)
    };
    let (unusable, left, remarks) = said(5.0);
    assert_eq!(
        (unusable.saturated, unusable.count(), left),
        (1200, 1200, 1200)
    );
    let [remark] = &remarks[..] else {
        panic!("{remarks:?}");
    };
    let begin = "fz is exactly 5 N, its largest value, for 6.0 s in all";
    assert!(remark.starts_with(begin), "{remark}");
    let (unusable, _, remarks) = said(20.0);
    assert_eq!((unusable.count(), remarks), (0, vec![]));
}
