//! Logs with faults of their own: jumping poses, drifting forces, wrong frames and units, and times without samples.

use super::log::{DEPTH, PRESS, STEEP, Script, task};
use super::{events, interpreted, interpreted_with};
use nalgebra::Isometry3;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{Doubt, EventKind, InterpretConfig, Interpretation, TouchSample};
use wisch::represent::Task;

/// Interprets the samples of a script after a change. `change` gets the pose of the surface and a sample, and returns the
/// sample to be kept.
fn changed(
    script: &Script,
    change: impl Fn(&Pose, usize, TouchSample) -> Option<TouchSample>,
) -> Interpretation {
    let task: Task = task(80, STEEP);
    let world_from_surface = task.surface.world_from_surface;
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter().enumerate())
        .filter_map(|(k, sample)| change(&world_from_surface, k, sample))
        .collect();
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

fn moved(sample: TouchSample, by: Vector3) -> TouchSample {
    let mut world_from_tool = sample.world_from_tool;
    world_from_tool.translation.vector += by;
    TouchSample {
        world_from_tool,
        ..sample
    }
}

fn one_stroke() -> Script {
    let plain = Script::default();
    Script {
        strokes: vec![plain.strokes[1]],
        ..plain
    }
}

#[test]
fn poses_that_jump_there_and_back_are_left_out_and_counted() {
    let truth = interpreted(&one_stroke()).performance.mean;
    let found = changed(&one_stroke(), |surface, k, sample| {
        let aside =
            surface.rotation * Vector3::new(0.0, 0.16 * f64::from(u8::from(k % 600 == 300)), 0.0);
        Some(moved(sample, aside))
    });
    assert!(
        (found.performance.mean - truth).abs() < 0.01,
        "{truth}: {:?}",
        found.performance
    );
    assert!(
        matches!(
            found.doubts[..],
            [Doubt::PoseJumps {
                left_out: 6..=12,
                lasting: 0,
                ..
            }]
        ),
        "{:?}",
        found.doubts
    );
    assert!(found.is_conclusive());
}

#[test]
fn wrong_poses_of_two_samples_are_left_out() {
    let truth = interpreted(&one_stroke()).performance.mean;
    let found = changed(&one_stroke(), |surface, k, sample| {
        let is_aside = f64::from(u8::from([300, 301].contains(&(k % 600))));
        let by = Vector3::new(0.0, 0.16 * is_aside, 0.0);
        Some(moved(sample, surface.rotation * by))
    });
    assert!(
        matches!(found.doubts[..], [Doubt::PoseJumps { lasting: 0, .. }]),
        "{:?}",
        found.doubts
    );
    let estimate = found.performance;
    assert!(
        (estimate.mean - truth).abs() < 0.01,
        "{truth}: {estimate:?}"
    );
}

#[test]
fn a_wrong_pose_between_which_a_reader_interpolates_leaves_the_performance_unknown() {
    // A single pose at 100 Hz, forces at 1 kHz.
    let found = changed(&one_stroke(), |surface, k, sample| {
        let share = 1.0 - (f64::from((k % 600) as u32) - 300.0).abs() / 10.0;
        let by = Vector3::new(0.0, 0.16 * share.max(0.0), 0.0);
        Some(moved(sample, surface.rotation * by))
    });
    let is_said = |doubt: &Doubt| matches!(doubt, Doubt::PoseJumps { lasting: 1.., .. });
    assert!(found.doubts.iter().any(is_said), "{:?}", found.doubts);
    assert!(!found.is_conclusive());
}

#[test]
fn first_poses_of_zeros_are_left_out() {
    for count in [1, 5] {
        let found = changed(&one_stroke(), |_, k, sample| {
            let is_zero = k < count;
            let measured = sample.world_from_tool;
            let world_from_tool = if is_zero { Pose::identity() } else { measured };
            Some(TouchSample {
                world_from_tool,
                ..sample
            })
        });
        assert!(
            matches!(found.doubts[..], [Doubt::PoseJumps { left_out, lasting: 0, .. }] if left_out == count),
            "{:?}",
            found.doubts
        );
    }
}

