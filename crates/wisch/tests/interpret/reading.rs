//! Logs of other robots: another force, bias, sign, frame or clock, and surfaces that are no plane.

use super::log::{DEPTH, PRESS, STEEP, Script, task};
use super::{events, interpreted, interpreted_with};
use nalgebra::UnitQuaternion;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::interpret::{Diagnosis, Doubt, EventKind, InterpretConfig, Interpretation, TouchSample};
use wisch::represent::Task;

/// Interprets the script's log with changed forces. `force` gets the time [s] and the force in the
/// axes of the surface [N].
fn read(script: &Script, force: impl Fn(f64, Vector3) -> Vector3) -> Interpretation {
    let task = task(80, STEEP);
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
        .map(|sample| changed(&task, sample, &force))
        .collect();
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

fn changed(
    task: &Task,
    sample: TouchSample,
    force: &impl Fn(f64, Vector3) -> Vector3,
) -> TouchSample {
    let turn = task.surface.world_from_surface.rotation;
    TouchSample {
        force: turn * force(sample.time, turn.inverse() * sample.force),
        ..sample
    }
}

fn assert_holds(interpretation: &Interpretation, truth: f64, what: &str) {
    let estimate = interpretation.performance;
    assert!(
        interpretation.is_conclusive(),
        "{what}: {:?}",
        interpretation.doubts
    );
    assert!(
        (estimate.low - 0.01..=estimate.high + 0.01).contains(&truth),
        "{what}: {truth} of {estimate:?}, {:?}",
        interpretation.doubts
    );
}

#[test]
fn contact_is_found_at_any_force_and_the_force_is_said() {
    let truth = interpreted(&Script::default()).performance.mean;
    for scale in [0.3, 0.5, 0.75, 0.85, 1.25, 1.45, 3.0] {
        let found = read(&Script::default(), |_, force| force * scale);
        let is_open = scale < 0.5;
        assert_eq!(
            found.is_conclusive(),
            !is_open,
            "{scale}: {:?}",
            found.doubts
        );
        let estimate = found.performance;
        assert!(
            estimate.low < truth && truth < estimate.high + 0.01,
            "{scale}: {estimate:?}"
        );
        // At so small a force, the scale of the measured force matters.
        assert!(!is_open || estimate.low < 0.3, "{scale}: {estimate:?}");
        let pressed = found.pressed_force.unwrap();
        assert!(
            (pressed / (scale * PRESS) - 1.0).abs() < 0.05,
            "{scale}: {pressed}"
        );
        assert_eq!(events(&found, EventKind::Contact).len(), 3, "{scale}");
        let others = found
            .events
            .iter()
            .filter(|event| event.kind != EventKind::Contact);
        assert_eq!(
            others.filter(|event| !event.kind.is_phase()).count(),
            0,
            "{scale}"
        );
        let is_said =
            (found.doubts.iter()).any(|doubt| matches!(doubt, Doubt::PressForceDiffers { .. }));
        assert_eq!(
            is_said,
            !(0.84..1.2).contains(&scale),
            "{scale}: {:?}",
            found.doubts
        );
    }
}

#[test]
fn a_bias_of_any_size_changes_nothing() {
    let plain = interpreted(&Script::default());
    for bias in [
        Vector3::new(0.0, 0.0, -8.0),
        Vector3::new(0.0, 0.0, 20.0),
        Vector3::new(0.0, 0.0, -35.0),
        Vector3::new(40.0, -40.0, 40.0),
    ] {
        let found = read(&Script::default(), |_, force| force + bias);
        let read = found.force_bias.unwrap();
        assert!((read - bias.z).abs() < 0.2, "{bias}: {read}");
        assert!(
            (found.performance.mean - plain.performance.mean).abs() < 0.01,
            "{bias}"
        );
        assert_eq!(found.events.len(), plain.events.len(), "{bias}");
        assert_eq!(found.doubts, [], "{bias}");
    }
}

#[test]
fn a_bias_in_the_axes_of_a_tool_that_turns_in_the_air_changes_nothing() {
    let task = task(80, STEEP);
    let surface = task.surface.world_from_surface;
    // Level in contact, leaning by 0.6 rad at the height of travel.
    let turned = |bias: Vector3| {
        let samples = Script::default().samples(&task).into_iter().map(|sample| {
            let mut world_from_tool = sample.world_from_tool;
            let height = (surface.inverse() * world_from_tool).translation.z;
            let lean = 0.6 * ((height - 0.01) / 0.03).clamp(0.0, 1.0);
            world_from_tool.rotation *= UnitQuaternion::from_euler_angles(lean, 0.0, 0.0);
            TouchSample {
                force: sample.force + world_from_tool.rotation * bias,
                world_from_tool,
                ..sample
            }
        });
        let samples: Vec<TouchSample> = samples.collect();
        interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
    };
    let truth = turned(Vector3::zeros()).performance.mean;
    for bias in [
        Vector3::new(0.0, 15.0, 0.0),
        Vector3::new(0.0, -15.0, 0.0),
        Vector3::new(0.0, 0.0, 5.0),
        Vector3::new(10.0, 10.0, 30.0),
    ] {
        let found = turned(bias);
        assert_holds(&found, truth, "axes of the tool");
        // What was subtracted in contact, where the tool is level.
        let read = found.force_bias.unwrap();
        assert!((read - bias.z).abs() < 0.2, "{bias}: {read}");
        let pushes = found.events.iter().filter(|event| event.kind.is_by_hand());
        assert_eq!(pushes.count(), 0, "{bias}: {:?}", found.events);
    }
}

#[test]
fn a_wrench_of_the_other_sign_or_of_another_frame_is_read_and_said() {
    let truth = interpreted(&Script::default()).performance.mean;
    let turned = read(&Script::default(), |_, force| {
        -force + Vector3::new(3.0, 0.0, 5.0)
    });
    assert_holds(&turned, truth, "sign");
    assert_eq!(turned.doubts, [Doubt::WrenchSignInverted]);
    let side = read(&Script::default(), |_, force| {
        Vector3::new(force.z, force.y, -force.x)
    });
    assert_holds(&side, truth, "frame");
    assert!(
        matches!(side.doubts[..], [Doubt::WrenchFrameRotated { direction: [x, _, _], .. }] if x > 0.8),
        "{:?}",
        side.doubts
    );
}

/// Samples at 100 Hz whose forces are measured later by this number of samples, with a hang of 3.5 s before and after them.
fn samples_with_late_forces(script: &Script, task: &Task, late: i32) -> Vec<TouchSample> {
    let script = Script {
        rate: 100.0,
        ..script.clone()
    };
    let moving = script.samples(task);
    let [first, last] = [&moving[0], &moving[moving.len() - 1]];
    let hang = |at: &TouchSample| TouchSample {
        force: Vector3::zeros(),
        ..*at
    };
    let before = vec![hang(first); 350];
    let after = vec![hang(last); 350];
    let mut samples = [before, moving, after].concat();
    let forces: Vec<Vector3> = samples.iter().map(|sample| sample.force).collect();
    let count = i32::try_from(samples.len()).unwrap();
    for (i, sample) in (0..).zip(&mut samples) {
        sample.time = 0.01 * f64::from(i);
        sample.force = forces[usize::try_from((i - late).clamp(0, count - 1)).unwrap()];
    }
    samples
}

#[test]
fn forces_with_another_clock_are_aligned() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let few = Script::default();
    let many = Script {
        strokes: [-0.1, -0.05, 0.0, 0.05, 0.1]
            .map(|y| [Point2::new(-0.13, y), Point2::new(0.13, y)])
            .to_vec(),
        speed: 0.25,
        ..Script::default()
    };
    for script in [&few, &many] {
        let truth = interpreted_with(&samples_with_late_forces(script, &task, 0), &task, &config);
        assert_eq!(truth.doubts, []);
        for late in [-290, -130, -40, -10, 10, 18, 40, 70, 100, 160, 200, 290] {
            let samples = samples_with_late_forces(script, &task, late);
            let found = interpreted_with(&samples, &task, &config);
            let expected = 0.01 * f64::from(late);
            assert!(
                matches!(found.doubts[..], [Doubt::ClockOffset { offset }] if (offset - expected).abs() < 0.04),
                "{late}: {:?}",
                found.doubts
            );
            assert_holds(&found, truth.performance.mean, "clock");
            assert_eq!(events(&found, EventKind::Push), [], "{late}");
            // Samples of one clock are read as they are.
            let config = InterpretConfig {
                has_one_clock: true,
                ..config.clone()
            };
            let found = interpreted_with(&samples, &task, &config);
            let is_shifted = |doubt: &Doubt| matches!(doubt, Doubt::ClockOffset { .. });
            assert!(!found.doubts.iter().any(is_shifted), "{late}");
        }
    }
}

