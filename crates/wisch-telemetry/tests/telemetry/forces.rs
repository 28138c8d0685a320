//! Corrections of a measured force: bias, scale, and the weight of the payload behind the sensor.

use super::{in_folder, refused};
use nalgebra::{Unit, UnitQuaternion};
use std::fmt::Write;
use std::fs;
use wisch::geometry::Vector3;
use wisch_telemetry::{Axes, AxesChoice, Log, LogOptions, Payload, WrenchSign, read};

/// Force of the environment on the tool in the world [N].
const CONTACT: Vector3 = Vector3::new(1.0, -2.0, 10.0);

/// Weight of a payload of 1 kg [N].
const WEIGHT: f64 = 9.80665;

/// Returns the log of a tool that is held upright and then tilted by 90° about an axis of the world. `measured`: maps the
/// force in the world and the rotation of the tool to the logged force.
fn log(measured: impl Fn(Vector3, UnitQuaternion<f64>) -> Vector3, options: &LogOptions) -> Log {
    let mut text = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
    for tick in 0..100_u32 {
        let axis = Unit::new_normalize(Vector3::new(1.0, 0.5, 0.0));
        let angle = if tick < 50 {
            0.0
        } else {
            std::f64::consts::FRAC_PI_2
        };
        let turn = UnitQuaternion::from_axis_angle(&axis, angle);
        let (q, f) = (turn.coords, measured(CONTACT, turn));
        let time = f64::from(tick) / 25.0;
        let pose = format!("{},0,0.8,{},{},{},{}", 0.1 * time, q.x, q.y, q.z, q.w);
        writeln!(text, "{time},{pose},{},{},{}", f.x, f.y, f.z).unwrap();
    }
    let (folder, _) = in_folder();
    let path = folder.path().join("log.csv");
    fs::write(&path, text).unwrap();
    read(&path, options).unwrap()
}

fn assert_is_contact(log: &Log, what: &str) {
    for sample in &log.samples {
        let off = (sample.force - CONTACT).norm();
        assert!(off < 1e-9, "{what}: {} at {}", sample.force, sample.time);
    }
}

fn payload(mass: f64, centre: Vector3) -> LogOptions {
    LogOptions {
        payload: Some(Payload { mass, centre }),
        ..LogOptions::default()
    }
}

#[test]
fn weight_is_subtracted_in_every_orientation() {
    let weight = Vector3::new(0.0, 0.0, -WEIGHT);
    let by_tool_axes =
        |contact: Vector3, turn: UnitQuaternion<f64>| turn.inverse() * (contact + weight);
    // Without options, no correction applies.
    let without = log(by_tool_axes, &LogOptions::default());
    let first = &without.samples[0];
    assert!((first.force - CONTACT - weight).norm() < 1e-9);
    assert_eq!(without.remarks, [] as [&str; 0]);
    // With half the mass, half the weight remains.
    let half = log(by_tool_axes, &payload(0.5, Vector3::zeros()));
    for sample in &half.samples {
        assert!((sample.force - CONTACT - weight * 0.5).norm() < 1e-9);
    }
    let with = log(by_tool_axes, &payload(1.0, Vector3::zeros()));
    assert_is_contact(&with, "in the tool's axes");
    assert_eq!(
        with.remarks,
        [
            "by --payload-mass, the weight of 1 kg behind the sensor is subtracted from the force, rotated by each pose: 9.81 N along the world's -z"
        ]
    );
    // With the opposite sign, and rotated in the tool's frame.
    let sensor = UnitQuaternion::from_euler_angles(0.3, -0.2, 1.0);
    let options = LogOptions {
        sign: Some(WrenchSign::ByTool),
        logged_from_sensor: Some(sensor),
        ..payload(1.0, Vector3::z() * 0.1)
    };
    let turned = log(
        |contact, turn| -((turn * sensor).inverse() * (contact + weight)),
        &options,
    );
    assert_is_contact(&turned, "in the sensor's axes");
    assert!(turned.remarks[1].starts_with("--payload-centre is not used"));
    // The sensor was zeroed with the tool hanging upright: z of the sensor points down.
    let down = UnitQuaternion::from_euler_angles(std::f64::consts::PI, 0.0, 0.0);
    let zeroed = LogOptions {
        logged_from_sensor: Some(down),
        force_bias: Some(Vector3::new(0.0, 0.0, -WEIGHT)),
        ..payload(1.0, Vector3::zeros())
    };
    let shown = |contact: Vector3, turn: UnitQuaternion<f64>| {
        (turn * down).inverse() * (contact + weight) - down.inverse() * weight
    };
    assert_is_contact(&log(shown, &zeroed), "zeroed");
    // In the world's axes the weight is a bias, whose sign is that of the measured force.
    let world = LogOptions {
        axes: AxesChoice::Given(Axes::World),
        ..payload(1.0, Vector3::zeros())
    };
    assert_is_contact(
        &log(|contact, _| contact + weight, &world),
        "in the world's axes",
    );
    let as_bias = LogOptions {
        force_bias: Some(weight),
        payload: None,
        ..world
    };
    assert_is_contact(&log(|contact, _| contact + weight, &as_bias), "as a bias");
}

#[test]
fn bias_and_scale_are_corrected_first() {
    let bias = Vector3::new(0.5, -30.0, 4.0);
    let weight = Vector3::new(0.0, 0.0, -2.0 * WEIGHT);
    // A sensor that shows four fifths of the tool's force, in kiloponds.
    let measured = |contact: Vector3, turn: UnitQuaternion<f64>| {
        (-(turn.inverse() * (contact + weight)) * 0.8 + bias) / WEIGHT
    };
    let options = LogOptions {
        force_unit: Some(WEIGHT),
        sign: Some(WrenchSign::ByTool),
        force_bias: Some(bias),
        force_scale: Some(1.25),
        ..payload(2.0, Vector3::zeros())
    };
    let log = log(measured, &options);
    assert_is_contact(&log, "bias and scale");
    assert_eq!(
        log.remarks[..2],
        [
            "by --force-bias, (0.5, -30, 4) N are subtracted from the measured force, in its own axes",
            "by --force-scale, the measured force is multiplied by 1.25"
        ]
    );
}

#[test]
fn invalid_corrections_are_refused() {
    let scale = |scale: f64| LogOptions {
        force_scale: Some(scale),
        ..LogOptions::default()
    };
    let bias = LogOptions {
        force_bias: Some(Vector3::new(0.0, f64::NAN, 0.0)),
        ..LogOptions::default()
    };
    let (folder, _) = in_folder();
    let path = folder.path().join("log.csv");
    for (options, expected) in [
        (scale(0.0), ": --force-scale: 0 is not finite and above 0"),
        (scale(-1.0), ": --force-scale: -1 is not finite and above 0"),
        (
            scale(f64::INFINITY),
            ": --force-scale: inf is not finite and above 0",
        ),
        (bias, ": --force-bias: NaN is not finite"),
        (
            payload(-0.1, Vector3::zeros()),
            ": --payload-mass: -0.1 is not finite and at least 0",
        ),
        (
            payload(1.0, Vector3::x() * f64::INFINITY),
            ": --payload-centre: inf is not finite",
        ),
    ] {
        assert_eq!(refused(&path, &options), expected);
    }
}