#[test]
fn poses_that_jump_and_stay_or_jump_too_often_leave_the_performance_unknown() {
    let aside = Vector3::new(0.0, 0.16, 0.0);
    let stays = changed(&one_stroke(), |surface, k, sample| {
        let by = surface.rotation * aside * f64::from(u8::from(k >= 2500));
        Some(moved(sample, by))
    });
    let often = changed(&one_stroke(), |surface, k, sample| {
        let by = surface.rotation * aside * f64::from(u8::from(k % 2 == 1));
        Some(moved(sample, by))
    });
    for found in [stays, often] {
        assert!(!found.is_conclusive(), "{:?}", found.doubts);
        let is_said = |doubt: &Doubt| matches!(doubt, Doubt::PoseJumps { .. });
        assert!(found.doubts.iter().any(is_said), "{:?}", found.doubts);
    }
}

#[test]
fn a_force_that_drifts_leaves_the_performance_unknown() {
    let at_rate = |rate: f64| {
        changed(&Script::default(), |surface, _, sample| {
            let force =
                sample.force + surface.rotation * Vector3::new(0.0, 0.0, rate * sample.time);
            Some(TouchSample { force, ..sample })
        })
    };
    for (rate, is_conclusive) in [
        (0.0, true),
        (0.02, true),
        (0.2, false),
        (0.4, false),
        (-1.0, false),
    ] {
        let found = at_rate(rate);
        assert_eq!(
            found.is_conclusive(),
            is_conclusive,
            "{rate}: {:?}",
            found.doubts
        );
        let is_said = |doubt: &Doubt| matches!(doubt, Doubt::BiasChange { .. });
        assert_eq!(
            found.doubts.iter().any(is_said),
            !is_conclusive,
            "{rate}: {:?}",
            found.doubts
        );
        assert_eq!(pushes(&found), 0, "{rate}: {:?}", found.events);
    }
}

/// Number of events that a person causes.
fn pushes(found: &Interpretation) -> usize {
    let by_hand = found.events.iter().filter(|event| event.kind.is_by_hand());
    by_hand.count()
}

#[test]
fn a_force_that_is_the_same_in_the_air_and_close_to_the_surface_is_bias() {
    for bias in [5.0, 8.0, 10.0, 20.0, -10.0] {
        let found = changed(&Script::default(), |surface, _, sample| {
            let above = surface.rotation * Vector3::z() * (DEPTH + 3e-3);
            let force = surface.rotation * Vector3::z() * bias;
            Some(TouchSample {
                force,
                ..moved(sample, above)
            })
        });
        let known = found.force_bias.unwrap_or(f64::NAN);
        assert!((known - bias).abs() < 0.01, "{bias} N: {known}");
        assert_eq!(found.events, [], "{bias} N");
        assert!(!found.is_conclusive(), "{bias} N: {:?}", found.doubts);
    }
}

#[test]
fn a_force_that_settles_in_a_short_approach_is_no_drift() {
    let [start, _] = Script::default().contacts()[0];
    let [_, end] = Script::default().contacts()[2];
    let found = changed(&Script::default(), |surface, _, sample| {
        let settles = 0.4 * (sample.time / start).min(1.0);
        let force = sample.force + surface.rotation * Vector3::new(0.0, 0.0, settles);
        (sample.time < end + 0.3).then_some(TouchSample { force, ..sample })
    });
    let is_said = |doubt: &Doubt| matches!(doubt, Doubt::BiasChange { .. });
    assert!(!found.doubts.iter().any(is_said), "{:?}", found.doubts);
}

