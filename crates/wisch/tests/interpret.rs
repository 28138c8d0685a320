//! Interpretations of synthetic logs, compared with the values from which the logs were made.

#[path = "interpret/belief.rs"]
mod belief;
#[path = "interpret/effects.rs"]
mod effects;
#[path = "interpret/events.rs"]
mod events_found;
#[path = "interpret/implausible.rs"]
mod implausible;
#[path = "interpret/inertia.rs"]
mod inertia;
#[path = "interpret/lean.rs"]
mod lean;
#[path = "interpret/log.rs"]
pub mod log;
#[path = "interpret/parts.rs"]
mod parts;
#[path = "interpret/patches.rs"]
mod patches;
#[path = "interpret/random.rs"]
mod random;
#[path = "interpret/reading.rs"]
mod reading;
#[path = "interpret/registration.rs"]
mod registration;
#[path = "interpret/relief.rs"]
mod relief;
#[path = "interpret/uncertain.rs"]
mod uncertain;

use log::{DEPTH, PRESS, STEEP, Script, task};
use proptest::prelude::*;
use wisch::geometry::{Point2, Point3, Pose, Vector3};
use wisch::interpret::{
    Belief, Diagnosis, Doubt, Event, EventKind, InterpretConfig, InterpretError, Interpretation,
    Interpreter, PathPiece, PlaneConfig, ToolCompliance, TouchSample, Uncertainty, fit_plane,
    interpret,
};
use wisch::represent::{Fate, GoalState, Task};

/// Largest error of the times of events [s].
const EVENT_TOLERANCE: f64 = 0.05;

fn interpreted_with(
    samples: &[TouchSample],
    task: &Task,
    config: &InterpretConfig,
) -> Interpretation {
    let believed = Belief::from_particles(task.particles.clone());
    interpret(samples, task, &believed, &GoalState::Absorbed, config).unwrap()
}

fn interpreted(script: &Script) -> Interpretation {
    let task = task(80, STEEP);
    interpreted_with(
        &script.samples(&task),
        &task,
        &InterpretConfig::from_task(&task),
    )
}

/// The configuration of the task, in which only the draws of (12) are uncertain.
fn exact(task: &Task) -> InterpretConfig {
    InterpretConfig {
        uncertainty: Uncertainty::NONE,
        ..InterpretConfig::from_task(task)
    }
}

fn events(interpretation: &Interpretation, kind: EventKind) -> Vec<Event> {
    (interpretation
        .events
        .iter()
        .filter(|event| event.kind == kind))
    .copied()
    .collect()
}

fn assert_near_times(event: &Event, [start, end]: [f64; 2]) {
    assert!(
        (event.start - start).abs() <= EVENT_TOLERANCE
            && (event.end - end).abs() <= EVENT_TOLERANCE,
        "{start} to {end} s: {event:?}"
    );
}

/// Share of the particles that three strokes of the sponge pass over.
fn swept(task: &Task) -> f64 {
    let inside = |p: &Point2| {
        p.x.abs() <= 0.16 + 0.035
            && [-0.085, 0.0, 0.085_f64]
                .iter()
                .any(|y| (p.y - y).abs() <= 0.055)
    };
    let particles: Vec<Point2> = task.particles.remaining().collect();
    particles.iter().filter(|p| inside(p)).count() as f64 / particles.len() as f64
}

#[test]
fn an_undisturbed_log_tells_three_contacts_and_nothing_else() {
    let script = Script::default();
    let interpretation = interpreted(&script);
    let plane = interpretation.plane.unwrap();
    assert_eq!(interpretation.diagnosis, Diagnosis::Localized);
    assert!(plane.tilt.to_degrees() < 0.1, "{plane:?}");
    assert!(plane.offset.abs() < 3e-4, "{plane:?}");
    let contacts = events(&interpretation, EventKind::Contact);
    let others: Vec<_> = (interpretation.events.iter())
        .filter(|event| event.kind != EventKind::Contact && !event.kind.is_phase())
        .collect();
    assert!(others.is_empty(), "{others:?}");
    assert_eq!(contacts.len(), 3);
    for (contact, [start, end]) in contacts.iter().zip(script.contacts()) {
        // The sponge touches a tenth of a second before it is fully compressed.
        assert_near_times(contact, [start - DEPTH / 0.05, end + DEPTH / 0.05]);
        assert!(
            (contact.mean_normal_force + PRESS).abs() < 0.6,
            "{contact:?}"
        );
    }
    assert!(
        (interpretation.performance.mean - swept(&task(80, STEEP))).abs() < 0.02,
        "{:?}",
        interpretation.performance
    );
    assert!(
        interpretation
            .force_bias
            .is_some_and(|bias| bias.abs() < 0.1)
    );
}