#[test]
fn a_force_that_a_sensor_reports_late_is_no_push() {
    let task = task(80, STEEP);
    let config = InterpretConfig {
        has_one_clock: true,
        ..InterpretConfig::from_task(&task)
    };
    for late in [10, 20, 30, 40] {
        let samples = samples_with_late_forces(&Script::default(), &task, late);
        let found = interpreted_with(&samples, &task, &config);
        assert_eq!(events(&found, EventKind::Push), [], "{late}");
        // Somebody who holds the lifted tool pushes.
        let held: Vec<TouchSample> = (samples.iter())
            .map(|sample| {
                let is_held = (0.5..1.1).contains(&sample.time);
                let push = Vector3::new(0.0, 8.0, 0.0) * f64::from(u8::from(is_held));
                TouchSample {
                    force: sample.force + push,
                    ..*sample
                }
            })
            .collect();
        let found = interpreted_with(&held, &task, &config);
        assert_eq!(events(&found, EventKind::Push).len(), 1, "{late}");
    }
}

#[test]
fn a_lost_contact_is_no_clock_offset() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    // One stroke to and fro over the board, without a lift.
    let corners = [-0.08, 0.0, 0.08].map(|y| [Point2::new(-0.13, y), Point2::new(0.13, y)]);
    let ways = corners.iter().enumerate().flat_map(|(i, [left, right])| {
        let [from, to] = if i % 2 == 0 {
            [left, right]
        } else {
            [right, left]
        };
        [*from, *to]
    });
    let ways: Vec<Point2> = ways.collect();
    let parts: [fn(Point2) -> f64; 4] = [
        |place| if place.y < 0.0 { PRESS } else { 0.0 },
        |place| if place.y > 0.0 { PRESS } else { 0.0 },
        |place| if place.y < 0.04 { PRESS } else { 0.0 },
        |place| if place.x < 0.0 { PRESS } else { 0.0 },
    ];
    for speed in [0.1, 0.2, 0.3, 0.4] {
        for (k, press) in parts.into_iter().enumerate() {
            let script = Script {
                strokes: ways.windows(2).map(|pair| [pair[0], pair[1]]).collect(),
                speed,
                press,
                ..Script::default()
            };
            let found = interpreted_with(&script.samples(&task), &task, &config);
            let is_misread = |doubt: &Doubt| {
                matches!(
                    doubt,
                    Doubt::ClockOffset { .. }
                        | Doubt::WrenchSignInverted
                        | Doubt::BiasChange { .. }
                )
            };
            assert!(
                !found.doubts.iter().any(is_misread),
                "{speed} {k}: {:?}",
                found.doubts
            );
            assert!(
                found.performance.high < 0.9,
                "{speed} {k}: {:?}",
                found.performance
            );
        }
    }
}