#[test]
fn a_bias_that_steps_in_contact_leaves_the_performance_unknown() {
    let contacts = Script::default().contacts();
    let middle = |stroke: usize| 0.5 * (contacts[stroke][0] + contacts[stroke][1]);
    let stepped = |size: f64, from: f64, to: f64| {
        changed(&Script::default(), |surface, _, sample| {
            let is_on = (from..to).contains(&sample.time);
            let step = Vector3::z() * size * f64::from(u8::from(is_on));
            let force = sample.force + surface.rotation * step;
            Some(TouchSample { force, ..sample })
        })
    };
    for (size, stroke) in [(12.0, 0), (12.0, 1), (20.0, 2), (-10.0, 1), (5.0, 2)] {
        let found = stepped(size, middle(stroke), f64::INFINITY);
        let told = found.doubts.iter().find_map(|doubt| match doubt {
            Doubt::BiasChange { change, .. } => Some(*change),
            _ => None,
        });
        assert!(
            told.is_some_and(|told| (told - f64::abs(size)).abs() < 0.5),
            "{size} N in stroke {stroke}: {:?}",
            found.doubts
        );
        assert!(!found.is_conclusive(), "{size} N in stroke {stroke}");
        assert_eq!(pushes(&found), 0, "{size} N: {:?}", found.events);
    }
    // A hand that pushes during one free motion is no bias.
    let pushed = stepped(8.0, contacts[0][1] + 0.4, contacts[1][0] - 0.4);
    let is_said = |doubt: &Doubt| matches!(doubt, Doubt::BiasChange { .. });
    assert!(!pushed.doubts.iter().any(is_said), "{:?}", pushed.doubts);
}

#[test]
fn a_log_far_above_the_surface_has_no_share_of_contact() {
    let found = changed(&Script::default(), |surface, _, sample| {
        Some(moved(sample, surface.rotation * Vector3::z() * 0.3))
    });
    assert_eq!(found.contact_share, None);
    assert!(interpreted(&Script::default()).contact_share > Some(0.8));
}

/// The pose is that of the flange, and the sensor carries the tool: neither is stated.
#[test]
fn the_weight_of_a_tool_on_a_distant_pose_is_no_person() {
    for rate in [50.0, 500.0] {
        for mass in [0.0, 0.3, 0.6, 1.2, 2.0, 4.0] {
            let script = Script {
                rate,
                ..Script::default()
            };
            let weight = Vector3::z() * -9.80665 * mass;
            let found = changed(&script, |surface, _, sample| {
                let mut sample = moved(sample, surface.rotation * Vector3::z() * 0.15);
                sample.force += weight;
                Some(sample)
            });
            let what = format!("{mass} kg, {rate} Hz: {:?}", found.doubts);
            assert!(
                matches!(found.doubts[0], Doubt::ContactFarFromSurface { height, .. } if (height - 0.15).abs() < 2e-3),
                "{what}"
            );
            assert!(found.doubts[0].to_string().contains("--pose-offset"));
            let by_hand = found.events.iter().filter(|event| event.kind.is_by_hand());
            assert_eq!(by_hand.count(), 0, "{what}");
            let load = (found.doubts.iter()).find_map(|doubt| match doubt {
                Doubt::LoadInAir { mass, .. } => Some((*mass, doubt.to_string())),
                _ => None,
            });
            match load {
                Some((found, text)) => {
                    assert!((found - mass).abs() < 0.05 * mass, "{what}");
                    assert!(text.contains("--payload-mass"), "{text}");
                }
                None => assert!(mass < 0.5, "{what}"),
            }
        }
    }
}