#[test]
fn phases_cover_a_log_without_a_gap() {
    let script = Script::default();
    let interpretation = interpreted(&script);
    let phases: Vec<Event> = (interpretation
        .events
        .iter()
        .filter(|event| event.kind.is_phase()))
    .copied()
    .collect();
    let kinds: Vec<EventKind> = phases.iter().map(|phase| phase.kind).collect();
    let [stroke, lift] = [EventKind::Stroke, EventKind::Lift];
    let [approach, retreat] = [EventKind::Approach, EventKind::Retreat];
    assert_eq!(
        kinds,
        [approach, stroke, lift, stroke, lift, stroke, retreat]
    );
    for pair in phases.windows(2) {
        assert!((pair[1].start - pair[0].end).abs() < 1e-9, "{pair:?}");
    }
    let strokes = events(&interpretation, stroke);
    for (stroke, contact) in strokes
        .iter()
        .zip(events(&interpretation, EventKind::Contact))
    {
        assert_near_times(stroke, [contact.start, contact.end]);
        assert!(stroke.mean_normal_force < -0.5 * PRESS, "{stroke:?}");
    }
}

/// The board rises to one side by `degrees`, and the sponge loses it on the other.
fn tilted() -> Script {
    fn rise(place: Point2) -> f64 {
        2.0_f64.to_radians().tan() * place.x - 0.001
    }
    Script {
        surface: rise,
        // The controller's spring reaches less deep where the surface is low.
        press: |place| {
            let short = -rise(place) - 0.002;
            if short > 0.0 {
                (PRESS - short * 5000.0).max(0.0)
            } else {
                PRESS
            }
        },
        ..Script::default()
    }
}

#[test]
fn a_tilted_board_is_found_and_the_side_out_of_reach_not_wiped() {
    let task = task(80, STEEP);
    let interpretation = interpreted_with(&tilted().samples(&task), &task, &exact(&task));
    let plane = interpretation.plane.unwrap();
    assert!((plane.tilt.to_degrees() - 2.0).abs() < 0.3, "{plane:?}");
    assert!((plane.offset + 0.001).abs() < 5e-4, "{plane:?}");
    let Diagnosis::Relocalize { world_from_surface } = interpretation.diagnosis else {
        panic!("{:?}", interpretation.diagnosis);
    };
    // The found surface is compared with the real one at single points.
    for place in [
        Point2::new(0.2, 0.14),
        Point2::new(-0.2, 0.14),
        Point2::new(0.0, -0.14),
    ] {
        let real = task.surface.world_from_surface.inverse()
            * (world_from_surface * Point3::new(place.x, place.y, 0.0));
        let surface = (tilted().surface)(Point2::new(real.x, real.y));
        assert!(
            (real.z - surface).abs() < 2e-3,
            "{place}: {} {surface}",
            real.z
        );
    }
    // No force where the surface lies more than 4 mm too low.
    let lost_below = -0.003 / 2.0_f64.to_radians().tan();
    assert!((-0.09..-0.08).contains(&lost_below));
    for replay in interpretation.belief.members() {
        for (i, (_, fate)) in replay.iter().enumerate() {
            let place = task.particles.position(i);
            if place.x < lost_below - 0.036 {
                assert_eq!(fate, Fate::OnSurface);
            } else if place.x > 0.0 && place.x < 0.18 && place.y.abs() < 0.13 {
                assert!(
                    fate == Fate::Absorbed || (place.y.abs() - 0.055).abs() < 0.04,
                    "{place}"
                );
            }
        }
    }
}