#[test]
fn a_noisy_force_at_a_low_rate_is_averaged() {
    let truth = interpreted(&Script::default()).performance.mean;
    for (rate, force_noise) in [(1000.0, 2.0), (100.0, 2.0), (25.0, 2.0), (10.0, 1.0)] {
        let found = interpreted(&Script {
            rate,
            force_noise,
            ..Script::default()
        });
        assert_holds(&found, truth, &format!("{rate} Hz, {force_noise} N"));
    }
}

#[test]
fn near_the_surface_without_contact_the_performance_is_unknown() {
    // The tool follows its path, but no force is measured: the sensor is not connected, or the surface lies lower.
    let found = read(&Script::default(), |_, _| Vector3::zeros());
    assert_eq!(found.diagnosis, Diagnosis::NoContact);
    assert!(!found.is_conclusive());
    assert!(matches!(found.doubts[..], [Doubt::NoContactForce { closest, .. }] if closest < 1e-3));
    let wiped = interpreted(&Script::default()).performance.mean;
    let estimate = found.performance;
    assert!(
        estimate.low < 0.05 && estimate.high > wiped - 0.05,
        "{estimate:?}"
    );
}

#[test]
fn a_log_without_free_motion_tells_nothing() {
    let task = task(80, STEEP);
    let script = Script::default();
    let [start, end] = script.contacts()[0];
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
        .filter(|sample| (start..end).contains(&sample.time))
        .collect();
    let found = interpreted_with(&samples, &task, &InterpretConfig::from_task(&task));
    assert!(
        found.doubts.contains(&Doubt::NoFreeMotion),
        "{:?}",
        found.doubts
    );
    assert!(!found.is_conclusive());
    let estimate = found.performance;
    assert!(estimate.high - estimate.low > 0.5, "{estimate:?}");
}