#[test]
fn a_tool_harder_or_softer_than_declared_stays_in_contact_as_its_force_changes() {
    let script = Script {
        press: |place| if place.x < 0.0 { PRESS } else { 0.4 * PRESS },
        ..Script::default()
    };
    let truth = interpreted(&script).performance;
    let contacts = script.contacts();
    // The script's tool is lifted by half of this where it presses with 4 N.
    for (scale, range) in [(0.0, 20e3..=1e5), (2.0, 800.0..=1200.0)] {
        let found = changed(&script, |surface, _, sample| {
            let is_in_contact =
                (contacts.iter()).any(|[start, end]| (*start..*end).contains(&sample.time));
            let place = surface.inverse() * sample.world_from_tool;
            let is_soft = place.translation.x >= 0.0 && is_in_contact;
            let lift = 0.6 * DEPTH * (scale - 1.0) * f64::from(u8::from(is_soft));
            Some(moved(sample, surface.rotation * Vector3::z() * lift))
        });
        let told = found.doubts.iter().find_map(|doubt| match doubt {
            Doubt::StiffnessDiffers { found, .. } => Some(*found),
            _ => None,
        });
        assert!(
            told.is_some_and(|told| range.contains(&told)),
            "{scale}: {:?}",
            found.doubts
        );
        let estimate = found.performance;
        assert!(
            found.is_conclusive() && (estimate.mean - truth.mean).abs() < 0.03,
            "{scale}: {estimate:?} instead of {truth:?}: {:?}",
            found.doubts
        );
        let stiffness = found.tool_stiffness.unwrap();
        assert!(!stiffness.is_assumed && range.contains(&stiffness.n_per_m));
    }
    // A force that hardly changes shows no stiffness.
    let stiffness = interpreted(&one_stroke()).tool_stiffness.unwrap();
    assert!(stiffness.is_assumed && stiffness.n_per_m == PRESS / DEPTH);
}

#[test]
fn a_frame_that_is_not_that_of_the_tool_is_reported() {
    let leaning = |lean: f64| {
        changed(&Script::default(), |_, _, sample| {
            let turn = Isometry3::rotation(Vector3::x() * lean);
            let world_from_tool = sample.world_from_tool * turn;
            Some(TouchSample {
                world_from_tool,
                ..sample
            })
        })
    };
    for (lean, expected) in [
        (0.2, None),
        (0.8, Some(true)),
        (1.2, Some(false)),
        (1.57, Some(false)),
        (3.1, None),
    ] {
        let found = leaning(lean);
        let told = found.doubts.iter().find_map(|doubt| match doubt {
            Doubt::ToolLeans { lean, .. } => Some(*lean),
            _ => None,
        });
        assert_eq!(
            told.is_some(),
            expected.is_some(),
            "{lean}: {:?}",
            found.doubts
        );
        assert!(
            told.is_none_or(|told| (told - lean).abs() < 0.05),
            "{lean}: {told:?}"
        );
        assert_eq!(
            found.is_conclusive(),
            expected.unwrap_or(true),
            "{lean}: {:?}",
            found.doubts
        );
    }
}

#[test]
fn a_plane_steeper_than_those_that_are_searched_is_reported_with_its_tilt() {
    let script = Script {
        surface: |place| 0.22 * place.y,
        ..Script::default()
    };
    let found = interpreted(&script);
    let [Doubt::TooSteep { tilt, .. }] = found.doubts[..] else {
        panic!("{:?}", found.doubts);
    };
    assert!((tilt - 0.22_f64.atan()).abs() < 0.01, "{tilt}");
    assert_eq!(events(&found, EventKind::Push), [], "no person");
}

#[test]
fn a_stroke_in_a_gap_is_not_taken_for_missing() {
    let [start, end] = Script::default().contacts()[1];
    let found = changed(&Script::default(), |_, _, sample| {
        (!(start - 0.3..end + 0.3).contains(&sample.time)).then_some(sample)
    });
    let [
        doubt @ Doubt::Incomplete {
            begins: false,
            ends: false,
            missing,
        },
    ] = found.doubts[..]
    else {
        panic!("{:?}", found.doubts);
    };
    assert!(
        (missing - (end - start + 0.6)).abs() < 0.05 && doubt.is_cut(),
        "{missing}"
    );
}

#[test]
fn a_force_in_another_unit_is_no_wiping() {
    for factor in [1.0 / 9.80665, 9.80665, 1000.0] {
        let found = changed(&Script::default(), |_, _, sample| {
            let force = sample.force * factor;
            Some(TouchSample { force, ..sample })
        });
        assert!(!found.is_conclusive(), "{factor}: {:?}", found.doubts);
    }
}