#[test]
fn without_contact_nothing_is_said_and_nothing_wiped() {
    let script = Script {
        surface: |_| -0.1,
        press: |_| 0.0,
        ..Script::default()
    };
    let interpretation = interpreted(&script);
    assert_eq!(interpretation.diagnosis, Diagnosis::NoContact);
    assert_eq!(interpretation.plane, None);
    assert_eq!(interpretation.events, []);
    assert!(!interpretation.is_conclusive());
    let task = task(80, STEEP);
    let mut dirt = interpretation.belief.members().iter();
    assert!(dirt.all(|dirt| dirt.tally().remaining == 80));
    let few = &script.samples(&task)[..3];
    let none: &[TouchSample] = &[];
    for samples in [few, none] {
        let interpretation = interpreted_with(samples, &task, &InterpretConfig::from_task(&task));
        assert_eq!(interpretation.diagnosis, Diagnosis::NoContact);
        assert!(!interpretation.is_conclusive());
    }
}

#[test]
fn a_bias_of_the_sensor_is_found_and_taken_off() {
    let plain = interpreted(&Script::default());
    for bias in [-1.0, 1.0] {
        let interpretation = interpreted(&Script {
            bias,
            ..Script::default()
        });
        let found = interpretation.force_bias.unwrap();
        assert!((found - bias).abs() < 0.1, "{found}");
        assert!((interpretation.performance.mean - plain.performance.mean).abs() < 0.01);
        assert_eq!(interpretation.events.len(), plain.events.len());
    }
    // Without free motion, the bias is unknown.
    let task = task(80, STEEP);
    let script = Script {
        bias: 1.0,
        ..Script::default()
    };
    let [start, end] = script.contacts()[0];
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
        .filter(|sample| (start..end).contains(&sample.time))
        .collect();
    let interpretation = interpreted_with(&samples, &task, &InterpretConfig::from_task(&task));
    assert_eq!(interpretation.force_bias, None);
}

#[test]
fn one_stroke_tells_height_and_slope_along_itself() {
    let script = Script {
        strokes: vec![[Point2::new(-0.16, 0.05), Point2::new(0.16, 0.05)]],
        surface: |place| 0.02 * place.x + 0.005,
        ..Script::default()
    };
    let plane = interpreted(&script).plane.unwrap();
    assert!(
        (plane.normal.x / -plane.normal.z - 0.02).abs() < 2e-3,
        "{plane:?}"
    );
    assert!(plane.normal.y.abs() < 1e-4);
    assert!((plane.offset - 0.005).abs() < 5e-4);
}

#[test]
fn a_log_at_100_hz_tells_what_one_at_1_khz_does() {
    let task = task(2000, STEEP);
    let config = InterpretConfig::from_task(&task);
    for script in [Script::default(), tilted(), events_found::lifted()] {
        let fast = script.samples(&task);
        let slow: Vec<TouchSample> = fast.iter().copied().step_by(10).collect();
        let (fast, slow) = (
            interpreted_with(&fast, &task, &config),
            interpreted_with(&slow, &task, &config),
        );
        let apart = (fast.performance.mean - slow.performance.mean).abs();
        assert!(
            apart <= 0.02,
            "{} {}",
            fast.performance.mean,
            slow.performance.mean
        );
        let kinds = |interpretation: &Interpretation| {
            interpretation
                .events
                .iter()
                .map(|e| e.kind)
                .collect::<Vec<_>>()
        };
        assert_eq!(kinds(&fast), kinds(&slow));
    }
}

#[test]
fn pieces_are_joined_beyond_the_limit_and_tell_nearly_the_same() {
    let task = task(500, STEEP);
    let samples = Script::default().samples(&task);
    let config = InterpretConfig::from_task(&task);
    let fine = interpreted_with(&samples, &task, &config);
    let coarse = interpreted_with(
        &samples,
        &task,
        &InterpretConfig {
            max_pieces: 400,
            ..config
        },
    );
    assert!(fine.path.len() > 1000);
    assert!(
        (200..=400).contains(&coarse.path.len()),
        "{}",
        coarse.path.len()
    );
    assert!((fine.performance.mean - coarse.performance.mean).abs() < 0.02);
    assert_eq!(fine.events.len(), coarse.events.len());
}