#[test]
fn a_log_that_begins_in_contact_says_that_it_may_be_cut() {
    let task = task(80, STEEP);
    let script = Script::default();
    let [start, end] = script.contacts()[1];
    let cut = 0.5 * (start + end);
    let parts = [(cut, 1e9, [true, false]), (0.0, cut, [false, true])];
    for (from, to, cuts) in parts {
        let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
            .filter(|sample| (from..to).contains(&sample.time))
            .collect();
        let found = interpreted_with(&samples, &task, &InterpretConfig::from_task(&task));
        assert!(
            matches!(found.doubts[..], [Doubt::Incomplete { begins, ends, .. }] if [begins, ends] == cuts),
            "{:?}",
            found.doubts
        );
    }
}

/// The height of a surface over a place.
type Height = fn(Point2) -> f64;

/// A convex cylinder about the surface's y with its crest at x = 0.
fn crest(place: Point2, radius: f64) -> f64 {
    (radius * radius - place.x * place.x).sqrt() - radius
}

#[test]
fn contacts_on_a_cylinder_are_reported_with_radius_and_axis() {
    let surfaces: [(f64, Height); 4] = [
        (0.5, |place| crest(place, 0.5)),
        (1.0, |place| crest(place, 1.0)),
        (2.5, |place| crest(place, 2.5)),
        (6.0, |place| crest(place, 6.0)),
    ];
    for (radius, surface) in surfaces {
        let found = interpreted(&Script {
            surface,
            ..Script::default()
        });
        let told = found.doubts.iter().find_map(|doubt| match doubt {
            Doubt::Curved {
                radius,
                axis,
                is_convex,
            } => Some((*radius, axis.to_degrees(), *is_convex)),
            _ => None,
        });
        let Some((told, axis, is_convex)) = told else {
            panic!("{radius}: {:?}", found.doubts);
        };
        assert!((told / radius - 1.0).abs() < 0.2, "{radius}: {told}");
        assert!((axis - 90.0).abs() < 10.0 && is_convex, "{radius}: {axis}");
        assert!(!found.is_conclusive());
        assert!(
            !found.events.iter().any(|event| event.kind.is_by_hand()),
            "{radius}"
        );
    }
    let concave = interpreted(&Script {
        surface: |place| -crest(Point2::new(place.y + 0.3 * place.x, 0.0), 1.0),
        ..Script::default()
    });
    assert!(
        matches!(
            concave.doubts[0],
            Doubt::Curved {
                is_convex: false,
                ..
            }
        ),
        "{:?}",
        concave.doubts
    );
    // A plane stays a plane where the tool is compressed less by a smaller force.
    let weak = interpreted(&Script {
        press: |place| PRESS * (1.0 - 0.4 * (place.x / 0.16).powi(2)),
        ..Script::default()
    });
    assert_eq!(weak.doubts, [], "compressed by {DEPTH} m at most");
}