#[test]
fn a_force_in_another_unit_names_the_unit_and_its_factor() {
    let units = [
        (1.0 / 9.80665, "a log in kgf needs a factor of 9.80665"),
        (1.0 / 4.448, "a log in lbf needs a factor of 4.44822"),
        (0.001, "a log in kN needs a factor of 1000"),
        (10.0, "a log in dN needs a factor of 0.1"),
        (1000.0, "a log in mN needs a factor of 0.001"),
    ];
    let script = one_stroke();
    let [start, end] = script.contacts()[0];
    for (factor, unit) in units {
        // With free motion, and without any, so that the bias is unknown.
        for times in [0.0..1e9, start + 0.1..end - 0.1] {
            let found = changed(&script, |_, _, sample| {
                let force = sample.force * factor;
                (times.contains(&sample.time)).then_some(TouchSample { force, ..sample })
            });
            let is_said = |doubt: &Doubt| doubt.to_string().contains(unit);
            assert!(
                found.doubts.iter().any(is_said),
                "{unit}: {:?}",
                found.doubts
            );
            assert!(!found.is_conclusive(), "{unit}: {:?}", found.doubts);
        }
    }
    // What a controller may press with is no other unit.
    for factor in [0.5, 1.5, 2.0] {
        let found = changed(&script, |_, _, sample| {
            let force = sample.force * factor;
            Some(TouchSample { force, ..sample })
        });
        let texts: Vec<String> = found.doubts.iter().map(ToString::to_string).collect();
        assert!(
            !texts.iter().any(|text| text.contains("needs a factor")),
            "{texts:?}"
        );
    }
}

#[test]
fn a_log_in_millimetres_has_no_other_fault_than_its_unit_of_length() {
    let script = one_stroke();
    let [start, end] = script.contacts()[0];
    for times in [0.0..1e9, start..end] {
        let found = changed(&script, |_, k, sample| {
            let mut world_from_tool = sample.world_from_tool;
            world_from_tool.translation.vector *= 1000.0;
            (k % 40 == 0 && times.contains(&sample.time)).then_some(TouchSample {
                world_from_tool,
                ..sample
            })
        });
        assert!(
            matches!(found.doubts[..], [Doubt::FarAway { distance }] if distance > 100.0),
            "{:?}",
            found.doubts
        );
        assert!(found.doubts[0].to_string().contains("--length-unit-m"));
        assert!(!found.is_conclusive());
    }
}

#[test]
fn missing_contact_states_the_time_and_the_force_that_do_not_show_it() {
    let script = one_stroke();
    let [start, end] = script.contacts()[0];
    let near = 0.5 * (start + end);
    let doubt = |lasts: f64, force: f64| {
        let found = changed(&script, |surface, _, sample| {
            let is_near = (near..near + lasts).contains(&sample.time);
            let up = surface.rotation * Vector3::z();
            let above = if is_near { 0.01 } else { 0.025 };
            let push = if is_near { force } else { 0.0 };
            let sample = moved(sample, up * above);
            Some(TouchSample {
                force: up * push,
                ..sample
            })
        });
        let texts: Vec<String> = found.doubts.iter().map(ToString::to_string).collect();
        texts.join("; ")
    };
    let short = doubt(0.06, 174.0);
    let is_short = short.contains("for only 0.0") && short.contains("too short to show contact");
    assert!(is_short && !short.contains("174"), "{short}");
    let weak = doubt(1.0, 0.02);
    assert!(
        weak.contains("it is below 0.0200 N; press_force_n is "),
        "{weak}"
    );
}

#[test]
fn samples_too_far_apart_are_reported() {
    let found = changed(&Script::default(), |_, k, sample| {
        (k % 1000 == 0).then_some(sample)
    });
    let is_said =
        |doubt: &Doubt| matches!(doubt, Doubt::Sparse { period } if (period - 1.0).abs() < 0.01);
    assert!(found.doubts.iter().any(is_said), "{:?}", found.doubts);
    assert!(!found.is_conclusive());
}