#[test]
fn what_is_no_measurement_is_refused_with_number_field_and_value() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let mut interpreter = Interpreter::new(&task, &config).unwrap();
    let sample = TouchSample {
        time: 1.0,
        world_from_tool: Pose::identity(),
        force: Vector3::zeros(),
    };
    interpreter.push(&sample).unwrap();
    assert_eq!(
        interpreter.push(&sample).unwrap_err().to_string(),
        "sample 1: time 1 s is not after 1 s, the time of the sample before it"
    );
    let mut deaf = TouchSample {
        time: 2.0,
        ..sample
    };
    deaf.force.y = f64::NAN;
    assert_eq!(
        interpreter.push(&deaf).unwrap_err().to_string(),
        "sample 1: force y [N] = NaN exceeds the limit of ±1e6"
    );
    let far = TouchSample {
        time: 2.0,
        world_from_tool: Pose::translation(0.0, 0.0, 2e4),
        ..sample
    };
    let refused = interpreter.push(&far).unwrap_err();
    assert!(matches!(
        refused,
        InterpretError::Measurement {
            field: "position z [m]",
            value: 2e4,
            ..
        }
    ));
    interpreter
        .push(&TouchSample {
            time: 1.5,
            ..sample
        })
        .unwrap();
    for wrong in [
        InterpretConfig {
            min_normal_force_n: 1.0,
            ..config.clone()
        },
        InterpretConfig {
            replays: 0,
            ..config.clone()
        },
        InterpretConfig {
            max_normal_force_n: -20.0,
            ..config.clone()
        },
        InterpretConfig {
            redraw_length_m: f64::NAN,
            ..config
        },
    ] {
        assert!(matches!(
            Interpreter::new(&task, &wrong),
            Err(InterpretError::Config { .. })
        ));
    }
}

/// The compression of the tool distinguishes weak contact from a tool off the plane.
#[test]
fn a_tool_believed_rigid_is_thought_off_the_plane_where_it_presses_less() {
    let task = task(500, STEEP);
    let script = Script {
        // In the middle, so that a tilted plane does not fit as well.
        press: |place| {
            if place.x.abs() < 0.1 {
                0.6 * PRESS
            } else {
                PRESS
            }
        },
        ..Script::default()
    };
    let samples = script.samples(&task);
    let config = exact(&task);
    let soft = interpreted_with(&samples, &task, &config);
    let rigid = InterpretConfig {
        compliance: ToolCompliance::Rigid,
        ..config
    };
    let rigid = interpreted_with(&samples, &task, &rigid);
    assert_eq!(events(&soft, EventKind::Push), []);
    assert!(soft.performance.mean > rigid.performance.mean + 0.2);
}

/// A surface far above the believed one, on which the tool has its nominal force.
#[test]
fn a_surface_far_above_the_believed_one_is_no_bias() {
    let interpretation = interpreted(&Script {
        surface: |_| 0.025,
        ..Script::default()
    });
    assert!(
        interpretation
            .force_bias
            .is_some_and(|bias| bias.abs() < 0.1),
        "{:?}",
        interpretation.force_bias
    );
    let plane = interpretation.plane.unwrap();
    assert!((plane.offset - 0.025).abs() < 5e-4, "{plane:?}");
    assert!(matches!(
        interpretation.diagnosis,
        Diagnosis::Relocalize { .. }
    ));
}

#[test]
fn planes_are_found_among_outliers_and_none_where_there_is_none() {
    let grid = |i: i32| {
        (
            f64::from(i % 25) * 0.016 - 0.2,
            f64::from(i / 25) * 0.014 - 0.14,
        )
    };
    let points: Vec<Point3> = (0..500)
        .map(|i| {
            let (x, y) = grid(i);
            let off = if i % 5 < 2 {
                0.002 + f64::from(i % 37) * 1e-3
            } else {
                0.0
            };
            Point3::new(x, y, 0.03 * x - 0.05 * y + 0.01 + off)
        })
        .collect();
    let config = PlaneConfig::default();
    let plane = fit_plane(&points, &config, 3).unwrap();
    assert_eq!(plane, fit_plane(&points, &config, 3).unwrap());
    assert!((plane.slope.x - 0.03).abs() < 1e-9 && (plane.slope.y + 0.05).abs() < 1e-9);
    assert_eq!(plane.inliers, 300);
    assert!((plane.tilt() - plane.normal().angle(&Vector3::z())).abs() < 1e-9);
    // The cone: a plane that steep is not believed, at most one as steep as the cone allows.
    let within = |degrees: f64| {
        let cone = degrees.to_radians();
        let narrow = PlaneConfig {
            cone,
            ..config.clone()
        };
        fit_plane(&points, &narrow, 3)
    };
    assert_eq!(within(1.0), None);
    let held = within(3.0).unwrap();
    assert!(held.tilt() <= 3.0_f64.to_radians() + 1e-12, "{held:?}");
    assert!(held.inliers < 300);
    // Scattered points lie on no plane.
    let scattered: Vec<Point3> = (0..500)
        .map(|i| {
            let (x, y) = grid(i);
            Point3::new(x, y, (f64::from(i) * 2.399_963).sin() * 0.05)
        })
        .collect();
    assert_eq!(fit_plane(&scattered, &config, 3), None);
    assert_eq!(fit_plane(&points[..5], &config, 3), None);
    assert_eq!(fit_plane(&[], &config, 3), None);
    // Contacts at one place determine its height only.
    let same = vec![Point3::new(0.1, 0.1, 0.02); 20];
    let flat = fit_plane(&same, &config, 3).unwrap();
    assert!((flat.height - 0.02).abs() < 1e-12 && flat.slope.norm() == 0.0);
}