#[test]
fn travel_below_the_surface_beside_it_is_no_contact_of_the_other_sign() {
    let task = task(80, STEEP);
    let script = Script {
        strokes: vec![[Point2::new(-0.10, 0.0), Point2::new(0.10, 0.0)]],
        rate: 100.0,
        ..Script::default()
    };
    let plain = script.samples(&task);
    let truth = interpreted(&script).performance.mean;
    // Before and after it, the tool travels beside the board, lower than the board lies.
    let surface = task.surface.world_from_surface;
    let beside = |begin: f64| {
        (0..400).map(move |k| {
            let time = f64::from(k) / 100.0;
            let place = Vector3::new(0.4 + 0.05 * time, 0.3, -0.05);
            TouchSample::new(begin + time, surface * Pose::from(place), Vector3::zeros())
        })
    };
    let end = plain.last().unwrap().time + 4.5;
    let samples: Vec<TouchSample> = beside(0.0)
        .chain(plain.iter().map(|sample| TouchSample {
            time: sample.time + 4.25,
            ..*sample
        }))
        .chain(beside(end))
        .collect();
    let found = interpreted_with(&samples, &task, &InterpretConfig::from_task(&task));
    assert!(
        !found.doubts.contains(&Doubt::WrenchSignInverted),
        "{:?}",
        found.doubts
    );
    assert_holds(&found, truth, "beside");
    assert!((found.pressed_force.unwrap() / PRESS - 1.0).abs() < 0.1);
}

/// A log of short strokes that follow each other at equal intervals, with travel at one height between them, and higher travel
/// now and then.
fn regular_strokes() -> Vec<TouchSample> {
    const STROKES: usize = 12;
    let task = task(80, STEEP);
    let world_from_surface = task.surface.world_from_surface;
    let mut samples = Vec::new();
    let mut time = 0.0;
    let mut put = |x: f64, y: f64, z: f64, force: f64| {
        let noise = 0.1 * f64::sin(1e4 * time);
        let force = Vector3::new(-0.3 * force, 0.0, force + noise);
        samples.push(TouchSample {
            time,
            world_from_tool: world_from_surface * Pose::translation(x, y, z),
            force: world_from_surface.rotation * force,
        });
        time += 0.005;
    };
    for stroke in 0..STROKES {
        let y = -0.11 + 0.02 * stroke as f64;
        // Down, along, up and back, each at its own speed.
        (0..40).for_each(|k| put(-0.15, y, 0.05 * (1.0 - f64::from(k) / 40.0), 0.0));
        (0..100).for_each(|k| put(-0.15 + 0.003 * f64::from(k), y, -DEPTH, PRESS));
        (0..40).for_each(|k| put(0.15, y, 0.05 * f64::from(k) / 40.0, 0.0));
        for k in 0..600 {
            let share = f64::from(k) / 600.0;
            let high = (stroke % 4 == 3 && (240..360).contains(&k))
                .then(|| 0.02 * f64::sin(std::f64::consts::PI * f64::from(k - 240) / 120.0));
            let z = 0.05 + high.unwrap_or(0.0);
            put(0.15 - 0.3 * share, y + 0.02 * share, z, 0.0);
        }
    }
    samples
}

#[test]
fn travel_between_regular_strokes_is_not_taken_for_contact() {
    let task = task(80, STEEP);
    let found = interpreted_with(
        &regular_strokes(),
        &task,
        &InterpretConfig::from_task(&task),
    );
    assert_eq!(found.doubts, [], "{:?}", found.pressed_force);
    let pressed = found.pressed_force.expect("the tool pressed");
    assert!((pressed / PRESS - 1.0).abs() < 0.05, "{pressed}");
}

/// A log of a single stroke that lasts as long as the way back above it, closely above the surface.
fn single_stroke_and_return() -> Vec<TouchSample> {
    let task = task(80, STEEP);
    let world_from_surface = task.surface.world_from_surface;
    let mut samples = Vec::new();
    let mut time = 0.0;
    let mut put = |x: f64, z: f64, force: f64| {
        let noise = 0.1 * f64::sin(1e4 * time);
        samples.push(TouchSample {
            time,
            world_from_tool: world_from_surface * Pose::translation(x, 0.0, z),
            force: world_from_surface.rotation * Vector3::new(-0.3 * force, 0.0, force + noise),
        });
        time += 0.005;
    };
    (0..60).for_each(|k| put(-0.13, 0.05 * (1.0 - f64::from(k) / 60.0), 0.0));
    (0..260).for_each(|k| put(-0.13 + 0.001 * f64::from(k), -DEPTH, PRESS));
    // The tool goes back 4 mm above the surface, somewhat longer than it wiped.
    (0..300).for_each(|k| put(0.13 - 0.000_9 * f64::from(k), 0.004, 0.0));
    (0..60).for_each(|k| put(-0.14, 0.004 + 0.05 * f64::from(k) / 60.0, 0.0));
    samples
}