fn any_log() -> impl Strategy<Value = Vec<TouchSample>> {
    let number =
        || prop_oneof![4 => -0.3..0.3_f64, 1 => -40.0..40.0_f64, 1 => proptest::num::f64::NORMAL];
    let one = (
        1e-6..0.2_f64,
        [number(), number(), number()],
        [number(), number(), number()],
        [number(), number(), number()],
    );
    prop::collection::vec(one, 0..120).prop_map(|rows| {
        let mut time = 0.0;
        rows.into_iter()
            .map(|(step, place, turn, force)| {
                time += step;
                let turn = turn.map(|angle| angle.rem_euclid(7.0));
                TouchSample {
                    time,
                    world_from_tool: Pose::new(place.into(), turn.into()),
                    force: force.into(),
                }
            })
            .collect()
    })
}

/// Within 10 km and a meganewton; times and orientations of these logs always are.
fn is_measurable(sample: &TouchSample) -> bool {
    let place = sample.world_from_tool.translation.vector;
    place.amax() <= 1e4 && sample.force.amax() <= 1e6
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_log_is_interpreted_but_for_samples_that_no_robot_measures(samples in any_log(), collect: bool, max_pieces in 16_usize..200) {
        let mut task = task(60, STEEP);
        task.surface.world_from_surface = Pose::identity();
        let config = InterpretConfig { replays: 2, max_pieces, ..InterpretConfig::from_task(&task) };
        let mut interpreter = Interpreter::new(&task, &config).unwrap();
        let mut accepted = Vec::new();
        for sample in &samples {
            let is_accepted = interpreter.push(sample).is_ok();
            prop_assert_eq!(is_accepted, is_measurable(sample), "{:?}", sample);
            accepted.extend(is_accepted.then_some(sample.time));
        }
        let goal = if collect {
            GoalState::Collected { center: Point2::origin(), radius: 0.06 }
        } else {
            GoalState::Absorbed
        };
        let interpretation = interpreter.conclude(&Belief::from_particles(task.particles.clone()), &goal).unwrap();
        prop_assert!(interpretation.path.len() <= max_pieces);
        let ends = |path: &[PathPiece]| Some([path.first()?.time[0], path.last()?.time[1]]);
        let times = accepted.first().copied().zip(accepted.last().copied());
        let times = times.map(<[f64; 2]>::from);
        // For positions far away, jumps are left out without a doubt of their own: the unit of
        // length is wrong.
        let has_jumps = |doubt: &Doubt| matches!(doubt, Doubt::PoseJumps { .. } | Doubt::FarAway { .. });
        if interpretation.doubts.iter().any(has_jumps) {
            let [[first, last], [start, end]] = [ends(&interpretation.path), times].map(Option::unwrap);
            prop_assert!(start <= first && last <= end);
        } else {
            prop_assert_eq!(ends(&interpretation.path), times);
        }
        prop_assert!(
            interpretation
                .contact_share
                .is_none_or(|share| (0.0..=1.0).contains(&share))
        );
        for replay in interpretation.belief.members() {
            let tally = replay.tally();
            prop_assert_eq!(tally.initial, tally.remaining + tally.absorbed + tally.off_surface);
        }
        for event in &interpretation.events {
            prop_assert!(event.start <= event.end && event.samples > 0);
        }
        prop_assert!(interpretation.events.is_sorted_by_key(|event| event.start));
    }
}