#[test]
fn the_way_back_closely_above_a_single_stroke_is_not_taken_for_contact() {
    let task = task(80, STEEP);
    let samples = single_stroke_and_return();
    let found = interpreted_with(&samples, &task, &InterpretConfig::from_task(&task));
    let misread =
        |doubt: &Doubt| matches!(doubt, Doubt::WrenchSignInverted | Doubt::ClockOffset { .. });
    assert!(!found.doubts.iter().any(misread), "{:?}", found.doubts);
    let pressed = found.pressed_force.expect("the tool pressed");
    assert!((pressed / PRESS - 1.0).abs() < 0.05, "{pressed}");
}

#[test]
fn a_tare_before_the_first_contact_is_no_push() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let samples = samples_with_late_forces(&Script::default(), &task, 0);
    let truth = interpreted_with(&samples, &task, &config);
    let with = |force: &dyn Fn(f64) -> Vector3| {
        let changed = samples.iter().map(|sample| TouchSample {
            force: sample.force + force(sample.time),
            ..*sample
        });
        interpreted_with(&changed.collect::<Vec<_>>(), &task, &config)
    };
    for bias in [[0.0, 0.0, 5.0], [0.0, 0.0, 25.0], [3.0, -2.0, -14.0]] {
        for tare in [0.5, 1.5, 3.2] {
            let bias = Vector3::from(bias);
            let found = with(&|time| if time < tare { bias } else { Vector3::zeros() });
            assert!(
                matches!(found.doubts[..], [Doubt::TaredEarly { time, change }]
                    if (time - tare).abs() < 0.03 && (change - bias.norm()).abs() < 0.1),
                "{bias:?} {tare}: {:?}",
                found.doubts
            );
            assert_eq!(events(&found, EventKind::Push), [], "{bias:?} {tare}");
            assert_holds(&found, truth.performance.mean, "tare");
        }
    }
    // A force that is gone in the last free motion is no bias.
    let early = with(&|time| {
        Vector3::z()
            * if (2.0..3.5).contains(&time) {
                10.0
            } else {
                0.0
            }
    });
    let is_tare = |doubt: &Doubt| matches!(doubt, Doubt::TaredEarly { .. });
    assert!(!early.doubts.iter().any(is_tare), "{:?}", early.doubts);
    // A hand that pushes the hanging tool releases it gradually.
    let push = |time: f64| (std::f64::consts::PI * (time - 0.5)).sin().max(0.0);
    let pushed = with(&|time| Vector3::x() * if time < 1.5 { 8.0 * push(time) } else { 0.0 });
    assert_eq!(events(&pushed, EventKind::Push).len(), 1);
    assert_eq!(pushed.doubts, []);
}

#[test]
fn poses_that_are_held_are_no_pushes() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let samples = samples_with_late_forces(&Script::default(), &task, 0);
    let truth = interpreted_with(&samples, &task, &config);
    for held in [10, 15, 20, 25, 40, 50] {
        let mut samples = samples.clone();
        for i in 0..samples.len() {
            samples[i].world_from_tool = samples[i - i % held].world_from_tool;
        }
        let found = interpreted_with(&samples, &task, &config);
        let expected = 0.01 * held as f64;
        assert!(
            matches!(found.doubts[..], [Doubt::HeldPoses { period }] if (period - expected).abs() < 0.011),
            "{held}: {:?}",
            found.doubts
        );
        assert_eq!(events(&found, EventKind::Push), [], "{held}");
        assert_eq!(found.is_conclusive(), held <= 25, "{held}");
        let estimate = found.performance;
        let range = estimate.low - 0.05..=estimate.high + 0.05;
        assert!(
            range.contains(&truth.performance.mean),
            "{held}: {estimate:?}"
        );
    }
}
